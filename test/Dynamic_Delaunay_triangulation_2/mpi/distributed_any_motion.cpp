// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Run by several ranks: random clouds with random motions, populations and distributions. Each
// frame is compared with one process. DYNAMIC_DELAUNAY_DISTRIBUTED_RUNS=1000 makes so many runs,
// from the seed DYNAMIC_DELAUNAY_DISTRIBUTED_SEED on; a failure names its seed.

#include "distributed_oracle.h"

#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <random>
#include <string>
#include <utility>

class Random_run // the same on all ranks
{
public:
  explicit Random_run(unsigned seed)
    : m_random(seed)
    , m_name("seed " + std::to_string(seed))
  {
  }

  void run()
  {
    const std::size_t n = std::size_t(std::exp(uniform(0, 6)));
    m_lattice = one_in(3) ? 1.0 : one_in(4) ? 0.25 : 0;
    m_side = std::sqrt(double(n)) * uniform(0.5, 2);
    for (std::size_t i = 0; i < n; ++i)
      add_point();
    const Owner owners[] = {in_order, in_turn, on_first};
    const auto own = own_part(m_population, owners[m_random() % 3]);
    Distributed dt(MPI_COMM_WORLD, own.begin(), own.end(), one_in(2) ? no_balance : 1.2);
    expect_exact(dt, m_population, m_name + " at the start");
    for (int frame = 0; frame < 8; ++frame) {
      const int kind = int(m_random() % 9);
      change(dt, kind);
      expect_exact(dt, m_population,
                   m_name + ", frame " + std::to_string(frame) + " of kind " +
                       std::to_string(kind));
    }
    expect(dt.is_valid(), m_name + ": valid");
  }

private:
  void change(Distributed& dt, int kind)
  {
    switch (kind) {
    case 0:
      return insert(dt);
    case 1:
      return remove(dt);
    case 2:
      return dt.distribute();
    default:
      move(kind);
      const Points next = own_positions(dt, m_population);
      dt.update(next.begin(), next.end());
    }
  }

  void move(int kind)
  {
    const double spread = std::exp(uniform(-8, 1)), turn = uniform(-0.5, 0.5);
    for (auto& [id, p] : m_population) {
      const double x = p.x() - m_side / 2, y = p.y() - m_side / 2;
      if (kind == 3 && !one_in(10))
        continue; // a few jump
      if (kind == 3)
        p = place();
      else if (kind == 4) // an explosion, or a collapse
        p = snapped(m_side / 2 + (1 + turn) * x, m_side / 2 + (1 + turn) * y);
      else if (kind == 5) // a turn
        p = snapped(m_side / 2 + std::cos(turn) * x - std::sin(turn) * y,
                    m_side / 2 + std::sin(turn) * x + std::cos(turn) * y);
      else if (kind == 6) // shear
        p = snapped(p.x() + turn * y, p.y());
      else // Brownian motion
        p = snapped(p.x() + uniform(-spread, spread), p.y() + uniform(-spread, spread));
    }
  }

  void insert(Distributed& dt)
  {
    std::vector<std::pair<Id, Point>> given;
    for (std::size_t k = m_random() % 20; k > 0; --k) {
      const auto added = add_point();
      if (int(m_random() % unsigned(number_of_ranks)) == this_rank)
        given.push_back(*added);
    }
    // Ranks have drawn alike, so each point is given by exactly one of them.
    dt.insert(given.begin(), given.end());
  }

  void remove(Distributed& dt)
  {
    std::vector<Id> given;
    const unsigned part = 1 + unsigned(m_random() % 8);
    for (auto value = m_population.begin(); value != m_population.end();) {
      const bool goes = one_in(part),
                 is_given = int(m_random() % unsigned(number_of_ranks)) == this_rank;
      if (goes && is_given)
        given.push_back(value->first);
      value = goes ? m_population.erase(value) : std::next(value);
    }
    dt.remove(given.begin(), given.end());
  }

  Population::iterator add_point()
  {
    const Id id = m_next += 1 + Id(m_random() % 5);
    const bool coincides = !m_population.empty() && one_in(20);
    return m_population.emplace(id, coincides ? m_population.begin()->second : place()).first;
  }

  Point place()
  {
    const double x = uniform(0, m_side);
    return snapped(x, uniform(0, m_side));
  }
  Point snapped(double x, double y) const
  {
    return m_lattice > 0
               ? Point(m_lattice * std::round(x / m_lattice), m_lattice * std::round(y / m_lattice))
               : Point(x, y);
  }
  bool one_in(unsigned n) { return m_random() % n == 0; }
  double uniform(double low, double high)
  {
    return std::uniform_real_distribution<double>(low, high)(m_random);
  }

  std::mt19937 m_random;
  std::string m_name;
  Population m_population;
  double m_lattice = 0, m_side = 1;
  Id m_next = 0;
};

int main(int argc, char** argv)
{
  start(argc, argv);
  const char* const wanted = std::getenv("DYNAMIC_DELAUNAY_DISTRIBUTED_RUNS");
  const char* const seed = std::getenv("DYNAMIC_DELAUNAY_DISTRIBUTED_SEED");
  const unsigned runs = wanted ? unsigned(std::atoi(wanted)) : 60;
  const unsigned first = seed ? unsigned(std::atoi(seed)) : 1;
  for (unsigned run = first; run < first + runs; ++run)
    Random_run(run).run();
  MPI_Finalize();
}

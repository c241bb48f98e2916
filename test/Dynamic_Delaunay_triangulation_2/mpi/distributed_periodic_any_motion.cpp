// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Run by several ranks: random clouds in periodic cells, with random motions, deformations,
// populations and distributions. Each frame is compared with one process.
// DYNAMIC_DELAUNAY_DISTRIBUTED_RUNS=1000 makes so many runs, from the seed
// DYNAMIC_DELAUNAY_DISTRIBUTED_SEED on; a failure names its seed.

#include "distributed_periodic_oracle.h"

#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <iterator>
#include <random>
#include <string>
#include <utility>
#include <vector>

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
    const std::size_t n = std::size_t(std::exp(uniform(0, 5)));
    m_is_lattice = one_in(3);
    const double size = std::sqrt(double(n)) * uniform(0.5, 2);
    m_vectors = {rounded(size * uniform(0.5, 2)), 0, rounded(size * uniform(-1, 1)),
                 rounded(size * uniform(0.5, 2))};
    if (!is_cell())
      m_vectors = {4, 0, 0, 4};
    for (std::size_t i = 0; i < n; ++i)
      add_point();
    const Owner owners[] = {in_order, in_turn, on_first};
    const auto own = own_part(m_population, owners[m_random() % 3]);
    Distributed_periodic dt(MPI_COMM_WORLD, own.begin(), own.end(), cell(),
                            one_in(2) ? no_balance : 1.2);
    expect_exact(dt, m_population, m_name + " at the start");
    for (int frame = 0; frame < 8; ++frame) {
      const int kind = int(m_random() % 10);
      change(dt, kind);
      expect_exact(dt, m_population,
                   m_name + ", frame " + std::to_string(frame) + " of kind " +
                       std::to_string(kind));
    }
    expect(dt.is_valid(), m_name + ": valid");
    expect(dt.certify(), m_name + ": certified");
  }

private:
  using Vectors = std::array<double, 4>;

  void change(Distributed_periodic& dt, int kind)
  {
    switch (kind) {
    case 0:
      return insert(dt);
    case 1:
      return remove(dt);
    case 2:
      return dt.distribute();
    case 3:
    case 4:
      return move(dt, kind);
    default:
      return deform(dt, kind);
    }
  }

  void update(Distributed_periodic& dt)
  {
    const Points next = own_positions(dt, m_population);
    dt.update(next.begin(), next.end(), cell());
  }

  void move(Distributed_periodic& dt, int kind)
  {
    const double spread = std::exp(uniform(-8, 1));
    for (auto& [id, p] : m_population) {
      if (kind == 3 && one_in(10)) // a few jump, or are given by other images
        p = one_in(2) ? place() : moved(p, int(m_random() % 9) - 4, int(m_random() % 9) - 4);
      else if (kind == 4) // Brownian motion
        p = snapped(p.x() + uniform(-spread, spread), p.y() + uniform(-spread, spread));
    }
    const Points next = own_positions(dt, m_population);
    dt.update(next.begin(), next.end());
  }

  // Points follow, or stay where they are.
  void deform(Distributed_periodic& dt, int kind)
  {
    const Vectors before = m_vectors;
    const double part = std::exp(uniform(-6, 0)) * (one_in(2) ? 1 : -1);
    auto& [ax, ay, bx, by] = m_vectors;
    if (kind == 5) // shear
      bx = rounded(bx + part * by), ax = rounded(ax + part * ay);
    else if (kind == 6) // stretching
      ax = rounded(ax * (1 + part)), bx = rounded(bx * (1 + part)), by = rounded(by / (1 + part));
    else if (kind == 7) // other vectors of the same lattice
      bx += ax, by += ay;
    else if (kind == 8)
      std::swap(ax, bx), std::swap(ay, by);
    else // any other cell
      for (double& x : m_vectors)
        x = rounded(x + uniform(-1, 1));
    if (!is_cell())
      m_vectors = before;
    if (one_in(2) && kind != 7 && kind != 8)
      follow(before);
    update(dt);
  }

  void follow(const Vectors& before)
  {
    const auto [ax, ay, bx, by] = before;
    const double d = ax * by - ay * bx;
    for (auto& [id, p] : m_population) {
      const double s = (p.x() * by - p.y() * bx) / d, t = (p.y() * ax - p.x() * ay) / d;
      p = snapped(s * m_vectors[0] + t * m_vectors[2], s * m_vectors[1] + t * m_vectors[3]);
    }
  }

  void insert(Distributed_periodic& dt)
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

  void remove(Distributed_periodic& dt)
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
    const Point p =
        coincides ? moved(m_population.begin()->second, int(m_random() % 3), 1) : place();
    return m_population.emplace(id, p).first;
  }

  Cell cell() const { return Cell(m_vectors[0], m_vectors[1], m_vectors[2], m_vectors[3]); }
  // Neither flat nor far too thin.
  bool is_cell() const
  {
    const auto [ax, ay, bx, by] = m_vectors;
    const double lengths = std::abs(ax) + std::abs(ay) + std::abs(bx) + std::abs(by);
    return lengths < 1000 && std::abs(ax * by - ay * bx) > 0.01 * lengths;
  }
  Point moved(const Point& p, int i, int j) const
  {
    return Point(p.x() + (i * m_vectors[0] + j * m_vectors[2]),
                 p.y() + (i * m_vectors[1] + j * m_vectors[3]));
  }
  Point place()
  {
    const double s = uniform(-1, 2), t = uniform(-1, 2);
    return snapped(s * m_vectors[0] + t * m_vectors[2], s * m_vectors[1] + t * m_vectors[3]);
  }
  double rounded(double x) const { return m_is_lattice ? std::round(x) : x; }
  Point snapped(double x, double y) const { return Point(rounded(x), rounded(y)); }
  bool one_in(unsigned n) { return m_random() % n == 0; }
  double uniform(double low, double high)
  {
    return std::uniform_real_distribution<double>(low, high)(m_random);
  }

  std::mt19937 m_random;
  std::string m_name;
  Population m_population;
  bool m_is_lattice = false;
  Vectors m_vectors{};
  Id m_next = 0;
};

int main(int argc, char** argv)
{
  start(argc, argv);
  const char* const wanted = std::getenv("DYNAMIC_DELAUNAY_DISTRIBUTED_RUNS");
  const char* const seed = std::getenv("DYNAMIC_DELAUNAY_DISTRIBUTED_SEED");
  const unsigned runs = wanted ? unsigned(std::atoi(wanted)) : 25;
  const unsigned first = seed ? unsigned(std::atoi(seed)) : 1;
  for (unsigned run = first; run < first + runs; ++run)
    Random_run(run).run();
  MPI_Finalize();
}

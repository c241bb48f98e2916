// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Runs of points over ranks in which a generator of random numbers, or a fuzzer, makes every
// decision. All ranks have to decide alike.

#ifndef DISTRIBUTED_DECISIONS_H
#define DISTRIBUTED_DECISIONS_H

#include "../../../benchmark/Dynamic_Delaunay_triangulation_2/random_operations/Decisions.h"
#include "distributed_oracle.h"

#include <cstddef>
#include <cstdlib>
#include <iterator>
#include <string>
#include <vector>

class Decided_run
{
public:
  Decided_run(random_operations::Decisions& decisions, const std::string& name)
    : m_decisions(decisions)
    , m_name(name)
  {
  }

protected:
  // So many points begin on any ranks. From frame to frame some come, some go, or all are
  // distributed anew, or they are moved by `move(dt, kind)`, a kind from 3 to `last_kind`. `add()`
  // adds a point to the population and returns its iterator.
  template <class Triangulation, class Add, class Move, class... Cell>
  void follow(std::size_t points, int last_kind, const Add& add, const Move& move,
              const Cell&... cell)
  {
    for (std::size_t i = 0; i < points; ++i)
      add();
    const Owner owner = any_owner();
    auto dt =
        distributed<Triangulation>(m_population, owner, cell..., one_in(2) ? no_balance : 1.2);
    expect_exact(dt, m_population, m_name + " at the start");
    for (int frame = 0; frame < 8 && m_decisions.has_more(); ++frame) {
      const int kind = whole(0, last_kind);
      if (kind == 0)
        insert(dt, add);
      else if (kind == 1)
        remove(dt);
      else if (kind == 2)
        dt.distribute();
      else
        move(dt, kind);
      expect_exact(dt, m_population,
                   m_name + ", frame " + std::to_string(frame) + " of kind " +
                       std::to_string(kind));
    }
    expect(dt.is_valid(), m_name + ": valid");
    expect(dt.certify(), m_name + ": certified");
  }

  Owner any_owner()
  {
    const Owner owners[] = {in_order, in_turn, on_first};
    return owners[m_decisions.below(3)];
  }
  bool one_in(std::size_t n) { return m_decisions.one_in(n); }
  int whole(int lowest, int highest) { return m_decisions.whole(lowest, highest); }
  double uniform(double low, double high) { return m_decisions.real(low, high); }

  Id next_id() { return m_next += 1 + Id(m_decisions.below(5)); }

  random_operations::Decisions& m_decisions;
  std::string m_name;
  Population m_population;

private:
  // Each of the new points is given by exactly one rank.
  template <class Triangulation, class Add>
  void insert(Triangulation& dt, const Add& add)
  {
    Newcomers given;
    for (std::size_t k = m_decisions.below(20); k > 0; --k) {
      const auto added = add();
      if (is_chosen())
        given.push_back(*added);
    }
    dt.insert(given.begin(), given.end());
  }

  // Each of the points that leave is given by exactly one rank.
  template <class Triangulation>
  void remove(Triangulation& dt)
  {
    std::vector<Id> given;
    const std::size_t part = 1 + m_decisions.below(8);
    for (auto value = m_population.begin(); value != m_population.end();) {
      const bool goes = one_in(part), is_given = is_chosen();
      if (goes && is_given)
        given.push_back(value->first);
      value = goes ? m_population.erase(value) : std::next(value);
    }
    dt.remove(given.begin(), given.end());
  }

  // True on one rank.
  bool is_chosen() { return whole(0, number_of_ranks - 1) == this_rank; }

  Id m_next = 0;
};

// Many runs in which random numbers make every decision, with up to `most_points(seed)` points.
// DYNAMIC_DELAUNAY_DISTRIBUTED_RUNS=1000 makes so many, from the seed
// DYNAMIC_DELAUNAY_DISTRIBUTED_SEED on; a failure names its seed.
template <class Run, class Most_points>
void make_runs(unsigned usual, const Most_points& most_points)
{
  const char* const wanted = std::getenv("DYNAMIC_DELAUNAY_DISTRIBUTED_RUNS");
  const char* const seed = std::getenv("DYNAMIC_DELAUNAY_DISTRIBUTED_SEED");
  const unsigned runs = wanted ? unsigned(std::atoi(wanted)) : usual;
  const unsigned first = seed ? unsigned(std::atoi(seed)) : 1;
  for (unsigned run = first; run < first + runs; ++run) {
    random_operations::Random_decisions decisions(run);
    Run(decisions, "seed " + std::to_string(run)).run(most_points(run));
  }
}

#endif // DISTRIBUTED_DECISIONS_H

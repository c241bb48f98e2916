// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Many runs in which random numbers make every decision.

#ifndef DISTRIBUTED_ANY_RUNS_H
#define DISTRIBUTED_ANY_RUNS_H

#include "distributed_decisions.h"

#include <cstdlib>
#include <string>

// Runs with up to `most_points(seed)` points. DYNAMIC_DELAUNAY_DISTRIBUTED_RUNS=1000 makes so many,
// from the seed DYNAMIC_DELAUNAY_DISTRIBUTED_SEED on; a failure names its seed.
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

#endif // DISTRIBUTED_ANY_RUNS_H

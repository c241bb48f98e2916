// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Run by several ranks: random clouds in periodic cells, with random motions, deformations,
// populations and distributions. Each frame is compared with one process.
// DYNAMIC_DELAUNAY_DISTRIBUTED_RUNS=1000 makes so many runs, from the seed
// DYNAMIC_DELAUNAY_DISTRIBUTED_SEED on; a failure names its seed.

#include "distributed_periodic_any_run.h"

#include <cstdlib>
#include <string>

int main(int argc, char** argv)
{
  start(argc, argv);
  const char* const wanted = std::getenv("DYNAMIC_DELAUNAY_DISTRIBUTED_RUNS");
  const char* const seed = std::getenv("DYNAMIC_DELAUNAY_DISTRIBUTED_SEED");
  const unsigned runs = wanted ? unsigned(std::atoi(wanted)) : 25;
  const unsigned first = seed ? unsigned(std::atoi(seed)) : 1;
  for (unsigned run = first; run < first + runs; ++run) {
    random_operations::Random_decisions decisions(run);
    Any_periodic_run(decisions, "seed " + std::to_string(run)).run(150);
  }
  MPI_Finalize();
}

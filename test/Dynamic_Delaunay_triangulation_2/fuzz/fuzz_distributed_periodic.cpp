// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A run over one to eight ranks, whose every decision is decoded from the input: how many ranks
// there are, how the points lie and which rank owns them, how they and their cell move, how they
// come and go. Each frame is compared with one process. The ranks are threads here.

#include "../mpi/distributed_periodic_any_run.h"
#include "fuzz_target.h"

#include <string>

void fuzz::examine(const std::string& input)
{
  constexpr double most_points = 100;
  if (input.empty())
    return;
  const int ranks = 1 + static_cast<unsigned char>(input.front()) % 8;
  const std::string choices = input.substr(1);
  threads_as_ranks::run_ranks(ranks, [&] {
    start(0, nullptr);
    random_operations::Byte_decisions decisions(choices);
    Any_periodic_run(decisions, "input").run(most_points);
  });
}

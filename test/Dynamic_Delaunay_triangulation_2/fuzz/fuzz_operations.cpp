// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A trial of random operations, as in the benchmark robustness, whose every decision is decoded
// from the input: what runs, how the points lie, and what is done to them.

#include "../../../benchmark/Dynamic_Delaunay_triangulation_2/random_operations/Decisions.h"
#include "../../../benchmark/Dynamic_Delaunay_triangulation_2/random_operations/Make_subject.h"
#include "../../../benchmark/Dynamic_Delaunay_triangulation_2/random_operations/Trial.h"
#include "fuzz_target.h"

#include <algorithm>
#include <cstddef>
#include <string>

void fuzz::examine(const std::string& input)
{
  using namespace random_operations;
  constexpr std::size_t max_operations = 32, max_points = 40;
  Byte_decisions decisions(input);
  const Family& family = any_family(decisions);
  Setup setup = any_setup(family, decisions);
  setup.max_points = (std::min)(setup.max_points, max_points);
  const auto subject = make_subject(setup);
  Counts counts;
  Trial(family, setup, *subject, decisions, counts).run(max_operations, [] {});
}

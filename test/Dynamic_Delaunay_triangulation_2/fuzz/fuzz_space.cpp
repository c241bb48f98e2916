// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A program of operations on points in space, whose every decision is decoded from the input: where
// the points lie, and what is done to them. After each operation the triangulation has to be exact,
// and now and then one that was written and read goes on.

#include "../space_operations.h"
#include "../space_oracle.h"
#include "fuzz_target.h"
#include "numbers_of_input.h"

#include <CGAL/Dynamic_Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <string>

void fuzz::examine(const std::string& input)
{
  using Dynamic = CGAL::Dynamic_Delaunay_triangulation_3<CGAL::Epick>;
  constexpr double extents[] = {1, 1, 1, 1e-150, 1e-30, 1e70};
  constexpr double grids[] = {0, 0.5, 0.25, 0.125}; // shares of the extent
  constexpr std::size_t most_points = 40, most_operations = 24;
  testing::GTEST_FLAG(throw_on_failure) = true; // as findings
  fuzz::Numbers_of_input numbers(input);
  const double extent = extents[numbers.byte() % 6], grid = grids[numbers.byte() % 4];
  const std::size_t points = numbers.byte() % most_points, operations = numbers.byte();
  space_operations::Program<Dynamic, fuzz::Numbers_of_input> program(numbers, extent,
                                                                     grid * extent);
  program.insert(points);
  for (std::size_t i = 0; i < operations % (most_operations + 1); ++i) {
    program.do_something();
    space_oracle::expect_exact(program.triangulation(), program.points());
    if ((operations + i) % 5 == 0) {
      program.interrupt();
    }
  }
}

// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A program of operations on points in periodic space of three dimensions, whose every decision is
// decoded from the input: the cell, where the points lie, and what is done to both. After each
// operation the triangulation has to be as a fresh one, and in the end exact.

#include "../periodic_space_operations.h"
#include "fuzz_target.h"
#include "numbers_of_input.h"

#include <CGAL/Dynamic_periodic_Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <string>

void fuzz::examine(const std::string& input)
{
  using Dynamic = CGAL::Dynamic_periodic_Delaunay_triangulation_3<CGAL::Epick>;
  using periodic_space_operations::Cell;
  using periodic_space_operations::Coordinates;
  const Cell cells[] = {Cell(1, 1, 1),
                        Cell({1, 0.1, 0.2}, {0.5, -0.9, 0.1}, {1.3, 0.2, 1.1}),
                        Cell(1, 1, 0.125),
                        Cell(1, 1, 8),
                        Cell({1, 0, 0}, {0.5, 1, 0}, {-0.5, 0.5, 1}),
                        Cell(1, 2, 0.5),
                        Cell({1, 0, 0}, {0, 1, 0}),
                        Cell({1, 0.1, 0.2}, {0.5, -0.9, 0.7}),
                        Cell({0, 0.5, 0}, {3, 0.125, 0}),
                        Cell(Coordinates{1, 0, 0}),
                        Cell(Coordinates{0.5, -0.875, 0.75})};
  constexpr double scales[] = {1, 1, 1, 0x1p-100, 0x1p100};
  constexpr double grids[] = {0, 0.5, 0.25, 0.125}; // shares of the scale
  constexpr int distances[] = {2, 2, 2, 10'000};    // in cells
  constexpr std::size_t most_points = 24, most_operations = 8;
  testing::GTEST_FLAG(throw_on_failure) = true; // as findings
  fuzz::Numbers_of_input numbers(input);
  periodic_space_operations::Setting setting;
  setting.cell = cells[numbers.byte() % 11];
  setting.scale = scales[numbers.byte() % 5];
  setting.grid = grids[numbers.byte() % 4];
  setting.far = distances[numbers.byte() % 4];
  setting.meetings = numbers.byte() % 4 == 0 ? 2 : 12;
  setting.deforms = numbers.byte() % 4 == 0;
  const std::size_t points = numbers.byte() % most_points, crystal = numbers.byte() % 12;
  const std::size_t operations = numbers.byte() % (most_operations + 1);
  periodic_space_operations::Program<Dynamic, fuzz::Numbers_of_input> program(numbers, setting);
  if (crystal < 6) {
    program.insert_crystal(1 + crystal / 3, crystal % 3);
  } else {
    program.insert(points);
  }
  for (std::size_t i = 0; i < operations; ++i) {
    program.do_something();
    program.expect_as_fresh();
    if (program.points().size() > 2 * most_points) {
      program.remove(most_points);
    }
  }
  program.expect_exact();
}

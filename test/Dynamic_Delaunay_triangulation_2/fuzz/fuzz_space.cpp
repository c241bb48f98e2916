// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A program of operations on points in space, whose every decision is decoded from the input: where
// the points lie, and what is done to them. After each operation the triangulation has to be exact,
// and now and then one that was written and read goes on.

#include "../space_operations.h"
#include "../space_oracle.h"
#include "fuzz_target.h"

#include <CGAL/Dynamic_Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <random>
#include <string>

namespace {

// Two bytes of the input are the first bits of a number. The other bits, and numbers after the end,
// are random, since distributions may draw as many as they like.
class Numbers_of_input
{
public:
  using result_type = std::uint64_t;

  explicit Numbers_of_input(const std::string& input)
    : m_input(input)
  {
  }

  static constexpr result_type(min)() { return 0; }
  static constexpr result_type(max)() { return ~result_type(0); }

  result_type operator()()
  {
    result_type number = m_others();
    if (m_place + 2 <= m_input.size()) {
      number = byte() << 56 | byte() << 48 | number >> 16;
    }
    return number;
  }

  std::uint64_t byte()
  {
    return m_place < m_input.size() ? static_cast<unsigned char>(m_input[m_place++]) : 0;
  }

private:
  std::string m_input;
  std::size_t m_place = 0;
  std::mt19937_64 m_others{1};
};

} // namespace

void fuzz::examine(const std::string& input)
{
  using Dynamic = CGAL::Dynamic_Delaunay_triangulation_3<CGAL::Epick>;
  constexpr double extents[] = {1, 1, 1, 1e-150, 1e-30, 1e70};
  constexpr double grids[] = {0, 0.5, 0.25, 0.125}; // shares of the extent
  constexpr std::size_t most_points = 40, most_operations = 24;
  testing::GTEST_FLAG(throw_on_failure) = true; // as findings
  Numbers_of_input numbers(input);
  const double extent = extents[numbers.byte() % 6], grid = grids[numbers.byte() % 4];
  const std::size_t points = numbers.byte() % most_points, operations = numbers.byte();
  space_operations::Program<Dynamic, Numbers_of_input> program(numbers, extent, grid * extent);
  program.insert(points);
  for (std::size_t i = 0; i < operations % (most_operations + 1); ++i) {
    program.do_something();
    space_oracle::expect_exact(program.triangulation(), program.points());
    if ((operations + i) % 5 == 0) {
      program.interrupt();
    }
  }
}

// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Random points for the tests of periodic space.

#ifndef DYNAMIC_DELAUNAY_TRIANGULATION_2_TEST_RANDOM_POINTS_H
#define DYNAMIC_DELAUNAY_TRIANGULATION_2_TEST_RANDOM_POINTS_H

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

inline double random_between(std::mt19937_64& random, double low, double high)
{
  return std::uniform_real_distribution<double>(low, high)(random);
}

// Points of the cell; with a grid, on its multiples, where many are on circles, lines and each
// other.
inline std::vector<CGAL::Exact_predicates_inexact_constructions_kernel::Point_2>
random_points(std::mt19937_64& random, std::size_t number, double extent, double grid = 0)
{
  const auto coordinate = [&] {
    const double x = random_between(random, 0, extent);
    return grid > 0 ? std::floor(x / grid) * grid : x;
  };
  std::vector<CGAL::Exact_predicates_inexact_constructions_kernel::Point_2> points;
  for (std::size_t i = 0; i < number; ++i) {
    const double x = coordinate();
    points.emplace_back(x, coordinate());
  }
  return points;
}

#endif // DYNAMIC_DELAUNAY_TRIANGULATION_2_TEST_RANDOM_POINTS_H

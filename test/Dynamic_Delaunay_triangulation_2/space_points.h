// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Points for the tests of points in space.

#ifndef DYNAMIC_DELAUNAY_TRIANGULATION_2_TEST_SPACE_POINTS_H
#define DYNAMIC_DELAUNAY_TRIANGULATION_2_TEST_SPACE_POINTS_H

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <cstddef>
#include <random>
#include <vector>

namespace space_points {

using Points = std::vector<CGAL::Exact_predicates_inexact_constructions_kernel::Point_3>;

// Points of the unit cube.
inline Points random_points(std::size_t number, unsigned seed = 1)
{
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> coordinate(0, 1);
  Points points;
  for (std::size_t i = 0; i < number; ++i) {
    const double x = coordinate(random), y = coordinate(random);
    points.emplace_back(x, y, coordinate(random));
  }
  return points;
}

// A cube of so many points along each edge, at distance 1.
inline Points lattice(int edge)
{
  Points points;
  for (int x = 0; x < edge; ++x)
    for (int y = 0; y < edge; ++y)
      for (int z = 0; z < edge; ++z)
        points.emplace_back(x, y, z);
  return points;
}

// The points after a Gaussian step in each coordinate.
inline Points shaken(const Points& points, double step, unsigned seed = 2)
{
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal(0, step);
  Points result;
  for (const auto& p : points) {
    const double x = p.x() + normal(random), y = p.y() + normal(random);
    result.emplace_back(x, y, p.z() + normal(random));
  }
  return result;
}

} // namespace space_points

#endif // DYNAMIC_DELAUNAY_TRIANGULATION_2_TEST_SPACE_POINTS_H

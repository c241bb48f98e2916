// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// What the tests without GoogleTest ask of a triangulation. To be included first: their assertions,
// and CGAL's, hold whatever they are compiled with.

#ifndef DYNAMIC_DELAUNAY_TRIANGULATION_2_TEST_PLAIN_ORACLE_H
#define DYNAMIC_DELAUNAY_TRIANGULATION_2_TEST_PLAIN_ORACLE_H

#undef NDEBUG

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/queries/delaunay_agreement.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Random.h>

#include <cassert>
#include <cstddef>
#include <map>
#include <vector>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_2;
using Points_by_id = std::map<std::size_t, Point>;

// Asserts that `dt` is certified, and has the points and the edges of a fresh triangulation.
template <class Dynamic>
void assert_exact(const Dynamic& dt, const Points_by_id& points)
{
  assert(dt.is_valid());
  assert(dt.is_certified());
  assert(dt.number_of_points() == points.size());
  CGAL::Delaunay_triangulation_2<Kernel> fresh;
  for (const auto& [id, p] : points) {
    assert(dt.has_id(id));
    assert(dt.point(id) == p);
    fresh.insert(p);
  }
  assert(dt.number_of_vertices() == fresh.number_of_vertices());
  assert(dt.triangulation().dimension() == fresh.dimension());
  assert(CGAL::delaunay_agreement(dt, fresh).is_perfect());
}

// The ids are the indices.
template <class Dynamic>
void assert_exact(const Dynamic& dt, const std::vector<Point>& points)
{
  Points_by_id points_by_id;
  for (std::size_t id = 0; id < points.size(); ++id)
    points_by_id.emplace(id, points[id]);
  assert_exact(dt, points_by_id);
}

inline Point random_point(CGAL::Random& random)
{
  const double x = random.get_double();
  return Point(x, random.get_double());
}

inline std::vector<Point> random_points(CGAL::Random& random, std::size_t number)
{
  std::vector<Point> points;
  while (points.size() < number)
    points.push_back(random_point(random));
  return points;
}

#endif // DYNAMIC_DELAUNAY_TRIANGULATION_2_TEST_PLAIN_ORACLE_H

// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "bindings/python/src/Triangle_walk.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <cmath>
#include <cstddef>

namespace python {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_2;

// Walks through edges that have the query point on their other side. In a Delaunay triangulation
// this ends, since distances from the query point to the circles, as powers, decrease.
class Triangle_walk
{
public:
  explicit Triangle_walk(const Flat_triangles& triangles)
    : m_triangles(triangles)
    , m_step(1 + std::size_t(std::pow(double(triangles.size), 2.0 / 3)))
  {
  }

  std::int32_t operator()(const Point& query_point)
  {
    if (m_triangles.size == 0) {
      return -1;
    }
    for (std::int32_t t = start(query_point);;) {
      m_last = std::size_t(t);
      const int side = side_towards(query_point, m_last);
      if (side < 0) {
        return t;
      }
      t = m_triangles.neighbors[3 * m_last + std::size_t(side)];
      if (t < 0) {
        return -1;
      }
    }
  }

private:
  Point corner(std::size_t t, std::size_t k) const
  {
    const auto id = std::size_t(m_triangles.corners[3 * t + k % 3]);
    return Point(m_triangles.points[2 * id], m_triangles.points[2 * id + 1]);
  }

  // The last triangle, or one of n^(1/3) others: that which is nearest.
  std::int32_t start(const Point& query_point) const
  {
    std::size_t nearest = m_last;
    double square = CGAL::squared_distance(corner(nearest, 0), query_point);
    for (std::size_t t = 0; t < m_triangles.size; t += m_step) {
      const double other = CGAL::squared_distance(corner(t, 0), query_point);
      if (other < square) {
        nearest = t;
        square = other;
      }
    }
    return std::int32_t(nearest);
  }

  // The corner whose opposite edge has the query point strictly on its other side, or -1.
  int side_towards(const Point& query_point, std::size_t t) const
  {
    for (std::size_t k = 0; k < 3; ++k) {
      if (CGAL::orientation(corner(t, k + 1), corner(t, k + 2), query_point) == CGAL::RIGHT_TURN) {
        return int(k);
      }
    }
    return -1;
  }

  Flat_triangles m_triangles;
  std::size_t m_step;
  std::size_t m_last = 0;
};

} // namespace

std::vector<std::int32_t> triangles_at(const Rows& query_points, const Flat_triangles& triangles)
{
  Triangle_walk walk(triangles);
  std::vector<std::int32_t> found;
  found.reserve(query_points.size);
  for (std::size_t i = 0; i < query_points.size; ++i) {
    const double x = query_points.at<double>(i, 0), y = query_points.at<double>(i, 1);
    found.push_back(std::isfinite(x) && std::isfinite(y) ? walk(Point(x, y)) : -1);
  }
  return found;
}

} // namespace python

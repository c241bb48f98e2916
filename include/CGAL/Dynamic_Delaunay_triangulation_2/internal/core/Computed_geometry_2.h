// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_CORE_COMPUTED_GEOMETRY_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_CORE_COMPUTED_GEOMETRY_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/proof/Edge_test_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/topology/Halfedge_arrays_2.h>

#include <cmath>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

// Plain floating-point geometry without error bounds. Heuristic classifiers use the rounded results
// as they are; exact ones bound the error themselves.

inline double squared_distance(const Position_2& p, const Position_2& q)
{
  const double x = p.x - q.x, y = p.y - q.y;
  return product(x, x) + product(y, y);
}

inline double distance(const Position_2& p, const Position_2& q)
{
  return std::sqrt(squared_distance(p, q));
}

inline Position_2 operator-(const Position_2& p, const Position_2& q)
{
  return {p.x - q.x, p.y - q.y};
}

inline double cross(const Position_2& u, const Position_2& v)
{
  return product(u.x, v.y) - product(u.y, v.x);
}

inline double dot(const Position_2& u, const Position_2& v)
{
  return product(u.x, v.x) + product(u.y, v.y);
}

// The circumcenter of the triangle of the origin, u and v, in either order. Infinite or NaN if they
// are collinear.
inline Position_2 circumcenter(const Position_2& u, const Position_2& v)
{
  const double uu = dot(u, u), vv = dot(v, v);
  const double scale = 0.5 / cross(u, v);
  return {(product(v.y, uu) - product(u.y, vv)) * scale,
          (product(u.x, vv) - product(v.x, uu)) * scale};
}

// True if an edge at infinity has a finite face that is not counterclockwise, or a finite end at
// which the hull turns right. False for all other edges.
inline bool breaks_hull(const Edge_2& edge, const std::vector<Position_2>& positions)
{
  const auto orientation = [&](Index p, Index q, Index r) {
    return cross(positions[q] - positions[p], positions[r] - positions[p]);
  };
  return by_kind(
      edge, [] { return false; },
      [&](Index a, Index b, Index c) { return !(orientation(a, b, c) > 0); },
      [&](Index p, Index q, Index r) { return !(orientation(p, q, r) >= 0); });
}

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_CORE_COMPUTED_GEOMETRY_2_H

// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// A space of another kind: the plane with an anisotropic metric, in which circles are ellipses.

#ifndef DYNAMIC_DELAUNAY_TRIANGULATION_2_TEST_ANISOTROPIC_PLANE_H
#define DYNAMIC_DELAUNAY_TRIANGULATION_2_TEST_ANISOTROPIC_PLANE_H

#include <CGAL/enum.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

// Measures a vector v by the length of A v, for a constant matrix A of positive determinant. So
// orientations are the usual ones, and circles are circles once A has been applied to all points.
class Anisotropic_traits : public CGAL::Exact_predicates_inexact_constructions_kernel
{
  using Exact = CGAL::Exact_predicates_exact_constructions_kernel;

  // Exactly.
  static Exact::Point_2 stretched(const Point_2& p)
  {
    const Exact::FT x = p.x(), y = p.y();
    return {3 * x + y, y / 2 - x / 4};
  }

public:
  // The package's filters know Euclidean circles only.
  static constexpr bool has_euclidean_circles = false;

  struct Side_of_oriented_circle_2
  {
    CGAL::Oriented_side operator()(const Point_2& p, const Point_2& q, const Point_2& r,
                                   const Point_2& s) const
    {
      return CGAL::side_of_oriented_circle(stretched(p), stretched(q), stretched(r), stretched(s));
    }
  };
  Side_of_oriented_circle_2 side_of_oriented_circle_2_object() const { return {}; }

  struct Compare_distance_2
  {
    CGAL::Comparison_result operator()(const Point_2& p, const Point_2& q, const Point_2& r) const
    {
      return CGAL::compare_distance_to_point(stretched(p), stretched(q), stretched(r));
    }
  };
  Compare_distance_2 compare_distance_2_object() const { return {}; }
};

#endif // DYNAMIC_DELAUNAY_TRIANGULATION_2_TEST_ANISOTROPIC_PLANE_H

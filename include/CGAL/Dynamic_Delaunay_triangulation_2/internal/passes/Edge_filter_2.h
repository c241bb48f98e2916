// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_PASSES_EDGE_FILTER_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_PASSES_EDGE_FILTER_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Flat_elements_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Lanes_2.h>

#include <boost/config.hpp>

#include <utility>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

// The three signs that decide an edge, in floating point with proved error bounds.
//
// For an edge (b, c) with faces (a, b, c) and (d, c, b):
//
//     left, left_dot      the cross and the dot product of b - a and c - a
//     right, right_dot    those of c - d and b - d
//     in_circle           -(left right_dot + left_dot right)
//
// `left` and `right` are the orientations of the faces. The angle at a has the cotangent left_dot /
// left, the one at d likewise. So between counterclockwise faces `in_circle` is negative if and
// only if these two angles are less than 180 degrees together. Multiplied out, `in_circle` is the
// in-circle determinant of a, b, c and d, so both have the same sign wherever the points are. This
// form takes fewer operations: the pass over the edges takes a tenth less time.
//
// The bounds. Let u = 2^-53. Each difference, product and sum is rounded once, by a factor between
// 1 - u and 1 + u. Let L = |b - a||c - a| and S = |left| + |left_dot|, as `left_size` is computed.
// By Lagrange's identity left^2 + left_dot^2 = L^2, so L <= S. Let M and T be the same at d.
//
// Orientation. A term of `left` or `left_dot` is a product of two differences: three roundings. The
// sum of the terms is the fourth. So their errors are at most 4u L + O(u^2), as the sum of the
// absolute values of both terms is at most L. The same bound holds at d, with M.
//
// In-circle. The errors of the factors change the two products by at most
//     4u (L |right_dot| + M |left|) + 4u (M |left_dot| + L |right|) <= 8u S T
// and rounding the products and their sum by at most 2u S T. So the error is at most 10u S T +
// O(u^2).
//
// The relative errors of the computed S and T are at most 9u. The computed bounds 5u S, 5u T and
// 11u S T cover all that.
//
// Underflow. Differences are exact then. A product that underflows is off by at most 2^-1075.
// Nothing is proved unless S and T are above 1e-150; for orientations the bound itself is larger.
// So what underflow adds to an error is below 1e-320 S or T, or 1e-320, while u S, u T and u S T,
// by which the computed bounds are too large, are above 1e-166 and 1e-316.
//
// Overflow. No summand is larger than S, T or S T, as rounding is monotonic. So if one overflows,
// the bound is infinite or NaN, as the factor is applied last, and all comparisons below are false.
// If only the sum in `in_circle` overflows, it is far larger than its error.
//
// All that holds as well where one instruction computes a product and a sum and rounds once: that
// is one error less. Yet products are rounded separately, so that all processors prove the same
// edges. Each lane has one edge.
template <class Number>
struct Edge_filter_in_lanes_2
{
  static constexpr double orientation_factor = 5 * 0x1p-53;
  static constexpr double in_circle_factor = 11 * 0x1p-53;
  static constexpr double smallest_size = 1e-150;

  using Points = Points_in_lanes_2<Number>;
  using Answers = decltype(std::declval<Number>() < std::declval<Number>());

  Number left, right, left_size, right_size, in_circle;

  // Takes the vectors from the left corners to the ends of the edges, and from the right corners.
  BOOST_FORCEINLINE Edge_filter_in_lanes_2(const Points& ab, const Points& ac, const Points& db,
                                           const Points& dc)
    : Edge_filter_in_lanes_2(cross(ab, ac), cross(dc, db), dot(ab, ac), dot(dc, db))
  {
  }

  // Bounds on the errors of `left`, `right` and `in_circle`.
  BOOST_FORCEINLINE Number left_bound() const { return orientation_bound(left_size); }
  BOOST_FORCEINLINE Number right_bound() const { return orientation_bound(right_size); }
  BOOST_FORCEINLINE Number in_circle_bound() const
  {
    return product(in_circle_factor, product(left_size, right_size));
  }

  // False where products may have underflowed.
  BOOST_FORCEINLINE Answers is_large() const
  {
    return (left_size > smallest_size) & (right_size > smallest_size);
  }

  // True only if both faces are counterclockwise.
  BOOST_FORCEINLINE Answers proves_counterclockwise() const
  {
    const Number left_error = left_bound(), right_error = right_bound();
    return (left > left_error) & (right > right_error);
  }

  // True only if both faces are counterclockwise and the edge is strictly locally Delaunay.
  BOOST_FORCEINLINE Answers proves_delaunay() const
  {
    const Answers are_counterclockwise = proves_counterclockwise();
    const Number error = in_circle_bound();
    return are_counterclockwise & (in_circle < -error);
  }

  // True only if both faces are counterclockwise and the edge is not locally Delaunay.
  BOOST_FORCEINLINE Answers proves_illegal() const
  {
    const Answers are_counterclockwise = proves_counterclockwise();
    const Number error = in_circle_bound();
    return are_counterclockwise & (in_circle > error);
  }

  // True only if a face is clockwise, or the edge is not locally Delaunay.
  BOOST_FORCEINLINE Answers disproves_delaunay() const
  {
    const Number left_error = left_bound(), right_error = right_bound(), error = in_circle_bound();
    const Answers has_large_terms = is_large();
    return (left < -left_error) | (right < -right_error) | ((in_circle > error) & has_large_terms);
  }

private:
  BOOST_FORCEINLINE Edge_filter_in_lanes_2(const Number& left_cross, const Number& right_cross,
                                           const Number& left_dot, const Number& right_dot)
    : left(left_cross)
    , right(right_cross)
    , left_size(magnitude(left) + magnitude(left_dot))
    , right_size(magnitude(right) + magnitude(right_dot))
    , in_circle(-(product(left, right_dot) + product(left_dot, right)))
  {
  }

  BOOST_FORCEINLINE static Number cross(const Points& p, const Points& q)
  {
    return product(p.x, q.y) - product(q.x, p.y);
  }
  BOOST_FORCEINLINE static Number dot(const Points& p, const Points& q)
  {
    return product(p.x, q.x) + product(p.y, q.y);
  }
  BOOST_FORCEINLINE static Number orientation_bound(const Number& size)
  {
    return product(orientation_factor, size) + smallest_size;
  }
};

// The filter of one edge.
struct Edge_filter_2 : Edge_filter_in_lanes_2<double>
{
  BOOST_FORCEINLINE explicit Edge_filter_2(const Edge_corners_2& corners)
    : Edge_filter_2(in_one_lane(corners.left), in_one_lane(corners.source),
                    in_one_lane(corners.target), in_one_lane(corners.right))
  {
  }

private:
  BOOST_FORCEINLINE Edge_filter_2(const Points& a, const Points& b, const Points& c,
                                  const Points& d)
    : Edge_filter_in_lanes_2(b - a, c - a, b - d, c - d)
  {
  }
};

// The sign of orientation(a, b, c) if it is proved, 0 if not. The determinant is the rounded
// difference of two products with three roundings each. So its error is at most 4u T + O(u^2),
// where T is the sum of the products' absolute values. The relative error of the computed T is at
// most 3u. Nothing is proved where products or the bound could underflow.
inline int filtered_orientation(const Position_2& a, const Position_2& b, const Position_2& c)
{
  constexpr double factor = 5 * 0x1p-53, smallest = 1e-280;
  const double p = product(a.x - c.x, b.y - c.y), q = product(b.x - c.x, a.y - c.y);
  const double determinant = p - q, t = magnitude(p) + magnitude(q), bound = factor * t;
  const bool is_large = t > smallest;
  return int((determinant > bound) & is_large) - int((determinant < -bound) & is_large);
}

// Positive if d is proved to be inside of the circle through a, b and c, which must be
// counterclockwise; negative if d is proved to be outside; 0 if nothing is proved.
inline int filtered_in_circle(const Position_2& a, const Position_2& b, const Position_2& c,
                              const Position_2& d)
{
  const Edge_filter_2 filter({a, b, c, d});
  const double bound = filter.in_circle_bound();
  const bool is_large = filter.is_large();
  return int((filter.in_circle > bound) & is_large) - int((filter.in_circle < -bound) & is_large);
}

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_PASSES_EDGE_FILTER_2_H

// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_EDGE_FILTER_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_EDGE_FILTER_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Floating_point_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Neighborhood_mirror_2.h>

#include <cmath>

namespace CGAL {
namespace Dynamic_Delaunay_triangulations_2 {
namespace internal {

// The three signs that decide an edge, in floating point with proved error bounds.
//
// For an edge (b, c) with faces (a, b, c) and (d, c, b), all coordinates relative to d:
//   ab, bc, ca       the 2x2 minors, e.g. bc = bx cy - cx by
//   right            orientation(d, c, b)  = -bc
//   left             orientation(a, b, c)  = ab + bc + ca
//   in_circle        |a|^2 bc + |b|^2 ca + |c|^2 ab, positive if d is inside the circle of abc
//
// Bounds. Let u = 2^-53 and s = |a|^2 + |b|^2 + |c|^2. A difference, a product and a sum each round
// once, by a factor within 1 +- u.
//   A term of a minor is a product of two differences: 3 roundings; the minor's subtraction: 1
//   more; at
// most two additions in `left`: 2 more. So |error(left)| <= 6u T + O(u^2), T the sum of the terms'
// absolute values, |bx cy| + |cx by| + ... By |bx cy| + |cx by| <= |b||c| <= (|b|^2 + |c|^2) / 2
// and its like, T <= s. The same holds for `right`.
//   A square |a|^2 takes two differences, a product and a sum: 4 roundings; its product with a
//   minor (4)
// is 9; two additions: 11. So |error(in_circle)| <= 11u P + O(u^2) with P = |a|^2 (|bx cy| + |cx
// by|) +
// ..., and P <= |a|^2 |b||c| + |b|^2 |c||a| + |c|^2 |a||b| <= s^2 / 3 (the sum of x^2 yz is at most
// that of x^2 y^2, as xy yz <= (x^2 y^2 + y^2 z^2) / 2). That is 3.67u s^2.
//   The computed s is within 6u of s, relatively. 8u s and 5u s^2, computed, cover all of this.
//   Underflow: differences are exact then; a product that underflows errs by at most 2^-1075, times
//   at
// most 2s where it is multiplied further, some 30 s 2^-1075 altogether; with s >= 1e-120 that is
// far below u s and u s^2, so smaller s are left to the kernel.
//   Overflow: what is summed up is at most s, or s^2 / 3, so where it overflows the bound is
// infinite (for that s^2 has to be computed before the factor is applied), and every comparison
// below fails.
//   Contraction to fused multiply-adds only leaves roundings out.
struct Edge_filter_2
{
  static constexpr double orientation_factor = 8 * 0x1p-53;
  static constexpr double in_circle_factor = 5 * 0x1p-53;
  static constexpr double smallest_s = 1e-120;

  double s, left, right, in_circle;

  Edge_filter_2(const Position_2& a, const Position_2& b, const Position_2& c, const Position_2& d)
  {
    const double ax = a.x - d.x, ay = a.y - d.y;
    const double bx = b.x - d.x, by = b.y - d.y;
    const double cx = c.x - d.x, cy = c.y - d.y;
    const double bc = bx * cy - cx * by;
    const double ca = cx * ay - ax * cy;
    const double ab = ax * by - bx * ay;
    const double aa = ax * ax + ay * ay;
    const double bb = bx * bx + by * by;
    const double cc = cx * cx + cy * cy;
    s = aa + bb + cc;
    right = -bc;
    left = ab + bc + ca;
    in_circle = aa * bc + bb * ca + cc * ab;
  }

  // Both faces are counterclockwise: proved.
  bool proves_counterclockwise() const
  {
    const double bound = orientation_factor * s;
    return (left > bound) & (right > bound) & (s > smallest_s);
  }

  // They are, and the edge is locally Delaunay, no tie: proved.
  bool proves_delaunay() const
  {
    return proves_counterclockwise() & (in_circle < -(in_circle_factor * (s * s)));
  }

  // They are, and the edge is not locally Delaunay: proved.
  bool proves_illegal() const
  {
    return proves_counterclockwise() & (in_circle > in_circle_factor * (s * s));
  }

  // A face is clockwise, or the edge is not locally Delaunay: proved.
  bool disproves_delaunay() const
  {
    const double bound = orientation_factor * s;
    return ((left < -bound) | (right < -bound) | (in_circle > in_circle_factor * (s * s))) &
           (s > smallest_s);
  }
};

// orientation(a, b, c): positive or negative if it is proved, 0 if not. The determinant is the
// difference of two products with 3 roundings each, and its own: with T the sum of their absolute
// values its error is at most 4u T + O(u^2), and the computed T is within 3u of T, relatively.
// Underflow as above.
inline int filtered_orientation(const Position_2& a, const Position_2& b, const Position_2& c)
{
  constexpr double factor = 5 * 0x1p-53, smallest = 1e-280;
  const double p = (a.x - c.x) * (b.y - c.y), q = (b.x - c.x) * (a.y - c.y);
  const double determinant = p - q, t = std::abs(p) + std::abs(q), bound = factor * t;
  const bool is_large = t > smallest;
  return int((determinant > bound) & is_large) - int((determinant < -bound) & is_large);
}

// The side of d of the circle through a, b, c, which are given counterclockwise, in the same way.
inline int filtered_in_circle(const Position_2& a, const Position_2& b, const Position_2& c,
                              const Position_2& d)
{
  const Edge_filter_2 filter(a, b, c, d);
  const double bound = Edge_filter_2::in_circle_factor * (filter.s * filter.s);
  const bool is_large = filter.s > Edge_filter_2::smallest_s;
  return int((filter.in_circle > bound) & is_large) - int((filter.in_circle < -bound) & is_large);
}

} // namespace internal
} // namespace Dynamic_Delaunay_triangulations_2
} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_EDGE_FILTER_2_H

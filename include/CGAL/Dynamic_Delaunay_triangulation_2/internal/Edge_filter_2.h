// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_EDGE_FILTER_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_EDGE_FILTER_2_H

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
// Bounds (u = 2^-53). A difference, a product and a sum each round once, by a factor within 1 +- u.
// A term of a minor is a product of two differences: 3 roundings; the minor's subtraction: 1 more;
// at most two additions in `left`: 2 more. So |error(left)| <= (6u + O(u^2)) S, S the sum of the
// terms' absolute values; the computed S is at least (1 - 9u) of the true one, and 8u S covers it.
// The same bound covers `right`. A square |a|^2 takes two differences, a product and a sum: 4
// roundings; its product with a minor (4) is 9; two additions: 11. So |error(in_circle)| <= (11u +
// O(u^2)) P, and 16u P covers it, P = |a|^2 S_bc + |b|^2 S_ca + |c|^2 S_ab computed with 11
// roundings at most. Underflow: differences are exact then; a product that underflows errs by at
// most 2^-1075, times a factor of at most 2(|a|^2 + |b|^2 + |c|^2) where it is multiplied further:
// 1e-290 (|a|^2 + |b|^2 + |c|^2 + 1) is above any sum of them. Overflow gives infinities or NaNs,
// with which every comparison below fails. Contraction to fused multiply-adds only leaves roundings
// out.
struct Edge_filter_2
{
  static constexpr double u = 0x1p-53;

  double left, left_bound;
  double right, right_bound;
  double in_circle, in_circle_bound;

  Edge_filter_2(const Position_2& a, const Position_2& b, const Position_2& c, const Position_2& d)
  {
    const double ax = a.x - d.x, ay = a.y - d.y;
    const double bx = b.x - d.x, by = b.y - d.y;
    const double cx = c.x - d.x, cy = c.y - d.y;

    const double bxcy = bx * cy, cxby = cx * by;
    const double cxay = cx * ay, axcy = ax * cy;
    const double axby = ax * by, bxay = bx * ay;
    const double bc = bxcy - cxby, ca = cxay - axcy, ab = axby - bxay;
    const double bc_sum = std::abs(bxcy) + std::abs(cxby);
    const double ca_sum = std::abs(cxay) + std::abs(axcy);
    const double ab_sum = std::abs(axby) + std::abs(bxay);
    const double aa = ax * ax + ay * ay, bb = bx * bx + by * by, cc = cx * cx + cy * cy;

    const double underflow = 1e-290 * (aa + bb + cc + 1);
    right = -bc;
    right_bound = 8 * u * bc_sum + underflow;
    left = ab + bc + ca;
    left_bound = 8 * u * (ab_sum + bc_sum + ca_sum) + underflow;
    in_circle = aa * bc + bb * ca + cc * ab;
    in_circle_bound = 16 * u * (aa * bc_sum + bb * ca_sum + cc * ab_sum) + underflow;
  }

  // Both faces are counterclockwise and the edge is locally Delaunay, no tie: proved.
  bool proves_delaunay() const
  {
    return (in_circle < -in_circle_bound) & (left > left_bound) & (right > right_bound);
  }
};

} // namespace internal
} // namespace Dynamic_Delaunay_triangulations_2
} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_EDGE_FILTER_2_H

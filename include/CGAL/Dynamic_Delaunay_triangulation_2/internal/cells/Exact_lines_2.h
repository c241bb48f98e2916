// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_CELLS_EXACT_LINES_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_CELLS_EXACT_LINES_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Flat_arrays.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Flat_elements_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Points_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_errors_2.h>
#include <CGAL/number_type_basic.h>
#include <CGAL/Number_types/internal/Exact_type_selector.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

// Lines of cells of points that are far from a domain.
//
// Let u = 2^-53. Cells are cut relative to their points. Where the domain goes up to the distance L
// from a point, corners are off by a few u L, and the area by a few u L^2, which may be more than
// the domain has. So a cell whose point is farther than two extents from the domain's center is cut
// relative to that center, by lines that are computed exactly from the coordinates and rounded at
// the end. A line that meets the domain is then off by a few u times the domain's extent.

// All x with direction * x = product, relative to an origin.
struct Line_2
{
  Position_2 direction;
  double product;
};

// Throws unless a corner of a domain is finite, and areas and moments can be computed.
inline void check_domain_corner(std::size_t number, const Position_2& p, const Position_2& first)
{
  constexpr double most = 1e100; // its cube has to be a double
  if (!std::isfinite(p.x) || !std::isfinite(p.y))
    throw Domain_error_2(number, "it is not finite");
  if (!(std::abs(p.x - first.x) <= most && std::abs(p.y - first.y) <= most))
    throw Domain_error_2(number, "it is farther than 1e100 from the first corner");
}

// The surroundings of a domain: a center, and a bound on |x| + |y| relative to it.
struct Surroundings_2
{
  // Everything, if there is no domain.
  Surroundings_2() = default;
  Surroundings_2(const Position_2& least, const Position_2& most)
    : center{least.x + (most.x - least.x) / 2, least.y + (most.y - least.y) / 2}
    , reach((1 + 0x1p-50) * ((std::max)(most.x - center.x, center.x - least.x) +
                             (std::max)(most.y - center.y, center.y - least.y)))
  {
  }

  static double size(const Position_2& way) { return std::abs(way.x) + std::abs(way.y); }
  // Whether p is far away, and the disc around p has all of them.
  bool are_seen_from_afar(const Position_2& p, double radius) const
  {
    const double distance = size(p - center);
    return distance > 2 * reach && (std::isinf(radius) || distance + reach < radius);
  }
  // An upper bound on the distances of all of them from p.
  double reach_from(const Position_2& p) const { return size(p - center) + reach; }

  Position_2 center{0, 0};
  double reach = std::numeric_limits<double>::infinity();
};

using Exact_ring_2 = CGAL::internal::Exact_ring_selector<double>::Type;

// A line in doubles. A power of two brings the direction to about the length 1, so that nothing
// overflows or underflows. All that fits into doubles stays exact: so do lines that meet in a
// corner of a domain.
inline Line_2 rounded_line(const Exact_ring_2& x, const Exact_ring_2& y,
                           const Exact_ring_2& product)
{
  const double size = (std::max)(std::abs(CGAL::to_double(x)), std::abs(CGAL::to_double(y)));
  const int exponent = (std::min)((std::max)(std::ilogb(size), -1000), 1000);
  const Exact_ring_2 scale(std::ldexp(1.0, -exponent));
  return {{CGAL::to_double(x * scale), CGAL::to_double(y * scale)},
          CGAL::to_double(product * scale)};
}

// The bisector of two points, relative to an origin. Its direction is that from p to q. Where an
// exact kernel distinguishes points with equal doubles, their rounded difference counts.
inline Line_2 exact_bisector(const Position_2& p, const Position_2& q, const Position_2& difference,
                             const Position_2& origin)
{
  const bool are_equal = p.x == q.x && p.y == q.y;
  const Exact_ring_2 x =
      are_equal ? Exact_ring_2(difference.x) : Exact_ring_2(Exact_ring_2(q.x) - Exact_ring_2(p.x));
  const Exact_ring_2 y =
      are_equal ? Exact_ring_2(difference.y) : Exact_ring_2(Exact_ring_2(q.y) - Exact_ring_2(p.y));
  const Exact_ring_2 to_p_x = Exact_ring_2(p.x) - Exact_ring_2(origin.x);
  const Exact_ring_2 to_p_y = Exact_ring_2(p.y) - Exact_ring_2(origin.y);
  const Exact_ring_2 half(0.5);
  return rounded_line(x, y, x * (to_p_x + x * half) + y * (to_p_y + y * half));
}

// How the bisector of p and q divides the places with |x| + |y| <= reach, on the side of p or not.
enum class Division_2 { ALL_BEFORE, ALL_BEYOND, UNKNOWN };

// Decides where doubles suffice. The scalar product is off by less than 2^-49 of the sum of the
// absolute values in it, besides underflow. Overflow and NaN leave it unknown.
inline Division_2 division(const Position_2& p, const Position_2& q, const Position_2& difference,
                           double reach)
{
  const double size = Surroundings_2::size(difference);
  const double summands = size * (Surroundings_2::size(p) + Surroundings_2::size(q));
  const double margin = size * reach + 0x1p-49 * summands + 0x1p-1060;
  const double product = dot(difference, {p.x / 2 + q.x / 2, p.y / 2 + q.y / 2});
  if (product > margin)
    return Division_2::ALL_BEFORE;
  return product < -margin ? Division_2::ALL_BEYOND : Division_2::UNKNOWN;
}

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_CELLS_EXACT_LINES_2_H

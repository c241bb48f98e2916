// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_PASSES_POINTS_3_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_PASSES_POINTS_3_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_3/Dynamic_Delaunay_triangulation_errors_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/passes/Elements_3.h>
#include <CGAL/Interval_nt.h>
#include <CGAL/number_type_basic.h>
#include <CGAL/Point_3.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <type_traits>
#include <utility>

namespace CGAL::Dynamic_Delaunay_triangulations_3::internal {

// Whether a point is just three doubles.
template <class Point>
constexpr bool is_three_doubles = false;
template <class Kernel>
constexpr bool is_three_doubles<CGAL::Point_3<Kernel>> =
    std::is_same_v<std::decay_t<decltype(std::declval<const CGAL::Point_3<Kernel>&>().x())>,
                   double> &&
    sizeof(CGAL::Point_3<Kernel>) == 3 * sizeof(double);

// The kernel's predicates are exact for coordinates below this magnitude.
//
// Compiled for SSE4.1 or AVX, CGAL's interval product loses a 0 that meets an infinity (CGAL 5.5;
// cf. its issue 4312), so no operand of a product may overflow. The largest operands, in the
// in-sphere determinant, have degree 4: sums of at most 18 products of a squared difference and two
// differences. With coordinates below 2^250 they are at most 18 * 3 * 2^(4 * 251) < 2^1010.
#if defined(CGAL_USE_SSE2) && (defined(__SSE4_1__) || defined(__AVX__))
constexpr double coordinate_limit = 0x1p250;
#else
constexpr double coordinate_limit = std::numeric_limits<double>::infinity();
#endif

template <class Point>
Position_3 approximation(const Point& p)
{
  return {CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())};
}

inline bool is_finite(const Position_3& p)
{
  return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
}

inline bool is_within_limit(const Position_3& p)
{
  return std::abs(p.x) < coordinate_limit && std::abs(p.y) < coordinate_limit &&
         std::abs(p.z) < coordinate_limit;
}

// The position of a point. Throws if its coordinates are not finite, or beyond the limit.
template <class Point>
Position_3 checked_position(const Point& p, std::size_t id)
{
  const Position_3 position = approximation(p);
  if (is_within_limit(position)) // neither NaN nor infinity is
    return position;
  if (!is_finite(position))
    throw Non_finite_coordinate_error_3(id, position.x, position.y, position.z);
  throw Coordinate_range_error_3(id, position.x, position.y, position.z, coordinate_limit);
}

// Whether the position is known to be exact, judging by the intervals of the coordinates.
template <class Point>
bool has_exact_position(const Point& p)
{
  if constexpr (is_three_doubles<Point>) {
    return true;
  } else {
    const auto is_a_double = [](const auto& coordinate) {
      const std::pair<double, double> interval = CGAL::to_interval(coordinate);
      return interval.first == interval.second;
    };
    return is_a_double(p.x()) && is_a_double(p.y()) && is_a_double(p.z());
  }
}

} // namespace CGAL::Dynamic_Delaunay_triangulations_3::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_PASSES_POINTS_3_H

// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_INPUT_POSITION_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_INPUT_POSITION_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Coordinate_range_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Neighborhood_mirror_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Planar_points_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_errors_2.h>
#include <CGAL/number_type_basic.h>

#include <cmath>
#include <cstddef>
#include <utility>

namespace CGAL {
namespace Dynamic_Delaunay_triangulations_2 {
namespace internal {

// Where a point is, if it can be there.
template <class Point>
Position_2 checked_position(const Point& p, std::size_t id)
{
  const Position_2 position{CGAL::to_double(p.x()), CGAL::to_double(p.y())};
  if (!std::isfinite(position.x) || !std::isfinite(position.y))
    throw Non_finite_coordinate_error_2(id, position.x, position.y);
  if (!is_within_limit(position.x) || !is_within_limit(position.y))
    throw Coordinate_range_error_2(id, position.x, position.y, coordinate_limit);
  return position;
}

// Whether none of its coordinates is rounded for that, as far as their intervals tell.
template <class Point>
bool has_exact_position(const Point& p)
{
  if constexpr (has_double_coordinates<Point>) {
    return true;
  } else {
    const auto is_a_double = [](const auto& coordinate) {
      const std::pair<double, double> interval = CGAL::to_interval(coordinate);
      return interval.first == interval.second;
    };
    return is_a_double(p.x()) && is_a_double(p.y());
  }
}

// Both: clears `are_exact` if a coordinate is rounded.
template <class Point>
Position_2 checked_position(const Point& p, std::size_t id, bool& are_exact)
{
  const Position_2 position = checked_position(p, id);
  are_exact = are_exact && has_exact_position(p);
  return position;
}

} // namespace internal
} // namespace Dynamic_Delaunay_triangulations_2
} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_INPUT_POSITION_2_H

// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_PLANAR_POINTS_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_PLANAR_POINTS_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/enum.h>
#include <CGAL/number_type_basic.h>
#include <CGAL/Point_2.h>

#include <type_traits>
#include <utility>

namespace CGAL {
namespace Dynamic_Delaunay_triangulations_2 {
namespace internal {

// What the triangulation knows of points, whatever they are: where they are in the plane of their x
// and y. They may hold more, such as a height, which has to come along.

template <class Point>
constexpr bool has_double_coordinates =
    std::is_same_v<std::decay_t<decltype(std::declval<const Point&>().x())>, double>;

// Whether a point can be made of its x and y again.
template <class Point>
constexpr bool is_made_of_x_and_y = false;
template <class Kernel>
constexpr bool is_made_of_x_and_y<CGAL::Point_2<Kernel>> = true;

// Whether it is nothing but two doubles. A kernel may add data of its own to its points: then they
// are larger.
template <class Point>
constexpr bool is_two_doubles = is_made_of_x_and_y<Point>&& has_double_coordinates<Point> &&
                                sizeof(Point) == 2 * sizeof(double);

template <class Traits, class Point>
Comparison_result compare_xy(const Traits& traits, const Point& p, const Point& q)
{
  if constexpr (has_double_coordinates<Point>) {
    return p.x() != q.x() ? CGAL::compare(p.x(), q.x()) : CGAL::compare(p.y(), q.y());
  } else {
    const Comparison_result x = traits.compare_x_2_object()(p, q);
    return x != EQUAL ? x : traits.compare_y_2_object()(p, q);
  }
}

// Points coincide if they are at the same place of the plane.
template <class Traits, class Point>
bool coincide(const Traits& traits, const Point& p, const Point& q)
{
  return compare_xy(traits, p, q) == EQUAL;
}

} // namespace internal
} // namespace Dynamic_Delaunay_triangulations_2
} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_PLANAR_POINTS_2_H

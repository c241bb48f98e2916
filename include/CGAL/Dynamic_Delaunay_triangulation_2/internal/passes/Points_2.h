// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_PASSES_POINTS_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_PASSES_POINTS_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Flat_arrays.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Flat_elements_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Lanes_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_errors_2.h>
#include <CGAL/enum.h>
#include <CGAL/Interval_nt.h>
#include <CGAL/number_type_basic.h>
#include <CGAL/Point_2.h>

#include <boost/config.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

// The triangulation uses only x and y of points, whatever their type. Points may hold more data,
// such as a height, which are passed along.

template <class Point>
constexpr bool has_double_coordinates =
    std::is_same_v<std::decay_t<decltype(std::declval<const Point&>().x())>, double>;

// Whether a point can be made from its x and y.
template <class Point>
constexpr bool is_made_of_x_and_y = false;
template <class Kernel>
constexpr bool is_made_of_x_and_y<CGAL::Point_2<Kernel>> = true;

// Whether a point is just two doubles. Kernels may add data to points, which are then larger.
// Points of other types need not even have coordinates.
template <class Point>
constexpr bool is_two_doubles = false;
template <class Kernel>
constexpr bool
    is_two_doubles<CGAL::Point_2<Kernel>> = has_double_coordinates<CGAL::Point_2<Kernel>> &&
                                            sizeof(CGAL::Point_2<Kernel>) == 2 * sizeof(double);

// True if the circles of the traits are Euclidean, as the floating-point filters assume. Traits
// with other circles set `has_euclidean_circles` to false: their predicates decide every sign.
template <class Traits, class = void>
struct Has_euclidean_circles_2 : std::true_type
{
};
template <class Traits>
struct Has_euclidean_circles_2<Traits, std::void_t<decltype(Traits::has_euclidean_circles)>>
  : std::bool_constant<Traits::has_euclidean_circles>
{
};

inline Position_2 nan_point()
{
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  return {nan, nan};
}

template <class Point>
Position_2 approximation(const Point& p)
{
  return {CGAL::to_double(p.x()), CGAL::to_double(p.y())};
}

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

// Points coincide if they have the same place in the plane.
template <class Traits, class Point>
bool coincide(const Traits& traits, const Point& p, const Point& q)
{
  return compare_xy(traits, p, q) == EQUAL;
}

// The kernel's predicates are exact for coordinates below this magnitude.
//
// Compiled for SSE4.1 or AVX, CGAL's interval product loses a 0 that meets an infinity: [-1, 0]
// times [1, inf] is [-inf, -1] (CGAL 5.5; cf. its issue 4312). Such an interval can exclude the
// true sign, so that exact arithmetic is not used. It appears only if an operand of a product
// overflows. The largest operands, in the in-circle determinant, are sums of two products of two
// differences. With coordinates below 2^510 they are at most 2 * 2^511 * 2^511 = 2^1023.
#if defined(CGAL_USE_SSE2) && (defined(__SSE4_1__) || defined(__AVX__))
constexpr double coordinate_limit = 0x1p510;
// The product of this with any coordinate beyond the limit overflows.
constexpr double factor_beyond_limit = 0x1p514;
#else
constexpr double coordinate_limit = std::numeric_limits<double>::infinity();
constexpr double factor_beyond_limit = 1;
#endif

inline bool is_within_limit(double coordinate)
{
  return std::isfinite(factor_beyond_limit * coordinate);
}

// Whether all coordinates of some positions are finite and within the limit, found without
// branches: a coordinate x is finite if 0 * x is 0, and within the limit if its product with the
// factor is finite.
class Limit_check_2
{
public:
#ifdef CGAL_DYNAMIC_DELAUNAY_HAS_LANES // g++ by itself computes x and y separately

  void add(const Position_2& p)
  {
    m_zero = m_zero + product(0, product(factor_beyond_limit, in_two_lanes(p)));
  }
  bool holds() const
  {
    return bits(m_zero == 0) == 3;
  }

private:
  Lanes<2> m_zero = 0;

#else

  void add(const Position_2& p)
  {
    m_zero.x += 0 * (factor_beyond_limit * p.x);
    m_zero.y += 0 * (factor_beyond_limit * p.y);
  }
  bool holds() const
  {
    return m_zero.x == 0 && m_zero.y == 0;
  }

private:
  Position_2 m_zero{0, 0};

#endif
};

// A function of its own, so that compilers inline the check.
[[noreturn]] BOOST_NOINLINE inline void throw_refused_position(const Position_2& position,
                                                               std::size_t id, const char* name)
{
  if (!std::isfinite(position.x) || !std::isfinite(position.y))
    throw Non_finite_coordinate_error_2(id, position.x, position.y, name);
  throw Coordinate_range_error_2(id, position.x, position.y, coordinate_limit, name);
}

// The position of a point. Throws if its coordinates are not finite, or beyond the limit.
template <class Point>
Position_2 checked_position(const Point& p, std::size_t id, const char* name = "point")
{
  const Position_2 position{CGAL::to_double(p.x()), CGAL::to_double(p.y())};
  if (!is_within_limit(position.x) || !is_within_limit(position.y))
    throw_refused_position(position, id, name);
  return position;
}

// Whether the position is known to be exact, judging by the intervals of the coordinates.
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

// Returns the checked position, and clears `are_exact` unless it is known to be exact.
template <class Point>
Position_2 checked_position(const Point& p, std::size_t id, bool& are_exact)
{
  const Position_2 position = checked_position(p, id);
  are_exact = are_exact && has_exact_position(p);
  return position;
}

// Throws unless a number is not negative, and finite or up to a limit. The error calls it `name`.
inline void check_extent(const char* name, double extent,
                         double largest = (std::numeric_limits<double>::max)())
{
  if (!(extent >= 0 && extent <= largest))
    throw Parameter_error_2(name, extent, 0, largest);
}

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

// Returns the value below which one in `part` of the values lies. Reorders the values, of which
// there must be one.
inline double quantile(std::vector<double>& values, std::size_t part)
{
  const auto place = values.begin() + std::ptrdiff_t(values.size() / part);
  std::nth_element(values.begin(), place, values.end());
  return *place;
}

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_PASSES_POINTS_2_H

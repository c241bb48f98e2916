// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_PASSES_CELL_FILTER_3_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_PASSES_CELL_FILTER_3_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Lanes_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/passes/Elements_3.h>

#include <boost/config.hpp>

#include <cstring>
#include <limits>

namespace CGAL::Dynamic_Delaunay_triangulations_3::internal {

using Dynamic_Delaunay_triangulations_2::internal::call_with_lanes;
using Dynamic_Delaunay_triangulations_2::internal::Lanes;
using Dynamic_Delaunay_triangulations_2::internal::larger;
using Dynamic_Delaunay_triangulations_2::internal::product;

// The coordinates of points, or of vectors, one in each lane.
template <class Number>
struct Points_in_lanes_3
{
  Number x, y, z;

  BOOST_FORCEINLINE Points_in_lanes_3 operator-(const Points_in_lanes_3& other) const
  {
    return {x - other.x, y - other.y, z - other.z};
  }
  BOOST_FORCEINLINE friend Points_in_lanes_3 cross(const Points_in_lanes_3& p,
                                                   const Points_in_lanes_3& q)
  {
    return {product(p.y, q.z) - product(p.z, q.y), product(p.z, q.x) - product(p.x, q.z),
            product(p.x, q.y) - product(p.y, q.x)};
  }
  BOOST_FORCEINLINE friend Number dot(const Points_in_lanes_3& p, const Points_in_lanes_3& q)
  {
    return product(p.x, q.x) + product(p.y, q.y) + product(p.z, q.z);
  }
};

// A point that is translated when it is loaded.
struct Translated_3
{
  const Position_3* position;
  const Position_3* translation;
};

#ifdef CGAL_DYNAMIC_DELAUNAY_HAS_LANES
template <int n>
BOOST_FORCEINLINE Lanes<n> load(const double& first)
{
  typename Lanes<n>::Vector numbers;
  std::memcpy(&numbers, &first, sizeof(numbers));
  return Lanes<n>(numbers);
}
// x and y, and with four lanes z.
template <int n>
BOOST_FORCEINLINE Lanes<n> load_from_x(const Position_3& p)
{
  return load<n>(p.x);
}
template <int n>
BOOST_FORCEINLINE Lanes<n> load_from_x(const Translated_3& p)
{
  return load<n>(p.position->x) + load<n>(p.translation->x);
}
BOOST_FORCEINLINE Lanes<2> load_from_z(const Position_3& p)
{
  return load<2>(p.z);
}
BOOST_FORCEINLINE Lanes<2> load_from_z(const Translated_3& p)
{
  return load<2>(p.position->z) + load<2>(p.translation->z);
}
#endif
BOOST_FORCEINLINE Points_in_lanes_3<double> load_one(const Position_3& p)
{
  return {p.x, p.y, p.z};
}
BOOST_FORCEINLINE Points_in_lanes_3<double> load_one(const Translated_3& p)
{
  return {p.position->x + p.translation->x, p.position->y + p.translation->y,
          p.position->z + p.translation->z};
}

// Puts the coordinates of point_at(i), which is a position or translated, into lane i. Positions,
// of four doubles, are loaded whole, and transposed.
template <int n, class Point_at>
BOOST_FORCEINLINE auto points_in_lanes(const Point_at& point_at)
{
#ifdef CGAL_DYNAMIC_DELAUNAY_HAS_LANES
  using Dynamic_Delaunay_triangulations_2::internal::Places;
  using Points = Points_in_lanes_3<Lanes<n>>;
  if constexpr (n == 4) {
    const Lanes<4> p = load_from_x<4>(point_at(0)), q = load_from_x<4>(point_at(1));
    const Lanes<4> r = load_from_x<4>(point_at(2)), s = load_from_x<4>(point_at(3));
    const Lanes<4> xz_low(p, q, Places<0, 4, 2, 6>()), xz_high(r, s, Places<0, 4, 2, 6>());
    const Lanes<4> y_low(p, q, Places<1, 5, 3, 7>()), y_high(r, s, Places<1, 5, 3, 7>());
    return Points{Lanes<4>(xz_low, xz_high, Places<0, 1, 4, 5>()),
                  Lanes<4>(y_low, y_high, Places<0, 1, 4, 5>()),
                  Lanes<4>(xz_low, xz_high, Places<2, 3, 6, 7>())};
  } else if constexpr (n == 2) {
    const Lanes<2> p = load_from_x<2>(point_at(0)), q = load_from_x<2>(point_at(1));
    return Points{Lanes<2>(p, q, Places<0, 2>()), Lanes<2>(p, q, Places<1, 3>()),
                  Lanes<2>(load_from_z(point_at(0)), load_from_z(point_at(1)), Places<0, 2>())};
  } else
#endif
  {
    const Points_in_lanes_3<double> p = load_one(point_at(0));
    return Points_in_lanes_3<Lanes<n>>{p.x, p.y, p.z};
  }
}

// What decides a cell (a, b, c, d) and its facets, in floating point with proved error bounds. With
// b, c and d as vectors from a, and e that to the vertex beyond a facet:
//
//     volume   b (c x d), six times the volume
//     sphere   |b|^2 (c x d) + |c|^2 (d x b) + |d|^2 (b x c)
//     power    volume |e|^2 - sphere e
//
// The in-sphere determinant is -power: if volume is positive, e is outside of the sphere if and
// only if power is. Both factors of `power` are computed once for the four facets of a cell.
//
// The bounds. Let u = 2^-53. Each difference, product and sum is rounded once, by a factor between
// 1 - u and 1 + u; let m be the largest of |b|, |c| and |d|, g that of m and |e|, and k' stand for
// (1 + u)^k - 1.
//
// A component of c x d, such as c.y d.z - c.z d.y, has the error 4' A.x with A.x = |c.y d.z| + |c.z
// d.y|: two differences, a product, a sum. By Cauchy and Schwarz, A.x^2 <= (|c|^2 - c.x^2) (|d|^2 -
// d.x^2), and |A|^2 <= |c|^2 |d|^2 + sum of c.i^2 d.i^2 <= 2 |c|^2 |d|^2. So |A| <= sqrt(2) m^2.
//
// volume: 4 roundings in c x d, one in b, one in the product, two in the sum: the error is at most
// 8' |b| |A| <= 8' sqrt(2) m^3 < 11.4 u m^3.
//
// sphere: |b|^2 has 5 roundings (two of a difference, product, two sums), c x d has 4, their
// product one, the sum of three two: as a vector the error has length 12' 3 sqrt(2) m^4 at most.
//
// power: sphere e adds one rounding of e, a product, and two sums, volume |e|^2 has 8 + 5 + 1, and
// the difference adds one to each. So the error is at most
//     17' 3 sqrt(2) m^4 |e| + 15' sqrt(2) m^3 |e|^2 < (72.2 + 21.3) u g^5.
//
// Bounds are compared squared, since only m^2 and g^2 are computed, with 5 roundings: the squares
// of 11.4 u and 93.5 u are 1.61e-30 and 1.08e-28. The factors below are larger by a tenth and more,
// while the roundings of m^6, g^10 and the comparison make up less than 50 u.
//
// Underflow. Differences are exact then. What underflows adds at most 2^-1075 to a product of j
// differences, j from 2 to 5, of which there are fewer than 100, and later at most 9 g^(5 - j)
// times that to the result. Nothing is proved unless m^2 > 1e-50; then g > 1e-25, these errors are
// below 1e-319 g^(5 - j) < 1e-243 g^5, and neither bound underflows: it is at least 1e-30 * 1e-150
// and 1e-28 * 1e-250.
//
// Overflow. All terms of `volume` and `power` are at most 3 m^3 and 5 g^5 in absolute value. So
// where one of them overflows, g^10 does, and where volume^2 does and m^6 does not, volume is far
// larger than its error. Nothing is proved of a cell if m^6 is infinite, nor of a facet if g^10 is.
//
// The infinite vertex has the position NaN. Where e is NaN, g is m, `power` is NaN, and the facet
// counts as proved; no finite e gives NaN unless g^10 is infinite.
template <class Number>
struct Cell_filter_in_lanes_3
{
  static constexpr double volume_factor = 1.9e-30, power_factor = 1.2e-28;
  static constexpr double smallest_square = 1e-50;

  using Points = Points_in_lanes_3<Number>;

  BOOST_FORCEINLINE Cell_filter_in_lanes_3(const Points& b, const Points& c, const Points& d)
  {
    const Points cd = cross(c, d), db = cross(d, b), bc = cross(b, c);
    const Number bb = dot(b, b), cc = dot(c, c), dd = dot(d, d);
    volume = dot(b, cd);
    sphere = {product(bb, cd.x) + product(cc, db.x) + product(dd, bc.x),
              product(bb, cd.y) + product(cc, db.y) + product(dd, bc.y),
              product(bb, cd.z) + product(cc, db.z) + product(dd, bc.z)};
    size = larger(bb, larger(cc, dd));
  }

  // What filters of other spaces are built on.
  BOOST_FORCEINLINE const Cell_filter_in_lanes_3& of_cell() const { return *this; }

  // True unless the cell is proved to be positive.
  BOOST_FORCEINLINE auto may_be_inverted() const
  {
    const Number bound = product(volume_factor, product(size, product(size, size)));
    const auto is_negative = volume <= Number(0), is_uncertain = product(volume, volume) <= bound;
    const auto is_small = size <= Number(smallest_square);
    const auto is_large = Number(std::numeric_limits<double>::infinity()) <= bound;
    return is_negative | is_uncertain | is_small | is_large;
  }

  // True unless the vertex at e is proved to be outside of the sphere, given a positive cell, or is
  // infinite.
  BOOST_FORCEINLINE auto may_be_inside(const Points& e) const
  {
    const Number ee = dot(e, e);
    const Number power = product(volume, ee) - dot(sphere, e), largest = larger(size, ee);
    const Number square = product(largest, largest);
    const Number size_of_power = product(product(square, square), largest);
    const Number bound = product(power_factor, size_of_power);
    const auto is_negative = power <= Number(0), is_uncertain = product(power, power) <= bound;
    const auto is_large = Number(std::numeric_limits<double>::infinity()) <= size_of_power;
    return is_negative | is_uncertain | is_large;
  }

  // 1 if e is proved to be inside of the sphere of a positive cell, -1 if outside, else 0. As the
  // sign of the determinant it is that of inverted cells, too.
  BOOST_FORCEINLINE int side_of_sphere(const Points& e) const
  {
    const Number ee = dot(e, e);
    const Number power = product(volume, ee) - dot(sphere, e), largest = larger(size, ee);
    const Number square = product(largest, largest);
    const Number size_of_power = product(product(square, square), largest);
    const bool is_proved = product(power, power) > product(power_factor, size_of_power) &&
                           size > smallest_square &&
                           size_of_power < std::numeric_limits<double>::infinity();
    return !is_proved ? 0 : power < 0 ? 1 : -1;
  }

  Number volume = 0.0, size = 0.0;
  Points sphere{0.0, 0.0, 0.0};
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_3::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_PASSES_CELL_FILTER_3_H

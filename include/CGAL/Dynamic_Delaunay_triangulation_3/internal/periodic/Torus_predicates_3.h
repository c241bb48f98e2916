// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_PERIODIC_TORUS_PREDICATES_3_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_PERIODIC_TORUS_PREDICATES_3_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/passes/Cell_filter_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/periodic/Torus_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/periodic/walls/Rounded_normal_3.h>
#include <CGAL/enum.h>

#include <boost/config.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace CGAL::Dynamic_Delaunay_triangulations_3::internal {

// The filter of a cell whose vectors are not exact: each is off by an error vector of a length up
// to E.
//
// volume is linear in each of three vectors of lengths up to m + E. While one of them moves by E,
// volume changes by at most (m + E)^2 E. For E below m / 1000 that is 3.01 m^2 E in all.
//
// power is linear in each of its four vectors with their lifted coordinates, and changes its sign
// if two are exchanged: its derivatives by all four have the same bounds. If e moves by d, volume
// |e|^2 - sphere e changes by 2 volume e d - sphere d in the first order, which is at most (2 g^3 g
// + 3 g^4) |d|. All vectors on the way are at most g + E long; so for E below g / 1000 the change
// is 4 * 5.03 g^4 E at most.
//
// With the bounds of Cell_filter_in_lanes_3, volume is right where |volume| > 11.4 u m^3 + 3.01 m^2
// E, which is so where volume^2 > m^4 (2 * 1.61e-30 m^2 + 18.2 E^2); and power where power^2 > g^8
// (2 * 1.08e-28 g^2 + 810 E^2). Again factors are larger by a tenth.
//
// Underflow. Where E^2 or products with it underflow, they are below 1e-308, and the other summand
// is above 1e-278 as there.
template <class Number>
class Torus_filter_in_lanes_3
{
public:
  using Points = Points_in_lanes_3<Number>;

  BOOST_FORCEINLINE Torus_filter_in_lanes_3(const Points& b, const Points& c, const Points& d,
                                            Number squared_error)
    : m_cell(b, c, d)
    , m_squared_error(squared_error)
  {
  }

  // As if positions were exact.
  BOOST_FORCEINLINE const Cell_filter_in_lanes_3<Number>& of_cell() const { return m_cell; }

  // True unless the cell is proved to be positive.
  BOOST_FORCEINLINE auto may_be_inverted() const
  {
    const Number size = m_cell.size, volume = m_cell.volume, square = product(size, size);
    const Number bound = product(square, product(Number(volume_factor), size) +
                                             product(Number(error_of_volume), m_squared_error));
    const auto is_negative = volume <= Number(0), is_uncertain = product(volume, volume) <= bound;
    const auto is_large = Number(std::numeric_limits<double>::infinity()) <= bound;
    return is_negative | is_uncertain | is_too_small() | is_large;
  }

  // True unless the vertex at e is proved to be outside of the sphere, given a cell that is proved
  // to be positive.
  BOOST_FORCEINLINE auto may_be_inside(const Points& e) const
  {
    const Power power(*this, e);
    const auto is_negative = power.value <= Number(0);
    const auto is_uncertain = product(power.value, power.value) <= power.bound;
    const auto is_large = Number(std::numeric_limits<double>::infinity()) <= power.bound;
    return is_negative | is_uncertain | is_large;
  }

  // 1 if e is proved to be inside of the sphere of a positive cell, -1 if outside, else 0. As the
  // sign of the determinant it is that of inverted cells, too.
  BOOST_FORCEINLINE int side_of_sphere(const Points& e) const
  {
    const Power power(*this, e);
    const bool is_proved = product(power.value, power.value) > power.bound && !is_too_small() &&
                           power.bound < std::numeric_limits<double>::infinity();
    return !is_proved ? 0 : power.value < 0 ? 1 : -1;
  }

  // The sign of the volume of b, c and d, if it is proved, else 0.
  BOOST_FORCEINLINE static int orientation(const Points& b, const Points& c, const Points& d,
                                           double squared_error)
  {
    const double volume = dot(b, cross(c, d));
    const double size = larger(dot(b, b), larger(dot(c, c), dot(d, d)));
    const double bound = size * size * (volume_factor * size + error_of_volume * squared_error);
    const bool is_proved = volume * volume > bound && size > smallest_square &&
                           size > most_error * squared_error &&
                           bound < std::numeric_limits<double>::infinity();
    return !is_proved ? 0 : volume < 0 ? -1 : 1;
  }

private:
  static constexpr double volume_factor = 3.8e-30, error_of_volume = 20.5;
  static constexpr double power_factor = 2.4e-28, error_of_power = 900;
  static constexpr double smallest_square = 1e-50, most_error = 1e6;

  struct Power
  {
    BOOST_FORCEINLINE Power(const Torus_filter_in_lanes_3& filter, const Points& e)
    {
      const Number ee = dot(e, e), size = larger(filter.m_cell.size, ee);
      value = product(filter.m_cell.volume, ee) - dot(filter.m_cell.sphere, e);
      const Number square = product(size, size);
      bound = product(product(square, square),
                      product(Number(power_factor), size) +
                          product(Number(error_of_power), filter.m_squared_error));
    }

    Number value = 0.0, bound = 0.0;
  };

  BOOST_FORCEINLINE auto is_too_small() const
  {
    return m_cell.size <=
           larger(Number(smallest_square), product(Number(most_error), m_squared_error));
  }

  Cell_filter_in_lanes_3<Number> m_cell;
  Number m_squared_error;
};

// The predicates of points on a torus: a filter, then exact numbers. As traits they serve for sets
// of images in open space.
//
// Ties. A lifting |x|^2 + e1 x^2 + e2 xy + e3 y^2 + e4 xz + e5 yz + e6 z^2, with infinitesimal e1
// >> e2 >> ... > 0, takes the place of |x|^2. So where the in-sphere determinant is 0, its sign is
// that of the first determinant with one of these monomials that is not 0. Translations change the
// lifting by an affine function, and no sign: so the triangulation is periodic. It is unique:
// five points that span space have one affine dependency, sum of l_i = 0, sum of l_i p_i = 0, and
// all determinants are 0 only if sum of l_i p_i p_i^T = 0. Points with positive l_i, and those with
// negative ones, as masses, have equal sums then, and equal first and second moments. One of both
// sets has at most two points, which are on a line; across this line it has no variance, nor then
// has the other set, whose points are on the line, too. But no four of the points are on a line; so
// one of the sets is a single point, both have no variance at all, and points coincide.
//
// Points at infinity. Let P be the point s n above a slab, where n is its normal, or -s n below it;
// a sign is that for all large s, so that of the coefficient of the highest power of s.
// - orientation is linear in P: with n in the place of a vector to P, it has this coefficient.
//   With both of them in a cell, it is 0.
// - In the in-sphere determinant of a, b, c, P and e, P is lifted to s^2 n^2, times the orientation
//   of a, b, c and e. If that is not 0, e is inside if it is beyond the plane of a, b and c, on the
//   side of P. If it is, no lifting of P counts, and the rest is linear in P: with n in its place,
//   it says whether e is inside of the circle of a, b and c, and of the perturbed one where there
//   are ties. Four points in a plane have one affine dependency, too, so this is unique as above.
// - P is outside of all spheres.
// A wire has one point at infinity all around it, which has no place of its own; signs of cells
// with it are those of `Wire_signs_3`. In the in-sphere determinant of a positive cell all that
// counts of P is on which side of the plane of a, b and c it is, as above. So the normal of that
// plane takes the place of n.
//
// Their filter. Only the direction of n counts; so a vector g n of the length g of the longest one
// to a finite point stands for it, off by g times the error of a rounded unit normal
// (`Rounded_normal_3`). That is below the largest error that the filter of finite points is told:
// so its bounds hold. In the in-sphere determinant of points that are coplanar the lifting of n
// gets the factor 0. Points on walls along coordinate planes are found to be coplanar by equal
// coordinates. So exact numbers are left with what no filter tells, and with walls at other angles.
class Torus_predicates_3
{
public:
  explicit Torus_predicates_3(const Torus_3& torus, const double& squared_error)
    : m_torus(torus)
    , m_squared_error(squared_error)
  {
  }

  int orientation(const Torus_point_3& p, const Torus_point_3& q, const Torus_point_3& r,
                  const Torus_point_3& s) const
  {
    if (const int sign = filtered_orientation(p.rounded, q.rounded, r.rounded, s.rounded))
      return sign;
    return orientation_in_doubt(p, q, r, s);
  }
  // The sign, if positions prove it, which may be rounded, else 0.
  int filtered_orientation(const Position_3& p, const Position_3& q, const Position_3& r,
                           const Position_3& s) const
  {
    return filtered_orientation_of(q - p, r - p, s - p, m_squared_error);
  }
  // That of three vectors which are off by an error.
  static int filtered_orientation_of(const Position_3& u, const Position_3& v, const Position_3& w,
                                     double squared_error)
  {
    return Filter::orientation(vector(u), vector(v), vector(w), squared_error);
  }
  // Where that is 0.
  int orientation_in_doubt(const Torus_point_3& p, const Torus_point_3& q, const Torus_point_3& r,
                           const Torus_point_3& s) const
  {
    const int number = number_at_infinity(p, q, r, s);
    if (number == 1)
      if (const int sign = filtered_orientation_at_infinity(p, q, r, s))
        return sign;
    if (number == 0 && m_torus.are_level(p, q, r, s))
      return 0;
    return exact_orientation(p, q, r, s);
  }
  int exact_orientation(const Torus_point_3& p, const Torus_point_3& q, const Torus_point_3& r,
                        const Torus_point_3& s) const
  {
    if (is_at_infinity(p))
      return is_at_infinity(q) ? 0 : -exact_orientation(q, p, r, s);
    return int(CGAL::sign(dot(exact_way(p, q), cross(exact_way(p, r), exact_way(p, s)))));
  }

  // 1 if t is inside of the sphere of the others, if these are positively oriented; one of them at
  // most is at infinity. 0 only if all are coplanar, or two coincide.
  int side_of_sphere(const Torus_point_3& p, const Torus_point_3& q, const Torus_point_3& r,
                     const Torus_point_3& s, const Torus_point_3& t) const
  {
    if (const int sign =
            filtered_side_of_sphere(p.rounded, q.rounded, r.rounded, s.rounded, t.rounded))
      return sign;
    return side_of_sphere_in_doubt(p, q, r, s, t);
  }
  // The sign, if positions prove it, which may be rounded, else 0.
  int filtered_side_of_sphere(const Position_3& p, const Position_3& q, const Position_3& r,
                              const Position_3& s, const Position_3& t) const
  {
    return Filter(way(p, q), way(p, r), way(p, s), m_squared_error).side_of_sphere(way(p, t));
  }
  // Where that is 0.
  int side_of_sphere_in_doubt(const Torus_point_3& p, const Torus_point_3& q,
                              const Torus_point_3& r, const Torus_point_3& s,
                              const Torus_point_3& t) const
  {
    if (is_at_infinity(t))
      return -1;
    if (is_at_infinity(p)) // an even permutation
      return side_of_sphere_in_doubt(q, r, p, s, t);
    if (number_at_infinity(p, q, r, s) == 1) {
      if (const int side = side_beyond(p, q, r, s, t))
        return side;
      if (const int side = filtered_side_of_circle(p, q, r, s, t))
        return side;
    }
    return exact_side_of_sphere(p, q, r, s, t);
  }
  int exact_side_of_sphere(const Torus_point_3& p, const Torus_point_3& q, const Torus_point_3& r,
                           const Torus_point_3& s, const Torus_point_3& t) const
  {
    if (is_at_infinity(t))
      return -1;
    if (is_at_infinity(p)) // an even permutation
      return exact_side_of_sphere(q, r, p, s, t);
    if (m_torus.dimension() < 3)
      if (const int side = side_beyond(p, q, r, s, t))
        return side;
    if (m_torus.is_wire())
      return exact_side_in_wire(p, q, r, s, t);
    return exact_side_of_sphere(exact_way(p, q), exact_way(p, r), exact_way(p, s), exact_way(p, t));
  }

  bool coincide(const Torus_point_3& p, const Torus_point_3& q) const
  {
    return m_torus.coincide(p, q);
  }

  // AS TRAITS -------------------------------------------------------------------------------------

  struct Orientation_3
  {
    const Torus_predicates_3* predicates;
    Sign operator()(const Torus_point_3& p, const Torus_point_3& q, const Torus_point_3& r,
                    const Torus_point_3& s) const
    {
      return Sign(predicates->orientation(p, q, r, s));
    }
  };
  struct Side_of_oriented_sphere_3
  {
    const Torus_predicates_3* predicates;
    Sign operator()(const Torus_point_3& p, const Torus_point_3& q, const Torus_point_3& r,
                    const Torus_point_3& s, const Torus_point_3& t) const
    {
      return Sign(predicates->side_of_sphere(p, q, r, s, t));
    }
  };
  struct Collinear_3
  {
    const Torus_predicates_3* predicates;
    bool operator()(const Torus_point_3& p, const Torus_point_3& q, const Torus_point_3& r) const
    {
      const Torus_3& torus = predicates->m_torus;
      const Exact_vector_3 v = cross(torus.exact_vector(p, q), torus.exact_vector(p, r));
      return CGAL::is_zero(v.x) && CGAL::is_zero(v.y) && CGAL::is_zero(v.z);
    }
  };
  Orientation_3 orientation_3_object() const { return {this}; }
  Side_of_oriented_sphere_3 side_of_oriented_sphere_3_object() const { return {this}; }
  Collinear_3 collinear_3_object() const { return {this}; }

private:
  using Filter = Torus_filter_in_lanes_3<double>;

  static Points_in_lanes_3<double> vector(const Position_3& v) { return {v.x, v.y, v.z}; }
  static Points_in_lanes_3<double> way(const Position_3& from, const Position_3& to)
  {
    return vector(to - from);
  }
  bool is_at_infinity(const Torus_point_3& p) const { return m_torus.end_of_space(p) != 0; }
  int number_at_infinity(const Torus_point_3& p, const Torus_point_3& q, const Torus_point_3& r,
                         const Torus_point_3& s) const
  {
    return m_torus.dimension() == 3
               ? 0
               : is_at_infinity(p) + is_at_infinity(q) + is_at_infinity(r) + is_at_infinity(s);
  }
  // Vectors from a point to three others, rounded; one of these is at infinity.
  struct Ways
  {
    Few<Position_3, 3> to;
    int infinite, end; // the number of that one, and which end of space it is

    // Those to the others, in an order that keeps the orientation.
    const Position_3& next() const { return to[(infinite + 1) % 3]; }
    const Position_3& last() const { return to[(infinite + 2) % 3]; }
  };
  Ways ways(const Torus_point_3& p, const Torus_point_3& q, const Torus_point_3& r,
            const Torus_point_3& s) const
  {
    const Few<int, 3> ends{m_torus.end_of_space(q), m_torus.end_of_space(r),
                           m_torus.end_of_space(s)};
    const int infinite = ends[0] != 0 ? 0 : ends[1] != 0 ? 1 : 2;
    return {{q.rounded - p.rounded, r.rounded - p.rounded, s.rounded - p.rounded},
            infinite,
            ends[infinite]};
  }
  // Puts a vector along a normal, of the length g, in the place of the one to infinity. Returns the
  // square of the largest error of all.
  double put_normal(Ways& ways, const Rounded_normal_3& normal, double squared_g) const
  {
    ways.to[ways.infinite] = ways.end * std::sqrt(squared_g) * normal.direction;
    return (std::max)(m_squared_error, 1.1 * squared_g * normal.error * normal.error);
  }

  // The sign for one point at infinity, if it is proved, else 0; in a wire always 0, as such a
  // point has no place there.
  int filtered_orientation_at_infinity(const Torus_point_3& p, const Torus_point_3& q,
                                       const Torus_point_3& r, const Torus_point_3& s) const
  {
    if (m_torus.is_wire())
      return 0;
    if (is_at_infinity(p))
      return -filtered_orientation_at_infinity(q, p, r, s);
    Ways w = ways(p, q, r, s);
    const double squared_g = (std::max)(squared_length(w.next()), squared_length(w.last()));
    const double squared_error = put_normal(w, m_torus.normal(), squared_g);
    return filtered_orientation_of(w.to[0], w.to[1], w.to[2], squared_error);
  }
  // 1 if t is inside of the circle of three points, -1 if it is outside, where it is in their plane
  // and one of q, r and s is at infinity; 0 if that is not proved.
  int filtered_side_of_circle(const Torus_point_3& p, const Torus_point_3& q,
                              const Torus_point_3& r, const Torus_point_3& s,
                              const Torus_point_3& t) const
  {
    Ways w = ways(p, q, r, s);
    const Position_3 e = t.rounded - p.rounded;
    const double squared_g =
        (std::max)({squared_length(w.next()), squared_length(w.last()), squared_length(e)});
    const Rounded_normal_3 normal =
        m_torus.is_wire() ? Rounded_normal_3::of(w.next(), w.last(), std::sqrt(m_squared_error))
                          : m_torus.normal();
    const double squared_error = put_normal(w, normal, squared_g);
    return Filter(vector(w.to[0]), vector(w.to[1]), vector(w.to[2]), squared_error)
        .side_of_sphere(vector(e));
  }

  // The vector from one point to another, or along the way to one at infinity.
  Exact_vector_3 exact_way(const Torus_point_3& from, const Torus_point_3& to) const
  {
    const int end = m_torus.end_of_space(to);
    if (end == 0)
      return m_torus.exact_vector(from, to);
    const Exact_vector_3& n = m_torus.exact_vector(2);
    return end > 0 ? n : Exact_vector_3{-n.x, -n.y, -n.z};
  }
  // 1 if t is beyond the plane of three points, on the side of a fourth one at infinity, -1 if it
  // is on the other side. 0 if it is in that plane, or no point is at infinity.
  int side_beyond(const Torus_point_3& p, const Torus_point_3& q, const Torus_point_3& r,
                  const Torus_point_3& s, const Torus_point_3& t) const
  {
    return is_at_infinity(q)   ? orientation(p, t, r, s)
           : is_at_infinity(r) ? orientation(p, q, t, s)
           : is_at_infinity(s) ? orientation(p, q, r, t)
                               : 0;
  }

  // As above, where t is in the plane of three points, if a fourth one is at infinity.
  int exact_side_in_wire(const Torus_point_3& p, const Torus_point_3& q, const Torus_point_3& r,
                         const Torus_point_3& s, const Torus_point_3& t) const
  {
    const auto way = [&](const Torus_point_3& to) { return m_torus.exact_vector(p, to); };
    const Exact_vector_3 e = way(t);
    if (is_at_infinity(q))
      return exact_side_of_sphere(cross(way(r), way(s)), way(r), way(s), e);
    if (is_at_infinity(r))
      return exact_side_of_sphere(way(q), cross(way(s), way(q)), way(s), e);
    if (is_at_infinity(s))
      return exact_side_of_sphere(way(q), way(r), cross(way(q), way(r)), e);
    return exact_side_of_sphere(way(q), way(r), way(s), e);
  }

  static int exact_side_of_sphere(const Exact_vector_3& b, const Exact_vector_3& c,
                                  const Exact_vector_3& d, const Exact_vector_3& e)
  {
    const Exact_vector_3 cd = cross(c, d), db = cross(d, b), bc = cross(b, c);
    const Exact_number_3 volume = dot(b, cd);
    const Exact_number_3 of_b = dot(cd, e), of_c = dot(db, e), of_d = dot(bc, e);
    const auto side = [&](const auto& lifting) {
      return -int(CGAL::sign(volume * lifting(e) - of_b * lifting(b) - of_c * lifting(c) -
                             of_d * lifting(d)));
    };
    using Vector = Exact_vector_3;
    int sign = side([](const Vector& v) { return dot(v, v); });
    if (sign == 0)
      sign = side([](const Vector& v) { return v.x * v.x; });
    if (sign == 0)
      sign = side([](const Vector& v) { return v.x * v.y; });
    if (sign == 0)
      sign = side([](const Vector& v) { return v.y * v.y; });
    if (sign == 0)
      sign = side([](const Vector& v) { return v.x * v.z; });
    if (sign == 0)
      sign = side([](const Vector& v) { return v.y * v.z; });
    if (sign == 0)
      sign = side([](const Vector& v) { return v.z * v.z; });
    return sign;
  }

  const Torus_3& m_torus;
  const double& m_squared_error;
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_3::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_PERIODIC_TORUS_PREDICATES_3_H

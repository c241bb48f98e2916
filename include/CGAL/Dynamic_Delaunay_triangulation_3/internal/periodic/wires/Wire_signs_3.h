// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_PERIODIC_WIRES_WIRE_SIGNS_3_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_PERIODIC_WIRES_WIRE_SIGNS_3_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/passes/Points_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/periodic/Torus_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/periodic/Torus_predicates_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/periodic/Torus_shift_3.h>

#include <cmath>

namespace CGAL::Dynamic_Delaunay_triangulations_3::internal {

// The signs of infinite cells of a wire, as its axis sees them: a line along its vector, inside of
// the hull. The axis goes through the state's origin; if doubles have no such point, through the
// middle of the first finite cell.
//
// An infinite cell is what lies beyond its hull facet, away from the axis: all x + s x', with x in
// the facet, s >= 0, and x' the part of x - o across the wire, for a point o of the axis. At x, the
// map of the facet and s to space turns nothing over if n * x' > 0, with the outer normal n of the
// facet. As n * x' is linear in x, the cell is positive if that holds at its three vertices. There
//   a^2 n * x' = a^2 n * (x - o) - (a * (x - o)) (n * a)
// with the vector a of the wire; where n * a = 0, as for all facets of a convex hull, this is a^2
// times the orientation of o and the facet.
//
// The filter. With edges v and w of the facet, n * x' is the determinant of v, w and x', which that
// of cells decides, for vectors that are off by an error. Let u = 2^-53, y = x - o, and E the bound
// for vectors between images, which is one for y, too. The vector a is exact. Its product with the
// inverse 1 / a^2, rounded 3 + 1 + 1 times, times y, rounded 3 times and once as y, is the height
// of y in units of |a|, up to 9.1 u |y| / |a|. One rounding more in each product with a, and one of
// the difference from y, leave x' with an error of E + 12 u |y|.
template <class State>
class Wire_signs_3
{
public:
  Wire_signs_3(const State& state, const Torus_predicates_3& predicates)
    : m_state(state)
    , m_predicates(predicates)
  {
  }

  // 1 if an infinite cell with this hull facet is positive, 0 if it is flat, else -1.
  int of(const Torus_facet_3& f) const
  {
    if (m_state.has_origin && has_images_of_one(f))
      return m_predicates.orientation(origin(), point(f[0]), point(f[1]), point(f[2]));
    if (const int sign = filtered(f))
      return sign;
    return exact(f);
  }
  // 1 if rounded positions prove that the cell is positive, -1 if that it is not, else 0.
  int filtered(const Torus_facet_3& f) const
  {
    if (!m_state.has_origin)
      return 0;
    const Position_3 p = m_state.position(f[0]);
    const Position_3 v = m_state.position(f[1]) - p, w = m_state.position(f[2]) - p;
    int positive = 0;
    for (const Torus_site_3& s : f) {
      const Rounded x = across(s);
      const int sign = m_predicates.filtered_orientation_of(v, w, x.way, x.squared_error);
      if (sign < 0)
        return -1;
      positive += sign;
    }
    return int(positive == 3);
  }
  // From the axis to a site, across the wire, with the square of a length by which that is off.
  struct Rounded
  {
    Position_3 way;
    double squared_error;
  };
  Rounded across(const Torus_site_3& s) const
  {
    const Position_3 y = m_state.position(s) - m_state.origin;
    return {y - m_state.torus.fractions(y).x * m_state.torus.vector(0),
            2.2 * m_state.squared_error + square_of_roundings * squared_length(y)};
  }
  int exact(const Torus_facet_3& f) const
  {
    const Exact_vector_3 w[] = {from_axis(f[0]), from_axis(f[1]), from_axis(f[2])};
    const Exact_vector_3 a = m_state.torus.exact_vector(0), n = normal(f);
    const Exact_number_3 along = dot(n, a);
    if (CGAL::is_zero(along))
      return int(CGAL::sign(dot(n, w[0])));
    const Exact_number_3 square = dot(a, a);
    int positive = 0, zero = 0;
    for (const Exact_vector_3& v : w) {
      const int sign = int(CGAL::sign(square * dot(n, v) - along * dot(v, a)));
      positive += sign > 0;
      zero += sign == 0;
    }
    return positive == 3 ? 1 : zero == 3 ? 0 : -1;
  }

  // The orientation of a point of the axis and three sites or points.
  template <class First, class Second, class Third>
  int orientation_from_axis(const First& p, const Second& q, const Third& r) const
  {
    if (m_state.has_origin)
      return m_predicates.orientation(origin(), point(p), point(q), point(r));
    return int(CGAL::sign(dot(from_axis(p), cross(from_axis(q), from_axis(r)))));
  }
  // A point of the axis, rounded.
  Position_3 point_of_axis() const
  {
    if (m_state.has_origin)
      return m_state.origin;
    Position_3 sum{0, 0, 0};
    for (const Torus_site_3& s : first_finite_cell())
      sum = sum + 0.25 * m_state.position(s);
    return sum;
  }

  // 1 if a site of the vertex of f[(pair + 2) % 3] is inside of the sphere of a positive infinite
  // cell, -1 if it is outside, where f[pair] and f[(pair + 1) % 3] are images of one vertex; 0 if
  // rounded positions do not tell. All four are on two lines along the wire.
  //
  // In units of |a|, let one line have the pair at the heights 0 and k, and the other one the rest
  // at s and s + m. The circle of the facet is symmetric to the height k / 2, so it meets the other
  // line at s and k - s.
  int side_beside(const Torus_facet_3& f, int pair, const Torus_site_3& other) const
  {
    const double excess = excess_beside(f, pair, other);
    return excess > 0 ? 1 : excess < 0 ? -1 : 0;
  }
  // How far all vertices may move while such a site stays outside, 0 if it is not proved to be. If
  // they move by d, s changes by 2 d / |a| at most, and k - m - 2 s by twice that.
  double slack_beside(const Torus_facet_3& f, int pair, const Torus_site_3& other) const
  {
    const double excess = excess_beside(f, pair, other);
    return excess < 0 ? 0.24 * (-excess - 1e-6) * m_state.torus.volume() : 0;
  }

private:
  // What is not 0, with the sign of `side_beside`, and at most 1e-7 off, if that is proved.
  double excess_beside(const Torus_facet_3& f, int pair, const Torus_site_3& other) const
  {
    const Torus_site_3 &low = f[pair], &high = f[(pair + 1) % 3], &opposite = f[(pair + 2) % 3];
    const int k = (high.shift - low.shift).multiples()[0];
    const int m = (other.shift - opposite.shift).multiples()[0];
    const Torus_3& torus = m_state.torus;
    const double s = torus.fractions(m_state.position(opposite) - m_state.position(low)).x;
    // points are less than 2^20 |a| from the origin, so what rounds s is below 2^-28
    const double value = k - m - 2 * s;
    if (!(std::sqrt(m_state.squared_error) < 1e-8 * torus.volume() && std::abs(value) > 1e-6 &&
          std::abs(s) < 0x1p22))
      return 0;
    return (m > 0) == (value > 0) ? std::abs(value) : -std::abs(value);
  }

  static constexpr double square_of_roundings = 4e-30; // 2 * (12 * 2^-53)^2, and a tenth more

  Torus_point_3 origin() const
  {
    const Position_3& o = m_state.origin;
    return {o.x, o.y, o.z};
  }
  Torus_point_3 point(const Torus_site_3& s) const { return m_state.image(s); }
  static const Torus_point_3& point(const Torus_point_3& p) { return p; }

  // Whether two sites are images of one vertex: then n * a = 0.
  static bool has_images_of_one(const Torus_facet_3& f)
  {
    return f[0].vertex == f[1].vertex || f[1].vertex == f[2].vertex || f[2].vertex == f[0].vertex;
  }

  Torus_sites_3 first_finite_cell() const
  {
    Cell_index c(0);
    while (m_state.arrays.is_infinite(c))
      ++c;
    return m_state.arrays.sites(c);
  }

  // From the axis to a point, times some positive number.
  template <class Site>
  Exact_vector_3 from_axis(const Site& s) const
  {
    const Torus_point_3 p = point(s);
    if (m_state.has_origin)
      return m_state.torus.exact_vector(origin(), p);
    Exact_vector_3 sum{Exact_number_3(0), Exact_number_3(0), Exact_number_3(0)};
    for (const Torus_site_3& t : first_finite_cell()) {
      const Exact_vector_3 v = m_state.torus.exact_vector(point(t), p);
      sum = {sum.x + v.x, sum.y + v.y, sum.z + v.z};
    }
    return sum;
  }
  Exact_vector_3 normal(const Torus_facet_3& f) const
  {
    const Torus_point_3 p = point(f[0]);
    return cross(m_state.torus.exact_vector(p, point(f[1])),
                 m_state.torus.exact_vector(p, point(f[2])));
  }

  const State& m_state;
  const Torus_predicates_3 m_predicates;
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_3::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_PERIODIC_WIRES_WIRE_SIGNS_3_H

// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_QUERIES_ROUNDED_FACE_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_QUERIES_ROUNDED_FACE_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Flat_arrays.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/cells/Voronoi_face_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Flat_elements_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Points_2.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

// A Delaunay face in doubles, with bounds on their errors.
//
// Let u = 2^-53, and let r |v| bound the error of a vector v, where r is u, plus 1.5e / |v| if
// coordinates are off by up to e > 0. Let k = 2r + 2u. Then the dot and the cross product of v
// and w are off by at most k |v| |w|, to the first order. So the doubled area of a face is off by
// the share k / sin(a), where a is its largest angle, as it is the product of the two shorter
// sides. Let c be the cotangent of the angle opposite to a side of the length l. Then
// 1 / sin <= 1 + |c|, and
//   - c is off by k / sin + |c| (k / sin(a) + 2u): by the dot product of the other sides, by the
//     area, by a division and a product;
//   - c l^2 is off by l^2 (k / sin + |c| (k + k / sin(a) + 4u)), by l^2 and two more roundings. As
//     4u <= k, that is at most k l^2 (1 + |c|) (4 + |c_a|);
//   - the squared radius l^2 (1 + c^2) / 4, with the longest side, is off by the share
//     k + 2 |c| (k (1 + |c|)^2 + 2u |c|) / (1 + c^2) + 3u <= k (3 + 5 |c|).
// Higher orders are less than a tenth of that where the share of the area is below 2^-10. Nothing
// is known where squares could underflow, or something overflows: then the bounds are infinite or
// NaN.
class Rounded_face_2
{
public:
  // \pre The corners are counterclockwise.
  template <class Geometry, class A, class B, class C>
  Rounded_face_2(const Geometry& geometry, const A& a, const B& b, const C& c)
    : m_off(0)
    , m_face{std::array<Position_2, 3>{geometry.vector(b, c, m_off), geometry.vector(c, a, m_off),
                                       geometry.vector(a, b, m_off)},
             m_off} // braces, because m_off must be read after the vectors
  {
    const double inverse = 1 / m_face.doubled_area(); // three divisions would take longer
    for (std::size_t i = 0; i < 3; ++i)
      m_cotangents[i] = -dot(m_face.side((i + 1) % 3), m_face.side((i + 2) % 3)) * inverse;
    std::size_t shortest = 0;
    for (std::size_t i = 1; i < 3; ++i) {
      m_longest = squared_length(i) > squared_length(m_longest) ? i : m_longest;
      shortest = squared_length(i) < squared_length(shortest) ? i : shortest;
    }
    const double r = unit + (m_off > 0 ? 1.5 * m_off / m_face.length(shortest) : 0);
    const double k = 2 * r + 2 * unit, blunt = std::abs(m_cotangents[m_longest]);
    const bool is_known = (squared_length(shortest) > 1e-280) & (k * (1 + blunt) < 0x1p-10);
    m_unit = is_known ? k : std::numeric_limits<double>::infinity();
  }

  double squared_length(std::size_t i) const { return m_face.squared_length(i); }
  double cotangent(std::size_t i) const { return m_cotangents[i]; }
  double squared_radius() const
  {
    const double c = m_cotangents[m_longest];
    return squared_length(m_longest) * (1 + c * c) / 4;
  }

  // Bounds, in the first order.
  double error_of_owned(std::size_t i) const
  {
    return m_unit * squared_length(i) * (1 + std::abs(m_cotangents[i])) *
           (4 + std::abs(m_cotangents[m_longest]));
  }
  double error_of_squared_radius() const
  {
    return m_unit * squared_radius() * (3 + 5 * std::abs(m_cotangents[m_longest]));
  }

private:
  static constexpr double unit = 0x1p-53;

  double m_off; // how far coordinates are off at most, besides rounding
  const Voronoi_face_2 m_face;
  std::array<double, 3> m_cotangents;
  std::size_t m_longest = 0;
  double m_unit; // k
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_QUERIES_ROUNDED_FACE_2_H

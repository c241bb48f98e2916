// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_PASSES_CELL_SLACK_3_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_PASSES_CELL_SLACK_3_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/passes/Cell_filter_3.h>

#include <boost/config.hpp>

namespace CGAL::Dynamic_Delaunay_triangulations_3::internal {

using Dynamic_Delaunay_triangulations_2::internal::magnitude;
using Dynamic_Delaunay_triangulations_2::internal::root;
using Dynamic_Delaunay_triangulations_2::internal::smaller;

// The slack of a cell: how far its vertices and those beyond its facets may all move, each in any
// direction, while the cell stays positive and its facets legal. To be asked of cells that
// `Cell_filter_in_lanes_3` has proved, with whose words this goes on.
//
// Let all points move at once, straight and at constant speed, by d at most, let o be any fixed
// point, and l the distances of the points from o. As polynomials of the vectors from o, volume is
// a sum of four determinants det(x, y, z), and power one of 20 terms |w|^2 det(x, y, z). A product
// of factors up to l_i that grow by d changes by at most d^2 times the second elementary
// derivative, taken at l_i + d, beyond the first order. So, with the mean m of the lengths l + d:
//
//     volume   4 (3 m) d^2 = 12 m d^2
//     power    (3 e1 e2 + 5 e3) d^2 <= 200 m^3 d^2
//
// where e1, e2 and e3 are the elementary symmetric polynomials of the five lengths, and Maclaurin's
// inequalities give the bound. No slack is larger than a fortieth of the mean length of the cell's
// vertices: that adds less than a tenth to m^3.
//
// The first order. The gradients of volume are the cross products of edges, which are twice the
// areas of the facets: their sum is `areas`. Let z be the center and R the radius of the sphere,
// and w_i what volume becomes where e takes the place of a vertex. With z as origin, and R^2 taken
// from all squares, the gradient of power is 2 volume (e - z) at e, and at a vertex p_i the sum of
// -2 w_i (p_i - z) and power / volume times the gradient of volume. So it is at most
//
//     |2 volume e - sphere| + 2 R (|w_a| + |w_b| + |w_c| + |w_d|) + power / volume * areas
//
// with 2 R = |sphere| / volume, times d. Then a d with slope d + curvature d^2 <= value is a slack.
//
// Rounding. Let s be the largest of |b|, |c| and |d|. Volume has to stay above 2^-20 s^3, of which
// its error is 2^-29; |sphere| is at least volume s, since R is at least s / 2, and so at least
// 2^-20 s^4, of which its error is 2^-27. The w_i are off by 70 u s^2 g in all, which is multiplied
// by 2 R <= 3 sqrt(2) 2^20 s: less than 2^-24 g^4. The other terms are off by less, relative to g^4
// or to themselves, where power is taken with its error added. A ten thousandth and 2^-20 g^4 are
// added. The value of power has to stay above three times its error, so that later passes prove
// the cell as well, whether it is skipped or not.
template <class Number>
class Cell_slack_in_lanes_3
{
  using Points = Points_in_lanes_3<Number>;

public:
  // `error`: by how much rounded vectors between points may be off.
  BOOST_FORCEINLINE Cell_slack_in_lanes_3(const Points& b, const Points& c, const Points& d,
                                          const Cell_filter_in_lanes_3<Number>& filter,
                                          Number error)
    : m_filter(filter)
    , m_error(error)
    , m_cd(cross(c, d))
    , m_db(cross(d, b))
    , m_bc(cross(b, c))
    , m_middle{product(0.25, b.x + c.x + d.x), product(0.25, b.y + c.y + d.y),
               product(0.25, b.z + c.z + d.z)}
    , m_size(root(filter.size))
    , m_per_volume(Number(1.0) / filter.volume)
    , m_diameter(product(length(filter.sphere), m_per_volume))
  {
    // sums of four lengths are at most twice the root of the sum of their squares
    const Points all{m_cd.x + m_db.x + m_bc.x, m_cd.y + m_db.y + m_bc.y, m_cd.z + m_db.z + m_bc.z};
    m_areas = twice_root(dot(m_cd, m_cd), dot(m_db, m_db), dot(m_bc, m_bc), dot(all, all));
    m_lengths = twice_root(dot(m_middle, m_middle), square_from_middle(b), square_from_middle(c),
                           square_from_middle(d));
    const Number least = product(filter.size, product(0x1p-20, m_size) + product(8.0, m_error));
    m_slack =
        smaller(product(1.0 / 160, m_lengths),
                way(filter.volume - least, product(1.0001, m_areas), product(3.25, m_lengths)));
  }

  // Takes the vertex beyond a facet into account, or none if its coordinates are NaN.
  BOOST_FORCEINLINE void restrict_by(const Points& e)
  {
    const Points& sphere = m_filter.sphere;
    const Number volume = m_filter.volume, ee = dot(e, e), square = larger(m_filter.size, ee);
    const Number power = product(volume, ee) - dot(sphere, e), fourth = product(square, square);
    const Number from_middle = root(square_from_middle(e)), longest = m_lengths + from_middle;
    const Number error = product(fourth, product(5e-14, longest) + product(64.0, m_error));
    const Number of_b = dot(m_cd, e), of_c = dot(m_db, e), of_d = dot(m_bc, e);
    const Number of_a = volume - of_b - of_c - of_d;
    const Number weights = magnitude(of_a) + magnitude(of_b) + magnitude(of_c) + magnitude(of_d);
    const Number twice = product(2.0, volume);
    const Points at_e{product(twice, e.x) - sphere.x, product(twice, e.y) - sphere.y,
                      product(twice, e.z) - sphere.z};
    const Number slope = length(at_e) + product(m_diameter, weights) +
                         product(product(power + error, m_per_volume), m_areas);
    const Number mean = product(0.2, m_lengths + from_middle);
    m_slack = smaller(m_slack, way(power - error, product(1.0001, slope) + product(0x1p-20, fourth),
                                   product(220.0, product(mean, product(mean, mean)))));
  }

  // Not positive if there is none.
  BOOST_FORCEINLINE Number slack() const { return product(0.9999, m_slack) - m_error; }

private:
  BOOST_FORCEINLINE static Number length(const Points& v) { return root(dot(v, v)); }
  BOOST_FORCEINLINE static Number twice_root(Number a, Number b, Number c, Number d)
  {
    return product(2.0, root((a + b) + (c + d)));
  }
  BOOST_FORCEINLINE Number square_from_middle(const Points& p) const
  {
    const Points v = p - m_middle;
    return dot(v, v);
  }
  // A way d with slope d + curvature d^2 <= value, or 0: d <= value / slope, so that the second
  // term is at most curvature d value / slope.
  BOOST_FORCEINLINE static Number way(Number value, Number slope, Number curvature)
  {
    const Number room = larger(value, Number(0.0));
    return product(room, slope) / (product(slope, slope) + product(curvature, room));
  }

  const Cell_filter_in_lanes_3<Number>& m_filter;
  Number m_error;
  Points m_cd, m_db, m_bc, m_middle;
  Number m_size, m_per_volume, m_diameter;
  Number m_areas = 0.0, m_lengths = 0.0, m_slack = 0.0;
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_3::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_PASSES_CELL_SLACK_3_H

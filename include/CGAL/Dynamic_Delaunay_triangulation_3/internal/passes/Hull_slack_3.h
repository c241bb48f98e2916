// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_PASSES_HULL_SLACK_3_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_PASSES_HULL_SLACK_3_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/passes/Cell_filter_3.h>

#include <limits>

namespace CGAL::Dynamic_Delaunay_triangulations_3::internal {

using Dynamic_Delaunay_triangulations_2::internal::magnitude;
using Dynamic_Delaunay_triangulations_2::internal::root;
using Dynamic_Delaunay_triangulations_2::internal::smaller;

// The slack of an infinite cell: how far the vertices of its hull facet and those beyond the edges
// of that may all move, each in any direction, while the cell stays positive and the facets between
// it and other infinite cells legal. Where there is one, the cell is proved to be so.
//
// The facet has the points p, p + v and p + w, counterclockwise as seen from outside; so v x w is
// an outer normal. Vectors are off by E at most before they are rounded. Let all points move by d
// at most, so that vectors between them change by up to 2d, let u = 2^-53, and g be the longest of
// the vectors of a case. Nothing is proved unless 1000 E < g and 1e-25 < g < 1e50: so nothing
// underflows or overflows, and lengths are off by a thousandth at most, relative to g.
//
// A volume det(v, w, x) > 0 says that the facet is seen from a point beneath (x leads from that to
// p), or that a vertex at p - x is beneath the plane of the facet. It changes by at most
//     2d (|v x w| + |w x x| + |x x v|) + 4 d^2 (|v| + |w| + |x|) + 8 d^3,
// where the last summand is below an eighth of d^2 times the sum of lengths if d is a 64th of that
// at most. It is off by 11.4 u g^3 + 3.01 g^2 E, as in `Cell_filter_3.h`, and the three cross
// products together by 3 (5.7 u g^2 + 2.01 g E).
//
// An area n (v x w) > 0, with a unit vector n, says that the facet is seen along n. Seen so, its
// gradients by the three points are the lengths of the sides, and what lies beyond is the doubled
// area of a triangle in a circle of the radius d, below 2.6 d^2. It is off by 5.7 u g^2 + 2.001 g E
// + h g^2 + 4 u g^2, where h is the error of n.
//
// A circle: four points in a plane across a coordinate axis, which have this coordinate exactly in
// common and keep that. With a = v x w in this plane, in an orientation in which it is positive,
//     power   a |e|^2 - sphere e,   sphere = |v|^2 w' - |w|^2 v',   (x, y)' = (y, -x),
// is positive if p + e is outside of the circle. As in `Cell_slack_3.h`, its gradient is 2 a e -
// sphere at e, and at the points of the facet at most 2 R |a_i| and power / a times a side, where R
// is the radius, 2 R = |sphere| / a, and a_i what a becomes where e takes the point's place. As a
// polynomial of vectors from a fixed point, power has 12 terms |q|^2 det(r, s). Beyond the first
// order they change by at most d^2 times the second elementary derivatives, whose sum is 3 e1^2 + 4
// e2 for the elementary symmetric polynomials of the lengths l + d; with the mean m of these it is
// below 72 m^2, and below 76 m^2 with m at d = 0 if d is a fortieth of that at most.
//   Rounding, with s = max(|v|, |w|) and E < 2^-25 s. The error of a is below 4 u s^2 + 2.1 s E,
// that of sphere below 14 u s^3 + 6.1 s^2 E. With a > 2^-20 s^2 + 2^16 s E, and so |sphere| = 2 R a
// > s a, both are relative errors below 2^-13. The a_i together are off by less than 64 u g^2 + 20
// g E; 2 a e - sphere by less than 20 u g^3 + 13 g^2 E < 2^-20 g^3; power by 32 u g^4 + 12.1 g^3 E,
// as it is linear in each of v, w and e with its square, and its derivatives by these are below 4
// g^3.
//
// Factors below are larger than these, for what is relative.
class Hull_slack_3
{
public:
  using Vector = Points_in_lanes_3<double>;

  // Without a way it is only proved that the cell is right, which takes half of the time.
  Hull_slack_3(const Vector& v, const Vector& w, double error, bool has_way = true)
    : m_has_way(has_way)
    , m_v(v)
    , m_w(w)
    , m_normal(cross(v, w))
    , m_error(error)
    , m_length_of_v(length(v))
    , m_length_of_w(length(w))
    , m_around(m_length_of_v + m_length_of_w + length(w - v))
  {
  }

  // det(v, w, x) has to stay positive, where x may be off by a larger error.
  void restrict_by_volume(const Vector& x, double error)
  {
    const double of_x = length(x), g = larger(of_x, longest());
    const double value =
        dot(m_normal, x) - product(product(g, g), product(0x1p-49, g) + product(3.1, error));
    if (!can_tell(g, error) || !(value > 0)) // also NaN, as of an image that is too far
      return refuse();
    if (!m_has_way)
      return;
    const double all = m_length_of_v + m_length_of_w + of_x;
    const double areas = length(m_normal) + length(cross(m_w, x)) + length(cross(x, m_v));
    restrict_by(product(1.0 / 64, all));
    restrict_by(way(value,
                    product(2.01, areas + product(g, product(0x1p-48, g) + product(7.0, error))),
                    product(4.2, all)));
  }

  // n (v x w) has to stay positive, for a unit vector that is off by an error.
  void restrict_by_area(const Vector& n, double error_of_n)
  {
    const double g = longest();
    if (!can_tell(g, m_error))
      return refuse();
    const double error = product(g, product(0x1p-48 + error_of_n, g) + product(2.1, m_error));
    const double value = dot(n, m_normal) - error;
    if (!(value > 0))
      return refuse();
    restrict_by(way(value, product(1.01, m_around), 3.0));
  }

  // p + e has to stay outside of the circle of the facet, in a plane across an axis.
  void restrict_by_circle(const Vector& e, int axis)
  {
    const bool is_mirrored = in_plane(m_normal, axis).across < 0;
    const Flat v = in_plane(is_mirrored ? m_w : m_v, axis);
    const Flat w = in_plane(is_mirrored ? m_v : m_w, axis), f = in_plane(e, axis);
    const double s = longest(), of_e = length(e), g = larger(of_e, s);
    const double area = determinant(v, w);
    const double least = product(s, product(0x1p-20, s) + product(0x1p16, m_error));
    if (!can_tell(g, m_error) || !(m_error < product(0x1p-25, s)) || !(area > least))
      return refuse();
    const double vv = square(v), ww = square(w), ee = square(f);
    const Flat sphere{product(vv, w.y) - product(ww, v.y), product(ww, v.x) - product(vv, w.x), 0};
    const double power = product(area, ee) - (product(sphere.x, f.x) + product(sphere.y, f.y));
    const double third = product(g, product(g, g));
    const double error = product(third, product(0x1p-47, g) + product(13.0, m_error));
    if (!(power - error > 0))
      return refuse();
    if (!m_has_way)
      return;
    const double of_v = determinant(f, w), of_w = determinant(v, f);
    const double weights = magnitude(area - of_v - of_w) + magnitude(of_v) + magnitude(of_w) +
                           product(g, product(0x1p-46, g) + product(20.0, m_error));
    const double twice = product(2.0, area);
    const Flat at_e{product(twice, f.x) - sphere.x, product(twice, f.y) - sphere.y, 0};
    const double slope = root(square(at_e)) + product(root(square(sphere)) / area, weights) +
                         product((power + error) / area, m_around);
    const double mean = product(0.25, m_length_of_v + m_length_of_w + of_e);
    restrict_by(product(1.0 / 40, mean));
    restrict_by(way(power - error, product(1.001, slope) + product(0x1p-20, third),
                    product(76.0, product(mean, mean))));
  }

  // Points may not move farther than that.
  void restrict_by(double way) { m_slack = smaller(way, m_slack); }
  void refuse() { m_slack = 0; }

  // 0 if nothing is proved; without a way any number if all is.
  double slack() const { return product(0.999, m_slack); }

private:
  // What a plane across an axis has of a vector, and the rest.
  struct Flat
  {
    double x, y, across;
  };
  static Flat in_plane(const Vector& v, int axis)
  {
    return axis == 0 ? Flat{v.y, v.z, v.x} : axis == 1 ? Flat{v.z, v.x, v.y} : Flat{v.x, v.y, v.z};
  }
  static double square(const Flat& v) { return product(v.x, v.x) + product(v.y, v.y); }
  static double determinant(const Flat& v, const Flat& w)
  {
    return product(v.x, w.y) - product(v.y, w.x);
  }

  static double length(const Vector& v) { return root(dot(v, v)); }
  double longest() const { return larger(m_length_of_v, m_length_of_w); }
  static bool can_tell(double g, double error)
  {
    return g > 1e-25 && g < 1e50 && product(1000.0, error) < g;
  }
  // A way d with slope d + curvature d^2 <= value (see `Cell_slack_3.h`).
  static double way(double value, double slope, double curvature)
  {
    return product(value, slope) / (product(slope, slope) + product(curvature, value));
  }

  bool m_has_way;
  Vector m_v, m_w, m_normal;
  double m_error;
  double m_length_of_v, m_length_of_w, m_around;
  double m_slack = std::numeric_limits<double>::infinity();
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_3::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_PASSES_HULL_SLACK_3_H

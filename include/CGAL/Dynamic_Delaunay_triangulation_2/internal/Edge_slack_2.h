// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_EDGE_SLACK_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_EDGE_SLACK_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Displacements_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Edge_filter_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Neighborhood_mirror_2.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace CGAL {
namespace Dynamic_Delaunay_triangulations_2 {
namespace internal {

// How far the four vertices of an edge may go, each in any direction, before the edge can stop
// being Delaunay.
//
// Between two finite faces (de Castro and Devillers, 2008). Let o be any point, r the larger
// distance of b and c from it, and R the smaller one of a and d. While none of the four moves by
// more than (R - r) / 2, the circle around o with radius (R + r) / 2 has b and c strictly inside,
// a and d strictly outside. It can be shrunk, inside itself, to one through b and c, which holds
// neither a nor d: if both faces are counterclockwise, the edge is Delaunay, and no tie. That holds
// for any o, so o may be computed as roughly as one likes; the best one makes |ob| = |oc| and
// |oa| = |od|. Each computed distance is within 3.5u of the true one, relatively (a difference u,
// its square 3u, the sum 4u, of which the root takes half; and u of its own), u = 2^-53; with the
// roundings of the comparison itself 16u (R + r) is more than enough.
//
// At the hull: the orientation determinant D = (p - q) x (w - q) changes by at most
// 2t (|p - q| + |w - q|) + 4t^2 if each of the three moves by at most t; the same holds for the
// scalar product. Lengths are bounded by sums of absolute values; the error of D itself is that of
// Edge_filter_2, and the hundredth of a percent covers the roundings of the bound.
class Edge_slack_2
{
public:
  // Squares of smaller ones underflow.
  static constexpr double smallest_tolerance = 1e-100;

  template <class Positions>
  Edge_slack_2(const Edge_2& edge, const Positions& positions)
  {
    const auto at = [&](Index v) -> const Position_2& { return positions[v]; };
    if (edge.left == infinite_index)
      measure_turn(at(edge.right), at(edge.target), at(edge.source));
    else if (edge.right == infinite_index)
      measure_turn(at(edge.left), at(edge.source), at(edge.target));
    else if (edge.source == infinite_index)
      measure_corner(at(edge.left), at(edge.target), at(edge.right));
    else if (edge.target == infinite_index)
      measure_corner(at(edge.right), at(edge.source), at(edge.left));
    else
      measure_annulus(at(edge.left), at(edge.source), at(edge.target), at(edge.right));
  }

  // Of an edge between finite faces, as it was computed.
  double value() const { return (m_outer - m_inner) / 2; }

  // Whether the edge is proved Delaunay as long as none of its vertices moves by more than `t`, and
  // each face at it that lies between three edges of which this can be said is counterclockwise.
  // Not if that is not so to begin with.
  bool is_safe(double t) const
  {
    if (m_is_at_hull)
      return m_determinant > bound(t);
    return m_is_counterclockwise && m_outer - m_inner > 2 * t + 16 * 0x1p-53 * (m_outer + m_inner);
  }

  // A tolerance with which the edge is safe, the largest one but for rounding; negative if there is
  // none. However it is computed, is_safe() has the last word.
  double tolerance() const
  {
    const double t = (1 - 1e-12) * (m_is_at_hull ? root_of_bound() : slack_less_rounding());
    return t > smallest_tolerance && is_safe(t) ? t : -1;
  }

  // False only if the edge goes from a corner of the hull to infinity, and the hull could turn back
  // on itself there.
  bool keeps_turning_angle(double t) const
  {
    return !m_is_corner || m_determinant > bound(t) || m_product > bound(t);
  }

private:
  void measure_annulus(const Position_2& a, const Position_2& b, const Position_2& c,
                       const Position_2& d)
  {
    m_is_counterclockwise = Edge_filter_2(a, b, c, d).proves_counterclockwise();
    const Position_2 o = center(a, b, c, d);
    m_outer = (std::min)(distance(o, a), distance(o, d));
    m_inner = (std::max)(distance(o, b), distance(o, c));
  }

  // Where the bisectors of bc and of ad meet.
  static Position_2 center(const Position_2& a, const Position_2& b, const Position_2& c,
                           const Position_2& d)
  {
    const double ax = a.x - d.x, ay = a.y - d.y;
    const double bx = b.x - d.x, by = b.y - d.y;
    const double ux = c.x - b.x, uy = c.y - b.y;
    const double bc = ux * (bx + ux / 2) + uy * (by + uy / 2);
    const double ad = -(ax * ax + ay * ay) / 2;
    const double determinant = ay * ux - ax * uy;
    return {d.x + (bc * ay + ad * uy) / determinant, d.y - (bc * ax + ad * ux) / determinant};
  }

  void measure_turn(const Position_2& p, const Position_2& q, const Position_2& w)
  {
    const double px = p.x - q.x, py = p.y - q.y;
    const double wx = w.x - q.x, wy = w.y - q.y;
    m_is_at_hull = true;
    m_determinant = wx * py - px * wy;
    m_product = -(px * wx + py * wy);
    m_lengths = std::abs(px) + std::abs(py) + std::abs(wx) + std::abs(wy);
    m_squares = px * px + py * py + wx * wx + wy * wy;
  }

  // The hull comes from p to q and goes on to w.
  void measure_corner(const Position_2& p, const Position_2& q, const Position_2& w)
  {
    measure_turn(p, q, w);
    m_is_corner = true;
  }

  double slack_less_rounding() const { return value() - 8 * 0x1p-53 * (m_outer + m_inner); }

  // Where bound() reaches the determinant.
  double root_of_bound() const
  {
    const double room = (m_determinant - Edge_filter_2::orientation_factor * m_squares) / 1.0001;
    return room / (m_lengths + std::sqrt(m_lengths * m_lengths + 4 * room));
  }

  double bound(double t) const
  {
    return Edge_filter_2::orientation_factor * m_squares + 1.0001 * (2 * t * m_lengths + 4 * t * t);
  }

  bool m_is_at_hull = false;
  bool m_is_corner = false;
  bool m_is_counterclockwise = false;
  double m_outer = 0, m_inner = 0;
  double m_determinant = 0, m_product = 0, m_lengths = 0, m_squares = 0;
};

} // namespace internal
} // namespace Dynamic_Delaunay_triangulations_2
} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_EDGE_SLACK_2_H

// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_PROOF_EDGE_SLACK_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_PROOF_EDGE_SLACK_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Flat_arrays.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Edge_filter_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Edge_kinds_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Flat_elements_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Lanes_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Points_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/topology/Halfedge_arrays_2.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

// A computed squared distance up to this bound proves that the distance is at most `tolerance`. The
// computed square has a relative error of at most 4u, u = 2^-53. If the square of the tolerance
// overflows, it is larger than all doubles, and only an infinite distance proves nothing. The
// tolerance must be at least 1e-150: squares of smaller ones underflow.
inline double squared_bound(double tolerance)
{
  return (std::min)(tolerance * tolerance, (std::numeric_limits<double>::max)()) *
         (1 - 16 * 0x1p-53);
}

inline bool is_within(double tolerance, const Position_2& p, const Position_2& q)
{
  return squared_distance(p, q) <= squared_bound(tolerance);
}

#ifdef CGAL_DYNAMIC_DELAUNAY_HAS_LANES

// Whether all squared distances between `number` points and their references are within `bound`.
template <int lanes, int number>
BOOST_FORCEINLINE bool are_within(const Position_2* points, const Position_2* references,
                                  double bound)
{
  constexpr int half = lanes / 2; // the number of points whose coordinates fill the lanes
  const auto steps = [&](int i) CGAL_DYNAMIC_DELAUNAY_INLINE {
    return coordinates_at<lanes>(points + i) - coordinates_at<lanes>(references + i);
  };
  const auto are_near = [&](int i) CGAL_DYNAMIC_DELAUNAY_INLINE {
    const auto [x, y] = taken_apart(steps(i), steps(i + half));
    return product(x, x) + product(y, y) <= Lanes<lanes>(bound);
  };
  auto are_all_near = are_near(0);
  for (int i = lanes; i < number; i += lanes)
    are_all_near = are_all_near & are_near(i);
  return bits(are_all_near) == all_bits<lanes>;
}

#endif

// Appends those of the vertices [first, beyond) whose squared distances to their references exceed
// `bound`. Several lanes test blocks of vertices first, because in most blocks none does.
template <int lanes>
BOOST_FORCEINLINE void
append_moved_in_lanes(const Position_2* positions, const Position_2* references, Vertex_index first,
                      Index beyond, double bound, std::vector<Vertex_index>& moved)
{
#ifdef CGAL_DYNAMIC_DELAUNAY_HAS_LANES
  if constexpr (lanes > 1) {
    constexpr Index block = 16;
    for (; first + block <= beyond; first += block)
      if (!are_within<lanes, block>(positions + first, references + first, bound))
        append_moved_in_lanes<1>(positions, references, first, first + block, bound, moved);
  }
#endif
  for (; first < beyond; ++first)
    if (!(squared_distance(positions[first], references[first]) <= bound))
      moved.push_back(first);
}

// Appends all finite vertices that are not proved to be within `tolerance` of their references.
// Returns false, and may leave vertices out, if they are more than `most`.
inline bool append_moved(const Position_vector& positions, const Position_vector& references,
                         double tolerance, std::size_t most, std::vector<Vertex_index>& moved)
{
  const double bound = squared_bound(tolerance);
  const Index vertices = Index(positions.size());
  constexpr Index part = 1 << 10; // small parts, to detect motion everywhere early
  for (Vertex_index first(1); first < vertices && moved.size() <= most; first += part) {
    const Index beyond = vertices - first < part ? vertices : Index(first) + part;
    call_with_lanes([&](auto lanes) CGAL_DYNAMIC_DELAUNAY_INLINE {
      append_moved_in_lanes<lanes>(positions.data(), references.data(), first, beyond, bound,
                                   moved);
    });
  }
  return moved.size() <= most;
}

// How far each of the four vertices of an edge may move, in any direction, before the edge can stop
// being Delaunay.
//
// Between two finite faces (de Castro and Devillers, 2008). Let o be any point, r the larger
// distance of b and c from o, and R the smaller distance of a and d. While none of the four moves
// by more than (R - r) / 2, the circle around o with radius (R + r) / 2 has b and c strictly
// inside, a and d strictly outside. It contains a circle through b and c, which contains neither a
// nor d. So if both faces are counterclockwise, the edge is strictly Delaunay. This holds for any
// o, so o may be computed roughly. The best o has |ob| = |oc| and |oa| = |od|. The relative error
// of a computed distance is at most 3.5u, u = 2^-53: u for a difference, 3u for its square, 4u for
// the sum, half of that for the root, and u for the rounding of the root. With the roundings of the
// comparison, 16u (R + r) is more than enough.
//
// At the hull. If p, q and w move by at most t each, the orientation determinant
// D = (p - q) x (w - q) changes by at most
//     2t (|p - q| + |w - q|) + 4t^2,
// and so does the scalar product. Lengths are bounded by sums of absolute values. The error of D is
// at most 4u |p - q||w - q| (Edge_filter_2), so at most 2u (|p - q|^2 + |w - q|^2). The factor
// 1.0001 covers the bound's roundings.
class Edge_slack_2
{
public:
  // Squares of smaller tolerances underflow.
  static constexpr double smallest_tolerance = 1e-100;

  // `corners` are the corners of `edge`.
  Edge_slack_2(const Edge_2& edge, const Edge_corners_2& corners)
  {
    const auto& [a, b, c, d] = corners;
    if (edge.left == infinite_index)
      measure_turn(d, c, b);
    else if (edge.right == infinite_index)
      measure_turn(a, b, c);
    else if (edge.source == infinite_index)
      measure_corner(a, c, d);
    else if (edge.target == infinite_index)
      measure_corner(d, b, a);
    else
      measure_annulus(corners);
  }

  // For an edge between two finite faces.
  explicit Edge_slack_2(const Edge_corners_2& corners) { measure_annulus(corners); }

  // The computed slack of an edge between finite faces, without allowance for rounding.
  double value() const { return (m_outer - m_inner) / 2; }

  // Whether the edge is proved Delaunay while none of its vertices moves by more than `t`. A face
  // stays counterclockwise if this holds for all of its three edges. False if the edge is not
  // Delaunay, or a face at it not counterclockwise, before any vertex moves.
  bool is_safe(double t) const
  {
    if (m_is_at_hull)
      return m_determinant > bound(t);
    return m_is_counterclockwise &&
           m_outer - m_inner > 2 * t + product(16 * 0x1p-53, m_outer + m_inner);
  }

  // A tolerance with which the edge is safe, the largest one except for rounding; negative if there
  // is none. The result is checked by is_safe(), however roughly it was computed.
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
  void measure_annulus(const Edge_corners_2& corners)
  {
    const auto& [a, b, c, d] = corners;
    m_is_counterclockwise = Edge_filter_2(corners).proves_counterclockwise();
    const Position_2 o = center(a, b, c, d);
    m_outer = (std::min)(distance(o, a), distance(o, d));
    m_inner = (std::max)(distance(o, b), distance(o, c));
  }

  // The intersection of the bisectors of bc and ad.
  static Position_2 center(const Position_2& a, const Position_2& b, const Position_2& c,
                           const Position_2& d)
  {
    const Position_2 ad = a - d, bd = b - d, bc = c - b;
    const double along_bc = product(bc.x, bd.x + bc.x / 2) + product(bc.y, bd.y + bc.y / 2);
    const double along_ad = -dot(ad, ad) / 2, determinant = -cross(ad, bc);
    return {d.x + (product(along_bc, ad.y) + product(along_ad, bc.y)) / determinant,
            d.y - (product(along_bc, ad.x) + product(along_ad, bc.x)) / determinant};
  }

  void measure_turn(const Position_2& p, const Position_2& q, const Position_2& w)
  {
    const Position_2 to_p = p - q, to_w = w - q;
    m_is_at_hull = true;
    m_determinant = cross(to_w, to_p);
    m_product = -dot(to_p, to_w);
    m_lengths = std::abs(to_p.x) + std::abs(to_p.y) + std::abs(to_w.x) + std::abs(to_w.y);
    m_squares = dot(to_p, to_p) + dot(to_w, to_w);
  }

  // The hull goes from p through q to w.
  void measure_corner(const Position_2& p, const Position_2& q, const Position_2& w)
  {
    measure_turn(p, q, w);
    m_is_corner = true;
  }

  double slack_less_rounding() const { return value() - product(8 * 0x1p-53, m_outer + m_inner); }

  // The t for which bound(t) equals the determinant.
  double root_of_bound() const
  {
    const double room = (m_determinant - rounding_bound()) / 1.0001;
    return room / (m_lengths + std::sqrt(product(m_lengths, m_lengths) + 4 * room));
  }

  double bound(double t) const
  {
    return rounding_bound() + product(1.0001, product(2 * t, m_lengths) + product(4 * t, t));
  }
  double rounding_bound() const { return product(Edge_filter_2::orientation_factor, m_squares); }

  bool m_is_at_hull = false;
  bool m_is_corner = false;
  bool m_is_counterclockwise = false;
  double m_outer = 0, m_inner = 0;
  double m_determinant = 0, m_product = 0, m_lengths = 0, m_squares = 0;
};

// The proofs of Edge_slack_2 for the edges of a frame in the plane.
struct Plane_slacks_2
{
  static constexpr bool has_hull = true;

  // How far the corners of an edge may move, roughly; NaN for edges at infinity.
  template <class Frame>
  static double value(const Frame& frame, Edge_index e)
  {
    return is_at_infinity(frame.edge(e)) ? std::numeric_limits<double>::quiet_NaN()
                                         : slack(frame, e, frame.positions()).value();
  }

  // Whether the edge is safe while no corner is farther than `tolerance` from its reference.
  template <class Frame>
  static bool is_safe(const Frame& frame, Edge_index e, const Position_vector& references,
                      double tolerance)
  {
    return slack(frame, e, references).is_safe(tolerance);
  }

  // A distance from the references up to which the edge is safe; negative if there is none.
  template <class Frame>
  static double tolerance(const Frame& frame, Edge_index e, const Position_vector& references)
  {
    return slack(frame, e, references).tolerance();
  }

  template <class Frame>
  static Edge_slack_2 slack(const Frame& frame, Edge_index e, const Position_vector& positions)
  {
    return Edge_slack_2(frame.edge(e), frame.corners(e, positions));
  }
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_PROOF_EDGE_SLACK_2_H

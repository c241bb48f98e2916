// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_PROOF_EDGE_SLACK_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_PROOF_EDGE_SLACK_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/core/Computed_geometry_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/core/Processor_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/proof/Edge_filter_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/topology/Halfedge_arrays_2.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Dynamic_Delaunay_triangulations_2 {
namespace internal {

// A computed squared distance up to this bound proves that the distance is at most `tolerance`. The
// computed one has a relative error of at most 4u, u = 2^-53. If the square of the tolerance
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

// Appends the vertices [first, beyond) whose squared distances to references exceed `bound`.
inline void append_moved_plain(const Position_2* positions, const Position_2* references,
                               Index first, Index beyond, double bound, std::vector<Index>& moved)
{
  for (Vertex_index v = first; v < beyond; ++v)
    if (!(squared_distance(positions[v], references[v]) <= bound))
      moved.push_back(v);
}

#ifdef CGAL_DYNAMIC_DELAUNAY_HAS_AVX2

// By the same operations, sixteen vertices at once.
__attribute__((target("avx2"))) inline void
append_moved_avx2(const Position_2* positions, const Position_2* references, Index first,
                  Index beyond, double bound, std::vector<Index>& moved)
{
  constexpr Index block = 16;
  const __m256d bounds = _mm256_set1_pd(bound);
  Vertex_index v = first;
  for (; v + block <= beyond; v += block) {
    const double *p = &positions[v].x, *r = &references[v].x;
    __m256d are_near = _mm256_castsi256_pd(_mm256_set1_epi64x(-1));
    for (int i = 0; i < 2 * int(block); i += 8) {
      const __m256d d = _mm256_sub_pd(_mm256_loadu_pd(p + i), _mm256_loadu_pd(r + i));
      const __m256d e = _mm256_sub_pd(_mm256_loadu_pd(p + i + 4), _mm256_loadu_pd(r + i + 4));
      const __m256d squares = _mm256_hadd_pd(_mm256_mul_pd(d, d), _mm256_mul_pd(e, e));
      are_near = _mm256_and_pd(are_near, _mm256_cmp_pd(squares, bounds, _CMP_LE_OQ));
    }
    if (_mm256_movemask_pd(are_near) != 15)
      append_moved_plain(positions, references, v, v + block, bound, moved);
  }
  append_moved_plain(positions, references, v, beyond, bound, moved);
}

#endif // CGAL_DYNAMIC_DELAUNAY_HAS_AVX2

// Appends all finite vertices that are not proved to be within `tolerance` of their references.
// Returns false, and may leave vertices out, if they are more than `most`.
inline bool append_moved(const std::vector<Position_2>& positions,
                         const std::vector<Position_2>& references, double tolerance,
                         std::size_t most, std::vector<Index>& moved)
{
  const double bound = squared_bound(tolerance);
  const Index vertices = Index(positions.size());
  constexpr Index part = 1 << 10; // small parts, to detect motion everywhere early
  for (Index first = 1; first < vertices && moved.size() <= most; first += part) {
    const Index beyond = vertices - first < part ? vertices : first + part;
#ifdef CGAL_DYNAMIC_DELAUNAY_HAS_AVX2
    if (has_avx2()) {
      append_moved_avx2(positions.data(), references.data(), first, beyond, bound, moved);
      continue;
    }
#endif
    append_moved_plain(positions.data(), references.data(), first, beyond, bound, moved);
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
// at most 4u |p - q||w - q| (Edge_filter_2), half of that times the sum of their squares; a
// hundredth of a percent covers the bound's roundings.
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

  // Of an edge between two finite faces.
  explicit Edge_slack_2(const Edge_corners_2& corners) { measure_annulus(corners); }

  // The computed slack of an edge between finite faces, without allowance for rounding.
  double value() const { return (m_outer - m_inner) / 2; }

  // Whether the edge is proved Delaunay while none of its vertices moves by more than `t`. A face
  // at it is then counterclockwise if this holds for all its three edges. False if the edge is not
  // Delaunay, or a face not counterclockwise, to begin with.
  bool is_safe(double t) const
  {
    if (m_is_at_hull)
      return m_determinant > bound(t);
    return m_is_counterclockwise && m_outer - m_inner > 2 * t + 16 * 0x1p-53 * (m_outer + m_inner);
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

  // The hull goes from p through q to w.
  void measure_corner(const Position_2& p, const Position_2& q, const Position_2& w)
  {
    measure_turn(p, q, w);
    m_is_corner = true;
  }

  double slack_less_rounding() const { return value() - 8 * 0x1p-53 * (m_outer + m_inner); }

  // The t for which bound(t) equals the determinant.
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

// These proofs for the edges of a frame in the plane.
struct Plane_slacks_2
{
  static constexpr bool has_hull = true;

  // How far the corners of an edge may move, roughly; NaN for edges that are no sample.
  template <class Frame>
  static double value(const Frame& frame, Edge_index e)
  {
    return is_at_infinity(frame.edge(e)) ? std::numeric_limits<double>::quiet_NaN()
                                         : slack(frame, e, frame.positions()).value();
  }

  // Whether the edge is safe while no corner is farther than `tolerance` from its reference.
  template <class Frame>
  static bool is_safe(const Frame& frame, Edge_index e, const std::vector<Position_2>& references,
                      double tolerance)
  {
    return slack(frame, e, references).is_safe(tolerance);
  }

  // A distance from the references up to which the edge is safe; negative if there is none.
  template <class Frame>
  static double tolerance(const Frame& frame, Edge_index e,
                          const std::vector<Position_2>& references)
  {
    return slack(frame, e, references).tolerance();
  }

  template <class Frame>
  static Edge_slack_2 slack(const Frame& frame, Edge_index e,
                            const std::vector<Position_2>& positions)
  {
    return Edge_slack_2(frame.edge(e), frame.corners(e, positions));
  }
};

} // namespace internal
} // namespace Dynamic_Delaunay_triangulations_2
} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_PROOF_EDGE_SLACK_2_H

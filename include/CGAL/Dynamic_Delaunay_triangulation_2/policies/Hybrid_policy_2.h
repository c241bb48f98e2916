// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_POLICIES_HYBRID_POLICY_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_POLICIES_HYBRID_POLICY_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/policies/Update_report_2.h>

#include <algorithm>
#include <cstddef>

namespace CGAL {

/*!
\ingroup PkgDynamicDelaunayTriangulation2Policies

Chooses for every frame between mending and rebuilding, from an estimate of both costs (thesis
7.2.1). It mends until a frame has cost more than a rebuild, or was rebuilt by its repair. From then
on it tests a sample of the edges first, and rebuilds a frame in which more than a fifth of the
sample is not Delaunay. It tries to mend another frame if less than half as many edges are broken as
at the last failure, or after a pause, which grows by one frame with each failure in a row, from
none up to 63 frames. After a success it tests no samples, until it fails again.

Costs are counted, not clocked: in flips, and in spliced and relocated vertices, each weighted with
a time that was measured once. So equal input gives equal choices.

Cost: none while mending wins; otherwise a test of some hundred edges.

\cgalModels{DelaunayUpdatePolicy_2}
*/
class Hybrid_policy_2
{
public:
  /// whether a rebuild is estimated to cost less.
  template <class Frame>
  bool wants_rebuild(const Frame& frame)
  {
    m_share = m_has_lost ? share_of_broken_edges(frame) : largest_share;
    m_is_tried = !m_has_lost || is_worth_a_try();
    return !m_is_tried;
  }

  /// compares the cost of the update with that of a rebuild.
  template <class Frame>
  void after_update(const Frame& frame, const Update_report_2& report)
  {
    if (!m_is_tried)
      return;
    m_is_tried = false; // the next frame may be rebuilt without asking
    m_has_lost = report.rebuilt() || cost_of_mending(report) > cost_of_rebuilding * vertices(frame);
    if (!m_has_lost) {
      m_next_rest = 0;
      return;
    }
    m_lost_share = m_share;
    m_rest = m_next_rest;
    m_next_rest = (std::min)(m_next_rest + 1, max_rest);
  }

private:
  // From about this share on, the usual repair of exact classifiers rebuilds.
  static constexpr double largest_share = 1. / 5;
  static constexpr unsigned max_rest = 63; // frames

  // Nanoseconds, measured on random clouds of 1,000 to 10,000 points; only their ratios matter. The
  // cost of a flip includes the tests that it needs.
  static constexpr double cost_of_rebuilding = 250; // a vertex
  static constexpr double cost_of_flip = 300;
  static constexpr double cost_of_splicing = 300; // a vertex of the Triangulation set
  static constexpr double cost_of_relocation = 700;

  template <class Frame>
  static double vertices(const Frame& frame)
  {
    return double(frame.number_of_vertices());
  }

  static double cost_of_mending(const Update_report_2& report)
  {
    return cost_of_flip * double(report.flips) + cost_of_splicing * double(report.spliced) +
           cost_of_relocation * double(report.relocated);
  }

  // Estimated from edges all over the plane, few enough to be cheap compared with a rebuild.
  template <class Frame>
  static double share_of_broken_edges(const Frame& frame)
  {
    constexpr std::size_t max_edges = 256, smallest_stride = 16;
    const std::size_t edges = frame.number_of_edges();
    const std::size_t stride = smallest_stride + edges / max_edges;
    std::size_t sampled = 0, broken = 0;
    for (std::size_t e = 0; e < edges; e += stride, ++sampled)
      broken += !frame.is_delaunay(typename Frame::Edge_index(e));
    return double(broken) / double(sampled);
  }

  bool is_worth_a_try()
  {
    if (m_share > largest_share)
      return false;
    if (m_rest == 0 || 2 * m_share < m_lost_share)
      return true;
    --m_rest;
    return false;
  }

  bool m_is_tried = false;  // whether this frame is mended
  bool m_has_lost = false;  // whether mending cost more when last tried
  double m_share = 0;       // of broken edges in this frame
  double m_lost_share = 0;  // m_share when mending last lost
  unsigned m_rest = 0;      // frames until mending is tried again
  unsigned m_next_rest = 0; // value of m_rest after the next failure
};

} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_POLICIES_HYBRID_POLICY_2_H

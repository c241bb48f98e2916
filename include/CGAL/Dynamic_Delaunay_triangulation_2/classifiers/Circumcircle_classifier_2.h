// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_CLASSIFIERS_CIRCUMCIRCLE_CLASSIFIER_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_CLASSIFIERS_CIRCUMCIRCLE_CLASSIFIER_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/proof/Safe_edges_2.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgDynamicDelaunayTriangulation2Classifiers

Classifies the vertices of every edge that is not Delaunay (thesis 4.2.5), that is, of every edge
- with the vertex beyond it inside the circumcircle of its face,
- at a face that is not counterclockwise, or
- where the hull is not convex.

It is *exact*: it misses none. The signs come from floating-point evaluations over the flat arrays,
with proved error bounds, and from the kernel's exact predicates where these do not decide.

Cost: one pass over all edges, which threads share if the triangulation has the `Parallel_tag`.
While vertices hardly move: one pass over all vertices and a few edges, since it finds out which
edges are proved to stay Delaunay
(\ref DynamicDelaunayTriangulation2SafeEdges). A classifier that wraps this one must forward
`after_update()` always, or never.

\cgalModels{DelaunayClassifier_2}
*/
class Circumcircle_classifier_2
{
public:
  /// it misses no edge.
  static constexpr bool is_exact = true;

  /// classifies the vertices of broken edges; if nearly all edges are broken, classifies every
  /// vertex.
  template <class Frame, class Classification>
  void operator()(const Frame& frame, Classification& classified);

  /// whether edge `e` is not Delaunay.
  template <class Frame>
  bool names_edge(const Frame& frame, typename Frame::Edge_index e) const
  {
    return !frame.is_delaunay(e);
  }

  /// takes note of what was triangulated anew. From time to time it also finds edges that need no
  /// test for a while, since their vertices hardly move.
  template <class Frame>
  void after_update(const Frame& frame);

private:
  using Index = Dynamic_Delaunay_triangulations_2::Index;
  using Edge_index = Dynamic_Delaunay_triangulations_2::Edge_index;

  static constexpr std::size_t sample_size = 64;

  // Lists unproved edges: one list for each part of the edges, or one in all if safe edges are
  // known.
  template <class Frame>
  void find_unproved(const Frame& frame)
  {
    if (m_safe_edges.holds()) {
      m_unproved.resize(1);
      m_unproved.front().clear();
      if (m_safe_edges.append_unproved(frame, m_unproved.front()))
        return;
    }
    m_unproved.resize(Frame::Parts::number(frame.number_of_edges()));
    Frame::Parts::for_each(frame.number_of_edges(),
                           [&](std::size_t part, std::size_t first, std::size_t beyond) {
                             m_unproved[part].clear();
                             frame.append_unproved(Index(first), Index(beyond), m_unproved[part]);
                           });
  }

  // Whether more than three quarters of all edges are broken, estimated from a sample.
  template <class Frame>
  static bool is_most_of_all_edges_broken(const Frame& frame)
  {
    std::size_t sampled = 0, broken = 0;
    const std::size_t stride = 1 + frame.number_of_edges() / sample_size;
    for (std::size_t e = 0; e < frame.number_of_edges(); e += stride, ++sampled)
      broken += !frame.is_delaunay(Edge_index(e));
    return 4 * broken > 3 * sampled;
  }

  // Whether more than two thirds of the edges are unproved, and most edges of a sample of these are
  // broken. Then naming each broken edge, which costs three times as much as the pass, is useless.
  template <class Frame>
  bool is_most_of_unproved_broken(const Frame& frame) const
  {
    std::size_t unproved = 0;
    for (const std::vector<Edge_index>& part : m_unproved)
      unproved += part.size();
    if (3 * unproved <= 2 * std::size_t(frame.number_of_edges()))
      return false;
    const std::size_t stride = 1 + unproved / sample_size;
    std::size_t sampled = 0, broken = 0;
    for (const std::vector<Edge_index>& part : m_unproved)
      for (std::size_t i = 0; i < part.size(); i += stride, ++sampled)
        broken += !frame.is_delaunay(part[i]);
    return 4 * broken > 3 * sampled;
  }

  Dynamic_Delaunay_triangulations_2::internal::Safe_edges_2 m_safe_edges;
  bool m_was_asked = true;          // since the last update
  bool m_nearly_all_broken = false; // in the last frame
  Dynamic_Delaunay_triangulations_2::internal::Safe_edges_schedule_2 m_schedule;
  std::vector<std::vector<Edge_index>> m_unproved; // of each part
};

// Not inline, as Update_2::run() is not.
template <class Frame, class Classification>
void Circumcircle_classifier_2::operator()(const Frame& frame, Classification& classified)
{
  m_was_asked = true;
  if (m_schedule.is_near() && !m_safe_edges.holds())
    m_safe_edges.measure_step(frame);
  m_safe_edges.take_changes(frame); // none, unless an exception ended the last update
  // if nearly all edges broke in the last frame, they may do so in this one
  m_nearly_all_broken = m_nearly_all_broken && is_most_of_all_edges_broken(frame);
  if (m_nearly_all_broken) {
    classified.add_everything();
    return;
  }
  // a pass without branches proves nearly all edges; the others are tested one by one
  find_unproved(frame);
  m_nearly_all_broken = is_most_of_unproved_broken(frame);
  if (m_nearly_all_broken) {
    classified.add_everything();
    return;
  }
  classified.add_unless_delaunay(frame, m_unproved);
  if (m_safe_edges.holds() && m_safe_edges.hull_turns_once())
    classified.set_hull_turns_once();
}

template <class Frame>
void Circumcircle_classifier_2::after_update(const Frame& frame)
{
  m_safe_edges.learn(frame);
  // safe edges are of no use to callers that only ask edge by edge
  if (!std::exchange(m_was_asked, false))
    return;
  if (m_schedule.is_due(m_safe_edges.holds()) && frame.positions_are_exact() &&
      !frame.everything_is_new())
    m_safe_edges.start(frame, m_schedule.share());
}

} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_CLASSIFIERS_CIRCUMCIRCLE_CLASSIFIER_2_H

// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CIRCUMCIRCLE_CLASSIFIER_2_H
#define CGAL_CIRCUMCIRCLE_CLASSIFIER_2_H

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Edge_proofs_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_errors_2.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#endif

#include <algorithm>
#include <cstddef>
#include <memory>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgDynamicDelaunayTriangulation2Classifiers

Classifies the vertices of every edge that is not Delaunay (thesis 4.2.5): one whose circumcircle
holds the vertex beyond it, one at a face that is not counterclockwise, one where the hull is not
convex. It is *exact*: it misses none. The signs come from floating-point evaluations with proved
error bounds over the flat arrays, and from the kernel's exact predicates where these do not decide.

Cost: one pass over all edges.

\cgalModels `DelaunayClassifier_2`
*/
class Circumcircle_classifier_2
{
public:
  /// it misses no edge.
  static constexpr bool is_exact = true;

  /// \param threads how many threads may share the pass, from 1 to 1024. More than one needs TBB
  ///   (`CGAL::TBB_support`). The result does not depend on it.
  /// \throws Parameter_error_2 if `threads` is out of its range, or not 1 without TBB.
  explicit Circumcircle_classifier_2(unsigned threads = 1)
    : m_threads(threads)
  {
#ifdef CGAL_LINKED_WITH_TBB
    constexpr unsigned most_threads = 1024;
#else
    constexpr unsigned most_threads = 1;
#endif
    if (threads < 1 || threads > most_threads)
      throw Parameter_error_2("the number of threads of circumcircle", threads, 1, most_threads);
#ifdef CGAL_LINKED_WITH_TBB
    if (threads > 1)
      m_arena = std::make_shared<tbb::task_arena>(int(threads));
#endif
  }

  /// the number of threads.
  unsigned threads() const
  {
    return m_threads;
  }

  /// classifies.
  template <class Frame, class Classification>
  void operator()(const Frame& frame, Classification& classified)
  {
    if (!frame.positions_are_exact()) {
      for (Index e = 0; e < frame.number_of_edges(); ++e)
        examine(frame, e, classified);
      return;
    }
    // a pass without branches proves nearly all; the others are looked at one by one
    find_unproved(frame);
    for (const std::vector<Index>& unproved : m_unproved)
      for (const Index e : unproved)
        examine(frame, e, classified);
  }

private:
  using Index = Dynamic_Delaunay_triangulations_2::Index;

  // The edges are shared out in equal parts, each with a list of its own, so that their order is
  // the same on any number of threads. A part of fewer edges costs more to hand out than to do.
  template <class Frame>
  void find_unproved(const Frame& frame)
  {
    constexpr Index fewest_edges = 1 << 14;
    const unsigned parts = (std::min)(m_threads, 1 + frame.number_of_edges() / fewest_edges);
    m_unproved.resize(parts);
#ifdef CGAL_LINKED_WITH_TBB
    if (parts > 1) {
      m_arena->execute([&] {
        tbb::parallel_for(0u, parts, [&](unsigned part) { find_unproved(frame, part, parts); });
      });
      return;
    }
#endif
    find_unproved(frame, 0, parts);
  }

  template <class Frame>
  void find_unproved(const Frame& frame, unsigned part, unsigned parts)
  {
    const std::size_t edges = frame.number_of_edges();
    m_unproved[part].clear();
    Dynamic_Delaunay_triangulations_2::internal::append_unproved(
        frame.edges().data(), frame.positions(), Index(edges * part / parts),
        Index(edges * (part + 1) / parts), m_unproved[part]);
  }

  template <class Frame, class Classification>
  static void examine(const Frame& frame, Index e, Classification& classified)
  {
    if (!frame.is_delaunay(e))
      classified.add_edge(e);
  }

  unsigned m_threads;
  std::vector<std::vector<Index>> m_unproved; // of each part
#ifdef CGAL_LINKED_WITH_TBB
  std::shared_ptr<tbb::task_arena> m_arena;
#endif
};

} // namespace CGAL

#endif // CGAL_CIRCUMCIRCLE_CLASSIFIER_2_H

// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CIRCUMCIRCLE_CLASSIFIER_2_H
#define CGAL_CIRCUMCIRCLE_CLASSIFIER_2_H

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Edge_filter_2.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace CGAL {

/*!
\ingroup PkgDynamicDelaunayTriangulation2Classifiers

Classifies the vertices of every edge that is not Delaunay (thesis 4.2.5): one whose circumcircle
holds the vertex beyond it, one at a face that is not counterclockwise, one where the hull is not
convex. It is *exact*: it misses none. The signs come from floating-point evaluations with proved
error bounds over the flat arrays, and from the kernel's exact predicates where these do not decide.

Cost: one pass over all edges. No parameter.

\cgalModels `DelaunayClassifier_2`
*/
class Circumcircle_classifier_2
{
public:
  /// it misses no edge.
  static constexpr bool is_exact = true;

  /// classifies.
  template <class Frame, class Classification>
  void operator()(const Frame& frame, Classification& classified) const
  {
    using Index = typename Frame::Index;
    const Index edges = frame.number_of_edges();
    if (!frame.positions_are_exact()) {
      for (Index e = 0; e < edges; ++e)
        examine(frame, e, classified);
      return;
    }
    // in blocks: a loop without branches that proves nearly all, then a look at the rest
    constexpr Index block_size = 256;
    std::uint8_t proved[block_size];
    for (Index first = 0; first < edges; first += block_size) {
      const Index size = (std::min)(block_size, edges - first);
      for (Index i = 0; i < size; ++i)
        proved[i] = is_proved(frame, frame.edge(first + i));
      for (Index i = 0; i < size; ++i)
        if (!proved[i])
          examine(frame, first + i, classified);
    }
  }

private:
  template <class Frame>
  static bool is_proved(const Frame& frame, const typename Frame::Edge& edge)
  {
    const Dynamic_Delaunay_triangulations_2::internal::Edge_filter_2 filter(
        frame.position(edge.left), frame.position(edge.source), frame.position(edge.target),
        frame.position(edge.right));
    return filter.proves_delaunay();
  }

  template <class Frame, class Classification>
  static void examine(const Frame& frame, typename Frame::Index e, Classification& classified)
  {
    if (!frame.is_delaunay(e))
      classified.add_edge(e);
  }
};

} // namespace CGAL

#endif // CGAL_CIRCUMCIRCLE_CLASSIFIER_2_H

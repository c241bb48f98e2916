// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_CLASSIFIERS_VORONOI_CIRCUMCENTER_CLASSIFIER_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_CLASSIFIERS_VORONOI_CIRCUMCENTER_CLASSIFIER_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Points_2.h>

namespace CGAL {

/*!
\ingroup PkgDynamicDelaunayTriangulation2Classifiers

Classifies the vertices of an edge whose Voronoi edge has reversed its direction, that is, the
circumcenters of its two faces have passed each other (thesis 4.2.6). With `c1` the circumcenter of
the face to the right of the edge, `c2` that of the face to its left, and `e2` the vector from its
source to its target, this is so when

\f[ (c1_x - c2_x)\, e2_y - (c1_y - c2_y)\, e2_x < 0 . \f]

Edges at a face that is not counterclockwise are classified regardless of the circumcenters. At the
hull, where there is only one circumcenter, an edge is classified if its finite face is not
counterclockwise, and an edge to the infinite vertex if the hull turns right at its end.

In exact arithmetic this classifies the same as `Circumcircle_classifier_2`. But the circumcenters
are rounded, so it is *heuristic*: near a tie it may decide wrongly.

Cost: one pass over all edges with two circumcenters each; no memory between frames.

\cgalModels{DelaunayClassifier_2}
*/
class Voronoi_circumcenter_classifier_2
{
public:
  /// it may miss edges.
  static constexpr bool is_exact = false;

  /// classifies.
  template <class Frame, class Classification>
  void operator()(const Frame& frame, Classification& classified) const
  {
    for (typename Frame::Edge_index e(0); e < frame.number_of_edges(); ++e)
      if (names_edge(frame, e))
        classified.add_edge(e);
  }

  /// whether the circumcenters at edge `e` have passed each other.
  template <class Frame>
  bool names_edge(const Frame& frame, typename Frame::Edge_index e) const
  {
    using namespace Dynamic_Delaunay_triangulations_2::internal;
    if (frame.is_at_infinity(e))
      return frame.breaks_hull(e);
    const auto corners = frame.corners(e);
    const auto e2 = corners.target - corners.source;
    const auto left = corners.left - corners.source;
    const auto right = corners.right - corners.source;
    if (!(cross(e2, left) > 0 && cross(right, e2) > 0))
      return true;
    // an edge with a NaN is broken
    return !(cross(circumcenter(e2, right) - circumcenter(e2, left), e2) >= 0);
  }
};

} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_CLASSIFIERS_VORONOI_CIRCUMCENTER_CLASSIFIER_2_H

// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_CLASSIFIERS_ESTIMATED_VORONOI_CIRCUMCENTER_CLASSIFIER_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_CLASSIFIERS_ESTIMATED_VORONOI_CIRCUMCENTER_CLASSIFIER_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Flat_elements_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Points_2.h>

#include <vector>

namespace CGAL {

/*!
\ingroup PkgDynamicDelaunayTriangulation2Classifiers

Classifies as `Voronoi_circumcenter_classifier_2` does, but with estimated circumcenters (thesis
7.2.4): the circumcenter of a face is computed when the face is triangulated, and then moves along
with the mean of the face's three vertices.

It is *heuristic*: it follows translations exactly, except for rounding. It notices turning,
stretching and inverted faces only when a face is triangulated anew. At the hull it does the same as
`Voronoi_circumcenter_classifier_2`.

Cost: one pass over all edges; memory for one position a face.

\cgalModels{DelaunayClassifier_2}
*/
class Estimated_voronoi_circumcenter_classifier_2
{
public:
  /// it may miss edges.
  static constexpr bool is_exact = false;

  /// classifies.
  template <class Frame, class Classification>
  void operator()(const Frame& frame, Classification& classified)
  {
    if (frame.has_changes())
      after_update(frame);
    for (Edge_index e(0); e < frame.number_of_edges(); ++e)
      if (names_edge(frame, e))
        classified.add_edge(e);
  }

  /// whether the estimated circumcenters at edge `e` have passed each other.
  template <class Frame>
  bool names_edge(const Frame& frame, Dynamic_Delaunay_triangulations_2::Edge_index e) const
  {
    using namespace Dynamic_Delaunay_triangulations_2::internal;
    if (frame.is_at_infinity(e))
      return frame.breaks_hull(e);
    const auto [left, right] = frame.faces_at(e);
    const auto corners = frame.corners(e);
    // the means of the faces differ by a third of this
    const Position across = corners.right - corners.left;
    const Position &l = m_offsets[left], &r = m_offsets[right];
    const Position way{across.x / 3 + (r.x - l.x), across.y / 3 + (r.y - l.y)};
    return !(cross(way, corners.target - corners.source) >= 0);
  }

  /// computes the circumcenters of the faces that were triangulated anew.
  template <class Frame>
  void after_update(const Frame& frame)
  {
    if (!frame.everything_is_new())
      frame.follow_faces(m_offsets);
    m_offsets.resize(frame.number_of_faces());
    frame.for_each_changed_face([&](Face_index f) { m_offsets[f] = offset(frame, f); });
  }

private:
  using Edge_index = Dynamic_Delaunay_triangulations_2::Edge_index;
  using Face_index = Dynamic_Delaunay_triangulations_2::Face_index;
  using Position = Dynamic_Delaunay_triangulations_2::Position_2;

  // The vector from the mean of the vertices to the circumcenter.
  template <class Frame>
  static Position offset(const Frame& frame, Face_index f)
  {
    using namespace Dynamic_Delaunay_triangulations_2::internal;
    const auto corners = frame.face_corners(f);
    const Position u = corners[1] - corners[0], v = corners[2] - corners[0];
    return circumcenter(u, v) - Position{(u.x + v.x) / 3, (u.y + v.y) / 3};
  }

  std::vector<Position> m_offsets; // of each face, when it was triangulated
};

} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_CLASSIFIERS_ESTIMATED_VORONOI_CIRCUMCENTER_CLASSIFIER_2_H

// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ESTIMATED_VORONOI_CIRCUMCENTER_CLASSIFIER_2_H
#define CGAL_ESTIMATED_VORONOI_CIRCUMCENTER_CLASSIFIER_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Computed_geometry_2.h>

#include <vector>

namespace CGAL {

/*!
\ingroup PkgDynamicDelaunayTriangulation2Classifiers

The same as `Voronoi_circumcenter_classifier_2`, but estimates the circumcenters (thesis 7.2.4): it
computes that of a face when the face is triangulated, and then moves it along with the mean of the
face's three vertices.

It is *heuristic*: it follows translations exactly, except for rounding. It notices turning,
stretching and inverted faces only when a face is triangulated anew. At the hull it does the same as
`Voronoi_circumcenter_classifier_2`.

Cost: one pass over all faces, and one over all edges; memory for two positions a face.

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
    for (Index f = 0; f < frame.number_of_faces(); ++f)
      m_centers[f] = center(frame, f);
    for (Index e = 0; e < frame.number_of_edges(); ++e)
      if (is_broken(frame, e, [this](Index f) { return m_centers[f]; }))
        classified.add_edge(e);
  }

  /// whether the estimated circumcenters at edge `e` have passed each other.
  template <class Frame>
  bool names_edge(const Frame& frame, Dynamic_Delaunay_triangulations_2::Index e) const
  {
    return is_broken(frame, e, [&](Index f) { return center(frame, f); });
  }

  /// computes the circumcenters of the faces that were triangulated anew.
  template <class Frame>
  void after_update(const Frame& frame)
  {
    if (!frame.everything_is_new())
      frame.follow_faces(m_offsets);
    m_offsets.resize(frame.number_of_faces());
    m_centers.resize(frame.number_of_faces());
    frame.for_each_changed_face([&](Index f) { m_offsets[f] = offset(frame, f); });
  }

private:
  using Index = Dynamic_Delaunay_triangulations_2::Index;
  using Position = Dynamic_Delaunay_triangulations_2::Position_2;

  template <class Frame>
  Position center(const Frame& frame, Index f) const
  {
    const auto vertices = frame.face(f);
    const Position &p = frame.position(vertices[0]), &q = frame.position(vertices[1]),
                   &r = frame.position(vertices[2]);
    return {(p.x + q.x + r.x) / 3 + m_offsets[f].x, (p.y + q.y + r.y) / 3 + m_offsets[f].y};
  }

  // The vector from the mean of the vertices to the circumcenter.
  template <class Frame>
  static Position offset(const Frame& frame, Index f)
  {
    using namespace Dynamic_Delaunay_triangulations_2::internal;
    const auto vertices = frame.face(f);
    const Position u = frame.position(vertices[1]) - frame.position(vertices[0]);
    const Position v = frame.position(vertices[2]) - frame.position(vertices[0]);
    return circumcenter(u, v) - Position{(u.x + v.x) / 3, (u.y + v.y) / 3};
  }

  template <class Frame, class Center>
  static bool is_broken(const Frame& frame, Index e, const Center& center_of)
  {
    using namespace Dynamic_Delaunay_triangulations_2::internal;
    if (frame.is_at_infinity(e))
      return frame.breaks_hull(e);
    const auto [left, right] = frame.faces_at(e);
    const auto corners = frame.corners(e);
    const Position e2 = corners.target - corners.source;
    return !(cross(center_of(right) - center_of(left), e2) >= 0);
  }

  std::vector<Position> m_offsets; // of each face, when it was triangulated
  std::vector<Position> m_centers; // of each face, in the frame that is classified
};

} // namespace CGAL

#endif // CGAL_ESTIMATED_VORONOI_CIRCUMCENTER_CLASSIFIER_2_H

// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_CLASSIFIERS_VORONOI_EDGE_LENGTH_CLASSIFIER_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_CLASSIFIERS_VORONOI_EDGE_LENGTH_CLASSIFIER_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Flat_arrays.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Flat_elements_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Points_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_errors_2.h>

#include <limits>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgDynamicDelaunayTriangulation2Classifiers

Uses Voronoi edges to bound how far vertices may move (thesis 7.2.3). The Voronoi edge of an edge
`bc` with the opposite vertices `a` and `d` gets shorter when `b` and `c` move apart, away from it,
and when `a` and `d` approach each other, towards its ends. So each Voronoi edge bounds the motion
of four vertices, and a vertex with six neighbors is bounded in twelve directions. With `Vt` the
length of the Voronoi edge when the neighborhood was last triangulated, and `bct` and `adt` the
distances at that time, the four are classified when

\f[ (|bc| - bc_t) + (ad_t - |ad|) > x\, V_t . \f]

Between equilateral faces the Voronoi edge loses 0.6 of the length by which `b` and `c` move apart,
and 0.7 of the length by which `a` and `d` approach each other. So `x = 1` is cautious there; at
flat faces it is not. At the hull, where Voronoi edges do not end, edges are classified as by
`Voronoi_circumcenter_classifier_2`. It is *heuristic*: motion along the edge goes unnoticed.

Cost: one pass over all edges with two distances each; memory for one double an edge.

\cgalModels{DelaunayClassifier_2}
*/
class Voronoi_edge_length_classifier_2
{
public:
  /// it may miss edges.
  static constexpr bool is_exact = false;

  /// \param x the share of a Voronoi edge that motion may use up, from 0 to 1.
  /// \throws Parameter_error_2 if `x` is out of this range.
  explicit Voronoi_edge_length_classifier_2(double x = 1)
    : m_x(x)
  {
    if (!(x >= 0 && x <= 1))
      throw Parameter_error_2("the parameter x of voronoi_edge_length", x, 0, 1);
  }

  /// the parameter.
  double x() const { return m_x; }

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

  /// whether motion has used up too much of the Voronoi edge of edge `e`.
  template <class Frame>
  bool names_edge(const Frame& frame, Dynamic_Delaunay_triangulations_2::Edge_index e) const
  {
    if (frame.is_at_infinity(e))
      return frame.breaks_hull(e);
    return !(stretch(frame.corners(e)) <= m_limits[e]); // a NaN is broken
  }

  /// measures the Voronoi edges that were triangulated anew, also those of edges of which only an
  /// opposite vertex changed.
  template <class Frame>
  void after_update(const Frame& frame)
  {
    if (!frame.everything_is_new())
      frame.follow_edges(m_limits);
    m_limits.resize(frame.number_of_edges());
    m_measured.clear(frame.number_of_edges());
    frame.for_each_changed_edge([&](Edge_index e) {
      if (!m_measured.insert(e))
        return;
      const Corners corners = frame.corners(e);
      m_limits[e] = stretch(corners) + m_x * voronoi_edge_length(corners);
    });
  }

private:
  using Edge_index = Dynamic_Delaunay_triangulations_2::Edge_index;
  using Position = Dynamic_Delaunay_triangulations_2::Position_2;
  using Corners = Dynamic_Delaunay_triangulations_2::Edge_corners_2;

  static double stretch(const Corners& corners)
  {
    using Dynamic_Delaunay_triangulations_2::internal::distance;
    return distance(corners.source, corners.target) - distance(corners.left, corners.right);
  }

  // Negative if the edge is not Delaunay; NaN at a face that is not counterclockwise. The center of
  // abc is above bc by half of |bc| times the cotangent of the angle at a, so the length is
  // computed without centers.
  static double voronoi_edge_length(const Corners& corners)
  {
    using Dynamic_Delaunay_triangulations_2::internal::distance;
    return distance(corners.source, corners.target) / 2 *
           (cotangent(corners.left, corners.source, corners.target) +
            cotangent(corners.right, corners.target, corners.source));
  }

  static double cotangent(const Position& apex, const Position& first, const Position& second)
  {
    using namespace Dynamic_Delaunay_triangulations_2::internal;
    const Position u = first - apex, v = second - apex;
    const double area = cross(u, v);
    return area > 0 ? dot(u, v) / area : std::numeric_limits<double>::quiet_NaN();
  }

  double m_x;
  std::vector<double> m_limits; // of |bc| - |ad|, for each edge
  Dynamic_Delaunay_triangulations_2::internal::Index_set<Edge_index> m_measured;
};

} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_CLASSIFIERS_VORONOI_EDGE_LENGTH_CLASSIFIER_2_H

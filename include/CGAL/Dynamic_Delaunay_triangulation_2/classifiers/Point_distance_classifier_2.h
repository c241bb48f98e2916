// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_CLASSIFIERS_POINT_DISTANCE_CLASSIFIER_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_CLASSIFIERS_POINT_DISTANCE_CLASSIFIER_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/classifiers/Point_distance_times_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Points_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_errors_2.h>

#include <algorithm>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgDynamicDelaunayTriangulation2Classifiers

Classifies both ends of an edge whose length has left the range from `x * Lt` to `(2 - x) * Lt`,
where `Lt` is the length that it had when its neighborhood was last triangulated (thesis 4.2.2,
figure 4.2). With `x = 1` every change of length counts; a small `x` tolerates much. It is
<em>heuristic</em>: an edge can lose the Delaunay property while all lengths stay within their
ranges.

Cost: one pass over all edges; memory for one double an edge.

\cgalModels{DelaunayClassifier_2}
*/
class Point_distance_classifier_2
{
public:
  /// it may miss edges.
  static constexpr bool is_exact = false;

  /// \param x the share of its reference length that an edge may shrink to, from 0 to 1.
  /// \throws Parameter_error_2 if `x` is out of this range.
  explicit Point_distance_classifier_2(double x = 0.7)
    : m_x(x)
  {
    if (!(x >= 0 && x <= 1))
      throw Parameter_error_2("the parameter x of point_distance", x, 0, 1);
  }

  /// the parameter.
  double x() const { return m_x; }

  /// classifies.
  template <class Frame, class Classification>
  void operator()(const Frame& frame, Classification& classified)
  {
    if (frame.has_changes())
      after_update(frame);
    // lengths are compared squared; at the infinite vertex they are NaN, and no comparison holds
    const double lowest = m_x * m_x, highest = (2 - m_x) * (2 - m_x);
    for (typename Frame::Edge_index e(0); e < frame.number_of_edges(); ++e) {
      const double length = squared_length(frame, e);
      const double reference = m_squared_references[e];
      if (length < lowest * reference || length > highest * reference) {
        classified.add_vertex(frame.edge(e).source);
        classified.add_vertex(frame.edge(e).target);
      }
    }
  }

  /// takes the lengths of the edges that were triangulated anew as their references.
  template <class Frame>
  void after_update(const Frame& frame)
  {
    using Edge_index = Dynamic_Delaunay_triangulations_2::Edge_index;
    if (frame.everything_is_new()) {
      m_squared_references.resize(frame.number_of_edges());
      for (Edge_index e(0); e < frame.number_of_edges(); ++e)
        m_squared_references[e] = squared_length(frame, e);
    } else {
      frame.follow_edges(m_squared_references);
      for (const Edge_index e : frame.new_edges())
        m_squared_references[e] = squared_length(frame, e);
    }
  }

  /// predicts, after an update, the first frame after `frame` in which the classifier will classify
  /// a vertex, if all vertices move at constant velocities: a whole number from 1 on, or infinity
  /// if that frame never comes (thesis 4.2.2, see `Point_distance_times_2`). Until then the
  /// classifier need not be asked. Cost: one pass over all edges with a few square roots each.
  ///
  /// \param frame the frame of the last update, `Dynamic_Delaunay_triangulation_2::frame()`.
  /// \param velocity a function from ids to velocities with `x` and `y`, in lengths a frame. If
  ///   points coincide, it is called only for their representative.
  template <class Frame, class Velocity>
  double predict(const Frame& frame, const Velocity& velocity) const
  {
    double first = Point_distance_times_2::never;
    for (typename Frame::Edge_index e(0); e < frame.number_of_edges(); ++e) {
      const auto& edge = frame.edge(e);
      if (frame.is_infinite(edge))
        continue;
      const auto way = frame.edge_vector(e);
      const auto u = velocity(frame.id(edge.source)), v = velocity(frame.id(edge.target));
      const Point_distance_times_2 times(m_x, m_squared_references[e], way.x, way.y, v.x - u.x,
                                         v.y - u.y);
      first = (std::min)(first, times.first_frame());
    }
    return first;
  }

private:
  template <class Frame>
  static double squared_length(const Frame& frame, typename Frame::Edge_index e)
  {
    const auto way = frame.edge_vector(e);
    return Dynamic_Delaunay_triangulations_2::internal::dot(way, way);
  }

  double m_x;
  std::vector<double> m_squared_references; // of each edge
};

} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_CLASSIFIERS_POINT_DISTANCE_CLASSIFIER_2_H

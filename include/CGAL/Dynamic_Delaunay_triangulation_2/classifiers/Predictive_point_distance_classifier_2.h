// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_CLASSIFIERS_PREDICTIVE_POINT_DISTANCE_CLASSIFIER_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_CLASSIFIERS_PREDICTIVE_POINT_DISTANCE_CLASSIFIER_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/classifiers/Point_distance_classifier_2.h>

#include <algorithm>
#include <cstddef>

namespace CGAL {

/*!
\ingroup PkgDynamicDelaunayTriangulation2Classifiers

`Point_distance_classifier_2` for known velocities: it predicts the first frame in which it can
classify a vertex (thesis 4.2.2), and tests no edge until then. It predicts after each frame in
which it tested edges, or in which something was triangulated anew. It classifies the same vertices
as `Point_distance_classifier_2` while velocities stay as they were at the last prediction. It is a
<em>heuristic</em> classifier.

Cost: none in frames without tests; in the others that of `Point_distance_classifier_2` and of
`Point_distance_classifier_2::predict()`. So it pays if few frames classify any vertex.

\tparam Velocity a function from ids to velocities with `x` and `y`, in lengths a frame.

\cgalModels{DelaunayClassifier_2}
*/
template <class Velocity>
class Predictive_point_distance_classifier_2
{
public:
  /// it may miss edges.
  static constexpr bool is_exact = false;

  /// \param velocity the velocities of the points; it is copied.
  /// \param x as in `Point_distance_classifier_2`.
  /// \throws Parameter_error_2 if `x` is out of its range.
  explicit Predictive_point_distance_classifier_2(const Velocity& velocity, double x = 0.7)
    : m_classifier(x)
    , m_velocity(velocity)
  {
  }

  /// the parameter.
  double x() const { return m_classifier.x(); }
  /// the number of frames to come in which it will test no edge, as last predicted.
  std::size_t number_of_quiet_frames() const { return m_quiet_frames; }

  /// classifies.
  template <class Frame, class Classification>
  void operator()(const Frame& frame, Classification& classified)
  {
    m_has_looked = frame.has_changes() || m_quiet_frames == 0;
    if (m_has_looked)
      m_classifier(frame, classified);
    else
      --m_quiet_frames;
  }

  /// updates references as `Point_distance_classifier_2` does, and predicts anew if necessary.
  template <class Frame>
  void after_update(const Frame& frame)
  {
    m_classifier.after_update(frame);
    if (!m_has_looked && !frame.has_changes())
      return;
    m_has_looked = false;
    constexpr double max_frames = 1e9;
    const double first = m_classifier.predict(frame, m_velocity);
    m_quiet_frames = std::size_t((std::min)(first, max_frames)) - 1;
  }

private:
  Point_distance_classifier_2 m_classifier;
  Velocity m_velocity;
  std::size_t m_quiet_frames = 0;
  bool m_has_looked = false;
};

} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_CLASSIFIERS_PREDICTIVE_POINT_DISTANCE_CLASSIFIER_2_H

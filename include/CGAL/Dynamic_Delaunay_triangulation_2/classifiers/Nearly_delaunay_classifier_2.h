// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_CLASSIFIERS_NEARLY_DELAUNAY_CLASSIFIER_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_CLASSIFIERS_NEARLY_DELAUNAY_CLASSIFIER_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Edge_filter_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Flat_elements_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Points_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/proof/Edge_test_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/repairs/Hold_and_flip_repair_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_errors_2.h>

#include <cmath>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgDynamicDelaunayTriangulation2Classifiers

Classifies the vertices of every edge that is not even nearly Delaunay (thesis 7.2.5). An edge `bc`
between the counterclockwise faces `abc` and `dcb` is *nearly Delaunay* if `d` is not deeper in the
circumcircle of `abc` than `eps` times its radius, nor `a` in that of `dcb`. With `o` and `R` the
center and the radius of the first one, that is

\f[ |od| \ge (1 - \mathit{eps})\, R , \f]

and likewise for the second one. Edges at a face that is not counterclockwise, or where the hull is
not convex, are classified whatever `eps` is.

<b>The bound.</b> With `Hold_and_flip_repair_2`, which is the default repair for this classifier,
every update ends with all finite faces counterclockwise, the hull turning left or going straight on
at each vertex, and all edges between finite faces nearly Delaunay. The reason: flips and splices
prove every edge Delaunay whose vertices they change, and that repair rebuilds where they cannot.
Rounding is on the safe side. With other repairs the bound is not guaranteed: flips alone get stuck
at inverted faces, and a border splice tests neither its own boundary nor the edges beyond it.

It is *heuristic*: the result is not a Delaunay triangulation, and not certified. With `eps = 0` it
classifies the same as `Circumcircle_classifier_2`.

Cost: one pass over all edges; no memory between frames.

\cgalModels{DelaunayClassifier_2}
*/
class Nearly_delaunay_classifier_2
{
public:
  /// it does not classify all edges that are not Delaunay.
  static constexpr bool is_exact = false;
  /// the repair that guarantees the bound.
  using Usual_repair = Hold_and_flip_repair_2;

  /// \param eps how deep a vertex may be in a circumcircle, in radii, from 0 to 1.
  /// \throws Parameter_error_2 if `eps` is out of this range.
  explicit Nearly_delaunay_classifier_2(double eps = 0.05)
    : m_eps(eps)
  {
    if (!(eps >= 0 && eps <= 1))
      throw Parameter_error_2("the parameter eps of nearly_delaunay", eps, 0, 1);
  }

  /// the parameter.
  double eps() const { return m_eps; }

  /// classifies.
  template <class Frame, class Classification>
  void operator()(const Frame& frame, Classification& classified)
  {
    m_unproved.clear();
    frame.append_unproved(0, frame.number_of_edges(), m_unproved);
    for (const Edge_index e : m_unproved)
      if (!frame.corners_are_exact(e) || !is_proved_near(frame.corners(e)))
        classified.add_unless_delaunay(frame, e);
  }

  /// whether edge `e` is not even nearly Delaunay.
  template <class Frame>
  bool names_edge(const Frame& frame, typename Frame::Edge_index e) const
  {
    return !(frame.corners_are_exact(e) && is_proved_near(frame.corners(e))) &&
           !frame.is_delaunay(e);
  }

private:
  using Edge_index = Dynamic_Delaunay_triangulations_2::Edge_index;
  using Position = Dynamic_Delaunay_triangulations_2::Position_2;

  // With the power R^2 - |od|^2 of d, which is in_circle / left, and R^2 = |ab|^2 |bc|^2 |ca|^2 /
  // (4 left^2), the edge is nearly Delaunay if
  //     4 left in_circle <= eps (2 - eps) |ab|^2 |bc|^2 |ca|^2,
  // and likewise with the other face's orientation and lengths. The errors of in_circle and left
  // are those of Edge_filter_2; the few roundings of the products, each within 2^-53, are far below
  // 1e-14.
  bool is_proved_near(const Dynamic_Delaunay_triangulations_2::Edge_corners_2& corners) const
  {
    using Dynamic_Delaunay_triangulations_2::internal::Edge_filter_2;
    const auto& [a, b, c, d] = corners;
    const Edge_filter_2 filter(corners);
    if (!filter.proves_counterclockwise())
      return false;
    const double in_circle = filter.in_circle + filter.in_circle_bound();
    return is_bounded((filter.left + filter.left_bound()) * in_circle, a, b, c) &&
           is_bounded((filter.right + filter.right_bound()) * in_circle, d, c, b);
  }

  bool is_bounded(double product, const Position& p, const Position& q, const Position& r) const
  {
    using Dynamic_Delaunay_triangulations_2::internal::squared_distance;
    constexpr double smallest_lengths = 1e-250; // smaller products may have underflowed
    const double lengths = squared_distance(p, q) * squared_distance(q, r) * squared_distance(r, p);
    return lengths > smallest_lengths && std::isfinite(lengths) &&
           4 * product <= (1 - 1e-14) * m_eps * (2 - m_eps) * lengths;
  }

  double m_eps;
  std::vector<Edge_index> m_unproved;
};

} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_CLASSIFIERS_NEARLY_DELAUNAY_CLASSIFIER_2_H

// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_CLASSIFIERS_POINT_DISTANCE_TIMES_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_CLASSIFIERS_POINT_DISTANCE_TIMES_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace CGAL {

/*!
\ingroup PkgDynamicDelaunayTriangulation2Classifiers

Computes when `Point_distance_classifier_2` will classify an edge whose ends move at constant
velocities: the times `T_min`, `T_max` and `T_T` of thesis 4.2.2.

With `p` the vector from one end to the other and `v` its change in a frame, the length after `t`
frames is `|p + t v|`. It falls below `x Lt` at `T_min` and exceeds `(2 - x) Lt` at `T_max`:

\f[ T_{min} = \frac{p^2 - (x L_t)^2}{-pv + \sqrt{(pv)^2 - v^2 (p^2 - (x L_t)^2)}}, \quad
    T_{max} = \frac{-pv + \sqrt{(pv)^2 + v^2 (((2 - x) L_t)^2 - p^2)}}{v^2}, \quad
    T_T = \min(T_{min}, T_{max}) . \f]

The thesis divides by the speed `S = pv / |p|` at which the edge is extending now, as if that speed
stayed constant. But a length is a convex function of time: the real `T_min` is later than that, or
never comes, and the real `T_max` is sooner.

So that no time is too late, the range is narrowed by 1e-12 of the values compared. This does not
cover the rounding of positions that are added up frame by frame.
*/
class Point_distance_times_2
{
public:
  /// the value for a time that never comes.
  static constexpr double never = std::numeric_limits<double>::infinity();

  /// \param x the classifier's parameter.
  /// \param squared_reference the square of `Lt`.
  /// \param px,py the vector from one end of the edge to the other.
  /// \param vx,vy its change in a frame.
  Point_distance_times_2(double x, double squared_reference, double px, double py, double vx,
                         double vy)
    : m_speed(vx * vx + vy * vy)
    , m_product(px * vx + py * vy)
  {
    const double square = px * px + py * py;
    const double lowest = x * x * squared_reference,
                 highest = (2 - x) * (2 - x) * squared_reference;
    const double margin = m_speed > 0 ? 1e-12 * (square + highest) : 0;
    // at x = 0 no length is too short
    m_above_lowest = x > 0 ? square - lowest - margin : never;
    m_below_highest = highest - square - margin;
  }

  /// the first time at which the edge is too short: 0 if it is too short now, `never` if that time
  /// never comes.
  double t_min() const
  {
    if (m_above_lowest < 0)
      return 0;
    const double root = root_of_lowest();
    return root >= 0 && m_product < 0 ? m_above_lowest / (root - m_product) : never;
  }

  /// the first time at which the edge is too long: 0 if it is too long now, `never` if that time
  /// never comes.
  double t_max() const
  {
    if (m_below_highest < 0)
      return 0;
    const double root = std::hypot(m_product, std::sqrt(m_speed) * std::sqrt(m_below_highest));
    if (m_product > 0)
      return m_below_highest / (root + m_product);
    return m_speed > 0 ? (root - m_product) / m_speed : never;
  }

  /// the smaller one of `t_min()` and `t_max()`.
  double t_t() const { return (std::min)(t_min(), t_max()); }

  /// the first frame in which the edge is classified: a whole number from 1 on, or `never`. An edge
  /// that is too short only between two frames is not classified. Returns 1 if the edge is out of
  /// its range now, even if it may be back within its range in that frame.
  double first_frame() const
  {
    const double too_short = frame_after(t_min());
    const bool is_still = m_above_lowest < 0 || too_short <= end_of_too_short();
    return (std::min)(is_still ? too_short : never, frame_after(t_max()));
  }

private:
  static double frame_after(double time) { return std::floor(time * (1 - 1e-14)) + 1; }

  // Returns the square root in `T_min`; NaN if the edge never gets too short. Does not square the
  // products, which could overflow or underflow.
  double root_of_lowest() const
  {
    const double product = std::abs(m_product);
    const double other = std::sqrt(m_speed) * std::sqrt(m_above_lowest);
    return std::sqrt(product - other) * std::sqrt(product + other);
  }

  double end_of_too_short() const { return (root_of_lowest() - m_product) / m_speed * (1 + 1e-14); }

  double m_speed;   // v^2
  double m_product; // p v
  double m_above_lowest, m_below_highest;
};

} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_CLASSIFIERS_POINT_DISTANCE_TIMES_2_H

// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_PERIODIC_PERIODIC_SLACKS_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_PERIODIC_PERIODIC_SLACKS_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Flat_arrays.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Flat_elements_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/periodic/Torus_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/proof/Edge_slack_2.h>

#include <limits>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

// The proofs of Edge_slack_2 for edges between images, while the cell stays the same. Where the
// corners have no shifts, the proofs are those of the plane. Elsewhere the corners are taken
// relative to one of them, which rounds them: each is off by at most some `error`. An image moves
// as far as its point. So corners within a tolerance t of their references are within t + error of
// the rounded references, where the circle separates them. The faces are proved counterclockwise at
// the references themselves.
struct Periodic_slacks_2
{
  static constexpr bool has_hull = false;

  template <class Frame>
  static double value(const Frame& frame, Edge_index e)
  {
    if (frame.state().arrays().is_empty_edge(e))
      return std::numeric_limits<double>::quiet_NaN();
    const Edge_images_2 corners = corners_of(frame, e, frame.positions());
    return is_across(torus(frame), corners)
               ? std::numeric_limits<double>::quiet_NaN()
               : Edge_slack_2(torus(frame).rounded_corners(corners).first).value();
  }

  template <class Frame>
  static bool is_safe(const Frame& frame, Edge_index e, const Position_vector& references,
                      double tolerance)
  {
    const auto& state = frame.state();
    if (state.arrays().is_empty_edge(e))
      return false;
    if (state.is_shifted(e))
      return is_safe(state.torus(), corners_of(frame, e, references), tolerance);
    return Edge_slack_2(frame.corners(e, references)).is_safe(tolerance);
  }

  static bool is_safe(const Torus_2& torus, const Edge_images_2& references, double tolerance)
  {
    if (is_across(torus, references) || !torus.filter_proves_counterclockwise(references))
      return false;
    const auto [rounded, error] = torus.rounded_corners(references);
    return Edge_slack_2(rounded).is_safe(tolerance + error);
  }

  // A distance from the references up to which the edge is safe; negative if there is none.
  template <class Frame>
  static double tolerance(const Frame& frame, Edge_index e, const Position_vector& references)
  {
    if (frame.is_at_infinity(e))
      return -1;
    const Edge_images_2 corners = corners_of(frame, e, references);
    const auto [rounded, error] = torus(frame).rounded_corners(corners);
    const double tolerance = (1 - 1e-12) * (Edge_slack_2(rounded).tolerance() - error);
    return tolerance > Edge_slack_2::smallest_tolerance && is_safe(torus(frame), corners, tolerance)
               ? tolerance
               : -1;
  }

private:
  template <class Frame>
  static const Torus_2& torus(const Frame& frame)
  {
    return frame.state().torus();
  }

  template <class Frame>
  static Edge_images_2 corners_of(const Frame& frame, Edge_index e,
                                  const Position_vector& positions)
  {
    return frame.state().corners_at(frame.state().arrays().halfedge(e), positions);
  }

  static bool is_across(const Torus_2& torus, const Edge_images_2& corners)
  {
    const auto is_from_right = [&](const Image_2& image) {
      return torus.are_across(image.shift, corners.right.shift);
    };
    return is_from_right(corners.left) || is_from_right(corners.source) ||
           is_from_right(corners.target);
  }
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_PERIODIC_PERIODIC_SLACKS_2_H

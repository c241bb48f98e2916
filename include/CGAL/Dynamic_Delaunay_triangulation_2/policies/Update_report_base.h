// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_POLICIES_UPDATE_REPORT_BASE_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_POLICIES_UPDATE_REPORT_BASE_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <cstddef>

namespace CGAL {

/*!
\ingroup PkgDynamicDelaunayTriangulation2Ref

Why an update rebuilt the triangulation instead of mending it.
*/
enum class Rebuild_reason_2 {
  NONE,            ///< the update did not rebuild
  REPAIR,          ///< the repair is `Rebuild_repair_2`, and something was classified
  TOO_MUCH_BROKEN, ///< so much was broken that mending would have cost more
  STUCK,           ///< the repair left something broken, or could not start from the last frame
  COINCIDENCE,     ///< many points came to coincide, or coincident points separated
  POPULATION,      ///< many points were inserted or removed
  DIMENSION,   ///< before or after the frame the points did not span the plane, or space: too few
               ///< points, or all on a line, or in space in a plane
  POLICY,      ///< the update policy wanted it
  BUDGET_SPENT ///< mending exceeded its expected cost, and was given up
};

/*!
\ingroup PkgDynamicDelaunayTriangulation2Ref

What `Update_report_2` and `Update_report_3` have in common.
*/
struct Update_report_base
{
  /// flips: of edges in the plane; in space 2-3, 3-2, and two for each 4-4, also those that are
  /// taken back.
  std::size_t flips = 0;
  /// vertices that moved far, and were taken out and inserted elsewhere; with `Relocation_repair_2`
  /// those that CGAL's `move_if_no_collision()` moved.
  std::size_t relocated = 0;
  /// points inserted.
  std::size_t inserted = 0;
  /// points removed.
  std::size_t removed = 0;
  /// vertices removed because they came to coincide with others; rebuilds do not count them.
  std::size_t merged = 0;
  /// points that left a vertex that they had shared; rebuilds do not count them.
  std::size_t parted = 0;
  /// why the triangulation was rebuilt; `NONE` if it was not.
  Rebuild_reason_2 rebuild_reason = Rebuild_reason_2::NONE;
  /// whether the triangulation is certified, that is, proved Delaunay, at the end.
  bool certified = false;

  /// whether the triangulation was rebuilt.
  bool rebuilt() const { return rebuild_reason != Rebuild_reason_2::NONE; }
};

} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_POLICIES_UPDATE_REPORT_BASE_H

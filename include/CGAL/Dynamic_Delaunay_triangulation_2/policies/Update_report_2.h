// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_POLICIES_UPDATE_REPORT_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_POLICIES_UPDATE_REPORT_2_H

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
  DIMENSION,       ///< fewer than three points, or all points on a line, before or after the frame
  POLICY,          ///< the update policy wanted it
  BUDGET_SPENT     ///< mending exceeded its expected cost, and was given up
};

/*!
\ingroup PkgDynamicDelaunayTriangulation2Ref

What one update did. Equal input and settings give equal reports.
*/
struct Update_report_2
{
  /// vertices that the classifier picked; where a frame was taken in steps
  /// (`Hold_and_flip_repair_2`), those of the last step.
  std::size_t classified = 0;
  /// vertices in the layers of padding around the classified ones (border splice only).
  std::size_t padded = 0;
  /// vertices in the layer beyond the padding (border splice only).
  std::size_t border = 0;
  /// edges flipped.
  std::size_t flips = 0;
  /// border splices: regions triangulated anew and put in place of the old ones.
  std::size_t splices = 0;
  /// vertices of spliced regions, borders included; a vertex of several regions is counted in each.
  std::size_t spliced = 0;
  /// enlargements of regions, because the boundaries of old and new faces disagreed.
  std::size_t enlargements = 0;
  /// vertices that moved far, and were taken out of their faces and inserted elsewhere; with
  /// `Relocation_repair_2` those that CGAL's `move_if_no_collision()` moved.
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

  /// adds the report of a later step: adds the counts, keeps the first reason for a rebuild, and
  /// takes over `certified`.
  Update_report_2& operator+=(const Update_report_2& next)
  {
    classified += next.classified;
    padded += next.padded;
    border += next.border;
    flips += next.flips;
    splices += next.splices;
    spliced += next.spliced;
    enlargements += next.enlargements;
    relocated += next.relocated;
    inserted += next.inserted;
    removed += next.removed;
    merged += next.merged;
    parted += next.parted;
    if (!rebuilt())
      rebuild_reason = next.rebuild_reason;
    certified = next.certified;
    return *this;
  }
};

} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_POLICIES_UPDATE_REPORT_2_H

// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_UPDATE_REPORT_2_H
#define CGAL_UPDATE_REPORT_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <cstddef>

namespace CGAL {

/*!
\ingroup PkgDynamicDelaunayTriangulation2Ref

Why an update rebuilt the triangulation instead of mending it.
*/
enum class Rebuild_reason_2 {
  NONE,            ///< it did not
  REPAIR,          ///< the repair is `Rebuild_repair_2`, and something was classified
  TOO_MUCH_BROKEN, ///< so much was broken, or jumped, that mending would have cost more
  STUCK,           ///< what the repair left broken
  COINCIDENCE,     ///< many points came to coincide, or coincident points parted
  POPULATION,      ///< many points came or went
  DIMENSION,       ///< fewer than three points, or all points on a line, before or after the frame
  POLICY,          ///< the update policy wanted it
  BUDGET_SPENT     ///< mending cost more than was expected, and was given up
};

/*!
\ingroup PkgDynamicDelaunayTriangulation2Ref

What one update did. Equal input and settings give equal reports.
*/
struct Update_report_2
{
  /// vertices that the classifier picked.
  std::size_t classified = 0;
  /// vertices in the layers of padding around them (border splice only).
  std::size_t padded = 0;
  /// vertices in the layer beyond the padding (border splice only).
  std::size_t border = 0;
  /// edges flipped.
  std::size_t flips = 0;
  /// border splices: regions triangulated anew and put in place of the old ones.
  std::size_t splices = 0;
  /// vertices of these regions, with their borders; those of several regions more than once.
  std::size_t spliced = 0;
  /// times that a region grew because its boundary and that of its new triangulation disagreed.
  std::size_t enlargements = 0;
  /// vertices that went far, and were taken out of their faces and put in again elsewhere; with
  /// `Relocation_repair_2` those that CGAL's `move_if_no_collision()` moved.
  std::size_t relocated = 0;
  /// points that came.
  std::size_t inserted = 0;
  /// points that went.
  std::size_t removed = 0;
  /// vertices that went because others came to be in the same place, but for rebuilds.
  std::size_t merged = 0;
  /// points that left a vertex which they had shared, but for rebuilds.
  std::size_t parted = 0;
  /// whether the triangulation was rebuilt, and why.
  Rebuild_reason_2 rebuild_reason = Rebuild_reason_2::NONE;
  /// whether the certificate holds at the end: the triangulation is proved Delaunay.
  bool certified = false;

  /// whether the triangulation was rebuilt.
  bool rebuilt() const { return rebuild_reason != Rebuild_reason_2::NONE; }

  /// adds what was done after this: counts are added, the first reason for a rebuild stays.
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

#endif // CGAL_UPDATE_REPORT_2_H

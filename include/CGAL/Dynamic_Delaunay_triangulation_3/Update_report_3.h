// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_UPDATE_REPORT_3_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_UPDATE_REPORT_3_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/policies/Update_report_2.h>

#include <cstddef>

namespace CGAL {

/*!
\ingroup PkgDynamicDelaunayTriangulation2Ref

What one update of a triangulation in space did. Equal input gives equal reports.
*/
struct Update_report_3
{
  /// finite cells that floating point did not prove positive with legal facets, so that exact
  /// predicates had to look at them.
  std::size_t unproved = 0;
  /// flips: 2-3, 3-2, and two for each 4-4. Flips that are taken back are counted.
  std::size_t flips = 0;
  /// vertices that were held back, so that no cell was inverted.
  std::size_t held = 0;
  /// vertices that were taken out of their cells and inserted elsewhere.
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

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_UPDATE_REPORT_3_H

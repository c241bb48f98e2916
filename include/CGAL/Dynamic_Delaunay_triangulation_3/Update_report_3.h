// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_UPDATE_REPORT_3_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_UPDATE_REPORT_3_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/policies/Update_report_base.h>

#include <cstddef>

namespace CGAL {

/*!
\ingroup PkgDynamicDelaunayTriangulation2Ref

What one update of a triangulation in space did. Equal input gives equal reports.
*/
struct Update_report_3 : Update_report_base
{
  /// finite cells that floating point did not prove positive with legal facets, so that exact
  /// predicates had to look at them.
  std::size_t unproved = 0;
  /// vertices that were held back, so that no cell was inverted.
  std::size_t held = 0;
};

} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_UPDATE_REPORT_3_H

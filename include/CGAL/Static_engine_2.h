// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_STATIC_ENGINE_2_H
#define CGAL_STATIC_ENGINE_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

namespace CGAL {

/*!
\ingroup PkgDynamicDelaunayTriangulation2Ref

Ways to triangulate points that have no triangulation yet (thesis chapter 3). All give a Delaunay
triangulation by exact predicates; where points are cocircular, not always the same one.
*/
enum class Static_engine_2 {
  /// divide and conquer on flat arrays (thesis 3.2; Guibas and Stolfi 1985), cut across both axes
  /// in turn (Dwyer 1987), from which CGAL's structure is written at the end. O(n log n).
  GUIBAS_STOLFI,
  /// CGAL's insertion, point after point in a spatial order, by flips. Expected cost with it: O(n).
  INSERTION,
  /// the same with CGAL's cavities: the faces in conflict with a point make way for a star around
  /// it (thesis 3.1; Bowyer 1981, Watson 1981).
  BOWYER_WATSON
};

/*!
\ingroup PkgDynamicDelaunayTriangulation2Ref

Which engine is used for what.
*/
struct Static_engines_2
{
  /// for the first triangulation and for rebuilds.
  Static_engine_2 whole = Static_engine_2::GUIBAS_STOLFI;
  /// for the regions of border splices.
  Static_engine_2 region = Static_engine_2::GUIBAS_STOLFI;
};

} // namespace CGAL

#endif // CGAL_STATIC_ENGINE_2_H

// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_POLICIES_STATIC_ENGINE_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_POLICIES_STATIC_ENGINE_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

namespace CGAL {

/*!
\ingroup PkgDynamicDelaunayTriangulation2Ref

The algorithms that triangulate points from scratch (thesis chapter 3). Each yields a Delaunay
triangulation, by exact predicates. Where points are cocircular, their results may differ.
*/
enum class Static_engine_2 {
  /// divide and conquer on flat arrays (thesis 3.2; Guibas and Stolfi 1985), with cuts across both
  /// axes in turn (Dwyer 1987). The data structure takes the faces over at the end. O(n log n).
  GUIBAS_STOLFI,
  /// CGAL's insertion of one point after the other, in a spatial order, by flips. Expected cost in
  /// that order: O(n).
  INSERTION,
  /// CGAL's insertion of one point after the other, in the same order, by cavities: the faces in
  /// conflict with a point are replaced by a star around it (thesis 3.1; Bowyer 1981, Watson 1981).
  BOWYER_WATSON
};

/*!
\ingroup PkgDynamicDelaunayTriangulation2Ref

The engines for whole triangulations and for regions.
*/
struct Static_engines_2
{
  /// for the first triangulation and for rebuilds.
  Static_engine_2 whole = Static_engine_2::GUIBAS_STOLFI;
  /// for the regions of border splices.
  Static_engine_2 region = Static_engine_2::GUIBAS_STOLFI;
};

} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_POLICIES_STATIC_ENGINE_2_H

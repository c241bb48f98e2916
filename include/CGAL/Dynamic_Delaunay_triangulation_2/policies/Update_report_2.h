// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_POLICIES_UPDATE_REPORT_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_POLICIES_UPDATE_REPORT_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/policies/Update_report_base.h>

#include <cstddef>

namespace CGAL {

/*!
\ingroup PkgDynamicDelaunayTriangulation2Ref

What one update did. Equal input and settings give equal reports.
*/
struct Update_report_2 : Update_report_base
{
  /// vertices that the classifier picked; where a frame was taken in steps
  /// (`Hold_and_flip_repair_2`), those of the last step.
  std::size_t classified = 0;
  /// vertices in the layers of padding around the classified ones (border splice only).
  std::size_t padded = 0;
  /// vertices in the layer beyond the padding (border splice only).
  std::size_t border = 0;
  /// border splices: regions triangulated anew and put in place of the old ones.
  std::size_t splices = 0;
  /// vertices of spliced regions, borders included; a vertex of several regions is counted in each.
  std::size_t spliced = 0;
  /// enlargements of regions, because the boundaries of old and new faces disagreed.
  std::size_t enlargements = 0;

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

// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_REPAIRS_REBUILD_REPAIR_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_REPAIRS_REBUILD_REPAIR_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/policies/Update_report_2.h>

namespace CGAL {

/*!
\ingroup PkgDynamicDelaunayTriangulation2Repairs

Rebuilds the triangulation whenever anything is classified: like a static triangulation, except in
frames in which nothing broke.

\cgalModels{DelaunayRepair_2}
*/
class Rebuild_repair_2
{
public:
  /// repairs.
  template <class Mender>
  void operator()(Mender& mender) const
  {
    mender.rebuild(Rebuild_reason_2::REPAIR);
  }
};

} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_REPAIRS_REBUILD_REPAIR_2_H

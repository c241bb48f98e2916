// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_REPAIRS_RELOCATION_REPAIR_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_REPAIRS_RELOCATION_REPAIR_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

namespace CGAL {

/*!
\ingroup PkgDynamicDelaunayTriangulation2Repairs

Whenever anything is classified, lets CGAL's `Delaunay_triangulation_2::move_if_no_collision()` move
every vertex that has moved, one after the other. CGAL's function needs a Delaunay triangulation
before and after each single move. So the repair works on a copy, with the vertices at their last
positions, and moving only the classified vertices is not enough. In periodic space the classified
vertices are taken out and inserted anew instead.

If memory runs out, the triangulation keeps its edges, and is not certified.

\cgalModels{DelaunayRepair_2}
*/
class Relocation_repair_2
{
public:
  /// repairs.
  template <class Mender>
  void operator()(Mender& mender) const
  {
    mender.relocate();
  }
};

} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_REPAIRS_RELOCATION_REPAIR_2_H

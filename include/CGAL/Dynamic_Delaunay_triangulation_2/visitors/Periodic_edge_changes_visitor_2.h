// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_VISITORS_PERIODIC_EDGE_CHANGES_VISITOR_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_VISITORS_PERIODIC_EDGE_CHANGES_VISITOR_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/visitors/Delaunay_update_visitor_base_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/visitors/Periodic_edge_changes_base.h>
#include <CGAL/Periodic_shift_2.h>

namespace CGAL {

/*!
\ingroup PkgDynamicDelaunayTriangulation2Periodic

Lists the edges that were created and removed since `clear()` was last called, or since the visitor
was constructed. An edge that was removed and created again in between is in neither list. In a
tissue or a foam these are the neighbor exchanges (T1 events): one removed and one created edge for
each.

All shifts, also those of removed edges, are for the present positions and the present cell: a point
that is wrapped, or a cell that is exchanged for another one of the same lattice, changes no edge.

Cost: proportional to the number of changes; a call that triangulates everything anew counts as all
edges. Asking for the lists costs that number times its logarithm.

\cgalModels{PeriodicUpdateVisitor_2}
*/
class Periodic_edge_changes_visitor_2
  : public Periodic_edge_changes_base<Delaunay_update_visitor_base_2, Periodic_shift_2>
{
};

} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_VISITORS_PERIODIC_EDGE_CHANGES_VISITOR_2_H

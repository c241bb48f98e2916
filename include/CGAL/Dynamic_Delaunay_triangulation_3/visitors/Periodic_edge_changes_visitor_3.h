// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_VISITORS_PERIODIC_EDGE_CHANGES_VISITOR_3_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_VISITORS_PERIODIC_EDGE_CHANGES_VISITOR_3_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/visitors/Periodic_edge_changes_base.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/Periodic_shift_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/visitors/Delaunay_update_visitor_base_3.h>

namespace CGAL {

/*!
\ingroup PkgDynamicDelaunayTriangulation2Periodic

Lists the edges of periodic space that were created and removed since `clear()` was last called, or
since the visitor was constructed. An edge that was removed and created again in between is in
neither list. In a glass or a foam these are the exchanges of neighbors.

All shifts, also those of removed edges, are for the present positions and the present cell: a point
that is wrapped, or a cell that is exchanged for another one of the same lattice, changes no edge.

Cost: proportional to the number of changes, times its logarithm; a rebuild counts as the edges that
differ.
*/
class Periodic_edge_changes_visitor_3
  : public Periodic_edge_changes_base<Delaunay_update_visitor_base_3, Periodic_shift_3>
{
};

} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_VISITORS_PERIODIC_EDGE_CHANGES_VISITOR_3_H

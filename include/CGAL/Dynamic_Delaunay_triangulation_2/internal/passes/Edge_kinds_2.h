// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_PASSES_EDGE_KINDS_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_PASSES_EDGE_KINDS_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Flat_arrays.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Flat_elements_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Points_2.h>

#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

// The condition at an edge depends on which of its four vertices is infinite, if any. Calls
//   inner()               if none is;
//   hull_edge(a, b, c)    if the edge goes from b to c, and its only finite face is (a, b, c);
//   hull_corner(p, q, r)  if the edge goes from q to infinity, and the hull from p through q to r.
template <class Inner, class Hull_edge, class Hull_corner>
auto by_kind(const Edge_2& edge, const Inner& inner, const Hull_edge& hull_edge,
             const Hull_corner& hull_corner)
{
  if (edge.left == infinite_index)
    return hull_edge(edge.right, edge.target, edge.source);
  if (edge.right == infinite_index)
    return hull_edge(edge.left, edge.source, edge.target);
  if (edge.source == infinite_index)
    return hull_corner(edge.left, edge.target, edge.right);
  if (edge.target == infinite_index)
    return hull_corner(edge.right, edge.source, edge.left);
  return inner();
}

inline bool is_at_infinity(const Edge_2& edge)
{
  return edge.source == infinite_index || edge.target == infinite_index ||
         edge.left == infinite_index || edge.right == infinite_index;
}

// True if an edge at infinity has a finite face that is not counterclockwise, or a finite end at
// which the hull turns right. False for all other edges.
inline bool breaks_hull(const Edge_2& edge, const Position_vector& positions)
{
  const auto orientation = [&](Vertex_index p, Vertex_index q, Vertex_index r) {
    return cross(positions[q] - positions[p], positions[r] - positions[p]);
  };
  return by_kind(
      edge, [] { return false; },
      [&](Vertex_index a, Vertex_index b, Vertex_index c) { return !(orientation(a, b, c) > 0); },
      [&](Vertex_index p, Vertex_index q, Vertex_index r) { return !(orientation(p, q, r) >= 0); });
}

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_PASSES_EDGE_KINDS_2_H

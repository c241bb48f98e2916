// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_SPACE_CHECKPOINT_ARRAYS_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_SPACE_CHECKPOINT_ARRAYS_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Flat_arrays.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Flat_elements_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/static/Flat_faces_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/topology/Point_ids_2.h>

#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

// What a checkpoint keeps of a maintained triangulation: everything that can influence the next
// update, except for the state of classifiers, repairs and policies.
template <class Point>
struct Checkpoint_arrays_2
{
  bool positions_are_exact = true;
  std::vector<Point> points;         // of all finite vertices
  std::vector<Position_2> positions; // of these points, as doubles; empty for a torus
  Point_ids_2<Point> ids;

  // Empty if the points do not span the plane: then every frame is triangulated from scratch.
  Flat_faces_2 faces;
  // Half-edges by their numbers in the arrays.
  std::vector<Halfedge_index> corners;                  // of each vertex the one that the arrays store
  Column<Edge_index, Halfedge_index> forward_halfedges; // of each edge the one from its source to its target
  Column<Edge_index, Halfedge_index> halfedges;         // of each edge the stored one; of a torus its twin
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_SPACE_CHECKPOINT_ARRAYS_2_H

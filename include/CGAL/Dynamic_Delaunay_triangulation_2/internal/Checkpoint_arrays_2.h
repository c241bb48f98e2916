// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_CHECKPOINT_ARRAYS_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_CHECKPOINT_ARRAYS_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Flat_faces_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Neighborhood_mirror_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Point_ids_2.h>

#include <vector>

namespace CGAL {
namespace Dynamic_Delaunay_triangulations_2 {
namespace internal {

// Half-edges and faces by their numbers in the mirror.
struct Checkpoint_edge_2
{
  Index forward;  // from the edge's source to its target
  Index halfedge; // that the mirror names first: this one or its twin
};
struct Checkpoint_corner_2
{
  Index halfedge; // that the mirror names
  Index face;     // that CGAL's vertex names
};

// What a checkpoint keeps of a maintained triangulation: all that may make a difference to the next
// update, but what classifiers, repairs and policies remember.
template <class Point>
struct Checkpoint_arrays_2
{
  bool positions_are_exact = true;
  std::vector<Point> points;         // of each vertex but the infinite one
  std::vector<Position_2> positions; // the same
  Point_ids_2<Point> ids;

  // None at all if the points do not span the plane: then that is triangulated anew in every frame.
  Flat_faces_2 faces;
  std::vector<Checkpoint_corner_2> corners; // of each vertex
  std::vector<Checkpoint_edge_2> edges;
};

} // namespace internal
} // namespace Dynamic_Delaunay_triangulations_2
} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_CHECKPOINT_ARRAYS_2_H

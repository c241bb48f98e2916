// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_TOPOLOGY_CHANGE_LOG_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_TOPOLOGY_CHANGE_LOG_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Flat_arrays.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Renumbering.h>

#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

// The changes since the classifier was last told: everything is new, or some edges are.
struct Change_log_2
{
  bool everything_is_new = true;
  std::vector<Edge_index> new_edges;
  std::vector<Vertex_index> relocated; // vertices put into other faces, or given by another image
  Renumberings renumberings;           // meaningless if everything is new

  void clear()
  {
    everything_is_new = false;
    new_edges.clear();
    relocated.clear();
    renumberings.clear();
  }
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_TOPOLOGY_CHANGE_LOG_2_H

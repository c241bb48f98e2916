// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_TOPOLOGY_TOPOLOGY_PARTS_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_TOPOLOGY_TOPOLOGY_PARTS_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/core/Flat_arrays_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/topology/Halfedge_arrays_2.h>

#include <algorithm>
#include <cstddef>
#include <initializer_list>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

// Parts of a triangulation in which threads can flip edges at the same time: each vertex belongs to
// one part. An edge is *inside* of a part if the vertices of its two faces belong to the part.
//
// Each thread examines edges with both ends in its part, and flips those inside of it. A flip
// replaces two faces whose vertices are all in the part by two such faces. What it changes besides
// is at edges with both ends in the part, their sides: the edge itself, and the twins of both its
// half-edges, one of which may be in a face with a vertex elsewhere. And the corners of vertices of
// the part. So what is at edges with both ends in a part, and in faces with all vertices there,
// changes by this part alone; the vertices of other faces, and what is at other edges, never.
// Nothing else is read where edges are examined, or where a walk goes around a vertex of the part.
//
// In periodic space, edges whose corners have different shifts stand in the arrays with infinite
// vertices alone. They are inside of no part. At the others all shifts of both faces are zero, as
// those of first corners are. So flips inside of parts change no shifts, and an edge at the side of
// such faces has corners with different shifts before as after.
//
// Parts are ranges of numbers, which are close in space as long as numbers follow a curve. Those of
// vertices do so longer than those of faces, which every flip moves.
class Topology_parts_2
{
public:
  Topology_parts_2(const Halfedge_arrays_2& arrays, std::size_t vertices, std::size_t parts)
    : m_arrays(arrays)
    , m_vertices((vertices + parts - 1) / parts)
  {
  }

  // The part of one of the vertices of edge e.
  std::size_t part_of(Edge_index e) const { return m_arrays.edge(e).source / m_vertices; }

  bool is_inside(std::size_t part, Edge_index e) const
  {
    const Edge_2& edge = m_arrays.edge(e);
    return edge.source != edge.target && has_vertex(part, edge.source) &&
           has_vertex(part, edge.target) && has_vertex(part, edge.left) &&
           has_vertex(part, edge.right);
  }

  bool has_all(std::size_t part, std::initializer_list<Index> vertices) const
  {
    return std::all_of(vertices.begin(), vertices.end(),
                       [&](Vertex_index v) { return has_vertex(part, v); });
  }

  // For a pass over a list of edges that asks part_of() and is_inside().
  void prefetch_some(const std::vector<Index>& edges, std::size_t i) const
  {
    constexpr std::size_t ahead = 16;
    if (i + ahead < edges.size())
      m_arrays.prefetch_edge(edges[i + ahead]);
  }

private:
  bool has_vertex(std::size_t part, Vertex_index v) const
  {
    return v - part * m_vertices < m_vertices; // false if v is smaller: nothing is signed
  }

  const Halfedge_arrays_2& m_arrays;
  const std::size_t m_vertices; // of a part
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_TOPOLOGY_TOPOLOGY_PARTS_2_H

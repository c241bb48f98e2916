// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_TOPOLOGY_PARTS_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_TOPOLOGY_PARTS_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Flat_arrays_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Neighborhood_mirror_2.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Dynamic_Delaunay_triangulations_2 {
namespace internal {

// Parts of a triangulation in which threads can flip edges at the same time: each vertex belongs to
// one part. A face belongs to the part of its three vertices, or, if these are of several parts, to
// none. An edge between two faces of a part is *inside* of it.
//
// A flip *stays inside* of a part if its edge and the four sides of its two faces are inside. Then
// all that it changes, half-edges, edges and corners of vertices, is that of six faces and four
// vertices of this part, and the two new faces belong to the part as well. A face that belongs to
// none never changes. A neighbor of a face of a part shares two vertices with it, so it belongs to
// the same part or to none, as does every face around a vertex of the part. So a thread that
// examines edges inside of its part, walks around vertices of it, and makes flips that stay inside
// reads nothing that others write.
//
// Parts are ranges of numbers, which are close in space as long as numbers follow a curve. Those of
// vertices do so longer than those of faces, which every flip moves.
class Topology_parts_2
{
public:
  Topology_parts_2(const Neighborhood_mirror_2& mirror, std::size_t vertices, std::size_t parts)
    : m_mirror(mirror)
    , m_vertices((vertices + parts - 1) / parts)
  {
  }

  // The part of one of the vertices of edge e.
  std::size_t part_of(Index e) const { return m_mirror.edge(e).source / m_vertices; }

  bool is_inside(std::size_t part, Index e) const
  {
    const Edge_2& edge = m_mirror.edge(e);
    return has_vertex(part, edge.source) && has_vertex(part, edge.target) &&
           has_vertex(part, edge.left) && has_vertex(part, edge.right);
  }

  // Whether the flip of half-edge h, whose edge is inside, stays inside.
  bool stays_inside(std::size_t part, Index h) const
  {
    const auto is_side_inside = [&](Index side) {
      return has_vertex(part, m_mirror.apex(m_mirror.twin(side)));
    };
    const auto are_sides_inside = [&](Index k) {
      return is_side_inside(Neighborhood_mirror_2::next(k)) &&
             is_side_inside(Neighborhood_mirror_2::previous(k));
    };
    return are_sides_inside(h) && are_sides_inside(m_mirror.twin(h));
  }

  // For a pass over a list of edges that asks part_of() and is_inside().
  void prefetch_some(const std::vector<Index>& edges, std::size_t i) const
  {
    constexpr std::size_t ahead = 16;
    if (i + ahead < edges.size())
      m_mirror.prefetch_edge(edges[i + ahead]);
  }

private:
  bool has_vertex(std::size_t part, Index v) const
  {
    return v - part * m_vertices < m_vertices; // false if v is smaller: nothing is signed
  }

  const Neighborhood_mirror_2& m_mirror;
  const std::size_t m_vertices; // of a part
};

} // namespace internal
} // namespace Dynamic_Delaunay_triangulations_2
} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_TOPOLOGY_PARTS_2_H

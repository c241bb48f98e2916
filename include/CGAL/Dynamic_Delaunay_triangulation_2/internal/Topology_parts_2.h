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

// Parts of a triangulation in which threads can flip edges at the same time: each face belongs to
// one part, each vertex, too, and an edge between two faces of a part is *inside* of it.
//
// A flip *stays inside* of a part if its edge and the four sides of its two faces are inside. Then
// all half-edges and edges that it changes are those of six faces of this part, and edges that were
// inside stay so. Nothing of an edge between two parts ever changes. So a thread that examines
// edges inside of its part, and makes flips that stay inside, reads nothing that others write. Two
// threads may meet only where a vertex names one of its corners: the part of the vertex writes that
// at once, others when all parts are done.
//
// Parts are ranges of numbers, which are close in space as long as numbers follow a curve.
class Topology_parts_2
{
public:
  Topology_parts_2(const Neighborhood_mirror_2& mirror, std::size_t vertices, std::size_t parts)
    : m_mirror(mirror)
    , m_halfedges(3 * size_of_part(mirror.number_of_faces(), parts))
    , m_vertices(size_of_part(vertices, parts))
  {
  }

  // The part of one of the faces at edge e.
  std::size_t part_of(Index e) const { return m_mirror.halfedge(e) / m_halfedges; }

  bool is_inside(std::size_t part, Index e) const
  {
    const Index h = m_mirror.halfedge(e);
    return has_halfedge(part, h) && has_halfedge(part, m_mirror.twin(h));
  }

  bool stays_inside(std::size_t part, Index h) const
  {
    const auto has_twin = [&](Index side) { return has_halfedge(part, m_mirror.twin(side)); };
    const auto has_sides = [&](Index k) {
      return has_halfedge(part, k) && has_twin(Neighborhood_mirror_2::next(k)) &&
             has_twin(Neighborhood_mirror_2::previous(k));
    };
    return has_sides(h) && has_sides(m_mirror.twin(h));
  }

  // Whether the vertices opposite to half-edge h are proved to have no other edge between them.
  // Walks around both, as `Neighborhood_mirror_2::are_apexes_neighbors()` does, but only inside.
  bool proves_apart(std::size_t part, Index h) const
  {
    using Mirror = Neighborhood_mirror_2;
    const Index g = m_mirror.twin(h);
    const Index v = m_mirror.apex(h), w = m_mirror.apex(g);
    Index i = m_mirror.next_corner(h), k = m_mirror.next_corner(g);
    for (; i != h && k != g; i = m_mirror.next_corner(i), k = m_mirror.next_corner(k))
      if (!has_halfedge(part, i) || !has_halfedge(part, k) || m_mirror.apex(Mirror::next(i)) == w ||
          m_mirror.apex(Mirror::next(k)) == v)
        return false;
    return true;
  }

  // For a pass over a list of edges that asks part_of() and is_inside().
  void prefetch_some(const std::vector<Index>& edges, std::size_t i) const
  {
    constexpr std::size_t ahead = 8;
    if (i + 2 * ahead < edges.size())
      m_mirror.prefetch_edge(edges[i + 2 * ahead]);
    if (i + ahead < edges.size())
      m_mirror.prefetch_face_at(edges[i + ahead]);
  }

  bool has_vertex(std::size_t part, Index v) const { return v - part * m_vertices < m_vertices; }

private:
  static std::size_t size_of_part(std::size_t size, std::size_t parts)
  {
    return (size + parts - 1) / parts;
  }

  bool has_halfedge(std::size_t part, Index h) const
  {
    return h - part * m_halfedges < m_halfedges; // false if h is smaller: nothing is signed
  }

  const Neighborhood_mirror_2& m_mirror;
  const std::size_t m_halfedges, m_vertices; // of a part
};

} // namespace internal
} // namespace Dynamic_Delaunay_triangulations_2
} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_TOPOLOGY_PARTS_2_H

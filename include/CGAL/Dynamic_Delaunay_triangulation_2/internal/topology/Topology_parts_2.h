// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_TOPOLOGY_TOPOLOGY_PARTS_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_TOPOLOGY_TOPOLOGY_PARTS_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Flat_arrays.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Flat_elements_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/topology/Halfedge_arrays_2.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

// Parts of a triangulation in which threads can flip edges at the same time. Each vertex belongs to
// one part. An edge is *inside* of a part if all vertices of its two faces belong to the part.
//
// Each thread examines edges with both ends in its part, and flips those inside of it. A flip
// replaces two faces whose vertices are all in the part by two such faces. It also writes the
// corners of these vertices and, at the four sides of the faces, the edge and the twins of both
// half-edges, one of which may be in a face with a vertex elsewhere. The ends of the sides are in
// the part. So only one part changes the data at edges with both ends in it, and in faces with all
// vertices in it. The vertices of other faces, and the data at other edges, do not change at all.
// To examine edges, or to walk around a vertex of the part, a thread reads nothing else.
//
// In periodic space, the arrays show an edge whose corners have different shifts with infinite
// vertices only, so it is inside of no part. At any other edge the shifts of both faces are all
// zero, because a face's first corner has shift zero. So flips inside of parts change no shifts,
// and do not change whether the corners of a side have different shifts.
//
// A thread may also move the vertices of its part that have all their neighbors there. No other
// thread reads their positions: a vertex of an edge with both ends in another part has these ends
// as neighbors, and flips inside of parts do not change which vertices of two parts are neighbors.
//
// Vertices belong to parts by blocks of consecutive numbers. These are close in space as long as
// the numbers follow a space-filling curve, which face numbers do for a shorter time, because every
// flip moves faces. In the first division of a triangulation, parts are ranges of numbers. In a
// second one they are others, so that what the first one leaves between parts is inside of them.
class Topology_parts_2
{
public:
  Topology_parts_2(const Halfedge_arrays_2& arrays, std::size_t vertices, std::size_t parts)
    : m_arrays(arrays)
    , m_number(parts)
    , m_vertices(vertices)
  {
    while (vertices >> m_digits >= max_blocks)
      ++m_digits;
    m_blocks = (vertices >> m_digits) + 1;
    for (std::size_t block = 0; block < m_blocks; ++block)
      m_part[block] = std::uint8_t(block * parts / m_blocks);
  }

  // As many parts as suit the size of a triangulation, which alone decides: so equal input gives
  // equal results on any number of threads. Larger parts leave fewer edges between parts.
  template <class State>
  explicit Topology_parts_2(const State& state)
    : Topology_parts_2(state.arrays(), state.positions().size(), usual_number(state))
  {
  }

  // So many other parts: part_of(v) is that of the block whose middle vertex is v. Threads share
  // the calls, each of which reads a position from memory.
  template <class Parts, class Part_of>
  Topology_parts_2 divided_anew(std::size_t parts, const Part_of& part_of) const
  {
    Topology_parts_2 other(*this);
    other.m_number = parts;
    Parts::for_each_element(m_blocks, Parts::size_for(64), [&](std::size_t block) {
      const std::size_t middle = (block << m_digits) + (std::size_t(1) << m_digits) / 2;
      other.m_part[block] = std::uint8_t(part_of(Vertex_index((std::min)(middle, m_vertices - 1))));
    });
    return other;
  }

  static constexpr std::size_t max_number = 32;

  std::size_t number() const { return m_number; }

  // Whether threads would gain by sharing so many pieces of work.
  template <class State>
  static bool are_worth(const State& state, std::size_t pieces)
  {
    using Parts = typename State::Parts;
    const std::size_t number = usual_number(state);
    return number >= Parts::least_shared && pieces > 0 &&
           pieces >= number * (Parts::usual_size / 256);
  }

  std::size_t part_of(Vertex_index v) const { return m_part[v >> m_digits]; }

  // Returns the part of the source of edge e.
  std::size_t part_of(Edge_index e) const { return part_of(m_arrays.edge(e).source); }

  bool is_inside(std::size_t part, Edge_index e) const
  {
    const Edge_2& edge = m_arrays.edge(e);
    return edge.source != edge.target && has_vertex(part, edge.source) &&
           has_vertex(part, edge.target) && has_vertex(part, edge.left) &&
           has_vertex(part, edge.right);
  }

  // Prefetches a later edge of the list, for a pass that calls part_of() and is_inside().
  void prefetch_some(const std::vector<Edge_index>& edges, std::size_t i) const
  {
    constexpr std::size_t ahead = 16;
    if (i + ahead < edges.size())
      m_arrays.prefetch_edge(edges[i + ahead]);
  }

  // Whether v and its finite neighbors belong to the part.
  bool has_star(std::size_t part, Vertex_index v) const
  {
    bool has = has_vertex(part, v);
    if (has)
      m_arrays.for_each_neighbor(
          v, [&](Vertex_index w) { has = has && (w == infinite_index || has_vertex(part, w)); });
    return has;
  }

private:
  template <class State>
  static std::size_t usual_number(const State& state)
  {
    return (std::min)(State::Parts::number(state.arrays().number_of_faces()), max_number);
  }

  bool has_vertex(std::size_t part, Vertex_index v) const { return part_of(v) == part; }

  static constexpr std::size_t max_blocks = 1 << 10;

  const Halfedge_arrays_2& m_arrays;
  std::size_t m_number;
  const std::size_t m_vertices;
  std::size_t m_blocks;
  unsigned m_digits = 0;                         // below those of a vertex's block
  std::array<std::uint8_t, max_blocks> m_part{}; // of each block
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_TOPOLOGY_TOPOLOGY_PARTS_2_H

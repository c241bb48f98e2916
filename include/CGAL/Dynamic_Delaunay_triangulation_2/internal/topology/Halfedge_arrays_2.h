// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_TOPOLOGY_HALFEDGE_ARRAYS_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_TOPOLOGY_HALFEDGE_ARRAYS_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Flat_arrays.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Processor.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Flat_elements_2.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Dynamic_Delaunay_triangulations_2 {

namespace internal {

// The topology of a triangulation in flat arrays, without positions.
//
// Vertex 0 is the infinite one. Its position is NaN, so that every comparison with it fails and
// passes over all edges need no branch for the hull. Half-edge 3f+i is the edge of face f opposite
// to its i-th vertex.
//
// The editor and the builders give numbers to edges, and store true corners of vertices. After
// CGAL's algorithms have written, and in dimensions below 2, there are no edges; see
// `Indexed_storage_2`. `Writable_halfedge_arrays_2` writes.
class Halfedge_arrays_2
{
public:
  // Without comparisons, for which compilers write branches that processors cannot predict.
  static Halfedge_index next(Halfedge_index h) { return Halfedge_index(h + 1 - 3 * (h % 3 / 2)); }
  static Halfedge_index previous(Halfedge_index h)
  {
    return Halfedge_index(h + 2 - 3 * ((h % 3 + 1) / 2));
  }
  static Face_index face_of(Halfedge_index h) { return Face_index(h / 3); }
  // The half-edge opposite to the i-th vertex of face f; and the i of half-edge h.
  static Halfedge_index halfedge_in(Face_index f, Index i) { return Halfedge_index(3 * f + i); }
  static Index number_in_face(Halfedge_index h) { return h % 3; }
  static std::array<Halfedge_index, 3> halfedges_of(Face_index f)
  {
    return {halfedge_in(f, 0), halfedge_in(f, 1), halfedge_in(f, 2)};
  }

  // Counts the infinite vertex, too.
  Index number_of_vertices() const { return Index(m_corner.size()); }
  // 0 unless edges have numbers.
  Index number_of_faces() const { return m_edges.empty() ? 0 : faces_with_holes(); }
  Index number_of_halfedges() const { return 3 * number_of_faces(); }
  Index number_of_edges() const { return Index(m_edges.size()); }

  // The vertex opposite to half-edge h: vertex number_in_face(h) of its face.
  Vertex_index apex(Halfedge_index h) const { return m_halfedges[h].apex; }
  Vertex_index source(Halfedge_index h) const { return apex(next(h)); }
  Vertex_index target(Halfedge_index h) const { return apex(previous(h)); }
  Halfedge_index twin(Halfedge_index h) const { return m_halfedges[h].twin; }
  Edge_index edge_of(Halfedge_index h) const { return m_halfedges[h].edge; }
  Halfedge_index halfedge(Edge_index edge) const { return m_halfedge_of_edge[edge]; }
  const Edge_2& edge(Edge_index e) const { return m_edges[e]; }
  const std::vector<Edge_2>& edges() const { return m_edges; }
  std::array<Vertex_index, 3> face(Face_index f) const
  {
    return {apex(halfedge_in(f, 0)), apex(halfedge_in(f, 1)), apex(halfedge_in(f, 2))};
  }

  // Prefetch the data for a flip of edge e: edge(e) and halfedge(e), then the two faces at e, then
  // what the flip changes around these faces. Call the functions in this order, with some time
  // between them: each one reads what the one before has fetched.
  void prefetch_edge(Edge_index e) const
  {
    prefetch(&m_edges[e]);
    prefetch(&m_halfedge_of_edge[e]);
  }
  void prefetch_face_at(Edge_index e) const { prefetch_face(halfedge(e)); }
  void prefetch_face_beyond(Edge_index e) const { prefetch_face(twin(halfedge(e))); }
  void prefetch_around(Edge_index e) const
  {
    for (const Halfedge_index h : {halfedge(e), twin(halfedge(e))}) {
      const Halfedge_index side = next(h);
      prefetch(&m_edges[edge_of(side)]);
      prefetch(&m_edges[edge_of(previous(h))]);
      prefetch(&m_halfedge_of_edge[edge_of(side)]);
      prefetch(&m_halfedges[twin(side)]);
      prefetch(&m_corner[apex(side)]);
    }
  }
  void prefetch_face(Halfedge_index h) const
  {
    prefetch(&m_halfedges[halfedge_in(face_of(h), 0)]);
    prefetch(&m_halfedges[halfedge_in(face_of(h), 2)].edge);
  }
  // Calls f(s) for the four other edges s of the two faces at edge e.
  template <class Function>
  void for_each_side(Edge_index e, Function&& f) const
  {
    for (const Halfedge_index h : {halfedge(e), twin(halfedge(e))}) {
      f(edge_of(next(h)));
      f(edge_of(previous(h)));
    }
  }

  // A corner of v: a half-edge whose apex is v.
  Halfedge_index corner(Vertex_index v) const { return m_corner[v]; }
  // The corner of the same vertex in the next face counterclockwise.
  Halfedge_index next_corner(Halfedge_index h) const { return next(twin(next(h))); }
  Halfedge_index previous_corner(Halfedge_index h) const { return previous(twin(previous(h))); }

  // Calls f(corner) for every face at v, counterclockwise.
  template <class Function>
  void for_each_corner(Vertex_index v, Function&& f) const
  {
    const Halfedge_index first = m_corner[v];
    Halfedge_index h = first;
    do {
      f(h);
      h = next_corner(h);
    } while (h != first);
  }

  // Calls f(w) for every neighbor w of v, counterclockwise, the infinite vertex among them.
  template <class Function>
  void for_each_neighbor(Vertex_index v, Function&& f) const
  {
    for_each_corner(v, [&](Halfedge_index h) { f(apex(next(h))); });
  }

  // Calls f(e) for every edge e whose test depends on the position of v: those to which v is
  // opposite, and those at v.
  template <class Function>
  void for_each_edge_that_sees(Vertex_index v, Function&& f) const
  {
    for_each_corner(v, [&](Halfedge_index h) {
      f(edge_of(h));
      f(edge_of(previous(h)));
    });
  }

  // The number of edges at v.
  Index degree(Vertex_index v) const
  {
    Index degree = 0;
    for_each_corner(v, [&](Halfedge_index) { ++degree; });
    return degree;
  }

  // Whether the apexes of h and of its twin are neighbors in any face but the two at h. Walks
  // around both apexes in step, because one of them may have many neighbors, like the infinite
  // vertex; and in both directions, because it then waits for memory half as often.
  bool are_apexes_neighbors(Halfedge_index h) const
  {
    const Halfedge_index g = twin(h);
    const Vertex_index a = apex(h), d = apex(g);
    Halfedge_index i = next_corner(h), j = previous_corner(h);
    Halfedge_index k = next_corner(g), l = previous_corner(g);
    while (true) {
      if (apex(next(i)) == d || apex(next(j)) == d || apex(next(k)) == a || apex(next(l)) == a)
        return true;
      if (i == j || k == l)
        return false;
      i = next_corner(i);
      k = next_corner(k);
      if (i == j || k == l)
        return false;
      j = previous_corner(j);
      l = previous_corner(l);
    }
  }

  // Whether an edge joins v and w. Walks around both in step, as are_apexes_neighbors() does.
  bool are_neighbors(Vertex_index v, Vertex_index w) const
  {
    Halfedge_index i = corner(v), k = corner(w);
    do {
      if (apex(next(i)) == w || apex(next(k)) == v)
        return true;
      i = next_corner(i);
      k = next_corner(k);
    } while (i != corner(v) && k != corner(w));
    return false;
  }

  // VERTICES OUTSIDE OF ALL FACES -------------------------------------------------------------
  //
  // A vertex that is taken out of its faces keeps a *slot*: its own number, and the numbers of two
  // faces and three edges that are no longer needed. These faces and edges are empty until a vertex
  // is put in with them, or until the last faces and edges take their numbers.

  struct Slot
  {
    Vertex_index vertex;
    std::array<Face_index, 2> faces;
    std::array<Edge_index, 3> edges;
  };

  Index faces_with_holes() const { return Index(m_halfedges.size() / 3); }

  bool is_outside(Vertex_index v) const { return m_corner[v] == null_index; }
  bool is_empty_face(Face_index f) const { return apex(halfedge_in(f, 0)) == null_index; }
  bool is_empty_edge(Edge_index e) const { return m_halfedge_of_edge[e] == null_index; }
  // Whether edge(e) has no vertices but the infinite one; see hide_edge().
  bool is_hidden(Edge_index e) const { return m_edges[e].source == infinite_index; }

protected:
  // The data of a face's three half-edges are contiguous, because they are needed together.
  struct Halfedge
  {
    Vertex_index apex;
    Halfedge_index twin;
    Edge_index edge;
  };

  Uninitialized_column<Halfedge_index, Halfedge> m_halfedges;
  Column<Edge_index, Edge_2> m_edges;
  Uninitialized_column<Edge_index, Halfedge_index> m_halfedge_of_edge;
  Uninitialized_column<Vertex_index, Halfedge_index> m_corner;
};

} // namespace internal
} // namespace Dynamic_Delaunay_triangulations_2
} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_TOPOLOGY_HALFEDGE_ARRAYS_2_H

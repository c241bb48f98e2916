// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_NEIGHBORHOOD_MIRROR_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_NEIGHBORHOOD_MIRROR_2_H

#include <CGAL/assertions.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Prefetch_2.h>

#include <array>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Dynamic_Delaunay_triangulations_2 {

/// Index of a vertex, a half-edge, an edge or a face in the flat arrays.
using Index = std::uint32_t;

/// The coordinates of a vertex in the flat arrays: exact where the kernel's coordinates are
/// doubles, the nearest doubles elsewhere.
struct Position_2
{
  double x, y;
};

/// An edge with its two opposite vertices: (left, source, target) and (right, target, source) are
/// the two faces at the edge, both counterclockwise.
struct Edge_2
{
  Index source, target, left, right;
};

namespace internal {

constexpr Index infinite_index = 0;
constexpr Index no_index = std::numeric_limits<Index>::max();

// The topology of a two-dimensional CGAL triangulation in flat arrays.
//
// Vertex 0 is the infinite one; its position is NaN, so that every comparison with it fails and the
// passes over all edges need no branch for the hull. Half-edge 3f+i is the edge of face f opposite
// to its i-th vertex, the face's vertices being the CGAL face's own in the same places: face f here
// and the CGAL face f never differ by so much as a rotation.
class Neighborhood_mirror_2
{
public:
  static Index next(Index h) { return h % 3 == 2 ? h - 2 : h + 1; }
  static Index previous(Index h) { return h % 3 == 0 ? h + 2 : h - 1; }
  static Index face_of(Index h) { return h / 3; }

  Index number_of_faces() const { return Index(m_halfedges.size() / 3); }
  Index number_of_edges() const { return Index(m_edges.size()); }

  // The vertex opposite to half-edge h, which is also the i-th vertex of its face.
  Index apex(Index h) const { return m_halfedges[h].apex; }
  Index source(Index h) const { return apex(next(h)); }
  Index target(Index h) const { return apex(previous(h)); }
  Index twin(Index h) const { return m_halfedges[h].twin; }
  Index edge_of(Index h) const { return m_halfedges[h].edge; }
  Index halfedge(Index edge) const { return m_halfedge_of_edge[edge]; }
  const Edge_2& edge(Index e) const { return m_edges[e]; }
  const std::vector<Edge_2>& edges() const { return m_edges; }
  std::array<Index, 3> face(Index f) const
  {
    return {apex(3 * f), apex(3 * f + 1), apex(3 * f + 2)};
  }

  // For a flip of edge e, in steps: each reads what the one before has asked for. First edge(e) and
  // halfedge(e); then the face at it; then the face beyond; then what the flip changes around the
  // two, one after the other.
  void prefetch_edge(Index e) const
  {
    prefetch(&m_edges[e]);
    prefetch(&m_halfedge_of_edge[e]);
  }
  void prefetch_face_at(Index e) const { prefetch_face(halfedge(e)); }
  void prefetch_face_beyond(Index e) const { prefetch_face(twin(halfedge(e))); }
  void prefetch_around(Index e) const
  {
    for (const Index h : {halfedge(e), twin(halfedge(e))}) {
      const Index side = next(h);
      prefetch(&m_edges[edge_of(side)]);
      prefetch(&m_edges[edge_of(previous(h))]);
      prefetch(&m_halfedge_of_edge[edge_of(side)]);
      prefetch(&m_halfedges[twin(side)]);
      prefetch(&m_corner[apex(side)]);
    }
  }
  // Calls f(edge) for the edges of the two faces at edge e other than e.
  template <class Function>
  void for_each_side(Index e, Function&& f) const
  {
    for (const Index h : {halfedge(e), twin(halfedge(e))}) {
      f(edge_of(next(h)));
      f(edge_of(previous(h)));
    }
  }

  // A corner of v: a half-edge whose apex is v.
  Index corner(Index v) const { return m_corner[v]; }
  // The corner of the same vertex in the next face counterclockwise.
  Index next_corner(Index h) const { return next(twin(next(h))); }

  // Calls f(corner) for every face at v, counterclockwise.
  template <class Function>
  void for_each_corner(Index v, Function&& f) const
  {
    const Index first = m_corner[v];
    Index h = first;
    do {
      f(h);
      h = next_corner(h);
    } while (h != first);
  }

  // Calls f(w) for every neighbour w of v, counterclockwise, the infinite vertex among them.
  template <class Function>
  void for_each_neighbor(Index v, Function&& f) const
  {
    for_each_corner(v, [&](Index h) { f(apex(next(h))); });
  }

  // Whether the apexes of h and of its twin are neighbours, beyond the two faces.
  bool are_apexes_neighbors(Index h) const
  {
    if (apex(h) == infinite_index)
      h = twin(h); // the star of the infinite vertex is the whole hull
    const Index opposite = apex(twin(h));
    for (Index g = next_corner(h); g != h; g = next_corner(g))
      if (apex(next(g)) == opposite)
        return true;
    return false;
  }

  // The writing part, for the topology editor alone.

  void clear()
  {
    m_halfedges.clear();
    m_edges.clear();
    m_halfedge_of_edge.clear();
    m_corner.clear();
  }

  void resize(Index vertices, Index faces)
  {
    m_corner.assign(vertices + 1, no_index);
    m_halfedges.resize(3 * std::size_t(faces));
    m_edges.resize(3 * std::size_t(faces) / 2);
    m_halfedge_of_edge.resize(3 * std::size_t(faces) / 2);
  }

  void set_apex(Index h, Index v)
  {
    m_halfedges[h].apex = v;
    m_corner[v] = h;
  }

  void set_twin(Index h, Index g) { m_halfedges[h].twin = g; }

  void link(Index h, Index g)
  {
    m_halfedges[h].twin = g;
    m_halfedges[g].twin = h;
  }

  // Makes e the edge of h and of its twin, and reads its four vertices anew.
  void set_edge(Index e, Index h)
  {
    const Index g = twin(h);
    m_halfedges[h].edge = m_halfedges[g].edge = e;
    m_halfedge_of_edge[e] = h;
    m_edges[e] = Edge_2{source(h), target(h), apex(h), apex(g)};
  }

  // Numbers the edges along the faces, so that edges close in space are close in memory. Which
  // half-edge comes first is anybody's guess, so there is no branch on it.
  void number_edges()
  {
    Index edges = 0;
    for (Index h = 0; h < Index(m_halfedges.size()); ++h) {
      const Index g = twin(h);
      const Index number_of_twin = m_halfedges[g].edge;
      const Index e = h < g ? edges : number_of_twin;
      edges += h < g;
      m_halfedges[h].edge = e;
      m_halfedge_of_edge[e] = h;
      m_edges[e] = Edge_2{source(h), target(h), apex(h), apex(g)};
    }
    CGAL_postcondition(edges == number_of_edges());
  }

  // Exchanges the diagonal at half-edge h, vertex by vertex as CGAL's TDS_2::flip(face, i) does:
  // from faces (a, b, c) and (d, c, b) to (a, b, d) and (d, c, a).
  void flip(Index h)
  {
    const Index g = twin(h);
    const Index h_next = next(h), h_previous = previous(h);
    const Index g_next = next(g), g_previous = previous(g);
    const Index a = apex(h), b = apex(h_next), c = apex(h_previous), d = apex(g);
    const Index ab = edge_of(h_previous), bd = edge_of(g_next);
    const Index dc = edge_of(g_previous), ca = edge_of(h_next), diagonal = edge_of(h);

    m_halfedges[h_previous].apex = d;
    m_halfedges[g_previous].apex = a;
    const Index outer_bd = twin(g_next), outer_ca = twin(h_next);
    link(h, outer_bd);
    link(g, outer_ca);
    link(h_next, g_next);
    m_corner[c] = g_next; // whether it has to change or not: a store waits for nothing
    m_corner[b] = h_next;

    m_halfedges[h].edge = bd;
    m_halfedges[g].edge = ca;
    m_halfedges[h_next].edge = m_halfedges[g_next].edge = diagonal;
    m_halfedge_of_edge[bd] = h;
    m_halfedge_of_edge[ca] = g;
    m_halfedge_of_edge[diagonal] = h_next;
    m_edges[diagonal] = Edge_2{d, a, b, c};
    exchange_opposite(ab, c, d);
    exchange_opposite(bd, c, a);
    exchange_opposite(dc, b, a);
    exchange_opposite(ca, b, d);
  }

private:
  void prefetch_face(Index h) const
  {
    prefetch(&m_halfedges[h / 3 * 3]);
    prefetch(&m_halfedges[h / 3 * 3 + 2].edge);
  }

  // The three half-edges of a face stand together: whoever needs one of them needs the others.
  struct Halfedge
  {
    Index apex, twin, edge;
  };

  void exchange_opposite(Index e, Index from, Index to)
  {
    Edge_2& edge = m_edges[e];
    (edge.left == from ? edge.left : edge.right) = to;
  }

  std::vector<Halfedge> m_halfedges;
  std::vector<Edge_2> m_edges;
  std::vector<Index> m_halfedge_of_edge;
  std::vector<Index> m_corner;
};

} // namespace internal
} // namespace Dynamic_Delaunay_triangulations_2
} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_NEIGHBORHOOD_MIRROR_2_H

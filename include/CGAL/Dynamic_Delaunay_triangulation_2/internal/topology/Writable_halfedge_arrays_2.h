// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_TOPOLOGY_WRITABLE_HALFEDGE_ARRAYS_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_TOPOLOGY_WRITABLE_HALFEDGE_ARRAYS_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Flat_arrays.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Renumbering.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Flat_elements_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/topology/Halfedge_arrays_2.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

// The half-edges as the editor and the builders write them. All other code has them as
// `const Halfedge_arrays_2&`.
class Writable_halfedge_arrays_2 : public Halfedge_arrays_2
{
public:
  void drop_edges()
  {
    m_edges.clear();
    m_halfedge_of_edge.clear();
  }

  // After this, resize() throws nothing.
  void reserve(Index vertices, Index faces)
  {
    m_corner.reserve(vertices + std::size_t(1));
    m_halfedges.reserve(3 * std::size_t(faces));
    m_edges.reserve(3 * std::size_t(faces) / 2);
    m_halfedge_of_edge.reserve(3 * std::size_t(faces) / 2);
  }

  void resize(Index vertices, Index faces)
  {
    m_corner.resize(vertices + std::size_t(1));
    m_halfedges.resize(3 * std::size_t(faces));
    m_edges.resize(3 * std::size_t(faces) / 2);
    m_halfedge_of_edge.resize(3 * std::size_t(faces) / 2);
  }

  // Calls f(array) for all arrays.
  template <class Function>
  void for_each_array(const Function& f)
  {
    f(m_halfedges);
    f(m_edges);
    f(m_halfedge_of_edge);
    f(m_corner);
  }

  void set_apex(Halfedge_index h, Vertex_index v)
  {
    m_halfedges[h].apex = v;
    m_corner[v] = h;
  }

  void link(Halfedge_index h, Halfedge_index g)
  {
    m_halfedges[h].twin = g;
    m_halfedges[g].twin = h;
  }

  // Makes e the edge of h and of its twin, and sets its four vertices.
  void set_edge(Edge_index e, Halfedge_index h)
  {
    const Halfedge_index g = twin(h);
    m_halfedges[h].edge = m_halfedges[g].edge = e;
    m_halfedge_of_edge[e] = h;
    m_edges[e] = Edge_2{source(h), target(h), apex(h), apex(g)};
  }

  // Set the half-edge that is stored for edge e, or the corner for vertex v.
  void set_halfedge(Edge_index e, Halfedge_index h) { m_halfedge_of_edge[e] = h; }
  void set_corner(Vertex_index v, Halfedge_index h) { m_corner[v] = h; }

  // WRITING EVERYTHING --------------------------------------------------------------------------

  // Writes all faces, finds the corners and numbers the edges. `apex_and_twin(f, i)` returns those
  // of the i-th half-edge of face f. Threads share the faces. When all are written, one of them
  // calls `companion()`, which may free what was read.
  template <class Parts, class Function, class Companion>
  void write(Index vertices, Index faces, const Function& apex_and_twin, const Companion& companion)
  {
    resize(vertices, faces);
    Parts::for_each_element(faces, [&](std::size_t number) {
      const Face_index f(number);
      for (Index i = 0; i < 3; ++i) {
        const Halfedge_index h = halfedge_in(f, i);
        const auto [apex, twin] = apex_and_twin(f, i);
        m_halfedges[h].apex = apex;
        m_halfedges[h].twin = twin;
      }
    });
    find_corners<Parts>();
    number_edges<Parts>(companion);
  }

  // Finds twins and corners, and numbers the edges, if only the vertices and the neighbors of faces
  // are known, as CGAL's algorithms leave them. If it throws, twins and corners have not changed.
  template <class Parts>
  void number_from_neighbors()
  {
    m_edges.resize(m_halfedges.size() / 2);
    m_halfedge_of_edge.resize(m_halfedges.size() / 2);
    for (Halfedge_index h(0); h < Index(m_halfedges.size()); ++h) {
      for (const Halfedge_index g : halfedges_of(face_of(m_halfedges[h].twin)))
        if (source(g) == target(h)) // and then target(g) == source(h), as neighbors share an edge
          m_halfedges[h].twin = g;
    }
    find_corners<Parts>();
    number_edges<Parts>([] {});
  }

  // Makes the last half-edge with apex v the corner of v. Each part of the half-edges sets the
  // corners of one part of the vertices. Half-edges with other apexes are left over for the parts
  // of these; they are few if faces and vertices are numbered in the same order and the parts are
  // large. The `edge` member of each of them holds the next one, because edges have no numbers yet.
  template <class Parts>
  void find_corners()
  {
    const std::size_t halfedges = m_halfedges.size(), vertices = m_corner.size();
    if (!Parts::are_shared(Parts::number(halfedges))) {
      m_corner[infinite_index] = null_index; // no face of a torus has it
      for (Halfedge_index h(0); h < halfedges; ++h)
        m_corner[apex(h)] = h;
      return;
    }
    constexpr std::size_t most_parts = 16;
    const std::size_t parts = (std::min)(Parts::number(halfedges), most_parts);
    const auto begin = [&](std::size_t part) { return Parts::begin(part, parts, vertices); };
    std::array<std::array<Halfedge_index, most_parts>, most_parts> left_over;
    Parts::run(parts, [&](std::size_t part) {
      left_over[part].fill(null_index);
      const std::size_t low = begin(part), high = begin(part + 1);
      std::fill(m_corner.begin() + std::ptrdiff_t(low), m_corner.begin() + std::ptrdiff_t(high),
                null_index);
      const Halfedge_index beyond(Parts::begin(part + 1, parts, halfedges));
      for (Halfedge_index h(Parts::begin(part, parts, halfedges)); h < beyond; ++h)
        if (apex(h) >= low && apex(h) < high)
          m_corner[apex(h)] = h;
        else {
          std::size_t other = apex(h) / (vertices / parts + 1); // or one of the next
          while (apex(h) >= begin(other + 1))
            ++other;
          m_halfedges[h].edge = Edge_index(Index(std::exchange(left_over[part][other], h)));
        }
    });
    Parts::run(parts, [&](std::size_t other) {
      for (std::size_t part = 0; part < parts; ++part)
        for (Halfedge_index h = left_over[part][other]; h != null_index;
             h = Halfedge_index(Index(edge_of(h)))) {
          Halfedge_index& corner = m_corner[apex(h)];
          corner = corner == null_index ? h : (std::max)(corner, h);
        }
    });
  }

  // Numbers the edges along the faces, so that edges close in space are close in memory. If threads
  // share the work, one of them calls `companion()`.
  template <class Parts, class Companion>
  void number_edges(const Companion& companion)
  {
    const std::size_t halfedges = m_halfedges.size(), parts = Parts::number(halfedges);
    if (!Parts::are_shared(parts)) {
      companion();
      return number_edges_of(Halfedge_index(0), Halfedge_index(halfedges), Edge_index(0));
    }
    std::array<Edge_index, Parts::max_parts> edges;
    Parts::for_each(halfedges, [&](std::size_t part, std::size_t first, std::size_t beyond) {
      edges[part] = Edge_index(0);
      for (Halfedge_index h(first); h < beyond; ++h)
        edges[part] += h < twin(h);
    });
    Edge_index sum(0);
    for (std::size_t part = 0; part < parts; ++part)
      sum += std::exchange(edges[part], sum);
    const auto begin = [&](std::size_t part) {
      return Halfedge_index(Parts::begin(part, parts, halfedges));
    };
    Parts::run(parts + 1, [&](std::size_t i) {
      if (i == 0)
        return companion();
      number_edges_of(begin(i - 1), begin(i), edges[i - 1]);
    });
  }

  // Gives the numbers from e on to the edges whose smaller half-edges are in [first, beyond). Lists
  // these half-edges without a branch on `h < twin(h)`, because it would be unpredictable.
  void number_edges_of(Halfedge_index first, Halfedge_index beyond, Edge_index e)
  {
    constexpr Index stretch = 256;
    std::array<Halfedge_index, stretch> firsts;
    for (Halfedge_index h = first; h < beyond;) {
      Index number = 0;
      for (const Halfedge_index end = (std::min)(beyond, h + stretch); h < end; ++h) {
        firsts[number] = h;
        number += h < twin(h);
      }
      for (Index i = 0; i < number; ++i)
        set_edge(e++, twin(firsts[i]));
    }
  }

  // Exchanges the diagonal at half-edge h, vertex by vertex as CGAL's TDS_2::flip(face, i) does.
  // The corners of the two vertices that leave a face are set even where they do not change: a
  // store is cheaper than a branch.
  void flip(Halfedge_index h)
  {
    const Halfedge_index g = twin(h);
    const Halfedge_index h_next = next(h), h_previous = previous(h);
    const Halfedge_index g_next = next(g), g_previous = previous(g);
    const Vertex_index a = apex(h), b = apex(h_next), c = apex(h_previous), d = apex(g);
    const Edge_index ab = edge_of(h_previous), bd = edge_of(g_next);
    const Edge_index dc = edge_of(g_previous), ca = edge_of(h_next), diagonal = edge_of(h);

    m_halfedges[h_previous].apex = d;
    m_halfedges[g_previous].apex = a;
    link(h, twin(g_next));
    link(g, twin(h_next));
    link(h_next, g_next);
    set_corner(c, g_next);
    set_corner(b, h_next);

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

  // Flips the edge at h where the two faces may share further edges, and vertices may have edges to
  // themselves, as on a torus. The two faces must be different.
  void flip_glued(Halfedge_index h)
  {
    const Halfedge_index g = twin(h);
    const Halfedge_index h_next = next(h), g_next = next(g);
    const Halfedge_index outer_bd = twin(g_next), outer_ca = twin(h_next);
    const Edge_index bd = edge_of(g_next), ca = edge_of(h_next), diagonal = edge_of(h);
    const Vertex_index a = apex(h), d = apex(g);
    // the sides bd and ca move to h and g, also where they are each other's twins
    link(h, outer_bd == h_next ? g : outer_bd);
    link(g, outer_ca == g_next ? h : outer_ca);
    link(h_next, g_next);
    set_apex(previous(h), d);
    set_apex(previous(g), a);
    for (const Halfedge_index corner : {h, h_next, g, g_next})
      set_corner(apex(corner), corner);
    set_edge(bd, h);
    set_edge(ca, g);
    set_edge(diagonal, h_next);
    set_edge(edge_of(previous(h)), previous(h));
    set_edge(edge_of(previous(g)), previous(g));
  }

  // Flips the edge at h where both faces lie in one chart, so that they share only this edge. Takes
  // less than half of the time of flip_glued(), because it reads nothing beyond the sides.
  void flip_in_one_chart(Halfedge_index h)
  {
    const Halfedge_index g = twin(h);
    const Edge_index ab = edge_of(previous(h)), dc = edge_of(previous(g));
    const Edge_index bd = edge_of(next(g)), ca = edge_of(next(h));
    flip(h);
    turn_along(bd, h);
    turn_along(ca, g);
    for (const Edge_index side : {ab, bd, dc, ca})
      if (is_hidden(side))
        hide_edge(side);
  }

  // Makes all vertices of edge(e) infinite, so that passes over the edges never prove e Delaunay.
  void hide_edge(Edge_index e)
  {
    m_edges[e] = Edge_2{infinite_index, infinite_index, infinite_index, infinite_index};
  }

  // Reserves memory for more slots. Then append_slots() throws nothing.
  void reserve_for_slots(std::size_t number)
  {
    reserve_extra(m_halfedges, 6 * number);
    reserve_extra(m_edges, 3 * number);
    reserve_extra(m_halfedge_of_edge, 3 * number);
    reserve_extra(m_corner, number);
  }

  // Makes slots with the next numbers, and appends them to `made`, which must have the memory.
  // Threads share them.
  template <class Parts>
  void append_slots(std::size_t number, std::vector<Slot>& made)
  {
    const std::size_t first = made.size(), vertices = m_corner.size(), faces = number_of_faces(),
                      edges = number_of_edges();
    made.resize(first + number);
    m_corner.resize(vertices + number);
    m_halfedges.resize(3 * faces + 6 * number);
    m_edges.resize(edges + 3 * number);
    m_halfedge_of_edge.resize(edges + 3 * number);
    Parts::for_each_element(number, Parts::size_for(16), [&](std::size_t i) {
      const Face_index f(faces + 2 * i);
      const Edge_index e(edges + 3 * i);
      std::fill_n(&m_halfedges[halfedge_in(f, 0)], 6, Halfedge{null_index, null_index, null_index});
      made[first + i] = {Vertex_index(vertices + i), {f, f + 1}, {e, e + 1, e + 2}};
      empty(made[first + i]);
    });
  }

  // Puts the slot's vertex v into face f. Face f keeps the edge opposite to its first vertex, and v
  // replaces that vertex. The edges opposite to the second and third vertex go to the slot's faces,
  // where v replaces the second and third vertex.
  void put_in(const Slot& slot, Face_index f)
  {
    const Vertex_index v = slot.vertex;
    const Face_index g = slot.faces[0], k = slot.faces[1];
    const std::array<Vertex_index, 3> corners = face(f);
    const Halfedge_index outer_g = twin(halfedge_in(f, 1)), outer_k = twin(halfedge_in(f, 2));
    const Edge_index edge_g = edge_of(halfedge_in(f, 1)), edge_k = edge_of(halfedge_in(f, 2));
    set_face(g, corners[0], v, corners[2]);
    set_face(k, corners[0], corners[1], v);
    set_face(f, v, corners[1], corners[2]);
    link(halfedge_in(g, 1), outer_g);
    link(halfedge_in(k, 2), outer_k);
    link(halfedge_in(f, 1), halfedge_in(g, 0));
    link(halfedge_in(f, 2), halfedge_in(k, 0));
    link(halfedge_in(g, 2), halfedge_in(k, 1));
    set_edge(edge_of(halfedge_in(f, 0)), halfedge_in(f, 0));
    set_edge(edge_g, halfedge_in(g, 1));
    set_edge(edge_k, halfedge_in(k, 2));
    set_edge(slot.edges[0], halfedge_in(f, 1));
    set_edge(slot.edges[1], halfedge_in(f, 2));
    set_edge(slot.edges[2], halfedge_in(g, 2));
  }

  // Give the number of an empty face, edge or vertex to the last one, and shorten the arrays.
  // The last one must not be empty itself, unless both are the same.
  void move_last_face_to(Face_index f)
  {
    const Face_index last(number_of_faces() - 1);
    for (Index i = 0; i < 3 && f != last; ++i) {
      const Halfedge_index from = halfedge_in(last, i), to = halfedge_in(f, i);
      m_halfedges[to] = m_halfedges[from];
      m_halfedges[twin(to)].twin = to;
      if (m_halfedge_of_edge[edge_of(to)] == from)
        m_halfedge_of_edge[edge_of(to)] = to;
      m_corner[apex(to)] = to;
    }
    m_halfedges.resize(m_halfedges.size() - 3);
  }

  void move_last_edge_to(Edge_index e)
  {
    const Edge_index last(number_of_edges() - 1);
    if (e != last) {
      m_edges[e] = m_edges[last];
      const Halfedge_index h = m_halfedge_of_edge[e] = m_halfedge_of_edge[last];
      m_halfedges[h].edge = m_halfedges[twin(h)].edge = e;
    }
    m_edges.pop_back();
    m_halfedge_of_edge.pop_back();
  }

  void move_last_vertex_to(Vertex_index v)
  {
    const Vertex_index last(m_corner.size() - 1);
    if (v != last) {
      for_each_corner(last, [&](Halfedge_index h) {
        m_halfedges[h].apex = v;
        rename(edge_of(h), last, v);
        rename(edge_of(previous(h)), last, v);
      });
      m_corner[v] = m_corner[last];
    }
    m_corner.pop_back();
  }

  // Does the same for many faces, edges and vertices at once, in passes that threads share.
  template <class Parts>
  void fill(const Filled_gaps<Face_index>& faces, const Filled_gaps<Edge_index>& edges,
            const Filled_gaps<Vertex_index>& vertices)
  {
    faces.template for_each_move<Parts>([this](Face_index from, Face_index to) {
      for (Index i = 0; i < 3; ++i)
        m_halfedges[halfedge_in(to, i)] = m_halfedges[halfedge_in(from, i)];
    });
    edges.template for_each_move<Parts>([this](Edge_index from, Edge_index to) {
      m_edges[to] = m_edges[from];
      m_halfedge_of_edge[to] = m_halfedge_of_edge[from];
    });
    vertices.template for_each_move<Parts>(
        [this](Vertex_index from, Vertex_index to) { m_corner[to] = m_corner[from]; });
    m_halfedges.resize(3 * std::size_t(faces.number_kept()));
    m_edges.resize(edges.number_kept());
    m_halfedge_of_edge.resize(edges.number_kept());
    m_corner.resize(vertices.number_kept());
    const Halfedge_index first_moved = halfedge_in(Face_index(faces.number_kept()), 0);
    const auto renumber = [&](Halfedge_index& h) {
      if (h >= first_moved)
        h = halfedge_in(faces(face_of(h)), number_in_face(h));
    };
    const Index first_vertex = vertices.number_kept(), first_edge = edges.number_kept();
    Parts::for_each_element(m_halfedges.size(), [&](std::size_t i) {
      Halfedge& h = m_halfedges[Halfedge_index(i)];
      if (h.apex >= first_vertex)
        h.apex = vertices(h.apex);
      renumber(h.twin);
      if (h.edge >= first_edge)
        h.edge = edges(h.edge);
    });
    Parts::for_each_element(m_edges.size(), [&](std::size_t i) {
      Edge_2& e = m_edges[Edge_index(i)];
      if ((std::max)({e.source, e.target, e.left, e.right}) >= first_vertex)
        e = {vertices(e.source), vertices(e.target), vertices(e.left), vertices(e.right)};
      renumber(m_halfedge_of_edge[Edge_index(i)]);
    });
    Parts::for_each_element(m_corner.size(),
                            [&](std::size_t i) { renumber(m_corner[Vertex_index(i)]); });
  }

  void empty(const Slot& slot)
  {
    m_corner[slot.vertex] = null_index;
    for (const Face_index f : slot.faces)
      m_halfedges[halfedge_in(f, 0)].apex = null_index;
    for (const Edge_index e : slot.edges) {
      m_halfedge_of_edge[e] = null_index;
      hide_edge(e);
    }
  }

  void set_face(Face_index f, Vertex_index a, Vertex_index b, Vertex_index c)
  {
    set_apex(halfedge_in(f, 0), a);
    set_apex(halfedge_in(f, 1), b);
    set_apex(halfedge_in(f, 2), c);
  }

  void rename(Edge_index e, Vertex_index from, Vertex_index to)
  {
    Edge_2& edge = m_edges[e];
    edge.source = edge.source == from ? to : edge.source;
    edge.target = edge.target == from ? to : edge.target;
    edge.left = edge.left == from ? to : edge.left;
    edge.right = edge.right == from ? to : edge.right;
  }

private:
  // Both functions below use masks of all bits or none: processors could not predict a branch.

  // Makes edge(e) go from the source to the target of half-edge h.
  void turn_along(Edge_index e, Halfedge_index h)
  {
    const Edge_2 edge = m_edges[e];
    const Index turns = 0 - Index(edge.source != source(h));
    const Index ends = (edge.source ^ edge.target) & turns;
    const Index apexes = (edge.left ^ edge.right) & turns;
    m_edges[e] = {Vertex_index(edge.source ^ ends), Vertex_index(edge.target ^ ends),
                  Vertex_index(edge.left ^ apexes), Vertex_index(edge.right ^ apexes)};
  }

  void exchange_opposite(Edge_index e, Vertex_index from, Vertex_index to)
  {
    Edge_2& edge = m_edges[e];
    const Index is_left = 0 - Index(edge.left == from);
    edge.left = Vertex_index((to & is_left) | (edge.left & ~is_left));
    edge.right = Vertex_index((to & ~is_left) | (edge.right & is_left));
  }
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_TOPOLOGY_WRITABLE_HALFEDGE_ARRAYS_2_H

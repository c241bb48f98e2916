// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_TOPOLOGY_TETRAHEDRA_ARRAYS_3_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_TOPOLOGY_TETRAHEDRA_ARRAYS_3_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/passes/Elements_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/topology/Cell_arrays_3.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_3::internal {

// Cells of open space: vertices, and mirror corners.
struct Tetrahedron_3
{
  using Site = Vertex_index;
  using Sites = Vertices_3;
  static constexpr bool may_repeat_vertices = false;

  const Sites& sites() const { return vertices; }
  Site site(int place) const { return vertices[place]; }
  static bool is_free(const Sites& sites) { return sites[0] == null_index; }
  // With its vertices in another order.
  Tetrahedron_3 turned(const Few<std::uint8_t, 4>& places) const
  {
    return {permuted(vertices, places), permuted(mirrors, places)};
  }
  void exchange(Tetrahedron_3& other)
  {
    exchange_what_differs(vertices, other.vertices);
    exchange_what_differs(mirrors, other.mirrors);
  }

  Vertices_3 vertices;
  Few<Corner_index, 4> mirrors;
};

// A triangulated 3-sphere: tetrahedra, and infinite cells, one for each facet of the hull. The
// infinite vertex has the number 0.
//
// A site, of which a torus has many for each vertex, is a vertex here; and there is one chart.
class Tetrahedra_arrays_3 : public Cell_arrays_3<Tetrahedron_3>
{
public:
  using Site = Vertex_index;
  using Sites = Vertices_3;
  // Takes a chart to another one: there is nothing to do.
  struct Translation
  {
    friend Translation operator+(Translation, Translation) { return {}; }
    friend bool operator!=(Translation, Translation) { return false; }
    friend bool operator==(Translation, Translation) { return true; }
  };

  static Vertex_index vertex_of(Site s) { return s; }
  static bool is_infinite(Site s) { return s == infinite_index; }
  static Site translated_back(Site s, Translation) { return s; }
  // What takes the site, in a chart, to another image of it, in another one.
  static Translation translation(Site, Site) { return {}; }
  Translation translation(Corner_index) const { return {}; }
  const Sites& sites(Cell_index c) const { return vertices(c); }
  Site site(Corner_index k) const { return vertex(k); }
  Site apex_site(Corner_index k) const { return apex(k); }

  bool is_infinite(Cell_index c) const { return has_infinite(vertices(c)); }
  // The place of a vertex in a cell, or 4.
  using Cell_arrays_3::place_of;
  int place_of(Cell_index c, Vertex_index v) const
  {
    const Vertices_3& w = vertices(c);
    return w[0] == v ? 0 : w[1] == v ? 1 : w[2] == v ? 2 : w[3] == v ? 3 : 4;
  }

  // The place of a vertex that the cell has, found without branches.
  static int place_of_known(const Cell& cell, Vertex_index v)
  {
    const Vertices_3& w = cell.vertices;
    return int(w[1] == v) + 2 * int(w[2] == v) + 3 * int(w[3] == v);
  }

  // CHANGES ---------------------------------------------------------------------------------------

  void set_vertices(Cell_index c, const Vertices_3& v, std::size_t part = whole)
  {
    record(c, part);
    note(c, part);
    m_cells[c].vertices = v;
    for (int i = 0; i < 4; ++i)
      note_corner(corner(c, i), part);
  }

  // Makes two corners each other's mirror.
  void connect(Corner_index k, Corner_index l, std::size_t part = whole)
  {
    meet(cell_of(k), part);
    meet(cell_of(l), part);
    m_cells[cell_of(k)].mirrors[place_of(k)] = l;
    m_cells[cell_of(l)].mirrors[place_of(l)] = k;
  }

  // Replaces the two cells at the facet opposite to k by three around the edge from the vertex of k
  // to the one beyond.
  Flipped flip_2_3(Corner_index k, std::size_t part = whole)
  {
    const Cell_index first = cell_of(k), second = cell_of(mirror(k));
    const int top = place_of(k);
    const Cell a = m_cells[first], b = m_cells[second];
    const Vertex_index beyond = apex(k);
    Few<int, 3> around;
    for (int i = 0, n = 0; i < 4; ++i)
      if (i != top)
        around[n++] = i;
    Flipped flipped{{first, second, make_cell(part)}, 3, {}};
    Few<Corner_index, 3> below;
    for (int n = 0; n < 3; ++n)
      below[n] = b.mirrors[place_of_known(b, a.vertices[around[n]])];
    for (int n = 0; n < 3; ++n) {
      Vertices_3 v = a.vertices;
      v[around[n]] = beyond;
      set_vertices(flipped.cells[n], v, part);
    }
    for (int n = 0; n < 3; ++n) {
      connect(flipped.outer[2 * n] = corner(flipped.cells[n], around[n]), a.mirrors[around[n]],
              part);
      connect(flipped.outer[2 * n + 1] = corner(flipped.cells[n], top), below[n], part);
      for (int m = 0; m < n; ++m)
        connect(corner(flipped.cells[n], around[m]), corner(flipped.cells[m], around[n]), part);
    }
    return flipped;
  }

  // Replaces the three cells around an edge by two: the two at the facet opposite to k, and their
  // common neighbor opposite to the vertex at `side` in the cell of k. The edge joins the other two
  // vertices.
  Flipped flip_3_2(Corner_index k, int side, std::size_t part = whole)
  {
    const Cell_index first = cell_of(k), second = cell_of(mirror(k)), third = neighbor(first, side);
    const int top = place_of(k);
    const Cell a = m_cells[first], b = m_cells[second], c = m_cells[third];
    const Vertex_index beyond = apex(k);
    int p = 0;
    while (p == top || p == side)
      ++p;
    const int q = 6 - top - side - p;
    const Vertex_index end_p = a.vertices[p], end_q = a.vertices[q];
    const Few<Corner_index, 3> at_p{a.mirrors[q], b.mirrors[place_of_known(b, end_q)],
                                    c.mirrors[place_of_known(c, end_q)]};
    const Few<Corner_index, 3> at_q{a.mirrors[p], b.mirrors[place_of_known(b, end_p)],
                                    c.mirrors[place_of_known(c, end_p)]};
    Vertices_3 v = a.vertices, w = a.vertices;
    v[q] = beyond;
    w[p] = beyond;
    drop_cell(third, part);
    set_vertices(first, v, part);
    set_vertices(second, w, part);
    const Flipped flipped{{first, second, null_index},
                          2,
                          {corner(first, top), corner(first, q), corner(first, side),
                           corner(second, top), corner(second, p), corner(second, side)}};
    connect(flipped.outer[0], at_p[1], part);
    connect(flipped.outer[1], at_p[0], part);
    connect(flipped.outer[2], at_p[2], part);
    connect(flipped.outer[3], at_q[1], part);
    connect(flipped.outer[4], at_q[0], part);
    connect(flipped.outer[5], at_q[2], part);
    connect(corner(first, p), corner(second, q), part);
    return flipped;
  }

  // Replaces cells, which form a ball without vertices inside, by cells over its border that have
  // the vertex v in common. Each facet of the border is given by the corner of the cell within that
  // is opposite to it. Returns a new cell. `star` is memory that is used anew each time; parts have
  // one each.
  Cell_index replace_by_star(const std::vector<Cell_index>& ball,
                             const std::vector<Corner_index>& border, Vertex_index v,
                             std::vector<Star_cell>& star, std::size_t part = whole)
  {
    prepare_star(ball, border, star, part,
                 [&](Star_cell& made, std::size_t) { made.cell.vertices[made.tip] = v; });
    for (const Star_cell& made : star) {
      write(made, part);
      connect(corner(made.number, made.tip), made.cell.mirrors[made.tip], part);
    }
    return star.back().number;
  }
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_3::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_TOPOLOGY_TETRAHEDRA_ARRAYS_3_H

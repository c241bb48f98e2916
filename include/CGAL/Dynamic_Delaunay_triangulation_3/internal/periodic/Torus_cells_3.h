// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_PERIODIC_TORUS_CELLS_3_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_PERIODIC_TORUS_CELLS_3_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/assertions.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/periodic/Torus_shift_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/topology/Tetrahedra_arrays_3.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <stdexcept>
#include <utility>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_3::internal {

// A triangulated torus of three dimensions in one flat array: one cell for each class of cells in
// space that are images of each other. Vertices have the numbers from 1 on.
//
// Each cell has a chart of its own, in which its vertices have shifts; the first one's is 0. At
// each corner it knows the mirror corner in the neighbor, and the translation that takes the
// neighbor's chart to its own: a site of the neighbor with the shift s has the shift s +
// translation here. So nothing has to be found by comparing vertices, and a cell may have several
// images of a vertex, be its own neighbor, or another's neighbor several times.
class Torus_cells_3
{
public:
  // One line of a cache.
  struct alignas(64) Cell
  {
    Vertices_3 vertices;
    Shifts_3 shifts;
    Few<Corner_index, 4> mirrors;
    Shifts_3 translations;
  };

  Index number_of_cells() const { return Index(m_cells.size()); }
  Index number_of_vertices() const { return Index(m_corners.size()); } // number 0 included

  const Cell& cell(Cell_index c) const { return m_cells[c]; }
  const Cell* cells() const { return m_cells.data(); }
  const Vertices_3& vertices(Cell_index c) const { return m_cells[c].vertices; }
  static Cell_index cell_of(Corner_index k) { return Tetrahedra_arrays_3::cell_of(k); }
  static int place_of(Corner_index k) { return Tetrahedra_arrays_3::place_of(k); }
  static Corner_index corner(Cell_index c, int place)
  {
    return Tetrahedra_arrays_3::corner(c, place);
  }
  Vertex_index vertex(Corner_index k) const { return vertices(cell_of(k))[place_of(k)]; }
  Corner_index mirror(Corner_index k) const { return m_cells[cell_of(k)].mirrors[place_of(k)]; }
  Torus_shift_3 translation(Corner_index k) const
  {
    return m_cells[cell_of(k)].translations[place_of(k)];
  }
  Cell_index neighbor(Cell_index c, int place) const { return cell_of(m_cells[c].mirrors[place]); }
  // The vertex beyond the facet opposite to a corner.
  Vertex_index apex(Corner_index k) const { return vertex(mirror(k)); }
  Corner_index corner_of(Vertex_index v) const { return m_corners[v]; }

  // In the chart of the corner's cell.
  Torus_site_3 site(Corner_index k) const
  {
    const Cell& cell = m_cells[cell_of(k)];
    return {cell.vertices[place_of(k)], cell.shifts[place_of(k)]};
  }
  Torus_site_3 apex_site(Corner_index k) const
  {
    const Torus_site_3 beyond = site(mirror(k));
    return {beyond.vertex, beyond.shift + translation(k)};
  }
  Torus_sites_3 sites(Cell_index c) const
  {
    const Cell& cell = m_cells[c];
    Torus_sites_3 sites;
    for (int i = 0; i < 4; ++i)
      sites[i] = {cell.vertices[i], cell.shifts[i]};
    return sites;
  }

  // Between changes no cell is free.
  bool is_free(Cell_index c) const { return vertices(c)[0] == null_index; }
  // The place of a site in a cell, or 4.
  int place_of(Cell_index c, const Torus_site_3& s) const
  {
    int place = 0;
    while (place < 4 && !(site(corner(c, place)) == s))
      ++place;
    return place;
  }

  // CHANGES ---------------------------------------------------------------------------------------

  // Vertices keep their corners, which mean nothing until they have cells again.
  void clear_cells()
  {
    m_cells.clear();
    m_free.clear();
    m_is_recording = false;
  }
  void reset(Index vertices)
  {
    clear_cells();
    m_cells.reserve(7 * std::size_t(vertices));
    m_corners.assign(vertices, Corner_index(null_index));
  }
  void resize_vertices(Index number) { m_corners.resize(number, null_index); }
  void forget_corner(Vertex_index v) { m_corners[v] = null_index; }

  Cell_index make_cell()
  {
    Cell_index c;
    if (m_free.empty()) {
      if (m_cells.size() >= Tetrahedra_arrays_3::max_cells)
        throw std::length_error("the triangulation would have more than 2^30 - 1 cells");
      c = Cell_index(m_cells.size());
      if (m_cells.size() == m_cells.capacity()) // doubling would take 300 bytes a point
        m_cells.reserve(with_reserve(m_cells.size()));
      m_cells.push_back(free_cell());
    } else {
      c = m_free.back();
      m_free.pop_back();
    }
    if (m_is_recording)
      m_made.push_back(c);
    return c;
  }
  void drop_cell(Cell_index c)
  {
    record(c);
    m_cells[c] = free_cell();
    (m_is_recording ? m_dropped : m_free).push_back(c);
  }

  void set_sites(Cell_index c, const Torus_sites_3& sites)
  {
    record(c);
    for (int i = 0; i < 4; ++i) {
      m_cells[c].vertices[i] = sites[i].vertex;
      m_cells[c].shifts[i] = sites[i].shift;
      m_corners[sites[i].vertex] = corner(c, i);
    }
  }

  // Makes two corners each other's mirror. The translation takes the chart of l's cell to k's.
  void connect(Corner_index k, Corner_index l, Torus_shift_3 translation)
  {
    record(cell_of(k));
    record(cell_of(l));
    set_mirror(k, l, translation);
    set_mirror(l, k, -translation);
  }

  // Cells that a flip has made, and their corners opposite to the facets around them.
  struct Flipped
  {
    Few<Cell_index, 3> cells;
    int number;
    Few<Corner_index, 6> outer;
  };

  // Replaces the two different cells at the facet opposite to k by three around the edge from the
  // vertex of k to the one beyond.
  Flipped flip_2_3(Corner_index k)
  {
    const Cell_index first = cell_of(k), second = cell_of(mirror(k));
    CGAL_precondition(first != second);
    const int top = place_of(k);
    const Torus_sites_3 a = sites(first);
    const Torus_site_3 beyond = apex_site(k);
    const Torus_shift_3 of_second = translation(k);
    Few<int, 3> around;
    for (int i = 0, n = 0; i < 4; ++i)
      if (i != top)
        around[n++] = i;
    Flipped flipped{{first, second, make_cell()}, 3, {}};
    Few<Outer_facet, 6> outer;
    for (int n = 0; n < 3; ++n) {
      const Torus_site_3 s = a[around[n]];
      const int below = place_of(second, {s.vertex, s.shift - of_second});
      outer[2 * n] = {corner(first, around[n]), corner(flipped.cells[n], around[n]), {}};
      outer[2 * n + 1] = {corner(second, below), corner(flipped.cells[n], top), of_second};
    }
    read_mirrors(outer);
    for (int n = 0; n < 3; ++n) {
      Torus_sites_3 s = a;
      s[around[n]] = beyond;
      set_sites(flipped.cells[n], s);
    }
    for (int n = 0; n < 3; ++n)
      for (int m = 0; m < n; ++m)
        connect(corner(flipped.cells[n], around[m]), corner(flipped.cells[m], around[n]), {});
    connect_outer(outer, [=](Cell_index c) { return c == first || c == second; });
    for (const Cell_index c : flipped.cells)
      normalize(c);
    flipped.outer = new_corners(outer);
    return flipped;
  }

  // Replaces the three different cells around an edge by two: the two at the facet opposite to k,
  // and their common neighbor opposite to the vertex at `side` in the cell of k. The edge joins the
  // other two vertices.
  Flipped flip_3_2(Corner_index k, int side)
  {
    const Cell_index first = cell_of(k), second = cell_of(mirror(k)), third = neighbor(first, side);
    CGAL_precondition(first != second && first != third && second != third);
    const int top = place_of(k);
    const Torus_sites_3 a = sites(first);
    const Torus_site_3 beyond = apex_site(k);
    const Torus_shift_3 of_second = translation(k), of_third = translation(corner(first, side));
    int p = 0;
    while (p == top || p == side)
      ++p;
    const int q = 6 - top - side - p;
    const auto opposite_to = [&](Cell_index c, Torus_shift_3 shift, const Torus_site_3& s) {
      return corner(c, place_of(c, {s.vertex, s.shift - shift}));
    };
    Few<Outer_facet, 6> outer{{
        {corner(first, q), corner(first, q), {}},
        {opposite_to(second, of_second, a[q]), corner(first, top), of_second},
        {opposite_to(third, of_third, a[q]), corner(first, side), of_third},
        {corner(first, p), corner(second, p), {}},
        {opposite_to(second, of_second, a[p]), corner(second, top), of_second},
        {opposite_to(third, of_third, a[p]), corner(second, side), of_third},
    }};
    read_mirrors(outer);
    Torus_sites_3 s = a, t = a;
    s[q] = beyond;
    t[p] = beyond;
    drop_cell(third);
    set_sites(first, s);
    set_sites(second, t);
    connect(corner(first, p), corner(second, q), {});
    connect_outer(outer, [=](Cell_index c) { return c == first || c == second || c == third; });
    normalize(first);
    normalize(second);
    return {{first, second, null_index}, 2, new_corners(outer)};
  }

  // A facet between cells that are replaced and others, or images of themselves: the corner
  // opposite to it in a cell that goes, and in one that comes. The shift takes the chart of the
  // former to that of the latter.
  struct Outer_facet
  {
    Corner_index from, to;
    Torus_shift_3 shift;
    Corner_index mirror = Corner_index(null_index); // of `from`, and the translation
    Torus_shift_3 translation = {};
  };

  // Reads what is behind outer facets, before cells are overwritten.
  template <class Outer_facets>
  void read_mirrors(Outer_facets& outer) const
  {
    for (Outer_facet& facet : outer) {
      facet.mirror = mirror(facet.from);
      facet.translation = translation(facet.from) + facet.shift;
    }
  }
  // Connects new cells with what is behind outer facets: a cell that stays, or a new one, if what
  // was there is replaced, too.
  template <class Outer_facets, class Predicate>
  void connect_outer(const Outer_facets& outer, const Predicate& is_replaced)
  {
    for (const Outer_facet& facet : outer) {
      const Outer_facet* other = nullptr;
      if (is_replaced(cell_of(facet.mirror)))
        for (const Outer_facet& candidate : outer)
          if (candidate.from == facet.mirror)
            other = &candidate;
      if (other == nullptr)
        connect(facet.to, facet.mirror, facet.translation);
      else
        connect(facet.to, other->to, facet.translation - other->shift);
    }
  }

  // Moves the chart of a cell, so that its first vertex has the shift 0.
  void normalize(Cell_index c)
  {
    const Torus_shift_3 shift = m_cells[c].shifts[0];
    if (shift == Torus_shift_3())
      return;
    record(c);
    for (Torus_shift_3& s : m_cells[c].shifts)
      s = s - shift;
    for (int i = 0; i < 4; ++i) {
      const Corner_index l = m_cells[c].mirrors[i];
      record(cell_of(l));
      Cell& other = m_cells[cell_of(l)];
      m_cells[c].translations[i] = m_cells[c].translations[i] - shift;
      other.translations[place_of(l)] = other.translations[place_of(l)] + shift;
    }
  }

  // Adds shifts to the images of all vertices.
  void shift_vertices(const Column<Vertex_index, Torus_shift_3>& shifts)
  {
    for (Cell& cell : m_cells)
      for (int i = 0; i < 4; ++i)
        cell.shifts[i] = cell.shifts[i] + shifts[cell.vertices[i]];
    for (Cell_index c(0); c < number_of_cells(); ++c)
      normalize(c);
  }

  // Moves the last cells to the numbers of free ones.
  void close_gaps()
  {
    std::sort(m_free.begin(), m_free.end());
    for (const Cell_index c : m_free) {
      drop_free_ones_at_end();
      if (c >= m_cells.size())
        break;
      move_last_cell_to(c);
    }
    drop_free_ones_at_end();
    m_free.clear();
  }

  // Gives the vertex `from`, whose star is given, the number `to`.
  void renumber(Vertex_index from, Vertex_index to, const std::vector<Cell_index>& star)
  {
    for (const Cell_index c : star)
      for (Vertex_index& v : m_cells[c].vertices)
        if (v == from)
          v = to;
    m_corners[to] = m_corners[from];
  }

  // Gives every vertex v the number numbers[v]; of `vertices` in all. Those without cells have
  // null_index.
  void renumber_all(const Column<Vertex_index, Vertex_index>& numbers, Index vertices)
  {
    m_corners.assign(vertices, Corner_index(null_index));
    for (Cell_index c(0); c < number_of_cells(); ++c)
      for (int i = 0; i < 4; ++i) {
        Vertex_index& v = m_cells[c].vertices[i];
        v = numbers[v];
        m_corners[v] = corner(c, i);
      }
  }

  // Cells in the order of their smallest vertices: a pass over them then reads positions in order.
  void sort_cells()
  {
    const auto key = [this](Cell_index c) {
      return std::size_t(*std::min_element(vertices(c).begin(), vertices(c).end()));
    };
    std::vector<Index> next(m_corners.size() + 1, 0);
    for (Cell_index c(0); c < number_of_cells(); ++c)
      ++next[key(c) + 1];
    std::partial_sum(next.begin(), next.end(), next.begin());
    Column<Cell_index, Cell_index> number(m_cells.size(), Cell_index(0));
    for (Cell_index c(0); c < number_of_cells(); ++c)
      number[c] = Cell_index(next[key(c)]++);
    Column<Cell_index, Cell> cells(m_cells.size());
    for (Cell_index c(0); c < number_of_cells(); ++c) {
      Cell& cell = cells[number[c]] = m_cells[c];
      for (Corner_index& k : cell.mirrors)
        k = corner(number[cell_of(k)], place_of(k));
    }
    m_cells.swap(cells);
    for (Corner_index& k : m_corners)
      if (k != null_index)
        k = corner(number[cell_of(k)], place_of(k));
  }

  // TRANSACTIONS ----------------------------------------------------------------------------------

  // Between begin() and commit() or undo(), what is overwritten is recorded.
  void begin()
  {
    CGAL_precondition(!m_is_recording);
    m_is_recording = true;
    m_record.clear();
    m_made.clear();
    m_dropped.clear();
  }
  void commit()
  {
    m_is_recording = false;
    m_free.insert(m_free.end(), m_dropped.begin(), m_dropped.end());
  }
  void undo()
  {
    m_is_recording = false;
    for (std::size_t i = m_record.size(); i-- > 0;)
      m_cells[m_record[i].first] = m_record[i].second;
    for (const Cell_index c : m_made)
      m_cells[c] = free_cell();
    for (const auto& [c, cell] : m_record)
      if (!is_free(c))
        for (int i = 0; i < 4; ++i)
          m_corners[vertices(c)[i]] = corner(c, i);
    m_free.insert(m_free.end(), m_made.begin(), m_made.end());
  }
  // Calls f(c) for each cell that was changed or made since begin() and exists; for some
  // repeatedly.
  template <class Function>
  void for_each_changed(const Function& f) const
  {
    for (const auto& [c, cell] : m_record)
      if (!is_free(c))
        f(c);
  }

private:
  static Cell free_cell()
  {
    return {{null_index, null_index, null_index, null_index},
            {},
            {null_index, null_index, null_index, null_index},
            {}};
  }

  void record(Cell_index c)
  {
    if (m_is_recording)
      m_record.emplace_back(c, m_cells[c]);
  }

  void set_mirror(Corner_index k, Corner_index l, Torus_shift_3 translation)
  {
    m_cells[cell_of(k)].mirrors[place_of(k)] = l;
    m_cells[cell_of(k)].translations[place_of(k)] = translation;
  }

  static Few<Corner_index, 6> new_corners(const Few<Outer_facet, 6>& outer)
  {
    Few<Corner_index, 6> corners;
    std::transform(outer.begin(), outer.end(), corners.begin(),
                   [](const Outer_facet& facet) { return facet.to; });
    return corners;
  }

  void drop_free_ones_at_end()
  {
    while (!m_cells.empty() && m_cells.back().vertices[0] == null_index)
      m_cells.pop_back();
  }
  void move_last_cell_to(Cell_index c)
  {
    const Cell_index last(m_cells.size() - 1);
    m_cells[c] = m_cells[last];
    for (Corner_index& k : m_cells[c].mirrors) // of a cell that is its own neighbor
      if (cell_of(k) == last)
        k = corner(c, place_of(k));
    for (int i = 0; i < 4; ++i) {
      const Corner_index mirror = m_cells[c].mirrors[i];
      m_cells[cell_of(mirror)].mirrors[place_of(mirror)] = corner(c, i);
      const Vertex_index v = m_cells[c].vertices[i];
      if (m_corners[v] == corner(last, i))
        m_corners[v] = corner(c, i);
    }
    m_cells.pop_back();
  }

  Column<Cell_index, Cell> m_cells;
  std::vector<Cell_index> m_free;
  Column<Vertex_index, Corner_index> m_corners;

  bool m_is_recording = false;
  std::vector<std::pair<Cell_index, Cell>> m_record; // what was overwritten, in order
  std::vector<Cell_index> m_made, m_dropped;
};

// Lists the cells around a vertex, each once, also one with several images of it.
inline void find_star(const Torus_cells_3& arrays, Vertex_index v, Cell_marks_3& marks,
                      std::vector<Cell_index>& star)
{
  star.clear();
  marks.clear(arrays.number_of_cells());
  const Cell_index first = Torus_cells_3::cell_of(arrays.corner_of(v));
  marks.insert(first);
  star.push_back(first);
  for (std::size_t n = 0; n < star.size(); ++n) {
    const Torus_cells_3::Cell& cell = arrays.cell(star[n]);
    int images = 0;
    for (const Vertex_index w : cell.vertices)
      images += w == v;
    for (int i = 0; i < 4; ++i)
      if (const Cell_index c = Torus_cells_3::cell_of(cell.mirrors[i]);
          images > int(cell.vertices[i] == v) && marks.insert(c))
        star.push_back(c);
  }
}

} // namespace CGAL::Dynamic_Delaunay_triangulations_3::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_PERIODIC_TORUS_CELLS_3_H

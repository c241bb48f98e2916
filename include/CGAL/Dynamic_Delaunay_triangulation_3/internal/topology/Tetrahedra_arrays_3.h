// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_TOPOLOGY_TETRAHEDRA_ARRAYS_3_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_TOPOLOGY_TETRAHEDRA_ARRAYS_3_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/assertions.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/passes/Elements_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/topology/Cell_history_3.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <utility>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_3::internal {

// Room for a few more than so many: frames change the number of cells little.
inline std::size_t with_reserve(std::size_t cells)
{
  return cells + cells / 32 + 64;
}

// A triangulated 3-sphere in one flat array: for each cell its four vertices, and for each of its
// corners the mirror corner, which lies opposite to the same facet in the neighbor. So the vertex
// beyond a facet is found without a search. The infinite vertex has the number 0. All cells have
// the same combinatorial orientation; they know no positions.
class Tetrahedra_arrays_3
{
public:
  struct Cell
  {
    Vertices_3 vertices;
    Few<Corner_index, 4> mirrors;
  };

  static constexpr std::size_t max_cells = (std::size_t(1) << 30) - 1;

  Index number_of_cells() const { return Index(m_cells.size()); }
  Index number_of_vertices() const { return Index(m_corners.size()); } // the infinite one included

  const Cell& cell(Cell_index c) const { return m_cells[c]; }
  const Cell* cells() const { return m_cells.data(); }
  const Vertices_3& vertices(Cell_index c) const { return m_cells[c].vertices; }
  static Cell_index cell_of(Corner_index k) { return Cell_index(k / 4); }
  static int place_of(Corner_index k) { return int(k % 4); }
  static Corner_index corner(Cell_index c, int place) { return Corner_index(4 * c + Index(place)); }
  Vertex_index vertex(Corner_index k) const { return vertices(cell_of(k))[place_of(k)]; }
  Corner_index mirror(Corner_index k) const { return m_cells[cell_of(k)].mirrors[place_of(k)]; }
  Cell_index neighbor(Cell_index c, int place) const { return cell_of(m_cells[c].mirrors[place]); }
  // The vertex beyond the facet opposite to a corner.
  Vertex_index apex(Corner_index k) const { return vertex(mirror(k)); }
  // Some corner of a vertex that has cells.
  Corner_index corner_of(Vertex_index v) const { return m_corners[v]; }

  // Between changes no cell is free. Free ones have neither vertices nor mirrors.
  bool is_free(Cell_index c) const { return vertices(c)[0] == null_index; }
  bool is_infinite(Cell_index c) const { return place_of(c, infinite_index) < 4; }
  // The place of a vertex in a cell, or 4.
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

  // Vertices keep their corners, which mean nothing until they have cells again.
  void clear_cells()
  {
    if (m_history.is_on())
      m_history.give_up(m_cells);
    m_cells.clear();
    m_free.clear();
    m_is_recording = false;
  }
  // Starts with so many vertices, the infinite one included, and no cells, but memory for as many
  // as random points have.
  void reset(Index vertices)
  {
    clear_cells();
    m_cells.reserve(7 * std::size_t(vertices));
    m_corners.assign(vertices, Corner_index(null_index));
  }
  void resize_vertices(Index number) { m_corners.resize(number, null_index); }

  Cell_index make_cell()
  {
    Cell_index c;
    if (m_free.empty()) {
      if (m_cells.size() >= max_cells)
        throw std::length_error("the triangulation would have more than 2^30 - 1 cells");
      c = Cell_index(m_cells.size());
      if (m_cells.size() == m_cells.capacity()) // doubling would take 200 bytes a point
        m_cells.reserve(with_reserve(m_cells.size()));
      m_cells.push_back(free_cell());
      note(c);
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
    note(c);
    m_cells[c] = free_cell();
    (m_is_recording ? m_dropped : m_free).push_back(c);
  }

  void set_vertices(Cell_index c, const Vertices_3& v)
  {
    record(c);
    note(c);
    m_cells[c].vertices = v;
    for (int i = 0; i < 4; ++i)
      m_corners[v[i]] = corner(c, i);
  }

  // Lets walks around its vertex begin at a corner.
  void set_corner(Corner_index k) { m_corners[vertex(k)] = k; }

  // Makes two corners each other's mirror.
  void connect(Corner_index k, Corner_index l)
  {
    record(cell_of(k));
    record(cell_of(l));
    m_cells[cell_of(k)].mirrors[place_of(k)] = l;
    m_cells[cell_of(l)].mirrors[place_of(l)] = k;
  }

  // Cells that a flip has made.
  struct Flipped
  {
    Few<Cell_index, 3> cells;
    int number;
  };

  // Replaces the two cells at the facet opposite to k by three around the edge from the vertex of k
  // to the one beyond.
  Flipped flip_2_3(Corner_index k)
  {
    const Cell_index first = cell_of(k), second = cell_of(mirror(k));
    const int top = place_of(k);
    const Cell a = m_cells[first], b = m_cells[second];
    const Vertex_index beyond = apex(k);
    Few<int, 3> around;
    for (int i = 0, n = 0; i < 4; ++i)
      if (i != top)
        around[n++] = i;
    Flipped flipped{{first, second, make_cell()}, 3};
    Few<Corner_index, 3> below;
    for (int n = 0; n < 3; ++n)
      below[n] = b.mirrors[place_of_known(b, a.vertices[around[n]])];
    for (int n = 0; n < 3; ++n) {
      Vertices_3 v = a.vertices;
      v[around[n]] = beyond;
      set_vertices(flipped.cells[n], v);
    }
    for (int n = 0; n < 3; ++n) {
      connect(corner(flipped.cells[n], around[n]), a.mirrors[around[n]]);
      connect(corner(flipped.cells[n], top), below[n]);
      for (int m = 0; m < n; ++m)
        connect(corner(flipped.cells[n], around[m]), corner(flipped.cells[m], around[n]));
    }
    return flipped;
  }

  // Replaces the three cells around an edge by two: the two at the facet opposite to k, and their
  // common neighbor opposite to the vertex at `side` in the cell of k. The edge joins the other two
  // vertices.
  Flipped flip_3_2(Corner_index k, int side)
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
    drop_cell(third);
    set_vertices(first, v);
    set_vertices(second, w);
    connect(corner(first, q), at_p[0]);
    connect(corner(first, top), at_p[1]);
    connect(corner(first, side), at_p[2]);
    connect(corner(second, p), at_q[0]);
    connect(corner(second, top), at_q[1]);
    connect(corner(second, side), at_q[2]);
    connect(corner(first, p), corner(second, q));
    return {{first, second, null_index}, 2};
  }

  // Replaces cells, which form a ball without vertices inside, by cells over its border that have
  // the vertex v in common. Each facet of the border is given by the corner of the cell within that
  // is opposite to it. Returns a new cell.
  Cell_index replace_by_star(const std::vector<Cell_index>& ball,
                             const std::vector<Corner_index>& border, Vertex_index v)
  {
    m_star.clear();
    for (std::size_t n = 0; n < border.size(); ++n) {
      const int tip = place_of(border[n]);
      Star_cell made{n < ball.size() ? ball[n] : make_cell(), tip, m_cells[cell_of(border[n])]};
      made.cell.vertices[tip] = v;
      m_star.push_back(made);
    }
    for (std::size_t n = border.size(); n < ball.size(); ++n)
      drop_cell(ball[n]);
    if (border.size() <= most_of_table)
      connect_star_by_table();
    else
      connect_star_by_sorting();
    for (const Star_cell& made : m_star) {
      record(made.number);
      note(made.number);
      m_cells[made.number] = made.cell;
      for (int i = 0; i < 4; ++i)
        m_corners[made.cell.vertices[i]] = corner(made.number, i);
      connect(corner(made.number, made.tip), made.cell.mirrors[made.tip]);
    }
    return m_star.back().number;
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
    for (const Cell_index c : star) {
      note(c);
      m_cells[c].vertices[place_of(c, from)] = to;
    }
    m_corners[to] = m_corners[from];
  }
  void pop_vertex() { m_corners.pop_back(); }

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

  // Takes cells in another order: the i-th is order[i].
  void reorder(const std::vector<Cell_index>& order)
  {
    Column<Cell_index, Cell_index> number(m_cells.size(), Cell_index(0));
    for (std::size_t i = 0; i < order.size(); ++i)
      number[order[i]] = Cell_index(i);
    Column<Cell_index, Cell> cells(m_cells.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
      Cell& cell = cells[Cell_index(i)] = m_cells[order[i]];
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

  // HISTORY ---------------------------------------------------------------------------------------

  // What is noted between its begin() and end(), for visitors. Numbers of vertices are those at its
  // begin().
  Cell_history_3<Cell>& history() { return m_history; }

  // Calls f(vertices) for each cell that there was at that begin(). Call finish() before.
  template <class Function>
  void for_each_former_of_all(const Function& f) const
  {
    m_history.for_each_former_of_all(m_cells, f);
  }

  // Notes the cells of a vertex that stays where it is, and gets another name.
  void note_star(const std::vector<Cell_index>& star)
  {
    for (const Cell_index c : star)
      note(c);
  }

private:
  static Cell free_cell()
  {
    return {{null_index, null_index, null_index, null_index},
            {null_index, null_index, null_index, null_index}};
  }

  void note(Cell_index c)
  {
    if (m_history.is_on())
      m_history.note(c, vertices(c));
  }

  void record(Cell_index c)
  {
    if (m_is_recording)
      m_record.emplace_back(c, m_cells[c]);
  }

  // A cell of a star before it is written. Its mirror at the tip lies outside of the star.
  struct Star_cell
  {
    Cell_index number;
    int tip; // the place of the vertex in the middle
    Cell cell;
  };

  // Connects the cells of a star, beside the border. Each edge of the border belongs to two of
  // them, which see it in opposite directions; so a table, by the numbers that its ends get here,
  // tells the one what the other is.
  void connect_star_by_table()
  {
    const std::size_t corners = 4 * m_star.size();
    const auto vertex_at = [this](std::size_t k) { return m_star[k / 4].cell.vertices[k % 4]; };
    for (std::size_t k = 0; k < corners; ++k)
      m_corners[vertex_at(k)] = Corner_index(k); // the last one of each counts
    std::array<unsigned char, 4 * most_of_table> counted, number;
    unsigned char vertices = 0;
    for (std::size_t k = 0; k < corners; ++k) {
      counted[k] = vertices;
      vertices = static_cast<unsigned char>(vertices + (m_corners[vertex_at(k)] == k));
    }
    for (std::size_t k = 0; k < corners; ++k)
      number[k] = counted[m_corners[vertex_at(k)]];
    std::array<std::array<unsigned char, row_of_table>, row_of_table> sides;
    for_each_side([&](std::size_t k, std::size_t from, std::size_t to) {
      sides[number[from]][number[to]] = static_cast<unsigned char>(k);
    });
    for_each_side([&](std::size_t k, std::size_t from, std::size_t to) {
      const int other = sides[number[to]][number[from]];
      m_star[k / 4].cell.mirrors[k % 4] = corner(m_star[std::size_t(other / 4)].number, other % 4);
    });
  }

  // Calls f(k, from, to) for each corner of a star's cell but that at the tip, with the ends of the
  // edge of the border that is opposite to it, in the direction in which the cell sees it. Corners
  // are counted from 0.
  template <class Function>
  void for_each_side(const Function& f) const
  {
    for (std::size_t n = 0; n < m_star.size(); ++n) {
      const std::size_t tip = std::size_t(m_star[n].tip), first = 4 * n;
      for (std::size_t i = 1; i < 4; ++i) {
        // tip, side, p and q are an even permutation where the tip has an even place
        const std::size_t side = (tip + i) % 4, p = (tip + i % 3 + 1) % 4, q = 6 - tip - side - p;
        f(first + side, first + (tip % 2 == 0 ? p : q), first + (tip % 2 == 0 ? q : p));
      }
    }
  }

  // The same for any number of cells.
  void connect_star_by_sorting()
  {
    std::vector<std::pair<Few<Vertex_index, 2>, std::size_t>> sides;
    for_each_side([&](std::size_t k, std::size_t from, std::size_t to) {
      const Vertices_3& v = m_star[k / 4].cell.vertices;
      const auto [low, high] = std::minmax(v[from % 4], v[to % 4]);
      sides.push_back({{low, high}, k});
    });
    std::sort(sides.begin(), sides.end());
    for (std::size_t n = 0; n < sides.size(); ++n) {
      const std::size_t k = sides[n].second, other = sides[n ^ 1].second;
      m_star[k / 4].cell.mirrors[k % 4] = corner(m_star[other / 4].number, int(other % 4));
    }
  }

  void drop_free_ones_at_end()
  {
    while (!m_cells.empty() && m_cells.back().vertices[0] == null_index)
      m_cells.pop_back();
  }

  void move_last_cell_to(Cell_index c)
  {
    const Cell_index last(m_cells.size() - 1);
    note(last);
    const Cell cell = m_cells[last];
    m_cells[c] = cell;
    for (int i = 0; i < 4; ++i) {
      const Corner_index mirror = cell.mirrors[i];
      m_cells[cell_of(mirror)].mirrors[place_of(mirror)] = corner(c, i);
      if (m_corners[cell.vertices[i]] == corner(last, i))
        m_corners[cell.vertices[i]] = corner(c, i);
    }
    m_cells.pop_back();
  }

  Column<Cell_index, Cell> m_cells;
  std::vector<Cell_index> m_free;
  Column<Vertex_index, Corner_index> m_corners;

  // A star of so many cells has at most so many vertices: by Euler, half of it and two on the
  // border, and the tip. All corners have numbers of a byte.
  static constexpr std::size_t most_of_table = 64, row_of_table = most_of_table / 2 + 3;
  std::vector<Star_cell> m_star;

  bool m_is_recording = false;
  std::vector<std::pair<Cell_index, Cell>> m_record; // what was overwritten, in order
  std::vector<Cell_index> m_made, m_dropped;
  Cell_history_3<Cell> m_history;
};

// Whether places are an even permutation of 0, 1, 2 and 3.
inline bool is_even(const Few<int, 4>& places)
{
  int inversions = 0;
  for (int i = 0; i < 4; ++i)
    for (int j = i + 1; j < 4; ++j)
      inversions += places[i] > places[j];
  return inversions % 2 == 0;
}

// Marks cells by one of two kinds of marks, and forgets all marks in constant time.
class Cell_marks_3
{
public:
  void clear(Index cells)
  {
    make_room(cells);
    m_mark = Mark(m_mark + 2);
    if (m_mark == 0) { // all numbers are used up
      std::fill(m_marks.begin(), m_marks.end(), Mark(0));
      m_mark = 2;
    }
  }
  // For so many cells in all.
  void make_room(Index cells)
  {
    if (m_marks.size() < cells) {
      m_marks.reserve(with_reserve(cells)); // resize() alone may double it
      m_marks.resize(with_reserve(cells), Mark(0));
    }
  }
  bool has(Cell_index c) const { return m_marks[c] >= m_mark; }
  bool has(Cell_index c, Index kind) const { return m_marks[c] == m_mark + kind; }
  // Whether the cell was not marked before.
  bool insert(Cell_index c)
  {
    if (has(c))
      return false;
    insert(c, 0);
    return true;
  }
  void insert(Cell_index c, Index kind) { m_marks[c] = Mark(m_mark + kind); }

private:
  using Mark = std::uint16_t; // every 32,000th call of clear() takes linear time

  Column<Cell_index, Mark> m_marks;
  Mark m_mark = 0;
};

// Lists the cells around a vertex.
inline void find_star(const Tetrahedra_arrays_3& arrays, Vertex_index v, Cell_marks_3& marks,
                      std::vector<Cell_index>& star)
{
  star.clear();
  marks.clear(arrays.number_of_cells());
  const Cell_index first = Tetrahedra_arrays_3::cell_of(arrays.corner_of(v));
  marks.insert(first);
  star.push_back(first);
  for (std::size_t n = 0; n < star.size(); ++n) {
    const Tetrahedra_arrays_3::Cell& cell = arrays.cell(star[n]);
    for (int i = 0; i < 4; ++i)
      if (const Cell_index c = Tetrahedra_arrays_3::cell_of(cell.mirrors[i]);
          cell.vertices[i] != v && marks.insert(c))
        star.push_back(c);
  }
}

} // namespace CGAL::Dynamic_Delaunay_triangulations_3::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_TOPOLOGY_TETRAHEDRA_ARRAYS_3_H

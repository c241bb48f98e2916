// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_TOPOLOGY_CELL_ARRAYS_3_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_TOPOLOGY_CELL_ARRAYS_3_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/assertions.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Processor.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/passes/Elements_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/topology/Cell_history_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/topology/Cell_star_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/topology/Safe_cells_3.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <utility>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_3::internal {

// Tetrahedra in one flat array: for each cell its four vertices, and for each of its corners the
// mirror corner, which lies opposite to the same facet in the neighbor. So the vertex beyond a
// facet is found without a search. All cells have the same combinatorial orientation; they know no
// positions.
//
// This is what open space and a torus have in common: numbers of cells, walks, gaps, and
// transactions. A `Cell` has `vertices`, `mirrors`, `sites()` and `exchange()`, which writes only
// what differs from another cell, what `Cell_star_3` asks for, and whatever else the space needs.
template <class Cell_of_space>
class Cell_arrays_3
{
public:
  using Cell = Cell_of_space;
  using Cells = typename Cell_history_3<Cell>::Cells;
  using Star_cell = Star_cell_3<Cell>;

  // Cells that a flip has made, and their corners opposite to the facets around them: equally many
  // of each cell, in the order of the cells.
  struct Flipped
  {
    Few<Cell_index, 3> cells;
    int number;
    Few<Corner_index, 6> outer;
  };

  static constexpr std::size_t max_cells = (std::size_t(1) << 30) - 1;

  Index number_of_cells() const { return Index(m_cells.size()); }
  Index number_of_vertices() const { return Index(m_corners.size()); } // number 0 included

  const Cell& cell(Cell_index c) const { return m_cells[c]; }
  const Cell* cells() const { return m_cells.data(); }
  void prefetch(Cell_index c) const
  {
    Dynamic_Delaunay_triangulations_2::internal::prefetch(m_cells.data() + c);
  }
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

  // CHANGES ---------------------------------------------------------------------------------------

  // Vertices keep their corners, which mean nothing until they have cells again.
  void clear_cells()
  {
    if (m_history.is_on())
      m_history.give_up(m_cells);
    m_cells.clear();
    m_safe_cells.stop();
    m_log = Log();
    m_logs.clear();
  }
  // Starts with so many vertices, number 0 included, and no cells, but memory for as many as random
  // points have.
  void reset(Index vertices)
  {
    clear_cells();
    m_cells.reserve(7 * std::size_t(vertices));
    m_corners.assign(vertices, Corner_index(null_index));
  }
  void resize_vertices(Index number) { m_corners.resize(number, null_index); }
  void pop_vertex() { m_corners.pop_back(); }

  // What follows is done in all of the cells, or in one of some parts (see below).
  static constexpr std::size_t whole = std::size_t(-1);

  Cell_index make_cell(std::size_t part = whole)
  {
    if (part == whole && m_log.free.empty())
      append_free_cell();
    Log& mine = log(part);
    const Cell_index c = mine.free.back();
    mine.free.pop_back();
    if (mine.is_recording)
      mine.made.push_back(c);
    return c;
  }

  void drop_cell(Cell_index c, std::size_t part = whole)
  {
    record(c, part);
    note(c, part);
    m_cells[c] = free_cell();
    Log& mine = log(part);
    (mine.is_recording ? mine.dropped : mine.free).push_back(c);
  }

  // Lets walks around its vertex begin at a corner.
  void set_corner(Corner_index k) { m_corners[vertex(k)] = k; }
  void forget_corner(Vertex_index v) { m_corners[v] = null_index; }

  // Moves the last cells to the numbers of free ones.
  void close_gaps()
  {
    std::sort(m_log.free.begin(), m_log.free.end());
    for (const Cell_index c : m_log.free) {
      drop_free_ones_at_end();
      if (c >= m_cells.size())
        break;
      move_last_cell_to(c);
    }
    drop_free_ones_at_end();
    m_log = Log(); // in rough frames records are large
  }

  // Gives the vertex `from`, whose star is given, the number `to`.
  void renumber(Vertex_index from, Vertex_index to, const std::vector<Cell_index>& star)
  {
    for (const Cell_index c : star) {
      note(c);
      for (Vertex_index& v : m_cells[c].vertices)
        if (v == from)
          v = to;
    }
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

  // Replaces all cells by the same ones with other numbers, and with their vertices in another
  // order; of each vertex a corner is given.
  void replace_all(Cells& cells, Column<Vertex_index, Corner_index>& corners)
  {
    clear_cells();
    m_cells.swap(cells);
    m_corners.swap(corners);
  }

  // TRANSACTIONS ----------------------------------------------------------------------------------

  // Between begin() and commit() or undo(), what is overwritten is recorded.
  void begin(std::size_t part = whole)
  {
    Log& mine = log(part);
    CGAL_precondition(!mine.is_recording);
    mine.is_recording = true;
    mine.clear_lists();
  }
  // What is changed from here on, up to the next step, is undone all at once.
  void begin_step(std::size_t part = whole)
  {
    if (Log& mine = log(part); mine.is_recording)
      mine.steps.push_back({mine.record.size(), mine.made.size(), mine.dropped.size()});
  }
  void commit(std::size_t part = whole)
  {
    Log& mine = log(part);
    mine.is_recording = false;
    mine.free.insert(mine.free.end(), mine.dropped.begin(), mine.dropped.end());
  }
  void undo(std::size_t part = whole)
  {
    Log& mine = log(part);
    mine.is_recording = false;
    for (std::size_t i = mine.record.size(); i-- > 0;)
      m_cells[mine.record[i].first].exchange(mine.record[i].second);
    for (const Cell_index c : mine.made)
      m_cells[c] = free_cell();
    // not of cells that have got other neighbors only: their vertices may be of other parts. A cell
    // that had other images of the same vertices is another one
    for (const auto& [c, replaced] : mine.record)
      if (!is_free(c) && !(replaced.sites() == m_cells[c].sites()))
        for (int i = 0; i < 4; ++i)
          note_corner(corner(c, i), part);
    mine.free.insert(mine.free.end(), mine.made.begin(), mine.made.end());
  }
  // Undoes, of the steps since begin(), those that have changed one of some cells, or a cell that
  // such a step has changed; others remain, and can be undone. Appends to the cells those that are
  // as before now.
  template <class Marks>
  void undo_around(std::vector<Cell_index>& cells, Marks& marks)
  {
    marks.clear(number_of_cells());
    for (const Cell_index c : cells)
      marks.insert(c);
    const std::vector<char> is_undone = find_steps_around(marks);
    Log undone, kept;
    for (std::size_t i = 0; i < is_undone.size(); ++i)
      (is_undone[i] != 0 ? undone : kept).append_step(m_log, i);
    m_log.swap_lists(undone);
    undo();
    marks.clear(number_of_cells());
    for_each_changed([&](Cell_index c) {
      if (marks.insert(c))
        cells.push_back(c);
    });
    m_log.swap_lists(kept);
    m_log.is_recording = true;
  }
  std::size_t number_of_changes() const { return m_log.record.size(); } // since begin()
  // Calls f(c) for each cell that was changed or made since begin() and exists; for some
  // repeatedly.
  template <class Function>
  void for_each_changed(const Function& f, std::size_t part = whole) const
  {
    for (const auto& [c, cell] : log(part).record)
      if (!is_free(c))
        f(c);
  }

  // PARTS -----------------------------------------------------------------------------------------

  // Threads may change different parts of the cells at the same time, if each cell and each finite
  // vertex belongs to one part at most. Each part has free cells and transactions of its own. A
  // transaction of all that is going on when they begin records what they change.

  // Begins with free_cells(part) free cells in each part, if there are numbers for them.
  template <class Parts, class Number>
  void begin_parts(std::size_t parts, const Number& free_cells)
  {
    m_logs.resize(parts);
    std::size_t number = 0;
    for (std::size_t part = 0; part < parts; ++part)
      number += free_cells(part);
    Cell_index next(m_cells.size());
    append_free_cells<Parts>(number - (std::min)(number, m_log.free.size()));
    for (std::size_t part = 0; part < parts; ++part) {
      m_logs[part].is_recording = m_log.is_recording;
      for (std::size_t n = free_cells(part); n > 0; --n)
        if (!m_log.free.empty()) {
          m_logs[part].free.push_back(m_log.free.back());
          m_log.free.pop_back();
        } else if (next < m_cells.size()) {
          m_logs[part].free.push_back(next++);
        }
    }
    if (m_history.is_on())
      m_history.begin_parts(parts);
  }
  void end_parts()
  {
    for (Log& part : m_logs) {
      if (part.corner_at_infinity != null_index) // its last change of the hull has made this one
        m_corners[infinite_index] = part.corner_at_infinity;
      m_log.append(part);
      part = Log(); // in rough frames records are large
    }
    m_logs.clear();
    m_history.join_parts();
  }
  // Whether so many cells can be made in a part, or in all.
  bool can_make_cells(std::size_t number, std::size_t part = whole) const
  {
    const std::size_t new_ones = part == whole ? max_cells - m_cells.size() : 0;
    return number <= log(part).free.size() + new_ones;
  }
  bool can_make_cell(std::size_t part = whole) const { return can_make_cells(1, part); }

  // HISTORY ---------------------------------------------------------------------------------------

  // What is noted between its begin() and end(), for visitors. Numbers of vertices are those at its
  // begin().
  Cell_history_3<Cell>& history() { return m_history; }

  // Calls f(sites) for each cell that there was at that begin(). Call finish() before.
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

  // SAFE CELLS ------------------------------------------------------------------------------------

  // What changes a cell, or a neighbor of it, makes it unsafe.
  Safe_cells_3& safe_cells() { return m_safe_cells; }
  const Safe_cells_3& safe_cells() const { return m_safe_cells; }
  // After a vertex has moved beside a frame: of its star.
  void forget_safe_cells(const std::vector<Cell_index>& star)
  {
    for (const Cell_index c : star) {
      m_safe_cells.forget(c);
      for (int i = 0; i < 4; ++i)
        m_safe_cells.forget(neighbor(c, i));
    }
  }

protected:
  // To be called before the vertices of a cell change.
  void note(Cell_index c, std::size_t part = whole)
  {
    if (!m_history.is_on())
      return;
    if (part == whole)
      m_history.note(c, m_cells[c]);
    else
      m_history.note(c, m_cells[c], part);
  }

  // To be called before a cell gets another neighbor, as all do whose vertices change.
  void meet(Cell_index c, std::size_t part = whole)
  {
    m_safe_cells.forget(c);
    record(c, part);
  }

  // Lets walks around a vertex of a cell that has changed begin there. All parts have the infinite
  // vertex: its corner remains as it is until end_parts().
  void note_corner(Corner_index k, std::size_t part = whole)
  {
    if (part != whole && vertex(k) == infinite_index)
      m_logs[part].corner_at_infinity = k;
    else
      m_corners[vertex(k)] = k;
  }

  void record(Cell_index c, std::size_t part = whole)
  {
    if (Log& mine = log(part); mine.is_recording)
      mine.record.emplace_back(c, m_cells[c]);
  }

  // Makes the cells of a star that replaces a ball, and connects them with each other: copies of
  // the cells inside of the ball at the corners opposite to its border, in which put_vertex(cell,
  // n) puts the vertex in the middle. They have numbers, and are still to be written. The cells of
  // the ball that are not needed are dropped.
  template <class Put_vertex>
  void prepare_star(const std::vector<Cell_index>& ball, const std::vector<Corner_index>& border,
                    std::vector<Star_cell>& star, std::size_t part, const Put_vertex& put_vertex)
  {
    star.clear();
    bool is_table_ours = true; // stored at vertices; a part does not have the infinite one
    for (std::size_t n = 0; n < border.size(); ++n) {
      const Corner_index k = border[n];
      Star_cell made{n < ball.size() ? ball[n] : make_cell(part), place_of(k), m_cells[cell_of(k)]};
      put_vertex(made, n);
      is_table_ours = is_table_ours && (part == whole || !has_infinite(made.cell.vertices));
      star.push_back(made);
    }
    for (std::size_t n = border.size(); n < ball.size(); ++n)
      drop_cell(ball[n], part);
    Cell_star_3<Cell> cells(star);
    if (!is_table_ours || !cells.connect_by_table(m_corners))
      cells.connect_by_sorting();
  }
  void write(const Star_cell& made, std::size_t part)
  {
    record(made.number, part);
    note(made.number, part);
    m_cells[made.number] = made.cell;
    for (int i = 0; i < 4; ++i)
      note_corner(corner(made.number, i), part);
  }

  Cells m_cells;
  Column<Vertex_index, Corner_index> m_corners;

private:
  static Cell free_cell()
  {
    Cell cell{};
    cell.vertices = {null_index, null_index, null_index, null_index};
    cell.mirrors = {null_index, null_index, null_index, null_index};
    return cell;
  }

  // Where the changes of a step begin in each list of a log.
  struct Step
  {
    std::size_t record, made, dropped;
  };

  // What changes use up and record: of all, or of a part, in lines of the cache of its own.
  struct alignas(64) Log
  {
    void append(const Log& part)
    {
      free.insert(free.end(), part.free.begin(), part.free.end());
      if (!is_recording)
        return;
      for (const Step& step : part.steps)
        steps.push_back(
            {record.size() + step.record, made.size() + step.made, dropped.size() + step.dropped});
      append_range(record, part.record, 0, part.record.size());
      append_range(made, part.made, 0, part.made.size());
      append_range(dropped, part.dropped, 0, part.dropped.size());
    }
    void append_step(const Log& other, std::size_t i)
    {
      const Step step = other.steps[i], next = other.end_of_step(i);
      steps.push_back({record.size(), made.size(), dropped.size()});
      append_range(record, other.record, step.record, next.record);
      append_range(made, other.made, step.made, next.made);
      append_range(dropped, other.dropped, step.dropped, next.dropped);
    }
    Step end_of_step(std::size_t i) const
    {
      return i + 1 < steps.size() ? steps[i + 1] : Step{record.size(), made.size(), dropped.size()};
    }
    void clear_lists()
    {
      record.clear();
      made.clear();
      dropped.clear();
      steps.clear();
    }
    void swap_lists(Log& other)
    {
      record.swap(other.record);
      made.swap(other.made);
      dropped.swap(other.dropped);
      steps.swap(other.steps);
    }

    std::vector<Cell_index> free;
    Corner_index corner_at_infinity = null_index; // of a part that has changed the hull
    bool is_recording = false;
    std::vector<std::pair<Cell_index, Cell>> record; // what was overwritten, in order
    std::vector<Cell_index> made, dropped;
    std::vector<Step> steps;

  private:
    template <class Element>
    static void append_range(std::vector<Element>& list, const std::vector<Element>& other,
                             std::size_t first, std::size_t beyond)
    {
      list.insert(list.end(), other.begin() + std::ptrdiff_t(first),
                  other.begin() + std::ptrdiff_t(beyond));
    }
  };

  // Which steps have changed a marked cell, or a cell of another such step. Marks all their cells.
  template <class Marks>
  std::vector<char> find_steps_around(Marks& marks) const
  {
    std::vector<char> are_around(m_log.steps.size(), 0);
    for (bool has_grown = true; has_grown;) {
      has_grown = false;
      for (std::size_t i = are_around.size(); i-- > 0;)
        if (are_around[i] == 0 && mark_step(i, marks)) {
          are_around[i] = 1;
          has_grown = true;
        }
    }
    return are_around;
  }
  // If a step has changed a marked cell, marks all that it has changed.
  template <class Marks>
  bool mark_step(std::size_t i, Marks& marks) const
  {
    const auto first = m_log.record.begin() + std::ptrdiff_t(m_log.steps[i].record);
    const auto beyond = m_log.record.begin() + std::ptrdiff_t(m_log.end_of_step(i).record);
    const bool is_marked =
        std::any_of(first, beyond, [&](const auto& former) { return marks.has(former.first); });
    for (auto former = first; is_marked && former != beyond; ++former)
      marks.insert(former->first);
    return is_marked;
  }

  Log& log(std::size_t part) { return part == whole ? m_log : m_logs[part]; }
  const Log& log(std::size_t part) const { return part == whole ? m_log : m_logs[part]; }

  void append_free_cell()
  {
    if (m_cells.size() >= max_cells)
      throw std::length_error("the triangulation would have more than 2^30 - 1 cells");
    const Cell_index c(m_cells.size());
    if (m_cells.size() == m_cells.capacity()) // doubling would take 200 bytes a point
      m_cells.reserve(with_reserve(m_cells.size()));
    m_cells.push_back(free_cell());
    m_safe_cells.resize(m_cells.size());
    note(c);
    m_log.free.push_back(c);
  }

  // Appends so many free cells, which are on no list, or as many as there are numbers for. Threads
  // share them: memory that is new takes most of the time.
  template <class Parts>
  void append_free_cells(std::size_t number)
  {
    const std::size_t first = m_cells.size();
    number = (std::min)(number, max_cells - first);
    if (first + number > m_cells.capacity())
      m_cells.reserve(with_reserve(Index(first + number)));
    m_cells.resize(first + number);
    Parts::for_each_element(number,
                            [&](std::size_t i) { m_cells[Cell_index(first + i)] = free_cell(); });
    m_safe_cells.resize(m_cells.size());
    for (Cell_index c(first); m_history.is_on() && c < m_cells.size(); ++c)
      note(c);
  }

  void drop_free_ones_at_end()
  {
    while (!m_cells.empty() && m_cells.back().vertices[0] == null_index)
      m_cells.pop_back();
    m_safe_cells.resize(m_cells.size());
  }

  void move_last_cell_to(Cell_index c)
  {
    const Cell_index last(m_cells.size() - 1);
    m_safe_cells.move(last, c);
    note(last);
    const Cell& cell = m_cells[c] = m_cells[last]; // none of its neighbors is itself
    for (int i = 0; i < 4; ++i) {
      const Corner_index mirror = cell.mirrors[i];
      m_cells[cell_of(mirror)].mirrors[place_of(mirror)] = corner(c, i);
      if (m_corners[cell.vertices[i]] == corner(last, i))
        m_corners[cell.vertices[i]] = corner(c, i);
    }
    m_cells.pop_back();
  }

  Log m_log;
  std::vector<Log> m_logs; // of parts, between begin_parts() and end_parts()
  Cell_history_3<Cell> m_history;
  Safe_cells_3 m_safe_cells;
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

// Lists the cells around a vertex, each once, also one that has several images of it. `Marks` are
// those of all cells, or a set of few. In a part (see Cell_arrays_3) to which the vertex belongs,
// nothing is read that changes in another part.
template <class Cell, class Marks>
void find_star(const Cell_arrays_3<Cell>& arrays, Vertex_index v, Marks& marks,
               std::vector<Cell_index>& star)
{
  star.clear();
  marks.clear(arrays.number_of_cells());
  const Cell_index first = arrays.cell_of(arrays.corner_of(v));
  marks.insert(first);
  star.push_back(first);
  for (std::size_t n = 0; n < star.size(); ++n) {
    const Cell& cell = arrays.cell(star[n]);
    int images = 0;
    if constexpr (Cell::may_repeat_vertices)
      for (const Vertex_index w : cell.vertices)
        images += w == v;
    for (int i = 0; i < 4; ++i)
      if (cell.vertices[i] != v || images > 1)
        if (const Cell_index c = arrays.cell_of(cell.mirrors[i]); marks.insert(c)) {
          arrays.prefetch(c);
          star.push_back(c);
        }
  }
}

} // namespace CGAL::Dynamic_Delaunay_triangulations_3::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_TOPOLOGY_CELL_ARRAYS_3_H

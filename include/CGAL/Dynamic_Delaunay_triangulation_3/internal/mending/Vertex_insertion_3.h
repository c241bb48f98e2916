// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_MENDING_VERTEX_INSERTION_3_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_MENDING_VERTEX_INSERTION_3_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/proof/Cell_signs_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/topology/Tetrahedra_arrays_3.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_3::internal {

// Inserts vertices into cells that are Delaunay: the cells whose spheres contain the vertex are
// replaced by cells from their boundary to it (Bowyer 1981, Watson 1981). The cells may be those of
// the state, or others with its vertices. Nothing depends on the origin.
template <class State>
class Vertex_insertion_3
{
  using Arrays = Tetrahedra_arrays_3;

public:
  explicit Vertex_insertion_3(State& state)
    : Vertex_insertion_3(state, state.arrays, state.marks)
  {
  }
  Vertex_insertion_3(const State& state, Arrays& arrays, Cell_marks_3& marks)
    : m_arrays(arrays)
    , m_marks(marks)
    , m_signs(state)
    , m_state(state)
  {
  }

  // Starts with one cell and its four neighbors, which are infinite. The vertices must not be
  // coplanar.
  void begin(Vertices_3 v)
  {
    if (!m_signs.is_positive(v))
      std::swap(v[0], v[1]);
    Few<Cell_index, 5> cells;
    for (Cell_index& c : cells)
      c = m_arrays.make_cell();
    m_arrays.set_vertices(cells[4], v);
    for (int i = 0; i < 4; ++i) {
      Vertices_3 w = v; // two exchanged, and the infinite vertex in place of one
      std::swap(w[(i + 1) % 4], w[(i + 2) % 4]);
      w[i] = infinite_index;
      m_arrays.set_vertices(cells[i], w);
      m_arrays.connect(Arrays::corner(cells[4], i), Arrays::corner(cells[i], i));
    }
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < i; ++j)
        m_arrays.connect(Arrays::corner(cells[i], m_arrays.place_of(cells[i], v[j])),
                         Arrays::corner(cells[j], m_arrays.place_of(cells[j], v[i])));
    m_last = cells[4];
  }

  // Lets the next walk begin at a cell.
  void start_at(Cell_index c) { m_last = c; }
  Cell_index last() const { return m_last; }

  // Inserts a vertex. Returns null_index, or the vertex that is at this point already.
  Vertex_index insert(Vertex_index v)
  {
    const Cell_index c = locate(v);
    if (!is_in_conflict(c, v)) {
      for (const Vertex_index w : m_arrays.vertices(c))
        if (w != infinite_index && m_state.coincide(m_state.point(v), m_state.point(w)))
          return w;
    }
    find_conflicts(c, v);
    m_last = m_arrays.replace_by_star(m_conflicts, m_border, v);
    return null_index;
  }

private:
  // Walks to the cell that contains a vertex, or to an infinite cell that it is beyond.
  Cell_index locate(Vertex_index v)
  {
    Cell_index c = m_last, before = null_index;
    if (const int place = m_arrays.place_of(c, infinite_index); place < 4)
      c = m_arrays.neighbor(c, place);
    for (bool goes_on = true; goes_on && !m_arrays.is_infinite(c);) {
      goes_on = false;
      for (int i = 0; i < 4 && !goes_on; ++i) {
        const Cell_index next = m_arrays.neighbor(c, i);
        if (next != before && m_signs.with(m_arrays.vertices(c), i, v) < 0) {
          before = c;
          c = next;
          goes_on = true;
        }
      }
    }
    return c;
  }

  // Whether the vertex is strictly inside of a cell's sphere. An infinite cell contains what is
  // strictly beyond its hull facet, and of the facet's plane what its finite neighbor contains: so
  // no flat cell can arise.
  bool is_in_conflict(Cell_index c, Vertex_index v) const
  {
    const Vertices_3& w = m_arrays.vertices(c);
    const int place = m_arrays.place_of(c, infinite_index);
    if (place == 4)
      return m_signs.side_of_sphere(w, v) > 0;
    if (const int sign = m_signs.with(w, place, v))
      return sign > 0;
    return m_signs.side_of_sphere(m_arrays.vertices(m_arrays.neighbor(c, place)), v) > 0;
  }

  // Finds the cells in conflict, and the facets of their border. The cells beyond these facets are
  // marked, too, so that each is tested once.
  void find_conflicts(Cell_index first, Vertex_index v)
  {
    m_conflicts.clear();
    m_border.clear();
    m_marks.clear(m_arrays.number_of_cells());
    m_marks.insert(first, conflicting);
    m_conflicts.push_back(first);
    for (std::size_t n = 0; n < m_conflicts.size(); ++n) {
      const Cell_index c = m_conflicts[n];
      for (int i = 0; i < 4; ++i) {
        const Cell_index next = m_arrays.neighbor(c, i);
        if (!m_marks.has(next)) {
          const bool conflicts = is_in_conflict(next, v);
          m_marks.insert(next, conflicts ? conflicting : bordering);
          if (conflicts)
            m_conflicts.push_back(next);
        }
        if (!m_marks.has(next, conflicting))
          m_border.push_back(Arrays::corner(c, i));
      }
    }
  }

  static constexpr Index bordering = 0, conflicting = 1; // kinds of marks

  Arrays& m_arrays;
  Cell_marks_3& m_marks; // of the cells of these arrays
  Cell_signs_3<State> m_signs;
  const State& m_state;
  Cell_index m_last{0};
  std::vector<Cell_index> m_conflicts;
  std::vector<Corner_index> m_border; // corners of cells in conflict, opposite to others
};

// Finds four vertices of a list that are not coplanar, and moves them to its front. Returns whether
// there are such.
template <class State>
bool begins_with_a_cell(const State& state, std::vector<Vertex_index>& vertices)
{
  const auto point = [&](std::size_t i) ->
      typename State::Point { return state.point(vertices[i]); };
  const auto bring = [&](std::size_t place, const auto& is_right) {
    for (std::size_t i = place; i < vertices.size(); ++i)
      if (is_right(point(i))) {
        std::swap(vertices[place], vertices[i]);
        return true;
      }
    return false;
  };
  using Point = typename State::Point;
  const auto are_collinear = state.traits.collinear_3_object();
  const auto orientation = state.traits.orientation_3_object();
  return vertices.size() >= 4 &&
         bring(1, [&](const Point& p) { return !state.coincide(point(0), p); }) &&
         bring(2, [&](const Point& p) { return !are_collinear(point(0), point(1), p); }) &&
         bring(3, [&](const Point& p) {
           return orientation(point(0), point(1), point(2), p) != COPLANAR;
         });
}

} // namespace CGAL::Dynamic_Delaunay_triangulations_3::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_MENDING_VERTEX_INSERTION_3_H

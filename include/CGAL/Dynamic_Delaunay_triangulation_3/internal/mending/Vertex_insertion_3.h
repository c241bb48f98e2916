// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_MENDING_VERTEX_INSERTION_3_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_MENDING_VERTEX_INSERTION_3_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/proof/Cell_signs_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/topology/Cell_set_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/topology/Tetrahedra_arrays_3.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <type_traits>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_3::internal {

// Lets any cell be replaced.
struct Everywhere_3
{
  static constexpr std::size_t part = Tetrahedra_arrays_3::whole;
  static constexpr bool has(const Vertices_3&) { return true; }
};

// The vertex that is inserted comes after those that have cells.
struct Order_of_insertion_3
{
};

// Inserts vertices into cells that are Delaunay: the cells whose spheres contain the vertex are
// replaced by cells from their boundary to it (Bowyer 1981, Watson 1981). The cells may be those of
// the state, or others with its vertices. Nothing depends on the origin.
//
// No cell is replaced because of a tie. With another `Order`, all cells have to be made with that
// one from the first on; then they are those that insertion in that order leads to.
//
// A `Region` says which cells may be replaced, by has(vertices), and in what `part` of the arrays.
// At most one region has all vertices of a cell. So threads may insert in different regions at the
// same time: what shares a facet with a cell of a region has three vertices there, and is replaced
// by no other thread.
template <class State, class Order = Order_of_insertion_3, class Region = Everywhere_3>
class Vertex_insertion_3
{
  using Arrays = Tetrahedra_arrays_3;

public:
  explicit Vertex_insertion_3(State& state, const Region& region = Region())
    : Vertex_insertion_3(state, state.arrays, region)
  {
  }
  Vertex_insertion_3(const State& state, Arrays& arrays, const Region& region = Region())
    : m_arrays(arrays)
    , m_signs(state)
    , m_state(state)
    , m_region(region)
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

  // Inserts a vertex. Returns null_index, or the vertex that is at this point already, or the given
  // one if that takes cells that are not in the region, or not there yet.
  Vertex_index insert(Vertex_index v)
  {
    const Cell_index c = locate(v);
    if (!m_region.has(m_arrays.vertices(c)))
      return v;
    m_last = c;
    if (const Vertex_index other = coincident_vertex(c, v); other != null_index)
      return other;
    if (!find_conflicts(c, v))
      return v;
    m_last = m_arrays.replace_by_star(m_conflicts, m_border, v, m_star, m_region.part);
    return null_index;
  }

  template <class Flips>
  Vertex_index insert(Vertex_index v, Flips&) // no flips have to follow
  {
    return insert(v);
  }

  // Walks to the cell that contains a vertex, or to an infinite cell that it is beyond. Where all
  // ways on leave the region, it returns the first cell outside.
  Cell_index locate(Vertex_index v) const
  {
    Cell_index c = m_last, before = null_index;
    if (const int place = m_arrays.place_of(c, infinite_index); place < 4)
      c = m_arrays.neighbor(c, place);
    while (!m_arrays.is_infinite(c) && m_region.has(m_arrays.vertices(c))) {
      const Cell_index next = next_towards(v, c, before);
      if (next == null_index)
        break;
      before = c;
      c = next;
    }
    return c;
  }

private:
  // The neighbor of a cell that a walk goes to, not back, or null_index at its end.
  Cell_index next_towards(Vertex_index v, Cell_index c, Cell_index before) const
  {
    Cell_index outside = null_index;
    for (int i = 0; i < 4; ++i) {
      const Cell_index next = m_arrays.neighbor(c, i);
      if (next == before || m_signs.with(m_arrays.vertices(c), i, v) >= 0)
        continue;
      if (m_region.has(m_arrays.vertices(next)))
        return next;
      outside = next;
    }
    return outside;
  }

  // The vertex of a cell that contains v which is where v is, or null_index.
  Vertex_index coincident_vertex(Cell_index c, Vertex_index v) const
  {
    const Vertices_3& w = m_arrays.vertices(c);
    if (has_infinite(w) || m_signs.side_of_sphere(w, v) > 0)
      return null_index;
    for (const Vertex_index other : w)
      if (m_state.coincide(m_state.point(v), m_state.point(other)))
        return other;
    return null_index;
  }

  // Whether the vertex is strictly inside of a cell's sphere. An infinite cell contains what is
  // strictly beyond its hull facet, and of the facet's plane what its finite neighbor contains: so
  // no flat cell can arise.
  bool is_in_conflict(Cell_index c, Vertex_index v) const
  {
    const Vertices_3& w = m_arrays.vertices(c);
    const int place = m_arrays.place_of(c, infinite_index);
    if (place == 4)
      return is_inside(w, v);
    if (const int sign = m_signs.with(w, place, v))
      return sign > 0;
    return is_inside(m_arrays.vertices(m_arrays.neighbor(c, place)), v);
  }
  bool is_inside(const Vertices_3& w, Vertex_index v) const
  {
    if constexpr (std::is_same_v<Order, Order_of_insertion_3>)
      return m_signs.side_of_sphere(w, v) > 0;
    else
      return m_signs.side_of_sphere_in_order(w, v, Order()) > 0;
  }

  // Finds the cells in conflict, and the facets of their border; false if not all of these cells
  // are in the region, or there are not enough free ones. The cells beyond these facets are noted,
  // too, so that each is tested once.
  bool find_conflicts(Cell_index first, Vertex_index v)
  {
    m_conflicts.assign(1, first);
    m_entries.assign(1, Corner_index(null_index));
    m_border.clear();
    m_tested.clear(m_arrays.number_of_cells());
    m_tested.insert(first, conflicting);
    for (std::size_t n = 0; n < m_conflicts.size(); ++n)
      for (int i = 0; i < 4; ++i) {
        const Corner_index k = Arrays::corner(m_conflicts[n], i);
        if (k == m_entries[n])
          continue;
        const Corner_index entry = m_arrays.mirror(k);
        const auto [kind, note] = m_tested.find_or_insert(Arrays::cell_of(entry), [&] {
          return Cell_set_3::Noted{kind_beyond(entry, v), {}};
        });
        if (kind == out_of_region)
          return false;
        if (kind == bordering)
          m_border.push_back(k);
      }
    return m_region.part == Arrays::whole || m_border.size() <= m_conflicts.size() ||
           m_arrays.can_make_cells(m_border.size() - m_conflicts.size(), m_region.part);
  }

  // Tests the cell of a corner, and lists it if it is in conflict, and in the region.
  Index kind_beyond(Corner_index entry, Vertex_index v)
  {
    const Cell_index c = Arrays::cell_of(entry);
    if (!is_in_conflict(c, v))
      return bordering;
    if (!m_region.has(m_arrays.vertices(c)))
      return out_of_region;
    m_conflicts.push_back(c);
    m_entries.push_back(entry);
    return conflicting;
  }

  static constexpr Index bordering = 0, conflicting = 1, out_of_region = 2; // kinds of cells

  Arrays& m_arrays;
  Cell_signs_3<State> m_signs;
  const State& m_state;
  Region m_region;
  Cell_index m_last{0};
  Cell_set_3 m_tested;
  std::vector<Cell_index> m_conflicts;
  std::vector<Corner_index> m_entries; // of each the corner opposite to where it was found
  std::vector<Corner_index> m_border;  // corners of cells in conflict, opposite to others
  std::vector<Arrays::Star_cell> m_star;
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

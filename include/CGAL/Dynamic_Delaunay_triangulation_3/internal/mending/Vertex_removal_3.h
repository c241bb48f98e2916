// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_MENDING_VERTEX_REMOVAL_3_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_MENDING_VERTEX_REMOVAL_3_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/mending/Lawson_flips_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/mending/Vertex_insertion_3.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_3::internal {

// Takes vertices out of cells that are Delaunay. The vertices around the hole are triangulated
// alone; of these cells, those inside of the hole fill it. Where points are cospherical, a facet of
// the hole may be missing among them: then the hole grows across it.
template <class State>
class Vertex_removal_3
{
  using Arrays = Tetrahedra_arrays_3;

public:
  explicit Vertex_removal_3(State& state)
    : m_state(state)
    , m_signs(state)
    , m_filling_insertion(state, m_filling)
  {
  }

  // Takes a vertex out, and opens the facets of new cells. Returns whether that has succeeded, and
  // changes nothing else. The vertex keeps its number, without cells.
  bool remove(Vertex_index v, Lawson_flips_3<State>& flips)
  {
    find_star(arrays(), v, m_state.marks, m_hole);
    while (m_hole.size() <= most_cells) {
      find_border(v);
      if (triangulate_around() && match_border() && find_inside())
        return are_new_cells_positive() && fill(flips);
      if (m_growth.empty())
        for (const Border& border : m_border)
          m_growth.push_back(Arrays::cell_of(border.outside));
      if (!grow())
        return false;
    }
    return false;
  }

private:
  static constexpr std::size_t most_cells = 20000;

  using Facet = Few<Vertex_index, 3>; // ascending

  struct Border
  {
    Facet facet;
    Corner_index inside, outside;
    Cell_index filling; // the cell that fills the hole there
  };

  Arrays& arrays() { return m_state.arrays; }
  const Arrays& arrays() const { return m_state.arrays; }

  static Facet facet_of(const Arrays& arrays, Corner_index k)
  {
    const Vertices_3& v = arrays.vertices(Arrays::cell_of(k));
    Facet facet;
    int number = 0;
    for (int i = 0; i < 4; ++i)
      if (i != Arrays::place_of(k))
        facet[number++] = v[i];
    std::sort(facet.begin(), facet.end());
    return facet;
  }

  // Lists the facets between the hole and the rest, sorted, and the vertices around.
  void find_border(Vertex_index v)
  {
    m_state.marks.clear(arrays().number_of_cells());
    for (const Cell_index c : m_hole)
      m_state.marks.insert(c);
    m_border.clear();
    m_around.clear();
    m_growth.clear();
    m_reaches_infinity = false;
    for (const Cell_index c : m_hole)
      for (int i = 0; i < 4; ++i) {
        const Corner_index k = Arrays::corner(c, i);
        const Vertex_index w = arrays().vertex(k);
        m_reaches_infinity = m_reaches_infinity || w == infinite_index;
        if (w != v && w != infinite_index)
          m_around.push_back(w);
        if (!m_state.marks.has(Arrays::cell_of(arrays().mirror(k))))
          m_border.push_back({facet_of(arrays(), k), k, arrays().mirror(k), null_index});
      }
    std::sort(m_border.begin(), m_border.end(),
              [](const Border& a, const Border& b) { return a.facet < b.facet; });
    std::sort(m_around.begin(), m_around.end());
    m_around.erase(std::unique(m_around.begin(), m_around.end()), m_around.end());
  }

  Border* find_facet(const Facet& facet)
  {
    const auto place =
        std::lower_bound(m_border.begin(), m_border.end(), facet,
                         [](const Border& border, const Facet& f) { return border.facet < f; });
    return place != m_border.end() && place->facet == facet ? &*place : nullptr;
  }

  bool triangulate_around()
  {
    if (!begins_with_a_cell(m_state, m_around))
      return false;
    m_filling.clear_cells();
    m_filling.resize_vertices(arrays().number_of_vertices());
    m_filling_insertion.begin({m_around[0], m_around[1], m_around[2], m_around[3]});
    for (std::size_t i = 4; i < m_around.size(); ++i)
      m_filling_insertion.insert(m_around[i]);
    m_filling.close_gaps();
    return true;
  }

  // Finds the filling cell at each facet of the border. Where there is none, the hole has to grow.
  bool match_border()
  {
    m_border_at.assign(4 * std::size_t(m_filling.number_of_cells()), nullptr);
    for (Cell_index c(0); c < m_filling.number_of_cells(); ++c)
      for (int i = 0; i < 4; ++i) {
        const Corner_index k = Arrays::corner(c, i), mirror = m_filling.mirror(k);
        if (mirror < k)
          continue;
        if (Border* const border = find_facet(facet_of(m_filling, k)))
          for (const Corner_index side : {k, mirror}) {
            m_border_at[side] = border;
            if (are_on_same_side(side, border->inside))
              border->filling = Arrays::cell_of(side);
          }
      }
    for (const Border& border : m_border)
      if (border.filling == null_index)
        m_growth.push_back(Arrays::cell_of(border.outside));
    return m_growth.empty();
  }

  // Whether a cell of the filling and one of the hole, with a facet in common, lie on the same side
  // of it: their vertices at this facet have the same orientation.
  bool are_on_same_side(Corner_index filling, Corner_index hole) const
  {
    const Vertices_3& v = m_filling.vertices(Arrays::cell_of(filling));
    Few<int, 4> places;
    for (int i = 0; i < 4; ++i)
      places[i] = i == Arrays::place_of(filling) ? Arrays::place_of(hole)
                                                 : arrays().place_of(Arrays::cell_of(hole), v[i]);
    return is_even(places);
  }

  // Collects the filling cells inside of the border. False if they leak out.
  bool find_inside()
  {
    m_inside.clear();
    m_filling_marks.clear(m_filling.number_of_cells());
    const auto add = [this](Cell_index c) {
      if (m_filling_marks.insert(c))
        m_inside.push_back(c);
    };
    if (m_border.empty()) // the hole has grown over all cells
      for (Cell_index c(0); c < m_filling.number_of_cells(); ++c)
        add(c);
    for (const Border& border : m_border)
      add(border.filling);
    std::size_t met = 0;
    for (std::size_t n = 0; n < m_inside.size(); ++n) {
      if (!m_reaches_infinity && m_filling.is_infinite(m_inside[n]))
        return false; // it leaks
      for (int i = 0; i < 4; ++i) {
        const Corner_index k = Arrays::corner(m_inside[n], i);
        if (m_border_at[k] != nullptr)
          ++met;
        else
          add(Arrays::cell_of(m_filling.mirror(k)));
      }
    }
    return met == m_border.size();
  }

  // Adds cells to the hole. False if it has all of them.
  bool grow()
  {
    const std::size_t before = m_hole.size();
    m_state.marks.clear(arrays().number_of_cells());
    for (const Cell_index c : m_hole)
      m_state.marks.insert(c);
    for (const Cell_index c : m_growth)
      if (m_state.marks.insert(c))
        m_hole.push_back(c);
    return m_hole.size() > before;
  }

  // The hull shrinks where a vertex of the hull goes: the origin may not be inside of it any more.
  bool are_new_cells_positive() const
  {
    for (const Cell_index c : m_inside)
      if (!m_signs.is_positive(m_filling.vertices(c)))
        return false;
    return true;
  }

  bool fill(Lawson_flips_3<State>& flips)
  {
    for (const Cell_index c : m_hole)
      arrays().drop_cell(c);
    m_number.assign(m_filling.number_of_cells(), Cell_index(null_index));
    for (const Cell_index c : m_inside) {
      m_number[c] = arrays().make_cell();
      arrays().set_vertices(m_number[c], m_filling.vertices(c));
    }
    for (const Cell_index c : m_inside)
      for (int i = 0; i < 4; ++i) {
        const Corner_index k = Arrays::corner(c, i), mirror = m_filling.mirror(k);
        const Border* const border = m_border_at[k];
        arrays().connect(Arrays::corner(m_number[c], i),
                         border != nullptr ? border->outside
                                           : Arrays::corner(m_number[Arrays::cell_of(mirror)],
                                                            Arrays::place_of(mirror)));
      }
    for (const Cell_index c : m_inside)
      flips.open_cell(m_number[c]);
    return true;
  }

  State& m_state;
  Cell_signs_3<State> m_signs;
  Arrays m_filling; // a triangulation of the vertices around the hole
  Cell_marks_3 m_filling_marks;
  Vertex_insertion_3<State> m_filling_insertion;
  std::vector<Cell_index> m_hole, m_growth, m_inside;
  std::vector<Border> m_border;
  Column<Corner_index, Border*> m_border_at; // of corners of the filling: what is opposite, or null
  std::vector<Vertex_index> m_around;
  Column<Cell_index, Cell_index> m_number;
  bool m_reaches_infinity = false;
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_3::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_MENDING_VERTEX_REMOVAL_3_H

// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_PERIODIC_TORUS_INSERTION_3_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_PERIODIC_TORUS_INSERTION_3_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/periodic/Torus_state_3.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_3::internal {

// Inserts vertices into Delaunay cells of a torus: the cells whose spheres contain an image of the
// vertex are replaced by cells from their boundary to it. That fails if two of these cells are
// images of each other, or of neighbors, as among few points, or above all others in a slab, or
// outside of the hull of a wire: then the images of the vertex are in each other's way.
template <class State>
class Torus_insertion_3
{
  using Arrays = Torus_cells_3;

public:
  explicit Torus_insertion_3(State& state)
    : m_state(state)
    , m_signs(state)
  {
  }

  // Lets the next walk begin at a cell.
  void start_at(Cell_index c) { m_last = c; }
  // A cell of the vertex that was inserted last.
  Cell_index last() const { return m_last; }

  // Inserts a vertex, which has a place and no cells. Returns null_index, or the vertex that it
  // coincides with; nothing if its images are in each other's way: then cells are as they were.
  std::optional<Vertex_index> insert(Vertex_index v)
  {
    const auto [c, site] = locate(v);
    if (!is_in_conflict(c, site)) // only vertices of a cell are in it and on its sphere
      for (const Torus_site_3& s : arrays().sites(c))
        if (!s.is_infinite() &&
            m_signs.predicates().coincide(m_state.image(s), m_state.image(site)))
          return s.vertex;
    if (!find_conflicts(c, site))
      return std::nullopt;
    replace_conflicts(v);
    m_last = m_made.back();
    return Vertex_index(null_index);
  }

private:
  // A cell in conflict, and the shift of the vertex's image there, in the cell's chart.
  struct Conflict
  {
    Cell_index cell;
    Torus_shift_3 shift;
  };

  Arrays& arrays() { return m_state.arrays; }
  const Arrays& arrays() const { return m_state.arrays; }

  bool is_in_conflict(Cell_index c, const Torus_site_3& site) const
  {
    return m_signs.side_of_sphere(arrays().sites(c), site) > 0;
  }

  // Walks to a cell that contains an image of a vertex, and returns that image in its chart. In
  // Delaunay cells no such walk goes in a circle. In a wire it goes through finite cells alone, and
  // ends in an infinite one if the image is beyond its hull facet.
  std::pair<Cell_index, Torus_site_3> locate(Vertex_index v)
  {
    Cell_index c = m_last;
    const Torus_site_3 start = arrays().first_finite_site(c);
    const Position_3 way = m_state.position(start) - m_state.positions.position(v);
    const Multiples_3 nearest = Torus_3::nearest(m_state.torus.fractions(way));
    Torus_site_3 site{v, Torus_shift_3::of(nearest)};
    Corner_index entrance = null_index;
    if (m_state.torus.is_wire() && arrays().is_infinite(c)) {
      const Corner_index k = Arrays::corner(c, infinite_place(arrays().sites(c)));
      site.shift = site.shift - arrays().translation(k);
      c = Arrays::cell_of(arrays().mirror(k));
    }
    for (bool goes_on = true; goes_on;) {
      goes_on = false;
      if (m_state.torus.is_wire() && arrays().is_infinite(c))
        break;
      const Torus_sites_3 sites = arrays().sites(c);
      for (int i = 0; i < 4 && !goes_on; ++i) {
        const Corner_index k = Arrays::corner(c, i);
        if (k != entrance && m_signs.with(sites, i, site) < 0) {
          site.shift = site.shift - arrays().translation(k);
          entrance = arrays().mirror(k);
          c = Arrays::cell_of(entrance);
          goes_on = true;
        }
      }
    }
    return {c, site};
  }

  // Finds the cells in conflict, and the facets of their border. False if two cells are images of
  // each other, or what lies beyond the border is an image of a cell in conflict: there the images
  // of the vertex would be in conflict with each other's new cells.
  bool find_conflicts(Cell_index first, const Torus_site_3& site)
  {
    m_conflicts.clear();
    m_border.clear();
    Cell_marks_3& marks = m_state.marks;
    marks.clear(arrays().number_of_cells());
    if (m_shift.size() < arrays().number_of_cells())
      m_shift.resize(with_reserve(arrays().number_of_cells()));
    marks.insert(first, conflicting);
    m_shift[first] = site.shift;
    m_conflicts.push_back({first, site.shift});
    for (std::size_t n = 0; n < m_conflicts.size(); ++n) {
      const auto [c, here] = m_conflicts[n];
      for (int i = 0; i < 4; ++i) {
        const Corner_index k = Arrays::corner(c, i);
        const Cell_index next = Arrays::cell_of(arrays().mirror(k));
        const Torus_shift_3 there = here - arrays().translation(k);
        if (marks.has(next, conflicting)) {
          if (m_shift[next] != there)
            return false;
          continue;
        }
        if (marks.has(next, bordering) && m_shift[next] == there) {
          m_border.push_back({k, here});
          continue;
        }
        if (is_in_conflict(next, {site.vertex, there})) {
          marks.insert(next, conflicting);
          m_shift[next] = there;
          m_conflicts.push_back({next, there});
          continue;
        }
        if (!marks.has(next)) {
          marks.insert(next, bordering);
          m_shift[next] = there;
        }
        m_border.push_back({k, here});
      }
    }
    return std::none_of(m_border.begin(), m_border.end(), [&](const Border& border) {
      return marks.has(Arrays::cell_of(arrays().mirror(border.corner)), conflicting);
    });
  }

  // Replaces the cells in conflict by cells over their border, in the chart in which the vertex has
  // the shift 0.
  void replace_conflicts(Vertex_index v)
  {
    const std::size_t cells = m_border.size();
    m_made.clear();
    m_outer.clear();
    m_sites.clear();
    for (std::size_t n = 0; n < cells; ++n) {
      const auto [k, shift] = m_border[n];
      m_made.push_back(n < m_conflicts.size() ? m_conflicts[n].cell : arrays().make_cell());
      Torus_sites_3 sites = arrays().sites(Arrays::cell_of(k));
      for (Torus_site_3& s : sites)
        s = s - shift;
      sites[Arrays::place_of(k)] = {v, {}};
      m_sites.push_back(sites);
      m_outer.push_back({k, Arrays::corner(m_made[n], Arrays::place_of(k)), -shift});
    }
    arrays().read_mirrors(m_outer);
    for (std::size_t n = cells; n < m_conflicts.size(); ++n)
      arrays().drop_cell(m_conflicts[n].cell);
    for (std::size_t n = 0; n < cells; ++n)
      arrays().set_sites(m_made[n], m_sites[n]);
    connect_star();
    arrays().connect_outer(m_outer, [](Cell_index) { return false; });
    for (const Cell_index c : m_made)
      arrays().normalize(c);
  }

  // Connects the new cells with each other, beside the border: each edge of the border belongs to
  // two of them. A table finds the one to the other.
  void connect_star()
  {
    std::size_t size = 64;
    while (size < 6 * m_made.size())
      size *= 2;
    m_table.assign(size, Side());
    for (std::size_t n = 0; n < m_made.size(); ++n) {
      const int tip = Arrays::place_of(m_border[n].corner);
      for (int side = 0; side < 4; ++side)
        if (side != tip)
          connect_side(n, tip, side);
    }
  }
  void connect_side(std::size_t n, int tip, int side)
  {
    int p = 0;
    while (p == tip || p == side)
      ++p;
    const int q = 6 - tip - side - p;
    Torus_site_3 low = m_sites[n][p], high = m_sites[n][q];
    if (high < low)
      std::swap(low, high);
    const Corner_index k = Arrays::corner(m_made[n], side);
    const std::size_t mask = m_table.size() - 1;
    for (std::size_t i = hash(low, high) & mask;; i = (i + 1) & mask) {
      Side& entry = m_table[i];
      if (entry.corner == null_index) {
        entry = {k, low, high};
        return;
      }
      if (entry.low == low && entry.high == high) {
        arrays().connect(k, entry.corner, {});
        return;
      }
    }
  }
  static std::size_t hash(const Torus_site_3& low, const Torus_site_3& high)
  {
    const auto bits = [](const Torus_site_3& s) {
      return std::uint64_t(Index(s.vertex)) << 32 | std::uint32_t(s.shift.code);
    };
    const std::uint64_t mixed = bits(low) * 0x9e3779b97f4a7c15u + bits(high) * 0xc2b2ae3d27d4eb4fu;
    return std::size_t((mixed ^ mixed >> 31) * 0x94d049bb133111ebu >> 20);
  }

  struct Border
  {
    Corner_index corner; // of the cell in conflict, opposite to the facet
    Torus_shift_3 shift; // of the vertex's image in its chart
  };
  struct Side
  {
    Corner_index corner = Corner_index(null_index);
    Torus_site_3 low = {}, high = {};
  };

  static constexpr Index bordering = 0, conflicting = 1; // kinds of marks

  State& m_state;
  Torus_signs_3<State> m_signs;
  Cell_index m_last{0};
  std::vector<Conflict> m_conflicts;
  std::vector<Border> m_border;
  Column<Cell_index, Torus_shift_3> m_shift; // of the image in marked cells
  std::vector<Cell_index> m_made;
  std::vector<Torus_sites_3> m_sites; // of the cells made
  std::vector<Arrays::Outer_facet> m_outer;
  std::vector<Side> m_table;
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_3::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_PERIODIC_TORUS_INSERTION_3_H

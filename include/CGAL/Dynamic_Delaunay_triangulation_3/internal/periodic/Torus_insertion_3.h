// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_PERIODIC_TORUS_INSERTION_3_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_PERIODIC_TORUS_INSERTION_3_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/mending/Vertex_insertion_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/periodic/Torus_state_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/topology/Cell_set_3.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_3::internal {

// Inserts vertices into Delaunay cells of a torus: the cells whose spheres contain an image of the
// vertex are replaced by cells from their boundary to it. That fails if two of these cells are
// images of each other, or of neighbors, as among few points, or above all others in a slab, or
// outside of the hull of a wire: then the images of the vertex are in each other's way. But the one
// cell that contains the vertex can be divided, which leaves it to flips to make all Delaunay.
//
// A `Region` says which cells may be replaced, as that of `Vertex_insertion_3`.
template <class State, class Region = Everywhere_3>
class Torus_insertion_3
{
  using Arrays = Torus_cells_3;

public:
  explicit Torus_insertion_3(State& state, const Region& region = Region())
    : m_arrays(state.arrays)
    , m_state(state)
    , m_signs(state)
    , m_region(region)
  {
  }

  // Lets the next walk begin at a cell.
  void start_at(Cell_index c) { m_last = c; }
  // A cell of the vertex that was inserted last, or that contains an image of it.
  Cell_index last() const { return m_last; }

  // Inserts a vertex, which has a place and no cells. Returns null_index; or the vertex that it
  // coincides with; or the given one if its images are in each other's way, or it takes cells that
  // are not in the region, or not there yet: then cells are as they were.
  Vertex_index insert(Vertex_index v)
  {
    const auto [c, site] = walk_to(v);
    if (!m_region.has(m_arrays.vertices(c)))
      return v;
    m_last = c;
    if (!is_in_conflict(c, site)) // only vertices of a cell are in it and on its sphere
      for (const Torus_site_3& s : m_arrays.sites(c))
        if (!s.is_infinite() &&
            m_signs.predicates().coincide(m_state.image(s), m_state.image(site)))
          return s.vertex;
    if (!find_conflicts(c, site))
      return v;
    m_last =
        m_arrays.replace_by_star(m_conflicts, m_border, m_border_shifts, v, m_star, m_region.part);
    return null_index;
  }

  // The same, and where images are in each other's way, divides one cell and flips. Returns the
  // given vertex if it is not inside of a cell, or if flips are stuck; cells may have changed then.
  template <class Flips>
  Vertex_index insert(Vertex_index v, Flips& flips)
  {
    const Vertex_index other = insert(v);
    if (other != v || !divide_cell_around(v))
      return other;
    for (const Arrays::Star_cell& made : m_star)
      flips.open_cell(made.number);
    flips.run();
    return flips.take_stuck().empty() ? Vertex_index(null_index) : v;
  }

  // The cell that contains an image of a vertex; or where all ways there leave the region, the
  // first one outside.
  Cell_index locate(Vertex_index v) const { return walk_to(v).first; }

private:
  bool is_in_conflict(Cell_index c, const Torus_site_3& site) const
  {
    return m_signs.side_of_sphere(m_arrays.sites(c), site) > 0;
  }

  // Walks to a cell that contains an image of a vertex, and returns that image in its chart. In
  // Delaunay cells no such walk goes in a circle. In a wire it goes through finite cells alone, and
  // ends in an infinite one if the image is beyond its hull facet.
  std::pair<Cell_index, Torus_site_3> walk_to(Vertex_index v) const
  {
    Cell_index c = m_last;
    const Torus_site_3 start = m_arrays.first_finite_site(c);
    const Position_3 way = m_state.position(start) - m_state.positions.position(v);
    const Multiples_3 nearest = Torus_3::nearest(m_state.torus.fractions(way));
    Torus_site_3 site{v, Torus_shift_3::of(nearest)};
    Corner_index entrance = null_index;
    const auto pass = [&](Corner_index k) {
      site.shift = site.shift - m_arrays.translation(k);
      entrance = m_arrays.mirror(k);
      c = Arrays::cell_of(entrance);
    };
    if (is_end_of_walk(c)) {
      pass(Arrays::corner(c, infinite_place(m_arrays.sites(c))));
      entrance = null_index; // the image may be beyond that facet
    }
    while (m_region.has(m_arrays.vertices(c)) && !is_end_of_walk(c)) {
      const Corner_index exit = way_on(c, site, entrance);
      if (exit == null_index)
        break;
      pass(exit);
    }
    return {c, site};
  }
  bool is_end_of_walk(Cell_index c) const
  {
    return m_state.torus.is_wire() && m_arrays.is_infinite(c);
  }
  // The corner opposite to a facet beyond which a site is, not back, or null_index.
  Corner_index way_on(Cell_index c, const Torus_site_3& site, Corner_index entrance) const
  {
    const Torus_sites_3 sites = m_arrays.sites(c);
    Corner_index outside = null_index;
    for (int i = 0; i < 4; ++i) {
      const Corner_index k = Arrays::corner(c, i);
      if (k == entrance || m_signs.with(sites, i, site) >= 0)
        continue;
      if (m_region.has(m_arrays.vertices(m_arrays.neighbor(c, i))))
        return k;
      outside = k;
    }
    return outside;
  }

  // Replaces the cell that contains an image of a vertex by four that have it. In a wire, where a
  // walk ends at the hull, it goes on from there through infinite cells. False if that leads to no
  // cell in which all four are positive.
  bool divide_cell_around(Vertex_index v)
  {
    constexpr int most_steps = 1000; // on the hull, which is not Delaunay, walks may go in circles
    auto [c, site] = walk_to(v);
    Corner_index entrance = null_index;
    for (int step = 0; step < most_steps; ++step) {
      const Torus_sites_3 sites = m_arrays.sites(c);
      const int infinite = infinite_place(sites);
      Corner_index exit = null_index;
      for (int i = 0; i < 4; ++i) {
        const int sign = m_signs.with(sites, i, site);
        if (sign == 0 || (sign < 0 && (infinite == 4 || i == infinite)))
          return false;
        if (sign < 0)
          exit = Arrays::corner(c, i);
      }
      if (exit == null_index) {
        divide(c, v, site.shift);
        return true;
      }
      if (exit == entrance)
        return false;
      site.shift = site.shift - m_arrays.translation(exit);
      entrance = m_arrays.mirror(exit);
      c = Arrays::cell_of(entrance);
    }
    return false;
  }
  void divide(Cell_index c, Vertex_index v, const Torus_shift_3& shift)
  {
    m_conflicts.assign(1, c);
    m_border.clear();
    for (int i = 0; i < 4; ++i)
      m_border.push_back(Arrays::corner(c, i));
    m_border_shifts.assign(4, shift);
    m_last = m_arrays.replace_by_star(m_conflicts, m_border, m_border_shifts, v, m_star);
  }

  // Finds the cells in conflict, and the facets of their border. False if one of these cells is not
  // in the region, or there are not enough free ones; or if two of them are images of each other,
  // or what lies beyond the border is an image of one: there the images of the vertex would be in
  // conflict with each other's new cells.
  bool find_conflicts(Cell_index first, const Torus_site_3& site)
  {
    m_conflicts.assign(1, first);
    m_shifts.assign(1, site.shift);
    m_entries.assign(1, Corner_index(null_index));
    m_border.clear();
    m_border_shifts.clear();
    m_tested.clear(m_arrays.number_of_cells());
    m_tested.insert(first, conflicting, site.shift);
    for (std::size_t n = 0; n < m_conflicts.size(); ++n)
      for (int i = 0; i < 4; ++i) {
        const Corner_index k = Arrays::corner(m_conflicts[n], i);
        if (k == m_entries[n])
          continue;
        const Torus_shift_3 here = m_shifts[n];
        const Index kind = kind_beyond(k, {site.vertex, here - m_arrays.translation(k)});
        if (kind == hopeless)
          return false;
        if (kind == bordering) {
          m_border.push_back(k);
          m_border_shifts.push_back(here);
        }
      }
    return m_region.part == Arrays::whole || m_border.size() <= m_conflicts.size() ||
           m_arrays.can_make_cells(m_border.size() - m_conflicts.size(), m_region.part);
  }

  // Tests the cell beyond a facet, given the vertex's image in its chart, and lists it if it is in
  // conflict.
  Index kind_beyond(Corner_index k, const Torus_site_3& site)
  {
    const Corner_index entry = m_arrays.mirror(k);
    const auto [kind, shift] = m_tested.find_or_insert(Arrays::cell_of(entry), [&] {
      return Tested{kind_of_new(entry, site), site.shift};
    });
    if (shift == site.shift)
      return kind;
    // another image of the cell
    return kind == bordering && !is_in_conflict(Arrays::cell_of(entry), site) ? bordering
                                                                              : hopeless;
  }
  Index kind_of_new(Corner_index entry, const Torus_site_3& site)
  {
    const Cell_index c = Arrays::cell_of(entry);
    if (!is_in_conflict(c, site))
      return bordering;
    if (!m_region.has(m_arrays.vertices(c)))
      return hopeless;
    m_conflicts.push_back(c);
    m_shifts.push_back(site.shift);
    m_entries.push_back(entry);
    return conflicting;
  }

  static constexpr Index bordering = 0, conflicting = 1, hopeless = 2; // kinds of cells
  using Tested = typename Noted_cells_3<Torus_shift_3>::Noted;

  Arrays& m_arrays;
  const State& m_state;
  Torus_signs_3<State> m_signs;
  Region m_region;
  Cell_index m_last{0};
  Noted_cells_3<Torus_shift_3> m_tested; // with the shift of the image
  std::vector<Cell_index> m_conflicts;
  std::vector<Torus_shift_3> m_shifts, m_border_shifts; // of the image in the charts of these cells
  std::vector<Corner_index> m_entries; // of each the corner opposite to where it was found
  std::vector<Corner_index> m_border;  // corners of cells in conflict, opposite to others
  std::vector<Arrays::Star_cell> m_star;
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_3::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_PERIODIC_TORUS_INSERTION_3_H

// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_PERIODIC_TORUS_REMOVAL_3_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_PERIODIC_TORUS_REMOVAL_3_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/periodic/Torus_patch_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/periodic/Torus_state_3.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_3::internal {

// Takes vertices out of Delaunay cells of a torus. The images around the hole are triangulated in
// open space alone; of these cells, those inside of the hole fill it. As there are no ties, they
// have each facet of the hole.
//
// That fails where a cell has two images of the vertex: then holes are in each other's way. So a
// vertex on the hull of a wire, or above all others in a slab, has to go inside first, unless it
// shares a wall with others. Then the hull stays as it is. The hole has infinite cells over a part
// of the wall, which is a part of the hull of the images around, too. Infinite cells there fill it,
// by the point at infinity of those in the hole. All ties in the plane of the wall are broken as in
// space. Where all points are in one layer, the points above and below it are among the sites
// around.
template <class State>
class Torus_removal_3
{
  using Arrays = Torus_cells_3;

public:
  explicit Torus_removal_3(State& state)
    : m_state(state)
    , m_signs(state)
  {
  }

  // Takes a vertex out. Returns whether that has succeeded, and changes nothing else. The vertex
  // keeps its number, without cells. No facet has to be opened.
  template <class Flips>
  bool remove(Vertex_index v, Flips&)
  {
    if (!find_hole(v))
      return false;
    Torus_patch_3<State> patch(m_state);
    const auto never = [](std::size_t, std::size_t) {};
    if (!patch.triangulate(m_around, never) || !find_inside(patch) ||
        !is_positive_at_infinity(patch))
      return false;
    fill(patch);
    m_state.arrays.forget_corner(v);
    return true;
  }

private:
  struct Border
  {
    Torus_sites_3 facet; // its sites ascending, in the chart where the vertex has the shift 0; the
                         // last one is the vertex
    Corner_index corner; // in the hole, opposite to the facet
    Torus_shift_3 shift; // of the vertex in that cell's chart
  };

  const Arrays& arrays() const { return m_state.arrays; }

  // Lists the cells around a vertex, its shift in each of them, and the sites around. Points at
  // infinity are among these only if there are two; a single one is that of the patch.
  bool find_hole(Vertex_index v)
  {
    find_star(arrays(), v, m_state.marks, m_hole);
    m_border.clear();
    m_around.clear();
    m_ends.clear();
    for (const Cell_index c : m_hole) {
      const Torus_sites_3 sites = arrays().sites(c);
      const auto is_image = [v](const Torus_site_3& s) { return s.vertex == v; };
      if (std::count_if(sites.begin(), sites.end(), is_image) > 1)
        return false;
      const int place = int(std::find_if(sites.begin(), sites.end(), is_image) - sites.begin());
      Border border{sites, Arrays::corner(c, place), sites[place].shift};
      for (Torus_site_3& s : border.facet)
        s = s - border.shift;
      std::swap(border.facet[place], border.facet[3]);
      std::sort(border.facet.begin(), border.facet.begin() + 3);
      for (int i = 0; i < 3; ++i)
        (border.facet[i].is_infinite() ? m_ends : m_around).push_back(border.facet[i]);
      m_border.push_back(border);
    }
    std::sort(m_border.begin(), m_border.end(),
              [](const Border& a, const Border& b) { return a.facet < b.facet; });
    keep_different(m_around);
    keep_different(m_ends);
    if (m_ends.size() == 2) {
      m_around.insert(m_around.end(), m_ends.begin(), m_ends.end());
      m_ends.clear();
    }
    return true;
  }
  static void keep_different(std::vector<Torus_site_3>& sites)
  {
    std::sort(sites.begin(), sites.end());
    sites.erase(std::unique(sites.begin(), sites.end()), sites.end());
  }

  // The sites of a cell of the patch, with that point at infinity that the hole has.
  Torus_sites_3 sites(const Torus_patch_3<State>& patch, Cell_index c) const
  {
    Torus_sites_3 sites = patch.sites(c);
    if (const int place = patch.arrays().place_of(c, infinite_index); place < 4 && !m_ends.empty())
      sites[place] = m_ends.front();
    return sites;
  }
  // Whether infinite cells of the patch may be in the hole.
  bool may_be_inside(const Torus_patch_3<State>& patch, Cell_index c) const
  {
    return !m_ends.empty() || !patch.arrays().is_infinite(c);
  }

  // The facet of the border opposite to a corner of the patch, or null.
  const Border* border_at(const Torus_patch_3<State>& patch, Corner_index k) const
  {
    const Tetrahedra_arrays_3& cells = patch.arrays();
    const Cell_index c = Arrays::cell_of(k);
    const int place = Arrays::place_of(k), infinite = cells.place_of(c, infinite_index);
    if (infinite != place && !may_be_inside(patch, c))
      return nullptr;
    Torus_sites_3 facet = sites(patch, c);
    facet[place] = facet[3];
    facet[3] = m_border.front().facet[3];
    std::sort(facet.begin(), facet.begin() + 3);
    const auto at =
        std::lower_bound(m_border.begin(), m_border.end(), facet,
                         [](const Border& b, const Torus_sites_3& f) { return b.facet < f; });
    return at != m_border.end() && at->facet == facet ? &*at : nullptr;
  }

  // Whether a cell of the patch and one of the hole, with a facet in common, lie on the same side
  // of it: their vertices at this facet have the same orientation.
  bool are_on_same_side(const Torus_patch_3<State>& patch, Corner_index k,
                        const Border& border) const
  {
    const Torus_sites_3 s = sites(patch, Arrays::cell_of(k));
    Few<int, 4> places;
    for (int i = 0; i < 4; ++i)
      places[i] = i == Arrays::place_of(k)
                      ? Arrays::place_of(border.corner)
                      : arrays().place_of(Arrays::cell_of(border.corner), s[i] + border.shift);
    return is_even(places);
  }

  // Collects the cells of the patch that are inside of the border. False if one of its facets is
  // not there, or they leak out.
  bool find_inside(Torus_patch_3<State>& patch)
  {
    const Tetrahedra_arrays_3& cells = patch.arrays();
    m_border_at.assign(4 * std::size_t(cells.number_of_cells()), nullptr);
    m_inside.clear();
    patch.marks().clear(cells.number_of_cells());
    const auto add = [&](Cell_index c) {
      if (patch.marks().insert(c))
        m_inside.push_back(c);
    };
    std::size_t found = 0, met = 0;
    for (Corner_index k(0); k < m_border_at.size(); ++k)
      if (const Border* const border = border_at(patch, k)) {
        m_border_at[k] = border;
        if (may_be_inside(patch, Arrays::cell_of(k)) && are_on_same_side(patch, k, *border)) {
          ++found;
          add(Arrays::cell_of(k));
        }
      }
    for (std::size_t n = 0; n < m_inside.size(); ++n) {
      if (!may_be_inside(patch, m_inside[n]))
        return false;
      for (int i = 0; i < 4; ++i) {
        const Corner_index k = Arrays::corner(m_inside[n], i);
        if (m_border_at[k] != nullptr)
          ++met;
        else
          add(Arrays::cell_of(cells.mirror(k)));
      }
    }
    return found == m_border.size() && met == m_border.size();
  }

  // Whether all new infinite cells are positive.
  bool is_positive_at_infinity(const Torus_patch_3<State>& patch) const
  {
    return std::all_of(m_inside.begin(), m_inside.end(), [&](Cell_index c) {
      const Torus_sites_3 s = sites(patch, c);
      return infinite_place(s) == 4 || m_signs.is_positive(s);
    });
  }

  void fill(const Torus_patch_3<State>& patch)
  {
    const Tetrahedra_arrays_3& cells = patch.arrays();
    m_number.assign(cells.number_of_cells(), Cell_index(null_index));
    for (const Cell_index c : m_inside)
      m_number[c] = m_state.arrays.make_cell();
    m_outer.clear();
    for (const Cell_index c : m_inside)
      for (int i = 0; i < 4; ++i)
        if (const Border* const border = m_border_at[Arrays::corner(c, i)])
          m_outer.push_back({border->corner, Arrays::corner(m_number[c], i), -border->shift});
    m_state.arrays.read_mirrors(m_outer);
    m_state.marks.clear(arrays().number_of_cells());
    for (const Cell_index c : m_hole) {
      m_state.marks.insert(c);
      m_state.arrays.drop_cell(c);
    }
    for (const Cell_index c : m_inside)
      m_state.arrays.set_sites(m_number[c], sites(patch, c));
    for (const Cell_index c : m_inside)
      for (int i = 0; i < 4; ++i) {
        const Corner_index k = Arrays::corner(c, i), mirror = cells.mirror(k);
        if (m_border_at[k] == nullptr && k < mirror)
          m_state.arrays.connect(
              Arrays::corner(m_number[c], i),
              Arrays::corner(m_number[Arrays::cell_of(mirror)], Arrays::place_of(mirror)), {});
      }
    m_state.arrays.connect_outer(m_outer, [this](Cell_index c) { return m_state.marks.has(c); });
    for (const Cell_index c : m_inside)
      m_state.arrays.normalize(m_number[c]);
  }

  State& m_state;
  const Torus_signs_3<State> m_signs;
  std::vector<Cell_index> m_hole, m_inside;
  std::vector<Border> m_border;
  Column<Corner_index, const Border*> m_border_at; // of corners of the patch, or null
  std::vector<Torus_site_3> m_around, m_ends;      // finite sites, and points at infinity
  Column<Cell_index, Cell_index> m_number;         // of cells of the patch
  std::vector<Arrays::Outer_facet> m_outer;
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_3::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_PERIODIC_TORUS_REMOVAL_3_H

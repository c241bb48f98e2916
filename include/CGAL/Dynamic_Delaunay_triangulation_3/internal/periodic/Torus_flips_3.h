// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_PERIODIC_TORUS_FLIPS_3_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_PERIODIC_TORUS_FLIPS_3_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/periodic/Torus_state_3.h>

#include <cstddef>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_3::internal {

// Flips facets that are not locally Delaunay, and inverted cells away, as `Lawson_flips_3` does in
// open space, with images in the place of vertices and without infinite cells.
//
// A flip replaces different cells: then their images in space do not overlap, whatever their
// neighbors are, and all images are flipped at once. Cells that are images of each other are never
// flipped together.
template <class State>
class Torus_flips_3
{
  using Arrays = Torus_cells_3;

public:
  using Flipped = Arrays::Flipped;

  explicit Torus_flips_3(State& state)
    : m_state(state)
    , m_signs(state)
  {
  }

  const Torus_signs_3<State>& signs() const { return m_signs; }
  std::size_t number_of_flips() const { return m_number; }
  bool is_positive(Cell_index c) const { return m_signs.is_positive(arrays().sites(c)); }

  void clear()
  {
    m_open = std::vector<Facet>();
    m_stuck = std::vector<Facet>();
    m_number = 0;
  }
  void forget_open_facets() { m_open.clear(); }

  // Opens the facets of a cell.
  void open_cell(Cell_index c)
  {
    for (int i = 0; i < 4; ++i)
      open(Arrays::corner(c, i));
  }
  // Opens the facet opposite to a corner: it is tested, and flipped if it is illegal.
  void open(Corner_index k) { m_open.push_back({k, arrays().vertex(k)}); }

  // Flips until no facet is open.
  void run()
  {
    while (!m_open.empty()) {
      const Facet facet = m_open.back();
      m_open.pop_back();
      if (is_there(facet) && is_illegal(facet.corner))
        if (!flip_illegal(facet.corner))
          m_stuck.push_back(facet);
    }
  }

  // Flips a cell that is not positive away, if one flip makes positive cells only and no edge or
  // facet that exists already. Returns the new cells, none if there is no such flip.
  Flipped right(Cell_index c)
  {
    for (int i = 0; i < 4; ++i)
      if (const Flipped flipped = flip_right(Arrays::corner(c, i)); flipped.number > 0)
        return flipped;
    return none();
  }

  // Takes the list of facets at which flips were stuck; those that are legal or gone by now are
  // left out.
  std::vector<Corner_index> take_stuck()
  {
    std::vector<Corner_index> stuck;
    for (const Facet& facet : m_stuck)
      if (is_there(facet) && is_illegal(facet.corner))
        stuck.push_back(facet.corner);
    m_stuck.clear();
    return stuck;
  }
  void remember_stuck(Corner_index k) { m_stuck.push_back({k, arrays().vertex(k)}); }

  bool is_illegal(Corner_index k) const
  {
    return m_signs.side_of_sphere(arrays().sites(Arrays::cell_of(k)), arrays().apex_site(k)) > 0;
  }

  // The vertices of the cell at k that are in the way of a flip of the facet opposite to k.
  void append_obstacles(Corner_index k, std::vector<Vertex_index>& obstacles) const
  {
    const Torus_sites_3 s = arrays().sites(Arrays::cell_of(k));
    for (int i = 0; i < 4; ++i)
      if (i != Arrays::place_of(k) && m_signs.with(s, i, arrays().apex_site(k)) <= 0)
        for (int j = 0; j < 4; ++j)
          if (j != i && j != Arrays::place_of(k))
            obstacles.push_back(s[j].vertex);
  }

private:
  // The facet opposite to a corner with its vertex. Flips may have changed the cell since; then all
  // facets around the new cells were opened by them.
  struct Facet
  {
    Corner_index corner;
    Vertex_index vertex;
  };

  // Which of the cells that a flip of a facet would make are not positive.
  struct Outlook
  {
    int number = 0;
    int place = 4; // of the last one
    int sign = 0;
  };

  static Flipped none() { return {{null_index, null_index, null_index}, 0, {}}; }
  Arrays& arrays() { return m_state.arrays; }
  const Arrays& arrays() const { return m_state.arrays; }

  bool is_there(const Facet& facet) const
  {
    return Arrays::cell_of(facet.corner) < arrays().number_of_cells() &&
           arrays().vertex(facet.corner) == facet.vertex;
  }

  Outlook outlook(Corner_index k) const
  {
    Outlook found;
    const Torus_sites_3 s = arrays().sites(Arrays::cell_of(k));
    const Torus_site_3 beyond = arrays().apex_site(k);
    for (int i = 0; i < 4; ++i)
      if (i != Arrays::place_of(k))
        if (const int sign = m_signs.with(s, i, beyond); sign <= 0)
          found = {found.number + 1, i, sign};
    return found;
  }

  // The corner at the mirror's cell opposite to the facet that is, in the cell of k, at `side`: the
  // other facet of both cells with the edge between the remaining two vertices.
  Corner_index opposite_in_mirror(Corner_index k, int side) const
  {
    const Cell_index other = Arrays::cell_of(arrays().mirror(k));
    const Torus_site_3 s = arrays().site(Arrays::corner(Arrays::cell_of(k), side));
    const int place = arrays().place_of(other, {s.vertex, s.shift - arrays().translation(k)});
    return Arrays::corner(other, place);
  }

  // Whether the two cells at a facet have a neighbor in common, as seen in one chart, opposite to
  // the vertex at `side`, and all three are different.
  bool have_common_neighbor(Corner_index k, int side) const
  {
    const Cell_index c = Arrays::cell_of(k), other = Arrays::cell_of(arrays().mirror(k));
    const Corner_index first = Arrays::corner(c, side), second = opposite_in_mirror(k, side);
    const Cell_index third = arrays().neighbor(c, side);
    return c != other && c != third && other != third &&
           Arrays::cell_of(arrays().mirror(second)) == third &&
           arrays().translation(first) == arrays().translation(k) + arrays().translation(second);
  }

  bool are_different(Corner_index k) const
  {
    return Arrays::cell_of(k) != Arrays::cell_of(arrays().mirror(k));
  }

  bool flip_illegal(Corner_index k)
  {
    if (!are_different(k))
      return false;
    const Outlook found = outlook(k);
    if (found.number == 0) {
      flip_2_3(k);
      return true;
    }
    if (found.number > 1)
      return false;
    if (have_common_neighbor(k, found.place)) {
      if (found.sign == 0)
        return false;
      flip_3_2(k, found.place);
      return true;
    }
    return found.sign == 0 && flip_4_4(k, found.place);
  }

  // Two cells at the facet opposite to k, two others behind them, around an edge that would be the
  // diagonal of a flat quadrangle; the other diagonal replaces it.
  bool flip_4_4(Corner_index k, int side)
  {
    const Cell_index c = Arrays::cell_of(k), other = Arrays::cell_of(arrays().mirror(k));
    const Corner_index first = Arrays::corner(c, side), second = opposite_in_mirror(k, side);
    const Cell_index third = arrays().neighbor(c, side);
    const Cell_index fourth = Arrays::cell_of(arrays().mirror(second));
    if (third == fourth || third == c || third == other || fourth == c || fourth == other)
      return false;
    // all in the chart of c
    const Torus_sites_3 s = arrays().sites(c);
    const Torus_shift_3 of_third = arrays().translation(first);
    const Torus_shift_3 of_fourth = arrays().translation(k) + arrays().translation(second);
    const Torus_site_3 top = s[Arrays::place_of(k)], beyond = arrays().apex_site(k);
    const Torus_site_3 opposite = arrays().apex_site(first);
    const int place_of_top = arrays().place_of(third, in_chart(top, of_third));
    const Corner_index between = Arrays::corner(third, place_of_top);
    if (opposite == beyond || arrays().neighbor(third, place_of_top) != fourth ||
        of_third + arrays().translation(between) != of_fourth)
      return false;
    const Torus_sites_3 w = arrays().sites(third);
    for (int i = 0; i < 4; ++i)
      if (i != Arrays::place_of(k) && i != side &&
          m_signs.with(w, arrays().place_of(third, in_chart(s[i], of_third)),
                       in_chart(beyond, of_third)) <= 0)
        return false;
    const Corner_index behind = arrays().mirror(first);
    flip_2_3(k);
    // the flat cell lies between the third one and the edge's other side
    const Corner_index flat = arrays().mirror(behind);
    const Torus_shift_3 of_flat = arrays().translation(behind);
    const auto in_flat = [&](const Torus_site_3& site) {
      return arrays().place_of(Arrays::cell_of(flat), in_chart(in_chart(site, of_third), of_flat));
    };
    flip_3_2(Arrays::corner(Arrays::cell_of(flat), in_flat(beyond)), in_flat(top));
    return true;
  }

  // A site as seen in another chart, which the translation takes to this one.
  static Torus_site_3 in_chart(const Torus_site_3& site, Torus_shift_3 translation)
  {
    return {site.vertex, site.shift - translation};
  }

  Flipped flip_right(Corner_index k)
  {
    if (!are_different(k))
      return none();
    const Outlook found = outlook(k);
    const Torus_site_3 top = arrays().site(k), beyond = arrays().apex_site(k);
    if (found.number == 0 && !has_simplex(Few<Torus_site_3, 2>{top, beyond}))
      return flip_2_3(k);
    if (found.number == 1 && have_common_neighbor(k, found.place)) {
      const Torus_site_3 side = arrays().site(Arrays::corner(Arrays::cell_of(k), found.place));
      if (!has_simplex(Few<Torus_site_3, 3>{top, beyond, side}))
        return flip_3_2(k, found.place);
    }
    return none();
  }

  Flipped flip_2_3(Corner_index k)
  {
    const Flipped flipped = arrays().flip_2_3(k);
    open_around(flipped);
    return flipped;
  }
  Flipped flip_3_2(Corner_index k, int side)
  {
    const Flipped flipped = arrays().flip_3_2(k, side);
    open_around(flipped);
    return flipped;
  }

  // Opens the facets around new cells. Those between them are legal.
  void open_around(const Flipped& flipped)
  {
    for (const Corner_index k : flipped.outer)
      open(k);
    ++m_number;
  }

  // Whether there is an edge or facet with these sites.
  template <int number>
  bool has_simplex(const Few<Torus_site_3, number>& simplex)
  {
    const Torus_site_3& first = simplex[0];
    find_star(arrays(), first.vertex, m_state.marks, m_star);
    for (const Cell_index c : m_star)
      for (int i = 0; i < 4; ++i) {
        const Torus_site_3 s = arrays().site(Arrays::corner(c, i));
        if (s.vertex != first.vertex)
          continue;
        bool has_all = true;
        for (int n = 1; n < number; ++n)
          has_all =
              has_all && arrays().place_of(c, in_chart(simplex[n], first.shift - s.shift)) < 4;
        if (has_all)
          return true;
      }
    return false;
  }

  State& m_state;
  Torus_signs_3<State> m_signs;
  std::vector<Facet> m_open, m_stuck;
  std::size_t m_number = 0;
  std::vector<Cell_index> m_star;
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_3::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_PERIODIC_TORUS_FLIPS_3_H

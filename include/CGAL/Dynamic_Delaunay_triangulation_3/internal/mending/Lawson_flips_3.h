// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_MENDING_LAWSON_FLIPS_3_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_MENDING_LAWSON_FLIPS_3_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/proof/Cell_signs_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/topology/Cell_arrays_3.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_3::internal {

// Flips facets that are not locally Delaunay, and inverted cells away.
//
// A flip replaces two cells at a facet by three, three around an edge by two, or, where four
// vertices are coplanar, four around an edge by four. It is made only if all new cells are
// positive: then they tile what the old ones covered. With infinite cells among them the same flips
// change the hull: seen from the origin, these are cells like others. Each legal flip raises the
// volume of the hull, or lowers the lifted surface; so flips end (Joe 1989; Edelsbrunner and Shah
// 1996). Flips may get stuck where several vertices of a facet are in each other's way; such facets
// are remembered.
//
// On a torus the same is done with images in the place of vertices, as one chart sees them. A flip
// replaces cells that are no images of each other, so that all images are flipped at once. For no
// cell is its own neighbor, by a translation t: of its sites x, y and z at that facet, x - t, y - t
// and z - t would be sites, too, so two of them again x, y or z; then x, y and z are in one line, t
// apart, wherever they are, and no cell is ever made flat. In a slab, where translations leave a
// point at infinity in the place of z where it is, x, y, x - t and y - t would be three finite
// sites in one line.
template <class State>
class Lawson_flips_3
{
  using Signs = typename Signs_of_3<State>::type;
  using Arrays = typename State::Arrays;
  using Site = typename Arrays::Site;
  using Sites = typename Arrays::Sites;
  using Translation = typename Arrays::Translation;

public:
  using Flipped = typename Arrays::Flipped;

  explicit Lawson_flips_3(State& state)
    : m_state(state)
    , m_signs(state)
  {
  }

  const Signs& signs() const { return m_signs; }
  std::size_t number_of_flips() const { return m_number; }
  bool is_positive(Cell_index c) const { return m_signs.is_positive(arrays().sites(c)); }

  // Gives memory back, too: after a rough frame these lists have some 100 bytes a point.
  void clear()
  {
    m_finite = std::vector<Facet>();
    m_infinite = std::vector<Facet>();
    m_stuck = std::vector<Facet>();
    m_number = 0;
  }
  void forget_open_facets()
  {
    m_finite.clear();
    m_infinite.clear();
  }

  // Opens the facets of a cell, but those that floating point proves legal. No vertex may move
  // until run().
  void open_cell(Cell_index c)
  {
    open_cell(c, [](Corner_index) { return true; });
  }
  // Only those opposite to corners that `is_wanted` says.
  template <class Predicate>
  void open_cell(Cell_index c, const Predicate& is_wanted)
  {
    m_signs.for_each_doubtful(c, [&](int place) {
      if (const Corner_index k = Arrays::corner(c, place); is_wanted(k))
        open(k);
    });
  }
  // Opens the facet opposite to a corner: it is tested, and flipped if it is illegal. Facets
  // between a finite and an infinite cell are never illegal.
  void open(Corner_index k)
  {
    if (!arrays().is_infinite(Arrays::cell_of(k)))
      m_finite.push_back({k, arrays().vertex(k)});
    else if (!Arrays::is_infinite(arrays().site(k)))
      m_infinite.push_back({k, arrays().vertex(k)});
  }

  // Flips until no facet is open. Facets of the hull come first: finite flips rely on it.
  void run()
  {
    for (;;) {
      std::vector<Facet>& open = m_infinite.empty() ? m_finite : m_infinite;
      if (open.empty())
        return;
      const Facet facet = open.back();
      open.pop_back();
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
    const Cell_index c = Arrays::cell_of(k), other = Arrays::cell_of(arrays().mirror(k));
    return arrays().is_infinite(c) == arrays().is_infinite(other) &&
           m_signs.is_illegal(arrays().sites(c), arrays().apex_site(k));
  }

  // The vertices of the cell at k that are in the way of a flip of the facet opposite to k.
  void append_obstacles(Corner_index k, std::vector<Vertex_index>& obstacles) const
  {
    const Sites s = arrays().sites(Arrays::cell_of(k));
    for (int i = 0; i < 4; ++i)
      if (i != Arrays::place_of(k) && m_signs.with(s, i, arrays().apex_site(k)) <= 0)
        for (int j = 0; j < 4; ++j)
          if (j != i && j != Arrays::place_of(k))
            obstacles.push_back(Arrays::vertex_of(s[j]));
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
    const Sites s = arrays().sites(Arrays::cell_of(k));
    const Site beyond = arrays().apex_site(k);
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
    const Site s = arrays().site(Arrays::corner(Arrays::cell_of(k), side));
    return Arrays::corner(
        other, arrays().place_of(other, Arrays::translated_back(s, arrays().translation(k))));
  }

  // Whether the two cells at a facet have a neighbor in common, opposite to the vertex at `side`,
  // in one chart. (Around an edge to a point at infinity of a slab there may be several images of
  // it.)
  bool have_common_neighbor(Corner_index k, int side) const
  {
    const Corner_index first = Arrays::corner(Arrays::cell_of(k), side);
    const Corner_index second = opposite_in_mirror(k, side);
    return Arrays::cell_of(arrays().mirror(first)) == Arrays::cell_of(arrays().mirror(second)) &&
           arrays().translation(first) == arrays().translation(k) + arrays().translation(second);
  }

  bool flip_illegal(Corner_index k)
  {
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
  // diagonal of a flat quadrangle; the other diagonal replaces it. With an infinite cell, that is a
  // coplanar face of the hull.
  bool flip_4_4(Corner_index k, int side)
  {
    const Cell_index c = Arrays::cell_of(k), other = Arrays::cell_of(arrays().mirror(k));
    const Corner_index first = Arrays::corner(c, side), second = opposite_in_mirror(k, side);
    const Cell_index third = arrays().neighbor(c, side);
    const Cell_index fourth = Arrays::cell_of(arrays().mirror(second));
    if (third == fourth || third == c || third == other || fourth == c || fourth == other)
      return false;
    // all in the chart of c
    const Sites s = arrays().sites(c);
    const Translation of_third = arrays().translation(first);
    const Translation of_fourth = arrays().translation(k) + arrays().translation(second);
    const Site top = s[Arrays::place_of(k)], beyond = arrays().apex_site(k);
    const Site opposite = arrays().apex_site(first);
    const int place_of_top = arrays().place_of(third, Arrays::translated_back(top, of_third));
    const Corner_index between = Arrays::corner(third, place_of_top);
    if (opposite == beyond || arrays().neighbor(third, place_of_top) != fourth ||
        of_third + arrays().translation(between) != of_fourth)
      return false;
    const Sites w = arrays().sites(third);
    for (int i = 0; i < 4; ++i)
      if (i != Arrays::place_of(k) && i != side &&
          m_signs.with(w, arrays().place_of(third, Arrays::translated_back(s[i], of_third)),
                       Arrays::translated_back(beyond, of_third)) <= 0)
        return false;
    const Corner_index behind = arrays().mirror(first);
    flip_2_3(k);
    // the flat cell lies between the third one and the edge's other side
    const Corner_index flat = arrays().mirror(behind);
    const Translation of_flat = arrays().translation(behind);
    const auto in_flat = [&](const Site& site) {
      return arrays().place_of(
          Arrays::cell_of(flat),
          Arrays::translated_back(Arrays::translated_back(site, of_third), of_flat));
    };
    flip_3_2(Arrays::corner(Arrays::cell_of(flat), in_flat(beyond)), in_flat(top));
    return true;
  }

  Flipped flip_right(Corner_index k)
  {
    const Outlook found = outlook(k);
    const Site top = arrays().site(k), beyond = arrays().apex_site(k);
    if (found.number == 0 && !has_simplex(Few<Site, 2>{top, beyond}))
      return flip_2_3(k);
    if (found.number == 1 && have_common_neighbor(k, found.place)) {
      const Site side = arrays().site(Arrays::corner(Arrays::cell_of(k), found.place));
      if (!has_simplex(Few<Site, 3>{side, top, beyond}))
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
  bool has_simplex(Few<Site, number> simplex)
  {
    if (Arrays::is_infinite(simplex[0])) // its star has the whole hull
      std::swap(simplex[0], simplex[1]);
    find_star(arrays(), Arrays::vertex_of(simplex[0]), m_state.marks, m_star);
    return std::any_of(m_star.begin(), m_star.end(),
                       [&](Cell_index c) { return has_simplex(c, simplex); });
  }
  template <int number>
  bool has_simplex(Cell_index c, const Few<Site, number>& simplex) const
  {
    for (int i = 0; i < 4; ++i) {
      const Site s = arrays().site(Arrays::corner(c, i));
      if (Arrays::vertex_of(s) != Arrays::vertex_of(simplex[0]))
        continue;
      const Translation chart = Arrays::translation(s, simplex[0]);
      if (std::all_of(simplex.begin() + 1, simplex.end(), [&](const Site& other) {
            return arrays().place_of(c, Arrays::translated_back(other, chart)) < 4;
          }))
        return true;
    }
    return false;
  }

  State& m_state;
  Signs m_signs;
  std::vector<Facet> m_finite, m_infinite; // open
  std::vector<Facet> m_stuck;
  std::size_t m_number = 0;
  std::vector<Cell_index> m_star;
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_3::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_MENDING_LAWSON_FLIPS_3_H

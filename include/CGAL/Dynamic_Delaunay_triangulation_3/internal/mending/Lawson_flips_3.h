// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_MENDING_LAWSON_FLIPS_3_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_MENDING_LAWSON_FLIPS_3_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/mending/Spatial_parts_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/proof/Cell_signs_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/space/State_base_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/topology/Cell_arrays_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/topology/Cell_set_3.h>

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
// All this is done in all of the triangulation or, while threads do so elsewhere, in one of the
// parts of space that `Flip_parts_3` makes.
//
// On a torus the same is done with images in the place of vertices, as one chart sees them. A flip
// replaces cells that are no images of each other, so that all images are flipped at once. For no
// cell is its own neighbor, by a translation t: of its sites x, y and z at that facet, x - t, y - t
// and z - t would be sites, too, so two of them again x, y or z; then x, y and z are in one line, t
// apart, wherever they are, and no cell is ever made flat. In a slab or a wire, where translations
// leave a point at infinity in the place of z where it is, x, y, x - t and y - t would be three
// finite sites in one line.
template <class State>
class alignas(64) Lawson_flips_3 // so that threads that have one each share no line of the cache
{
  using Arrays = typename State::Arrays;
  using Site = typename Arrays::Site;
  using Sites = typename Arrays::Sites;
  using Translation = typename Arrays::Translation;

public:
  using Signs = typename Signs_of_3<State>::type;
  using Flipped = typename Arrays::Flipped;
  using Division = Spatial_parts_3<typename State::Positions, typename State::Exact_parts>;

  // The facet opposite to a corner with its vertex. Flips may have changed the cell since; then all
  // facets around the new cells were opened by them.
  struct Facet
  {
    Corner_index corner;
    Vertex_index vertex;
  };

  // Those to be tested: of finite cells, and those between infinite ones.
  struct Open_facets
  {
    void append(const Open_facets& others)
    {
      finite.insert(finite.end(), others.finite.begin(), others.finite.end());
      infinite.insert(infinite.end(), others.infinite.begin(), others.infinite.end());
    }
    std::vector<Facet> finite, infinite;
  };

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
    m_open = Open_facets();
    m_stuck = std::vector<Facet>();
    m_left = std::vector<Facet>();
    m_number = 0;
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
    append_doubtful(m_signs, c, is_wanted, m_open);
  }
  // The same, but appends them to others. Threads may do so at the same time, each by signs of its
  // own.
  template <class Predicate>
  void append_doubtful(const Signs& signs, Cell_index c, const Predicate& is_wanted,
                       Open_facets& facets) const
  {
    signs.for_each_doubtful(
        c, [&](int place) { return is_wanted(Arrays::corner(c, place)); },
        [&](int place) { append(Arrays::corner(c, place), facets); });
  }
  // Opens the facet opposite to a corner: it is tested, and flipped if it is illegal.
  void open(Corner_index k) { append(k, m_open); }
  Open_facets& open_facets() { return m_open; }

  // Flips until no facet is open. Facets of the hull come first: finite flips rely on it.
  void run()
  {
    for (;;) {
      run_at_hull();
      if (m_open.finite.empty())
        return;
      flip_last(m_open.finite);
    }
  }
  // Flips until no facet of the hull is open.
  void run_at_hull()
  {
    while (!m_open.infinite.empty())
      flip_last(m_open.infinite);
  }

  // From here on flips in a part alone, for which the arrays have a part of the same number. Facets
  // that are opened must have their vertices in it.
  void begin_part(const Division& parts, std::size_t part)
  {
    m_parts = &parts;
    m_part = part;
  }
  std::size_t part() const { return m_part; }
  // Whether the vertex belongs to the part in which this flips.
  bool is_mine(Vertex_index v) const { return m_parts == nullptr || m_parts->has(m_part, v); }
  bool is_around_mine(Cell_index c) const
  {
    return m_parts == nullptr || m_parts->has_around(m_part, arrays().vertices(c));
  }
  // Whether a cell may be flipped with each of its neighbors.
  bool is_mine_with_neighbors(Cell_index c) const
  {
    if (m_parts == nullptr)
      return true;
    for (const Vertex_index v : arrays().vertices(c))
      if (!is_mine(v)) // others may change its neighbors
        return false;
    for (int i = 0; i < 4; ++i)
      if (!is_mine(arrays().apex(Arrays::corner(c, i))))
        return false;
    return arrays().can_make_cell(m_part);
  }
  // Flips from each of so many facets, in turn, until none is open.
  void run(const Facet* seeds, std::size_t number)
  {
    for (std::size_t i = 0; i < number; ++i) {
      prefetch_ahead(seeds, number, i);
      m_open.finite.push_back(seeds[i]);
      run();
    }
  }
  // Fetches what facets have around them that come soon in a list: this saves a third of the time
  // of flips at 100,000 points.
  void prefetch_ahead(const Facet* facets, std::size_t number, std::size_t i) const
  {
    prefetch_around(m_state, i, number,
                    [&](std::size_t n) { return Arrays::cell_of(facets[n].corner); });
  }
  // Whether a facet that was opened is there still.
  bool is_there(const Facet& facet) const
  {
    return Arrays::cell_of(facet.corner) < arrays().number_of_cells() &&
           arrays().vertex(facet.corner) == facet.vertex;
  }

  // Takes over what the flips in a part have left: facets that are stuck, and, as open ones, those
  // for which a flip needs vertices elsewhere, or a new cell for which the part has no number.
  void append_left(const Lawson_flips_3& part)
  {
    for (const Facet& facet : part.m_left)
      (arrays().is_infinite(Arrays::cell_of(facet.corner)) ? m_open.infinite : m_open.finite)
          .push_back(facet);
    m_stuck.insert(m_stuck.end(), part.m_stuck.begin(), part.m_stuck.end());
    m_number += part.m_number;
  }

  // Flips a cell that is not positive away, if one flip makes positive cells only and no edge or
  // facet that exists already. Returns the new cells, none if there is no such flip. Opens nothing:
  // other such flips follow.
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
  enum class Outcome { FLIPPED, STUCK, LEFT };

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

  // Facets between a finite and an infinite cell are never illegal.
  void append(Corner_index k, Open_facets& facets) const
  {
    if (!arrays().is_infinite(Arrays::cell_of(k)))
      facets.finite.push_back({k, arrays().vertex(k)});
    else if (!Arrays::is_infinite(arrays().site(k)))
      facets.infinite.push_back({k, arrays().vertex(k)});
  }

  void flip_last(std::vector<Facet>& facets)
  {
    const Facet facet = facets.back();
    facets.pop_back();
    if (!is_there(facet) || !is_illegal(facet.corner))
      return;
    const Outcome outcome = flip_illegal(facet.corner);
    if (outcome != Outcome::FLIPPED)
      (outcome == Outcome::STUCK ? m_stuck : m_left).push_back(facet);
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

  Outcome flip_illegal(Corner_index k)
  {
    if (!is_mine(arrays().vertex(k)) || !is_mine(arrays().apex(k)))
      return Outcome::LEFT;
    const Outlook found = outlook(k);
    if (found.number == 0)
      return try_flip_2_3(k);
    if (found.number > 1)
      return Outcome::STUCK;
    if (!have_common_neighbor(k, found.place))
      return found.sign == 0 ? flip_4_4(k, found.place) : Outcome::STUCK;
    if (found.sign == 0)
      return Outcome::STUCK;
    open_around(flip_3_2(k, found.place));
    return Outcome::FLIPPED;
  }

  Outcome try_flip_2_3(Corner_index k)
  {
    if (m_parts != nullptr && !arrays().can_make_cell(m_part))
      return Outcome::LEFT;
    open_around(flip_2_3(k));
    return Outcome::FLIPPED;
  }

  // Two cells at the facet opposite to k, two others behind them, around an edge that would be the
  // diagonal of a flat quadrangle; the other diagonal replaces it. With an infinite cell, that is a
  // coplanar face of the hull.
  Outcome flip_4_4(Corner_index k, int side)
  {
    const Cell_index c = Arrays::cell_of(k), other = Arrays::cell_of(arrays().mirror(k));
    const Corner_index first = Arrays::corner(c, side), second = opposite_in_mirror(k, side);
    const Cell_index third = arrays().neighbor(c, side);
    const Cell_index fourth = Arrays::cell_of(arrays().mirror(second));
    if (third == fourth || third == c || third == other || fourth == c || fourth == other)
      return Outcome::STUCK;
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
      return Outcome::STUCK;
    const Sites w = arrays().sites(third);
    for (int i = 0; i < 4; ++i)
      if (i != Arrays::place_of(k) && i != side &&
          m_signs.with(w, arrays().place_of(third, Arrays::translated_back(s[i], of_third)),
                       Arrays::translated_back(beyond, of_third)) <= 0)
        return Outcome::STUCK;
    const Corner_index behind = arrays().mirror(first);
    if (!is_mine(Arrays::vertex_of(opposite)) || try_flip_2_3(k) == Outcome::LEFT)
      return Outcome::LEFT;
    // the flat cell lies between the third one and the edge's other side
    const Corner_index flat = arrays().mirror(behind);
    const Translation of_flat = arrays().translation(behind);
    const auto in_flat = [&](const Site& site) {
      return arrays().place_of(
          Arrays::cell_of(flat),
          Arrays::translated_back(Arrays::translated_back(site, of_third), of_flat));
    };
    open_around(flip_3_2(Arrays::corner(Arrays::cell_of(flat), in_flat(beyond)), in_flat(top)));
    return Outcome::FLIPPED;
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
    begin_flip();
    return arrays().flip_2_3(k, m_part);
  }
  Flipped flip_3_2(Corner_index k, int side)
  {
    begin_flip();
    return arrays().flip_3_2(k, side, m_part);
  }
  void begin_flip()
  {
    ++m_number;
    arrays().begin_step(m_part);
  }

  // Opens the facets around new cells. Those between them are legal.
  void open_around(const Flipped& flipped)
  {
    const int of_cell = 6 / flipped.number;
    for (int n = 0; n < flipped.number; ++n) {
      int outer = 0; // places
      for (int i = n * of_cell; i < (n + 1) * of_cell; ++i)
        outer |= 1 << Arrays::place_of(flipped.outer[i]);
      open_cell(flipped.cells[n],
                [outer](Corner_index k) { return (outer >> Arrays::place_of(k) & 1) != 0; });
    }
  }

  // Whether there is an edge or facet with these sites.
  template <int number>
  bool has_simplex(Few<Site, number> simplex)
  {
    if (Arrays::is_infinite(simplex[0])) // its star has the whole hull
      std::swap(simplex[0], simplex[1]);
    find_star(arrays(), Arrays::vertex_of(simplex[0]), m_in_star, m_star);
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
  const Division* m_parts = nullptr;
  std::size_t m_part = Arrays::whole; // of these parts
  Open_facets m_open;
  std::vector<Facet> m_stuck, m_left;
  std::size_t m_number = 0;
  std::vector<Cell_index> m_star;
  Cell_set_3 m_in_star;
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_3::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_MENDING_LAWSON_FLIPS_3_H

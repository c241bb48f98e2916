// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_MENDING_LAWSON_FLIPS_3_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_MENDING_LAWSON_FLIPS_3_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/proof/Cell_signs_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/topology/Tetrahedra_arrays_3.h>

#include <array>
#include <cstddef>
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
template <class State>
class Lawson_flips_3
{
  using Arrays = Tetrahedra_arrays_3;

public:
  using Flipped = Arrays::Flipped;

  explicit Lawson_flips_3(State& state)
    : m_state(state)
    , m_signs(state)
  {
  }

  const Cell_signs_3<State>& signs() const { return m_signs; }
  std::size_t number_of_flips() const { return m_number; }
  bool is_positive(Cell_index c) const { return m_signs.is_positive(arrays().vertices(c)); }

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
    const Vertices_3& v = arrays().vertices(c);
    if (arrays().is_infinite(c) || !m_state.positions_are_exact) {
      for (const Vertex_index w : v)
        open(c, w);
      return;
    }
    const auto filter = m_signs.filter_of(v);
    for (int i = 0; i < 4; ++i)
      if (filter.may_be_inside(m_signs.seen_from(v[0], arrays().apex(Arrays::corner(c, i)))))
        m_finite.push_back({c, v[i]});
  }
  // Opens the facet of a cell opposite to a vertex: it is tested, and flipped if it is illegal.
  // Facets between a finite and an infinite cell are never illegal.
  void open(Cell_index c, Vertex_index v)
  {
    if (!arrays().is_infinite(c))
      m_finite.push_back({c, v});
    else if (v != infinite_index)
      m_infinite.push_back({c, v});
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
      if (const Corner_index k = corner_of(facet); k != null_index && is_illegal(k))
        if (!flip_illegal(k))
          m_stuck.push_back(facet);
    }
  }

  // Flips a cell that is not positive away, if one flip makes positive cells only and no edge or
  // facet that exists already. Returns the new cells, none if there is no such flip.
  Flipped right(Cell_index c)
  {
    for (int i = 0; i < 4; ++i)
      if (const Flipped flipped = flip_right(arrays().corner(c, i)); flipped.number > 0)
        return flipped;
    return {{null_index, null_index, null_index}, 0};
  }

  // Takes the list of facets at which flips were stuck, each with its cell and vertex; those that
  // are legal or gone by now are left out.
  std::vector<Corner_index> take_stuck()
  {
    std::vector<Corner_index> stuck;
    for (const Facet& facet : m_stuck)
      if (const Corner_index k = corner_of(facet); k != null_index && is_illegal(k))
        stuck.push_back(k);
    m_stuck.clear();
    return stuck;
  }
  void remember_stuck(Corner_index k)
  {
    m_stuck.push_back({Arrays::cell_of(k), arrays().vertex(k)});
  }

  bool is_illegal(Corner_index k) const
  {
    const Cell_index c = Arrays::cell_of(k), other = Arrays::cell_of(arrays().mirror(k));
    return arrays().is_infinite(c) == arrays().is_infinite(other) &&
           m_signs.is_illegal(arrays().vertices(c), arrays().apex(k));
  }

  // The vertices of the cell at k that are in the way of a flip of the facet opposite to k.
  void append_obstacles(Corner_index k, std::vector<Vertex_index>& obstacles) const
  {
    const Vertices_3& v = arrays().vertices(Arrays::cell_of(k));
    for (int i = 0; i < 4; ++i)
      if (i != Arrays::place_of(k) && m_signs.with(v, i, arrays().apex(k)) <= 0)
        for (int j = 0; j < 4; ++j)
          if (j != i && j != Arrays::place_of(k))
            obstacles.push_back(v[j]);
  }

private:
  // The facet of a cell opposite to one of its vertices. Flips may have changed the cell since.
  struct Facet
  {
    Cell_index cell;
    Vertex_index vertex;
  };

  // Which of the cells that a flip of a facet would make are not positive.
  struct Outlook
  {
    int number = 0;
    int place = 4; // of the last one
    int sign = 0;
  };

  Arrays& arrays() { return m_state.arrays; }
  const Arrays& arrays() const { return m_state.arrays; }

  Corner_index corner_of(const Facet& facet) const
  {
    if (arrays().is_free(facet.cell))
      return null_index;
    const int place = arrays().place_of(facet.cell, facet.vertex);
    return place < 4 ? Arrays::corner(facet.cell, place) : Corner_index(null_index);
  }

  Outlook outlook(Corner_index k) const
  {
    Outlook found;
    const Vertices_3& v = arrays().vertices(Arrays::cell_of(k));
    const Vertex_index beyond = arrays().apex(k);
    for (int i = 0; i < 4; ++i)
      if (i != Arrays::place_of(k))
        if (const int sign = m_signs.with(v, i, beyond); sign <= 0)
          found = {found.number + 1, i, sign};
    return found;
  }

  // The neighbor that the two cells at a facet have in common, opposite to the vertex at `side`, or
  // null_index.
  Cell_index common_neighbor(Corner_index k, int side) const
  {
    const Cell_index c = Arrays::cell_of(k), other = Arrays::cell_of(arrays().mirror(k));
    const Cell_index third = arrays().neighbor(c, side);
    const int place = arrays().place_of(other, arrays().vertices(c)[side]);
    return arrays().neighbor(other, place) == third ? third : Cell_index(null_index);
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
    if (common_neighbor(k, found.place) != null_index) {
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
    const Vertices_3 v = arrays().vertices(c);
    const Vertex_index top = arrays().vertex(k), beyond = arrays().apex(k);
    const Corner_index behind = arrays().cell(c).mirrors[side];
    const Cell_index third = Arrays::cell_of(behind);
    const Vertex_index opposite = arrays().vertex(behind);
    const Cell_index fourth = arrays().neighbor(other, arrays().place_of(other, v[side]));
    if (opposite == beyond || arrays().place_of(fourth, opposite) == 4 || third == fourth ||
        arrays().neighbor(third, arrays().place_of(third, top)) != fourth)
      return false;
    const Vertices_3 w = arrays().vertices(third);
    for (int i = 0; i < 4; ++i)
      if (i != Arrays::place_of(k) && i != side &&
          m_signs.with(w, arrays().place_of(third, v[i]), beyond) <= 0)
        return false;
    flip_2_3(k);
    // the flat cell lies between the third one and the edge's other side
    const Cell_index flat = arrays().neighbor(third, arrays().place_of(third, opposite));
    flip_3_2(Arrays::corner(flat, arrays().place_of(flat, beyond)), arrays().place_of(flat, top));
    return true;
  }

  Flipped flip_right(Corner_index k)
  {
    const Outlook found = outlook(k);
    const Cell_index c = Arrays::cell_of(k);
    const Vertex_index top = arrays().vertex(k), beyond = arrays().apex(k);
    if (found.number == 0 && !has_edge(top, beyond))
      return flip_2_3(k);
    if (found.number == 1 && common_neighbor(k, found.place) != null_index &&
        !has_facet(arrays().vertices(c)[found.place], top, beyond))
      return flip_3_2(k, found.place);
    return {{null_index, null_index, null_index}, 0};
  }

  Flipped flip_2_3(Corner_index k)
  {
    const Vertex_index top = arrays().vertex(k), beyond = arrays().apex(k);
    const Flipped flipped = arrays().flip_2_3(k);
    for (const Cell_index c : flipped.cells) {
      open(c, beyond);
      open(c, top);
    }
    ++m_number;
    return flipped;
  }

  Flipped flip_3_2(Corner_index k, int side)
  {
    const Vertex_index around[3] = {arrays().vertex(k), arrays().apex(k),
                                    arrays().vertices(Arrays::cell_of(k))[side]};
    const Flipped flipped = arrays().flip_3_2(k, side);
    for (int i = 0; i < 2; ++i)
      for (const Vertex_index v : around)
        open(flipped.cells[i], v);
    ++m_number;
    return flipped;
  }

  bool has_edge(Vertex_index v, Vertex_index w)
  {
    if (v == infinite_index)
      std::swap(v, w);
    find_star(arrays(), v, m_state.marks, m_star);
    for (const Cell_index c : m_star)
      if (arrays().place_of(c, w) < 4)
        return true;
    return false;
  }
  bool has_facet(Vertex_index u, Vertex_index v, Vertex_index w)
  {
    if (u == infinite_index)
      std::swap(u, v);
    find_star(arrays(), u, m_state.marks, m_star);
    for (const Cell_index c : m_star)
      if (arrays().place_of(c, v) < 4 && arrays().place_of(c, w) < 4)
        return true;
    return false;
  }

  State& m_state;
  Cell_signs_3<State> m_signs;
  std::vector<Facet> m_finite, m_infinite; // open
  std::vector<Facet> m_stuck;
  std::size_t m_number = 0;
  std::vector<Cell_index> m_star;
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_3::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_MENDING_LAWSON_FLIPS_3_H

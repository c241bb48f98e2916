// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_QUERIES_VERTEX_STAR_3_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_QUERIES_VERTEX_STAR_3_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/passes/Elements_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/queries/Site_charts_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/topology/Tetrahedra_arrays_3.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_3::internal {

// A set of some indices, or of longer keys, by hashes. Clearing it takes time proportional to the
// number of members.
template <class Kind>
class Sparse_set_3
{
public:
  void clear()
  {
    for (const std::size_t place : m_places)
      m_table[place] = null_index;
    m_places.clear();
  }

  // Whether the index was not there before.
  bool insert(Kind v)
  {
    if (4 * m_places.size() >= m_table.size())
      grow();
    const std::size_t place = place_of(v);
    if (m_table[place] == v)
      return false;
    m_places.push_back(place); // may throw
    m_table[place] = v;
    return true;
  }

private:
  // Where the index is, or would be inserted. There is always a free place.
  std::size_t place_of(Kind v) const
  {
    const std::size_t mask = m_table.size() - 1;
    std::size_t place = hash(v) & mask;
    while (m_table[place] != v && m_table[place] != null_index)
      place = (place + 1) & mask;
    return place;
  }

  static std::size_t hash(Kind v)
  {
    if constexpr (sizeof(Kind) > sizeof(Index))
      return std::size_t((v * 0x9e3779b97f4a7c15u) >> 39);
    else
      return (Index(v) * 0x9e3779b1u) >> 7;
  }

  void grow()
  {
    std::vector<Kind> members;
    for (const std::size_t place : m_places)
      members.push_back(m_table[place]);
    m_places.clear();
    m_table.assign(m_table.empty() ? 128 : 2 * m_table.size(), null_index);
    for (const Kind v : members)
      insert(v);
  }

  std::vector<Kind> m_table;         // a power of two of them
  std::vector<std::size_t> m_places; // those in use
};

// A cell around an edge, and the site that it shares with the next cell.
template <class Charts>
struct Ring_cell_3
{
  typename Charts::Seen_cell cell;
  typename Charts::Site next;
};
// The cells around an edge, counterclockwise as seen from the end of the edge.
template <class Charts>
using Cell_ring_3 = std::vector<Ring_cell_3<Charts>>;

// Visits the neighbors of vertices, one vertex after the other. It marks no cells, so that each
// thread can have one at little cost.
template <class Arrays>
class Vertex_star_3
{
  using Charts = Site_charts_3<Arrays>;
  using Site = typename Charts::Site;
  using Seen_cell = typename Charts::Seen_cell;

public:
  // Calls f(w, ring) for each finite site w that is a neighbor of v, with the cells around the edge
  // from v to w.
  template <class Function>
  void for_each_neighbor(const Arrays& arrays, Vertex_index v, const Function& f)
  {
    m_found.clear();
    m_open.clear();
    const Site center = Charts::site(v);
    const Seen_cell first = Charts::first_cell(arrays, center);
    for (int place = 0; place < 4 && m_open.empty(); ++place)
      if (const Site w = Charts::site(arrays, first, place); !(w == center))
        note(w, first);
    for (std::size_t n = 0; n < m_open.size(); ++n) {
      const auto [w, cell] = m_open[n];
      walk_around(arrays, center, w, cell);
      for (const Ring_cell_3<Charts>& of_ring : m_ring)
        note(of_ring.next, of_ring.cell);
      f(w, m_ring);
    }
  }

private:
  // The sites around v are connected without the infinite one, too.
  void note(const Site& w, const Seen_cell& cell)
  {
    if (!Charts::is_infinite(w) && m_found.insert(Charts::key(w)))
      m_open.emplace_back(w, cell);
  }

  void walk_around(const Arrays& arrays, const Site& v, const Site& w, const Seen_cell& first)
  {
    const int from = Charts::place_of(arrays, first, v), to = Charts::place_of(arrays, first, w);
    int leaving = 0;
    while (leaving == from || leaving == to)
      ++leaving;
    int staying = 6 - from - to - leaving;
    if (!is_even(Few<int, 4>{from, to, leaving, staying}))
      std::swap(leaving, staying);
    m_ring.clear();
    Seen_cell cell = first;
    Site next = Charts::site(arrays, cell, staying);
    do {
      m_ring.push_back({cell, next});
      const Corner_index mirror = arrays.mirror(Arrays::corner(Charts::cell_of(cell), leaving));
      cell = Charts::beyond(arrays, cell, leaving, mirror);
      leaving = Charts::place_of_known(arrays, cell, next);
      next = Charts::site(arrays, cell, Arrays::place_of(mirror));
    } while (cell != first);
  }

  Sparse_set_3<typename Charts::Key> m_found;
  std::vector<std::pair<Site, Seen_cell>> m_open; // neighbors, each with a cell
  Cell_ring_3<Charts> m_ring;
};

// Visits the cells of sites, one site after the other. It is for who needs no cells around edges,
// as `Vertex_star_3` finds them by walking around each: here a cell is entered once.
template <class Arrays>
class Star_cells_3
{
  using Charts = Site_charts_3<Arrays>;
  using Site = typename Charts::Site;
  using Seen_cell = typename Charts::Seen_cell;

public:
  // Calls f(w, cell) for finite neighbors w of v, with a cell that has both, until f returns false.
  // Each neighbor comes at least once. `first` is one of the cells of v.
  template <class Function>
  void for_each_neighbor(const Arrays& arrays, const Site& v, const Seen_cell& first,
                         const Function& f)
  {
    const auto call = [&](const Site& w, const Seen_cell& c) {
      return w == v || Charts::is_infinite(w) || f(w, c);
    };
    m_found.clear();
    m_found.insert(Charts::key_of_cell(first));
    m_open.assign(1, first);
    for (int place = 0; place != 4; ++place)
      if (!call(Charts::site(arrays, first, place), first))
        return;
    for (std::size_t n = 0; n < m_open.size(); ++n) {
      const Seen_cell cell = m_open[n];
      for (int place = 0; place != 4; ++place) {
        if (Charts::site(arrays, cell, place) == v)
          continue;
        const Corner_index beyond = arrays.mirror(Arrays::corner(Charts::cell_of(cell), place));
        const Seen_cell other = Charts::beyond(arrays, cell, place, beyond);
        if (!m_found.insert(Charts::key_of_cell(other)))
          continue;
        m_open.push_back(other);
        if (!call(Charts::site(arrays, other, Arrays::place_of(beyond)), other))
          return;
      }
    }
  }

private:
  Sparse_set_3<typename Charts::Cell_key> m_found;
  std::vector<Seen_cell> m_open;
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_3::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_QUERIES_VERTEX_STAR_3_H

// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_TOPOLOGY_CELL_STAR_3_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_TOPOLOGY_CELL_STAR_3_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/passes/Elements_3.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_3::internal {

// A cell of a star before it is written, with its sites. Its mirror at the tip, the place of the
// vertex in the middle, lies outside of the star.
template <class Cell>
struct Star_cell_3
{
  Cell_index number;
  int tip;
  Cell cell;
};

// Connects the cells of a star with each other: each edge of its border belongs to two of them. A
// `Cell` is that of some arrays, with `may_repeat_vertices`, `sites()` and `site(place)`.
template <class Cell>
class Cell_star_3
{
public:
  using Star = std::vector<Star_cell_3<Cell>>;

  explicit Cell_star_3(Star& star)
    : m_star(star)
  {
  }

  // By a table, if the star is small and has no vertex with several sites; `corners`, some for each
  // vertex of the border, mean nothing after that. False if it is not like that.
  bool connect_by_table(Column<Vertex_index, Corner_index>& corners)
  {
    return m_star.size() <= most_of_table && number_vertices(corners) && connect_numbered();
  }

  // Any star.
  void connect_by_sorting()
  {
    struct Side
    {
      Few<Site, 2> ends;
      std::size_t n;
      int place;
    };
    std::vector<Side> sides;
    for_each_side([&](std::size_t n, std::size_t k, int place) {
      const auto& others = other_places[m_star[n].tip];
      const Cell& cell = m_star[n].cell;
      Site low = cell.site(others[(k + 1) % 3]), high = cell.site(others[(k + 2) % 3]);
      if (high < low)
        std::swap(low, high);
      sides.push_back({{low, high}, n, place});
    });
    std::sort(sides.begin(), sides.end(),
              [](const Side& a, const Side& b) { return a.ends < b.ends; });
    for (std::size_t i = 0; i < sides.size(); ++i) {
      const Side &side = sides[i], &other = sides[i ^ 1];
      m_star[side.n].cell.mirrors[side.place] = corner(m_star[other.n].number, other.place);
    }
  }

private:
  using Site = typename Cell::Site;

  // A star of so many cells has at most so many vertices: by Euler, half of it and two on the
  // border. All corners have numbers of a byte.
  static constexpr std::size_t most_of_table = 64, row_of_table = most_of_table / 2 + 2;

  static Corner_index corner(Cell_index c, int place) { return Corner_index(4 * c + Index(place)); }

  // Numbers the vertices of the border from 0 on. False if one of them has several sites.
  bool number_vertices(Column<Vertex_index, Corner_index>& corners)
  {
    for_each_side([&](std::size_t n, std::size_t k, int place) {
      m_vertex[k] = m_star[n].cell.vertices[place];
      m_corner[k] = corner(m_star[n].number, place);
    });
    const std::size_t size = 3 * m_star.size();
    for (std::size_t k = 0; k < size; ++k)
      corners[Vertex_index(m_vertex[k])] = Corner_index(k); // the last one of each counts
    std::array<unsigned char, 3 * most_of_table> counted;
    unsigned char vertices = 0;
    for (std::size_t k = 0; k < size; ++k) {
      counted[k] = vertices;
      vertices = static_cast<unsigned char>(vertices + (corners[Vertex_index(m_vertex[k])] == k));
    }
    bool has_one_site_each = true;
    for (std::size_t k = 0; k < size; ++k) {
      const std::size_t last = corners[Vertex_index(m_vertex[k])];
      m_number[k] = counted[last];
      if constexpr (Cell::may_repeat_vertices)
        has_one_site_each = has_one_site_each && site(k) == site(last);
    }
    return has_one_site_each;
  }

  // Two cells see an edge of the border in opposite directions; so a table, by the numbers of its
  // ends, tells the one what the other is.
  bool connect_numbered()
  {
    std::array<std::array<unsigned char, row_of_table>, row_of_table> sides;
    for (std::size_t k = 0; k < 3 * m_star.size(); k += 3)
      for (std::size_t i = 0; i < 3; ++i)
        sides[m_number[k + (i + 1) % 3]][m_number[k + (i + 2) % 3]] =
            static_cast<unsigned char>(k + i);
    for_each_side([&](std::size_t n, std::size_t k, int place) {
      const std::size_t first = 3 * n, i = k - first;
      const std::size_t from = m_number[first + (i + 1) % 3], to = m_number[first + (i + 2) % 3];
      m_star[n].cell.mirrors[place] = Corner_index(m_corner[sides[to][from]]);
    });
    return true;
  }

  Site site(std::size_t k) const
  {
    const Star_cell_3<Cell>& made = m_star[k / 3];
    return made.cell.site(other_places[made.tip][k % 3]);
  }

  // Calls f(n, k, place) for each corner of the n-th cell but that at the tip. All are counted by
  // k. The edge of the border opposite to each goes from the next one to the one after.
  template <class Function>
  void for_each_side(const Function& f) const
  {
    for (std::size_t n = 0; n < m_star.size(); ++n)
      for (std::size_t i = 0; i < 3; ++i)
        f(n, 3 * n + i, int(other_places[m_star[n].tip][i]));
  }

  Star& m_star;
  std::array<Index, 3 * most_of_table> m_vertex, m_corner; // of three corners of each cell
  std::array<unsigned char, 3 * most_of_table> m_number;   // of these vertices
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_3::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_TOPOLOGY_CELL_STAR_3_H

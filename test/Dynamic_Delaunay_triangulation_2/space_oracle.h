// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// What every test asks of a triangulation in space: a certificate by exact predicates, a fresh
// triangulation of CGAL, and nobody lost.

#ifndef DYNAMIC_DELAUNAY_TRIANGULATION_2_TEST_SPACE_ORACLE_H
#define DYNAMIC_DELAUNAY_TRIANGULATION_2_TEST_SPACE_ORACLE_H

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <set>
#include <vector>

namespace space_oracle {

using Cell = std::array<std::size_t, 4>; // ids, ascending

template <class Kernel>
using Fresh = CGAL::Delaunay_triangulation_3<
    Kernel, CGAL::Triangulation_data_structure_3<
                CGAL::Triangulation_vertex_base_with_info_3<std::size_t, Kernel>>>;

template <class Cells>
Cell sorted(const Cells& ids)
{
  Cell cell;
  std::copy(ids.begin(), ids.end(), cell.begin());
  std::sort(cell.begin(), cell.end());
  return cell;
}

template <class Dynamic>
std::set<Cell> cells_of(const Dynamic& dt)
{
  std::set<Cell> cells;
  dt.for_each_cell([&](const auto& ids) { EXPECT_TRUE(cells.insert(sorted(ids)).second); });
  return cells;
}

// Whether the sphere of a cell has no point strictly inside: the definition of a Delaunay cell.
template <class Dynamic, class Points>
bool is_empty(const Dynamic& dt, const Cell& cell, const Points& points)
{
  using Kernel = typename Dynamic::Geom_traits;
  const auto side = Kernel().side_of_bounded_sphere_3_object();
  return std::none_of(points.begin(), points.end(), [&](const auto& entry) {
    return side(dt.point(cell[0]), dt.point(cell[1]), dt.point(cell[2]), dt.point(cell[3]),
                entry.second) == CGAL::ON_BOUNDED_SIDE;
  });
}

template <class Dynamic>
std::size_t number_of_edges(const Dynamic& dt)
{
  std::set<std::array<std::size_t, 2>> edges;
  dt.for_each_edge([&](std::size_t i, std::size_t j) {
    EXPECT_NE(i, j);
    EXPECT_TRUE(edges.insert({(std::min)(i, j), (std::max)(i, j)}).second);
  });
  return edges.size();
}

template <class Dynamic>
std::size_t number_of_facets(const Dynamic& dt)
{
  std::set<std::array<std::size_t, 3>> facets;
  dt.for_each_facet([&](std::array<std::size_t, 3> ids) {
    std::sort(ids.begin(), ids.end());
    EXPECT_TRUE(facets.insert(ids).second);
  });
  return facets.size();
}

// Expects the Delaunay triangulation of these points, by id. Where points are cospherical, cells
// may be others than CGAL's.
template <class Dynamic>
void expect_exact(const Dynamic& dt, const std::map<std::size_t, typename Dynamic::Point>& points)
{
  ASSERT_EQ(dt.number_of_points(), points.size());
  Fresh<typename Dynamic::Geom_traits> fresh;
  for (const auto& [id, point] : points) {
    ASSERT_TRUE(dt.has_id(id));
    ASSERT_EQ(dt.point(id), point) << "id " << id;
    ASSERT_EQ(dt.point(dt.representative(id)), point) << "id " << id;
    fresh.insert(point)->info() = dt.representative(id);
  }
  ASSERT_TRUE(dt.is_certified());
  ASSERT_TRUE(dt.is_valid(true));
  ASSERT_EQ(dt.number_of_vertices(), fresh.number_of_vertices());
  ASSERT_EQ(dt.dimension(), fresh.dimension());

  const std::set<Cell> cells = cells_of(dt);
  bool is_other = false;
  for (const Cell& cell : cells) {
    typename Fresh<typename Dynamic::Geom_traits>::Cell_handle c;
    std::array<typename Fresh<typename Dynamic::Geom_traits>::Vertex_handle, 4> v;
    for (std::size_t i = 0; i < 4; ++i)
      ASSERT_TRUE(fresh.is_vertex(dt.point(cell[i]), v[i]));
    if (fresh.is_cell(v[0], v[1], v[2], v[3], c))
      continue;
    is_other = true;
    ASSERT_TRUE(is_empty(dt, cell, points));
  }
  if (!is_other) { // then numbers have to be the same, too
    ASSERT_EQ(cells.size(), fresh.dimension() == 3 ? fresh.number_of_finite_cells() : 0);
    ASSERT_EQ(number_of_edges(dt), fresh.dimension() >= 1 ? fresh.number_of_finite_edges() : 0);
    ASSERT_EQ(number_of_facets(dt), fresh.dimension() >= 2 ? fresh.number_of_finite_facets() : 0);
  }
}

} // namespace space_oracle

#endif // DYNAMIC_DELAUNAY_TRIANGULATION_2_TEST_SPACE_ORACLE_H

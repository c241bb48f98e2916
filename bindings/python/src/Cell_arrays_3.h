// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PYTHON_CELL_ARRAYS_3_H
#define PYTHON_CELL_ARRAYS_3_H

#include "bindings/common/Array_numbers.h"
#include "bindings/common/Subject.h"

#include <CGAL/Dynamic_Delaunay_triangulation_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/Voronoi_cell_measures_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/Voronoi_cell_volumes_3.h>
#include <CGAL/Iterator_range.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <type_traits>
#include <utility>
#include <vector>

// Arrays of a triangulation in space, in linear time.
namespace python {

using namespace bindings;

using CGAL::Dynamic_Delaunay_triangulations_3::Cell_index;
using CGAL::Dynamic_Delaunay_triangulations_3::Point_id;
using CGAL::Dynamic_Delaunay_triangulations_3::Position_3;
using CGAL::Dynamic_Delaunay_triangulations_3::Vertex_index;

// NaN in rows of removed ids.
template <class Dynamic>
Array point_array_3(const Dynamic& dt, const Row_numbers& rows)
{
  Doubles coordinates(3 * rows.size(), std::numeric_limits<double>::quiet_NaN());
  for (std::size_t id = 0; id < dt.number_of_ids(); ++id) {
    if (dt.has_id(id)) {
      const auto p = dt.point(id);
      std::copy(p.cartesian_begin(), p.cartesian_end(), &coordinates[3 * std::size_t(rows[id])]);
    }
  }
  return {std::move(coordinates), {3}};
}

// Pairs: each point that shares a vertex with another one, and the one that represents it.
template <class Dynamic>
Integers duplicate_pairs_3(const Dynamic& dt, const Row_numbers& rows)
{
  Integers pairs;
  if (dt.number_of_vertices() == dt.number_of_points()) {
    return pairs;
  }
  for (std::size_t id = 0; id < dt.number_of_ids(); ++id) {
    if (dt.has_id(id) && dt.representative(id) != id) {
      pairs.insert(pairs.end(), {rows[id], rows[dt.representative(id)]});
    }
  }
  return pairs;
}

// The state of a triangulation, and its finite cells, numbered as they follow each other.
template <class Dynamic>
class Finite_cells_3
{
public:
  explicit Finite_cells_3(const Dynamic& dt)
    : m_state(CGAL::Dynamic_Delaunay_triangulations_3::internal::Triangulation_access::state(dt))
    , m_numbers(m_state.spans_space ? m_state.arrays.number_of_cells() : 0, -1)
  {
    for (Cell_index c(0); c < m_numbers.size(); ++c) {
      if (!m_state.arrays.is_infinite(c)) {
        m_numbers[c] = m_size++;
      }
    }
  }

  std::size_t size() const { return std::size_t(m_size); }
  // Of a cell; -1 if it is infinite.
  std::int32_t number(Cell_index c) const { return m_numbers[c]; }
  const auto& arrays() const { return m_state.arrays; }
  const Position_3& position(Cell_index c, int place) const
  {
    return m_state.positions.position(m_state.arrays.vertices(c)[place]);
  }
  Vertex_index vertex(Cell_index c, int place) const { return m_state.arrays.vertices(c)[place]; }
  std::size_t id(Vertex_index v) const { return std::size_t(m_state.ids.representative(v)); }
  // Of an id that is there.
  Vertex_index vertex(std::size_t id) const { return m_state.ids.vertex(Point_id(id)); }
  // The infinite one, which is 0, included.
  std::size_t number_of_vertices() const { return m_state.number_of_vertices() + std::size_t(1); }

  // Calls `f(c)` for each finite cell, in the order of their numbers.
  template <class Function>
  void for_each(const Function& f) const
  {
    for (Cell_index c(0); c < m_numbers.size(); ++c) {
      if (m_numbers[c] >= 0) {
        f(c);
      }
    }
  }

private:
  using State = std::decay_t<
      decltype(CGAL::Dynamic_Delaunay_triangulations_3::internal::Triangulation_access::state(
          std::declval<Dynamic>()))>;

  const State& m_state;
  Integers m_numbers;
  std::int32_t m_size = 0;
};

// For each corner of each finite cell `value_of(c, place)`.
template <class Dynamic, class Value>
Integers corner_values_3(const Finite_cells_3<Dynamic>& cells, const Value& value_of)
{
  Integers values(4 * cells.size());
  auto value = values.begin();
  cells.for_each([&](Cell_index c) {
    for (int i = 0; i < 4; ++i) {
      *value++ = value_of(c, i);
    }
  });
  return values;
}

// The rows of the corners of each cell, positively oriented, and the cells opposite to them, or -1.
template <class Dynamic>
std::vector<Array> simplex_arrays_3(const Dynamic& dt, const Row_numbers& rows)
{
  const Finite_cells_3<Dynamic> cells(dt);
  const auto row = [&](Cell_index c, int place) { return rows[cells.id(cells.vertex(c, place))]; };
  const auto neighbor = [&](Cell_index c, int place) {
    return cells.number(cells.arrays().neighbor(c, place));
  };
  return {{corner_values_3(cells, row), {4}}, {corner_values_3(cells, neighbor), {4}}};
}

// Of a positive cell; its edges are made about as long as 1 meanwhile, and halved before, so that
// nothing overflows, and nothing underflows unless the volume does.
inline double volume_3(const std::array<Position_3, 4>& corners)
{
  std::array<std::array<double, 3>, 3> edges;
  double longest = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const Position_3 &p = corners[0], &q = corners[i + 1];
    edges[i] = {q.x / 2 - p.x / 2, q.y / 2 - p.y / 2, q.z / 2 - p.z / 2};
    for (const double coordinate : edges[i]) {
      longest = (std::max)(longest, std::abs(coordinate));
    }
  }
  int exponent = 0;
  std::frexp(longest, &exponent);
  const double factor = std::ldexp(1.0, (std::min)(-exponent, 1000));
  for (auto& edge : edges) {
    for (double& coordinate : edge) {
      coordinate *= factor;
    }
  }
  const auto& [u, v, w] = edges;
  const double six_volumes = u[0] * (v[1] * w[2] - v[2] * w[1]) +
                             u[1] * (v[2] * w[0] - v[0] * w[2]) +
                             u[2] * (v[0] * w[1] - v[1] * w[0]);
  return (std::max)(std::ldexp(six_volumes / 6, 3 * (1 - (std::min)(-exponent, 1000))), 0.0);
}

// In the order of the simplices.
template <class Dynamic>
Array volume_array_3(const Dynamic& dt)
{
  const Finite_cells_3<Dynamic> cells(dt);
  Doubles volumes;
  volumes.reserve(cells.size());
  cells.for_each([&](Cell_index c) {
    volumes.push_back(volume_3(
        {cells.position(c, 0), cells.position(c, 1), cells.position(c, 2), cells.position(c, 3)}));
  });
  return {std::move(volumes)};
}

// The volumes of Voronoi cells alone, also in periodic space.
template <class Dynamic>
Array voronoi_volume_array_3(const Dynamic& dt, const Row_numbers& rows)
{
  CGAL::Voronoi_cell_volumes_3 cells;
  cells.compute(dt);
  Doubles volumes;
  for (std::size_t id = 0; id < dt.number_of_ids(); ++id) {
    if (dt.has_id(id) || !rows.are_dense()) {
      volumes.push_back(cells.volumes()[id]);
    }
  }
  return {std::move(volumes)};
}

// The measures of Voronoi cells, whole or in a box: volumes, surface areas and centroids; where the
// facets of each row begin, the rows on their other sides, and their areas.
template <class Dynamic>
std::vector<Array> voronoi_arrays_3(const Dynamic& dt, const Row_numbers& rows,
                                    const CGAL::Bbox_3* box)
{
  CGAL::Voronoi_cell_measures_3 cells;
  if (box) {
    cells.compute(dt, *box);
  } else {
    cells.compute(dt);
  }
  Doubles volumes, surface_areas, centroids;
  std::vector<std::int64_t> begins; // an id without a row has no facets
  for (std::size_t id = 0; id < dt.number_of_ids(); ++id) {
    if (dt.has_id(id) || !rows.are_dense()) {
      const Position_3& centroid = cells.centroids()[id];
      volumes.push_back(cells.volumes()[id]);
      surface_areas.push_back(cells.surface_areas()[id]);
      centroids.insert(centroids.end(), {centroid.x, centroid.y, centroid.z});
      begins.push_back(std::int64_t(cells.offsets()[id]));
    }
  }
  begins.push_back(std::int64_t(cells.neighbors().size()));
  Integers neighbors;
  neighbors.reserve(cells.neighbors().size());
  for (const auto neighbor : cells.neighbors()) {
    neighbors.push_back(rows[neighbor]);
  }
  return {{std::move(volumes)}, {std::move(surface_areas)}, {std::move(centroids), {3}},
          {std::move(begins)},  {std::move(neighbors)},     {cells.facet_areas()}};
}

// Lists, one for each row, one after the other: that of row i begins at `begins[i]`.
struct Row_lists
{
  auto operator[](std::size_t row) const
  {
    const auto at = [&](std::size_t i) { return entries.begin() + begins[i]; };
    return CGAL::make_range(at(row), at(row + 1));
  }

  Integers begins, entries;
};

// Lists what `for_each_entry(f)` has, which calls `f(row, entry)` for each entry, the last one
// first. It is called twice.
template <class For_each_entry>
Row_lists listed_by_row(std::size_t number_of_rows, const For_each_entry& for_each_entry)
{
  Row_lists lists{Integers(number_of_rows + 1), {}};
  std::size_t size = 0;
  for_each_entry([&](std::int32_t row, std::int32_t) {
    ++lists.begins[std::size_t(row)];
    ++size;
  });
  check_length(size);
  lists.entries.resize(size);
  std::partial_sum(lists.begins.begin(), lists.begins.end(), lists.begins.begin());
  for_each_entry([&](std::int32_t row, std::int32_t entry) {
    lists.entries[std::size_t(--lists.begins[std::size_t(row)])] = entry;
  });
  return lists;
}

// The neighbors of each vertex, in any order: the other corners of its cells.
template <class Dynamic>
Row_lists neighbor_vertices_3(const Finite_cells_3<Dynamic>& cells)
{
  const Integers corners = corner_values_3(
      cells, [&](Cell_index c, int place) { return std::int32_t(cells.vertex(c, place)); });
  const Row_lists corners_of = listed_by_row(cells.number_of_vertices(), [&](const auto& f) {
    for (std::size_t i = corners.size(); i-- > 0;) {
      f(corners[i], std::int32_t(i));
    }
  });
  Row_lists lists{{0}, {}};
  lists.begins.reserve(cells.number_of_vertices() + 1);
  lists.entries.reserve(16 * cells.number_of_vertices());
  Integers seen_by(cells.number_of_vertices(), -1), found;
  for (std::size_t v = 0; v < cells.number_of_vertices(); ++v) {
    const auto its_corners = corners_of[v];
    found.resize(4 * its_corners.size() + 1);
    std::size_t size = 0;
    seen_by[v] = std::int32_t(v);
    for (const std::int32_t corner : its_corners) {
      const auto first = corners.begin() + (corner - corner % 4);
      std::for_each(first, first + 4, [&](std::int32_t w) { // without branches: none is foreseen
        found[size] = w;
        size += std::exchange(seen_by[std::size_t(w)], std::int32_t(v)) != std::int32_t(v);
      });
    }
    lists.entries.insert(lists.entries.end(), found.begin(), found.begin() + std::ptrdiff_t(size));
    check_length(lists.entries.size());
    lists.begins.push_back(std::int32_t(lists.entries.size()));
  }
  return lists;
}

// Of points in a plane or on a line, which have no cells.
template <class Dynamic>
Integers flat_edges_3(const Dynamic& dt, const Row_numbers& rows)
{
  Integers edges;
  dt.for_each_edge([&](std::size_t i, std::size_t j) {
    edges.insert(edges.end(), {rows[i], rows[j]});
  });
  return edges;
}

// The neighbors of each row, ascending: by cells, and the other ends of pairs of rows. First those
// of vertices are found, as vertices that are close in space are close in memory. Ids may be
// anywhere.
template <class Dynamic>
Row_lists neighbor_lists_3(const Dynamic& dt, const Row_numbers& rows, const Integers& pairs)
{
  const Finite_cells_3<Dynamic> cells(dt);
  const Row_lists neighbors = neighbor_vertices_3(cells);
  const Row_lists ends = listed_by_row(rows.size(), [&](const auto& f) {
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      f(pairs[i], pairs[i ^ 1]);
    }
  });
  return listed_by_row(rows.size(), [&](const auto& f) { // who is a neighbor has this one
    for (std::size_t id = dt.number_of_ids(); id-- > 0;) {
      if (!dt.has_id(id)) {
        continue;
      }
      const std::int32_t row = rows[id];
      if (dt.representative(id) == id) {
        for (const std::int32_t w : neighbors[cells.vertex(id)]) {
          f(rows[cells.id(Vertex_index(w))], row);
        }
      }
      for (const std::int32_t end : ends[std::size_t(row)]) {
        f(end, row);
      }
    }
  });
}

template <class Dynamic>
Array edge_array_3(const Dynamic& dt, const Row_numbers& rows)
{
  if (dt.dimension() < 3) {
    return {flat_edges_3(dt, rows), {2}};
  }
  const Row_lists lists = neighbor_lists_3(dt, rows, {});
  Integers edges;
  edges.reserve(lists.entries.size());
  for (std::size_t row = 0; row < rows.size(); ++row) {
    for (const std::int32_t other : lists[row]) {
      if (other > std::int32_t(row)) {
        edges.insert(edges.end(), {std::int32_t(row), other});
      }
    }
  }
  return {std::move(edges), {2}};
}

template <class Dynamic>
std::vector<Array> neighbor_list_arrays_3(const Dynamic& dt, const Row_numbers& rows)
{
  Integers pairs = duplicate_pairs_3(dt, rows);
  if (dt.dimension() < 3) {
    const Integers edges = flat_edges_3(dt, rows);
    pairs.insert(pairs.end(), edges.begin(), edges.end());
  }
  Row_lists lists = neighbor_lists_3(dt, rows, pairs);
  return {{std::move(lists.begins)}, {std::move(lists.entries)}};
}

} // namespace python

#endif // PYTHON_CELL_ARRAYS_3_H

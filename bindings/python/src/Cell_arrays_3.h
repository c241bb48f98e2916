// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PYTHON_CELL_ARRAYS_3_H
#define PYTHON_CELL_ARRAYS_3_H

#include "bindings/common/Array_numbers.h"
#include "bindings/common/Subject.h"

#include <CGAL/Dynamic_Delaunay_triangulation_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

// Arrays of a triangulation in space, in linear time. Their rows are ids.
namespace python {

using bindings::check_length;
using bindings::Doubles;
using bindings::Integers;

using CGAL::Dynamic_Delaunay_triangulations_3::Cell_index;
using CGAL::Dynamic_Delaunay_triangulations_3::Position_3;

// NaN for removed ids.
template <class Dynamic>
Array point_array_3(const Dynamic& dt)
{
  Doubles coordinates(3 * dt.number_of_ids(), std::numeric_limits<double>::quiet_NaN());
  for (std::size_t id = 0; id < dt.number_of_ids(); ++id) {
    if (dt.has_id(id)) {
      const auto p = dt.point(id);
      std::copy_n(std::array<double, 3>{p.x(), p.y(), p.z()}.begin(), 3, &coordinates[3 * id]);
    }
  }
  return {std::move(coordinates), {3}};
}

// Pairs: each point that shares a vertex with another one, and the one that represents it.
template <class Dynamic>
Integers duplicate_pairs_3(const Dynamic& dt)
{
  Integers pairs;
  if (dt.number_of_vertices() == dt.number_of_points()) {
    return pairs;
  }
  for (std::size_t id = 0; id < dt.number_of_ids(); ++id) {
    if (dt.has_id(id) && dt.representative(id) != id) {
      pairs.insert(pairs.end(), {std::int32_t(id), std::int32_t(dt.representative(id))});
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
    : m_state(CGAL::Dynamic_Delaunay_triangulations_3::internal::Access_3::state(dt))
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
  std::int32_t id(Cell_index c, int place) const
  {
    return std::int32_t(m_state.ids.representative(m_state.arrays.vertices(c)[place]));
  }

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
  using State =
      std::decay_t<decltype(CGAL::Dynamic_Delaunay_triangulations_3::internal::Access_3::state(
          std::declval<Dynamic>()))>;

  const State& m_state;
  Integers m_numbers;
  std::int32_t m_size = 0;
};

// The ids of the corners of each cell, positively oriented.
template <class Dynamic>
Integers corner_ids_3(const Finite_cells_3<Dynamic>& cells)
{
  Integers corners(4 * cells.size());
  auto corner = corners.begin();
  cells.for_each([&](Cell_index c) {
    for (int i = 0; i < 4; ++i) {
      *corner++ = cells.id(c, i);
    }
  });
  return corners;
}

// The cell opposite to each corner, or -1.
template <class Dynamic>
Integers neighbor_numbers_3(const Finite_cells_3<Dynamic>& cells)
{
  Integers neighbors(4 * cells.size());
  auto neighbor = neighbors.begin();
  cells.for_each([&](Cell_index c) {
    for (int i = 0; i < 4; ++i) {
      *neighbor++ = cells.number(cells.arrays().neighbor(c, i));
    }
  });
  return neighbors;
}

template <class Dynamic>
std::vector<Array> simplex_arrays_3(const Dynamic& dt)
{
  const Finite_cells_3<Dynamic> cells(dt);
  return {{corner_ids_3(cells), {4}}, {neighbor_numbers_3(cells), {4}}};
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

// Lists, one for each row, one after the other: that of row i begins at `begins[i]`.
struct Row_lists
{
  Integers begins, entries;
};

// The numbers 0, 1, 2, ... of these rows, listed by row.
inline Row_lists numbers_by_row(const Integers& rows, std::size_t number_of_rows)
{
  check_length(rows.size());
  Row_lists lists{Integers(number_of_rows + 1), Integers(rows.size())};
  for (const std::int32_t row : rows) {
    ++lists.begins[std::size_t(row)];
  }
  std::partial_sum(lists.begins.begin(), lists.begins.end(), lists.begins.begin());
  for (std::size_t i = rows.size(); i-- > 0;) { // each list from its end on
    lists.entries[std::size_t(--lists.begins[std::size_t(rows[i])])] = std::int32_t(i);
  }
  return lists;
}

// The neighbors of each id, ascending: the other corners of its cells, of which there are four ids
// each, and the other ends of pairs, which have two.
inline Row_lists neighbor_lists_3(const Integers& corners, const Integers& pairs,
                                  std::size_t number_of_ids)
{
  const Row_lists cells = numbers_by_row(corners, number_of_ids),
                  ends = numbers_by_row(pairs, number_of_ids);
  Row_lists lists;
  lists.begins.reserve(number_of_ids + 1);
  lists.entries.reserve(corners.size()); // a vertex has half as many cells as neighbors, and more
  lists.begins.push_back(0);
  Integers seen_by(number_of_ids, -1);
  for (std::size_t id = 0; id < number_of_ids; ++id) {
    const auto add = [&](std::int32_t other) {
      if (std::exchange(seen_by[std::size_t(other)], std::int32_t(id)) != std::int32_t(id)) {
        lists.entries.push_back(other);
      }
    };
    seen_by[id] = std::int32_t(id);
    for (auto i = cells.begins[id]; i < cells.begins[id + 1]; ++i) {
      const std::size_t cell = std::size_t(cells.entries[std::size_t(i)]) / 4;
      std::for_each_n(&corners[4 * cell], 4, add);
    }
    for (auto i = ends.begins[id]; i < ends.begins[id + 1]; ++i) {
      add(pairs[std::size_t(ends.entries[std::size_t(i)]) ^ 1]);
    }
    std::sort(lists.entries.begin() + lists.begins.back(), lists.entries.end());
    check_length(lists.entries.size());
    lists.begins.push_back(std::int32_t(lists.entries.size()));
  }
  return lists;
}

// Of points in a plane or on a line, which have no cells.
template <class Dynamic>
Integers flat_edges_3(const Dynamic& dt)
{
  Integers edges;
  dt.for_each_edge([&](std::size_t i, std::size_t j) {
    edges.insert(edges.end(), {std::int32_t(i), std::int32_t(j)});
  });
  return edges;
}

template <class Dynamic>
Row_lists neighbor_lists_3(const Dynamic& dt, Integers pairs)
{
  if (dt.dimension() < 3) {
    const Integers edges = flat_edges_3(dt);
    pairs.insert(pairs.end(), edges.begin(), edges.end());
  }
  return neighbor_lists_3(corner_ids_3(Finite_cells_3<Dynamic>(dt)), pairs, dt.number_of_ids());
}

template <class Dynamic>
Array edge_array_3(const Dynamic& dt)
{
  const Row_lists lists = neighbor_lists_3(dt, {});
  Integers edges;
  edges.reserve(lists.entries.size());
  for (std::size_t id = 0; id < dt.number_of_ids(); ++id) {
    for (auto i = lists.begins[id]; i < lists.begins[id + 1]; ++i) {
      if (const std::int32_t other = lists.entries[std::size_t(i)]; other > std::int32_t(id)) {
        edges.insert(edges.end(), {std::int32_t(id), other});
      }
    }
  }
  return {std::move(edges), {2}};
}

template <class Dynamic>
std::vector<Array> neighbor_list_arrays_3(const Dynamic& dt)
{
  Row_lists lists = neighbor_lists_3(dt, duplicate_pairs_3(dt));
  return {{std::move(lists.begins)}, {std::move(lists.entries)}};
}

} // namespace python

#endif // PYTHON_CELL_ARRAYS_3_H

// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PYTHON_PERIODIC_ARRAYS_3_H
#define PYTHON_PERIODIC_ARRAYS_3_H

#include "bindings/common/Array_numbers.h"
#include "bindings/common/Subject.h"
#include "bindings/python/src/Cell_arrays_3.h"

#include <CGAL/Dynamic_Delaunay_triangulation_3/Delaunay_neighbor_lists_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/Periodic_shift_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/Voronoi_cell_measures_3.h>
#include <CGAL/Dynamic_periodic_Delaunay_triangulation_3.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace bindings {

template <class... Parameters>
constexpr bool
    is_periodic_triangulation<CGAL::Dynamic_periodic_Delaunay_triangulation_3<Parameters...>> =
        true;

} // namespace bindings

// Arrays of a triangulation in periodic space, in linear time.
namespace python {

inline void append(Integers& integers, const CGAL::Periodic_shift_3& shift)
{
  integers.insert(integers.end(), shift.begin(), shift.end());
}

// The rows of the corners of each cell, positively oriented, and their shifts.
template <class Dynamic>
std::vector<Array> periodic_simplex_arrays(const Dynamic& dt, const Row_numbers& rows)
{
  check_length(12 * dt.number_of_cells());
  Integers corners, shifts;
  dt.for_each_cell([&](const std::array<std::size_t, 4>& ids,
                       const std::array<CGAL::Periodic_shift_3, 4>& its_shifts) {
    for (std::size_t i = 0; i < 4; ++i) {
      corners.push_back(rows[ids[i]]);
      append(shifts, its_shifts[i]);
    }
  });
  return {{std::move(corners), {4}}, {std::move(shifts), {4, 3}}};
}

// In the order of the simplices.
template <class Dynamic>
Array periodic_volume_array(const Dynamic& dt)
{
  Doubles volumes;
  volumes.reserve(dt.number_of_cells());
  dt.for_each_cell([&](const std::array<std::size_t, 4>& ids,
                       const std::array<CGAL::Periodic_shift_3, 4>& shifts) {
    std::array<Position_3, 4> corners{{{0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}}};
    for (std::size_t i = 1; i < 4; ++i) {
      const auto way = dt.vector(ids[0], ids[i], shifts[i]);
      corners[i] = {way.x(), way.y(), way.z()};
    }
    volumes.push_back(volume_3(corners));
  });
  return {std::move(volumes)};
}

// Where the entries of each row begin, and of the last one end, by those of ids; an id without a
// row has none.
template <class Number, class Dynamic, class Offsets>
std::vector<Number> begins_of_rows(const Dynamic& dt, const Row_numbers& rows,
                                   const Offsets& offsets)
{
  std::vector<Number> begins;
  begins.reserve(rows.size() + 1);
  for (std::size_t id = 0; id < dt.number_of_ids(); ++id) {
    if (dt.has_id(id) || !rows.are_dense()) {
      begins.push_back(Number(offsets[id]));
    }
  }
  begins.push_back(Number(offsets[dt.number_of_ids()]));
  return begins;
}

template <class Ids>
Integers rows_of(const Ids& ids, const Row_numbers& rows)
{
  Integers integers;
  integers.reserve(ids.size());
  for (const auto id : ids) {
    integers.push_back(rows[id]);
  }
  return integers;
}

inline Integers shift_numbers(const std::vector<CGAL::Periodic_shift_3>& shifts)
{
  Integers integers;
  integers.reserve(3 * shifts.size());
  for (const CGAL::Periodic_shift_3& shift : shifts) {
    append(integers, shift);
  }
  return integers;
}

// The neighbors of each row, their shifts, and the vectors to them.
template <class Dynamic>
std::vector<Array> periodic_neighbor_list_arrays(const Dynamic& dt, const Row_numbers& rows)
{
  CGAL::Delaunay_neighbor_lists_3 lists;
  lists.compute_with_vectors(dt);
  check_length(3 * lists.neighbors().size());
  Doubles vectors;
  vectors.reserve(3 * lists.vectors().size());
  for (const Position_3& way : lists.vectors()) {
    vectors.insert(vectors.end(), {way.x, way.y, way.z});
  }
  return {{begins_of_rows<std::int32_t>(dt, rows, lists.offsets())},
          {rows_of(lists.neighbors(), rows)},
          {shift_numbers(lists.shifts()), {3}},
          {std::move(vectors), {3}}};
}

// Each edge once, from the smaller row; a loop by the shift of which the first number that is not 0
// is positive. With the shifts of the second ends.
template <class Dynamic>
std::vector<Array> periodic_edge_arrays(const Dynamic& dt, const Row_numbers& rows)
{
  CGAL::Delaunay_neighbor_lists_3 lists;
  lists.compute(dt);
  Integers edges, shifts;
  for (std::size_t id = 0; id < dt.number_of_ids(); ++id) {
    if (!dt.has_id(id) || dt.representative(id) != id) {
      continue;
    }
    for (std::size_t i = lists.offsets()[id]; i < lists.offsets()[id + 1]; ++i) {
      const std::size_t other = lists.neighbors()[i];
      const CGAL::Periodic_shift_3& shift = lists.shifts()[i];
      if (dt.representative(other) == other &&
          (id < other || (id == other && CGAL::Periodic_shift_3{} < shift))) {
        edges.insert(edges.end(), {rows[id], rows[other]});
        append(shifts, shift);
      }
    }
  }
  return {{std::move(edges), {2}}, {std::move(shifts), {3}}};
}

// The measures of Voronoi cells: volumes, surface areas and centroids; where the facets of each row
// begin, the rows on their other sides, their areas, shifts, and the vectors to the other points.
template <class Dynamic>
std::vector<Array> periodic_voronoi_arrays(const Dynamic& dt, const Row_numbers& rows)
{
  CGAL::Voronoi_cell_measures_3 cells;
  cells.compute(dt);
  Doubles volumes, surface_areas, centroids, vectors;
  vectors.reserve(3 * cells.neighbors().size());
  for (std::size_t id = 0; id < dt.number_of_ids(); ++id) {
    if (dt.has_id(id) || !rows.are_dense()) {
      const Position_3& centroid = cells.centroids()[id];
      volumes.push_back(cells.volumes()[id]);
      surface_areas.push_back(cells.surface_areas()[id]);
      centroids.insert(centroids.end(), {centroid.x, centroid.y, centroid.z});
    }
    for (std::size_t i = cells.offsets()[id]; i < cells.offsets()[id + 1]; ++i) {
      const auto way = dt.vector(id, cells.neighbors()[i], cells.shifts()[i]);
      vectors.insert(vectors.end(), {way.x(), way.y(), way.z()});
    }
  }
  return {{std::move(volumes)},
          {std::move(surface_areas)},
          {std::move(centroids), {3}},
          {begins_of_rows<std::int64_t>(dt, rows, cells.offsets())},
          {rows_of(cells.neighbors(), rows)},
          {cells.facet_areas()},
          {shift_numbers(cells.shifts()), {3}},
          {std::move(vectors), {3}}};
}

} // namespace python

#endif // PYTHON_PERIODIC_ARRAYS_3_H

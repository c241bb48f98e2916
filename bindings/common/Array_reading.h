// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef BINDINGS_ARRAY_READING_H
#define BINDINGS_ARRAY_READING_H

#include "bindings/common/Array_numbers.h"
#include "bindings/common/Subject.h"

#include <CGAL/Dynamic_Delaunay_triangulation_2/queries/Delaunay_neighbor_lists_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/queries/Voronoi_cell_measures_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/queries/Voronoi_cells_2.h>
#include <CGAL/Dynamic_periodic_Delaunay_triangulation_2.h>
#include <CGAL/Periodic_cell_2.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

namespace bindings {

template <class... Parameters>
constexpr bool
    is_periodic_triangulation<CGAL::Dynamic_periodic_Delaunay_triangulation_2<Parameters...>> =
        true;

inline void append(Integers& numbers, const CGAL::Periodic_shift_2& shift)
{
  numbers.insert(numbers.end(), {shift[0], shift[1]});
}

template <class Dynamic>
Array point_array(const Dynamic& dt, const Row_numbers& rows)
{
  Doubles points;
  points.reserve(2 * rows.size());
  for (std::size_t id = 0; id < dt.number_of_ids(); ++id) {
    if (dt.has_id(id)) {
      const auto& p = dt.point(id);
      points.insert(points.end(), {p.x(), p.y()});
    } else if (!rows.are_dense()) {
      constexpr double nan = std::numeric_limits<double>::quiet_NaN();
      points.insert(points.end(), {nan, nan});
    }
  }
  return {std::move(points), {2}};
}

// Points that share a vertex with another one, and that one.
template <class Dynamic>
Array duplicate_array(const Dynamic& dt, const Row_numbers& rows)
{
  Integers duplicates;
  if constexpr (is_periodic_triangulation<Dynamic>) {
    for (std::size_t id = 0; id < dt.number_of_ids(); ++id) {
      if (dt.has_id(id) && dt.representative(id) != id) {
        duplicates.insert(duplicates.end(), {rows[id], rows[dt.representative(id)]});
      }
    }
  } else {
    const auto frame = dt.frame();
    frame.for_each_duplicate([&](std::size_t id) {
      duplicates.insert(duplicates.end(), {rows[id], rows[frame.id(frame.vertex(id))]});
    });
  }
  return {std::move(duplicates), {2}};
}

// Edges, and in periodic space shifts.
template <class Dynamic>
std::vector<Array> edge_arrays(const Dynamic& dt, const Row_numbers& rows)
{
  Integers edges, shifts;
  edges.reserve(6 * dt.number_of_vertices());
  if constexpr (is_periodic_triangulation<Dynamic>) {
    shifts.reserve(6 * dt.number_of_vertices());
    dt.for_each_edge([&](std::size_t i, std::size_t j, const CGAL::Periodic_shift_2& shift) {
      edges.insert(edges.end(), {rows[i], rows[j]});
      append(shifts, shift);
    });
    return {{std::move(edges), {2}}, {std::move(shifts), {2}}};
  } else {
    dt.for_each_edge([&](std::size_t i, std::size_t j) {
      edges.insert(edges.end(), {rows[i], rows[j]});
    });
    return {{std::move(edges), {2}}};
  }
}

// Sets what is across an edge of a face, beside the corner that is opposite to the edge.
template <class Frame>
void set_neighbor(const Frame& frame, const Integers& numbers, typename Frame::Face_index face,
                  typename Frame::Vertex_index opposite, std::int32_t neighbor, Integers& neighbors)
{
  if (numbers[face] < 0) {
    return;
  }
  const auto corners = frame.face(face);
  for (std::size_t k = 0; k < 3; ++k) {
    if (corners[k] == opposite) {
      neighbors[3 * std::size_t(numbers[face]) + k] = neighbor;
    }
  }
}

// Finite faces and their neighbors.
template <class Dynamic>
std::vector<Array> planar_triangle_arrays(const Dynamic& dt, const Row_numbers& rows)
{
  using Edge_index = typename Dynamic::Frame::Edge_index;
  using Face_index = typename Dynamic::Frame::Face_index;
  using Vertex_index = typename Dynamic::Frame::Vertex_index;
  const auto frame = dt.frame();
  const bool has_faces = dt.tds().dimension() == 2;
  Integers corners, numbers(has_faces ? frame.number_of_faces() : 0, -1);
  corners.reserve(3 * numbers.size());
  for (Face_index f(0); f < numbers.size(); ++f) {
    const auto vertices = frame.face(f);
    if (frame.is_infinite(vertices[0]) || frame.is_infinite(vertices[1]) ||
        frame.is_infinite(vertices[2])) {
      continue;
    }
    numbers[f] = std::int32_t(corners.size() / 3);
    for (const Vertex_index v : vertices) {
      corners.push_back(rows[frame.id(v)]);
    }
  }
  Integers neighbors(corners.size(), -1);
  for (Edge_index e(0); has_faces && e < frame.number_of_edges(); ++e) {
    const auto& edge = frame.edge(e);
    const auto [left, right] = frame.faces_at(e);
    set_neighbor(frame, numbers, left, edge.left, numbers[right], neighbors);
    set_neighbor(frame, numbers, right, edge.right, numbers[left], neighbors);
  }
  return {{std::move(corners), {3}}, {std::move(neighbors), {3}}};
}

// Finite faces without their neighbors, and in periodic space the shifts of their corners.
template <class Dynamic>
std::vector<Array> corner_arrays(const Dynamic& dt, const Row_numbers& rows)
{
  Integers corners(3 * std::size_t(dt.frame().number_of_faces())), shifts;
  shifts.reserve(is_periodic_triangulation<Dynamic> ? 2 * corners.size() : 0);
  std::size_t size = 0; // to append one by one would take nearly twice as long
  dt.for_each_face([&](const std::array<std::size_t, 3>& ids, const auto&... its_shifts) {
    for (std::size_t k = 0; k < 3; ++k) {
      corners[size++] = rows[ids[k]];
      (append(shifts, its_shifts[k]), ...);
    }
  });
  corners.resize(size);
  return {{std::move(corners), {3}}, {std::move(shifts), {3, 2}}};
}

// Where each list begins, neighbors, and in periodic space their shifts.
template <class Dynamic>
std::vector<Array> neighbor_list_arrays(const Dynamic& dt, const Row_numbers& rows)
{
  CGAL::Delaunay_neighbor_lists_2 lists;
  lists.compute(dt);
  Integers begins{0}, neighbors, shifts;
  begins.reserve(rows.size() + 1);
  neighbors.reserve(lists.neighbors().size());
  for (std::size_t id = 0; id < dt.number_of_ids(); ++id) {
    for (const auto j : lists.neighbors(id)) {
      neighbors.push_back(rows[j]);
    }
    if (dt.has_id(id) || !rows.are_dense()) {
      begins.push_back(std::int32_t(neighbors.size()));
    }
  }
  for (const CGAL::Periodic_shift_2& shift : lists.shifts()) {
    append(shifts, shift);
  }
  return {{std::move(begins)}, {std::move(neighbors)}, {std::move(shifts), {2}}};
}

// Areas, perimeters, centroids and shape indices.
template <class Dynamic>
std::vector<Array> measure_arrays(const Dynamic& dt, const Row_numbers& rows,
                                  const CGAL::Voronoi_cell_measures_2& measures)
{
  Doubles areas, perimeters, centroids, shape_indices;
  for (std::size_t id = 0; id < dt.number_of_ids(); ++id) {
    if (rows.are_dense() && !dt.has_id(id)) {
      continue;
    }
    areas.push_back(measures.areas()[id]);
    perimeters.push_back(measures.perimeters()[id]);
    centroids.insert(centroids.end(), {measures.centroids()[id].x, measures.centroids()[id].y});
    shape_indices.push_back(measures.shape_indices()[id]);
  }
  return {{std::move(areas)},
          {std::move(perimeters)},
          {std::move(centroids), {2}},
          {std::move(shape_indices)}};
}

// Pairs of neighbors, in periodic space shifts, and the lengths of their Voronoi edges.
template <class Dynamic>
std::vector<Array> ridge_arrays(const Dynamic& dt, const Row_numbers& rows)
{
  Integers pairs, shifts;
  Doubles lengths;
  if constexpr (is_periodic_triangulation<Dynamic>) {
    CGAL::for_each_voronoi_edge(
        dt, [&](std::size_t i, std::size_t j, const CGAL::Periodic_shift_2& shift, double length) {
          pairs.insert(pairs.end(), {rows[i], rows[j]});
          append(shifts, shift);
          lengths.push_back(length);
        });
  } else {
    CGAL::for_each_voronoi_edge(dt, [&](std::size_t i, std::size_t j, double length) {
      pairs.insert(pairs.end(), {rows[i], rows[j]});
      lengths.push_back(length);
    });
  }
  return {{std::move(pairs), {2}}, {std::move(lengths)}, {std::move(shifts), {2}}};
}

// Of an unbounded cell there are none.
template <class Dynamic>
Array corner_array(const Dynamic& dt, std::size_t id)
{
  std::vector<CGAL::Voronoi_cell_measures_2::Position> corners;
  CGAL::voronoi_cell_corners(dt, id, std::back_inserter(corners));
  Doubles numbers;
  for (const auto& corner : corners) {
    numbers.insert(numbers.end(), {corner.x, corner.y});
  }
  return {std::move(numbers), {2}};
}

template <class Dynamic>
std::vector<Array> cell_arrays(const Dynamic& dt, const Row_numbers& rows)
{
  CGAL::Voronoi_cell_measures_2 measures;
  measures.compute(dt);
  return measure_arrays(dt, rows, measures);
}

template <class Dynamic>
std::vector<Array> triangle_arrays(const Dynamic& dt, const Row_numbers& rows)
{
  if constexpr (is_periodic_triangulation<Dynamic>) {
    return corner_arrays(dt, rows);
  } else {
    return planar_triangle_arrays(dt, rows);
  }
}

// Of each row: 3 in the Classified set of the last update, 2 in the Padded set, 1 in the Border
// set, 0 in none. To be read only after a frame that was not rebuilt: vertices have got other
// numbers otherwise.
template <class Dynamic>
Array set_array(const Dynamic& dt, const Row_numbers& rows)
{
  Integers sets(rows.size());
  const auto frame = dt.frame();
  const auto assign = [&](const auto& vertices, std::int32_t number) {
    for (const auto v : vertices) {
      if (!frame.is_infinite(v) && v <= dt.number_of_vertices()) {
        sets[std::size_t(rows[frame.id(v)])] = number;
      }
    }
  };
  assign(dt.border_vertices(), 1);
  assign(dt.padded_vertices(), 2);
  assign(dt.classified_vertices(), 3);
  return {std::move(sets)};
}

// Whether an edge is one of those that `for_each_edge()` passes over: at infinity, or across the
// gap of a slab.
template <bool is_periodic, class Frame>
bool is_passed_over(const Frame& frame, typename Frame::Edge_index e)
{
  if constexpr (is_periodic) {
    return std::isnan(frame.edge_vector(e).x);
  } else {
    return frame.is_infinite(frame.edge(e));
  }
}

// The edges that are not locally Delaunay, by exact predicates, and in periodic space shifts.
template <class Dynamic>
std::vector<Array> broken_edge_arrays(const Dynamic& dt, const Row_numbers& rows)
{
  const auto frame = dt.frame();
  typename Dynamic::Frame::Edge_index e(0);
  Integers edges, shifts;
  if (dt.is_certified() || frame.number_of_edges() == 0) { // on a line every edge is Delaunay
    return {{std::move(edges), {2}}, {std::move(shifts), {2}}};
  }
  dt.for_each_edge([&](std::size_t i, std::size_t j, const auto&... shift) {
    while (is_passed_over<is_periodic_triangulation<Dynamic>>(frame, e)) {
      ++e;
    }
    if (!frame.is_delaunay(e++)) {
      edges.insert(edges.end(), {rows[i], rows[j]});
      (append(shifts, shift), ...);
    }
  });
  return {{std::move(edges), {2}}, {std::move(shifts), {2}}};
}

template <class Dynamic>
std::vector<Array> read_arrays(const Dynamic& dt, const Row_numbers& rows, Group group)
{
  switch (group) {
  case Group::POINTS:
    return {point_array(dt, rows)};
  case Group::DUPLICATES:
    return {duplicate_array(dt, rows)};
  case Group::EDGES:
    return edge_arrays(dt, rows);
  case Group::TRIANGLES:
    return triangle_arrays(dt, rows);
  case Group::NEIGHBOR_LISTS:
    return neighbor_list_arrays(dt, rows);
  case Group::CELLS:
    return cell_arrays(dt, rows);
  case Group::RIDGES:
    return ridge_arrays(dt, rows);
  case Group::SETS:
    return {set_array(dt, rows)};
  case Group::BROKEN_EDGES:
    return broken_edge_arrays(dt, rows);
  case Group::CORNERS:
    return corner_arrays(dt, rows);
  case Group::IDS:
  case Group::CHANGES:
    break; // which an owner of ids knows
  }
  return {};
}

} // namespace bindings

#endif // BINDINGS_ARRAY_READING_H

// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "python/src/Bounded_cells_in_python.h"

#include "python/src/Numpy.h"

#include <CGAL/Dynamic_Delaunay_triangulation_2/queries/Bounded_voronoi_surface_2.h>

#include <pybind11/stl.h>

#include <cstddef>
#include <cstdint>
#include <utility>

namespace py = pybind11;

namespace python {

namespace {

using Cells = CGAL::Bounded_voronoi_cells_2;

Array by_rows(const Bounded_cells& bounded, const Doubles& numbers)
{
  Doubles rows;
  rows.reserve(bounded.ids.size());
  for (const std::size_t id : bounded.ids) {
    rows.push_back(numbers[id]);
  }
  return {std::move(rows)};
}

Array by_rows(const Bounded_cells& bounded, const std::vector<Cells::Position>& vectors)
{
  Doubles rows;
  rows.reserve(2 * bounded.ids.size());
  for (const std::size_t id : bounded.ids) {
    rows.insert(rows.end(), {vectors[id].x, vectors[id].y});
  }
  return {std::move(rows), {2}};
}

Integers integers(const std::vector<std::size_t>& numbers)
{
  Integers result;
  result.reserve(numbers.size());
  for (const std::size_t number : numbers) {
    result.push_back(std::int32_t(number));
  }
  return result;
}

// By rows: radii, areas, perimeters, centroids, lengths of what is free, and on walls.
std::vector<Array> measure_arrays(const Bounded_cells& bounded)
{
  const Cells& cells = bounded.cells;
  return {by_rows(bounded, cells.radii()),        by_rows(bounded, cells.areas()),
          by_rows(bounded, cells.perimeters()),   by_rows(bounded, cells.centroids()),
          by_rows(bounded, cells.free_lengths()), by_rows(bounded, cells.wall_lengths())};
}

// Where those of each row begin; sides, others, shifts, both ends, lengths and angles.
std::vector<Array> piece_arrays(const Bounded_cells& bounded)
{
  const Cells& cells = bounded.cells;
  Integers begins, sides, others, shifts;
  Doubles starts, ends, lengths, angles;
  for (const std::size_t id : bounded.ids) {
    begins.push_back(std::int32_t(cells.first_pieces()[id]));
  }
  begins.push_back(std::int32_t(cells.pieces().size()));
  for (const Cells::Piece& piece : cells.pieces()) {
    const bool is_wall = piece.side == Cells::Side::WALL;
    sides.push_back(std::int32_t(piece.side));
    others.push_back(is_wall ? std::int32_t(piece.other) : bounded.rows[piece.other]);
    append(shifts, piece.shift);
    starts.insert(starts.end(), {piece.from.x, piece.from.y});
    ends.insert(ends.end(), {piece.to.x, piece.to.y});
    lengths.push_back(piece.length);
    angles.push_back(piece.angle);
  }
  return {{std::move(begins)},      {std::move(sides)},       {std::move(others)},
          {std::move(shifts), {2}}, {std::move(starts), {2}}, {std::move(ends), {2}},
          {std::move(lengths)},     {std::move(angles)}};
}

// Where the pieces of each line begin, pieces, their rows; areas, windings, and 1 for closed lines.
std::vector<Array> surface_arrays(const Bounded_cells& bounded)
{
  CGAL::Bounded_voronoi_surface_2 surface;
  surface.compute(bounded.cells);
  Integers rows, windings, are_closed;
  for (const std::size_t id : surface.ids()) {
    rows.push_back(bounded.rows[id]);
  }
  for (std::size_t line = 0; line < surface.number_of_lines(); ++line) {
    append(windings, surface.windings()[line]);
    are_closed.push_back(surface.is_closed(line));
  }
  return {{integers(surface.first_pieces())},
          {integers(surface.pieces())},
          {std::move(rows)},
          {surface.areas()},
          {std::move(windings), {2}},
          {std::move(are_closed)}};
}

// What is made of cells without the interpreter's lock.
template <class Make>
auto arrays_by(const Make& make)
{
  return [=](const Bounded_cells_in_python& cells) {
    std::vector<Array> arrays;
    {
      const py::gil_scoped_release release;
      arrays = make(cells.bounded);
    }
    return to_numpy(std::move(arrays));
  };
}

} // namespace

std::vector<Array> gradient_arrays(const Bounded_cells& bounded,
                                   const CGAL::Bounded_voronoi_gradients_2& gradients)
{
  return {by_rows(bounded, gradients.by_positions()), by_rows(bounded, gradients.by_radii())};
}

void bind_bounded_cells(py::module_& module)
{
  using Self = Bounded_cells_in_python;
  py::class_<Self>(module, "BoundedCells")
      .def("_measures", arrays_by(measure_arrays))
      .def("_pieces", arrays_by(piece_arrays))
      .def("_surface", arrays_by(surface_arrays))
      .def("_points", [](const Self& cells) { return to_numpy(cells.bounded.points); })
      .def("_cell", [](const Self& cells) { return cells.bounded.cell; });
}

} // namespace python

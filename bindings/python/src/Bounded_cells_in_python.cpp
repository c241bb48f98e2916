// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "bindings/python/src/Bounded_cells_in_python.h"

#include "bindings/python/src/Numpy.h"

#include <CGAL/Dynamic_Delaunay_triangulation_2/queries/Bounded_voronoi_surface_2.h>

#include <pybind11/stl.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>
#include <variant>

namespace py = pybind11;

namespace python {

namespace {

using Cells = CGAL::Bounded_voronoi_cells_2;

Integers integers(const std::vector<std::size_t>& numbers)
{
  Integers result;
  result.reserve(numbers.size());
  for (const std::size_t number : numbers) {
    result.push_back(std::int32_t(number));
  }
  return result;
}

// Where the pieces of each ring begin, the rows of the rings, and 1 for holes.
std::vector<Array> ring_arrays(const Bounded_cells& bounded)
{
  Integers begins, rows, are_holes;
  const auto read = [&](const auto& cells) {
    for (const std::size_t id : bounded.ids) {
      if constexpr (std::is_same_v<std::decay_t<decltype(cells)>, Cells>) {
        if (cells.first_pieces()[id] < cells.first_pieces()[id + 1]) {
          begins.push_back(std::int32_t(cells.first_pieces()[id]));
          rows.push_back(bounded.rows[id]);
          are_holes.push_back(0);
        }
      } else {
        for (std::size_t i = cells.first_rings()[id]; i < cells.first_rings()[id + 1]; ++i) {
          begins.push_back(std::int32_t(cells.first_pieces()[i]));
          rows.push_back(bounded.rows[id]);
          are_holes.push_back(cells.ring_areas()[i] < 0);
        }
      }
    }
    begins.push_back(std::int32_t(cells.pieces().size()));
  };
  std::visit(read, bounded.cells);
  return {{std::move(begins)}, {std::move(rows)}, {std::move(are_holes)}};
}

// By rows, 1 for points that are in the domain.
std::vector<Array> inside_arrays(const Bounded_cells& bounded)
{
  const auto& points = std::get<Doubles>(bounded.points.numbers);
  Integers are_inside;
  const auto read = [&](const auto& cells) {
    for (std::size_t i = 0; i < points.size(); i += 2) {
      const bool is_there = !std::isnan(points[i]); // no removed id
      are_inside.push_back(is_there && cells.is_in_domain({points[i], points[i + 1]}));
    }
  };
  std::visit(read, bounded.cells);
  return {{std::move(are_inside)}};
}

// Of cells that have a surface: where the pieces of each line begin, pieces, their rows; areas,
// windings, and 1 for closed lines.
std::vector<Array> surface_arrays(const Bounded_cells& bounded)
{
  CGAL::Bounded_voronoi_surface_2 surface;
  surface.compute(std::get<Cells>(bounded.cells));
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
      .def("_measures", arrays_by(bounded_measure_arrays))
      .def("_pieces", arrays_by(bounded_piece_arrays))
      .def("_rings", arrays_by(ring_arrays))
      .def("_are_inside", arrays_by(inside_arrays))
      .def("_are_convex",
           [](const Self& cells) { return std::holds_alternative<Cells>(cells.bounded.cells); })
      .def("_surface", arrays_by(surface_arrays))
      .def("_points", [](const Self& cells) { return to_numpy(cells.bounded.points); })
      .def("_cell", [](const Self& cells) { return cells.bounded.cell; });
}

} // namespace python

// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "scenario_runner/Lammps_box.h"

#include "scenario_runner/Number_text.h"

#include <algorithm>
#include <cstddef>
#include <string>

namespace scenario {

namespace {

using run::number_text;

// How far the tilted box reaches beyond the one without tilt, along each axis.
struct Overhang
{
  Point_3 low;
  Point_3 high;
};

Overhang overhang(const std::array<double, 3>& tilt)
{
  const auto& [xy, xz, yz] = tilt;
  return {{(std::min)({0.0, xy, xz, xy + xz}), (std::min)(0.0, yz), 0.0},
          {(std::max)({0.0, xy, xz, xy + xz}), (std::max)(0.0, yz), 0.0}};
}

Lammps_bounds bounds_of_box(const Cell_3& box)
{
  Lammps_bounds bounds;
  bounds.tilt = {box.sides[1][0], box.sides[2][0], box.sides[2][1]};
  const Overhang beyond = overhang(bounds.tilt);
  for (std::size_t axis = 0; axis != 3; ++axis) {
    bounds.low[axis] = box.corner[axis] + beyond.low[axis];
    bounds.high[axis] = box.corner[axis] + box.sides[axis][axis] + beyond.high[axis];
  }
  return bounds;
}

bool have_bounds(const Cell_3& box)
{
  const bool are_positive = box.sides[0][0] > 0.0 && box.sides[1][1] > 0.0 && box.sides[2][2] > 0.0;
  return are_positive && box_of_bounds(bounds_of_box(box), box.is_periodic) == box;
}

void write_bounds(std::ostream& out, const Cell_3& box, const std::string& boundaries)
{
  const Lammps_bounds bounds = bounds_of_box(box);
  const bool is_tilted = bounds.tilt != std::array<double, 3>{};
  out << "ITEM: BOX BOUNDS " << (is_tilted ? "xy xz yz " : "") << boundaries << '\n';
  for (std::size_t i = 0; i != 3; ++i) {
    out << number_text(bounds.low[i]) << ' ' << number_text(bounds.high[i]);
    if (is_tilted) {
      out << ' ' << number_text(bounds.tilt[i]);
    }
    out << '\n';
  }
}

void write_vectors(std::ostream& out, const Cell_3& box, const std::string& boundaries)
{
  out << "ITEM: BOX BOUNDS abc origin " << boundaries << '\n';
  for (std::size_t i = 0; i != 3; ++i) {
    for (const double coordinate : box.sides[i]) {
      out << number_text(coordinate) << ' ';
    }
    out << number_text(box.corner[i]) << '\n';
  }
}

} // namespace

Cell_3 box_of_bounds(const Lammps_bounds& bounds, const std::array<bool, 3>& is_periodic)
{
  const auto& [xy, xz, yz] = bounds.tilt;
  Cell_3 box{{}, {{{}, {xy, 0.0, 0.0}, {xz, yz, 0.0}}}, is_periodic};
  const Overhang beyond = overhang(bounds.tilt);
  for (std::size_t axis = 0; axis != 3; ++axis) {
    box.corner[axis] = bounds.low[axis] - beyond.low[axis];
    box.sides[axis][axis] = bounds.high[axis] - beyond.high[axis] - box.corner[axis];
  }
  return box;
}

void write_lammps_box(std::ostream& out, const Cell_3& box)
{
  std::string boundaries;
  for (const bool is_periodic : box.is_periodic) {
    boundaries += std::string(boundaries.empty() ? "" : " ") + (is_periodic ? "pp" : "ff");
  }
  if (have_bounds(box)) {
    write_bounds(out, box, boundaries);
  } else {
    write_vectors(out, box, boundaries);
  }
}

void write_lammps_box(std::ostream& out, const Cell& cell)
{
  const auto& [a, b] = cell.sides;
  const auto [along_a, along_b] = cell.is_periodic;
  write_lammps_box(out, Cell_3{{cell.corner.x, cell.corner.y, -0.5},
                               {{{a.x, a.y, 0.0}, {b.x, b.y, 0.0}, {0.0, 0.0, 1.0}}},
                               {along_a, along_b, !cell.is_slab()}});
}

} // namespace scenario

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

// How far the tilted box reaches beyond the one without tilt.
struct Overhang
{
  Point low;
  Point high;
};

Overhang overhang(const std::array<double, 3>& tilt)
{
  const auto& [xy, xz, yz] = tilt;
  return {{(std::min)({0.0, xy, xz, xy + xz}), (std::min)(0.0, yz)},
          {(std::max)({0.0, xy, xz, xy + xz}), (std::max)(0.0, yz)}};
}

Lammps_bounds bounds_of_cell(const Cell& cell)
{
  Lammps_bounds bounds;
  bounds.tilt[0] = cell.sides[1].x;
  const Overhang beyond = overhang(bounds.tilt);
  bounds.low = {cell.corner.x + beyond.low.x, cell.corner.y, -0.5};
  bounds.high = {cell.corner.x + cell.sides[0].x + beyond.high.x, cell.corner.y + cell.sides[1].y,
                 0.5};
  return bounds;
}

bool have_bounds(const Cell& cell)
{
  return cell.sides[0].x > 0.0 && cell.sides[1].y > 0.0 &&
         cell_of_bounds(bounds_of_cell(cell), cell.is_periodic) == cell;
}

void write_bounds(std::ostream& out, const Cell& cell, const std::string& boundaries)
{
  const Lammps_bounds bounds = bounds_of_cell(cell);
  const bool is_tilted = bounds.tilt[0] != 0.0;
  out << "ITEM: BOX BOUNDS " << (is_tilted ? "xy xz yz " : "") << boundaries;
  for (std::size_t i = 0; i != 3; ++i) {
    out << number_text(bounds.low[i]) << ' ' << number_text(bounds.high[i]);
    if (is_tilted) {
      out << ' ' << number_text(bounds.tilt[i]);
    }
    out << '\n';
  }
}

void write_vectors(std::ostream& out, const Cell& cell, const std::string& boundaries)
{
  out << "ITEM: BOX BOUNDS abc origin " << boundaries;
  const std::array<double, 2> origin = {cell.corner.x, cell.corner.y};
  for (std::size_t i = 0; i != 2; ++i) {
    out << number_text(cell.sides[i].x) << ' ' << number_text(cell.sides[i].y) << " 0 "
        << number_text(origin[i]) << '\n';
  }
  out << "0 0 1 -0.5\n";
}

} // namespace

Cell cell_of_bounds(const Lammps_bounds& bounds, const std::array<bool, 2>& is_periodic)
{
  const Overhang beyond = overhang(bounds.tilt);
  const Point low = {bounds.low[0] - beyond.low.x, bounds.low[1] - beyond.low.y};
  const Point high = {bounds.high[0] - beyond.high.x, bounds.high[1] - beyond.high.y};
  return {low, {{{high.x - low.x, 0.0}, {bounds.tilt[0], high.y - low.y}}}, is_periodic};
}

void write_lammps_box(std::ostream& out, const Cell& cell)
{
  const auto letters = [](bool is_periodic) { return is_periodic ? "pp " : "ff "; };
  const std::string boundaries = std::string(letters(cell.is_periodic[0])) +
                                 letters(cell.is_periodic[1]) + (cell.is_slab() ? "ff\n" : "pp\n");
  if (have_bounds(cell)) {
    write_bounds(out, cell, boundaries);
  } else {
    write_vectors(out, cell, boundaries);
  }
}

} // namespace scenario

// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SCENARIO_RUNNER_LAMMPS_BOX_H
#define SCENARIO_RUNNER_LAMMPS_BOX_H

#include "scenario_runner/Cell.h"

#include <array>
#include <ostream>

namespace scenario {

// A box as the three lines below ITEM: BOX BOUNDS have it: a lower and an upper bound along x, y
// and z, then xy, xz and yz in a tilted one. Bounds are those of the box that encloses the tilted
// one.
struct Lammps_bounds
{
  std::array<double, 3> low{};
  std::array<double, 3> high{};
  std::array<double, 3> tilt{};
};

// The section of the box with a plane z = constant.
Cell cell_of_bounds(const Lammps_bounds& bounds, const std::array<bool, 2>& is_periodic);

// Writes the header and the three lines, which are read as the same cell again: where rounding of
// bounds would change it, or if its first side is not along x, vectors and the origin are written
// instead.
void write_lammps_box(std::ostream& out, const Cell& cell);

} // namespace scenario

#endif // SCENARIO_RUNNER_LAMMPS_BOX_H

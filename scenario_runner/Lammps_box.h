// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SCENARIO_RUNNER_LAMMPS_BOX_H
#define SCENARIO_RUNNER_LAMMPS_BOX_H

#include "scenario_runner/Cell.h"
#include "scenario_runner/space/Cell_3.h"

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

Cell_3 box_of_bounds(const Lammps_bounds& bounds, const std::array<bool, 3>& is_periodic);

// Writes the header and the three lines, which are read as the same box again: where rounding of
// bounds would change it, or if its first side is not along x or its second one leaves the plane of
// x and y, vectors and the origin are written instead.
void write_lammps_box(std::ostream& out, const Cell_3& box);

// Does so with a box of height 1 that has the cell in the middle.
void write_lammps_box(std::ostream& out, const Cell& cell);

} // namespace scenario

#endif // SCENARIO_RUNNER_LAMMPS_BOX_H

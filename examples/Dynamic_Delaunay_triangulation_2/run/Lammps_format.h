// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef RUN_LAMMPS_FORMAT_H
#define RUN_LAMMPS_FORMAT_H

#include "../scenario/Motion.h"
#include "Bounds.h"
#include "Exact_number.h"

#include <cstddef>
#include <ostream>

namespace run {

// A text dump of LAMMPS, which scenario/Lammps_dump.h reads as the same motion. All atoms are of
// type 1.
struct Lammps_format
{
  static constexpr char species = '1';

  // The time stands before the time step, as LAMMPS itself has it.
  static void write_head(std::ostream& out, const scenario::Motion& motion, const Bounds& bounds,
                         std::size_t frame)
  {
    out << "ITEM: TIME\n"
        << Exact_number{motion.time()} << "\nITEM: TIMESTEP\n"
        << frame << "\nITEM: NUMBER OF ATOMS\n"
        << motion.points().size() << "\nITEM: BOX BOUNDS ff ff ff\n"
        << Exact_number{bounds.low.x} << ' ' << Exact_number{bounds.high.x} << '\n'
        << Exact_number{bounds.low.y} << ' ' << Exact_number{bounds.high.y}
        << "\n-0.5 0.5\nITEM: ATOMS id type x y z set\n";
  }
};

} // namespace run

#endif // RUN_LAMMPS_FORMAT_H

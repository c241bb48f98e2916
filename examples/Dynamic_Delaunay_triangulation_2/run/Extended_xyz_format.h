// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef RUN_EXTENDED_XYZ_FORMAT_H
#define RUN_EXTENDED_XYZ_FORMAT_H

#include "../scenario/Motion.h"
#include "Bounds.h"
#include "Exact_number.h"

#include <cstddef>
#include <ostream>

namespace run {

// The extended XYZ format, which says in the second line of a frame what the columns are. The
// points have a species because atoms have one: X, for unknown.
struct Extended_xyz_format
{
  static constexpr char species = 'X';

  static void write_head(std::ostream& out, const scenario::Motion& motion, const Bounds& bounds,
                         std::size_t frame)
  {
    out << motion.points().size() << "\nLattice=\"" << Exact_number{bounds.width()} << " 0 0 0 "
        << Exact_number{bounds.height()} << " 0 0 0 1\" Origin=\"" << Exact_number{bounds.low.x}
        << ' ' << Exact_number{bounds.low.y}
        << " -0.5\" pbc=\"F F F\" Properties=id:I:1:species:S:1:pos:R:3:set:I:1 Time="
        << Exact_number{motion.time()} << " Frame=" << frame << '\n';
  }
};

} // namespace run

#endif // RUN_EXTENDED_XYZ_FORMAT_H

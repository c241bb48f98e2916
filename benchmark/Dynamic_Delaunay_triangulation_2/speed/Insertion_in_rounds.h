// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SPEED_INSERTION_IN_ROUNDS_H
#define SPEED_INSERTION_IN_ROUNDS_H

#include "scenario_runner/Static_triangulation.h"

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Static_triangulator_2.h>

#include <cstddef>
#include <vector>

namespace speed {

// CGAL's insertion one by one, each point located from the last one, in rounds along the curve that
// the points are sorted by: every 8^k-th point first.
inline void insert_in_rounds(const std::vector<run::Kernel::Point_2>& points,
                             run::Static_triangulation& triangulation)
{
  run::Static_triangulation::Face_handle hint;
  CGAL::Dynamic_Delaunay_triangulations_2::internal::for_each_in_rounds(
      points.size(), [&](std::size_t i) { hint = triangulation.insert(points[i], hint)->face(); });
}

} // namespace speed

#endif // SPEED_INSERTION_IN_ROUNDS_H

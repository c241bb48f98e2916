// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PEERS_GRID_POINTS_H
#define PEERS_GRID_POINTS_H

#include "scenario_runner/Static_triangulation.h"

#include <cstdint>
#include <vector>

namespace peers {

using Point = run::Kernel::Point_2;
using Points = std::vector<Point>;

struct Grid_point
{
  std::int32_t x;
  std::int32_t y;
};

// The points of a frame, twice the same.
struct Grid_points
{
  std::vector<Grid_point> integers;
  Points points;
};

} // namespace peers

#endif // PEERS_GRID_POINTS_H

// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SCENARIO_RUNNER_PICTURE_GEOMETRY_H
#define SCENARIO_RUNNER_PICTURE_GEOMETRY_H

#include "scenario_runner/Frame_record.h"

#include <vector>

namespace run {

struct Segment
{
  scenario::Point from;
  scenario::Point to;
};

// What a picture of a frame draws, in the coordinates of the motion. In periodic space the points
// are wrapped into the cell, and an edge that leaves it is drawn as its two halves, one at each
// end.
struct Picture_geometry
{
  std::vector<scenario::Point> points;
  std::vector<Segment> edges;
  std::vector<scenario::Point> outline; // of the cell, if there is one
};

// The shift from a point to its image in the cell.
scenario::Shift shift_into_cell(const scenario::Point& point, const scenario::Cell& cell);

// The shift from a point to its image that is nearest to a place.
scenario::Shift nearest_shift(const scenario::Point& point, const scenario::Point& place,
                              const scenario::Cell& cell);

// The corners of the cell.
std::vector<scenario::Point> outline_of(const scenario::Cell& cell);

Picture_geometry picture_geometry(const Run_view& run);

} // namespace run

#endif // SCENARIO_RUNNER_PICTURE_GEOMETRY_H

// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef RUN_BOUNDS_H
#define RUN_BOUNDS_H

#include "../scenario/Motion.h"
#include "../scenario/Scenario_description.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <vector>

namespace run {

// A rectangle.
struct Bounds
{
  scenario::Point low;
  scenario::Point high;

  // A finite number, also where the sides are farther apart than any.
  double width() const { return length(low.x, high.x); }
  double height() const { return length(low.y, high.y); }

private:
  static double length(double from, double to)
  {
    return (std::min)(to - from, (std::numeric_limits<double>::max)());
  }
};

// Of all points; the origin if there are none.
inline Bounds bounds_of(const std::vector<scenario::Point>& points)
{
  if (points.empty()) {
    return {{0.0, 0.0}, {0.0, 0.0}};
  }
  Bounds bounds{points.front(), points.front()};
  for (const scenario::Point& point : points) {
    bounds.low = {(std::min)(bounds.low.x, point.x), (std::min)(bounds.low.y, point.y)};
    bounds.high = {(std::max)(bounds.high.x, point.x), (std::max)(bounds.high.y, point.y)};
  }
  return bounds;
}

// The box of the scenario, if it has one, or else of all points of the frame.
inline Bounds frame_bounds(const std::optional<scenario::Box>& box,
                           const std::vector<scenario::Point>& points)
{
  return box ? Bounds{{0.0, 0.0}, {box->width, box->height}} : bounds_of(points);
}

// Programs that look at a cell divide by its sides. One without a length reaches from the origin
// then, and at the origin it is 1.
inline void widen(double& low, double& high)
{
  if (low == high) {
    low = (std::min)(low, 0.0);
    high = low == 0.0 && high == 0.0 ? 1.0 : (std::max)(high, 0.0);
  }
}

inline Bounds cell_bounds(const std::optional<scenario::Box>& box,
                          const std::vector<scenario::Point>& points)
{
  Bounds bounds = frame_bounds(box, points);
  widen(bounds.low.x, bounds.high.x);
  widen(bounds.low.y, bounds.high.y);
  return bounds;
}

} // namespace run

#endif // RUN_BOUNDS_H

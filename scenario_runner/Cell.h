// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SCENARIO_RUNNER_CELL_H
#define SCENARIO_RUNNER_CELL_H

#include <array>
#include <cstddef>

namespace scenario {

struct Point
{
  double x;
  double y;
};

// How often a point is shifted by each side of a cell.
using Shift = std::array<int, 2>;

// The box of a periodic frame, a parallelogram. Everything is repeated along the sides that are
// periodic: both, or one of them in a slab, which is open across.
struct Cell
{
  Point corner;
  std::array<Point, 2> sides;
  std::array<bool, 2> is_periodic;

  bool is_slab() const { return is_periodic[0] != is_periodic[1]; }
  // The only vector of a slab by which space repeats itself.
  const Point& period() const { return sides[is_periodic[0] ? 0 : 1]; }

  bool has_kind_of(const Cell& other) const { return is_slab() == other.is_slab(); }

  double area() const { return sides[0].x * sides[1].y - sides[0].y * sides[1].x; }

  // The vector by which a shift translates points.
  Point translation(const Shift& shift) const
  {
    return {shift[0] * sides[0].x + shift[1] * sides[1].x,
            shift[0] * sides[0].y + shift[1] * sides[1].y};
  }
  Point image(const Point& point, const Shift& shift) const
  {
    const Point by = translation(shift);
    return {point.x + by.x, point.y + by.y};
  }

  friend bool operator==(const Cell& c, const Cell& d)
  {
    const auto are_equal = [](const Point& p, const Point& q) { return p.x == q.x && p.y == q.y; };
    return are_equal(c.corner, d.corner) && are_equal(c.sides[0], d.sides[0]) &&
           are_equal(c.sides[1], d.sides[1]) && c.is_periodic == d.is_periodic;
  }
  friend bool operator!=(const Cell& c, const Cell& d) { return !(c == d); }
};

} // namespace scenario

#endif // SCENARIO_RUNNER_CELL_H

// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SCENARIO_RUNNER_SPACE_CELL_3_H
#define SCENARIO_RUNNER_SPACE_CELL_3_H

#include "scenario_runner/Cell.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace scenario {

using Point_3 = std::array<double, 3>;

// How often a point is shifted by each side of a cell in space.
using Shift_3 = std::array<int, 3>;

// The box of a frame in space, a parallelepiped. Everything is repeated along the sides that are
// periodic.
struct Cell_3
{
  Point_3 corner;
  std::array<Point_3, 3> sides;
  std::array<bool, 3> is_periodic;

  std::ptrdiff_t number_of_periodic_sides() const
  {
    return std::count(is_periodic.begin(), is_periodic.end(), true);
  }
  // Whether space is open across two periodic sides, or across a single one.
  bool is_slab() const { return number_of_periodic_sides() == 2; }
  bool is_wire() const { return number_of_periodic_sides() == 1; }
  // "torus", "slab" or "wire".
  const char* kind() const { return is_wire() ? "wire" : is_slab() ? "slab" : "torus"; }
  // The numbers of the periodic sides of a slab.
  std::array<std::size_t, 2> sides_of_slab() const
  {
    return {is_periodic[0] ? std::size_t(0) : std::size_t(1),
            is_periodic[2] ? std::size_t(2) : std::size_t(1)};
  }
  // The periodic side of a wire.
  const Point_3& side_of_wire() const { return sides[is_periodic[0] ? 0 : is_periodic[1] ? 1 : 2]; }

  bool is_finite() const
  {
    return std::all_of(sides.begin(), sides.end(), [](const Point_3& side) {
      return std::all_of(side.begin(), side.end(), [](double x) { return std::isfinite(x); });
    });
  }

  // Negative where the sides are left-handed.
  double volume() const
  {
    const auto& [a, b, c] = sides;
    return a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
           a[2] * (b[0] * c[1] - b[1] * c[0]);
  }

  // How large the parallelogram of a slab's periodic sides is.
  double area_of_slab() const
  {
    const auto [i, j] = sides_of_slab();
    const Point_3 &a = sides[i], &b = sides[j];
    return std::hypot(a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
                      a[0] * b[1] - a[1] * b[0]);
  }

  // Whether it repeats space along three sides, two, or one.
  bool repeats_space() const
  {
    if (is_wire()) {
      return is_finite() && side_of_wire() != Point_3{};
    }
    const auto number = number_of_periodic_sides();
    return is_finite() && (number == 3 ? volume() != 0.0 : number == 2 && area_of_slab() > 0.0);
  }

  // Whether it is a cube along the axes.
  bool is_cube() const
  {
    const double length = sides[0][0];
    return length > 0.0 &&
           sides == std::array<Point_3, 3>{{{length, 0, 0}, {0, length, 0}, {0, 0, length}}};
  }

  // What a plane has of it where z is left out.
  Cell section() const
  {
    return {{corner[0], corner[1]},
            {{{sides[0][0], sides[0][1]}, {sides[1][0], sides[1][1]}}},
            {is_periodic[0], is_periodic[1]}};
  }

  Point_3 image(Point_3 point, const Shift_3& shift) const
  {
    for (std::size_t side = 0; side != 3; ++side) {
      for (std::size_t axis = 0; axis != 3; ++axis) {
        point[axis] += shift[side] * sides[side][axis];
      }
    }
    return point;
  }

  // A shift by the first, the second and so on of the periodic sides as one by the sides.
  Shift_3 shift_of_periodic_sides(const Shift_3& shift) const
  {
    Shift_3 by_sides{};
    std::size_t next = 0;
    for (std::size_t side = 0; side != 3; ++side) {
      if (is_periodic[side]) {
        by_sides[side] = shift[next++];
      }
    }
    return by_sides;
  }

  friend bool operator==(const Cell_3& c, const Cell_3& d)
  {
    return c.corner == d.corner && c.sides == d.sides && c.is_periodic == d.is_periodic;
  }
  friend bool operator!=(const Cell_3& c, const Cell_3& d) { return !(c == d); }
};

} // namespace scenario

#endif // SCENARIO_RUNNER_SPACE_CELL_3_H

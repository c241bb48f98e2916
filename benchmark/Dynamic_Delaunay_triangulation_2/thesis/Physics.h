// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef THESIS_PHYSICS_H
#define THESIS_PHYSICS_H

#include "scenario_runner/Simulated_motion.h"
#include "scenario_runner/Static_triangulation.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

namespace thesis {

// What tells whether a simulation went as it should: numbers that belong to all particles, not to
// one of them.
struct Physics
{
  static constexpr std::size_t size = 5;

  static std::vector<std::string> names()
  {
    return {"kinetic", "energy", "center_x", "center_y", "front"};
  }

  // Energies in units of mass, stiffness and diameter; the front is the largest x coordinate.
  std::array<double, size> values;
};

// The energy is that of all contacts there are, whether the simulation has noticed them or not: its
// neighbors come from a fresh Delaunay triangulation.
inline Physics physics_of(scenario::Particle_motion& motion)
{
  const auto& points = motion.points();
  scenario::Static_neighbors neighbors;
  const scenario::Energy energy = motion.energy(neighbors(points));
  double x = 0.0;
  double y = 0.0;
  double front = std::numeric_limits<double>::lowest();
  for (const scenario::Point& point : points) {
    x += point.x;
    y += point.y;
    front = (std::max)(front, point.x);
  }
  const auto number = static_cast<double>(points.size());
  return {{energy.kinetic, energy.total(), x / number, y / number, front}};
}

} // namespace thesis

#endif // THESIS_PHYSICS_H

// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SCENARIO_RUNNER_SPACE_SCENARIO_FILE_3_H
#define SCENARIO_RUNNER_SPACE_SCENARIO_FILE_3_H

#include "scenario_runner/Scenario_file.h"
#include "scenario_runner/space/Motion_3.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace scenario {

// A box from the origin to this corner.
using Box_3 = std::array<double, 3>;

// A block of balls that touch, on a cubic lattice; `position` is its lowest corner, the balls'
// radii included.
struct Block_description_3
{
  std::array<std::size_t, 3> counts; // along x, y and z
  Point_3 position;
  Point_3 velocity{};

  std::size_t number_of_points() const { return counts[0] * counts[1] * counts[2]; }
};

struct Particle_description_3
{
  double jitter; // of the first positions, in diameters
  double diameter;
  double mass;
  double stiffness;
  double damping; // in sqrt(mass * stiffness)
  double gravity; // along -z
  std::optional<Box_3> box;
  std::vector<Block_description_3> blocks;
  double time_step; // in sqrt(mass / stiffness)

  std::size_t number_of_points() const;
};

struct Brownian_description_3
{
  std::size_t points;
  Box_3 box;
  double time_step;                // standard deviation of a step along each axis, in mean spacings
  std::array<bool, 3> is_periodic; // the box, along each axis; else its sides reflect the points
};

struct Scenario_description_3
{
  std::string name;
  std::uint64_t seed = 0;
  std::size_t frames = 0;
  std::variant<Particle_description_3, Brownian_description_3> kind;
};

// Whether a scenario file has "dimension": 3.
// \throws Scenario_error, also if it has another dimension
bool is_scenario_in_space(const std::string& file, const std::string& text);

// What a scenario file in space says, as JSON; `file` is what messages call the text.
// \throws Scenario_error
Scenario_description_3 parse_scenario_3(const std::string& file, const std::string& text);

// The scenario with another number of points of the same size: blocks keep their shapes, as far as
// whole balls allow, lengths grow alike, and gravity shrinks so that the pressure at the bottom
// stays what it was. Exactly `number_of_points` of all places have a ball, those from below.
Particle_description_3 scaled_to(Particle_description_3 particles, std::size_t number_of_points);

} // namespace scenario

#endif // SCENARIO_RUNNER_SPACE_SCENARIO_FILE_3_H

// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SCENARIO_SCENARIO_DESCRIPTION_H
#define SCENARIO_SCENARIO_DESCRIPTION_H

#include "Motion.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace scenario {

constexpr std::size_t max_points = 10'000'000;
constexpr double largest_time_step = 10.0;

enum class Packing { square, hexagonal };

// From the origin to this corner.
struct Box
{
  double width;
  double height;
};

// A block of discs that touch; `position` is its lower left corner, the discs' radii included.
struct Body_description
{
  std::size_t rows;
  std::size_t columns;
  Point position;
  Point velocity{0.0, 0.0};
  double angular_velocity = 0.0;        // counterclockwise
  bool bonded = false;                  // a hard body, else a fluid
  std::optional<double> strain_limit{}; // where bonds break; without it they never do
  // The largest speed that a bond gives each of its ends at first, apart or together; in
  // diameters * sqrt(stiffness / mass).
  double shiver = 0.0;

  std::size_t number_of_points() const { return rows * columns; }
};

// In diameters.
inline double row_distance(Packing packing)
{
  return packing == Packing::square ? 1.0 : std::sqrt(0.75);
}

// The extent of a body, the discs' radii included.
inline Box extent(const Body_description& body, Packing packing, double diameter)
{
  const double shift = packing == Packing::hexagonal && body.rows > 1 ? 0.5 : 0.0;
  return {diameter * (static_cast<double>(body.columns) + shift),
          diameter * (1.0 + static_cast<double>(body.rows - 1) * row_distance(packing))};
}

struct Particle_description
{
  Packing packing;
  double jitter; // of the first positions, in diameters; for a bonded body its shape at rest
  double diameter;
  double mass;
  double stiffness;
  double damping; // in sqrt(mass * stiffness)
  double gravity;
  std::optional<Box> box; // without it the plane is open
  std::vector<Body_description> bodies;
  double time_step; // in sqrt(mass / stiffness)
  std::optional<double> largest_stable_time_step;

  std::size_t number_of_points() const
  {
    std::size_t sum = 0;
    for (const Body_description& body : bodies) {
      sum += body.number_of_points();
    }
    return sum;
  }
};

struct Brownian_description
{
  std::size_t points;
  Box box;
  double time_step; // standard deviation of a step along each axis, in mean spacings
};

struct Scenario_description
{
  std::string name;
  std::uint64_t seed = 0;
  std::size_t frames = 0;
  std::variant<Particle_description, Brownian_description> kind;
};

// What a caller wants different from the file.
struct Overrides
{
  std::optional<std::size_t> points;
  std::optional<double> time_step;
  std::optional<std::uint64_t> seed;
  std::optional<Packing> packing;
};

} // namespace scenario

#endif // SCENARIO_SCENARIO_DESCRIPTION_H

// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SCENARIO_RUNNER_SCENARIO_FILE_H
#define SCENARIO_RUNNER_SCENARIO_FILE_H

#include "scenario_runner/Motion.h"
#include "scenario_runner/Text_input.h"

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

// A box from the origin to (width, height).
struct Box
{
  double width;
  double height;
};

// The sides of a box keep points inside (closed), or a point that leaves through the left or right
// side comes in through the other one (channel), or so through any side (periodic).
enum class Cell_kind { closed, channel, periodic };

// The cell of such a box; none if it is closed.
std::optional<Cell> cell_of(const Box& box, Cell_kind kind);

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

// The distance between rows, in diameters.
double row_distance(Packing packing);

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
  Cell_kind cell = Cell_kind::closed; // of the box

  std::size_t number_of_points() const;
};

struct Brownian_description
{
  std::size_t points;
  Box box;
  double time_step; // standard deviation of a step along each axis, in mean spacings
  Cell_kind cell = Cell_kind::closed;
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

// A body of a scaled scenario: its last row need not be full.
struct Scaled_body
{
  std::size_t number_of_points;
  std::size_t columns;
  Body_description description;
};

// A particle scenario brought to another number of points of the same size. Lengths grow by
// `factor`, speeds stay; gravity shrinks so that the pressure at the bottom stays what it was.
struct Scaled_scenario
{
  double factor;
  double gravity;
  std::optional<Box> box;
  std::vector<Scaled_body> bodies;
};

Scaled_scenario scaled_to(const Particle_description& particles, std::size_t number_of_points);

// What a scenario file says, as JSON; `file` is what messages call the text.
// \throws Scenario_error
Scenario_description parse_scenario(const std::string& file, const std::string& text);
Scenario_description read_scenario_file(const std::string& path);

} // namespace scenario

#endif // SCENARIO_RUNNER_SCENARIO_FILE_H

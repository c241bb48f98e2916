// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SCENARIO_OPEN_MOTION_H
#define SCENARIO_OPEN_MOTION_H

#include "Brownian_motion.h"
#include "Csv_motion.h"
#include "Lammps_dump.h"
#include "Motion.h"
#include "Motion_file.h"
#include "Particle_motion.h"
#include "Scenario_error.h"
#include "Scenario_file.h"

#include <cstddef>
#include <memory>
#include <sstream>
#include <string>
#include <utility>

namespace scenario {

inline void check_overrides(const std::string& path, const Overrides& overrides)
{
  if (overrides.points && (*overrides.points < 1 || *overrides.points > max_points)) {
    throw Scenario_error(path, "cannot be scaled to " + std::to_string(*overrides.points) +
                                   " points, allowed are 1 to " + std::to_string(max_points));
  }
  if (overrides.time_step && !positive_up_to(largest_time_step).contains(*overrides.time_step)) {
    std::ostringstream message;
    message << "cannot run with time step " << *overrides.time_step << ", allowed are values "
            << positive_up_to(largest_time_step).text();
    throw Scenario_error(path, message.str());
  }
}

inline std::unique_ptr<Particle_motion> make_motion(const Scenario_description& description,
                                                    Particle_description particles,
                                                    const Overrides& overrides)
{
  particles.packing = overrides.packing.value_or(particles.packing);
  particles.time_step = overrides.time_step.value_or(particles.time_step);
  return std::make_unique<Particle_motion>(
      description.name, particles, overrides.seed.value_or(description.seed), description.frames,
      overrides.points.value_or(particles.number_of_points()));
}

inline std::unique_ptr<Brownian_motion> make_motion(const Scenario_description& description,
                                                    Brownian_description brownian,
                                                    const Overrides& overrides)
{
  brownian.points = overrides.points.value_or(brownian.points);
  brownian.time_step = overrides.time_step.value_or(brownian.time_step);
  return std::make_unique<Brownian_motion>(
      description.name, brownian, overrides.seed.value_or(description.seed), description.frames);
}

inline std::unique_ptr<Motion> open_scenario(const std::string& path, const Overrides& overrides)
{
  const Scenario_description description = read_scenario_file(path);
  check_overrides(path, overrides);
  if (const auto* particles = std::get_if<Particle_description>(&description.kind)) {
    return make_motion(description, *particles, overrides);
  }
  if (overrides.packing) {
    throw Scenario_error(path, "has no packing that could be chosen, it is a random cloud");
  }
  return make_motion(description, std::get<Brownian_description>(description.kind), overrides);
}

inline void refuse_overrides(const std::string& path, const Overrides& overrides)
{
  if (overrides.points || overrides.time_step || overrides.seed || overrides.packing) {
    throw Scenario_error(path, "is a recording: its number of points, time step, seed and packing "
                               "cannot be chosen");
  }
}

// Opens a scenario or a recording, which the name of the file tells apart, compressed or not; or a
// CSV recording from standard input, as "-".
inline std::unique_ptr<Motion> open_motion(const std::string& path, const Overrides& overrides = {})
{
  const auto format = is_standard_input(path) ? Motion_format::csv : motion_format(path);
  if (!format) {
    throw Scenario_error(path, "has the unknown extension '" +
                                   without_gz(path).extension().string() + "', allowed are " +
                                   motion_extensions + ", also followed by .gz");
  }
  if (*format == Motion_format::scenario) {
    return open_scenario(path, overrides);
  }
  refuse_overrides(path, overrides);
  Recording recording =
      *format == Motion_format::csv ? read_csv_motion(path) : read_lammps_dump(path);
  return std::make_unique<Recorded_motion>(recording_name(path), std::move(recording));
}

} // namespace scenario

#endif // SCENARIO_OPEN_MOTION_H

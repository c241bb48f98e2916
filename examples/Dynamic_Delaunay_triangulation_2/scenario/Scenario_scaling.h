// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SCENARIO_SCENARIO_SCALING_H
#define SCENARIO_SCENARIO_SCALING_H

#include "Scenario_description.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace scenario {

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

inline std::size_t scaled_columns(const Body_description& body, std::size_t number_of_points)
{
  if (number_of_points == body.number_of_points()) {
    return body.columns;
  }
  const double shape = static_cast<double>(body.columns) / static_cast<double>(body.rows);
  const double columns = std::round(std::sqrt(static_cast<double>(number_of_points) * shape));
  return static_cast<std::size_t>((std::max)(1.0, columns));
}

inline Scaled_scenario scaled_to(const Particle_description& particles,
                                 std::size_t number_of_points)
{
  const auto before = static_cast<double>(particles.number_of_points());
  const auto after = static_cast<double>(number_of_points);
  Scaled_scenario scaled{std::sqrt(after / before), 0.0, particles.box, {}};
  scaled.gravity = particles.gravity / scaled.factor;
  if (scaled.box) {
    scaled.box->width *= scaled.factor;
    scaled.box->height *= scaled.factor;
  }
  std::size_t sum = 0;
  std::size_t scaled_sum = 0;
  for (Body_description body : particles.bodies) {
    sum += body.number_of_points();
    const auto scaled_end =
        static_cast<std::size_t>(std::llround(after * (static_cast<double>(sum) / before)));
    const std::size_t number = scaled_end - scaled_sum;
    scaled_sum = scaled_end;
    const std::size_t columns = scaled_columns(body, number);
    body.position.x *= scaled.factor;
    body.position.y *= scaled.factor;
    body.angular_velocity /= scaled.factor;
    scaled.bodies.push_back({number, columns, body});
  }
  return scaled;
}

} // namespace scenario

#endif // SCENARIO_SCENARIO_SCALING_H

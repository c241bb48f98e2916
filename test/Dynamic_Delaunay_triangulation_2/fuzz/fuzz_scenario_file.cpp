// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "parser_checks.h"
#include "scenario_runner/Open_motion.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <variant>

namespace {

using fuzz::require;

void require_in(double value, double low, double high)
{
  require(value >= low && value <= high, "a number of a scenario is out of its range");
}

void require_above_zero(double value, double high)
{
  require(value > 0.0 && value <= high, "a number of a scenario is out of its range");
}

void require_sound(const scenario::Box& box)
{
  require_in(box.width, 1e-6, 1e6);
  require_in(box.height, 1e-6, 1e6);
}

void require_sound(const scenario::Body_description& body)
{
  require(body.rows != 0 && body.columns != 0, "a body has no points");
  for (const double value : {body.position.x, body.position.y, body.velocity.x, body.velocity.y,
                             body.angular_velocity}) {
    require_in(value, -1e6, 1e6);
  }
  require_in(body.shiver, 0.0, 1.0);
  if (body.strain_limit) {
    require_above_zero(*body.strain_limit, 1.0);
  }
  require(body.bonded || (!body.strain_limit && body.shiver == 0.0),
          "a body without bonds has properties of them");
}

std::size_t require_sound(const scenario::Particle_description& particles)
{
  require_in(particles.jitter, 0.0, 0.5);
  require_in(particles.damping, 0.0, 2.0);
  require_in(particles.gravity, 0.0, 1e6);
  require_in(particles.diameter, 1e-6, 1e6);
  require_in(particles.mass, 1e-6, 1e6);
  require_in(particles.stiffness, 1e-6, 1e6);
  require_above_zero(particles.time_step, scenario::largest_time_step);
  if (particles.box) {
    require_sound(*particles.box);
  }
  for (const scenario::Body_description& body : particles.bodies) {
    require_sound(body);
  }
  return particles.number_of_points();
}

std::size_t require_sound(const scenario::Brownian_description& brownian)
{
  require_sound(brownian.box);
  require_above_zero(brownian.time_step, scenario::largest_time_step);
  return brownian.points;
}

// All points are neighbors of each other.
scenario::Neighbor_edges all_edges(std::size_t number_of_points)
{
  scenario::Neighbor_edges edges;
  for (std::uint32_t a = 0; a < number_of_points; ++a) {
    for (std::uint32_t b = a + 1; b < number_of_points; ++b) {
      edges.emplace_back(a, b);
    }
  }
  return edges;
}

// Runs the scenario with at most 20 points, whatever number the file asks for.
template <class Description>
void run(const scenario::Scenario_description& scenario, const Description& kind,
         std::size_t number_of_points)
{
  scenario::Overrides overrides;
  overrides.points = std::min<std::size_t>(number_of_points, 20);
  const auto motion = scenario::make_motion(scenario, kind, overrides);
  require(motion->points().size() == *overrides.points, "a motion has the wrong number of points");
  fuzz::require_sound(motion->ids(), motion->points());
  const scenario::Neighbor_edges edges = all_edges(motion->points().size());
  for (int frame = 0; frame != 3; ++frame) {
    require(motion->advance(edges), "a scenario has ended");
    fuzz::require_sound(motion->ids(), motion->points());
    require(std::isfinite(motion->time()), "a time is not finite");
  }
}

} // namespace

void fuzz::examine(const std::string& input)
{
  const auto scenario = parsed_or_refused(input, scenario::parse_scenario);
  if (!scenario) {
    return;
  }
  require(!scenario->name.empty(), "a scenario has no name");
  require(scenario->frames >= 1 && scenario->frames <= 1'000'000'000,
          "a scenario has an absurd number of frames");
  std::visit(
      [&](const auto& kind) {
        const std::size_t number_of_points = ::require_sound(kind);
        require(number_of_points >= 1 && number_of_points <= scenario::max_points,
                "a scenario has an absurd number of points");
        run(*scenario, kind, number_of_points);
      },
      scenario->kind);
}

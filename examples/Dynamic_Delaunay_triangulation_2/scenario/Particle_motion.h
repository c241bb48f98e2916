// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SCENARIO_PARTICLE_MOTION_H
#define SCENARIO_PARTICLE_MOTION_H

#include "Body_lattice.h"
#include "Motion.h"
#include "Particle_system.h"
#include "Random_source.h"
#include "Scenario_description.h"
#include "Scenario_scaling.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

namespace scenario {

// Blocks of discs under the physics of Particle_system.
class Particle_motion : public Motion
{
public:
  Particle_motion(std::string name, const Particle_description& description, std::uint64_t seed,
                  std::size_t frames, std::size_t number_of_points)
    : Motion(std::move(name))
    , m_time_step(description.time_step)
    , m_largest_stable_time_step(description.largest_stable_time_step)
    , m_frames(frames)
    , m_seconds_per_frame(description.time_step *
                          std::sqrt(description.mass / description.stiffness))
    , m_ids(number_of_points)
    , m_system(start(description, scaled_to(description, number_of_points), seed))
  {
    std::iota(m_ids.begin(), m_ids.end(), std::int64_t(0));
  }

  const std::vector<std::int64_t>& ids() const override { return m_ids; }
  const std::vector<Point>& points() const override { return m_system.positions(); }
  double time() const override { return m_time; }
  std::size_t frames() const override { return m_frames; }
  bool uses_neighbors() const override { return true; }
  std::optional<double> time_step() const override { return m_time_step; }

  std::optional<double> largest_stable_time_step() const override
  {
    return m_largest_stable_time_step;
  }

  bool advance(const Neighbor_edges& neighbors) override
  {
    m_system.step(neighbors, m_seconds_per_frame);
    m_time += m_seconds_per_frame;
    return true;
  }

  const Particle_system& system() const { return m_system; }

  Energy energy(const Neighbor_edges& neighbors)
  {
    return m_system.energy(neighbors, m_seconds_per_frame);
  }

private:
  static Particle_system start(const Particle_description& description,
                               const Scaled_scenario& scaled, std::uint64_t seed)
  {
    Random_source random(seed);
    std::vector<Point> positions;
    std::vector<Point> velocities;
    Bond_network bonds;
    for (const Scaled_body& body : scaled.bodies) {
      const Body_lattice lattice(body.number_of_points, body.columns, description.packing,
                                 description.diameter, body.description.position);
      if (body.description.bonded) {
        lattice.add_bonds(static_cast<std::uint32_t>(positions.size()),
                          body.description.strain_limit, bonds);
      } else {
        lattice.add_no_bonds(bonds);
      }
      const double jitter = description.jitter * description.diameter;
      add_particles(lattice, body.description, jitter, random, positions, velocities);
    }
    const double damping =
        description.damping * std::sqrt(description.stiffness * description.mass);
    const Particle_parameters parameters{description.diameter,  description.mass,
                                         description.stiffness, damping,
                                         scaled.gravity,        scaled.box};
    return Particle_system(parameters, std::move(positions), std::move(velocities),
                           std::move(bonds));
  }

  static void add_particles(const Body_lattice& lattice, const Body_description& body,
                            double jitter, Random_source& random, std::vector<Point>& positions,
                            std::vector<Point>& velocities)
  {
    const Point center = lattice.center();
    for (std::size_t i = 0; i != lattice.number_of_points(); ++i) {
      const Point place = lattice.point(i);
      velocities.push_back({body.velocity.x - body.angular_velocity * (place.y - center.y),
                            body.velocity.y + body.angular_velocity * (place.x - center.x)});
      const double dx = random.uniform(-jitter, jitter);
      const double dy = random.uniform(-jitter, jitter);
      positions.push_back({place.x + dx, place.y + dy});
    }
  }

  double m_time_step;
  std::optional<double> m_largest_stable_time_step;
  std::size_t m_frames;
  double m_seconds_per_frame;
  double m_time = 0.0;
  std::vector<std::int64_t> m_ids;
  Particle_system m_system;
};

} // namespace scenario

#endif // SCENARIO_PARTICLE_MOTION_H

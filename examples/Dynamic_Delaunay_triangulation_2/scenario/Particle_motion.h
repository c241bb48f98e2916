// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SCENARIO_PARTICLE_MOTION_H
#define SCENARIO_PARTICLE_MOTION_H

#include "Body_lattice.h"
#include "Bond_network.h"
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
  double time() const override { return m_frame * m_seconds_per_frame; }
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
    m_frame += 1;
    return true;
  }

  const Particle_system& system() const { return m_system; }

  Energy energy(const Neighbor_edges& neighbors)
  {
    return m_system.energy(neighbors, m_seconds_per_frame);
  }

private:
  struct First_frame
  {
    std::vector<Point> positions;
    std::vector<Point> velocities;
    Bond_network bonds;
  };

  static Particle_system start(const Particle_description& description,
                               const Scaled_scenario& scaled, std::uint64_t seed)
  {
    Random_source random(seed);
    First_frame frame;
    for (const Scaled_body& body : scaled.bodies) {
      const Body_lattice lattice(body.number_of_points, body.columns, description.packing,
                                 description.diameter, body.description.position);
      const std::size_t first_index = frame.positions.size();
      const double jitter = description.jitter * description.diameter;
      add_particles(lattice, body.description, jitter, random, frame);
      add_bonds(lattice, body.description, first_index, frame);
      if (body.description.shiver != 0.0) {
        const double speed = body.description.shiver * description.diameter *
                             std::sqrt(description.stiffness / description.mass);
        add_shiver(lattice, first_index, speed, random, frame);
      }
    }
    const double damping =
        description.damping * std::sqrt(description.stiffness * description.mass);
    const Particle_parameters parameters{description.diameter,  description.mass,
                                         description.stiffness, damping,
                                         scaled.gravity,        scaled.box};
    return Particle_system(parameters, std::move(frame.positions), std::move(frame.velocities),
                           std::move(frame.bonds));
  }

  static void add_particles(const Body_lattice& lattice, const Body_description& body,
                            double jitter, Random_source& random, First_frame& frame)
  {
    const Point center = lattice.center();
    for (std::size_t i = 0; i != lattice.number_of_points(); ++i) {
      const Point place = lattice.point(i);
      frame.velocities.push_back({body.velocity.x - body.angular_velocity * (place.y - center.y),
                                  body.velocity.y + body.angular_velocity * (place.x - center.x)});
      const double dx = random.uniform(-jitter, jitter);
      const double dy = random.uniform(-jitter, jitter);
      frame.positions.push_back({place.x + dx, place.y + dy});
    }
  }

  // At rest the body has its jittered shape, not the lattice's: relaxing into a perfect square
  // lattice it would make every cell a tie, whose diagonal rounding flips for ever.
  static void add_bonds(const Body_lattice& lattice, const Body_description& body,
                        std::size_t first_index, First_frame& frame)
  {
    for (std::size_t i = 0; i != lattice.number_of_points(); ++i) {
      frame.bonds.begin_particle();
      if (body.bonded) {
        lattice.for_each_later_near_place(i, [&](std::size_t j) {
          const Point offset = offset_between(frame, first_index + i, first_index + j);
          frame.bonds.add(static_cast<std::uint32_t>(first_index + j),
                          std::hypot(offset.x, offset.y), body.strain_limit);
        });
      }
    }
  }

  // Every bond kicks its two ends apart or together. Free random velocities would also set the body
  // as a whole drifting and turning, which damping never ends.
  static void add_shiver(const Body_lattice& lattice, std::size_t first_index, double speed,
                         Random_source& random, First_frame& frame)
  {
    for (std::size_t i = 0; i != lattice.number_of_points(); ++i) {
      lattice.for_each_later_near_place(i, [&](std::size_t j) {
        const Point offset = offset_between(frame, first_index + i, first_index + j);
        const double factor = random.uniform(-speed, speed) / std::hypot(offset.x, offset.y);
        Point& one = frame.velocities[first_index + i];
        Point& other = frame.velocities[first_index + j];
        one = {one.x - factor * offset.x, one.y - factor * offset.y};
        other = {other.x + factor * offset.x, other.y + factor * offset.y};
      });
    }
  }

  static Point offset_between(const First_frame& frame, std::size_t a, std::size_t b)
  {
    return {frame.positions[b].x - frame.positions[a].x,
            frame.positions[b].y - frame.positions[a].y};
  }

  double m_time_step;
  std::optional<double> m_largest_stable_time_step;
  std::size_t m_frames;
  double m_seconds_per_frame;
  double m_frame = 0.0;
  std::vector<std::int64_t> m_ids;
  Particle_system m_system;
};

} // namespace scenario

#endif // SCENARIO_PARTICLE_MOTION_H

// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "scenario_runner/space/Simulated_motion_3.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace scenario {

namespace {

double dot(const Point_3& u, const Point_3& v)
{
  return u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
}

Point_3 difference(const Point_3& p, const Point_3& q)
{
  return {p[0] - q[0], p[1] - q[1], p[2] - q[2]};
}

void add_multiple(Point_3& sum, double factor, const Point_3& vector)
{
  for (std::size_t axis = 0; axis != 3; ++axis) {
    sum[axis] += factor * vector[axis];
  }
}

double reflected(double value, double side)
{
  const double folded = std::fmod(std::abs(value), 2.0 * side);
  return folded > side ? 2.0 * side - folded : folded;
}

double wrapped(double value, double period)
{
  return value - period * std::floor(value / period);
}

} // namespace

Simulated_motion_3::Simulated_motion_3(const Scenario_description_3& description,
                                       std::size_t number_of_points, double time_step)
  : Motion_3(description.name)
  , m_points(number_of_points)
  , m_frames(description.frames)
  , m_time_step(time_step)
  , m_ids(number_of_points)
{
  std::iota(m_ids.begin(), m_ids.end(), std::int64_t(0));
}

Brownian_motion_3::Brownian_motion_3(const Scenario_description_3& description,
                                     const Brownian_description_3& brownian, std::uint64_t seed)
  : Simulated_motion_3(description, brownian.points, brownian.time_step)
  , m_box(brownian.box)
  , m_is_periodic(brownian.is_periodic)
  , m_random(seed)
  , m_step(brownian.time_step *
           std::cbrt(m_box[0] * m_box[1] * m_box[2] / static_cast<double>(brownian.points)))
{
  for (Point_3& point : m_points) {
    for (std::size_t axis = 0; axis != 3; ++axis) {
      point[axis] = m_random.uniform(0.0, m_box[axis]);
    }
  }
}

std::optional<Cell_3> Brownian_motion_3::cell() const
{
  const auto& [width, depth, height] = m_box;
  const Cell_3 cell{{}, {{{width, 0, 0}, {0, depth, 0}, {0, 0, height}}}, m_is_periodic};
  return cell.number_of_periodic_sides() == 0 ? std::nullopt : std::optional(cell);
}

bool Brownian_motion_3::advance(const Neighbor_edges&)
{
  for (Point_3& point : m_points) {
    for (std::size_t axis = 0; axis != 3; ++axis) {
      const double place = point[axis] + m_step * m_random.gaussian();
      point[axis] =
          m_is_periodic[axis] ? wrapped(place, m_box[axis]) : reflected(place, m_box[axis]);
    }
  }
  m_time += 1.0;
  return true;
}

Particle_motion_3::Particle_motion_3(const Scenario_description_3& description,
                                     const Particle_description_3& particles,
                                     std::size_t number_of_points, std::uint64_t seed)
  : Simulated_motion_3(description, number_of_points, particles.time_step)
  , m_description(particles)
  , m_seconds_per_frame(particles.time_step * std::sqrt(particles.mass / particles.stiffness))
  , m_damping(particles.damping * std::sqrt(particles.stiffness * particles.mass))
  , m_velocities(number_of_points)
  , m_forces(number_of_points)
{
  Random_source random(seed);
  place_blocks(number_of_points, random);
}

// Layer by layer from below.
void Particle_motion_3::place_blocks(std::size_t number_of_points, Random_source& random)
{
  const double diameter = m_description.diameter;
  const double jitter = m_description.jitter * diameter;
  std::size_t i = 0;
  for (const Block_description_3& block : m_description.blocks) {
    for (std::size_t k = 0; k != block.number_of_points() && i != number_of_points; ++k, ++i) {
      const std::array<std::size_t, 3> place = {k % block.counts[0],
                                                k / block.counts[0] % block.counts[1],
                                                k / (block.counts[0] * block.counts[1])};
      for (std::size_t axis = 0; axis != 3; ++axis) {
        m_points[i][axis] = block.position[axis] +
                            diameter * (0.5 + static_cast<double>(place[axis])) +
                            random.uniform(-jitter, jitter);
      }
      m_velocities[i] = block.velocity;
    }
  }
}

bool Particle_motion_3::advance(const Neighbor_edges& neighbors)
{
  std::fill(m_forces.begin(), m_forces.end(),
            Point_3{0.0, 0.0, -m_description.mass * m_description.gravity});
  find_contacts(neighbors);
  add_contact_forces();
  if (m_description.box) {
    add_wall_forces();
  }
  for (std::size_t i = 0; i != m_points.size(); ++i) {
    add_multiple(m_velocities[i], m_seconds_per_frame / m_description.mass, m_forces[i]);
    add_multiple(m_points[i], m_seconds_per_frame, m_velocities[i]);
  }
  if (m_description.box) {
    put_back_into_box();
  }
  m_frame += 1.0;
  return true;
}

// Sums round differently in another order, so contacts are sorted: the motion depends on which
// edges there are, not on how they are listed.
void Particle_motion_3::find_contacts(const Neighbor_edges& neighbors)
{
  const double squared_diameter = m_description.diameter * m_description.diameter;
  m_contacts.clear();
  for (const auto& [a, b] : neighbors) {
    const Point_3 offset = difference(m_points[b], m_points[a]);
    if (dot(offset, offset) < squared_diameter) {
      m_contacts.emplace_back((std::min)(a, b), (std::max)(a, b));
    }
  }
  std::sort(m_contacts.begin(), m_contacts.end());
}

void Particle_motion_3::add_contact_forces()
{
  for (const auto& [a, b] : m_contacts) {
    Point_3 normal = difference(m_points[b], m_points[a]);
    const double distance = std::sqrt(dot(normal, normal));
    if (distance == 0.0) {
      normal = {1.0, 0.0, 0.0};
    } else {
      normal = {normal[0] / distance, normal[1] / distance, normal[2] / distance};
    }
    const double approach = -dot(difference(m_velocities[b], m_velocities[a]), normal);
    const double force = push(m_description.diameter - distance, approach);
    add_multiple(m_forces[a], -force, normal);
    add_multiple(m_forces[b], force, normal);
  }
}

void Particle_motion_3::add_wall_forces()
{
  const double radius = 0.5 * m_description.diameter;
  for (std::size_t i = 0; i != m_points.size(); ++i) {
    for (std::size_t axis = 0; axis != 3; ++axis) {
      const double place = m_points[i][axis], velocity = m_velocities[i][axis];
      const double beyond = (*m_description.box)[axis] - place;
      m_forces[i][axis] += push(radius - place, -velocity) - push(radius - beyond, velocity);
    }
  }
}

double Particle_motion_3::push(double overlap, double approach) const
{
  return overlap > 0.0 ? (std::max)(0.0, m_description.stiffness * overlap + m_damping * approach)
                       : 0.0;
}

void Particle_motion_3::put_back_into_box()
{
  for (std::size_t i = 0; i != m_points.size(); ++i) {
    for (std::size_t axis = 0; axis != 3; ++axis) {
      double& place = m_points[i][axis];
      const double side = (*m_description.box)[axis];
      if (place < 0.0 || place > side) {
        place = std::clamp(place < 0.0 ? -place : 2.0 * side - place, 0.0, side);
        m_velocities[i][axis] = -m_velocities[i][axis];
        ++m_number_put_back;
      }
    }
  }
}

} // namespace scenario

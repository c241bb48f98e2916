// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SCENARIO_PARTICLE_SYSTEM_H
#define SCENARIO_PARTICLE_SYSTEM_H

#include "Bond_network.h"
#include "Motion.h"
#include "Scenario_description.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace scenario {

struct Particle_parameters
{
  double diameter;
  double mass;
  double stiffness;
  double damping;
  double gravity;
  std::optional<Box> box;
};

struct Energy
{
  double kinetic = 0.0;
  double potential = 0.0;

  double total() const { return kinetic + potential; }
};

// Soft discs of equal size that push each other and the walls apart with damped springs; bonds are
// springs that also pull. Only neighbors in a triangulation of the particles can touch.
class Particle_system
{
public:
  Particle_system(const Particle_parameters& parameters, std::vector<Point> positions,
                  std::vector<Point> velocities, Bond_network bonds)
    : m_parameters(parameters)
    , m_positions(std::move(positions))
    , m_velocities(std::move(velocities))
    , m_forces(m_positions.size())
    , m_bonds(std::move(bonds))
  {
  }

  // One semi-implicit Euler step: forces at the positions given by the edges' triangulation, then
  // velocities, then positions.
  void step(const Neighbor_edges& neighbors, double time_step)
  {
    compute_forces(neighbors);
    const double factor = time_step / m_parameters.mass;
    for (std::size_t i = 0; i != m_positions.size(); ++i) {
      m_velocities[i].x += factor * m_forces[i].x;
      m_velocities[i].y += factor * m_forces[i].y;
      m_positions[i].x += time_step * m_velocities[i].x;
      m_positions[i].y += time_step * m_velocities[i].y;
    }
    if (m_parameters.box) {
      put_back_into_box();
    }
  }

  // Semi-implicit Euler is a leapfrog whose velocities lie half a step before the positions, so the
  // kinetic energy is taken with velocities brought to the time of the positions.
  Energy energy(const Neighbor_edges& neighbors, double time_step)
  {
    Energy energy;
    energy.potential = compute_forces(neighbors);
    const double factor = 0.5 * time_step / m_parameters.mass;
    for (std::size_t i = 0; i != m_positions.size(); ++i) {
      const double vx = m_velocities[i].x + factor * m_forces[i].x;
      const double vy = m_velocities[i].y + factor * m_forces[i].y;
      energy.kinetic += 0.5 * m_parameters.mass * (vx * vx + vy * vy);
    }
    return energy;
  }

  const std::vector<Point>& positions() const { return m_positions; }
  const std::vector<Point>& velocities() const { return m_velocities; }
  const Bond_network& bonds() const { return m_bonds; }

  // The largest strain that an unbroken bond showed so far.
  double largest_strain() const { return m_largest_strain; }

  // How often a particle's center passed a wall and had to be reflected, which springs should
  // prevent.
  std::size_t number_put_back() const { return m_number_put_back; }

private:
  // Returns the potential energy.
  double compute_forces(const Neighbor_edges& neighbors)
  {
    const double weight = m_parameters.mass * m_parameters.gravity;
    std::fill(m_forces.begin(), m_forces.end(), Point{0.0, -weight});
    double potential = bond_forces() + contact_forces(neighbors);
    if (m_parameters.box) {
      potential += wall_forces();
    }
    if (weight != 0.0) {
      for (const Point& position : m_positions) {
        potential += weight * position.y;
      }
    }
    return potential;
  }

  double bond_forces()
  {
    double potential = 0.0;
    m_bonds.for_each([&](std::uint32_t particle, const Bond& bond) {
      const Pair pair = between(particle, bond.partner);
      const double length = std::sqrt(pair.squared_distance);
      const double stretch = length - bond.rest_length;
      const double strain = std::abs(stretch) / bond.rest_length;
      if (strain > bond.strain_limit) {
        return false;
      }
      m_largest_strain = (std::max)(m_largest_strain, strain);
      const Point normal = direction(pair, length);
      push_apart(particle, bond.partner, normal,
                 -m_parameters.stiffness * stretch - damping_force(pair, normal));
      potential += 0.5 * m_parameters.stiffness * stretch * stretch;
      return true;
    });
    return potential;
  }

  double contact_forces(const Neighbor_edges& neighbors)
  {
    find_contacts(neighbors);
    double potential = 0.0;
    for (const auto& [a, b] : m_contacts) {
      const Pair pair = between(a, b);
      const double distance = std::sqrt(pair.squared_distance);
      const double overlap = m_parameters.diameter - distance;
      const Point normal = direction(pair, distance);
      const double force = m_parameters.stiffness * overlap - damping_force(pair, normal);
      push_apart(a, b, normal, (std::max)(0.0, force));
      potential += 0.5 * m_parameters.stiffness * overlap * overlap;
    }
    return potential;
  }

  // Sums round differently in another order, so contacts are sorted: the motion depends on which
  // edges there are, not on how they are listed.
  void find_contacts(const Neighbor_edges& neighbors)
  {
    const double squared_diameter = m_parameters.diameter * m_parameters.diameter;
    m_contacts.clear();
    for (const auto& [a, b] : neighbors) {
      if (between(a, b).squared_distance < squared_diameter && !m_bonds.connects(a, b)) {
        m_contacts.emplace_back((std::min)(a, b), (std::max)(a, b));
      }
    }
    std::sort(m_contacts.begin(), m_contacts.end());
  }

  double wall_forces()
  {
    double potential = 0.0;
    for (std::size_t i = 0; i != m_positions.size(); ++i) {
      const Point& position = m_positions[i];
      const Point& velocity = m_velocities[i];
      Point& force = m_forces[i];
      potential += wall_force(position.x, velocity.x, 1.0, force.x) +
                   wall_force(m_parameters.box->width - position.x, velocity.x, -1.0, force.x) +
                   wall_force(position.y, velocity.y, 1.0, force.y) +
                   wall_force(m_parameters.box->height - position.y, velocity.y, -1.0, force.y);
    }
    return potential;
  }

  // `inwards` is the sign of the axis that leads away from the wall.
  double wall_force(double distance, double velocity, double inwards, double& force) const
  {
    const double overlap = 0.5 * m_parameters.diameter - distance;
    if (overlap <= 0.0) {
      return 0.0;
    }
    const double push =
        m_parameters.stiffness * overlap - m_parameters.damping * inwards * velocity;
    force += inwards * (std::max)(0.0, push);
    return 0.5 * m_parameters.stiffness * overlap * overlap;
  }

  struct Pair
  {
    Point offset;
    Point relative_velocity;
    double squared_distance;
  };

  Pair between(std::uint32_t a, std::uint32_t b) const
  {
    const Point offset{m_positions[b].x - m_positions[a].x, m_positions[b].y - m_positions[a].y};
    return {offset,
            {m_velocities[b].x - m_velocities[a].x, m_velocities[b].y - m_velocities[a].y},
            offset.x * offset.x + offset.y * offset.y};
  }

  static Point direction(const Pair& pair, double distance)
  {
    if (distance == 0.0) {
      return {1.0, 0.0};
    }
    return {pair.offset.x / distance, pair.offset.y / distance};
  }

  double damping_force(const Pair& pair, const Point& normal) const
  {
    return m_parameters.damping *
           (pair.relative_velocity.x * normal.x + pair.relative_velocity.y * normal.y);
  }

  void push_apart(std::uint32_t a, std::uint32_t b, const Point& normal, double force)
  {
    m_forces[a].x -= force * normal.x;
    m_forces[a].y -= force * normal.y;
    m_forces[b].x += force * normal.x;
    m_forces[b].y += force * normal.y;
  }

  void put_back_into_box()
  {
    for (std::size_t i = 0; i != m_positions.size(); ++i) {
      reflect(m_positions[i].x, m_velocities[i].x, m_parameters.box->width);
      reflect(m_positions[i].y, m_velocities[i].y, m_parameters.box->height);
    }
  }

  void reflect(double& coordinate, double& velocity, double side)
  {
    if (coordinate < 0.0 || coordinate > side) {
      coordinate = std::clamp(coordinate < 0.0 ? -coordinate : 2.0 * side - coordinate, 0.0, side);
      velocity = -velocity;
      ++m_number_put_back;
    }
  }

  Particle_parameters m_parameters;
  std::vector<Point> m_positions;
  std::vector<Point> m_velocities;
  std::vector<Point> m_forces;
  Bond_network m_bonds;
  Neighbor_edges m_contacts;
  double m_largest_strain = 0.0;
  std::size_t m_number_put_back = 0;
};

} // namespace scenario

#endif // SCENARIO_PARTICLE_SYSTEM_H

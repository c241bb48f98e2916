// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PAGE_MOTION_PLAYED_MOTION_H
#define PAGE_MOTION_PLAYED_MOTION_H

#include "scenario_runner/Simulated_motion.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace page {

using scenario::Neighbor_edges;
using scenario::Point;

// The motion of a scenario, with hands in it: points can be held, added and removed while they
// move. Numbers of points stay.
class Played_motion
{
public:
  Played_motion() = default;
  Played_motion(const Played_motion&) = delete;
  Played_motion& operator=(const Played_motion&) = delete;
  virtual ~Played_motion() = default;

  virtual const std::vector<Point>& points() const = 0;
  // By which the scenario's lengths are multiplied for this number of points.
  virtual double factor() const = 0;
  // The diameter of a particle, or the mean distance of neighbors.
  virtual double spacing() const = 0;

  // Acceleration of particles; of points without mass, how far they drift in a step, in spacings.
  virtual void set_field(const Point& field) = 0;
  // Draws a point to a place in the next step.
  virtual void hold(std::uint32_t point, const Point& place) = 0;
  virtual void add(const Point& place) = 0;
  // The point's neighbors are not asked for any more; where it is has no meaning.
  virtual void remove(std::uint32_t point) = 0;
  // A point that was removed.
  virtual void put_back(std::uint32_t point, const Point& place) = 0;
  virtual void advance(const Neighbor_edges& neighbors) = 0;
};

class Played_particles : public Played_motion
{
public:
  Played_particles(const scenario::Particle_description& description, std::size_t number_of_points,
                   std::uint64_t seed)
    : m_description(description)
    , m_scaled(scenario::scaled_to(description, number_of_points))
    , m_system(scenario::make_particle_system(description, m_scaled, seed))
    , m_time_step(description.time_step * std::sqrt(description.mass / description.stiffness))
  {
  }

  const std::vector<Point>& points() const override { return m_system.positions(); }
  double factor() const override { return m_scaled.factor; }
  double spacing() const override { return m_description.diameter; }

  void set_field(const Point& field) override { m_system.set_gravity(field); }

  // A damped spring, which does not pull harder beyond some length: nothing is torn through others.
  void hold(std::uint32_t point, const Point& place) override
  {
    const Point& at = m_system.positions()[point];
    const Point& velocity = m_system.velocities()[point];
    const Point offset{place.x - at.x, place.y - at.y};
    const double reach = longest_pull * m_description.diameter;
    const double share = (std::min)(1.0, reach / (std::max)(reach, std::hypot(offset.x, offset.y)));
    const double stiffness = 0.5 * m_description.stiffness;
    const double damping = 2.0 * std::sqrt(stiffness * m_description.mass); // critical
    m_system.push(point, {stiffness * share * offset.x - damping * velocity.x,
                          stiffness * share * offset.y - damping * velocity.y});
  }

  void add(const Point& place) override { m_system.add(place); }
  void remove(std::uint32_t point) override { m_system.remove(point); }
  void put_back(std::uint32_t point, const Point& place) override { m_system.put(point, place); }
  void advance(const Neighbor_edges& neighbors) override { m_system.step(neighbors, m_time_step); }

private:
  static constexpr double longest_pull = 6.0; // in diameters

  scenario::Particle_description m_description;
  scenario::Scaled_scenario m_scaled;
  scenario::Particle_system m_system;
  double m_time_step;
};

// Points without mass, which go where they are held at once.
class Played_walk : public Played_motion
{
public:
  Played_walk(const scenario::Scenario_description& scenario,
              const scenario::Brownian_description& description)
    : m_motion(scenario.name, description, scenario.seed, scenario.frames)
    , m_spacing(m_motion.mean_spacing())
  {
  }

  const std::vector<Point>& points() const override { return m_motion.points(); }
  double factor() const override { return 1.0; }
  double spacing() const override { return m_spacing; }

  void set_field(const Point& field) override
  {
    m_drift = {m_spacing * field.x, m_spacing * field.y};
  }

  void hold(std::uint32_t point, const Point& place) override { m_held.emplace_back(point, place); }
  void add(const Point& place) override { m_motion.add(place); }
  void remove(std::uint32_t) override {} // it walks on, unseen
  void put_back(std::uint32_t point, const Point& place) override { m_motion.put(point, place); }

  void advance(const Neighbor_edges& neighbors) override
  {
    m_motion.advance(neighbors);
    if (m_drift.x != 0.0 || m_drift.y != 0.0) {
      for (std::size_t i = 0; i != points().size(); ++i) {
        m_motion.put(i, {points()[i].x + m_drift.x, points()[i].y + m_drift.y});
      }
    }
    for (const auto& [point, place] : m_held) {
      m_motion.put(point, place);
    }
    m_held.clear();
  }

private:
  scenario::Brownian_motion m_motion;
  double m_spacing;
  Point m_drift{0.0, 0.0};
  std::vector<std::pair<std::uint32_t, Point>> m_held;
};

// A scenario as its file describes it, of so many points.
inline std::unique_ptr<Played_motion> make_motion(scenario::Scenario_description scenario,
                                                  std::size_t number_of_points)
{
  if (number_of_points < 1 || number_of_points > scenario::max_points) {
    throw std::invalid_argument("a scenario needs 1 to " + std::to_string(scenario::max_points) +
                                " points");
  }
  if (auto* walk = std::get_if<scenario::Brownian_description>(&scenario.kind)) {
    walk->points = number_of_points;
    return std::make_unique<Played_walk>(scenario, *walk);
  }
  return std::make_unique<Played_particles>(std::get<scenario::Particle_description>(scenario.kind),
                                            number_of_points, scenario.seed);
}

} // namespace page

#endif // PAGE_MOTION_PLAYED_MOTION_H

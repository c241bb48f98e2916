// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SCENARIO_RUNNER_SIMULATED_MOTION_H
#define SCENARIO_RUNNER_SIMULATED_MOTION_H

#include "scenario_runner/Motion.h"
#include "scenario_runner/Scenario_file.h"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <random>
#include <string>
#include <vector>

namespace scenario {

// The distributions of the standard library differ between its implementations; these do not.
class Random_source
{
public:
  explicit Random_source(std::uint64_t seed)
    : m_engine(seed)
  {
  }

  // Uniform in [0, 1).
  double uniform() { return static_cast<double>(m_engine() >> 11) * 0x1p-53; }

  double uniform(double low, double high) { return low + (high - low) * uniform(); }

  // Mean 0, standard deviation 1 (Box and Muller).
  double gaussian();

private:
  std::mt19937_64 m_engine;
  double m_spare = 0.0;
  bool m_has_spare = false;
};

// The lengths after which a space with axes at right angles repeats itself; 0 where it does not.
struct Periods
{
  double x = 0.0;
  double y = 0.0;

  // The offset to the nearest image.
  Point nearest(const Point& offset) const { return {nearest(offset.x, x), nearest(offset.y, y)}; }

  // The coordinate between 0 and the period, if there is one.
  static double wrapped(double coordinate, double period);

private:
  static double nearest(double offset, double period);
};

Periods periods_of(const std::optional<Box>& box, Cell_kind kind);

struct Bond
{
  std::uint32_t partner;
  double rest_length;
  double strain_limit; // infinite for bonds that never break
};

// The bonds of each particle to partners with a larger index, one flat array for all.
class Bond_network
{
public:
  // Bonds are added particle by particle: first begin_particle(), then its bonds.
  void begin_particle() { m_begin.push_back(m_bonds.size()); }

  void add(std::uint32_t partner, double rest_length, const std::optional<double>& strain_limit);

  void break_all_of(std::uint32_t particle);

  bool connects(std::uint32_t a, std::uint32_t b) const;

  // Calls visit(particle, bond) for every unbroken bond; the bond breaks where it answers false.
  template <class Visit>
  void for_each(Visit visit)
  {
    for (std::uint32_t particle = 0; particle != m_begin.size(); ++particle) {
      const std::size_t end = end_of(particle);
      for (std::size_t i = m_begin[particle]; i != end; ++i) {
        if (m_bonds[i].partner != broken && !visit(particle, m_bonds[i])) {
          m_bonds[i].partner = broken;
          ++m_number_of_broken;
        }
      }
    }
  }

  std::size_t number_of_bonds() const { return m_bonds.size(); }
  std::size_t number_of_broken() const { return m_number_of_broken; }

private:
  static constexpr std::uint32_t broken = (std::numeric_limits<std::uint32_t>::max)();

  std::size_t end_of(std::uint32_t particle) const;

  std::vector<std::size_t> m_begin;
  std::vector<Bond> m_bonds;
  std::size_t m_number_of_broken = 0;
};

struct Particle_parameters
{
  double diameter;
  double mass;
  double stiffness;
  double damping;
  double gravity;
  std::optional<Box> box;
  Cell_kind cell = Cell_kind::closed;
};

struct Energy
{
  double kinetic = 0.0;
  double potential = 0.0;

  double total() const { return kinetic + potential; }
};

// Soft discs of equal size that push each other and the walls apart with damped springs; bonds are
// springs that also pull. Only neighbors in a triangulation of the particles can touch. In periodic
// space each acts on the nearest image of the other.
class Particle_system
{
public:
  Particle_system(const Particle_parameters& parameters, std::vector<Point> positions,
                  std::vector<Point> velocities, Bond_network bonds);

  // One semi-implicit Euler step: forces at the positions given by the edges' triangulation, then
  // velocities, then positions.
  void step(const Neighbor_edges& neighbors, double time_step);

  // Semi-implicit Euler is a leapfrog whose velocities lie half a step before the positions, so the
  // kinetic energy is taken with velocities brought to the time of the positions.
  Energy energy(const Neighbor_edges& neighbors, double time_step);

  // The acceleration of all particles; at first the parameters' gravity, downwards.
  void set_gravity(const Point& acceleration) { m_gravity = acceleration; }

  // A force of the next step alone.
  void push(std::uint32_t particle, const Point& force) { m_pushes.emplace_back(particle, force); }

  // Adds a particle at rest, without bonds, and with the next number.
  void add(const Point& position);

  // Breaks the particle's bonds, and makes its position and velocity NaN; so is energy() until
  // put() is called. The others keep their numbers; edges must not name it.
  void remove(std::uint32_t particle);

  // Puts a particle to a position, at rest, with the bonds that it has.
  void put(std::uint32_t particle, const Point& position);

  // The cell of the box; none if it is closed.
  std::optional<Cell> cell() const;

  const std::vector<Point>& positions() const { return m_positions; }
  const std::vector<Point>& velocities() const { return m_velocities; }
  const Bond_network& bonds() const { return m_bonds; }

  // The largest strain that an unbroken bond showed so far.
  double largest_strain() const { return m_largest_strain; }

  // How often a particle's center passed a wall and had to be reflected, which springs should
  // prevent.
  std::size_t number_put_back() const { return m_number_put_back; }

private:
  struct Pair
  {
    Point offset;
    Point relative_velocity;
    double squared_distance;
  };

  // These return the potential energy.
  double compute_forces(const Neighbor_edges& neighbors);
  double bond_forces();
  double contact_forces(const Neighbor_edges& neighbors);
  double wall_forces();
  // Along one axis.
  double wall_forces(double Point::*axis, double side);
  // `inwards` is the sign of the axis that leads away from the wall.
  double wall_force(double distance, double velocity, double inwards, double& force) const;

  // Sums round differently in another order, so contacts are sorted: the motion depends on which
  // edges there are, not on how they are listed.
  void find_contacts(const Neighbor_edges& neighbors);
  Pair between(std::uint32_t a, std::uint32_t b) const;
  static Point direction(const Pair& pair, double distance);
  double damping_force(const Pair& pair, const Point& normal) const;
  void push_apart(std::uint32_t a, std::uint32_t b, const Point& normal, double force);
  void put_back_into_box();
  void put_back(double Point::*axis, double side, double period);
  void reflect(double& coordinate, double& velocity, double side);

  Particle_parameters m_parameters;
  Periods m_periods;
  Point m_gravity;
  std::vector<Point> m_positions;
  std::vector<Point> m_velocities;
  std::vector<Point> m_forces;
  std::vector<std::pair<std::uint32_t, Point>> m_pushes;
  Bond_network m_bonds;
  Neighbor_edges m_contacts;
  double m_largest_strain = 0.0;
  std::size_t m_number_put_back = 0;
};

// The first frame of a scenario.
Particle_system make_particle_system(const Particle_description& description,
                                     const Scaled_scenario& scaled, std::uint64_t seed);

// Blocks of discs under the physics of Particle_system.
class Particle_motion : public Motion
{
public:
  Particle_motion(std::string name, const Particle_description& description, std::uint64_t seed,
                  std::size_t frames, std::size_t number_of_points);

  const std::vector<std::int64_t>& ids() const override { return m_ids; }
  const std::vector<Point>& points() const override { return m_system.positions(); }
  double time() const override { return m_frame * m_seconds_per_frame; }
  std::optional<Cell> cell() const override { return m_system.cell(); }
  std::size_t frames() const override { return m_frames; }
  bool uses_neighbors() const override { return true; }
  std::optional<double> time_step() const override { return m_time_step; }
  std::optional<double> largest_stable_time_step() const override
  {
    return m_largest_stable_time_step;
  }
  bool advance(const Neighbor_edges& neighbors) override;

  const Particle_system& system() const { return m_system; }

  Energy energy(const Neighbor_edges& neighbors);

private:
  double m_time_step;
  std::optional<double> m_largest_stable_time_step;
  std::size_t m_frames;
  double m_seconds_per_frame;
  double m_frame = 0.0;
  std::vector<std::int64_t> m_ids;
  Particle_system m_system;
};

// Points that start uniformly in a box and take an independent Gaussian step every frame; the sides
// of the box reflect them, or they come in on the other side.
class Brownian_motion : public Motion
{
public:
  Brownian_motion(std::string name, const Brownian_description& description, std::uint64_t seed,
                  std::size_t frames);

  const std::vector<std::int64_t>& ids() const override { return m_ids; }
  const std::vector<Point>& points() const override { return m_points; }
  double time() const override { return m_time; }
  std::optional<Cell> cell() const override
  {
    return cell_of(m_description.box, m_description.cell);
  }
  std::size_t frames() const override { return m_frames; }
  std::optional<double> time_step() const override { return m_description.time_step; }

  bool advance(const Neighbor_edges&) override;

  double mean_spacing() const;

  // Puts a point to a place, reflected or wrapped as by a step that leads there.
  void put(std::size_t i, const Point& place);

  // Adds a point with the next id.
  void add(const Point& place);

private:
  static double kept_inside(double value, double side, double period);

  Brownian_description m_description;
  Random_source m_random;
  std::size_t m_frames;
  double m_time = 0.0;
  std::vector<std::int64_t> m_ids;
  std::vector<Point> m_points;
};

} // namespace scenario

#endif // SCENARIO_RUNNER_SIMULATED_MOTION_H

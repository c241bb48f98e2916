// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SCENARIO_RUNNER_SPACE_SIMULATED_MOTION_3_H
#define SCENARIO_RUNNER_SPACE_SIMULATED_MOTION_3_H

#include "scenario_runner/Simulated_motion.h"
#include "scenario_runner/space/Motion_3.h"
#include "scenario_runner/space/Scenario_file_3.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace scenario {

// A motion in space that a scenario file describes: all points stay, with the ids 0, 1, 2 and so
// on.
class Simulated_motion_3 : public Motion_3
{
public:
  Simulated_motion_3(const Scenario_description_3& description, std::size_t number_of_points,
                     double time_step);

  const std::vector<std::int64_t>& ids() const override { return m_ids; }
  const std::vector<Point_3>& points() const override { return m_points; }
  std::size_t frames() const override { return m_frames; }
  std::optional<double> time_step() const override { return m_time_step; }

protected:
  std::vector<Point_3> m_points;

private:
  std::size_t m_frames;
  double m_time_step;
  std::vector<std::int64_t> m_ids;
};

// Points that start uniformly in a box and take an independent Gaussian step every frame; the sides
// of the box reflect them, or it is periodic along all of them, two or one, and they are wrapped
// there.
class Brownian_motion_3 : public Simulated_motion_3
{
public:
  Brownian_motion_3(const Scenario_description_3& description,
                    const Brownian_description_3& brownian, std::uint64_t seed);

  double time() const override { return m_time; }
  std::optional<Point_3> box() const override
  {
    return cell() ? std::nullopt : std::optional(m_box);
  }
  std::optional<Cell_3> cell() const override;
  bool advance(const Neighbor_edges&) override;

private:
  Box_3 m_box;
  std::array<bool, 3> m_is_periodic; // along each axis
  Random_source m_random;
  double m_step; // its standard deviation along each axis
  double m_time = 0.0;
};

// Soft balls of equal size that push each other and the walls apart with damped springs, and fall.
// Only neighbors in a triangulation of the balls can touch. A frame is a semi-implicit Euler step.
class Particle_motion_3 : public Simulated_motion_3
{
public:
  // `particles`: scaled, of which `number_of_points` are there.
  Particle_motion_3(const Scenario_description_3& description,
                    const Particle_description_3& particles, std::size_t number_of_points,
                    std::uint64_t seed);

  double time() const override { return m_frame * m_seconds_per_frame; }
  std::optional<Point_3> box() const override { return m_description.box; }
  bool uses_neighbors() const override { return true; }
  bool advance(const Neighbor_edges& neighbors) override;

  // How often a ball's center passed a wall and had to be reflected, which springs should prevent.
  std::size_t number_put_back() const { return m_number_put_back; }

private:
  void place_blocks(std::size_t number_of_points, Random_source& random);
  void find_contacts(const Neighbor_edges& neighbors);
  void add_contact_forces();
  void add_wall_forces();
  void put_back_into_box();
  // The force of a damped spring that is compressed by `overlap`, and gets shorter by `approach` a
  // second; it never pulls.
  double push(double overlap, double approach) const;

  Particle_description_3 m_description;
  double m_seconds_per_frame;
  double m_damping;
  double m_frame = 0.0;
  std::vector<Point_3> m_velocities;
  std::vector<Point_3> m_forces;
  Neighbor_edges m_contacts;
  std::size_t m_number_put_back = 0;
};

} // namespace scenario

#endif // SCENARIO_RUNNER_SPACE_SIMULATED_MOTION_3_H

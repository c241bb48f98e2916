// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SCALE_SCALE_MOTION_H
#define SCALE_SCALE_MOTION_H

#include "../common/Contest.h"
#include "scenario_runner/Simulated_motion.h"
#include "scenario_runner/Static_triangulation.h"

#include <chrono>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace scale {

using Points = std::vector<run::Kernel::Point_2>;

// What happens in a frame.
struct Motion_kind
{
  std::string name;
  double drift;  // of all points alike, in spacings
  double step;   // of each coordinate on its own, standard deviation
  double jumps;  // the share of points that jump anywhere
  bool rebuilds; // the policy asks for it
  // What one thread computes before each update, as a simulation does, while the others fall
  // asleep.
  double seconds_alone = 0;
};

inline void compute_alone(double seconds)
{
  const auto start = std::chrono::steady_clock::now();
  volatile double sum = 0;
  while (std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() <
         seconds) {
    for (int i = 0; i < 1000; ++i) {
      sum = sum + std::sqrt(static_cast<double>(i));
    }
  }
}

// A random cloud, one point to a unit of area, that moves.
class Scale_motion
{
public:
  explicit Scale_motion(std::size_t points)
    : m_points(common::random_cloud<Points::value_type>(points, m_random))
  {
  }

  const Points& points() const { return m_points; }

  void advance(const Motion_kind& kind)
  {
    for (auto& point : m_points) {
      const double dx = displacement(kind);
      point = {point.x() + dx, point.y() + displacement(kind)};
    }
    const auto size = static_cast<double>(m_points.size());
    const double side = std::sqrt(size);
    const auto jumps = static_cast<std::size_t>(kind.jumps * size);
    for (std::size_t i = 0; i != jumps; ++i) {
      const auto id = static_cast<std::size_t>(m_random.uniform(0.0, size));
      const double x = m_random.uniform(0.0, side);
      m_points[id] = {x, m_random.uniform(0.0, side)};
    }
  }

private:
  double displacement(const Motion_kind& kind)
  {
    return kind.drift + (kind.step == 0.0 ? 0.0 : kind.step * m_random.gaussian());
  }

  scenario::Random_source m_random{1};
  Points m_points;
};

} // namespace scale

#endif // SCALE_SCALE_MOTION_H

// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SCALE_SCALE_MOTION_H
#define SCALE_SCALE_MOTION_H

#include "../common/Contest.h"
#include "scenario_runner/Simulated_motion.h"
#include "scenario_runner/Static_triangulation.h"

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
  bool rebuilds; // the policy asks for it
};

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

// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef COMMON_TELEPORT_MOTION_H
#define COMMON_TELEPORT_MOTION_H

#include "scenario_runner/Motion.h"
#include "scenario_runner/Simulated_motion.h"

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace common {

// Every frame is a fresh random cloud in the unit square: the worst that can come.
class Teleport_motion : public scenario::Motion
{
public:
  explicit Teleport_motion(std::size_t points)
    : Motion("teleport")
    , m_ids(points)
    , m_points(points)
  {
    std::iota(m_ids.begin(), m_ids.end(), std::int64_t(0));
    scatter();
  }

  const std::vector<std::int64_t>& ids() const override { return m_ids; }
  const std::vector<scenario::Point>& points() const override { return m_points; }
  double time() const override { return m_time; }
  std::size_t frames() const override { return usual_frames; }

  bool advance(const scenario::Neighbor_edges&) override
  {
    scatter();
    m_time += 1.0;
    return true;
  }

private:
  static constexpr std::size_t usual_frames = 20;

  void scatter()
  {
    for (scenario::Point& point : m_points) {
      point.x = m_random.uniform();
      point.y = m_random.uniform();
    }
  }

  scenario::Random_source m_random{1};
  double m_time = 0.0;
  std::vector<std::int64_t> m_ids;
  std::vector<scenario::Point> m_points;
};

} // namespace common

#endif // COMMON_TELEPORT_MOTION_H

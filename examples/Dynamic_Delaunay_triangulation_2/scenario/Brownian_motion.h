// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SCENARIO_BROWNIAN_MOTION_H
#define SCENARIO_BROWNIAN_MOTION_H

#include "Motion.h"
#include "Random_source.h"
#include "Scenario_description.h"

#include <cmath>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

namespace scenario {

// Points that start uniformly in a box and take an independent Gaussian step every frame; the sides
// of the box reflect them.
class Brownian_motion : public Motion
{
public:
  Brownian_motion(std::string name, const Brownian_description& description, std::uint64_t seed,
                  std::size_t frames)
    : Motion(std::move(name))
    , m_description(description)
    , m_random(seed)
    , m_frames(frames)
    , m_ids(description.points)
    , m_points(description.points)
  {
    std::iota(m_ids.begin(), m_ids.end(), std::int64_t(0));
    for (Point& point : m_points) {
      point.x = m_random.uniform(0.0, m_description.box.width);
      point.y = m_random.uniform(0.0, m_description.box.height);
    }
  }

  const std::vector<std::int64_t>& ids() const override { return m_ids; }
  const std::vector<Point>& points() const override { return m_points; }
  double time() const override { return m_time; }
  std::size_t frames() const override { return m_frames; }
  std::optional<double> time_step() const override { return m_description.time_step; }

  bool advance(const Neighbor_edges&) override
  {
    const double step = m_description.time_step * mean_spacing();
    for (Point& point : m_points) {
      point.x = reflected(point.x + step * m_random.gaussian(), m_description.box.width);
      point.y = reflected(point.y + step * m_random.gaussian(), m_description.box.height);
    }
    m_time += 1.0;
    return true;
  }

  double mean_spacing() const
  {
    const Box& box = m_description.box;
    return std::sqrt(box.width * box.height / static_cast<double>(m_points.size()));
  }

private:
  static double reflected(double value, double side)
  {
    const double folded = std::fmod(std::abs(value), 2.0 * side);
    return folded > side ? 2.0 * side - folded : folded;
  }

  Brownian_description m_description;
  Random_source m_random;
  std::size_t m_frames;
  double m_time = 0.0;
  std::vector<std::int64_t> m_ids;
  std::vector<Point> m_points;
};

} // namespace scenario

#endif // SCENARIO_BROWNIAN_MOTION_H

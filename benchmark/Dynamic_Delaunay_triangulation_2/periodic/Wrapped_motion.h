// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PERIODIC_WRAPPED_MOTION_H
#define PERIODIC_WRAPPED_MOTION_H

#include "../common/Contest.h"
#include "../common/Fastest_static.h"
#include "scenario_runner/Simulated_motion.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace periodic {

using common::Points;
using Point = run::Kernel::Point_2;

// Brownian motion in a periodic square, one point to a unit of area: every frame each coordinate
// takes an independent Gaussian step of this standard deviation. A point that leaves the square
// comes in on the other side.
class Wrapped_motion
{
public:
  Wrapped_motion(std::size_t points, double step, std::uint64_t seed)
    : m_side(std::sqrt(static_cast<double>(points)))
    , m_step(step)
    , m_random(seed)
    , m_unwrapped(common::random_cloud<Point>(points, m_random))
  {
    wrap();
  }

  void advance()
  {
    m_longest_move = 0.0;
    for (Point& point : m_unwrapped) {
      const double dx = m_step * m_random.gaussian(), dy = m_step * m_random.gaussian();
      point = Point(point.x() + dx, point.y() + dy);
      m_longest_move = (std::max)(m_longest_move, std::hypot(dx, dy));
    }
    wrap();
  }

  double side() const { return m_side; }
  // In the square, its lower sides included.
  const Points& wrapped() const { return m_wrapped; }
  // Where the points would be without a border.
  const Points& unwrapped() const { return m_unwrapped; }
  // Of the last step.
  double longest_move() const { return m_longest_move; }

private:
  void wrap()
  {
    m_wrapped.clear();
    for (const Point& point : m_unwrapped) {
      m_wrapped.emplace_back(wrapped(point.x()), wrapped(point.y()));
    }
  }

  // Rounding may lead out of the square again: such a coordinate becomes 0.
  double wrapped(double coordinate) const
  {
    const double rest = coordinate - m_side * std::floor(coordinate / m_side);
    return rest >= 0.0 && rest < m_side ? rest : 0.0;
  }

  double m_side;
  double m_step;
  scenario::Random_source m_random;
  Points m_unwrapped;
  Points m_wrapped;
  double m_longest_move = 0.0;
};

} // namespace periodic

#endif // PERIODIC_WRAPPED_MOTION_H

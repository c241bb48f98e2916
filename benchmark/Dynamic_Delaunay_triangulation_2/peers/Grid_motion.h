// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PEERS_GRID_MOTION_H
#define PEERS_GRID_MOTION_H

#include "Peer_output.h"
#include "scenario_runner/Motion.h"
#include "scenario_runner/Scenario_run.h"
#include "scenario_runner/Static_triangulation.h"

#include <CGAL/Dynamic_Delaunay_triangulation_2.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <stdexcept>
#include <utility>
#include <vector>

namespace peers {

// Rounds points to integer coordinates: Boost.Polygon takes nothing but 32-bit integers, so all
// peers get the same. The longer side of the first frame is 2^26 steps long.
//
// A finer grid would help no peer. With 26 bits, differences are exact in doubles, and their
// products lose only a bit or two, which favors peers that compute with rounding; still, a ten
// thousandth of the spacing is 21 steps of the grid at 100,000 points, two random points of them
// coincide once in a million frames, and points that fly apart may go 31 sides far.
class Grid
{
public:
  explicit Grid(const std::vector<scenario::Point>& points)
    : m_low(points.front())
  {
    scenario::Point high = m_low;
    for (const scenario::Point& point : points) {
      m_low = {(std::min)(m_low.x, point.x), (std::min)(m_low.y, point.y)};
      high = {(std::max)(high.x, point.x), (std::max)(high.y, point.y)};
    }
    m_scale = steps / (std::max)(high.x - m_low.x, high.y - m_low.y);
  }

  void snap(const std::vector<scenario::Point>& points, Grid_points& snapped) const
  {
    snapped.integers.clear();
    snapped.points.clear();
    for (const scenario::Point& point : points) {
      const Grid_point integers = {snap(point.x - m_low.x), snap(point.y - m_low.y)};
      snapped.integers.push_back(integers);
      snapped.points.emplace_back(integers.x, integers.y);
    }
  }

private:
  static constexpr double steps = 0x1p26;

  std::int32_t snap(double distance) const
  {
    const double value = std::round(distance * m_scale);
    if (!(std::abs(value) < (std::numeric_limits<std::int32_t>::max)())) {
      throw std::runtime_error("a point has left the grid");
    }
    return static_cast<std::int32_t>(value);
  }

  scenario::Point m_low;
  double m_scale;
};

// A motion on a grid, as the peers see it. If its physics needs neighbors, they come from an exact
// triangulation of its own, so no peer influences where the points go.
class Grid_motion
{
public:
  explicit Grid_motion(std::unique_ptr<scenario::Motion> motion)
    : m_motion(std::move(motion))
    , m_grid(m_motion->points())
  {
    if (m_motion->uses_neighbors()) {
      const auto& points = m_motion->points();
      m_driver = Driver(points.begin(), points.end(), run::Point_map());
    }
  }

  const Grid_points& snapped()
  {
    m_grid.snap(m_motion->points(), m_snapped);
    return m_snapped;
  }

  void advance()
  {
    if (!m_motion->advance(m_neighbors(*m_motion, m_driver))) {
      throw std::runtime_error("the motion has come to its end");
    }
    if (m_motion->uses_neighbors()) {
      const auto& points = m_motion->points();
      m_driver.update(points.begin(), points.end(), run::Point_map());
    }
  }

private:
  using Driver = CGAL::Dynamic_Delaunay_triangulation_2<run::Kernel>;

  std::unique_ptr<scenario::Motion> m_motion;
  Grid m_grid;
  Grid_points m_snapped;
  Driver m_driver; // empty if the motion needs no neighbors
  run::Neighbor_reader m_neighbors;
};

} // namespace peers

#endif // PEERS_GRID_MOTION_H

// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PEERS_GRID_MOTION_H
#define PEERS_GRID_MOTION_H

#include "Grid.h"
#include "Grid_points.h"
#include "scenario_runner/Motion.h"
#include "scenario_runner/Scenario_run.h"
#include "scenario_runner/Static_triangulation.h"

#include <CGAL/Dynamic_Delaunay_triangulation_2.h>

#include <memory>
#include <stdexcept>
#include <utility>

namespace peers {

// A motion as its peers see it, on a grid. Where its physics asks who is whose neighbor, an exact
// triangulation of its own answers, so no peer has a say in where the points go.
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
  Driver m_driver; // empty where nobody asks
  run::Neighbor_reader m_neighbors;
};

} // namespace peers

#endif // PEERS_GRID_MOTION_H

// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SCENARIO_RUNNER_SPACE_KEPT_PERIODIC_MOTION_3_H
#define SCENARIO_RUNNER_SPACE_KEPT_PERIODIC_MOTION_3_H

#include "scenario_runner/space/Motion_3.h"
#include "scenario_runner/space/Periodic_opponents_3.h"

#include <CGAL/Dynamic_Delaunay_triangulation_3/Dynamic_population_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/Voronoi_cell_measures_3.h>

#include <cstddef>
#include <cstdint>
#include <optional>

namespace run {

// The triangulation of a motion that has a cell in all frames, from its first frame on. If points
// come and go, it knows them by the motion's ids, otherwise by their places.
class Kept_periodic_motion_3
{
public:
  using Opponents = Periodic_opponents_3;

  Kept_periodic_motion_3(const scenario::Motion_3& motion, const Any_policy_3& policy);

  CGAL::Update_report_3 update(const scenario::Motion_3& motion);

  const Dynamic_periodic_3& triangulation() const
  {
    return m_population ? m_population->triangulation() : *m_triangulation;
  }
  // The id in the triangulation of the point in this place of the motion.
  std::size_t id(const scenario::Motion_3& motion, std::size_t place) const
  {
    return m_population ? m_population->id(motion.ids()[place]) : place;
  }

  // Calls `f(ids, shifts)` for each cell.
  template <class Function>
  void for_each_cell(const Function& f) const
  {
    triangulation().for_each_cell(f);
  }

  void measure(const scenario::Motion_3& motion, CGAL::Voronoi_cell_measures_3& measures) const;

private:
  CGAL::Update_report_3 update_population(const scenario::Motion_3& motion);

  // exactly one of them exists
  std::optional<Dynamic_periodic_3> m_triangulation;
  std::optional<CGAL::Dynamic_population_3<Dynamic_periodic_3, std::int64_t>> m_population;
};

} // namespace run

#endif // SCENARIO_RUNNER_SPACE_KEPT_PERIODIC_MOTION_3_H

// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SCENARIO_RUNNER_SPACE_KEPT_MOTION_3_H
#define SCENARIO_RUNNER_SPACE_KEPT_MOTION_3_H

#include "scenario_runner/space/Motion_3.h"
#include "scenario_runner/space/Policy_3.h"
#include "scenario_runner/space/Static_triangulation_3.h"
#include "scenario_runner/Threads.h"

#include <CGAL/Dynamic_Delaunay_triangulation_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/Dynamic_population_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/Voronoi_cell_measures_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace run {

using Dynamic_3 =
    CGAL::Dynamic_Delaunay_triangulation_3<CGAL::Exact_predicates_inexact_constructions_kernel,
                                           CGAL::With_concurrency_2<Concurrency_tag>,
                                           CGAL::With_policy_2<Any_policy_3>>;

struct As_point_3
{
  Dynamic_3::Point operator()(const scenario::Point_3& p) const { return {p[0], p[1], p[2]}; }
};

// The triangulation of a motion in open space, from its first frame on. If points come and go, it
// knows them by the motion's ids, otherwise by their places.
class Kept_motion_3
{
public:
  using Opponents = Static_opponents_3;

  Kept_motion_3(const scenario::Motion_3& motion, const Any_policy_3& policy);

  CGAL::Update_report_3 update(const scenario::Motion_3& motion);

  const Dynamic_3& triangulation() const
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
    triangulation().for_each_cell(
        [&](const std::array<std::size_t, 4>& ids) { f(ids, std::array<scenario::Shift_3, 4>{}); });
  }

  // Of the cells in the motion's box, or of whole ones.
  void measure(const scenario::Motion_3& motion, CGAL::Voronoi_cell_measures_3& measures) const;

private:
  CGAL::Update_report_3 update_population(const scenario::Motion_3& motion);

  // exactly one of them exists
  std::optional<Dynamic_3> m_triangulation;
  std::optional<CGAL::Dynamic_population_3<Dynamic_3, std::int64_t>> m_population;
};

} // namespace run

#endif // SCENARIO_RUNNER_SPACE_KEPT_MOTION_3_H

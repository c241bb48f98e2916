// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SCENARIO_RUNNER_SPACE_STATIC_TRIANGULATION_3_H
#define SCENARIO_RUNNER_SPACE_STATIC_TRIANGULATION_3_H

#include "scenario_runner/space/Motion_3.h"

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <cstddef>
#include <optional>
#include <vector>

namespace run {

// What the dynamic triangulation in space has to beat: two ways to triangulate a frame anew.
// Whatever a program could have at hand before the frame comes, and all destruction, is outside of
// the timing.
class Static_opponents_3
{
public:
  Static_opponents_3();

  void prepare(const std::vector<scenario::Point_3>& points, bool population_changed);

  // CGAL's own insertion of a range, as a user would write it.
  double time_insert();

  // Insertion in the order that CGAL's insertion had for the frame before, each point located from
  // the last one: that leaves sorting out.
  double time_fastest();

private:
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Triangulation = CGAL::Delaunay_triangulation_3<Kernel>;

  void find_order();

  std::vector<Kernel::Point_3> m_points;
  std::vector<Kernel::Point_3> m_sorted_points;
  std::vector<std::size_t> m_order;
  std::optional<Triangulation> m_insert;
  std::optional<Triangulation> m_fastest;
};

} // namespace run

#endif // SCENARIO_RUNNER_SPACE_STATIC_TRIANGULATION_3_H

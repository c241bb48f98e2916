// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SCENARIO_RUNNER_SPACE_PERIODIC_OPPONENTS_3_H
#define SCENARIO_RUNNER_SPACE_PERIODIC_OPPONENTS_3_H

#include "scenario_runner/space/Motion_3.h"
#include "scenario_runner/space/Policy_3.h"
#include "scenario_runner/space/Static_triangulation_3.h"
#include "scenario_runner/Threads.h"

#include <CGAL/Dynamic_Delaunay_triangulation_3/Periodic_cell_3.h>
#include <CGAL/Dynamic_periodic_Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <memory>
#include <optional>
#include <vector>

namespace run {

using Dynamic_periodic_3 = CGAL::Dynamic_periodic_Delaunay_triangulation_3<
    CGAL::Exact_predicates_inexact_constructions_kernel, CGAL::With_concurrency_2<Concurrency_tag>,
    CGAL::With_policy_2<Any_policy_3>>;

// Of a motion that is periodic along all sides, in a slab along two, or in a wire along one.
inline CGAL::Periodic_cell_3 periodic_cell(const scenario::Cell_3& cell)
{
  if (cell.is_wire()) {
    return CGAL::Periodic_cell_3(cell.side_of_wire());
  }
  if (cell.is_slab()) {
    const auto [i, j] = cell.sides_of_slab();
    return CGAL::Periodic_cell_3(cell.sides[i], cell.sides[j]);
  }
  return CGAL::Periodic_cell_3(cell.sides[0], cell.sides[1], cell.sides[2]);
}

// What the dynamic triangulation in periodic space has to beat:
// - CGAL's periodic triangulation, which knows cubes alone;
// - CGAL's triangulation of open space, of the points and ghosts, their images in a margin around
//   the cell. It has all cells if the margin is as wide as the radius of the largest empty sphere.
//   The margin is that radius of the frame before, in the scale of this one, plus a quarter;
// - the package's own one, made anew. It is the only one in a slab or a wire, where the flat cells
//   among the outermost points would need a margin of ghosts that is wider than the cell.
//
// Whatever a program could have at hand before the frame comes, wrapping, finding ghosts and their
// order, and all destruction, is outside of the timing.
class Periodic_opponents_3
{
public:
  Periodic_opponents_3();
  ~Periodic_opponents_3();

  // `before` is of the frame before, or, for the first one, of this frame.
  void prepare(const scenario::Motion_3& motion, const Dynamic_periodic_3& before);

  // CGAL's own insertion of a range, as a user would write it: of points in a cube, in any other
  // cell of points and ghosts; in a slab or a wire, the package's own triangulation.
  double time_insert();

  // The faster one of inserting points and ghosts in their order, and of the package's own
  // triangulation. This is left out for good if it took three times as long.
  double time_fastest();

private:
  struct Of_cgal; // whose headers are long

  double time_fresh();
  std::vector<scenario::Point_3> with_ghosts(const scenario::Motion_3& motion, double margin) const;

  std::vector<Dynamic_periodic_3::Point> m_points;
  std::optional<scenario::Cell_3> m_cell;
  std::unique_ptr<Of_cgal> m_of_cgal;
  Static_opponents_3 m_ghosts;
  std::optional<Dynamic_periodic_3> m_fresh;
  bool m_may_fresh_win = true;
};

} // namespace run

#endif // SCENARIO_RUNNER_SPACE_PERIODIC_OPPONENTS_3_H

// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SCENARIO_RUNNER_SPACE_PERIODIC_OPPONENTS_3_H
#define SCENARIO_RUNNER_SPACE_PERIODIC_OPPONENTS_3_H

#include "scenario_runner/space/Motion_3.h"
#include "scenario_runner/Threads.h"

#include <CGAL/Dynamic_Delaunay_triangulation_3/Periodic_cell_3.h>
#include <CGAL/Dynamic_periodic_Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <memory>
#include <optional>
#include <vector>

namespace run {

using Dynamic_periodic_3 = CGAL::Dynamic_periodic_Delaunay_triangulation_3<
    CGAL::Exact_predicates_inexact_constructions_kernel, CGAL::With_concurrency_2<Concurrency_tag>>;

// Of a motion that is periodic along all sides.
inline CGAL::Periodic_cell_3 periodic_cell(const scenario::Cell_3& cell)
{
  return CGAL::Periodic_cell_3(cell.sides[0], cell.sides[1], cell.sides[2]);
}

// What the dynamic triangulation in periodic space has to beat: CGAL's periodic triangulation,
// which knows cubes alone, and the package's own one, made anew. Whatever a program could have at
// hand before the frame comes, and all destruction, is outside of the timing.
class Periodic_opponents_3
{
public:
  Periodic_opponents_3();
  ~Periodic_opponents_3();

  void prepare(const scenario::Motion_3& motion);

  // CGAL's own insertion of a range of points in a cube; in any other cell `time_fastest()`.
  double time_insert();

  // The package's own triangulation of a range, made once in a frame.
  double time_fastest();

private:
  struct Of_cgal; // whose headers are long

  std::vector<Dynamic_periodic_3::Point> m_points;
  std::optional<scenario::Cell_3> m_cell;
  std::unique_ptr<Of_cgal> m_of_cgal;
  std::optional<Dynamic_periodic_3> m_fresh;
  double m_nanoseconds = 0.0; // that it took
};

} // namespace run

#endif // SCENARIO_RUNNER_SPACE_PERIODIC_OPPONENTS_3_H

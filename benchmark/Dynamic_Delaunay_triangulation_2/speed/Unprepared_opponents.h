// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SPEED_UNPREPARED_OPPONENTS_H
#define SPEED_UNPREPARED_OPPONENTS_H

#include "Insertion_in_rounds.h"
#include "scenario_runner/Measurement.h"
#include "scenario_runner/Motion.h"
#include "scenario_runner/Static_triangulation.h"

#include <CGAL/hilbert_sort.h>

#include <optional>
#include <vector>

namespace speed {

// The opponents where the last frame's order is worth nothing: whoever wants a spatial order has to
// sort while the clock runs.
class Unprepared_opponents
{
public:
  void prepare(const std::vector<scenario::Point>& points, bool population_changed)
  {
    m_opponents.prepare(points, population_changed);
    m_sorted.reset();
    m_points.clear();
    for (const scenario::Point& point : points) {
      m_points.emplace_back(point.x, point.y);
    }
  }

  double time_insert() { return m_opponents.time_insert(); }

  // Sorts along a Hilbert curve, and inserts in rounds along it. Halving boxes instead of sets of
  // points takes a tenth off the whole on an even cloud.
  double time_fastest()
  {
    return run::nanoseconds_of([this] {
      CGAL::hilbert_sort(m_points.begin(), m_points.end(), CGAL::Hilbert_sort_middle_policy());
      insert_in_rounds(m_points, m_sorted.emplace());
    });
  }

  const run::Static_triangulation& reference() const { return m_opponents.reference(); }

private:
  run::Static_opponents m_opponents;
  std::vector<run::Kernel::Point_2> m_points;
  std::optional<run::Static_triangulation> m_sorted;
};

} // namespace speed

#endif // SPEED_UNPREPARED_OPPONENTS_H

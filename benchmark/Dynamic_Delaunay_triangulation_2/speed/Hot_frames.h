// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SPEED_HOT_FRAMES_H
#define SPEED_HOT_FRAMES_H

#include "../common/Contest.h"
#include "scenario_runner/Measurement.h"
#include "scenario_runner/Motion.h"

#include <CGAL/Dynamic_Delaunay_triangulation_2.h>

#include <cstddef>
#include <vector>

namespace speed {

// Times the same frames in bursts, one update right after the other: their cost in a program that
// does nothing else with caches and vector units.
template <class Concurrency_tag>
class Hot_frames
{
public:
  explicit Hot_frames(const std::vector<scenario::Point>& points)
    : m_dynamic(common::places_of(points))
  {
  }

  void add(const std::vector<scenario::Point>& points)
  {
    m_frames.push_back(common::places_of(points));
    if (m_frames.size() == burst) {
      run_burst();
    }
  }

  // The times of hot frames.
  const std::vector<double>& nanoseconds_per_point() const { return m_times; }

private:
  using Dynamic = CGAL::Dynamic_Delaunay_triangulation_2<run::Kernel, CGAL::Default,
                                                         CGAL::With_concurrency_2<Concurrency_tag>>;

  static constexpr std::size_t burst = 8; // of 1000 points they fit in a second-level cache

  // The first update finds everything cold.
  void run_burst()
  {
    for (const common::Points& frame : m_frames) {
      const double time = run::nanoseconds_of([&] { m_dynamic.update(frame); });
      if (&frame != &m_frames.front()) {
        m_times.push_back(time / static_cast<double>(frame.size()));
      }
    }
    common::require(m_dynamic.is_certified(), "the triangulation of hot frames is not certified");
    m_frames.clear();
  }

  Dynamic m_dynamic;
  std::vector<common::Points> m_frames;
  std::vector<double> m_times;
};

} // namespace speed

#endif // SPEED_HOT_FRAMES_H

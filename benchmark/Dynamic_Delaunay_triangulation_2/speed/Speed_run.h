// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SPEED_SPEED_RUN_H
#define SPEED_SPEED_RUN_H

#include "Phase_marks.h"
#include "scenario_runner/Measurement.h"
#include "scenario_runner/Motion.h"
#include "scenario_runner/Scenario_run.h"
#include "Speed_record.h"
#include "Timed_classifier.h"
#include "Timed_repair.h"

#include <CGAL/delaunay_agreement.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>

namespace speed {

// Lets a motion run and keeps its triangulation: times every frame, phase by phase, against
// opponents that triangulate it anew, and checks the result outside of the timing.
template <class Opponents>
class Speed_run
{
public:
  explicit Speed_run(scenario::Motion& motion)
    : m_motion(motion)
  {
    check_coordinates();
    m_kept.emplace(motion, Dynamic(Timed_classifier(m_marks), Timed_repair(m_marks)));
  }
  Speed_run(const Speed_run&) = delete;
  Speed_run& operator=(const Speed_run&) = delete;

  // Follows a frame without the opponents, on the way to those that count. False at the end of the
  // motion.
  bool follow()
  {
    if (!go_on()) {
      return false;
    }
    time_dynamic();
    check_certificate();
    return true;
  }

  // Times all three. False at the end of the motion.
  bool measure()
  {
    if (!go_on()) {
      return false;
    }
    m_opponents.prepare(m_motion.points(), m_record.frame.population_changed);
    time_all();
    check_certificate();
    return true;
  }

  const Speed_record& record() const { return m_record; }

  // Of a measured frame, by everything that tells a right triangulation from a wrong one.
  void check_thoroughly() const
  {
    if (!m_kept->triangulation().is_valid()) {
      fail("the triangulation is not valid");
    }
    if (CGAL::delaunay_agreement(m_kept->triangulation(), m_opponents.reference())
            .matthews_correlation_coefficient() != 1.0) {
      fail("the triangulation differs from a fresh one");
    }
  }

private:
  using Dynamic =
      CGAL::Dynamic_Delaunay_triangulation_2<run::Kernel, Timed_classifier, Timed_repair>;

  bool go_on()
  {
    if (!m_motion.advance(m_neighbors(m_motion, m_kept->triangulation()))) {
      return false;
    }
    const std::size_t frame = m_record.frame.frame + 1;
    m_record = {};
    m_record.frame.frame = frame;
    m_record.frame.time = m_motion.time();
    m_record.frame.points = m_motion.points().size();
    m_record.frame.population_changed = m_motion.population_changed();
    check_coordinates();
    return true;
  }

  // The order rotates: whoever comes first warms the caches for the others.
  void time_all()
  {
    constexpr std::size_t contestants = 3;
    for (std::size_t i = 0; i != contestants; ++i) {
      switch ((m_record.frame.frame + i) % contestants) {
      case 0:
        time_dynamic();
        break;
      case 1:
        m_record.frame.nanoseconds.static_insert = m_opponents.time_insert();
        break;
      default:
        m_record.frame.nanoseconds.static_fastest = m_opponents.time_fastest();
      }
    }
  }

  void time_dynamic()
  {
    const double total = run::nanoseconds_of([&] {
      m_marks.start();
      m_record.frame.update = m_kept->update(m_motion);
    });
    m_record.frame.nanoseconds.dynamic = total;
    m_record.phases = m_marks.times(total);
  }

  // CGAL's static triangulation may never end on a coordinate that is no number.
  void check_coordinates() const
  {
    const auto& points = m_motion.points();
    if (!std::all_of(points.begin(), points.end(), [](const scenario::Point& point) {
          return std::isfinite(point.x) && std::isfinite(point.y);
        })) {
      fail("a point has left all bounds");
    }
  }

  void check_certificate() const
  {
    if (!m_kept->triangulation().is_certified()) {
      fail("the triangulation is not certified");
    }
  }

  [[noreturn]] void fail(const std::string& what) const
  {
    throw std::runtime_error("frame " + std::to_string(m_record.frame.frame) + ": " + what);
  }

  scenario::Motion& m_motion;
  Phase_marks m_marks;
  std::optional<run::Kept_triangulation<Dynamic>> m_kept;
  Opponents m_opponents;
  run::Neighbor_reader m_neighbors;
  Speed_record m_record;
};

} // namespace speed

#endif // SPEED_SPEED_RUN_H

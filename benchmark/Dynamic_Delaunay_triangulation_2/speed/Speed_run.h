// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SPEED_SPEED_RUN_H
#define SPEED_SPEED_RUN_H

#include "../common/Cases.h"
#include "../common/Contest.h"
#include "../common/Statistics.h"
#include "../common/Timed_phases.h"
#include "Hot_frames.h"
#include "scenario_runner/Frame_record.h"
#include "scenario_runner/Measurement.h"
#include "scenario_runner/Motion.h"
#include "scenario_runner/Scenario_run.h"

#include <CGAL/Dynamic_Delaunay_triangulation_2.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace speed {

using common::Figures;
using common::Phase_times;

struct Speed_record
{
  run::Frame_record frame{};
  Phase_times phases{};
};

using Speed_records = std::vector<Speed_record>;

// The records of frames that have points: others have no time a point.
inline Speed_records counted(const Speed_records& records)
{
  Speed_records counted;
  for (const Speed_record& record : records) {
    if (record.frame.points != 0) {
      counted.push_back(record);
    }
  }
  return counted;
}

template <class Value>
std::vector<double> per_point(const Speed_records& records, Value value)
{
  return common::values_of(records, [&](const Speed_record& record) {
    return static_cast<double>(value(record)) / static_cast<double>(record.frame.points);
  });
}

inline void add_counts(const Speed_records& records, Figures& figures)
{
  figures["points"] = common::largest(
      common::values_of(records, [](const Speed_record& record) { return record.frame.points; }));
  figures["frames"] = static_cast<double>(records.size());
  figures["flips"] = common::mean(
      per_point(records, [](const Speed_record& record) { return record.frame.update.flips; }));
  figures["rebuilds"] = common::sum(common::values_of(
      records, [](const Speed_record& record) { return record.frame.update.rebuilt(); }));
}

// Medians, each of its own: they need not add up to the median of the whole.
inline void add_phases(const Speed_records& records, Figures& figures)
{
  const auto median = [&](double Phase_times::*phase) {
    return common::median(
        per_point(records, [&](const Speed_record& record) { return record.phases.*phase; }));
  };
  figures["read"] = median(&Phase_times::read);
  figures["classify"] = median(&Phase_times::classify);
  figures["repair"] = median(&Phase_times::repair);
  figures["certify"] = median(&Phase_times::certify);
}

inline void add_times(const Speed_records& records, Figures& figures)
{
  const auto of_points = [&](double run::Frame_times::*time) {
    return per_point(records,
                     [&](const Speed_record& record) { return record.frame.nanoseconds.*time; });
  };
  const std::vector<double> dynamic = of_points(&run::Frame_times::dynamic);
  common::add_spread(figures, "dynamic", "", dynamic);
  figures["worst"] = common::largest(dynamic);
  figures["insert"] = common::median(of_points(&run::Frame_times::static_insert));
  figures["fastest"] = common::median(of_points(&run::Frame_times::static_fastest));
  figures["vs_insert"] = figures["insert"] / figures["dynamic"];
  figures["vs_fastest"] = figures["fastest"] / figures["dynamic"];
}

inline Figures speed_summary(const Speed_records& all_records)
{
  Figures figures;
  const Speed_records records = counted(all_records);
  if (!records.empty()) {
    add_counts(records, figures);
    add_times(records, figures);
    add_phases(records, figures);
  }
  return figures;
}

// Lets a motion run and keeps its triangulation: times every frame, phase by phase, against
// opponents that triangulate it anew, and checks the result outside of the timing.
template <class Opponents, class Concurrency_tag>
class Speed_run
{
public:
  explicit Speed_run(scenario::Motion& motion)
    : m_motion(motion)
  {
    check_coordinates();
    m_kept.emplace(motion, Dynamic(typename Dynamic::Settings{common::Timed_classifier(m_marks),
                                                              common::Timed_repair(m_marks)}));
    if (motion.has_fixed_population()) {
      m_hot_frames.emplace(motion.points());
    }
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
    finish_frame();
    return true;
  }

  // Times the update and both opponents. False at the end of the motion.
  bool measure()
  {
    if (!go_on()) {
      return false;
    }
    m_opponents.prepare(m_motion.points(), m_record.frame.population_changed);
    time_all();
    finish_frame();
    return true;
  }

  const Speed_record& record() const { return m_record; }

  // Nanoseconds a point of all frames, measured or followed, repeated as hot frames; none where
  // the population changes.
  std::vector<double> hot() const
  {
    return m_hot_frames ? m_hot_frames->nanoseconds_per_point() : std::vector<double>();
  }

  // To be called after a measured frame only.
  void check_thoroughly() const
  {
    common::require_equal(m_kept->triangulation(), m_opponents.reference(),
                          common::in_frame(m_record.frame.frame));
  }

private:
  using Dynamic = CGAL::Dynamic_Delaunay_triangulation_2<run::Kernel, common::Timed_classifier,
                                                         CGAL::With_repair_2<common::Timed_repair>,
                                                         CGAL::With_concurrency_2<Concurrency_tag>>;

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

  void finish_frame()
  {
    check_certificate();
    if (m_hot_frames) {
      m_hot_frames->add(m_motion.points());
    }
  }

  void time_all()
  {
    run::Frame_times& times = m_record.frame.nanoseconds;
    common::in_turn(m_record.frame.frame, 3, [&](std::size_t contestant) {
      if (contestant == 0) {
        time_dynamic();
      } else if (contestant == 1) {
        times.static_insert = m_opponents.time_insert();
      } else {
        times.static_fastest = m_opponents.time_fastest();
      }
    });
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
    const bool are_finite =
        std::all_of(points.begin(), points.end(), [](const scenario::Point& point) {
          return std::isfinite(point.x) && std::isfinite(point.y);
        });
    require(are_finite, "a point has left all bounds");
  }

  void check_certificate() const
  {
    require(m_kept->triangulation().is_certified(), "the triangulation is not certified");
  }

  void require(bool is_right, const char* what) const
  {
    common::require(is_right, common::in_frame(m_record.frame.frame) + what);
  }

  scenario::Motion& m_motion;
  common::Phase_marks m_marks;
  std::optional<run::Kept_triangulation<Dynamic>> m_kept;
  Opponents m_opponents;
  run::Neighbor_reader m_neighbors;
  std::optional<Hot_frames<Concurrency_tag>> m_hot_frames;
  Speed_record m_record;
};

} // namespace speed

#endif // SPEED_SPEED_RUN_H

// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SPEED_MOTION_CASES_H
#define SPEED_MOTION_CASES_H

#include "../common/Cases.h"
#include "../common/Contest.h"
#include "../common/Fastest_static.h"
#include "../common/Teleport_motion.h"
#include "scenario_runner/Measurement.h"
#include "scenario_runner/Motion.h"
#include "scenario_runner/Open_motion.h"
#include "scenario_runner/Progress.h"
#include "scenario_runner/Static_triangulation.h"
#include "Speed_run.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace speed {

// The opponents where the last frame's order is useless: a spatial order has to be found while the
// clock runs.
class Unprepared_opponents : public run::Static_opponents
{
public:
  void prepare(const std::vector<scenario::Point>& points, bool population_changed)
  {
    Static_opponents::prepare(points, population_changed);
    m_sorted.reset();
    m_points = common::places_of(points);
  }

  // Sorts along a Hilbert curve, and inserts in rounds along it.
  double time_fastest()
  {
    return run::nanoseconds_of([this] {
      common::sort_along_curve(m_points);
      common::insert_in_rounds(m_points, m_sorted.emplace());
    });
  }

private:
  common::Points m_points;
  std::optional<run::Static_triangulation> m_sorted;
};

// Which frames of a motion are measured, after the first one: one in `stride`, up to `measured`
// frames, behind `passed_over` others. All others are followed without the opponents.
struct Frame_choice
{
  std::size_t passed_over;
  std::size_t measured;
  std::size_t stride = 1;
};

struct Followed_frames
{
  Speed_records records{};
  std::vector<double> hot{};
};

template <class Opponents, class Concurrency_tag = CGAL::Sequential_tag>
Followed_frames run_frames(scenario::Motion& motion, const Frame_choice& frames)
{
  run::Progress_display progress(frames.passed_over + frames.measured * frames.stride, true);
  Speed_run<Opponents, Concurrency_tag> run(motion);
  Speed_records records;
  const auto follow = [&](std::size_t number) {
    bool goes_on = true;
    for (std::size_t i = 0; i != number && goes_on; ++i) {
      goes_on = run.follow();
      progress.show(run.record().frame.frame);
    }
    return goes_on;
  };
  follow(frames.passed_over);
  while (records.size() != frames.measured && follow(frames.stride - 1) && run.measure()) {
    records.push_back(run.record());
    progress.show(run.record().frame.frame);
  }
  if (!records.empty()) {
    run.check_thoroughly();
  }
  return {records, run.hot()};
}

inline common::Case_result result_of(const Followed_frames& frames)
{
  const double nanoseconds =
      common::sum(common::values_of(counted(frames.records), [](const Speed_record& record) {
        return record.frame.nanoseconds.dynamic;
      }));
  common::Case_result result{speed_summary(frames.records), 1e-9 * nanoseconds};
  if (!frames.hot.empty()) {
    result.figures["hot"] = common::median(frames.hot);
  }
  return result;
}

// The opponents have one thread whatever the tag is, as CGAL's insertion has.
template <class Concurrency_tag>
common::Case_result motion_case(scenario::Motion& motion, const Frame_choice& frames)
{
  return result_of(run_frames<run::Static_opponents, Concurrency_tag>(motion, frames));
}

// The fastest way for a fresh cloud is the faster one of `insert` and `sorted`.
inline common::Case_result teleport_case(std::size_t points)
{
  common::Teleport_motion motion(points);
  common::Case_result result =
      result_of(run_frames<Unprepared_opponents>(motion, {0, motion.frames()}));
  Figures& figures = result.figures;
  figures["sorted"] = figures["fastest"];
  figures["fastest"] = (std::min)(figures["insert"], figures["sorted"]);
  figures["vs_fastest"] = figures["fastest"] / figures["dynamic"];
  figures["of_fastest"] = figures["dynamic"] / figures["fastest"];
  return result;
}

inline common::Case_result recorded_case(const std::string& path)
{
  const auto motion = scenario::open_motion(path);
  const Followed_frames frames = run_frames<run::Static_opponents>(*motion, {0, motion->frames()});
  common::Case_result result = result_of(frames);
  result.figures["changes"] = static_cast<double>(
      std::count_if(frames.records.begin(), frames.records.end(),
                    [](const Speed_record& record) { return record.frame.population_changed; }));
  return result;
}

} // namespace speed

#endif // SPEED_MOTION_CASES_H

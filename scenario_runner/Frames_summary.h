// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SCENARIO_RUNNER_FRAMES_SUMMARY_H
#define SCENARIO_RUNNER_FRAMES_SUMMARY_H

#include "scenario_runner/Frame_record.h"
#include "scenario_runner/Measurement.h"
#include "scenario_runner/Rebuild_reason_name.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace run {

// Nanoseconds a point, over frames.
struct Time_summary
{
  std::optional<Spread> dynamic;
  std::optional<Spread> static_insert;
  std::optional<Spread> static_fastest;
};

// All frames after the first one, in the plane or in space, in a few numbers. Numbers that no frame
// yields are missing.
struct Frames_summary
{
  std::size_t points = 0; // the most in a frame
  std::size_t frames = 0;
  std::size_t certified_frames = 0;
  std::size_t rebuilds = 0;
  std::size_t population_changes = 0;
  std::map<std::string, std::size_t> rebuild_reasons;
  Time_summary times;
  Time_summary last_half_times;
};

// Frames without points have no time a point.
template <class Record>
std::optional<Spread> time_spread(const std::vector<Record>& records, double Frame_times::*time,
                                  std::size_t first)
{
  std::vector<double> values;
  for (std::size_t i = first; i < records.size(); ++i) {
    if (records[i].points != 0) {
      values.push_back(records[i].nanoseconds.*time / static_cast<double>(records[i].points));
    }
  }
  return spread(std::move(values));
}

template <class Record>
Time_summary time_summary(const std::vector<Record>& records, std::size_t first)
{
  return {time_spread(records, &Frame_times::dynamic, first),
          time_spread(records, &Frame_times::static_insert, first),
          time_spread(records, &Frame_times::static_fastest, first)};
}

template <class Record>
Frames_summary summarize_frames(std::size_t points_of_first_frame,
                                const std::vector<Record>& records)
{
  Frames_summary summary;
  summary.points = points_of_first_frame;
  for (const Record& record : records) {
    ++summary.frames;
    summary.points = (std::max)(summary.points, record.points);
    summary.certified_frames += record.certified ? 1 : 0;
    summary.population_changes += record.population_changed ? 1 : 0;
    if (record.update.rebuilt()) {
      ++summary.rebuilds;
      ++summary.rebuild_reasons[rebuild_reason_name(record.update.rebuild_reason)];
    }
  }
  summary.times = time_summary(records, 0);
  summary.last_half_times = time_summary(records, records.size() / 2);
  return summary;
}

// The mean of value(record).
template <class Record, class Value>
std::optional<double> mean(const std::vector<Record>& records, const Value& value)
{
  if (records.empty()) {
    return std::nullopt;
  }
  double sum = 0.0;
  for (const Record& record : records) {
    sum += static_cast<double>(value(record));
  }
  return sum / static_cast<double>(records.size());
}

} // namespace run

#endif // SCENARIO_RUNNER_FRAMES_SUMMARY_H

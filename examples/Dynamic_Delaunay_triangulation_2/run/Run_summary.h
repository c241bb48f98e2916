// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef RUN_RUN_SUMMARY_H
#define RUN_RUN_SUMMARY_H

#include "Frame_record.h"
#include "Rebuild_reason_name.h"
#include "Spread.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace run {

// Nanoseconds a point, over frames.
struct Time_summary
{
  std::optional<Spread> dynamic;
  std::optional<Spread> static_insert;
  std::optional<Spread> static_fastest;
};

// All frames after the first one in a few numbers. What no frame tells is not there.
struct Run_summary
{
  std::size_t points = 0; // the most in a frame
  std::size_t frames = 0;
  std::size_t certified_frames = 0;
  std::size_t rebuilds = 0;
  std::size_t population_changes = 0;
  std::map<std::string, std::size_t> rebuild_reasons;
  std::optional<double> validity_min;
  std::optional<double> validity_mean;
  std::optional<double> classified_mean;
  std::optional<double> padded_mean;
  std::optional<double> border_mean;
  std::optional<double> flips_mean;
  std::optional<double> splices_mean;
  std::optional<double> enlargements_mean;
  std::optional<double> relocated_mean;
  Time_summary times;
  Time_summary last_half_times;
};

template <class Value>
std::optional<double> mean(const std::vector<Frame_record>& records, Value value)
{
  if (records.empty()) {
    return std::nullopt;
  }
  double sum = 0.0;
  for (const Frame_record& record : records) {
    sum += static_cast<double>(value(record));
  }
  return sum / static_cast<double>(records.size());
}

// Frames without points have no time a point.
inline std::optional<Spread> time_spread(const std::vector<Frame_record>& records,
                                         double Frame_times::*time, std::size_t first)
{
  std::vector<double> values;
  for (std::size_t i = first; i < records.size(); ++i) {
    if (records[i].points != 0) {
      values.push_back(records[i].nanoseconds.*time / static_cast<double>(records[i].points));
    }
  }
  return spread(std::move(values));
}

inline Time_summary time_summary(const std::vector<Frame_record>& records, std::size_t first)
{
  return {time_spread(records, &Frame_times::dynamic, first),
          time_spread(records, &Frame_times::static_insert, first),
          time_spread(records, &Frame_times::static_fastest, first)};
}

inline std::optional<double> speedup(const std::optional<Spread>& dynamic,
                                     const std::optional<Spread>& opponent)
{
  if (!dynamic || !opponent || dynamic->median == 0.0) {
    return std::nullopt;
  }
  return opponent->median / dynamic->median;
}

inline void count(const Frame_record& record, Run_summary& summary)
{
  ++summary.frames;
  summary.points = (std::max)(summary.points, record.points);
  summary.certified_frames += record.certified ? 1 : 0;
  summary.population_changes += record.population_changed ? 1 : 0;
  if (record.update.rebuilt()) {
    ++summary.rebuilds;
    ++summary.rebuild_reasons[rebuild_reason_name(record.update.rebuild_reason)];
  }
  summary.validity_min = (std::min)(summary.validity_min.value_or(1.0), record.validity);
}

inline Run_summary summarize(std::size_t points_of_first_frame,
                             const std::vector<Frame_record>& records)
{
  Run_summary summary;
  summary.points = points_of_first_frame;
  for (const Frame_record& record : records) {
    count(record, summary);
  }
  const auto update_mean = [&](std::size_t CGAL::Update_report_2::*number) {
    return mean(records, [&](const Frame_record& record) { return record.update.*number; });
  };
  summary.validity_mean = mean(records, [](const Frame_record& record) { return record.validity; });
  summary.classified_mean = update_mean(&CGAL::Update_report_2::classified);
  summary.padded_mean = update_mean(&CGAL::Update_report_2::padded);
  summary.border_mean = update_mean(&CGAL::Update_report_2::border);
  summary.flips_mean = update_mean(&CGAL::Update_report_2::flips);
  summary.splices_mean = update_mean(&CGAL::Update_report_2::splices);
  summary.enlargements_mean = update_mean(&CGAL::Update_report_2::enlargements);
  summary.relocated_mean = update_mean(&CGAL::Update_report_2::relocated);
  summary.times = time_summary(records, 0);
  summary.last_half_times = time_summary(records, records.size() / 2);
  return summary;
}

} // namespace run

#endif // RUN_RUN_SUMMARY_H

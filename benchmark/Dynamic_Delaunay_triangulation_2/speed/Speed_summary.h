// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SPEED_SPEED_SUMMARY_H
#define SPEED_SPEED_SUMMARY_H

#include "scenario_runner/Measurement.h"
#include "Speed_record.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace speed {

// What is measured of a case, by name. What no frame tells is not there.
using Figures = std::map<std::string, double>;

using Speed_records = std::vector<Speed_record>;

// Frames that can be compared: without points there is no time a point.
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
  std::vector<double> values;
  for (const Speed_record& record : records) {
    values.push_back(static_cast<double>(value(record)) / static_cast<double>(record.frame.points));
  }
  return values;
}

template <class Value>
double median_per_point(const Speed_records& records, Value value)
{
  return run::spread(per_point(records, value))->median;
}

inline void add_counts(const Speed_records& records, Figures& figures)
{
  std::size_t points = 0;
  double flips = 0.0;
  double rebuilds = 0.0;
  for (const Speed_record& record : records) {
    const auto points_of_frame = static_cast<double>(record.frame.points);
    points = (std::max)(points, record.frame.points);
    flips += static_cast<double>(record.frame.update.flips) / points_of_frame;
    rebuilds += record.frame.update.rebuilt() ? 1.0 : 0.0;
  }
  figures["points"] = static_cast<double>(points);
  figures["frames"] = static_cast<double>(records.size());
  figures["flips"] = flips / static_cast<double>(records.size());
  figures["rebuilds"] = rebuilds;
}

// Medians, each of its own: they need not add up to the median of the whole.
inline void add_phases(const Speed_records& records, Figures& figures)
{
  const auto median = [&](double Phase_times::*phase) {
    return median_per_point(records,
                            [&](const Speed_record& record) { return record.phases.*phase; });
  };
  figures["read"] = median(&Phase_times::read);
  figures["classify"] = median(&Phase_times::classify);
  figures["repair"] = median(&Phase_times::repair);
  figures["certify"] = median(&Phase_times::certify);
}

inline void add_times(const Speed_records& records, Figures& figures)
{
  const auto spread = [&](double run::Frame_times::*time) {
    return *run::spread(per_point(
        records, [&](const Speed_record& record) { return record.frame.nanoseconds.*time; }));
  };
  const run::Spread dynamic = spread(&run::Frame_times::dynamic);
  figures["dynamic"] = dynamic.median;
  figures["q1"] = dynamic.low_quartile;
  figures["q3"] = dynamic.high_quartile;
  figures["insert"] = spread(&run::Frame_times::static_insert).median;
  figures["fastest"] = spread(&run::Frame_times::static_fastest).median;
  figures["vs_insert"] = figures["insert"] / dynamic.median;
  figures["vs_fastest"] = figures["fastest"] / dynamic.median;
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

} // namespace speed

#endif // SPEED_SPEED_SUMMARY_H

// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef RUN_RUN_TABLE_H
#define RUN_RUN_TABLE_H

#include "Run_subject.h"
#include "Run_summary.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iomanip>
#include <optional>
#include <ostream>
#include <sstream>
#include <string>

namespace run {

// Three significant digits, never an exponent.
inline std::string readable(double value)
{
  if (value == 0.0) {
    return "0";
  }
  const double size = std::abs(value);
  const int digits_before = size < 1.0 ? 1 : static_cast<int>(std::floor(std::log10(size))) + 1;
  const int digits_behind = 3 - digits_before;
  const double unit = std::pow(10.0, -(std::min)(0, digits_behind));
  std::ostringstream text;
  text << std::fixed << std::setprecision((std::max)(0, digits_behind))
       << (unit > 1.0 ? std::round(value / unit) * unit : value);
  return text.str();
}

inline std::string readable(const std::optional<double>& value)
{
  return value ? readable(*value) : "-";
}

// Never rounded up: what is shown as 1 is 1.
inline std::string readable_validity(const std::optional<double>& value)
{
  if (!value) {
    return "-";
  }
  std::ostringstream text;
  text << std::floor(*value * 1e6) / 1e6;
  return text.str();
}

inline void write_line(std::ostream& out, const std::string& label, const std::string& text)
{
  out << std::left << std::setw(30) << label << text << '\n';
}

inline void write_times(std::ostream& out, const std::string& label,
                        const std::optional<Spread>& spread)
{
  std::string text = "-";
  if (spread) {
    text = readable(spread->median) + "  (" + readable(spread->low_quartile) + " to " +
           readable(spread->high_quartile) + ")";
  }
  write_line(out, label, text);
}

inline void write_subject(std::ostream& out, const Run_subject& subject, const Run_summary& summary)
{
  write_line(out, "scenario",
             subject.scenario + ", " + std::to_string(summary.points) + " points, " +
                 std::to_string(summary.frames) + " frames");
  write_line(out, "classifier",
             subject.classifier.text() +
                 (subject.classifier.is_exact ? " (exact)" : " (heuristic)"));
  write_line(out, "repair", subject.repair);
  write_line(out, "policy", subject.policy.text());
  write_line(out, "engine", subject.engine);
}

inline std::string rebuild_text(const Run_summary& summary)
{
  std::string text = std::to_string(summary.rebuilds);
  const char* separator = "  (";
  for (const auto& [reason, number] : summary.rebuild_reasons) {
    text += separator + reason + ' ' + std::to_string(number);
    separator = ", ";
  }
  return text + (summary.rebuild_reasons.empty() ? "" : ")");
}

inline void write_results(std::ostream& out, const Run_summary& summary)
{
  write_line(out, "certified frames",
             std::to_string(summary.certified_frames) + " of " + std::to_string(summary.frames));
  write_line(out, "validity (MCC)",
             "mean " + readable_validity(summary.validity_mean) + ", smallest " +
                 readable_validity(summary.validity_min));
  write_line(out, "rebuilds", rebuild_text(summary));
  if (summary.population_changes != 0) {
    write_line(out, "population changes", std::to_string(summary.population_changes));
  }
  write_line(out, "a frame",
             "classified " + readable(summary.classified_mean) + ", padded " +
                 readable(summary.padded_mean) + ", border " + readable(summary.border_mean) +
                 ", flips " + readable(summary.flips_mean) + ", relocated " +
                 readable(summary.relocated_mean));
}

// For a person; a program reads the report.
inline void write_table(std::ostream& out, const Run_subject& subject, const Run_summary& summary)
{
  const Time_summary& times = summary.times;
  write_subject(out, subject, summary);
  write_results(out, summary);
  write_line(out, "ns a point", "median  (quartiles)");
  write_times(out, "  dynamic update", times.dynamic);
  write_times(out, "  static insert", times.static_insert);
  write_times(out, "  fastest static", times.static_fastest);
  write_line(out, "speedup over static insert",
             readable(speedup(times.dynamic, times.static_insert)));
  write_line(out, "speedup over fastest static",
             readable(speedup(times.dynamic, times.static_fastest)));
}

} // namespace run

#endif // RUN_RUN_TABLE_H

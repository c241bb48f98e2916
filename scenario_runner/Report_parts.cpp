// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "scenario_runner/Report_parts.h"

#include "scenario_runner/Number_text.h"

namespace run {

namespace {

std::optional<double> speedup(const std::optional<Spread>& dynamic,
                              const std::optional<Spread>& opponent)
{
  if (!dynamic || !opponent || dynamic->median == 0.0) {
    return std::nullopt;
  }
  return opponent->median / dynamic->median;
}

void add_times(Json& json, const std::string& name, const std::optional<Spread>& spread)
{
  json[name + "_ns_per_point"] = spread ? Json(spread->median) : Json(nullptr);
  json[name + "_ns_per_point_quartiles"] =
      spread ? Json{spread->low_quartile, spread->high_quartile} : Json(nullptr);
}

std::string readable_times(const std::optional<Spread>& spread)
{
  return spread ? readable(spread->median) + "  (" + readable(spread->low_quartile) + " to " +
                      readable(spread->high_quartile) + ")"
                : "-";
}

} // namespace

void add_rebuilds(Json& json, const Frames_summary& summary)
{
  json["rebuilds"] = summary.rebuilds;
  json["rebuild_reasons"] = Json(summary.rebuild_reasons);
  json["population_changes"] = summary.population_changes;
}

void add_comparison(Json& json, const Frames_summary& summary)
{
  const Time_summary& times = summary.times;
  add_times(json, "dynamic", times.dynamic);
  add_times(json, "static_insert", times.static_insert);
  add_times(json, "static_fastest", times.static_fastest);
  json["speedup_vs_insert"] = json_of(speedup(times.dynamic, times.static_insert));
  json["speedup_vs_fastest"] = json_of(speedup(times.dynamic, times.static_fastest));
  json["speedup_vs_insert_last_half"] =
      json_of(speedup(summary.last_half_times.dynamic, summary.last_half_times.static_insert));
}

std::string certified_text(const Frames_summary& summary)
{
  return std::to_string(summary.certified_frames) + " of " + std::to_string(summary.frames);
}

std::string rebuild_text(const Frames_summary& summary)
{
  std::string text = std::to_string(summary.rebuilds);
  const char* separator = "  (";
  for (const auto& [reason, number] : summary.rebuild_reasons) {
    text += separator + reason + ' ' + std::to_string(number);
    separator = ", ";
  }
  return text + (summary.rebuild_reasons.empty() ? "" : ")");
}

void add_comparison(Table& table, const Frames_summary& summary)
{
  const Time_summary& times = summary.times;
  table.add("ns a point", "median  (quartiles)");
  table.add("  dynamic update", readable_times(times.dynamic));
  table.add("  static insert", readable_times(times.static_insert));
  table.add("  fastest static", readable_times(times.static_fastest));
  table.add("speedup over static insert", speedup(times.dynamic, times.static_insert));
  table.add("speedup over fastest static", speedup(times.dynamic, times.static_fastest));
}

} // namespace run

// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SCENARIO_RUNNER_RUN_REPORT_H
#define SCENARIO_RUNNER_RUN_REPORT_H

#include "scenario_runner/Frame_record.h"
#include "scenario_runner/Measurement.h"
#include "scenario_runner/Motion.h"
#include "scenario_runner/Number_text.h"
#include "scenario_runner/Open_motion.h"
#include "scenario_runner/Run_options.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iomanip>
#include <map>
#include <optional>
#include <ostream>
#include <sstream>
#include <string>
#include <vector>

namespace run {

// What ran, with all defaults filled in.
struct Run_subject
{
  std::string scenario;
  Classifier_choice classifier;
  std::string repair;
  Policy_choice policy;
  unsigned padding;
  std::string engine;
  unsigned threads;
  std::optional<double> time_step;
  std::optional<std::uint64_t> seed; // where there is chance
  std::optional<scenario::Packing> packing;
};

inline Run_subject run_subject(const Run_options& options, const scenario::Motion& motion,
                               const scenario::Scenario_facts& facts)
{
  const bool is_random = facts.seed || options.classifier.uses_chance();
  const std::uint64_t seed = options.overrides.seed.value_or(facts.seed.value_or(0));
  return {motion.name(),
          options.classifier,
          options.repair_name(),
          options.policy,
          options.padding,
          options.engine,
          options.threads,
          motion.time_step(),
          is_random ? std::optional(seed) : std::nullopt,
          options.overrides.packing ? options.overrides.packing : facts.packing};
}

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

using Json = nlohmann::ordered_json;

template <class Value>
Json json_of(const std::optional<Value>& value)
{
  return value ? Json(*value) : Json(nullptr);
}

inline void add_times(Json& json, const std::string& name, const std::optional<Spread>& spread)
{
  json[name + "_ns_per_point"] = spread ? Json(spread->median) : Json(nullptr);
  json[name + "_ns_per_point_quartiles"] =
      spread ? Json{spread->low_quartile, spread->high_quartile} : Json(nullptr);
}

inline Json packing_json(const std::optional<scenario::Packing>& packing)
{
  if (!packing) {
    return nullptr;
  }
  return *packing == scenario::Packing::square ? "square" : "hexagonal";
}

inline Json parameter_json(const Classifier_choice& choice)
{
  return choice.parts.empty() ? json_of(choice.parameter) : Json(choice.parameter_text());
}

inline void add_subject(Json& json, const Run_subject& subject)
{
  json["classifier"] = subject.classifier.name;
  json["parameter"] = parameter_json(subject.classifier);
  json["padding"] = subject.padding;
  json["repair"] = subject.repair;
  json["policy"] = subject.policy.name;
  json["policy_parameter"] = json_of(subject.policy.parameter);
  json["engine"] = subject.engine;
  json["threads"] = subject.threads;
  json["time_step"] = json_of(subject.time_step);
  json["seed"] = json_of(subject.seed);
  json["packing"] = packing_json(subject.packing);
  json["exact"] = subject.classifier.is_exact;
}

inline void add_results(Json& json, const Run_summary& summary)
{
  json["certified_frames"] = summary.certified_frames;
  json["valid_frames"] = summary.frames; // the first invalid one would have ended the run
  json["mcc_min"] = json_of(summary.validity_min);
  json["mcc_mean"] = json_of(summary.validity_mean);
  json["rebuilds"] = summary.rebuilds;
  json["rebuild_reasons"] = Json(summary.rebuild_reasons);
  json["population_changes"] = summary.population_changes;
  json["classified_mean"] = json_of(summary.classified_mean);
  json["padded_mean"] = json_of(summary.padded_mean);
  json["border_mean"] = json_of(summary.border_mean);
  json["flips_mean"] = json_of(summary.flips_mean);
  json["splices_mean"] = json_of(summary.splices_mean);
  json["enlargements_mean"] = json_of(summary.enlargements_mean);
  json["relocated_mean"] = json_of(summary.relocated_mean);
}

inline void add_comparison(Json& json, const Run_summary& summary)
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

inline void write_report(std::ostream& out, const Run_subject& subject, const Run_summary& summary)
{
  Json json;
  json["scenario"] = subject.scenario;
  json["points"] = summary.points;
  json["frames"] = summary.frames;
  add_subject(json, subject);
  add_results(json, summary);
  add_comparison(json, summary);
  out << json.dump(2, ' ', false, Json::error_handler_t::replace) << '\n';
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

#endif // SCENARIO_RUNNER_RUN_REPORT_H

// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "scenario_runner/Run_report.h"

#include "scenario_runner/Number_text.h"
#include "scenario_runner/Rebuild_reason_name.h"
#include "scenario_runner/Table.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <utility>

namespace run {

namespace {

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
std::optional<Spread> time_spread(const std::vector<Frame_record>& records,
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

Time_summary time_summary(const std::vector<Frame_record>& records, std::size_t first)
{
  return {time_spread(records, &Frame_times::dynamic, first),
          time_spread(records, &Frame_times::static_insert, first),
          time_spread(records, &Frame_times::static_fastest, first)};
}

std::optional<double> speedup(const std::optional<Spread>& dynamic,
                              const std::optional<Spread>& opponent)
{
  if (!dynamic || !opponent || dynamic->median == 0.0) {
    return std::nullopt;
  }
  return opponent->median / dynamic->median;
}

void count(const Frame_record& record, Run_summary& summary)
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

using Json = nlohmann::ordered_json;

template <class Value>
Json json_of(const std::optional<Value>& value)
{
  return value ? Json(*value) : Json(nullptr);
}

void add_times(Json& json, const std::string& name, const std::optional<Spread>& spread)
{
  json[name + "_ns_per_point"] = spread ? Json(spread->median) : Json(nullptr);
  json[name + "_ns_per_point_quartiles"] =
      spread ? Json{spread->low_quartile, spread->high_quartile} : Json(nullptr);
}

Json packing_json(const std::optional<scenario::Packing>& packing)
{
  if (!packing) {
    return nullptr;
  }
  return *packing == scenario::Packing::square ? "square" : "hexagonal";
}

Json parameter_json(const Classifier_choice& choice)
{
  return choice.parts.empty() ? json_of(choice.parameter) : Json(choice.parameter_text());
}

void add_subject(Json& json, const Run_subject& subject)
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
  json["cell"] = json_of(subject.cell);
  json["exact"] = subject.classifier.is_exact;
}

void add_results(Json& json, const Run_summary& summary)
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

void add_comparison(Json& json, const Run_summary& summary)
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

std::string readable_times(const std::optional<Spread>& spread)
{
  return spread ? readable(spread->median) + "  (" + readable(spread->low_quartile) + " to " +
                      readable(spread->high_quartile) + ")"
                : "-";
}

std::string rebuild_text(const Run_summary& summary)
{
  std::string text = std::to_string(summary.rebuilds);
  const char* separator = "  (";
  for (const auto& [reason, number] : summary.rebuild_reasons) {
    text += separator + reason + ' ' + std::to_string(number);
    separator = ", ";
  }
  return text + (summary.rebuild_reasons.empty() ? "" : ")");
}

std::string classifier_text(const Classifier_choice& classifier)
{
  return classifier.text() + (classifier.is_exact ? " (exact)" : " (heuristic)");
}

} // namespace

Run_summary summarize(std::size_t points_of_first_frame, const std::vector<Frame_record>& records)
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

void write_report(std::ostream& out, const Run_subject& subject, const Run_summary& summary)
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

std::string method_text(const Run_subject& subject)
{
  return classifier_text(subject.classifier) + ", padding " + std::to_string(subject.padding) +
         ", " + subject.repair + ", " + subject.policy.text();
}

void write_table(std::ostream& out, const Run_subject& subject, const Run_summary& summary)
{
  const Time_summary& times = summary.times;
  Table table({}, Table::Align::LEFT);
  table.add("scenario", subject.scenario + ", " + std::to_string(summary.points) + " points, " +
                            std::to_string(summary.frames) + " frames");
  if (subject.cell) {
    table.add("cell", *subject.cell);
  }
  table.add("classifier", classifier_text(subject.classifier));
  table.add("repair", subject.repair);
  table.add("policy", subject.policy.text());
  table.add("engine", subject.engine);
  table.add("certified frames",
            std::to_string(summary.certified_frames) + " of " + std::to_string(summary.frames));
  table.add("validity (MCC)", "mean " + readable_validity(summary.validity_mean) + ", smallest " +
                                  readable_validity(summary.validity_min));
  table.add("rebuilds", rebuild_text(summary));
  if (summary.population_changes != 0) {
    table.add("population changes", summary.population_changes);
  }
  table.add("a frame", "classified " + readable(summary.classified_mean) + ", padded " +
                           readable(summary.padded_mean) + ", border " +
                           readable(summary.border_mean) + ", flips " +
                           readable(summary.flips_mean) + ", relocated " +
                           readable(summary.relocated_mean));
  table.add("ns a point", "median  (quartiles)");
  table.add("  dynamic update", readable_times(times.dynamic));
  table.add("  static insert", readable_times(times.static_insert));
  table.add("  fastest static", readable_times(times.static_fastest));
  table.add("speedup over static insert", speedup(times.dynamic, times.static_insert));
  table.add("speedup over fastest static", speedup(times.dynamic, times.static_fastest));
  table.write(out);
}

} // namespace run

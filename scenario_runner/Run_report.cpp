// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "scenario_runner/Run_report.h"

#include "scenario_runner/Number_text.h"
#include "scenario_runner/Report_parts.h"
#include "scenario_runner/Table.h"

#include <algorithm>

namespace run {

namespace {

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
  add_rebuilds(json, summary);
  json["classified_mean"] = json_of(summary.classified_mean);
  json["padded_mean"] = json_of(summary.padded_mean);
  json["border_mean"] = json_of(summary.border_mean);
  json["flips_mean"] = json_of(summary.flips_mean);
  json["splices_mean"] = json_of(summary.splices_mean);
  json["enlargements_mean"] = json_of(summary.enlargements_mean);
  json["relocated_mean"] = json_of(summary.relocated_mean);
}

std::string classifier_text(const Classifier_choice& classifier)
{
  return classifier.text() + (classifier.is_exact ? " (exact)" : " (heuristic)");
}

} // namespace

Run_summary summarize(std::size_t points_of_first_frame, const std::vector<Frame_record>& records)
{
  Run_summary summary;
  static_cast<Frames_summary&>(summary) = summarize_frames(points_of_first_frame, records);
  for (const Frame_record& record : records) {
    summary.validity_min = (std::min)(summary.validity_min.value_or(1.0), record.validity);
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
  table.add("certified frames", certified_text(summary));
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
  add_comparison(table, summary);
  table.write(out);
}

} // namespace run

// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "scenario_runner/space/Run_report_3.h"

#include "scenario_runner/Number_text.h"
#include "scenario_runner/Report_parts.h"
#include "scenario_runner/Table.h"

namespace run {

Run_summary_3 summarize(std::size_t points_of_first_frame,
                        const std::vector<Frame_record_3>& records)
{
  Run_summary_3 summary;
  static_cast<Frames_summary&>(summary) = summarize_frames(points_of_first_frame, records);
  const auto update_mean = [&](std::size_t CGAL::Update_report_3::*number) {
    return mean(records, [&](const Frame_record_3& record) { return record.update.*number; });
  };
  summary.unproved_mean = update_mean(&CGAL::Update_report_3::unproved);
  summary.flips_mean = update_mean(&CGAL::Update_report_3::flips);
  summary.held_mean = update_mean(&CGAL::Update_report_3::held);
  summary.relocated_mean = update_mean(&CGAL::Update_report_3::relocated);
  return summary;
}

void write_report(std::ostream& out, const Run_subject_3& subject, const Run_summary_3& summary)
{
  Json json;
  json["scenario"] = subject.scenario;
  json["dimension"] = 3;
  json["points"] = summary.points;
  json["frames"] = summary.frames;
  json["repair"] = "hold_and_flip";
  json["policy"] = subject.policy.name;
  json["policy_parameter"] = json_of(subject.policy.parameter);
  json["threads"] = subject.threads;
  json["time_step"] = json_of(subject.time_step);
  json["seed"] = json_of(subject.seed);
  json["cell"] = json_of(subject.cell);
  json["exact"] = true;
  json["certified_frames"] = summary.certified_frames;
  json["valid_frames"] = summary.frames; // the first invalid one would have ended the run
  add_rebuilds(json, summary);
  json["unproved_mean"] = json_of(summary.unproved_mean);
  json["flips_mean"] = json_of(summary.flips_mean);
  json["held_mean"] = json_of(summary.held_mean);
  json["relocated_mean"] = json_of(summary.relocated_mean);
  add_comparison(json, summary);
  out << json.dump(2, ' ', false, Json::error_handler_t::replace) << '\n';
}

void write_table(std::ostream& out, const Run_subject_3& subject, const Run_summary_3& summary)
{
  Table table({}, Table::Align::LEFT);
  table.add("scenario", subject.scenario + ", " + std::to_string(summary.points) +
                            " points in space, " + std::to_string(summary.frames) + " frames");
  if (subject.cell) {
    table.add("cell", *subject.cell);
  }
  table.add("repair", "hold_and_flip (exact)");
  table.add("policy", subject.policy.text());
  table.add("certified frames", certified_text(summary));
  table.add("rebuilds", rebuild_text(summary));
  if (summary.population_changes != 0) {
    table.add("population changes", summary.population_changes);
  }
  table.add("a frame", "unproved " + readable(summary.unproved_mean) + ", flips " +
                           readable(summary.flips_mean) + ", held " + readable(summary.held_mean) +
                           ", relocated " + readable(summary.relocated_mean));
  if (subject.cell == "slab" || subject.cell == "wire") {
    table.add("static ways",
              "its own triangulation made anew: CGAL has none of " + *subject.cell + "s");
  }
  add_comparison(table, summary);
  table.write(out);
}

} // namespace run

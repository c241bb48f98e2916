// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef RUN_RUN_REPORT_H
#define RUN_RUN_REPORT_H

#include "Run_subject.h"
#include "Run_summary.h"

#include <nlohmann/json.hpp>

#include <optional>
#include <ostream>
#include <string>

namespace run {

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

} // namespace run

#endif // RUN_RUN_REPORT_H

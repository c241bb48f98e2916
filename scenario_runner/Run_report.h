// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SCENARIO_RUNNER_RUN_REPORT_H
#define SCENARIO_RUNNER_RUN_REPORT_H

#include "scenario_runner/Frame_record.h"
#include "scenario_runner/Measurement.h"
#include "scenario_runner/Method_choice.h"
#include "scenario_runner/Scenario_file.h"

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

namespace run {

// The settings of a run, with all defaults filled in.
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
  std::optional<std::string> cell{}; // "torus" or "slab" where space is periodic
};

// The classifier, repair and policy of a run, in one line.
std::string method_text(const Run_subject& subject);

// Nanoseconds a point, over frames.
struct Time_summary
{
  std::optional<Spread> dynamic;
  std::optional<Spread> static_insert;
  std::optional<Spread> static_fastest;
};

// All frames after the first one in a few numbers. Numbers that no frame yields are missing.
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

Run_summary summarize(std::size_t points_of_first_frame, const std::vector<Frame_record>& records);

// One JSON object, for programs.
void write_report(std::ostream& out, const Run_subject& subject, const Run_summary& summary);

// For a person.
void write_table(std::ostream& out, const Run_subject& subject, const Run_summary& summary);

} // namespace run

#endif // SCENARIO_RUNNER_RUN_REPORT_H

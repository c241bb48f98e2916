// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SCENARIO_RUNNER_RUN_REPORT_H
#define SCENARIO_RUNNER_RUN_REPORT_H

#include "scenario_runner/Frame_record.h"
#include "scenario_runner/Frames_summary.h"
#include "scenario_runner/Method_choice.h"
#include "scenario_runner/Scenario_file.h"

#include <cstddef>
#include <cstdint>
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
  std::optional<std::string> cell{}; // "torus", "slab" or "wire" where space is periodic
};

// The classifier, repair and policy of a run, in one line.
std::string method_text(const Run_subject& subject);

// All frames of a run in the plane after the first one, in a few numbers.
struct Run_summary : Frames_summary
{
  std::optional<double> validity_min;
  std::optional<double> validity_mean;
  std::optional<double> classified_mean;
  std::optional<double> padded_mean;
  std::optional<double> border_mean;
  std::optional<double> flips_mean;
  std::optional<double> splices_mean;
  std::optional<double> enlargements_mean;
  std::optional<double> relocated_mean;
};

Run_summary summarize(std::size_t points_of_first_frame, const std::vector<Frame_record>& records);

// One JSON object, for programs.
void write_report(std::ostream& out, const Run_subject& subject, const Run_summary& summary);

// For a person.
void write_table(std::ostream& out, const Run_subject& subject, const Run_summary& summary);

} // namespace run

#endif // SCENARIO_RUNNER_RUN_REPORT_H

// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SCENARIO_RUNNER_SPACE_RUN_REPORT_3_H
#define SCENARIO_RUNNER_SPACE_RUN_REPORT_3_H

#include "scenario_runner/Frames_summary.h"
#include "scenario_runner/space/Motion_run_3.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

namespace run {

// The settings of a run in space.
struct Run_subject_3
{
  std::string scenario;
  Policy_choice policy;
  unsigned threads;
  std::optional<double> time_step;
  std::optional<std::uint64_t> seed; // where there is chance
  std::optional<std::string> cell;   // the kind, where space is periodic
};

// All frames of a run in space after the first one, in a few numbers.
struct Run_summary_3 : Frames_summary
{
  std::optional<double> unproved_mean;
  std::optional<double> flips_mean;
  std::optional<double> held_mean;
  std::optional<double> relocated_mean;
};

Run_summary_3 summarize(std::size_t points_of_first_frame,
                        const std::vector<Frame_record_3>& records);

// One JSON object, for programs.
void write_report(std::ostream& out, const Run_subject_3& subject, const Run_summary_3& summary);

// For a person.
void write_table(std::ostream& out, const Run_subject_3& subject, const Run_summary_3& summary);

} // namespace run

#endif // SCENARIO_RUNNER_SPACE_RUN_REPORT_3_H

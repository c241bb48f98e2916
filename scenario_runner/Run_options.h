// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SCENARIO_RUNNER_RUN_OPTIONS_H
#define SCENARIO_RUNNER_RUN_OPTIONS_H

#include "scenario_runner/Cells_in_domains.h"
#include "scenario_runner/Method_choice.h"
#include "scenario_runner/Recorded_motion.h"
#include "scenario_runner/Scenario_file.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace run {

// What a person asks for.
struct Run_options
{
  std::string scenario = "dam_break";
  Classifier_choice classifier = classifier_choice("circumcircle");
  std::optional<std::string> repair{};
  Policy_choice policy = policy_choice("always_dynamic");
  std::string engine = engine_names().front();
  unsigned padding = 1;
  unsigned threads = 1;
  std::optional<std::size_t> frames{};
  std::optional<int> dimension{};
  scenario::Overrides overrides{};
  scenario::Table_columns columns{};
  std::optional<std::string> report{};
  std::optional<std::string> csv{};
  std::optional<std::string> svg{};
  std::optional<std::string> html{};
  std::optional<std::string> vtk{};
  std::optional<std::string> xyz{};
  std::optional<std::string> lammps{};
  std::optional<std::string> cells{};
  std::optional<double> radius{};
  std::optional<std::string> domain{};
  std::optional<Cell_rule> cell_rule{};
  std::optional<std::size_t> every{};
  bool quiet = false;
  std::vector<std::string> given_for_plane{}; // options that were given, and say nothing of space

  std::string repair_name() const { return repair.value_or(usual_repair(classifier)); }
};

// Nothing after --help and --version, which it prints. Throws std::exception for a mistake. The
// parser's header, which takes a compiler seconds, is read in one file only.
std::optional<Run_options> parse_options(int argc, const char* const* argv);

} // namespace run

#endif // SCENARIO_RUNNER_RUN_OPTIONS_H

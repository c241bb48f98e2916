// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef THESIS_THESIS_OPTIONS_H
#define THESIS_THESIS_OPTIONS_H

#include "../results/Command.h"
#include "Experiments.h"
#include "scenario_runner/Text_input.h"
#include "Settings.h"

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

namespace thesis {

inline std::vector<std::string> experiment_names()
{
  std::vector<std::string> names;
  for (const auto& experiment : all_experiments({})) {
    names.push_back(experiment->name());
  }
  return names;
}

// \throws CLI::Success for --help, another CLI::ParseError for a mistake.
inline Settings parse_settings(CLI::App& app, int argc, const char* const* argv)
{
  Settings settings;
  settings.output = RESULTS_DIR "/thesis";
  settings.command = results::command_of("thesis", argc, argv);
  app.description("Runs the experiments of the thesis, and those that it lacks.");
  app.add_flag("--quick", settings.is_quick, "fewer trials, scenarios and values: five minutes");
  app.add_option("--trials", settings.trials, "each with a jitter of its own; default 10")
      ->check(CLI::Range(1, 1000));
  app.add_option("--seed", settings.seed, "of the first trial; default 1");
  app.add_option("--only", settings.only,
                 "these experiments: " + scenario::joined(experiment_names()))
      ->check(CLI::IsMember(experiment_names()));
  app.add_option("--output", settings.output, "the directory that results are written to")
      ->type_name("DIR");
  app.parse(argc, argv);
  return settings;
}

} // namespace thesis

#endif // THESIS_THESIS_OPTIONS_H

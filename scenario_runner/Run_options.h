// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SCENARIO_RUNNER_RUN_OPTIONS_H
#define SCENARIO_RUNNER_RUN_OPTIONS_H

#include "scenario_runner/Classifiers.h"
#include "scenario_runner/Command_line.h"
#include "scenario_runner/Number_text.h"
#include "scenario_runner/Open_motion.h"
#include "scenario_runner/Repairs_and_policies.h"
#include "scenario_runner/Text_input.h"

#include <CLI/CLI.hpp>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <system_error>
#include <utility>
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
  scenario::Overrides overrides{};
  std::optional<std::string> report{};
  std::optional<std::string> csv{};
  std::optional<std::string> svg{};
  std::optional<std::string> vtk{};
  std::optional<std::string> xyz{};
  std::optional<std::string> lammps{};
  std::optional<std::size_t> every{};
  bool quiet = false;

  std::string repair_name() const { return repair.value_or(usual_repair(classifier)); }
};

inline scenario::Packing packing_argument(const std::string& text)
{
  if (text != "square" && text != "hexagonal") {
    throw std::invalid_argument("there is no packing '" + text + "'; there are square, hexagonal");
  }
  return text == "square" ? scenario::Packing::square : scenario::Packing::hexagonal;
}

inline void add_method_options(CLI::App& app, Run_options& options)
{
  constexpr unsigned max_padding = 100;
  constexpr unsigned max_threads = 1024;
  add_option(app, "--classifier", "NAME[:PARAMETER]",
             "what finds the vertices to mend: " + classifier_list() + "; default circumcircle",
             [&](const std::string& text) { options.classifier = classifier_choice(text); });
  add_option(app, "--padding", "N", "layers of neighbors around the classified vertices; default 1",
             [&](const std::string& text) {
               options.padding = static_cast<unsigned>(count_argument(text, 0, max_padding));
             });
  add_option(
      app, "--repair", "NAME",
      "what mends: " + scenario::joined(repair_names()) +
          "; default flip_and_splice, with a heuristic classifier but nearly_delaunay splice",
      [&](const std::string& text) {
        check_repair_name(text);
        options.repair = text;
      });
  add_option(app, "--policy", "NAME[:PARAMETER]",
             "which frames are rebuilt instead: " + policy_list() + "; default always_dynamic",
             [&](const std::string& text) { options.policy = policy_choice(text); });
  add_option(app, "--engine", "NAME",
             "what triangulates anew, everything or a region: " + scenario::joined(engine_names()) +
                 "; default " + options.engine,
             [&](const std::string& text) {
               engines_named(text); // throws
               options.engine = text;
             });
  add_option(app, "--threads", "N", "threads of the circumcircle classifier; default 1",
             [&](const std::string& text) {
               options.threads = static_cast<unsigned>(count_argument(text, 1, max_threads));
             });
}

constexpr std::size_t max_frames = 1'000'000'000;

inline void add_motion_options(CLI::App& app, Run_options& options)
{
  add_option(
      app, "--frames", "N", "frames after the first one; default what the scenario says",
      [&](const std::string& text) { options.frames = count_argument(text, 0, max_frames); });
  add_option(app, "--points", "N", "points that the scenario is scaled to",
             [&](const std::string& text) {
               options.overrides.points = count_argument(text, 1, scenario::max_points);
             });
  add_option(app, "--time-step", "F",
             "motion between two frames; small ones are the favorable ones",
             [&](const std::string& text) {
               options.overrides.time_step =
                   number_argument(text, scenario::positive_up_to(scenario::largest_time_step));
             });
  add_option(app, "--packing", "NAME", "first places of the points: square, hexagonal",
             [&](const std::string& text) { options.overrides.packing = packing_argument(text); });
  add_option(app, "--seed", "N", "seed of the scenario and of the random classifier",
             [&](const std::string& text) {
               options.overrides.seed =
                   count_argument(text, 0, (std::numeric_limits<std::uint64_t>::max)());
             });
}

inline void add_output_options(CLI::App& app, Run_options& options)
{
  const auto take_into = [](std::optional<std::string>& target) {
    return [&target](const std::string& text) { target = text; };
  };
  add_option(app, "--report", "FILE.json", "write what came out, as one JSON object",
             take_into(options.report));
  add_option(app, "--csv", "FILE.csv", "write a row for each frame", take_into(options.csv));
  add_option(app, "--svg", "DIR",
             "draw about 30 frames: classified vertices red, padded green, border cyan; "
             "index.html shows them one after another",
             take_into(options.svg));
  add_option(app, "--vtk", "DIR",
             "write about 30 frames for ParaView: triangles in .vtu files, all times in frames.pvd",
             take_into(options.vtk));
  add_option(app, "--xyz", "FILE.xyz", "write the points of all frames as extended XYZ",
             take_into(options.xyz));
  add_option(app, "--lammps", "FILE.lammpstrj",
             "write the points of all frames as a LAMMPS dump, which can be run again",
             take_into(options.lammps));
  add_option(app, "--every", "N",
             "every N-th frame and the last one for --svg, --vtk, --xyz and --lammps",
             [&](const std::string& text) { options.every = count_argument(text, 1, max_frames); });
  app.add_flag("--quiet", options.quiet, "no progress, no table");
}

inline bool is_one_file(const std::filesystem::path& a, const std::filesystem::path& b)
{
  std::error_code ignored;
  return a.lexically_normal() == b.lexically_normal() || std::filesystem::equivalent(a, b, ignored);
}

// A file that two outputs write would hold one of them; one that is the recording would replace it.
inline void check_files(const Run_options& options)
{
  std::vector<std::pair<std::string, std::string>> files;
  std::error_code ignored;
  if (std::filesystem::is_regular_file(options.scenario, ignored)) {
    files.emplace_back("SCENARIO", options.scenario);
  }
  for (const auto& [name, file] :
       {std::pair("--report", options.report), std::pair("--csv", options.csv),
        std::pair("--xyz", options.xyz), std::pair("--lammps", options.lammps)}) {
    if (!file) {
      continue;
    }
    for (const auto& [other_name, other_file] : files) {
      if (is_one_file(*file, other_file)) {
        throw CLI::ValidationError(name, "is the file of " + other_name + " too");
      }
    }
    files.emplace_back(name, *file);
  }
}

inline void check_every(const Run_options& options)
{
  if (options.every && !options.svg && !options.vtk && !options.xyz && !options.lammps) {
    throw CLI::ValidationError("--every", "chooses frames for --svg, --vtk, --xyz or --lammps, "
                                          "and none of them is there");
  }
}

// \throws CLI::Success for --help and --version, another CLI::ParseError for a mistake.
inline Run_options parse_options(CLI::App& app, int argc, const char* const* argv)
{
  Run_options options;
  app.description("Runs a scenario, keeps its Delaunay triangulation, checks every frame, and "
                  "compares the time with fresh triangulations.");
  app.add_option("SCENARIO", options.scenario,
                 "a scenario; or a " + scenario::motion_extensions +
                     " file, also followed by .gz; or - for CSV from standard input; default "
                     "dam_break")
      ->type_name("");
  add_method_options(app, options);
  add_motion_options(app, options);
  add_output_options(app, options);
  app.set_version_flag("--version", "run_scenario 1.0");
  app.footer("Scenarios: " + scenario::joined(scenario::known_scenarios()) +
             "\nHow to write one, and which recordings are read: "
             "doc/Dynamic_Delaunay_triangulation_2/Scenario_files.txt");
  app.parse(argc, argv);
  check_files(options);
  check_every(options);
  return options;
}

} // namespace run

#endif // SCENARIO_RUNNER_RUN_OPTIONS_H

// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ROBUSTNESS_ROBUSTNESS_OPTIONS_H
#define ROBUSTNESS_ROBUSTNESS_OPTIONS_H

#include "Arithmetic.h"
#include "Families.h"
#include "scenario_runner/Command_line.h"
#include "scenario_runner/Number_text.h"
#include "scenario_runner/Text_input.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <thread>

namespace robustness {

// What a person asks for.
struct Robustness_options
{
  std::uint64_t operations = 10'000'000;
  std::uint64_t seed = 1;
  unsigned threads = (std::max)(1u, std::thread::hardware_concurrency());
  double time_limit = 20.0; // seconds
  std::optional<std::uint64_t> trial{};
  std::optional<std::size_t> family{};
  std::optional<std::string> report{};
  Arithmetic arithmetic{};
};

// \throws CLI::Success for --help, another CLI::ParseError for a mistake.
inline Robustness_options parse_options(CLI::App& app, int argc, const char* const* argv)
{
  constexpr std::uint64_t any = (std::numeric_limits<std::uint64_t>::max)();
  constexpr std::uint64_t max_operations = 1'000'000'000'000, max_threads = 1024;
  constexpr double max_time_limit = 1e6;
  using run::add_option;
  Robustness_options options;
  app.description("Does random things to triangulations, and compares them with fresh ones of "
                  "CGAL's after each of them.");
  add_option(app, "--operations", "N", "how many, of all families; default 10000000",
             [&](const std::string& text) {
               options.operations = run::count_argument(text, 1, max_operations);
             });
  add_option(app, "--seed", "N", "what everything is drawn from; default 1",
             [&](const std::string& text) { options.seed = run::count_argument(text, 0, any); });
  add_option(app, "--threads", "N",
             "which nothing that is counted depends on; default as many as the machine has",
             [&](const std::string& text) {
               options.threads = static_cast<unsigned>(run::count_argument(text, 1, max_threads));
             });
  add_option(app, "--family", "NAME", "this one only",
             [&](const std::string& text) { options.family = family_named(text); });
  add_option(app, "--trial", "SEED", "repeat one trial, with --family as it was reported",
             [&](const std::string& text) { options.trial = run::count_argument(text, 0, any); });
  add_option(
      app, "--time_limit", "SECONDS", "an operation that takes longer ends the program; default 20",
      [&](const std::string& text) {
        options.time_limit = run::number_argument(text, scenario::positive_up_to(max_time_limit));
      });
  add_option(app, "--arithmetic", "NAME",
             "what the caller's is: usual (default), upward, downward, toward_zero, "
             "without_subnormals, or trapping",
             [&](const std::string& text) { options.arithmetic = arithmetic_named(text); });
  add_option(app, "--report", "FILE.json", "write what came out, as one JSON object",
             [&](const std::string& text) { options.report = text; });
  app.parse(argc, argv);
  return options;
}

} // namespace robustness

#endif // ROBUSTNESS_ROBUSTNESS_OPTIONS_H

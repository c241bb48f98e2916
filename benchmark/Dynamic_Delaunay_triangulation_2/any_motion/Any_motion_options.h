// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ANY_MOTION_ANY_MOTION_OPTIONS_H
#define ANY_MOTION_ANY_MOTION_OPTIONS_H

#include "Program.h"
#include "scenario_runner/Command_line.h"
#include "scenario_runner/Number_text.h"
#include "scenario_runner/Open_motion.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace any_motion {

// What a person asks for.
struct Any_motion_options
{
  std::vector<std::size_t> chosen_points{};
  std::optional<std::size_t> frames{};
  std::uint64_t seed = 1;
  std::vector<std::string> kinds{};
  std::string only{};
  std::string recorded = scenario::recordings_directory();
  std::optional<std::string> csv{};
  std::optional<Program> program{};
  std::optional<double> adversary{}; // seconds
  std::vector<std::string> left_out{};
  bool is_quick = false;
  bool is_list = false;

  std::vector<std::size_t> points() const
  {
    if (!chosen_points.empty()) {
      return chosen_points;
    }
    return program || adversary ? std::vector<std::size_t>{1'000}
                                : std::vector<std::size_t>{1'000, 10'000, 100'000};
  }

  bool has_kinds() const { return only != "recorded"; }
  bool has_recordings() const { return only == "recorded" || (only.empty() && !is_quick); }

  bool wants(const std::string& kind) const
  {
    return kinds.empty() || std::any_of(kinds.begin(), kinds.end(), [&](const auto& part) {
             return kind.find(part) != std::string::npos;
           });
  }
};

// \throws CLI::Success for --help, another CLI::ParseError for a mistake.
inline Any_motion_options parse_options(CLI::App& app, int argc, const char* const* argv)
{
  constexpr std::uint64_t any = (std::numeric_limits<std::uint64_t>::max)(), max_frames = 100'000;
  constexpr int min_points = 10, max_points = 10'000'000;
  constexpr double longest = 1e6;
  using run::add_option;
  Any_motion_options options;
  app.description("Times updates against the fastest static way, frame by frame, for motions of "
                  "all kinds, and compares what comes out.");
  app.add_option("--points", options.chosen_points, "how many; default 1000 10000 100000")
      ->type_name("N...")
      ->check(CLI::Range(min_points, max_points));
  add_option(
      app, "--frames", "N", "measured ones of each kind; default 16 to 8, of recordings 200",
      [&](const std::string& text) { options.frames = run::count_argument(text, 1, max_frames); });
  add_option(app, "--seed", "N", "what is drawn by chance; default 1",
             [&](const std::string& text) { options.seed = run::count_argument(text, 0, any); });
  app.add_option("--kind", options.kinds, "only kinds with this in their names; may be repeated")
      ->type_name("TEXT")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  app.add_option("--only", options.only, "kinds or recorded; default both")
      ->check(CLI::IsMember({"kinds", "recorded"}));
  app.add_option("--recorded", options.recorded, "where recorded motion is")->type_name("DIR");
  add_option(app, "--csv", "FILE", "write every frame",
             [&](const std::string& text) { options.csv = text; });
  add_option(app, "--program", "TEXT", "run this one, and show its frames",
             [&](const std::string& text) { options.program = program_in(text); });
  add_option(app, "--adversary", "SECONDS", "look for slow programs by chance for so long",
             [&](const std::string& text) {
               options.adversary = run::number_argument(text, scenario::positive_up_to(longest));
             });
  app.add_option("--without", options.left_out,
                 "a motion that the adversary leaves out; may be repeated")
      ->type_name("MOTION")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
      ->check([](const std::string& name) {
        const auto& all = all_motions();
        const bool is_one = std::any_of(all.begin(), all.end(),
                                        [&](const Motion& motion) { return motion.name == name; });
        return is_one ? std::string() : "there is no motion '" + name + "', see --list";
      });
  app.add_flag("--quick", options.is_quick,
               "only check: every frame, nothing is repeated, and no recordings by default");
  app.add_flag("--list", options.is_list, "the kinds and the parts of programs");
  app.parse(argc, argv);
  return options;
}

} // namespace any_motion

#endif // ANY_MOTION_ANY_MOTION_OPTIONS_H

// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PEERS_PEERS_OPTIONS_H
#define PEERS_PEERS_OPTIONS_H

#include <CLI/CLI.hpp>

#include <cstddef>
#include <string>
#include <vector>

namespace peers {

// What a person asks for.
struct Peers_options
{
  std::vector<std::size_t> chosen_points{};
  std::size_t frames = 0; // as many as fit to the number of points
  std::string filter{};
  std::string output = RESULTS_DIR "/peers";
  bool is_large = false;
  bool is_quick = false;

  std::vector<std::size_t> points() const
  {
    if (!chosen_points.empty()) {
      return chosen_points;
    }
    if (is_quick) {
      return {1'000, 10'000};
    }
    return is_large ? std::vector<std::size_t>{1'000, 10'000, 100'000, 1'000'000}
                    : std::vector<std::size_t>{1'000, 10'000, 100'000};
  }
};

// \throws CLI::Success for --help, another CLI::ParseError for a mistake.
inline Peers_options parse_options(CLI::App& app, int argc, const char* const* argv)
{
  constexpr int fewest_points = 10, most_points = 10'000'000, most_frames = 100'000;
  Peers_options options;
  app.description("Times this package and its peers on the same frames, in turn, and compares what "
                  "comes out.");
  app.add_option("--points", options.chosen_points, "how many; default 1000 10000 100000")
      ->type_name("N...")
      ->check(CLI::Range(fewest_points, most_points));
  app.add_option("--frames", options.frames, "timed ones of each motion; default 96 to 4")
      ->type_name("N")
      ->check(CLI::Range(1, most_frames));
  app.add_option("--filter", options.filter, "only motions with this in 'motion/points'")
      ->type_name("TEXT");
  app.add_option("--output", options.output, "where peers.csv goes; default build/dev/bench/peers")
      ->type_name("DIR");
  app.add_flag("--large", options.is_large, "a million points, too");
  app.add_flag("--quick", options.is_quick, "a first look, in less than a minute");
  app.parse(argc, argv);
  return options;
}

} // namespace peers

#endif // PEERS_PEERS_OPTIONS_H

// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PEERS_PEER_CASES_H
#define PEERS_PEER_CASES_H

#include "../common/Teleport_motion.h"
#include "Grid_motion.h"
#include "scenario_runner/Open_motion.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
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

// One motion of `points` points. First `passed_over` frames are skipped, then peers warm up for
// `warm_up` frames, then `frames` successive frames are timed.
struct Peer_case
{
  std::string motion;
  std::size_t points;
  std::function<std::unique_ptr<scenario::Motion>()> open;
  bool has_lasting_order; // whether the last frame's order in space is of use in this one
  std::size_t passed_over;
  std::size_t warm_up;
  std::size_t frames;

  std::string name() const { return motion + '/' + std::to_string(points); }

  // The work of a case, roughly, in updates of one point by all peers.
  std::size_t work() const { return points * (warm_up + frames) + passed_over_work(passed_over); }
  std::size_t passed_over_work(std::size_t number) const { return points * number / 64; }
};

inline std::unique_ptr<scenario::Motion> open_scenario(const std::string& name, std::size_t points,
                                                       std::optional<double> time_step)
{
  scenario::Overrides overrides;
  overrides.points = points;
  overrides.time_step = time_step;
  return scenario::open_motion(scenario::scenario_file(name), overrides);
}

// The number of timed frames, where possible a multiple of the number of peers, whose order
// rotates. For fresh clouds half as many are enough: each is like the others, and CGAL's moves take
// long.
inline std::size_t usual_frames(std::size_t points, bool has_lasting_order, bool is_quick)
{
  const std::size_t frames = points <= 1'000     ? 96
                             : points <= 10'000  ? 32
                             : points <= 100'000 ? 16
                                                 : 4;
  const std::size_t share = (has_lasting_order ? 1 : 2) * (is_quick ? 4 : 1);
  return (std::max)(frames / share, std::size_t(1));
}

inline std::size_t usual_warm_up(std::size_t points)
{
  return points <= 1'000 ? 16 : points <= 10'000 ? 4 : points <= 100'000 ? 2 : 1;
}

// All cases that were asked for.
inline std::vector<Peer_case> peer_cases(const Peers_options& options)
{
  std::vector<Peer_case> cases;
  for (const std::size_t points : options.points()) {
    const auto add = [&](const std::string& motion, std::size_t passed_over, bool has_lasting_order,
                         std::function<std::unique_ptr<scenario::Motion>()> open) {
      const std::size_t frames = options.frames != 0
                                     ? options.frames
                                     : usual_frames(points, has_lasting_order, options.is_quick);
      Peer_case added{
          motion, points, std::move(open), has_lasting_order, passed_over, usual_warm_up(points),
          frames};
      if (added.name().find(options.filter) != std::string::npos) {
        cases.push_back(std::move(added));
      }
    };
    for (const char* const step : {"0.0001", "0.001", "0.01", "0.1"}) {
      add(std::string("brownian_") + step, 0, true,
          [=] { return open_scenario("brownian", points, std::stod(step)); });
    }
    // After these frames the water falls and the bodies have met, at every size: lengths and
    // durations grow with the root of the number of points.
    const auto passed_over =
        static_cast<std::size_t>(60.0 * std::sqrt(static_cast<double>(points) / 1000.0));
    for (const char* const name : {"dam_break", "explosion"}) {
      add(name, passed_over, true, [=] { return open_scenario(name, points, std::nullopt); });
    }
    add("teleport", 0, false, [=] { return std::make_unique<common::Teleport_motion>(points); });
  }
  return cases;
}

} // namespace peers

#endif // PEERS_PEER_CASES_H

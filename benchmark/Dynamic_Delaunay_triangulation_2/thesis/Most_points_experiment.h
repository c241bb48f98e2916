// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef THESIS_MOST_POINTS_EXPERIMENT_H
#define THESIS_MOST_POINTS_EXPERIMENT_H

#include "../common/Csv_file.h"
#include "Experiment.h"
#include "Most_points_search.h"
#include "scenario_runner/Frame_record.h"
#include "scenario_runner/Measurement.h"
#include "scenario_runner/Scenario_file.h"
#include "Trial.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace thesis {

// A trial and a contestant, and the largest number of points found in each repetition.
struct Most_points_case
{
  Trial trial;
  std::string contestant;         // the name of the method, or of a static opponent
  double run::Frame_times::*time; // of the triangulation whose frames have to fit
  std::vector<Frame_milliseconds> found{};

  bool is_static() const { return time != &run::Frame_times::dynamic; }
};

// The largest number of points under 40 ms a frame (thesis, figure 5.11).
class Most_points_experiment : public Repeated_experiment<Most_points_case>
{
public:
  // `work`: points times frames that a try may follow; at least `least_frames`.
  Most_points_experiment(std::string name, const Settings& settings, std::size_t usual_trials,
                         std::size_t work)
    : Repeated_experiment(std::move(name), settings, usual_trials)
    , m_work(work)
  {
  }

  void add(const std::string& scenario, const Method& method)
  {
    add_case({{scenario, method}, method_name(method), &run::Frame_times::dynamic});
  }

  // The static opponents, on the motion that the method drives.
  void add_static(const std::string& scenario, const Method& method)
  {
    add_case({{scenario, method}, "static_insert", &run::Frame_times::static_insert});
    add_case({{scenario, method}, "static_fastest", &run::Frame_times::static_fastest});
  }

  void write(const std::filesystem::path& directory,
             const std::vector<std::string>& remarks) const override
  {
    common::Csv_file file(
        directory / (name() + ".csv"), remarks,
        {"scenario", "method", "trial", "points", "upper_quartile_ms", "median_ms", "frames"});
    for (const Most_points_case& one : cases()) {
      for (std::size_t trial = 0; trial != one.found.size(); ++trial) {
        const Frame_milliseconds& times = one.found[trial];
        file.write_row(one.trial.scenario, one.contestant, trial + 1, times.points,
                       times.upper_quartile, times.median, times.frames);
      }
    }
    file.finish();
  }

private:
  double seconds_of(const Most_points_case&) const override
  {
    return 12.0 + 5.0e-7 * static_cast<double>(m_work);
  }

  // Trials after the first one begin their search at its result.
  void run(Most_points_case& one, std::uint64_t seed) const override
  {
    constexpr std::size_t first_try = 150'000, least_first_try = 1000;
    Trial trial = one.trial;
    trial.seed = seed;
    const std::size_t first = one.found.empty() ? first_try : one.found.front().points;
    Most_points_search search(std::max<std::size_t>(first, least_first_try), scenario::max_points);
    one.found.push_back(search.run([&](std::size_t points) {
      trial.points = points;
      return measure(trial, one);
    }));
  }

  // Frames are spread over as much of the scenario as the work allows.
  Frame_milliseconds measure(const Trial& trial, const Most_points_case& one) const
  {
    constexpr std::size_t samples = 10, least_frames = 20;
    const auto motion = open(trial);
    const std::size_t points = motion->points().size();
    const std::size_t frames =
        std::clamp(m_work / points, least_frames, (std::max)(least_frames, motion->frames()));
    std::vector<double> milliseconds;
    const auto counts = [&](std::size_t frame) {
      return frame * samples / frames != (frame - 1) * samples / frames;
    };
    with_run(trial, *motion, [&](auto& run) {
      while (run.record().frame != frames) {
        const std::size_t frame = run.record().frame + 1;
        if (!one.is_static()) {
          run.follow(false);
        } else if (counts(frame)) {
          run.measure();
        } else {
          run.follow(counts(frame + 1));
        }
        if (counts(frame)) {
          milliseconds.push_back(1e-6 * (run.record().nanoseconds.*one.time));
        }
      }
    });
    const run::Spread spread = *run::spread(milliseconds);
    return {points, frames, spread.median, spread.high_quartile};
  }

  std::size_t m_work;
};

} // namespace thesis

#endif // THESIS_MOST_POINTS_EXPERIMENT_H

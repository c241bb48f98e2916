// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The experiments of the thesis (chapter 5, and 6.2.5), and others that it lacks: every classifier
// next to the exact default, both static opponents, and the simulation as judge (6.2.3).
//
// As in the thesis each trial is a simulation of its own, with a jitter of its own, driven by the
// triangulation that is tried; trials are repeated with seeds 1, 2, ... Where samples are taken,
// the update and both static triangulations of the same frame are timed in turn, and the result is
// compared with a fresh triangulation, ties counting as right. The time is the triangulation's
// alone. Results are CSV files, one or more for each experiment:
//
//   scenario, method    the classifier, with /REPAIR or /POLICY where it is not the usual one
//   points, time_step   of the scenario
//   trials, frames      number of trials, and frames of each after the first one
//   frame, time         of the last sample of a part of the frames
//   samples             frames that were timed against the opponents
//   validity            Matthews correlation coefficient: mean, smallest, largest
//   dynamic             ns a point: median and quartiles over the samples
//   over_insert, over_fastest    speedups: the same
//   insert, fastest     the opponents' ns a point: median
//   dynamic_mean        ns a point: mean over all frames, of which the samples are a part
//   classified, flips, rebuilt   a frame: means over all frames
//   kinetic, energy, center_x, center_y, front    of the particles: mean, smallest, largest
// The columns of classification.csv are explained at the top of classifiers.cpp. In
// most_points.csv three of four timed frames took up to upper_quartile_ms; the last timed frame has
// the number `frames`.

#include "common/Program.h"
#include "common/Statistics.h"
#include "scenario_runner/Progress.h"
#include "thesis/Experiments.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <exception>
#include <filesystem>
#include <iostream>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace thesis;

std::vector<std::string> experiment_names()
{
  std::vector<std::string> names;
  for (const auto& experiment : all_experiments({})) {
    names.push_back(experiment->name());
  }
  return names;
}

void add_options(CLI::App& app, Settings& settings)
{
  app.description("Runs the experiments of the thesis, and those that it lacks.");
  app.add_flag("--quick", settings.is_quick, "fewer trials, scenarios and values: five minutes");
  app.add_option("--trials", settings.trials, "each with a jitter of its own; default 10")
      ->check(CLI::Range(1, 1000));
  app.add_option("--seed", settings.seed, "of the first trial; default 1");
  app.add_option("--only", settings.only, "these experiments; default all")
      ->check(CLI::IsMember(experiment_names()));
  common::add_option(app, "--output", settings.output, "DIR",
                     "the directory that results are written to");
}

struct Planned_experiment
{
  std::unique_ptr<Experiment> experiment;
  std::vector<Job> jobs;

  double seconds() const { return common::sum(common::values_of(jobs, &Job::seconds)); }
};

std::vector<Planned_experiment> plan(const Settings& settings)
{
  std::vector<Planned_experiment> planned;
  for (std::unique_ptr<Experiment>& experiment : all_experiments(settings)) {
    const auto& only = settings.only;
    if (only.empty() || std::find(only.begin(), only.end(), experiment->name()) != only.end()) {
      std::vector<Job> jobs = experiment->jobs();
      planned.push_back({std::move(experiment), std::move(jobs)});
    }
  }
  return planned;
}

bool run_experiments(const Settings& settings, const std::string& command)
{
  using Clock = std::chrono::steady_clock;
  const std::vector<Planned_experiment> planned = plan(settings);
  const double seconds = common::sum(common::values_of(planned, &Planned_experiment::seconds));
  const double minutes = std::ceil(seconds / 60.0);
  std::cout << "About " << minutes << (minutes == 1.0 ? " minute\n" : " minutes\n") << std::flush;
  std::filesystem::create_directories(settings.output);
  double done = 0.0;
  for (const Planned_experiment& one : planned) {
    const Clock::time_point start = Clock::now();
    {
      run::Progress_display progress(static_cast<std::size_t>(std::ceil(seconds)), true,
                                     one.experiment->name().c_str());
      for (const Job& job : one.jobs) {
        job.work();
        done += job.seconds;
        progress.show(static_cast<std::size_t>(done));
      }
    }
    one.experiment->write(settings.output, {"command: " + command});
    std::cout << one.experiment->name() << ": "
              << std::round(std::chrono::duration<double>(Clock::now() - start).count()) << " s, "
              << one.jobs.size() << " jobs\n"
              << std::flush;
  }
  std::cout << "Results: " << settings.output.string() << '\n';
  return true;
}

} // namespace

int main(int argc, char** argv)
{
  return common::run_program<Settings>("thesis", argc, argv, add_options, run_experiments);
}

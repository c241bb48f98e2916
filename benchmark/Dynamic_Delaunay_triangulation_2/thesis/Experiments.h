// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef THESIS_EXPERIMENTS_H
#define THESIS_EXPERIMENTS_H

#include "Classification_experiment.h"
#include "Experiment.h"
#include "Frame_experiment.h"
#include "Most_points_experiment.h"
#include "scenario_runner/Open_motion.h"
#include "scenario_runner/Scenario_file.h"
#include "Trial.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <string>
#include <variant>
#include <vector>

namespace thesis {

using Experiments = std::vector<std::unique_ptr<Experiment>>;

// The number of trials in the thesis (5.1.2).
constexpr std::size_t usual_trials = 10;

// The number of trials where a million points take long to simulate, also in the thesis (6.2.1):
// for the largest number of points, and for the cost by number of points.
constexpr std::size_t few_trials = 2;

inline std::size_t trials_of(const Settings& settings, std::size_t quick_trials = 1)
{
  return settings.is_quick ? quick_trials : usual_trials;
}

inline std::vector<std::string> square_scenarios()
{
  return {"dam_break", "spinning", "explosion", "static"};
}

// The thesis does not say how its bodies are packed.
inline std::vector<std::string> all_scenarios(const Settings& settings)
{
  std::vector<std::string> names = square_scenarios();
  if (!settings.is_quick) {
    for (const std::string& name : square_scenarios()) {
      names.push_back(name + "_hexagonal");
    }
  }
  return names;
}

inline Method method_with(const std::string& classifier, const std::string& repair)
{
  Method method = classifiers::method(classifier);
  method.repair = repair;
  return method;
}

inline Method method_with_policy(const std::string& classifier, const std::string& policy)
{
  Method method = classifiers::method(classifier);
  method.policy = run::policy_choice(policy);
  return method;
}

// The exact default first, then the thesis's circumcircle classifier with its border splice, then
// all other classifiers. Of the random one the thesis shows two sides: hardly any and
// nearly all vertices are triangulated.
inline std::vector<Method> all_methods()
{
  std::vector<Method> methods = {classifiers::method("circumcircle"),
                                 method_with("circumcircle", "splice")};
  for (const char* const name :
       {"safe_region", "point_distance:0.7", "inflation_aware:0.7", "voronoi_circumcenter",
        "voronoi_circumcenter_estimated", "voronoi_edge_length:1", "nearly_delaunay:0.05",
        "random:0.0025", "random:0.1", "refined:point_distance:0.9+voronoi_circumcenter"}) {
    methods.push_back(classifiers::method(name));
  }
  return methods;
}

inline std::vector<Method> exact_and_point_distance()
{
  return {classifiers::method("circumcircle"), classifiers::method("point_distance:0.7")};
}

inline std::size_t frames_of(const std::string& scenario)
{
  return scenario::read_scenario_file(scenario::scenario_file(scenario)).frames;
}

inline std::vector<double> evenly_spaced(double last, std::size_t steps)
{
  std::vector<double> values;
  for (std::size_t i = 0; i <= steps; ++i) {
    values.push_back(last * static_cast<double>(i) / static_cast<double>(steps));
  }
  return values;
}

// Validity and speedup over time, each classifier on each scenario: figures 5.5, 5.7 and 5.10.
inline std::unique_ptr<Experiment> over_time(const Settings& settings)
{
  auto experiment =
      std::make_unique<Frame_experiment>("over_time", settings, trials_of(settings, 2));
  const std::size_t bins = settings.is_quick ? 15 : 40;
  for (const std::string& scenario : all_scenarios(settings)) {
    for (const Method& method : all_methods()) {
      experiment->add({scenario, method}, {frames_of(scenario), 2 * bins, bins});
    }
  }
  return experiment;
}

inline void add_surface(const std::string& scenario, const std::string& classifier,
                        const std::vector<double>& parameters, std::size_t samples,
                        Frame_experiment& experiment)
{
  constexpr std::size_t bins = 25;
  for (const double parameter : parameters) {
    const Method method = classifiers::method(classifier + ':' + common::csv_cell(parameter));
    experiment.add({scenario, method}, {frames_of(scenario), samples, bins});
  }
}

// Point distance by its parameter, on the dam break: figure 5.6, and the simulation as judge
// (6.2.3) beside the exact one.
inline std::unique_ptr<Experiment> point_distance(const Settings& settings)
{
  auto experiment =
      std::make_unique<Frame_experiment>("point_distance", settings, trials_of(settings, 2));
  std::vector<std::string> scenarios = {"dam_break"};
  if (!settings.is_quick) {
    scenarios.push_back("dam_break_hexagonal");
  }
  for (const std::string& scenario : scenarios) {
    experiment->add({scenario, classifiers::method("circumcircle")},
                    {frames_of(scenario), 100, 25});
    add_surface(scenario, "point_distance", evenly_spaced(1.0, settings.is_quick ? 5 : 20), 100,
                *experiment);
  }
  return experiment;
}

// The random classifier by its parameter, on the dam break: figures 5.8 and 5.9.
inline std::unique_ptr<Experiment> random(const Settings& settings)
{
  auto experiment = std::make_unique<Frame_experiment>("random", settings, trials_of(settings));
  const std::size_t steps = settings.is_quick ? 5 : 10;
  const std::size_t samples = settings.is_quick ? 25 : 50;
  add_surface("dam_break", "random", evenly_spaced(0.005, steps), samples, *experiment);
  std::vector<double> large = evenly_spaced(1.0, steps);
  large.erase(large.begin()); // among the small ones
  add_surface("dam_break", "random", large, samples, *experiment);
  return experiment;
}

// Steps up to the largest stable one, each over the whole scenario: figure 6.1.
inline std::unique_ptr<Experiment> time_step(const Settings& settings)
{
  auto experiment = std::make_unique<Frame_experiment>("time_step", settings, trials_of(settings));
  for (const std::string& name : square_scenarios()) {
    const scenario::Scenario_description description =
        scenario::read_scenario_file(scenario::scenario_file(name));
    const auto& particles = std::get<scenario::Particle_description>(description.kind);
    const double duration = static_cast<double>(description.frames) * particles.time_step;
    std::vector<double> steps = {0.1, 0.3, *particles.largest_stable_time_step};
    if (!settings.is_quick) {
      steps.insert(steps.end(), {0.03, 0.05, 0.2, 0.45});
      std::sort(steps.begin(), steps.end());
    }
    for (const double step : steps) {
      for (const Method& method : exact_and_point_distance()) {
        const auto frames = static_cast<std::size_t>(std::round(duration / step));
        experiment->add({name, method, 1, {}, step}, {frames, 50, 1});
      }
    }
  }
  return experiment;
}

// The largest number of points under 40 ms a frame: figure 5.11, and both static ways beside it.
inline std::unique_ptr<Experiment> most_points(const Settings& settings)
{
  const std::size_t trials = settings.is_quick ? 1 : few_trials;
  const std::size_t work = settings.is_quick ? 2'000'000 : 20'000'000;
  auto experiment = std::make_unique<Most_points_experiment>("most_points", settings, trials, work);
  std::vector<std::string> scenarios = square_scenarios();
  if (settings.is_quick) {
    scenarios = {"dam_break"};
  }
  for (const std::string& scenario : scenarios) {
    for (const Method& method : settings.is_quick ? exact_and_point_distance() : all_methods()) {
      experiment->add(scenario, method);
    }
    experiment->add_static(scenario, classifiers::method("circumcircle"));
  }
  return experiment;
}

// What classifiers find of what the motion broke.
inline std::unique_ptr<Experiment> classification(const Settings& settings)
{
  const std::size_t frames = settings.is_quick ? 200 : 1000;
  auto experiment = std::make_unique<Classification_experiment>("classification", settings,
                                                                trials_of(settings), frames);
  for (const std::string& scenario : square_scenarios()) {
    experiment->add(scenario, all_methods());
  }
  return experiment;
}

// Cost from a thousand points to a million.
inline std::unique_ptr<Experiment> points(const Settings& settings)
{
  auto experiment =
      std::make_unique<Frame_experiment>("points", settings, settings.is_quick ? 1 : few_trials);
  std::vector<std::size_t> numbers = {1000, 10'000, 100'000};
  if (!settings.is_quick) {
    numbers = {1000, 3000, 10'000, 30'000, 100'000, 300'000, 1'000'000};
  }
  for (const std::size_t number : numbers) {
    const std::size_t frames = std::clamp<std::size_t>(1'000'000 / number, 6, 100);
    for (const Method& method : exact_and_point_distance()) {
      experiment->add({"brownian", method, 1, number, 0.001}, {frames, frames, 1, false});
      experiment->add({"brownian", method, 1, number, 0.01}, {frames, frames, 1, false});
      experiment->add({"dam_break", method, 1, number, {}}, {frames, frames, 1, false});
    }
  }
  return experiment;
}

// Cost by motion, from hardly any to so much that nothing of the old triangulation is left.
inline std::unique_ptr<Experiment> motion(const Settings& settings)
{
  auto experiment = std::make_unique<Frame_experiment>("motion", settings, trials_of(settings));
  constexpr std::size_t number = 10'000, frames = 20;
  for (const double step :
       {1e-5, 3e-5, 1e-4, 3e-4, 1e-3, 3e-3, 1e-2, 2e-2, 3e-2, 5e-2, 0.1, 0.3, 1.0}) {
    std::vector<Method> methods = exact_and_point_distance();
    methods.push_back(method_with_policy("circumcircle", "hybrid"));
    for (const Method& method : methods) {
      experiment->add({"brownian", method, 1, number, step}, {frames, frames, 1});
    }
  }
  return experiment;
}

// In the order in which they run.
inline Experiments all_experiments(const Settings& settings)
{
  Experiments experiments;
  for (const auto make : {over_time, point_distance, random, time_step, classification, points,
                          motion, most_points}) {
    experiments.push_back(make(settings));
  }
  return experiments;
}

} // namespace thesis

#endif // THESIS_EXPERIMENTS_H

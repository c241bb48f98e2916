// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef THESIS_TRIAL_H
#define THESIS_TRIAL_H

#include "../classifiers/Classifier_run.h"
#include "scenario_runner/Open_motion.h"
#include "scenario_runner/Repairs_and_policies.h"
#include "scenario_runner/Scenario_run.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <type_traits>

namespace thesis {

using classifiers::Method;

// A motion that is driven by a method's own triangulation, as in the thesis (5.1.2).
struct Trial
{
  std::string scenario;
  Method method;
  std::uint64_t seed = 1; // of the jitter and of chance in the method
  std::optional<std::size_t> points{};
  std::optional<double> time_step{};
};

inline std::unique_ptr<scenario::Motion> open(const Trial& trial)
{
  scenario::Overrides overrides;
  overrides.points = trial.points;
  overrides.time_step = trial.time_step;
  overrides.seed = trial.seed;
  return scenario::open_motion(scenario::scenario_file(trial.scenario), overrides);
}

// Calls `use(run)` with the run of the trial at its first frame, on one thread.
template <class Use>
void with_run(const Trial& trial, scenario::Motion& motion, Use use)
{
  Method method = trial.method;
  method.seed = trial.seed;
  run::Threads(1).execute([&] {
    run::Scenario_run<run::Any_classifier> run(motion, classifiers::make_classifier(method),
                                               run::make_repair(method.repair, method.padding),
                                               CGAL::Static_engines_2(),
                                               run::make_policy(method.policy));
    use(run);
  });
}

// "circumcircle", "circumcircle/splice", "circumcircle/hybrid": with repair and policy where they
// are not the usual ones.
inline std::string method_name(const classifiers::Method& method)
{
  std::string name = method.classifier.text();
  if (method.repair != run::usual_repair(method.classifier)) {
    name += '/' + method.repair;
  }
  return method.policy.name == "always_dynamic" ? name : name + '/' + method.policy.name;
}

} // namespace thesis

#endif // THESIS_TRIAL_H

// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef RUN_RUN_SUBJECT_H
#define RUN_RUN_SUBJECT_H

#include "../scenario/Motion.h"
#include "Run_options.h"
#include "Scenario_choice.h"

#include <cstdint>
#include <optional>
#include <string>

namespace run {

// What ran, with all defaults filled in.
struct Run_subject
{
  std::string scenario;
  Classifier_choice classifier;
  std::string repair;
  Policy_choice policy;
  unsigned padding;
  std::string engine;
  unsigned threads;
  std::optional<double> time_step;
  std::optional<std::uint64_t> seed; // where there is chance
  std::optional<scenario::Packing> packing;
};

inline Run_subject run_subject(const Run_options& options, const scenario::Motion& motion,
                               const Scenario_facts& facts)
{
  const bool is_random = facts.seed || options.classifier.uses_chance();
  const std::uint64_t seed = options.overrides.seed.value_or(facts.seed.value_or(0));
  return {motion.name(),
          options.classifier,
          options.repair_name(),
          options.policy,
          options.padding,
          options.engine,
          options.threads,
          motion.time_step(),
          is_random ? std::optional(seed) : std::nullopt,
          options.overrides.packing ? options.overrides.packing : facts.packing};
}

} // namespace run

#endif // RUN_RUN_SUBJECT_H

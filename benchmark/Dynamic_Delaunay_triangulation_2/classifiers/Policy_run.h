// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CLASSIFIERS_POLICY_RUN_H
#define CLASSIFIERS_POLICY_RUN_H

#include "Classifier_run.h"
#include "Recorded_scenario.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <memory>
#include <numeric>
#include <random>
#include <string>
#include <vector>

namespace classifiers {

// What a policy took on a recording, with the default classifier and repair.
struct Policy_record
{
  std::vector<double> nanoseconds{}; // of each frame, the fastest of all passes
  double rebuilds = 0.0;
};

// All policies on the same frames, in an order that changes at random: whoever comes after a
// rebuild finds the caches full of it. Every frame has to be certified.
inline void run_pass(const Recorded_frames& recording, const std::vector<std::string>& policies,
                     std::mt19937& random, std::vector<Policy_record>& records)
{
  using Classifier = run::Exact_classifiers::Classifier;
  std::vector<std::unique_ptr<Observed_subject<Classifier>>> subjects;
  for (const std::string& policy : policies) {
    Method chosen = method("circumcircle");
    chosen.policy = run::policy_choice(policy);
    subjects.push_back(std::make_unique<Observed_subject<Classifier>>(
        recording.front(), run::Exact_classifiers::make(chosen.classifier, {1, 1}), chosen));
    subjects.back()->set_keeps_sets(false);
  }
  for (Policy_record& record : records) {
    record.rebuilds = 0.0;
  }
  std::vector<std::size_t> order(policies.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  for (std::size_t frame = 1; frame < recording.size(); ++frame) {
    std::shuffle(order.begin(), order.end(), random);
    for (const std::size_t chosen : order) {
      Observed_subject<Classifier>& subject = *subjects[chosen];
      subject.update(recording[frame]);
      subject.check_certificate(frame);
      double& fastest = records[chosen].nanoseconds[frame - 1];
      fastest = (std::min)(fastest, subject.observation().terms.total);
      records[chosen].rebuilds += subject.report().rebuilt() ? 1.0 : 0.0;
    }
  }
  for (const auto& subject : subjects) {
    subject->check(recording.size() - 1);
  }
}

inline std::vector<Policy_record> run_policies(const Recorded_frames& recording,
                                               const std::vector<std::string>& policies,
                                               std::size_t passes)
{
  const std::vector<double> none(recording.size() - 1, std::numeric_limits<double>::infinity());
  std::vector<Policy_record> records(policies.size(), Policy_record{none});
  std::mt19937 random;
  for (std::size_t pass = 0; pass != passes; ++pass) {
    run_pass(recording, policies, random, records);
  }
  return records;
}

} // namespace classifiers

#endif // CLASSIFIERS_POLICY_RUN_H

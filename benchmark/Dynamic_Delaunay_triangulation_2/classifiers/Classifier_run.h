// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CLASSIFIERS_CLASSIFIER_RUN_H
#define CLASSIFIERS_CLASSIFIER_RUN_H

#include "../common/Contest.h"
#include "../common/Timed_phases.h"
#include "Confusion.h"
#include "Recorded_scenario.h"
#include "scenario_runner/Classifiers.h"
#include "scenario_runner/Repairs_and_policies.h"
#include "scenario_runner/Static_triangulation.h"

#include <CGAL/Dynamic_Delaunay_triangulation_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/queries/delaunay_agreement.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <numeric>
#include <random>
#include <string>
#include <vector>

namespace classifiers {

// A combination of classifier, repair and policy that is tried.
struct Method
{
  run::Classifier_choice classifier;
  std::string repair;
  unsigned padding;
  run::Policy_choice policy{"always_dynamic"};
  std::uint64_t seed = 1; // of the random classifier
};

// A classifier with its default repair and padding.
inline Method method(const std::string& classifier)
{
  const run::Classifier_choice choice = run::classifier_choice(classifier);
  const std::string repair = run::usual_repair(choice);
  const unsigned padding = repair == "splice" ? CGAL::Border_splice_repair_2().padding()
                                              : CGAL::Hold_and_flip_repair_2().padding();
  return {choice, repair, padding};
}

template <class Classifier>
using Observed_triangulation = CGAL::Dynamic_Delaunay_triangulation_2<
    run::Kernel, Observed_classifier<Classifier>,
    CGAL::With_repair_2<common::Clocked_repair<run::Any_repair>>,
    CGAL::With_policy_2<run::Any_policy>>;

// Keeps a triangulation through a recording.
template <class Classifier>
class Observed_subject
{
public:
  Observed_subject(const Points& points, const Classifier& classifier, const Method& method)
    : m_triangulation(
          points.begin(), points.end(), run::Point_map(),
          {Observed_classifier<Classifier>(classifier, m_observation),
           common::Clocked_repair<run::Any_repair>(run::make_repair(method.repair, method.padding),
                                                   m_observation.terms.repair),
           CGAL::Static_engines_2(), run::make_policy(method.policy)})
  {
  }
  Observed_subject(const Observed_subject&) = delete;
  Observed_subject& operator=(const Observed_subject&) = delete;

  // Whether the classified sets are kept, which only a confusion matrix needs.
  void set_keeps_sets(bool keeps) { m_observation.keeps_sets = keeps; }

  void update(const Points& points)
  {
    m_observation.terms = {};
    m_observation.aside = 0.0;
    m_observation.was_asked = false;
    const double total = run::nanoseconds_of(
        [&] { m_report = m_triangulation.update(points.begin(), points.end(), run::Point_map()); });
    m_observation.terms.total = total - m_observation.aside;
  }

  const Observed_triangulation<Classifier>& triangulation() const { return m_triangulation; }
  const Observation& observation() const { return m_observation; }
  const CGAL::Update_report_2& report() const { return m_report; }

  void check_certificate(std::size_t frame) const
  {
    const bool is_promised =
        CGAL::is_classifier_exact(m_triangulation.classifier()) || m_report.rebuilt();
    common::require(!is_promised || m_triangulation.is_certified(),
                    common::in_frame(frame) + "the triangulation is not certified");
  }

  // Throws unless the triangulation is valid, and certified if the method promises that.
  void check(std::size_t frame) const
  {
    check_certificate(frame);
    common::require(m_triangulation.is_valid(),
                    common::in_frame(frame) + "the triangulation is not valid");
  }

private:
  Observation m_observation;
  Observed_triangulation<Classifier> m_triangulation;
  CGAL::Update_report_2 m_report;
};

// What came out of one method on one recording.
struct Classifier_record
{
  Confusion confusion{};
  std::vector<Cost_terms> terms{}; // of each frame
  std::vector<double> validity{};  // of those that were compared
  std::size_t frames = 0;
  std::size_t asked = 0;
  std::size_t right_frames = 0; // of those that were compared
  double wrong_edges = 0.0;
  double classified = 0.0;
  double padded = 0.0;
  double enlargements = 0.0;
  double rebuilds = 0.0;
};

template <class Triangulation>
void compare(const Triangulation& triangulation, const Points& points, Classifier_record& record)
{
  const CGAL::Delaunay_agreement agreement =
      CGAL::delaunay_agreement(triangulation, common::fresh_triangulation(points));
  record.validity.push_back(agreement.matthews_correlation_coefficient());
  record.right_frames += agreement.is_perfect() ? 1 : 0;
  record.wrong_edges += static_cast<double>(agreement.false_positives());
}

inline void count(const CGAL::Update_report_2& report, Classifier_record& record)
{
  ++record.frames;
  record.classified += static_cast<double>(report.classified);
  record.padded += static_cast<double>(report.padded);
  record.enlargements += static_cast<double>(report.enlargements);
  record.rebuilds += report.rebuilt() ? 1.0 : 0.0;
}

// Observes every update; the truth is found before the clock starts. Every `stride`-th frame is
// compared with a fresh triangulation.
template <class Classifier>
Classifier_record observe(const Recorded_frames& recording, const Classifier& classifier,
                          const Method& method, std::size_t stride)
{
  Classifier_record record;
  Observed_subject<Classifier> subject(recording.front(), classifier, method);
  Classification_truth truth;
  for (std::size_t frame = 1; frame < recording.size(); ++frame) {
    const Points& points = recording[frame];
    const auto view = subject.triangulation().frame();
    truth.find(view, points);
    const auto edges = view.edges(); // a copy: repairs change them
    subject.update(points);
    count(subject.report(), record);
    if (subject.observation().was_asked) {
      ++record.asked;
      count(truth, subject.observation(), edges, record.confusion);
    }
    record.terms.push_back(subject.observation().terms);
    subject.check(frame);
    if (frame % stride == 0) {
      compare(subject.triangulation(), points, record);
    }
  }
  return record;
}

// Another pass, for the times alone. All passes make the same updates, so the fastest of each frame
// counts.
template <class Classifier>
void time_again(const Recorded_frames& recording, const Classifier& classifier,
                const Method& method, Classifier_record& record)
{
  Observed_subject<Classifier> subject(recording.front(), classifier, method);
  subject.set_keeps_sets(false);
  for (std::size_t frame = 1; frame < recording.size(); ++frame) {
    subject.update(recording[frame]);
    Cost_terms& fastest = record.terms[frame - 1];
    if (subject.observation().terms.total < fastest.total) {
      fastest = subject.observation().terms;
    }
  }
}

inline run::Any_classifier make_classifier(const Method& method)
{
  return run::make_classifier(method.classifier, {method.seed});
}

inline Classifier_record run_method(const Recorded_frames& recording, const Method& method,
                                    std::size_t passes, std::size_t stride)
{
  const run::Any_classifier classifier = make_classifier(method);
  Classifier_record record = observe(recording, classifier, method, stride);
  for (std::size_t pass = 1; pass < passes; ++pass) {
    time_again(recording, classifier, method, record);
  }
  return record;
}

// What a policy took on a recording, with the default classifier and repair.
struct Policy_record
{
  std::vector<double> nanoseconds{}; // of each frame, the fastest of all passes
  double rebuilds = 0.0;
};

// Runs all policies on the same frames, in an order that changes at random: the one after a rebuild
// finds the caches full of the data of that. Every frame has to be certified.
inline void run_pass(const Recorded_frames& recording, const std::vector<std::string>& policies,
                     std::mt19937& random, std::vector<Policy_record>& records)
{
  using Classifier = run::Any_classifier;
  std::vector<std::unique_ptr<Observed_subject<Classifier>>> subjects;
  for (const std::string& policy : policies) {
    Method chosen = method("circumcircle");
    chosen.policy = run::policy_choice(policy);
    subjects.push_back(std::make_unique<Observed_subject<Classifier>>(
        recording.front(), make_classifier(chosen), chosen));
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

#endif // CLASSIFIERS_CLASSIFIER_RUN_H

// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CLASSIFIERS_OBSERVED_UPDATE_H
#define CLASSIFIERS_OBSERVED_UPDATE_H

#include "scenario_runner/Measurement.h"
#include "scenario_runner/Repairs_and_policies.h"

#include <cstddef>
#include <utility>
#include <vector>

namespace classifiers {

// Nanoseconds of an update, by the terms of the thesis's cost model (4.2.1).
struct Cost_terms
{
  double classify = 0.0;
  double after_update = 0.0; // the rest of the classifier's cost
  double repair = 0.0;
  double total = 0.0;
};

// What was classified in an update, and what it took.
struct Observation
{
  Cost_terms terms{};
  double aside = 0.0; // nanoseconds of the observing itself
  bool was_asked = false;
  bool keeps_sets = true;
  std::vector<std::size_t> vertices{};
  std::vector<std::size_t> whole_vertices{};
  std::vector<std::size_t> edges{};

  template <class Classification>
  void take(const Classification& classified)
  {
    was_asked = true;
    if (keeps_sets) {
      vertices.assign(classified.vertices().begin(), classified.vertices().end());
      whole_vertices.assign(classified.whole_vertices().begin(), classified.whole_vertices().end());
      edges.assign(classified.edges().begin(), classified.edges().end());
    }
  }
};

template <class Classifier>
class Observed_classifier
{
public:
  static constexpr bool is_exact = Classifier::is_exact;

  Observed_classifier(Classifier classifier, Observation& observation)
    : m_classifier(std::move(classifier))
    , m_observation(&observation)
  {
  }

  template <class Frame, class Classification>
  void operator()(const Frame& frame, Classification& classified)
  {
    m_observation->terms.classify = run::nanoseconds_of([&] { m_classifier(frame, classified); });
    m_observation->aside = run::nanoseconds_of([&] { m_observation->take(classified); });
  }

  template <class Frame>
  void after_update(const Frame& frame)
  {
    m_observation->terms.after_update =
        run::nanoseconds_of([&] { m_classifier.after_update(frame); });
  }

private:
  Classifier m_classifier;
  Observation* m_observation;
};

class Observed_repair
{
public:
  Observed_repair(run::Any_repair repair, Observation& observation)
    : m_repair(std::move(repair))
    , m_observation(&observation)
  {
  }

  template <class Mender>
  void operator()(Mender& mender) const
  {
    m_observation->terms.repair = run::nanoseconds_of([&] { m_repair(mender); });
  }

private:
  run::Any_repair m_repair;
  Observation* m_observation;
};

} // namespace classifiers

#endif // CLASSIFIERS_OBSERVED_UPDATE_H

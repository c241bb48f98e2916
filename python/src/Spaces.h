// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PYTHON_SPACES_H
#define PYTHON_SPACES_H

#include "python/src/Python_classifier.h"
#include "python/src/Recorded_changes.h"
#include "python/src/Subject_of.h"
#include "scenario_runner/Classifiers.h"
#include "scenario_runner/Repairs_and_policies.h"
#include "scenario_runner/Threads.h"

#include <CGAL/Default.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2.h>
#include <CGAL/Dynamic_periodic_Delaunay_triangulation_2.h>
#include <CGAL/Edge_changes_visitor_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Periodic_edge_changes_visitor_2.h>

#include <memory>
#include <string>

namespace python {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

class Plane
{
public:
  explicit Plane(const Settings&) {}

  using Edge_changes = CGAL::Edge_changes_visitor_2;
  template <class Classifier, class Repair, class Policy, class Visitor>
  using Dynamic = CGAL::Dynamic_Delaunay_triangulation_2<Kernel, Classifier, Repair, CGAL::Default,
                                                         Policy, Visitor, run::Concurrency_tag>;

  template <class Triangulation>
  Triangulation make(const typename Triangulation::Settings& settings) const
  {
    return Triangulation(settings);
  }
};

class Periodic_space
{
public:
  explicit Periodic_space(const Settings& settings)
    : m_cell(periodic_cell(*settings.cell))
  {
  }

  using Edge_changes = CGAL::Periodic_edge_changes_visitor_2;
  template <class Classifier, class Repair, class Policy, class Visitor>
  using Dynamic =
      CGAL::Dynamic_periodic_Delaunay_triangulation_2<Kernel, Classifier, Repair, Policy, Visitor,
                                                      run::Concurrency_tag>;

  template <class Triangulation>
  Triangulation make(const typename Triangulation::Settings& settings) const
  {
    return Triangulation(m_cell, settings);
  }

private:
  CGAL::Periodic_cell_2 m_cell;
};

// Without a visitor if it has nothing to record, since each flip would tell it.
template <class Space, class Classifier, class Repair, class Policy>
std::unique_ptr<Subject> make_in(const Classifier& classifier, const Repair& repair,
                                 const Policy& policy, const Settings& settings)
{
  const auto make = [&](auto visitor) {
    using Dynamic = typename Space::template Dynamic<Classifier, Repair, Policy, decltype(visitor)>;
    typename Dynamic::Settings its_settings;
    its_settings.classifier = classifier;
    its_settings.repair = repair;
    its_settings.policy = policy;
    return make_subject_of(Space(settings).template make<Dynamic>(its_settings),
                           settings.is_population);
  };
  return settings.records_changes ? make(Recorded_changes<typename Space::Edge_changes>())
                                  : make(CGAL::Default());
}

// Repair and policy by the names of run_scenario.
template <class Space, class Classifier>
std::unique_ptr<Subject> make_by_names(const Classifier& classifier,
                                       const std::string& usual_repair, const Settings& settings)
{
  constexpr unsigned padding = 1;
  const std::string& repair = settings.repair.empty() ? usual_repair : settings.repair;
  return make_in<Space>(classifier, run::make_repair(repair, padding),
                        run::make_policy(run::policy_choice(settings.policy)), settings);
}

// With an exact classifier.
template <class Space>
std::unique_ptr<Subject> make_exact_in(const Settings& settings)
{
  const run::Classifier_choice choice = run::classifier_choice(settings.classifier);
  return make_by_names<Space>(run::Exact_classifiers::make(choice, {settings.seed}),
                              run::usual_repair(choice), settings);
}

// With any classifier, also one in Python.
template <class Space>
std::unique_ptr<Subject> make_heuristic_in(const Settings& settings)
{
  using Named_classifier = run::All_classifiers::Classifier;
  using Classifier = run::Any_classifier<Named_classifier, Python_classifier>;
  if (settings.function) {
    return make_by_names<Space>(Classifier(Python_classifier(settings.function)), "splice",
                                settings);
  }
  const run::Classifier_choice choice = run::classifier_choice(settings.classifier);
  return make_by_names<Space>(Classifier(run::All_classifiers::make(choice, {settings.seed})),
                              run::usual_repair(choice), settings);
}

} // namespace python

#endif // PYTHON_SPACES_H

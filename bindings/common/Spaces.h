// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef BINDINGS_SPACES_H
#define BINDINGS_SPACES_H

#include "bindings/common/Recorded_changes.h"
#include "bindings/common/Subject_of.h"
#include "scenario_runner/Classifiers.h"
#include "scenario_runner/Repairs_and_policies.h"
#include "scenario_runner/Threads.h"

#include <CGAL/Dynamic_Delaunay_triangulation_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/visitors/Edge_changes_visitor_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/visitors/Periodic_edge_changes_visitor_2.h>
#include <CGAL/Dynamic_periodic_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <memory>
#include <string>
#include <utility>

namespace bindings {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

class Plane
{
public:
  explicit Plane(const Settings&) {}

  using Edge_changes = CGAL::Edge_changes_visitor_2;
  template <class Classifier, class Repair, class Policy, class Visitor>
  using Dynamic = CGAL::Dynamic_Delaunay_triangulation_2<
      Kernel, Classifier, CGAL::With_repair_2<Repair>, CGAL::With_policy_2<Policy>,
      CGAL::With_visitor_2<Visitor>, CGAL::With_concurrency_2<run::Concurrency_tag>>;

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
  using Dynamic = CGAL::Dynamic_periodic_Delaunay_triangulation_2<
      Kernel, Classifier, CGAL::With_repair_2<Repair>, CGAL::With_policy_2<Policy>,
      CGAL::With_visitor_2<Visitor>, CGAL::With_concurrency_2<run::Concurrency_tag>>;

  template <class Triangulation>
  Triangulation make(const typename Triangulation::Settings& settings) const
  {
    return Triangulation(m_cell, settings);
  }

private:
  CGAL::Periodic_cell_2 m_cell;
};

// Which types of a subject there are for each classifier, and whether they have checkpoints and
// checks of validity, which need streams, gradients of bounded cells, domains that are not convex,
// and queries of points. A binding that must be small has less.
struct All_kinds
{
  static constexpr bool has_populations = true;
  static constexpr bool has_extras = true;
};

template <class Space, class Kinds, class Dynamic>
std::unique_ptr<Subject> make_subject(const typename Dynamic::Settings& its_settings,
                                      const Settings& settings)
{
  auto triangulation = Space(settings).template make<Dynamic>(its_settings);
  if constexpr (Kinds::has_populations) {
    if (settings.is_population) {
      return std::make_unique<Subject_of<Dynamic, Kinds, true>>(std::move(triangulation));
    }
  }
  return std::make_unique<Subject_of<Dynamic, Kinds, false>>(std::move(triangulation));
}

template <class Space, class Kinds = All_kinds, class Classifier, class Repair, class Policy>
std::unique_ptr<Subject> make_in(const Classifier& classifier, const Repair& repair,
                                 const Policy& policy, const Settings& settings)
{
  using Visitor = Recorded_changes<typename Space::Edge_changes>;
  using Dynamic = typename Space::template Dynamic<Classifier, Repair, Policy, Visitor>;
  typename Dynamic::Settings its_settings;
  its_settings.classifier = classifier;
  its_settings.repair = repair;
  its_settings.policy = policy;
  its_settings.visitor = Visitor(settings.records_changes);
  return make_subject<Space, Kinds, Dynamic>(its_settings, settings);
}

// Repair and policy by the names of run_scenario.
template <class Space, class Kinds = All_kinds, class Classifier>
std::unique_ptr<Subject> make_by_names(const Classifier& classifier,
                                       const std::string& usual_repair, const Settings& settings)
{
  const std::string& repair = settings.repair.empty() ? usual_repair : settings.repair;
  return make_in<Space, Kinds>(classifier, run::make_repair(repair, settings.padding),
                               run::make_policy(run::policy_choice(settings.policy)), settings);
}

// What a program in C++ has by default.
template <class Space, class Kinds = All_kinds>
std::unique_ptr<Subject> make_usual_in(const Settings& settings)
{
  return make_in<Space, Kinds>(CGAL::Circumcircle_classifier_2(), CGAL::Hold_and_flip_repair_2(),
                               CGAL::Always_dynamic_policy_2(), settings);
}

} // namespace bindings

#endif // BINDINGS_SPACES_H

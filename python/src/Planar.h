// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PYTHON_PLANAR_H
#define PYTHON_PLANAR_H

#include "python/src/Recorded_changes.h"
#include "python/src/Subject_of.h"
#include "scenario_runner/Method_choice.h"
#include "scenario_runner/Repairs_and_policies.h"
#include "scenario_runner/Threads.h"

#include <CGAL/Dynamic_Delaunay_triangulation_2.h>
#include <CGAL/Edge_changes_visitor_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <string>

namespace python {

// Repair and policy by the names of run_scenario.
template <class Classifier>
std::unique_ptr<Subject> make_planar(const Classifier& classifier, const std::string& usual_repair,
                                     const Settings& settings, bool is_population)
{
  using Visitor = Recorded_changes<CGAL::Edge_changes_visitor_2>;
  using Dynamic =
      CGAL::Dynamic_Delaunay_triangulation_2<CGAL::Exact_predicates_inexact_constructions_kernel,
                                             Classifier, run::Any_repair, CGAL::Default,
                                             run::Any_policy, Visitor, run::Concurrency_tag>;
  constexpr unsigned padding = 1;
  const std::string repair = settings.repair.empty() ? usual_repair : settings.repair;
  return make_subject(Dynamic(typename Dynamic::Settings{
                          classifier, run::make_repair(repair, padding), CGAL::Static_engines_2(),
                          run::make_policy(run::policy_choice(settings.policy)),
                          Visitor(settings.records_changes)}),
                      is_population);
}

} // namespace python

#endif // PYTHON_PLANAR_H

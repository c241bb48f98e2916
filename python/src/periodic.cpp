// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "python/src/Recorded_changes.h"
#include "python/src/Subject_of.h"
#include "scenario_runner/Threads.h"

#include <CGAL/Dynamic_periodic_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Periodic_edge_changes_visitor_2.h>

namespace python {

std::unique_ptr<Subject> make_periodic(const Settings& settings, const Cell& cell,
                                       bool is_population)
{
  using Visitor = Recorded_changes<CGAL::Periodic_edge_changes_visitor_2>;
  using Dynamic = CGAL::Dynamic_periodic_Delaunay_triangulation_2<
      CGAL::Exact_predicates_inexact_constructions_kernel, CGAL::Default, CGAL::Default,
      CGAL::Default, Visitor, run::Concurrency_tag>;
  Dynamic::Settings its_settings;
  its_settings.visitor = Visitor(settings.records_changes);
  return make_subject(Dynamic(periodic_cell(cell), its_settings), is_population);
}

} // namespace python

// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SCENARIO_RUNNER_REBUILD_REASON_NAME_H
#define SCENARIO_RUNNER_REBUILD_REASON_NAME_H

#include <CGAL/Dynamic_Delaunay_triangulation_2/policies/Update_report_2.h>

namespace run {

// As files and other languages have it.
inline const char* rebuild_reason_name(CGAL::Rebuild_reason_2 reason)
{
  using Reason = CGAL::Rebuild_reason_2;
  switch (reason) {
  case Reason::NONE:
    return "none";
  case Reason::REPAIR:
    return "repair";
  case Reason::TOO_MUCH_BROKEN:
    return "too_much_broken";
  case Reason::STUCK:
    return "stuck";
  case Reason::COINCIDENCE:
    return "coincidence";
  case Reason::POPULATION:
    return "population";
  case Reason::DIMENSION:
    return "dimension";
  case Reason::POLICY:
    return "policy";
  case Reason::BUDGET_SPENT:
    return "budget_spent";
  }
  return "unknown";
}

} // namespace run

#endif // SCENARIO_RUNNER_REBUILD_REASON_NAME_H

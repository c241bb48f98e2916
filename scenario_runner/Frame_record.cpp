// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "scenario_runner/Frame_record.h"

namespace run {

std::string rebuild_reason_name(CGAL::Rebuild_reason_2 reason)
{
  switch (reason) {
  case CGAL::Rebuild_reason_2::NONE:
    return "none";
  case CGAL::Rebuild_reason_2::REPAIR:
    return "repair";
  case CGAL::Rebuild_reason_2::TOO_MUCH_BROKEN:
    return "too_much_broken";
  case CGAL::Rebuild_reason_2::STUCK:
    return "stuck";
  case CGAL::Rebuild_reason_2::COINCIDENCE:
    return "coincidence";
  case CGAL::Rebuild_reason_2::POPULATION:
    return "population";
  case CGAL::Rebuild_reason_2::DIMENSION:
    return "dimension";
  case CGAL::Rebuild_reason_2::POLICY:
    return "policy";
  case CGAL::Rebuild_reason_2::BUDGET_SPENT:
    return "budget_spent";
  }
  return "unknown";
}

} // namespace run

// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SCENARIO_RUNNER_FRAME_RECORD_H
#define SCENARIO_RUNNER_FRAME_RECORD_H

#include <CGAL/Update_report_2.h>

#include <cstddef>
#include <string>

namespace run {

// Nanoseconds.
struct Frame_times
{
  double dynamic = 0.0;
  double static_insert = 0.0;
  double static_fastest = 0.0;
};

struct Frame_record
{
  std::size_t frame = 0;
  double time = 0.0; // of the motion
  std::size_t points = 0;
  bool population_changed = false;
  CGAL::Update_report_2 update{};
  bool certified = false;
  double validity = 1.0;
  Frame_times nanoseconds{};
};

inline std::string rebuild_reason_name(CGAL::Rebuild_reason_2 reason)
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

#endif // SCENARIO_RUNNER_FRAME_RECORD_H

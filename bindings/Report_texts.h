// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef BINDINGS_REPORT_TEXTS_H
#define BINDINGS_REPORT_TEXTS_H

#include <CGAL/Update_report_2.h>

#include <array>

namespace bindings {

// Null if the frame was not triangulated anew.
inline const char* reason_text(CGAL::Rebuild_reason_2 reason)
{
  using Reason = CGAL::Rebuild_reason_2;
  switch (reason) {
  case Reason::NONE:
    return nullptr;
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
  return nullptr;
}

inline constexpr std::array counts_of_reports = {
    &CGAL::Update_report_2::classified,   &CGAL::Update_report_2::padded,
    &CGAL::Update_report_2::border,       &CGAL::Update_report_2::flips,
    &CGAL::Update_report_2::splices,      &CGAL::Update_report_2::spliced,
    &CGAL::Update_report_2::enlargements, &CGAL::Update_report_2::relocated,
    &CGAL::Update_report_2::inserted,     &CGAL::Update_report_2::removed,
    &CGAL::Update_report_2::merged,       &CGAL::Update_report_2::parted};

} // namespace bindings

#endif // BINDINGS_REPORT_TEXTS_H

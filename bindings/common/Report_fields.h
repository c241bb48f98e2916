// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef BINDINGS_REPORT_FIELDS_H
#define BINDINGS_REPORT_FIELDS_H

#include "scenario_runner/Rebuild_reason_name.h"

#include <CGAL/Dynamic_Delaunay_triangulation_2/policies/Update_report_2.h>

#include <array>
#include <cstddef>

namespace bindings {

// Null if the frame was not triangulated anew.
template <class Report>
const char* rebuild_reason(const Report& report)
{
  return report.rebuilt() ? run::rebuild_reason_name(report.rebuild_reason) : nullptr;
}

inline constexpr std::array<std::size_t CGAL::Update_report_2::*, 12> counts_of_reports = {
    &CGAL::Update_report_2::classified,   &CGAL::Update_report_2::padded,
    &CGAL::Update_report_2::border,       &CGAL::Update_report_2::flips,
    &CGAL::Update_report_2::splices,      &CGAL::Update_report_2::spliced,
    &CGAL::Update_report_2::enlargements, &CGAL::Update_report_2::relocated,
    &CGAL::Update_report_2::inserted,     &CGAL::Update_report_2::removed,
    &CGAL::Update_report_2::merged,       &CGAL::Update_report_2::parted};

} // namespace bindings

#endif // BINDINGS_REPORT_FIELDS_H

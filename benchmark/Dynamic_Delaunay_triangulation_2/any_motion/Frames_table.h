// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ANY_MOTION_FRAMES_TABLE_H
#define ANY_MOTION_FRAMES_TABLE_H

#include "scenario_runner/Frame_record.h"
#include "Sequence_figures.h"

#include <iomanip>
#include <ostream>

namespace any_motion {

// For people: every frame of a sequence, times in nanoseconds a point.
inline void write_frames(std::ostream& out, const Sequence_figures& figures)
{
  out << std::fixed << std::right << std::setw(6) << "frame" << std::setw(9) << "points"
      << std::setw(10) << "ratio" << std::setw(11) << "dynamic" << std::setw(9) << "insert"
      << std::setw(9) << "ordered" << std::setw(9) << "sorted" << std::setw(11) << "classified"
      << std::setw(10) << "relocated" << std::setw(8) << "flips" << std::setw(8) << "splices"
      << std::setw(8) << "spliced"
      << "  rebuilt\n";
  for (const Frame_figures& frame : figures.frames) {
    const auto points = static_cast<double>(frame.points);
    const CGAL::Update_report_2& report = frame.report;
    out << std::setw(6) << frame.frame << std::setw(9) << frame.points << std::setprecision(3)
        << std::setw(10) << frame.ratio() << std::setprecision(1) << std::setw(11)
        << frame.dynamic / points << std::setw(9) << frame.insert / points << std::setw(9)
        << frame.ordered / points << std::setw(9) << frame.sorted / points << std::setw(11)
        << report.classified << std::setw(10) << report.relocated << std::setw(8) << report.flips
        << std::setw(8) << report.splices << std::setw(8) << report.spliced << "  "
        << run::rebuild_reason_name(report.rebuild_reason) << '\n';
  }
}

} // namespace any_motion

#endif // ANY_MOTION_FRAMES_TABLE_H

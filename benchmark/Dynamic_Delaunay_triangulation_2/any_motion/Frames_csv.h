// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ANY_MOTION_FRAMES_CSV_H
#define ANY_MOTION_FRAMES_CSV_H

#include "../results/Csv_file.h"
#include "scenario_runner/Frame_record.h"
#include "Sequence_figures.h"

#include <string>
#include <vector>

namespace any_motion {

// A line for each measured frame; times in nanoseconds.
inline void write_csv(const std::string& path, const std::string& command,
                      const std::vector<Sequence_figures>& all)
{
  results::Csv_file file(path, {"command: " + command},
                         {"kind", "points", "frame", "dynamic_ns", "static_ns", "ratio",
                          "insert_ns", "ordered_ns", "sorted_ns", "rebuild_reason", "classified",
                          "relocated", "flips", "splices", "spliced", "inserted", "removed",
                          "merged", "parted"});
  for (const Sequence_figures& figures : all) {
    for (const Frame_figures& frame : figures.frames) {
      const CGAL::Update_report_2& report = frame.report;
      file.write_row(figures.kind, frame.points, frame.frame, frame.dynamic, frame.fastest_static(),
                     frame.ratio(), frame.insert, frame.ordered, frame.sorted,
                     run::rebuild_reason_name(report.rebuild_reason), report.classified,
                     report.relocated, report.flips, report.splices, report.spliced,
                     report.inserted, report.removed, report.merged, report.parted);
    }
  }
  file.finish();
}

} // namespace any_motion

#endif // ANY_MOTION_FRAMES_CSV_H

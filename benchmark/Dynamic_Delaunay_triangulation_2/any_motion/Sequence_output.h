// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ANY_MOTION_SEQUENCE_OUTPUT_H
#define ANY_MOTION_SEQUENCE_OUTPUT_H

#include "../common/Csv_file.h"
#include "../common/Table.h"
#include "scenario_runner/Rebuild_reason_name.h"
#include "Sequence_run.h"

#include <CGAL/Dynamic_Delaunay_triangulation_2/policies/Update_report_2.h>

#include <algorithm>
#include <cstddef>
#include <iomanip>
#include <ostream>
#include <string>
#include <vector>

namespace any_motion {

// A line for each measured frame; times in nanoseconds.
inline void write_csv(const std::string& path, const std::string& command,
                      const std::vector<Sequence_figures>& all)
{
  common::Csv_file file(path, {"command: " + command},
                        {"kind", "points", "frame", "dynamic_ns", "static_ns", "ratio", "insert_ns",
                         "ordered_ns", "sorted_ns", "rebuild_reason", "classified", "relocated",
                         "flips", "splices", "spliced", "inserted", "removed", "merged", "parted"});
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

// For people: every frame of a sequence, times in nanoseconds a point.
inline void write_frames(std::ostream& out, const Sequence_figures& figures)
{
  common::Table table(out, 0,
                      {{"frame", 6},
                       {"points", 9},
                       {"ratio", 10, 3},
                       {"dynamic", 11, 1},
                       {"insert", 9, 1},
                       {"ordered", 9, 1},
                       {"sorted", 9, 1},
                       {"classified", 11},
                       {"relocated", 10},
                       {"flips", 8},
                       {"splices", 8},
                       {"spliced", 8},
                       {"  rebuilt", 0}});
  table.write_head("");
  for (const Frame_figures& frame : figures.frames) {
    const auto points = static_cast<double>(frame.points);
    const CGAL::Update_report_2& report = frame.report;
    table.write_row("", frame.frame, frame.points, frame.ratio(), frame.dynamic / points,
                    frame.insert / points, frame.ordered / points, frame.sorted / points,
                    report.classified, report.relocated, report.flips, report.splices,
                    report.spliced,
                    std::string("  ") + run::rebuild_reason_name(report.rebuild_reason));
  }
}

// For people: a line for each sequence, and what of it is slow.
class Sequence_table
{
public:
  explicit Sequence_table(std::ostream& out)
    : m_out(out)
    , m_table(out, name_width,
              {{"points", 8},
               {"frames", 7},
               {"median", 9, 3},
               {"worst", 9, 3},
               {"dynamic", 11, 1},
               {"static", 11, 1},
               {"rebuilds", 9},
               {"relocated", 11, 1},
               {"flips", 11, 1},
               {"splices", 9, 1},
               {"", 0}})
  {
    m_out << std::fixed;
    m_table.write_head("");
  }

  void write_row(const Sequence_figures& figures)
  {
    using Report = CGAL::Update_report_2;
    const auto median_a_point = [&](const auto& nanoseconds) {
      return common::median(common::values_of(figures.frames, [&](const Frame_figures& frame) {
        return frame.points == 0 ? 0.0 : nanoseconds(frame) / static_cast<double>(frame.points);
      }));
    };
    m_table.write_row(
        figures.kind, figures.points(), figures.frames.size(), figures.median_ratio(),
        figures.worst_ratio(), median_a_point([](const auto& frame) { return frame.dynamic; }),
        median_a_point([](const auto& frame) { return frame.fastest_static(); }),
        figures.rebuilds(), figures.mean(&Report::relocated), figures.mean(&Report::flips),
        figures.mean(&Report::splices), figures.was_cut_short ? "  cut short" : "");
  }

  void write_summary(const std::vector<Sequence_figures>& all)
  {
    write_times_faster(all, "calm");
    write_times_faster(all, "jumps");
    write_slow_medians(all);
    write_slow_frames(all);
  }

private:
  std::ostream& write_name(const Sequence_figures& figures)
  {
    return m_out << "  " << std::left << std::setw(name_width)
                 << figures.kind + '/' + std::to_string(figures.points()) << std::right;
  }

  void write_times_faster(const std::vector<Sequence_figures>& all, const std::string& group)
  {
    const char* head = "\nTimes faster than the fastest static way, ";
    for (const Sequence_figures& figures : all) {
      if (figures.group == group) {
        if (head != nullptr) {
          m_out << head << group << ", medians\n" << std::setprecision(2);
          head = nullptr;
        }
        write_name(figures) << std::setw(9) << 1.0 / figures.median_ratio() << '\n';
      }
    }
  }

  void write_slow_medians(const std::vector<Sequence_figures>& all)
  {
    const auto is_slow_one = [](const Sequence_figures& figures) {
      return figures.median_ratio() > slow_median;
    };
    m_out << std::setprecision(2) << '\n'
          << std::count_if(all.begin(), all.end(), is_slow_one) << " of " << all.size()
          << " medians above " << slow_median << '\n'
          << std::setprecision(3);
    for (const Sequence_figures& figures : all) {
      if (is_slow_one(figures)) {
        write_name(figures) << std::setw(9) << figures.median_ratio() << '\n';
      }
    }
  }

  void write_slow_frames(const std::vector<Sequence_figures>& all)
  {
    std::size_t slow = 0, frames = 0;
    for (const Sequence_figures& figures : all) {
      frames += figures.frames.size();
      slow += slow_frames(figures);
    }
    m_out << std::setprecision(2) << '\n'
          << slow << " of " << frames << " frames above " << slow_frame << '\n'
          << std::setprecision(3);
    for (const Sequence_figures& figures : all) {
      if (slow_frames(figures) != 0) {
        write_name(figures) << std::setw(5) << slow_frames(figures) << " of "
                            << figures.frames.size() << ':';
        write_frames(figures);
        m_out << '\n';
      }
    }
  }

  static std::size_t slow_frames(const Sequence_figures& figures)
  {
    return static_cast<std::size_t>(
        std::count_if(figures.frames.begin(), figures.frames.end(),
                      [](const Frame_figures& frame) { return frame.ratio() > slow_frame; }));
  }

  void write_frames(const Sequence_figures& figures)
  {
    constexpr std::size_t most = 8;
    std::size_t written = 0;
    for (const Frame_figures& frame : figures.frames) {
      if (frame.ratio() > slow_frame && written++ < most) {
        m_out << "  " << frame.frame << " (" << frame.ratio() << ')';
      }
    }
    m_out << (written > most ? "  ..." : "");
  }

  static constexpr int name_width = 40;

  std::ostream& m_out;
  common::Table m_table;
};

} // namespace any_motion

#endif // ANY_MOTION_SEQUENCE_OUTPUT_H

// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PERIODIC_PERIODIC_OUTPUT_H
#define PERIODIC_PERIODIC_OUTPUT_H

#include "../common/Csv_file.h"
#include "../common/Statistics.h"
#include "../common/Table.h"
#include "Periodic_run.h"
#include "scenario_runner/Measurement.h"
#include "scenario_runner/Rebuild_reason_name.h"

#include <CGAL/Dynamic_Delaunay_triangulation_2/policies/Update_report_2.h>

#include <array>
#include <cstddef>
#include <ostream>
#include <string>
#include <vector>

namespace periodic {

// All frames of a number of points and a step.
struct Case_figures
{
  std::size_t points;
  double step;
  std::vector<Frame_figures> frames{};

  // Nanoseconds a point.
  std::vector<double> times(Contestant contestant) const
  {
    std::vector<double> times;
    for (const Frame_figures& frame : frames) {
      if (frame.times[contestant]) {
        times.push_back(*frame.times[contestant]);
      }
    }
    return times;
  }

  // The median of the ratios in single frames.
  double median_ratio(Contestant above, Contestant below) const
  {
    std::vector<double> ratios;
    for (const Frame_figures& frame : frames) {
      if (frame.times[above] && frame.times[below]) {
        ratios.push_back(*frame.times[above] / *frame.times[below]);
      }
    }
    return common::median(ratios);
  }

  // The mean count of a frame.
  template <class Count>
  double mean(const Count& count) const
  {
    return common::mean(common::values_of(frames, count));
  }
};

// For people: a line for each case.
class Case_table
{
public:
  explicit Case_table(std::ostream& out)
    : m_table(out, 15,
              {{"frames", 7},     {"periodic", 10, 1}, {"q1", 8, 1},         {"q3", 8, 1},
               {"worst", 8, 1},   {"plane", 10, 1},    {"q1", 8, 1},         {"q3", 8, 1},
               {"ghosts", 10, 1}, {"q1", 8, 1},        {"q3", 8, 1},         {"CGAL", 10, 1},
               {"q1", 8, 1},      {"q3", 8, 1},        {"p/plane", 9, 2},    {"ghosts/p", 9, 2},
               {"CGAL/p", 9, 1},  {"flips", 10, 1},    {"relocated", 10, 1}, {"rebuilds", 9, 3},
               {"copies", 8, 3}})
  {
    m_table.write_head("points, step");
  }

  void write_row(const Case_figures& figures)
  {
    const auto spread = [&](Contestant contestant) {
      return *run::spread(figures.times(contestant));
    };
    const run::Spread periodic = spread(PERIODIC), plane = spread(PLANE), ghosts = spread(GHOSTS),
                      cgal = spread(CGAL_PERIODIC);
    const auto mean = [&](std::size_t CGAL::Update_report_2::*count) {
      return figures.mean([&](const Frame_figures& frame) { return frame.report.*count; });
    };
    m_table.write_row(
        std::to_string(figures.points) + ", " + common::csv_cell(figures.step),
        figures.frames.size(), periodic.median, periodic.low_quartile, periodic.high_quartile,
        common::largest(figures.times(PERIODIC)), plane.median, plane.low_quartile,
        plane.high_quartile, ghosts.median, ghosts.low_quartile, ghosts.high_quartile, cgal.median,
        cgal.low_quartile, cgal.high_quartile, figures.median_ratio(PERIODIC, PLANE),
        figures.median_ratio(GHOSTS, PERIODIC), figures.median_ratio(CGAL_PERIODIC, PERIODIC),
        mean(&CGAL::Update_report_2::flips), mean(&CGAL::Update_report_2::relocated),
        figures.mean([](const Frame_figures& frame) { return frame.report.rebuilt(); }),
        figures.mean(&Frame_figures::copies) / static_cast<double>(figures.points));
  }

private:
  common::Table m_table;
};

// Slabs without and with walls: a line for each case, with medians and the slowest frames.
class Channel_table
{
public:
  explicit Channel_table(std::ostream& out)
    : m_table(out, 15,
              {{"frames", 7},
               {"slab", 10, 1},
               {"worst", 8, 1},
               {"walls", 10, 1},
               {"worst", 8, 1},
               {"walls/slab", 12, 2}})
  {
    m_table.write_head("points, step");
  }

  void write_row(const std::string& name, const std::array<std::vector<double>, 2>& times)
  {
    m_table.write_row(name, times[0].size(), common::median(times[0]), common::largest(times[0]),
                      common::median(times[1]), common::largest(times[1]),
                      common::median_ratio(times[1], times[0]));
  }

private:
  common::Table m_table;
};

// A line for each frame; times in nanoseconds a point.
inline void write_csv(const std::string& path, const std::string& command,
                      const std::vector<Case_figures>& all)
{
  common::Csv_file file(path, {"command: " + command},
                        {"points", "step", "frame", "periodic_ns", "plane_ns", "ghosts_ns",
                         "cgal_ns", "copies", "flips", "relocated", "rebuild_reason"});
  for (const Case_figures& figures : all) {
    for (const Frame_figures& frame : figures.frames) {
      const auto time = [&](Contestant contestant) {
        const auto& measured = frame.times[contestant];
        return measured ? common::csv_cell(*measured) : std::string();
      };
      file.write_row(figures.points, figures.step, frame.frame, time(PERIODIC), time(PLANE),
                     time(GHOSTS), time(CGAL_PERIODIC), frame.copies, frame.report.flips,
                     frame.report.relocated, run::rebuild_reason_name(frame.report.rebuild_reason));
    }
  }
  file.finish();
}

} // namespace periodic

#endif // PERIODIC_PERIODIC_OUTPUT_H

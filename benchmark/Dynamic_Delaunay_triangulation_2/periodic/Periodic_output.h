// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PERIODIC_PERIODIC_OUTPUT_H
#define PERIODIC_PERIODIC_OUTPUT_H

#include "../common/Csv_file.h"
#include "../common/Table.h"
#include "Periodic_run.h"
#include "scenario_runner/Measurement.h"
#include "scenario_runner/Rebuild_reason_name.h"

#include <CGAL/Dynamic_Delaunay_triangulation_2/policies/Update_report_2.h>

#include <algorithm>
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
    return run::spread(ratios)->median;
  }

  // The mean count of a frame.
  template <class Count>
  double mean(const Count& count) const
  {
    double sum = 0.0;
    for (const Frame_figures& frame : frames) {
      sum += static_cast<double>(count(frame));
    }
    return sum / static_cast<double>(frames.size());
  }
};

// For people: a line for each case.
class Case_table
{
public:
  explicit Case_table(std::ostream& out)
    : m_table(out, name_width, columns())
  {
    m_table.write_head("points, step");
  }

  void write_row(const Case_figures& figures)
  {
    std::vector<std::string> cells{std::to_string(figures.frames.size())};
    for (const Contestant contestant : {PERIODIC, PLANE, GHOSTS, CGAL_PERIODIC}) {
      append_times(figures.times(contestant), contestant == PERIODIC, cells);
    }
    const auto append = [&](double value, int decimals) {
      cells.push_back(common::cell(value, decimals));
    };
    append(figures.median_ratio(PERIODIC, PLANE), 2);
    append(figures.median_ratio(GHOSTS, PERIODIC), 2);
    append(figures.median_ratio(CGAL_PERIODIC, PERIODIC), 1);
    const auto mean = [&](std::size_t CGAL::Update_report_2::*count) {
      return figures.mean([&](const Frame_figures& frame) { return frame.report.*count; });
    };
    append(mean(&CGAL::Update_report_2::flips), 1);
    append(mean(&CGAL::Update_report_2::relocated), 1);
    append(figures.mean([](const Frame_figures& frame) { return frame.report.rebuilt(); }), 3);
    append(figures.mean([](const Frame_figures& frame) { return frame.copies; }) /
               static_cast<double>(figures.points),
           3);
    m_table.write_cells(std::to_string(figures.points) + ", " + common::csv_cell(figures.step),
                        cells);
  }

private:
  static std::vector<common::Column> columns()
  {
    std::vector<common::Column> columns{{"frames", 7}};
    for (const char* const name : {"periodic", "plane", "ghosts", "CGAL"}) {
      columns.insert(columns.end(), {{name, 10}, {"q1", 8}, {"q3", 8}});
      if (columns.size() == 4) {
        columns.push_back({"worst", 8});
      }
    }
    columns.insert(columns.end(), {{"p/plane", 9},
                                   {"ghosts/p", 9},
                                   {"CGAL/p", 9},
                                   {"flips", 10},
                                   {"relocated", 10},
                                   {"rebuilds", 9},
                                   {"copies", 8}});
    return columns;
  }

  static void append_times(const std::vector<double>& times, bool has_worst,
                           std::vector<std::string>& cells)
  {
    const run::Spread spread = *run::spread(times);
    std::vector<double> values{spread.median, spread.low_quartile, spread.high_quartile};
    if (has_worst) {
      values.push_back(*std::max_element(times.begin(), times.end()));
    }
    for (const double value : values) {
      cells.push_back(common::cell(value, 1));
    }
  }

  static constexpr int name_width = 15;

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
    std::vector<double> ratios;
    for (std::size_t i = 0; i != times[0].size(); ++i) {
      ratios.push_back(times[1][i] / times[0][i]);
    }
    const auto worst = [](const std::vector<double>& all) {
      return *std::max_element(all.begin(), all.end());
    };
    m_table.write_row(name, times[0].size(), run::spread(times[0])->median, worst(times[0]),
                      run::spread(times[1])->median, worst(times[1]), run::spread(ratios)->median);
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

// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ANY_MOTION_SEQUENCE_FIGURES_H
#define ANY_MOTION_SEQUENCE_FIGURES_H

#include "scenario_runner/Measurement.h"

#include <CGAL/Update_report_2.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

namespace any_motion {

// Times in nanoseconds.
struct Frame_figures
{
  std::size_t frame = 0;
  std::size_t points = 0;
  double dynamic = 0.0;
  double insert = 0.0;
  double ordered = 0.0;
  double sorted = 0.0;
  CGAL::Update_report_2 report{};

  double fastest_static() const { return (std::min)({insert, ordered, sorted}); }
  double ratio() const { return dynamic / fastest_static(); }
};

// Of all measured frames of a sequence, at least one.
struct Sequence_figures
{
  std::string kind;
  std::string group;
  std::vector<Frame_figures> frames{};
  bool was_cut_short = false;

  template <class Figure>
  double median(Figure figure) const
  {
    std::vector<double> values;
    for (const Frame_figures& frame : frames) {
      values.push_back(figure(frame));
    }
    return run::spread(values)->median;
  }

  // Of a changing population, what is usual.
  std::size_t points() const
  {
    return static_cast<std::size_t>(
        median([](const Frame_figures& frame) { return static_cast<double>(frame.points); }));
  }

  double median_ratio() const
  {
    return median([](const Frame_figures& frame) { return frame.ratio(); });
  }

  double worst_ratio() const
  {
    double worst = 0.0;
    for (const Frame_figures& frame : frames) {
      worst = (std::max)(worst, frame.ratio());
    }
    return worst;
  }

  // A count from the reports.
  double mean(std::size_t CGAL::Update_report_2::*count) const
  {
    double sum = 0.0;
    for (const Frame_figures& frame : frames) {
      sum += static_cast<double>(frame.report.*count);
    }
    return sum / static_cast<double>(frames.size());
  }

  std::size_t rebuilds() const
  {
    return static_cast<std::size_t>(
        std::count_if(frames.begin(), frames.end(),
                      [](const Frame_figures& frame) { return frame.report.rebuilt(); }));
  }
};

// From where on a median, or a single frame, is slower than it should be.
constexpr double slow_median = 1.05, slow_frame = 1.3;

inline bool is_slow(const Sequence_figures& figures)
{
  return figures.median_ratio() > slow_median || figures.worst_ratio() > slow_frame;
}

} // namespace any_motion

#endif // ANY_MOTION_SEQUENCE_FIGURES_H

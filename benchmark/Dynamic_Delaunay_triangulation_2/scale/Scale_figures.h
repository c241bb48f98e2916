// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SCALE_SCALE_FIGURES_H
#define SCALE_SCALE_FIGURES_H

#include "../common/Statistics.h"
#include "Scale_run.h"

#include <array>
#include <cstddef>
#include <vector>

namespace scale {

// Nanoseconds a point: medians over the frames, and the slowest frame.
struct Figures
{
  double total;
  double worst;
  double read;
  double classify;
  double repair;
  double certify;
  double flips; // a point and frame, mean

  std::array<double, 6> times() const { return {total, worst, read, classify, repair, certify}; }
};

inline Figures figures_of(const Series& series, std::size_t points)
{
  const auto per_point = [&](const auto& value) {
    return common::values_of(series.frames, [&](const Frame_times& frame) {
      return static_cast<double>(value(frame)) / static_cast<double>(points);
    });
  };
  const auto phase = [&](double common::Phase_times::*member) {
    return common::median(
        per_point([&](const Frame_times& frame) { return frame.phases.*member; }));
  };
  const std::vector<double> totals =
      per_point([](const Frame_times& frame) { return frame.total; });
  return {common::median(totals),
          common::largest(totals),
          phase(&common::Phase_times::read),
          phase(&common::Phase_times::classify),
          phase(&common::Phase_times::repair),
          phase(&common::Phase_times::certify),
          common::mean(per_point([](const Frame_times& frame) { return frame.update.flips; }))};
}

// The bytes a point that a frame has to move, by the sizes of the arrays, each of them once: the
// caller's point (16) and the number of its vertex (4) are read, its position (16) is written, and
// in the end a vertex handle (8) is read and the point in CGAL's vertex (16) written. In between
// lies a proof of every edge. The cheapest one known, skipping, reads the reference (16) of each
// vertex, the position where its edges were examined last, to find edges that may be skipped; the
// other one, passing, reads every edge, three to a point (48). Repeated reads, whole cache lines
// around eight or sixteen bytes, and repairs are not counted, as they are not necessary.
constexpr double bytes_of_skipping = 16 + 4 + 16 + 8 + 16 + 16;
constexpr double bytes_of_passing = 16 + 4 + 16 + 8 + 16 + 48;

} // namespace scale

#endif // SCALE_SCALE_FIGURES_H

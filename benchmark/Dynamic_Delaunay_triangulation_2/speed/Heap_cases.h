// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SPEED_HEAP_CASES_H
#define SPEED_HEAP_CASES_H

#include "../common/Cases.h"
#include "../common/Contest.h"
#include "../common/Counted_heap.h"
#include "scenario_runner/Motion.h"
#include "scenario_runner/Static_triangulation.h"

#include <CGAL/Dynamic_Delaunay_triangulation_2.h>

#include <cstddef>
#include <vector>

namespace speed {

using Exact_triangulation = CGAL::Dynamic_Delaunay_triangulation_2<run::Kernel>;

// The bytes on the heap that belong to the object that `make` returns.
template <class Make>
double heap_bytes_of(Make make)
{
  const std::size_t before = common::live_heap_bytes();
  const auto made = make();
  return static_cast<double>(common::live_heap_bytes() - before);
}

inline Exact_triangulation triangulation_of(const std::vector<scenario::Point>& points)
{
  return Exact_triangulation(points.begin(), points.end(), run::Point_map());
}

inline Exact_triangulation triangulation_after(std::size_t frames, scenario::Motion& motion)
{
  Exact_triangulation triangulation = triangulation_of(motion.points());
  for (std::size_t frame = 0; frame != frames; ++frame) {
    motion.advance({});
    triangulation.update(motion.points().begin(), motion.points().end(), run::Point_map());
  }
  return triangulation;
}

// Bytes a point, after some frames of a motion that needs no neighbors.
inline common::Figures memory_figures(scenario::Motion& motion, std::size_t frames)
{
  const auto points = static_cast<double>(motion.points().size());
  const double dynamic = heap_bytes_of([&] { return triangulation_after(frames, motion); });
  const double fresh = heap_bytes_of([&] { return common::fresh_triangulation(motion.points()); });
  return {{"points", points},
          {"frames", static_cast<double>(frames)},
          {"dynamic", dynamic / points},
          {"CGAL", fresh / points},
          {"beyond", (dynamic - fresh) / points}};
}

inline void shift(std::vector<scenario::Point>& points, double distance)
{
  for (scenario::Point& point : points) {
    point = {point.x + distance, point.y + distance};
  }
}

inline std::size_t allocations_of_update(Exact_triangulation& triangulation,
                                         const std::vector<scenario::Point>& points)
{
  const std::size_t before = common::number_of_allocations();
  const auto report = triangulation.update(points.begin(), points.end(), run::Point_map());
  const std::size_t allocations = common::number_of_allocations() - before;
  common::require(report.flips == 0 && report.splices == 0 && !report.rebuilt(),
                  "an edge changed where none should");
  return allocations;
}

// Allocations a frame in which all points move by the same tiny vector and no edge changes, once
// the first frames have made room for all that is needed again and again.
inline common::Figures allocation_figures(std::vector<scenario::Point> points, double distance)
{
  constexpr std::size_t first_frames = 20;
  constexpr std::size_t frames = 50;
  Exact_triangulation triangulation = triangulation_of(points);
  std::size_t allocations = 0;
  for (std::size_t frame = 0; frame != first_frames + frames; ++frame) {
    shift(points, distance);
    const std::size_t allocations_of_frame = allocations_of_update(triangulation, points);
    allocations += frame < first_frames ? 0 : allocations_of_frame;
  }
  return {{"points", static_cast<double>(points.size())},
          {"frames", static_cast<double>(frames)},
          {"allocations", static_cast<double>(allocations) / static_cast<double>(frames)}};
}

} // namespace speed

#endif // SPEED_HEAP_CASES_H

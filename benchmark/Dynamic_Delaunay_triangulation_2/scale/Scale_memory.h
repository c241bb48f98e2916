// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SCALE_SCALE_MEMORY_H
#define SCALE_SCALE_MEMORY_H

#include "../common/Contest.h"
#include "../common/Counted_heap.h"
#include "Scale_motion.h"
#include "scenario_runner/Static_triangulation.h"
#include "Threaded_triangulation.h"

#include <algorithm>
#include <cstddef>
#include <string>

namespace scale {

// Bytes on the heap, without the points that the caller has. Peaks are the most at any time of a
// construction, and of an update while the triangulation lives.
struct Memory_record
{
  std::size_t points = 0;
  unsigned threads = 0;
  double cgal = 0.0; // CGAL's own triangulation of the same points
  double constructed = 0.0;
  double construction_peak = 0.0;
  double calm = 0.0; // after some calm frames
  double rough = 0.0;
  double frame_peak = 0.0;
  double rebuilt = 0.0;
  double rebuild_peak = 0.0;

  double largest() const { return (std::max)({construction_peak, frame_peak, rebuild_peak}); }
};

class Memory_run
{
public:
  Memory_run(std::size_t points, unsigned threads)
    : m_points(points)
    , m_threads(threads)
  {
  }

  // Measures memory after a construction, after `frames` frames of each kind, and after a rebuild.
  Memory_record measure(const Motion_kind& calm, const Motion_kind& rough, std::size_t frames) const
  {
    Memory_record record;
    record.points = m_points;
    record.threads = m_threads;
    Scale_motion motion(m_points);
    record.cgal = bytes_of_cgal(motion.points());
    const Meter meter;
    Threaded_triangulation<In_the_plane> triangulation(m_threads);
    common::start_peak();
    triangulation.build(motion.points());
    record.constructed = meter.live();
    record.construction_peak = meter.peak();
    const auto follow = [&](const Motion_kind& kind) {
      for (std::size_t frame = 0; frame != frames; ++frame) {
        motion.advance(kind);
        triangulation.update(motion.points(), false);
      }
      return meter.live();
    };
    common::start_peak();
    record.calm = follow(calm);
    record.rough = follow(rough);
    record.frame_peak = meter.peak();
    common::start_peak();
    triangulation.update(motion.points(), true);
    record.rebuilt = meter.live();
    record.rebuild_peak = meter.peak();
    require_little(record);
    return record;
  }

private:
  // The bytes that the heap has grown by since the construction of the meter.
  class Meter
  {
  public:
    double live() const { return static_cast<double>(common::live_heap_bytes() - m_before); }
    double peak() const { return static_cast<double>(common::peak_heap_bytes() - m_before); }

  private:
    std::size_t m_before = common::live_heap_bytes();
  };

  // Requires peaks so low that neither the memory at rest, nor the 64 bytes a point of faces under
  // construction, can have been there twice.
  static void require_little(const Memory_record& record)
  {
    constexpr std::size_t many_points = 10'000; // of fewer, what is constant counts as well
    constexpr double most_bytes = 450;          // a point
    common::require(record.points < many_points ||
                        record.largest() <= most_bytes * static_cast<double>(record.points),
                    std::to_string(record.points) + " points need more than 450 bytes each");
  }

  static double bytes_of_cgal(const Points& points)
  {
    const Meter meter;
    const run::Static_triangulation triangulation(points.begin(), points.end());
    return meter.live();
  }

  std::size_t m_points;
  unsigned m_threads;
};

} // namespace scale

#endif // SCALE_SCALE_MEMORY_H

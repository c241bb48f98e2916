// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ANY_MOTION_FASTEST_STATIC_H
#define ANY_MOTION_FASTEST_STATIC_H

#include "../speed/Insertion_in_rounds.h"
#include "scenario_runner/Recorded_motion.h"
#include "scenario_runner/Static_triangulation.h"
#include "Thread_time.h"

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Static_triangulator_2.h>
#include <CGAL/hilbert_sort.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace any_motion {

// Three ways to triangulate a frame anew with CGAL's own means. Nobody knows which is the fastest
// before they have been tried. Whatever a program could have at hand before the frame comes, and
// all destruction, is outside of the timing.
class Fastest_static
{
public:
  // Before the first frame that is timed, and for each that is not.
  void follow(const scenario::Recorded_frame& frame)
  {
    read(frame);
    learn(frame);
  }

  // Before a frame is timed.
  void prepare(const scenario::Recorded_frame& frame)
  {
    read(frame);
    order_points(frame);
    learn(frame);
  }

  // The range, what a user writes.
  double time_insert()
  {
    return thread_nanoseconds_of(
        [this] { m_insert.emplace().insert(m_points.begin(), m_points.end()); });
  }

  // In rounds along the curve through the points of the frame before, each located from the last
  // one. Newcomers are not on that curve: they come last, and are sorted while the clock runs.
  double time_ordered()
  {
    return thread_nanoseconds_of([this] {
      run::Static_triangulation::Face_handle hint;
      m_ordered.emplace();
      const auto insert = [&](const Point_2& point) {
        hint = m_ordered->insert(point, hint)->face();
      };
      for (const Point_2& point : m_in_rounds) {
        insert(point);
      }
      sort(m_newcomers);
      for (const Point_2& point : m_newcomers) {
        insert(point);
      }
    });
  }

  // In rounds along a curve through the points where they are now.
  double time_sorted()
  {
    return thread_nanoseconds_of([this] {
      sort(m_unsorted);
      speed::insert_in_rounds(m_unsorted, m_sorted.emplace());
    });
  }

  // Of time_insert().
  const run::Static_triangulation& reference() const { return *m_insert; }

private:
  using Point_2 = run::Kernel::Point_2;

  // Halving boxes instead of sets of points takes a tenth off the whole on an even cloud.
  static void sort(std::vector<Point_2>& points)
  {
    if (points.empty()) {
      return; // CGAL's looks for the first one
    }
    CGAL::hilbert_sort(points.begin(), points.end(), CGAL::Hilbert_sort_middle_policy());
  }

  void read(const scenario::Recorded_frame& frame)
  {
    m_insert.reset();
    m_ordered.reset();
    m_sorted.reset();
    m_points.clear();
    for (const scenario::Point& point : frame.points) {
      m_points.emplace_back(point.x, point.y);
    }
    m_unsorted = m_points;
  }

  // For the next frame.
  void learn(const scenario::Recorded_frame& frame)
  {
    scenario::find_spatial_order(m_points, m_order);
    m_known_ids = frame.ids;
  }

  void order_points(const scenario::Recorded_frame& frame)
  {
    find_places(frame);
    std::vector<std::size_t> survivors;
    for (const std::size_t known : m_order) {
      if (m_places[known] != nowhere) {
        survivors.push_back(m_places[known]);
      }
    }
    m_in_rounds.clear();
    CGAL::Dynamic_Delaunay_triangulations_2::internal::for_each_in_rounds(
        survivors.size(), [&](std::size_t i) { m_in_rounds.push_back(m_points[survivors[i]]); });
  }

  // Where those of the frame before are in this one, and who is new. Both have ascending ids.
  void find_places(const scenario::Recorded_frame& frame)
  {
    m_places.assign(m_known_ids.size(), nowhere);
    m_newcomers.clear();
    std::size_t known = 0;
    for (std::size_t place = 0; place != frame.ids.size(); ++place) {
      while (known != m_known_ids.size() && m_known_ids[known] < frame.ids[place]) {
        ++known;
      }
      if (known != m_known_ids.size() && m_known_ids[known] == frame.ids[place]) {
        m_places[known] = place;
      } else {
        m_newcomers.push_back(m_points[place]);
      }
    }
  }

  static constexpr std::size_t nowhere = static_cast<std::size_t>(-1);

  std::vector<Point_2> m_points;
  std::vector<Point_2> m_unsorted;
  std::vector<Point_2> m_in_rounds;
  std::vector<Point_2> m_newcomers;
  std::vector<std::size_t> m_order; // of the frame before, along a Hilbert curve
  std::vector<std::int64_t> m_known_ids;
  std::vector<std::size_t> m_places; // in this frame of those before
  std::optional<run::Static_triangulation> m_insert;
  std::optional<run::Static_triangulation> m_ordered;
  std::optional<run::Static_triangulation> m_sorted;
};

} // namespace any_motion

#endif // ANY_MOTION_FASTEST_STATIC_H

// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef COMMON_FASTEST_STATIC_H
#define COMMON_FASTEST_STATIC_H

#include "Contest.h"
#include "scenario_runner/Measurement.h"
#include "scenario_runner/Recorded_motion.h"
#include "scenario_runner/Static_triangulation.h"
#include "Thread_time.h"

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/static/Static_triangulator_2.h>
#include <CGAL/hilbert_sort.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace common {

using CGAL::Dynamic_Delaunay_triangulations_2::internal::for_each_in_rounds;

// Halving boxes instead of sets of points takes a tenth off the whole on an even cloud.
inline void sort_along_curve(Points& points)
{
  if (!points.empty()) { // CGAL's looks for the first one
    CGAL::hilbert_sort(points.begin(), points.end(), CGAL::Hilbert_sort_middle_policy());
  }
}

// Inserts points, each located from the last one.
inline run::Static_triangulation::Face_handle
insert_one_by_one(const Points& points, run::Static_triangulation& triangulation,
                  run::Static_triangulation::Face_handle hint = {})
{
  for (const auto& point : points) {
    hint = triangulation.insert(point, hint)->face();
  }
  return hint;
}

// CGAL's insertion one by one, each point located from the last one, in rounds along the curve that
// the points are sorted by: every 8^k-th point first.
inline void insert_in_rounds(const Points& points, run::Static_triangulation& triangulation)
{
  run::Static_triangulation::Face_handle hint;
  for_each_in_rounds(points.size(),
                     [&](std::size_t i) { hint = triangulation.insert(points[i], hint)->face(); });
}

// Three ways to triangulate a frame anew with CGAL's own means. Which is the fastest is not
// known before they have been tried. Whatever a program could have at hand before the frame comes,
// and all destruction, is outside of the timing.
class Fastest_static
{
public:
  Fastest_static() { run::keep_freed_memory(); }

  // To be called for the first frame, and for each one that is not timed.
  void follow(const scenario::Recorded_frame& frame)
  {
    read(frame);
    learn(frame);
  }

  // To be called before a frame is timed.
  void prepare(const scenario::Recorded_frame& frame)
  {
    read(frame);
    order_points(frame);
    learn(frame);
  }

  // Inserts the range, as a user would write it.
  double time_insert()
  {
    return thread_nanoseconds_of(
        [this] { m_insert.emplace().insert(m_points.begin(), m_points.end()); });
  }

  // Inserts in rounds along the curve through the points of the frame before, each located from the
  // last one. New points are not on that curve: they are last, and are sorted while the clock runs.
  double time_ordered()
  {
    return thread_nanoseconds_of([this] {
      const auto hint = insert_one_by_one(m_in_rounds, m_ordered.emplace());
      sort_along_curve(m_newcomers);
      insert_one_by_one(m_newcomers, *m_ordered, hint);
    });
  }

  // Inserts in rounds along a curve through the points of this frame.
  double time_sorted()
  {
    return thread_nanoseconds_of([this] {
      sort_along_curve(m_unsorted);
      insert_in_rounds(m_unsorted, m_sorted.emplace());
    });
  }

  // The triangulation of time_insert().
  const run::Static_triangulation& reference() const { return *m_insert; }
  // The triangulation of time_ordered().
  const run::Static_triangulation& ordered() const { return *m_ordered; }

private:
  void read(const scenario::Recorded_frame& frame)
  {
    m_insert.reset();
    m_ordered.reset();
    m_sorted.reset();
    m_points = places_of(frame.points);
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
      if (m_places[known] != no_place) {
        survivors.push_back(m_places[known]);
      }
    }
    m_in_rounds.clear();
    for_each_in_rounds(survivors.size(),
                       [&](std::size_t i) { m_in_rounds.push_back(m_points[survivors[i]]); });
  }

  // Finds the last frame's points in this one, and the new points. Both frames have ascending ids.
  void find_places(const scenario::Recorded_frame& frame)
  {
    m_places.assign(m_known_ids.size(), no_place);
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

  static constexpr std::size_t no_place = static_cast<std::size_t>(-1);

  Points m_points;
  Points m_unsorted;
  Points m_in_rounds;
  Points m_newcomers;
  std::vector<std::size_t> m_order; // of the frame before, along a Hilbert curve
  std::vector<std::int64_t> m_known_ids;
  std::vector<std::size_t> m_places; // in this frame of those before
  std::optional<run::Static_triangulation> m_insert;
  std::optional<run::Static_triangulation> m_ordered;
  std::optional<run::Static_triangulation> m_sorted;
};

} // namespace common

#endif // COMMON_FASTEST_STATIC_H

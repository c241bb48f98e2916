// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef RUN_STATIC_OPPONENTS_H
#define RUN_STATIC_OPPONENTS_H

#include "../scenario/Motion.h"
#include "../scenario/Spatial_order.h"
#include "Kernel.h"
#include "Stopwatch.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace run {

// What the dynamic triangulation has to beat: two ways to triangulate a frame anew. Whatever a
// program could have at hand before the frame comes, and all destruction, is outside of the timing.
class Static_opponents
{
public:
  void prepare(const std::vector<scenario::Point>& points, bool population_changed)
  {
    m_insert.reset();
    m_fastest.reset();
    m_points.clear();
    for (const scenario::Point& point : points) {
      m_points.emplace_back(point.x, point.y);
    }
    // points that were not there a frame ago have no place in its order
    if (population_changed || m_order.size() != m_points.size()) {
      sort();
    }
    sort_points();
    sort(); // for the next frame
  }

  // CGAL's own insertion of a range, what a user writes.
  double time_insert()
  {
    return nanoseconds_of([this] { m_insert.emplace().insert(m_points.begin(), m_points.end()); });
  }

  // Insertion in the spatial order of the frame before, each point located from the last one: the
  // fastest way that we know with CGAL's own means.
  double time_fastest()
  {
    return nanoseconds_of([this] {
      Static_triangulation& triangulation = m_fastest.emplace();
      Static_triangulation::Face_handle hint;
      for (const Kernel::Point_2& point : m_sorted_points) {
        hint = triangulation.insert(point, hint)->face();
      }
    });
  }

  // Of time_insert().
  const Static_triangulation& reference() const { return *m_insert; }

private:
  void sort() { scenario::find_spatial_order(m_points, m_order); }

  // Along a Hilbert curve in rounds, every 8^k-th point first: that takes a fifth off the insertion
  // along the curve in one go, and is a little faster than the order of CGAL::spatial_sort().
  void sort_points()
  {
    constexpr std::size_t ratio = 8;
    m_sorted_points.clear();
    std::size_t stride = 1;
    while (stride < m_order.size()) {
      stride *= ratio;
    }
    for (; stride > 0; stride /= ratio) {
      for (std::size_t i = 0; i < m_order.size(); i += stride) {
        if (i % (stride * ratio) != 0 || stride >= m_order.size()) {
          m_sorted_points.push_back(m_points[m_order[i]]);
        }
      }
    }
  }

  std::vector<Kernel::Point_2> m_points;
  std::vector<Kernel::Point_2> m_sorted_points;
  std::vector<std::size_t> m_order;
  std::optional<Static_triangulation> m_insert;
  std::optional<Static_triangulation> m_fastest;
};

} // namespace run

#endif // RUN_STATIC_OPPONENTS_H

// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef RUN_STATIC_OPPONENTS_H
#define RUN_STATIC_OPPONENTS_H

#include "Kernel.h"
#include "Stopwatch.h"

#include <CGAL/hilbert_sort.h>
#include <CGAL/property_map.h>
#include <CGAL/Spatial_sort_traits_adapter_2.h>

#include <cstddef>
#include <numeric>
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
    m_sorted_points.clear();
    for (const std::size_t i : m_order) {
      m_sorted_points.push_back(m_points[i]);
    }
    sort(); // for the next frame
  }

  // CGAL's own insertion of a range, what a user writes.
  double time_insert()
  {
    return nanoseconds_of([this] { m_insert.emplace().insert(m_points.begin(), m_points.end()); });
  }

  // Insertion in the spatial order of the frame before, each point located from the last one.
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
  using Map = CGAL::Pointer_property_map<Kernel::Point_2>::const_type;

  void sort()
  {
    m_order.resize(m_points.size());
    std::iota(m_order.begin(), m_order.end(), std::size_t(0));
    CGAL::hilbert_sort(m_order.begin(), m_order.end(),
                       CGAL::Spatial_sort_traits_adapter_2<Kernel, Map>(Map(m_points.data())));
  }

  std::vector<Kernel::Point_2> m_points;
  std::vector<Kernel::Point_2> m_sorted_points;
  std::vector<std::size_t> m_order;
  std::optional<Static_triangulation> m_insert;
  std::optional<Static_triangulation> m_fastest;
};

} // namespace run

#endif // RUN_STATIC_OPPONENTS_H

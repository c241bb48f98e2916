// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "scenario_runner/space/Static_triangulation_3.h"

#include "scenario_runner/Measurement.h"

#include <CGAL/property_map.h>
#include <CGAL/spatial_sort.h>
#include <CGAL/Spatial_sort_traits_adapter_3.h>

#include <numeric>

namespace run {

Static_opponents_3::Static_opponents_3()
{
  keep_freed_memory();
}

void Static_opponents_3::prepare(const std::vector<scenario::Point_3>& points,
                                 bool population_changed)
{
  m_insert.reset();
  m_fastest.reset();
  m_points.clear();
  for (const auto& [x, y, z] : points) {
    m_points.emplace_back(x, y, z);
  }
  // points that were not there a frame ago have no place in its order
  if (population_changed || m_order.size() != m_points.size()) {
    find_order();
  }
  m_sorted_points.clear();
  for (const std::size_t i : m_order) {
    m_sorted_points.push_back(m_points[i]);
  }
  find_order(); // for the next frame
}

double Static_opponents_3::time_insert()
{
  return nanoseconds_of([this] { m_insert.emplace().insert(m_points.begin(), m_points.end()); });
}

double Static_opponents_3::time_fastest()
{
  return nanoseconds_of([this] {
    Triangulation& triangulation = m_fastest.emplace();
    Triangulation::Cell_handle hint;
    for (const Kernel::Point_3& point : m_sorted_points) {
      hint = triangulation.insert(point, hint)->cell();
    }
  });
}

void Static_opponents_3::find_order()
{
  using Map = CGAL::Pointer_property_map<Kernel::Point_3>::const_type;
  m_order.resize(m_points.size());
  std::iota(m_order.begin(), m_order.end(), std::size_t(0));
  CGAL::spatial_sort(m_order.begin(), m_order.end(),
                     CGAL::Spatial_sort_traits_adapter_3<Kernel, Map>(Map(m_points.data())));
}

} // namespace run

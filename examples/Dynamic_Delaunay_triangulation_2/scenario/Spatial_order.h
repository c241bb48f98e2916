// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SCENARIO_SPATIAL_ORDER_H
#define SCENARIO_SPATIAL_ORDER_H

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/hilbert_sort.h>
#include <CGAL/property_map.h>
#include <CGAL/Spatial_sort_traits_adapter_2.h>

#include <cstddef>
#include <numeric>
#include <vector>

namespace scenario {

// The places of points, in their order along a Hilbert curve.
inline void find_spatial_order(const std::vector<CGAL::Epick::Point_2>& points,
                               std::vector<std::size_t>& order)
{
  using Map = CGAL::Pointer_property_map<CGAL::Epick::Point_2>::const_type;
  order.resize(points.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  CGAL::hilbert_sort(order.begin(), order.end(),
                     CGAL::Spatial_sort_traits_adapter_2<CGAL::Epick, Map>(Map(points.data())));
}

} // namespace scenario

#endif // SCENARIO_SPATIAL_ORDER_H

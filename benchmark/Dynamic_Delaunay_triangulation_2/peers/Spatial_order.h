// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PEERS_SPATIAL_ORDER_H
#define PEERS_SPATIAL_ORDER_H

#include "Grid_points.h"

#include <CGAL/hilbert_sort.h>
#include <CGAL/property_map.h>
#include <CGAL/Spatial_sort_traits_adapter_2.h>

#include <cstddef>
#include <numeric>
#include <vector>

namespace peers {

// The ids of points along a Hilbert curve.
inline std::vector<std::size_t> spatial_order(const Points& points)
{
  using Map = CGAL::Pointer_property_map<Point>::const_type;
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  CGAL::hilbert_sort(order.begin(), order.end(),
                     CGAL::Spatial_sort_traits_adapter_2<run::Kernel, Map>(Map(points.data())));
  return order;
}

} // namespace peers

#endif // PEERS_SPATIAL_ORDER_H

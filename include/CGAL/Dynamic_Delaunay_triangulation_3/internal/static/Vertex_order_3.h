// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_STATIC_VERTEX_ORDER_3_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_STATIC_VERTEX_ORDER_3_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/passes/Elements_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/hilbert_sort.h>
#include <CGAL/Spatial_sort_traits_adapter_3.h>

#include <boost/property_map/function_property_map.hpp>

#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_3::internal {

// The numbers of positions along a Hilbert curve.
inline std::vector<Index> order_along_curve(const std::vector<Position_3>& positions)
{
  using Kernel = Exact_predicates_inexact_constructions_kernel;
  std::vector<Index> order(positions.size());
  std::iota(order.begin(), order.end(), Index(0));
  const auto point_of = [&positions](Index i) {
    const Position_3& p = positions[i];
    return Kernel::Point_3(p.x, p.y, p.z);
  };
  const auto map = boost::make_function_property_map<Index>(point_of);
  const Spatial_sort_traits_adapter_3<Kernel, decltype(map)> traits(map);
  hilbert_sort(order.begin(), order.end(), traits);
  return order;
}

} // namespace CGAL::Dynamic_Delaunay_triangulations_3::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_STATIC_VERTEX_ORDER_3_H

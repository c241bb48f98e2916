// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef RUN_KERNEL_H
#define RUN_KERNEL_H

#include "../scenario/Motion.h"

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <boost/property_map/property_map.hpp>

namespace run {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Static_triangulation = CGAL::Delaunay_triangulation_2<Kernel>;

// Lets CGAL read a scenario's points where they are.
struct Point_map
{
  using key_type = scenario::Point;
  using value_type = Kernel::Point_2;
  using reference = value_type;
  using category = boost::readable_property_map_tag;

  friend value_type get(const Point_map&, const key_type& point) { return {point.x, point.y}; }
};

} // namespace run

#endif // RUN_KERNEL_H

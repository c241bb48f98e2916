// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SCENARIO_RUNNER_STATIC_TRIANGULATION_H
#define SCENARIO_RUNNER_STATIC_TRIANGULATION_H

#include "scenario_runner/Measurement.h"
#include "scenario_runner/Motion.h"

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <optional>
#include <vector>

namespace scenario {

// The places of points, in their order along a Hilbert curve.
void find_spatial_order(const std::vector<CGAL::Epick::Point_2>& points,
                        std::vector<std::size_t>& order);

// Finds the neighbors of a motion by triangulating every frame anew, for programs that look at the
// physics alone.
class Static_neighbors
{
public:
  const Neighbor_edges& operator()(const std::vector<Point>& points);

private:
  std::vector<std::size_t> m_order;
  Neighbor_edges m_edges;
};

} // namespace scenario

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

// What the dynamic triangulation has to beat: two ways to triangulate a frame anew. Whatever a
// program could have at hand before the frame comes, and all destruction, is outside of the timing.
class Static_opponents
{
public:
  Static_opponents() { keep_freed_memory(); }

  void prepare(const std::vector<scenario::Point>& points, bool population_changed);

  // CGAL's own insertion of a range, as a user would write it.
  double time_insert();

  // Insertion in the spatial order of the frame before, each point located from the last one: the
  // fastest way that we know with CGAL's own means.
  double time_fastest();

  // The triangulation of time_insert().
  const Static_triangulation& reference() const { return *m_insert; }

private:
  void sort_points();

  std::vector<Kernel::Point_2> m_points;
  std::vector<Kernel::Point_2> m_sorted_points;
  std::vector<std::size_t> m_order;
  std::optional<Static_triangulation> m_insert;
  std::optional<Static_triangulation> m_fastest;
};

} // namespace run

#endif // SCENARIO_RUNNER_STATIC_TRIANGULATION_H

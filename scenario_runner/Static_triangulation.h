// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SCENARIO_RUNNER_STATIC_TRIANGULATION_H
#define SCENARIO_RUNNER_STATIC_TRIANGULATION_H

#include "scenario_runner/Measurement.h"
#include "scenario_runner/Motion.h"

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/hilbert_sort.h>
#include <CGAL/property_map.h>
#include <CGAL/Spatial_sort_traits_adapter_2.h>
#include <CGAL/Triangulation_data_structure_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <optional>
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

// Finds the neighbors of a motion by triangulating every frame anew, for programs that look at the
// physics alone.
class Static_neighbors
{
public:
  const Neighbor_edges& operator()(const std::vector<Point>& points)
  {
    if (m_order.size() != points.size()) {
      sort_along_curve(points);
    }
    m_edges.clear();
    m_triangulation.clear();
    insert(points);
    for (auto edge = m_triangulation.finite_edges_begin();
         edge != m_triangulation.finite_edges_end(); ++edge) {
      m_edges.emplace_back(edge->first->vertex(Triangulation::cw(edge->second))->info(),
                           edge->first->vertex(Triangulation::ccw(edge->second))->info());
    }
    return m_edges;
  }

private:
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Vertex_base = CGAL::Triangulation_vertex_base_with_info_2<std::uint32_t, Kernel>;
  using Data_structure = CGAL::Triangulation_data_structure_2<Vertex_base>;
  using Triangulation = CGAL::Delaunay_triangulation_2<Kernel, Data_structure>;

  void sort_along_curve(const std::vector<Point>& points)
  {
    std::vector<Kernel::Point_2> places;
    for (const Point& point : points) {
      places.emplace_back(point.x, point.y);
    }
    find_spatial_order(places, m_order);
  }

  // Coincident points share a vertex; an edge between them keeps them neighbors.
  void insert(const std::vector<Point>& points)
  {
    Triangulation::Face_handle hint;
    for (const std::size_t i : m_order) {
      const std::size_t before = m_triangulation.number_of_vertices();
      const auto vertex = m_triangulation.insert(Kernel::Point_2(points[i].x, points[i].y), hint);
      if (m_triangulation.number_of_vertices() == before) {
        m_edges.emplace_back(vertex->info(), static_cast<std::uint32_t>(i));
      } else {
        vertex->info() = static_cast<std::uint32_t>(i);
      }
      hint = vertex->face();
    }
  }

  Triangulation m_triangulation;
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

#endif // SCENARIO_RUNNER_STATIC_TRIANGULATION_H

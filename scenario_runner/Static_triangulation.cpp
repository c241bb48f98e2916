// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "scenario_runner/Static_triangulation.h"

#include "scenario_runner/Measurement.h"

#include <CGAL/hilbert_sort.h>
#include <CGAL/property_map.h>
#include <CGAL/Spatial_sort_traits_adapter_2.h>
#include <CGAL/Triangulation_data_structure_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <cstdint>
#include <numeric>

namespace scenario {

void find_spatial_order(const std::vector<CGAL::Epick::Point_2>& points,
                        std::vector<std::size_t>& order)
{
  using Map = CGAL::Pointer_property_map<CGAL::Epick::Point_2>::const_type;
  order.resize(points.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  CGAL::hilbert_sort(order.begin(), order.end(),
                     CGAL::Spatial_sort_traits_adapter_2<CGAL::Epick, Map>(Map(points.data())));
}

const Neighbor_edges& Static_neighbors::operator()(const std::vector<Point>& points)
{
  using Kernel = CGAL::Epick;
  using Vertex_base = CGAL::Triangulation_vertex_base_with_info_2<std::uint32_t, Kernel>;
  using Data_structure = CGAL::Triangulation_data_structure_2<Vertex_base>;
  using Triangulation = CGAL::Delaunay_triangulation_2<Kernel, Data_structure>;
  if (m_order.size() != points.size()) {
    std::vector<Kernel::Point_2> places;
    for (const Point& point : points) {
      places.emplace_back(point.x, point.y);
    }
    find_spatial_order(places, m_order);
  }
  m_edges.clear();
  Triangulation triangulation;
  Triangulation::Face_handle hint;
  for (const std::size_t i : m_order) {
    const std::size_t before = triangulation.number_of_vertices();
    const auto vertex = triangulation.insert(Kernel::Point_2(points[i].x, points[i].y), hint);
    if (triangulation.number_of_vertices() == before) {
      // Coincident points share a vertex; an edge between them keeps them neighbors.
      m_edges.emplace_back(vertex->info(), static_cast<std::uint32_t>(i));
    } else {
      vertex->info() = static_cast<std::uint32_t>(i);
    }
    hint = vertex->face();
  }
  for (auto edge = triangulation.finite_edges_begin(); edge != triangulation.finite_edges_end();
       ++edge) {
    m_edges.emplace_back(edge->first->vertex(Triangulation::cw(edge->second))->info(),
                         edge->first->vertex(Triangulation::ccw(edge->second))->info());
  }
  return m_edges;
}

} // namespace scenario

namespace run {

void Static_opponents::prepare(const std::vector<scenario::Point>& points, bool population_changed)
{
  m_insert.reset();
  m_fastest.reset();
  m_points.clear();
  for (const scenario::Point& point : points) {
    m_points.emplace_back(point.x, point.y);
  }
  // points that were not there a frame ago have no place in its order
  if (population_changed || m_order.size() != m_points.size()) {
    scenario::find_spatial_order(m_points, m_order);
  }
  sort_points();
  scenario::find_spatial_order(m_points, m_order); // for the next frame
}

double Static_opponents::time_insert()
{
  return nanoseconds_of([this] { m_insert.emplace().insert(m_points.begin(), m_points.end()); });
}

double Static_opponents::time_fastest()
{
  return nanoseconds_of([this] {
    Static_triangulation& triangulation = m_fastest.emplace();
    Static_triangulation::Face_handle hint;
    for (const Kernel::Point_2& point : m_sorted_points) {
      hint = triangulation.insert(point, hint)->face();
    }
  });
}

// Along a Hilbert curve in rounds, every 8^k-th point first: that takes a fifth off the insertion
// along the curve in one go, and is a little faster than the order of CGAL::spatial_sort().
void Static_opponents::sort_points()
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

} // namespace run

// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SCENARIO_STATIC_NEIGHBORS_H
#define SCENARIO_STATIC_NEIGHBORS_H

#include "Motion.h"
#include "Spatial_order.h"

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_data_structure_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace scenario {

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

#endif // SCENARIO_STATIC_NEIGHBORS_H

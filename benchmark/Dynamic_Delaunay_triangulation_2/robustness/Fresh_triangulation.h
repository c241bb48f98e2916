// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ROBUSTNESS_FRESH_TRIANGULATION_H
#define ROBUSTNESS_FRESH_TRIANGULATION_H

#include "Finding.h"

#include <CGAL/delaunay_agreement.h>
#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace robustness {

// CGAL's own triangulation of the same points, which a certified one has to equal.
template <class Dynamic>
class Fresh_triangulation
{
  using Kernel = typename Dynamic::Geom_traits;
  using Vertex = CGAL::Triangulation_vertex_base_with_info_2<std::size_t, Kernel>;
  using Tds = CGAL::Triangulation_data_structure_2<Vertex>;
  using Triangulation = CGAL::Delaunay_triangulation_2<Kernel, Tds>;
  using Point = typename Kernel::Point_2;
  using Edges = std::vector<std::pair<std::size_t, std::size_t>>;

public:
  // `ids` are those of all points.
  Fresh_triangulation(const Dynamic& dynamic, const std::vector<std::size_t>& ids)
    : m_dynamic(dynamic)
    , m_vertex_of_id(dynamic.number_of_ids())
  {
    typename Triangulation::Face_handle near;
    for (const std::size_t id : ids) {
      const std::size_t vertices = m_fresh.number_of_vertices();
      const auto vertex = m_fresh.insert(dynamic.point(id), near);
      if (m_fresh.number_of_vertices() > vertices) {
        vertex->info() = vertices;
      }
      near = vertex->face();
      m_vertex_of_id[id] = vertex->info();
    }
  }

  void check() const
  {
    require(m_fresh.number_of_vertices() == m_dynamic.number_of_vertices(), Fault::WRONG,
            "another number of vertices than a fresh triangulation");
    require(m_fresh.dimension() == m_dynamic.triangulation().dimension(), Fault::WRONG,
            "another dimension than a fresh triangulation");
    if (edges() != dynamic_edges()) { // where points are cocircular, both may be right
      const CGAL::Delaunay_agreement agreement = CGAL::delaunay_agreement(m_dynamic, m_fresh);
      require(agreement.is_perfect(), Fault::WRONG, "certified, but not Delaunay");
    }
  }

private:
  static void add(std::size_t v, std::size_t w, Edges& edges)
  {
    edges.emplace_back((std::min)(v, w), (std::max)(v, w));
  }

  Edges edges() const
  {
    Edges edges;
    for (auto e = m_fresh.finite_edges_begin(); e != m_fresh.finite_edges_end(); ++e) {
      add(e->first->vertex(m_fresh.cw(e->second))->info(),
          e->first->vertex(m_fresh.ccw(e->second))->info(), edges);
    }
    std::sort(edges.begin(), edges.end());
    return edges;
  }

  Edges dynamic_edges() const
  {
    Edges edges;
    m_dynamic.for_each_edge(
        [&](std::size_t i, std::size_t j) { add(m_vertex_of_id[i], m_vertex_of_id[j], edges); });
    std::sort(edges.begin(), edges.end());
    return edges;
  }

  const Dynamic& m_dynamic;
  Triangulation m_fresh;
  std::vector<std::size_t> m_vertex_of_id; // numbers of the fresh one
};

} // namespace robustness

#endif // ROBUSTNESS_FRESH_TRIANGULATION_H

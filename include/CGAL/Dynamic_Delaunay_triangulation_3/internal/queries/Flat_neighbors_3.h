// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_QUERIES_FLAT_NEIGHBORS_3_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_QUERIES_FLAT_NEIGHBORS_3_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/passes/Elements_3.h>
#include <CGAL/enum.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <utility>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_3::internal {

// The neighbors of all vertices where there are no cells: the points are in a plane or on a line.
class Flat_neighbors_3
{
public:
  // Lists the ends of all edges.
  template <class State>
  void list_ends(const State& state)
  {
    std::vector<Edge> edges;
    for (const auto& edge : state.flat_edges)
      edges.push_back(make_edge(edge[0], edge[1]));
    list(state.number_of_vertices(), edges);
  }

  // Lists those whose Voronoi cells share a facet. An edge between triangles of one circle has
  // none.
  template <class State>
  void list_cells(const State& state)
  {
    std::vector<Edge> edges, without_facet;
    for (const auto& edge : state.flat_edges)
      edges.push_back(make_edge(edge[0], edge[1]));
    find_edges_in_circles(state, without_facet);
    std::sort(edges.begin(), edges.end());
    std::vector<Edge> with_facet;
    std::set_difference(edges.begin(), edges.end(), without_facet.begin(), without_facet.end(),
                        std::back_inserter(with_facet));
    list(state.number_of_vertices(), with_facet);
  }

  // Calls f(w) for each neighbor.
  template <class Function>
  void for_each_neighbor(Vertex_index v, const Function& f) const
  {
    for (std::size_t i = m_begins[v]; i < m_begins[v + std::size_t(1)]; ++i)
      f(m_ends[i]);
  }

private:
  using Edge = std::pair<Vertex_index, Vertex_index>; // ascending

  static Edge make_edge(Vertex_index v, Vertex_index w)
  {
    return {(std::min)(v, w), (std::max)(v, w)};
  }

  // Lists, sorted, the edges between two triangles whose vertices are on one circle.
  template <class State>
  static void find_edges_in_circles(const State& state, std::vector<Edge>& found)
  {
    std::vector<std::pair<Edge, Vertex_index>> sides; // an edge and the vertex opposite to it
    for (const auto& t : state.flat_triangles)
      for (int i = 0; i < 3; ++i)
        sides.emplace_back(make_edge(t[(i + 1) % 3], t[(i + 2) % 3]), t[i]);
    std::sort(sides.begin(), sides.end());
    const auto side = state.traits.coplanar_side_of_bounded_circle_3_object();
    for (std::size_t i = 1; i < sides.size(); ++i)
      if (const Edge& edge = sides[i].first; edge == sides[i - 1].first)
        if (side(state.point(edge.first), state.point(edge.second), state.point(sides[i].second),
                 state.point(sides[i - 1].second)) == ON_BOUNDARY)
          found.push_back(edge);
  }

  void list(Index vertices, const std::vector<Edge>& edges)
  {
    m_begins.assign(vertices + std::size_t(2), 0);
    for (const auto& [v, w] : edges) {
      ++m_begins[v + std::size_t(1)];
      ++m_begins[w + std::size_t(1)];
    }
    for (std::size_t i = 1; i < m_begins.size(); ++i)
      m_begins[i] += m_begins[i - 1];
    m_ends.resize(2 * edges.size());
    std::vector<std::size_t> entries(m_begins);
    for (const auto& [v, w] : edges) {
      m_ends[entries[v]++] = w;
      m_ends[entries[w]++] = v;
    }
  }

  std::vector<std::size_t> m_begins; // of each vertex, in m_ends
  std::vector<Vertex_index> m_ends;
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_3::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_QUERIES_FLAT_NEIGHBORS_3_H

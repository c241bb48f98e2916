// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_SPACE_POINT_NUMBERING_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_SPACE_POINT_NUMBERING_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Flat_arrays.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Flat_elements_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Points_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Spatial_order_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/topology/Point_ids_2.h>
#include <CGAL/enum.h>

#include <boost/iterator/counting_iterator.hpp>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

// Puts points into a spatial order, distinguishes representatives from covered points, and numbers
// the vertices in that order. Of coincident points, it makes one that keeps its vertex, if there is
// any, the representative.
template <class State>
class Point_numbering_2
{
  using Point = typename State::Point;
  using Ids = Point_ids_2<Point>;
  using Parts = typename State::Parts;

public:
  explicit Point_numbering_2(const State& state)
    : m_state(state)
  {
  }

  // Numbers these points with these ids. All ids are smaller than `number_of_ids`.
  // `keeps_vertex(id)` is true if the point already has a vertex of its own, and stays.
  template <class Predicate>
  void number(std::vector<Point_id> ids, std::vector<Point> points, Index number_of_ids,
              const Predicate& keeps_vertex)
  {
    m_point_ids = std::move(ids);
    m_points = std::move(points);
    sort_points();
    number_points(number_of_ids, keeps_vertex);
  }

  // Numbers the vertices of the maintained triangulation, at their present positions and in this
  // order. No vertices may coincide, and there must be no covered points.
  void number(Spatial_order_2 order)
  {
    const Index vertices = m_state.number_of_vertices();
    m_order = std::move(order);
    m_point_ids.resize(vertices + std::size_t(1)); // the infinite vertex has no point
    m_points.resize(vertices + std::size_t(1));
    Parts::for_each_element(vertices, [&](std::size_t i) {
      const Vertex_index v(i + 1);
      m_point_ids[v] = m_state.ids().representative(v);
      m_points[v] = m_state.point(v);
    });
    number_points(m_state.ids().number_of_ids(), [](Point_id) { return true; });
  }

  // Numbers all points of the maintained triangulation, at their present positions.
  void number()
  {
    const Ids& ids = m_state.ids();
    std::vector<Point_id> point_ids = ids.representatives_and_covered();
    std::vector<Point> points;
    points.reserve(point_ids.size());
    for (Vertex_index v(1); v <= m_state.number_of_vertices(); ++v)
      points.push_back(m_state.point(v));
    for (std::size_t i = points.size(); i < point_ids.size(); ++i)
      points.push_back(ids.covered_point(point_ids[i]));
    number(std::move(point_ids), std::move(points), ids.number_of_ids(),
           [&](Point_id id) { return ids.is_representative(id); });
  }

  // The spatial order of the vertices, given by their new numbers.
  const Spatial_order_2& order() const { return m_order; }
  // The results: the ids, and the point of each vertex.
  Ids& ids() { return m_ids; }
  const Point& point(Vertex_index vertex) const { return m_points[m_place_of_vertex[vertex - 1]]; }

  // Free the memory of the points, of the order, or of everything. Throw nothing.
  void release_points()
  {
    std::vector<Point>().swap(m_points);
    std::vector<Point_id>().swap(m_point_ids);
    Uninitialized_vector<Index>().swap(m_place_of_vertex);
  }
  void release_order() { m_order.release(); }
  void release()
  {
    release_points();
    release_order();
    m_ids = Ids();
  }

private:
  // Replaces the indices of points in the order by numbers of vertices.
  template <class Predicate>
  void number_points(Index number_of_ids, const Predicate& keeps_vertex)
  {
    const auto are_in_one_place = [this](Index i, Index j) {
      return coincide(m_state.traits(), m_points[i], m_points[j]);
    };
    m_ids.template reset<Parts>(number_of_ids);
    m_place_of_vertex.clear();
    m_place_of_vertex.reserve(m_points.size());
    if (m_order.template are_distinct<Parts>(are_in_one_place))
      number_distinct_points();
    else
      m_order.merge_coincident(are_in_one_place, [&](std::size_t first, std::size_t beyond) {
        return add_vertex(first, beyond, keeps_vertex);
      });
    m_ids.finish_numbering();
  }

  // Each point gets a vertex, numbered by its place in the order, so threads work independently.
  void number_distinct_points()
  {
    m_place_of_vertex.resize(m_order.size());
    m_ids.resize(Index(m_order.size()));
    Parts::for_each_element(m_order.size(), [&](std::size_t i) {
      const Index place = m_order[i];
      const Vertex_index vertex(i + 1);
      m_place_of_vertex[i] = place;
      m_ids.set_representative(vertex, m_point_ids[place]);
      m_order.renumber(i, vertex);
    });
  }

  void sort_points()
  {
    const boost::counting_iterator<Index> first(0), beyond(Index(m_points.size()));
    if (m_state.positions_are_exact()) {
      Uninitialized_vector<Position_2> positions(m_points.size());
      Parts::for_each_element(m_points.size(),
                              [&](std::size_t i) { positions[i] = approximation(m_points[i]); });
      m_order.template sort<Parts>(positions, first, beyond);
    } else
      m_order.sort_by_comparisons(first, beyond, [this](Index i, Index j) {
        return compare_xy(m_state.traits(), m_points[i], m_points[j]) == SMALLER;
      });
  }

  // Adds a vertex for the coincident points in these places of the order.
  template <class Predicate>
  Vertex_index add_vertex(std::size_t first, std::size_t beyond, const Predicate& keeps_vertex)
  {
    std::size_t representative = first;
    while (representative < beyond && !keeps_vertex(m_point_ids[m_order[representative]]))
      ++representative;
    if (representative == beyond)
      representative = first;
    const Vertex_index vertex = m_ids.add_representative(m_point_ids[m_order[representative]]);
    m_place_of_vertex.push_back(m_order[representative]);
    for (std::size_t i = first; i < beyond; ++i)
      if (i != representative)
        m_ids.cover(m_point_ids[m_order[i]], vertex, m_points[m_order[i]]);
    return vertex;
  }

  const State& m_state;
  Spatial_order_2 m_order;
  std::vector<Point> m_points; // the points to number
  std::vector<Point_id> m_point_ids;
  Uninitialized_vector<Index> m_place_of_vertex; // index in m_points of its representative
  Ids m_ids;
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_SPACE_POINT_NUMBERING_2_H

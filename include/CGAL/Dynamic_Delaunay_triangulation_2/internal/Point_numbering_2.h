// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_POINT_NUMBERING_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_POINT_NUMBERING_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Neighborhood_mirror_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Planar_points_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Point_ids_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Spatial_order_2.h>
#include <CGAL/enum.h>

#include <boost/iterator/counting_iterator.hpp>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Dynamic_Delaunay_triangulations_2 {
namespace internal {

// Puts points into a spatial order, tells representatives from duplicates, and numbers the vertices
// in that order. Whoever was a representative stays one where points coincide.
template <class Maintained>
class Point_numbering_2
{
  using Point = typename Maintained::Point;
  using Ids = Point_ids_2<Point>;

public:
  explicit Point_numbering_2(const Maintained& maintained)
    : m_maintained(maintained)
  {
  }

  // Takes these points, with these ids, all of which are smaller than `number_of_ids`.
  void number(std::vector<Index> ids, std::vector<Point> points, Index number_of_ids)
  {
    m_point_ids = std::move(ids);
    m_points = std::move(points);
    sort_points();
    number_points(number_of_ids);
  }

  // Takes the vertices of the maintained triangulation, where they are now, in this order. None
  // coincide, and there are no duplicates.
  void number(Spatial_order_2 order)
  {
    const Index vertices = m_maintained.number_of_vertices();
    m_order = std::move(order);
    m_point_ids.resize(vertices + std::size_t(1)); // the infinite vertex has no point
    m_points.resize(vertices + std::size_t(1));
    for (Index v = 1; v <= vertices; ++v) {
      m_point_ids[v] = m_maintained.ids().representative(v);
      m_points[v] = m_maintained.point(v);
    }
    number_points(m_maintained.ids().number_of_ids());
  }

  // Takes the points of the maintained triangulation, where they are now.
  void number()
  {
    const Ids& ids = m_maintained.ids();
    std::vector<Index> point_ids = ids.representatives_and_duplicates();
    std::vector<Point> points;
    points.reserve(point_ids.size());
    for (Index v = 1; v <= m_maintained.number_of_vertices(); ++v)
      points.push_back(m_maintained.point(v));
    for (const auto& duplicate : ids.duplicates())
      points.push_back(duplicate.point);
    number(std::move(point_ids), std::move(points), ids.number_of_ids());
  }

  // The vertices by their numbers.
  const Spatial_order_2& order() const { return m_order; }
  // After numbering: who they are, and where each is.
  Ids& ids() { return m_ids; }
  const Point& point(Index vertex) const { return m_points[m_place_of_vertex[vertex - 1]]; }

  void release()
  {
    m_order.release();
    m_ids = Ids();
    std::vector<Point>().swap(m_points);
    std::vector<Index>().swap(m_point_ids);
    std::vector<Index>().swap(m_place_of_vertex);
  }

private:
  // The indices of points in the order become numbers of vertices.
  void number_points(Index number_of_ids)
  {
    m_ids.reset(number_of_ids);
    m_place_of_vertex.clear();
    m_place_of_vertex.reserve(m_points.size());
    m_order.merge_coincident(
        [this](Index i, Index j) {
          return coincide(m_maintained.traits(), m_points[i], m_points[j]);
        },
        [this](std::size_t first, std::size_t beyond) { return add_vertex(first, beyond); });
    m_ids.settle();
  }

  void sort_points()
  {
    const boost::counting_iterator<Index> first(0), beyond(Index(m_points.size()));
    if (m_maintained.positions_are_exact()) {
      std::vector<Position_2> positions;
      positions.reserve(m_points.size());
      for (const Point& p : m_points)
        positions.push_back(approximation(p));
      m_order.sort(positions, first, beyond);
    } else
      m_order.sort_by_comparisons(first, beyond, [this](Index i, Index j) {
        return compare_xy(m_maintained.traits(), m_points[i], m_points[j]) == SMALLER;
      });
  }

  // One for the points in these places of the order.
  Index add_vertex(std::size_t first, std::size_t beyond)
  {
    std::size_t representative = first;
    while (representative + 1 < beyond && !was_representative(m_point_ids[m_order[representative]]))
      ++representative;
    if (!was_representative(m_point_ids[m_order[representative]]))
      representative = first;
    const Index id = m_point_ids[m_order[representative]];
    const Index vertex = m_ids.add_representative(id);
    m_place_of_vertex.push_back(m_order[representative]);
    for (std::size_t i = first; i < beyond; ++i)
      if (i != representative)
        m_ids.add_duplicate(m_point_ids[m_order[i]], id, m_points[m_order[i]]);
    return vertex;
  }

  bool was_representative(Index id) const
  {
    const Ids& ids = m_maintained.ids();
    return ids.is_taken(id) && ids.is_representative(id);
  }

  const Maintained& m_maintained;
  Spatial_order_2 m_order;
  std::vector<Point> m_points; // those that are numbered
  std::vector<Index> m_point_ids;
  std::vector<Index> m_place_of_vertex; // of its representative in m_points
  Ids m_ids;
};

} // namespace internal
} // namespace Dynamic_Delaunay_triangulations_2
} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_POINT_NUMBERING_2_H

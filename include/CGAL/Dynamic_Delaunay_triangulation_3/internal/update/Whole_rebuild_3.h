// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_UPDATE_WHOLE_REBUILD_3_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_UPDATE_WHOLE_REBUILD_3_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/space/Input_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/static/Vertex_order_3.h>

#include <cstddef>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_3::internal {

// Triangulates all points anew, with new numbers of vertices.
template <class Space>
class Whole_rebuild_3
{
  using State = typename Space::State;
  using Point = typename State::Point;
  using Place = typename State::Place;

public:
  explicit Whole_rebuild_3(State& state)
    : m_state(state)
    , m_static(state)
  {
  }

  // Triangulates all points anew. Each gets a vertex, in the order of the old ones, or along a
  // curve; then those that coincide with others lose theirs. If memory runs out, no point is lost.
  void run(const Change_3<Point>& change, bool is_order_lost)
  {
    m_state.begin_rebuild();
    std::vector<Located> points = all_points(change);
    if (is_order_lost)
      sort_along_curve(points);
    take_over(points);
    std::vector<std::pair<Vertex_index, Vertex_index>> covered;
    m_static.triangulate(covered);
    if (!covered.empty())
      cover(points, covered);
  }

private:
  enum class Kind { REPRESENTATIVE, COVERED, NEW };

  struct Located
  {
    Point_id id;
    Place place;
    Kind kind;

    // Whether it represents the other point where they coincide.
    bool precedes(const Located& other) const
    {
      return std::tie(kind, id) < std::tie(other.kind, other.id);
    }
  };

  std::vector<Located> all_points(const Change_3<Point>& change) const
  {
    const auto& ids = m_state.ids;
    std::vector<Located> points;
    points.reserve(ids.number_of_points() + change.coming.size());
    for (Vertex_index v(1); v < m_state.positions.number(); ++v)
      if (ids.has_representative(v))
        points.push_back({ids.representative(v), m_state.place_anew(v), Kind::REPRESENTATIVE});
    for (const Point_id id : ids.covered_ids())
      points.push_back({id, m_state.place_of(ids.covered_point(id)), Kind::COVERED});
    for (std::size_t i = 0; i < change.coming.size(); ++i)
      if (!ids.is_taken(change.coming[i]))
        points.push_back({change.coming[i], m_state.place_of(change.coming_points[i]), Kind::NEW});
    return points;
  }

  // Gives each point a vertex of its own.
  void take_over(const std::vector<Located>& points)
  {
    typename State::Ids ids;
    typename State::Positions positions;
    ids.reset(m_state.ids.number_of_ids());
    positions.resize(Index(points.size()) + 1);
    for (const Located& point : points)
      positions.set(ids.add_representative(point.id), point.place);
    ids.finish_numbering();
    m_state.positions.swap(positions);
    std::swap(m_state.ids, ids);
    m_state.include_all();
  }

  // Takes the vertices from points that coincide with those of others. Of each such set the point
  // that precedes the others represents them.
  void cover(std::vector<Located>& points,
             const std::vector<std::pair<Vertex_index, Vertex_index>>& covered)
  {
    Column<Vertex_index, Vertex_index> numbers(points.size() + 1, infinite_index);
    for (const auto& [v, other] : covered) {
      numbers[v] = null_index;
      if (points[v - 1].precedes(points[other - 1]))
        exchange(points[v - 1], points[other - 1], other);
    }
    typename State::Ids ids;
    typename State::Positions positions;
    ids.reset(m_state.ids.number_of_ids());
    positions.resize(Index(points.size() - covered.size()) + 1);
    for (Vertex_index v(1); v <= points.size(); ++v)
      if (numbers[v] != null_index) {
        numbers[v] = ids.add_representative(points[v - 1].id);
        positions.set(numbers[v], points[v - 1].place);
      }
    for (const auto& [v, other] : covered)
      ids.cover(points[v - 1].id, numbers[other], m_state.point_at(points[v - 1].place));
    ids.finish_numbering();
    m_state.renumber_vertices(numbers, Index(positions.number()));
    m_state.positions.swap(positions);
    std::swap(m_state.ids, ids);
    m_state.include_all();
  }

  // Exchanges points that coincide. The vertex that has cells stays where it is: on a torus, at
  // that image of its new point.
  void exchange(Located& covered, Located& representative, Vertex_index v) const
  {
    std::swap(covered, representative);
    representative.place = m_state.place_near(m_state.point_at(representative.place), v);
  }

  static void sort_along_curve(std::vector<Located>& points)
  {
    std::vector<Position_3> positions;
    positions.reserve(points.size());
    for (const Located& point : points)
      positions.push_back(point.place.position);
    std::vector<Located> sorted;
    sorted.reserve(points.size());
    for (const Index i : Order_along_curve_3<typename State::Parts>(positions).run())
      sorted.push_back(points[i]);
    points.swap(sorted);
  }

  State& m_state;
  typename Space::Static m_static;
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_3::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_UPDATE_WHOLE_REBUILD_3_H

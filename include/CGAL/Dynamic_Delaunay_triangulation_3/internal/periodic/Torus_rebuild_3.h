// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_PERIODIC_TORUS_REBUILD_3_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_PERIODIC_TORUS_REBUILD_3_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/periodic/Torus_triangulator_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/space/Input_3.h>

#include <cstddef>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_3::internal {

// Triangulates all points of a torus anew, with new numbers of vertices, and a short basis.
template <class State>
class Torus_rebuild_3
{
  using Point = typename State::Point;

public:
  explicit Torus_rebuild_3(State& state)
    : m_state(state)
    , m_triangulator(state)
  {
  }

  // Each point gets a vertex, along a curve through the cell; then those that coincide with others
  // lose theirs. If memory runs out, no point is lost.
  void run(const Change_3<Point>& change)
  {
    Torus_3 torus = m_state.torus.with_short_basis();
    const std::vector<Located> points = sorted_along_curve(all_points(change, torus));
    m_state.torus = torus;
    take_over(points);
    typename Torus_triangulator_3<State>::Covered covered;
    m_triangulator.triangulate(covered);
    if (!covered.empty())
      cover(points, covered);
  }

private:
  enum class Kind { REPRESENTATIVE, COVERED, NEW };

  struct Located
  {
    Point_id id;
    Torus_place_3 place;
    Kind kind;

    // Whether it represents the other point where they coincide.
    bool precedes(const Located& other) const
    {
      return std::tie(kind, id) < std::tie(other.kind, other.id);
    }
    Point point() const { return Point(place.base.x, place.base.y, place.base.z); }
  };

  std::vector<Located> all_points(const Change_3<Point>& change, const Torus_3& torus) const
  {
    const auto& ids = m_state.ids;
    std::vector<Located> points;
    points.reserve(ids.number_of_points() + change.coming.size());
    const auto add = [&](Point_id id, const Position_3& base, Kind kind) {
      const Multiples_3 multiples = Torus_3::floor(torus.fractions(base));
      points.push_back({id, Torus_place_3(base, Multiples_3{0, 0, 0} - multiples, torus), kind});
    };
    for (Vertex_index v(1); v < m_state.positions.number(); ++v)
      if (ids.has_representative(v))
        add(ids.representative(v), m_state.positions.base(v), Kind::REPRESENTATIVE);
    for (const Point_id id : ids.covered_ids())
      add(id, approximation(ids.covered_point(id)), Kind::COVERED);
    for (std::size_t i = 0; i < change.coming.size(); ++i)
      if (!ids.is_taken(change.coming[i]))
        add(change.coming[i], approximation(change.coming_points[i]), Kind::NEW);
    return points;
  }

  static std::vector<Located> sorted_along_curve(const std::vector<Located>& points)
  {
    std::vector<Position_3> positions;
    positions.reserve(points.size());
    for (const Located& point : points)
      positions.push_back(point.place.position);
    std::vector<Located> sorted;
    sorted.reserve(points.size());
    for (const Index i : order_along_curve(positions))
      sorted.push_back(points[i]);
    return sorted;
  }

  // Gives each point a vertex of its own.
  void take_over(const std::vector<Located>& points)
  {
    typename State::Ids ids;
    Torus_positions_3 positions;
    ids.reset(m_state.ids.number_of_ids());
    positions.resize(Index(points.size()) + 1);
    for (const Located& point : points)
      positions.set(ids.add_representative(point.id), point.place);
    ids.finish_numbering();
    m_state.arrays.clear_cells();
    m_state.positions.swap(positions);
    std::swap(m_state.ids, ids);
    m_state.set_error(nullptr);
  }

  // Takes the vertices from points that coincide with those of others. Of each such set the point
  // that precedes the others represents them.
  void cover(std::vector<Located> points,
             const typename Torus_triangulator_3<State>::Covered& covered)
  {
    Column<Vertex_index, Vertex_index> numbers(points.size() + 1, infinite_index);
    for (const auto& [v, other] : covered) {
      numbers[v] = null_index;
      if (points[v - 1].precedes(points[other - 1]))
        exchange(points[v - 1], points[other - 1]);
    }
    typename State::Ids ids;
    Torus_positions_3 positions;
    ids.reset(m_state.ids.number_of_ids());
    positions.resize(Index(points.size() - covered.size()) + 1);
    for (Vertex_index v(1); v <= points.size(); ++v)
      if (numbers[v] != null_index) {
        numbers[v] = ids.add_representative(points[v - 1].id);
        positions.set(numbers[v], points[v - 1].place);
      }
    for (const auto& [v, other] : covered)
      ids.cover(points[v - 1].id, numbers[other], points[v - 1].point());
    ids.finish_numbering();
    m_state.arrays.renumber_all(numbers, Index(positions.number()));
    m_state.positions.swap(positions);
    std::swap(m_state.ids, ids);
    m_state.set_error(nullptr);
  }

  // Exchanges points that coincide. The vertex that has cells stays where it is: the new point's
  // multiples may differ where rounding has wrapped them differently.
  void exchange(Located& covered, Located& representative) const
  {
    const Position_3 position = representative.place.position;
    std::swap(covered, representative);
    representative.place = m_state.place_at(representative.place.base, position);
  }

  State& m_state;
  Torus_triangulator_3<State> m_triangulator;
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_3::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_PERIODIC_TORUS_REBUILD_3_H

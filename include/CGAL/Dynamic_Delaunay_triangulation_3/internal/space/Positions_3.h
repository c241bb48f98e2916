// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_SPACE_POSITIONS_3_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_SPACE_POSITIONS_3_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/passes/Elements_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/passes/Points_3.h>

#include <limits>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_3::internal {

// Where a vertex is: its position and, where coordinates are not doubles, its point.
template <class Point, bool are_doubles = is_three_doubles<Point>>
struct Place_3
{
  Place_3() = default;
  Place_3(const Position_3& p, const Point&)
    : position(p)
  {
  }
  explicit Place_3(const Position_3& p)
    : position(p)
  {
  }
  Point point() const { return Point(position.x, position.y, position.z); }

  Position_3 position{0, 0, 0};
};
template <class Point>
struct Place_3<Point, false>
{
  Place_3() = default;
  Place_3(const Position_3& p, const Point& exact)
    : position(p)
    , exact_point(exact)
  {
  }
  explicit Place_3(const Position_3& p)
    : position(p)
    , exact_point(p.x, p.y, p.z)
  {
  }
  const Point& point() const { return exact_point; }

  Position_3 position{0, 0, 0};
  Point exact_point;
};

// The places of the vertices, present or those of the last frame.
template <class Point>
class Positions_3
{
public:
  using Place = Place_3<Point>;

  // Position of the infinite vertex included, which is NaN.
  const Position_3* data() const { return m_positions.data(); }
  const Position_3& position(Vertex_index v) const { return m_positions[v]; }
  Index number() const { return Index(m_positions.size()); }
  decltype(auto) point(Vertex_index v) const
  {
    if constexpr (is_three_doubles<Point>) {
      const Position_3& p = m_positions[v];
      return Point(p.x, p.y, p.z);
    } else {
      return static_cast<const Point&>(m_points[v]);
    }
  }
  Place place(Vertex_index v) const { return Place(m_positions[v], point(v)); }
  // Whether a vertex is exactly where others have it; false where it costs more to know.
  bool has_same(Vertex_index v, const Positions_3& others) const
  {
    return is_three_doubles<Point> && internal::is_same(m_positions[v], others.m_positions[v]);
  }

  void set(Vertex_index v, const Place& place)
  {
    m_positions[v] = place.position;
    if constexpr (!is_three_doubles<Point>)
      m_points[v] = place.exact_point;
  }
  void resize(Index number)
  {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    m_positions.resize(number, Position_3{nan, nan, nan});
    if constexpr (!is_three_doubles<Point>)
      m_points.resize(number);
  }
  void swap(Positions_3& other)
  {
    m_positions.swap(other.m_positions);
    m_points.swap(other.m_points);
  }

private:
  Column<Vertex_index, Position_3> m_positions;
  Column<Vertex_index, Point> m_points; // empty where points are three doubles
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_3::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_SPACE_POSITIONS_3_H

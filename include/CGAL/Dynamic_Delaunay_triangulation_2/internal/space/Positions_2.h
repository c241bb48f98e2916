// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_SPACE_POSITIONS_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_SPACE_POSITIONS_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/assertions.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Flat_arrays.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Processor.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Flat_elements_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Points_2.h>

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

// How points are stored: if they are just two doubles, as positions, so that one array holds both.
template <class Point>
struct Point_arrays_2
{
  static constexpr bool points_are_two_doubles = is_two_doubles<Point>;
  using Stored_point = std::conditional_t<points_are_two_doubles, Position_2, Point>;
  using Stored_points = Uninitialized_vector<Stored_point>; // indexed by vertices

  static Point as_point(const Position_2& p)
  {
    static_assert(points_are_two_doubles);
    return Point(p.x, p.y);
  }
  static const Point& as_point(const Point& p) { return p; }

  static Stored_point stored(const Position_2& position, [[maybe_unused]] const Point& p)
  {
    if constexpr (points_are_two_doubles)
      return position;
    else
      return p;
  }
};

// The positions of the vertices, now and one frame ago. The present points are in the data
// structure's own array. A frame is read into another array, and both are exchanged; a second
// exchange takes the frame back. If single points move, only their former places are kept.
// `Writable_positions_2` writes.
template <class Point>
class Positions_2
{
  using Arrays = Point_arrays_2<Point>;

public:
  using Stored_point = typename Arrays::Stored_point;
  using Stored_points = typename Arrays::Stored_points;
  static constexpr bool points_are_two_doubles = Arrays::points_are_two_doubles;

  // Whether place() can put a vertex anywhere.
  static constexpr bool can_place = points_are_two_doubles || is_made_of_x_and_y<Point>;

  Positions_2(const Positions_2&) = delete;
  Positions_2& operator=(const Positions_2&) = delete;

  // The points, rounded if their coordinates are not doubles. Indexed by vertices.
  const Position_vector& positions() const
  {
    if constexpr (points_are_two_doubles)
      return m_points;
    else
      return m_positions;
  }
  decltype(auto) point(Vertex_index v) const { return Arrays::as_point(m_points[v]); }

  // Whether no coordinate was rounded in positions(), wherever vertices are held in this call.
  bool are_exact() const { return m_are_exact && m_were_exact; }

  // Whether points have moved in the present call. Otherwise their previous places are not known,
  // and previous_position() returns the present ones.
  bool have_moved() const { return m_is_frame || !m_moved.empty(); }

  // Whether a frame has come in which every vertex is where it was, bit by bit. Where one of the
  // first vertices has moved, that takes no time.
  bool is_frame_at_rest() const
  {
    const Position_vector& previous = previous_positions();
    return m_is_frame && are_exact() &&
           std::memcmp(&positions()[1], &previous[1], (previous.size() - 1) * sizeof(Position_2)) ==
               0;
  }

  Position_2 previous_position(Vertex_index v) const
  {
    if constexpr (points_are_two_doubles)
      return *previous(v);
    else
      return approximation(*previous(v));
  }

  // Prefetches the present and the previous position of a vertex.
  void prefetch(Vertex_index v) const
  {
    internal::prefetch(&positions()[v]);
    if (m_is_frame)
      internal::prefetch(&m_other_points[v]);
  }

protected:
  // The first of the points must be that of the infinite vertex.
  explicit Positions_2(Stored_points& points)
    : m_points(points)
    , m_positions(points_are_two_doubles ? 0 : 1, nan_point())
  {
    if constexpr (points_are_two_doubles)
      m_points.front() = nan_point();
  }

  // Those of the last frame, while it is known.
  const Position_vector& previous_positions() const
  {
    if constexpr (points_are_two_doubles)
      return m_other_points;
    else
      return m_other_positions;
  }

  // The stored point of a vertex before it moved, or the present one if it has not moved.
  const Stored_point* previous(Vertex_index v) const
  {
    if (m_is_frame)
      return &m_other_points[v];
    if (m_moved.empty())
      return &m_points[v];
    const auto moved =
        std::lower_bound(m_moved.begin(), m_moved.end(), v,
                         [](const auto& entry, Vertex_index w) { return entry.first < w; });
    return moved != m_moved.end() && moved->first == v ? &moved->second : &m_points[v];
  }

  Stored_points& m_points;     // those of the data structure
  Position_vector m_positions; // empty if points are two doubles
  Stored_points m_other_points;
  Position_vector m_other_positions;
  // While the vertices have stopped on their way.
  Stored_points m_target_points;
  Position_vector m_target_positions;
  bool m_have_stopped = false;
  std::vector<std::pair<Vertex_index, Stored_point>> m_moved; // single points, with former places
  bool m_is_frame = false; // the other arrays hold the previous frame
  bool m_are_exact = true;
  bool m_were_exact = true; // the previous positions, while a call knows them
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_SPACE_POSITIONS_2_H

// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_SPACE_WRITABLE_POSITIONS_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_SPACE_WRITABLE_POSITIONS_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/assertions.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Flat_arrays.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Parallel_parts.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Flat_elements_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Points_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/space/Positions_2.h>
#include <CGAL/tags.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

// The positions as they are written: the input of a space stages and restores frames; the editor
// and the builders add and remove entries along with vertices.
template <class Point>
class Writable_positions_2 : public Positions_2<Point>
{
  using Base = Positions_2<Point>;
  using Arrays = Point_arrays_2<Point>;
  using Base::m_are_exact;
  using Base::m_have_stopped;
  using Base::m_is_frame;
  using Base::m_moved;
  using Base::m_other_points;
  using Base::m_other_positions;
  using Base::m_points;
  using Base::m_positions;
  using Base::m_target_points;
  using Base::m_target_positions;
  using Base::m_were_exact;

public:
  using Base::can_place;
  using Base::have_moved;
  using Base::points_are_two_doubles;
  using typename Base::Stored_point;
  using typename Base::Stored_points;

  // The first of the points must be that of the infinite vertex.
  explicit Writable_positions_2(Stored_points& points)
    : Base(points)
  {
  }

  // A FRAME -------------------------------------------------------------------------------------

  // Makes room for a frame. If it throws, or if no other function is called, nothing has changed.
  void begin_frame()
  {
    m_other_points.resize(m_points.size());
    m_other_points.front() = m_points.front();
    m_other_positions.resize(m_positions.size(), nan_point());
  }

  // Where to put points, and positions if they are stored separately. Threads may share the
  // vertices.
  struct Staged
  {
    Stored_point* points;
    Position_2* positions;

    void set(Vertex_index v, const Position_2& position, const Point& p) const
    {
      points[v] = Arrays::stored(position, p);
      if constexpr (!points_are_two_doubles)
        positions[v] = position;
    }
  };
  Staged staged() { return {m_other_points.data(), m_other_positions.data()}; }

  void accept_frame(bool are_exact)
  {
    exchange();
    m_were_exact = std::exchange(m_are_exact, are_exact);
    m_is_frame = true;
  }

  void take_back(bool were_exact)
  {
    CGAL_precondition(m_is_frame);
    exchange();
    m_are_exact = were_exact;
    m_were_exact = true;
    m_is_frame = false;
  }

  void exchange()
  {
    m_points.swap(m_other_points);
    m_positions.swap(m_other_positions);
  }

  // The points of the last frame, indexed by vertices.
  const Stored_points& previous_points() const { return m_other_points; }

  // SINGLE POINTS -------------------------------------------------------------------------------

  // Reserves memory for so many moves. Then move() throws only what copying a point throws.
  void reserve_for_moves(std::size_t number) { reserve_extra(m_moved, number); }

  void move(Vertex_index v, const Point& p)
  {
    m_moved.emplace_back(v, m_points[v]);
    set(v, p);
  }

  // Whether the points that move from now on are exact in positions().
  void note_exactness(bool are_exact) { m_are_exact = m_are_exact && are_exact; }

  // Sorts the moves for look-ups. To be called after the last move(); vertices must be distinct.
  void end_moves()
  {
    std::sort(m_moved.begin(), m_moved.end(),
              [](const auto& a, const auto& b) { return a.first < b.first; });
  }

  void set(Vertex_index v, const Point& p)
  {
    Staged{m_points.data(), m_positions.data()}.set(v, approximation(p), p);
  }

  // Sets the present and the previous position of a new vertex that takes the number of another.
  void restart(Vertex_index v, const Point& p)
  {
    set(v, p);
    if (have_moved())
      *previous(v) = m_points[v];
  }

  // Forgets previous positions, at the end of a call or when vertices get other numbers.
  void forget_previous()
  {
    m_is_frame = false;
    m_were_exact = true;
    m_moved.clear();
  }

  // HELD VERTICES -------------------------------------------------------------------------------

  const Stored_point& stored(Vertex_index v) const { return m_points[v]; }

  // Puts the vertex at p. Its previous position stays.
  void place(Vertex_index v, const Position_2& p)
  {
    if constexpr (points_are_two_doubles)
      m_points[v] = p;
    else {
      static_assert(can_place);
      set(v, Point(p.x, p.y));
    }
  }
  void put_to_rest(Vertex_index v) { restore(v, *Base::previous(v)); }
  void restore(Vertex_index v, const Stored_point& p)
  {
    if constexpr (points_are_two_doubles)
      m_points[v] = p;
    else
      set(v, p);
  }

  // STEPS OF A FRAME ----------------------------------------------------------------------------

  // Puts each vertex v at place(v), until go_on() or arrive(). Threads share the vertices.
  template <class Parts, class Function>
  void stop_at(const Function& place)
  {
    CGAL_precondition(m_is_frame && can_place);
    m_target_points.resize(m_points.size());
    m_target_points.front() = m_points.front();
    m_target_positions.resize(m_positions.size(), nan_point());
    const Staged all{m_target_points.data(), m_target_positions.data()};
    Parts::for_each_element(m_points.size() - 1, [&](std::size_t i) {
      const Vertex_index v(i + 1);
      const Position_2 p = place(v);
      all.set(v, p, Point(p.x, p.y));
    });
    exchange_targets();
  }

  // Goes on from where the vertices have stopped: they rest there now, and stand at their targets.
  void go_on()
  {
    exchange();
    arrive();
  }
  // Puts all vertices at their targets.
  void arrive()
  {
    if (m_have_stopped)
      exchange_targets();
  }

  void exchange_targets()
  {
    m_points.swap(m_target_points);
    m_positions.swap(m_target_positions);
    m_have_stopped = !m_have_stopped;
  }

  // IN STEP WITH THE VERTICES -------------------------------------------------------------------

  void append(const Point& p)
  {
    append<Parallel_parts<Sequential_tag>>(1, [&](std::size_t) -> const Point& { return p; });
  }
  // Appends so many vertices, the i-th at point(i). Threads share the calls. If it throws, some may
  // have been appended.
  template <class Parts, class Point_of>
  void append(std::size_t number, const Point_of& point)
  {
    const std::size_t first = m_points.size();
    m_points.resize(first + number);
    if constexpr (!points_are_two_doubles)
      m_positions.resize(first + number);
    Parts::for_each_element(number, Parts::size_for(8),
                            [&](std::size_t i) { set(Vertex_index(first + i), point(i)); });
    if (m_is_frame)
      m_other_points.insert(m_other_points.end(), m_points.begin() + std::ptrdiff_t(first),
                            m_points.end());
  }

  // Drops what was appended beyond this number.
  void resize(std::size_t number)
  {
    m_points.resize(number);
    if constexpr (!points_are_two_doubles)
      m_positions.resize(number);
    if (m_is_frame)
      m_other_points.resize(number);
  }

  // Puts vertex `to` where `from` is.
  void copy(Vertex_index from, Vertex_index to)
  {
    m_points[to] = m_points[from];
    if constexpr (!points_are_two_doubles)
      m_positions[to] = m_positions[from];
  }

  // Copies what is kept between calls, except for the points in the data structure's array.
  void copy(const Writable_positions_2& other)
  {
    m_positions = other.m_positions;
    m_are_exact = other.m_are_exact;
  }
  void exchange_all_but_points(Writable_positions_2& other)
  {
    m_positions.swap(other.m_positions);
    std::swap(m_are_exact, other.m_are_exact);
  }

  // Collects the points of other vertices, where vertex v has the point `point(v)`, for exchange().
  // Threads share the vertices.
  template <class Parts, class Function>
  void collect(std::size_t vertices, const Function& point, Stored_points& points,
               Position_vector& positions) const
  {
    points.resize(vertices + 1);
    points.front() = m_points.front();
    if constexpr (!points_are_two_doubles)
      positions.resize(vertices + 1, nan_point());
    const Staged all{points.data(), positions.data()};
    Parts::for_each_element(vertices, [&](std::size_t i) {
      const Vertex_index v(i + 1);
      const Point& p = point(v);
      all.set(v, approximation(p), p);
    });
  }

  void set_exactness(bool are_exact) { m_are_exact = are_exact; }

  // Exchanges the points of all vertices, and the positions if they are stored separately.
  void exchange(Stored_points& points, Position_vector& positions)
  {
    m_points.swap(points);
    m_positions.swap(positions);
  }

private:
  Stored_point* previous(Vertex_index v) { return const_cast<Stored_point*>(Base::previous(v)); }
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_SPACE_WRITABLE_POSITIONS_2_H

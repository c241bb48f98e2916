// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_SPACE_INPUT_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_SPACE_INPUT_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Flat_arrays.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Processor.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Range_arguments.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Flat_elements_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Points_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/topology/Halfedge_arrays_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_errors_2.h>
#include <CGAL/number_type_basic.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <iterator>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

// The input of a call, read and checked.
template <class Point>
struct Change_2
{
  bool is_frame = false; // all points that stay have new positions, which are staged
  bool is_mending = false;
  std::vector<Point_id> gone;  // distinct ids of points to remove
  std::vector<Point_id> moved; // distinct ids of points that move alone, and their new positions
  std::vector<Point> moved_points;
  std::vector<Point_id> coming; // ids of points to insert, and their positions
  std::vector<Point> coming_points;
  bool are_exact = true; // no coordinate above is rounded in the flat arrays

  // Makes it empty. Short lists keep their memory: most calls insert, remove or move one point.
  void clear()
  {
    constexpr std::size_t few = 1024;
    if (gone.capacity() + moved.capacity() + coming.capacity() > few) {
      *this = Change_2();
      return;
    }
    is_frame = is_mending = false;
    are_exact = true;
    gone.clear();
    moved.clear();
    moved_points.clear();
    coming.clear();
    coming_points.clear();
  }

  bool has_population() const { return !gone.empty() || !coming.empty(); }

  bool is_empty() const
  {
    return !is_frame && !is_mending && gone.empty() && moved.empty() && coming.empty();
  }
};

// Throws if a triangulation cannot hold so many points.
inline void check_limit(std::size_t number)
{
  if (number > max_vertices)
    throw Point_limit_error_2(number, max_vertices);
}

// Returns the length of a random-access range of points, or 0 for other ranges, which can only be
// counted by reading them. Throws if a triangulation cannot hold these points and `others` more.
template <class InputIterator>
std::size_t length_within_limit(const InputIterator& first, const InputIterator& beyond,
                                std::size_t others)
{
  if constexpr (is_random_access<InputIterator>) {
    check_limit(others + std::size_t(beyond - first));
    return std::size_t(beyond - first);
  }
  return 0;
}

// Throws unless a random-access range has a position for each id. Other ranges are counted while
// they are read.
template <class InputIterator>
void check_frame_length(const InputIterator& first, const InputIterator& beyond, std::size_t ids)
{
  if constexpr (is_random_access<InputIterator>)
    if (const std::size_t given = std::size_t(beyond - first); given != ids)
      throw Point_count_error_2(ids, given);
}

// Reads and checks the positions of a frame before anything changes, and can take the frame back.
template <class State>
class Input_frame_2
{
  using Point = typename State::Point;
  using Ids = typename State::Ids;
  using Parts = typename State::Parts;

public:
  explicit Input_frame_2(State& state)
    : m_state(state)
    , m_ids(typename State::Writer(state).ids())
    , m_positions(typename State::Writer(state).positions())
  {
  }

  // Reads a frame. Nothing changes before accept(), even if the frame is refused.
  template <class InputIterator, class PointMap>
  void stage(InputIterator first, InputIterator beyond, const PointMap& point_map)
  {
    check_frame_length(first, beyond, m_state.ids().number_of_ids());
    m_next_covered = m_state.ids().covered_points();
    m_were_exact = m_positions.are_exact();
    m_positions.begin_frame();
    m_are_exact = stage_all(first, beyond, point_map);
  }

  // Does nothing: in the plane, points that the call removes may have any positions in the frame.
  static void leave_out(const std::vector<Point_id>&) {}

  // Does nothing: in the plane, points may have any coordinates that can be read.
  static void check(const std::vector<Point>&, const std::vector<Point_id>&) {}

  // Makes the positions that were read the present ones. Throws nothing.
  void accept()
  {
    m_positions.accept_frame(m_are_exact);
    exchange_covered();
  }

  // Undoes accept(): restores the positions from before the frame.
  void take_back()
  {
    m_positions.take_back(m_were_exact);
    exchange_covered();
  }

  // Forgets the previous positions, at the end of a call.
  void forget_previous() { m_positions.forget_previous(); }

private:
  // Returns whether no coordinate is rounded.
  template <class InputIterator, class PointMap>
  bool stage_all(InputIterator first, InputIterator beyond, const PointMap& point_map)
  {
    if constexpr (is_random_access<InputIterator>)
      return stage_in_order_of_vertices(first, beyond, point_map);
    else
      return stage_one_by_one(first, beyond, point_map);
  }

  // For random-access input: stages in the order of the vertices, then the covered points.
  template <class RandomAccessIterator, class PointMap>
  bool stage_in_order_of_vertices(RandomAccessIterator first, RandomAccessIterator beyond,
                                  const PointMap& point_map)
  {
    const Index points = m_state.ids().number_of_representatives();
    std::atomic<bool> are_right{true}, are_exact{true};
    Parts::for_each(points, [&](std::size_t, std::size_t begin, std::size_t end) {
      bool are_exact_here = true;
      if (!stage_part(first, point_map, begin + 1, end + 1, are_exact_here))
        are_right.store(false, std::memory_order_relaxed);
      if (!are_exact_here)
        are_exact.store(false, std::memory_order_relaxed);
    });
    bool covered_are_exact = true;
    if (!stage_covered(first, point_map, covered_are_exact) || !are_right)
      throw_refused(first, beyond, point_map);
    return are_exact && covered_are_exact;
  }

  // Stages the vertices from v to before `end`, without branches. False if a coordinate is refused.
  // Two checks alternate, so that no addition has to wait for the one before it.
  template <class RandomAccessIterator, class PointMap>
  bool stage_part(RandomAccessIterator first, const PointMap& point_map, std::size_t v,
                  std::size_t end, bool& are_exact)
  {
    using Difference = typename std::iterator_traits<RandomAccessIterator>::difference_type;
    const Point_id* const representatives = m_state.ids().representatives();
    const auto staged = m_positions.staged();
    const auto stage = [&, staged](std::size_t i, Limit_check_2& check) {
      read(first, point_map, representatives[i], check, are_exact,
           [&](const Position_2& position, const Point& p) {
             staged.set(Vertex_index(i), position, p);
           });
    };
    // consecutive vertices are near to each other in the plane, but scattered over the range
    const auto prefetch_point = [&](std::size_t i) {
      if constexpr (is_in_memory<RandomAccessIterator>)
        prefetch(&*(first + Difference(representatives[i])));
    };
    constexpr std::size_t ahead = 128;
    const std::size_t points = m_state.number_of_vertices();
    const std::size_t end_of_prefetching =
        points < min_vertices_to_prefetch ? 0 : points - ahead - 1;
    Limit_check_2 odd, even;
    for (; v + 1 < end; v += 2) {
      if (v < end_of_prefetching) {
        prefetch_point(v + ahead);
        prefetch_point(v + ahead + 1);
      }
      stage(v, odd);
      stage(v + 1, even);
    }
    if (v < end)
      stage(v, odd);
    return odd.holds() && even.holds();
  }

  // Stages the covered points. False if a coordinate is refused.
  template <class RandomAccessIterator, class PointMap>
  bool stage_covered(RandomAccessIterator first, const PointMap& point_map, bool& are_exact)
  {
    Limit_check_2 check;
    for (Index i = 0; i < m_next_covered.size(); ++i)
      read(first, point_map, m_state.ids().covered_id(i), check, are_exact,
           [&](const Position_2&, const Point& p) { m_next_covered[i] = p; });
    return check.holds();
  }

  // Reads one point of random-access input, and calls store(position, point).
  template <class RandomAccessIterator, class PointMap, class Store>
  static void read(RandomAccessIterator first, const PointMap& point_map, Index id,
                   Limit_check_2& check, bool& are_exact, const Store& store)
  {
    using Difference = typename std::iterator_traits<RandomAccessIterator>::difference_type;
    // keep the iterator and its value alive, because p may refer to data inside of them
    const RandomAccessIterator iterator = first + Difference(id);
    auto&& value = *iterator;
    const Point& p = get(point_map, value);
    const Position_2 position{CGAL::to_double(p.x()), CGAL::to_double(p.y())};
    check.add(position);
    are_exact = are_exact && has_exact_position(p);
    store(position, p);
  }

  template <class InputIterator, class PointMap>
  void throw_refused(InputIterator first, InputIterator beyond, const PointMap& point_map)
  {
    bool are_exact = true;
    for (std::size_t id = 0; first != beyond; ++id, ++first)
      if (m_state.ids().is_taken(id))
        checked_position(get(point_map, *first), id, are_exact);
  }

  template <class InputIterator, class PointMap>
  bool stage_one_by_one(InputIterator first, InputIterator beyond, const PointMap& point_map)
  {
    const Index ids = m_state.ids().number_of_ids();
    bool are_exact = true;
    const auto staged = m_positions.staged();
    Point_id id(0);
    for (; id < ids && first != beyond; ++id, ++first) {
      if (!m_state.ids().is_taken(id))
        continue;
      auto&& value = *first;
      const Point& p = get(point_map, value);
      const Position_2 position = checked_position(p, id, are_exact);
      if (m_state.ids().is_representative(id))
        staged.set(m_state.ids().vertex(id), position, p);
      else
        m_next_covered[m_state.ids().covered_number(id)] = p;
    }
    if (first != beyond)
      throw Point_count_error_2(ids, ids + std::size_t(1));
    if (id < ids)
      throw Point_count_error_2(ids, id);
    return are_exact;
  }

  // Covered points belong to a frame, too.
  void exchange_covered() { m_ids.covered_points().swap(m_next_covered); }

  const State& m_state;
  Ids& m_ids;
  typename State::Writer::Positions& m_positions;
  std::vector<Point> m_next_covered; // by their numbers
  bool m_were_exact = true, m_are_exact = true;
};

// Reads and checks the input for points to insert, remove or move alone, before anything changes.
template <class State>
class Population_input_2
{
  using Point = typename State::Point;

public:
  // Reads points to insert.
  template <class InputIterator, class PointMap>
  static void read_newcomers(InputIterator first, InputIterator beyond, const PointMap& point_map,
                             const State& state, Change_2<Point>& change)
  {
    using Parts = typename State::Parts;
    std::vector<Point>& points = change.coming_points;
    const std::size_t present = state.ids().number_of_points();
    const std::size_t length = length_within_limit(first, beyond, present);
    if constexpr (Parts::is_parallel && is_random_access<InputIterator>) {
      points.resize(length);
      Parts::for_each_element(length, [&](std::size_t i) {
        // it has to outlive the value, which may be a part of it
        const auto place = first + typename std::iterator_traits<InputIterator>::difference_type(i);
        auto&& value = *place;
        points[i] = get(point_map, value);
      });
    } else {
      points.reserve(length);
      for (; first != beyond; ++first) {
        check_limit(present + points.size() + 1);
        points.push_back(get(point_map, *first));
      }
    }
    state.ids().list_next_ids(points.size(), change.coming);
    const std::size_t inexact = Parts::sum(points.size(), [&](std::size_t i, std::size_t end) {
      bool are_exact = true;
      for (; i < end; ++i)
        checked_position(points[i], change.coming[i], are_exact);
      return std::size_t(!are_exact);
    });
    change.are_exact = change.are_exact && inexact == 0;
  }

  // Appends the ids of a range in its order. Throws if one has no point, or occurs more than once.
  template <class InputIterator>
  static void read_ids(InputIterator first, InputIterator beyond, const State& state,
                       std::vector<Point_id>& ids)
  {
    for (; first != beyond; ++first)
      ids.push_back(read_id(*first, state));
    check_distinct(ids);
  }

  // Reads points with new positions.
  template <class InputIterator, class IdMap, class PointMap>
  static void read_movers(InputIterator first, InputIterator beyond, const IdMap& id_map,
                          const PointMap& point_map, const State& state, Change_2<Point>& change)
  {
    for (; first != beyond; ++first) {
      auto&& value = *first;
      change.moved.push_back(read_id(get(id_map, value), state));
      change.moved_points.push_back(get(point_map, value));
      checked_position(change.moved_points.back(), change.moved.back(), change.are_exact);
    }
    check_distinct(change.moved);
  }

private:
  // Reads an id from any type of integers. Throws if it has no point, as negative numbers do.
  template <class Integer>
  static Point_id read_id(const Integer& id, const State& state)
  {
    if (!state.ids().is_taken(std::size_t(id)))
      throw Unknown_id_error_2(std::size_t(id), state.ids().number_of_ids());
    return Point_id(id);
  }
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_SPACE_INPUT_2_H

// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_SPACE_INPUT_3_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_SPACE_INPUT_3_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Processor.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Range_arguments.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/passes/Elements_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/passes/Points_3.h>

#include <boost/config.hpp>
#include <boost/property_map/property_map.hpp>

#include <atomic>
#include <cstddef>
#include <iterator>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_3::internal {

// The input of a call, read and checked.
template <class Point>
struct Change_3
{
  bool is_frame = false;      // all points have new positions, which are staged
  std::vector<Point_id> gone; // distinct ids of points to remove; in a frame only with `positions`
  const std::vector<Point>* positions = nullptr; // by ids, checked, to be staged after that
  std::vector<Point_id> coming;                  // ids of points to insert, and their positions
  std::vector<Point> coming_points;
  std::vector<Point_id> moved; // distinct ids of points that move alone, not in a frame
  std::vector<Point> moved_points;
};

// Reads and checks input before anything changes.
template <class State>
class Input_3
{
  using Point = typename State::Point;
  using Ids = typename State::Ids;
  using Parts = typename State::Parts;
  using Staged = typename State::Staged;

public:
  // Cells have 4 corners each, which are numbered with 32 bits; there are up to 7 cells a point in
  // simulations.
  static constexpr std::size_t max_points = (std::size_t(1) << 27) - 1;

  // Reads a frame. Vertices that have lost their points stay where they are.
  template <class InputIterator, class PointMap>
  static void stage(InputIterator first, InputIterator beyond, const PointMap& point_map,
                    const State& state, Staged& staged)
  {
    if constexpr (Dynamic_Delaunay_triangulations_2::internal::is_random_access<InputIterator>) {
      stage_in_any_order(first, beyond, point_map, state, staged);
    } else {
      std::vector<Point> points;
      for (; first != beyond; ++first) {
        if (points.size() == state.ids.number_of_ids())
          throw Point_count_error_2(points.size(), points.size() + 1);
        points.push_back(get(point_map, *first));
      }
      stage_in_any_order(points.begin(), points.end(), boost::typed_identity_property_map<Point>(),
                         state, staged);
    }
  }

  static void check_number(std::size_t points)
  {
    if (points > max_points)
      throw Point_limit_error_2(points, max_points);
  }

  // Reads points to insert.
  template <class InputIterator, class PointMap>
  static void read_newcomers(InputIterator first, InputIterator beyond, const PointMap& point_map,
                             const State& state, Change_3<Point>& change)
  {
    const std::size_t present = state.ids.number_of_points();
    for (; first != beyond; ++first) {
      if (present + change.coming_points.size() == max_points)
        throw Point_limit_error_2(max_points + 1, max_points);
      change.coming_points.push_back(get(point_map, *first));
    }
    state.ids.list_next_ids(change.coming_points.size(), change.coming);
    for (std::size_t i = 0; i < change.coming.size(); ++i)
      state.check(change.coming_points[i], change.coming[i]);
  }

private:
  template <class RandomAccessIterator, class PointMap>
  static void stage_in_any_order(RandomAccessIterator first, RandomAccessIterator beyond,
                                 const PointMap& point_map, const State& state, Staged& staged)
  {
    using Difference = typename std::iterator_traits<RandomAccessIterator>::difference_type;
    const Ids& ids = state.ids;
    if (const std::size_t given = std::size_t(beyond - first); given != ids.number_of_ids())
      throw Point_count_error_2(ids.number_of_ids(), given);
    staged.positions.resize(state.positions.number());
    staged.covered.resize(ids.number_of_covered());
    std::atomic<bool> are_right{true}, are_exact{true};
    Parts::for_each(state.number_of_vertices(),
                    [&](std::size_t, std::size_t begin, std::size_t end) {
                      const Points_fetched_ahead<RandomAccessIterator> fetched(first, ids);
                      for (Vertex_index v(begin + 1); v <= end; ++v) {
                        fetched.prefetch(v);
                        if (!ids.has_representative(v)) {
                          staged.positions.set(v, state.positions.place(v));
                          continue;
                        }
                        auto&& value = first[Difference(ids.representative(v))];
                        const Point& p = get(point_map, value);
                        if (!staged.set(state, v, p))
                          are_right.store(false, std::memory_order_relaxed);
                        else if (!has_exact_position(p))
                          are_exact.store(false, std::memory_order_relaxed);
                      }
                    });
    for (Index i = 0; i < ids.number_of_covered(); ++i) {
      auto&& value = first[Difference(ids.covered_id(i))];
      const Point& p = get(point_map, value);
      are_right = are_right && staged.accepts(state, p);
      are_exact = are_exact && has_exact_position(p);
      staged.covered[i] = p;
    }
    staged.are_exact = are_exact;
    for (std::size_t id = 0; !are_right && id < ids.number_of_ids(); ++id)
      if (ids.is_taken(id)) {
        auto&& value = first[Difference(id)];
        staged.check(state, get(point_map, value), id); // one of them throws
      }
  }

  // Consecutive vertices are near to each other in space, but their points may be scattered over
  // the range. Where these follow another curve, reading 100,000 of them takes half of the time
  // then.
  template <class RandomAccessIterator>
  class Points_fetched_ahead
  {
  public:
    Points_fetched_ahead(RandomAccessIterator first, const Ids& ids)
      : m_first(first)
      , m_representatives(ids.representatives())
      , m_last(ids.number_of_representatives())
    {
      if (m_last < Dynamic_Delaunay_triangulations_2::internal::min_vertices_to_prefetch)
        m_last = 0;
    }

    // Fetches that of a later vertex.
    BOOST_FORCEINLINE void prefetch(std::size_t v) const
    {
      using Dynamic_Delaunay_triangulations_2::internal::is_in_memory;
      using Difference = typename std::iterator_traits<RandomAccessIterator>::difference_type;
      if constexpr (is_in_memory<RandomAccessIterator>)
        if (v + ahead <= m_last && m_representatives[v + ahead] != null_index)
          Dynamic_Delaunay_triangulations_2::internal::prefetch(
              &*(m_first + Difference(m_representatives[v + ahead])));
    }

  private:
    static constexpr std::size_t ahead = 32;

    RandomAccessIterator m_first;
    const Point_id* m_representatives;
    std::size_t m_last; // of the vertices, or 0 where they are few
  };
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_3::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_SPACE_INPUT_3_H

// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_INPUT_FRAME_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_INPUT_FRAME_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Coordinate_range_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Input_position_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Maintained_triangulation_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Prefetch_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_errors_2.h>
#include <CGAL/number_type_basic.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Dynamic_Delaunay_triangulations_2 {
namespace internal {

// Whether it is known to point to values that stand in memory: others may be costly to ask twice.
template <class Iterator, class Value = typename std::iterator_traits<Iterator>::value_type>
constexpr bool is_in_memory = std::is_pointer_v<Iterator> ||
                              std::is_same_v<Iterator, typename std::vector<Value>::iterator> ||
                              std::is_same_v<Iterator, typename std::vector<Value>::const_iterator>;
// which has no values to point to
template <class Iterator>
constexpr bool is_in_memory<Iterator, bool> = false;

// Reads and checks the positions of a frame, before anything changes.
template <class Maintained>
class Input_frame_2
{
  using Point = typename Maintained::Point;

public:
  // Reads a frame into the positions; CGAL's vertices keep the points of the last one until they
  // are written. If the frame is refused, or reading it throws, all is as it was.
  template <class InputIterator, class PointMap>
  void stage(InputIterator first, InputIterator beyond, const PointMap& point_map,
             Maintained& maintained)
  {
    maintained.next_duplicates = maintained.ids.duplicates();
    maintained.previous_positions_are_exact = maintained.positions_are_exact;
    try {
      stage_all(first, beyond, point_map, maintained);
    } catch (...) {
      maintained.restore_positions();
      throw;
    }
    maintained.points_are_written = false;
    std::swap(maintained.ids.duplicates(), maintained.next_duplicates);
  }

  // Takes it back.
  void unstage(Maintained& maintained)
  {
    maintained.restore_positions();
    std::swap(maintained.ids.duplicates(), maintained.next_duplicates);
  }

private:
  template <class InputIterator, class PointMap>
  static void stage_all(InputIterator first, InputIterator beyond, const PointMap& point_map,
                        Maintained& maintained)
  {
    using Category = typename std::iterator_traits<InputIterator>::iterator_category;
    if constexpr (std::is_convertible_v<Category, std::random_access_iterator_tag>)
      if (maintained.ids.duplicates().empty())
        return stage_all_representatives(first, beyond, point_map, maintained);
    stage_one_by_one(first, beyond, point_map, maintained);
  }

  // Where each point has a vertex of its own, and all are at hand: in the order of the vertices,
  // without a branch. A coordinate x is finite if 0x is 0, and within the limit if its product with
  // the factor is finite; two sums take turns, so that no addition waits for the one before.
  template <class RandomAccessIterator, class PointMap>
  static void stage_all_representatives(RandomAccessIterator first, RandomAccessIterator beyond,
                                        const PointMap& point_map, Maintained& maintained)
  {
    const std::size_t ids = maintained.ids.number_of_ids();
    const std::size_t given = std::size_t(beyond - first);
    if (given != ids)
      throw Point_count_error_2(ids, (std::min)(given, ids + 1));
    using Difference = typename std::iterator_traits<RandomAccessIterator>::difference_type;
    const Index points = maintained.ids.number_of_representatives();
    const Index* const representatives = maintained.ids.representatives();
    bool are_exact = true;
    const auto stage = [&](std::size_t v, Position_2& zero) {
      // iterators may keep their values in themselves, or make them, and maps refer into these
      const RandomAccessIterator iterator = first + Difference(representatives[v]);
      auto&& value = *iterator;
      const Point& p = get(point_map, value);
      const Position_2 position{CGAL::to_double(p.x()), CGAL::to_double(p.y())};
      zero.x += 0 * (factor_beyond_limit * position.x);
      zero.y += 0 * (factor_beyond_limit * position.y);
      are_exact = are_exact && has_exact_position(p);
      write(position, p, Index(v), maintained);
    };
    // one after the other in the plane, the points are anywhere in the range
    const auto prefetch_point = [&](std::size_t v) {
      if constexpr (is_in_memory<RandomAccessIterator>)
        prefetch(&*(first + Difference(representatives[v])));
      prefetch(&maintained.positions[v]);
    };
    constexpr std::size_t ahead = 128;
    const std::size_t end_of_prefetching =
        points < min_vertices_to_prefetch ? 0 : points - ahead - 1;
    Position_2 odd{0, 0}, even{0, 0};
    std::size_t v = 1;
    for (; v < points; v += 2) {
      if (v < end_of_prefetching) {
        prefetch_point(v + ahead);
        prefetch_point(v + ahead + 1);
      }
      stage(v, odd);
      stage(v + 1, even);
    }
    if (v == points)
      stage(v, odd);
    if (!(odd.x + odd.y + even.x + even.y == 0))
      throw_refused(first, beyond, point_map, maintained);
    maintained.positions_are_exact = are_exact;
  }

  template <class InputIterator, class PointMap>
  static void throw_refused(InputIterator first, InputIterator beyond, const PointMap& point_map,
                            const Maintained& maintained)
  {
    bool are_exact = true;
    for (std::size_t id = 0; first != beyond; ++id, ++first)
      if (maintained.ids.is_taken(id))
        checked_position(get(point_map, *first), id, are_exact);
  }

  template <class InputIterator, class PointMap>
  static void stage_one_by_one(InputIterator first, InputIterator beyond, const PointMap& point_map,
                               Maintained& maintained)
  {
    const Index ids = maintained.ids.number_of_ids();
    bool are_exact = true;
    auto duplicate = maintained.next_duplicates.begin(); // sorted by id
    Index id = 0;
    for (; id < ids && first != beyond; ++id, ++first) {
      if (!maintained.ids.is_taken(id))
        continue;
      auto&& value = *first;
      const Point& p = get(point_map, value);
      const Position_2 position = checked_position(p, id, are_exact);
      if (duplicate != maintained.next_duplicates.end() && duplicate->id == id)
        (duplicate++)->point = p;
      else
        write(position, p, maintained.ids.vertex(id), maintained);
    }
    if (first != beyond)
      throw Point_count_error_2(ids, ids + std::size_t(1));
    if (id < ids)
      throw Point_count_error_2(ids, id);
    maintained.positions_are_exact = are_exact;
  }

  static void write(const Position_2& position, const Point& p, Index vertex,
                    Maintained& maintained)
  {
    maintained.positions[vertex] = position;
    if constexpr (!Maintained::points_are_two_doubles)
      maintained.next_points[vertex] = p;
  }
};

} // namespace internal
} // namespace Dynamic_Delaunay_triangulations_2
} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_INPUT_FRAME_2_H

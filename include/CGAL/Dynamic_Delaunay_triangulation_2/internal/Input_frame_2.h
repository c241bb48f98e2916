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

// Reads and checks the positions of a frame before anything changes, takes them back, or gives them
// to CGAL's vertices in the end. It alone has the key to the points of duplicates.
template <class Maintained>
class Input_frame_2
{
  using Point = typename Maintained::Point;
  using Ids = typename Maintained::Ids;

public:
  class Key
  {
    friend class Input_frame_2;
    Key() {}
  };

  explicit Input_frame_2(Maintained& maintained)
    : m_maintained(maintained)
    , m_positions(maintained.m_positions)
  {
  }

  // Reads a frame into the positions; CGAL's vertices keep the points of the last one until they
  // are written. If the frame is refused, or reading it throws, all is as it was.
  template <class InputIterator, class PointMap>
  void stage(InputIterator first, InputIterator beyond, const PointMap& point_map)
  {
    m_next_duplicates = m_maintained.ids().duplicates();
    m_were_exact = m_positions.m_are_exact;
    try {
      stage_all(first, beyond, point_map);
    } catch (...) {
      m_positions.take_back(m_maintained.vertices(), m_were_exact);
      throw;
    }
    m_positions.m_are_written = false;
    exchange_duplicates();
  }

  // Takes it back.
  void take_back()
  {
    m_positions.take_back(m_maintained.vertices(), m_were_exact);
    exchange_duplicates();
  }

  // CGAL's vertices get the points of the frame.
  void write() { m_positions.write(m_maintained.vertices()); }

  // The same where only the points with these ids have moved. Some of them may be gone.
  void write(const std::vector<Index>& moved_ids)
  {
    if (std::exchange(m_positions.m_are_written, true))
      return;
    const auto& ids = m_maintained.ids();
    for (const Index id : moved_ids)
      if (ids.is_taken(id)) {
        const Index v = ids.vertex(id);
        m_positions.write_one(v, m_maintained.vertices()[v]);
      }
  }

private:
  template <class InputIterator, class PointMap>
  void stage_all(InputIterator first, InputIterator beyond, const PointMap& point_map)
  {
    using Category = typename std::iterator_traits<InputIterator>::iterator_category;
    if constexpr (std::is_convertible_v<Category, std::random_access_iterator_tag>)
      if (m_maintained.ids().duplicates().empty())
        return stage_all_representatives(first, beyond, point_map);
    stage_one_by_one(first, beyond, point_map);
  }

  // Where each point has a vertex of its own, and all are at hand: in the order of the vertices,
  // without a branch. A coordinate x is finite if 0x is 0, and within the limit if its product with
  // the factor is finite; two sums take turns, so that no addition waits for the one before.
  template <class RandomAccessIterator, class PointMap>
  void stage_all_representatives(RandomAccessIterator first, RandomAccessIterator beyond,
                                 const PointMap& point_map)
  {
    const std::size_t ids = m_maintained.ids().number_of_ids();
    const std::size_t given = std::size_t(beyond - first);
    if (given != ids)
      throw Point_count_error_2(ids, (std::min)(given, ids + 1));
    using Difference = typename std::iterator_traits<RandomAccessIterator>::difference_type;
    const Index points = m_maintained.ids().number_of_representatives();
    const Index* const representatives = m_maintained.ids().representatives();
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
      m_positions.stage(Index(v), position, p);
    };
    // one after the other in the plane, the points are anywhere in the range
    const auto prefetch_point = [&](std::size_t v) {
      if constexpr (is_in_memory<RandomAccessIterator>)
        prefetch(&*(first + Difference(representatives[v])));
      prefetch(&m_maintained.positions()[v]);
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
      throw_refused(first, beyond, point_map);
    m_positions.m_are_exact = are_exact;
  }

  template <class InputIterator, class PointMap>
  void throw_refused(InputIterator first, InputIterator beyond, const PointMap& point_map)
  {
    bool are_exact = true;
    for (std::size_t id = 0; first != beyond; ++id, ++first)
      if (m_maintained.ids().is_taken(id))
        checked_position(get(point_map, *first), id, are_exact);
  }

  template <class InputIterator, class PointMap>
  void stage_one_by_one(InputIterator first, InputIterator beyond, const PointMap& point_map)
  {
    const Index ids = m_maintained.ids().number_of_ids();
    bool are_exact = true;
    auto duplicate = m_next_duplicates.begin(); // sorted by id
    Index id = 0;
    for (; id < ids && first != beyond; ++id, ++first) {
      if (!m_maintained.ids().is_taken(id))
        continue;
      auto&& value = *first;
      const Point& p = get(point_map, value);
      const Position_2 position = checked_position(p, id, are_exact);
      if (duplicate != m_next_duplicates.end() && duplicate->id == id)
        (duplicate++)->point = p;
      else
        m_positions.stage(m_maintained.ids().vertex(id), position, p);
    }
    if (first != beyond)
      throw Point_count_error_2(ids, ids + std::size_t(1));
    if (id < ids)
      throw Point_count_error_2(ids, id);
    m_positions.m_are_exact = are_exact;
  }

  void exchange_duplicates()
  {
    m_maintained.m_topology.template exchange_duplicates<Maintained>(Key(), m_next_duplicates);
  }

  Maintained& m_maintained;
  typename Maintained::Positions& m_positions;
  std::vector<typename Ids::Duplicate> m_next_duplicates;
  bool m_were_exact = true;
};

} // namespace internal
} // namespace Dynamic_Delaunay_triangulations_2
} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_INPUT_FRAME_2_H

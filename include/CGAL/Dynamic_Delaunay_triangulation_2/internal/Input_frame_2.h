// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_INPUT_FRAME_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_INPUT_FRAME_2_H

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Coordinate_range_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Flat_faces_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Maintained_triangulation_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Prefetch_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_errors_2.h>
#include <CGAL/number_type_basic.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <memory>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Dynamic_Delaunay_triangulations_2 {
namespace internal {

// Reads and checks the positions of a frame, before anything changes.
template <class Maintained>
class Input_frame_2
{
  using Point = typename Maintained::Point;

public:
  // Points that come, and whether none of their coordinates has to be rounded for the flat arrays.
  struct Newcomers
  {
    std::vector<Index> ids; // that they will get
    std::vector<Point> points;
    bool are_exact = true;
  };

  template <class InputIterator, class PointMap>
  static Newcomers read_newcomers(InputIterator first, InputIterator beyond,
                                  const PointMap& point_map, const Maintained& maintained)
  {
    Newcomers newcomers;
    for (; first != beyond; ++first)
      newcomers.points.push_back(get(point_map, *first));
    if (newcomers.points.size() > most_vertices - maintained.ids.number_of_points())
      throw std::length_error("a triangulation holds at most " + std::to_string(most_vertices) +
                              " points");
    newcomers.ids = maintained.ids.next_ids(newcomers.points.size());
    for (std::size_t i = 0; i < newcomers.points.size(); ++i)
      read_position(newcomers.points[i], newcomers.ids[i], newcomers.are_exact);
    return newcomers;
  }

  // Ids of points that are there, each once, in the order of the range.
  template <class InputIterator>
  static std::vector<Index> read_ids(InputIterator first, InputIterator beyond,
                                     const Maintained& maintained)
  {
    std::vector<Index> ids;
    for (; first != beyond; ++first)
      ids.push_back(read_id(*first, maintained));
    check_distinct(ids);
    return ids;
  }

  // Points with new positions.
  struct Movers
  {
    std::vector<Index> ids;
    std::vector<Point> points;
    bool are_exact = true;
  };

  template <class InputIterator, class IdMap, class PointMap>
  static Movers read_movers(InputIterator first, InputIterator beyond, const IdMap& id_map,
                            const PointMap& point_map, const Maintained& maintained)
  {
    Movers movers;
    for (; first != beyond; ++first) {
      movers.ids.push_back(read_id(get(id_map, *first), maintained));
      movers.points.push_back(get(point_map, *first));
      read_position(movers.points.back(), movers.ids.back(), movers.are_exact);
    }
    check_distinct(movers.ids);
    return movers;
  }

  // Reads a frame into the positions; CGAL's vertices keep the points of the last one until they
  // are written. If the frame is refused, or reading it throws, all is as it was.
  template <class InputIterator, class PointMap>
  void stage(InputIterator first, InputIterator beyond, const PointMap& point_map,
             Maintained& maintained)
  {
    maintained.next_guests = maintained.ids.guests();
    maintained.previous_positions_are_exact = maintained.positions_are_exact;
    try {
      stage_all(first, beyond, point_map, maintained);
    } catch (...) {
      maintained.restore_positions();
      throw;
    }
    maintained.points_are_written = false;
    std::swap(maintained.ids.guests(), maintained.next_guests);
  }

  // Takes it back.
  void unstage(Maintained& maintained)
  {
    maintained.restore_positions();
    std::swap(maintained.ids.guests(), maintained.next_guests);
  }

private:
  template <class InputIterator, class PointMap>
  static void stage_all(InputIterator first, InputIterator beyond, const PointMap& point_map,
                        Maintained& maintained)
  {
    using Category = typename std::iterator_traits<InputIterator>::iterator_category;
    if constexpr (std::is_convertible_v<Category, std::random_access_iterator_tag>)
      if (maintained.ids.guests().empty())
        return stage_all_hosts(first, beyond, point_map, maintained);
    stage_one_by_one(first, beyond, point_map, maintained);
  }

  // Where each point has a vertex of its own, and all are at hand: in the order of the vertices,
  // without a branch. A coordinate x is finite if 0x is 0, and within the limit if its product with
  // the factor is finite; two sums take turns, so that no addition waits for the one before.
  template <class RandomAccessIterator, class PointMap>
  static void stage_all_hosts(RandomAccessIterator first, RandomAccessIterator beyond,
                              const PointMap& point_map, Maintained& maintained)
  {
    const std::size_t ids = maintained.ids.number_of_ids();
    const std::size_t given = std::size_t(beyond - first);
    if (given != ids)
      throw Point_count_error_2(ids, (std::min)(given, ids + 1));
    using Difference = typename std::iterator_traits<RandomAccessIterator>::difference_type;
    const Index points = maintained.ids.number_of_hosts();
    const Index* const hosts = maintained.ids.hosts();
    bool are_exact = true;
    const auto stage = [&](std::size_t v, Position_2& zero) {
      const Point& p = get(point_map, first[Difference(hosts[v])]);
      const Position_2 position{CGAL::to_double(p.x()), CGAL::to_double(p.y())};
      zero.x += 0 * (factor_beyond_limit * position.x);
      zero.y += 0 * (factor_beyond_limit * position.y);
      if constexpr (!Maintained::coordinates_are_doubles)
        are_exact = are_exact && is_a_double(p.x()) && is_a_double(p.y());
      write(position, p, Index(v), maintained);
    };
    // one after the other in the plane, the points are anywhere in the range
    const auto prefetch_point = [&](std::size_t v) {
      using Reference = typename std::iterator_traits<RandomAccessIterator>::reference;
      if constexpr (std::is_lvalue_reference_v<Reference>)
        prefetch(std::addressof(first[Difference(hosts[v])]));
      prefetch(&maintained.positions[v]);
    };
    constexpr std::size_t ahead = 128;
    const std::size_t end_of_prefetching =
        points < fewest_vertices_to_prefetch ? 0 : points - ahead - 1;
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
        read_position(get(point_map, *first), id, are_exact);
  }

  template <class InputIterator, class PointMap>
  static void stage_one_by_one(InputIterator first, InputIterator beyond, const PointMap& point_map,
                               Maintained& maintained)
  {
    const Index ids = maintained.ids.number_of_ids();
    bool are_exact = true;
    auto guest = maintained.next_guests.begin(); // sorted by id
    Index id = 0;
    for (; id < ids && first != beyond; ++id, ++first) {
      if (!maintained.ids.is_taken(id))
        continue;
      const Point& p = get(point_map, *first);
      const Position_2 position = read_position(p, id, are_exact);
      if (guest != maintained.next_guests.end() && guest->id == id)
        (guest++)->point = p;
      else
        write(position, p, maintained.ids.vertex(id), maintained);
    }
    if (first != beyond)
      throw Point_count_error_2(ids, ids + std::size_t(1));
    if (id < ids)
      throw Point_count_error_2(ids, id);
    maintained.positions_are_exact = are_exact;
  }

  // Any integer, a negative one too.
  template <class Integer>
  static Index read_id(const Integer& id, const Maintained& maintained)
  {
    if (!maintained.ids.is_taken(std::size_t(id)))
      throw Unknown_id_error_2(std::size_t(id), maintained.ids.number_of_ids());
    return Index(id);
  }

  static void check_distinct(std::vector<Index> ids)
  {
    std::sort(ids.begin(), ids.end());
    const auto twice = std::adjacent_find(ids.begin(), ids.end());
    if (twice != ids.end())
      throw Repeated_id_error_2(*twice);
  }

  static Position_2 read_position(const Point& p, std::size_t id, bool& are_exact)
  {
    const Position_2 position = checked_position(p, id);
    if constexpr (!Maintained::coordinates_are_doubles)
      are_exact = are_exact && is_a_double(p.x()) && is_a_double(p.y());
    return position;
  }

  // Whether converting a coordinate to a double has not rounded it, as far as its interval tells.
  template <class FT>
  static bool is_a_double(const FT& coordinate)
  {
    const std::pair<double, double> interval = CGAL::to_interval(coordinate);
    return interval.first == interval.second;
  }

  static void write(const Position_2& position, const Point& p, Index vertex,
                    Maintained& maintained)
  {
    maintained.positions[vertex] = position;
    if constexpr (!Maintained::coordinates_are_doubles)
      maintained.next_points[vertex] = p;
  }
};

} // namespace internal
} // namespace Dynamic_Delaunay_triangulations_2
} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_INPUT_FRAME_2_H

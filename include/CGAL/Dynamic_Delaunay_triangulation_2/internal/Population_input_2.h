// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_POPULATION_INPUT_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_POPULATION_INPUT_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Change_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Distinct_numbers_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Flat_faces_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Input_position_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_errors_2.h>

#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL {
namespace Dynamic_Delaunay_triangulations_2 {
namespace internal {

// Reads and checks what comes, goes or moves alone, before anything changes.
template <class Maintained>
class Population_input_2
{
  using Point = typename Maintained::Point;

public:
  // Points that come.
  template <class InputIterator, class PointMap>
  static void read_newcomers(InputIterator first, InputIterator beyond, const PointMap& point_map,
                             const Maintained& maintained, Change_2<Point>& change)
  {
    std::vector<Point>& points = change.coming_points;
    for (; first != beyond; ++first)
      points.push_back(get(point_map, *first));
    if (points.size() > max_vertices - maintained.ids().number_of_points())
      throw std::length_error("a triangulation holds at most " + std::to_string(max_vertices) +
                              " points");
    change.coming = maintained.ids().next_ids(points.size());
    for (std::size_t i = 0; i < points.size(); ++i)
      checked_position(points[i], change.coming[i], change.are_exact);
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
  template <class InputIterator, class IdMap, class PointMap>
  static void read_movers(InputIterator first, InputIterator beyond, const IdMap& id_map,
                          const PointMap& point_map, const Maintained& maintained,
                          Change_2<Point>& change)
  {
    for (; first != beyond; ++first) {
      auto&& value = *first;
      change.moved.push_back(read_id(get(id_map, value), maintained));
      change.moved_points.push_back(get(point_map, value));
      checked_position(change.moved_points.back(), change.moved.back(), change.are_exact);
    }
    check_distinct(change.moved);
  }

private:
  // Any integer, a negative one too.
  template <class Integer>
  static Index read_id(const Integer& id, const Maintained& maintained)
  {
    if (!maintained.ids().is_taken(std::size_t(id)))
      throw Unknown_id_error_2(std::size_t(id), maintained.ids().number_of_ids());
    return Index(id);
  }
};

} // namespace internal
} // namespace Dynamic_Delaunay_triangulations_2
} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_POPULATION_INPUT_2_H

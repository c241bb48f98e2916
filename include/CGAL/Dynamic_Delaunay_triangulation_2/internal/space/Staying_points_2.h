// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_SPACE_STAYING_POINTS_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_SPACE_STAYING_POINTS_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Flat_arrays.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/topology/Point_ids_2.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

// The points of which a builder makes a triangulation: those that stay, and those that come.
template <class Point>
struct Points_to_build_2
{
  std::vector<Point_id> ids; // representatives that keep their vertices first
  std::vector<Point> points;
  Index number_of_ids = 0; // all ids are smaller
};

// Which of the present points stay when a triangulation is built anew.
template <class State>
class Staying_points_2
{
  using Point = typename State::Point;
  using Ids = Point_ids_2<Point>;
  using Parts = typename State::Parts;

public:
  explicit Staying_points_2(const State& state)
    : m_state(state)
  {
  }

  // Collects the present points except those in `gone`, and the points that come. Until forget()
  // it is known who goes.
  Points_to_build_2<Point> collect(const std::vector<Point_id>& gone, std::vector<Point_id> coming_ids,
                                   std::vector<Point> coming_points)
  {
    Points_to_build_2<Point> all;
    all.number_of_ids = m_state.ids().number_of_ids();
    for (const Point_id id : coming_ids)
      all.number_of_ids = (std::max)(all.number_of_ids, Index(id) + 1);
    all.ids = ids_without(gone);
    if (all.ids.empty()) { // as at a construction, where memory counts
      all.ids = std::move(coming_ids);
      all.points = std::move(coming_points);
      return all;
    }
    all.points.reserve(all.ids.size() + coming_ids.size());
    all.points.resize(all.ids.size());
    Parts::for_each_element(
        all.ids.size(), [&](std::size_t i) { all.points[i] = m_state.point_of_id(all.ids[i]); });
    all.points.insert(all.points.end(), coming_points.begin(), coming_points.end());
    all.ids.insert(all.ids.end(), coming_ids.begin(), coming_ids.end());
    return all;
  }

  // Whether the point with this id is removed. A new point may get its id, but not its vertex.
  bool goes(Point_id id) const { return id < m_goes.size() && m_goes[id]; }

  // Whether the point has a vertex of its own by these ids, and stays.
  bool keeps_vertex(Point_id id, const Ids& ids) const
  {
    return ids.is_taken(id) && ids.is_representative(id) && !goes(id);
  }

  // To be called when all is built.
  void forget() { m_goes.clear(); }

private:
  // The ids of all points but those in `gone`, representatives first.
  std::vector<Point_id> ids_without(const std::vector<Point_id>& gone)
  {
    std::vector<Point_id> ids = m_state.ids().representatives_and_duplicates();
    if (gone.empty())
      return ids;
    m_goes.assign(m_state.ids().number_of_ids(), false);
    for (const Point_id id : gone)
      m_goes[id] = true;
    ids.erase(std::remove_if(ids.begin(), ids.end(), [this](Point_id id) { return goes(id); }),
              ids.end());
    return ids;
  }

  const State& m_state;
  std::vector<bool> m_goes; // by ids
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_SPACE_STAYING_POINTS_2_H

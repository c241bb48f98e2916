// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_PERIODIC_PERIODIC_INPUT_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_PERIODIC_PERIODIC_INPUT_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/core/Flat_arrays_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/core/Input_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/core/Points_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/core/Processor_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/periodic/Lattice_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/periodic/Torus_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_errors_2.h>
#include <CGAL/Periodic_cell_2.h>

#include <boost/property_map/property_map.hpp>

#include <cmath>
#include <cstddef>
#include <iterator>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Dynamic_Delaunay_triangulations_2 {
namespace internal {

// Reads and checks the input of a periodic triangulation before anything changes.
template <class State>
class Periodic_input_2
{
  using Point = typename State::Point;

public:
  explicit Periodic_input_2(const State& state)
    : m_state(state)
    , m_cell(state.torus().cell())
  {
  }

  // Throws if this cannot be the next cell.
  void check_next(const Periodic_cell_2& next) const
  {
    check_cell(next);
    if (next.is_slab() != m_state.torus().cell().is_slab())
      throw Periodic_cell_error_2(next.ax(), next.ay(), next.bx(), next.by(),
                                  next.is_slab() ? "a cell cannot become a slab"
                                                 : "a slab cannot become a cell with two vectors");
  }

  // Reads a frame and its cell, to be used in this call. Positions in memory stay there; other
  // ranges may be costly to read twice, and are copied.
  template <class InputIterator, class PointMap>
  void stage(InputIterator first, InputIterator beyond, const PointMap& point_map)
  {
    stage(first, beyond, point_map, m_state.torus().cell());
  }
  template <class InputIterator, class PointMap>
  void stage(InputIterator first, InputIterator beyond, const PointMap& point_map,
             const Periodic_cell_2& cell)
  {
    using Value = typename std::iterator_traits<InputIterator>::value_type;
    using Identity_map = boost::typed_identity_property_map<Point>;
    check_next(cell);
    m_cell = cell;
    m_points = nullptr;
    m_positions.clear();
    if constexpr (is_in_memory<InputIterator> && std::is_same_v<Value, Point> &&
                  std::is_same_v<PointMap, Identity_map>) {
      check_count(std::size_t(beyond - first));
      m_points = first == beyond ? nullptr : &*first;
    } else {
      copy(first, beyond, point_map);
    }
  }

  // Calls f(next) for the frame, which has the position `next(id)` for each id.
  template <class Function>
  void with_frame(const Function& f) const
  {
    if (m_points)
      f(Points_in_memory{m_points});
    else
      f(Positions{m_positions.data()});
  }
  const Periodic_cell_2& cell() const { return m_cell; }

  // Only the update changes positions, which can take them back.
  void accept() {}
  void settle() {}

  // Throws if a position of the frame cannot be used in its cell.
  template <class Next>
  void check_frame(const Next& next) const
  {
    const Torus_2 torus(m_cell);
    for (Index id = 0; id < m_state.ids().number_of_ids(); ++id)
      if (m_state.ids().is_taken(id)) {
        const Position_2 p = next(id);
        check(Point(p.x, p.y), id, torus);
      }
  }

  // Throws if a point with one of these ids is too far away.
  void check(const std::vector<Point>& points, const std::vector<Index>& ids) const
  {
    check(points, ids, m_state.torus().cell());
  }
  static void check(const std::vector<Point>& points, const std::vector<Index>& ids,
                    const Periodic_cell_2& cell)
  {
    const Torus_2 torus(cell);
    for (std::size_t i = 0; i < points.size(); ++i)
      check(points[i], ids[i], torus);
  }

  static std::vector<Position_2> positions(const std::vector<Point>& points)
  {
    std::vector<Position_2> positions;
    for (const Point& p : points)
      positions.push_back({p.x(), p.y()});
    return positions;
  }

private:
  struct Points_in_memory
  {
    Position_2 operator()(std::size_t id) const { return {points[id].x(), points[id].y()}; }
    void prefetch(std::size_t id) const { internal::prefetch(&points[id]); }

    const Point* points;
  };

  struct Positions
  {
    Position_2 operator()(std::size_t id) const { return positions[id]; }
    void prefetch(std::size_t id) const { internal::prefetch(&positions[id]); }

    const Position_2* positions;
  };

  template <class InputIterator, class PointMap>
  void copy(InputIterator first, InputIterator beyond, const PointMap& point_map)
  {
    const std::size_t ids = m_state.ids().number_of_ids();
    for (; first != beyond && m_positions.size() <= ids; ++first) {
      auto&& value = *first;
      const Point& p = get(point_map, value);
      m_positions.push_back({p.x(), p.y()});
    }
    check_count(m_positions.size());
  }

  void check_count(std::size_t given) const
  {
    if (given != m_state.ids().number_of_ids())
      throw Point_count_error_2(m_state.ids().number_of_ids(), given);
  }

  static void check(const Point& p, std::size_t id, const Torus_2& torus)
  {
    checked_position(p, id, torus);
  }

  const State& m_state;
  Periodic_cell_2 m_cell;              // of the frame
  const Point* m_points = nullptr;     // of a frame in memory, by ids
  std::vector<Position_2> m_positions; // of one that was copied, by ids
};

} // namespace internal
} // namespace Dynamic_Delaunay_triangulations_2
} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_PERIODIC_PERIODIC_INPUT_2_H

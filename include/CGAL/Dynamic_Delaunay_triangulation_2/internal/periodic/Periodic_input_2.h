// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_PERIODIC_PERIODIC_INPUT_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_PERIODIC_PERIODIC_INPUT_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Flat_arrays.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Processor.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Range_arguments.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Flat_elements_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Points_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/periodic/Lattice_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/periodic/Torus_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/periodic/Torus_editing_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/space/Input_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/space/Positions_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_errors_2.h>
#include <CGAL/Periodic_cell_2.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

// Reads and checks the input of a periodic triangulation before anything changes. For a frame, also
// finds the points that cross the border of the cell. An accepted frame can be taken back.
template <class State>
class Periodic_input_2
{
  using Point = typename State::Point;
  using Parts = typename State::Parts;
  using Shift = Periodic_shift_2;

public:
  explicit Periodic_input_2(State& state)
    : m_state(state)
    , m_writer(state)
    , m_positions(m_writer.positions())
    , m_editing(state)
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

  // Throws if a point with one of these ids is too far away.
  void check(const std::vector<Point>& points, const std::vector<Point_id>& ids) const
  {
    Parts::for_each_element(points.size(), [&](std::size_t i) {
      checked_position(points[i], ids[i], m_state.torus());
    });
  }

  // A FRAME -------------------------------------------------------------------------------------

  // Ignores the positions with these ids in the next frame, because the call removes their points.
  // Until then these points move along with the cell.
  void leave_out(const std::vector<Point_id>& ids) { m_gone = ids; }

  // Reads and checks a frame and its cell. Nothing changes before accept(), nor if this throws.
  template <class InputIterator, class PointMap>
  void stage(InputIterator first, InputIterator beyond, const PointMap& point_map)
  {
    stage(first, beyond, point_map, Periodic_cell_2(m_state.torus().cell()));
  }
  template <class InputIterator, class PointMap>
  void stage(InputIterator first, InputIterator beyond, const PointMap& point_map,
             const Periodic_cell_2& cell)
  {
    using Value = typename std::iterator_traits<InputIterator>::value_type;
    using Identity_map = boost::typed_identity_property_map<Point>;
    const std::vector<Point_id> gone = std::exchange(m_gone, {});
    check_next(cell);
    check_frame_length(first, beyond, m_state.ids().number_of_ids());
    if constexpr (is_in_memory<InputIterator> && std::is_same_v<Value, Point> &&
                  std::is_same_v<PointMap, Identity_map>) {
      stage_points({first == beyond ? nullptr : &*first}, cell, gone);
    } else { // other ranges may be costly to read twice
      const std::vector<Point> points = copied(first, beyond, point_map);
      stage_points({points.data()}, cell, gone);
    }
  }

  // Makes the staged positions and the staged cell the present ones. Throws nothing.
  void accept()
  {
    m_cell_before = m_state.torus().cell();
    if (m_cell != m_cell_before)
      m_editing.set_cell(m_cell, m_multiples);
    m_positions.accept_frame(true);
    m_writer.ids().covered_points().swap(m_next_covered);
    for (const auto& [v, shift] : m_translated)
      m_editing.shift_images(v, shift);
  }

  // Undoes accept(): restores the positions and the cell of the last frame. Throws nothing.
  void take_back()
  {
    for (const auto& [v, shift] : m_translated)
      m_editing.shift_images(v, no_shift - shift);
    m_positions.take_back(true);
    m_writer.ids().covered_points().swap(m_next_covered);
    if (m_cell != m_cell_before)
      m_editing.set_cell(m_cell_before, inverse(m_multiples));
  }

  // Forgets the previous positions. To be called at the end of each call of the user.
  void forget_previous()
  {
    m_positions.forget_previous();
    m_writer.forget_deformation();
  }

private:
  struct Points_by_id
  {
    const Point& operator()(std::size_t id) const { return points[id]; }
    void prefetch(std::size_t id) const { internal::prefetch(&points[id]); }

    const Point* points;
  };

  // The points of a frame, where points that are left out move along with the cell.
  struct Points_that_stay
  {
    Point operator()(std::size_t id) const
    {
      return goes[id] ? input.point_taken_along(Point_id(id), now) : points(id);
    }
    void prefetch(std::size_t) const {}

    const Periodic_input_2& input;
    const Torus_2& now;
    const Points_by_id& points;
    std::vector<bool> goes; // indexed by ids
  };

  template <class InputIterator, class PointMap>
  std::vector<Point> copied(InputIterator first, InputIterator beyond,
                            const PointMap& point_map) const
  {
    const std::size_t ids = m_state.ids().number_of_ids();
    std::vector<Point> points;
    for (; first != beyond && points.size() <= ids; ++first) {
      auto&& value = *first;
      points.push_back(get(point_map, value));
    }
    if (points.size() != ids)
      throw Point_count_error_2(ids, points.size());
    return points;
  }

  void stage_points(const Points_by_id& points, const Periodic_cell_2& cell,
                    const std::vector<Point_id>& gone)
  {
    const Torus_2 now(cell);
    m_cell = cell;
    m_multiples = is_same_cell() ? unit_multiples : countable_multiples(now);
    if (gone.empty())
      return stage_all(points, now);
    Points_that_stay staying{*this, now, points, std::vector<bool>(m_state.ids().number_of_ids())};
    for (const Point_id id : gone)
      staying.goes[id] = true;
    stage_all(staying, now);
  }

  bool is_same_cell() const { return m_cell == m_state.torus().cell(); }

  // Returns the point moved with the cell: its multiples of the vectors stay, up to wrapping.
  Point point_taken_along(Point_id id, const Torus_2& now) const
  {
    const Point p = m_state.point_of_id(id);
    if (is_same_cell())
      return p;
    const Position_2 s = multiples_in_next_cell(approximation(p));
    const Position_2 q = now.vector({s.x - std::floor(s.x), s.y - std::floor(s.y)});
    return Point(q.x, q.y);
  }

  // Stages the point `next(id)` of each id.
  template <class Next>
  void stage_all(const Next& next, const Torus_2& now)
  {
    m_positions.begin_frame();
    m_next_covered = m_state.ids().covered_points();
    bool are_in_range =
        is_same_cell() ? stage_vertices<true>(next, now) : stage_vertices<false>(next, now);
    for (Index i = 0; i < m_next_covered.size(); ++i) {
      m_next_covered[i] = next(m_state.ids().covered_id(i));
      are_in_range = are_in_range && is_in_range(approximation(m_next_covered[i]), now);
    }
    if (!are_in_range)
      throw_refused(next, now);
    // for accept(), take_back() and accept() again
    m_editing.reserve_for_move(3 * m_translated.size() + 2);
  }

  template <class Next>
  void throw_refused(const Next& next, const Torus_2& now) const
  {
    for (Point_id id(0); id < m_state.ids().number_of_ids(); ++id)
      if (m_state.ids().is_taken(id))
        checked_position(next(id), id, now);
  }

  static bool is_in_range(const Position_2& p, const Torus_2& torus)
  {
    const Position_2 m = torus.periodic(torus.multiples(p));
    return std::abs(m.x) < max_shift && std::abs(m.y) < max_shift && is_within_limit(p.x) &&
           is_within_limit(p.y);
  }

  // VERTICES ------------------------------------------------------------------------------------

  // Returns a bound: positions with |x| + |y| up to it are in range.
  static double usual_sum(const Torus_2& torus)
  {
    constexpr double rounding = 0.99;
    return (std::min)(rounding * max_shift / torus.largest_multiple(1), coordinate_limit / 2);
  }

  using Translations = std::vector<std::pair<Vertex_index, Shift>>;

  // Stages the positions of the vertices. Lists the vertices that are nearest to another image of
  // their last position, with its shift in multiples of the new cell's vectors: a point that leaves
  // the cell and enters it at the other side does not go far. False if a coordinate is not finite,
  // or a point is out of range in the new cell.
  template <bool is_same, class Next>
  bool stage_vertices(const Next& next, const Torus_2& now)
  {
    const Index vertices = m_state.number_of_vertices();
    m_parts.resize(Parts::number(vertices));
    std::atomic<bool> are_in_range{true};
    Parts::for_each(vertices, [&](std::size_t part, std::size_t first, std::size_t beyond) {
      if (!stage_part<is_same>(next, now, Index(first) + 1, Index(beyond) + 1, m_parts[part]))
        are_in_range.store(false, std::memory_order_relaxed);
    });
    m_translated.clear();
    for (const Translations& translated : m_parts)
      m_translated.insert(m_translated.end(), translated.begin(), translated.end());
    return are_in_range;
  }

  template <bool is_same, class Next>
  bool stage_part(const Next& next, const Torus_2& now, Index first, Index beyond,
                  Translations& translated)
  {
    translated.clear();
    const double usual = usual_sum(now);
    const Index vertices = m_state.number_of_vertices();
    const Index end_of_prefetching =
        vertices < min_vertices_to_prefetch ? 0 : vertices - prefetched_ahead;
    constexpr Index block = 16;
    static_assert(block <= prefetched_ahead);
    for (Vertex_index v(first); v < beyond; v += block) {
      const Index end = (std::min)(Index(v) + block, beyond);
      const Index prefetched = end < end_of_prefetching ? prefetched_ahead : 0;
      if (!(is_same && stage_usual(next, now, usual, v, end, prefetched)) &&
          !stage_any<is_same>(next, now, v, end, translated))
        return false;
    }
    return true;
  }

  // Stages vertices if none of them goes far or crosses the border. False if one does: then
  // stage_any() has to stage all of them again. There is no branch for each vertex, which in calm
  // frames saves a tenth of the time of an update.
  template <class Next>
  bool stage_usual(const Next& next, const Torus_2& now, double usual, Index first, Index beyond,
                   Index prefetched)
  {
    const auto staged = m_positions.staged();
    const Point_id* const representatives = m_state.ids().representatives();
    const Position_2* const positions = m_state.positions().data();
    const double short_way = now.short_way();
    bool are_usual = true;
    for (Vertex_index v(first); v < beyond; ++v) {
      next.prefetch(representatives[v + prefetched]);
      const Point& point = next(representatives[v]);
      const Position_2 q = approximation(point), way = q - positions[v];
      staged.set(v, q, point);
      are_usual &= std::abs(way.x) + std::abs(way.y) <= short_way;
      are_usual &= std::abs(q.x) + std::abs(q.y) <= usual;
    }
    return are_usual;
  }

  template <bool is_same, class Next>
  bool stage_any(const Next& next, const Torus_2& now, Index first, Index beyond,
                 Translations& translated)
  {
    const auto staged = m_positions.staged();
    for (Vertex_index v(first); v < beyond; ++v) {
      const Position_2& p = m_state.positions()[v];
      const Point& point = next(m_state.ids().representative(v));
      const Position_2 q = approximation(point);
      staged.set(v, q, point);
      if (!is_in_range(q, now))
        return false; // the shift may not fit into an int
      const Position_2 way = q - p;
      if (is_same && now.is_short(way))
        continue;
      const Position_2 step =
          is_same ? now.multiples(way) : now.multiples(q) - multiples_in_next_cell(p);
      const Shift shift = now.nearest_shift(step);
      if (!are_equal(shift, no_shift))
        translated.push_back({v, shift});
    }
    return true;
  }

  // CELLS ---------------------------------------------------------------------------------------

  // Returns the old cell's vectors in multiples of the next ones. Edges that a heuristic classifier
  // has missed can grow with each exchange of cells. If shifts would exceed their limit, the
  // exchange counts as deformation.
  std::array<Shift, 2> countable_multiples(const Torus_2& next) const
  {
    const auto multiples = multiples_in_new_cell(m_state.torus(), next);
    return are_countable(multiples) ? multiples : multiples_in_deformed_cell(m_state.torus(), next);
  }

  // Whether all shifts are within their limit when a cell is exchanged by these multiples.
  bool are_countable(const std::array<Shift, 2>& multiples) const
  {
    if (multiples == unit_multiples || multiples == exchanged_multiples)
      return true;
    const Index halfedges = m_state.arrays().number_of_halfedges();
    return Parts::all_of(halfedges, [&](std::size_t first, std::size_t beyond) {
      bool are = true;
      for (std::size_t h = first; h < beyond; ++h) {
        const auto [i, j] = m_state.shift(Halfedge_index(h));
        for (std::size_t k = 0; k < 2; ++k)
          are &= std::abs(double(i) * multiples[0][k] + double(j) * multiples[1][k]) <
                 max_shift_in_face;
      }
      return are;
    });
  }

  // Returns a position of the old cell, moved with the cell, in multiples of the new vectors.
  Position_2 multiples_in_next_cell(const Position_2& p) const
  {
    return in_new_multiples(m_state.torus().multiples(p), m_multiples);
  }

  // \pre The determinant is 1 or -1.
  static std::array<Shift, 2> inverse(const std::array<Shift, 2>& matrix)
  {
    const auto [a, b] = matrix[0];
    const auto [c, d] = matrix[1];
    const int sign = determinant(matrix);
    return {{{sign * d, -sign * b}, {-sign * c, sign * a}}};
  }

  static constexpr Index prefetched_ahead = 64; // points

  const State& m_state;
  const typename State::Writer m_writer;
  typename State::Writer::Positions& m_positions;
  Torus_editing_2<State> m_editing;
  std::vector<Point_id> m_gone;      // ids to be left out of the next frame
  std::vector<Point> m_next_covered; // by their numbers
  std::vector<Translations> m_parts; // of the vertices, while they are staged
  Translations m_translated;         // vertices, and their shifts
  Periodic_cell_2 m_cell{1, 1}, m_cell_before{1, 1};
  std::array<Shift, 2> m_multiples = unit_multiples; // of the old cell's vectors
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_PERIODIC_PERIODIC_INPUT_2_H

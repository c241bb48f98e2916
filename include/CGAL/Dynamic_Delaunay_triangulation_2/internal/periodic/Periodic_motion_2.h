// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_PERIODIC_PERIODIC_MOTION_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_PERIODIC_PERIODIC_MOTION_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/core/Computed_geometry_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/core/Flat_arrays_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/core/Points_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/core/Processor_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/periodic/Lattice_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/periodic/Torus_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/topology/Halfedge_arrays_2.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Dynamic_Delaunay_triangulations_2 {
namespace internal {

// The motion of a frame in periodic space: reads it, and finds which points cross the border of the
// cell and which ones jump, before anything moves.
template <class State, class Editor>
class Periodic_motion_2
{
  using Arrays = Halfedge_arrays_2;
  using Parts = typename State::Parts;

public:
  Periodic_motion_2(const State& state, Editor& editor)
    : m_state(state)
    , m_editor(editor)
  {
  }

  // Reads the position `next(id)` of each point for update(). False if a coordinate is not finite,
  // or a point out of range in the new cell.
  template <class Next>
  bool stage(const Next& next, const Periodic_cell_2& cell)
  {
    const Torus_2 now(cell);
    const bool is_same = cell == m_state.torus().cell();
    m_multiples = is_same ? unit_multiples : countable_multiples(now);
    return (is_same ? stage_vertices<true>(next, now) : stage_vertices<false>(next, now)) &&
           std::all_of(ids().duplicates().begin(), ids().duplicates().end(),
                       [&](const auto& d) { return is_in_range(next(d.id), now); });
  }

  // After stage(): points that go farther than half the way to their nearest neighbors, and would
  // tangle the faces on their way.
  std::vector<Index> find_jumpers() const
  {
    std::vector<Index> jumpers;
    const double long_way = squared_long_way();
    for (const auto& [v, way] : m_far) {
      const double squared = squared_distance(way, m_next_mean_way);
      if (squared > long_way && 4 * squared > squared_distance_to_neighbors(v))
        jumpers.push_back(v);
    }
    return jumpers;
  }

  // Of all vertices, in the last frame.
  const Position_2& mean_way() const { return m_mean_way; }
  void set_mean_way(const Position_2& way) { m_mean_way = way; }

  // Moves the vertices where they were staged.
  void move_vertices(const Periodic_cell_2& cell)
  {
    if (cell != m_state.torus().cell())
      m_editor.set_cell(cell, m_multiples);
    m_editor.exchange_positions();
    m_mean_way = m_next_mean_way;
    for (const auto& [v, shift] : m_translated)
      m_editor.shift_images(v, shift);
  }

  // Undoes that; this was the cell before.
  void move_vertices_back(const Periodic_cell_2& cell)
  {
    for (const auto& [v, shift] : m_translated)
      m_editor.shift_images(v, no_shift - shift);
    m_editor.exchange_positions();
    if (cell != m_state.torus().cell())
      m_editor.set_cell(cell, inverse(m_multiples));
  }

private:
  static constexpr Index prefetched_ahead = 64; // points

  const typename State::Ids& ids() const { return m_state.ids(); }

  // Points that go no farther from the mean motion, to coordinates whose sum is no larger, go less
  // than half through the cell, not far, and stay in range.
  struct Usual_step
  {
    double squared_way, coordinates;
  };
  Usual_step usual_step(const Torus_2& torus, double long_way) const
  {
    constexpr double rounding = 0.99;
    const double way = std::hypot(m_mean_way.x, m_mean_way.y) + std::sqrt(long_way);
    return {torus.largest_multiple(way) < rounding / 2 ? long_way : -1,
            (std::min)(rounding * max_shift / torus.largest_multiple(1), coordinate_limit / 2)};
  }

  // Stages the positions of the vertices, and finds which of them come nearest to where they were
  // by a translation, in multiples of the new cell's vectors: points that leave the cell and come
  // in at the other side do not go far. Also finds those that go far otherwise, compared to the
  // last frame's mean motion. The result is that of stage().
  template <bool is_same, class Next>
  bool stage_vertices(const Next& next, const Torus_2& now)
  {
    std::vector<Position_2>& staged = m_editor.next_positions();
    staged.resize(m_state.positions().size());
    staged[infinite_index] = nan_point();
    const Index vertices = m_state.number_of_vertices();
    const double long_way = squared_long_way();
    const Usual_step usual = is_same ? usual_step(now, long_way) : Usual_step{-1, 0};
    m_parts.resize(Parts::number(vertices));
    Parts::for_each(vertices, [&](std::size_t part, std::size_t first, std::size_t beyond) {
      stage_part<is_same>(next, now, long_way, usual, Index(first) + 1, Index(beyond) + 1,
                          m_parts[part]);
    });
    return join_parts();
  }

  // What was found out about a part of the vertices.
  struct Part
  {
    std::vector<std::pair<Index, Periodic_shift_2>> translated;
    std::vector<std::pair<Index, Position_2>> far_movers;
    Position_2 sum;
    bool are_in_range;
  };

  bool join_parts()
  {
    m_translated.clear();
    m_far.clear();
    bool are_in_range = true;
    Position_2 sum{0, 0};
    for (const Part& part : m_parts) {
      m_translated.insert(m_translated.end(), part.translated.begin(), part.translated.end());
      m_far.insert(m_far.end(), part.far_movers.begin(), part.far_movers.end());
      sum = {sum.x + part.sum.x, sum.y + part.sum.y};
      are_in_range &= part.are_in_range;
    }
    const Index vertices = m_state.number_of_vertices();
    m_next_mean_way =
        vertices > 0 ? Position_2{sum.x / vertices, sum.y / vertices} : Position_2{0, 0};
    return are_in_range;
  }

  template <bool is_same, class Next>
  void stage_part(const Next& next, const Torus_2& now, double long_way, const Usual_step& usual,
                  Index first, Index beyond, Part& part)
  {
    std::vector<Position_2>& staged = m_editor.next_positions();
    const Index* const representatives = ids().representatives();
    const Index vertices = m_state.number_of_vertices();
    const Index end_of_prefetching =
        vertices < min_vertices_to_prefetch ? 0 : vertices - prefetched_ahead;
    part.translated.clear();
    part.far_movers.clear();
    part.sum = {0, 0};
    part.are_in_range = true;
    Position_2 sum{0, 0};
    for (Index v = first; v < beyond; ++v) {
      if (v < end_of_prefetching)
        next.prefetch(representatives[v + prefetched_ahead]);
      const Position_2& p = m_state.positions()[v];
      const Position_2 q = next(representatives[v]);
      staged[v] = q;
      Position_2 way{q.x - p.x, q.y - p.y};
      if (squared_distance(way, m_mean_way) <= usual.squared_way &&
          std::abs(q.x) + std::abs(q.y) <= usual.coordinates) {
        sum = {sum.x + way.x, sum.y + way.y};
        continue;
      }
      const Position_2 multiples = now.multiples(q);
      part.are_in_range &= is_in_range(q, now);
      const Position_2 step = is_same ? now.multiples(way) : step_to_new_cell(p, multiples);
      if (!is_same || !(std::abs(step.x) <= 0.5 && std::abs(step.y) <= 0.5)) {
        if (!part.are_in_range)
          return; // a shift may be no integer
        const Periodic_shift_2 shift = now.nearest_shift(step);
        if (!are_equal(shift, no_shift))
          part.translated.push_back({v, shift});
        way = now.vector({step.x - shift[0], step.y - shift[1]});
      }
      sum = {sum.x + way.x, sum.y + way.y};
      if (squared_distance(way, m_mean_way) > long_way)
        part.far_movers.push_back({v, way});
    }
    part.sum = sum;
  }

  static bool is_in_range(const Position_2& p, const Torus_2& torus)
  {
    const Position_2 m = torus.periodic(torus.multiples(p));
    return std::abs(m.x) < max_shift && std::abs(m.y) < max_shift && is_within_limit(p.x) &&
           is_within_limit(p.y);
  }

  // The vectors of the old cell in those of the next one. Edges that a heuristic classifier has
  // left as they were can become longer with each exchange of cells: then it counts as deformation.
  std::array<Periodic_shift_2, 2> countable_multiples(const Torus_2& next) const
  {
    const auto multiples = multiples_in_new_cell(m_state.torus(), next);
    return are_countable(multiples) ? multiples : multiples_in_deformed_cell(m_state.torus(), next);
  }

  // Whether all shifts are within their limit when a cell is exchanged by these multiples.
  bool are_countable(const std::array<Periodic_shift_2, 2>& multiples) const
  {
    if (multiples == unit_multiples || multiples == exchanged_multiples)
      return true;
    const Index halfedges = 3 * m_state.arrays().number_of_faces();
    return Parts::all_of(halfedges, [&](std::size_t first, std::size_t beyond) {
      bool are = true;
      for (std::size_t h = first; h < beyond; ++h) {
        const auto [i, j] = m_state.shift(Index(h));
        for (std::size_t k = 0; k < 2; ++k)
          are &= std::abs(double(i) * multiples[0][k] + double(j) * multiples[1][k]) <
                 max_shift_in_face;
      }
      return are;
    });
  }

  // From p in the old cell to a position in the new one, in multiples of the new cell's vectors.
  Position_2 step_to_new_cell(const Position_2& p, const Position_2& multiples) const
  {
    const Position_2 s = m_state.torus().multiples(p);
    return {multiples.x - (s.x * m_multiples[0][0] + s.y * m_multiples[1][0]),
            multiples.y - (s.x * m_multiples[0][1] + s.y * m_multiples[1][1])};
  }

  // Of an integer matrix with determinant 1 or -1.
  static std::array<Periodic_shift_2, 2> inverse(const std::array<Periodic_shift_2, 2>& matrix)
  {
    const auto [a, b] = matrix[0];
    const auto [c, d] = matrix[1];
    const int sign = determinant(matrix);
    return {{{sign * d, -sign * b}, {-sign * c, sign * a}}};
  }

  double squared_distance_to_neighbors(Index v) const
  {
    double least = std::numeric_limits<double>::infinity();
    const Torus_2& torus = m_state.torus();
    m_state.arrays().for_each_corner(v, [&](Index h) {
      const Image_2 p = m_state.image(h), q = m_state.image(Arrays::next(h));
      if (!torus.are_across(p.shift, q.shift))
        least = (std::min)(least, squared_distance(torus.rounded(p), torus.rounded(q)));
    });
    return least;
  }

  // A quarter of the spacing.
  double squared_long_way() const { return area_of_points() / m_state.number_of_vertices() / 16; }

  // That of the cell. In a slab that of the strip with all points, or, where that is thin, of
  // squares between points in a row.
  double area_of_points() const
  {
    const Torus_2& torus = m_state.torus();
    if (!torus.cell().is_slab())
      return torus.cell().area();
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (Index v = 1; v <= m_state.number_of_vertices(); ++v) {
      const double height = torus.multiples(m_state.positions()[v]).y;
      low = (std::min)(low, height);
      high = (std::max)(high, height);
    }
    const double length = std::hypot(torus.cell().ax(), torus.cell().ay());
    return length * (std::max)(high - low, length / m_state.number_of_vertices());
  }

  const State& m_state;
  Editor& m_editor;
  std::vector<std::pair<Index, Periodic_shift_2>> m_translated;
  std::vector<std::pair<Index, Position_2>> m_far; // vertices and their ways
  std::vector<Part> m_parts;                       // of the vertices, while they are staged
  Position_2 m_mean_way{0, 0}, m_next_mean_way{0, 0};
  std::array<Periodic_shift_2, 2> m_multiples = unit_multiples; // of the old cell's vectors
};

} // namespace internal
} // namespace Dynamic_Delaunay_triangulations_2
} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_PERIODIC_PERIODIC_MOTION_2_H

// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_QUERIES_DISTANCE_QUERY_3_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_QUERIES_DISTANCE_QUERY_3_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/passes/Elements_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/passes/Points_3.h>
#include <CGAL/enum.h>
#include <CGAL/number_type_basic.h>

#include <cstddef>
#include <limits>

namespace CGAL::Dynamic_Delaunay_triangulations_3::internal {

// Compares the distances of vertices from a query point exactly: in doubles, and by the kernel
// where these leave it undecided.
template <class State>
class Distance_query_3
{
public:
  using Point = typename State::Point;

  // Throws unless p is a valid point: the error calls it `number`. Both must outlive this object.
  Distance_query_3(const State& state, const Point& p, std::size_t number)
    : m_state(state)
    , m_point(p)
    , m_position(checked_position(p, number))
    , m_is_exact(state.positions_are_exact && has_exact_position(p))
  {
  }

  const State& state() const { return m_state; }

  double rounded_squared_distance(Vertex_index v) const
  {
    return squared_length(m_state.positions.position(v) - m_position);
  }

  double rounded_squared_length(Vertex_index v, Vertex_index w) const
  {
    return squared_length(m_state.positions.position(w) - m_state.positions.position(v));
  }

  // A vertex, and an interval of its squared distance.
  struct Measured
  {
    Vertex_index vertex;
    double least, most;
  };

  // The square is off by at most 3u times the sum of the squares, where u = 2^-53, and by what
  // underflows. Taken twice, the bound covers the sum or difference that makes an end.
  Measured measured(Vertex_index v) const
  {
    if (!m_is_exact)
      return {v, 0, std::numeric_limits<double>::infinity()};
    const double square = rounded_squared_distance(v), error = 0x1p-48 * square + 1e-300;
    return {v, square - error, square + error};
  }

  Comparison_result compare(const Measured& a, const Measured& b) const
  {
    const Comparison_result result = filtered(a, b.least, b.most);
    return result != EQUAL ? result
                           : m_state.traits.compare_distance_3_object()(
                                 m_point, m_state.point(a.vertex), m_state.point(b.vertex));
  }

  template <class FT>
  Comparison_result compare_square(const Measured& a, const FT& other) const
  {
    const auto [lower, upper] = CGAL::to_interval(other);
    const Comparison_result result = lower == upper ? filtered(a, lower, upper) : EQUAL;
    return result != EQUAL ? result
                           : m_state.traits.compare_squared_distance_3_object()(
                                 m_point, m_state.point(a.vertex), other);
  }

private:
  // EQUAL if undecided, as where something overflows.
  static Comparison_result filtered(const Measured& a, double least, double most)
  {
    return a.most < least ? SMALLER : most < a.least ? LARGER : EQUAL;
  }

  const State& m_state;
  const Point& m_point;
  const Position_3 m_position;
  const bool m_is_exact;
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_3::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_QUERIES_DISTANCE_QUERY_3_H

// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_QUERIES_VERTEX_GEOMETRY_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_QUERIES_VERTEX_GEOMETRY_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Floating_point.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Flat_elements_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Points_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/topology/Halfedge_arrays_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_errors_2.h>
#include <CGAL/enum.h>
#include <CGAL/number_type_basic.h>

#include <boost/config.hpp>

#include <limits>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

// Throws unless a number is not negative, and finite or up to a limit. The error calls it `name`.
inline void check_extent(const char* name, double extent,
                         double largest = (std::numeric_limits<double>::max)())
{
  if (!(extent >= 0 && extent <= largest))
    throw Parameter_error_2(name, extent, 0, largest);
}

// The vector from one vertex to another, rounded once. It does not subtract rounded positions,
// because points that an exact kernel distinguishes may have equal doubles as coordinates.
template <class Dynamic>
class Vertex_differences_2
{
public:
  explicit Vertex_differences_2(const Dynamic& dt)
    : m_dt(dt)
    , m_frame(dt.frame())
    , m_positions_are_exact(m_frame.positions_are_exact())
  {
  }

  // Passes over faces are much slower where compilers do not inline this.
  BOOST_FORCEINLINE Position_2 operator()(Index from, Index to) const
  {
    if (m_positions_are_exact)
      return m_frame.position(to) - m_frame.position(from);
    const auto& p = m_dt.point(m_frame.id(from));
    const auto& q = m_dt.point(m_frame.id(to));
    return {CGAL::to_double(q.x() - p.x()), CGAL::to_double(q.y() - p.y())};
  }

private:
  const Dynamic& m_dt;
  const typename Dynamic::Frame m_frame;
  const bool m_positions_are_exact;
};

// Compares the distances of vertices from one point exactly: by floating point, and by the kernel
// where that is undecided.
//
// With u = 2^-53, a squared distance s is computed as S with |S - s| <= 5u S + 2^-1072: each
// difference is rounded once, each square and the sum once more, and each square may lose up to
// 2^-1074 to underflow. For two such distances, S < (1 - 2^-48) T and 2^-900 <= T < infinity imply
// s < t, because 2^-48 T = 32u T exceeds both errors and that of the product together. The same
// holds if one of the two is a number that is not rounded.
template <class Dynamic>
class Distances_2
{
  using Traits = typename Dynamic::Geom_traits;
  using Point = typename Dynamic::Point;
  using FT = typename Traits::FT;

public:
  // Distances from p. Throws if p has coordinates that a point must not have: the error calls p
  // `number`.
  Distances_2(const Dynamic& dt, const Point& p, std::size_t number = 0)
    : m_dt(dt)
    , m_frame(dt.frame())
    , m_traits(dt.triangulation().geom_traits())
    , m_from(p)
    , m_position(checked_position(p, number, m_positions_are_exact))
  {
    m_positions_are_exact = m_positions_are_exact && m_frame.positions_are_exact();
  }

  // Computed in plain floating point.
  double approximate_square(Vertex_index v) const
  {
    return squared_distance(m_position, m_frame.position(v));
  }

  // Compares the distances of v and w.
  Comparison_result compare(Vertex_index v, Vertex_index w) const
  {
    if (m_positions_are_exact) {
      const Comparison_result result = filtered(approximate_square(v), approximate_square(w));
      if (result != EQUAL)
        return result;
    }
    return m_traits.compare_distance_2_object()(m_from, point(v), point(w));
  }

  // Compares the squared distance of v with `square`.
  Comparison_result compare_square(Vertex_index v, const FT& square) const
  {
    if (m_positions_are_exact) {
      const auto [lower, upper] = CGAL::to_interval(square);
      const double approximation = approximate_square(v);
      if (lower == upper && filtered(approximation, lower) != EQUAL)
        return filtered(approximation, lower);
    }
    return m_traits.compare_squared_distance_2_object()(m_from, point(v), square);
  }

private:
  const Point& point(Vertex_index v) const { return m_dt.point(m_frame.id(v)); }

  static bool is_surely_smaller(double s, double t)
  {
    return s < (1 - 0x1p-48) * t && t >= 0x1p-900 && t <= (std::numeric_limits<double>::max)();
  }

  // EQUAL if undecided.
  static Comparison_result filtered(double s, double t)
  {
    return is_surely_smaller(s, t) ? SMALLER : is_surely_smaller(t, s) ? LARGER : EQUAL;
  }

  const Default_floating_point m_floating_point; // while distances are compared
  const Dynamic& m_dt;
  const typename Dynamic::Frame m_frame;
  const Traits& m_traits;
  const Point& m_from;
  bool m_positions_are_exact = true;
  const Position_2 m_position;
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_QUERIES_VERTEX_GEOMETRY_2_H

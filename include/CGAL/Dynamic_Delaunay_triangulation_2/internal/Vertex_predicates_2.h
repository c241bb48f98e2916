// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_VERTEX_PREDICATES_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_VERTEX_PREDICATES_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Edge_filter_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Neighborhood_mirror_2.h>
#include <CGAL/enum.h>
#include <CGAL/number_type_basic.h>

#include <boost/config.hpp>

namespace CGAL {
namespace Dynamic_Delaunay_triangulations_2 {
namespace internal {

// The exact predicates over vertices by their indices: a floating-point filter with a proved bound
// first, the kernel where it does not decide.
template <class Maintained>
class Vertex_predicates_2
{
public:
  explicit Vertex_predicates_2(const Maintained& maintained)
    : m_maintained(maintained)
  {
  }

  Orientation orientation(Index a, Index b, Index c) const
  {
    if (m_maintained.positions_are_exact()) {
      const auto& positions = m_maintained.positions();
      if (const int sign = filtered_orientation(positions[a], positions[b], positions[c]))
        return sign > 0 ? LEFT_TURN : RIGHT_TURN;
    }
    return kernel_orientation(a, b, c);
  }

  // Of d, for a circle that is given counterclockwise.
  Oriented_side side_of_circle(Index a, Index b, Index c, Index d) const
  {
    if (m_maintained.positions_are_exact()) {
      const auto& positions = m_maintained.positions();
      if (const int sign =
              filtered_in_circle(positions[a], positions[b], positions[c], positions[d]))
        return sign > 0 ? ON_POSITIVE_SIDE : ON_NEGATIVE_SIDE;
    }
    return kernel_side_of_circle(a, b, c, d);
  }

  Comparison_result compare_xy(Index v, Index w) const
  {
    if (m_maintained.positions_are_exact()) {
      const Position_2 &p = m_maintained.positions()[v], &q = m_maintained.positions()[w];
      return p.x != q.x ? CGAL::compare(p.x, q.x) : CGAL::compare(p.y, q.y);
    }
    const Comparison_result x = compare_x(v, w);
    return x != EQUAL ? x : compare_y(v, w);
  }

  Comparison_result compare_yx(Index v, Index w) const
  {
    if (m_maintained.positions_are_exact()) {
      const Position_2 &p = m_maintained.positions()[v], &q = m_maintained.positions()[w];
      return p.y != q.y ? CGAL::compare(p.y, q.y) : CGAL::compare(p.x, q.x);
    }
    const Comparison_result y = compare_y(v, w);
    return y != EQUAL ? y : compare_x(v, w);
  }

private:
  // Apart, so that compilers put the filters in line.

  BOOST_NOINLINE Orientation kernel_orientation(Index a, Index b, Index c) const
  {
    return m_maintained.traits().orientation_2_object()(
        m_maintained.point(a), m_maintained.point(b), m_maintained.point(c));
  }

  BOOST_NOINLINE Oriented_side kernel_side_of_circle(Index a, Index b, Index c, Index d) const
  {
    return m_maintained.traits().side_of_oriented_circle_2_object()(
        m_maintained.point(a), m_maintained.point(b), m_maintained.point(c), m_maintained.point(d));
  }

  Comparison_result compare_x(Index v, Index w) const
  {
    return m_maintained.traits().compare_x_2_object()(m_maintained.point(v), m_maintained.point(w));
  }
  Comparison_result compare_y(Index v, Index w) const
  {
    return m_maintained.traits().compare_y_2_object()(m_maintained.point(v), m_maintained.point(w));
  }

  const Maintained& m_maintained;
};

} // namespace internal
} // namespace Dynamic_Delaunay_triangulations_2
} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_VERTEX_PREDICATES_2_H

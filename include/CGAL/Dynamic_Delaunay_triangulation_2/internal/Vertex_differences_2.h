// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_VERTEX_DIFFERENCES_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_VERTEX_DIFFERENCES_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Computed_geometry_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Neighborhood_mirror_2.h>
#include <CGAL/number_type_basic.h>

namespace CGAL {
namespace Dynamic_Delaunay_triangulations_2 {
namespace internal {

// The vector from one vertex to another, rounded once: points that an exact kernel tells apart may
// well have the same doubles for coordinates.
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

  Position_2 operator()(Index from, Index to) const
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

} // namespace internal
} // namespace Dynamic_Delaunay_triangulations_2
} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_VERTEX_DIFFERENCES_2_H

// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_QUERIES_VERTEX_GEOMETRY_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_QUERIES_VERTEX_GEOMETRY_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Flat_elements_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Points_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/topology/Halfedge_arrays_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_errors_2.h>
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
  BOOST_FORCEINLINE Position_2 operator()(Vertex_index from, Vertex_index to) const
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

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_QUERIES_VERTEX_GEOMETRY_2_H

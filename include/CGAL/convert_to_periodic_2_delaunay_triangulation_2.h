// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CONVERT_TO_PERIODIC_2_DELAUNAY_TRIANGULATION_2_H
#define CGAL_CONVERT_TO_PERIODIC_2_DELAUNAY_TRIANGULATION_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/io/Periodic_2_conversion_2.h>
#include <CGAL/Dynamic_periodic_Delaunay_triangulation_2.h>
#include <CGAL/Origin.h>
#include <CGAL/Periodic_2_Delaunay_triangulation_2.h>

#include <vector>

namespace CGAL {

/*!
\ingroup PkgDynamicDelaunayTriangulation2Periodic

makes `target` a copy of the triangulation `pt`, with the same edges and faces, in one sheet. The
cell must be a square with sides along the axes, since CGAL's class has no other cells; its vectors
may have any order and direction. The domain of `target` is then the square of that size with the
lower left corner `corner`.

All points are wrapped into the domain. That must not need any rounding, and does not for points
that were given in the domain. Points that coincide share a vertex, at the image of their
representative; only the representative is wrapped.

One sheet must be enough by CGAL's criterion, so that it stays enough whatever points are inserted
later: the square of each edge's length must be less than 0.166 times the square of the side. A
triangulation of very few points does not fulfill that.

The data structure is copied without any predicate or search. Cost: O(n log n), to match the edges
of neighboring faces. If this throws, `target` has not changed.

\tparam Periodic a `Dynamic_periodic_Delaunay_triangulation_2`.
\tparam Traits, Data_structure those of CGAL's class, whose points are made from two doubles.
\param pt the triangulation to convert.
\param target receives the result; its former contents are lost.
\param corner the lower left corner of the domain.

\return the vertices, indexed by ids; `Vertex_handle()` for the ids of removed points.

\throws Uncertified_triangulation_error_2 unless `pt.is_certified()`.
\throws Periodic_cell_error_2 if the cell is a slab, or no square with sides along the axes.
\throws Periodic_conversion_error_2 if a point cannot be wrapped without rounding, if the upper
right corner of the domain is no pair of doubles, or if one sheet is not enough.
*/
template <class Periodic, class Traits, class Data_structure>
std::vector<typename Periodic_2_Delaunay_triangulation_2<Traits, Data_structure>::Vertex_handle>
convert_to_periodic_2_delaunay_triangulation_2(
    const Periodic& pt, Periodic_2_Delaunay_triangulation_2<Traits, Data_structure>& target,
    const typename Periodic::Point& corner = typename Periodic::Point(ORIGIN))
{
  using Target = Periodic_2_Delaunay_triangulation_2<Traits, Data_structure>;
  const Dynamic_Delaunay_triangulations_2::internal::Periodic_2_conversion_2<Periodic> conversion(
      pt, {corner.x(), corner.y()});
  Target result(conversion.template domain<Target>());
  auto vertices = conversion.write(result);
  target.swap(result);
  return vertices;
}

} // namespace CGAL

#endif // CGAL_CONVERT_TO_PERIODIC_2_DELAUNAY_TRIANGULATION_2_H

// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_CONVERSIONS_CONVERT_TO_PERIODIC_3_DELAUNAY_TRIANGULATION_3_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_CONVERSIONS_CONVERT_TO_PERIODIC_3_DELAUNAY_TRIANGULATION_3_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/conversions/Periodic_3_conversion_3.h>
#include <CGAL/Dynamic_periodic_Delaunay_triangulation_3.h>
#include <CGAL/Origin.h>
#include <CGAL/Periodic_3_Delaunay_triangulation_3.h>

#include <vector>

namespace CGAL {

/*!
\ingroup PkgDynamicDelaunayTriangulation2Periodic

makes `target` a triangulation of CGAL with the points of the triangulation `pt`. The cell must be a
cube with edges along the axes, since CGAL's class has no other cells; its vectors may have any
order and direction. The domain of `target` is then the cube of that size with the lower corner
`corner`. Where the vertices of `target` have an `info()`, it becomes the id of the point, or of the
representative of points that coincide.

All points are wrapped into the domain. That must not need any rounding, and does not for points
that were given in the domain. Points that coincide share a vertex, at the image of their
representative; only the representative is wrapped.

The data structure is copied, in one sheet and without any search, if one sheet is enough by CGAL's
criterion, so that it stays enough whatever points are inserted later: the square of each edge's
length must be less than 0.166 times the square of the side. Then the cells are the same. Cost:
linear. Else, as for few points, CGAL inserts the points, in 27 sheets where it has to. So it does
where five points or more are on an empty sphere and CGAL chooses another of their triangulations
than `pt`: both are Delaunay, but CGAL's class needs its own choice. If this throws, `target` has
not changed.

The way back needs no function: `pt` is constructed from CGAL's points and
`Periodic_cell_3(side, side, side)`.

\tparam Traits, Options those of the triangulation.
\tparam Target_traits, Data_structure those of CGAL's class, whose points are made from three
  doubles.
\param pt the triangulation to convert.
\param target receives the result; its former contents are lost.
\param corner the lower corner of the domain.

\return the vertices, indexed by ids; `Vertex_handle()` for the ids of removed points. In 27 sheets
they are those in the domain.

\throws Uncertified_triangulation_error_2 unless `pt.is_certified()`.
\throws Periodic_cell_error_3 if the cell is no cube with edges along the axes.
\throws Periodic_conversion_error_2 if a point cannot be wrapped without rounding, or if the upper
corner of the domain has no coordinates of doubles.
*/
template <class Traits, class... Options, class Target_traits, class Data_structure>
std::vector<
    typename Periodic_3_Delaunay_triangulation_3<Target_traits, Data_structure>::Vertex_handle>
convert_to_periodic_3_delaunay_triangulation_3(
    const Dynamic_periodic_Delaunay_triangulation_3<Traits, Options...>& pt,
    Periodic_3_Delaunay_triangulation_3<Target_traits, Data_structure>& target,
    const typename Traits::Point_3& corner = typename Traits::Point_3(ORIGIN))
{
  using Target = Periodic_3_Delaunay_triangulation_3<Target_traits, Data_structure>;
  const Dynamic_Delaunay_triangulations_3::internal::Periodic_3_conversion_3<
      Dynamic_periodic_Delaunay_triangulation_3<Traits, Options...>>
      conversion(pt, {corner.x(), corner.y(), corner.z()});
  Target result;
  auto vertices = conversion.convert(result);
  target.swap(result);
  return vertices;
}

} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_CONVERSIONS_CONVERT_TO_PERIODIC_3_DELAUNAY_TRIANGULATION_3_H

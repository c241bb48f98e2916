// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_QUERIES_VORONOI_CELLS_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_QUERIES_VORONOI_CELLS_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Flat_arrays.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/cells/Voronoi_face_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/cells/Voronoi_space_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Flat_elements_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_errors_2.h>
#include <CGAL/Periodic_cell_2.h>

#include <cstddef>
#include <limits>
#include <optional>

namespace CGAL {
namespace Dynamic_Delaunay_triangulations_2 {
namespace internal {

// Calls f(neighbor, length) with the length of the Voronoi edge of each neighbor of a point.
template <class Space, class Function>
void for_each_voronoi_edge_of(const Space& space, std::size_t id, const Function& f)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  std::optional<Voronoi_neighbor_2> first;
  double in_first_face = 0, in_face_before = 0;
  for_each_face_around(space, id,
                       [&](const Voronoi_neighbor_2& right, const Voronoi_neighbor_2&,
                           const std::optional<Voronoi_face_2>& face) {
                         const double in_face =
                             face ? face->length(2) * face->cotangent(2) / 2 : infinity;
                         if (first)
                           f(right, in_face_before + in_face);
                         else {
                           first = right; // the face before it comes last
                           in_first_face = in_face;
                         }
                         in_face_before =
                             face ? face->length(1) * face->cotangent(1) / 2 : infinity;
                       });
  if (first)
    f(*first, in_face_before + in_first_face);
}

} // namespace internal
} // namespace Dynamic_Delaunay_triangulations_2

/*!
\ingroup PkgDynamicDelaunayTriangulation2Ref

calls `f(i, j, length)` once for each pair of neighbors i and j, with the length of the Voronoi edge
between their cells. In periodic space it calls `f(i, j, shift, length)`, where the image of point j
by `shift` is a neighbor of point i; a point can be a neighbor of its own image there, and two
points can have several edges.

The length is infinite where an edge has only one face, as on the hull, and beside a face that is so
flat that rounding hides its orientation. It is 0, but for rounding, where four points lie on a
circle. Where points share a cell, only their representative has edges. `Voronoi_cell_measures_2`
says how accurate lengths are.

Cost: linear, and three times that of a pass over the faces. Nothing is allocated.

\tparam Dynamic a `Dynamic_Delaunay_triangulation_2` or `Dynamic_periodic_Delaunay_triangulation_2`.
\throws Uncertified_triangulation_error_2 unless `dt.is_certified()`.
*/
template <class Dynamic, class Function>
void for_each_voronoi_edge(const Dynamic& dt, const Function& f)
{
  using namespace Dynamic_Delaunay_triangulations_2::internal;
  const Voronoi_space_2<Dynamic> space(dt);
  for (std::size_t i = 0; i < space.number_of_ids(); ++i) {
    if (!space.has_id(i) || !space.is_representative(i))
      continue;
    for_each_voronoi_edge_of(space, i, [&](const Voronoi_neighbor_2& neighbor, double length) {
      // each edge is met at both of its ends
      if (neighbor.id < i || (neighbor.id == i && neighbor.shift < Periodic_shift_2{0, 0}))
        return;
      space.show(neighbor.shift,
                 [&](const auto&... shift) { f(i, neighbor.id, shift..., length); });
    });
  }
}

/*!
\ingroup PkgDynamicDelaunayTriangulation2Ref

writes the corners of the Voronoi cell of a point to `corners`, counterclockwise, as places with two
doubles, `x` and `y`, and returns the iterator behind them. There is one corner for each face at the
point, so where four points lie on a circle some corners coincide, up to rounding. In periodic space
the corners are around the point as it was given, wrapped or not. Nothing is written for an
unbounded cell.

Cost: proportional to the number of neighbors. Nothing is allocated.

\tparam Dynamic a `Dynamic_Delaunay_triangulation_2` or `Dynamic_periodic_Delaunay_triangulation_2`.
\throws Uncertified_triangulation_error_2 unless `dt.is_certified()`.
\throws Unknown_id_error_2 if no point has this id.
*/
template <class Dynamic, class OutputIterator>
OutputIterator voronoi_cell_corners(const Dynamic& dt, std::size_t id, OutputIterator corners)
{
  using namespace Dynamic_Delaunay_triangulations_2::internal;
  using Face = std::optional<Voronoi_face_2>;
  const Voronoi_space_2<Dynamic> space(dt);
  if (!space.has_id(id))
    throw Unknown_id_error_2(id, space.number_of_ids());
  bool is_bounded = true;
  for_each_face_around(space, id, [&](const auto&, const auto&, const Face& face) {
    is_bounded = is_bounded && face;
  });
  if (!is_bounded)
    return corners;
  const Dynamic_Delaunay_triangulations_2::Position_2 p = space.position(id);
  for_each_face_around(space, id, [&](const auto&, const auto&, const Face& face) {
    const auto v = face->to_circumcenter(0);
    *corners++ = Dynamic_Delaunay_triangulations_2::Position_2{p.x + v.x, p.y + v.y};
  });
  return corners;
}

} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_QUERIES_VORONOI_CELLS_2_H

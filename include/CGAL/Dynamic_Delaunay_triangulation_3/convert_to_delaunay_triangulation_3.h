// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_CONVERT_TO_DELAUNAY_TRIANGULATION_3_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_CONVERT_TO_DELAUNAY_TRIANGULATION_3_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/conversions/Vertex_info_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/queries/certified_state_3.h>

#include <cstddef>
#include <vector>

namespace CGAL {

namespace Dynamic_Delaunay_triangulations_3::internal {

// Copies vertices and cells one to one.
template <class State, class Triangulation>
void copy_cells(const State& state, Triangulation& result)
{
  const Tetrahedra_arrays_3& arrays = state.arrays;
  auto& tds = result.tds();
  tds.delete_cell(result.infinite_vertex()->cell()); // an empty triangulation has one
  tds.set_dimension(3);
  Column<Vertex_index, typename Triangulation::Vertex_handle> vertices;
  vertices.push_back(result.infinite_vertex());
  for (Vertex_index v(1); v < arrays.number_of_vertices(); ++v) {
    vertices.push_back(tds.create_vertex());
    vertices.back()->set_point(state.point(v));
    set_info(vertices.back(), state.ids.representative(v));
  }
  Column<Cell_index, typename Triangulation::Cell_handle> cells;
  for (Cell_index c(0); c < arrays.number_of_cells(); ++c) {
    const Vertices_3& v = arrays.vertices(c);
    cells.push_back(
        tds.create_cell(vertices[v[0]], vertices[v[1]], vertices[v[2]], vertices[v[3]]));
    for (const Vertex_index w : v)
      vertices[w]->set_cell(cells.back());
  }
  for (Cell_index c(0); c < arrays.number_of_cells(); ++c)
    for (int i = 0; i < 4; ++i)
      cells[c]->set_neighbor(i, cells[arrays.neighbor(c, i)]);
}

} // namespace Dynamic_Delaunay_triangulations_3::internal

/*!
\ingroup PkgDynamicDelaunayTriangulation2Ref

Copies a triangulation in space into one of CGAL, so that all of CGAL can be used on it. Where the
vertices of that one have an `info()`, it becomes the id of the point, or of the representative of
points that coincide. Cost: linear, about a microsecond a point; without cells, points are inserted.

\pre `dt.is_certified()`
\tparam Triangulation a `Delaunay_triangulation_3` with the same type of points.
*/
template <class Traits, class... Options, class Triangulation>
void convert_to_delaunay_triangulation_3(
    const Dynamic_Delaunay_triangulation_3<Traits, Options...>& dt, Triangulation& result)
{
  const auto& state = Dynamic_Delaunay_triangulations_3::internal::certified_state(dt);
  result.clear();
  if (state.spans_space)
    return Dynamic_Delaunay_triangulations_3::internal::copy_cells(state, result);
  for (std::size_t id = 0; id < dt.number_of_ids(); ++id)
    if (dt.has_id(id) && dt.representative(id) == id)
      Dynamic_Delaunay_triangulations_3::internal::set_info(result.insert(dt.point(id)), id);
}

} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_CONVERT_TO_DELAUNAY_TRIANGULATION_3_H

// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_VIEWS_DYNAMIC_FRAME_3_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_VIEWS_DYNAMIC_FRAME_3_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/passes/Elements_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/proof/Cell_signs_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/space/Positions_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/topology/Tetrahedra_arrays_3.h>

#include <algorithm>
#include <array>
#include <cstddef>

namespace CGAL {

/*!
\ingroup PkgDynamicDelaunayTriangulation2Ref

The view that an update policy of `Dynamic_Delaunay_triangulation_3` gets: the vertices and cells of
the maintained triangulation as flat arrays, with the positions of the current frame and the cells
of the last one. A view copies nothing, and is valid until the next update.

Vertices are numbered from 1 to `number_of_vertices()`, in a spatial order; 0 is the infinite
vertex. Cells are numbered from 0. Any update may change these numbers; the ids of points never
change.

\tparam State an internal type.
*/
template <class State>
class Dynamic_frame_3
{
  using Arrays = typename State::Arrays;
  using Positions = typename State::Positions;
  using Signs = typename Dynamic_Delaunay_triangulations_3::internal::Signs_of_3<State>::type;

public:
  /// the type of all numbers: an unsigned integer of 32 bits.
  using Index = Dynamic_Delaunay_triangulations_3::Index;
  /// the number of a vertex. A number becomes one as in `Vertex_index(1)`, and it converts to
  /// `Index`; but it neither converts to nor compares with the number of another kind of element.
  /// Likewise the following types.
  using Vertex_index = Dynamic_Delaunay_triangulations_3::Vertex_index;
  using Cell_index = Dynamic_Delaunay_triangulations_3::Cell_index; ///< of a cell.
  using Point_id = Dynamic_Delaunay_triangulations_3::Point_id;     ///< the id of a point.
  /// three doubles, `x`, `y` and `z`. If the kernel's coordinates are not doubles, these are the
  /// nearest ones.
  using Position = Dynamic_Delaunay_triangulations_3::Position_3;

  /// \cond
  Dynamic_frame_3(const State& state, const Positions& previous)
    : m_state(state)
    , m_previous(previous)
    , m_signs(state)
  {
  }
  /// \endcond

  /// \name Sizes
  /// @{

  /// the number of points.
  Index number_of_points() const { return m_state.ids.number_of_points(); }
  /// one more than the largest id ever in use.
  Index number_of_ids() const { return m_state.ids.number_of_ids(); }
  /// the number of finite vertices: less than the number of points if points coincide.
  Index number_of_vertices() const { return m_state.positions.number() - 1; }
  /// the number of cells, including the infinite ones; 0 if the points do not span space.
  Index number_of_cells() const
  {
    return m_state.spans_space ? m_state.arrays.number_of_cells() : 0;
  }

  /// @}
  /// \name Points
  /// @{

  /// whether a point has the id `id`.
  bool has_id(std::size_t id) const { return m_state.ids.is_taken(id); }
  /// the vertex of the point `id`. \pre `has_id(id)`
  Vertex_index vertex(std::size_t id) const { return m_state.ids.vertex(Point_id(id)); }
  void vertex(Vertex_index) const = delete; ///< a vertex is no id.
  /// whether the finite vertex `v` has a point. In a frame of a population one whose point has gone
  /// has none, nor cells.
  bool has_point(Vertex_index v) const { return m_state.ids.has_representative(v); }
  /// the id of the point at the finite vertex `v`; of several, that of their representative.
  /// \pre `has_point(v)`
  Point_id id(Vertex_index v) const { return m_state.ids.representative(v); }
  /// whether `v` is the infinite vertex.
  static bool is_infinite(Vertex_index v)
  {
    return v == Dynamic_Delaunay_triangulations_3::internal::infinite_index;
  }
  /// the position of vertex `v`; NaNs for the infinite vertex.
  const Position& position(Vertex_index v) const { return m_state.positions.position(v); }
  /// the position of vertex `v` one frame ago. Valid only before the frame is mended.
  const Position& previous_position(Vertex_index v) const { return m_previous.position(v); }

  /// @}
  /// \name Cells
  /// @{

  /// the four vertices of cell `c`. It was positively oriented in the last frame.
  std::array<Vertex_index, 4> cell(Cell_index c) const
  {
    std::array<Vertex_index, 4> vertices;
    const auto& v = m_state.arrays.vertices(c);
    std::copy(v.begin(), v.end(), vertices.begin());
    return vertices;
  }
  /// whether one vertex of cell `c` is the infinite one.
  bool is_infinite(Cell_index c) const { return m_state.arrays.is_infinite(c); }
  /// whether cell `c` is positively oriented at the current positions, with facets that are locally
  /// Delaunay, by exact predicates. True for infinite cells, which are not tested. Cost: some 0.2
  /// microseconds.
  bool is_delaunay(Cell_index c) const
  {
    const Arrays& arrays = m_state.arrays;
    if (arrays.is_infinite(c))
      return true;
    if (!m_signs.is_positive(arrays.sites(c)))
      return false;
    for (int i = 0; i < 4; ++i)
      if (m_signs.is_illegal(arrays.sites(c), arrays.apex_site(Arrays::corner(c, i))))
        return false;
    return true;
  }

  /// @}

private:
  const State& m_state;
  const Positions& m_previous;
  Signs m_signs;
};

} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_VIEWS_DYNAMIC_FRAME_3_H

// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_VERTEX_BASE_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_VERTEX_BASE_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Triangulation_vertex_base_2.h>

#include <cstdint>

namespace CGAL {

/*!
\ingroup PkgDynamicDelaunayTriangulation2VertexFaceClasses

The vertex base that `Dynamic_Delaunay_triangulation_2` needs: a vertex that knows its index in the
flat arrays of the neighborhood mirror. To use your own vertices in a data structure, derive them
from this class, or pass their base as `Vb`.

\tparam Traits the geometric traits, as for `Delaunay_triangulation_2`.
\tparam Vb a vertex base of `Triangulation_2`, `Triangulation_vertex_base_2<Traits>` by default.
*/
template <class Traits, class Vb = Triangulation_vertex_base_2<Traits>>
class Dynamic_Delaunay_triangulation_vertex_base_2 : public Vb
{
public:
  /// \cond
  using Vertex_handle = typename Vb::Vertex_handle;
  using Face_handle = typename Vb::Face_handle;
  using Point = typename Vb::Point;

  template <class TDS2>
  struct Rebind_TDS
  {
    using Vb2 = typename Vb::template Rebind_TDS<TDS2>::Other;
    using Other = Dynamic_Delaunay_triangulation_vertex_base_2<Traits, Vb2>;
  };

  using Vb::Vb;
  Dynamic_Delaunay_triangulation_vertex_base_2() = default;
  /// \endcond

  /// the vertex's index in the flat arrays: 0 for the infinite vertex, 1 to n for the others. The
  /// package sets it; every update may change it.
  std::uint32_t mirror_index() const { return m_mirror_index; }

  /// \cond
  void set_mirror_index(std::uint32_t index) { m_mirror_index = index; }
  /// \endcond

private:
  std::uint32_t m_mirror_index = 0;
};

} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_VERTEX_BASE_2_H

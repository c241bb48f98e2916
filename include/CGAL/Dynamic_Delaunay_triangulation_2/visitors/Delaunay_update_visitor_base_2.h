// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_VISITORS_DELAUNAY_UPDATE_VISITOR_BASE_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_VISITORS_DELAUNAY_UPDATE_VISITOR_BASE_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/policies/Update_report_2.h>
#include <CGAL/Periodic_shift_2.h>

#include <array>
#include <cstddef>

namespace CGAL {

/*!
\ingroup PkgDynamicDelaunayTriangulation2Visitors

A visitor that ignores everything, in the plane and in periodic space. It is the default, which
costs nothing, and a base for your own visitors, which then define only the functions that they
need.

\cgalModels{DelaunayUpdateVisitor_2}
\cgalModels{PeriodicUpdateVisitor_2}
*/
class Delaunay_update_visitor_base_2
{
public:
  /// does nothing.
  template <class Dynamic>
  void before_update(const Dynamic&)
  {
  }

  /// does nothing.
  template <class Dynamic>
  void after_update(const Dynamic&, const Update_report_2&)
  {
  }

  /// does nothing.
  template <class Dynamic>
  void before_flip(const Dynamic&, const typename Dynamic::Edge&)
  {
  }

  /// does nothing.
  template <class Dynamic>
  void after_flip(const Dynamic&, const typename Dynamic::Edge&)
  {
  }

  /// does nothing.
  template <class Dynamic>
  void before_face_removal(const Dynamic&, typename Dynamic::Face_handle)
  {
  }

  /// does nothing.
  template <class Dynamic>
  void after_face_creation(const Dynamic&, typename Dynamic::Face_handle)
  {
  }

  /// does nothing.
  template <class Dynamic>
  void after_vertex_creation(const Dynamic&, typename Dynamic::Vertex_handle, std::size_t)
  {
  }

  /// does nothing.
  template <class Dynamic>
  void before_vertex_removal(const Dynamic&, typename Dynamic::Vertex_handle, std::size_t)
  {
  }

  /// does nothing.
  template <class Dynamic>
  void before_vertex_relocation(const Dynamic&, typename Dynamic::Vertex_handle, std::size_t)
  {
  }

  /// does nothing.
  template <class Dynamic>
  void before_vertex_merge(const Dynamic&, typename Dynamic::Vertex_handle, std::size_t,
                           typename Dynamic::Vertex_handle)
  {
  }

  /// does nothing.
  template <class Dynamic>
  void after_id_change(const Dynamic&, typename Dynamic::Vertex_handle, std::size_t)
  {
  }

  /// does nothing.
  template <class Dynamic>
  void after_edge_removal(const Dynamic&, std::size_t, std::size_t, const Periodic_shift_2&)
  {
  }

  /// does nothing.
  template <class Dynamic>
  void after_edge_creation(const Dynamic&, std::size_t, std::size_t, const Periodic_shift_2&)
  {
  }

  /// does nothing.
  template <class Dynamic>
  void after_translation(const Dynamic&, std::size_t, const Periodic_shift_2&)
  {
  }

  /// does nothing.
  template <class Dynamic>
  void after_cell_exchange(const Dynamic&, const std::array<Periodic_shift_2, 2>&)
  {
  }
};

} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_VISITORS_DELAUNAY_UPDATE_VISITOR_BASE_2_H

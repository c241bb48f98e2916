// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_TOPOLOGY_TOPOLOGY_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_TOPOLOGY_TOPOLOGY_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Flat_arrays.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/topology/Change_log_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/topology/Halfedge_arrays_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/topology/Point_ids_2.h>

#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

template <class State>
class Input_frame_2;
template <class Traits, class Tds, class VisitorCalls, class ConcurrencyTag>
class Triangulation_state_2;

// The topology: CGAL's triangulation, whose data structure is the arrays themselves; the ids, and
// the log of changes. Reading is public. Only two classes write: `Topology_editor_2`, which edits
// some faces at a time, by `Plane_editing_2`, and `Topology_builder_2`, which writes everything.
// Both keep the members consistent and tell the visitor.
template <class Traits, class Tds, class VisitorCalls>
class Topology_2
{
public:
  using Visitor_calls = VisitorCalls;
  using Triangulation = Delaunay_triangulation_2<Traits, Tds>;
  using Vertex_handle = typename Triangulation::Vertex_handle;
  using Face_handle = typename Triangulation::Face_handle;
  using Point = typename Triangulation::Point;
  using Storage = typename Tds::Storage;
  using Ids = Point_ids_2<Point>;

  Topology_2(const Topology_2&) = delete;
  Topology_2& operator=(const Topology_2&) = delete;

  explicit Topology_2(const Traits& traits)
    : m_triangulation(traits)
    , m_storage(storage_of(m_triangulation))
  {
    m_ids.reset(0);
    m_storage.m_is_written_by_handles = false;
  }

  const Triangulation& triangulation() const { return m_triangulation; }
  const Halfedge_arrays_2& arrays() const { return m_storage.arrays(); }
  const Ids& ids() const { return m_ids; }
  const Change_log_2& changes() const { return m_changes; }
  // Whether the user has changed anything through handles.
  bool is_written_by_handles() const { return m_storage.is_written_by_handles(); }

  Vertex_handle vertex_handle(Vertex_index v) const { return Vertex_handle(&m_storage, v); }
  Face_handle face_handle(Face_index f) const { return Face_handle(&m_storage, f); }

  typename Storage::Vertex_properties& vertex_properties() { return m_storage.vertex_properties(); }
  typename Storage::Face_properties& face_properties() { return m_storage.face_properties(); }

  // Exchanges the list of duplicates with `others`, which must have the same ids. Only
  // `Input_frame_2` can make the key, because the points of duplicates belong to a frame.
  template <class State>
  void exchange_duplicates(const typename Input_frame_2<State>::Key&,
                           std::vector<typename Ids::Duplicate>& others)
  {
    m_ids.duplicates().swap(others);
  }

private:
  template <class State>
  friend class Topology_builder_2;
  template <class State>
  friend class Plane_editing_2;
  template <class Traits_, class Tds_, class VisitorCalls_, class ConcurrencyTag>
  friend class Triangulation_state_2;

  static Storage& storage_of(Triangulation& triangulation)
  {
    return *triangulation.tds().m_storage;
  }

  // The points of the vertices, which `Positions_2` writes.
  typename Storage::Points& points() { return m_storage.m_points; }

  Triangulation m_triangulation;
  Storage& m_storage; // of m_triangulation's data structure
  Ids m_ids;
  Change_log_2 m_changes;
  Visitor_calls m_visitor_calls;
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_TOPOLOGY_TOPOLOGY_2_H

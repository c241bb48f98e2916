// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_CGAL_VISITOR_CALLS_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_CGAL_VISITOR_CALLS_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <cstddef>
#include <exception>
#include <utility>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

// One change in the plane, in the words of `DelaunayUpdateVisitor_2`.
template <class Triangulation>
struct Plane_change_2
{
  using Edge = typename Triangulation::Edge;
  using Face_handle = typename Triangulation::Face_handle;
  using Vertex_handle = typename Triangulation::Vertex_handle;

  enum class Kind {
    BEFORE_FLIP,
    AFTER_FLIP,
    BEFORE_FACE_REMOVAL,
    AFTER_FACE_CREATION,
    AFTER_VERTEX_CREATION,
    BEFORE_VERTEX_REMOVAL,
    BEFORE_VERTEX_RELOCATION,
    BEFORE_VERTEX_MERGE,
    AFTER_ID_CHANGE
  };

  static Plane_change_2 of(Kind kind, const Edge& edge) { return {kind, edge, {}, {}, 0}; }
  static Plane_change_2 of(Kind kind, Face_handle face) { return {kind, {face, 0}, {}, {}, 0}; }
  static Plane_change_2 of(Kind kind, Vertex_handle vertex, std::size_t id,
                           Vertex_handle other = Vertex_handle())
  {
    return {kind, {}, vertex, other, id};
  }

  // Calls the visitor's function for this change.
  template <class Visitor, class Dynamic>
  void tell(Visitor& visitor, const Dynamic& dynamic) const
  {
    switch (kind) {
    case Kind::BEFORE_FLIP:
      return visitor.before_flip(dynamic, edge);
    case Kind::AFTER_FLIP:
      return visitor.after_flip(dynamic, edge);
    case Kind::BEFORE_FACE_REMOVAL:
      return visitor.before_face_removal(dynamic, edge.first);
    case Kind::AFTER_FACE_CREATION:
      return visitor.after_face_creation(dynamic, edge.first);
    case Kind::AFTER_VERTEX_CREATION:
      return visitor.after_vertex_creation(dynamic, vertex, id);
    case Kind::BEFORE_VERTEX_REMOVAL:
      return visitor.before_vertex_removal(dynamic, vertex, id);
    case Kind::BEFORE_VERTEX_RELOCATION:
      return visitor.before_vertex_relocation(dynamic, vertex, id);
    case Kind::BEFORE_VERTEX_MERGE:
      return visitor.before_vertex_merge(dynamic, vertex, id, other);
    default:
      return visitor.after_id_change(dynamic, vertex, id);
    }
  }

  Kind kind;
  Edge edge; // or a face, as that of the edge
  Vertex_handle vertex, other;
  std::size_t id;
};

// Reports to the user's visitor what an update changes. Only `finish()` throws, because elsewhere
// an exception would leave the topology inconsistent. After the visitor's first exception, which
// `finish()` throws, the visitor is not called again in this update.
//
// The visitor and the triangulation that it is shown are hidden behind a function, so that the
// kernel is compiled once for all visitors, also for those that do not listen.
template <class Triangulation>
class Visitor_calls_2
{
public:
  using Change = Plane_change_2<Triangulation>;

  // Called in each update, because both objects may have other addresses than in the last one.
  template <class Visitor, class Dynamic>
  void start(Visitor& visitor, const Dynamic* dynamic, bool is_listening)
  {
    m_failure = nullptr;
    m_visitor = is_listening ? &visitor : nullptr;
    m_dynamic = dynamic;
    m_tell = [](void* v, const void* d, const Change& change) {
      change.tell(*static_cast<Visitor*>(v), *static_cast<const Dynamic*>(d));
    };
  }

  // Whether a visitor listens to this update.
  bool is_heard() const { return m_visitor != nullptr; }

  void finish()
  {
    m_visitor = nullptr;
    if (m_failure)
      std::rethrow_exception(std::exchange(m_failure, nullptr));
  }

  // Tells the visitor of the change that `make()` returns.
  template <class Make>
  void call(const Make& make) noexcept
  {
    if (!is_heard() || m_failure)
      return;
    try {
      m_tell(m_visitor, m_dynamic, make());
    } catch (...) {
      m_failure = std::current_exception();
    }
  }

private:
  void* m_visitor = nullptr;
  const void* m_dynamic = nullptr;
  void (*m_tell)(void*, const void*, const Change&) = nullptr;
  std::exception_ptr m_failure;
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_CGAL_VISITOR_CALLS_2_H

// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_VISITOR_CALLS_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_VISITOR_CALLS_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Delaunay_update_visitor_base_2.h>

#include <cstddef>
#include <exception>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Dynamic_Delaunay_triangulations_2 {
namespace internal {

// Tells the user's visitor what changes while an update is on its way. None of these calls throws:
// topology is written where an exception would leave the two copies of it out of step. What the
// visitor throws is kept until `finish()`, and it is told nothing more until then.
template <class Visitor, class Dynamic>
class Visitor_calls_2
{
public:
  // Whether anybody listens: if not, nothing of all this is compiled.
  static constexpr bool is_heard = !std::is_same_v<Visitor, Delaunay_update_visitor_base_2>;

  // Both may have moved since the last update.
  void start(Visitor& visitor, const Dynamic& dynamic)
  {
    m_visitor = &visitor;
    m_dynamic = &dynamic;
    m_failure = nullptr;
  }

  void finish()
  {
    m_visitor = nullptr;
    if (m_failure)
      std::rethrow_exception(std::exchange(m_failure, nullptr));
  }

  template <class Edge>
  void before_flip(const Edge& e)
  {
    call([&](auto& visitor, auto& dt) { visitor.before_flip(dt, e); });
  }

  template <class Edge>
  void after_flip(const Edge& e)
  {
    call([&](auto& visitor, auto& dt) { visitor.after_flip(dt, e); });
  }

  template <class Face_handle>
  void before_face_removal(Face_handle f)
  {
    call([&](auto& visitor, auto& dt) { visitor.before_face_removal(dt, f); });
  }

  template <class Face_handle>
  void after_face_creation(Face_handle f)
  {
    call([&](auto& visitor, auto& dt) { visitor.after_face_creation(dt, f); });
  }

  template <class Vertex_handle>
  void after_vertex_creation(Vertex_handle v, std::size_t id)
  {
    call([&](auto& visitor, auto& dt) { visitor.after_vertex_creation(dt, v, id); });
  }

  template <class Vertex_handle>
  void before_vertex_removal(Vertex_handle v, std::size_t id)
  {
    call([&](auto& visitor, auto& dt) { visitor.before_vertex_removal(dt, v, id); });
  }

  template <class Vertex_handle>
  void before_vertex_relocation(Vertex_handle v, std::size_t id)
  {
    call([&](auto& visitor, auto& dt) { visitor.before_vertex_relocation(dt, v, id); });
  }

  template <class Vertex_handle>
  void before_vertex_merge(Vertex_handle v, std::size_t id, Vertex_handle stays)
  {
    call([&](auto& visitor, auto& dt) { visitor.before_vertex_merge(dt, v, id, stays); });
  }

  template <class Vertex_handle>
  void after_id_change(Vertex_handle v, std::size_t id_before)
  {
    call([&](auto& visitor, auto& dt) { visitor.after_id_change(dt, v, id_before); });
  }

private:
  template <class Function>
  void call(const Function& f) noexcept
  {
    if constexpr (is_heard) {
      if (m_visitor == nullptr || m_failure)
        return;
      try {
        f(*m_visitor, *m_dynamic);
      } catch (...) {
        m_failure = std::current_exception();
      }
    }
  }

  Visitor* m_visitor = nullptr;
  const Dynamic* m_dynamic = nullptr;
  std::exception_ptr m_failure;
};

} // namespace internal
} // namespace Dynamic_Delaunay_triangulations_2
} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_VISITOR_CALLS_2_H

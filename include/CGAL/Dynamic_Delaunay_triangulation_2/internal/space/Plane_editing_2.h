// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_SPACE_PLANE_EDITING_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_SPACE_PLANE_EDITING_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Flat_arrays.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Renumbering.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Flat_elements_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/topology/Halfedge_arrays_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/topology/Writable_halfedge_arrays_2.h>
#include <CGAL/Triangulation_utils_2.h>

#include <cstddef>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

// What `Topology_editor_2` does in the plane alone: user data follow the numbers of vertices and
// faces, and the user's visitor is told of each change at once. The builder tells the visitor
// through it, too. No changes are kept to be told later, so no memory is reserved for that. Only
// finish_visit(), reserve_for_slots() and renew_vertex() can throw.
template <class State>
class Plane_editing_2
{
  using Arrays = Halfedge_arrays_2;
  using Slot = Arrays::Slot;
  using Calls = typename State::Visitor_calls;
  using Told = typename Calls::Change;
  using Kind = typename Told::Kind;
  using Edge = typename Told::Edge;

public:
  explicit Plane_editing_2(State& state)
    : m_state(state)
    , m_writer(state)
    , m_arrays(m_writer.arrays())
  {
  }

  template <class Visitor, class Dynamic>
  void start_visit(Visitor& visitor, const Dynamic* dynamic, bool is_listening)
  {
    m_writer.visitor_calls().start(visitor, dynamic, is_listening);
  }
  void finish_visit() { m_writer.visitor_calls().finish(); }

  bool is_heard() const { return m_writer.visitor_calls().is_heard(); }
  bool tells_at_once() const { return is_heard(); }

  // MEMORY OF CHANGES ---------------------------------------------------------------------------

  struct Log
  {
  };
  Log& log() { return m_log; }
  static void append(Log&) {}
  static void reserve(std::size_t) {}
  static void reserve(Log&, std::size_t) {}
  static void keep_memory_for(std::size_t) {}

  static void rest_in_present_cell() {}

  // FACES AND EDGES -----------------------------------------------------------------------------

  bool can_flip(Halfedge_index h) const { return !m_arrays.are_apexes_neighbors(h); }

  void flip(Halfedge_index h, Log&)
  {
    const auto f = m_state.face_handle(Arrays::face_of(h));
    const int i = int(Arrays::number_in_face(h));
    tell([&] { return Told::of(Kind::BEFORE_FLIP, Edge(f, i)); });
    m_arrays.flip(h);
    tell([&] { return Told::of(Kind::AFTER_FLIP, Edge(f, Triangulation_cw_ccw_2::ccw(i))); });
  }

  void set_corner(Halfedge_index h, Vertex_index v) { m_arrays.set_apex(h, v); }
  void put_in(const Slot& slot, Face_index f, typename State::Chart) { m_arrays.put_in(slot, f); }

  void before_face(Face_index f)
  {
    tell([&] { return Told::of(Kind::BEFORE_FACE_REMOVAL, m_state.face_handle(f)); });
  }
  void after_face(Face_index f)
  {
    tell([&] { return Told::of(Kind::AFTER_FACE_CREATION, m_state.face_handle(f)); });
  }
  static void before_edge(Edge_index) {}
  static void after_edge(Edge_index) {}

  // VERTICES ------------------------------------------------------------------------------------

  void after_vertex_creation(Vertex_index v)
  {
    tell([&] { return Told::of(Kind::AFTER_VERTEX_CREATION, handle(v), id(v)); });
  }
  void before_vertex_removal(Vertex_index v)
  {
    tell([&] { return Told::of(Kind::BEFORE_VERTEX_REMOVAL, handle(v), id(v)); });
  }
  void before_vertex_relocation(Vertex_index v)
  {
    tell([&] { return Told::of(Kind::BEFORE_VERTEX_RELOCATION, handle(v), id(v)); });
  }
  void before_vertex_merge(Vertex_index goes, Vertex_index stays)
  {
    tell(
        [&] { return Told::of(Kind::BEFORE_VERTEX_MERGE, handle(goes), id(goes), handle(stays)); });
  }

  static void reserve_for_id_change(Vertex_index) {}
  static void before_id_change(Vertex_index) {}
  void after_id_change(Vertex_index v, Point_id former, const Position_2&)
  {
    tell([&] { return Told::of(Kind::AFTER_ID_CHANGE, handle(v), std::size_t(former)); });
  }

  static void reserve_for_move() {}
  static void after_move(Vertex_index, const Position_2&) {}

  // Puts a held vertex exactly where it was before it moved.
  void put_to_rest(Vertex_index v) { m_writer.positions().put_to_rest(v); }

  // DATA OF USERS -------------------------------------------------------------------------------

  // Makes the data of a vertex and two faces for each slot. Then append_slots() throws nothing.
  void reserve_for_slots(std::size_t number)
  {
    m_writer.storage().reserve_data(m_arrays.number_of_vertices() + number,
                                    m_arrays.number_of_faces() + 2 * number);
  }
  template <class Parts>
  void append_slots(std::size_t number)
  {
    resize_data(m_arrays.number_of_vertices() + number, m_arrays.number_of_faces() + 2 * number);
  }
  void resize_data(std::size_t vertices, std::size_t faces)
  {
    m_writer.storage().resize_data(vertices, faces);
  }
  void renew_vertex(Vertex_index v) { m_writer.storage().vertex_data().reset(v); }
  // Gives the numbers of removed faces and vertices to the last ones.
  template <class Parts>
  void fill(const Filled_gaps<Face_index>& faces, const Filled_gaps<Vertex_index>& vertices)
  {
    const auto fill = [](auto& data, const auto& gaps) {
      if (data.empty())
        data.resize(gaps.number_kept());
      else
        gaps.for_each_from_last([&](Index, Index to) { data.move_last_to(to); });
    };
    fill(m_writer.storage().face_data(), faces);
    fill(m_writer.storage().vertex_data(), vertices);
  }

private:
  // Tells the user's visitor, if there is one, of the change that `make()` returns.
  template <class Make>
  void tell(const Make& make)
  {
    m_writer.visitor_calls().call(make);
  }
  auto handle(Vertex_index v) const { return m_state.vertex_handle(v); }
  std::size_t id(Vertex_index v) const { return m_state.ids().representative(v); }

  const State& m_state;
  const typename State::Writer m_writer;
  Writable_halfedge_arrays_2& m_arrays;
  Log m_log;
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_SPACE_PLANE_EDITING_2_H

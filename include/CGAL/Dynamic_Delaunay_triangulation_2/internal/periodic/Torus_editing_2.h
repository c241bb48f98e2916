// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_PERIODIC_TORUS_EDITING_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_PERIODIC_TORUS_EDITING_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Flat_arrays.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Renumbering.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Flat_elements_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/periodic/Lattice_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/periodic/Periodic_visitor_calls_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/periodic/Torus_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/topology/Change_log_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/topology/Halfedge_arrays_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/topology/Writable_halfedge_arrays_2.h>
#include <CGAL/Periodic_cell_2.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

// The part of `Topology_editor_2` that is specific to a torus: keeps shifts that close up around
// each face and agree along each edge, and logs the changes of edges for the user's visitor.
template <class State>
class Torus_editing_2
{
  using Arrays = Halfedge_arrays_2;
  using Slot = Arrays::Slot;
  using Kind = Periodic_change_2::Kind;

public:
  explicit Torus_editing_2(State& state)
    : m_state(state)
    , m_writer(state)
  {
  }

  template <class Visitor, class Dynamic>
  void start_visit(Visitor& visitor, const Dynamic* dynamic, bool is_listening)
  {
    m_writer.visitor_calls().start(visitor, dynamic, is_listening);
  }
  void finish_visit() { m_writer.visitor_calls().finish(); }

  bool is_heard() const { return m_writer.visitor_calls().is_heard(); }
  static bool tells_at_once() { return false; }

  // MEMORY OF CHANGES ---------------------------------------------------------------------------

  using Log = std::vector<Periodic_change_2>;
  Log& log() { return m_writer.visitor_calls().log(); }

  // Appends the log of one part. Memory must have been reserved.
  void append(Log& others)
  {
    log().insert(log().end(), others.begin(), others.end());
    others.clear();
  }
  void reserve(std::size_t changes) { m_writer.visitor_calls().reserve(changes); }
  void reserve(Log& log, std::size_t changes) const
  {
    if (is_heard())
      reserve_extra(log, changes);
  }
  void keep_memory_for(std::size_t changes) { m_writer.visitor_calls().keep_memory_for(changes); }

  // FACES AND EDGES -----------------------------------------------------------------------------

  // True if h has two different faces, and its flip gives an edge that is new and has a length.
  bool can_flip(Halfedge_index h) const
  {
    const Arrays& arrays = m_state.arrays();
    const Halfedge_index g = arrays.twin(h);
    if (Arrays::face_of(h) == Arrays::face_of(g))
      return false;
    if (!arrays.is_hidden(arrays.edge_of(h)) && arrays.apex(h) != arrays.apex(g) &&
        !arrays.are_apexes_neighbors(h))
      return true; // then no images of the apexes are neighbors either
    const auto chart = m_state.chart_at(h);
    const auto a = m_state.site_in(h, chart);
    const auto d = m_state.site_in(g, m_state.chart_beyond(h, chart));
    return !(a == d) && !m_state.are_neighbors(a, d);
  }

  void flip(Halfedge_index h, Log& log)
  {
    const Edge_index diagonal = arrays().edge_of(h);
    note_edge(Kind::EDGE_REMOVED, h, log);
    if (arrays().is_hidden(diagonal))
      flip_shifted(h);
    else
      arrays().flip_in_one_chart(h); // all shifts are zero there, and stay so
    note_edge(Kind::EDGE_CREATED, arrays().halfedge(diagonal), log);
  }

  void flip_shifted(Halfedge_index h)
  {
    const Halfedge_index g = arrays().twin(h);
    const Edge_images_2 images = m_state.corners_at(h);
    arrays().flip_glued(h);
    shifts()[Arrays::previous(h)] = images.right.shift;
    shifts()[g] = images.right.shift;
    shifts()[Arrays::next(g)] = images.target.shift;
    shifts()[Arrays::previous(g)] = images.left.shift;
    after_face(Arrays::face_of(h));
    after_face(Arrays::face_of(g));
  }

  void set_corner(Halfedge_index h, const typename State::Site& site)
  {
    arrays().set_apex(h, site.vertex);
    shifts()[h] = site.shift;
  }

  // Puts the slot's vertex into face f. `chart` is that of f as seen from the vertex.
  void put_in(const Slot& slot, Face_index f, const Periodic_shift_2& chart)
  {
    const Periodic_shift_2 a = shifts()[Arrays::halfedge_in(f, 0)],
                           b = shifts()[Arrays::halfedge_in(f, 1)],
                           c = shifts()[Arrays::halfedge_in(f, 2)];
    const Periodic_shift_2 v = no_shift - chart;
    arrays().put_in(slot, f);
    set_shifts(f, v, b, c);
    set_shifts(slot.faces[0], a, v, c);
    set_shifts(slot.faces[1], a, b, v);
  }

  static void before_face(Face_index) {}
  // Moves the chart of a face to its first corner, and updates what passes over all edges see of
  // its edges.
  void after_face(Face_index f)
  {
    move_chart(f);
    for (const Halfedge_index h : Arrays::halfedges_of(f))
      show_or_hide(arrays().edge_of(h));
  }

  void before_edge(Edge_index e) { note_edge(Kind::EDGE_REMOVED, arrays().halfedge(e), log()); }
  void after_edge(Edge_index e) { note_edge(Kind::EDGE_CREATED, arrays().halfedge(e), log()); }

  // Notes all edges as removed or created. There must be memory for it.
  void note_all_edges(Kind kind)
  {
    if (is_heard())
      for (Edge_index e(0); e < arrays().number_of_edges(); ++e)
        if (!arrays().is_empty_edge(e))
          note_edge(kind, arrays().halfedge(e), log());
  }

  // If the corners at an edge have the same shift, writes the edge as in the plane; else hides it.
  void show_or_hide(Edge_index e)
  {
    if (m_state.is_in_one_chart(e))
      arrays().set_edge(e, arrays().halfedge(e));
    else
      arrays().hide_edge(e);
  }

  void move_chart(Face_index f)
  {
    const Periodic_shift_2 first = shifts()[Arrays::halfedge_in(f, 0)];
    for (const Halfedge_index h : Arrays::halfedges_of(f))
      shifts()[h] = shifts()[h] - first;
  }

  // VERTICES ------------------------------------------------------------------------------------

  static void after_vertex_creation(Vertex_index) {}
  static void before_vertex_removal(Vertex_index) {}
  static void before_vertex_relocation(Vertex_index) {}
  static void before_vertex_merge(Vertex_index, Vertex_index) {}

  void reserve_for_id_change(Vertex_index v)
  {
    reserve_extra(changes().relocated, 1);
    if (is_heard())
      reserve(2 * std::size_t(arrays().degree(v)) + 1);
  }
  void before_id_change(Vertex_index v) { note_edges_around(Kind::EDGE_REMOVED, v); }
  // The vertex was at `before`.
  void after_id_change(Vertex_index v, Point_id, const Position_2& before)
  {
    note_edges_around(Kind::EDGE_CREATED, v);
    after_move(v, before);
  }

  // Puts a held vertex where it was before it moved, taken along with the cell.
  void put_to_rest(Vertex_index v) { m_writer.positions().place(v, m_state.rest_position(v)); }

  // THE LATTICE ---------------------------------------------------------------------------------

  // Reserves memory for one call of after_move(), or for `number` calls of shift_images() and one
  // of set_cell().
  void reserve_for_move(std::size_t number = 1)
  {
    reserve_extra(changes().relocated, number);
    reserve(number + 1);
  }
  void after_move(Vertex_index v, const Position_2& before)
  {
    shift_images(v, m_state.shift_of_step(before, m_state.positions()[v]));
  }

  // Call this after the position of v was replaced by one that is about `shift` away. Keeps every
  // image of v about where it is.
  void shift_images(Vertex_index v, const Periodic_shift_2& shift)
  {
    if (are_equal(shift, no_shift) || arrays().is_outside(v))
      return;
    note([&] { return Periodic_change_2::translation(m_state.ids().representative(v), shift); });
    changes().relocated.push_back(v);
    arrays().for_each_corner(v, [&](Halfedge_index h) { shifts()[h] = shifts()[h] - shift; });
    arrays().for_each_corner(v, [&](Halfedge_index h) { after_face(Arrays::face_of(h)); });
  }

  // Gives the lattice another cell. `multiples` are the old cell's vectors in multiples of the new
  // ones, integers with determinant 1 or -1; the rest is deformation.
  void set_cell(const Periodic_cell_2& cell, const std::array<Periodic_shift_2, 2>& multiples)
  {
    if (multiples != unit_multiples)
      note([&] { return Periodic_change_2::exchange(multiples); });
    m_writer.change_cell(cell, multiples);
    for (Periodic_shift_2& s : shifts())
      s = {s[0] * multiples[0][0] + s[1] * multiples[1][0],
           s[0] * multiples[0][1] + s[1] * multiples[1][1]};
  }

  // From now on, the previous positions are those in the present cell.
  void rest_in_present_cell() { m_writer.forget_deformation(); }

  // SHIFTS OF CORNERS ---------------------------------------------------------------------------

  void reserve_for_slots(std::size_t number) { reserve_extra(shifts(), 6 * number); }
  template <class Parts>
  void append_slots(std::size_t number)
  {
    const std::size_t first = shifts().size();
    shifts().resize(first + 6 * number);
    Parts::for_each_element(6 * number,
                            [&](std::size_t i) { shifts()[Halfedge_index(first + i)] = no_shift; });
  }
  void resize_data(std::size_t, std::size_t faces) { shifts().resize(3 * faces, no_shift); }
  static void renew_vertex(Vertex_index) {}
  // Gives the numbers of removed faces to the last ones. Threads share these.
  template <class Parts>
  void fill(const Filled_gaps<Face_index>& faces, const Filled_gaps<Vertex_index>&)
  {
    faces.template for_each_move<Parts>([this](Face_index from, Face_index to) {
      const Halfedge_index h = Arrays::halfedge_in(from, 0);
      set_shifts(to, shifts()[h], shifts()[h + 1], shifts()[h + 2]);
    });
    resize_data(0, faces.number_kept());
  }

private:
  Writable_halfedge_arrays_2& arrays() { return m_writer.arrays(); }
  Change_log_2& changes() { return m_writer.changes(); }
  typename State::Shifts& shifts() { return m_writer.shifts(); }

  template <class Change>
  void note(const Change& change)
  {
    if (is_heard())
      log().push_back(change());
  }

  // Logs the change of an edge, unless it is across the gap of a slab: users do not see those.
  void note_edge(Kind kind, Halfedge_index h, Log& log) const
  {
    if (is_heard()) {
      const Halfedge_index from = Arrays::next(h), to = Arrays::previous(h);
      if (!m_state.are_across(from, to))
        log.push_back(Periodic_change_2::edge(kind, m_state.id_at(from), m_state.id_at(to),
                                              m_state.shift_between(from, to)));
    }
  }

  // Edges from the vertex to an image of itself are met twice, and noted once.
  void note_edges_around(Kind kind, Vertex_index v)
  {
    if (is_heard())
      arrays().for_each_corner(v, [&](Halfedge_index h) {
        const Halfedge_index spoke = Arrays::previous(h);
        if (arrays().target(spoke) != v || spoke == arrays().halfedge(arrays().edge_of(spoke)))
          note_edge(kind, spoke, log());
      });
  }

  void set_shifts(Face_index f, Periodic_shift_2 a, Periodic_shift_2 b, Periodic_shift_2 c)
  {
    shifts()[Arrays::halfedge_in(f, 0)] = a;
    shifts()[Arrays::halfedge_in(f, 1)] = b;
    shifts()[Arrays::halfedge_in(f, 2)] = c;
  }

  const State& m_state;
  const typename State::Writer m_writer;
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_PERIODIC_TORUS_EDITING_2_H

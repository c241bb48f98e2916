// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_SPACE_PLANE_BUILDER_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_SPACE_PLANE_BUILDER_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/assertions.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Flat_arrays.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/cgal/Indexed_storage_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Flat_elements_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Points_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Spatial_order_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/space/Checkpoint_arrays_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/space/Plane_editing_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/space/Point_numbering_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/space/Positions_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/space/Staying_points_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/static/Flat_faces_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/static/Static_triangulator_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/static/Vertex_order_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/topology/Point_ids_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/topology/Writable_halfedge_arrays_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/policies/Static_engine_2.h>

#include <boost/iterator/counting_iterator.hpp>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

// Writes the whole topology at once: triangulates from scratch, restores, copies or exchanges it,
// or takes over what CGAL's algorithms have made. Everything is new then, but for a copy.
template <class State>
class Plane_builder_2
{
  using Writer = typename State::Writer;
  using Positions = typename Writer::Positions;
  using Point = typename State::Point;
  using Triangulation = typename State::Triangulation;
  using Vertex_handle = typename State::Vertex_handle;
  using Face_handle = typename State::Face_handle;
  using Storage = typename State::Storage;
  using Ids = Point_ids_2<Point>;
  using Parts = typename State::Parts;
  using Arrays = Point_arrays_2<Point>;
  using Stored_point = typename Arrays::Stored_point;

public:
  explicit Plane_builder_2(State& state)
    : m_state(state)
    , m_writer(state)
    , m_storage(m_writer.storage())
    , m_arrays(m_writer.arrays())
    , m_positions(m_writer.positions())
    , m_editing(state)
    , m_staying(state)
    , m_vertex_order(state)
    , m_numbering(state)
    , m_triangulator(state)
  {
  }

  void set_engine(Static_engine_2 engine) { m_triangulator.set_engine(engine); }

  // Triangulates the present points except those in `gone`, and the points that come.
  void build_with(const std::vector<Point_id>& gone, std::vector<Point_id> coming_ids,
                  std::vector<Point> coming_points)
  {
    try {
      auto all = m_staying.collect(gone, std::move(coming_ids), std::move(coming_points));
      write_all_anew([&] {
        m_numbering.number(std::move(all.ids), std::move(all.points), all.number_of_ids,
                           [&](Point_id id) { return m_staying.keeps_vertex(id, m_state.ids()); });
        triangulate_numbered();
      });
    } catch (...) {
      m_staying.forget();
      throw;
    }
    m_staying.forget();
  }

  // Triangulates the points anew at their present positions. The vertices keep their numbers if
  // these still follow the spatial order, and no points coincide.
  void rebuild()
  {
    write_all_anew([&] {
      if (!sort_vertices()) {
        m_numbering.number();
        triangulate_numbered();
      } else if (are_numbers_far_apart()) {
        m_numbering.number(m_vertex_order.take_order());
        triangulate_numbered();
      } else
        triangulate(m_vertex_order.order());
    });
  }

  // Restores a triangulation from a checkpoint, which must be valid. There must be no points yet.
  // If memory runs out, this triangulation can only be discarded.
  void restore(Checkpoint_arrays_2<Point>& kept)
  {
    CGAL_precondition(m_state.number_of_vertices() == 0);
    restore_vertices(kept);
    if (kept.faces.number_of_faces() == 0)
      triangulate_line();
    else {
      provide_faces(kept.faces.number_of_faces());
      take_faces(kept.faces, [] {});
      restore_numbers(kept);
    }
    m_storage.resize_data(m_state.number_of_vertices() + std::size_t(1),
                          m_arrays.faces_with_holes());
  }

  // Makes the triangulation, which must be empty, a copy of another one, with all user data in
  // vertices and faces. The visitor is not called. If this throws, the copy can only be discarded.
  void copy(const State& other)
  {
    CGAL_precondition(m_state.number_of_vertices() == 0);
    m_writer.copy(other);
    m_writer.ids() = other.ids();
    m_writer.changes() = other.changes();
  }

  // Reserves the memory that exchange() needs.
  void reserve_for_exchange(const State& other)
  {
    m_storage.reserve_data(other.number_of_vertices() + std::size_t(1),
                           other.arrays().faces_with_holes());
  }

  // Exchanges everything with another triangulation, except the user's visitor and data. User data
  // are then as in new vertices and faces. Throws nothing after reserve_for_exchange().
  void exchange(State& other)
  {
    tell_of_faces_before();
    for_each_vertex([this](Vertex_index v) { m_editing.before_vertex_removal(v); });
    m_writer.exchange(other);
    std::swap(m_writer.ids(), Writer(other).ids());
    std::swap(m_writer.changes(), Writer(other).changes());
    for_each_vertex([this](Vertex_index v) { m_editing.after_vertex_creation(v); });
    tell_of_faces_after();
  }

  // Moves each vertex by CGAL's own functions from its position in the last frame, where everything
  // is Delaunay, to its present one. Adds the number of moved vertices to `relocated`. Returns
  // false if some cannot move because other vertices stay where they would go: then the result is
  // not Delaunay. If memory runs out, nothing has changed: CGAL works on a copy.
  bool relocate_all(std::size_t& relocated)
  {
    bool all_arrived = false;
    write_all_anew([&] {
      Storage storage(m_storage);
      storage.writable_points() = m_positions.previous_points();
      Triangulation copy = triangulation_on<Triangulation>(storage, m_state.traits(),
                                                           m_state.triangulation().dimension());
      all_arrived = relocate_one_by_one(copy, relocated);
      take_arrays(storage, copy.dimension());
      m_positions.forget_previous();
    });
    return all_arrived;
  }

private:
  // THE VISITOR -----------------------------------------------------------------------------------

  // Writes all faces anew by f(), and calls the visitor before and after, even if f() throws.
  template <class Function>
  void write_all_anew(const Function& f)
  {
    m_writer.changes().everything_is_new = true; // also if memory runs out on the way
    tell_of_faces_before();
    try {
      f();
    } catch (...) {
      tell_of_faces_after();
      throw;
    }
    tell_of_faces_after();
  }

  void tell_of_faces_before()
  {
    for_each_face([this](Face_index f) { m_editing.before_face(f); });
  }
  void tell_of_faces_after()
  {
    for_each_face([this](Face_index f) { m_editing.after_face(f); });
  }

  // Calls f(face) for all faces if the visitor listens.
  template <class Function>
  void for_each_face(const Function& f) const
  {
    if (m_editing.is_heard())
      for (Face_index face(0); face < m_arrays.number_of_faces(); ++face)
        f(face);
  }

  // Calls f(vertex) for all finite vertices if the visitor listens.
  template <class Function>
  void for_each_vertex(const Function& f) const
  {
    if (m_editing.is_heard())
      for (Vertex_index v(1); v <= m_state.number_of_vertices(); ++v)
        f(v);
  }

  // Tells the visitor of the vertices that vanish when `next_ids` replace the present ids.
  void tell_of_going_vertices(const Ids& next_ids)
  {
    const Ids& ids = m_state.ids();
    for_each_vertex([&](Vertex_index v) {
      const Point_id id = ids.representative(v);
      if (!next_ids.is_taken(id) || m_staying.goes(id))
        m_editing.before_vertex_removal(v);
      else if (!next_ids.is_representative(id)) {
        const Point_id stays =
            next_ids.representative(next_ids.vertex(id)); // keeps its vertex, too
        m_editing.before_vertex_merge(v, ids.vertex(stays));
      }
    });
  }

  // Tells the visitor of the vertices that did not exist with `former_ids`.
  void tell_of_new_vertices(const Ids& former_ids)
  {
    for_each_vertex([&](Vertex_index v) {
      if (!m_staying.keeps_vertex(m_state.ids().representative(v), former_ids))
        m_editing.after_vertex_creation(v);
    });
  }

  // RELOCATING ----------------------------------------------------------------------------------

  bool relocate_one_by_one(Triangulation& triangulation, std::size_t& relocated)
  {
    const auto& tds = triangulation.tds();
    std::vector<Vertex_index> waiting;
    for (Vertex_index v(1); v <= m_state.number_of_vertices(); ++v)
      if (!coincide(m_state.traits(), m_state.point(v), tds.vertex_handle(v)->point()))
        waiting.push_back(v);
    const auto arrives = [&](Vertex_index v) {
      const Vertex_handle vertex = tds.vertex_handle(v);
      const bool arrived = triangulation.move_if_no_collision(vertex, m_state.point(v)) == vertex;
      relocated += arrived;
      return arrived;
    };
    // a vertex whose place is taken tries again after the others have moved
    for (std::size_t before = waiting.size() + 1; !waiting.empty() && waiting.size() < before;) {
      before = waiting.size();
      waiting.erase(std::remove_if(waiting.begin(), waiting.end(), arrives), waiting.end());
    }
    return waiting.empty();
  }

  // Takes over the faces that CGAL's algorithms have made of vertices with the same numbers. If
  // this throws, nothing has changed.
  void take_arrays(Storage& storage, int dimension)
  {
    storage.collect_garbage(); // at most the last vertex, which CGAL has used for a time
    Writable_halfedge_arrays_2& arrays = storage.writable_arrays();
    CGAL_assertion(arrays.number_of_vertices() == m_state.positions().size());
    if (dimension == 2)
      arrays.template number_from_neighbors<Parts>();
    m_storage.reserve_data(0, arrays.faces_with_holes());
    std::swap(m_arrays, arrays); // nothing throws from here on
    set_dimension(dimension);
    finish_faces();
  }

  // BUILDING ------------------------------------------------------------------------------------

  void set_dimension(int dimension) { m_writer.set_dimension(dimension); }

  // Sorts the vertices. False, perhaps without sorting, if the set of vertices may change, because
  // vertices coincide or there are covered points, which may have left.
  bool sort_vertices()
  {
    if (m_state.ids().number_of_covered() > 0)
      return false;
    const boost::counting_iterator<Index> first(1), beyond(m_state.number_of_vertices() + Index(1));
    m_vertex_order.sort(first, beyond);
    return !m_vertex_order.has_coincident_vertices();
  }

  // Whether consecutive vertices in space have distant numbers often enough to pay for new ones.
  bool are_numbers_far_apart() const
  {
    return 8 * m_vertex_order.number_of_far_steps() > m_state.positions().size();
  }

  // Triangulates the vertices as m_numbering numbers them. Representatives that had vertices of
  // their own keep them, and the data in them. If memory runs out, nothing has changed.
  void triangulate_numbered()
  {
    Ids& ids = m_numbering.ids();
    Uninitialized_vector<Stored_point> points;
    Position_vector positions;
    m_positions.template collect<Parts>(
        ids.number_of_representatives(),
        [this](Vertex_index v) -> const Point& { return m_numbering.point(v); }, points, positions);
    const std::vector<Vertex_index> before = numbers_before();
    const auto data = m_storage.vertex_data().prepare(before);
    m_numbering.release_points();
    tell_of_going_vertices(ids);
    const auto exchange = [&] {
      m_positions.exchange(points, positions);
      std::swap(m_writer.ids(), ids);
    };
    exchange();
    try {
      triangulate(m_numbering.order());
    } catch (...) {
      exchange();
      tell_of_new_vertices(ids);
      throw;
    }
    m_positions.forget_previous();
    if (m_storage.vertex_data().empty())
      m_storage.vertex_data().resize(m_positions.positions().size());
    else
      m_storage.vertex_data().renumber(data, before);
    tell_of_new_vertices(ids);
    m_numbering.release();
  }

  // Returns for each vertex, as m_numbering numbers them, its former number, or `null_index` if it
  // is new. Empty if there are no user data at vertices.
  std::vector<Vertex_index> numbers_before()
  {
    std::vector<Vertex_index> before;
    if (m_storage.vertex_data().empty())
      return before;
    const Ids &ids = m_numbering.ids(), &present_ids = m_state.ids();
    before.push_back(infinite_index);
    for (Vertex_index v(1); v <= ids.number_of_representatives(); ++v) {
      const Point_id id = ids.representative(v);
      before.push_back(m_staying.keeps_vertex(id, present_ids) ? present_ids.vertex(id)
                                                               : null_index);
    }
    return before;
  }

  // Triangulates all vertices in this order. Frees the temporary data, which would take as much
  // memory as the triangulation. If memory runs out, nothing has changed.
  void triangulate(const Spatial_order_2& order)
  {
    m_triangulator.run(order, [&] { provide_faces(2 * order.size() - 2); });
    m_vertex_order.release();
    m_numbering.release_order();
    const auto release = [&] { m_triangulator.release(); };
    if (m_triangulator.faces().number_of_faces() > 0) {
      provide_faces(m_triangulator.faces().number_of_faces());
      take_faces(m_triangulator.faces(), release);
    } else {
      triangulate_line();
      release();
    }
  }

  // Reserves memory for take_faces().
  void provide_faces(std::size_t number)
  {
    m_arrays.reserve(m_state.number_of_vertices(), Index(number));
    m_storage.reserve_data(0, number);
  }

  // Takes over the faces. When they are no longer needed, calls `companion()`.
  template <class Companion>
  void take_faces(const Flat_faces_2& faces, const Companion& companion)
  {
    const auto apex_and_twin = [&](Face_index f, Index i) {
      const Flat_halfedge_index h = Flat_faces_2::first_halfedge(f) + i;
      return std::pair(faces.apex(h), Flat_faces_2::number_in_arrays(faces.twin(h)));
    };
    m_arrays.template write<Parts>(m_state.number_of_vertices(), faces.number_of_faces(),
                                   apex_and_twin, companion);
    set_dimension(2);
    finish_faces();
  }

  // Resizes the user data at faces. Their values belonged to other faces before.
  void finish_faces()
  {
    m_storage.face_data().resize(m_arrays.faces_with_holes());
    m_storage.note_written_by_editor();
  }

  // Triangulates vertices that do not span the plane, by CGAL's insertion.
  void triangulate_line()
  {
    Storage storage;
    Triangulation line = triangulation_on<Triangulation>(storage, m_state.traits());
    Face_handle last;
    for (Vertex_index v(1); v <= m_state.number_of_vertices(); ++v)
      last = line.insert(m_state.point(v), last)->face();
    take_arrays(storage, line.dimension());
  }

  // RESTORING -----------------------------------------------------------------------------------

  void restore_vertices(Checkpoint_arrays_2<Point>& kept)
  {
    Uninitialized_vector<Stored_point> points(kept.points.size() + 1);
    points.front() = m_positions.stored(infinite_index);
    for (std::size_t i = 0; i < kept.points.size(); ++i)
      points[i + 1] = Arrays::stored(kept.positions[i], kept.points[i]);
    Position_vector positions;
    if constexpr (!Positions::points_are_two_doubles) {
      positions.push_back(nan_point());
      positions.insert(positions.end(), kept.positions.begin(), kept.positions.end());
    }
    m_positions.exchange(points, positions);
    m_positions.set_exactness(kept.positions_are_exact);
    std::swap(m_writer.ids(), kept.ids);
  }

  // Restores the numbers of edges, and the corners.
  void restore_numbers(const Checkpoint_arrays_2<Point>& kept)
  {
    for (Edge_index e(0); e < m_arrays.number_of_edges(); ++e) {
      m_arrays.set_edge(e, kept.forward_halfedges[e]);
      m_arrays.set_halfedge(e, kept.halfedges[e]);
    }
    for (Vertex_index v(0); v < m_arrays.number_of_vertices(); ++v)
      m_arrays.set_corner(v, kept.corners[v]);
  }

  const State& m_state;
  const Writer m_writer;
  Storage& m_storage;
  Writable_halfedge_arrays_2& m_arrays;
  Positions& m_positions;
  Plane_editing_2<State> m_editing; // tells the visitor
  Staying_points_2<State> m_staying;
  Vertex_order_2<State> m_vertex_order;
  Point_numbering_2<State> m_numbering;
  Static_triangulator_2<State> m_triangulator;
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_SPACE_PLANE_BUILDER_2_H

// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_SPACE_TOPOLOGY_BUILDER_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_SPACE_TOPOLOGY_BUILDER_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/assertions.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Flat_elements_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Points_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Spatial_order_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/space/Checkpoint_arrays_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/space/Plane_editing_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/space/Positions_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/space/Triangulation_state_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/static/Flat_faces_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/static/Static_triangulator_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/static/Vertex_order_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/topology/Halfedge_arrays_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/topology/Point_ids_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/topology/Topology_2.h>
#include <CGAL/enum.h>

#include <boost/iterator/counting_iterator.hpp>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

// Puts points into a spatial order, distinguishes representatives from duplicates, and numbers the
// vertices in that order. Of coincident points, it makes one that keeps its vertex, if there is
// any, the representative.
template <class State>
class Point_numbering_2
{
  using Point = typename State::Point;
  using Ids = Point_ids_2<Point>;
  using Parts = typename State::Parts;

public:
  explicit Point_numbering_2(const State& state)
    : m_state(state)
  {
  }

  // Numbers these points with these ids. All ids are smaller than `number_of_ids`.
  // `keeps_vertex(id)` is true if the point already has a vertex of its own, and stays.
  template <class Predicate>
  void number(std::vector<Index> ids, std::vector<Point> points, Index number_of_ids,
              const Predicate& keeps_vertex)
  {
    m_point_ids = std::move(ids);
    m_points = std::move(points);
    sort_points();
    number_points(number_of_ids, keeps_vertex);
  }

  // Numbers the vertices of the maintained triangulation, at their present positions and in this
  // order. No vertices may coincide, and there must be no duplicates.
  void number(Spatial_order_2 order)
  {
    const Index vertices = m_state.number_of_vertices();
    m_order = std::move(order);
    m_point_ids.resize(vertices + std::size_t(1)); // the infinite vertex has no point
    m_points.resize(vertices + std::size_t(1));
    Parts::for_each_element(vertices, [&](std::size_t i) {
      const Vertex_index v = Index(i + 1);
      m_point_ids[v] = m_state.ids().representative(v);
      m_points[v] = m_state.point(v);
    });
    number_points(m_state.ids().number_of_ids(), [](Index) { return true; });
  }

  // Numbers all points of the maintained triangulation, at their present positions.
  void number()
  {
    const Ids& ids = m_state.ids();
    std::vector<Index> point_ids = ids.representatives_and_duplicates();
    std::vector<Point> points;
    points.reserve(point_ids.size());
    for (Vertex_index v = 1; v <= m_state.number_of_vertices(); ++v)
      points.push_back(m_state.point(v));
    for (const auto& duplicate : ids.duplicates())
      points.push_back(duplicate.point);
    number(std::move(point_ids), std::move(points), ids.number_of_ids(),
           [&](Point_id id) { return ids.is_representative(id); });
  }

  // The spatial order of the vertices, given by their new numbers.
  const Spatial_order_2& order() const { return m_order; }
  // The results: the ids, and the point of each vertex.
  Ids& ids() { return m_ids; }
  const Point& point(Vertex_index vertex) const { return m_points[m_place_of_vertex[vertex - 1]]; }

  // Free the memory of the points, of the order, or of everything. Throw nothing.
  void release_points()
  {
    std::vector<Point>().swap(m_points);
    std::vector<Index>().swap(m_point_ids);
    std::vector<Index>().swap(m_place_of_vertex);
  }
  void release_order() { m_order.release(); }
  void release()
  {
    release_points();
    release_order();
    m_ids = Ids();
  }

private:
  // Replaces the indices of points in the order by numbers of vertices.
  template <class Predicate>
  void number_points(Index number_of_ids, const Predicate& keeps_vertex)
  {
    const auto are_in_one_place = [this](Index i, Index j) {
      return coincide(m_state.traits(), m_points[i], m_points[j]);
    };
    m_ids.reset(number_of_ids);
    m_place_of_vertex.clear();
    m_place_of_vertex.reserve(m_points.size());
    if (m_order.template are_distinct<Parts>(are_in_one_place))
      number_distinct_points();
    else
      m_order.merge_coincident(are_in_one_place, [&](std::size_t first, std::size_t beyond) {
        return add_vertex(first, beyond, keeps_vertex);
      });
    m_ids.finish_numbering();
  }

  // Each point gets a vertex, numbered by its place in the order, so threads work independently.
  void number_distinct_points()
  {
    m_place_of_vertex.resize(m_order.size());
    m_ids.resize(Index(m_order.size()));
    Parts::for_each_element(m_order.size(), [&](std::size_t i) {
      const Index place = m_order[i], vertex = Index(i) + 1;
      m_place_of_vertex[i] = place;
      m_ids.set_representative(vertex, m_point_ids[place]);
      m_order.renumber(i, vertex);
    });
  }

  void sort_points()
  {
    const boost::counting_iterator<Index> first(0), beyond(Index(m_points.size()));
    if (m_state.positions_are_exact()) {
      std::vector<Position_2> positions(m_points.size());
      Parts::for_each_element(m_points.size(),
                              [&](std::size_t i) { positions[i] = approximation(m_points[i]); });
      m_order.template sort<Parts>(positions, first, beyond);
    } else
      m_order.sort_by_comparisons(first, beyond, [this](Index i, Index j) {
        return compare_xy(m_state.traits(), m_points[i], m_points[j]) == SMALLER;
      });
  }

  // Adds a vertex for the coincident points in these places of the order.
  template <class Predicate>
  Index add_vertex(std::size_t first, std::size_t beyond, const Predicate& keeps_vertex)
  {
    std::size_t representative = first;
    while (representative < beyond && !keeps_vertex(m_point_ids[m_order[representative]]))
      ++representative;
    if (representative == beyond)
      representative = first;
    const Point_id id = m_point_ids[m_order[representative]];
    const Vertex_index vertex = m_ids.add_representative(id);
    m_place_of_vertex.push_back(m_order[representative]);
    for (std::size_t i = first; i < beyond; ++i)
      if (i != representative)
        m_ids.add_duplicate(m_point_ids[m_order[i]], id, m_points[m_order[i]]);
    return vertex;
  }

  const State& m_state;
  Spatial_order_2 m_order;
  std::vector<Point> m_points; // the points to number
  std::vector<Index> m_point_ids;
  std::vector<Index> m_place_of_vertex; // index in m_points of its representative
  Ids m_ids;
};

// Writes the whole topology at once: triangulates from scratch, restores, copies or exchanges it,
// or takes over what CGAL's algorithms have made. Everything is new then, but for a copy.
template <class State>
class Topology_builder_2
{
  using Topology = typename State::Topology;
  using Positions = typename State::Positions;
  using Point = typename State::Point;
  using Triangulation = typename State::Triangulation;
  using Vertex_handle = typename State::Vertex_handle;
  using Face_handle = typename State::Face_handle;
  using Storage = typename Topology::Storage;
  using Ids = Point_ids_2<Point>;
  using Parts = typename State::Parts;
  using Arrays = Point_arrays_2<Point>;
  using Stored_point = typename Arrays::Stored_point;

public:
  explicit Topology_builder_2(State& state)
    : m_state(state)
    , m_topology(state.m_topology)
    , m_storage(state.m_topology.m_storage)
    , m_arrays(state.m_topology.m_storage.m_arrays)
    , m_positions(state.m_positions)
    , m_editing(state)
    , m_vertex_order(state)
    , m_numbering(state)
    , m_triangulator(state)
  {
  }

  void set_engine(Static_engine_2 engine) { m_triangulator.set_engine(engine); }

  // Replaces everything by a fresh triangulation of these points with these ids, all of which are
  // smaller than `number_of_ids`. Points that are present already keep their vertices.
  void build(std::vector<Index> ids, std::vector<Point> points, Index number_of_ids)
  {
    write_all_anew([&] {
      m_numbering.number(std::move(ids), std::move(points), number_of_ids,
                         [&](Point_id id) { return keeps_vertex(id, m_topology.m_ids); });
      triangulate_numbered();
    });
  }

  // Triangulates the present points except those in `gone`, and the points that come.
  void build_with(const std::vector<Index>& gone, std::vector<Index> coming_ids,
                  std::vector<Point> coming_points)
  {
    try {
      Index number_of_ids = m_topology.m_ids.number_of_ids();
      for (const Point_id id : coming_ids)
        number_of_ids = (std::max)(number_of_ids, id + 1);
      std::vector<Index> ids = ids_without(gone);
      std::vector<Point> points;
      if (ids.empty()) { // as at a construction, where memory counts
        ids = std::move(coming_ids);
        points = std::move(coming_points);
      } else {
        points.reserve(ids.size() + coming_ids.size());
        for (const Point_id id : ids)
          points.push_back(m_state.point_of_id(id));
        points.insert(points.end(), coming_points.begin(), coming_points.end());
        ids.insert(ids.end(), coming_ids.begin(), coming_ids.end());
      }
      build(std::move(ids), std::move(points), number_of_ids);
    } catch (...) {
      m_goes.clear();
      throw;
    }
    m_goes.clear();
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
      take_faces(kept.faces);
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
    m_storage.copy(other.m_topology.m_storage);
    set_dimension(other.triangulation().dimension());
    m_topology.m_ids = other.ids();
    m_topology.m_changes = other.changes();
    m_positions.copy(other.m_positions);
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
    const int dimension = m_state.triangulation().dimension();
    set_dimension(other.triangulation().dimension());
    other.m_topology.m_triangulation.tds().set_dimension(dimension);
    m_storage.exchange(other.m_topology.m_storage);
    std::swap(m_topology.m_ids, other.m_topology.m_ids);
    std::swap(m_topology.m_changes, other.m_topology.m_changes);
    m_positions.exchange_all_but_points(other.m_positions);
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
      Triangulation copy(m_state.traits());
      Storage& storage = Topology::storage_of(copy);
      storage.copy(m_storage);
      storage.m_arrays.drop_edges();
      storage.m_points = m_positions.m_other_points;
      copy.tds().set_dimension(m_state.triangulation().dimension());
      all_arrived = relocate_one_by_one(copy, relocated);
      take_arrays(copy);
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
    m_topology.m_changes.everything_is_new = true; // also if memory runs out on the way
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
    if constexpr (State::Visitor_calls::is_heard)
      for (Face_index face = 0; face < m_arrays.number_of_faces(); ++face)
        f(face);
  }

  // Calls f(vertex) for all finite vertices if the visitor listens.
  template <class Function>
  void for_each_vertex(const Function& f) const
  {
    if constexpr (State::Visitor_calls::is_heard)
      for (Vertex_index v = 1; v <= m_state.number_of_vertices(); ++v)
        f(v);
  }

  // Tells the visitor of the vertices that vanish when `next_ids` replace the present ids.
  void tell_of_going_vertices(const Ids& next_ids)
  {
    const Ids& ids = m_topology.m_ids;
    for_each_vertex([&](Vertex_index v) {
      const Point_id id = ids.representative(v);
      if (!next_ids.is_taken(id) || goes(id))
        m_editing.before_vertex_removal(v);
      else if (!next_ids.is_representative(id)) {
        const Index stays = next_ids.representative(next_ids.vertex(id)); // keeps its vertex, too
        m_editing.before_vertex_merge(v, ids.vertex(stays));
      }
    });
  }

  // Tells the visitor of the vertices that did not exist with `former_ids`.
  void tell_of_new_vertices(const Ids& former_ids)
  {
    for_each_vertex([&](Vertex_index v) {
      if (!keeps_vertex(m_topology.m_ids.representative(v), former_ids))
        m_editing.after_vertex_creation(v);
    });
  }

  // RELOCATING ----------------------------------------------------------------------------------

  bool relocate_one_by_one(Triangulation& triangulation, std::size_t& relocated)
  {
    const auto& tds = triangulation.tds();
    std::vector<Index> waiting;
    for (Vertex_index v = 1; v <= m_state.number_of_vertices(); ++v)
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

  // Takes over the faces of a triangulation that CGAL's algorithms have made of vertices with the
  // same numbers. If this throws, nothing has changed.
  void take_arrays(Triangulation& other)
  {
    Storage& storage = Topology::storage_of(other);
    storage.collect_garbage(); // at most the last vertex, which CGAL has used for a time
    CGAL_assertion(storage.m_arrays.number_of_vertices() == m_state.positions().size());
    if (other.dimension() == 2)
      storage.m_arrays.template number_from_neighbors<Parts>();
    m_storage.reserve_data(0, storage.m_arrays.faces_with_holes());
    std::swap(m_arrays, storage.m_arrays); // nothing throws from here on
    set_dimension(other.dimension());
    finish_faces();
  }

  // BUILDING ------------------------------------------------------------------------------------

  void set_dimension(int dimension) { m_topology.m_triangulation.tds().set_dimension(dimension); }

  // Returns the ids of all points but those in `gone`, representatives first. Sets m_goes.
  std::vector<Index> ids_without(const std::vector<Index>& gone)
  {
    std::vector<Index> ids = m_topology.m_ids.representatives_and_duplicates();
    if (gone.empty())
      return ids;
    m_goes.assign(m_topology.m_ids.number_of_ids(), false);
    for (const Point_id id : gone)
      m_goes[id] = true;
    ids.erase(std::remove_if(ids.begin(), ids.end(), [this](Point_id id) { return goes(id); }),
              ids.end());
    return ids;
  }

  // Whether the point with this id is removed. A new point may get its id, but not its vertex.
  bool goes(Point_id id) const { return id < m_goes.size() && m_goes[id]; }

  bool keeps_vertex(Point_id id, const Ids& ids) const
  {
    return ids.is_taken(id) && ids.is_representative(id) && !goes(id);
  }

  // Sorts the vertices. False, perhaps without sorting, if the set of vertices may change, because
  // vertices coincide or there are duplicates, which may have left.
  bool sort_vertices()
  {
    if (!m_topology.m_ids.duplicates().empty())
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
    std::vector<Stored_point> points;
    std::vector<Position_2> positions;
    m_positions.template collect<Parts>(
        ids.number_of_representatives(),
        [this](Vertex_index v) -> const Point& { return m_numbering.point(v); }, points, positions);
    const std::vector<Index> before = numbers_before();
    auto data = m_storage.m_vertex_data.prepare(before);
    m_numbering.release_points();
    tell_of_going_vertices(ids);
    const auto exchange = [&] {
      m_positions.exchange(points, positions);
      std::swap(m_topology.m_ids, ids);
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
    if (m_storage.m_vertex_data.empty())
      m_storage.m_vertex_data.resize(m_positions.positions().size());
    else
      m_storage.m_vertex_data.renumber(data, before);
    tell_of_new_vertices(ids);
    m_numbering.release();
  }

  // Returns for each vertex, as m_numbering numbers them, its former number, or `null_index` if it
  // is new. Empty if there are no user data at vertices.
  std::vector<Index> numbers_before()
  {
    std::vector<Index> before;
    if (m_storage.m_vertex_data.empty())
      return before;
    const Ids &ids = m_numbering.ids(), &present_ids = m_topology.m_ids;
    before.push_back(infinite_index);
    for (Vertex_index v = 1; v <= ids.number_of_representatives(); ++v) {
      const Point_id id = ids.representative(v);
      before.push_back(keeps_vertex(id, present_ids) ? present_ids.vertex(id)
                                                     : Vertex_index(null_index));
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
    if (m_triangulator.faces().number_of_faces() > 0) {
      provide_faces(m_triangulator.faces().number_of_faces());
      take_faces(m_triangulator.faces());
    } else
      triangulate_line();
    m_triangulator.release();
  }

  // Reserves memory for take_faces().
  void provide_faces(std::size_t number)
  {
    m_arrays.reserve(m_state.number_of_vertices(), Index(number));
    m_storage.reserve_data(0, number);
  }

  void take_faces(const Flat_faces_2& faces)
  {
    const auto apex_and_twin = [&](Face_index f, Index i) {
      const Halfedge_index h = Flat_faces_2::first_halfedge(f) + i;
      return std::pair(faces.apex(h), Flat_faces_2::number_in_arrays(faces.twin(h)));
    };
    m_arrays.template write<Parts>(m_state.number_of_vertices(), faces.number_of_faces(),
                                   apex_and_twin);
    set_dimension(2);
    finish_faces();
  }

  // Resizes the user data at faces. Their values belonged to other faces before.
  void finish_faces()
  {
    m_storage.m_face_data.resize(m_arrays.faces_with_holes());
    m_storage.m_is_written_by_handles = false;
  }

  // Triangulates vertices that do not span the plane, by CGAL's insertion.
  void triangulate_line()
  {
    Triangulation line(m_state.traits());
    Face_handle last;
    for (Vertex_index v = 1; v <= m_state.number_of_vertices(); ++v)
      last = line.insert(m_state.point(v), last)->face();
    take_arrays(line);
  }

  // RESTORING -----------------------------------------------------------------------------------

  void restore_vertices(Checkpoint_arrays_2<Point>& kept)
  {
    std::vector<Stored_point> points(kept.points.size() + 1);
    points.front() = m_positions.m_points.front();
    for (std::size_t i = 0; i < kept.points.size(); ++i)
      points[i + 1] = Arrays::stored(kept.positions[i], kept.points[i]);
    std::vector<Position_2> positions;
    if constexpr (!Positions::points_are_two_doubles) {
      positions.push_back(nan_point());
      positions.insert(positions.end(), kept.positions.begin(), kept.positions.end());
    }
    m_positions.exchange(points, positions);
    m_positions.m_are_exact = kept.positions_are_exact;
    std::swap(m_topology.m_ids, kept.ids);
  }

  // Restores the numbers of edges, and the corners.
  void restore_numbers(const Checkpoint_arrays_2<Point>& kept)
  {
    for (Edge_index e = 0; e < m_arrays.number_of_edges(); ++e) {
      m_arrays.set_edge(e, kept.forward_halfedges[e]);
      m_arrays.set_halfedge(e, kept.halfedges[e]);
    }
    for (Vertex_index v = 0; v < m_arrays.number_of_vertices(); ++v)
      m_arrays.set_corner(v, kept.corners[v]);
  }

  const State& m_state;
  Topology& m_topology;
  Storage& m_storage;
  Halfedge_arrays_2& m_arrays;
  Positions& m_positions;
  Plane_editing_2<State> m_editing; // tells the visitor
  Vertex_order_2<State> m_vertex_order;
  Point_numbering_2<State> m_numbering;
  std::vector<bool> m_goes; // by ids: the points that build_with() leaves out
  Static_triangulator_2<State> m_triangulator;
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_SPACE_TOPOLOGY_BUILDER_2_H

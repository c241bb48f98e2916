// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_TOPOLOGY_TOPOLOGY_EDITOR_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_TOPOLOGY_TOPOLOGY_EDITOR_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/assertions.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Flat_arrays.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Processor.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Flat_elements_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/topology/Change_log_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/topology/Halfedge_arrays_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/topology/Star_polygon_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/topology/Topology_parts_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/topology/Writable_halfedge_arrays_2.h>

#include <algorithm>
#include <cstddef>
#include <new>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

// A directed edge on the boundary of a set of faces. The set is on its left.
struct Boundary_edge_2
{
  Vertex_index source, target;
  Halfedge_index halfedge;

  bool operator<(const Boundary_edge_2& other) const
  {
    return source != other.source ? source < other.source : target < other.target;
  }
};

// A set of faces with half-edges of its own. Half-edge 3k+i is opposite to vertex i of the k-th
// face, as in the arrays. Half-edges on the boundary have no twin.
struct Patch_2
{
  Column<Halfedge_index, Vertex_index> apexes;
  Column<Halfedge_index, Halfedge_index> twins;
  std::vector<Boundary_edge_2> boundary; // sorted by source, then target

  Index number_of_faces() const { return Index(apexes.size() / 3); }

  void clear()
  {
    apexes.clear();
    twins.clear();
    boundary.clear();
  }

  void find_boundary()
  {
    using Arrays = Halfedge_arrays_2;
    boundary.clear();
    for (Halfedge_index h(0); h < Index(twins.size()); ++h)
      if (twins[h] == null_index)
        boundary.push_back({apexes[Arrays::next(h)], apexes[Arrays::previous(h)], h});
    std::sort(boundary.begin(), boundary.end());
  }
};

// Edits the topology, some faces at a time, in every space. Builders write all of it; nothing else
// can write. Each operation logs the new edges. `State::Editing` writes what only one space keeps
// at faces and vertices, and tells the user's visitor.
template <class State>
class Topology_editor_2
{
  using Writer = typename State::Writer;
  using Editing = typename State::Editing;
  using Parts = typename State::Parts;
  using Positions = typename Writer::Positions;
  using Point = typename State::Point;
  using Chart = typename State::Chart;
  using Polygon = Star_polygon_2<State>;

  // The changes in a part: the new edges, vertices that were put in again, ids that are no longer
  // used, and what the visitor has to be told.
  struct Changes_of_part
  {
    std::vector<Edge_index> edges;
    std::vector<Vertex_index> relocated;
    std::vector<Point_id> gone;
    typename Editing::Log log;
  };

public:
  using Slot = Halfedge_arrays_2::Slot;

  explicit Topology_editor_2(State& state)
    : m_state(state)
    , m_editing(state)
    , m_arrays(Writer(state).arrays())
    , m_ids(Writer(state).ids())
    , m_positions(Writer(state).positions())
    , m_changes(Writer(state).changes())
    , m_star_writer(m_arrays)
  {
  }

  // THE VISITOR AND THE LOG OF CHANGES ----------------------------------------------------------

  // Begins to call the visitor, if it listens.
  template <class Visitor, class Dynamic>
  void start_visit(Visitor& visitor, const Dynamic* dynamic, bool is_listening)
  {
    m_editing.start_visit(visitor, dynamic, is_listening);
  }

  // Ends the calls of the visitor, and throws its first exception, if any.
  void finish_visit() { m_editing.finish_visit(); }

  // Begins an update. Changes of the last one that the classifier was not told stay in the log.
  void begin_changes(bool is_classifier_informed)
  {
    if (is_classifier_informed)
      m_changes.clear();
    else if (!m_changes.renumberings.are_none()) // those of two updates are not combined
      m_changes.everything_is_new = true;
    if (m_changes.everything_is_new)
      m_changes.new_edges.clear();
  }

  // Ends an update. Each new edge is in the log once afterwards.
  void end_changes() { make_distinct_by_parts<Parts>(m_changes.new_edges); }

  void note_everything_is_new() { m_changes.everything_is_new = true; }

  // Reports examined edges to a heuristic classifier as if they were new.
  void note_examined(const std::vector<Edge_index>& edges)
  {
    m_changes.new_edges.insert(m_changes.new_edges.end(), edges.begin(), edges.end());
  }

  // FLIPS ---------------------------------------------------------------------------------------

  // False if the flip would double an edge, as at vertices of degree 3: the vertices of an edge, on
  // a torus with their shifts, identify it. This can be so even if both faces at the edge are
  // counterclockwise, because other faces may overlap them.
  bool can_flip(Halfedge_index h) const { return m_editing.can_flip(h); }

  // Exchanges the diagonal at half-edge h. If it throws, nothing has changed.
  //
  //     b ----- a             b ----- a
  //     | \  h  |             |     / |
  //     |   \   |  -------->  |   /   |
  //     |  g  \ |             | /     |
  //     d ----- c             d ----- c
  void flip(Halfedge_index h)
  {
    m_editing.reserve(2);
    m_changes.new_edges.push_back(m_arrays.edge_of(h));
    m_editing.flip(h, m_editing.log()); // throws nothing
  }

  // Undoes the flips since the log had this many edges; nothing else may have changed faces.
  // Faces are as before then, but may have exchanged numbers. The log goes on.
  void undo_flips(std::size_t first)
  {
    const std::size_t beyond = m_changes.new_edges.size();
    for (std::size_t i = beyond; i > first; --i)
      flip(m_arrays.halfedge(m_changes.new_edges[i - 1]));
  }

  // Calls f(part, try_flip) for all parts of `topology`, which threads share. There must be no more
  // than `most` flips. try_flip(h) flips the edge of half-edge h, and returns true, if the edge is
  // inside of the part and the flip doubles no edge, which is not tested if `no_edge_doubles`. If
  // the visitor is told of each flip, there are no threads, and one part follows the other. The
  // result depends on the parts alone.
  template <class Function>
  void flip_in_parts(const Topology_parts_2& topology, bool no_edge_doubles, std::size_t most,
                     const Function& f)
  {
    m_editing.reserve(2 * most);
    run_in_parts(topology.number(), m_editing.tells_at_once(),
                 [&](std::size_t part, Changes_of_part& changes) {
                   f(part, [&](Halfedge_index h) {
                     return try_flip(topology, part, no_edge_doubles, h, changes);
                   });
                 });
  }

  // Replaces `old_faces` by the faces of `patch`. Both have equal numbers of faces and equal
  // boundaries. The half-edge outside the i-th edge of the patch's boundary is `outside[i]`.
  void replace(const Index_set<Face_index>& old_faces, const Patch_2& patch,
               const std::vector<Halfedge_index>& outside)
  {
    CGAL_precondition(old_faces.size() == patch.number_of_faces());
    CGAL_precondition(outside.size() == patch.boundary.size());
    collect_inner_edges(old_faces);
    auto& new_edges = m_changes.new_edges;
    new_edges.insert(new_edges.end(), m_inner_edges.begin(), m_inner_edges.end());
    for (const Face_index f : old_faces) // nothing throws from here on
      m_editing.before_face(f);
    const auto global = [&](Halfedge_index h) {
      return Halfedge_arrays_2::halfedge_in(old_faces[Halfedge_arrays_2::face_of(h)],
                                            Halfedge_arrays_2::number_in_face(h));
    };
    for (Halfedge_index h(0); h < Index(patch.apexes.size()); ++h)
      m_arrays.set_apex(global(h), patch.apexes[h]);
    for (Halfedge_index h(0); h < Index(patch.twins.size()); ++h)
      if (patch.twins[h] != null_index && h < patch.twins[h])
        m_arrays.link(global(h), global(patch.twins[h]));
    for (std::size_t i = 0; i < outside.size(); ++i)
      m_arrays.link(global(patch.boundary[i].halfedge), outside[i]);
    auto edge = m_inner_edges.begin();
    for (Halfedge_index h(0); h < Index(patch.twins.size()); ++h)
      if (patch.twins[h] != null_index && h < patch.twins[h])
        m_arrays.set_edge(*edge++, global(h));
    for (const Halfedge_index h : outside)
      m_arrays.set_edge(m_arrays.edge_of(h), h);
    for (const Face_index f : old_faces)
      m_editing.after_face(f);
  }

  // OUT OF FACES AND INTO FACES -------------------------------------------------------------------
  // To take a vertex out, the faces around it are replaced by those of a triangulated polygon. To
  // put one in, a face is split, or those in a polygon are replaced. This works for any positions.

  // Fetches what take_out() and put_in() will write.
  void prefetch(const Polygon& polygon) const
  {
    if (m_arrays.number_of_vertices() < min_vertices_to_prefetch)
      return;
    for (const auto& side : polygon.sides()) {
      internal::prefetch(&m_state.positions()[State::vertex_of(side.corner)]);
      m_arrays.prefetch_edge(side.edge);
      m_arrays.prefetch_face(side.outer);
    }
    for (const Edge_index e : polygon.edges())
      m_arrays.prefetch_edge(e);
  }

  // Takes the polygon's center out of all faces, to be put in again. If this throws, the center is
  // still in its faces.
  Slot take_out(const Polygon& polygon)
  {
    return take_out(polygon, [&] { m_editing.before_vertex_relocation(polygon.center()); });
  }

  // Takes out the polygon's center and removes its only point.
  Slot remove(const Polygon& polygon)
  {
    return take_out(polygon, [&] {
      const Vertex_index v = polygon.center();
      m_editing.before_vertex_removal(v);
      m_ids.remove_representative(m_ids.representative(v));
    });
  }

  // Takes out the polygon's center. Its points, which are at p, are covered at `stays` then.
  Slot merge(const Polygon& polygon, Vertex_index stays, const Point& p)
  {
    return take_out(polygon, [&] { hand_points_to(stays, polygon.center(), p); });
  }

  // A face, and its chart as seen from the vertex that is put into it.
  struct Seen_face
  {
    Face_index face;
    Chart chart;
  };

  // Puts the slot's vertex v into a face. Throws nothing after reserve_for_new_edges(6), or after
  // keep_memory_for() if everything is new.
  //
  //     c --------- b         c --------- b
  //     |         /           | \  f   . /      g and k are
  //     |  f    /   ------->  |   \ . ' /       the slot's faces
  //     |     /               | g  v   /
  //     |   /                 |   / k /
  //     | /                   |  / . '
  //     a                     a '
  void put_in(const Slot& slot, const Seen_face& place)
  {
    auto& new_edges = m_changes.new_edges;
    if (!m_changes.everything_is_new)
      reserve_extra(new_edges, 6);
    m_editing.reserve(3);
    m_editing.before_face(place.face);
    m_editing.put_in(slot, place.face, place.chart);
    if (!m_changes.everything_is_new) {
      new_edges.insert(new_edges.end(), slot.edges.begin(), slot.edges.end());
      m_arrays.for_each_corner(slot.vertex,
                               [&](Halfedge_index h) { new_edges.push_back(m_arrays.edge_of(h)); });
    }
    for (const Edge_index e : slot.edges)
      m_editing.after_edge(e);
    for (const Face_index f : {place.face, slot.faces[0], slot.faces[1]})
      m_editing.after_face(f);
  }

  // Puts the center of a polygon into the polygon, which must have faces and edges for it. Throws
  // nothing after reserve_for_new_edges() for as many edges. `Star_polygon_2` has the picture.
  void put_in(const Slot& slot, const Polygon& polygon)
  {
    put_in(slot, polygon, m_changes.new_edges);
  }

  // What a thread can do to the vertices of its part, if the whole polygon belongs to the part.
  class Edit_of_part
  {
  public:
    Slot take_out(const Polygon& polygon)
    {
      return m_editor.take_out(polygon, m_writer, m_changes.edges, [&] {
        m_editor.m_editing.before_vertex_relocation(polygon.center());
      });
    }

    // Removes the center's only point, whose id must stay unused until the parts end.
    Slot remove(const Polygon& polygon)
    {
      reserve_extra(m_changes.gone, 1);
      return m_editor.take_out(polygon, m_writer, m_changes.edges, [&] {
        const Vertex_index v = polygon.center();
        const Point_id id = m_editor.m_ids.representative(v);
        m_editor.m_editing.before_vertex_removal(v);
        m_editor.m_ids.vacate(id);
        m_changes.gone.push_back(id);
      });
    }

    void put_in_new(const Slot& slot, const Polygon& polygon, Point_id id)
    {
      m_editor.reserve_for_star(polygon, m_changes.edges);
      m_editor.m_ids.place_representative(id, slot.vertex);
      m_editor.m_editing.after_vertex_creation(slot.vertex);
      m_editor.put_in(slot, polygon, m_changes.edges);
    }

    void put_in_again(const Slot& slot, const Polygon& polygon)
    {
      m_editor.reserve_for_star(polygon, m_changes.edges);
      reserve_extra(m_changes.relocated, 1);
      m_editor.put_in(slot, polygon, m_changes.edges);
      m_changes.relocated.push_back(slot.vertex);
    }

  private:
    friend Topology_editor_2;
    Edit_of_part(Topology_editor_2& editor, Changes_of_part& changes)
      : m_editor(editor)
      , m_changes(changes)
      , m_writer(editor.m_arrays)
    {
    }

    Topology_editor_2& m_editor;
    Changes_of_part& m_changes;
    Star_writer_2<State> m_writer;
  };

  // Calls f(part, edit) for all parts, which threads share; `most` vertices come or go. If a
  // visitor is heard, there are no threads, and one part follows the other. The result depends on
  // the parts alone.
  template <class Function>
  void edit_in_parts(std::size_t parts, std::size_t most, const Function& f)
  {
    reserve_extra(m_changes.relocated, most);
    run_in_parts(parts, m_editing.is_heard(), [&](std::size_t part, Changes_of_part& changes) {
      Edit_of_part edit(*this, changes);
      f(part, edit);
    });
  }

  // Makes slots with the next numbers and vertices without representatives, the i-th at point(i).
  // Appends them to `made`, which must have the memory. If it throws, nothing has changed.
  template <class Point_of>
  void make_slots(std::size_t number, const Point_of& point, std::vector<Slot>& made)
  {
    m_arrays.reserve_for_slots(number);
    m_ids.reserve_for_vertices(number);
    m_editing.reserve_for_slots(number);
    append_vertices(number, point);
    auto& renumberings = m_changes.renumberings;
    renumberings.vertices.note_appended(Vertex_index(m_arrays.number_of_vertices()));
    renumberings.edges.note_appended(Edge_index(m_arrays.number_of_edges()));
    renumberings.faces.note_appended(Face_index(m_arrays.number_of_faces()));
    m_arrays.template append_slots<Parts>(number, made);
    m_ids.append_vertices(number);
  }

  // Replaces the slot's vertex, which has no representative, by a fresh one at p. If it throws,
  // nothing has changed.
  void renew_vertex(const Slot& slot, const Point& p)
  {
    m_changes.renumberings.vertices.reserve_extra(1);
    m_positions.restart(slot.vertex, p);
    m_editing.renew_vertex(slot.vertex);
    m_changes.renumberings.vertices.note_replacement(slot.vertex);
  }

  // Deletes the vertices of these slots, which have no representatives. The last vertices, edges
  // and faces take the free numbers. No other slots may exist. If it throws, nothing has changed.
  void drop(const std::vector<Slot>& empty_slots)
  {
    collect_numbers(empty_slots, [](auto& numbers) { make_distinct_by_parts<Parts>(numbers); });
    m_changes.renumberings.reserve_for_removals(empty_slots.size());
    drop_collected(); // nothing throws from here on
    auto& new_edges = m_changes.new_edges;
    if (m_changes.everything_is_new) // some of these numbers can no longer be traced
      return new_edges.clear();
    Parts::for_each_element(new_edges.size(),
                            [&](std::size_t i) { new_edges[i] = m_edges_to(new_edges[i]); });
    new_edges.erase(std::remove(new_edges.begin(), new_edges.end(), null_index), new_edges.end());
  }

  // Drops slots if memory has run out. Throws nothing after keep_memory_for(). Everything is new.
  void drop_in_need(const std::vector<Slot>& empty_slots)
  {
    m_changes.everything_is_new = true;
    collect_numbers(empty_slots, [](auto& numbers) { std::sort(numbers.begin(), numbers.end()); });
    drop_collected();
  }

  // Reserves memory to put so many vertices into faces, or to drop their slots, after memory has
  // run out.
  void keep_memory_for(std::size_t number)
  {
    m_editing.keep_memory_for(3 * number);
    m_empty_vertices.reserve(number);
    m_empty_faces.reserve(2 * number);
    m_empty_edges.reserve(3 * number);
    m_vertices_to.reserve(number);
    m_faces_to.reserve(2 * number);
    m_edges_to.reserve(3 * number);
  }

  // IDS AND POINTS ------------------------------------------------------------------------------

  // Reserves the next ids, as given by `Point_ids_2::list_next_ids()`, for points to be inserted.
  // If it throws, nothing has changed. `release_id()` returns an id that was not used.
  void reserve_ids(const std::vector<Point_id>& ids) { m_ids.reserve(ids); }
  void release_id(Point_id id) { m_ids.release(id); }

  // Reserve memory. Then remove_covered(), place_covered(), put_in() and hand_points_to() throw
  // nothing.
  void reserve_for_removals(std::size_t number) { m_ids.reserve_for_removals(number); }
  void reserve_for_covered(std::size_t number) { m_ids.reserve_for_covered(number); }
  void reserve_for_new_edges(std::size_t number)
  {
    reserve_extra(m_changes.new_edges, number);
    m_editing.reserve(2 * number);
  }

  void remove_covered(Point_id id) { m_ids.remove_covered(id); }

  void place_covered(Point_id id, Vertex_index vertex, const Point& p)
  {
    m_ids.place_covered(id, vertex, p);
  }

  // Puts the slot's vertex into a face or a polygon, for the point `id`, which is new or was
  // covered.
  template <class Place>
  void put_in_new(const Slot& slot, const Place& place, Point_id id)
  {
    m_ids.place_representative(id, slot.vertex);
    m_editing.after_vertex_creation(slot.vertex);
    put_in(slot, place);
  }

  // Puts a vertex that was taken out into a face or a polygon.
  template <class Place>
  void put_in_again(const Slot& slot, const Place& place)
  {
    reserve_extra(m_changes.relocated, 1);
    put_in(slot, place);
    m_changes.relocated.push_back(slot.vertex);
  }

  // Makes the points of vertex `goes`, which are at p, covered at vertex `stays`.
  void hand_points_to(Vertex_index stays, Vertex_index goes, const Point& p)
  {
    m_editing.before_vertex_merge(goes, stays);
    m_ids.merge(goes, stays, p);
  }

  // Makes a covered point at v the representative, so that v gets its point. The former
  // representative is covered then, at p. If it throws, nothing has changed.
  void exchange_representative(Point_id covered, Vertex_index v, const Point& p)
  {
    m_editing.reserve_for_id_change(v);
    const Point_id representative = m_ids.representative(v);
    const Point point = m_ids.covered_point(covered);
    const Position_2 before = m_state.positions()[v];
    m_editing.before_id_change(v);
    m_ids.exchange_representative(covered, p);
    m_positions.set(v, point);
    m_editing.after_id_change(v, representative, before);
  }

  // Moves single points. If points of a vertex stay, one of them becomes its representative.
  // Otherwise the vertex moves with its representative.
  void move(const std::vector<Point_id>& ids, const std::vector<Point>& points, bool are_exact)
  {
    m_positions.note_exactness(are_exact);
    if (ids.empty())
      return;
    m_positions.reserve_for_moves(ids.size());
    for (std::size_t i = 0; i < ids.size(); ++i)
      if (!m_ids.is_representative(ids[i]))
        m_ids.covered_point(ids[i]) = points[i];
    for (std::size_t i = 0; i < ids.size(); ++i)
      if (m_ids.is_representative(ids[i]))
        move_representative(ids[i], points[i]);
    m_positions.end_moves();
  }

  // HELD VERTICES -------------------------------------------------------------------------------
  // While an update runs, a vertex may be elsewhere than its point. Faces stay as they are.

  const typename Positions::Stored_point& stored(Vertex_index v) const
  {
    return m_positions.stored(v);
  }
  void place(Vertex_index v, const Position_2& p) { m_positions.place(v, p); }
  // Puts a vertex where it was before it moved; on a torus, where the cell has taken that along.
  void put_to_rest(Vertex_index v) { m_editing.put_to_rest(v); }
  void restore(Vertex_index v, const typename Positions::Stored_point& p)
  {
    m_positions.restore(v, p);
  }

  // STEPS OF A FRAME ------------------------------------------------------------------------------

  // Puts all vertices at this share of their ways, from where they rest to their targets, until
  // arrive(). They must stand at their targets.
  void stop_at(double share)
  {
    // without overflow, whatever the coordinates are; a vertex that rests stays exactly there
    const auto between = [share](double from, double to) {
      return from == to ? from : (from - share * from) + share * to;
    };
    const auto place = [&](Vertex_index v) {
      const Position_2 rest = m_state.rest_position(v), target = m_state.positions()[v];
      return Position_2{between(rest.x, target.x), between(rest.y, target.y)};
    };
    m_positions.template stop_at<Parts>(place);
  }
  // Puts all vertices at their targets; they rest where they have stopped.
  void go_on()
  {
    m_positions.go_on();
    m_editing.rest_in_present_cell();
  }
  // Ends a frame at rest: from now on the call is like one that moves no points.
  void forget_previous() { m_positions.forget_previous(); }
  // Puts all vertices at their targets, if they have stopped.
  void arrive() { m_positions.arrive(); }

private:
  void move_representative(Point_id id, const Point& p)
  {
    const Vertex_index v = m_ids.vertex(id);
    const Point_id successor = m_ids.find_covered_at(
        v, [&](const Point& covered) { return m_state.is_at(covered, v) && !m_state.is_at(p, v); });
    if (successor != null_index)
      return exchange_representative(successor, v, p);
    m_editing.reserve_for_move();
    const Position_2 before = m_state.positions()[v];
    m_positions.move(v, p); // also to the same place: the point may hold more than a position
    m_editing.after_move(v, before);
  }

  // OUT OF FACES AND INTO FACES -------------------------------------------------------------------

  // Appends the data of slots. If it throws, nothing has changed.
  template <class Point_of>
  void append_vertices(std::size_t number, const Point_of& point)
  {
    const std::size_t vertices = m_arrays.number_of_vertices(), faces = m_arrays.number_of_faces();
    try {
      m_positions.template append<Parts>(number, point);
      m_editing.template append_slots<Parts>(number);
    } catch (...) {
      m_positions.resize(vertices);
      m_editing.resize_data(vertices, faces);
      throw;
    }
  }

  auto corner_setter()
  {
    return [this](Halfedge_index h, const typename State::Site& c) { m_editing.set_corner(h, c); };
  }

  void reserve_for_star(const Polygon& polygon, std::vector<Edge_index>& new_edges)
  {
    reserve_extra(new_edges, polygon.edges().size());
    m_editing.reserve(2 * polygon.edges().size());
  }

  void put_in(const Slot& slot, const Polygon& polygon, std::vector<Edge_index>& new_edges)
  {
    CGAL_precondition(polygon.has_star() && polygon.center() == slot.vertex);
    m_editing.reserve(2 * polygon.edges().size());
    for (std::size_t i = 0; i + slot.faces.size() < polygon.faces().size(); ++i)
      m_editing.before_face(polygon.faces()[i]);
    for (std::size_t i = 0; i + slot.edges.size() < polygon.edges().size(); ++i)
      m_editing.before_edge(polygon.edges()[i]);
    m_star_writer.write_star(polygon, corner_setter());
    new_edges.insert(new_edges.end(), polygon.edges().begin(), polygon.edges().end());
    for (const Edge_index e : polygon.edges())
      m_editing.after_edge(e);
    for (const Face_index f : polygon.faces())
      m_editing.after_face(f);
  }

  template <class Vacate>
  Slot take_out(const Polygon& polygon, const Vacate& vacate)
  {
    return take_out(polygon, m_star_writer, m_changes.new_edges, vacate);
  }

  // Calls `vacate()`, which must not throw, after the visitor was told of the faces around the
  // center, and before the center is taken out of them.
  template <class Vacate>
  Slot take_out(const Polygon& polygon, Star_writer_2<State>& writer,
                std::vector<Edge_index>& new_edges, const Vacate& vacate)
  {
    CGAL_precondition(!m_arrays.is_outside(polygon.center()));
    CGAL_precondition(polygon.is_triangulated());
    const std::size_t degree = polygon.sides().size();
    reserve_extra(new_edges, degree);
    m_editing.reserve(2 * degree);
    writer.reserve(polygon); // nothing throws from here on
    for (const Face_index f : polygon.faces())
      m_editing.before_face(f);
    for (const Edge_index e : polygon.edges())
      m_editing.before_edge(e);
    vacate();
    const Slot slot = writer.write_ears(polygon, corner_setter());
    writer.for_each_edge_of_ears(polygon, [&](Edge_index e) { new_edges.push_back(e); });
    for (std::size_t i = 0; i + 3 < degree; ++i)
      m_editing.after_edge(polygon.edges()[i]);
    for (std::size_t i = 0; i + 2 < degree; ++i)
      m_editing.after_face(polygon.faces()[i]);
    return slot;
  }

  // Collects the numbers of these slots, sorts them, and finds who takes them.
  template <class Sort>
  void collect_numbers(const std::vector<Slot>& empty_slots, const Sort& sort)
  {
    const std::size_t number = empty_slots.size();
    m_empty_vertices.resize(number);
    m_empty_faces.resize(2 * number);
    m_empty_edges.resize(3 * number);
    Parts::for_each_element(number, Parts::size_for(8), [&](std::size_t i) {
      const Slot& slot = empty_slots[i];
      m_empty_vertices[i] = slot.vertex;
      std::copy(slot.faces.begin(), slot.faces.end(), &m_empty_faces[2 * i]);
      std::copy(slot.edges.begin(), slot.edges.end(), &m_empty_edges[3 * i]);
    });
    sort(m_empty_vertices);
    sort(m_empty_faces);
    sort(m_empty_edges);
    m_vertices_to.template assign<Parts>(m_arrays.number_of_vertices(), m_empty_vertices);
    m_faces_to.template assign<Parts>(m_arrays.number_of_faces(), m_empty_faces);
    m_edges_to.template assign<Parts>(m_arrays.number_of_edges(), m_empty_edges);
  }

  // Gives the collected numbers to the last elements: one by one, or if they are many, in passes
  // over everything.
  void drop_collected()
  {
    auto& renumberings = m_changes.renumberings;
    if (!m_changes.everything_is_new) {
      m_faces_to.for_each_from_last(
          [&](Face_index last, Face_index to) { renumberings.faces.note_move(last, to); });
      m_edges_to.for_each_from_last(
          [&](Edge_index last, Edge_index to) { renumberings.edges.note_move(last, to); });
      m_vertices_to.for_each_from_last(
          [&](Vertex_index last, Vertex_index to) { renumberings.vertices.note_move(last, to); });
    }
    constexpr std::size_t many = 128; // one of so many
    const std::size_t vertices = m_arrays.number_of_vertices();
    if (Parts::number(vertices) >= Parts::least_shared &&
        m_empty_vertices.size() >= vertices / many)
      m_arrays.template fill<Parts>(m_faces_to, m_edges_to, m_vertices_to);
    else {
      m_faces_to.for_each_from_last(
          [this](Face_index, Face_index to) { m_arrays.move_last_face_to(to); });
      m_edges_to.for_each_from_last(
          [this](Edge_index, Edge_index to) { m_arrays.move_last_edge_to(to); });
      m_vertices_to.for_each_from_last(
          [this](Vertex_index, Vertex_index to) { m_arrays.move_last_vertex_to(to); });
    }
    m_editing.template fill<Parts>(m_faces_to, m_vertices_to);
    m_vertices_to.template for_each_move<Parts>([this](Vertex_index from, Vertex_index to) {
      m_ids.move_points(from, to);
      m_positions.copy(from, to);
    });
    m_ids.resize(m_vertices_to.number_kept() - 1);
    m_positions.forget_previous();
    m_positions.resize(m_vertices_to.number_kept());
  }

  // REPLACING -----------------------------------------------------------------------------------

  void collect_inner_edges(const Index_set<Face_index>& faces)
  {
    m_inner_edges.clear();
    for (const Face_index f : faces)
      for (const Halfedge_index h : Halfedge_arrays_2::halfedges_of(f))
        if (h < m_arrays.twin(h) && faces.contains(Halfedge_arrays_2::face_of(m_arrays.twin(h))))
          m_inner_edges.push_back(m_arrays.edge_of(h));
  }

  // IN PARTS ------------------------------------------------------------------------------------

  // Calls f(part, changes) for all parts, and then logs their changes.
  template <class Function>
  void run_in_parts(std::size_t parts, bool is_one_after_other, const Function& f)
  {
    m_changes_of_parts.resize((std::max)(parts, m_changes_of_parts.size()));
    const auto run_part = [&](std::size_t part) { f(part, m_changes_of_parts[part]); };
    const auto log_all = [&] {
      log_new_edges(parts);
      std::size_t gone = 0;
      for (std::size_t part = 0; part < parts; ++part) {
        gone += m_changes_of_parts[part].gone.size();
        log(m_changes_of_parts[part]);
      }
      m_ids.end_releases(gone);
    };
    try {
      if (is_one_after_other)
        for (std::size_t part = 0; part < parts; ++part)
          run_part(part);
      else
        Parts::run(parts, run_part);
    } catch (...) {
      log_all();
      throw;
    }
    log_all();
  }

  bool try_flip(const Topology_parts_2& topology, std::size_t part, bool no_edge_doubles,
                Halfedge_index h, Changes_of_part& changes)
  {
    const Edge_index e = m_arrays.edge_of(h);
    if (!topology.is_inside(part, e) || !(no_edge_doubles || can_flip(h)))
      return false;
    m_editing.reserve(changes.log, 2);
    changes.edges.push_back(e);
    m_editing.flip(h, changes.log); // throws nothing
    return true;
  }

  // Logs the new edges of all parts. If their list cannot grow, everything counts as new.
  void log_new_edges(std::size_t parts)
  {
    const auto edges = [this](std::size_t part) -> const auto&
    {
      return m_changes_of_parts[part].edges;
    };
    try {
      append_lists<Parts>(parts, edges, m_changes.new_edges);
    } catch (const std::bad_alloc&) {
      m_changes.everything_is_new = true;
    }
  }

  // Logs the other changes in a part.
  void log(Changes_of_part& changes)
  {
    m_changes.relocated.insert(m_changes.relocated.end(), changes.relocated.begin(),
                               changes.relocated.end());
    m_ids.release(changes.gone);
    m_editing.append(changes.log);
    changes.edges.clear();
    changes.relocated.clear();
    changes.gone.clear();
  }

  const State& m_state;
  Editing m_editing;
  Writable_halfedge_arrays_2& m_arrays;
  typename State::Ids& m_ids;
  Positions& m_positions;
  Change_log_2& m_changes;
  Star_writer_2<State> m_star_writer;
  std::vector<Edge_index> m_inner_edges;
  std::vector<Changes_of_part> m_changes_of_parts;
  std::vector<Vertex_index> m_empty_vertices; // to be dropped, like the following
  std::vector<Face_index> m_empty_faces;
  std::vector<Edge_index> m_empty_edges;
  Filled_gaps<Vertex_index> m_vertices_to; // who takes their numbers
  Filled_gaps<Face_index> m_faces_to;
  Filled_gaps<Edge_index> m_edges_to;
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_TOPOLOGY_TOPOLOGY_EDITOR_2_H

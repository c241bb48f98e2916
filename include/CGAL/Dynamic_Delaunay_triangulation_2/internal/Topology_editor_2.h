// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_TOPOLOGY_EDITOR_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_TOPOLOGY_EDITOR_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Flat_arrays_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Maintained_triangulation_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Neighborhood_mirror_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Processor_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Star_polygon_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Topology_parts_2.h>
#include <CGAL/Triangulation_utils_2.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <new>
#include <utility>
#include <vector>

namespace CGAL {
namespace Dynamic_Delaunay_triangulations_2 {
namespace internal {

// A directed edge on the boundary of a set of faces. The set is on its left.
struct Boundary_edge_2
{
  Index source, target, halfedge;

  bool operator<(const Boundary_edge_2& other) const
  {
    return source != other.source ? source < other.source : target < other.target;
  }
};

// A set of faces on its own. Half-edge 3k+i is opposite to vertex i of its k-th face, as in the
// mirror. Half-edges on the boundary have no twin.
struct Patch_2
{
  std::vector<Index> apexes;
  std::vector<Index> twins;
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
    using Mirror = Neighborhood_mirror_2;
    boundary.clear();
    for (Index h = 0; h < Index(twins.size()); ++h)
      if (twins[h] == no_index)
        boundary.push_back({apexes[Mirror::next(h)], apexes[Mirror::previous(h)], h});
    std::sort(boundary.begin(), boundary.end());
  }
};

// Writes parts of the topology; `Topology_builder_2` writes the whole, and nothing else can write.
// Each operation changes the CGAL triangulation and the mirror together, keeps all vertex handles,
// logs the new edges, and calls the user's visitor.
template <class Maintained>
class Topology_editor_2
{
  using Topology = typename Maintained::Topology;
  using Positions = typename Maintained::Positions;
  using Point = typename Maintained::Point;
  using Vertex_handle = typename Maintained::Vertex_handle;
  using Face_handle = typename Maintained::Face_handle;
  using Edge = typename Maintained::Triangulation::Edge;

public:
  using Slot = Neighborhood_mirror_2::Slot;

  explicit Topology_editor_2(Maintained& maintained)
    : m_maintained(maintained)
    , m_topology(maintained.m_topology)
    , m_positions(maintained.m_positions)
  {
  }

  // THE VISITOR AND THE LOG OF CHANGES ----------------------------------------------------------

  // From here on the visitor is called.
  template <class Visitor, class Dynamic>
  void start_visit(Visitor& visitor, const Dynamic* dynamic)
  {
    m_topology.m_visitor_calls.start(visitor, dynamic);
  }

  // Throws the visitor's first exception, if any.
  void finish_visit() { m_topology.m_visitor_calls.finish(); }

  // Begins an update. Changes of the last one that the classifier was not told stay in the log.
  void begin_changes(bool is_classifier_informed)
  {
    Change_log_2& changes = m_topology.m_changes;
    if (is_classifier_informed)
      changes.clear();
    else if (!changes.renumberings.are_none()) // another renumbering will follow
      changes.everything_is_new = true;
    if (changes.everything_is_new)
      changes.new_edges.clear();
  }

  // Ends an update. Each new edge is in the log once afterwards.
  void end_changes() { make_distinct(m_topology.m_changes.new_edges); }

  void note_everything_is_new() { m_topology.m_changes.everything_is_new = true; }

  // Reports examined edges to a heuristic classifier as if they were new.
  void note_examined(const std::vector<Index>& edges)
  {
    auto& new_edges = m_topology.m_changes.new_edges;
    new_edges.insert(new_edges.end(), edges.begin(), edges.end());
  }

  // FLIPS ---------------------------------------------------------------------------------------

  // Refuses flips that would double an edge, because the vertices of an edge identify it in
  // simplicial complexes. Among these are all flips at vertices of degree 3. Counterclockwise faces
  // at the edge do not exclude them, because other faces may overlap these.
  bool can_flip(Index h) const { return !m_topology.m_mirror.are_apexes_neighbors(h); }

  // Calls f(flip), where flip(h) exchanges the diagonal at half-edge h. The mirror is flipped at
  // once. CGAL's structure is flipped when f ends, also by an exception, in the same order: the
  // data of these flips are scattered over the memory, and a separate loop can prefetch them.
  template <class Function>
  void flip_in_series(const Function& f)
  {
    const auto flip = [this](Index h) {
      provide(m_flipped, 1);
      m_topology.m_changes.new_edges.push_back(m_topology.m_mirror.edge_of(h));
      m_flipped.push_back(m_topology.m_mirror.flip(h)); // throws nothing
    };
    try {
      f(flip);
    } catch (...) {
      visit_and_write_flips(m_flipped);
      throw;
    }
    visit_and_write_flips(m_flipped);
  }

  // Calls f(part, try_flip) for all parts of `topology`, which threads share. try_flip(h) returns
  // whether the edge of half-edge h is inside of the part and its flip doubles no edge, which it
  // cannot if `no_edge_doubles`, and flips it if so: at most `most` times in all. CGAL's structure
  // is flipped at the end of each part, or, where a visitor hears of it, part by part at the end.
  // The result depends on the parts alone.
  template <class Function>
  void flip_in_parts(const Topology_parts_2& topology, std::size_t parts, bool no_edge_doubles,
                     std::size_t, const Function& f)
  {
    m_flipped_in_parts.resize((std::max)(parts, m_flipped_in_parts.size()));
    const auto finish = [&] {
      for (std::size_t part = 0; part < parts; ++part)
        finish_part(m_flipped_in_parts[part]);
    };
    try {
      Maintained::Parts::run(parts, [&](std::size_t part) {
        flip_part(topology, part, no_edge_doubles, m_flipped_in_parts[part], f);
      });
    } catch (...) {
      finish();
      throw;
    }
    finish();
  }

  // Replaces `old_faces` by the faces of `patch`. Both have equal numbers of faces and equal
  // boundaries. The half-edge outside the i-th edge of the patch's boundary is `outside[i]`.
  void replace(const Index_set_2& old_faces, const Patch_2& patch,
               const std::vector<Index>& outside)
  {
    CGAL_precondition(old_faces.size() == patch.number_of_faces());
    CGAL_precondition(outside.size() == patch.boundary.size());
    collect_inner_edges(old_faces);
    auto& new_edges = m_topology.m_changes.new_edges;
    new_edges.insert(new_edges.end(), m_inner_edges.begin(), m_inner_edges.end());
    for (const Index f : old_faces) // nothing throws from here on
      m_topology.m_visitor_calls.before_face_removal(m_topology.m_faces[f]);
    write_faces(old_faces, patch);
    auto& mirror = m_topology.m_mirror;
    const auto global = [&](Index h) { return 3 * old_faces[h / 3] + h % 3; };
    for (Index h = 0; h < Index(patch.twins.size()); ++h)
      if (patch.twins[h] != no_index && h < patch.twins[h])
        link(global(h), global(patch.twins[h]));
    for (std::size_t i = 0; i < outside.size(); ++i)
      link(global(patch.boundary[i].halfedge), outside[i]);
    auto edge = m_inner_edges.begin();
    for (Index h = 0; h < Index(patch.twins.size()); ++h)
      if (patch.twins[h] != no_index && h < patch.twins[h])
        mirror.set_edge(*edge++, global(h));
    for (const Index h : outside)
      mirror.set_edge(mirror.edge_of(h), h);
    for (const Index f : old_faces)
      m_topology.m_visitor_calls.after_face_creation(m_topology.m_faces[f]);
  }

  // Fetches what replace() will write for these faces and vertices: first handles, to be called
  // some time before, then what they refer to.
  void prefetch_handles(const std::vector<Index>& faces, const std::vector<Index>& vertices) const
  {
    for (const Index f : faces) {
      prefetch(&m_topology.m_faces[f]);
      m_topology.m_mirror.prefetch_face(3 * f);
    }
    for (const Index v : vertices)
      prefetch(&m_topology.m_vertices[v]);
  }
  void prefetch_faces(const std::vector<Index>& faces, const std::vector<Index>& vertices) const
  {
    const auto& mirror = m_topology.m_mirror;
    for (const Index f : faces) {
      prefetch_face(m_topology.m_faces[f]);
      for (Index h = 3 * f; h < 3 * f + 3; ++h)
        mirror.prefetch_edge(mirror.edge_of(h));
    }
    for (const Index v : vertices)
      prefetch(&*m_topology.m_vertices[v]);
  }

  // Fetches what take_out() will write around v: first handles, to be called some time before, then
  // what they refer to.
  void prefetch_handles_around(Index v) const
  {
    const auto& mirror = m_topology.m_mirror;
    mirror.for_each_corner(v, [&](Index h) {
      prefetch(&m_topology.m_faces[h / 3]);
      prefetch(&m_topology.m_vertices[mirror.source(h)]);
      prefetch(&m_maintained.positions()[mirror.source(h)]);
      mirror.prefetch_edge(mirror.edge_of(h));
      mirror.prefetch_edge(mirror.edge_of(Neighborhood_mirror_2::next(h)));
      mirror.prefetch_face(mirror.twin(h));
    });
  }
  void prefetch_faces_around(Index v) const
  {
    const auto& mirror = m_topology.m_mirror;
    mirror.for_each_corner(v, [&](Index h) {
      prefetch_face(m_topology.m_faces[h / 3]);
      prefetch(&m_topology.m_faces[mirror.twin(h) / 3]);
      prefetch(&*m_topology.m_vertices[mirror.source(h)]);
    });
  }

  // OUT OF FACES AND INTO FACES -------------------------------------------------------------------
  // To take a vertex out, the faces around it are replaced by those of a triangulated polygon. To
  // put one in, a face is split. Both work for any positions.

  // Fetches what take_out() will write, in two steps as above, if there are many vertices.
  void prefetch_handles(const Star_polygon_2& polygon) const
  {
    if (m_topology.m_vertices.size() < min_vertices_to_prefetch)
      return;
    for (const Index f : polygon.faces())
      prefetch(&m_topology.m_faces[f]);
    for (const Star_polygon_2::Side& side : polygon.sides()) {
      prefetch(&m_topology.m_faces[side.outer / 3]);
      prefetch(&m_topology.m_vertices[side.corner]);
      prefetch(&m_positions.positions()[side.corner]);
      m_topology.m_mirror.prefetch_edge(side.edge);
    }
    for (const Index e : polygon.edges())
      m_topology.m_mirror.prefetch_edge(e);
  }
  void prefetch_faces(const Star_polygon_2& polygon) const
  {
    if (m_topology.m_vertices.size() < min_vertices_to_prefetch)
      return;
    for (const Index f : polygon.faces())
      prefetch_face(m_topology.m_faces[f]);
    for (const Star_polygon_2::Side& side : polygon.sides()) {
      prefetch_face(m_topology.m_faces[side.outer / 3]);
      prefetch(&*m_topology.m_vertices[side.corner]);
    }
  }

  // Takes the polygon's center out of all faces, to be put in again. If this throws, it is still in
  // its faces.
  Slot take_out(const Star_polygon_2& polygon)
  {
    const Index v = polygon.center();
    return take_out(polygon, [&] {
      m_topology.m_visitor_calls.before_vertex_relocation(m_topology.m_vertices[v],
                                                          m_topology.m_ids.representative(v));
    });
  }

  // The same for a vertex whose only point is removed.
  Slot remove(const Star_polygon_2& polygon)
  {
    const Index v = polygon.center();
    return take_out(polygon, [&] {
      const Index id = m_topology.m_ids.representative(v);
      m_topology.m_visitor_calls.before_vertex_removal(m_topology.m_vertices[v], id);
      m_topology.m_ids.remove_representative(id);
    });
  }

  // The same for a vertex whose points, at p, become duplicates at another vertex.
  Slot merge(const Star_polygon_2& polygon, Index stays, const Point& p)
  {
    return take_out(polygon, [&] { hand_points_to(stays, polygon.center(), p); });
  }

  // Puts the slot's vertex into a face. Throws nothing if everything is new, or if there is memory
  // for six new edges.
  void put_in(const Slot& slot, Index f)
  {
    auto& mirror = m_topology.m_mirror;
    auto& new_edges = m_topology.m_changes.new_edges;
    if (!m_topology.m_changes.everything_is_new)
      provide(new_edges, 6);
    auto& visitor_calls = m_topology.m_visitor_calls;
    visitor_calls.before_face_removal(m_topology.m_faces[f]);
    mirror.put_in(slot, f);
    const std::array<Index, 3> faces{f, slot.faces[0], slot.faces[1]};
    for (const Index g : faces)
      write_face(g);
    if (!m_topology.m_changes.everything_is_new) {
      new_edges.insert(new_edges.end(), slot.edges.begin(), slot.edges.end());
      mirror.for_each_corner(slot.vertex, [&](Index h) { new_edges.push_back(mirror.edge_of(h)); });
    }
    for (const Index g : faces)
      visitor_calls.after_face_creation(m_topology.m_faces[g]);
  }

  // Puts the center of a polygon that has faces and edges for it in their place. Throws nothing if
  // there is memory for as many new edges.
  void put_in(const Slot& slot, const Star_polygon_2& polygon)
  {
    CGAL_precondition(polygon.has_star() && polygon.center() == slot.vertex);
    auto& new_edges = m_topology.m_changes.new_edges;
    auto& visitor_calls = m_topology.m_visitor_calls;
    for (std::size_t i = 0; i + slot.faces.size() < polygon.faces().size(); ++i)
      visitor_calls.before_face_removal(m_topology.m_faces[polygon.faces()[i]]);
    write_star(polygon);
    new_edges.insert(new_edges.end(), polygon.edges().begin(), polygon.edges().end());
    for (const Index f : polygon.faces())
      visitor_calls.after_face_creation(m_topology.m_faces[f]);
  }

  // Makes a slot with the next numbers and a vertex at p without representative. If it throws,
  // nothing has changed.
  Slot make_slot(const Point& p)
  {
    auto& mirror = m_topology.m_mirror;
    auto& tds = m_topology.m_triangulation.tds();
    mirror.provide_for_slot();
    m_topology.m_ids.provide_for_vertex();
    provide(m_topology.m_faces, 2);
    append_vertex(p);
    std::array<Face_handle, 2> faces;
    try {
      faces[0] = tds.create_face();
      try {
        faces[1] = tds.create_face();
      } catch (...) {
        tds.delete_face(faces[0]);
        throw;
      }
    } catch (...) {
      drop_last_vertex();
      throw;
    }
    const Slot slot = mirror.append_slot();
    m_topology.m_ids.append_vertex();
    m_topology.m_changes.renumberings.vertices.note_appended(slot.vertex);
    m_topology.m_changes.renumberings.edges.note_appended(slot.edges[0]);
    m_topology.m_changes.renumberings.faces.note_appended(slot.faces[0]);
    m_topology.m_faces.push_back(faces[0]);
    m_topology.m_faces.push_back(faces[1]);
    return slot;
  }

  // Replaces the slot's vertex, which has no representative, by a fresh one at p. If it throws,
  // nothing has changed.
  void renew_vertex(const Slot& slot, const Point& p)
  {
    auto& tds = m_topology.m_triangulation.tds();
    m_topology.m_changes.renumberings.vertices.provide(1);
    const Vertex_handle fresh = tds.create_vertex();
    try {
      fresh->set_point(p);
      m_positions.stage(slot.vertex, p);
    } catch (...) {
      tds.delete_vertex(fresh);
      throw;
    }
    fresh->set_mirror_index(slot.vertex);
    tds.delete_vertex(std::exchange(m_topology.m_vertices[slot.vertex], fresh));
    m_topology.m_changes.renumberings.vertices.note_replacement(slot.vertex);
  }

  // Deletes the vertices of these slots, which have no representatives. The last vertices, edges
  // and faces take the free numbers. No other slots may exist. If it throws, nothing has changed.
  void drop(const std::vector<Slot>& empty_slots)
  {
    collect_numbers(empty_slots);
    const std::size_t kept_edges = m_topology.m_mirror.number_of_edges() - m_empty_edges.size();
    m_number_of_edge.assign(m_empty_edges.size(), no_index); // from `kept_edges` on
    m_topology.m_changes.renumberings.provide_for_removals(empty_slots.size());
    const auto note = [&](Index from, Index to) { m_number_of_edge[from - kept_edges] = to; };
    drop_collected(note); // nothing throws from here on
    auto& new_edges = m_topology.m_changes.new_edges;
    if (m_topology.m_changes.everything_is_new) // some of these numbers can no longer be traced
      return new_edges.clear();
    for (Index& e : new_edges)
      while (e != no_index && e >= kept_edges)
        e = m_number_of_edge[e - kept_edges];
    new_edges.erase(std::remove(new_edges.begin(), new_edges.end(), no_index), new_edges.end());
  }

  // The same if memory has run out: throws nothing, and everything is new.
  void drop_in_need(const std::vector<Slot>& empty_slots)
  {
    m_topology.m_changes.everything_is_new = true;
    collect_numbers(empty_slots);
    drop_collected([](Index, Index) {});
  }

  // Reserves memory for drop_in_need() with so many slots.
  void provide_for_drop(std::size_t number)
  {
    m_empty_vertices.reserve(number);
    m_empty_faces.reserve(2 * number);
    m_empty_edges.reserve(3 * number);
  }

  // IDS AND POINTS ------------------------------------------------------------------------------

  // Reserves the next ids, as given by `Point_ids_2::list_next_ids()`, for points to be inserted.
  // If it throws, nothing has changed. `release_id()` returns an id that was not used.
  void reserve_ids(const std::vector<Index>& ids) { m_topology.m_ids.reserve(ids); }
  void release_id(Index id) { m_topology.m_ids.release(id); }

  // Reserve memory. Then the functions below throw nothing.
  void provide_for_removals(std::size_t number) { m_topology.m_ids.provide_for_removals(number); }
  void provide_for_duplicates(std::size_t number)
  {
    m_topology.m_ids.provide_for_duplicates(number);
  }
  void provide_for_new_edges(std::size_t number)
  {
    provide(m_topology.m_changes.new_edges, number);
  }

  void remove_duplicate(Index id) { m_topology.m_ids.remove_duplicate(id); }

  void place_duplicate(Index id, Index vertex, const Point& p)
  {
    m_topology.m_ids.place_duplicate(id, vertex, p);
  }

  // Puts the slot's vertex into a face or a polygon, for the point `id`, which is new or was a
  // duplicate.
  template <class Place>
  void put_in_new(const Slot& slot, const Place& place, Index id)
  {
    m_topology.m_ids.place_representative(id, slot.vertex);
    m_topology.m_visitor_calls.after_vertex_creation(m_topology.m_vertices[slot.vertex], id);
    put_in(slot, place);
  }

  // Puts a vertex that was taken out into a face or a polygon.
  template <class Place>
  void put_in_again(const Slot& slot, const Place& place)
  {
    provide(m_topology.m_changes.relocated, 1);
    put_in(slot, place);
    m_topology.m_changes.relocated.push_back(slot.vertex);
  }

  // Makes the points of vertex `goes`, which are at p, duplicates at vertex `stays`.
  void hand_points_to(Index stays, Index goes, const Point& p)
  {
    auto& ids = m_topology.m_ids;
    m_topology.m_visitor_calls.before_vertex_merge(
        m_topology.m_vertices[goes], ids.representative(goes), m_topology.m_vertices[stays]);
    ids.merge(goes, stays, p);
  }

  // Makes a duplicate at v the representative, so that v has its point. The representative becomes
  // a duplicate at p.
  void hand_over(Index duplicate, Index v, const Point& p)
  {
    const Index representative = m_topology.m_ids.representative(v);
    const Point point = m_topology.m_ids.duplicate(duplicate).point;
    m_topology.m_ids.hand_over(duplicate, p);
    m_positions.stage(v, point);
    if (m_positions.m_are_written)
      m_topology.m_vertices[v]->set_point(point);
    m_topology.m_visitor_calls.after_id_change(m_topology.m_vertices[v], representative);
  }

  // Stages points that move alone. If points of a vertex stay, one of them becomes its
  // representative. Otherwise the vertex moves with its representative.
  void stage_moved(const std::vector<Index>& ids, const std::vector<Point>& points, bool are_exact)
  {
    m_positions.m_are_exact &= are_exact;
    if (ids.empty())
      return;
    provide_for_duplicates(ids.size());
    m_positions.m_are_written = false;
    for (std::size_t i = 0; i < ids.size(); ++i)
      if (!m_topology.m_ids.is_representative(ids[i]))
        m_topology.m_ids.duplicate(ids[i]).point = points[i];
    for (std::size_t i = 0; i < ids.size(); ++i)
      if (m_topology.m_ids.is_representative(ids[i]))
        stage_representative(ids[i], points[i]);
  }

private:
  void stage_representative(Index id, const Point& p)
  {
    const auto& ids = m_topology.m_ids;
    const Index v = ids.vertex(id);
    const Point place = m_maintained.point(v);
    const auto is_at = [this](const Point& q, const Point& r) {
      return coincide(m_maintained.traits(), q, r);
    };
    const Index successor = is_at(p, place) || ids.duplicates().empty()
                                ? no_index
                                : ids.find_duplicate_at(v, [&](const auto& duplicate) {
                                    return is_at(duplicate.point, place);
                                  });
    if (successor == no_index)
      return m_positions.stage(v, p); // the point may hold more than a position
    const Point point_of_successor = ids.duplicate(successor).point;
    hand_over(successor, v, p);
    m_topology.m_vertices[v]->set_point(point_of_successor);
  }

  // VERTICES ------------------------------------------------------------------------------------

  // Appends a vertex at p, with the next number, without faces and without points. If it throws,
  // nothing has changed.
  void append_vertex(const Point& p)
  {
    auto& vertices = m_topology.m_vertices;
    provide(vertices, 1);
    m_positions.provide_for_vertex();
    const Vertex_handle vertex = m_topology.m_triangulation.tds().create_vertex();
    vertex->set_mirror_index(Index(vertices.size()));
    vertices.push_back(vertex);
    try {
      vertex->set_point(p);
      m_positions.append(p);
    } catch (...) {
      drop_last_vertex();
      throw;
    }
  }

  // Reverts append_vertex().
  void drop_last_vertex()
  {
    m_topology.m_triangulation.tds().delete_vertex(m_topology.m_vertices.back());
    m_topology.m_vertices.pop_back();
    m_positions.resize(m_topology.m_vertices.size());
  }

  // OUT OF FACES AND INTO FACES -------------------------------------------------------------------

  // `vacate()`, which must not throw, is called before the center leaves its faces, after the
  // visitor was told of them.
  template <class Vacate>
  Slot take_out(const Star_polygon_2& polygon, const Vacate& vacate)
  {
    CGAL_precondition(!m_topology.m_mirror.is_outside(polygon.center()));
    CGAL_precondition(polygon.is_triangulated());
    auto& visitor_calls = m_topology.m_visitor_calls;
    const std::size_t degree = polygon.sides().size();
    provide(m_topology.m_changes.new_edges, degree);
    m_open_sides.resize(degree); // nothing throws from here on
    for (const Index f : polygon.faces())
      visitor_calls.before_face_removal(m_topology.m_faces[f]);
    vacate();
    write_ears(polygon);
    const Slot slot = slot_left_by(polygon);
    m_topology.m_mirror.empty(slot);
    log_ears(polygon);
    for (std::size_t i = 0; i + 2 < degree; ++i)
      visitor_calls.after_face_creation(m_topology.m_faces[polygon.faces()[i]]);
    return slot;
  }

  // A side of a polygon while ears are cut off: the half-edge outside of it, and its edge.
  struct Open_side
  {
    Index outer, edge;
  };

  // The i-th ear gets the i-th face, and what it leaves the i-th edge.
  void write_ears(const Star_polygon_2& polygon)
  {
    const auto& sides = polygon.sides();
    const auto& ears = polygon.ears();
    for (std::size_t i = 0; i < sides.size(); ++i)
      m_open_sides[i] = {sides[i].outer, sides[i].edge};
    for (std::size_t i = 0; i < ears.size(); ++i) {
      const Star_polygon_2::Ear& ear = ears[i];
      const Index f = polygon.faces()[i];
      write_vertex(3 * f, sides[ear.before].corner);
      write_vertex(3 * f + 1, sides[ear.tip].corner);
      write_vertex(3 * f + 2, sides[ear.after].corner);
      close(m_open_sides[ear.before], 3 * f + 2);
      close(m_open_sides[ear.tip], 3 * f);
      m_open_sides[ear.before] = {3 * f + 1, polygon.edges()[i]};
    }
    // the last ear is a triangle that has a side of the polygon for its third edge
    const Star_polygon_2::Ear& last = ears.back();
    close(m_open_sides[last.after], 3 * polygon.faces()[ears.size() - 1] + 1);
  }

  // Puts v at the apex of half-edge h, in both structures.
  void write_vertex(Index h, Index v)
  {
    const Face_handle f = m_topology.m_faces[h / 3];
    m_topology.m_mirror.set_apex(h, v);
    f->set_vertex(int(h % 3), m_topology.m_vertices[v]);
    m_topology.m_vertices[v]->set_face(f);
  }

  // Makes h, whose face has its vertices, the other half-edge of an open side.
  void close(const Open_side& side, Index h)
  {
    link(h, side.outer);
    m_topology.m_mirror.set_edge(side.edge, h);
  }

  // The numbers that write_ears() does not use.
  static Slot slot_left_by(const Star_polygon_2& polygon)
  {
    const auto face = polygon.faces().end();
    const auto edge = polygon.edges().end();
    return {polygon.center(), {face[-2], face[-1]}, {edge[-3], edge[-2], edge[-1]}};
  }

  // Logs all edges of the last face: it has no new one if it is the only face.
  void log_ears(const Star_polygon_2& polygon)
  {
    auto& new_edges = m_topology.m_changes.new_edges;
    const auto& edges = polygon.edges();
    new_edges.insert(new_edges.end(), edges.begin(), edges.end() - 3);
    const Index last = polygon.faces()[polygon.ears().size() - 1];
    for (Index h = 3 * last; h < 3 * last + 3; ++h)
      new_edges.push_back(m_topology.m_mirror.edge_of(h));
  }

  // The i-th side gets the i-th face, and the edge to its end the i-th edge.
  void write_star(const Star_polygon_2& polygon)
  {
    auto& mirror = m_topology.m_mirror;
    const auto& sides = polygon.sides();
    const Index v = polygon.center();
    const std::size_t degree = sides.size();
    for (std::size_t i = 0; i < degree; ++i) {
      const Index h = 3 * polygon.faces()[i];
      write_vertex(h, v);
      write_vertex(h + 1, sides[i].corner);
      write_vertex(h + 2, sides[i + 1 < degree ? i + 1 : 0].corner);
    }
    for (std::size_t i = 0; i < degree; ++i) {
      const Index h = 3 * polygon.faces()[i];
      close({sides[i].outer, sides[i].edge}, h);
      link(h + 1, 3 * polygon.faces()[i + 1 < degree ? i + 1 : 0] + 2);
      mirror.set_edge(polygon.edges()[i], h + 1);
    }
  }

  // Sorts the numbers in descending order. Then the last element is never empty, unless it is the
  // one to remove.
  void collect_numbers(const std::vector<Slot>& empty_slots)
  {
    m_empty_vertices.clear();
    m_empty_faces.clear();
    m_empty_edges.clear();
    for (const Slot& slot : empty_slots) {
      m_empty_vertices.push_back(slot.vertex);
      for (const Index f : slot.faces)
        m_empty_faces.push_back(f);
      for (const Index e : slot.edges)
        m_empty_edges.push_back(e);
    }
    for (std::vector<Index>* numbers : {&m_empty_vertices, &m_empty_faces, &m_empty_edges})
      std::sort(numbers->begin(), numbers->end(), std::greater<Index>());
  }

  // Calls `note(from, to)` when edge `from` takes the number `to`.
  template <class Note>
  void drop_collected(const Note& note)
  {
    auto& mirror = m_topology.m_mirror;
    auto& renumberings = m_topology.m_changes.renumberings;
    const bool are_noted = !m_topology.m_changes.everything_is_new;
    for (const Index f : m_empty_faces) {
      if (are_noted)
        renumberings.faces.note_move(mirror.number_of_faces() - 1, f);
      m_topology.m_triangulation.tds().delete_face(m_topology.m_faces[f]);
      m_topology.m_faces[f] = m_topology.m_faces.back();
      m_topology.m_faces.pop_back();
      mirror.move_last_face_to(f);
    }
    for (const Index e : m_empty_edges) {
      const Index last = mirror.number_of_edges() - 1;
      if (are_noted)
        renumberings.edges.note_move(last, e);
      if (last != e)
        note(last, e);
      mirror.move_last_edge_to(e);
    }
    for (const Index v : m_empty_vertices) {
      if (are_noted)
        renumberings.vertices.note_move(m_maintained.number_of_vertices(), v);
      const Vertex_handle vertex = m_topology.m_vertices[v];
      mirror.move_last_vertex_to(v);
      m_topology.m_ids.move_last_vertex_to(v);
      m_topology.m_vertices[v] = m_topology.m_vertices.back();
      m_topology.m_vertices[v]->set_mirror_index(v);
      m_topology.m_vertices.pop_back();
      m_positions.move_last_to(v);
      m_topology.m_triangulation.tds().delete_vertex(vertex);
    }
  }

  // Writes face f, and its neighbors' references to it, into CGAL's structure.
  void write_face(Index f)
  {
    for (Index h = 3 * f; h < 3 * f + 3; ++h) {
      write_vertex(h);
      write_neighbors(h);
      m_topology.m_vertices[m_topology.m_mirror.apex(h)]->set_face(m_topology.m_faces[f]);
    }
  }

  // REPLACING -----------------------------------------------------------------------------------

  void collect_inner_edges(const Index_set_2& faces)
  {
    const auto& mirror = m_topology.m_mirror;
    m_inner_edges.clear();
    for (const Index f : faces)
      for (Index h = 3 * f; h < 3 * f + 3; ++h)
        if (h < mirror.twin(h) && faces.contains(mirror.twin(h) / 3))
          m_inner_edges.push_back(mirror.edge_of(h));
  }

  void write_faces(const Index_set_2& old_faces, const Patch_2& patch)
  {
    for (Index k = 0; k < patch.number_of_faces(); ++k) {
      const Index f = old_faces[k];
      for (Index i = 0; i < 3; ++i) {
        const Index v = patch.apexes[3 * k + i];
        m_topology.m_mirror.set_apex(3 * f + i, v);
        write_vertex(3 * f + i);
        m_topology.m_vertices[v]->set_face(m_topology.m_faces[f]);
      }
    }
  }

  void link(Index h, Index g)
  {
    m_topology.m_mirror.link(h, g);
    write_neighbors(h);
  }

  // CGAL ----------------------------------------------------------------------------------------

  void visit_and_write_flips(std::vector<Flip_2>& flips)
  {
    for_each_prefetched(flips, [this](const Flip_2& flip) {
      const Face_handle f = m_topology.m_faces[flip.h / 3];
      const int place = int(flip.h % 3);
      m_topology.m_visitor_calls.before_flip(Edge(f, place));
      write_flip(flip);
      m_topology.m_visitor_calls.after_flip(Edge(f, Triangulation_cw_ccw_2::ccw(place)));
    });
    flips.clear();
  }

  // Does in CGAL's structure what the flip has done in the mirror.
  void write_flip(const Flip_2& flip)
  {
    using Mirror = Neighborhood_mirror_2;
    const auto set_apex = [this](Index h, Index v) {
      m_topology.m_faces[h / 3]->set_vertex(int(h % 3), m_topology.m_vertices[v]);
    };
    const auto set_face = [this](Index v, Index h) {
      m_topology.m_vertices[v]->set_face(m_topology.m_faces[h / 3]);
    };
    set_apex(Mirror::previous(flip.h), flip.d);
    set_apex(Mirror::previous(flip.g), flip.a);
    write_neighbors(flip.h, flip.outer_bd);
    write_neighbors(flip.g, flip.outer_ca);
    write_neighbors(Mirror::next(flip.h), Mirror::next(flip.g));
    set_face(flip.c, flip.g);
    set_face(flip.b, flip.h);
  }

  // Calls f for each flip; fetches what write_flip() writes some flips before.
  template <class Function>
  void for_each_prefetched(const std::vector<Flip_2>& flips, const Function& f) const
  {
    for (std::size_t i = 0; i < flips.size(); ++i) {
      if (i % stretch == 0)
        prefetch_stretch(flips.data() + i, (std::min)(stretch, flips.size() - i));
      f(flips[i]);
    }
  }

  // Fetches the handles first, then what they refer to.
  void prefetch_stretch(const Flip_2* flips, std::size_t number) const
  {
    const auto& faces = m_topology.m_faces;
    const auto& vertices = m_topology.m_vertices;
    for (std::size_t i = 0; i < number; ++i) {
      for (const Index h : {flips[i].h, flips[i].g, flips[i].outer_bd, flips[i].outer_ca})
        prefetch(&faces[h / 3]);
      for (const Index v : {flips[i].a, flips[i].b, flips[i].c, flips[i].d})
        prefetch(&vertices[v]);
    }
    for (std::size_t i = 0; i < number; ++i) {
      for (const Index h : {flips[i].h, flips[i].g, flips[i].outer_bd, flips[i].outer_ca})
        prefetch_face(faces[h / 3]);
      prefetch(&*vertices[flips[i].b]);
      prefetch(&*vertices[flips[i].c]);
    }
  }

  static void prefetch_face(Face_handle f)
  {
    prefetch(&*f);
    prefetch(reinterpret_cast<const char*>(&*f) + sizeof(*f) - 1);
  }

  void write_vertex(Index h)
  {
    m_topology.m_faces[h / 3]->set_vertex(int(h % 3),
                                          m_topology.m_vertices[m_topology.m_mirror.apex(h)]);
  }

  // Writes the references of both faces at h to each other.
  void write_neighbors(Index h) { write_neighbors(h, m_topology.m_mirror.twin(h)); }
  void write_neighbors(Index h, Index g)
  {
    m_topology.m_faces[h / 3]->set_neighbor(int(h % 3), m_topology.m_faces[g / 3]);
    m_topology.m_faces[g / 3]->set_neighbor(int(g % 3), m_topology.m_faces[h / 3]);
  }

  // FLIPS IN PARTS ------------------------------------------------------------------------------

  template <class Function>
  void flip_part(const Topology_parts_2& topology, std::size_t part, bool no_edge_doubles,
                 std::vector<Flip_2>& flips, const Function& f)
  {
    auto& mirror = m_topology.m_mirror;
    const auto try_flip = [&](Index h) {
      if (!topology.is_inside(part, mirror.edge_of(h)) || !(no_edge_doubles || can_flip(h)))
        return false;
      provide(flips, 1);
      flips.push_back(mirror.flip(h)); // throws nothing
      CGAL_assertion(
          topology.has_all(part, {flips.back().a, flips.back().b, flips.back().c, flips.back().d}));
      return true;
    };
    const auto write = [&] {
      if constexpr (!Topology::Visitor_calls::is_heard)
        for_each_prefetched(flips, [this](const Flip_2& flip) { write_flip(flip); });
    };
    try {
      f(part, try_flip);
    } catch (...) {
      write();
      throw;
    }
    write();
  }

  void finish_part(std::vector<Flip_2>& flips)
  {
    log_flips(flips);
    if constexpr (Topology::Visitor_calls::is_heard)
      visit_and_write_flips(flips);
    flips.clear();
  }

  // Everything is new where there is no memory to list it.
  void log_flips(const std::vector<Flip_2>& flips)
  {
    auto& changes = m_topology.m_changes;
    try {
      provide(changes.new_edges, flips.size());
      for (const Flip_2& flip : flips)
        changes.new_edges.push_back(flip.edge);
    } catch (const std::bad_alloc&) {
      changes.everything_is_new = true;
    }
  }

  static constexpr std::size_t stretch = 16; // flips that are fetched together

  const Maintained& m_maintained;
  Topology& m_topology;
  Positions& m_positions;
  std::vector<Index> m_inner_edges;
  std::vector<Open_side> m_open_sides;
  std::vector<Flip_2> m_flipped; // in their order
  std::vector<std::vector<Flip_2>> m_flipped_in_parts;
  std::vector<Index> m_empty_vertices, m_empty_faces, m_empty_edges; // to be dropped
  std::vector<Index> m_number_of_edge;                               // after that
};

} // namespace internal
} // namespace Dynamic_Delaunay_triangulations_2
} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_TOPOLOGY_EDITOR_2_H

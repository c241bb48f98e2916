// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_PERIODIC_PERIODIC_EDITOR_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_PERIODIC_PERIODIC_EDITOR_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/assertions.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/core/Flat_arrays_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/core/Points_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/periodic/Periodic_builder_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/periodic/Periodic_change_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/periodic/Torus_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/topology/Halfedge_arrays_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/topology/Star_polygon_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/topology/Star_writer_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/topology/Topology_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/topology/Topology_parts_2.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <new>
#include <utility>
#include <vector>

namespace CGAL {
namespace Dynamic_Delaunay_triangulations_2 {
namespace internal {

// The only writer of a periodic triangulation. Every function leaves a triangulation of the torus
// whose shifts close up around each face and agree along each edge.
//
// If `is_logged_`, it keeps a log of all edges that it removes and creates, of the points whose
// images it numbers anew, and of exchanged cells.
template <class State, bool is_logged_>
class Periodic_editor_2
{
  using Arrays = Halfedge_arrays_2;
  using Slot = Arrays::Slot;
  using Ids = typename State::Ids;
  using Kind = Periodic_change_2::Kind;
  using Parts = typename State::Parts;
  using Polygon = Star_polygon_2<State>;

public:
  explicit Periodic_editor_2(State& state)
    : m_state(state)
    , m_star_writer(state.m_arrays)
  {
  }

  // LOG -----------------------------------------------------------------------------------------

  static constexpr bool is_logged = is_logged_;
  std::vector<Periodic_change_2>& log() { return m_log; }

  // Reserves memory for so many changes.
  void reserve_for_log(std::size_t changes)
  {
    if constexpr (is_logged)
      reserve_extra(m_log, changes);
  }

  // Notes all edges as removed or created. The memory must have been provided.
  void note_all_edges(Kind kind)
  {
    if constexpr (is_logged)
      for (Index e = 0; e < arrays().number_of_edges(); ++e)
        if (!arrays().is_empty_edge(e))
          note_edge(kind, arrays().halfedge(e), m_log);
  }

  // CHANGES -------------------------------------------------------------------------------------

  // Lists each new edge once. To be called before the classifier is told.
  void end_changes() { make_distinct(changes().new_edges); }
  // To be called when the classifier has been told.
  void begin_changes() { changes().clear(); }

  // POINTS --------------------------------------------------------------------------------------

  Ids& ids() { return m_state.m_ids; }
  void set_position(Index v, const Position_2& p) { m_state.m_positions[v] = p; }

  // The next positions of all vertices, by their numbers, and where to write them.
  std::vector<Position_2>& next_positions() { return m_state.m_other_positions; }
  // Moves all vertices there.
  void exchange_positions() { m_state.m_positions.swap(m_state.m_other_positions); }

  // To be called where the position of v was replaced by one that is about `shift` away: every
  // image of v stays where it is, about. A vertex that is taken out has none, but the edges that it
  // had are called by its position now.
  void shift_images(Index v, const Periodic_shift_2& shift)
  {
    if (are_equal(shift, no_shift))
      return;
    note([&] { return Periodic_change_2::translation(ids().representative(v), shift); });
    if (arrays().is_outside(v))
      return;
    changes().relocated.push_back(v);
    arrays().for_each_corner(v, [&](Index h) { m_corners.push_back(h); });
    for (const Index h : m_corners)
      shifts()[h] = shifts()[h] - shift;
    for (const Index h : m_corners)
      write_face(h / 3);
    m_corners.clear();
  }

  // Exchanges the representative of a vertex for one of its duplicates, which is at p: so
  // far the representative was at `before`, by `shift` away from p.
  void exchange_representative(Index duplicate, const Position_2& p, const Position_2& before,
                               const Periodic_shift_2& shift)
  {
    const Index v = ids().vertex(duplicate);
    reserve_for_log(2 * std::size_t(arrays().degree(v)) + 1);
    note_edges_around(Kind::EDGE_REMOVED, v);
    ids().exchange_representative(duplicate, before);
    note_edges_around(Kind::EDGE_CREATED, v);
    set_position(v, p);
    shift_images(v, shift);
  }

  // The lattice gets another cell. `multiples` are the vectors of the old cell in those of the new
  // one, integers with determinant 1 or -1; the rest is deformation.
  void set_cell(const Periodic_cell_2& cell, const std::array<Periodic_shift_2, 2>& multiples)
  {
    if (multiples != std::array<Periodic_shift_2, 2>{{{1, 0}, {0, 1}}})
      note([&] { return Periodic_change_2::exchange(multiples); });
    ++m_state.m_cell_changes;
    m_state.m_torus = Torus_2(cell);
    for (Periodic_shift_2& s : shifts())
      s = {s[0] * multiples[0][0] + s[1] * multiples[1][0],
           s[0] * multiples[0][1] + s[1] * multiples[1][1]};
  }

  // FLIPS ---------------------------------------------------------------------------------------

  // A flip needs two faces, and must give no edge that is there already, or has no length. Walks
  // around both ends of the new edge in step, because one of them may have many neighbors.
  bool can_flip(Index h) const
  {
    const Index g = arrays().twin(h);
    const Index a = arrays().apex(h), d = arrays().apex(g);
    const Periodic_shift_2 way = shifts()[g] + m_state.transition(h) - shifts()[h];
    if (h / 3 == g / 3 || (a == d && are_equal(way, no_shift)))
      return false;
    Index i = h, k = g;
    do {
      if (m_state.leads(i, d, way) || m_state.leads(k, a, no_shift - way))
        return false;
      i = arrays().next_corner(i);
      k = arrays().next_corner(k);
    } while (i != h && k != g);
    return true;
  }

  void flip(Index h)
  {
    reserve_for_log(2);
    reserve_extra(changes().new_edges, 1);
    flip(h, changes().new_edges, m_log);
  }

  // As `Topology_editor_2` has it: calls f(part, try_flip) for all parts, for `most` flips at most.
  // Edges are flipped there only where all corners have the same shift. No flip there changes any
  // shift, or hides an edge or shows it. Everything else is as in the plane. Doubled edges are
  // always looked for, since flips elsewhere may have left faces of any kind.
  template <class Function>
  void flip_in_parts(const Topology_parts_2& topology, std::size_t parts, bool, std::size_t most,
                     const Function& f)
  {
    m_flips_of_parts.resize((std::max)(parts, m_flips_of_parts.size()));
    reserve_for_log(2 * most);
    const auto finish = [&] {
      for (std::size_t part = 0; part < parts; ++part)
        finish_part(m_flips_of_parts[part]);
    };
    try {
      Parts::run(parts, [&](std::size_t part) {
        f(part, [&](Index h) { return try_flip(topology, part, h, m_flips_of_parts[part]); });
      });
    } catch (...) {
      finish();
      throw;
    }
    finish();
  }

  // VERTICES ------------------------------------------------------------------------------------

  void copy(const State& other) { m_state = other; }

  // Exchanges everything with another one.
  void swap(State& other)
  {
    std::swap(m_state, other);
    changes().everything_is_new = true;
    other.m_changes.everything_is_new = true;
  }

  // Makes the only vertex, at p, with two faces over the basis r, t of the lattice, which is
  // counterclockwise. Its edges are not logged, as its point has no id yet.
  void start(const Position_2& p, const Periodic_shift_2& r, const Periodic_shift_2& t)
  {
    changes().everything_is_new = true;
    arrays().resize(1, 2);
    ids().append_vertex();
    m_state.m_positions.push_back(p);
    for (Index h = 0; h < 6; ++h)
      arrays().set_apex(h, 1);
    // the faces (0, r, r + t) and (0, r + t, t) of a parallelogram
    shifts() = {no_shift, r, r + t, no_shift, r + t, t};
    arrays().link(0, 4);
    arrays().link(1, 5);
    arrays().link(2, 3);
    arrays().template number_edges<Parts>();
    write_face(0);
    write_face(1);
  }

  // Makes these vertices and faces, where there are none, of points with these reserved ids. The
  // edges are not logged.
  void build(const Periodic_faces_2& faces, const std::vector<Index>& ids_of_points,
             const std::vector<Position_2>& points)
  {
    const std::size_t vertices = faces.points.size() - 1;
    std::vector<Position_2> positions(vertices);
    ids().resize(Index(vertices));
    for_each_in_parts(vertices, [&](std::size_t i) {
      const Index point = faces.points[i + 1];
      positions[i] = points[point];
      ids().set_representative(Index(i + 1), ids_of_points[point]);
    });
    write_faces(faces, positions);
    arrays().template number_edges<Parts>();
    hide_shifted_edges();
  }

  // Makes what a checkpoint has kept, where there is nothing: with these ids of the vertices, and
  // with these half-edges stored for the vertices and for the edges.
  void restore(const Periodic_faces_2& faces, const std::vector<Position_2>& positions,
               const Ids& ids_of_vertices, const std::vector<Index>& corners,
               const std::vector<Index>& halfedges)
  {
    write_faces(faces, positions);
    for (Index e = 0; e < Index(halfedges.size()); ++e)
      arrays().set_edge(e, halfedges[e]);
    for (Index v = 1; v <= Index(corners.size()); ++v)
      arrays().set_corner(v, corners[v - 1]);
    hide_shifted_edges();
    ids() = ids_of_vertices;
  }

  // Makes a vertex outside of all faces. Its point has no id yet.
  Slot make_slot()
  {
    arrays().reserve_for_slot();
    ids().reserve_for_vertex();
    reserve_extra(shifts(), 6);
    reserve_extra(m_state.m_positions, 1);
    ids().append_vertex();
    shifts().resize(shifts().size() + 6);
    m_state.m_positions.push_back(nan_point());
    changes().everything_is_new = true;
    return arrays().append_slot();
  }

  // Puts the slot's vertex into face f, its image by `shift` in the frame of f.
  void put_in(const Slot& slot, const Periodic_shift_2& shift, Index f)
  {
    reserve_for_log(3);
    const Index g = slot.faces[0], k = slot.faces[1];
    const Periodic_shift_2 a = shifts()[3 * f], b = shifts()[3 * f + 1], c = shifts()[3 * f + 2];
    arrays().put_in(slot, f);
    changes().relocated.push_back(slot.vertex);
    set_shifts(f, shift, b, c);
    set_shifts(g, a, shift, c);
    set_shifts(k, a, b, shift);
    for (const Index face : {f, g, k})
      write_face(face);
    note_new_edges_around(slot.vertex);
    note_edges_around(Kind::EDGE_CREATED, slot.vertex);
  }

  // Puts the center of a polygon that has faces and edges for it in their place. If it throws,
  // nothing has changed.
  void put_in(const Polygon& polygon)
  {
    const std::size_t degree = polygon.sides().size();
    reserve_for_log(2 * degree);
    reserve_extra(changes().new_edges, degree);
    reserve_extra(changes().relocated, 1);
    for (std::size_t i = 0; i + 3 < degree; ++i)
      note_edge(Kind::EDGE_REMOVED, arrays().halfedge(polygon.edges()[i]), m_log);
    m_star_writer.write_star(polygon, corner_setter());
    for (const Index f : polygon.faces())
      write_face(f);
    changes().relocated.push_back(polygon.center());
    note_new_edges_around(polygon.center());
    note_edges_around(Kind::EDGE_CREATED, polygon.center());
  }

  // Takes the center of a triangulated polygon out of its faces. If it throws, nothing has changed.
  Slot take_out(const Polygon& polygon)
  {
    const std::size_t degree = polygon.sides().size();
    reserve_for_log(2 * degree);
    reserve_extra(changes().new_edges, degree);
    m_star_writer.reserve(polygon);
    note_edges_around(Kind::EDGE_REMOVED, polygon.center());
    const Slot slot = m_star_writer.write_ears(polygon, corner_setter());
    for (std::size_t i = 0; i < polygon.ears().size(); ++i)
      write_face(polygon.faces()[i]);
    for (const Index e : slot.edges)
      arrays().hide_edge(e); // so that passes over all edges need not look whether they are empty
    m_star_writer.for_each_edge_of_ears(polygon,
                                        [this](Index e) { changes().new_edges.push_back(e); });
    for (std::size_t i = 0; i + 3 < degree; ++i)
      note_edge(Kind::EDGE_CREATED, arrays().halfedge(polygon.edges()[i]), m_log);
    return slot;
  }

  // Deletes the vertices of all slots, which have no points. The last vertices, edges and faces
  // take their numbers.
  void drop(const std::vector<Slot>& empty_slots)
  {
    changes().everything_is_new = changes().everything_is_new || !empty_slots.empty();
    std::vector<Index> vertices, faces, edges;
    for (const Slot& slot : empty_slots) {
      vertices.push_back(slot.vertex);
      faces.insert(faces.end(), slot.faces.begin(), slot.faces.end());
      edges.insert(edges.end(), slot.edges.begin(), slot.edges.end());
    }
    for (auto* numbers : {&vertices, &faces, &edges}) // from the last on, which thus is not empty
      std::sort(numbers->rbegin(), numbers->rend());
    for (const Index f : faces) {
      const Index last = 3 * (arrays().number_of_faces() - 1);
      set_shifts(f, shifts()[last], shifts()[last + 1], shifts()[last + 2]);
      arrays().move_last_face_to(f);
      shifts().resize(last);
    }
    for (const Index e : edges)
      arrays().move_last_edge_to(e);
    for (const Index v : vertices) {
      arrays().move_last_vertex_to(v);
      ids().move_last_vertex_to(v);
      set_position(v, m_state.m_positions.back());
      m_state.m_positions.pop_back();
    }
  }

private:
  Halfedge_arrays_2& arrays() { return m_state.m_arrays; }
  const Halfedge_arrays_2& arrays() const { return m_state.m_arrays; }
  Change_log_2& changes() { return m_state.m_changes; }
  std::vector<Periodic_shift_2>& shifts() { return m_state.m_shifts; }
  const std::vector<Periodic_shift_2>& shifts() const { return m_state.m_shifts; }

  // Flips the edge of half-edge h. There must be memory for one new edge, and for two changes.
  void flip(Index h, std::vector<Index>& new_edges, std::vector<Periodic_change_2>& log)
  {
    const Index g = arrays().twin(h);
    const Edge_images_2 images = m_state.corners_at(h);
    note_edge(Kind::EDGE_REMOVED, h, log);
    arrays().flip_glued(h);
    shifts()[Arrays::previous(h)] = images.right.shift;
    shifts()[g] = images.right.shift;
    shifts()[Arrays::next(g)] = images.target.shift;
    shifts()[Arrays::previous(g)] = images.left.shift;
    write_face(h / 3);
    write_face(g / 3);
    new_edges.push_back(arrays().edge_of(Arrays::next(g)));
    note_edge(Kind::EDGE_CREATED, Arrays::next(g), log);
  }

  // What was flipped in a part: the new edges, and the entries of the log.
  struct Flips_of_part
  {
    std::vector<Index> edges;
    std::vector<Periodic_change_2> log;
  };

  bool try_flip(const Topology_parts_2& topology, std::size_t part, Index h, Flips_of_part& flips)
  {
    if (!topology.is_inside(part, arrays().edge_of(h)) || !can_flip(h))
      return false;
    reserve_extra(flips.edges, 1);
    if constexpr (is_logged)
      reserve_extra(flips.log, 2);
    CGAL_assertion_code(const Edge_2 edge = m_state.edge(arrays().edge_of(h)));
    CGAL_assertion(topology.has_all(part, {edge.source, edge.target, edge.left, edge.right}));
    flip(h, flips.edges, flips.log);
    return true;
  }

  // The log has memory for all changes. Everything is new where there is none to list new edges.
  void finish_part(Flips_of_part& flips)
  {
    try {
      reserve_extra(changes().new_edges, flips.edges.size());
      changes().new_edges.insert(changes().new_edges.end(), flips.edges.begin(), flips.edges.end());
    } catch (const std::bad_alloc&) {
      changes().everything_is_new = true;
    }
    m_log.insert(m_log.end(), flips.log.begin(), flips.log.end());
    flips.edges.clear();
    flips.log.clear();
  }

  template <class Change>
  void note(const Change& change)
  {
    if constexpr (is_logged)
      m_log.push_back(change());
  }

  // Edges across the gap of a slab are none of the user's.
  void note_edge(Kind kind, Index h, std::vector<Periodic_change_2>& log) const
  {
    if constexpr (is_logged) {
      const Index from = Arrays::next(h), to = Arrays::previous(h);
      if (!m_state.torus().are_across(shifts()[from], shifts()[to]))
        log.push_back(Periodic_change_2::edge(
            kind, m_state.ids().representative(arrays().apex(from)),
            m_state.ids().representative(arrays().apex(to)), shifts()[to] - shifts()[from]));
    }
  }

  // Edges from the vertex to itself are met twice, and noted once.
  void note_edges_around(Kind kind, Index v)
  {
    if constexpr (is_logged)
      arrays().for_each_corner(v, [&](Index h) {
        const Index spoke = Arrays::previous(h);
        if (arrays().target(spoke) != v || spoke == arrays().halfedge(arrays().edge_of(spoke)))
          note_edge(kind, spoke, m_log);
      });
  }

  void note_new_edges_around(Index v)
  {
    arrays().for_each_corner(
        v, [&](Index h) { changes().new_edges.push_back(arrays().edge_of(Arrays::previous(h))); });
  }

  auto corner_setter()
  {
    return [this](Index h, const typename State::Corner& corner) {
      arrays().set_apex(h, corner.vertex);
      shifts()[h] = corner.shift;
    };
  }

  void set_shifts(Index f, Periodic_shift_2 a, Periodic_shift_2 b, Periodic_shift_2 c)
  {
    shifts()[3 * f] = a;
    shifts()[3 * f + 1] = b;
    shifts()[3 * f + 2] = c;
  }

  // Writes all but the edges, and the ids of the vertices, which have these positions.
  void write_faces(const Periodic_faces_2& faces, const std::vector<Position_2>& positions)
  {
    changes().everything_is_new = true;
    const Index vertices = Index(positions.size());
    arrays().resize(vertices, 2 * vertices);
    m_state.m_positions.insert(m_state.m_positions.end(), positions.begin(), positions.end());
    shifts() = faces.shifts;
    for_each_in_parts(2 * vertices, [&](std::size_t f) {
      for (Index h = Index(3 * f); h < 3 * f + 3; ++h)
        arrays().set_apex_and_twin(h, faces.apexes[h], faces.twins[h]);
      move_frame(Index(f));
    });
    arrays().template find_corners<Parts>();
  }

  void hide_shifted_edges()
  {
    for_each_in_parts(arrays().number_of_edges(), [&](std::size_t e) {
      if (!has_equal_shifts(arrays().halfedge(Index(e))))
        arrays().hide_edge(Index(e));
    });
  }

  // Calls f(i) for all i below `size`.
  template <class Function>
  static void for_each_in_parts(std::size_t size, const Function& f)
  {
    Parts::for_each(size, [&](std::size_t, std::size_t first, std::size_t beyond) {
      for (std::size_t i = first; i < beyond; ++i)
        f(i);
    });
  }

  // Moves the frame of face f to its first corner, and writes its edges.
  void write_face(Index f)
  {
    move_frame(f);
    for (Index h = 3 * f; h < 3 * f + 3; ++h) {
      const Index e = arrays().edge_of(h);
      if (has_equal_shifts(h))
        arrays().set_edge(e, arrays().halfedge(e));
      else
        arrays().hide_edge(e);
    }
  }

  void move_frame(Index f)
  {
    const Periodic_shift_2 first = shifts()[3 * f];
    for (Index h = 3 * f; h < 3 * f + 3; ++h)
      shifts()[h] = shifts()[h] - first;
  }

  // Whether the corners of both faces at half-edge h have the same shift.
  bool has_equal_shifts(Index h) const
  {
    const auto [a, b, c, d] = m_state.corners_at(h);
    return are_equal(a.shift, b.shift) && are_equal(b.shift, c.shift) &&
           are_equal(c.shift, d.shift);
  }

  State& m_state;
  Star_writer_2<State> m_star_writer;
  std::vector<Index> m_corners;
  std::vector<Flips_of_part> m_flips_of_parts;
  std::vector<Periodic_change_2> m_log;
};

} // namespace internal
} // namespace Dynamic_Delaunay_triangulations_2
} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_PERIODIC_PERIODIC_EDITOR_2_H

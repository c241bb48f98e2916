// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_MENDING_VERTEX_RELOCATION_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_MENDING_VERTEX_RELOCATION_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Flat_arrays.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/mending/Point_location_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/mending/Relocation_parts_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Flat_elements_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Points_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Spatial_order_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/static/Vertex_order_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/topology/Star_polygon_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/topology/Topology_editor_2.h>

#include <boost/iterator/counting_iterator.hpp>
#include <boost/sort/pdqsort/pdqsort.hpp>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

// Vertices that jump, merge and part, and points that come and go, in one update. First vertices
// are taken out of their faces: jumpers wait, vertices without points leave an empty slot. Then the
// waiting vertices and the new points are put in, all of them along a Hilbert curve. New points
// take empty slots, if there are any. In the end the remaining empty slots are dropped.
//
// If an exception ends the update, each insertion and removal is either complete or not begun, and
// all vertices are in some face.
template <class State>
class Vertex_relocation_2
{
  using Editor = Topology_editor_2<State>;
  using Slot = typename Editor::Slot;
  using Point = typename State::Point;
  using Location = Location_2<State>;

public:
  Vertex_relocation_2(State& state, Editor& editor)
    : m_state(state)
    , m_editor(editor)
    , m_meeting_order(state)
    , m_parts(state, editor)
  {
  }

  // Announces points to be inserted, with the next ids, after the removals. Swaps the lists for
  // others, unless it throws.
  void announce(std::vector<Point_id>& ids, std::vector<Point>& points)
  {
    m_editor.reserve_ids(ids); // nothing throws from here on
    announce_reserved(ids, points);
  }
  // Announces points whose ids need not be reserved: no other point has them. Throws nothing.
  void announce_reserved(std::vector<Point_id>& ids, std::vector<Point>& points)
  {
    m_coming_ids.swap(ids);
    m_coming_points.swap(points);
  }

  // Calls f(id, point) for the announced points that are not inserted yet.
  template <class Function>
  void for_each_coming(const Function& f) const
  {
    for (std::size_t i = 0; i < m_coming_ids.size(); ++i)
      if (!m_state.ids().is_taken(m_coming_ids[i]))
        f(m_coming_ids[i], m_coming_points[i]);
  }

  // The number of vertices outside of all faces.
  std::size_t number_outside() const { return m_waiting.size() + m_empty.size(); }

  // The number of vertices to put in again.
  std::size_t number_waiting() const { return m_waiting.size(); }

  // The number of vertices to put in again and of points to insert.
  std::size_t number_to_put_in() const { return m_waiting.size() + m_coming_ids.size(); }

  // Whether vertices are outside of all faces, or announced points are not inserted yet.
  bool is_under_way() const
  {
    return !m_waiting.empty() || !m_empty.empty() || !m_coming_ids.empty();
  }

  // OUT -----------------------------------------------------------------------------------------

  // Takes v out, to be put in again at its present position; the faces have it at `position`.
  // False, with nothing done, if its faces cannot be replaced: in a torus of few vertices, and
  // along the sides of a slab, these may meet images of themselves.
  bool take_out(Vertex_index v, const Position_2& position)
  {
    reserve_for_slots(1);
    const bool can_go = triangulate_anyhow_without(v, position);
    if (can_go)
      m_waiting.push_back(m_editor.take_out(m_polygon));
    return can_go;
  }

  // Takes v out so that everything else stays Delaunay. False, with nothing done, if it is not
  // known how. Everything has to be Delaunay before, except that v may have moved.
  bool take_out_of_delaunay(Vertex_index v)
  {
    reserve_for_slots(1);
    const bool is_known = triangulate_as_delaunay_without(v);
    if (is_known)
      m_waiting.push_back(m_editor.take_out(m_polygon));
    return is_known;
  }

  // Does so with the vertices of a list, by parts, if they are many. Returns how many it has taken
  // out; the others, which it keeps in the list, may be known, too.
  std::size_t take_out_of_delaunay(std::vector<Vertex_index>& vertices)
  {
    const std::size_t number = vertices.size();
    if (!m_parts.are_worth(number))
      return 0;
    reserve_for_slots(number);
    m_parts.take_out(vertices, m_waiting, [](auto& edit, const Star_polygon_2<State>& polygon) {
      return edit.take_out(polygon);
    });
    return number - vertices.size();
  }

  // Removes the points with these ids. A representative leaves its vertex to a covered point, if
  // there is one. Returns the vertices that this has moved, because that is elsewhere by now.
  //
  // If everything is Delaunay (`are_delaunay`), it stays so: removes only vertices for which it is
  // known how. All other vertices keep their points until remove_rest().
  std::vector<Vertex_index> remove(const std::vector<Point_id>& ids, bool are_delaunay)
  {
    std::vector<Vertex_index> moved;
    m_editor.reserve_for_removals(ids.size());
    m_rest.clear();
    for (const Point_id id : ids)
      if (m_state.ids().is_taken(id))
        remove(id, moved);
    if (are_delaunay)
      remove_of_delaunay();
    const auto is_outside = [this](Vertex_index v) { return m_state.arrays().is_outside(v); };
    moved.erase(std::remove_if(moved.begin(), moved.end(), is_outside), moved.end());
    return moved;
  }

  // Removes the points with these ids that have a vertex of their own, so that everything stays
  // Delaunay, as it must be. Keeps for remove_rest() the vertices for which it is not known how.
  void remove_of_delaunay(const std::vector<Point_id>& ids)
  {
    m_editor.reserve_for_removals(ids.size());
    m_rest.clear();
    for (const Point_id id : ids)
      if (m_state.ids().is_alone(id))
        m_rest.push_back(m_state.ids().vertex(id));
    remove_of_delaunay();
  }

  // Removes the remaining vertices of the last `remove()`. False if one of them cannot go, see
  // take_out(); then this vertex and all after it stay.
  bool remove_rest()
  {
    for (const Vertex_index v : m_rest) {
      reserve_for_slots(1);
      if (!triangulate_anyhow_without(v, m_state.previous_position(v)))
        return false;
      m_empty.push_back(m_editor.remove(m_polygon));
    }
    return true;
  }
  bool has_rest() const { return !m_rest.empty(); }

  // Merges vertices of the list that coincide: the one with the smallest id stays, and the points
  // of the others are covered there. Returns how many vertices were removed. Removes none if
  // more than `most` would have to go, or if fewer than three would remain.
  std::size_t merge(const std::vector<Vertex_index>& vertices, std::size_t most)
  {
    const auto& ids = m_state.ids();
    m_meeting_order.sort(vertices.begin(), vertices.end());
    std::vector<std::pair<Point_id, Point_id>> pairs;
    m_meeting_order.for_each_coincident_pair([&](Vertex_index v, Vertex_index w) {
      pairs.emplace_back(ids.representative(v), ids.representative(w));
    });
    constexpr std::size_t min_vertices = 3;
    if (pairs.size() > most || pairs.size() + m_waiting.size() + m_empty.size() + min_vertices >
                                   m_state.number_of_vertices())
      return 0;
    m_editor.reserve_for_covered(pairs.size());
    for (const auto& [i, j] : pairs) {
      Vertex_index stays = ids.vertex(i), goes = ids.vertex(j);
      if (ids.representative(goes) < ids.representative(stays))
        std::swap(stays, goes);
      reserve_for_slots(1);
      const Point p = m_state.point(goes);
      triangulate_anyhow_without(goes, m_state.previous_position(goes));
      m_empty.push_back(m_editor.merge(m_polygon, stays, p));
    }
    return pairs.size();
  }

  // IN ------------------------------------------------------------------------------------------

  struct Counts
  {
    std::size_t relocated = 0, parted = 0, merged = 0, steps = 0;
    std::size_t in_parts = 0; // put in without a call of `legalize`
  };

  // Puts in the waiting vertices, the points that have parted from their vertices, and the new
  // ones. `most_faces()` must be 0 unless everything is Delaunay. A vertex v replaces up to so many
  // faces if everything is known to stay Delaunay then. Otherwise v is just put into a face, and
  // flips around v have to follow. After each vertex, calls `legalize(v, steps, faces)` with the
  // steps of all walks so far and the number of replaced faces, 0 in the second case. Stops if it
  // is false.
  template <class Most_faces, class Legalize>
  Counts put_in(const std::vector<Point_id>& parted, const Most_faces& most_faces,
                const Legalize& legalize)
  {
    Counts counts;
    collect_positions(parted);
    provide_slots(parted);
    if (most_faces() > 0 && m_parts.are_worth(m_numbers.size()))
      put_in_by_parts(parted.size(), counts);
    Hint hint{any_vertex(), m_state.number_of_vertices()};
    bool goes_on = true;
    for (std::size_t k = 0; k < m_numbers.size() && goes_on; ++k) {
      const std::size_t i = m_numbers[k];
      const std::size_t most = most_faces();
      m_replaced = 0;
      const Vertex_index v = i < m_waiting.size()
                                 ? put_in_again(m_slots[i], hint, most, counts)
                                 : insert(parted, i - m_waiting.size(), hint, most, counts);
      if (v == null_index)
        continue;
      if (k + 1 < m_numbers.size())
        hint = hint_at(v); // flips may join v with vertices that are far away
      goes_on = legalize(v, counts.steps, m_replaced);
    }
    drop_full_slots();
    if (goes_on)
      forget_all();
    return counts;
  }

  // Drops the empty slots. Returns whether there were any: then some numbers of vertices changed.
  bool finish()
  {
    if (m_empty.empty())
      return false;
    m_editor.drop(m_empty);
    m_empty.clear();
    return true;
  }

  // Puts the waiting vertices into any faces, drops the empty slots, and cancels the insertions
  // that are left. Everything is new then. Throws nothing.
  void give_up()
  {
    if (!is_under_way())
      return;
    drop_full_slots();
    m_editor.note_everything_is_new();
    m_editor.keep_memory_for(0);
    for (const Slot& slot : m_waiting)
      if (m_state.arrays().is_outside(slot.vertex) && m_state.ids().has_representative(slot.vertex))
        m_editor.put_in(slot, any_face());
    m_editor.drop_in_need(m_empty);
    for_each_coming([this](Point_id id, const Point&) { m_editor.release_id(id); });
    m_empty.clear();
    forget_all();
  }

  // Cancels everything, because the triangulation is replaced by another one.
  void forget()
  {
    m_empty.clear();
    forget_all();
  }

private:
  // Reserves all memory that give_up() would need for more slots.
  void reserve_for_slots(std::size_t number)
  {
    const std::size_t max_slots = m_waiting.size() + m_empty.size() + number;
    reserve_extra(m_waiting, number);
    reserve_extra(m_empty, number + m_waiting.size());
    m_editor.keep_memory_for(2 * max_slots);
  }

  bool triangulate_as_delaunay_without(Vertex_index v)
  {
    const bool can_go = m_polygon.read(m_state, v);
    m_editor.prefetch(m_polygon);
    return can_go && m_polygon.triangulate_as_delaunay(m_state);
  }

  // Triangulates the polygon around v; the faces have v at `position`.
  bool triangulate_anyhow_without(Vertex_index v, const Position_2& position)
  {
    if (!m_polygon.read(m_state, v) || !m_polygon.has_different_vertices())
      return false;
    m_polygon.triangulate_anyhow(m_state, position);
    return true;
  }

  // Removes a covered point. Lists the vertex of another one, if that has no other point.
  void remove(Point_id id, std::vector<Vertex_index>& moved)
  {
    const auto& ids = m_state.ids();
    const Vertex_index v = ids.vertex(id);
    if (ids.is_alone(id))
      return m_rest.push_back(v);
    if (ids.is_representative(id)) {
      const Point_id successor = ids.find_covered_at(v, [](const Point&) { return true; });
      const Point p = m_state.point(v);
      if (!m_state.is_at(ids.covered_point(successor), v))
        moved.push_back(v);
      m_editor.exchange_representative(successor, v, p);
    }
    m_editor.remove_covered(id);
  }

  // Removes the listed vertices for which that is known to leave everything Delaunay: by parts, if
  // they are many, in the order of their numbers, so that those that are close in space are close
  // in time.
  void remove_of_delaunay()
  {
    make_distinct(m_rest);
    reserve_for_slots(m_rest.size());
    if (m_parts.are_worth(m_rest.size())) {
      m_parts.take_out(m_rest, m_empty, [](auto& edit, const Star_polygon_2<State>& polygon) {
        return edit.remove(polygon);
      });
    }
    std::size_t left = 0;
    for (std::size_t i = 0; i < m_rest.size(); ++i) {
      const Vertex_index v = m_rest[i];
      m_parts.fetch_stars(i, m_rest.size(), [this](std::size_t k) { return m_rest[k]; });
      if (triangulate_as_delaunay_without(v))
        m_empty.push_back(m_editor.remove(m_polygon));
      else
        m_rest[left++] = v;
    }
    m_rest.resize(left);
  }

  // Collects the positions to put in: those of waiting vertices, then those of points that
  // have parted, then those of new points.
  void collect_positions(const std::vector<Point_id>& parted)
  {
    m_positions.clear();
    const auto add = [this](const Position_2& p) {
      m_positions.push_back(m_state.position_in_order(p));
    };
    for (const Slot& slot : m_waiting)
      add(m_state.positions()[slot.vertex]);
    for (const Point_id id : parted)
      add(approximation(m_state.ids().covered_point(id)));
    for (const Point& p : m_coming_points)
      add(approximation(p));
    const boost::counting_iterator<Index> first(0), beyond(Index(m_positions.size()));
    m_order.sort(m_positions, first, beyond);
    m_numbers.resize(m_order.size());
    for (std::size_t k = 0; k < m_order.size(); ++k)
      m_numbers[k] = m_order[k];
  }

  // Provides each position with a slot: waiting vertices have their own, the others get empty ones,
  // with a fresh vertex there, and new ones where these do not suffice. Numbers of vertices follow
  // a curve, so the empty slots in the order of their numbers go to the positions in the order of
  // the curve: then vertices that are close in space still are close in memory.
  void provide_slots(const std::vector<Point_id>& parted)
  {
    const std::size_t waiting = m_waiting.size(), needed = m_order.size() - waiting,
                      empty = m_empty.size();
    const auto point = [&](std::size_t i) -> const Point& {
      return i < waiting + parted.size() ? m_state.ids().covered_point(parted[i - waiting])
                                         : m_coming_points[i - waiting - parted.size()];
    };
    reserve_for_slots(needed);
    boost::sort::pdqsort(m_empty.begin(), m_empty.end(), // often sorted already
                         [](const Slot& s, const Slot& t) { return s.vertex < t.vertex; });
    m_slots = m_waiting;
    m_slots.resize(m_order.size());
    m_without_slot.clear();
    for (std::size_t k = 0, n = 0; k < m_order.size(); ++k) {
      const Index i = m_order[k];
      if (i < waiting)
        continue;
      const std::size_t next = n * empty / needed; // spread evenly, be there more or fewer
      if (++n * empty / needed == next) {
        m_without_slot.push_back(i);
        continue;
      }
      m_editor.renew_vertex(m_empty[next], point(i));
      m_slots[i] = m_empty[next];
    }
    if (m_without_slot.empty())
      return;
    m_editor.make_slots(
        m_without_slot.size(),
        [&](std::size_t k) -> const Point& { return point(m_without_slot[k]); }, m_empty);
    for (std::size_t k = 0; k < m_without_slot.size(); ++k)
      m_slots[m_without_slot[k]] = m_empty[empty + k];
  }

  // Keeps in the list of empty slots those whose vertices are outside of faces.
  void drop_full_slots()
  {
    const auto is_full = [this](const Slot& s) { return !m_state.arrays().is_outside(s.vertex); };
    m_empty.erase(std::remove_if(m_empty.begin(), m_empty.end(), is_full), m_empty.end());
  }

  // Puts in, by parts, waiting vertices and new points. What is left stays in m_numbers.
  void put_in_by_parts(std::size_t parted, Counts& counts)
  {
    const std::size_t waiting = m_waiting.size(), first_coming = waiting + parted;
    const auto slot = [&](Index i) {
      return i < waiting || i >= first_coming ? &m_slots[i] : nullptr;
    };
    const auto position = [this](Index i) { return m_positions[i]; };
    const auto put = [&](auto& edit, Index i, const Star_polygon_2<State>& polygon) {
      if (i < waiting)
        edit.put_in_again(m_slots[i], polygon);
      else
        edit.put_in_new(m_slots[i], polygon, m_coming_ids[i - first_coming]);
    };
    counts.steps += m_parts.put_in(m_numbers, slot, position, any_vertex(), put);
    counts.in_parts = m_order.size() - m_numbers.size();
    const auto is_left = [&](Index i) { return i < waiting; };
    counts.relocated +=
        waiting - std::size_t(std::count_if(m_numbers.begin(), m_numbers.end(), is_left));
  }

  // A finite vertex that is in some face.
  Vertex_index any_vertex() const
  {
    Vertex_index v(1);
    while (m_state.arrays().is_outside(v))
      ++v;
    return v;
  }

  typename Editor::Seen_face any_face() const
  {
    const Halfedge_index h = m_state.arrays().corner(any_vertex());
    return {Halfedge_arrays_2::face_of(h), m_state.chart_at(h)};
  }

  // Where to start the search for the next position.
  struct Hint
  {
    Vertex_index nearby;
    Index spread; // of the numbers of vertices around the position
  };

  // A neighbor of v, because the number of v itself belongs to its former position.
  Hint hint_at(Vertex_index v) const
  {
    Vertex_index nearby = v;
    m_state.arrays().for_each_neighbor(
        v, [&](Vertex_index w) { nearby = w == infinite_index ? nearby : w; });
    const std::size_t spread = 4 * m_state.number_of_vertices() / m_numbers.size();
    return {nearby, Index(spread)};
  }

  Location locate(Vertex_index v, const Hint& hint) const
  {
    const Vertex_target_2<State> target(m_state, v);
    return Point_location_2(m_state, target).locate(hint.nearby, hint.spread);
  }

  // Returns v, or `null_index` if another vertex is there already, and now has the points of v.
  Vertex_index put_in_again(const Slot& slot, const Hint& hint, std::size_t most, Counts& counts)
  {
    const Vertex_index v = slot.vertex;
    const Location location = locate(v, hint);
    counts.steps += location.steps;
    if (location.vertex == null_index) {
      if (find_polygon(slot, location, most))
        m_editor.put_in_again(slot, m_polygon);
      else
        m_editor.put_in_again(slot, seen(location));
      ++counts.relocated;
      return v;
    }
    m_editor.reserve_for_covered(1);
    m_editor.hand_points_to(location.vertex, v, m_state.point(v));
    m_empty.push_back(slot);
    ++counts.merged;
    return null_index;
  }

  // Inserts a point that has parted, or a new one. Returns its vertex, or `null_index` if it is
  // covered now.
  Vertex_index insert(const std::vector<Point_id>& parted, std::size_t i, const Hint& hint,
                      std::size_t most, Counts& counts)
  {
    const auto& ids = m_state.ids();
    const bool parts = i < parted.size();
    const std::size_t coming = i - parted.size();
    const Point_id id = parts ? parted[i] : m_coming_ids[coming];
    const Slot& slot = m_slots[m_waiting.size() + i];
    counts.parted += parts;
    m_editor.reserve_for_covered(1);
    const Location location = locate(slot.vertex, hint);
    counts.steps += location.steps;
    if (location.vertex != null_index) {
      const Point p = parts ? ids.covered_point(id) : m_coming_points[coming];
      m_editor.place_covered(id, location.vertex, p);
      return null_index;
    }
    if (find_polygon(slot, location, most))
      m_editor.put_in_new(slot, m_polygon, id);
    else
      m_editor.put_in_new(slot, seen(location), id);
    return slot.vertex;
  }

  static typename Editor::Seen_face seen(const Location& location)
  {
    return {location.face, location.chart};
  }

  // Finds a polygon to put the slot's vertex in so that everything stays Delaunay. False if `most`
  // is 0, or if that is not possible. In any case reserves memory for the new edges.
  bool find_polygon(const Slot& slot, const Location& location, std::size_t most)
  {
    constexpr std::size_t edges_of_three_faces = 6;
    const bool is_found =
        State::predicates_are_exact && most > 0 && location.is_inside &&
        m_polygon.find_as_delaunay(m_state, location.face, location.chart, slot.vertex, most);
    if (is_found) {
      m_replaced = m_polygon.faces().size();
      m_polygon.add(slot);
      m_editor.prefetch(m_polygon);
    }
    m_editor.reserve_for_new_edges(is_found ? m_polygon.edges().size() : edges_of_three_faces);
    return is_found;
  }

  void forget_all()
  {
    m_waiting.clear();
    m_coming_ids.clear();
    m_coming_points.clear();
  }

  const State& m_state;
  Editor& m_editor;
  Vertex_order_2<State> m_meeting_order;
  Relocation_parts_2<State> m_parts;
  Spatial_order_2 m_order;
  std::vector<Index> m_numbers; // of the positions to put in, in this order
  std::vector<Position_2> m_positions;
  Star_polygon_2<State> m_polygon;   // around the vertex that goes or comes
  std::size_t m_replaced = 0;        // faces that the last vertex has replaced
  std::vector<Vertex_index> m_rest;  // vertices for remove_rest()
  std::vector<Slot> m_waiting;       // of vertices that jumped
  std::vector<Slot> m_empty;         // of vertices without points
  std::vector<Slot> m_slots;         // of the positions to put in
  std::vector<Index> m_without_slot; // of these, those that need new ones
  std::vector<Point_id> m_coming_ids;
  std::vector<Point> m_coming_points;
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_MENDING_VERTEX_RELOCATION_2_H

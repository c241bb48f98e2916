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
  using Parts = typename State::Parts;
  using Editor = Topology_editor_2<State>;
  using Slot = typename Editor::Slot;
  using Point = typename State::Point;
  using Location = Location_2<State>;
  using Polygon = Star_polygon_2<State>;

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
  bool is_under_way() const { return number_outside() > 0 || !m_coming_ids.empty(); }

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

  // Takes the vertices of a list out so that everything else stays Delaunay. Keeps in the list
  // those for which it is not known how. Everything has to be Delaunay before, except that these
  // vertices may have moved.
  void take_out_of_delaunay(std::vector<Vertex_index>& vertices)
  {
    take_out_of_delaunay(vertices, m_waiting, [](auto& editor, const Polygon& polygon) {
      return editor.take_out(polygon);
    });
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
    if (are_delaunay) {
      make_distinct_by_parts<Parts>(
          m_rest); // those that are close in space are then close in time, too
      take_out_of_delaunay(m_rest, m_empty, [](auto& editor, const Polygon& polygon) {
        return editor.remove(polygon);
      });
    }
    const auto is_outside = [this](Vertex_index v) { return m_state.arrays().is_outside(v); };
    moved.erase(std::remove_if(moved.begin(), moved.end(), is_outside), moved.end());
    return moved;
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
    if (pairs.size() > most ||
        pairs.size() + number_outside() + min_vertices > m_state.number_of_vertices())
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
    std::size_t relocated = 0, parted = 0, merged = 0;
    std::size_t in_parts = 0; // put in without a call of `legalize`
    std::size_t steps = 0;    // of walks since its last call
  };

  // Puts in the waiting vertices, the points that have parted from their vertices, and the new
  // ones. `most_faces()` must be 0 unless everything is Delaunay. A vertex v replaces up to so many
  // faces if everything is known to stay Delaunay then. Otherwise v is just put into a face, and
  // flips around v have to follow. After each vertex, calls `legalize(v, steps, faces)` with the
  // steps of walks since the last call and the number of replaced faces, 0 in the second case.
  // Stops if it is false.
  template <class Most_faces, class Legalize>
  Counts put_in(const std::vector<Point_id>& parted, const Most_faces& most_faces,
                const Legalize& legalize)
  {
    Counts counts;
    m_ids = parted;
    m_ids.insert(m_ids.end(), m_coming_ids.begin(), m_coming_ids.end());
    sort_positions();
    provide_slots();
    if (most_faces() > 0 && m_parts.are_worth(m_numbers.size()))
      put_in_by_parts(counts);
    Location_hint_2 hint{any_vertex(), m_state.number_of_vertices()};
    bool goes_on = true;
    for (std::size_t k = 0; k < m_numbers.size() && goes_on; ++k) {
      const Vertex_index v = m_slots[m_numbers[k]].vertex;
      if (!put_in(m_numbers[k], hint, most_faces(), counts))
        continue;
      if (k + 1 < m_numbers.size())
        hint = hint_at(v); // flips may join v with vertices that are far away
      goes_on = legalize(v, std::exchange(counts.steps, std::size_t(0)), m_replaced);
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
    forget();
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

  // Does take_out(editor, polygon) for the vertices of a list, if that is known to leave everything
  // Delaunay, and lists their slots, by parts, if they are many. Keeps the others in the list.
  template <class Take_out>
  void take_out_of_delaunay(std::vector<Vertex_index>& vertices, std::vector<Slot>& taken,
                            const Take_out& take_out)
  {
    reserve_for_slots(vertices.size());
    if (m_parts.are_worth(vertices.size()))
      m_parts.take_out(vertices, taken, take_out);
    std::size_t left = 0;
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      const Vertex_index v = vertices[i];
      prefetch_stars(m_state, i, vertices.size(), [&](std::size_t k) { return vertices[k]; });
      const bool can_go = m_polygon.read(m_state, v);
      m_editor.prefetch(m_polygon);
      if (can_go && m_polygon.triangulate_as_delaunay(m_state))
        taken.push_back(take_out(m_editor, m_polygon));
      else
        vertices[left++] = v;
    }
    vertices.resize(left);
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

  // THE POSITIONS TO PUT IN -----------------------------------------------------------------------
  // First those of waiting vertices, then those of points that have parted, then those of new
  // points.

  bool waits(Index i) const { return i < m_waiting.size(); }
  bool parts(Index i) const { return !waits(i) && i - m_waiting.size() < number_parted(); }
  std::size_t number_parted() const { return m_ids.size() - m_coming_ids.size(); }
  // The id and the point, unless a vertex waits.
  Point_id id_at(Index i) const { return m_ids[i - m_waiting.size()]; }
  const Point& point_at(Index i) const
  {
    return parts(i) ? m_state.ids().covered_point(id_at(i))
                    : m_coming_points[i - m_waiting.size() - number_parted()];
  }

  // Sorts the positions along a curve.
  void sort_positions()
  {
    const Index number = Index(m_waiting.size() + m_ids.size());
    m_positions.resize(number);
    Parts::for_each_element(number, Parts::size_for(8), [&](std::size_t k) {
      const auto i = Index(k);
      m_positions[i] = m_state.position_in_order(waits(i) ? m_state.positions()[m_waiting[i].vertex]
                                                          : approximation(point_at(i)));
    });
    m_order.template sort<Parts>(m_positions, boost::counting_iterator<Index>(0),
                                 boost::counting_iterator<Index>(number));
    m_numbers.resize(number);
    Parts::for_each_element(number, [&](std::size_t k) { m_numbers[k] = m_order[k]; });
  }

  // Provides each position with a slot: waiting vertices have their own, the others get empty ones,
  // with a fresh vertex there, and new ones where these do not suffice. Numbers of vertices follow
  // a curve, so the empty slots in the order of their numbers go to the positions in the order of
  // the curve: then vertices that are close in space still are close in memory.
  void provide_slots()
  {
    const std::size_t needed = m_ids.size(), empty = m_empty.size();
    reserve_for_slots(needed);
    boost::sort::pdqsort(m_empty.begin(), m_empty.end(), // often sorted already
                         [](const Slot& s, const Slot& t) { return s.vertex < t.vertex; });
    m_slots = m_waiting;
    m_slots.resize(m_numbers.size());
    m_without_slot.clear();
    std::size_t n = 0;
    for (const Index i : m_numbers) {
      if (waits(i))
        continue;
      const std::size_t next = n * empty / needed; // spread evenly, be there more or fewer
      if (++n * empty / needed == next) {
        m_without_slot.push_back(i);
        continue;
      }
      m_editor.renew_vertex(m_empty[next], point_at(i));
      m_slots[i] = m_empty[next];
    }
    if (m_without_slot.empty())
      return;
    m_editor.make_slots(
        m_without_slot.size(),
        [&](std::size_t k) -> const Point& { return point_at(m_without_slot[k]); }, m_empty);
    Parts::for_each_element(m_without_slot.size(), Parts::size_for(8), [&](std::size_t k) {
      m_slots[m_without_slot[k]] = m_empty[empty + k];
    });
  }

  // Keeps in the list of empty slots those whose vertices are outside of faces.
  void drop_full_slots()
  {
    const auto is_full = [this](const Slot& s) { return !m_state.arrays().is_outside(s.vertex); };
    m_empty.erase(std::remove_if(m_empty.begin(), m_empty.end(), is_full), m_empty.end());
  }

  // Puts in, by parts, waiting vertices and new points. What is left stays in m_numbers.
  void put_in_by_parts(Counts& counts)
  {
    const auto slot = [&](Index i) { return parts(i) ? nullptr : &m_slots[i]; };
    const auto position = [this](Index i) { return m_positions[i]; };
    const auto put = [&](auto& editor, Index i, const Polygon& polygon) {
      put_in_at(editor, i, polygon);
    };
    const std::size_t number = m_numbers.size();
    counts.steps += m_parts.put_in(m_numbers, slot, position, any_vertex(), put);
    counts.in_parts = number - m_numbers.size();
    counts.relocated +=
        m_waiting.size() - std::size_t(std::count_if(m_numbers.begin(), m_numbers.end(),
                                                     [this](Index i) { return waits(i); }));
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

  // A neighbor of v, because the number of v itself belongs to its former position.
  Location_hint_2 hint_at(Vertex_index v) const
  {
    Vertex_index nearby = v;
    m_state.arrays().for_each_neighbor(
        v, [&](Vertex_index w) { nearby = w == infinite_index ? nearby : w; });
    const std::size_t spread = 4 * m_state.number_of_vertices() / m_numbers.size();
    return {nearby, Index(spread)};
  }

  // Puts in the vertex of the i-th position. False if another vertex is there, which covers the
  // points now.
  bool put_in(Index i, const Location_hint_2& hint, std::size_t most, Counts& counts)
  {
    const Slot slot = m_slots[i];
    const Location location = locate_vertex(
        m_state, slot.vertex, waits(i) ? nearer_hint(m_state, slot.vertex, hint) : hint);
    counts.steps += location.steps;
    counts.parted += parts(i);
    m_editor.reserve_for_covered(1);
    if (location.vertex != null_index) {
      cover(i, location.vertex, counts);
      return false;
    }
    m_replaced = 0;
    if (find_polygon(slot, location, most))
      put_in_at(m_editor, i, m_polygon);
    else
      put_in_at(m_editor, i, typename Editor::Seen_face{location.face, location.chart});
    counts.relocated += waits(i);
    return true;
  }

  template <class Some_editor, class Place>
  void put_in_at(Some_editor& editor, Index i, const Place& place)
  {
    if (waits(i))
      editor.put_in_again(m_slots[i], place);
    else
      editor.put_in_new(m_slots[i], place, id_at(i));
  }

  void cover(Index i, Vertex_index by, Counts& counts)
  {
    if (waits(i)) {
      m_editor.hand_points_to(by, m_slots[i].vertex, m_state.point(m_slots[i].vertex));
      m_empty.push_back(m_slots[i]);
      ++counts.merged;
    } else {
      const Point p = point_at(i);
      m_editor.place_covered(id_at(i), by, p);
    }
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
  std::vector<Point_id> m_ids;       // of the points to put in, first those that have parted
  Position_vector m_positions;       // to put in
  std::vector<Index> m_numbers;      // of these, in this order
  Polygon m_polygon;                 // around the vertex that goes or comes
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

// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_UPDATE_VERTEX_RELOCATION_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_UPDATE_VERTEX_RELOCATION_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/core/Computed_geometry_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/core/Flat_arrays_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/core/Points_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/core/Processor_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/core/Spatial_order_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/proof/Edge_test_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/topology/Halfedge_arrays_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/topology/Star_polygon_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/topology/Topology_editor_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/policies/accepts_inexact_predicates_2.h>
#include <CGAL/enum.h>

#include <boost/iterator/counting_iterator.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Dynamic_Delaunay_triangulations_2 {
namespace internal {

// JUMPS -------------------------------------------------------------------------------------------

// Finds the vertices that jumped: relative to their neighbors, they moved farther than the extent
// of their neighborhood. A vertex that leaves its neighborhood inverts a face, so only vertices at
// edges with inverted faces are examined. Jumps affect only the cost, so plain floating point
// decides.
template <class State>
class Jumper_search_2
{
public:
  explicit Jumper_search_2(const State& state)
    : m_state(state)
  {
  }

  // Finds jumpers among the vertices of these edges, in the order in which they are met. This and
  // all functions below need the previous positions.
  const std::vector<Index>& find_jumpers(const std::vector<Index>& edges)
  {
    collect_from_parts(edges.size(), m_suspects, [&](std::size_t i, Work& work) {
      prefetch_edges(edges, i);
      look_at(m_state.arrays().edge(edges[i]), work.found);
    });
    m_seen.clear(m_state.arrays().number_of_vertices());
    m_suspects.erase(std::remove_if(m_suspects.begin(), m_suspects.end(),
                                    [this](Index v) { return !m_seen.insert(v); }),
                     m_suspects.end());
    collect_from_parts(m_suspects.size(), m_jumpers, [&](std::size_t i, Work& work) {
      if (has_jumped(m_suspects[i], work))
        work.found.push_back(m_suspects[i]);
    });
    return m_jumpers;
  }

  // For each of these edges, finds the one of its vertices that moved farthest relative to the
  // others. Skips edges with a vertex found before, so that each edge has only one.
  const std::vector<Index>& find_farthest(const std::vector<Index>& edges)
  {
    m_jumpers.clear();
    m_seen.clear(m_state.arrays().number_of_vertices());
    for (const Index e : edges) {
      const Edge_2& edge = m_state.arrays().edge(e);
      const std::array<Index, 4> vertices{edge.source, edge.target, edge.left, edge.right};
      const auto is_taken = [this](Index v) { return m_seen.contains(v); };
      if (std::any_of(vertices.begin(), vertices.end(), is_taken))
        continue;
      const Index v = farthest_of(vertices);
      if (v != null_index && m_seen.insert(v))
        m_jumpers.push_back(v);
    }
    return m_jumpers;
  }

  // Whether v has jumped, if no other vertex has moved. `false` if it has no finite neighbors.
  bool has_jumped_alone(Index v) const
  {
    const Position_2 place = previous_position(v);
    const double square = squared_distance(m_state.positions()[v], place);
    std::size_t neighbors = 0, passed = 0;
    m_state.arrays().for_each_neighbor(v, [&](Index w) {
      const double squared_length = squared_distance(place, m_state.positions()[w]);
      neighbors += w != infinite_index;
      passed += square > max_way * max_way * squared_length; // false for the infinite one
    });
    return passed > neighbors / 4; // as has_jumped() has it
  }

private:
  using Parts = typename State::Parts;

  // What each thread needs: what it finds, and how the neighbors of a vertex moved.
  struct Work
  {
    std::vector<Index> found;
    std::vector<double> x, y, squared_lengths;
  };

  // Calls f(i, work) for each i below `size`, and lists what is found, in the order of i.
  template <class Function>
  void collect_from_parts(std::size_t size, std::vector<Index>& found, const Function& f)
  {
    // an i takes up to a microsecond
    constexpr std::size_t least = (std::max)(Parts::usual_size / 256, std::size_t(1));
    m_works.resize((std::max)(Parts::number(size, least), m_works.size()));
    Parts::for_each(size, least, [&](std::size_t part, std::size_t first, std::size_t beyond) {
      m_works[part].found.clear();
      for (std::size_t i = first; i < beyond; ++i)
        f(i, m_works[part]);
    });
    found.clear();
    for (std::size_t part = 0; part < Parts::number(size, least); ++part)
      found.insert(found.end(), m_works[part].found.begin(), m_works[part].found.end());
  }

  // `null_index` if all have moved alike.
  Index farthest_of(const std::array<Index, 4>& vertices)
  {
    Work& work = m_works.front();
    work.x.clear();
    work.y.clear();
    for (const Index v : vertices)
      if (v != infinite_index) {
        const Position_2 step = displacement(v);
        work.x.push_back(step.x);
        work.y.push_back(step.y);
      }
    const Position_2 usual{quantile(work.x, 2), quantile(work.y, 2)};
    Index farthest = null_index;
    double longest = 0;
    for (const Index v : vertices)
      if (v != infinite_index) {
        const Position_2 relative = displacement(v) - usual;
        const double length = dot(relative, relative);
        if (length > longest) {
          longest = length;
          farthest = v;
        }
      }
    return farthest;
  }

  // In units of a short edge. Flips take one or two per spacing that a vertex travels, at a tenth
  // of the cost of taking it out and putting it in again, but from about this length on they get
  // stuck. The limit is below 1, because a vertex that returns from far away moved by its distance
  // from all its neighbors.
  static constexpr double max_way = 0.9;

  // Lists those vertices that moved differently from each of the others, and not just a little. At
  // 100,000 points, reading these scattered data takes most of the search.
  void look_at(const Edge_2& edge, std::vector<Index>& suspects) const
  {
    std::array<Index, 4> vertices;
    std::array<Position_2, 4> places, steps;
    std::size_t size = 0;
    for (const Index v : {edge.source, edge.target, edge.left, edge.right})
      if (v != infinite_index) {
        vertices[size] = v;
        places[size] = previous_position(v);
        steps[size] = m_state.positions()[v] - places[size];
        ++size;
      }
    for (std::size_t i = 0; i < size; ++i) {
      constexpr double infinity = std::numeric_limits<double>::infinity();
      double difference = infinity, distance = infinity;
      for (std::size_t k = 0; k < size; ++k)
        if (k != i)
          difference = (std::min)(difference, squared_distance(steps[i], steps[k]));
      if (difference == 0)
        continue;
      for (std::size_t k = 0; k < size; ++k)
        if (k != i)
          distance = (std::min)(distance, squared_distance(places[i], places[k]));
      if (16 * difference > distance)
        suspects.push_back(vertices[i]);
    }
  }

  bool has_jumped(Index v, Work& work) const
  {
    collect_neighbors(v, work);
    if (work.squared_lengths.empty())
      return false;
    const Position_2 step = displacement(v);
    const Position_2 relative{farthest_from_median(step.x, work.x),
                              farthest_from_median(step.y, work.y)};
    return dot(relative, relative) > max_way * max_way * quantile(work.squared_lengths, 4);
  }

  // Prefetches in steps, each of which reads what the one before has fetched.
  void prefetch_edges(const std::vector<Index>& edges, std::size_t i) const
  {
    constexpr std::size_t ahead = 4;
    if (i + 2 * ahead < edges.size())
      prefetch(&m_state.arrays().edge(edges[i + 2 * ahead]));
    if (i + ahead < edges.size())
      for_each_vertex(edges[i + ahead], [this](Index v) { m_state.prefetch_positions(v); });
  }

  template <class Function>
  void for_each_vertex(Index e, const Function& f) const
  {
    const Edge_2& edge = m_state.arrays().edge(e);
    for (const Index v : {edge.source, edge.target, edge.left, edge.right})
      f(v);
  }

  // Collects how far each neighbor moved, and its distance from v in the last frame.
  void collect_neighbors(Index v, Work& work) const
  {
    work.x.clear();
    work.y.clear();
    work.squared_lengths.clear();
    const Position_2 place = previous_position(v);
    m_state.arrays().for_each_neighbor(v, [&](Index w) {
      if (w == infinite_index)
        return;
      const Position_2 step = displacement(w);
      work.x.push_back(step.x);
      work.y.push_back(step.y);
      work.squared_lengths.push_back(squared_distance(place, previous_position(w)));
    });
  }

  Position_2 previous_position(Index v) const { return m_state.previous_position(v); }

  Position_2 displacement(Index v) const { return m_state.positions()[v] - previous_position(v); }

  // The distance of x from the median; if there are two medians, from the farther one, because half
  // of a vertex's neighbors may have jumped along with it.
  static double farthest_from_median(double x, std::vector<double>& values)
  {
    const double upper = quantile(values, 2);
    double difference = std::abs(x - upper);
    if (values.size() % 2 == 0) {
      const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
      difference = (std::max)(difference, std::abs(x - *std::max_element(values.begin(), middle)));
    }
    return difference;
  }

  // One in `part` of the values is smaller than this.
  static double quantile(std::vector<double>& values, std::size_t part)
  {
    const auto place = values.begin() + std::ptrdiff_t(values.size() / part);
    std::nth_element(values.begin(), place, values.end());
    return *place;
  }

  const State& m_state;
  Index_set_2 m_seen;
  std::vector<Index> m_suspects, m_jumpers;
  std::vector<Work> m_works = std::vector<Work>(1);
};

// POINT LOCATION ----------------------------------------------------------------------------------

// The place of a point: a vertex, or a face that contains it, boundary included. The face is
// infinite if the point is outside of the hull.
struct Place_2
{
  Index face = null_index;
  Index vertex = null_index;
  Index steps = 0;        // of the walk to find it
  bool is_inside = false; // strictly inside of a finite face
};

// Jump and walk (Mücke, Saias and Zhu, 1999): walks from the nearest of some vertices through
// faces, always across an edge that has the point on its other side. In a Delaunay triangulation
// such a walk meets no face twice. In other ones it may not end, or lead nan_point; then the result
// is any face that contains the point, or just any face.
template <class State>
class Point_location_2
{
  using Arrays = Halfedge_arrays_2;

public:
  explicit Point_location_2(const State& state)
    : m_state(state)
    , m_predicates(state)
  {
  }

  // Locates vertex v, which is in no face. `nearby` is a finite vertex in some face. The numbers of
  // the vertices around v are expected to differ from its number by at most `spread`.
  Place_2 locate(Index v, Index nearby, Index spread) const
  {
    const Arrays& arrays = m_state.arrays();
    const Index start = arrays.corner(nearest(v, nearby, spread)) / 3;
    Index steps = 0;
    Index h = way_out(start, v);
    if (h == null_index)
      return place_in(start, v, steps);
    while (++steps < arrays.number_of_faces()) {
      const Index entry = arrays.twin(h);
      h = way_on(entry, v, steps % 2 == 0);
      if (h == null_index)
        return place_in(entry / 3, v, steps);
    }
    for (Index g = 0; g < arrays.number_of_faces(); ++g)
      if (!arrays.is_empty_face(g) && way_out(g, v) == null_index)
        return place_in(g, v, steps);
    return place_in(start, v, steps);
  }

private:
  // A vertex near v. If `nearby` says little, first takes the best of half to all of the
  // cube root of n vertices, evenly spread over the numbers. Then searches around the best one at
  // ever smaller steps of the numbers, which follow a curve through the plane. At 100,000 points
  // the second search takes as long as two steps of the walk, and saves some forty.
  Index nearest(Index v, Index nearby, Index spread) const
  {
    const Index vertices = m_state.number_of_vertices();
    Index samples = 1;
    while (8 * std::size_t(samples) * samples * samples <= vertices)
      samples *= 2;
    Nearest best{v, nearby, squared_distance(position(v), position(nearby))};
    if (spread > vertices / samples) {
      for (Index i = 0; i < samples; ++i)
        consider(1 + Index(std::size_t(i) * vertices / samples), best);
      spread = vertices / samples / 2;
    }
    for (Index step = spread; step > 0; step /= 2) {
      const Index middle = best.vertex;
      if (middle > step)
        consider(middle - step, best);
      if (step <= vertices - middle)
        consider(middle + step, best);
    }
    return best.vertex;
  }

  struct Nearest
  {
    Index of, vertex;
    double squared_distance;
  };

  void consider(Index w, Nearest& best) const
  {
    const double square = squared_distance(position(best.of), position(w));
    if (square < best.squared_distance && !m_state.arrays().is_outside(w)) {
      best.squared_distance = square;
      best.vertex = w;
    }
  }

  const Position_2& position(Index v) const { return m_state.positions()[v]; }

  // The edge of face f that separates it from v; `null_index` if v is in f.
  Index way_out(Index f, Index v) const
  {
    const Arrays& arrays = m_state.arrays();
    for (Index h = 3 * f; h < 3 * f + 3; ++h) // an infinite face has one finite edge
      if (arrays.apex(h) == infinite_index)
        return orientation(h, v) == LEFT_TURN ? null_index : h;
    for (Index h = 3 * f; h < 3 * f + 3; ++h)
      if (orientation(h, v) == RIGHT_TURN)
        return h;
    return null_index;
  }

  // The same for the face of half-edge `entry`, which has v strictly on its left. `turn` determines
  // which edge is tested first: always preferring the same one can cause detours.
  Index way_on(Index entry, Index v, bool turn) const
  {
    if (m_state.arrays().apex(entry) == infinite_index)
      return null_index;
    const Index next = Arrays::next(entry), previous = Arrays::previous(entry);
    const Index first = turn ? next : previous, second = turn ? previous : next;
    if (orientation(first, v) == RIGHT_TURN)
      return first;
    return orientation(second, v) == RIGHT_TURN ? second : null_index;
  }

  Orientation orientation(Index h, Index v) const
  {
    const Arrays& arrays = m_state.arrays();
    return m_predicates.orientation(arrays.source(h), arrays.target(h), v);
  }

  Place_2 place_in(Index f, Index v, Index steps) const
  {
    Place_2 place;
    place.steps = steps;
    place.face = f;
    place.is_inside = is_strictly_inside(f, v);
    if (!place.is_inside)
      for (const Index w : m_state.arrays().face(f))
        if (w != infinite_index && m_predicates.compare_xy(v, w) == EQUAL)
          place.vertex = w;
    return place;
  }

  bool is_strictly_inside(Index f, Index v) const
  {
    const auto corners = m_state.arrays().face(f);
    return std::find(corners.begin(), corners.end(), infinite_index) == corners.end() &&
           orientation(3 * f, v) == LEFT_TURN && orientation(3 * f + 1, v) == LEFT_TURN &&
           orientation(3 * f + 2, v) == LEFT_TURN;
  }

  const State& m_state;
  Vertex_predicates_2<State> m_predicates;
};

// RELOCATION --------------------------------------------------------------------------------------

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

public:
  Vertex_relocation_2(State& state, Editor& editor)
    : m_state(state)
    , m_editor(editor)
    , m_location(state)
    , m_meeting_order(state)
  {
  }

  // Announces points to be inserted, with the next ids, after the removals. Takes the lists, and
  // leaves others, unless it throws.
  void announce(std::vector<Index>& ids, std::vector<Point>& points)
  {
    m_editor.reserve_ids(ids); // nothing throws from here on
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

  // Takes v out, to be put in again at its present position.
  void take_out(Index v)
  {
    reserve_for_slot();
    triangulate_anyhow_without(v);
    m_waiting.push_back(m_editor.take_out(m_polygon));
  }

  // The same if everything is Delaunay, except that v may have moved, and if it is known how to
  // leave everything so. False if not: then nothing is done.
  bool take_out_of_delaunay(Index v)
  {
    reserve_for_slot();
    const bool is_known = triangulate_as_delaunay_without(v);
    if (is_known)
      m_waiting.push_back(m_editor.take_out(m_polygon));
    return is_known;
  }

  // Removes the points with these ids. A representative leaves its vertex to a duplicate, if there
  // is one. Returns the vertices that have moved by that, because such a duplicate is to part.
  //
  // If everything is Delaunay (`are_delaunay`), it stays so. Other vertices keep their points until
  // remove_rest().
  std::vector<Index> remove(const std::vector<Index>& ids, bool are_delaunay)
  {
    std::vector<Index> moved;
    m_editor.reserve_for_removals(ids.size());
    m_rest.clear();
    for (const Index id : ids)
      remove(id, are_delaunay, moved);
    const auto is_outside = [this](Index v) { return m_state.arrays().is_outside(v); };
    moved.erase(std::remove_if(moved.begin(), moved.end(), is_outside), moved.end());
    return moved;
  }

  // Removes the other vertices of the last call of remove(). Whether there were any.
  bool remove_rest()
  {
    for (const Index v : m_rest) {
      reserve_for_slot();
      triangulate_anyhow_without(v);
      m_empty.push_back(m_editor.remove(m_polygon));
    }
    return !m_rest.empty();
  }

  // Merges vertices of the list that coincide: the one with the smallest id stays, and the points
  // of the others become duplicates there. Returns how many vertices were removed. Removes none if
  // these would be more than `most`, or would leave fewer than three.
  std::size_t merge(const std::vector<Index>& vertices, std::size_t most)
  {
    const auto& ids = m_state.ids();
    m_meeting_order.sort(vertices.begin(), vertices.end());
    std::vector<std::pair<Index, Index>> pairs;
    m_meeting_order.for_each_coincident_pair([&](Index v, Index w) {
      pairs.emplace_back(ids.representative(v), ids.representative(w));
    });
    constexpr std::size_t min_vertices = 3;
    if (pairs.size() > most || pairs.size() + m_waiting.size() + m_empty.size() + min_vertices >
                                   m_state.number_of_vertices())
      return 0;
    m_editor.reserve_for_duplicates(pairs.size());
    for (const auto& [i, j] : pairs) {
      Index stays = ids.vertex(i), goes = ids.vertex(j);
      if (ids.representative(goes) < ids.representative(stays))
        std::swap(stays, goes);
      reserve_for_slot();
      const Point p = m_state.point(goes);
      triangulate_anyhow_without(goes);
      m_empty.push_back(m_editor.merge(m_polygon, stays, p));
    }
    return pairs.size();
  }

  // IN ------------------------------------------------------------------------------------------

  struct Counts
  {
    std::size_t relocated = 0, parted = 0, merged = 0, steps = 0;
  };

  // Puts in the waiting vertices, the duplicates that have left their vertices, and the new points.
  // Everything stays Delaunay, if it is and no more than `most_faces()` are replaced, which is 0 if
  // it is not. After each vertex, `settle(v, steps, faces)` is called, with the number of steps
  // that all walks so far took, and the number of faces that were replaced: 0 if v was just put
  // into a face, so that flips around it have to follow. If it returns false, no more are put in.
  template <class Most_faces, class Settle>
  Counts put_in(const std::vector<Index>& parted_duplicates, const Most_faces& most_faces,
                const Settle& settle)
  {
    Counts counts;
    collect_places(parted_duplicates);
    Hint hint{any_vertex(), m_state.number_of_vertices()};
    for (std::size_t k = 0; k < m_order.size(); ++k) {
      const std::size_t i = m_order[k];
      const std::size_t most = most_faces();
      m_replaced = 0;
      const Index v = i < m_waiting.size()
                          ? put_in_again(m_waiting[i], hint, most, counts)
                          : insert(parted_duplicates, i - m_waiting.size(), hint, most, counts);
      if (v == null_index)
        continue;
      if (k + 1 < m_order.size())
        hint = hint_at(v); // flips may join v with vertices that are far away
      if (!settle(v, counts.steps, m_replaced))
        return counts;
    }
    forget_all();
    return counts;
  }

  // Drops the empty slots. Whether there were any: then vertices have other numbers.
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
    m_editor.note_everything_is_new();
    for (const Slot& slot : m_waiting)
      if (m_state.arrays().is_outside(slot.vertex) && m_state.ids().has_representative(slot.vertex))
        m_editor.put_in(slot, m_state.arrays().corner(any_vertex()) / 3);
    m_editor.drop_in_need(m_empty);
    for_each_coming([this](Index id, const Point&) { m_editor.release_id(id); });
    m_empty.clear();
    forget_all();
  }

private:
  // Reserves all memory that give_up() would need for one more slot.
  void reserve_for_slot()
  {
    const std::size_t max_slots = m_waiting.size() + m_empty.size() + 1;
    reserve_extra(m_waiting, 1);
    reserve_extra(m_empty, 1 + m_waiting.size());
    m_editor.reserve_for_drop(2 * max_slots);
  }

  bool triangulate_as_delaunay_without(Index v)
  {
    m_polygon.read(m_state, v);
    m_editor.prefetch(m_polygon);
    return m_polygon.triangulate_as_delaunay(m_state);
  }

  // The faces around v have it at its previous position.
  void triangulate_anyhow_without(Index v)
  {
    m_polygon.read(m_state, v);
    m_polygon.triangulate_anyhow(m_state, m_state.previous_position(v));
  }

  void remove(Index id, bool are_delaunay, std::vector<Index>& moved)
  {
    const auto& ids = m_state.ids();
    const Index v = ids.vertex(id);
    if (ids.is_representative(id)) {
      const Index successor = ids.find_duplicate_at(v, [](const auto&) { return true; });
      if (successor == null_index)
        return remove_vertex(v, are_delaunay);
      const Point place = m_state.point(v);
      if (!coincide(m_state.traits(), place, ids.duplicate(successor).point))
        moved.push_back(v);
      m_editor.exchange_representative(successor, v, place);
    }
    m_editor.remove_duplicate(id);
  }

  // Removes v if that leaves everything Delaunay, otherwise lists it.
  void remove_vertex(Index v, bool are_delaunay)
  {
    reserve_extra(m_rest, 1);
    reserve_for_slot();
    if (are_delaunay && triangulate_as_delaunay_without(v))
      m_empty.push_back(m_editor.remove(m_polygon));
    else
      m_rest.push_back(v);
  }

  // Collects the positions to put in: those of waiting vertices, then those of parted duplicates,
  // then those of new points.
  void collect_places(const std::vector<Index>& parted_duplicates)
  {
    m_places.clear();
    for (const Slot& slot : m_waiting)
      m_places.push_back(m_state.positions()[slot.vertex]);
    for (const Index id : parted_duplicates)
      m_places.push_back(approximation(m_state.ids().duplicate(id).point));
    for (const Point& p : m_coming_points)
      m_places.push_back(approximation(p));
    const boost::counting_iterator<Index> first(0), beyond(Index(m_places.size()));
    m_order.sort(m_places, first, beyond);
  }

  // A finite vertex that is in some face.
  Index any_vertex() const
  {
    Index v = 1;
    while (m_state.arrays().is_outside(v))
      ++v;
    return v;
  }

  // Where to start the search for the next position.
  struct Hint
  {
    Index nearby, spread;
  };

  // A neighbor of v, because the number of v itself belongs to its former position.
  Hint hint_at(Index v) const
  {
    Index nearby = v;
    m_state.arrays().for_each_neighbor(v,
                                       [&](Index w) { nearby = w == infinite_index ? nearby : w; });
    const std::size_t spread = 4 * m_state.number_of_vertices() / m_order.size();
    return {nearby, Index(spread)};
  }

  // Returns v, or `null_index` if another vertex is there already, and now has the points of v.
  Index put_in_again(const Slot& slot, const Hint& hint, std::size_t most, Counts& counts)
  {
    const Index v = slot.vertex;
    const Place_2 place = m_location.locate(v, hint.nearby, hint.spread);
    counts.steps += place.steps;
    if (place.vertex == null_index) {
      if (find_polygon(slot, place, most))
        m_editor.put_in_again(slot, m_polygon);
      else
        m_editor.put_in_again(slot, place.face);
      ++counts.relocated;
      return v;
    }
    m_editor.reserve_for_duplicates(1);
    m_editor.hand_points_to(place.vertex, v, m_state.point(v));
    m_empty.push_back(slot);
    ++counts.merged;
    return null_index;
  }

  // The same for a duplicate that parts, or a new point.
  Index insert(const std::vector<Index>& parted_duplicates, std::size_t i, const Hint& hint,
               std::size_t most, Counts& counts)
  {
    const auto& ids = m_state.ids();
    const bool parts = i < parted_duplicates.size();
    const std::size_t coming = i - parted_duplicates.size();
    const Index id = parts ? parted_duplicates[i] : m_coming_ids[coming];
    const Point p = parts ? ids.duplicate(id).point : m_coming_points[coming];
    counts.parted += parts;
    m_editor.reserve_for_duplicates(1);
    const Slot slot = take_slot(p);
    const Place_2 place = m_location.locate(slot.vertex, hint.nearby, hint.spread);
    counts.steps += place.steps;
    if (place.vertex != null_index) {
      m_editor.place_duplicate(id, place.vertex, p);
      return null_index;
    }
    const bool is_found = find_polygon(slot, place, most);
    m_empty.pop_back(); // nothing throws from here on
    if (is_found)
      m_editor.put_in_new(slot, m_polygon, id);
    else
      m_editor.put_in_new(slot, place.face, id);
    return slot.vertex;
  }

  // Finds the polygon that the slot's vertex gets, if everything is to stay Delaunay and that is
  // possible. Reserves memory for the new edges, also if not.
  bool find_polygon(const Slot& slot, const Place_2& place, std::size_t most)
  {
    constexpr std::size_t edges_of_three_faces = 6;
    const bool is_found = State::predicates_are_exact && most > 0 && place.is_inside &&
                          m_polygon.find_as_delaunay(m_state, place.face, {}, slot.vertex, most);
    if (is_found) {
      m_replaced = m_polygon.faces().size();
      m_polygon.add(slot);
    }
    m_editor.reserve_for_new_edges(is_found ? m_polygon.edges().size() : edges_of_three_faces);
    return is_found;
  }

  // The last empty slot, with a vertex at p. It stays in the list of empty slots for now.
  Slot take_slot(const Point& p)
  {
    if (m_empty.empty()) {
      reserve_for_slot();
      m_empty.push_back(m_editor.make_slot(p));
    } else
      m_editor.renew_vertex(m_empty.back(), p);
    return m_empty.back();
  }

  void forget_all()
  {
    m_waiting.clear();
    m_coming_ids.clear();
    m_coming_points.clear();
  }

  const State& m_state;
  Editor& m_editor;
  Point_location_2<State> m_location;
  Vertex_order_2<State> m_meeting_order;
  Spatial_order_2 m_order;
  std::vector<Position_2> m_places;
  Star_polygon_2<State> m_polygon; // around the vertex that goes or comes
  std::size_t m_replaced = 0;      // faces that the last vertex has replaced
  std::vector<Index> m_rest;       // vertices that are to go
  std::vector<Slot> m_waiting;     // of vertices that jumped
  std::vector<Slot> m_empty;       // of vertices without points
  std::vector<Index> m_coming_ids;
  std::vector<Point> m_coming_points;
};

} // namespace internal
} // namespace Dynamic_Delaunay_triangulations_2
} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_UPDATE_VERTEX_RELOCATION_2_H

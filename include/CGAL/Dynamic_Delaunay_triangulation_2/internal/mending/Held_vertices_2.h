// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_MENDING_HELD_VERTICES_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_MENDING_HELD_VERTICES_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Flat_arrays.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/mending/Hull_flips_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/mending/Spatial_parts_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Flat_elements_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Points_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/topology/Divided_list.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/topology/Halfedge_arrays_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/topology/Star_polygon_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/topology/Topology_editor_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/topology/Topology_parts_2.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <numeric>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

// Holds vertices back so that no face is inverted. Flips then end with the Delaunay triangulation
// of the positions as they stand. After that, lets the held vertices move on to their targets.
//
// Where the vertices rest, all faces must be counterclockwise: at their positions before the
// motion. A held vertex is first carried along: it goes where the mean displacement of its free
// neighbors takes it. If a face around it is inverted even so, it stays at its rest position. This
// ends: with all vertices at rest, no face is inverted.
template <class State>
class Held_vertices_2
{
  using Arrays = Halfedge_arrays_2;
  using Editor = Topology_editor_2<State>;
  using Stored_point = typename State::Positions::Stored_point;
  static constexpr bool can_place = State::Positions::can_place;

public:
  Held_vertices_2(const State& state, Editor& editor)
    : m_state(state)
    , m_editor(editor)
    , m_hull_flips(state, editor)
  {
  }

  bool empty() const { return m_held.empty(); }
  std::size_t size() const { return m_held.size(); }

  // What to do at the hull, or at the sides of a slab.
  enum class At_hull {
    PEEL, // flip faces away that their apex has left through an edge of the hull
    HOLD  // flip nothing, and hold vertices that go past others along the hull
  };

  // Makes all finite faces counterclockwise; only faces at these edges may be inverted. Holds about
  // `most` vertices at most. False if that was not enough.
  bool hold(const std::vector<Edge_index>& edges, std::size_t most, At_hull at_hull)
  {
    reserve_bonds();
    m_peeled.clear();
    m_is_hull_held = State::has_hull && at_hull == At_hull::HOLD;
    collect_inverted(edges);
    if (at_hull == At_hull::PEEL)
      peel();
    if (m_is_hull_held)
      m_state.arrays().for_each_corner(infinite_index, [&](Halfedge_index h) {
        add_if_inverted(Arrays::face_of(h), m_inverted);
      });
    std::vector<Held> Part::*held = &Part::held; // in the second division `beside`
    std::size_t in_parts = 0;
    work_in_divisions(
        m_state, [this] { return 2 * m_inverted.size(); },
        [this](std::size_t i) { return finite_vertex(m_inverted[i / 2]); },
        [&](const Topology_parts_2& topology) {
          in_parts += hold_in_parts(topology, most - (std::min)(in_parts, most), held);
          held = &Part::beside;
        });
    hold_beside_parts(most - (std::min)(in_parts, most));
    if (held == &Part::held)
      std::sort(m_held.begin(), m_held.end()); // nearly a spatial order
    else
      take_over_from_parts(Topology_parts_2(m_state));
    return m_inverted.empty() && m_left.empty() && m_held.size() <= most;
  }

  // Lists the edges whose test hold() may have changed, without those that the filter proves.
  // Threads share the held vertices.
  void append_unproved(std::vector<Edge_index>& unproved) const
  {
    append_by_parts<Parts>(m_held.size(), least_of_part, unproved,
                           [&](std::size_t i, std::size_t beyond, std::vector<Edge_index>& some) {
                             std::vector<Edge_index> edges;
                             for (; i < beyond; ++i) {
                               prefetch_stars(i, beyond, itself);
                               append_edges_that_see(m_held[i].vertex, edges);
                             }
                             typename State::Edge_test(m_state).append_unproved(edges, some);
                           });
    unproved.insert(unproved.end(), m_peeled.begin(), m_peeled.end());
  }

  // Moves each held vertex on, the whole way to its target, half of it or a quarter, as far as the
  // faces around it stay counterclockwise. After each move calls `flip(edges)` with the edges whose
  // test the move may have changed. Returns whether enough have moved to go on: to take a vertex
  // out and to put it in again costs as much as ten vain tries.
  //
  // Leaves alone the vertices on the hull, which might break it, and those that go far: moving them
  // through the faces on their way would cost more than to take them out.
  //
  // If they are many, calls `in_parts(topology)` before, which has to call release_in_part() for
  // all parts.
  template <class In_parts, class Flip>
  bool release(const In_parts& in_parts, const Flip& flip)
  {
    constexpr std::size_t pieces = 4, // of work: a vertex and the flips around it
        enough = 32;                  // of which one moves
    m_waiting.resize(m_held.size());
    std::iota(m_waiting.begin(), m_waiting.end(), Index(0)); // this round has tried none
    work_in_divisions(
        m_state, [this] { return pieces * m_waiting.size(); },
        [this](std::size_t i) { return m_held[m_waiting[i / pieces]].vertex; },
        [&](const Topology_parts_2& topology) {
          m_divided_waiting.template divide<Parts>(
              m_waiting, topology.number(),
              [&](std::size_t i) { return topology.part_of(m_held[m_waiting[i]].vertex); });
          in_parts(topology);
          list_waiting();
        });
    for (std::size_t n = 0; n < m_waiting.size(); ++n) {
      prefetch_stars(n, m_waiting.size(), [this](std::size_t i) { return m_waiting[i]; });
      Held& held = m_held[m_waiting[n]];
      m_changed.clear();
      held.share = is_to_be_taken_out(held) ? 0 : move_on(held);
      if (!m_changed.empty())
        flip(m_changed);
    }
    const std::size_t tried = m_held.size();
    std::atomic<std::size_t> moved{0};
    m_kept.clear();
    append_by_parts<Parts>(m_held.size(), Parts::size_for(32), m_kept,
                           [&](std::size_t i, std::size_t beyond, std::vector<Held>& kept) {
                             std::size_t moved_here = 0;
                             for (; i < beyond; ++i) {
                               moved_here += m_held[i].share > 0;
                               if (m_held[i].share == 1)
                                 m_bonds[m_held[i].vertex] = Bond::FREE;
                               else {
                                 kept.push_back(m_held[i]);
                                 kept.back().share = untried;
                               }
                             }
                             moved.fetch_add(moved_here, std::memory_order_relaxed);
                           });
    m_held.swap(m_kept);
    return enough * moved > tried;
  }

  // Moves on those whose stars are inside of the part; release() moves the others, and counts
  // these. Those that cannot move wait for the next round: to try all of them again at once, one
  // after the other, took 4 percent of the time of a frame of 1,000,000 points with steps of 0.1
  // spacings, and 6 on a torus. Threads may do so at the same time, each in another part.
  template <class Flip>
  void release_in_part(const Topology_parts_2& topology, std::size_t part, const Flip& flip)
  {
    std::vector<Edge_index> changed;
    const Index* const waiting = m_divided_waiting.begin(part);
    const std::size_t number = m_divided_waiting.size(part);
    for (std::size_t i = 0; i < number; ++i) {
      prefetch_stars(i, number, [&](std::size_t k) { return waiting[k]; });
      Held& held = m_held[waiting[i]];
      if (is_to_be_taken_out(held) || !topology.has_star(part, held.vertex))
        continue;
      held.share = move_in_star(held);
      if (held.share == 0) {
        if (may_flip_into_gap(held.vertex))
          held.share = untried;
        continue;
      }
      changed.clear();
      append_edges_that_see(held.vertex, changed);
      flip(changed);
    }
  }

  // Lists the vertices that are still held.
  void list(std::vector<Vertex_index>& vertices) const
  {
    vertices.clear();
    for (const Held& held : m_held)
      vertices.push_back(held.vertex);
  }

  // Puts all held vertices at their targets, whatever that does to faces.
  void let_go()
  {
    for (Part& part : m_parts) { // an exception may have left some there
      let_go(part.held);
      let_go(part.beside);
    }
    let_go(m_held);
  }

  // Whether the way of v, relative to its neighbors, is longer than its edges were.
  bool goes_far(Vertex_index v) const { return goes_far(v, mean_displacement(v)); }

  // Holds a vertex that is not held yet, whatever its faces are.
  void hold_at_rest(Vertex_index v)
  {
    reserve_bonds();
    m_held.push_back({v, true, untried, m_editor.stored(v)});
    put_to_rest(v);
  }

private:
  using Parts = typename State::Parts;

  enum class Bond : std::uint8_t { FREE, CARRIED, AT_REST };

  static constexpr double untried = -1;

  struct Held
  {
    Vertex_index vertex;
    bool goes_far;
    double share; // of its way, that it has moved in this round of release(), or `untried`
    Stored_point target;

    bool operator<(const Held& other) const { return vertex < other.vertex; }
  };

  // What is held in a part of the first division, and in one of the second, beside the first.
  struct Part
  {
    std::vector<Held> held, beside;
    std::vector<Face_index> inverted, left;
  };

  static std::size_t itself(std::size_t i) { return i; }

  static constexpr std::size_t least_of_part = Parts::size_for(256);

  // Lists those that this round of release() has not tried.
  void list_waiting()
  {
    m_waiting.clear();
    append_by_parts<Parts>(m_held.size(), Parts::size_for(8), m_waiting,
                           [&](std::size_t i, std::size_t beyond, std::vector<Index>& waiting) {
                             for (; i < beyond; ++i)
                               if (m_held[i].share == untried)
                                 waiting.push_back(Index(i));
                           });
  }

  void let_go(std::vector<Held>& all)
  {
    for (const Held& held : all) {
      m_editor.restore(held.vertex, held.target);
      m_bonds[held.vertex] = Bond::FREE;
    }
    all.clear();
  }

  // MEMORY --------------------------------------------------------------------------------------

  // Fetches the corners of the faces at an edge that is due soon.
  void prefetch_ahead(const std::vector<Edge_index>& edges, std::size_t i) const
  {
    constexpr std::size_t near_ahead = 8, ahead = 16, far_ahead = 24;
    const auto& arrays = m_state.arrays();
    if (i + far_ahead >= edges.size())
      return;
    arrays.prefetch_edge(edges[i + far_ahead]);
    arrays.prefetch_face_at(edges[i + ahead]);
    prefetch_corners(arrays.edge(edges[i + ahead]), m_state.positions().data());
    arrays.prefetch_face_beyond(edges[i + near_ahead]);
  }

  // Of held vertices, the i-th of which is m_held[held_at(i)].
  template <class Held_at>
  void prefetch_stars(std::size_t first, std::size_t beyond, const Held_at& held_at) const
  {
    internal::prefetch_stars<true>(m_state, first, beyond,
                                   [&](std::size_t i) { return m_held[held_at(i)].vertex; });
  }

  // FACES ---------------------------------------------------------------------------------------

  bool is_right(Face_index f) const
  {
    if (m_state.is_infinite_face(f))
      return !m_is_hull_held || !m_hull_flips.is_folded(f);
    const auto [h, i, k] = Arrays::halfedges_of(f);
    constexpr typename State::Chart chart{};
    const typename State::Predicates predicates(m_state);
    return predicates.orientation(m_state.site_in(h, chart), m_state.site_in(i, chart),
                                  m_state.site_in(k, chart)) == LEFT_TURN;
  }

  void add_if_inverted(Face_index f, std::vector<Face_index>& inverted) const
  {
    if (!is_right(f))
      inverted.push_back(f);
  }

  // Lists the inverted faces at these edges. Threads share the edges.
  void collect_inverted(const std::vector<Edge_index>& edges)
  {
    m_inverted.clear();
    append_by_parts<Parts>(
        edges.size(), least_of_part, m_inverted,
        [&](std::size_t i, std::size_t beyond, std::vector<Face_index>& inverted) {
          for (; i < beyond; ++i) {
            prefetch_ahead(edges, i);
            const Halfedge_index h = m_state.arrays().halfedge(edges[i]);
            add_if_inverted(Arrays::face_of(h), inverted);
            add_if_inverted(Arrays::face_of(m_state.arrays().twin(h)), inverted);
          }
        });
  }

  bool is_star_right(Vertex_index v) const
  {
    const auto& arrays = m_state.arrays();
    const Halfedge_index first = arrays.corner(v);
    Halfedge_index h = first;
    do {
      if (!is_right(Arrays::face_of(h)))
        return false;
      h = arrays.next_corner(h);
    } while (h != first);
    return true;
  }

  void append_edges_that_see(Vertex_index v, std::vector<Edge_index>& edges) const
  {
    m_state.arrays().for_each_edge_that_sees(v, [&](Edge_index e) { edges.push_back(e); });
  }

  // Flips edges of the hull through which the vertex opposite to them has left. All other faces
  // stay.
  void peel()
  {
    const auto& arrays = m_state.arrays();
    std::vector<Face_index> faces;
    append_by_parts<Parts>(m_inverted.size(), least_of_part, faces,
                           [&](std::size_t i, std::size_t beyond, std::vector<Face_index>& some) {
                             std::copy_if(m_inverted.data() + i, m_inverted.data() + beyond,
                                          std::back_inserter(some), [&](Face_index f) {
                                            return m_hull_flips.edge_left_through(f) != null_index;
                                          });
                           });
    for (std::size_t i = 0; i < faces.size(); ++i)
      if (const Halfedge_index h = m_hull_flips.edge_left_through(faces[i]); h != null_index) {
        const std::array<Face_index, 2> behind{Arrays::face_of(arrays.twin(Arrays::next(h))),
                                               Arrays::face_of(arrays.twin(Arrays::previous(h)))};
        m_hull_flips.flip(h, m_peeled);
        for (const Face_index f : behind)
          if (!is_right(f)) {
            m_inverted.push_back(f);
            faces.push_back(f);
          }
      }
  }

  // WHO IS HELD, AND WHERE. Plain floating point decides, because a bad decision affects only the
  // cost.

  // Returns the free vertex of a face whose displacement differs most from the face's mean, or else
  // one that is carried, if there is any.
  Vertex_index vertex_to_hold(Face_index f) const
  {
    const std::array<Vertex_index, 3> vertices = m_state.face(f);
    std::array<Position_2, 3> ways;
    Position_2 sum{0, 0};
    double number = 0;
    for (std::size_t i = 0; i < 3; ++i)
      if (vertices[i] != infinite_index) {
        ways[i] = displacement(vertices[i]);
        sum = {sum.x + ways[i].x, sum.y + ways[i].y};
        ++number;
      }
    Vertex_index farthest = null_index, carried = null_index;
    double longest = -1;
    for (std::size_t i = 0; i < 3; ++i) {
      if (vertices[i] == infinite_index)
        continue;
      const Position_2 way{number * ways[i].x - sum.x, number * ways[i].y - sum.y};
      const double squared = dot(way, way);
      if (m_bonds[vertices[i]] == Bond::CARRIED)
        carried = vertices[i];
      else if (m_bonds[vertices[i]] == Bond::FREE && squared > longest) {
        longest = squared;
        farthest = vertices[i];
      }
    }
    return farthest != null_index ? farthest : carried;
  }

  // Holds vertices whose stars are inside of a part, in lists of the parts. Threads share the
  // parts. Leaves the faces that are not right even so. Returns the number of these vertices.
  std::size_t hold_in_parts(const Topology_parts_2& topology, std::size_t most,
                            std::vector<Held> Part::*held)
  {
    m_parts.resize((std::max)(m_parts.size(), topology.number()));
    for (Part& part : m_parts) { // other divisions may have left some
      part.inverted.clear();
      part.left.clear();
    }
    m_divided_faces.template divide<Parts>(m_inverted, topology.number(), [&](std::size_t i) {
      return topology.part_of(finite_vertex(m_inverted[i]));
    });
    Parts::run(topology.number(), [&](std::size_t part) {
      const auto may_hold = [&](Vertex_index v) { return topology.has_star(part, v); };
      Part& mine = m_parts[part];
      mine.inverted.assign(m_divided_faces.begin(part), m_divided_faces.end(part));
      hold_vertices_of(mine.inverted, mine.*held, 4 * most / topology.number(), may_hold,
                       mine.left);
      std::sort((mine.*held).begin(), (mine.*held).end());
    });
    m_inverted.clear();
    std::size_t number = 0;
    for (const Part& part : m_parts) {
      number += (part.*held).size();
      for (const std::vector<Face_index>* faces : {&part.inverted, &part.left})
        m_inverted.insert(m_inverted.end(), faces->begin(), faces->end());
    }
    return number;
  }

  // Holds vertices that no part of the first division has, at most so many more than in parts.
  void hold_beside_parts(std::size_t most)
  {
    for (Part& part : m_parts) {
      m_held.insert(m_held.end(), part.beside.begin(), part.beside.end());
      part.beside.clear();
    }
    m_left.clear();
    hold_vertices_of(
        m_inverted, m_held, most + m_held.size(), [](Vertex_index) { return true; }, m_left);
  }

  // Merges the lists of the parts with the vertices that are held beside them. Threads share the
  // parts.
  void take_over_from_parts(const Topology_parts_2& topology)
  {
    const std::size_t parts = topology.number();
    m_beside.template divide<Parts>(
        m_held, parts, [&](std::size_t i) { return topology.part_of(m_held[i].vertex); });
    std::array<std::size_t, Topology_parts_2::max_number + 1> begins{};
    for (std::size_t part = 0; part < parts; ++part)
      begins[part + 1] = begins[part] + m_parts[part].held.size() + m_beside.size(part);
    m_held.resize(begins[parts]);
    Parts::run(parts, [&](std::size_t part) {
      std::vector<Held>& held = m_parts[part].held;
      std::sort(m_beside.begin(part), m_beside.end(part));
      std::merge(held.begin(), held.end(), m_beside.begin(part), m_beside.end(part),
                 m_held.begin() + std::ptrdiff_t(begins[part]));
      held.clear();
    });
  }

  // Holds vertices of these faces, and of those around them, until all are right, or `most` are
  // held. Lists in `left` the faces that only a vertex v without may_hold(v) could right.
  template <class May_hold>
  void hold_vertices_of(std::vector<Face_index>& inverted, std::vector<Held>& held,
                        std::size_t most, const May_hold& may_hold, std::vector<Face_index>& left)
  {
    while (!inverted.empty() && held.size() <= most) {
      const Face_index f = inverted.back();
      inverted.pop_back();
      if (is_right(f))
        continue;
      const Vertex_index v = vertex_to_hold(f);
      if (v == null_index || !may_hold(v))
        left.push_back(f);
      else
        hold(v, inverted, held);
    }
  }

  Vertex_index finite_vertex(Face_index f) const
  {
    const std::array<Vertex_index, 3> vertices = m_state.face(f);
    return vertices[0] == infinite_index ? vertices[1] : vertices[0];
  }

  void hold(Vertex_index v, std::vector<Face_index>& inverted, std::vector<Held>& held)
  {
    if (m_bonds[v] == Bond::FREE) {
      const Position_2 mean = mean_displacement(v);
      held.push_back({v, goes_far(v, mean), untried, m_editor.stored(v)});
      carry(v, mean);
    } else
      put_to_rest(v);
    m_state.arrays().for_each_corner(
        v, [&](Halfedge_index h) { add_if_inverted(Arrays::face_of(h), inverted); });
  }

  // A vertex that has not moved is at rest already; if points move alone, no other array has its
  // rest position. Nor is a vertex carried beyond the limit of coordinates.
  void carry(Vertex_index v, const Position_2& mean)
  {
    const Position_2 rest = m_state.rest_position(v), way = displacement(v);
    const Position_2 place{rest.x + mean.x, rest.y + mean.y};
    const bool can_go =
        (way.x != 0 || way.y != 0) && is_within_limit(place.x) && is_within_limit(place.y);
    if (!can_place || !can_go)
      return put_to_rest(v);
    if constexpr (can_place) {
      m_bonds[v] = Bond::CARRIED;
      m_editor.place(v, place);
    }
  }

  bool is_held(Vertex_index v) const { return v < m_bonds.size() && m_bonds[v] != Bond::FREE; }

  void put_to_rest(Vertex_index v)
  {
    m_bonds[v] = Bond::AT_REST;
    m_editor.put_to_rest(v);
  }

  void reserve_bonds()
  {
    m_bonds.resize((std::max)(m_bonds.size(), m_state.positions().size()), Bond::FREE);
  }

  Position_2 displacement(Vertex_index v) const
  {
    return m_state.positions()[v] - m_state.rest_position(v);
  }

  // The mean displacement of the free neighbors of v; 0 if there are none.
  Position_2 mean_displacement(Vertex_index v) const
  {
    Position_2 sum{0, 0};
    double number = 0;
    m_state.for_each_finite_neighbor(v, [&](Vertex_index w, const auto&...) {
      if (is_held(w))
        return;
      const Position_2 way = displacement(w);
      sum = {sum.x + way.x, sum.y + way.y};
      ++number;
    });
    return number == 0 ? sum : Position_2{sum.x / number, sum.y / number};
  }

  // Whether the way of v, relative to this mean displacement, is longer than its edges were.
  bool goes_far(Vertex_index v, const Position_2& mean) const
  {
    const Position_2 way = displacement(v) - mean, rest = m_state.rest_position(v);
    const double squared = dot(way, way);
    bool is_far = true;
    m_state.for_each_finite_neighbor(v, [&](Vertex_index w, const auto&...) {
      is_far = is_far && squared > m_state.rounded_squared_distance(rest, m_state.rest_position(w));
    });
    return is_far;
  }

  bool may_flip_into_gap(Vertex_index v) const
  {
    if constexpr (State::has_hull)
      return false;
    else
      return m_hull_flips.edge_into_gap(v) != null_index;
  }

  bool is_to_be_taken_out(const Held& held) const
  {
    if constexpr (State::has_hull)
      return held.goes_far || m_state.arrays().are_neighbors(held.vertex, infinite_index);
    else
      return held.goes_far && !may_flip_into_gap(held.vertex);
  }

  // Returns the share of the way to its target that the vertex has moved. Lists the edges whose
  // test that may have changed.
  double move_on(const Held& held)
  {
    double share = move_in_star(held);
    if constexpr (!State::has_hull)
      while (share == 0) {
        const Halfedge_index h = m_hull_flips.edge_into_gap(held.vertex);
        if (h == null_index)
          break;
        m_hull_flips.flip(h, m_changed);
        share = move_in_star(held);
      }
    if (share > 0)
      append_edges_that_see(held.vertex, m_changed);
    return share;
  }

  double move_in_star(const Held& held)
  {
    const Vertex_index v = held.vertex;
    const Position_2 here = m_state.positions()[v];
    const Stored_point stored = m_editor.stored(v);
    m_editor.restore(v, held.target);
    if (is_star_right(v))
      return 1;
    if constexpr (can_place) {
      const Position_2 way = m_state.positions()[v] - here;
      for (const double share : {0.5, 0.25}) {
        m_editor.place(v, {here.x + share * way.x, here.y + share * way.y});
        if (is_star_right(v))
          return share;
      }
    }
    m_editor.restore(v, stored);
    return 0;
  }

  const State& m_state;
  Editor& m_editor;
  Hull_flips_2<State> m_hull_flips;
  bool m_is_hull_held = false;
  std::vector<Held> m_held;
  std::vector<Held> m_kept;     // memory for m_held
  std::vector<Index> m_waiting; // places in m_held
  Divided_list<Index> m_divided_waiting;
  std::vector<Bond> m_bonds; // indexed by vertices; FREE between updates
  std::vector<Part> m_parts; // hold none outside of hold()
  Divided_list<Face_index> m_divided_faces;
  Divided_list<Held> m_beside;        // copies of those that no part of the first division has
  std::vector<Face_index> m_inverted; // faces that may be inverted
  std::vector<Face_index> m_left;     // inverted faces, none of whose vertices can be held
  std::vector<Edge_index> m_peeled;   // hull edges that were flipped, and edges around them
  std::vector<Edge_index> m_changed;  // edges around the vertex that has moved last
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_MENDING_HELD_VERTICES_2_H

// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_PROOF_EDGE_TEST_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_PROOF_EDGE_TEST_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Flat_arrays.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Processor.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Edge_filter_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Edge_kinds_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Flat_elements_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Lanes_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/topology/Halfedge_arrays_2.h>
#include <CGAL/enum.h>
#include <CGAL/number_type_basic.h>

#include <boost/config.hpp>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Dynamic_Delaunay_triangulations_2 {

/// The state of an edge, decided by exact predicates.
enum class Edge_state_2 {
  DELAUNAY, ///< locally Delaunay; its finite faces are counterclockwise, and the hull is convex
            ///< there.
  ILLEGAL,  ///< both faces are counterclockwise, and each circle holds the other's vertex: flip it.
  INVERTED, ///< a face is not counterclockwise, or the hull not convex; a flip may repair that.
  NOT_FLIPPABLE ///< as INVERTED, but a flip does not repair it.
};

namespace internal {

// How passes see the corners of an edge, where its faces lie in one chart: as in the plane, a
// corner is its vertex's position, and the vector between two corners is a difference that is
// rounded once: the bounds of `Edge_filter_2` and `Edge_slack_2` are derived for that.
class Plane_2
{
public:
  // `positions` are indexed by vertices.
  template <class Positions>
  static Edge_corners_2 corners(const Edge_2& edge, const Positions& positions)
  {
    return {positions[edge.left], positions[edge.source], positions[edge.target],
            positions[edge.right]};
  }

  // Returns the filter of several edges at once: lane i has edge_at(i).
  template <int lanes, class Edge_at>
  BOOST_FORCEINLINE static Edge_filter_in_lanes_2<Lanes<lanes>> filter(const Edge_at& edge_at,
                                                                       const Position_2* positions)
  {
    const auto corners = [&](Vertex_index Edge_2::*corner) CGAL_DYNAMIC_DELAUNAY_INLINE {
      return points_in_lanes<lanes>([&](int i) CGAL_DYNAMIC_DELAUNAY_INLINE -> const Position_2& {
        return positions[edge_at(i).*corner];
      });
    };
    const auto a = corners(&Edge_2::left), b = corners(&Edge_2::source);
    const auto c = corners(&Edge_2::target), d = corners(&Edge_2::right);
    return {b - a, c - a, b - d, c - d};
  }
};

// THE PASS OVER EDGES -----------------------------------------------------------------------------

inline void prefetch_corners(const Edge_2& edge, const Position_2* positions)
{
  for (const Vertex_index v : {edge.source, edge.target, edge.left, edge.right})
    prefetch(positions + v);
}

// Appends the numbers of those edges that Edge_filter_2 does not prove Delaunay, among them all
// edges at infinity, as these have NaN corners. Tests the edges [first, beyond) of a pass, `lanes`
// at once, and returns the first edge that is left over.
template <class Space, int lanes, class Pass>
BOOST_FORCEINLINE std::size_t
append_unproved_in_lanes(const Pass& pass, const Position_2* positions, std::size_t first,
                         std::size_t beyond, std::vector<Edge_index>& unproved)
{
  for (; first + lanes <= beyond; first += lanes) {
    pass.template prefetch_ahead<lanes>(first);
    const auto edge_at = [&](int i) CGAL_DYNAMIC_DELAUNAY_INLINE -> const Edge_2& {
      return pass.edge(first + std::size_t(i));
    };
    const unsigned proved =
        bits(Space::template filter<lanes>(edge_at, positions).proves_delaunay());
    if (proved != all_bits<lanes>)
      for (int i = 0; i < lanes; ++i)
        if (!(proved >> i & 1))
          unproved.push_back(pass.number(first + std::size_t(i)));
  }
  return first;
}

template <class Space, class Pass>
void append_unproved_of_pass(const Pass& pass, const Position_vector& positions, std::size_t first,
                             std::size_t beyond, std::vector<Edge_index>& unproved)
{
  const Position_2* const places = positions.data();
  call_with_lanes([=, &unproved](auto lanes) CGAL_DYNAMIC_DELAUNAY_INLINE {
    const std::size_t rest =
        append_unproved_in_lanes<Space, lanes>(pass, places, first, beyond, unproved);
    append_unproved_in_lanes<Space, 1>(pass, places, rest, beyond, unproved);
  });
}

// A pass over consecutive edges.
struct Consecutive_edges_2
{
  const Edge_2& edge(std::size_t e) const { return edges[e]; }
  Edge_index number(std::size_t e) const { return Edge_index(e); }
  template <int>
  void prefetch_ahead(std::size_t) const
  {
  }

  const Edge_2* edges;
};

// A pass over consecutive edges that prefetches one corner of each. That fetches nearly all
// vertices; to prefetch all four corners takes longer than it saves.
struct Prefetched_edges_2 : Consecutive_edges_2
{
  template <int lanes>
  void prefetch_ahead(std::size_t e) const
  {
    prefetch(edges + e + far_ahead);
    for (std::size_t i = 0; i < lanes; ++i)
      prefetch(positions + edges[e + ahead + i].left);
  }

  static constexpr std::size_t ahead = 128, far_ahead = 512;
  const Position_2* positions;
};

// A pass over the edges of a list.
struct Listed_edges_2 : Consecutive_edges_2
{
  const Edge_2& edge(std::size_t i) const { return edges[list[i]]; }
  Edge_index number(std::size_t i) const { return list[i]; }

  const Edge_index* list;
};

template <class Space>
void append_unproved(const Edge_2* edges, const Position_vector& positions, Index first,
                     Index beyond, std::vector<Edge_index>& unproved)
{
  constexpr Index last_ones = Prefetched_edges_2::far_ahead;
  if (positions.size() >= min_vertices_to_prefetch && beyond - first > last_ones) {
    append_unproved_of_pass<Space>(Prefetched_edges_2{{edges}, positions.data()}, positions, first,
                                   beyond - last_ones, unproved);
    first = beyond - last_ones;
  }
  append_unproved_of_pass<Space>(Consecutive_edges_2{edges}, positions, first, beyond, unproved);
}

template <class Space>
void append_unproved_of(const Edge_2* edges, const Position_vector& positions,
                        const std::vector<Edge_index>& list, std::vector<Edge_index>& unproved)
{
  append_unproved_of_pass<Space>(Listed_edges_2{{edges}, list.data()}, positions, 0, list.size(),
                                 unproved);
}

// EXACT SIGNS -------------------------------------------------------------------------------------

// The exact predicates on vertices, given by their indices. A floating-point filter with a proved
// bound comes first; the kernel decides where the filter fails.
template <class State>
class Vertex_predicates_2
{
public:
  explicit Vertex_predicates_2(const State& state)
    : m_state(state)
  {
  }

  Orientation orientation(Vertex_index a, Vertex_index b, Vertex_index c) const
  {
    if (m_state.positions_are_exact()) {
      const auto& positions = m_state.positions();
      if (const int sign = filtered_orientation(positions[a], positions[b], positions[c]))
        return sign > 0 ? LEFT_TURN : RIGHT_TURN;
    }
    return kernel_orientation(a, b, c);
  }

  // The side of d of the circle through a, b and c, which must be counterclockwise.
  Oriented_side side_of_circle(Vertex_index a, Vertex_index b, Vertex_index c, Vertex_index d) const
  {
    if (m_state.positions_are_exact()) {
      const auto& positions = m_state.positions();
      if (const int sign =
              filtered_in_circle(positions[a], positions[b], positions[c], positions[d]))
        return sign > 0 ? ON_POSITIVE_SIDE : ON_NEGATIVE_SIDE;
    }
    return kernel_side_of_circle(a, b, c, d);
  }

  bool coincide(Vertex_index v, Vertex_index w) const { return compare_xy(v, w) == EQUAL; }

  Comparison_result compare_xy(Vertex_index v, Vertex_index w) const
  {
    const Comparison_result x = compare_x(v, w);
    return x != EQUAL ? x : compare_y(v, w);
  }

  Comparison_result compare_yx(Vertex_index v, Vertex_index w) const
  {
    const Comparison_result y = compare_y(v, w);
    return y != EQUAL ? y : compare_x(v, w);
  }

private:
  // Separate functions, so that compilers inline the filters.

  BOOST_NOINLINE Orientation kernel_orientation(Vertex_index a, Vertex_index b,
                                                Vertex_index c) const
  {
    return m_state.traits().orientation_2_object()(m_state.point(a), m_state.point(b),
                                                   m_state.point(c));
  }

  BOOST_NOINLINE Oriented_side kernel_side_of_circle(Vertex_index a, Vertex_index b, Vertex_index c,
                                                     Vertex_index d) const
  {
    return m_state.traits().side_of_oriented_circle_2_object()(m_state.point(a), m_state.point(b),
                                                               m_state.point(c), m_state.point(d));
  }

  Comparison_result compare_x(Vertex_index v, Vertex_index w) const
  {
    if (m_state.positions_are_exact())
      return CGAL::compare(m_state.positions()[v].x, m_state.positions()[w].x);
    return m_state.traits().compare_x_2_object()(m_state.point(v), m_state.point(w));
  }
  Comparison_result compare_y(Vertex_index v, Vertex_index w) const
  {
    if (m_state.positions_are_exact())
      return CGAL::compare(m_state.positions()[v].y, m_state.positions()[w].y);
    return m_state.traits().compare_y_2_object()(m_state.point(v), m_state.point(w));
  }

  const State& m_state;
};

// The one test of an edge, at the present positions. All signs are exact: the kernel's predicates
// decide where the filter fails.
template <class State>
class Edge_test_2
{
public:
  explicit Edge_test_2(const State& state)
    : m_state(state)
    , m_predicates(state)
  {
  }

  Edge_state_2 state(Edge_index e) const
  {
    return by_kind(
        m_state.arrays().edge(e), [&] { return inner_edge_state(e); },
        [&](Vertex_index a, Vertex_index b, Vertex_index c) { return hull_edge_state(a, b, c); },
        [&](Vertex_index p, Vertex_index q, Vertex_index r) { return hull_corner_state(p, q, r); });
  }

  // Returns the state at lower cost, but may report a NOT_FLIPPABLE edge as INVERTED.
  Edge_state_2 rough_state(Edge_index e) const
  {
    const Edge_filter_2 filter(m_state.corners(e));
    if (m_state.positions_are_exact() && filter.disproves_delaunay())
      return filter.proves_illegal() ? Edge_state_2::ILLEGAL : Edge_state_2::INVERTED;
    return state(e);
  }

  // Whether the filter alone proves the edge Delaunay. It never does for an edge at infinity.
  bool proves_delaunay(Edge_index e) const
  {
    return m_state.positions_are_exact() && Edge_filter_2(m_state.corners(e)).proves_delaunay();
  }

  // Appends those of the edges [first, beyond) that the filter does not prove Delaunay, among them
  // all edges at infinity.
  void append_unproved(Index first, Index beyond, std::vector<Edge_index>& unproved) const
  {
    if (m_state.positions_are_exact())
      return internal::append_unproved<Plane_2>(m_state.arrays().edges().data(),
                                                m_state.positions(), first, beyond, unproved);
    for (Edge_index e(first); e < beyond; ++e)
      unproved.push_back(e);
  }
  // Appends those of the edges in a list.
  void append_unproved(const std::vector<Edge_index>& list, std::vector<Edge_index>& unproved) const
  {
    if (m_state.positions_are_exact())
      return append_unproved_of<Plane_2>(m_state.arrays().edges().data(), m_state.positions(), list,
                                         unproved);
    unproved.insert(unproved.end(), list.begin(), list.end());
  }

private:
  // Whether to flip depends on the sign of the in-circle determinant alone, even where a face is
  // inverted: if a vertex has crossed an edge, the determinant at that edge is positive, and
  // flipping the edge makes both faces counterclockwise.
  Edge_state_2 inner_edge_state(Edge_index e) const
  {
    if (m_state.positions_are_exact()) {
      const Edge_filter_2 filter(m_state.corners(e));
      if (filter.proves_delaunay())
        return Edge_state_2::DELAUNAY;
      if (filter.proves_illegal())
        return Edge_state_2::ILLEGAL;
    }
    const Edge_2& edge = m_state.arrays().edge(e);
    const bool is_twisted = orientation(edge.left, edge.source, edge.target) != LEFT_TURN ||
                            orientation(edge.right, edge.target, edge.source) != LEFT_TURN;
    if (m_predicates.side_of_circle(edge.left, edge.source, edge.target, edge.right) ==
        ON_POSITIVE_SIDE)
      return is_twisted ? Edge_state_2::INVERTED : Edge_state_2::ILLEGAL;
    return is_twisted ? Edge_state_2::NOT_FLIPPABLE : Edge_state_2::DELAUNAY;
  }

  // Tests the hull edge from b to c with the finite face (a, b, c): a must be on its left.
  Edge_state_2 hull_edge_state(Vertex_index a, Vertex_index b, Vertex_index c) const
  {
    if (b == infinite_index)
      return Edge_state_2::DELAUNAY; // it is empty
    switch (orientation(a, b, c)) {
    case LEFT_TURN:
      return Edge_state_2::DELAUNAY;
    case RIGHT_TURN:
      return Edge_state_2::INVERTED;
    default:
      return is_strictly_between(b, a, c) ? Edge_state_2::INVERTED : Edge_state_2::NOT_FLIPPABLE;
    }
  }

  // Tests the turn of the hull at v; the hull is counterclockwise.
  Edge_state_2 hull_corner_state(Vertex_index before, Vertex_index v, Vertex_index after) const
  {
    switch (orientation(before, v, after)) {
    case LEFT_TURN:
      return Edge_state_2::DELAUNAY;
    case RIGHT_TURN:
      return Edge_state_2::INVERTED;
    default: // the hull must not turn back on itself
      return is_strictly_between(before, v, after) ? Edge_state_2::DELAUNAY
                                                   : Edge_state_2::NOT_FLIPPABLE;
    }
  }

  Orientation orientation(Vertex_index a, Vertex_index b, Vertex_index c) const
  {
    return m_predicates.orientation(a, b, c);
  }

  // Whether q is strictly between p and r, for collinear points.
  bool is_strictly_between(Vertex_index p, Vertex_index q, Vertex_index r) const
  {
    const Comparison_result pq = m_predicates.compare_xy(p, q);
    return pq != EQUAL && pq == m_predicates.compare_xy(q, r);
  }

  const State& m_state;
  Vertex_predicates_2<State> m_predicates;
};

// Appends all edges that the filter does not prove Delaunay.
template <class State>
void append_unproved(const State& state, std::vector<Edge_index>& unproved)
{
  using Parts = typename State::Parts;
  append_by_parts<Parts>(state.arrays().number_of_edges(), Parts::usual_size, unproved,
                         [&](std::size_t first, std::size_t beyond, std::vector<Edge_index>& some) {
                           typename State::Edge_test(state).append_unproved(
                               Edge_index(first), Edge_index(beyond), some);
                         });
}

// Removes the Delaunay edges from the list, and keeps each other edge once, in ascending order.
template <class State>
void keep_unproved(const State& state, std::vector<Edge_index>& edges)
{
  using Parts = typename State::Parts;
  constexpr std::size_t least = Parts::size_for(16), ahead = 8;
  make_distinct(edges);
  const typename State::Edge_test test(state);
  remove_by_parts<Parts>(edges, least, [&](std::size_t i, std::size_t beyond) {
    if (i + 2 * ahead < beyond)
      state.arrays().prefetch_edge(edges[i + 2 * ahead]);
    if (i + ahead < beyond)
      prefetch_corners(state.arrays().edge(edges[i + ahead]), state.positions().data());
    return test.state(edges[i]) == Edge_state_2::DELAUNAY;
  });
}

} // namespace internal
} // namespace Dynamic_Delaunay_triangulations_2
} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_PROOF_EDGE_TEST_2_H

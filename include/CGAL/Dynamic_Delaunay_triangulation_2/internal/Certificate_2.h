// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_CERTIFICATE_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_CERTIFICATE_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Edge_filter_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Neighborhood_mirror_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Vertex_predicates_2.h>
#include <CGAL/enum.h>

namespace CGAL {
namespace Dynamic_Delaunay_triangulations_2 {
namespace internal {

enum class Edge_state_2 {
  DELAUNAY, // locally Delaunay, its finite faces counterclockwise, the hull convex here
  ILLEGAL,  // both faces are counterclockwise, and each circle holds the other's vertex: flip it
  CROSSED,  // a face at it is not counterclockwise, or the hull not convex, and a flip may right
            // that
  TWISTED   // the same, and a flip does not
};

// The certificate: a triangulated sphere with one vertex at infinity is the Delaunay triangulation
// of its points if and only if
//   1. every finite face is counterclockwise,
//   2. every edge between two finite faces is locally Delaunay,
//   3. the hull turns left or goes straight on at each of its vertices,
//   4. and turns around once.
// By 1 and 3 the map from the triangulation to the plane is a covering of the hull's inside with as
// many sheets as the hull has turns, branched at most at vertices; by 4 it has one sheet, so the
// faces tile the convex hull, and 2 makes that tiling Delaunay (Delaunay's lemma). Without 4 a
// vertex star that winds around its center twice passes 1 to 3. All signs are exact: a
// floating-point filter with a proved bound first, the kernel's exact predicates where it does not
// decide.
template <class Maintained>
class Certificate_2
{
public:
  explicit Certificate_2(const Maintained& maintained)
    : m_maintained(maintained)
    , m_predicates(maintained)
  {
  }

  // Conditions 1 to 3 at one edge.
  Edge_state_2 state(Index e) const
  {
    const Edge_2& edge = m_maintained.mirror().edge(e);
    if (edge.left == infinite_index)
      return hull_edge_state(edge.right, edge.target, edge.source);
    if (edge.right == infinite_index)
      return hull_edge_state(edge.left, edge.source, edge.target);
    // the infinite faces at an edge from a hull vertex to infinity give the hull's way through it
    if (edge.source == infinite_index)
      return hull_corner_state(edge.left, edge.target, edge.right);
    if (edge.target == infinite_index)
      return hull_corner_state(edge.right, edge.source, edge.left);
    return inner_edge_state(edge);
  }

  // The same at less cost: what is twisted may be called crossed.
  Edge_state_2 rough_state(Index e) const
  {
    const Edge_2& edge = m_maintained.mirror().edge(e);
    const auto& positions = m_maintained.positions();
    const Edge_filter_2 filter(positions[edge.left], positions[edge.source], positions[edge.target],
                               positions[edge.right]);
    if (m_maintained.positions_are_exact() && filter.disproves_delaunay())
      return filter.proves_illegal() ? Edge_state_2::ILLEGAL : Edge_state_2::CROSSED;
    return state(e);
  }

  // Condition 4. A locally convex closed curve turns around as often as it has a summit: a vertex
  // that is lexicographically larger than both its neighbors.
  bool hull_turns_once() const
  {
    int summits = 0;
    const auto& mirror = m_maintained.mirror();
    mirror.for_each_corner(infinite_index, [&](Index corner) {
      const Index v = mirror.target(corner);
      const Index next = mirror.target(mirror.next_corner(corner));
      summits += is_larger(v, mirror.source(corner)) && is_larger(v, next);
    });
    return summits == 1;
  }

  bool holds() const
  {
    for (Index e = 0; e < m_maintained.mirror().number_of_edges(); ++e)
      if (state(e) != Edge_state_2::DELAUNAY)
        return false;
    return hull_turns_once();
  }

private:
  // Flips go by the sign of the in-circle determinant alone, also where a face is inverted: the
  // edge that a vertex has crossed has a positive one, and flipping it rights both faces.
  Edge_state_2 inner_edge_state(const Edge_2& edge) const
  {
    const auto& positions = m_maintained.positions();
    const Edge_filter_2 filter(positions[edge.left], positions[edge.source], positions[edge.target],
                               positions[edge.right]);
    if (m_maintained.positions_are_exact()) {
      if (filter.proves_delaunay())
        return Edge_state_2::DELAUNAY;
      if (filter.proves_illegal())
        return Edge_state_2::ILLEGAL;
    }
    const bool is_twisted = orientation(edge.left, edge.source, edge.target) != LEFT_TURN ||
                            orientation(edge.right, edge.target, edge.source) != LEFT_TURN;
    if (m_predicates.side_of_circle(edge.left, edge.source, edge.target, edge.right) ==
        ON_POSITIVE_SIDE)
      return is_twisted ? Edge_state_2::CROSSED : Edge_state_2::ILLEGAL;
    return is_twisted ? Edge_state_2::TWISTED : Edge_state_2::DELAUNAY;
  }

  // The hull edge from b to c with the finite face (a, b, c): a must be on its left.
  Edge_state_2 hull_edge_state(Index a, Index b, Index c) const
  {
    switch (orientation(a, b, c)) {
    case LEFT_TURN:
      return Edge_state_2::DELAUNAY;
    case RIGHT_TURN:
      return Edge_state_2::CROSSED;
    default:
      return is_strictly_between(b, a, c) ? Edge_state_2::CROSSED : Edge_state_2::TWISTED;
    }
  }

  // The hull's way through v, counterclockwise.
  Edge_state_2 hull_corner_state(Index before, Index v, Index after) const
  {
    switch (orientation(before, v, after)) {
    case LEFT_TURN:
      return Edge_state_2::DELAUNAY;
    case RIGHT_TURN:
      return Edge_state_2::CROSSED;
    default: // the hull must not turn back on itself
      return is_strictly_between(before, v, after) ? Edge_state_2::DELAUNAY : Edge_state_2::TWISTED;
    }
  }

  Orientation orientation(Index a, Index b, Index c) const
  {
    return m_predicates.orientation(a, b, c);
  }

  bool is_larger(Index v, Index w) const { return m_predicates.compare_xy(v, w) == LARGER; }

  // For three collinear points.
  bool is_strictly_between(Index p, Index q, Index r) const
  {
    const Comparison_result pq = m_predicates.compare_xy(p, q);
    return pq != EQUAL && pq == m_predicates.compare_xy(q, r);
  }

  const Maintained& m_maintained;
  Vertex_predicates_2<Maintained> m_predicates;
};

} // namespace internal
} // namespace Dynamic_Delaunay_triangulations_2
} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_CERTIFICATE_2_H

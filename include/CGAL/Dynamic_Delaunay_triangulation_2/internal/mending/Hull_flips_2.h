// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_MENDING_HULL_FLIPS_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_MENDING_HULL_FLIPS_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Flat_arrays.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Flat_elements_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Points_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/proof/Edge_test_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/topology/Halfedge_arrays_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/topology/Topology_editor_2.h>

#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

// Which edges of the hull, or of the sides of a slab, can be flipped to let a vertex out, and where
// the hull may fold.
template <class State>
class Hull_flips_2
{
  using Arrays = Halfedge_arrays_2;
  using Editor = Topology_editor_2<State>;

public:
  Hull_flips_2(const State& state, Editor& editor)
    : m_state(state)
    , m_editor(editor)
  {
  }

  // Whether the hull may fold at the edge of an infinite face: whether this edge has turned by a
  // right angle or more since it was at rest, so that one end has moved past the other one. Plain
  // floating point decides, because a walk around the hull with exact signs follows.
  //
  // If it is so at no edge, and all finite faces are counterclockwise, the hull turns around once.
  //   - Not more often: at rest it turned at each vertex by an angle from 0 to below pi. Now it is
  //     that angle plus the turn of one edge minus that of the other, which is less than 2 pi, plus
  //     a multiple of 2 pi that makes it at most pi, and so is not positive. Without these
  //     multiples all angles together are 2 pi, as at rest.
  //   - Not less often: around each inner vertex the angles of faces are at least 2 pi together.
  //     The others, of the pi of each face, by Euler's formula leave at least one turn to the hull.
  bool is_folded(Face_index f) const
  {
    for (const Halfedge_index h : Arrays::halfedges_of(f))
      if (m_state.arrays().apex(h) == infinite_index)
        return !keeps_direction(h);
    return false;
  }

  // A half-edge of an inverted face on the hull whose apex has left through its edge, so that a
  // flip may right the face; or `null_index`.
  Halfedge_index edge_left_through(Face_index f) const
  {
    for (const Halfedge_index h : Arrays::halfedges_of(f))
      if (m_state.is_hull_edge(h) && has_left_through(h))
        return h;
    return null_index;
  }

  // A vertex on a side of a slab may be unable to leave that side, and the only one there, whose
  // faces meet images of themselves, cannot be taken out. But its edges along the side can be
  // flipped into the gap. Returns such an edge, as a half-edge, or `null_index`. Each flip takes an
  // edge from the vertex, so there are only a few.
  Halfedge_index edge_into_gap(Vertex_index v) const
  {
    const auto& arrays = m_state.arrays();
    Halfedge_index found = null_index;
    arrays.for_each_corner(v, [&](Halfedge_index h) {
      for (const Halfedge_index along : {Arrays::next(h), Arrays::previous(h)})
        if (found == null_index && m_state.is_hull_edge(along) && can_flip_into_gap(along))
          found = along;
    });
    return found;
  }

  // Flips, and lists the edges whose test that may have changed.
  void flip(Halfedge_index h, std::vector<Edge_index>& edges)
  {
    const Edge_index e = m_state.arrays().edge_of(h);
    m_editor.flip(h);
    edges.push_back(e);
    m_state.arrays().for_each_side(e, [&](Edge_index side) { edges.push_back(side); });
  }

private:
  bool keeps_direction(Halfedge_index h) const
  {
    const Vertex_index v = m_state.arrays().source(h), w = m_state.arrays().target(h);
    return dot(m_state.positions()[w] - m_state.positions()[v],
               m_state.rest_position(w) - m_state.rest_position(v)) > 0;
  }

  bool has_left_through(Halfedge_index h) const
  {
    const auto& arrays = m_state.arrays();
    if constexpr (State::has_hull) {
      const typename State::Edge_test test(m_state);
      return is_over(h) && test.state(arrays.edge_of(h)) == Edge_state_2::INVERTED &&
             m_editor.can_flip(h);
    } else
      return can_flip_into_gap(h);
  }

  // Whether the edge of h, on a side of a slab, can be flipped so that both new faces are
  // counterclockwise.
  bool can_flip_into_gap(Halfedge_index h) const
  {
    constexpr typename State::Chart chart{};
    const auto a = m_state.site_in(h, chart);
    const auto b = m_state.site_in(Arrays::next(h), chart);
    const auto c = m_state.site_in(Arrays::previous(h), chart);
    const auto d = m_state.site_in(m_state.arrays().twin(h), m_state.chart_beyond(h, chart));
    const typename State::Predicates predicates(m_state);
    return predicates.orientation(a, b, d) == LEFT_TURN &&
           predicates.orientation(d, c, a) == LEFT_TURN && m_editor.can_flip(h);
  }

  // Whether the apex of h projects onto the edge of h, and flipping the edge does not let the hull
  // turn twice.
  bool is_over(Halfedge_index h) const
  {
    const auto& arrays = m_state.arrays();
    const Position_2 a = m_state.positions()[arrays.apex(h)],
                     b = m_state.positions()[arrays.source(h)],
                     c = m_state.positions()[arrays.target(h)];
    return keeps_direction(h) && dot(c - b, a - b) > 0 && dot(b - c, a - c) > 0;
  }

  const State& m_state;
  Editor& m_editor;
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_MENDING_HULL_FLIPS_2_H

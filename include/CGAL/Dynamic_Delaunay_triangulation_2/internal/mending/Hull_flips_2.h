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

// Which edges of the hull, or of the sides of a slab, can be flipped to let a vertex out.
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

  bool is_on_hull(Vertex_index v) const
  {
    bool is = false;
    m_state.arrays().for_each_corner(
        v, [&](Halfedge_index h) { is = is || m_state.is_infinite_face(Arrays::face_of(h)); });
    return is;
  }

private:
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

  // Whether the apex of h projects onto the edge of h, and the edge has not turned around. If not,
  // one end of the edge has moved past the other: flipping the edge would let the hull turn twice.
  bool is_over(Halfedge_index h) const
  {
    const auto& arrays = m_state.arrays();
    const Vertex_index v = arrays.source(h), w = arrays.target(h);
    const Position_2 a = m_state.positions()[arrays.apex(h)], b = m_state.positions()[v],
                     c = m_state.positions()[w];
    return dot(c - b, m_state.rest_position(w) - m_state.rest_position(v)) > 0 &&
           dot(c - b, a - b) > 0 && dot(b - c, a - c) > 0;
  }

  const State& m_state;
  Editor& m_editor;
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_MENDING_HULL_FLIPS_2_H

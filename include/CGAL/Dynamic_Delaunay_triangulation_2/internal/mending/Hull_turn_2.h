// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_MENDING_HULL_TURN_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_MENDING_HULL_TURN_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Flat_arrays.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Flat_elements_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Points_2.h>

#include <algorithm>
#include <array>
#include <cstddef>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

// How the hull turns around the middle of all points. A condition on each hull edge alone tells
// whether the hull turns around once, as it did at rest: the middle is inside of the edge, and
// neither end has turned by a right angle around the middle since it was at rest.
//
// Proof: let the middle at rest be inside of the hull at rest. Seen from the middle, a hull edge
// has an angle between 0 and pi, at rest and now. The angle now is the one at rest plus the turn of
// one end minus that of the other one, up to a multiple of 2 pi. As each turn is less than pi / 2,
// that multiple is 0. So all angles together are 2 pi, as at rest.
//
// Plain floating point decides, because a walk around the hull with exact signs follows.
template <class State>
class Hull_turn_2
{
public:
  explicit Hull_turn_2(const State& state)
    : m_state(state)
  {
  }

  // Finds the middle, where the vertices stand and where they rest. O(n).
  void find_middle()
  {
    const double share = 1 / double(m_state.number_of_vertices());
    m_middle = m_rest_middle = {0, 0};
    for (Vertex_index v = infinite_index + 1; v < m_state.positions().size(); ++v)
      if (!m_state.arrays().is_outside(v)) {
        m_middle = moved(m_middle, m_state.positions()[v], share);
        m_rest_middle = moved(m_rest_middle, m_state.rest_position(v), share);
      }
  }

  // Whether the condition holds for the edge of an infinite face.
  bool is_as_at_rest(Face_index f) const
  {
    const std::array<Vertex_index, 3> face = m_state.face(f);
    const auto i = std::size_t(std::find(face.begin(), face.end(), infinite_index) - face.begin());
    const Vertex_index v = face[(i + 1) % 3], w = face[(i + 2) % 3];
    const Position_2 a = m_state.positions()[v] - m_middle, b = m_state.positions()[w] - m_middle;
    return b.x * a.y > b.y * a.x && dot(a, m_state.rest_position(v) - m_rest_middle) > 0 &&
           dot(b, m_state.rest_position(w) - m_rest_middle) > 0;
  }

private:
  static Position_2 moved(const Position_2& p, const Position_2& way, double share)
  {
    return {p.x + share * way.x, p.y + share * way.y};
  }

  const State& m_state;
  Position_2 m_middle{0, 0}, m_rest_middle{0, 0};
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_MENDING_HULL_TURN_2_H

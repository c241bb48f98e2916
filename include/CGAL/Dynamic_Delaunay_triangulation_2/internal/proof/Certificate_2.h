// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_PROOF_CERTIFICATE_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_PROOF_CERTIFICATE_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/proof/Edge_test_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/topology/Halfedge_arrays_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_errors_2.h>
#include <CGAL/enum.h>

#include <cstddef>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

// The certificate: a triangulated sphere with one vertex at infinity is the Delaunay triangulation
// of its points if and only if
//   1. every finite face is counterclockwise,
//   2. every edge between two finite faces is locally Delaunay,
//   3. the hull turns left or goes straight on at each of its vertices, and
//   4. the hull turns around once.
// By 1 and 3, the map from the triangulation to the plane is a covering of the hull's inside with
// as many sheets as the hull has turns, branched at most at vertices. By 4 it has one sheet, so the
// faces tile the convex hull. By 2 that tiling is Delaunay (Delaunay's lemma). Without 4, a vertex
// star that winds around its center twice would pass 1 to 3. The edge test tests 1 to 3 edge by
// edge.
//
// On a torus there are neither infinity nor hull, and the first two conditions are enough as long
// as the faces cover the torus once. No update changes that, and Torus_cover_2 tests it.
template <class State>
class Certificate_2
{
public:
  explicit Certificate_2(const State& state)
    : m_state(state)
  {
  }

  // Condition 4. A locally convex closed curve turns around once for each of its summits, the
  // vertices that are lexicographically larger than both their neighbors.
  bool hull_turns_once() const
  {
    const Vertex_predicates_2<State> predicates(m_state);
    const auto is_larger = [&](Vertex_index v, Vertex_index w) {
      return predicates.compare_xy(v, w) == LARGER;
    };
    int summits = 0;
    const auto& arrays = m_state.arrays();
    arrays.for_each_corner(infinite_index, [&](Halfedge_index corner) {
      const Vertex_index v = arrays.target(corner);
      const Vertex_index next = arrays.target(arrays.next_corner(corner));
      summits += is_larger(v, arrays.source(corner)) && is_larger(v, next);
    });
    return summits == 1;
  }

  bool holds() const
  {
    if constexpr (!State::has_hull)
      return are_edges_delaunay();
    else
      return are_edges_delaunay() && hull_turns_once();
  }

private:
  // Conditions 1 to 3.
  bool are_edges_delaunay() const
  {
    const typename State::Edge_test test(m_state);
    return State::Parts::all_of(m_state.arrays().number_of_edges(),
                                [&](std::size_t first, std::size_t beyond) {
                                  for (std::size_t e = first; e < beyond; ++e)
                                    if (test.state(Edge_index(e)) != Edge_state_2::DELAUNAY)
                                      return false;
                                  return true;
                                });
  }

  const State& m_state;
};

// Throws unless the periodic triangulation is certified.
template <class Dynamic>
void check_certified(const Dynamic& pt)
{
  if (!pt.is_certified())
    throw Uncertified_triangulation_error_2(
        "the periodic triangulation is not certified after a heuristic update, or after a change "
        "that was interrupted: call mend() to make it Delaunay");
}

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_PROOF_CERTIFICATE_2_H

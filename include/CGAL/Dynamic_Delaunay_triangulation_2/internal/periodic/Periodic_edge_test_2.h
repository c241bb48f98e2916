// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_PERIODIC_PERIODIC_EDGE_TEST_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_PERIODIC_PERIODIC_EDGE_TEST_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Flat_arrays.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Edge_filter_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/periodic/Torus_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/proof/Edge_test_2.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

// The one test of an edge on a torus, with the interface that `Edge_test_2` has in the plane.
template <class Space>
class Periodic_edge_test_2
{
public:
  explicit Periodic_edge_test_2(const Space& space)
    : m_space(space)
  {
  }

  Edge_state_2 state(Edge_index e) const
  {
    const auto& arrays = m_space.arrays();
    if (arrays.is_empty_edge(e))
      return Edge_state_2::DELAUNAY;
    if (!m_space.is_shifted(e)) {
      const Edge_filter_2 filter(Plane_2::corners(arrays.edge(e), m_space.positions()));
      if (filter.proves_delaunay())
        return Edge_state_2::DELAUNAY;
      if (filter.proves_illegal())
        return Edge_state_2::ILLEGAL;
    }
    return m_space.torus().edge_state(m_space.corners_at(arrays.halfedge(e)));
  }

  // Returns the exact state, because the exact test, behind its filters, costs little more here.
  Edge_state_2 rough_state(Edge_index e) const { return state(e); }

  // Appends those of the edges [first, beyond) that the filters do not prove Delaunay. Empty edges
  // are left out.
  void append_unproved(Index first, Index beyond, std::vector<Edge_index>& unproved) const
  {
    const std::size_t before = unproved.size();
    internal::append_unproved<Plane_2>(m_space.arrays().edges().data(), m_space.positions(), first,
                                       beyond, unproved);
    keep_unproved(unproved, before);
  }

  // Appends those of the edges in a list.
  void append_unproved(const std::vector<Edge_index>& list, std::vector<Edge_index>& unproved) const
  {
    const std::size_t first = unproved.size();
    append_unproved_of<Plane_2>(m_space.arrays().edges().data(), m_space.positions(), list,
                                unproved);
    keep_unproved(unproved, first);
  }

  bool proves_delaunay(Edge_index e) const
  {
    const auto& arrays = m_space.arrays();
    if (arrays.is_empty_edge(e))
      return true;
    if (m_space.is_shifted(e))
      return m_space.torus().filter_proves_delaunay(m_space.corners_at(arrays.halfedge(e)));
    return Edge_filter_2(Plane_2::corners(arrays.edge(e), m_space.positions())).proves_delaunay();
  }

private:
  // From place `first` on, keeps the edges that the filters of the torus do not prove, either.
  void keep_unproved(std::vector<Edge_index>& unproved, std::size_t first) const
  {
    const auto& arrays = m_space.arrays();
    const auto corners = [&](Edge_index e) { return m_space.corners_at(arrays.halfedge(e)); };
    std::array<Edge_index, 4> shifted;
    std::size_t kept = first, waiting = 0;
    for (std::size_t i = first; i < unproved.size(); ++i) {
      const Edge_index e = unproved[i];
      if (arrays.is_empty_edge(e))
        continue;
      if (!m_space.is_shifted(e)) {
        unproved[kept++] = e;
        continue;
      }
      shifted[waiting++] = e;
      if (waiting < 4)
        continue;
      const int proved = m_space.torus().filter_proves_delaunay(
          {corners(shifted[0]), corners(shifted[1]), corners(shifted[2]), corners(shifted[3])});
      for (waiting = 4; waiting > 0; --waiting)
        if (!(proved >> (waiting - 1) & 1))
          unproved[kept++] = shifted[waiting - 1];
    }
    while (waiting > 0)
      if (!proves_delaunay(shifted[--waiting]))
        unproved[kept++] = shifted[waiting];
    unproved.resize(kept);
  }

  const Space& m_space;
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_PERIODIC_PERIODIC_EDGE_TEST_2_H

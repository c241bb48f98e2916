// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_MENDING_PADDED_REGION_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_MENDING_PADDED_REGION_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Flat_arrays.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/mending/Cluster_splice_2.h>

#include <cstddef>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

// A region of a torus: some vertices, their padding, and one layer of border around both. It is not
// triangulated apart: the repair flips edges in the region, or puts its vertices in anew.
template <class State>
class Padded_region_2
{
public:
  explicit Padded_region_2(const State& state)
    : m_state(state)
  {
  }

  // Collects the region around `classified`. Skips vertices that are in no face.
  void run(const std::vector<Vertex_index>& classified, unsigned padding)
  {
    m_number_of_classified = collect_region(m_state, classified, padding, m_vertices);
    m_number_of_inner = m_vertices.size();
    add_layer(m_state, m_vertices);
  }

  // All vertices of the region, except the border.
  std::vector<Vertex_index> inner() const { return part(0, m_number_of_inner); }
  std::vector<Vertex_index> padded() const { return part(m_number_of_classified, m_number_of_inner); }
  std::vector<Vertex_index> border() const { return part(m_number_of_inner, m_vertices.size()); }

private:
  std::vector<Vertex_index> part(std::size_t first, std::size_t beyond) const
  {
    const std::vector<Vertex_index>& all = m_vertices.members();
    return {all.begin() + std::ptrdiff_t(first), all.begin() + std::ptrdiff_t(beyond)};
  }

  const State& m_state;
  Index_set<Vertex_index> m_vertices; // classified, then padded, then border
  std::size_t m_number_of_classified = 0, m_number_of_inner = 0;
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_MENDING_PADDED_REGION_2_H

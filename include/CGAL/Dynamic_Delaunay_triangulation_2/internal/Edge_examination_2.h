// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_EDGE_EXAMINATION_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_EDGE_EXAMINATION_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Certificate_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Edge_proofs_2.h>

#include <numeric>
#include <vector>

namespace CGAL {
namespace Dynamic_Delaunay_triangulations_2 {
namespace internal {

// Classifies edge e unless it is Delaunay, decided exactly.
template <class Frame, class Classification>
void examine(const Frame& frame, Index e, Classification& classified)
{
  const Edge_state_2 state = frame.rough_state(e);
  if (state == Edge_state_2::ILLEGAL)
    classified.add_illegal_edge(e);
  else if (state != Edge_state_2::DELAUNAY)
    classified.add_edge(e);
}

// The same for all edges of a list. After a pass over all edges they are no longer in the cache.
template <class Frame, class Classification>
void examine_all(const Frame& frame, const std::vector<Index>& edges, Classification& classified)
{
  constexpr std::size_t ahead = 8;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    if (i + 2 * ahead < edges.size())
      prefetch(&frame.edge(edges[i + 2 * ahead]));
    if (i + ahead < edges.size())
      prefetch_corners(frame.edge(edges[i + ahead]), frame.positions().data());
    examine(frame, edges[i], classified);
  }
}

// Lists edges among which are all that are not Delaunay: those that the pass over all edges does
// not prove.
template <class Frame>
void find_unproved(const Frame& frame, std::vector<Index>& unproved)
{
  unproved.clear();
  if (frame.positions_are_exact()) {
    append_unproved(frame.edges().data(), frame.positions(), 0, frame.number_of_edges(), unproved);
    return;
  }
  unproved.resize(frame.number_of_edges());
  std::iota(unproved.begin(), unproved.end(), Index(0));
}

} // namespace internal
} // namespace Dynamic_Delaunay_triangulations_2
} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_EDGE_EXAMINATION_2_H

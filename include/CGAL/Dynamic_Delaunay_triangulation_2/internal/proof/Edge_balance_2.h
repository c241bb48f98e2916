// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_PROOF_EDGE_BALANCE_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_PROOF_EDGE_BALANCE_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <algorithm>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

// Collects changes of edges, positive for creations and negative for removals, and finds the edges
// that these have created or removed in the end.
template <class Edge>
class Edge_balance_2
{
public:
  struct Change
  {
    Edge edge;
    int sign;
  };

  void note(const Edge& edge, int sign) { m_changes.push_back({edge, sign}); }
  void clear() { m_changes.clear(); }
  // The changes so far, in any order.
  std::vector<Change>& changes() { return m_changes; }

  // Calls f(edge, sum) for each edge whose changes do not cancel, in ascending order.
  template <class Function>
  void for_each_change(const Function& f)
  {
    std::sort(m_changes.begin(), m_changes.end(),
              [](const Change& a, const Change& b) { return a.edge < b.edge; });
    for (auto change = m_changes.begin(); change != m_changes.end();) {
      const Edge edge = change->edge;
      int sum = 0;
      for (; change != m_changes.end() && change->edge == edge; ++change)
        sum += change->sign;
      if (sum != 0)
        f(edge, sum);
    }
  }

private:
  std::vector<Change> m_changes;
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_PROOF_EDGE_BALANCE_2_H

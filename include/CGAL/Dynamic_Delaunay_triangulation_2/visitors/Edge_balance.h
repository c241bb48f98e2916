// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_VISITORS_EDGE_BALANCE_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_VISITORS_EDGE_BALANCE_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <algorithm>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

// Collects changes of edges, positive for creations and negative for removals, and lists the edges
// that these have created or removed in the end.
template <class Edge>
class Edge_balance
{
public:
  void note(const Edge& edge, int sign)
  {
    m_changes.push_back({edge, sign});
    m_are_listed = false;
  }
  void clear()
  {
    m_changes.clear();
    m_are_listed = false;
  }
  // Calls f(edge), which may rename the edge, for each change.
  template <class Function>
  void rename(const Function& f)
  {
    for (Change& change : m_changes)
      f(change.edge);
    m_are_listed = false;
  }
  // Call it if `list()` would give edges other names than before.
  void forget_lists() { m_are_listed = false; }

  // Lists the edges whose changes do not cancel, as `name(edge)`, in ascending order. Does nothing
  // if they are listed already.
  template <class Name>
  void list(const Name& name)
  {
    if (m_are_listed)
      return;
    m_created.clear();
    m_removed.clear();
    std::sort(m_changes.begin(), m_changes.end(),
              [](const Change& a, const Change& b) { return a.edge < b.edge; });
    for (auto change = m_changes.begin(); change != m_changes.end();) {
      const Edge edge = change->edge;
      int sum = 0;
      for (; change != m_changes.end() && change->edge == edge; ++change)
        sum += change->sign;
      if (sum != 0)
        (sum > 0 ? m_created : m_removed).push_back(name(edge));
    }
    std::sort(m_created.begin(), m_created.end());
    std::sort(m_removed.begin(), m_removed.end());
    m_are_listed = true;
  }
  const std::vector<Edge>& created() const { return m_created; }
  const std::vector<Edge>& removed() const { return m_removed; }

private:
  struct Change
  {
    Edge edge;
    int sign;
  };

  std::vector<Change> m_changes;
  std::vector<Edge> m_created, m_removed;
  bool m_are_listed = true;
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_VISITORS_EDGE_BALANCE_H

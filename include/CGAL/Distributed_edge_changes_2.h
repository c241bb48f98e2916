// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISTRIBUTED_EDGE_CHANGES_2_H
#define CGAL_DISTRIBUTED_EDGE_CHANGES_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Message_exchange_2.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <map>
#include <utility>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgDynamicDelaunayTriangulation2Ref

Lists the finite edges of a `Distributed_dynamic_Delaunay_triangulation_2` that have come and gone
since the last `compute()`. Each of them is in the list of one rank; an edge that has only changed
its owner is in none.

Cost: the edges of each rank are sorted, and the changes are sent.
*/
class Distributed_edge_changes_2
{
public:
  /// the ids of the two ends of an edge, the smaller one first.
  using Edge = std::pair<std::int64_t, std::int64_t>;

  /// compares the edges with those at the last call. At the first call all are created. Collective.
  /// \tparam Distributed a `Distributed_dynamic_Delaunay_triangulation_2`, always the same one.
  template <class Distributed>
  void compute(Distributed& dt)
  {
    std::vector<Edge> edges, created, removed;
    dt.for_each_edge([&](std::int64_t i, std::int64_t j) { edges.emplace_back(i, j); });
    std::sort(edges.begin(), edges.end());
    std::set_difference(edges.begin(), edges.end(), m_edges.begin(), m_edges.end(),
                        std::back_inserter(created));
    std::set_difference(m_edges.begin(), m_edges.end(), edges.begin(), edges.end(),
                        std::back_inserter(removed));
    m_edges = std::move(edges);
    settle(dt.ranks(), created, removed);
  }

  /// the created edges that this rank tells, in ascending order.
  const std::vector<Edge>& created_edges() const { return m_created; }
  /// the removed edges that this rank tells, in ascending order.
  const std::vector<Edge>& removed_edges() const { return m_removed; }

private:
  struct Change
  {
    std::int64_t i, j, sign;
  };

  // One rank hears of all changes of an edge: where it went to another owner they cancel out.
  template <class Ranks>
  void settle(Ranks& ranks, const std::vector<Edge>& created, const std::vector<Edge>& removed)
  {
    auto messages = ranks.empty_messages();
    const auto note = [&](const Edge& edge, std::int64_t sign) {
      messages[std::uint64_t(edge.first) % ranks.size()].write(
          Change{edge.first, edge.second, sign});
    };
    for (const Edge& edge : created)
      note(edge, 1);
    for (const Edge& edge : removed)
      note(edge, -1);
    std::map<Edge, std::int64_t> sums;
    for (auto& message : ranks.send(std::move(messages)))
      while (!message.is_read()) {
        const auto change = message.template read<Change>();
        sums[{change.i, change.j}] += change.sign;
      }
    m_created.clear();
    m_removed.clear();
    for (const auto& [edge, sum] : sums)
      if (sum != 0)
        (sum > 0 ? m_created : m_removed).push_back(edge);
  }

  std::vector<Edge> m_edges, m_created, m_removed;
};

} // namespace CGAL

#endif // CGAL_DISTRIBUTED_EDGE_CHANGES_2_H

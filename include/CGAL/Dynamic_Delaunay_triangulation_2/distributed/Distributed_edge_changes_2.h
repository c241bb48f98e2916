// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_DISTRIBUTED_DISTRIBUTED_EDGE_CHANGES_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_DISTRIBUTED_DISTRIBUTED_EDGE_CHANGES_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/distributed/Distributed_ranks_2.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <iterator>
#include <map>
#include <utility>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

// Lists the edges that were created and removed between two calls of `compare()`, over all ranks.
// `Traits::Edge` can be compared, `Traits::end(edge)` is the id of one of its ends, and
// `Traits::received()` returns what was given to `Traits::sent()`, which returns plain data.
template <class Traits>
class Distributed_edge_comparison_2
{
public:
  using Edge = typename Traits::Edge;

  // Renames the edges of the last comparison. `name` maps different edges to different ones.
  template <class Name>
  void rename(const Name& name)
  {
    for (Edge& edge : m_edges)
      edge = name(edge);
    std::sort(m_edges.begin(), m_edges.end());
  }

  // Compares `edges`, which this rank gives, with those of the last call. Collective.
  void compare(Distributed_ranks_2& ranks, std::vector<Edge> edges)
  {
    std::vector<Edge> created, removed;
    std::sort(edges.begin(), edges.end());
    std::set_difference(edges.begin(), edges.end(), m_edges.begin(), m_edges.end(),
                        std::back_inserter(created));
    std::set_difference(m_edges.begin(), m_edges.end(), edges.begin(), edges.end(),
                        std::back_inserter(removed));
    m_edges = std::move(edges);
    list_once(ranks, created, removed);
  }

  // The changes that are listed on this rank, ascending.
  const std::vector<Edge>& created() const { return m_created; }
  const std::vector<Edge>& removed() const { return m_removed; }

private:
  struct Change
  {
    decltype(Traits::sent(Edge())) edge;
    std::int64_t sign;
  };

  // Sends all changes of an edge to one rank: if only its owner has changed they cancel out.
  void list_once(Distributed_ranks_2& ranks, const std::vector<Edge>& created,
                 const std::vector<Edge>& removed)
  {
    const auto changes = ranks.delivered<Change>([&](const auto& post) {
      const auto note = [&](const Edge& edge, std::int64_t sign) {
        post(std::uint64_t(Traits::end(edge)) % ranks.size(), {Traits::sent(edge), sign});
      };
      for (const Edge& edge : created)
        note(edge, 1);
      for (const Edge& edge : removed)
        note(edge, -1);
    });
    std::map<Edge, std::int64_t> sums;
    for (const auto& [edge, sign] : changes)
      sums[Traits::received(edge)] += sign;
    m_created.clear();
    m_removed.clear();
    for (const auto& [edge, sum] : sums)
      if (sum != 0)
        (sum > 0 ? m_created : m_removed).push_back(edge);
  }

  std::vector<Edge> m_edges, m_created, m_removed;
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

namespace CGAL {

/*!
\ingroup PkgDynamicDelaunayTriangulation2Ref

Lists the finite edges of a `Distributed_dynamic_Delaunay_triangulation_2` that were created and
removed since the last `compute()`. Each such edge is in the list of one rank; an edge that has only
changed its owner is in no list.

Cost: the edges of each rank are sorted, and the changes are sent.

\sa `Distributed_periodic_edge_changes_2`
*/
class Distributed_edge_changes_2
{
public:
  /// the ids of the two ends of an edge, the smaller one first.
  using Edge = std::pair<std::int64_t, std::int64_t>;

  /// compares the edges with those at the last call. At the first call all edges count as created.
  /// Collective.
  /// \tparam Distributed a `Distributed_dynamic_Delaunay_triangulation_2`, always the same one.
  template <class Distributed>
  void compute(Distributed& dt)
  {
    auto& ranks = Dynamic_Delaunay_triangulations_2::internal::Distributed_access_2::ranks(dt);
    ranks.agree("Distributed_edge_changes_2::compute()");
    std::vector<Edge> edges;
    dt.for_each_edge([&](std::int64_t i, std::int64_t j) { edges.emplace_back(i, j); });
    m_edges.compare(ranks, std::move(edges));
  }

  /// the created edges that are listed on this rank, in ascending order.
  const std::vector<Edge>& created_edges() const { return m_edges.created(); }
  /// the removed edges that are listed on this rank, in ascending order.
  const std::vector<Edge>& removed_edges() const { return m_edges.removed(); }

private:
  struct Traits
  {
    using Edge = Distributed_edge_changes_2::Edge;

    static std::int64_t end(const Edge& edge) { return edge.first; }
    static std::array<std::int64_t, 2> sent(const Edge& edge) { return {edge.first, edge.second}; }
    static Edge received(const std::array<std::int64_t, 2>& ids) { return {ids[0], ids[1]}; }
  };

  Dynamic_Delaunay_triangulations_2::internal::Distributed_edge_comparison_2<Traits> m_edges;
};

} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_DISTRIBUTED_DISTRIBUTED_EDGE_CHANGES_2_H

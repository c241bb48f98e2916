// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_DISTRIBUTED_DISTRIBUTED_EDGE_CHANGES_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_DISTRIBUTED_DISTRIBUTED_EDGE_CHANGES_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/distributed/Distributed_edge_comparison_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/distributed/Message_exchange_2.h>

#include <cstdint>
#include <utility>
#include <vector>

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
    std::vector<Edge> edges;
    dt.for_each_edge([&](std::int64_t i, std::int64_t j) { edges.emplace_back(i, j); });
    m_edges.compare(dt.ranks(), std::move(edges));
  }

  /// the created edges that are listed on this rank, in ascending order.
  const std::vector<Edge>& created_edges() const { return m_edges.created(); }
  /// the removed edges that are listed on this rank, in ascending order.
  const std::vector<Edge>& removed_edges() const { return m_edges.removed(); }

private:
  using Message = Dynamic_Delaunay_triangulations_2::internal::Message_2;

  struct Traits
  {
    using Edge = Distributed_edge_changes_2::Edge;

    static std::int64_t end(const Edge& edge) { return edge.first; }
    static void write(const Edge& edge, Message& message)
    {
      message.write(edge.first);
      message.write(edge.second);
    }
    static Edge read(Message& message)
    {
      const auto i = message.read<std::int64_t>();
      return {i, message.read<std::int64_t>()};
    }
  };

  Dynamic_Delaunay_triangulations_2::internal::Distributed_edge_comparison_2<Traits> m_edges;
};

} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_DISTRIBUTED_DISTRIBUTED_EDGE_CHANGES_2_H

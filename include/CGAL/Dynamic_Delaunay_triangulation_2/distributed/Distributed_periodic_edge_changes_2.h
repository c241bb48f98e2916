// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_DISTRIBUTED_DISTRIBUTED_PERIODIC_EDGE_CHANGES_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_DISTRIBUTED_DISTRIBUTED_PERIODIC_EDGE_CHANGES_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/core/Floating_point_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/distributed/Distributed_edge_comparison_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/distributed/Message_exchange_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/distributed/zones/Distributed_translations_2.h>
#include <CGAL/Periodic_cell_2.h>

#include <cstddef>
#include <cstdint>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgDynamicDelaunayTriangulation2Periodic

Lists the edges of a `Distributed_dynamic_periodic_Delaunay_triangulation_2` that were created and
removed since the last `compute()`: what `Periodic_edge_changes_visitor_2` is for one process. Each
such edge is in the list of one rank; an edge that has only changed its owner is in no list.

All shifts, also those of removed edges, are for the present positions and the present cell: a point
that is wrapped, or a cell that is exchanged for another one of the same lattice, changes no edge.
Points are taken to have gone the shortest way since the last call, in multiples of the cell's
vectors, and the cell's present vectors to be those nearest to the former ones, as in one frame of
one process. So if `compute()` is called after each frame, the lists are those of one process,
except where more than three images are on an empty circle.

Cost: points and edges of each rank are sorted; the changes are sent, and every rank hears of all
points that were wrapped.

\sa `Distributed_edge_changes_2`
*/
class Distributed_periodic_edge_changes_2
{
public:
  /// an edge from point `i` to the image of point `j` by `shift`. `i` is not larger than `j`; where
  /// they are equal, the first number of `shift` that is not 0 is positive.
  struct Edge
  {
    std::int64_t i;         ///< an id
    std::int64_t j;         ///< an id
    Periodic_shift_2 shift; ///< of j

    /// compares `i`, `j` and `shift` in turn.
    friend bool operator<(const Edge& e, const Edge& f)
    {
      return std::tie(e.i, e.j, e.shift) < std::tie(f.i, f.j, f.shift);
    }
    /// compares all members.
    friend bool operator==(const Edge& e, const Edge& f)
    {
      return std::tie(e.i, e.j, e.shift) == std::tie(f.i, f.j, f.shift);
    }
  };

  /// compares the edges with those at the last call. At the first call all edges count as created.
  /// Collective.
  /// \tparam Distributed a `Distributed_dynamic_periodic_Delaunay_triangulation_2`, always the same
  /// one.
  template <class Distributed>
  void compute(Distributed& dt)
  {
    const Floating_point floating_point;
    const std::vector<std::int64_t> ids = dt.owned_ids();
    const auto points = dt.owned_points();
    std::vector<Translations::Entry> own;
    for (std::size_t k = 0; k < ids.size(); ++k)
      own.push_back({ids[k], points[k].x(), points[k].y()});
    m_translations.compute(dt.ranks(), dt.cell(), std::move(own));
    m_edges.rename([&](const Edge& e) {
      return in_order({e.i, e.j, m_translations.renamed(e.i, e.j, e.shift)});
    });
    std::vector<Edge> edges;
    dt.for_each_edge([&](std::int64_t i, std::int64_t j, const Periodic_shift_2& shift) {
      edges.push_back(in_order({i, j, shift}));
    });
    m_edges.compare(dt.ranks(), std::move(edges));
  }

  /// the created edges that are listed on this rank, in ascending order.
  const std::vector<Edge>& created_edges() const { return m_edges.created(); }
  /// the removed edges that are listed on this rank, in ascending order.
  const std::vector<Edge>& removed_edges() const { return m_edges.removed(); }

private:
  using Floating_point = Dynamic_Delaunay_triangulations_2::internal::Default_floating_point_2;
  using Message = Dynamic_Delaunay_triangulations_2::internal::Message_2;
  using Translations = Dynamic_Delaunay_triangulations_2::internal::Distributed_translations_2;

  struct Traits
  {
    using Edge = Distributed_periodic_edge_changes_2::Edge;

    static std::int64_t end(const Edge& edge) { return edge.i; }
    static void write(const Edge& edge, Message& message) { message.write(edge); }
    static Edge read(Message& message) { return message.read<Edge>(); }
  };

  // Returns the edge as it is listed: its reverse, for some edges from a point to its own image.
  static Edge in_order(const Edge& edge)
  {
    const Edge reverse{edge.j, edge.i, {-edge.shift[0], -edge.shift[1]}};
    return edge.i == edge.j && edge < reverse ? reverse : edge;
  }

  Translations m_translations;
  Dynamic_Delaunay_triangulations_2::internal::Distributed_edge_comparison_2<Traits> m_edges;
};

} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_DISTRIBUTED_DISTRIBUTED_PERIODIC_EDGE_CHANGES_2_H

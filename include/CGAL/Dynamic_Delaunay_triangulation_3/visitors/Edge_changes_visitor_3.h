// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_VISITORS_EDGE_CHANGES_VISITOR_3_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_VISITORS_EDGE_CHANGES_VISITOR_3_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/visitors/Edge_balance.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/visitors/Delaunay_update_visitor_base_3.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgDynamicDelaunayTriangulation2Visitors

Lists the finite edges and facets in space that were created and removed since `clear()` was last
called, or since the visitor was constructed. What was removed and created again in between is in
neither list. So the edges at that time, minus `removed_edges()` and plus `created_edges()`, are the
current edges; facets likewise.

The lists are computed when they are asked for, so several threads must not ask at once.
*/
class Edge_changes_visitor_3 : public Delaunay_update_visitor_base_3
{
public:
  /// the ids of the two ends of an edge, ascending.
  using Edge = std::array<std::size_t, 2>;
  /// the ids of the three vertices of a facet, ascending.
  using Facet = std::array<std::size_t, 3>;

  /// the created edges, in ascending order.
  const std::vector<Edge>& created_edges() const { return listed(m_edges).created(); }
  /// the removed edges, in ascending order.
  const std::vector<Edge>& removed_edges() const { return listed(m_edges).removed(); }
  /// the created facets, in ascending order.
  const std::vector<Facet>& created_facets() const { return listed(m_facets).created(); }
  /// the removed facets, in ascending order.
  const std::vector<Facet>& removed_facets() const { return listed(m_facets).removed(); }

  /// forgets all recorded changes, and starts to record anew.
  void clear()
  {
    m_edges.clear();
    m_facets.clear();
  }

  /// \cond
  template <class Dynamic>
  void after_edge_removal(const Dynamic&, std::size_t i, std::size_t j)
  {
    m_edges.note({i, j}, -1);
  }
  template <class Dynamic>
  void after_edge_creation(const Dynamic&, std::size_t i, std::size_t j)
  {
    m_edges.note({i, j}, 1);
  }
  template <class Dynamic>
  void after_facet_removal(const Dynamic&, const Facet& facet)
  {
    m_facets.note(facet, -1);
  }
  template <class Dynamic>
  void after_facet_creation(const Dynamic&, const Facet& facet)
  {
    m_facets.note(facet, 1);
  }
  /// \endcond

private:
  template <class Simplex>
  using Balance = Dynamic_Delaunay_triangulations_2::internal::Edge_balance<Simplex>;

  template <class Simplex>
  static const Balance<Simplex>& listed(Balance<Simplex>& balance)
  {
    balance.list([](const Simplex& simplex) { return simplex; });
    return balance;
  }

  mutable Balance<Edge> m_edges;
  mutable Balance<Facet> m_facets;
};

} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_VISITORS_EDGE_CHANGES_VISITOR_3_H

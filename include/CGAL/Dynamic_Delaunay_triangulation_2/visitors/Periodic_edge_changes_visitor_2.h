// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_VISITORS_PERIODIC_EDGE_CHANGES_VISITOR_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_VISITORS_PERIODIC_EDGE_CHANGES_VISITOR_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/visitors/Delaunay_update_visitor_base_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/visitors/Edge_changes_visitor_2.h>
#include <CGAL/Periodic_cell_2.h>

#include <array>
#include <cstddef>
#include <tuple>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

// An edge from point i to the image of point j by `shift`.
template <class Id>
struct Periodic_edge_2
{
  Id i, j;
  Periodic_shift_2 shift;

  friend bool operator<(const Periodic_edge_2& e, const Periodic_edge_2& f)
  {
    return std::tie(e.i, e.j, e.shift) < std::tie(f.i, f.j, f.shift);
  }
  friend bool operator==(const Periodic_edge_2& e, const Periodic_edge_2& f)
  {
    return std::tie(e.i, e.j, e.shift) == std::tie(f.i, f.j, f.shift);
  }

  // Returns the direction of the edge in which i is not larger than j, and where they are equal,
  // the first number of the shift that is not 0 is positive.
  Periodic_edge_2 in_order() const
  {
    const Periodic_edge_2 reverse{j, i, {-shift[0], -shift[1]}};
    if (i != j)
      return i < j ? *this : reverse;
    return reverse < *this ? *this : reverse;
  }
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

namespace CGAL {

/*!
\ingroup PkgDynamicDelaunayTriangulation2Periodic

Lists the edges that were created and removed since `clear()` was last called, or since the visitor
was constructed. An edge that was removed and created again in between is in neither list. In a
tissue or a foam these are the neighbor exchanges (T1 events): one removed and one created edge for
each.

All shifts, also those of removed edges, are for the present positions and the present cell: a point
that is wrapped, or a cell that is exchanged for another one of the same lattice, changes no edge.

Cost: proportional to the number of changes; a call that triangulates everything anew counts as all
edges. Asking for the lists costs that number times its logarithm.

\cgalModels{PeriodicUpdateVisitor_2}
*/
class Periodic_edge_changes_visitor_2 : public Delaunay_update_visitor_base_2
{
public:
  /// an edge from point `i` to the image of point `j` by `shift`. These are its members: two ids,
  /// and a `Periodic_shift_2`; `<` and `==` compare them in turn. `i` is not larger than `j`; where
  /// they are equal, the first number of `shift` that is not 0 is positive.
  using Edge = Dynamic_Delaunay_triangulations_2::internal::Periodic_edge_2<std::size_t>;

  /// the created edges, in ascending order.
  const std::vector<Edge>& created_edges() const { return listed().created(); }

  /// the removed edges, in ascending order. Their ids may belong to points that no longer exist, or
  /// to new points that got the same ids.
  const std::vector<Edge>& removed_edges() const { return listed().removed(); }

  /// forgets all recorded changes, and starts to record anew.
  void clear()
  {
    m_changes.clear();
    m_ways.clear();
  }

  /// \cond
  template <class Dynamic>
  void after_edge_removal(const Dynamic&, std::size_t i, std::size_t j,
                          const Periodic_shift_2& shift)
  {
    note(i, j, shift, -1);
  }

  template <class Dynamic>
  void after_edge_creation(const Dynamic&, std::size_t i, std::size_t j,
                           const Periodic_shift_2& shift)
  {
    note(i, j, shift, 1);
  }

  template <class Dynamic>
  void after_translation(const Dynamic&, std::size_t i, const Periodic_shift_2& shift)
  {
    if (i >= m_ways.size())
      m_ways.resize(i + 1, Periodic_shift_2{0, 0});
    m_ways[i] = {m_ways[i][0] + shift[0], m_ways[i][1] + shift[1]};
    m_changes.forget_lists();
  }

  template <class Dynamic>
  void after_cell_exchange(const Dynamic&, const std::array<Periodic_shift_2, 2>& multiples)
  {
    const auto exchange = [&](Periodic_shift_2& s) {
      s = {s[0] * multiples[0][0] + s[1] * multiples[1][0],
           s[0] * multiples[0][1] + s[1] * multiples[1][1]};
    };
    m_changes.rename([&](Edge& edge) { exchange(edge.shift); });
    for (Periodic_shift_2& way : m_ways)
      exchange(way);
  }
  /// \endcond

private:
  using Changes = Dynamic_Delaunay_triangulations_2::internal::Edge_balance_2<Edge>;

  Periodic_shift_2 way(std::size_t i) const
  {
    return i < m_ways.size() ? m_ways[i] : Periodic_shift_2{0, 0};
  }

  // Returns an edge as it is named after its points were translated by `of_i` and `of_j`.
  static Edge translated(Edge edge, const Periodic_shift_2& of_i, const Periodic_shift_2& of_j)
  {
    for (std::size_t k = 0; k < 2; ++k)
      edge.shift[k] += of_i[k] - of_j[k];
    return edge.in_order();
  }

  void note(std::size_t i, std::size_t j, const Periodic_shift_2& shift, int sign)
  {
    const Periodic_shift_2 of_i = way(i), of_j = way(j);
    m_changes.note(translated({i, j, shift}, {-of_i[0], -of_i[1]}, {-of_j[0], -of_j[1]}), sign);
  }

  const Changes& listed() const
  {
    m_changes.list([this](const Edge& e) { return translated(e, way(e.i), way(e.j)); });
    return m_changes;
  }

  // The edges have the shifts that they would have if no point had been translated since clear().
  mutable Changes m_changes;
  std::vector<Periodic_shift_2> m_ways; // by which each id was translated since clear()
};

} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_VISITORS_PERIODIC_EDGE_CHANGES_VISITOR_2_H

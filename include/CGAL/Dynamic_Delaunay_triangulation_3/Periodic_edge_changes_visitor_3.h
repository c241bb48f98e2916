// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_PERIODIC_EDGE_CHANGES_VISITOR_3_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_PERIODIC_EDGE_CHANGES_VISITOR_3_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/visitors/Edge_changes_visitor_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/Delaunay_update_visitor_base_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/Periodic_shift_3.h>

#include <array>
#include <cstddef>
#include <tuple>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgDynamicDelaunayTriangulation2Periodic

Lists the edges of periodic space that were created and removed since `clear()` was last called, or
since the visitor was constructed. An edge that was removed and created again in between is in
neither list. In a glass or a foam these are the exchanges of neighbors.

All shifts, also those of removed edges, are for the present positions and the present cell: a point
that is wrapped, or a cell that is exchanged for another one of the same lattice, changes no edge.

The lists are computed when they are asked for, so several threads must not ask at once. Cost:
proportional to the number of changes, times its logarithm; a rebuild counts as the edges that
differ.
*/
class Periodic_edge_changes_visitor_3 : public Delaunay_update_visitor_base_3
{
public:
  /// an edge from point `i` to the image of point `j` by `shift`. `<` and `==` compare these
  /// members in turn. `i` is not larger than `j`; where they are equal, the first number of `shift`
  /// that is not 0 is positive.
  struct Edge
  {
    std::size_t i;          ///< an id.
    std::size_t j;          ///< an id.
    Periodic_shift_3 shift; ///< of the image of `j`.

    /// \cond
    friend bool operator<(const Edge& e, const Edge& f)
    {
      // one by one: g++ 12 takes whole arrays for uninitialized here
      const auto members = [](const Edge& d) {
        return std::tie(d.i, d.j, d.shift[0], d.shift[1], d.shift[2]);
      };
      return members(e) < members(f);
    }
    friend bool operator==(const Edge& e, const Edge& f)
    {
      return std::tie(e.i, e.j, e.shift) == std::tie(f.i, f.j, f.shift);
    }
    /// \endcond
  };

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
                          const Periodic_shift_3& shift)
  {
    note({i, j, shift}, -1);
  }
  template <class Dynamic>
  void after_edge_creation(const Dynamic&, std::size_t i, std::size_t j,
                           const Periodic_shift_3& shift)
  {
    note({i, j, shift}, 1);
  }
  template <class Dynamic>
  void after_translation(const Dynamic&, std::size_t i, const Periodic_shift_3& shift)
  {
    if (i >= m_ways.size())
      m_ways.resize(i + 1, Periodic_shift_3{0, 0, 0});
    m_ways[i] = sum(m_ways[i], shift, 1);
    m_changes.forget_lists();
  }
  template <class Dynamic>
  void after_cell_exchange(const Dynamic&, const std::array<Periodic_shift_3, 3>& rows)
  {
    const auto exchange = [&](Periodic_shift_3& shift) {
      const Periodic_shift_3 before = shift;
      shift = {0, 0, 0};
      for (std::size_t k = 0; k < 3; ++k)
        shift = sum(shift, rows[k], before[k]);
    };
    m_changes.rename([&](Edge& edge) {
      exchange(edge.shift);
      edge = in_order(edge);
    });
    for (Periodic_shift_3& way : m_ways)
      exchange(way);
  }
  /// \endcond

private:
  using Changes = Dynamic_Delaunay_triangulations_2::internal::Edge_balance_2<Edge>;

  static Periodic_shift_3 sum(Periodic_shift_3 s, const Periodic_shift_3& t, int times)
  {
    for (std::size_t k = 0; k < 3; ++k)
      s[k] += times * t[k];
    return s;
  }

  static Edge in_order(const Edge& edge)
  {
    const Edge reverse{edge.j, edge.i, sum({0, 0, 0}, edge.shift, -1)};
    if (edge.i != edge.j)
      return edge.i < edge.j ? edge : reverse;
    return reverse < edge ? edge : reverse;
  }

  // Returns an edge as it is named after its points were translated by their ways, or before.
  Edge translated(Edge edge, int sign) const
  {
    const auto way = [this](std::size_t i) {
      return i < m_ways.size() ? m_ways[i] : Periodic_shift_3{0, 0, 0};
    };
    edge.shift = sum(sum(edge.shift, way(edge.i), sign), way(edge.j), -sign);
    return in_order(edge);
  }

  void note(const Edge& edge, int balance) { m_changes.note(translated(edge, -1), balance); }

  const Changes& listed() const
  {
    m_changes.list([this](const Edge& edge) { return translated(edge, 1); });
    return m_changes;
  }

  // The edges have the shifts that they would have if no point had been translated since clear().
  mutable Changes m_changes;
  std::vector<Periodic_shift_3> m_ways; // by which each id was translated since clear()
};

} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_PERIODIC_EDGE_CHANGES_VISITOR_3_H

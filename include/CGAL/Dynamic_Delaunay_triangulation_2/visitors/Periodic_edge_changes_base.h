// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_VISITORS_PERIODIC_EDGE_CHANGES_BASE_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_VISITORS_PERIODIC_EDGE_CHANGES_BASE_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/visitors/Edge_balance.h>

#include <array>
#include <cstddef>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgDynamicDelaunayTriangulation2Periodic

An edge of periodic space, from point `i` to the image of point `j` by `shift`. `<` and `==` compare
these members in turn.

\tparam Id an integer.
\tparam Shift `Periodic_shift_2` or `Periodic_shift_3`.
*/
template <class Id, class Shift>
struct Periodic_edge
{
  Id i;        ///< an id.
  Id j;        ///< an id.
  Shift shift; ///< of the image of `j`.

  /// whether `e` is before `f`.
  friend bool operator<(const Periodic_edge& e, const Periodic_edge& f)
  {
    if (e.i != f.i || e.j != f.j)
      return std::tie(e.i, e.j) < std::tie(f.i, f.j);
    // one by one: g++ 12 takes whole arrays for uninitialized here
    std::size_t n = 0;
    while (n + 1 < e.shift.size() && e.shift[n] == f.shift[n])
      ++n;
    return e.shift[n] < f.shift[n];
  }
  /// whether all members are equal.
  friend bool operator==(const Periodic_edge& e, const Periodic_edge& f)
  {
    return std::tie(e.i, e.j, e.shift) == std::tie(f.i, f.j, f.shift);
  }

  /// the direction of the edge in which `i` is not larger than `j`, and where they are equal, the
  /// first number of `shift` that is not 0 is positive.
  Periodic_edge in_order() const
  {
    Periodic_edge reverse{j, i, shift};
    for (int& number : reverse.shift)
      number = -number;
    if (i != j)
      return i < j ? *this : reverse;
    return reverse < *this ? *this : reverse;
  }
};

/*!
\ingroup PkgDynamicDelaunayTriangulation2Periodic

What `Periodic_edge_changes_visitor_2` and `Periodic_edge_changes_visitor_3` have in common. The
lists are computed when they are asked for, so several threads must not ask at once.

\tparam Base the visitor that ignores everything.
\tparam Shift `Periodic_shift_2` or `Periodic_shift_3`.
*/
template <class Base, class Shift>
class Periodic_edge_changes_base : public Base
{
public:
  /// an edge from point `i` to the image of point `j` by `shift`, the way round that
  /// `Periodic_edge::in_order()` gives.
  using Edge = Periodic_edge<std::size_t, Shift>;

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
  void after_edge_removal(const Dynamic&, std::size_t i, std::size_t j, const Shift& shift)
  {
    note({i, j, shift}, -1);
  }

  template <class Dynamic>
  void after_edge_creation(const Dynamic&, std::size_t i, std::size_t j, const Shift& shift)
  {
    note({i, j, shift}, 1);
  }

  template <class Dynamic>
  void after_translation(const Dynamic&, std::size_t i, const Shift& shift)
  {
    if (i >= m_ways.size())
      m_ways.resize(i + 1, Shift{});
    m_ways[i] = sum(m_ways[i], shift, 1);
    m_changes.forget_lists();
  }

  template <class Dynamic>
  void after_cell_exchange(const Dynamic&,
                           const std::array<Shift, std::tuple_size<Shift>::value>& multiples)
  {
    const auto exchange = [&](Shift& shift) {
      const Shift before = std::exchange(shift, Shift{});
      for (std::size_t k = 0; k < before.size(); ++k)
        shift = sum(shift, multiples[k], before[k]);
    };
    m_changes.rename([&](Edge& edge) {
      exchange(edge.shift);
      edge = edge.in_order();
    });
    for (Shift& way : m_ways)
      exchange(way);
  }
  /// \endcond

private:
  using Changes = Dynamic_Delaunay_triangulations_2::internal::Edge_balance<Edge>;

  static Shift sum(Shift s, const Shift& t, int times)
  {
    for (std::size_t k = 0; k < s.size(); ++k)
      s[k] += times * t[k];
    return s;
  }

  // Returns an edge as it is named after its points were translated by their ways, or before.
  Edge translated(Edge edge, int sign) const
  {
    const auto way = [this](std::size_t i) { return i < m_ways.size() ? m_ways[i] : Shift{}; };
    edge.shift = sum(sum(edge.shift, way(edge.i), sign), way(edge.j), -sign);
    return edge.in_order();
  }

  void note(const Edge& edge, int balance) { m_changes.note(translated(edge, -1), balance); }

  const Changes& listed() const
  {
    m_changes.list([this](const Edge& edge) { return translated(edge, 1); });
    return m_changes;
  }

  // The edges have the shifts that they would have if no point had been translated since clear().
  mutable Changes m_changes;
  std::vector<Shift> m_ways; // by which each id was translated since clear()
};

} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_VISITORS_PERIODIC_EDGE_CHANGES_BASE_H

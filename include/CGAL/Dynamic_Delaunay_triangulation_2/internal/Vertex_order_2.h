// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_VERTEX_ORDER_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_VERTEX_ORDER_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Spatial_order_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Vertex_predicates_2.h>
#include <CGAL/enum.h>

#include <cstddef>
#include <utility>

namespace CGAL {
namespace Dynamic_Delaunay_triangulations_2 {
namespace internal {

// A spatial order of vertices, where they are now.
template <class Maintained>
class Vertex_order_2
{
public:
  explicit Vertex_order_2(const Maintained& maintained)
    : m_maintained(maintained)
    , m_predicates(maintained)
  {
  }

  template <class Iterator>
  void sort(Iterator first, Iterator beyond)
  {
    if (m_maintained.positions_are_exact())
      m_order.sort(m_maintained.positions(), first, beyond);
    else
      m_order.sort_by_comparisons(first, beyond, [this](Index v, Index w) {
        return m_predicates.compare_xy(v, w) == SMALLER;
      });
  }

  const Spatial_order_2& order() const { return m_order; }
  // Leaves nothing.
  Spatial_order_2 take_order() { return std::exchange(m_order, {}); }

  // Coincident ones follow each other.
  bool has_coincident_vertices() const
  {
    for (std::size_t i = 1; i < m_order.size(); ++i)
      if (is_where_the_last_one_is(i))
        return true;
    return false;
  }

  // Calls f(v, w) for every vertex w that has the same place as the one before it, v being the
  // first one there.
  template <class Function>
  void for_each_coincident_pair(const Function& f) const
  {
    for (std::size_t first = 0, i = 1; i < m_order.size(); ++i)
      if (is_where_the_last_one_is(i))
        f(m_order[first], m_order[i]);
      else
        first = i;
  }

  // The steps to a vertex whose number is far away: it has to be fetched from memory.
  std::size_t number_of_far_steps() const
  {
    constexpr Index far_away = 64;
    std::size_t steps = 0;
    for (std::size_t i = 1; i < m_order.size(); ++i)
      steps += m_order[i - 1] + far_away < m_order[i] || m_order[i] + far_away < m_order[i - 1];
    return steps;
  }

  void release() { m_order.release(); }

private:
  bool is_where_the_last_one_is(std::size_t i) const
  {
    return m_predicates.compare_xy(m_order[i - 1], m_order[i]) == EQUAL;
  }

  const Maintained& m_maintained;
  Vertex_predicates_2<Maintained> m_predicates;
  Spatial_order_2 m_order;
};

} // namespace internal
} // namespace Dynamic_Delaunay_triangulations_2
} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_VERTEX_ORDER_2_H

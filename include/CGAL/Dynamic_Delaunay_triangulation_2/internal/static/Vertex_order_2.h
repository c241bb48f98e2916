// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_STATIC_VERTEX_ORDER_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_STATIC_VERTEX_ORDER_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Flat_arrays.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Spatial_order_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/proof/Edge_test_2.h>
#include <CGAL/enum.h>

#include <algorithm>
#include <cstddef>
#include <utility>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

// A spatial order of vertices at their present positions.
template <class State>
class Vertex_order_2
{
  using Parts = typename State::Parts;

public:
  explicit Vertex_order_2(const State& state)
    : m_state(state)
    , m_predicates(state)
  {
  }

  template <class Iterator>
  void sort(Iterator first, Iterator beyond)
  {
    if (m_state.positions_are_exact())
      m_order.template sort<Parts>(m_state.positions(), first, beyond);
    else
      m_order.sort_by_comparisons(first, beyond, [this](Index v, Index w) {
        return m_predicates.compare_xy(Vertex_index(v), Vertex_index(w)) == SMALLER;
      });
  }

  const Spatial_order_2& order() const { return m_order; }
  // Returns the order, and leaves none.
  Spatial_order_2 take_order() { return std::exchange(m_order, {}); }

  // Whether vertices coincide. Those that do are consecutive.
  bool has_coincident_vertices() const
  {
    return !m_order.template are_distinct<Parts>([this](Index v, Index w) {
      return m_predicates.coincide(Vertex_index(v), Vertex_index(w));
    });
  }

  // Calls f(v, w) for every vertex w that coincides with earlier ones, of which v is the first.
  template <class Function>
  void for_each_coincident_pair(const Function& f) const
  {
    for (std::size_t first = 0, i = 1; i < m_order.size(); ++i)
      if (m_predicates.coincide(vertex(i - 1), vertex(i)))
        f(vertex(first), vertex(i));
      else
        first = i;
  }

  // The number of steps to a vertex with a distant number, which must be fetched from memory.
  std::size_t number_of_far_steps() const
  {
    constexpr Index far_away = 64;
    return Parts::sum(m_order.size(), [this](std::size_t first, std::size_t beyond) {
      std::size_t steps = 0;
      for (std::size_t i = (std::max)(first, std::size_t(1)); i < beyond; ++i)
        steps += m_order[i - 1] + far_away < m_order[i] || m_order[i] + far_away < m_order[i - 1];
      return steps;
    });
  }

  void release() { m_order.release(); }

private:
  Vertex_index vertex(std::size_t i) const { return Vertex_index(m_order[i]); }

  const State& m_state;
  Vertex_predicates_2<State> m_predicates;
  Spatial_order_2 m_order;
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_STATIC_VERTEX_ORDER_2_H

// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SPACE_CLASSIFIERS_BROKEN_VERTICES_3_H
#define SPACE_CLASSIFIERS_BROKEN_VERTICES_3_H

#include <CGAL/Dynamic_Delaunay_triangulation_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/proof/Cell_pass_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/proof/Cell_signs_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace space_classifiers {

// What a motion has broken before it is mended, by exact predicates: the vertices of finite cells
// that are not positive, and those of both cells at facets that are not locally Delaunay.
class Broken_vertices_3
{
  using Dynamic =
      CGAL::Dynamic_Delaunay_triangulation_3<CGAL::Exact_predicates_inexact_constructions_kernel>;
  using Point = Dynamic::Point;
  using State = std::decay_t<
      decltype(CGAL::Dynamic_Delaunay_triangulations_3::internal::Triangulation_access::state(
          std::declval<const Dynamic&>()))>;
  using Signs = CGAL::Dynamic_Delaunay_triangulations_3::internal::Cell_signs_3<State>;
  using Cell_index = CGAL::Dynamic_Delaunay_triangulations_3::Cell_index;
  using Vertex_index = CGAL::Dynamic_Delaunay_triangulations_3::Vertex_index;

public:
  // Looks at all cells of the last frame with new positions. No two points may coincide.
  void find(const Dynamic& dt, const std::vector<Point>& points)
  {
    using namespace CGAL::Dynamic_Delaunay_triangulations_3::internal;
    m_state = Triangulation_access::state(dt); // with its cells
    for (Vertex_index v(1); v <= m_state.number_of_vertices(); ++v) {
      const Point& p = points[m_state.ids.representative(v)];
      m_state.positions.set(v, {{p.x(), p.y(), p.z()}, p});
    }
    m_is_broken.assign(points.size(), false);
    const Signs signs(m_state);
    for (Cell_index c(0); c < m_state.arrays.number_of_cells(); ++c) {
      find(signs, c);
    }
  }

  // Does what an exact classifier does in these cells: the pass of the filter, and exact predicates
  // for what it has not proved. Returns the number of cells that are broken.
  std::size_t classify()
  {
    CGAL::Dynamic_Delaunay_triangulations_3::internal::find_unproved(m_state, m_unproved);
    const Signs signs(m_state);
    std::size_t number = 0;
    for (const Cell_index c : m_unproved.finite) {
      number += !signs.is_positive(m_state.arrays.vertices(c)) || has_illegal_facet(signs, c);
    }
    for (const Cell_index c : m_unproved.infinite) {
      number += has_illegal_facet(signs, c);
    }
    return number;
  }

  bool is_broken(std::size_t id) const { return m_is_broken[id]; }
  std::size_t number() const
  {
    return std::size_t(std::count(m_is_broken.begin(), m_is_broken.end(), true));
  }

private:
  void find(const Signs& signs, Cell_index c)
  {
    if (!m_state.arrays.is_infinite(c) && !signs.is_positive(m_state.arrays.vertices(c))) {
      mark(c);
      return;
    }
    for (int place = 0; place != 4; ++place) {
      if (is_illegal(signs, c, place)) {
        mark(c);
        mark(m_state.arrays.neighbor(c, place));
      }
    }
  }

  bool has_illegal_facet(const Signs& signs, Cell_index c) const
  {
    for (int place = 0; place != 4; ++place) {
      if (is_illegal(signs, c, place)) {
        return true;
      }
    }
    return false;
  }

  // Facets between a finite and an infinite cell are legal if the finite one is positive.
  bool is_illegal(const Signs& signs, Cell_index c, int place) const
  {
    const auto& arrays = m_state.arrays;
    return arrays.is_infinite(arrays.neighbor(c, place)) == arrays.is_infinite(c) &&
           signs.is_illegal(arrays.vertices(c), arrays.apex(arrays.corner(c, place)));
  }

  void mark(Cell_index c)
  {
    for (const Vertex_index v : m_state.arrays.vertices(c)) {
      if (v != CGAL::Dynamic_Delaunay_triangulations_3::internal::infinite_index) {
        m_is_broken[m_state.ids.representative(v)] = true;
      }
    }
  }

  State m_state;
  CGAL::Dynamic_Delaunay_triangulations_3::internal::Unproved_cells_3 m_unproved;
  std::vector<bool> m_is_broken;
};

} // namespace space_classifiers

#endif // SPACE_CLASSIFIERS_BROKEN_VERTICES_3_H

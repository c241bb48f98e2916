// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_PROOF_FILTERED_CERTIFICATE_3_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_PROOF_FILTERED_CERTIFICATE_3_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/proof/Cell_pass_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/proof/Cell_signs_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/proof/Certificate_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/proof/Exact_hull_count_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/topology/Tetrahedra_arrays_3.h>

#include <algorithm>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_3::internal {

// Proves that cells that fit together are a Delaunay triangulation: as `Certificate_3` does, but
// exact predicates decide only what the pass in floating point leaves.
template <class State>
class Filtered_certificate_3
{
public:
  explicit Filtered_certificate_3(const State& state)
    : m_state(state)
    , m_signs(state)
  {
  }

  // `unproved` gets what the pass leaves.
  bool holds(Unproved_cells_3& unproved) const
  {
    if (!m_state.has_origin) // doubles have no point inside of the hull
      return Certificate_3<State>(m_state).holds() && Exact_hull_count_3<State>(m_state).is_one();
    find_unproved(m_state, unproved);
    const auto is_right = [this](Cell_index c) {
      return m_signs.is_positive(m_state.arrays.vertices(c));
    };
    const auto has_legal_facets = [this](Cell_index c) { return are_facets_legal(c); };
    return all_of(unproved.finite, is_right) && all_of(unproved.infinite, is_right) &&
           all_of(unproved.finite, has_legal_facets) &&
           all_of(unproved.infinite, has_legal_facets) &&
           Hull_count_3<State>(m_state).is_one(unproved.infinite);
  }

private:
  template <class Predicate>
  static bool all_of(const std::vector<Cell_index>& cells, const Predicate& is)
  {
    return std::all_of(cells.begin(), cells.end(), is);
  }

  // Whether no facet to a cell of the same kind, finite or infinite, is illegal.
  bool are_facets_legal(Cell_index c) const
  {
    const Tetrahedra_arrays_3& arrays = m_state.arrays;
    const bool is_infinite = arrays.is_infinite(c);
    for (int i = 0; i < 4; ++i)
      if (arrays.is_infinite(arrays.neighbor(c, i)) == is_infinite &&
          m_signs.is_illegal(arrays.vertices(c), arrays.apex(arrays.corner(c, i))))
        return false;
    return true;
  }

  const State& m_state;
  Cell_signs_3<State> m_signs;
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_3::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_PROOF_FILTERED_CERTIFICATE_3_H

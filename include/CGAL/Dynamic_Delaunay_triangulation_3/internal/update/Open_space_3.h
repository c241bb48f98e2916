// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_UPDATE_OPEN_SPACE_3_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_UPDATE_OPEN_SPACE_3_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/mending/Vertex_insertion_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/mending/Vertex_removal_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/proof/Certificate_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/proof/Filtered_certificate_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/space/Triangulation_state_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/static/Static_triangulator_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/topology/Cell_set_3.h>

#include <string_view>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_3::internal {

// The proof that there is a Delaunay triangulation of points of open space, also without cells.
template <class State>
class Open_proof_3
{
public:
  explicit Open_proof_3(State& state)
    : m_state(state)
  {
  }

  // `unproved` gets what the pass in floating point leaves.
  bool holds(Unproved_cells_3& unproved) const
  {
    return m_state.spans_space ? Filtered_certificate_3<State>(m_state).holds(unproved)
                               : are_coplanar();
  }
  // What is wrong, or null, by exact predicates alone.
  const char* problem() const
  {
    if (!m_state.spans_space)
      return are_coplanar() ? nullptr : "there are no cells, and the points are not coplanar";
    const Certificate_3<State> certificate(m_state);
    if (!certificate.is_combinatorially_valid())
      return "the cells do not fit together, or a vertex has none";
    return certificate.holds() ? nullptr : "it is not Delaunay";
  }
  // Whether cells, which are all positive, cover space once.
  bool go_on_to_cover_once()
  {
    find_star(m_state.arrays, infinite_index, m_in_star, m_star);
    return Hull_count_3<State>(m_state).is_one(m_star);
  }

private:
  bool are_coplanar() const
  {
    std::vector<Vertex_index> vertices;
    for (Vertex_index v(1); v < m_state.positions.number(); ++v)
      vertices.push_back(v);
    return !begins_with_a_cell(m_state, vertices);
  }

  State& m_state;
  std::vector<Cell_index> m_star;
  Cell_set_3 m_in_star;
};

// Space without a boundary: what an update does there.
template <class Traits, class ConcurrencyTag>
struct Open_space_3
{
  static constexpr std::string_view name = "Dynamic_Delaunay_triangulation_3";

  using State = Triangulation_state_3<Traits, ConcurrencyTag>;
  using Insertion = Vertex_insertion_3<State>;
  using Removal = Vertex_removal_3<State>;
  using Static = Static_triangulator_3<State>;
  using Proof = Open_proof_3<State>;
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_3::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_UPDATE_OPEN_SPACE_3_H

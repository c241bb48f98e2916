// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_PROOF_VALIDITY_CHECK_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_PROOF_VALIDITY_CHECK_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/core/Points_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/core/Triangulation_state_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/proof/Certificate_2.h>
#include <CGAL/exceptions.h>

#include <cstddef>
#include <iostream>
#include <vector>

namespace CGAL {
namespace Dynamic_Delaunay_triangulations_2 {
namespace internal {

// Checks everything that must hold for a maintained triangulation between two calls.
template <class State>
class Validity_check_2
{
public:
  Validity_check_2(const State& state, bool verbose)
    : m_state(state)
    , m_verbose(verbose)
  {
  }

  bool passes(int level, bool is_certified) const
  {
    return says(is_data_structure_valid(level), "the triangulation data structure is not valid") &&
           says(is_no_point_lost(is_certified), "a point has no vertex, or not its own") &&
           says(!m_state.is_written_by_handles(), "handles have changed a vertex or a face") &&
           says(are_arrays_consistent(), "the half-edges are not those of a triangulation") &&
           says(is_simplicial(), "two edges have the same vertices") &&
           says(!is_certified || is_delaunay(), "the triangulation is certified, and not Delaunay");
  }

private:
  bool says(bool is_right, const char* complaint) const
  {
    if (!is_right && m_verbose)
      std::cerr << complaint << std::endl;
    return is_right;
  }

  // Whether is(i) for all numbers from `first` to before `beyond`.
  template <class Predicate>
  static bool all_of(Index first, std::size_t beyond, const Predicate& is)
  {
    return State::Parts::all_of(beyond - first, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i)
        if (!is(Index(first + i)))
          return false;
      return true;
    });
  }

  // CGAL's own check throws instead of answering where its assertions are enabled.
  bool is_data_structure_valid(int level) const
  {
    try {
      return m_state.triangulation().tds().is_valid(m_verbose, level);
    } catch (const Failure_exception&) {
      return false;
    }
  }

  // A duplicate may differ from its vertex only after an exception, until the next proof.
  bool is_no_point_lost(bool is_certified) const
  {
    const auto& ids = m_state.ids();
    if (m_state.triangulation().number_of_vertices() != m_state.number_of_vertices())
      return false;
    Index duplicates = 0;
    for (Index id = 0; id < ids.number_of_ids(); ++id) {
      if (!ids.is_taken(id))
        continue;
      const Index v = ids.vertex(id);
      if (v == infinite_index || v > m_state.number_of_vertices())
        return false;
      if (!ids.is_representative(id)) {
        ++duplicates;
        if (is_certified && !coincide(m_state.traits(), ids.duplicate(id).point, m_state.point(v)))
          return false;
      }
    }
    for (Index v = 1; v <= ids.number_of_representatives(); ++v)
      if (!ids.is_taken(ids.representative(v)) || ids.vertex(ids.representative(v)) != v)
        return false;
    return duplicates == ids.duplicates().size() &&
           m_state.number_of_vertices() == ids.number_of_representatives();
  }

  bool are_arrays_consistent() const
  {
    const auto& arrays = m_state.arrays();
    if (m_state.positions().size() != arrays.number_of_vertices())
      return false;
    if (!m_state.spans_plane())
      return arrays.number_of_faces() == 0;
    return all_of(0, 3 * std::size_t(arrays.number_of_faces()),
                  [this](Index h) { return is_halfedge_consistent(h); }) &&
           all_of(0, arrays.number_of_vertices(),
                  [&](Index v) { return arrays.apex(arrays.corner(v)) == v; });
  }

  bool is_simplicial() const
  {
    if (!m_state.spans_plane())
      return true;
    std::vector<Index> last_neighbor_of(m_state.arrays().number_of_vertices(), null_index);
    bool is_simplicial = true;
    for (Index v = 0; v < m_state.arrays().number_of_vertices(); ++v)
      m_state.arrays().for_each_neighbor(v, [&](Index w) {
        is_simplicial = is_simplicial && last_neighbor_of[w] != v;
        last_neighbor_of[w] = v;
      });
    return is_simplicial;
  }

  bool is_halfedge_consistent(Index h) const
  {
    const auto& arrays = m_state.arrays();
    const Index g = arrays.twin(h);
    const Edge_2& edge = arrays.edge(arrays.edge_of(h));
    const bool is_forward = edge.source == arrays.source(h);
    const Index left = is_forward ? edge.left : edge.right;
    const Index right = is_forward ? edge.right : edge.left;
    return arrays.twin(g) == h && arrays.edge_of(g) == arrays.edge_of(h) &&
           arrays.source(g) == arrays.target(h) && arrays.target(g) == arrays.source(h) &&
           left == arrays.apex(h) && right == arrays.apex(g) &&
           (is_forward ? edge.target : edge.source) == arrays.target(h);
  }

  bool is_delaunay() const
  {
    if (m_state.spans_plane())
      return Certificate_2<State>(m_state).holds();
    try { // on a line the triangulation is CGAL's own work
      return m_state.triangulation().is_valid();
    } catch (const Failure_exception&) {
      return false;
    }
  }

  const State& m_state;
  bool m_verbose;
};

} // namespace internal
} // namespace Dynamic_Delaunay_triangulations_2
} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_PROOF_VALIDITY_CHECK_2_H

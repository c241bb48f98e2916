// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_PROOF_VALIDITY_CHECK_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_PROOF_VALIDITY_CHECK_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Flat_arrays.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Flat_elements_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Points_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/proof/Certificate_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/topology/Halfedge_arrays_2.h>
#include <CGAL/exceptions.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <cstddef>
#include <iostream>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

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
           says(are_arrays_consistent(), "the half-edges are not those of a triangulation") &&
           says(m_state.covers_space(), "the faces do not cover the torus once") &&
           says(is_simplicial(), "two edges have the same ends") &&
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
  template <class Index_of_kind, class Predicate>
  static bool all_of(Index first, std::size_t beyond, const Predicate& is)
  {
    return State::Parts::all_of(beyond - first, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i)
        if (!is(Index_of_kind(first + i)))
          return false;
      return true;
    });
  }

  // CGAL's own check throws instead of answering where its assertions are enabled. A torus has no
  // data structure of CGAL's.
  bool is_data_structure_valid([[maybe_unused]] int level) const
  {
    if constexpr (!State::is_periodic) {
      if (m_state.triangulation().number_of_vertices() != m_state.number_of_vertices())
        return false;
      try {
        return says(!m_state.is_written_by_handles(), "handles have changed a vertex or a face") &&
               m_state.triangulation().tds().is_valid(m_verbose, level);
      } catch (const Failure_exception&) {
        return false;
      }
    }
    return true;
  }

  // In the plane a duplicate may differ from its vertex after an exception, until the next proof.
  bool is_no_point_lost(bool is_certified) const
  {
    const auto& ids = m_state.ids();
    Index duplicates = 0;
    for (Point_id id(0); id < ids.number_of_ids(); ++id) {
      if (!ids.is_taken(id))
        continue;
      const Vertex_index v = ids.vertex(id);
      if (v == infinite_index || v > m_state.number_of_vertices())
        return false;
      if (!ids.is_representative(id)) {
        ++duplicates;
        if ((State::is_periodic || is_certified) && !m_state.is_at(ids.duplicate(id).point, v))
          return false;
      }
    }
    for (Vertex_index v(1); v <= ids.number_of_representatives(); ++v)
      if (!ids.is_taken(ids.representative(v)) || ids.vertex(ids.representative(v)) != v)
        return false;
    return duplicates == ids.duplicates().size() &&
           m_state.number_of_vertices() == ids.number_of_representatives();
  }

  bool are_arrays_consistent() const
  {
    const auto& arrays = m_state.arrays();
    const bool has_vertices =
        !State::is_periodic || m_state.spans_plane(); // at least the infinite one
    if (has_vertices && m_state.positions().size() != arrays.number_of_vertices())
      return false;
    if (!m_state.spans_plane())
      return arrays.number_of_faces() == 0;
    const auto is_face = [&](Face_index f) { return !arrays.is_empty_face(f); };
    const auto has_corner = [&](Vertex_index v) {
      return !arrays.is_outside(v) && arrays.apex(arrays.corner(v)) == v;
    };
    return all_of<Face_index>(0, arrays.number_of_faces(), is_face) &&
           all_of<Halfedge_index>(
               0, arrays.number_of_halfedges(),
                  [this](Halfedge_index h) { return is_halfedge_consistent(h); }) &&
           all_of<Vertex_index>(first_vertex, arrays.number_of_vertices(), has_corner);
  }

  // Whether no two edges have the same ends, as seen from one end, and none ends where it begins.
  bool is_simplicial() const
  {
    if (!m_state.spans_plane())
      return true;
    using Arrays = Halfedge_arrays_2;
    std::vector<typename State::Site> ends;
    for (Vertex_index v = first_vertex; v < m_state.arrays().number_of_vertices(); ++v) {
      ends.assign(1, State::site_of(v));
      m_state.arrays().for_each_corner(v, [&](Halfedge_index h) {
        ends.push_back(m_state.site_in(Arrays::next(h), m_state.chart_at(h)));
      });
      std::sort(ends.begin(), ends.end());
      if (std::adjacent_find(ends.begin(), ends.end()) != ends.end())
        return false;
    }
    return true;
  }

  bool is_halfedge_consistent(Halfedge_index h) const
  {
    const auto& arrays = m_state.arrays();
    const Halfedge_index g = arrays.twin(h);
    const Edge_index e = arrays.edge_of(h);
    const Edge_2 edge = m_state.edge(e);
    const bool is_forward = m_state.is_along(e, arrays.halfedge(e)) == (h == arrays.halfedge(e));
    const Vertex_index left = is_forward ? edge.left : edge.right;
    const Vertex_index right = is_forward ? edge.right : edge.left;
    return m_state.is_shown_right(e) && arrays.twin(g) == h &&
           arrays.edge_of(g) == arrays.edge_of(h) && arrays.source(g) == arrays.target(h) &&
           arrays.target(g) == arrays.source(h) && left == arrays.apex(h) &&
           right == arrays.apex(g) &&
           (is_forward ? edge.source : edge.target) == arrays.source(h) &&
           (is_forward ? edge.target : edge.source) == arrays.target(h);
  }

  bool is_delaunay() const
  {
    if (State::is_periodic || m_state.spans_plane())
      return Certificate_2<State>(m_state).holds();
    if constexpr (!State::is_periodic)
      try { // on a line the triangulation is CGAL's own work
        return m_state.triangulation().is_valid();
      } catch (const Failure_exception&) {
      }
    return false;
  }

  static constexpr Vertex_index first_vertex{State::is_periodic ? 1 : 0};

  const State& m_state;
  bool m_verbose;
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_PROOF_VALIDITY_CHECK_2_H

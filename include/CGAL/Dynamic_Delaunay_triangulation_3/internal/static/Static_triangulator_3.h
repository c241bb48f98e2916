// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_STATIC_STATIC_TRIANGULATOR_3_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_STATIC_STATIC_TRIANGULATOR_3_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/mending/Vertex_insertion_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/proof/Certificate_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/static/Parallel_insertion_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/static/Vertex_order_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/topology/Canonical_cells_3.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_3::internal {

// Triangulates all vertices from scratch, by insertion in rounds (Amenta, Choi and Rote 2003): a
// share of the vertices, chosen at random, is left for the last round, the same share of the others
// for the one before, and so on; within a round they follow their numbers, which should follow a
// curve.
template <class State>
class Static_triangulator_3
{
  using Arrays = Tetrahedra_arrays_3;
  using Parts = typename State::Exact_parts;
  using Point = typename State::Point;

public:
  explicit Static_triangulator_3(State& state)
    : m_state(state)
    , m_insertion(state)
    , m_parallel_insertion(state, m_insertion)
    , m_signs(state)
  {
  }

  // Builds the cells of all vertices. `covered` lists vertices that coincide with others, each with
  // the one that has cells; they have none.
  void triangulate(std::vector<std::pair<Vertex_index, Vertex_index>>& covered)
  {
    covered.clear();
    const Index vertices = m_state.number_of_vertices();
    m_state.arrays.reset(vertices + 1);
    m_state.flat_edges.clear();
    m_state.flat_triangles.clear();
    m_state.has_origin = false;
    Rounds_3 rounds = rounds_of(vertices);
    std::vector<Vertex_index> first = one_after_the_other(rounds);
    m_state.spans_space = begins_with_a_cell(m_state, first);
    if (!m_state.spans_space)
      return triangulate_plane(covered);
    first.resize(4);
    m_insertion.begin({first[0], first[1], first[2], first[3]});
    for (const Vertex_index v : first) {
      std::vector<Vertex_index>& round = rounds[round_of(v)];
      round.erase(std::lower_bound(round.begin(), round.end(), v));
    }
    for (std::vector<Vertex_index>& round : rounds)
      m_parallel_insertion.insert(std::move(round), covered);
    Canonical_cells_3<Arrays, Parts>(m_state.arrays).order();
    choose_origin();
  }

  // Chooses a point strictly inside of the hull, if doubles have one.
  void choose_origin()
  {
    std::vector<Cell_index> infinite;
    for (Cell_index c(0); c < m_state.arrays.number_of_cells(); ++c)
      if (m_state.arrays.is_infinite(c))
        infinite.push_back(c);
    const auto [middle, extent] = middle_and_extent();
    m_state.has_origin = true;
    // off the center of symmetry, so that it is not in a plane with three vertices of a lattice
    for (const double factor : {0.01, 0.001, 0.0001, 1e-6, 0.0}) {
      m_state.origin = middle + Position_3{factor * 0.618 * extent.x, factor * -0.717 * extent.y,
                                           factor * 0.865 * extent.z};
      if (is_inside(infinite))
        return;
    }
    const Index cells = m_state.arrays.number_of_cells();
    for (Index i = 0; i < 64; ++i) {
      const Cell_index c(std::size_t(cells) * i / 64);
      if (m_state.arrays.is_infinite(c))
        continue;
      m_state.origin = middle_of(c);
      if (is_inside(infinite))
        return;
    }
    m_state.has_origin = false;
  }

private:
  // The mean of the vertices, and their extent along each axis.
  std::pair<Position_3, Position_3> middle_and_extent() const
  {
    const auto& positions = m_state.positions;
    Position_3 low = positions.position(Vertex_index(1)), high = low, sum{0, 0, 0};
    const double share = 1.0 / double(m_state.number_of_vertices());
    for (Vertex_index v(1); v <= m_state.number_of_vertices(); ++v) {
      const Position_3& p = positions.position(v);
      low = {(std::min)(low.x, p.x), (std::min)(low.y, p.y), (std::min)(low.z, p.z)};
      high = {(std::max)(high.x, p.x), (std::max)(high.y, p.y), (std::max)(high.z, p.z)};
      sum = sum + share * p;
    }
    return {sum, high - low};
  }

  Position_3 middle_of(Cell_index c) const
  {
    Position_3 sum{0, 0, 0};
    for (const Vertex_index v : m_state.arrays.vertices(c))
      sum = sum + 0.25 * m_state.positions.position(v);
    return sum;
  }

  bool is_inside(const std::vector<Cell_index>& infinite) const
  {
    if (!is_finite(m_state.origin))
      return false;
    return std::all_of(infinite.begin(), infinite.end(), [this](Cell_index c) {
      return m_signs.is_positive(m_state.arrays.vertices(c));
    });
  }

  // For points in a plane or on a line: CGAL triangulates these.
  void triangulate_plane(std::vector<std::pair<Vertex_index, Vertex_index>>& covered)
  {
    using Vertex_base = Triangulation_vertex_base_with_info_3<Vertex_index, typename State::Traits>;
    using Tds = Triangulation_data_structure_3<Vertex_base>;
    Delaunay_triangulation_3<typename State::Traits, Tds> flat(m_state.traits);
    for (Vertex_index v(1); v <= m_state.number_of_vertices(); ++v) {
      const std::size_t before = flat.number_of_vertices();
      const auto vertex = flat.insert(m_state.point(v));
      if (flat.number_of_vertices() == before)
        covered.emplace_back(v, vertex->info());
      else
        vertex->info() = v;
    }
    if (flat.dimension() >= 1)
      for (auto e = flat.finite_edges_begin(); e != flat.finite_edges_end(); ++e)
        m_state.flat_edges.push_back(
            {e->first->vertex(e->second)->info(), e->first->vertex(e->third)->info()});
    if (flat.dimension() == 2)
      for (auto f = flat.finite_facets_begin(); f != flat.finite_facets_end(); ++f)
        m_state.flat_triangles.push_back({f->first->vertex(0)->info(), f->first->vertex(1)->info(),
                                          f->first->vertex(2)->info()});
    sort_each(m_state.flat_edges);
    sort_each(m_state.flat_triangles);
  }

  // So that the lists depend on the points alone, not on how CGAL came to them.
  template <class Simplices>
  static void sort_each(Simplices& simplices)
  {
    for (auto& simplex : simplices)
      std::sort(simplex.begin(), simplex.end());
    std::sort(simplices.begin(), simplices.end());
  }

  State& m_state;
  typename Parallel_insertion_3<State>::Insertion m_insertion;
  Parallel_insertion_3<State> m_parallel_insertion;
  Cell_signs_3<State> m_signs;
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_3::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_STATIC_STATIC_TRIANGULATOR_3_H

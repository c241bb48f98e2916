// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_UPDATE_SIMPLEX_CHANGES_3_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_UPDATE_SIMPLEX_CHANGES_3_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/topology/Tetrahedra_arrays_3.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_3::internal {

// Finite edges and facets, by ascending ids of representatives.
struct Simplices_3
{
  using Edge = std::array<std::size_t, 2>;
  using Facet = std::array<std::size_t, 3>;

  void clear()
  {
    edges.clear();
    facets.clear();
  }

  // `name(v)` is the id of a vertex.
  template <class Name>
  void append_cell(const Vertices_3& v, const Name& name)
  {
    for (int i = 0; i < 4; ++i) {
      for (int j = i + 1; j < 4; ++j)
        append(edges, Few<Vertex_index, 2>{v[i], v[j]}, name);
      append(facets, Few<Vertex_index, 3>{v[(i + 1) % 4], v[(i + 2) % 4], v[(i + 3) % 4]}, name);
    }
  }
  // What there is without cells.
  template <class State>
  void append_flat(const State& state)
  {
    const auto name = [&state](Vertex_index v) { return state.ids.representative(v); };
    for (const auto& edge : state.flat_edges)
      append(edges, edge, name);
    for (const auto& triangle : state.flat_triangles)
      append(facets, triangle, name);
  }

  void make_distinct()
  {
    make_distinct(edges);
    make_distinct(facets);
  }

  // Those of `a` that are not among those of `b`; both are distinct.
  void assign_difference(const Simplices_3& a, const Simplices_3& b)
  {
    clear();
    std::set_difference(a.edges.begin(), a.edges.end(), b.edges.begin(), b.edges.end(),
                        std::back_inserter(edges));
    std::set_difference(a.facets.begin(), a.facets.end(), b.facets.begin(), b.facets.end(),
                        std::back_inserter(facets));
  }

  std::vector<Edge> edges;
  std::vector<Facet> facets;

private:
  template <class Simplex, class Vertices, class Name>
  static void append(std::vector<Simplex>& list, const Vertices& vertices, const Name& name)
  {
    if (std::find(vertices.begin(), vertices.end(), infinite_index) != vertices.end())
      return;
    Simplex simplex;
    std::transform(vertices.begin(), vertices.end(), simplex.begin(), name);
    std::sort(simplex.begin(), simplex.end());
    list.push_back(simplex);
  }
  template <class Simplex>
  static void make_distinct(std::vector<Simplex>& list)
  {
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
  }
};

// Which finite edges and facets an update removes and creates: the difference of those of the cells
// that have changed, before and after it. (A simplex of cells that have changed and of others is on
// the boundary of both, so it is in neither.) What a call that has failed has changed belongs to
// the next one.
template <class State>
class Simplex_changes_3
{
public:
  // To be called before a change.
  void begin(State& state)
  {
    if (m_is_open)
      return;
    m_names.assign(state.ids.representatives(),
                   state.ids.representatives() + state.ids.number_of_representatives() + 1);
    m_before.clear();
    m_before.append_flat(state);
    state.arrays.history().begin();
    m_is_open = true;
  }

  // To be called after it. If it throws, it can be called again.
  void end(State& state)
  {
    state.arrays.history().finish();
    state.arrays.history().for_each_former([this](const Vertices_3& v) { append_former(v); });
    m_now.clear();
    if (state.arrays.history().are_given_up())
      append_all(state, m_now);
    else
      append_changed(state);
    compare();
    state.arrays.history().end();
    m_is_open = false;
  }

  // Compares a state that goes, whose `changes` may be those of a call that has failed, with
  // another one.
  void compare(State& before, const Simplex_changes_3& changes, const State& now)
  {
    m_before.clear();
    if (changes.m_is_open) {
      m_before = changes.m_before; // flat ones
      m_names = changes.m_names;
      before.arrays.history().finish();
      before.arrays.for_each_former_of_all([this](const Vertices_3& v) { append_former(v); });
    } else {
      append_all(before, m_before);
    }
    m_now.clear();
    append_all(now, m_now);
    compare();
  }

  const Simplices_3& removed() const { return m_removed; }
  const Simplices_3& created() const { return m_created; }

private:
  void append_former(const Vertices_3& vertices)
  {
    m_before.append_cell(vertices, [this](Vertex_index v) { return m_names[v]; });
  }

  static void append_cell(const State& state, Cell_index c, Simplices_3& simplices)
  {
    simplices.append_cell(state.arrays.vertices(c),
                          [&state](Vertex_index v) { return state.ids.representative(v); });
  }

  void append_changed(State& state)
  {
    state.arrays.history().for_each_changed([&](Cell_index c) {
      if (c < state.arrays.number_of_cells())
        append_cell(state, c, m_now);
    });
  }

  static void append_all(const State& state, Simplices_3& simplices)
  {
    simplices.append_flat(state);
    for (Cell_index c(0); state.spans_space && c < state.arrays.number_of_cells(); ++c)
      append_cell(state, c, simplices);
  }

  void compare()
  {
    m_before.make_distinct();
    m_now.make_distinct();
    m_removed.assign_difference(m_before, m_now);
    m_created.assign_difference(m_now, m_before);
  }

  bool m_is_open = false;
  Column<Vertex_index, Point_id> m_names; // representatives when it began
  Simplices_3 m_before, m_now, m_removed, m_created;
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_3::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_UPDATE_SIMPLEX_CHANGES_3_H

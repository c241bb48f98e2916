// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_SPACE_SITE_NAMES_3_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_SPACE_SITE_NAMES_3_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/passes/Elements_3.h>

#include <array>
#include <cstddef>

namespace CGAL::Dynamic_Delaunay_triangulations_3::internal {

// What visitors call the sites of a state, which may change with a call: ids of representatives.
template <class State>
class Site_names_3
{
public:
  using Name = std::size_t;

  static bool is_infinite(Vertex_index v) { return v == infinite_index; }
  template <class Simplex>
  static void normalize(Simplex&)
  {
  }

  // Remembers the names that there are now.
  void begin(State& state)
  {
    m_names.assign(state.ids.representatives(),
                   state.ids.representatives() + state.ids.number_of_representatives() + 1);
  }
  static void end(State&) {}
  // Lets the second state tell what has become of names of the first.
  static void hand_over(State&, State&) {}
  // What was the name, as it would be now.
  Name former(const State&, Vertex_index v) const { return m_names[v]; }
  static Name present(const State& state, Vertex_index v) { return state.ids.representative(v); }

  // Calls f(i, j), or f(ids of a facet).
  template <class Function>
  static void apply(const std::array<Name, 2>& edge, const Function& f)
  {
    f(edge[0], edge[1]);
  }
  template <class Function>
  static void apply(const std::array<Name, 3>& facet, const Function& f)
  {
    f(facet);
  }
  // Tells a visitor how names have changed: not at all.
  template <class Visitor, class Dynamic>
  static void tell(const State&, Visitor&, const Dynamic&)
  {
  }

  // Those that there are without cells.
  template <class Simplices>
  static void append_flat(const State& state, Simplices& simplices)
  {
    const auto name = [&state](Vertex_index v) { return present(state, v); };
    for (const auto& edge : state.flat_edges)
      simplices.append_edge(edge, name);
    for (const auto& triangle : state.flat_triangles)
      simplices.append_facet(triangle, name);
  }

private:
  Column<Vertex_index, Point_id> m_names;
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_3::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_SPACE_SITE_NAMES_3_H

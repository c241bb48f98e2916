// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Not one of the statements below must compile: only the editor and the builder write
// topology, and only the input frame and these two write positions.

#include <CGAL/Dynamic_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

namespace internal = CGAL::Dynamic_Delaunay_triangulations_2::internal;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Tds = CGAL::Indexed_triangulation_data_structure_2<Kernel>;
struct Silent_calls
{
  static constexpr bool is_heard = false;
};
using State = internal::Triangulation_state_2<Kernel, Tds, Silent_calls, CGAL::Sequential_tag>;
using Positions = State::Positions;
using Topology = State::Topology;

// Refused even though all these objects are non-const.
void write(State& state, Topology& topology, Positions& positions,
           internal::Halfedge_arrays_2& arrays)
{
  state.m_topology;
  topology.m_triangulation.tds().create_vertex();
  topology.m_storage.set_face(0, 0);
  topology.m_ids.reset(0);
  topology.m_changes.new_edges.clear();
  internal::Input_frame_2<State>::Key();
  arrays.flip(0);
  positions.set(1, Kernel::Point_2(0, 0));
  state.triangulation().tds().create_vertex();
}

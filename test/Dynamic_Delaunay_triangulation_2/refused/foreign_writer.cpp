// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Not one of the statements below must compile: classifiers, repairs, tools and queries have a
// constant state, and that has no writer. Only the editor, the builder and the input write.

#include <CGAL/Dynamic_Delaunay_triangulation_2.h>
#include <CGAL/Dynamic_periodic_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <type_traits>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Plane = CGAL::Dynamic_Delaunay_triangulation_2<Kernel>;
using Torus = CGAL::Dynamic_periodic_Delaunay_triangulation_2<Kernel>;

template <class Frame>
void write(const Frame& frame)
{
  const auto& state = frame.state();
  using State = std::decay_t<decltype(state)>;
  static_assert(std::is_constructible_v<typename State::Writer, const State&>,
                "a constant state has no writer");
  state.m_ids;
  state.m_changes;
  state.m_visitor_calls;
  state.m_positions;
  state.arrays().flip(0);
  state.ids().reset(0);
}

void write(const Plane& plane, const Torus& torus)
{
  write(plane.frame());
  write(torus.frame());
  plane.frame().state().m_triangulation;
  plane.frame().state().m_storage;
  plane.triangulation().tds().create_vertex();
  plane.tds().m_storage;
  torus.frame().state().m_arrays;
  torus.frame().state().m_shifts;
}

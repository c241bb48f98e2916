// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_UPDATE_REPAIR_TOOLS_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_UPDATE_REPAIR_TOOLS_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/update/Flip_tool_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/update/Hold_tool_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/update/Population_tool_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/update/Splice_tool_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/update/Update_context_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/policies/Static_engine_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/views/Dynamic_classification_2.h>

#include <type_traits>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

// Only spaces without splices include this tool.
template <class State>
class Reinsertion_tool_2;

// The tools of an update, in every space, over one context. `Dynamic_mender_2` offers some of them
// to a repair.
template <class State>
struct Repair_tools_2
{
  using Classification = Dynamic_classification_2<State>;
  // Border splices, or what stands for them where no region can be triangulated apart.
  using Region_tool =
      std::conditional_t<State::can_splice, Splice_tool_2<State>, Reinsertion_tool_2<State>>;

  explicit Repair_tools_2(State& state)
    : context(state)
    , flips(context)
    , holds(context, flips)
    , regions(context, flips)
    , population(context, flips)
  {
  }

  void set_engines(const Static_engines_2& static_engines)
  {
    engines = static_engines;
    context.builder.set_engine(engines.whole);
    regions.set_engine(engines.region);
  }

  Update_context_2<State> context;
  Flip_tool_2<State> flips;
  Hold_tool_2<State> holds;
  Region_tool regions;
  Population_tool_2<State> population;
  Static_engines_2 engines;
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_UPDATE_REPAIR_TOOLS_2_H

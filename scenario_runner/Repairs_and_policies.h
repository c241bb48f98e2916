// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SCENARIO_RUNNER_REPAIRS_AND_POLICIES_H
#define SCENARIO_RUNNER_REPAIRS_AND_POLICIES_H

#include "scenario_runner/Method_choice.h"

#include <CGAL/Dynamic_Delaunay_triangulation_2/policies/Always_dynamic_policy_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/policies/Always_static_policy_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/policies/Chosen_policy_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/policies/Hybrid_policy_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/policies/Key_frame_policy_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/policies/Static_engine_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/repairs/Border_splice_repair_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/repairs/Chosen_repair_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/repairs/Flip_repair_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/repairs/Hold_and_flip_repair_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/repairs/Rebuild_repair_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/repairs/Relocation_repair_2.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace run {

using Any_repair =
    CGAL::Chosen_repair_2<CGAL::Hold_and_flip_repair_2, CGAL::Border_splice_repair_2,
                          CGAL::Flip_repair_2, CGAL::Relocation_repair_2, CGAL::Rebuild_repair_2>;

Any_repair make_repair(const std::string& name, unsigned padding);

using Any_policy =
    CGAL::Chosen_policy_2<CGAL::Always_dynamic_policy_2, CGAL::Always_static_policy_2,
                          CGAL::Hybrid_policy_2, CGAL::Key_frame_policy_2>;

Any_policy make_policy(const Policy_choice& choice);

// What triangulates anew, the default first.
const std::vector<std::pair<std::string, CGAL::Static_engine_2>>& engines();

// Triangulates both the whole and regions.
CGAL::Static_engines_2 engines_named(const std::string& name);

} // namespace run

#endif // SCENARIO_RUNNER_REPAIRS_AND_POLICIES_H

// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SCENARIO_RUNNER_SPACE_POLICY_3_H
#define SCENARIO_RUNNER_SPACE_POLICY_3_H

#include "scenario_runner/Method_choice.h"

#include <CGAL/Dynamic_Delaunay_triangulation_2/policies/Always_dynamic_policy_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/policies/Always_static_policy_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/policies/Chosen_policy_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/policies/Key_frame_policy_2.h>

namespace run {

using Any_policy_3 = CGAL::Chosen_policy_2<CGAL::Always_dynamic_policy_2,
                                           CGAL::Always_static_policy_2, CGAL::Key_frame_policy_2>;

// \throws std::invalid_argument for a policy that is for the plane alone
Any_policy_3 make_policy_3(const Policy_choice& choice);

} // namespace run

#endif // SCENARIO_RUNNER_SPACE_POLICY_3_H

// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "scenario_runner/space/Policy_3.h"

#include <stdexcept>

namespace run {

Any_policy_3 make_policy_3(const Policy_choice& choice)
{
  if (choice.name == "always_static") {
    return Any_policy_3(CGAL::Always_static_policy_2());
  }
  if (choice.name == "key_frames") {
    return Any_policy_3(CGAL::Key_frame_policy_2(*choice.parameter));
  }
  if (choice.name != "always_dynamic") {
    throw std::invalid_argument("--policy " + choice.name +
                                ": is for the plane, and the motion is in space");
  }
  return Any_policy_3();
}

} // namespace run

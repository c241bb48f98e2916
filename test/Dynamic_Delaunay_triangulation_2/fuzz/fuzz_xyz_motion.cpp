// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "parser_checks.h"
#include "scenario_runner/Recorded_motion.h"

#include <string>
#include <utility>

void fuzz::examine(const std::string& input)
{
  auto recording = parsed_or_refused(input, scenario::parse_xyz);
  if (recording) {
    require_sound(std::move(*recording));
  }
}

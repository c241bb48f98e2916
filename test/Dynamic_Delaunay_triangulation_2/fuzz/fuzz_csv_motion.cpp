// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "parser_checks.h"
#include "scenario_runner/Recorded_motion.h"

#include <string>

void fuzz::examine(const std::string& input)
{
  examine_recording(input, [](const std::string& file, const std::string& text) {
    return scenario::parse_csv(file, text);
  });
}

// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SCENARIO_RUNNER_JSON_TEXT_H
#define SCENARIO_RUNNER_JSON_TEXT_H

#include <nlohmann/json.hpp>

#include <string>

namespace scenario {

// A text as JSON. A key that is twice in one object is refused, and so is deep nesting.
// \throws Scenario_error, with line and column where there is one; `file` is what it calls the text
nlohmann::json parse_json(const std::string& file, const std::string& text);

} // namespace scenario

#endif // SCENARIO_RUNNER_JSON_TEXT_H

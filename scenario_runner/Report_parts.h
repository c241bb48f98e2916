// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SCENARIO_RUNNER_REPORT_PARTS_H
#define SCENARIO_RUNNER_REPORT_PARTS_H

#include "scenario_runner/Frames_summary.h"
#include "scenario_runner/Table.h"

#include <nlohmann/json.hpp>

#include <optional>
#include <string>

namespace run {

// What reports of runs in the plane and in space have in common.

using Json = nlohmann::ordered_json;

template <class Value>
Json json_of(const std::optional<Value>& value)
{
  return value ? Json(*value) : Json(nullptr);
}

void add_rebuilds(Json& json, const Frames_summary& summary);
void add_comparison(Json& json, const Frames_summary& summary);

std::string certified_text(const Frames_summary& summary);
std::string rebuild_text(const Frames_summary& summary);
void add_comparison(Table& table, const Frames_summary& summary);

} // namespace run

#endif // SCENARIO_RUNNER_REPORT_PARTS_H

// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SCENARIO_SCENARIO_DIRECTORY_H
#define SCENARIO_SCENARIO_DIRECTORY_H

#include <filesystem>
#include <string>

namespace scenario {

// Of a scenario that comes with the package.
inline std::string scenario_file(const std::string& name)
{
  return (std::filesystem::path(SCENARIOS_DIR) / (name + ".json")).string();
}

} // namespace scenario

#endif // SCENARIO_SCENARIO_DIRECTORY_H

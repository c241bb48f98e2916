// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef RUN_SCENARIO_CHOICE_H
#define RUN_SCENARIO_CHOICE_H

#include "../scenario/Json_object_reader.h"
#include "../scenario/Motion_file.h"
#include "../scenario/Scenario_description.h"
#include "../scenario/Scenario_directory.h"
#include "../scenario/Scenario_file.h"
#include "../scenario/Scenario_scaling.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <system_error>
#include <variant>
#include <vector>

namespace run {

inline std::vector<std::string> scenario_names()
{
  std::vector<std::string> names;
  std::error_code ignored;
  for (const auto& file : std::filesystem::directory_iterator(SCENARIOS_DIR, ignored)) {
    if (file.path().extension() == ".json") {
      names.push_back(file.path().stem().string());
    }
  }
  std::sort(names.begin(), names.end());
  return names;
}

// The file that a person means who names a scenario or a file.
inline std::string scenario_path(const std::string& name)
{
  if (scenario::is_standard_input(name)) {
    return name;
  }
  std::error_code ignored;
  if (std::filesystem::exists(name, ignored) && !std::filesystem::is_directory(name, ignored)) {
    return name;
  }
  const auto names = scenario_names();
  if (std::find(names.begin(), names.end(), name) != names.end()) {
    return scenario::scenario_file(name);
  }
  throw std::runtime_error("there is no scenario and no file '" + name + "'; scenarios are " +
                           scenario::joined(names) + ", files end in " +
                           scenario::motion_extensions + ", also followed by .gz");
}

// What a scenario file says and its motion does not; a recording says nothing of it.
struct Scenario_facts
{
  std::optional<std::uint64_t> seed{};
  std::optional<scenario::Packing> packing{};
  std::optional<scenario::Box> box{};
};

inline Scenario_facts scenario_facts(const std::string& path,
                                     const std::optional<std::size_t>& points)
{
  if (scenario::motion_format(path) != scenario::Motion_format::scenario) {
    return {};
  }
  const scenario::Scenario_description description = scenario::read_scenario_file(path);
  if (const auto* particles = std::get_if<scenario::Particle_description>(&description.kind)) {
    const scenario::Scaled_scenario scaled =
        scenario::scaled_to(*particles, points.value_or(particles->number_of_points()));
    return {description.seed, particles->packing, scaled.box};
  }
  return {description.seed, std::nullopt,
          std::get<scenario::Brownian_description>(description.kind).box};
}

} // namespace run

#endif // RUN_SCENARIO_CHOICE_H

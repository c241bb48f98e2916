// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "scenario_runner/Open_motion.h"

#include "scenario_runner/Number_text.h"
#include "scenario_runner/space/Scenario_file_3.h"
#include "scenario_runner/space/Simulated_motion_3.h"
#include "scenario_runner/Text_input.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <stdexcept>
#include <system_error>
#include <utility>
#include <variant>

namespace scenario {

namespace {

bool is_scenario_file(const std::string& path)
{
  return lower_case(without_gz(path).extension().string()) == ".json";
}

// The name of a recording, after its file.
std::string recording_name(const std::string& path)
{
  return is_standard_input(path) ? "standard_input" : without_gz(path).stem().string();
}

std::string name_in_messages(const std::string& path)
{
  return is_standard_input(path) ? "standard input" : path;
}

std::unique_ptr<Motion> open_in_plane(const std::string& path, Recording recording)
{
  check_in_plane(name_in_messages(path), recording);
  return std::make_unique<Recorded_motion>(recording_name(path), std::move(recording));
}

// A .txt file in a directory of recordings is more likely a description than a recording.
bool is_recording(const std::filesystem::path& file)
{
  return format_by_name(file.string()) && without_gz(file).extension() != ".txt";
}

void check_overrides(const std::string& path, const Overrides& overrides)
{
  if (overrides.points && (*overrides.points < 1 || *overrides.points > max_points)) {
    throw Scenario_error(path, "cannot be scaled to " + std::to_string(*overrides.points) +
                                   " points, allowed are 1 to " + std::to_string(max_points));
  }
  if (overrides.time_step && !positive_up_to(largest_time_step).contains(*overrides.time_step)) {
    throw Scenario_error(path,
                         "cannot run with time step " + run::number_text(*overrides.time_step, 6) +
                             ", allowed are values " + positive_up_to(largest_time_step).text());
  }
}

bool is_scenario_file_in_space(const std::string& path)
{
  return is_scenario_file(path) && is_scenario_in_space(path, read_text_file(path));
}

std::unique_ptr<Motion> open_scenario(const std::string& path, const Overrides& overrides)
{
  if (is_scenario_file_in_space(path)) {
    throw Scenario_error(path, "is in space, and is to be in the plane here");
  }
  const Scenario_description description = read_scenario_file(path);
  check_overrides(path, overrides);
  if (const auto* particles = std::get_if<Particle_description>(&description.kind)) {
    return make_motion(description, *particles, overrides);
  }
  if (overrides.packing) {
    throw Scenario_error(path, "has no packing that could be chosen, it is a random cloud");
  }
  return make_motion(description, std::get<Brownian_description>(description.kind), overrides);
}

std::unique_ptr<Motion_3> open_scenario_3(const std::string& path, const Overrides& overrides)
{
  const Scenario_description_3 description = parse_scenario_3(path, read_text_file(path));
  check_overrides(path, overrides);
  if (overrides.packing) {
    throw Scenario_error(path, "is in space, where no packing can be chosen");
  }
  const std::uint64_t seed = overrides.seed.value_or(description.seed);
  if (const auto* brownian = std::get_if<Brownian_description_3>(&description.kind)) {
    Brownian_description_3 changed = *brownian;
    changed.points = overrides.points.value_or(changed.points);
    changed.time_step = overrides.time_step.value_or(changed.time_step);
    return std::make_unique<Brownian_motion_3>(description, changed, seed);
  }
  Particle_description_3 particles = std::get<Particle_description_3>(description.kind);
  const std::size_t points = overrides.points.value_or(particles.number_of_points());
  particles = scaled_to(particles, points);
  particles.time_step = overrides.time_step.value_or(particles.time_step);
  return std::make_unique<Particle_motion_3>(description, particles, points, seed);
}

void check_dimension(const std::string& path, int dimension, const std::optional<int>& wanted)
{
  if (wanted.value_or(dimension) != dimension) {
    throw Scenario_error(path, std::string("is a scenario in ") +
                                   (dimension == 3 ? "space" : "the plane") +
                                   ": its dimension cannot be chosen");
  }
}

// The names of the scenario files in a directory.
std::vector<std::string> scenarios_in(const std::filesystem::path& directory)
{
  std::vector<std::string> names;
  std::error_code ignored;
  for (const auto& file : std::filesystem::directory_iterator(directory, ignored)) {
    if (file.path().extension() == ".json") {
      names.push_back(file.path().stem().string());
    }
  }
  std::sort(names.begin(), names.end());
  return names;
}

const std::filesystem::path& space_folder()
{
  static const std::filesystem::path folder = std::filesystem::path(SCENARIOS_DIR) / "space";
  return folder;
}

// A file need not have a known extension, but if it is not even there, its name may be the mistake.
void check_name(const std::string& path)
{
  std::error_code ignored;
  if (!is_standard_input(path) && !format_by_name(path) &&
      !std::filesystem::exists(path, ignored)) {
    throw Scenario_error(path, "is not there, and has the unknown extension " +
                                   in_quotes(without_gz(path).extension().string()) +
                                   ", allowed are " + motion_extensions + ", also followed by .gz");
  }
}

void refuse_overrides(const std::string& path, const Overrides& overrides)
{
  if (overrides.points || overrides.time_step || overrides.seed || overrides.packing) {
    throw Scenario_error(path, "is a recording: its number of points, time step, seed and packing "
                               "cannot be chosen");
  }
}

} // namespace

std::unique_ptr<Particle_motion> make_motion(const Scenario_description& description,
                                             Particle_description particles,
                                             const Overrides& overrides)
{
  particles.packing = overrides.packing.value_or(particles.packing);
  particles.time_step = overrides.time_step.value_or(particles.time_step);
  return std::make_unique<Particle_motion>(
      description.name, particles, overrides.seed.value_or(description.seed), description.frames,
      overrides.points.value_or(particles.number_of_points()));
}

std::unique_ptr<Brownian_motion> make_motion(const Scenario_description& description,
                                             Brownian_description brownian,
                                             const Overrides& overrides)
{
  brownian.points = overrides.points.value_or(brownian.points);
  brownian.time_step = overrides.time_step.value_or(brownian.time_step);
  return std::make_unique<Brownian_motion>(
      description.name, brownian, overrides.seed.value_or(description.seed), description.frames);
}

std::unique_ptr<Motion> open_motion(const std::string& path, const Overrides& overrides,
                                    const Table_columns& columns)
{
  if (!is_scenario_file(path)) {
    check_name(path);
    refuse_overrides(path, overrides);
    return open_in_plane(path, read_recording(path, columns));
  }
  if (!columns.empty()) {
    throw Scenario_error(path, "is no table, so its columns cannot be named");
  }
  return open_scenario(path, overrides);
}

Opened_motion open_any_motion(const std::string& path, const Overrides& overrides,
                              const Table_columns& columns, std::optional<int> dimension)
{
  if (is_scenario_file(path)) {
    const bool is_in_space = is_scenario_file_in_space(path);
    check_dimension(path, is_in_space ? 3 : 2, dimension);
    if (is_in_space && columns.empty()) {
      return {nullptr, open_scenario_3(path, overrides)};
    }
    return {open_motion(path, overrides, columns), nullptr};
  }
  check_name(path);
  refuse_overrides(path, overrides);
  Recording recording = read_recording(path, columns);
  if (dimension ? *dimension == 3 : is_in_space(recording)) {
    return {nullptr, std::make_unique<Recorded_motion_3>(
                         name_in_messages(path), recording_name(path), std::move(recording))};
  }
  return {open_in_plane(path, std::move(recording)), nullptr};
}

Scenario_facts scenario_facts(const std::string& path, const std::optional<std::size_t>& points)
{
  if (!is_scenario_file(path)) {
    return {};
  }
  if (is_scenario_file_in_space(path)) {
    return {parse_scenario_3(path, read_text_file(path)).seed};
  }
  const Scenario_description description = read_scenario_file(path);
  if (const auto* particles = std::get_if<Particle_description>(&description.kind)) {
    const Scaled_scenario scaled =
        scaled_to(*particles, points.value_or(particles->number_of_points()));
    return {description.seed, particles->packing, scaled.box};
  }
  return {description.seed, std::nullopt, std::get<Brownian_description>(description.kind).box};
}

std::vector<std::string> known_scenarios()
{
  return scenarios_in(SCENARIOS_DIR);
}

std::vector<std::string> known_scenarios_3()
{
  return scenarios_in(space_folder());
}

std::string scenario_file(const std::string& name)
{
  return (std::filesystem::path(SCENARIOS_DIR) / (name + ".json")).string();
}

std::string scenario_path(const std::string& name)
{
  if (is_standard_input(name)) {
    return name;
  }
  std::error_code ignored;
  if (std::filesystem::exists(name, ignored) && !std::filesystem::is_directory(name, ignored)) {
    return name;
  }
  const auto names = known_scenarios();
  if (std::find(names.begin(), names.end(), name) != names.end()) {
    return scenario_file(name);
  }
  const auto names_in_space = known_scenarios_3();
  if (std::find(names_in_space.begin(), names_in_space.end(), name) != names_in_space.end()) {
    return (space_folder() / (name + ".json")).string();
  }
  throw std::runtime_error("there is no scenario and no file '" + name + "'; scenarios are " +
                           joined(names) + ", in space " + joined(names_in_space) +
                           ", files end in " + motion_extensions + ", also followed by .gz");
}

std::string recordings_directory()
{
  const char* const variable = std::getenv("RECORDINGS_DIR");
  return variable != nullptr ? variable : RECORDINGS_DIR;
}

std::string no_recordings_message()
{
  return "no recordings in " + recordings_directory() +
         "; set RECORDINGS_DIR to the directory that holds them";
}

bool recordings_are_expected()
{
  return std::getenv("RECORDINGS_DIR") != nullptr ||
         std::filesystem::is_directory(recordings_directory());
}

std::vector<std::string> recordings_in(const std::string& directory)
{
  std::vector<std::string> paths;
  std::error_code ignored;
  for (const auto& file : std::filesystem::directory_iterator(directory, ignored)) {
    if (is_recording(file.path())) {
      paths.push_back(file.path().string());
    }
  }
  std::sort(paths.begin(), paths.end());
  return paths;
}

std::vector<std::string> recordings()
{
  return recordings_in(recordings_directory());
}

} // namespace scenario

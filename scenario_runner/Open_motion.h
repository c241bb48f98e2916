// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SCENARIO_RUNNER_OPEN_MOTION_H
#define SCENARIO_RUNNER_OPEN_MOTION_H

#include "scenario_runner/Motion.h"
#include "scenario_runner/Recorded_motion.h"
#include "scenario_runner/Scenario_file.h"
#include "scenario_runner/Simulated_motion.h"
#include "scenario_runner/space/Motion_3.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace scenario {

inline const std::string motion_extensions = ".json, " + recording_extensions;

// Opens a scenario, whose extension is .json, or any recording, compressed or not; or a recording
// from standard input, as "-". `columns` are those of a table.
std::unique_ptr<Motion> open_motion(const std::string& path, const Overrides& overrides = {},
                                    const Table_columns& columns = {});

// A motion in the plane or one in space: exactly one is there.
struct Opened_motion
{
  std::unique_ptr<Motion> in_plane{};
  std::unique_ptr<Motion_3> in_space{};
};

// Opens what open_motion() opens, or the same in space. Scenarios say in which dimension they are.
// A recording is in space if its points have third coordinates that differ, or if `dimension` is 3,
// and in the plane if that is 2.
Opened_motion open_any_motion(const std::string& path, const Overrides& overrides,
                              const Table_columns& columns, std::optional<int> dimension);

std::unique_ptr<Particle_motion> make_motion(const Scenario_description& description,
                                             Particle_description particles,
                                             const Overrides& overrides);
std::unique_ptr<Brownian_motion> make_motion(const Scenario_description& description,
                                             Brownian_description brownian,
                                             const Overrides& overrides);

// Facts that a scenario file states but its motion does not. A recording has none of them.
struct Scenario_facts
{
  std::optional<std::uint64_t> seed{};
  std::optional<Packing> packing{};
  std::optional<Box> box{};
};
Scenario_facts scenario_facts(const std::string& path, const std::optional<std::size_t>& points);

// The scenarios in the plane that come with the package, those in space, and the file of one in the
// plane.
std::vector<std::string> known_scenarios();
std::vector<std::string> known_scenarios_3();
std::string scenario_file(const std::string& name);

// The file of a scenario that is given by its name or by a file name.
std::string scenario_path(const std::string& name);

// Where recorded motion is, which is no part of the package: in the directory that the environment
// names, or else in that which CMake was told of.
std::string recordings_directory();
std::string no_recordings_message();

// Whether they have to be there: the environment names a directory, or the usual one exists.
bool recordings_are_expected();

// The paths of all recordings in a directory, in the order of their names; none if there is none.
std::vector<std::string> recordings_in(const std::string& directory);
std::vector<std::string> recordings();

} // namespace scenario

#endif // SCENARIO_RUNNER_OPEN_MOTION_H

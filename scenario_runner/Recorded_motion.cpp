// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "scenario_runner/Recorded_motion.h"

#include "scenario_runner/Text_input.h"

#include <algorithm>

namespace scenario {

bool do_numbers_ascend(const Recording& recording)
{
  const auto do_not_ascend = [](const Recorded_frame& a, const Recorded_frame& b) {
    return a.number >= b.number;
  };
  return std::adjacent_find(recording.begin(), recording.end(), do_not_ascend) == recording.end();
}

bool has_fixed_population(const Recording& recording)
{
  return std::all_of(recording.begin(), recording.end(), [&](const Recorded_frame& frame) {
    return frame.ids == recording.front().ids;
  });
}

void check_in_plane(const std::string& file, const Recording& recording)
{
  for (const Recorded_frame& frame : recording) {
    if (frame.flaw_in_plane) {
      throw Scenario_error(file, frame.flaw_in_plane->message, frame.flaw_in_plane->line);
    }
  }
}

bool is_standard_input(const std::string& path)
{
  return path == "-";
}

Recording read_recording(const std::string& path, const Table_columns& columns)
{
  if (is_standard_input(path)) {
    const std::string name = "standard input";
    return parse_recording(name, read_standard_input(name), columns);
  }
  return parse_recording(path, read_text_file(path), columns);
}

Recording read_csv_motion(const std::string& path)
{
  if (is_standard_input(path)) {
    const std::string name = "standard input";
    return parse_csv(name, read_standard_input(name));
  }
  return parse_csv(path, read_text_file(path));
}

Recording read_lammps_dump(const std::string& path)
{
  return parse_lammps_dump(path, read_text_file(path));
}

Recording read_xyz_motion(const std::string& path)
{
  return parse_xyz(path, read_text_file(path));
}

} // namespace scenario

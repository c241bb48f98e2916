// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "scenario_runner/Recorded_motion.h"

#include "scenario_runner/Text_input.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace scenario {

namespace {

bool numbers_ascend(const Recording& recording)
{
  const auto do_not_ascend = [](const Recorded_frame& a, const Recorded_frame& b) {
    return a.number >= b.number;
  };
  return std::adjacent_find(recording.begin(), recording.end(), do_not_ascend) == recording.end();
}

} // namespace

Recorded_motion::Recorded_motion(std::string name, Recording recording)
  : Motion(std::move(name))
  , m_recording(std::move(recording))
  , m_has_numbers(numbers_ascend(m_recording))
{
  if (m_recording.empty()) {
    throw std::invalid_argument("a recorded motion needs at least one frame");
  }
}

bool Recorded_motion::has_fixed_population() const
{
  return std::all_of(m_recording.begin(), m_recording.end(), [this](const Recorded_frame& frame) {
    return frame.ids == m_recording.front().ids;
  });
}

std::optional<std::int64_t> Recorded_motion::frame_number() const
{
  return m_has_numbers ? std::optional(frame().number) : std::nullopt;
}

bool Recorded_motion::advance(const Neighbor_edges&)
{
  if (m_current + 1 == m_recording.size()) {
    return false;
  }
  m_population_changed = m_recording[m_current].ids != m_recording[m_current + 1].ids;
  ++m_current;
  return true;
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

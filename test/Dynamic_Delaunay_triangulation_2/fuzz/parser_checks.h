// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What fuzz targets require of every parser: readable errors, and sound results.

#ifndef DYNAMIC_DELAUNAY_TRIANGULATION_2_TEST_FUZZ_PARSER_CHECKS_H
#define DYNAMIC_DELAUNAY_TRIANGULATION_2_TEST_FUZZ_PARSER_CHECKS_H

#include "fuzz_target.h"
#include "scenario_runner/Motion.h"
#include "scenario_runner/Recorded_motion.h"
#include "scenario_runner/space/Motion_3.h"
#include "scenario_runner/Text_input.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace fuzz {

inline const std::string file_name = "file";

inline bool is_control_character(char byte)
{
  return static_cast<unsigned char>(byte) < 0x20 || byte == 0x7F;
}

// Requires a message that a person can read in a terminal.
inline void require_readable(const scenario::Scenario_error& error, const std::string& input)
{
  const std::string message = error.what();
  const auto lines = 1 + std::count(input.begin(), input.end(), '\n');
  require(message.size() > file_name.size() + 2, "an error says nothing");
  require(message.rfind(file_name, 0) == 0, "an error does not name the file");
  require(message.size() < 500, "an error is drowned in foreign data");
  require(std::none_of(message.begin(), message.end(), is_control_character),
          "an error sends control characters to the terminal");
  require(error.line() <= static_cast<std::size_t>(lines),
          "an error is in a line that is not there");
}

// What `parse` returns; nothing if it refuses the input with a readable error.
template <class Parse>
auto parsed_or_refused(const std::string& input, Parse parse)
    -> std::optional<decltype(parse(file_name, input))>
{
  try {
    return parse(file_name, input);
  } catch (const scenario::Scenario_error& error) {
    require_readable(error, input);
    return std::nullopt;
  }
}

inline void require_sound(const std::vector<std::int64_t>& ids,
                          const std::vector<scenario::Point>& points)
{
  require(ids.size() == points.size(), "there are not as many ids as points");
  require(std::adjacent_find(ids.begin(), ids.end(), std::greater_equal<>()) == ids.end(),
          "ids do not ascend");
  require(std::all_of(points.begin(), points.end(),
                      [](const scenario::Point& point) {
                        return std::isfinite(point.x) && std::isfinite(point.y);
                      }),
          "a coordinate is not finite");
}

inline void require_sound(const scenario::Cell& cell)
{
  for (std::size_t i = 0; i != 2; ++i) {
    const scenario::Point& side = cell.sides[i];
    require(std::isfinite(side.x) && std::isfinite(side.y), "a side of a cell is not finite");
    require(!cell.is_periodic[i] || side.x != 0.0 || side.y != 0.0, "a period is 0");
  }
  require(cell.is_periodic[0] || cell.is_periodic[1], "a cell is not periodic");
  require(cell.is_slab() || cell.area() != 0.0, "a cell is flat");
}

inline void require_sound(const scenario::Recorded_frame& frame)
{
  const auto has_name = [&frame](std::int64_t id) {
    return id >= 0 && static_cast<std::size_t>(id) < frame.names->size();
  };
  require(!frame.names || std::all_of(frame.ids.begin(), frame.ids.end(), has_name),
          "an id has no name, others have");
}

// Whether a check that may throw Scenario_error accepts a recording.
template <class Check>
bool is_accepted(const Check& check)
{
  try {
    check();
    return true;
  } catch (const scenario::Scenario_error&) {
    return false;
  }
}

inline void require_sound_in_space(const scenario::Recording& recording)
{
  scenario::Recorded_motion_3 motion(file_name, "motion", recording);
  do {
    for (const scenario::Point_3& point : motion.points()) {
      require(std::isfinite(point[2]), "a third coordinate is not finite");
    }
    if (const auto cell = motion.cell()) {
      require(cell->repeats_space(), "a cell in space has no volume");
    }
  } while (motion.advance({}));
}

inline void require_sound(scenario::Recording recording)
{
  const std::size_t number_of_frames = recording.size();
  require(number_of_frames != 0, "a recording has no frame");
  for (std::size_t i = 0; i != number_of_frames; ++i) {
    require_sound(recording[i]);
    require(i == 0 || recording[i - 1].number < recording[i].number, "frames do not ascend");
  }
  if (is_accepted([&] { scenario::check_in_space(file_name, recording, "--dimension 2"); })) {
    require_sound_in_space(recording);
  }
  if (!is_accepted([&] { scenario::check_in_plane(file_name, recording); })) {
    return;
  }
  scenario::Recorded_motion motion("motion", std::move(recording));
  std::size_t frames_seen = 0;
  do {
    require_sound(motion.ids(), motion.points());
    require(std::isfinite(motion.time()), "a time is not finite");
    if (motion.cell()) {
      require_sound(*motion.cell());
    }
    ++frames_seen;
  } while (motion.advance({}));
  require(frames_seen == number_of_frames, "frames have been lost");
}

// Requires a sound recording, unless `parse` refuses the input.
template <class Parse>
void examine_recording(const std::string& input, Parse parse)
{
  auto recording = parsed_or_refused(input, parse);
  if (recording) {
    require_sound(std::move(*recording));
  }
}

} // namespace fuzz

#endif // DYNAMIC_DELAUNAY_TRIANGULATION_2_TEST_FUZZ_PARSER_CHECKS_H

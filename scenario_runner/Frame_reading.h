// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SCENARIO_RUNNER_FRAME_READING_H
#define SCENARIO_RUNNER_FRAME_READING_H

#include "scenario_runner/Recorded_motion.h"
#include "scenario_runner/Text_input.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace scenario {

// The points of one frame of a recording, in any order, and the lines that they are in.
class Frame_rows
{
public:
  // Forgets all points, and takes memory for as many as a file can hold that claims `size`.
  void begin(std::size_t size, const Text_scanner& scanner);
  void add(std::int64_t id, const Point& point, std::size_t line);

  std::size_t size() const { return m_rows.size(); }

  // Moves the points into the frame, by ascending ids. `frame_name` is its name in messages.
  // \throws Scenario_error if an id is there twice.
  void sort_into(Recorded_frame& frame, const Text_scanner& scanner, const std::string& frame_name);

private:
  struct Row
  {
    std::int64_t id;
    Point point;
    std::size_t line;
  };

  std::vector<Row> m_rows;
};

// \throws Scenario_error, with the scanner's line, if the text is no integer from 0 on. `what` is
// counted.
std::size_t number_of(const Text_scanner& scanner, std::string_view text, const std::string& what);

// \throws Scenario_error, with the scanner's line, if the text is no finite number.
double finite_number(const Text_scanner& scanner, std::string_view text, std::string_view what);

// The cell that a box makes; none if no side is periodic.
// \throws Scenario_error, with the scanner's line, if space cannot be repeated by it.
std::optional<Cell> cell_of_box(const Text_scanner& scanner, const Cell& box);

// \throws Scenario_error, with the scanner's line, if the cell is of another kind than that of the
// frame before: the whole recording is periodic in both directions, or in one, or in none.
void check_kind(const Text_scanner& scanner, const std::optional<Cell>& cell,
                const Recording& frames_before);

} // namespace scenario

#endif // SCENARIO_RUNNER_FRAME_READING_H

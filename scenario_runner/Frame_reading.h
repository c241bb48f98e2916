// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SCENARIO_RUNNER_FRAME_READING_H
#define SCENARIO_RUNNER_FRAME_READING_H

#include "scenario_runner/Recorded_motion.h"
#include "scenario_runner/Text_input.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace scenario {

// Ids for points that have names: 0, 1, 2 and so on, in the order in which the names first appear.
class Point_names
{
public:
  std::int64_t id(std::string_view name);
  const std::string& name(std::int64_t id) const { return *m_names[static_cast<std::size_t>(id)]; }
  std::shared_ptr<const Point_name_list> list() const;

private:
  std::unordered_map<std::string, std::int64_t> m_ids;
  std::vector<const std::string*> m_names;
};

// Gives the names to all frames, where ids stand for names.
void set_names(Recording& frames, const Point_names& names);

// The points of one frame of a recording, in any order, and the lines that they are in.
class Frame_rows
{
public:
  // Forgets all points, and takes memory for as many as a file can hold that claims `size`.
  void begin(std::size_t size, const Text_scanner& scanner);
  // `height`: its third coordinate.
  void add(std::int64_t id, const Point& point, double height, std::size_t line);

  std::size_t size() const { return m_rows.size(); }

  // Moves the points into the frame, by ascending ids. `frame_name` is its name in messages.
  // \throws Scenario_error if an id is there twice.
  void sort_into(Recorded_frame& frame, const Text_scanner& scanner, const std::string& frame_name);

private:
  struct Row
  {
    std::int64_t id;
    Point point;
    double height;
    std::size_t line;
  };

  std::vector<Row> m_rows;
};

// The points of all frames of a recording, in any order.
class Recording_rows
{
public:
  struct Row
  {
    std::int64_t frame;
    std::int64_t id;
    double time;
    Point point;
    double height; // its third coordinate
    std::size_t line;
  };

  bool empty() const { return m_rows.empty(); }
  void add(const Row& row) { m_rows.push_back(row); }

  template <class Renamed>
  void rename(const Renamed& renamed)
  {
    for (Row& row : m_rows) {
      row.id = renamed(row.id);
    }
  }

  // The points of one time become a frame: 0, 1, 2 and so on.
  void number_frames_by_time();

  // The frames in the order of their numbers. Forgets all rows.
  // \throws Scenario_error if an id is twice in a frame; `id_text` is how the message calls it.
  Recording recording(const Text_scanner& scanner,
                      const std::function<std::string(std::int64_t)>& id_text);

private:
  void check_ids(const Text_scanner& scanner,
                 const std::function<std::string(std::int64_t)>& id_text) const;

  std::vector<Row> m_rows;
};

// \throws Scenario_error, with the scanner's line, if the text is no integer from 0 on. `what` is
// counted.
std::size_t number_of(const Text_scanner& scanner, std::string_view text, const std::string& what);

// The third coordinate that a text stands for; NaN if it is no finite number, as what a motion in
// the plane has there does not matter.
double height_in(std::string_view text);

// \throws Scenario_error, with the scanner's line, if the text is no finite number.
double finite_number(const Text_scanner& scanner, std::string_view text, std::string_view what);

// \throws Scenario_error if the number is not above that of the frame before. `what` is numbered.
void check_ascends(const Text_scanner& scanner, const std::string& what, std::int64_t number,
                   std::size_t line, const Recording& frames_before);

// Gives the frame its box, and the cell that this makes in the plane; none if no side is periodic.
// If the box has a volume, and its section has no area, the frame has a flaw in the plane.
// \throws Scenario_error, with the scanner's line, if neither the plane nor space can be repeated
// by the box.
void set_box(Recorded_frame& frame, const Text_scanner& scanner, const Cell_3& box);

// \throws Scenario_error, with the scanner's line, if the cell is of another kind than that of the
// frame before: the whole recording is periodic in both directions, or in one, or in none.
void check_kind(const Text_scanner& scanner, const std::optional<Cell>& cell,
                const Recording& frames_before);

} // namespace scenario

#endif // SCENARIO_RUNNER_FRAME_READING_H

// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "scenario_runner/Frame_reading.h"
#include "scenario_runner/Recorded_motion.h"
#include "scenario_runner/Text_input.h"
#include "scenario_runner/Xyz_comment.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace scenario {

namespace {

class Xyz_parser
{
public:
  Xyz_parser(const std::string& file, std::string_view text)
    : m_scanner(file, text)
  {
  }

  Recording parse()
  {
    Recording frames;
    std::string_view line;
    while (m_scanner.next_line(line)) {
      read_frame(line, frames);
    }
    if (frames.empty()) {
      throw Scenario_error(m_scanner.file(), "is empty, expected a number of points");
    }
    if (m_ids_are_text) {
      set_names(frames, m_names);
    }
    return frames;
  }

private:
  struct Columns
  {
    std::size_t count = 0;
    bool are_all = false;     // no others may follow
    bool ends_with_z = false; // which rows of plane motion may leave out
    std::optional<std::size_t> id{};
    bool ids_are_text = false;
    std::optional<std::size_t> position{}; // of x, before y
    bool has_z = false;                    // after y
  };

  void read_frame(std::string_view first_line, Recording& frames)
  {
    const std::size_t size = number_of(m_scanner, first_line, "points");
    std::string_view line;
    if (!m_scanner.next_line_as_it_is(line)) {
      m_scanner.fail("the file ends in the head of a frame");
    }
    const Xyz_comment comment(m_scanner, line);
    Recorded_frame frame;
    frame.number = number(comment, frames);
    frame.time = comment.has("time") ? comment.number("time") : static_cast<double>(frame.number);
    set_box(frame, m_scanner, box(comment));
    check_kind(m_scanner, frame.cell, frames);
    const Columns columns = read_columns(comment);
    if (!frames.empty() && columns.ids_are_text != m_ids_are_text) {
      m_scanner.fail("the ids of some frames are text, those of others are numbers");
    }
    m_ids_are_text = columns.ids_are_text;
    read_points(size, columns);
    m_rows.sort_into(frame, m_scanner, "frame " + std::to_string(frame.number));
    frames.push_back(std::move(frame));
  }

  // Either all frames are numbered, or none is.
  std::int64_t number(const Xyz_comment& comment, const Recording& frames)
  {
    if (frames.empty()) {
      m_has_numbers = comment.has("frame");
    }
    if (comment.has("frame") != m_has_numbers) {
      m_scanner.fail(m_has_numbers ? "the frame has no Frame=, those before it have"
                                   : "the frame has a Frame=, those before it have none");
    }
    if (!m_has_numbers) {
      return static_cast<std::int64_t>(frames.size());
    }
    const std::int64_t number = comment.integer("frame");
    check_ascends(m_scanner, "Frame", number, m_scanner.line_number(), frames);
    return number;
  }

  Cell_3 box(const Xyz_comment& comment) const
  {
    Cell_3 box{{}, {}, periodic_sides(comment)};
    if (!comment.has("lattice")) {
      if (box.is_periodic[0] || box.is_periodic[1]) {
        m_scanner.fail("the frame is periodic by its pbc, but has no Lattice");
      }
      return box;
    }
    const std::vector<double> numbers = comment.matrix("lattice");
    for (std::size_t i = 0; i != numbers.size(); ++i) {
      box.sides[i / 3][i % 3] = numbers[i];
    }
    if (comment.has("origin")) {
      const std::vector<double> origin = comment.numbers("origin", 3);
      box.corner = {origin[0], origin[1], origin[2]};
    }
    return box;
  }

  // A lattice without pbc is periodic.
  static std::array<bool, 3> periodic_sides(const Xyz_comment& comment)
  {
    if (!comment.has("pbc")) {
      const bool are = comment.has("lattice");
      return {are, are, are};
    }
    const std::vector<bool> sides = comment.truths("pbc", 3);
    return {sides[0], sides[1], sides[2]};
  }

  // The columns by a text of the form name:type:number:name:type:number...
  Columns read_columns(const Xyz_comment& comment) const
  {
    const bool has_properties = comment.has("properties");
    const std::string properties =
        has_properties ? comment.text("properties") : "species:S:1:pos:R:3";
    std::vector<std::string_view> words;
    split_at(':', properties, words);
    if (words.size() % 3 != 0) {
      m_scanner.fail("Properties are not triples of a name, a type and a number of columns");
    }
    Columns columns;
    columns.are_all = has_properties;
    for (std::size_t i = 0; i != words.size(); i += 3) {
      add_property(columns, words[i], words[i + 1], number_of_columns(words[i], words[i + 2]));
    }
    if (!columns.position) {
      m_scanner.fail("Properties have no positions, expected pos:R:3");
    }
    return columns;
  }

  std::size_t number_of_columns(std::string_view property, std::string_view text) const
  {
    constexpr std::int64_t most_columns = 10'000;
    const std::int64_t number = m_scanner.integer(text, "number of columns");
    if (number < 1 || number > most_columns) {
      m_scanner.fail("property " + in_quotes(property) + " has " + std::to_string(number) +
                     " columns, allowed are 1 to " + std::to_string(most_columns));
    }
    return static_cast<std::size_t>(number);
  }

  void add_property(Columns& columns, std::string_view property, std::string_view type,
                    std::size_t number) const
  {
    const std::string name = lower_case(std::string(property));
    if (name == "id") {
      check_property(property, type, "IRS", !columns.id && number == 1, "one column");
      columns.id = columns.count;
      columns.ids_are_text = type == "S";
    } else if (name == "pos") {
      check_property(property, type, "IR", !columns.position && number >= 2,
                     "two or three columns");
      columns.position = columns.count;
      columns.has_z = number >= 3;
    } else {
      check_property(property, type, "IRLS", true, "");
    }
    columns.count += number;
    columns.ends_with_z = name == "pos" && number == 3;
  }

  void check_property(std::string_view property, std::string_view type, std::string_view types,
                      bool is_right, const char* wanted) const
  {
    if (type.size() != 1 || types.find(type) == types.npos) {
      m_scanner.fail("property " + in_quotes(property) + " has the type " + in_quotes(type) +
                     ", allowed is one of " + std::string(types));
    }
    if (!is_right) {
      m_scanner.fail("property " + in_quotes(property) + " has to be there once, with " + wanted);
    }
  }

  void read_points(std::size_t size, Columns columns)
  {
    m_rows.begin(size, m_scanner);
    for (std::size_t i = 0; i != size; ++i) {
      std::string_view line;
      if (!m_scanner.next_line(line)) {
        m_scanner.fail("the last frame is truncated: " + std::to_string(size) +
                       " points expected, " + std::to_string(i) + " found");
      }
      split_at_blanks(line, m_fields);
      if (i == 0 && columns.ends_with_z && m_fields.size() + 1 == columns.count) {
        --columns.count; // in this row, so in all of the frame
        columns.are_all = true;
        columns.has_z = false;
      }
      check_fields(columns);
      const std::int64_t id = point_id(columns, i);
      const std::string name =
          columns.ids_are_text ? in_quotes(m_fields[*columns.id]) : std::to_string(id);
      m_rows.add(
          id,
          {coordinate(*columns.position, "x", name), coordinate(*columns.position + 1, "y", name)},
          columns.has_z ? height(m_fields[*columns.position + 2]) : 0.0, m_scanner.line_number());
    }
  }

  void check_fields(const Columns& columns) const
  {
    if (m_fields.size() < columns.count || (columns.are_all && m_fields.size() > columns.count)) {
      m_scanner.fail("the point has " + std::to_string(m_fields.size()) + " fields, " +
                     std::to_string(columns.count) + " columns are named");
    }
  }

  std::int64_t point_id(const Columns& columns, std::size_t place)
  {
    if (!columns.id) {
      return static_cast<std::int64_t>(place);
    }
    const std::string_view text = m_fields[*columns.id];
    if (columns.ids_are_text) {
      return m_names.id(text);
    }
    const auto number = m_scanner.whole_number(text, "id");
    if (!number) {
      m_scanner.fail("id " + in_quotes(text) + " is not an integer");
    }
    return *number;
  }

  double coordinate(std::size_t column, std::string_view name, const std::string& id) const
  {
    const std::string_view text = m_fields[column];
    return may_be_of_fortran(text) ? m_scanner.coordinate(with_usual_exponent(text), name, id)
                                   : m_scanner.coordinate(text, name, id);
  }

  static double height(std::string_view text)
  {
    return may_be_of_fortran(text) ? height_in(with_usual_exponent(text)) : height_in(text);
  }

  Text_scanner m_scanner;
  std::vector<std::string_view> m_fields;
  Frame_rows m_rows;
  Point_names m_names;
  bool m_ids_are_text = false;
  bool m_has_numbers = false;
};

} // namespace

Recording parse_xyz(const std::string& file, std::string_view text)
{
  return Xyz_parser(file, text).parse();
}

} // namespace scenario

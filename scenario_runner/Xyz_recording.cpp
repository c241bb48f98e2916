// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "scenario_runner/Frame_reading.h"
#include "scenario_runner/Recorded_motion.h"
#include "scenario_runner/Text_input.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace scenario {

namespace {

// The values in the second line of a frame, by their keys in lower case. Text that is no key=value
// is a comment.
class Xyz_comment
{
public:
  Xyz_comment(const Text_scanner& scanner, std::string_view line)
    : m_scanner(scanner)
  {
    while (!(line = trimmed(line)).empty()) {
      const std::size_t end = end_of_name(line);
      const std::string name = lower_case(std::string(line.substr(0, end)));
      line.remove_prefix(end);
      if (!line.empty() && line.front() == '=') {
        line.remove_prefix(1);
        m_values.insert_or_assign(name, take_value(line));
      }
    }
  }

  std::optional<std::string_view> value(const std::string& key) const
  {
    const auto found = m_values.find(key);
    return found == m_values.end() ? std::nullopt : std::optional(found->second);
  }

  // The numbers in the value of a key.
  std::vector<double> numbers(const std::string& key, std::size_t size) const
  {
    std::vector<std::string_view> fields;
    split_at_blanks(*value(key), fields);
    if (fields.size() != size) {
      m_scanner.fail(key + " has " + std::to_string(fields.size()) + " numbers instead of " +
                     std::to_string(size));
    }
    std::vector<double> numbers;
    for (const std::string_view field : fields) {
      numbers.push_back(finite_number(m_scanner, field, key));
    }
    return numbers;
  }

private:
  static std::size_t end_of_name(std::string_view line)
  {
    const auto ends = [](char c) { return c == '=' || is_blank(c); };
    return static_cast<std::size_t>(std::find_if(line.begin(), line.end(), ends) - line.begin());
  }

  // Takes a value up to the next blank, or between quotes, braces or brackets.
  std::string_view take_value(std::string_view& line) const
  {
    constexpr std::string_view openings = "\"'{[", closings = "\"'}]";
    const std::size_t kind = line.empty() ? openings.npos : openings.find(line.front());
    if (kind == openings.npos) {
      const std::size_t end =
          static_cast<std::size_t>(std::find_if(line.begin(), line.end(), is_blank) - line.begin());
      return taken(line, end);
    }
    line.remove_prefix(1);
    const std::size_t end = line.find(closings[kind]);
    if (end == line.npos) {
      m_scanner.fail("a value begins with " + std::string(1, openings[kind]) + " and has no end");
    }
    const std::string_view value = taken(line, end);
    line.remove_prefix(1);
    return value;
  }

  static std::string_view taken(std::string_view& line, std::size_t size)
  {
    const std::string_view value = line.substr(0, size);
    line.remove_prefix(size);
    return value;
  }

  const Text_scanner& m_scanner;
  std::map<std::string, std::string_view> m_values;
};

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
    return frames;
  }

private:
  struct Columns
  {
    std::size_t count = 0;
    std::optional<std::size_t> id{};
    std::optional<std::size_t> position{}; // of x, before y
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
    frame.time = time(comment, frames.size());
    frame.cell = cell(comment);
    check_kind(m_scanner, frame.cell, frames);
    const Columns columns =
        read_columns(comment.value("properties").value_or("species:S:1:pos:R:3"));
    read_points(size, columns);
    m_rows.sort_into(frame, m_scanner, "frame " + std::to_string(frames.size()));
    frames.push_back(std::move(frame));
  }

  double time(const Xyz_comment& comment, std::size_t frame) const
  {
    return comment.value("time") ? comment.numbers("time", 1)[0] : static_cast<double>(frame);
  }

  std::optional<Cell> cell(const Xyz_comment& comment) const
  {
    const std::array<bool, 2> is_periodic = periodic_sides(comment);
    if (!comment.value("lattice")) {
      if (is_periodic[0] || is_periodic[1]) {
        m_scanner.fail("the frame is periodic by its pbc, but has no Lattice");
      }
      return std::nullopt;
    }
    const std::vector<double> vectors = comment.numbers("lattice", 9);
    Point corner{0.0, 0.0};
    if (comment.value("origin")) {
      const std::vector<double> origin = comment.numbers("origin", 3);
      corner = {origin[0], origin[1]};
    }
    return cell_of_box(
        m_scanner, {corner, {{{vectors[0], vectors[1]}, {vectors[3], vectors[4]}}}, is_periodic});
  }

  // A lattice without pbc is periodic.
  std::array<bool, 2> periodic_sides(const Xyz_comment& comment) const
  {
    const auto text = comment.value("pbc");
    if (!text) {
      const bool has_lattice = comment.value("lattice").has_value();
      return {has_lattice, has_lattice};
    }
    std::vector<std::string_view> fields;
    split_at_blanks(*text, fields);
    if (fields.size() != 3) {
      m_scanner.fail("pbc is " + in_quotes(*text) + ", expected three of T and F");
    }
    return {is_true(fields[0]), is_true(fields[1])};
  }

  bool is_true(std::string_view word) const
  {
    const std::string name = lower_case(std::string(word));
    if (name == "t" || name == "true" || name == "1") {
      return true;
    }
    if (name == "f" || name == "false" || name == "0") {
      return false;
    }
    m_scanner.fail("pbc has " + in_quotes(word) + ", expected T or F");
  }

  // The columns by a text of the form name:type:number:name:type:number...
  Columns read_columns(std::string_view properties) const
  {
    std::vector<std::string_view> words;
    split_at(':', properties, words);
    if (words.size() % 3 != 0) {
      m_scanner.fail("Properties are not triples of a name, a type and a number of columns");
    }
    constexpr std::int64_t most_columns = 10'000;
    Columns columns;
    for (std::size_t i = 0; i != words.size(); i += 3) {
      const std::string name = lower_case(std::string(words[i]));
      const std::int64_t number = m_scanner.integer(words[i + 2], "number of columns");
      if (number < 1 || number > most_columns) {
        m_scanner.fail("property " + in_quotes(words[i]) + " has " + std::to_string(number) +
                       " columns, allowed are 1 to " + std::to_string(most_columns));
      }
      if (name == "id") {
        columns.id = columns.count;
      } else if (name == "pos" && number >= 2) {
        columns.position = columns.count;
      }
      columns.count += static_cast<std::size_t>(number);
    }
    if (!columns.position) {
      m_scanner.fail("Properties have no positions, expected pos:R:3");
    }
    return columns;
  }

  void read_points(std::size_t size, const Columns& columns)
  {
    m_rows.begin(size, m_scanner);
    for (std::size_t i = 0; i != size; ++i) {
      std::string_view line;
      if (!m_scanner.next_line(line)) {
        m_scanner.fail("the last frame is truncated: " + std::to_string(size) +
                       " points expected, " + std::to_string(i) + " found");
      }
      split_at_blanks(line, m_fields);
      if (m_fields.size() < columns.count) {
        m_scanner.fail("the point has " + std::to_string(m_fields.size()) + " fields, " +
                       std::to_string(columns.count) + " columns are named");
      }
      const std::int64_t id = columns.id ? m_scanner.integer(m_fields[*columns.id], "id")
                                         : static_cast<std::int64_t>(i);
      const std::string name = std::to_string(id);
      m_rows.add(id,
                 {m_scanner.coordinate(m_fields[*columns.position], "x", name),
                  m_scanner.coordinate(m_fields[*columns.position + 1], "y", name)},
                 m_scanner.line_number());
    }
  }

  Text_scanner m_scanner;
  std::vector<std::string_view> m_fields;
  Frame_rows m_rows;
};

} // namespace

Recording parse_xyz(const std::string& file, std::string_view text)
{
  return Xyz_parser(file, text).parse();
}

} // namespace scenario

// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SCENARIO_CSV_MOTION_H
#define SCENARIO_CSV_MOTION_H

#include "Csv_header.h"
#include "Field_splitter.h"
#include "Motion_file.h"
#include "Point_names.h"
#include "Recorded_motion.h"
#include "Text_file.h"
#include "Text_scanner.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

namespace scenario {

// Reads tables of positions, a row for a point in a frame, in the dialects of R, pandas, PeTrack
// and others. `frame`, `id`, `x`, `y` and, if it is there, `time` are looked up by name in a
// header, further columns are ignored. Rows come in any order; lines that begin with # are
// comments.
class Csv_parser
{
public:
  Csv_parser(const std::string& file, std::string_view text)
    : m_scanner(file, text)
  {
  }

  Recording parse()
  {
    std::string_view line = read_header();
    while (!line.empty()) {
      read_row(line);
      line = next_row();
    }
    if (m_rows.empty()) {
      throw Scenario_error(m_scanner.file(), "has a header but no rows");
    }
    sort_rows();
    return recording();
  }

private:
  struct Row
  {
    std::int64_t frame;
    std::int64_t id;
    double time;
    Point point;
    std::size_t line;
  };

  // Returns the first row of data, or nothing if there is none. The header is the first row, or,
  // where that has numbers, the last comment before it.
  std::string_view read_header()
  {
    const std::string_view first = next_row();
    if (first.empty()) {
      throw Scenario_error(m_scanner.file(),
                           std::string(m_comment.empty() ? "is empty" : "has comments alone") +
                               ", expected the header frame,time,id,x,y");
    }
    const Csv_header header(
        m_scanner.file(), first, m_scanner.line_number(),
        {Separator::comma, Separator::semicolon, Separator::tab, Separator::blanks});
    if (header.names_any_column() || !header.has_numbers()) {
      take(header);
      const std::string_view row = next_row();
      skip_row_names(row);
      return row;
    }
    take(header_in_comment());
    return first;
  }

  // Its words stand at blanks of any kind, however the rows are aligned.
  Csv_header header_in_comment() const
  {
    const Csv_header header(
        m_scanner.file(),
        m_comment.substr((std::min)(m_comment.find_first_not_of("# \t"), m_comment.size())),
        m_comment_line_number, {Separator::comma, Separator::semicolon, Separator::blanks});
    if (!header.names_any_column()) {
      m_scanner.fail("there is no header: this row has numbers, and no comment right before it "
                     "names the columns frame, id, x and y");
    }
    return header;
  }

  void take(const Csv_header& header)
  {
    m_position = header.positions();
    m_has_time = m_position[Csv_column::time] != Csv_header::none;
    m_number_of_fields = header.number_of_fields();
    m_splitter = Field_splitter(header.separator());
  }

  // R writes the names of rows in quotes before them, and nothing above these.
  void skip_row_names(std::string_view row)
  {
    if (row.empty() || row.front() != '"') {
      return;
    }
    split(row);
    if (m_fields.size() == m_number_of_fields + 1) {
      ++m_number_of_fields;
      for (std::size_t& position : m_position) {
        position += position == Csv_header::none ? 0 : 1;
      }
    }
  }

  // The next line that is no comment, nothing at the end.
  std::string_view next_row()
  {
    std::string_view line;
    while (m_scanner.next_whole_line(line)) {
      if (trimmed(line).front() != '#') {
        return line;
      }
      m_comment = trimmed(line);
      m_comment_line_number = m_scanner.line_number();
    }
    return {};
  }

  void split(std::string_view line)
  {
    const std::string_view problem = m_splitter.split(line, m_fields);
    if (!problem.empty()) {
      m_scanner.fail("field " + std::to_string(m_fields.size() + 1) + " " + std::string(problem));
    }
  }

  void read_row(std::string_view line)
  {
    split(line);
    if (m_fields.size() != m_number_of_fields) {
      m_scanner.fail("the row has " + std::to_string(m_fields.size()) + " fields, the header has " +
                     std::to_string(m_number_of_fields) + ", split at " +
                     place_of(m_splitter.separator()));
    }
    const std::int64_t frame = frame_number();
    const std::int64_t id = point_id();
    const double time = m_has_time ? number(Csv_column::time, id) : static_cast<double>(frame);
    m_rows.push_back({frame, id, time, Point{number(Csv_column::x, id), number(Csv_column::y, id)},
                      m_scanner.line_number()});
  }

  std::int64_t frame_number() const
  {
    const std::string_view text = field(Csv_column::frame);
    const auto number = m_scanner.whole_number(text, "frame");
    if (!number) {
      m_scanner.fail("frame " + in_quotes(text) + " is not an integer");
    }
    return *number;
  }

  std::int64_t point_id()
  {
    const std::string_view text = field(Csv_column::id);
    const auto number = m_scanner.whole_number(text, "id");
    if (number && !m_names) {
      return *number;
    }
    if (number) {
      return m_names->id(std::to_string(*number));
    }
    if (text.empty() || text == "NA" || text == "None" || text == "null") {
      m_scanner.fail("id " + in_quotes(text) + " stands for none, and every point needs one");
    }
    if (!m_names) {
      name_all();
    }
    return m_names->id(text);
  }

  // Where one id is text, all of them are names.
  void name_all()
  {
    m_names.emplace();
    for (Row& row : m_rows) {
      row.id = m_names->id(std::to_string(row.id));
    }
  }

  std::string id_text(std::int64_t id) const
  {
    return m_names ? in_quotes(m_names->name(id)) : std::to_string(id);
  }

  double number(Csv_column column, std::int64_t id) const
  {
    const std::string_view text = field(column);
    const std::string_view name = csv_column_names[column];
    if (m_splitter.separator() != Separator::comma && text.find(',') != std::string_view::npos) {
      m_scanner.fail(std::string(name) + " " + in_quotes(text) +
                     " is not a number: decimal commas are not supported, use points");
    }
    const double value = m_scanner.number(text, name);
    if (!std::isfinite(value)) {
      m_scanner.fail(std::string(name) + " of id " + id_text(id) + " is " + in_quotes(text) +
                     ", not a finite number");
    }
    return value;
  }

  std::string_view field(Csv_column column) const { return m_fields[m_position[column]]; }

  void sort_rows()
  {
    const auto before = [](const Row& a, const Row& b) {
      return std::tie(a.frame, a.id, a.line) < std::tie(b.frame, b.id, b.line);
    };
    if (!std::is_sorted(m_rows.begin(), m_rows.end(), before)) {
      std::sort(m_rows.begin(), m_rows.end(), before);
    }
    const auto twice =
        std::adjacent_find(m_rows.begin(), m_rows.end(), [](const Row& a, const Row& b) {
          return a.frame == b.frame && a.id == b.id;
        });
    if (twice != m_rows.end()) {
      throw Scenario_error(m_scanner.file(),
                           "id " + id_text(twice->id) + " is twice in frame " +
                               std::to_string(twice->frame) + ", first in line " +
                               std::to_string(twice->line),
                           (twice + 1)->line);
    }
  }

  Recording recording() const
  {
    Recording frames;
    for (auto row = m_rows.begin(); row != m_rows.end();) {
      const auto end = std::find_if(row, m_rows.end(),
                                    [row](const Row& other) { return other.frame != row->frame; });
      Recorded_frame& frame = frames.emplace_back();
      frame.time = row->time;
      frame.ids.reserve(static_cast<std::size_t>(end - row));
      frame.points.reserve(static_cast<std::size_t>(end - row));
      for (; row != end; ++row) {
        frame.ids.push_back(row->id);
        frame.points.push_back(row->point);
      }
    }
    return frames;
  }

  Text_scanner m_scanner;
  std::string_view m_comment;
  std::size_t m_comment_line_number = 0;
  Field_splitter m_splitter{Separator::comma};
  std::vector<std::string_view> m_fields;
  std::size_t m_number_of_fields = 0;
  std::array<std::size_t, csv_column_names.size()> m_position{};
  bool m_has_time = false;
  std::optional<Point_names> m_names;
  std::vector<Row> m_rows;
};

inline Recording read_csv_motion(const std::string& path)
{
  if (is_standard_input(path)) {
    const std::string name = "standard input";
    return Csv_parser(name, read_standard_input(name)).parse();
  }
  const std::string text = read_text_file(path);
  return Csv_parser(path, text).parse();
}

} // namespace scenario

#endif // SCENARIO_CSV_MOTION_H

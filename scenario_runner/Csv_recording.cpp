// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "scenario_runner/Csv_fields.h"
#include "scenario_runner/Csv_header.h"
#include "scenario_runner/Frame_reading.h"
#include "scenario_runner/Recorded_motion.h"
#include "scenario_runner/Text_input.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace scenario {

namespace {

class Csv_parser
{
public:
  Csv_parser(const std::string& file, std::string_view text, const Table_columns& columns)
    : m_scanner(file, text)
    , m_columns(columns)
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
    if (!m_layout.has(Csv_column::frame)) {
      m_rows.number_frames_by_time();
    }
    Recording frames = m_rows.recording(m_scanner, [this](std::int64_t id) { return id_text(id); });
    if (m_names) {
      set_names(frames, *m_names);
    }
    return frames;
  }

private:
  struct Comment
  {
    std::string text;
    std::size_t line_number;
  };

  // Returns the first row of data, or nothing if there is none. The header is the first row, or,
  // where that has numbers, a comment before it.
  std::string_view read_header()
  {
    std::string_view first = next_row();
    if (trimmed(first) == "$VISION") { // of PTV Viswalk
      m_comment_marks = "#*";
      first = next_row();
    }
    if (first.empty()) {
      throw Scenario_error(m_scanner.file(),
                           std::string(m_comments.empty() ? "is empty" : "has comments alone") +
                               ", expected the header frame,time,id,x,y");
    }
    if (!m_columns.in_order.empty()) {
      take(layout_in_order(m_scanner.file(), first, m_scanner.line_number(), m_columns));
      return first_row_of_data(first);
    }
    const Csv_header header(
        m_scanner.file(), first, m_scanner.line_number(),
        {Separator::comma, Separator::semicolon, Separator::tab, Separator::blanks}, m_columns);
    if (header.known() != 0 || !header.has_numbers()) {
      take(header.layout());
      const std::string_view row = first_row_of_data(next_row());
      skip_row_names(row);
      return row;
    }
    Csv_layout layout = layout_by_comments(first);
    layout.positions[Csv_column::z] =
        Csv_layout::none; // the heights of people, who walk on a floor
    take(layout);
    return first;
  }

  // The layout by the last comment that names all columns. Files of JuPedSim and PedPy need no
  // header: a comment with their frame rate tells what they are.
  Csv_layout layout_by_comments(std::string_view first_row) const
  {
    std::vector<Csv_header> headers;
    for (auto comment = m_comments.rbegin(); comment != m_comments.rend(); ++comment) {
      headers.push_back(header_in(*comment));
      if (headers.back().is_complete()) {
        return headers.back().layout();
      }
    }
    const bool may_need_no_header = has_frame_rate() && m_columns.by_title.empty();
    for (const Csv_header& header : headers) {
      const bool is_last = &header == &headers.front();
      if (may_need_no_header ? header.known() >= (is_last ? 2u : 3u)
                             : is_last && header.known() != 0) {
        return header.layout(); // throws: some are missing
      }
    }
    const auto layout =
        may_need_no_header ? layout_of_jupedsim(first_row) : std::optional<Csv_layout>();
    if (!layout) {
      m_scanner.fail("there is no header: this row has numbers, and no comment right before it "
                     "names the columns frame, id, x and y; name them in their order, as by "
                     "--columns id,frame,x,y");
    }
    return *layout;
  }

  bool has_frame_rate() const
  {
    return std::any_of(m_comments.begin(), m_comments.end(), [](const Comment& comment) {
      return lower_case(comment.text).find("framerate") != std::string::npos;
    });
  }

  // The header in a comment. Tabs between its words count as blanks, however rows are split. Files
  // of PeTrack may have units as [in m].
  Csv_header header_in(const Comment& comment) const
  {
    std::string text = comment.text;
    text.erase(0, (std::min)(text.find_first_not_of("#* \t"), text.size()));
    const std::string_view unit = "[in ";
    for (auto place = text.find(unit); place != text.npos; place = text.find(unit, place + 1)) {
      text.erase(place + 1, unit.size() - 1);
    }
    return Csv_header(m_scanner.file(), text, comment.line_number,
                      {Separator::comma, Separator::semicolon, Separator::blanks}, m_columns);
  }

  void take(const Csv_layout& layout)
  {
    m_layout = layout;
    m_splitter = Field_splitter(layout.separator);
  }

  // Skips the lines without numbers that may stand below a header, such as full names and units.
  std::string_view first_row_of_data(std::string_view row)
  {
    for (std::size_t i = 0; i != m_layout.more_header_lines && !row.empty(); ++i) {
      split(row);
      if (m_fields.size() != m_layout.number_of_fields || has_numbers()) {
        break;
      }
      check_units_in_row();
      row = next_row();
    }
    return row;
  }

  bool has_numbers() const
  {
    double ignored{};
    const auto is_number_at = [&](Csv_column column) {
      return m_layout.has(column) && is_number(field(column), ignored);
    };
    return is_number_at(Csv_column::frame) || is_number_at(Csv_column::time) ||
           is_number_at(Csv_column::x) || is_number_at(Csv_column::y);
  }

  void check_units_in_row() const
  {
    const std::string_view x = field(Csv_column::x);
    const std::string_view y = field(Csv_column::y);
    if (x != y && !x.empty() && x.front() == '(') {
      m_scanner.fail("the columns of x and y have different units, " + in_quotes(x) + " and " +
                     in_quotes(y) + ", allowed are equal ones");
    }
  }

  // Skips the column of row names that R writes, in quotes and without a title.
  void skip_row_names(std::string_view row)
  {
    if (row.empty() || row.front() != '"') {
      return;
    }
    split(row);
    if (m_fields.size() == m_layout.number_of_fields + 1) {
      ++m_layout.number_of_fields;
      for (std::size_t& position : m_layout.positions) {
        position += position == Csv_layout::none ? 0 : 1;
      }
    }
  }

  // The next line that is no comment, nothing at the end.
  std::string_view next_row()
  {
    std::string_view line;
    while (m_scanner.next_whole_line(line)) {
      const std::string_view content = trimmed(line);
      if (m_comment_marks.find(content.front()) == m_comment_marks.npos) {
        return line;
      }
      if (m_rows.empty()) {
        m_comments.push_back({std::string(content), m_scanner.line_number()});
      }
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
    if (m_fields.size() != m_layout.number_of_fields) {
      m_scanner.fail("the row has " + std::to_string(m_fields.size()) + " fields, the header has " +
                     std::to_string(m_layout.number_of_fields) + ", split at " +
                     place_of(m_splitter.separator()));
    }
    check_constant_fields();
    const std::int64_t frame = m_layout.has(Csv_column::frame) ? frame_number() : 0;
    const std::int64_t id = point_id();
    const double time =
        m_layout.has(Csv_column::time) ? number(Csv_column::time, id) : static_cast<double>(frame);
    const double height = m_layout.has(Csv_column::z) ? height_in(field(Csv_column::z)) : 0.0;
    m_rows.add({frame, id, time, Point{number(Csv_column::x, id), number(Csv_column::y, id)},
                height, m_scanner.line_number()});
  }

  void check_constant_fields()
  {
    for (std::size_t i = 0; i != m_layout.constant.size(); ++i) {
      const std::string_view text = m_fields[m_layout.constant[i]];
      if (m_constant_texts.size() == i) {
        m_constant_texts.emplace_back(text);
      } else if (m_constant_texts[i] != text) {
        m_scanner.fail("the tracks are of several clusters, in which their ids begin anew: use the "
                       "file .mdf of MTrackJ");
      }
    }
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

  // To be called at the first id that is text: all ids, also numbers, are then names.
  void name_all()
  {
    m_names.emplace();
    m_rows.rename([this](std::int64_t id) { return m_names->id(std::to_string(id)); });
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
    return m_scanner.coordinate(text, name, id_text(id));
  }

  std::string_view field(Csv_column column) const { return m_fields[m_layout.positions[column]]; }

  Text_scanner m_scanner;
  Table_columns m_columns;
  std::string_view m_comment_marks = "#";
  std::vector<Comment> m_comments; // before the first row
  Csv_layout m_layout;
  Field_splitter m_splitter{Separator::comma};
  std::vector<std::string_view> m_fields;
  std::vector<std::string> m_constant_texts;
  std::optional<Point_names> m_names;
  Recording_rows m_rows;
};

} // namespace

Recording parse_csv(const std::string& file, std::string_view text, const Table_columns& columns)
{
  return Csv_parser(file, text, columns).parse();
}

} // namespace scenario

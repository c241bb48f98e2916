// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SCENARIO_CSV_MOTION_H
#define SCENARIO_CSV_MOTION_H

#include "Recorded_motion.h"
#include "Text_file.h"
#include "Text_scanner.h"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

namespace scenario {

// Reads comma separated values whose first line names the columns; `frame`, `time`, `id`, `x` and
// `y` are looked up by name, further columns are ignored. Rows come in any order.
class Csv_parser
{
public:
  Csv_parser(const std::string& file, std::string_view text)
    : m_scanner(file, text)
  {
  }

  Recording parse()
  {
    read_header();
    read_rows();
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

  enum Column : std::size_t { frame, time, id, x, y };
  static constexpr std::array<std::string_view, 5> column_names = {"frame", "time", "id", "x", "y"};

  void read_header()
  {
    std::string_view line;
    if (!m_scanner.next_line(line)) {
      throw Scenario_error(m_scanner.file(), "is empty, expected the header frame,time,id,x,y");
    }
    split_at_commas(line, m_fields);
    m_number_of_fields = m_fields.size();
    for (std::size_t column = 0; column != column_names.size(); ++column) {
      m_position[column] = position_of(column_names[column]);
    }
  }

  std::size_t position_of(std::string_view name) const
  {
    const auto found = std::find(m_fields.begin(), m_fields.end(), name);
    if (found == m_fields.end()) {
      m_scanner.fail("column '" + std::string(name) +
                     "' is missing, needed are frame, time, id, x and y");
    }
    if (std::find(found + 1, m_fields.end(), name) != m_fields.end()) {
      m_scanner.fail("column '" + std::string(name) + "' is there twice");
    }
    return static_cast<std::size_t>(found - m_fields.begin());
  }

  void read_rows()
  {
    std::string_view line;
    while (m_scanner.next_line(line)) {
      split_at_commas(line, m_fields);
      if (m_fields.size() != m_number_of_fields) {
        m_scanner.fail("the row has " + std::to_string(m_fields.size()) +
                       " fields, the header has " + std::to_string(m_number_of_fields));
      }
      m_rows.push_back(row());
    }
    if (m_rows.empty()) {
      throw Scenario_error(m_scanner.file(), "has a header but no rows");
    }
  }

  Row row() const
  {
    const std::int64_t point_id = m_scanner.integer(field(id), "id");
    return {m_scanner.integer(field(frame), "frame"), point_id,
            coordinate(m_scanner, field(time), "time", point_id),
            Point{coordinate(m_scanner, field(x), "x", point_id),
                  coordinate(m_scanner, field(y), "y", point_id)},
            m_scanner.line_number()};
  }

  std::string_view field(Column column) const { return m_fields[m_position[column]]; }

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
                           "id " + std::to_string(twice->id) + " is twice in frame " +
                               std::to_string(twice->frame) + ", first in line " +
                               std::to_string(twice->line),
                           (twice + 1)->line);
    }
  }

  Recording recording() const
  {
    Recording frames;
    for (std::size_t i = 0; i != m_rows.size(); ++i) {
      if (i == 0 || m_rows[i].frame != m_rows[i - 1].frame) {
        frames.emplace_back();
        frames.back().time = m_rows[i].time;
      }
      frames.back().ids.push_back(m_rows[i].id);
      frames.back().points.push_back(m_rows[i].point);
    }
    return frames;
  }

  Text_scanner m_scanner;
  std::vector<std::string_view> m_fields;
  std::size_t m_number_of_fields = 0;
  std::array<std::size_t, column_names.size()> m_position{};
  std::vector<Row> m_rows;
};

inline Recording read_csv_motion(const std::string& path)
{
  const std::string text = read_text_file(path);
  return Csv_parser(path, text).parse();
}

} // namespace scenario

#endif // SCENARIO_CSV_MOTION_H

// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "scenario_runner/Recorded_motion.h"
#include "scenario_runner/Text_input.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>

namespace scenario {

namespace {

class Lammps_parser
{
public:
  Lammps_parser(const std::string& file, std::string_view text)
    : m_scanner(file, text)
  {
  }

  Recording parse()
  {
    Recording frames;
    std::string_view line;
    while (m_scanner.next_line(line)) {
      read_section(line, frames);
    }
    if (frames.empty() && !m_frame_is_open) {
      throw Scenario_error(m_scanner.file(), "is empty, expected ITEM: TIMESTEP");
    }
    if (m_frame_is_open) {
      fail_truncated("its atoms are missing");
    }
    return frames;
  }

private:
  struct Interval
  {
    double low;
    double high;
  };

  struct Coordinate_pair
  {
    std::string_view x;
    std::string_view y;
    bool scaled;
  };

  static constexpr std::array<Coordinate_pair, 4> coordinate_pairs = {
      {{"x", "y", false}, {"xu", "yu", false}, {"xs", "ys", true}, {"xsu", "ysu", true}}};

  struct Columns
  {
    std::size_t count;
    std::size_t id;
    std::size_t x;
    std::size_t y;
    bool scaled;
  };

  void read_section(std::string_view line, Recording& frames)
  {
    if (line == "ITEM: TIMESTEP") {
      begin_frame();
    } else if (line == "ITEM: UNITS") {
      data_line();
    } else if (line == "ITEM: TIME") {
      m_time = finite(data_line(), "time");
    } else if (!m_frame_is_open) {
      m_scanner.fail("expected ITEM: TIMESTEP, found " + in_quotes(line));
    } else if (line == "ITEM: NUMBER OF ATOMS") {
      read_number_of_atoms();
    } else if (starts_with(line, "ITEM: BOX BOUNDS")) {
      read_box(line);
    } else if (starts_with(line, "ITEM: ATOMS")) {
      read_atoms(line, frames);
    } else {
      m_scanner.fail("expected an ITEM: line, found " + in_quotes(line));
    }
  }

  void begin_frame()
  {
    if (m_frame_is_open) {
      fail_truncated("the next one begins before its atoms");
    }
    m_timestep = m_scanner.integer(data_line(), "timestep");
    m_frame_is_open = true;
    m_number_of_atoms.reset();
    m_box.reset();
  }

  void read_number_of_atoms()
  {
    const std::int64_t number = m_scanner.integer(data_line(), "number of atoms");
    if (number < 0) {
      m_scanner.fail("number of atoms " + std::to_string(number) + " is negative");
    }
    m_number_of_atoms = static_cast<std::size_t>(number);
  }

  void read_box(std::string_view header)
  {
    m_box_is_tilted = header.find(" xy ") != std::string_view::npos ||
                      header.find(" abc ") != std::string_view::npos;
    read_boundaries(header);
    m_box.emplace();
    for (Interval& side : *m_box) {
      split_at_blanks(data_line(), m_fields);
      if (m_fields.size() < 2) {
        m_scanner.fail("expected the lower and the upper bound of the box");
      }
      side = {finite(m_fields[0], "lower bound"), finite(m_fields[1], "upper bound")};
    }
  }

  // Of x, y and z: two letters each, p for periodic.
  void read_boundaries(std::string_view header)
  {
    split_at_blanks(header, m_fields);
    const std::size_t planar = m_fields.size() < 3 ? m_fields.size() : m_fields.size() - 1;
    m_box_is_periodic =
        std::find(m_fields.begin(), m_fields.begin() + static_cast<std::ptrdiff_t>(planar), "pp") !=
        m_fields.begin() + static_cast<std::ptrdiff_t>(planar);
  }

  void read_atoms(std::string_view header, Recording& frames)
  {
    if (!m_number_of_atoms) {
      m_scanner.fail("ITEM: NUMBER OF ATOMS is missing in the frame of timestep " +
                     std::to_string(m_timestep));
    }
    const Columns columns = read_columns(header);
    Recorded_frame frame;
    frame.time = m_time.value_or(static_cast<double>(m_timestep));
    frame.is_periodic = m_box && m_box_is_periodic;
    const std::size_t plausible = (std::min)(*m_number_of_atoms, m_scanner.bytes_left() / 2);
    frame.ids.reserve(plausible);
    frame.points.reserve(plausible);
    m_lines.clear();
    for (std::size_t i = 0; i != *m_number_of_atoms; ++i) {
      read_atom(columns, frame);
    }
    sort_by_id(frame);
    frames.push_back(std::move(frame));
    m_frame_is_open = false;
    m_time.reset();
  }

  Columns read_columns(std::string_view header)
  {
    split_at_blanks(header, m_fields);
    const std::vector<std::string_view> names(m_fields.begin() + 2, m_fields.end());
    const auto position = [&names](std::string_view name) {
      return static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin());
    };
    const std::size_t missing = names.size();
    if (position("id") == missing) {
      m_scanner.fail("column 'id' is missing");
    }
    for (const Coordinate_pair& pair : coordinate_pairs) {
      if (position(pair.x) != missing && position(pair.y) != missing) {
        check_scaling(pair.scaled);
        return {names.size(), position("id"), position(pair.x), position(pair.y), pair.scaled};
      }
    }
    m_scanner.fail("column '" + std::string(position("x") == missing ? "x" : "y") +
                   "' is missing; read are the pairs x y, xu yu, xs ys and xsu ysu");
  }

  void check_scaling(bool scaled) const
  {
    if (scaled && !m_box) {
      m_scanner.fail("scaled coordinates need ITEM: BOX BOUNDS before the atoms");
    }
    if (scaled && m_box_is_tilted) {
      m_scanner.fail("scaled coordinates in a tilted box are not supported, dump x y instead");
    }
  }

  void read_atom(const Columns& columns, Recorded_frame& frame)
  {
    std::string_view line;
    if (!m_scanner.next_line(line) || starts_with(line, "ITEM:")) {
      fail_truncated(std::to_string(*m_number_of_atoms) + " atoms expected, " +
                     std::to_string(frame.ids.size()) + " found");
    }
    split_at_blanks(line, m_fields);
    if (m_fields.size() != columns.count) {
      m_scanner.fail("the atom has " + std::to_string(m_fields.size()) + " fields, " +
                     std::to_string(columns.count) + " columns are named");
    }
    const std::int64_t id = m_scanner.integer(m_fields[columns.id], "id");
    Point point{m_scanner.coordinate(m_fields[columns.x], "x", std::to_string(id)),
                m_scanner.coordinate(m_fields[columns.y], "y", std::to_string(id))};
    if (columns.scaled) {
      point = {unscaled(point.x, (*m_box)[0]), unscaled(point.y, (*m_box)[1])};
      check_finite(point, id);
    }
    frame.ids.push_back(id);
    frame.points.push_back(point);
    m_lines.push_back(m_scanner.line_number());
  }

  void check_finite(const Point& point, std::int64_t id) const
  {
    if (!std::isfinite(point.x) || !std::isfinite(point.y)) {
      m_scanner.fail("the scaled coordinates of id " + std::to_string(id) +
                     " and the box give no finite number");
    }
  }

  static double unscaled(double fraction, const Interval& side)
  {
    return side.low + fraction * (side.high - side.low);
  }

  void sort_by_id(Recorded_frame& frame) const
  {
    std::vector<std::size_t> order(frame.ids.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::sort(order.begin(), order.end(), [&frame](std::size_t a, std::size_t b) {
      return std::pair(frame.ids[a], a) < std::pair(frame.ids[b], b);
    });
    Recorded_frame sorted;
    sorted.time = frame.time;
    sorted.is_periodic = frame.is_periodic;
    for (std::size_t i = 0; i != order.size(); ++i) {
      if (i != 0 && frame.ids[order[i]] == frame.ids[order[i - 1]]) {
        fail_twice(frame.ids[order[i]], m_lines[order[i - 1]], m_lines[order[i]]);
      }
      sorted.ids.push_back(frame.ids[order[i]]);
      sorted.points.push_back(frame.points[order[i]]);
    }
    frame = std::move(sorted);
  }

  [[noreturn]] void fail_twice(std::int64_t id, std::size_t first, std::size_t second) const
  {
    throw Scenario_error(m_scanner.file(),
                         "id " + std::to_string(id) + " is twice in the frame of timestep " +
                             std::to_string(m_timestep) + ", first in line " +
                             std::to_string(first),
                         second);
  }

  [[noreturn]] void fail_truncated(const std::string& how) const
  {
    m_scanner.fail("the frame of timestep " + std::to_string(m_timestep) + " is truncated: " + how);
  }

  std::string_view data_line()
  {
    std::string_view line;
    if (!m_scanner.next_line(line)) {
      m_scanner.fail(m_frame_is_open ? "the frame of timestep " + std::to_string(m_timestep) +
                                           " is truncated in its head"
                                     : "the file ends in the head of a frame");
    }
    return line;
  }

  double finite(std::string_view text, std::string_view what) const
  {
    const double value = m_scanner.number(text, what);
    if (!std::isfinite(value)) {
      m_scanner.fail(std::string(what) + " " + in_quotes(text) + " is not a finite number");
    }
    return value;
  }

  static bool starts_with(std::string_view text, std::string_view start)
  {
    return text.substr(0, start.size()) == start;
  }

  Text_scanner m_scanner;
  std::vector<std::string_view> m_fields;
  std::vector<std::size_t> m_lines;
  std::int64_t m_timestep = 0;
  std::optional<double> m_time;
  std::optional<std::size_t> m_number_of_atoms;
  std::optional<std::array<Interval, 3>> m_box;
  bool m_box_is_tilted = false;
  bool m_box_is_periodic = false;
  bool m_frame_is_open = false;
};

} // namespace

Recording parse_lammps_dump(const std::string& file, std::string_view text)
{
  return Lammps_parser(file, text).parse();
}

} // namespace scenario

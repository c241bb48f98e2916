// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "scenario_runner/Frame_reading.h"
#include "scenario_runner/Lammps_box.h"
#include "scenario_runner/Recorded_motion.h"
#include "scenario_runner/Text_input.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
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
  struct Coordinate_names
  {
    std::string_view x;
    std::string_view y;
    std::string_view z; // which need not be there
    bool scaled;
  };

  static constexpr std::array<Coordinate_names, 4> coordinate_names = {
      {{"x", "y", "z", false},
       {"xu", "yu", "zu", false},
       {"xs", "ys", "zs", true},
       {"xsu", "ysu", "zsu", true}}};

  struct Columns
  {
    std::size_t count;
    std::size_t id;
    std::size_t x;
    std::size_t y;
    std::optional<std::size_t> z;
    bool scaled;
  };

  void read_section(std::string_view line, Recording& frames)
  {
    if (line == "ITEM: TIMESTEP") {
      begin_frame(frames);
    } else if (line == "ITEM: UNITS") {
      data_line();
    } else if (line == "ITEM: TIME") {
      check_first(!m_time, line);
      m_time = finite_number(m_scanner, data_line(), "time");
    } else if (!m_frame_is_open) {
      m_scanner.fail("expected ITEM: TIMESTEP, found " + in_quotes(line));
    } else if (line == "ITEM: NUMBER OF ATOMS") {
      check_first(!m_number_of_atoms, line);
      m_number_of_atoms = number_of(m_scanner, data_line(), "atoms");
    } else if (starts_with(line, "ITEM: BOX BOUNDS")) {
      check_first(!m_box, "ITEM: BOX BOUNDS");
      read_box(line);
    } else if (starts_with(line, "ITEM: ATOMS")) {
      read_atoms(line, frames);
    } else {
      m_scanner.fail("expected an ITEM: line, found " + in_quotes(line));
    }
  }

  void check_first(bool is_first, std::string_view item) const
  {
    if (!is_first) {
      m_scanner.fail(std::string(item) + " is twice in a frame");
    }
  }

  void begin_frame(const Recording& frames)
  {
    if (m_frame_is_open) {
      fail_truncated("the next one begins before its atoms");
    }
    m_timestep = m_scanner.integer(data_line(), "timestep");
    check_ascends(m_scanner, "timestep", m_timestep, m_scanner.line_number(), frames);
    m_frame_is_open = true;
    m_number_of_atoms.reset();
    m_box.reset();
    m_head = {};
  }

  void read_box(std::string_view header)
  {
    split_at_blanks(header, m_fields);
    std::vector<std::string_view> words(m_fields.begin() + 3, m_fields.end());
    const auto begins_with = [&words](std::initializer_list<std::string_view> names) {
      return words.size() >= names.size() && std::equal(names.begin(), names.end(), words.begin());
    };
    const bool has_vectors = begins_with({"abc", "origin"});
    const bool is_tilted = begins_with({"xy", "xz", "yz"});
    words.erase(words.begin(), words.begin() + (has_vectors ? 2 : is_tilted ? 3 : 0));
    check_boundaries(words);
    std::array<bool, 3> is_periodic{};
    std::transform(words.begin(), words.end(), is_periodic.begin(),
                   [](std::string_view word) { return word == "pp"; });
    m_box.emplace(has_vectors ? read_vectors(is_periodic) : read_bounds(is_tilted, is_periodic));
    set_box(m_head, m_scanner, *m_box);
  }

  // Dumps of LAMMPS before 2010 have no boundaries. The box was periodic then, unless the input of
  // the run said otherwise, which nobody knows here.
  void check_boundaries(const std::vector<std::string_view>& words) const
  {
    if (words.empty()) {
      m_scanner.fail("ITEM: BOX BOUNDS does not say which sides are periodic: add pp pp pp to the "
                     "line if all were, or ff ff ff if none was");
    }
    if (words.size() != 3 || !std::all_of(words.begin(), words.end(), is_boundary)) {
      m_scanner.fail("the boundaries of the box are " + in_quotes(joined(words)) +
                     ", expected one for each of x, y and z: pp if it is periodic, or else two of "
                     "f, s and m");
    }
  }

  static bool is_boundary(std::string_view word)
  {
    return word == "pp" ||
           (word.size() == 2 && word.find_first_not_of("fsm") == std::string_view::npos);
  }

  static std::string joined(const std::vector<std::string_view>& words)
  {
    std::string text;
    for (const std::string_view word : words) {
      text += (text.empty() ? "" : " ") + std::string(word);
    }
    return text;
  }

  Cell_3 read_bounds(bool is_tilted, const std::array<bool, 3>& is_periodic)
  {
    constexpr std::array<const char*, 3> tilts = {"xy", "xz", "yz"};
    Lammps_bounds bounds;
    for (std::size_t axis = 0; axis != 3; ++axis) {
      read_numbers(is_tilted ? 3 : 2, "the lower and the upper bound of the box");
      bounds.low[axis] = finite_number(m_scanner, m_fields[0], "lower bound");
      bounds.high[axis] = finite_number(m_scanner, m_fields[1], "upper bound");
      if (is_periodic[axis] && !(bounds.low[axis] < bounds.high[axis])) {
        const std::string flaw = "the box is periodic here, so its upper bound " +
                                 in_quotes(m_fields[1]) + " has to be above its lower bound " +
                                 in_quotes(m_fields[0]);
        if (axis != 2) {
          m_scanner.fail(flaw);
        }
        m_head.flaw_in_space = {flaw, m_scanner.line_number()};
      }
      if (is_tilted) {
        bounds.tilt[axis] = finite_number(m_scanner, m_fields[2], tilts[axis]);
      }
    }
    const Cell_3 box = box_of_bounds(bounds, is_periodic);
    if ((is_periodic[0] && !(box.sides[0][0] > 0.0)) ||
        (is_periodic[1] && !(box.sides[1][1] > 0.0))) {
      m_scanner.fail("the box is periodic, and its bounds leave no room beside its tilt");
    }
    return box;
  }

  // Each line has a vector and a coordinate of the origin.
  Cell_3 read_vectors(const std::array<bool, 3>& is_periodic)
  {
    Cell_3 box{{}, {}, is_periodic};
    for (std::size_t row = 0; row != 3; ++row) {
      read_numbers(4, "a vector of the box and a coordinate of its origin");
      for (std::size_t i = 0; i != 3; ++i) {
        box.sides[row][i] = finite_number(m_scanner, m_fields[i], "vector");
      }
      box.corner[row] = finite_number(m_scanner, m_fields[3], "origin");
    }
    return box;
  }

  void read_numbers(std::size_t number, const char* what)
  {
    split_at_blanks(data_line(), m_fields);
    if (m_fields.size() < number) {
      m_scanner.fail(std::string("expected ") + what);
    }
  }

  void read_atoms(std::string_view header, Recording& frames)
  {
    if (!m_number_of_atoms) {
      m_scanner.fail("ITEM: NUMBER OF ATOMS is missing in the frame of timestep " +
                     std::to_string(m_timestep));
    }
    const Columns columns = read_columns(header);
    Recorded_frame frame = std::move(m_head);
    frame.number = m_timestep;
    frame.time = m_time.value_or(static_cast<double>(m_timestep));
    check_kind(m_scanner, frame.cell, frames);
    m_rows.begin(*m_number_of_atoms, m_scanner);
    for (std::size_t i = 0; i != *m_number_of_atoms; ++i) {
      read_atom(columns);
    }
    m_rows.sort_into(frame, m_scanner, "the frame of timestep " + std::to_string(m_timestep));
    frames.push_back(std::move(frame));
    m_frame_is_open = false;
    m_time.reset();
  }

  Columns read_columns(std::string_view header)
  {
    split_at_blanks(header, m_fields);
    const std::vector<std::string_view> names(m_fields.begin() + 2, m_fields.end());
    check_names(names);
    const auto position = [&names](std::string_view name) {
      return static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin());
    };
    const std::size_t missing = names.size();
    if (position("id") == missing) {
      m_scanner.fail("column 'id' is missing");
    }
    for (const auto& [x, y, z, scaled] : coordinate_names) {
      if (position(x) != missing && position(y) != missing) {
        check_scaling(scaled, position(z) != missing);
        return {names.size(),
                position("id"),
                position(x),
                position(y),
                position(z) == missing ? std::nullopt : std::optional(position(z)),
                scaled};
      }
    }
    m_scanner.fail("column '" + std::string(position("x") == missing ? "x" : "y") +
                   "' is missing; read are the pairs x y, xu yu, xs ys and xsu ysu");
  }

  void check_names(std::vector<std::string_view> names) const
  {
    std::sort(names.begin(), names.end());
    const auto twice = std::adjacent_find(names.begin(), names.end());
    if (twice != names.end()) {
      m_scanner.fail("column " + in_quotes(*twice) + " is there twice");
    }
  }

  void check_scaling(bool scaled, bool has_z) const
  {
    if (scaled && !m_box) {
      m_scanner.fail("scaled coordinates need ITEM: BOX BOUNDS before the atoms");
    }
    if (scaled && !has_z && (m_box->sides[2][0] != 0.0 || m_box->sides[2][1] != 0.0)) {
      m_scanner.fail("scaled coordinates in a box that is tilted along z need all three: dump zs "
                     "or zsu, too, or x y");
    }
  }

  void read_atom(const Columns& columns)
  {
    std::string_view line;
    if (!m_scanner.next_line(line) || starts_with(line, "ITEM:")) {
      fail_truncated(std::to_string(*m_number_of_atoms) + " atoms expected, " +
                     std::to_string(m_rows.size()) + " found");
    }
    split_at_blanks(line, m_fields);
    if (m_fields.size() != columns.count) {
      m_scanner.fail("the atom has " + std::to_string(m_fields.size()) + " fields, " +
                     std::to_string(columns.count) + " columns are named");
    }
    const std::int64_t id = m_scanner.integer(m_fields[columns.id], "id");
    Point point{m_scanner.coordinate(m_fields[columns.x], "x", std::to_string(id)),
                m_scanner.coordinate(m_fields[columns.y], "y", std::to_string(id))};
    double height = columns.z ? height_in(m_fields[*columns.z]) : 0.0;
    if (columns.scaled) {
      const Point_3 place = unscaled(point, height);
      height = columns.z ? place[2] : 0.0;
      point = {place[0], place[1]};
      check_finite(point, id);
    }
    m_rows.add(id, point, height, m_scanner.line_number());
  }

  void check_finite(const Point& point, std::int64_t id) const
  {
    if (!std::isfinite(point.x) || !std::isfinite(point.y)) {
      m_scanner.fail("the scaled coordinates of id " + std::to_string(id) +
                     " and the box give no finite number");
    }
  }

  // The third fraction may be NaN where the third side is along z: then z is so alone.
  Point_3 unscaled(const Point& fractions, double third) const
  {
    const auto& [a, b, c] = m_box->sides;
    Point_3 place = m_box->corner;
    for (std::size_t axis = 0; axis != 3; ++axis) {
      place[axis] += fractions.x * a[axis] + fractions.y * b[axis];
      place[axis] += c[axis] == 0.0 ? 0.0 : third * c[axis];
    }
    return place;
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

  static bool starts_with(std::string_view text, std::string_view start)
  {
    return text.substr(0, start.size()) == start;
  }

  Text_scanner m_scanner;
  std::vector<std::string_view> m_fields;
  Frame_rows m_rows;
  std::int64_t m_timestep = 0;
  std::optional<double> m_time;
  std::optional<std::size_t> m_number_of_atoms;
  std::optional<Cell_3> m_box; // periodic or not
  Recorded_frame m_head;       // what the box makes of the frame
  bool m_frame_is_open = false;
};

} // namespace

Recording parse_lammps_dump(const std::string& file, std::string_view text)
{
  return Lammps_parser(file, text).parse();
}

} // namespace scenario

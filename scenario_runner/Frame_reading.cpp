// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "scenario_runner/Frame_reading.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace scenario {

namespace {

const char* kind_name(const std::optional<Cell>& cell)
{
  return !cell ? "open" : cell->is_slab() ? "periodic in one direction" : "periodic in x and y";
}

// Why the plane cannot be repeated by a cell; empty if it can.
std::string flaw_of(const Cell& cell)
{
  for (std::size_t i = 0; i != 2; ++i) {
    const Point& side = cell.sides[i];
    if (!std::isfinite(side.x) || !std::isfinite(side.y)) {
      return "the sides of the box are too long for a number";
    }
    if (cell.is_periodic[i] && side.x == 0.0 && side.y == 0.0) {
      return std::string("the box is periodic along its ") + (i == 0 ? "first" : "second") +
             " side, whose length is 0";
    }
  }
  return !cell.is_slab() && cell.area() == 0.0
             ? "the box is periodic along both sides, which are parallel"
             : "";
}

// Most recordings are in the plane.
void drop_zeros(std::vector<double>& heights)
{
  if (std::all_of(heights.begin(), heights.end(), [](double z) { return z == 0.0; })) {
    heights = {};
  }
}

} // namespace

std::int64_t Point_names::id(std::string_view name)
{
  const auto [place, is_new] = m_ids.emplace(name, static_cast<std::int64_t>(m_names.size()));
  if (is_new) {
    m_names.push_back(&place->first);
  }
  return place->second;
}

std::shared_ptr<const Point_name_list> Point_names::list() const
{
  auto list = std::make_shared<Point_name_list>();
  for (const std::string* const name : m_names) {
    list->push_back(*name);
  }
  return list;
}

void set_names(Recording& frames, const Point_names& names)
{
  const std::shared_ptr<const Point_name_list> list = names.list();
  for (Recorded_frame& frame : frames) {
    frame.names = list;
  }
}

void Frame_rows::begin(std::size_t size, const Text_scanner& scanner)
{
  m_rows.clear();
  m_rows.reserve((std::min)(size, scanner.bytes_left() / 2));
}

void Frame_rows::add(std::int64_t id, const Point& point, double height, std::size_t line)
{
  m_rows.push_back({id, point, height, line});
}

void Frame_rows::sort_into(Recorded_frame& frame, const Text_scanner& scanner,
                           const std::string& frame_name)
{
  std::sort(m_rows.begin(), m_rows.end(), [](const Row& a, const Row& b) {
    return std::tie(a.id, a.line) < std::tie(b.id, b.line);
  });
  for (std::size_t i = 0; i != m_rows.size(); ++i) {
    const Row& row = m_rows[i];
    if (i != 0 && row.id == m_rows[i - 1].id) {
      throw Scenario_error(scanner.file(),
                           "id " + std::to_string(row.id) + " is twice in " + frame_name +
                               ", first in line " + std::to_string(m_rows[i - 1].line),
                           row.line);
    }
    frame.ids.push_back(row.id);
    frame.points.push_back(row.point);
    frame.heights.push_back(row.height);
  }
  drop_zeros(frame.heights);
}

void Recording_rows::number_frames_by_time()
{
  std::vector<double> times;
  for (const Row& row : m_rows) {
    times.push_back(row.time);
  }
  std::sort(times.begin(), times.end());
  times.erase(std::unique(times.begin(), times.end()), times.end());
  for (Row& row : m_rows) {
    row.frame = std::lower_bound(times.begin(), times.end(), row.time) - times.begin();
  }
}

Recording Recording_rows::recording(const Text_scanner& scanner,
                                    const std::function<std::string(std::int64_t)>& id_text)
{
  const auto before = [](const Row& a, const Row& b) {
    return std::tie(a.frame, a.id, a.line) < std::tie(b.frame, b.id, b.line);
  };
  if (!std::is_sorted(m_rows.begin(), m_rows.end(), before)) {
    std::sort(m_rows.begin(), m_rows.end(), before);
  }
  check_ids(scanner, id_text);
  Recording frames;
  for (auto row = m_rows.begin(); row != m_rows.end();) {
    const auto end = std::find_if(row, m_rows.end(),
                                  [row](const Row& other) { return other.frame != row->frame; });
    Recorded_frame& frame = frames.emplace_back();
    frame.time = row->time;
    frame.number = row->frame;
    frame.ids.reserve(static_cast<std::size_t>(end - row));
    frame.points.reserve(static_cast<std::size_t>(end - row));
    for (; row != end; ++row) {
      frame.ids.push_back(row->id);
      frame.points.push_back(row->point);
      frame.heights.push_back(row->height);
    }
    drop_zeros(frame.heights);
  }
  m_rows.clear();
  return frames;
}

void Recording_rows::check_ids(const Text_scanner& scanner,
                               const std::function<std::string(std::int64_t)>& id_text) const
{
  const auto twice =
      std::adjacent_find(m_rows.begin(), m_rows.end(), [](const Row& a, const Row& b) {
        return a.frame == b.frame && a.id == b.id;
      });
  if (twice != m_rows.end()) {
    throw Scenario_error(scanner.file(),
                         "id " + id_text(twice->id) + " is twice in frame " +
                             std::to_string(twice->frame) + ", first in line " +
                             std::to_string(twice->line),
                         (twice + 1)->line);
  }
}

std::size_t number_of(const Text_scanner& scanner, std::string_view text, const std::string& what)
{
  const std::int64_t number = scanner.integer(text, "number of " + what);
  if (number < 0) {
    scanner.fail("number of " + what + " " + std::to_string(number) + " is negative");
  }
  return static_cast<std::size_t>(number);
}

double height_in(std::string_view text)
{
  double value{};
  return is_number(text, value) && std::isfinite(value) ? value
                                                        : std::numeric_limits<double>::quiet_NaN();
}

double finite_number(const Text_scanner& scanner, std::string_view text, std::string_view what)
{
  const double value = scanner.number(text, what);
  if (!std::isfinite(value)) {
    scanner.fail(std::string(what) + " " + in_quotes(text) + " is not a finite number");
  }
  return value;
}

void check_ascends(const Text_scanner& scanner, const std::string& what, std::int64_t number,
                   std::size_t line, const Recording& frames_before)
{
  if (!frames_before.empty() && number <= frames_before.back().number) {
    throw Scenario_error(
        scanner.file(),
        what + " " + std::to_string(number) + " follows " +
            std::to_string(frames_before.back().number) +
            ": numbers have to ascend. A run that was continued writes some again, "
            "and one that was reset starts over: remove what is there twice, or "
            "split the file",
        line);
  }
}

void set_box(Recorded_frame& frame, const Text_scanner& scanner, const Cell_3& box)
{
  frame.box = box.number_of_periodic_sides() != 0 ? std::optional(box) : std::nullopt;
  const Cell cell = box.section();
  if (!cell.is_periodic[0] && !cell.is_periodic[1]) {
    return;
  }
  frame.cell = cell;
  if (const std::string flaw = flaw_of(cell); !flaw.empty()) {
    if (!box.repeats_space()) {
      scanner.fail(flaw);
    }
    frame.flaw_in_plane = {flaw, scanner.line_number()};
  }
}

void check_kind(const Text_scanner& scanner, const std::optional<Cell>& cell,
                const Recording& frames_before)
{
  if (frames_before.empty()) {
    return;
  }
  const std::optional<Cell>& before = frames_before.back().cell;
  const bool is_same = cell && before ? cell->has_kind_of(*before) : !cell == !before;
  if (!is_same) {
    scanner.fail(std::string("the box is ") + kind_name(cell) + ", that of the frame before is " +
                 kind_name(before) + "; all frames of a recording have to be alike in this");
  }
}

} // namespace scenario

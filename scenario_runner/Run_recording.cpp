// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "scenario_runner/Run_recording.h"

#include "scenario_runner/Periodic_faces.h"
#include "scenario_runner/Picture_geometry.h"
#include "scenario_runner/Rebuild_reason_name.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <ostream>

namespace run {

namespace {

using scenario::Cell;
using scenario::Point;
using Json = nlohmann::ordered_json;

// Numbers in ascending order, as differences.
void append_ascending(Packed_bytes& bytes, const std::vector<std::size_t>& numbers)
{
  bytes.append(numbers.size());
  std::size_t before = 0;
  for (const std::size_t number : numbers) {
    bytes.append(number - before);
    before = number;
  }
}

// Appends the places in an ascending list at which tuples were removed, and the tuples that were
// added, `numbers` numbers of each: the first one as difference to that of the tuple before,
// further corners as differences to the first one, shifts as they are.
template <class Tuple>
void append_changes(Packed_bytes& bytes, const std::vector<Tuple>& before,
                    const std::vector<Tuple>& after, std::size_t corners, std::size_t numbers)
{
  std::vector<std::size_t> removed;
  std::vector<Tuple> added;
  for (std::size_t i = 0, j = 0; i != before.size() || j != after.size();) {
    if (j == after.size() || (i != before.size() && before[i] < after[j])) {
      removed.push_back(i++);
    } else if (i == before.size() || after[j] < before[i]) {
      added.push_back(after[j++]);
    } else {
      ++i;
      ++j;
    }
  }
  append_ascending(bytes, removed);
  bytes.append(added.size());
  std::int64_t first = 0;
  for (const Tuple& tuple : added) {
    bytes.append(static_cast<std::uint64_t>(tuple[0] - first));
    first = tuple[0];
    for (std::size_t k = 1; k != numbers; ++k) {
      bytes.append_signed(k < corners ? tuple[k] - first : tuple[k]);
    }
  }
}

Json of_cell(const Cell& cell)
{
  const auto& [a, b] = cell.sides;
  return {{"corner", {cell.corner.x, cell.corner.y}},
          {"sides", {{a.x, a.y}, {b.x, b.y}}},
          {"isPeriodic", {cell.is_periodic[0], cell.is_periodic[1]}}};
}

// null where the cell is that of the frame before.
Json of_cells(const std::vector<std::optional<Cell>>& cells)
{
  Json list = Json::array();
  for (std::size_t k = 0; k != cells.size(); ++k) {
    list.push_back(k != 0 && cells[k] == cells[k - 1] ? Json() : of_cell(*cells[k]));
  }
  return list;
}

// Rounds a time to four digits, more than clocks have.
double rounded(double value)
{
  const double scale = value > 0.0 ? std::pow(10.0, 3.0 - std::floor(std::log10(value))) : 1.0;
  return std::round(value * scale) / scale;
}

// A row of numbers, one for each frame.
template <class Value>
Json column(const std::vector<Frame_record>& records, Value value)
{
  Json numbers = Json::array();
  for (const Frame_record& record : records) {
    numbers.push_back(value(record));
  }
  return numbers;
}

// A frame that was not timed has no time: the first one.
Json nanoseconds_a_point(const std::vector<Frame_record>& records, double Frame_times::*time)
{
  return column(records, [time](const Frame_record& record) {
    const double nanoseconds = record.nanoseconds.*time;
    return nanoseconds > 0.0 && record.points != 0
               ? Json(rounded(nanoseconds / static_cast<double>(record.points)))
               : Json();
  });
}

Json columns(const std::vector<Frame_record>& records)
{
  const auto reported = [&](auto member) {
    return column(records, [member](const Frame_record& record) { return record.update.*member; });
  };
  using Report = CGAL::Update_report_2;
  return {{"frame", column(records, [](const Frame_record& record) { return record.number; })},
          {"time", column(records, [](const Frame_record& record) { return record.time; })},
          {"points", column(records, [](const Frame_record& record) { return record.points; })},
          {"certified",
           column(records, [](const Frame_record& record) { return record.certified ? 1 : 0; })},
          {"validity", column(records, [](const Frame_record& record) { return record.validity; })},
          {"rebuild", column(records,
                             [](const Frame_record& record) {
                               return record.update.rebuilt()
                                          ? Json(rebuild_reason_name(record.update.rebuild_reason))
                                          : Json();
                             })},
          {"classified", reported(&Report::classified)},
          {"padded", reported(&Report::padded)},
          {"border", reported(&Report::border)},
          {"flips", reported(&Report::flips)},
          {"splices", reported(&Report::splices)},
          {"dynamic", nanoseconds_a_point(records, &Frame_times::dynamic)},
          {"staticInsert", nanoseconds_a_point(records, &Frame_times::static_insert)},
          {"staticFastest", nanoseconds_a_point(records, &Frame_times::static_fastest)}};
}

// In a script of a page "</script>" and "<!--" mean something else.
std::string script_text(const Json& json)
{
  std::string text;
  for (const char c : json.dump(-1, ' ', false, Json::error_handler_t::replace)) {
    if (c == '<') {
      text += "\\u003c";
    } else {
      text += c;
    }
  }
  return text;
}

} // namespace

void Run_recording::add(const Run_view& run)
{
  const scenario::Motion& motion = run.motion();
  m_records.push_back(run.record());
  if (m_records.size() == 1 && motion.names()) {
    m_names = *motion.names();
  }
  m_cells.push_back(motion.cell());
  const Places places = follow(motion);
  add_edges(run.edges(), places);
  add_triangles(run.triangles(), places);
  add_sets(run.sets(), places);
}

// Gives new points their numbers, and finds where the others have gone.
Run_recording::Places Run_recording::follow(const scenario::Motion& motion)
{
  const std::vector<std::int64_t>& ids = motion.ids();
  remove_gone(ids);
  const std::size_t known = m_points.size();
  Places places;
  for (std::size_t place = 0, before = 0; place != ids.size(); ++place) {
    while (before != m_ids.size() && m_ids[before] < ids[place]) {
      ++before;
    }
    const bool is_known = before != m_ids.size() && m_ids[before] == ids[place];
    const auto number = is_known ? m_numbers[before] : static_cast<Number>(m_points.size());
    if (!is_known) {
      m_points.push_back({ids[place], {}, Vertex_set::none, true});
    }
    places.numbers.push_back(number);
    places.shifts.push_back(shift_of(motion, place, is_known ? &m_points[number] : nullptr));
  }
  m_changes.append(m_points.size() - known);
  for (std::size_t number = known; number != m_points.size(); ++number) {
    m_changes.append_signed(m_points[number].id);
  }
  add_positions(motion, places);
  m_ids = ids;
  m_numbers = places.numbers;
  return places;
}

void Run_recording::remove_gone(const std::vector<std::int64_t>& ids)
{
  std::vector<std::size_t> gone;
  for (std::size_t i = 0; i != m_ids.size(); ++i) {
    if (!std::binary_search(ids.begin(), ids.end(), m_ids[i])) {
      gone.push_back(m_numbers[i]);
      m_points[m_numbers[i]].is_there = false;
    }
  }
  std::sort(gone.begin(), gone.end());
  append_ascending(m_changes, gone);
}

// The shift of a new point into the cell, or of a known one to the image nearest to its last place.
Run_recording::Shift Run_recording::shift_of(const scenario::Motion& motion, std::size_t place,
                                             const Followed_point* before)
{
  const auto cell = motion.cell();
  if (!cell) {
    return {0, 0};
  }
  const Point& point = motion.points()[place];
  return before ? nearest_shift(point, before->position, *cell) : shift_into_cell(point, *cell);
}

void Run_recording::add_positions(const scenario::Motion& motion, const Places& places)
{
  const auto cell = motion.cell();
  const std::size_t known = m_positions.empty() ? 0 : m_positions.back().numbers.size();
  std::vector<Point> drawn;
  std::vector<double> squared_distances;
  squared_distances.reserve(known);
  for (std::size_t place = 0; place != places.numbers.size(); ++place) {
    const Point& point = motion.points()[place];
    Followed_point& followed = m_points[places.numbers[place]];
    const Point to = cell ? cell->image(point, places.shifts[place]) : point;
    if (std::binary_search(m_ids.begin(), m_ids.end(), followed.id)) {
      const double dx = to.x - followed.position.x, dy = to.y - followed.position.y;
      squared_distances.push_back(dx * dx + dy * dy);
    }
    followed.position = to;
    drawn.push_back(cell ? cell->image(point, shift_into_cell(point, *cell)) : point);
  }
  take_bounds(drawn);
  if (cell) {
    take_bounds(outline_of(*cell));
  }
  if (m_records.size() > 1) {
    const double time = m_records.back().time - m_records[m_records.size() - 2].time;
    add_speed(squared_distances, time);
  }
  Frame_positions frame;
  for (std::size_t number = 0; number != m_points.size(); ++number) {
    if (m_points[number].is_there) {
      frame.numbers.push_back(static_cast<Number>(number));
      frame.points.push_back(m_points[number].position);
    }
  }
  m_positions.push_back(std::move(frame));
}

// The largest speed in all frames, without the fastest twentieth of the points of each: a single
// point that is much faster would leave one color to all others.
void Run_recording::add_speed(const std::vector<double>& squared_distances, double time)
{
  if (squared_distances.empty()) {
    return;
  }
  std::vector<double> sorted = squared_distances;
  const std::size_t at = (sorted.size() - 1) * 19 / 20;
  std::nth_element(sorted.begin(), sorted.begin() + static_cast<std::ptrdiff_t>(at), sorted.end());
  m_speed_scale = (std::max)(m_speed_scale, std::sqrt(sorted[at]) / (time > 0.0 ? time : 1.0));
}

void Run_recording::add_sets(const std::vector<Vertex_set>& sets, const Places& places)
{
  std::vector<std::size_t> changed;
  for (std::size_t place = 0; place != sets.size(); ++place) {
    Followed_point& point = m_points[places.numbers[place]];
    if (point.set != sets[place]) {
      point.set = sets[place];
      changed.push_back(places.numbers[place]);
    }
  }
  std::sort(changed.begin(), changed.end());
  append_ascending(m_changes, changed);
  for (const std::size_t number : changed) {
    m_changes.append(static_cast<std::uint64_t>(m_points[number].set));
  }
}

void Run_recording::add_edges(const std::vector<Shown_edge>& edges, const Places& places)
{
  std::vector<Edge> now;
  std::vector<Edge> wrong;
  for (const Shown_edge& edge : edges) {
    const std::int64_t from = places.numbers[edge.from], to = places.numbers[edge.to];
    const Shift &of_from = places.shifts[edge.from], &of_to = places.shifts[edge.to];
    const std::int64_t s = edge.shift[0] + of_from[0] - of_to[0];
    const std::int64_t t = edge.shift[1] + of_from[1] - of_to[1];
    const Edge known = (std::min)(Edge{from, to, s, t}, Edge{to, from, -s, -t});
    now.push_back(known);
    if (!edge.is_delaunay) {
      wrong.push_back(known);
    }
  }
  std::sort(now.begin(), now.end());
  append_changes(m_changes, m_edges, now, 2, m_cells.back() ? 4 : 2);
  m_edges = std::move(now);
  std::vector<std::size_t> places_of_wrong;
  for (const Edge& edge : wrong) {
    const auto at = std::lower_bound(m_edges.begin(), m_edges.end(), edge);
    places_of_wrong.push_back(static_cast<std::size_t>(at - m_edges.begin()));
  }
  std::sort(places_of_wrong.begin(), places_of_wrong.end());
  append_ascending(m_changes, places_of_wrong);
}

void Run_recording::add_triangles(const std::vector<Shown_triangle>& triangles,
                                  const Places& places)
{
  std::vector<Triangle> now;
  for (const Shown_triangle& triangle : triangles) {
    Periodic_face face{};
    for (std::size_t k = 0; k != 3; ++k) {
      const std::size_t place = triangle.corners[k];
      face.places[k] = places.numbers[place];
      face.shifts[k] = {triangle.shifts[k][0] - places.shifts[place][0],
                        triangle.shifts[k][1] - places.shifts[place][1]};
    }
    const auto [corners, shifts] = normal(face);
    now.push_back({corners[0], corners[1], corners[2], shifts[1][0], shifts[1][1], shifts[2][0],
                   shifts[2][1]});
  }
  std::sort(now.begin(), now.end());
  append_changes(m_changes, m_triangles, now, 3, m_cells.back() ? 7 : 3);
  m_triangles = std::move(now);
}

void Run_recording::take_bounds(const std::vector<Point>& points)
{
  if (points.empty()) {
    return;
  }
  const Bounds bounds = bounds_of(points);
  if (!m_bounds) {
    m_bounds = bounds;
  }
  m_bounds = bounds_of({m_bounds->low, m_bounds->high, bounds.low, bounds.high});
}

double Run_recording::quantum() const
{
  const double side = m_bounds ? (std::max)(m_bounds->width(), m_bounds->height()) : 0.0;
  return (std::max)(side / steps_of_longer_side, (std::numeric_limits<double>::min)());
}

// For each point of each frame, as multiples of the quantum: the position of a new one, and the
// displacement of the others.
std::string Run_recording::packed_positions() const
{
  Packed_bytes bytes;
  std::vector<std::array<std::int64_t, 2>> last(m_points.size());
  const Point low = m_bounds ? m_bounds->low : Point{};
  // halves, as the difference of two doubles may be no finite one
  const auto multiple = [unit = quantum()](double value, double from) {
    return std::llround((0.5 * value - 0.5 * from) / unit * 2.0);
  };
  for (const Frame_positions& frame : m_positions) {
    for (std::size_t i = 0; i != frame.numbers.size(); ++i) {
      auto& [x, y] = last[frame.numbers[i]];
      const std::int64_t new_x = multiple(frame.points[i].x, low.x);
      const std::int64_t new_y = multiple(frame.points[i].y, low.y);
      bytes.append_signed(new_x - x);
      bytes.append_signed(new_y - y);
      x = new_x;
      y = new_y;
    }
  }
  return bytes.bytes();
}

void Run_recording::write(std::ostream& out, const std::string& name,
                          const std::string& method) const
{
  const Point low = m_bounds ? m_bounds->low : Point{};
  const Point high = m_bounds ? m_bounds->high : Point{};
  const bool is_periodic = !m_cells.empty() && m_cells.front();
  out << script_text({{"name", name},
                      {"method", method},
                      {"numbers", m_points.size()},
                      {"names", m_names.empty() ? Json() : Json(m_names)},
                      {"low", {low.x, low.y}},
                      {"high", {high.x, high.y}},
                      {"quantum", quantum()},
                      {"speedScale", m_speed_scale},
                      {"cells", is_periodic ? of_cells(m_cells) : Json()},
                      {"columns", columns(m_records)},
                      {"positions", base64(packed_positions())},
                      {"changes", base64(m_changes.bytes())}});
}

} // namespace run

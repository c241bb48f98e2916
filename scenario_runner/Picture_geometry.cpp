// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "scenario_runner/Picture_geometry.h"

#include <array>
#include <cmath>
#include <cstddef>

namespace run {

namespace {

using scenario::Cell;
using scenario::Point;
using scenario::Shift;

Point plus(const Point& p, const Point& q)
{
  return {p.x + q.x, p.y + q.y};
}

Point minus(const Point& p, const Point& q)
{
  return {p.x - q.x, p.y - q.y};
}

Point middle(const Point& p, const Point& q)
{
  return {0.5 * (p.x + q.x), 0.5 * (p.y + q.y)};
}

// By which shift the point is outside of the cell. A slab has no sides across if its box is flat.
Shift shift_out_of_cell(const Point& point, const Cell& cell)
{
  std::array<Point, 2> sides = cell.sides;
  if (cell.area() == 0.0) {
    const Point& u = cell.period();
    sides[cell.is_periodic[0] ? 1 : 0] = {-u.y, u.x};
  }
  const auto& [a, b] = sides;
  const Point p = minus(point, cell.corner);
  const double area = a.x * b.y - a.y * b.x;
  const auto multiple = [](bool is_periodic, double coordinate) {
    return is_periodic ? static_cast<int>(std::floor(coordinate)) : 0;
  };
  return {multiple(cell.is_periodic[0], (p.x * b.y - p.y * b.x) / area),
          multiple(cell.is_periodic[1], (a.x * p.y - a.y * p.x) / area)};
}

Picture_geometry open_geometry(const Run_view& run)
{
  Picture_geometry geometry{run.motion().points(), {}, {}};
  for (const Shown_edge& edge : run.edges()) {
    geometry.edges.push_back({geometry.points[edge.from], geometry.points[edge.to]});
  }
  return geometry;
}

} // namespace

Picture_geometry picture_geometry(const Run_view& run)
{
  const auto cell = run.motion().cell();
  if (!cell) {
    return open_geometry(run);
  }
  Picture_geometry geometry;
  std::vector<Shift> shifts;
  for (const Point& point : run.motion().points()) {
    shifts.push_back(shift_out_of_cell(point, *cell));
    geometry.points.push_back(minus(point, cell->translation(shifts.back())));
  }
  for (const Shown_edge& edge : run.edges()) {
    const Shift shift{edge.shift[0] + shifts[edge.to][0] - shifts[edge.from][0],
                      edge.shift[1] + shifts[edge.to][1] - shifts[edge.from][1]};
    const Point from = geometry.points[edge.from], to = geometry.points[edge.to];
    if (shift == Shift{0, 0}) {
      geometry.edges.push_back({from, to});
    } else {
      const Point by = cell->translation(shift);
      geometry.edges.push_back({from, middle(from, plus(to, by))});
      geometry.edges.push_back({to, middle(to, minus(from, by))});
    }
  }
  const auto& [a, b] = cell->sides;
  geometry.outline = {cell->corner, plus(cell->corner, a), plus(plus(cell->corner, a), b),
                      plus(cell->corner, b)};
  return geometry;
}

} // namespace run

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

// A vector as multiples of the sides. A slab has no side across if its box is flat: a perpendicular
// one of the same length stands for it.
Point along_sides(const Point& vector, const Cell& cell)
{
  std::array<Point, 2> sides = cell.sides;
  if (cell.area() == 0.0) {
    const Point& u = cell.period();
    sides[cell.is_periodic[0] ? 1 : 0] = {-u.y, u.x};
  }
  const auto& [a, b] = sides;
  const double area = a.x * b.y - a.y * b.x;
  return {(vector.x * b.y - vector.y * b.x) / area, (a.x * vector.y - a.y * vector.x) / area};
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

Shift shift_into_cell(const Point& point, const Cell& cell)
{
  const Point at = along_sides(minus(point, cell.corner), cell);
  return {cell.is_periodic[0] ? -static_cast<int>(std::floor(at.x)) : 0,
          cell.is_periodic[1] ? -static_cast<int>(std::floor(at.y)) : 0};
}

Shift nearest_shift(const Point& point, const Point& place, const Cell& cell)
{
  const Point at = along_sides(minus(place, point), cell);
  return {cell.is_periodic[0] ? static_cast<int>(std::lround(at.x)) : 0,
          cell.is_periodic[1] ? static_cast<int>(std::lround(at.y)) : 0};
}

std::vector<Point> outline_of(const Cell& cell)
{
  const auto& [a, b] = cell.sides;
  return {cell.corner, plus(cell.corner, a), plus(plus(cell.corner, a), b), plus(cell.corner, b)};
}

Picture_geometry picture_geometry(const Run_view& run)
{
  const auto cell = run.motion().cell();
  if (!cell) {
    return open_geometry(run);
  }
  Picture_geometry geometry;
  std::vector<Shift> shifts;
  for (const Point& point : run.motion().points()) {
    shifts.push_back(shift_into_cell(point, *cell));
    geometry.points.push_back(cell->image(point, shifts.back()));
  }
  for (const Shown_edge& edge : run.edges()) {
    const Shift shift{edge.shift[0] + shifts[edge.from][0] - shifts[edge.to][0],
                      edge.shift[1] + shifts[edge.from][1] - shifts[edge.to][1]};
    const Point from = geometry.points[edge.from], to = geometry.points[edge.to];
    if (shift == Shift{0, 0}) {
      geometry.edges.push_back({from, to});
    } else {
      geometry.edges.push_back({from, middle(from, cell->image(to, shift))});
      geometry.edges.push_back({to, middle(to, cell->image(from, {-shift[0], -shift[1]}))});
    }
  }
  geometry.outline = outline_of(*cell);
  return geometry;
}

} // namespace run

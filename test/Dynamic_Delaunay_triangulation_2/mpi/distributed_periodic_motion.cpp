// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Run by several ranks in a periodic cell, which may change: the union of their edges is the
// triangulation of all points, in each frame.

#include "distributed_periodic_oracle.h"
#include "distributed_theme.h"

#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <limits>
#include <random>
#include <vector>

namespace distributed_periodic_motion {

constexpr double length = 20;

// Where a point is in the cell, as parts of its vectors, and back.
Point in_cell(const Cell& cell, const Point& parts)
{
  return Point(parts.x() * cell.ax() + parts.y() * cell.bx(),
               parts.x() * cell.ay() + parts.y() * cell.by());
}

double wrapped(double x)
{
  return x - length * std::floor(x / length);
}

// Points that keep their parts of the vectors of a cell that is deformed, but for small steps.
template <class Deform>
void run_with_cell(const std::string& what, const std::vector<Point>& parts, int frames,
                   const Ownership& ownership, const Deform& deform)
{
  std::mt19937 random(3);
  std::normal_distribution<double> step(0, 0.02);
  Points points;
  for (const Point& p : parts)
    points.push_back(in_cell(deform(0), p));
  run_periodic(what, points, frames, ownership, deform,
               [&](std::size_t i, const Point&, int frame) {
                 const Point p = in_cell(deform(frame), parts[i]);
                 return Point(p.x() + step(random), p.y() + step(random));
               });
}

void refuse_bad_input()
{
  const Population points =
      numbered({{0, 0}, {1, 0}, {0, 1}, {1, 1.5}, {2, 3}, {3, 1}, {4, 2}, {5, 5}});
  auto dt = distributed<Distributed_periodic>(points, in_order, Cell(6, 6));
  const auto refuses = [&](const Cell& cell, const Points& next) {
    const bool is_so = is_refused<CGAL::Dynamic_Delaunay_triangulation_error_2>(
        [&] { dt.update(next.begin(), next.end(), cell); });
    expect_exact(dt, points, "after a refusal");
    expect(dt.cell() == Cell(6, 6), "the cell is as it was");
    return is_so;
  };
  const bool is_bad = this_rank == 0;
  Points next = own_positions(dt, points);
  for (const double x : {std::numeric_limits<double>::quiet_NaN(), 7e5}) {
    Points bad = next;
    if (is_bad && !bad.empty())
      bad[0] = Point(x, 0);
    expect(refuses(Cell(6, 6), bad) == (sum(is_bad && !bad.empty()) > 0),
           "a bad point is refused on all ranks");
  }
  expect(refuses(Cell::slab(6, 0), next), "a slab is refused");
  expect(refuses(Cell(6, 0, 6, 1e-300), next), "a cell that is too thin is refused");
  expect(refuses(Cell(1e160, 1e160), next), "a cell that is too large is refused");
  if (number_of_ranks > 1)
    expect(refuses(Cell(6, is_bad ? 6 : 7), next), "different cells are refused");
  next.push_back(Point(0, 0));
  expect(refuses(Cell(6, 7), next), "too many points are refused");
}

void run_theme()
{
  std::mt19937 random(7); // the same on all ranks
  std::uniform_real_distribution<double> coordinate(0, length);
  std::normal_distribution<double> step(0, 0.05);
  const Points cloud = any_points(300, length, random), parts = any_points(300, 1, random);
  const auto at_first = always(Cell(length, length));
  constexpr int frames = 12;
  const char* const wanted = std::getenv("DYNAMIC_DELAUNAY_DISTRIBUTED_FRAMES");
  const int many = wanted ? std::atoi(wanted) : 3 * frames; // of those that can go on for long
  for (const double load_factor : {no_balance, Distributed_periodic::default_load_factor}) {
    const Ownership ownership{in_order, load_factor};
    run_periodic("Brownian motion, wrapped", cloud, many, ownership, at_first,
                 [&](std::size_t, const Point& p, int) {
                   return Point(wrapped(p.x() + step(random)), wrapped(p.y() + step(random)));
                 });
    run_periodic("a stream that is not wrapped", cloud, frames, ownership, at_first,
                 [&](std::size_t, const Point& p, int) {
                   return Point(p.x() + 3 + step(random), p.y() + 0.1 * p.x());
                 });
    run_periodic("jumps", cloud, many, {in_turn, load_factor}, at_first,
                 [&](std::size_t, const Point& p, int) {
                   return random() % 20 ? p : Point(coordinate(random), coordinate(random));
                 });
    run_with_cell("shear, with cells that are flipped", parts, many, ownership, [](int frame) {
      const double shear = 0.07 * frame;
      return Cell(length, 0, length * (shear - std::round(shear)), length);
    });
    run_with_cell("shear without end", parts, 3 * frames, ownership,
                  [](int frame) { return Cell(length, 0, 0.07 * frame * length, length); });
    run_with_cell("stretching", parts, 2 * frames, ownership, [](int frame) {
      return Cell(length * std::exp(0.1 * frame), length * std::exp(-0.1 * frame));
    });
    run_with_cell("growth, and a turn", parts, frames, ownership, [](int frame) {
      const double s = length * std::exp(0.2 * frame), turn = 0.3 * frame;
      return Cell(s * std::cos(turn), s * std::sin(turn), -s * std::sin(turn), s * std::cos(turn));
    });
    run_with_cell("any other cell", parts, frames, ownership, [](int frame) {
      std::mt19937 own(unsigned(100 + frame));
      std::uniform_real_distribution<double> any(-length, length);
      const double ax = any(own), ay = any(own), bx = any(own);
      return Cell(ax, ay, bx, any(own));
    });
  }
  run_periodic("a rank that owns all", cloud, 2, {on_first, no_balance}, at_first, at_rest);
  run_periodic("points in turn", cloud, 2, {in_turn, no_balance}, at_first, at_rest);
  run_periodic("points far from the origin", cloud, 3, {}, at_first,
               [&](std::size_t i, const Point&, int frame) {
                 const double way = length * double(frame * 15000 + int(i % 5));
                 return Point(cloud[i].x() + way, cloud[i].y() - way);
               });
  refuse_bad_input();
}

const Theme theme("distributed_periodic_motion", run_theme);

} // namespace distributed_periodic_motion

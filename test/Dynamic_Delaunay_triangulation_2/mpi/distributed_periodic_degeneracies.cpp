// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Run by several ranks in a periodic cell: points on common circles and lines, points that
// coincide, also by translations of the lattice, too few points for all ranks, and extreme cells.

#include "distributed_periodic_oracle.h"
#include "distributed_theme.h"

#include <cmath>
#include <cstddef>
#include <random>

namespace distributed_periodic_degeneracies {

void run_theme()
{
  std::mt19937 random(11); // the same on all ranks
  std::normal_distribution<double> step(0, 0.05);
  Points grid, line, pairs;
  for (int i = 0; i < 144; ++i) {
    grid.push_back(Point(i % 12, i / 12));
    line.push_back(Point(i % 12, 2 * (i % 12)));
    // two points a place, one of them some cells away
    pairs.push_back(Point(7 * (i % 72) % 31 + 31 * (i / 72), 11 * (i % 72) % 37 - 74 * (i / 72)));
  }
  const Cell square(12, 12);
  const double root = std::sqrt(3.0);

  for (const Ownership& ownership : ownerships) {
    run_periodic("a grid that comes and goes", grid, 4, ownership, always(square),
                 [&](std::size_t i, const Point&, int frame) {
                   return frame % 2 ? Point(double(i % 12) + step(random), double(i / 12))
                                    : grid[i];
                 });
    run_periodic(
        "a grid that shears with its cell", grid, 6, ownership,
        [](int frame) { return Cell(12, 0, 3 * frame, 12); },
        [&](std::size_t i, const Point&, int frame) {
          return Point(double(i % 12) + 0.25 * frame * double(i / 12), double(i / 12));
        });
    run_periodic("a grid in a skew cell", grid, 1, ownership, always(Cell(24, 12, 36, 24)),
                 at_rest);
    const Points circle = points_on_one_circle(1105, 50);
    run_periodic("a circle", circle, 3, ownership, always(Cell(110, 110)),
                 [&](std::size_t i, const Point&, int frame) {
                   return frame == 2 && i == 5 ? Point(1, 1) : circle[i];
                 });
    run_periodic("points that coincide by translations", pairs, 4, ownership, always(Cell(31, 37)),
                 [&](std::size_t i, const Point&, int frame) {
                   return i % 3 == 0 && frame % 2 ? Point(pairs[i].x() + 0.25, pairs[i].y())
                                                  : pairs[i];
                 });
    run_periodic("points on a line that coincide", line, 2, ownership, always(Cell(12, 24)),
                 at_rest);
    run_periodic("points that all meet", Points(grid.begin(), grid.begin() + 30), 3, ownership,
                 always(square), [&](std::size_t i, const Point&, int frame) {
                   return frame == 2 ? Point(1 + 12 * double(i), 1) : grid[i];
                 });
    for (std::size_t n = 0; n <= 9; ++n)
      for (const Cell& cell : {Cell(31, 37), Cell(32, 32), Cell(32, 0, 16, 16 * root)})
        run_periodic(std::to_string(n) + " points", Points(pairs.begin(), pairs.begin() + long(n)),
                     3, ownership, always(cell), [&](std::size_t i, const Point& p, int frame) {
                       return frame == 1 && i + 2 >= n ? Point(0, 16) : p;
                     });
  }
  run_periodic("a grid of one rank", grid, 2, {on_first, no_balance}, always(square), at_rest);
  const Points few(pairs.begin(), pairs.begin() + 5);
  for (const Cell& cell : {Cell(1, 40), Cell(40, 0, 39.5, 1), Cell(1000, 1, 999, 1.001),
                           Cell(1e-90, 1e-90), Cell(1e90, 2e90), Cell(-3, 1, 5, -7)}) {
    Points parts;
    for (const Point& p : few)
      parts.push_back(Point(p.x() / 40 * cell.ax() + p.y() / 40 * cell.bx(),
                            p.x() / 40 * cell.ay() + p.y() / 40 * cell.by()));
    run_periodic("few points in an extreme cell", parts, 1, {}, always(cell), at_rest);
  }
}

const Theme theme("distributed_periodic_degeneracies", run_theme);

} // namespace distributed_periodic_degeneracies

// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Run by several ranks: points on common circles and lines, points that coincide, and too few
// points for all ranks.

#include "distributed_oracle.h"
#include "distributed_theme.h"

#include <cstddef>
#include <random>

namespace distributed_degeneracies {

void run_theme()
{
  std::mt19937 random(11); // the same on all ranks
  std::normal_distribution<double> step(0, 0.05);
  Points grid, line, pairs;
  for (int i = 0; i < 400; ++i) {
    grid.push_back(Point(i % 20, i / 20));
    line.push_back(Point(i % 40, 2 * (i % 40)));
    pairs.push_back(Point(7 * (i % 200) % 31, 11 * (i % 200) % 37));
  }

  for (const Ownership& ownership : ownerships) {
    run("a grid that comes and goes", grid, 6, ownership,
        [&](std::size_t i, const Point&, int frame) {
          return frame % 2 ? Point(double(i % 20) + step(random), double(i / 20)) : grid[i];
        });
    // Each square of the grid has corners of several ranks, and its diagonal is one edge.
    run("a grid that shears", grid, 4, ownership, [&](std::size_t i, const Point& p, int frame) {
      return Point(double(i % 20) + double(frame) * p.y(), p.y());
    });
    const Points circle = points_on_one_circle(1105 * 169, 500);
    expect(circle.size() > 60, "many points are on one circle");
    run("a circle", circle, 3, ownership, [&](std::size_t i, const Point&, int frame) {
      return frame == 2 && i == 5 ? Point(1, 1) : circle[i];
    });
    run("points that coincide with those of other ranks", pairs, 4, ownership,
        [&](std::size_t i, const Point&, int frame) {
          return i % 3 == 0 && frame % 2 ? Point(pairs[i].x() + 0.25, pairs[i].y()) : pairs[i];
        });
    run("points on a line that coincide", line, 2, ownership, at_rest);
    run("a point that leaves the line", Points(line.begin(), line.begin() + 40), 3, ownership,
        [&](std::size_t i, const Point&, int frame) {
          return i == 39 && frame == 1 ? Point(3, 4.5) : line[i];
        });
    run("points that all meet", Points(grid.begin(), grid.begin() + 30), 3, ownership,
        [&](std::size_t i, const Point&, int frame) { return frame == 2 ? Point(1, 1) : grid[i]; });
    for (std::size_t n = 0; n <= 10; ++n)
      run(std::to_string(n) + " points", Points(pairs.begin(), pairs.begin() + long(n)), 2,
          ownership, [&](std::size_t i, const Point& p, int frame) {
            return frame == 1 && i == 2 ? Point(0, 0) : p;
          });
  }
  run("a grid of one rank", grid, 2, {on_first, no_balance}, at_rest);
}

const Theme theme("distributed_degeneracies", run_theme);

} // namespace distributed_degeneracies

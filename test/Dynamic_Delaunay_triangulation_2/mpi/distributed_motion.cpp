// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Run by several ranks: the union of their edges is the triangulation of all points, in each frame.

#include "distributed_oracle.h"

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <random>
#include <utility>

void refuse_bad_input()
{
  const Population points =
      numbered({{0, 0}, {1, 0}, {0, 1}, {1, 1.5}, {2, 3}, {3, 1}, {4, 2}, {5, 5}});
  const auto own = own_part(points, in_order);
  Distributed dt(MPI_COMM_WORLD, own.begin(), own.end());
  Points next = own_positions(dt, points);
  const bool is_bad = !next.empty() && dt.owned_ids()[0] == 0;
  if (is_bad)
    next[0] = Point(std::numeric_limits<double>::quiet_NaN(), 0);
  bool is_refused = false;
  try {
    dt.update(next.begin(), next.end());
  } catch (const CGAL::Non_finite_coordinate_error_2&) {
    is_refused = is_bad;
  } catch (const CGAL::Distributed_input_error_2&) {
    is_refused = !is_bad;
  }
  expect(is_refused, "NaN on one rank is refused on all ranks");
  expect_exact(dt, points, "after a refusal");
}

int main(int argc, char** argv)
{
  start(argc, argv);
  const char* const wanted = std::getenv("DYNAMIC_DELAUNAY_DISTRIBUTED_FRAMES");
  const int frames = wanted ? std::atoi(wanted) : 20;

  std::mt19937 random(7); // the same on all ranks
  std::uniform_real_distribution<double> coordinate(0, 20);
  std::normal_distribution<double> step(0, 0.05);
  Points cloud;
  for (int i = 0; i < 400; ++i)
    cloud.push_back(Point(coordinate(random), coordinate(random)));
  std::sort(cloud.begin(), cloud.end());
  for (const double load_factor : {no_balance, Distributed::default_load_factor}) {
    run(
        "Brownian motion", cloud, frames,
        [&](std::size_t, const Point& p, int) {
          return Point(p.x() + step(random), p.y() + step(random));
        },
        in_order, load_factor);
    run(
        "jumps", cloud, frames,
        [&](std::size_t, const Point& p, int) {
          return random() % 20 ? p : Point(coordinate(random), coordinate(random));
        },
        in_order, load_factor);
    run(
        "an explosion", cloud, frames,
        [](std::size_t, const Point& p, int) {
          return Point(10 + 1.1 * (p.x() - 10), 10 + 1.1 * (p.y() - 10));
        },
        in_order, load_factor);
  }
  run("a rank that owns all", cloud, 2, at_rest, on_first, no_balance);
  run("points in turn", cloud, 2, at_rest, in_turn, no_balance);
  refuse_bad_input();
  MPI_Finalize();
}

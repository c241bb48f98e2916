// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Soft disks in a periodic cell that is sheared further and further. Neighbors that overlap push
// each other apart. Counts how many pairs of neighbors change while the strain grows by one.

#include <CGAL/Dynamic_periodic_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iostream>
#include <random>
#include <set>
#include <utility>
#include <vector>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_2;
using Vector = Kernel::Vector_2;
using Dynamic = CGAL::Dynamic_periodic_Delaunay_triangulation_2<Kernel>;
using Shift = CGAL::Periodic_shift_2;
using Pairs = std::set<std::pair<std::size_t, std::size_t>>;

Pairs neighbor_pairs(const Dynamic& dt)
{
  Pairs pairs;
  dt.for_each_edge([&](std::size_t i, std::size_t j, const Shift&) {
    pairs.insert(std::minmax(i, j)); // the shift says through which sides of the cell
  });
  return pairs;
}

// The forces of disks with diameter 1: springs between neighbors that are closer.
std::vector<Vector> forces(const Dynamic& dt)
{
  std::vector<Vector> forces(dt.number_of_ids(), Vector(0, 0));
  dt.for_each_edge([&](std::size_t i, std::size_t j, const Shift& shift) {
    const Vector v = dt.vector(i, j, shift);
    const double length = std::sqrt(v.squared_length());
    if (length < 1 && length > 0) {
      const Vector push = v * ((1 - length) / length);
      forces[i] -= push;
      forces[j] += push;
    }
  });
  return forces;
}

int main()
{
  constexpr std::size_t number = 400;
  constexpr double side = 19, strain_of_step = 0.01;
  std::mt19937 random(1);
  std::uniform_real_distribution<double> coordinate(0, side);
  std::vector<Point> disks;
  for (std::size_t i = 0; i < number; ++i) {
    const double x = coordinate(random);
    disks.push_back(Point(x, coordinate(random)));
  }

  Dynamic dt(disks, CGAL::Periodic_cell_2(side, side));
  double skew = 0;
  std::size_t changes = 0, rebuilds = 0;
  Pairs pairs = neighbor_pairs(dt);
  for (int step = 1; step <= 500; ++step) {
    const std::vector<Vector> push = forces(dt);
    for (std::size_t i = 0; i < number; ++i) {
      const Point p = disks[i] + 0.25 * push[i];
      disks[i] = Point(p.x() + strain_of_step * p.y(), p.y());
    }
    skew += strain_of_step * side;
    if (skew > side / 2)
      skew -= side; // the same lattice with less skew vectors, as Lees and Edwards have it
    rebuilds += dt.update(disks, CGAL::Periodic_cell_2(side, 0, skew, side)).rebuilt();

    const Pairs now = neighbor_pairs(dt);
    for (const auto& pair : now)
      changes += pairs.count(pair) == 0;
    pairs = now;
    if (step % 100 == 0) {
      std::cout << "strain " << step * strain_of_step << ": " << changes
                << " new pairs of neighbors, " << rebuilds << " rebuilds\n";
      changes = 0;
    }
  }
  return dt.is_certified() && rebuilds == 0 ? 0 : 1;
}

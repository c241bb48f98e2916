// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Soft discs of diameter 1 in a channel, which is periodic along x and has walls at y = 0 and y =
// 10; those in the middle are pushed along.

#include <CGAL/Dynamic_periodic_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iostream>
#include <random>
#include <vector>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

int main()
{
  std::mt19937 random(1);
  std::uniform_real_distribution<double> jitter(-0.05, 0.05);
  std::vector<Kernel::Point_2> discs;
  for (int i = 0; i < 400; ++i) {
    const double x = 1.1 * (i / 10) + jitter(random);
    discs.emplace_back(x, 0.5 + i % 10 + jitter(random));
  }
  std::vector<Kernel::Vector_2> speeds(discs.size(), Kernel::Vector_2(0, 0)), forces = speeds;
  CGAL::Dynamic_periodic_Delaunay_triangulation_2<Kernel> dt(discs,
                                                             CGAL::Periodic_cell_2::slab(44, 0));
  double flow = 0, nearest = 1; // masses and stiffness are 1
  bool is_right = true;
  for (int frame = 0; frame < 4000; ++frame) {
    for (std::size_t i = 0; i < discs.size(); ++i) {
      const double y = discs[i].y();
      const double from_walls = (std::max)(0.5 - y, 0.0) - (std::max)(y - 9.5, 0.0);
      forces[i] = Kernel::Vector_2(3 < y && y < 7 ? 0.01 : 0, from_walls) - 0.05 * speeds[i];
    }
    //! [forces]
    dt.for_each_edge([&](std::size_t i, std::size_t j, const CGAL::Periodic_shift_2& shift) {
      const Kernel::Vector_2 way = dt.vector(i, j, shift); // to the image that is the neighbor
      const double distance = std::sqrt(way.squared_length());
      nearest = (std::min)(nearest, distance);
      const Kernel::Vector_2 push = (std::max)(1 / distance - 1, 0.0) * way;
      forces[i] -= push;
      forces[j] += push;
    });
    //! [forces]
    flow = 0;
    for (std::size_t i = 0; i < discs.size(); ++i) {
      speeds[i] += 0.1 * forces[i];
      discs[i] += 0.1 * speeds[i]; // never wrapped, so that ways add up
      flow += speeds[i].x() / double(discs.size());
    }
    is_right = dt.update(discs).certified && is_right;
  }
  std::cout << "mean speed " << flow << ", none nearer than " << nearest << '\n';
  return is_right && flow > 0 && nearest < 1 && nearest > std::sqrt(0.5) ? 0 : 1;
}

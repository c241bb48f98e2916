// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// A glass of particles in a periodic cell that is sheared, as simulations of molecules do it, and
// the neighbors that particles lose and find.

#include <CGAL/Dynamic_periodic_Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <cstddef>
#include <iostream>
#include <iterator>
#include <random>
#include <set>
#include <utility>
#include <vector>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Vector = Kernel::Vector_3;
using Glass = CGAL::Dynamic_periodic_Delaunay_triangulation_3<Kernel>;
using Pairs = std::set<std::pair<std::size_t, std::size_t>>;

constexpr int edge = 10; // particles, at distance 1

// The cell at a strain. It is flipped where that is shorter: the same lattice, by another vector.
CGAL::Periodic_cell_3 cell_at(double strain)
{
  const double turn = strain > 0.5 ? strain - 1 : strain;
  return CGAL::Periodic_cell_3(Vector(edge, 0, 0), Vector(0, edge, 0),
                               Vector(turn * edge, 0, edge));
}

Pairs neighbors(const Glass& glass)
{
  Pairs pairs;
  glass.for_each_edge([&](std::size_t i, std::size_t j, const CGAL::Periodic_shift_3&) {
    pairs.insert(std::minmax(i, j));
  });
  return pairs;
}

std::size_t number_without(const Pairs& pairs, const Pairs& others)
{
  Pairs rest;
  std::set_difference(pairs.begin(), pairs.end(), others.begin(), others.end(),
                      std::inserter(rest, rest.begin()));
  return rest.size();
}

int main()
{
  std::mt19937 random(1);
  std::normal_distribution<double> jitter(0, 0.15), step(0, 0.002);
  std::vector<Point> points;
  for (int i = 0; i < edge * edge * edge; ++i) {
    const double x = i % edge + jitter(random), y = i / edge % edge + jitter(random);
    points.emplace_back(x, y, i / edge / edge + jitter(random));
  }

  Glass glass(points, cell_at(0));
  Pairs before = neighbors(glass);
  constexpr double strain_of_frame = 0.005;
  for (int frame = 1; frame <= 120; ++frame) {
    for (Point& p : points) {
      const double x = p.x() + strain_of_frame * p.z() + step(random), y = p.y() + step(random);
      p = Point(x, y, p.z() + step(random));
    }
    glass.update(points, cell_at(strain_of_frame * frame));
    if (frame % 20 == 0) {
      const Pairs now = neighbors(glass);
      std::cout << "strain " << strain_of_frame * frame << ": " << now.size() << " pairs, "
                << number_without(before, now) << " parted and " << number_without(now, before)
                << " met in 20 frames\n";
      before = now;
    }
  }

  // where the image of a neighbor is
  glass.for_each_neighbor(7, [&](std::size_t j, const CGAL::Periodic_shift_3& shift) {
    if (shift != CGAL::Periodic_shift_3{0, 0, 0})
      std::cout << "particle 7 has an image of " << j << " at the vector "
                << glass.vector(7, j, shift) << '\n';
  });
  return glass.is_certified() && glass.is_valid() ? 0 : 1;
}

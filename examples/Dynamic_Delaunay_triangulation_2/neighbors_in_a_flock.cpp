// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Birds that start in all directions take the mean heading of their Delaunay neighbors, turn away
// from whoever is too close, and become a flock.

#include <CGAL/Dynamic_Delaunay_triangulation_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/queries/Delaunay_neighbor_lists_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/queries/Delaunay_point_queries_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iostream>
#include <iterator>
#include <random>
#include <vector>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_2;
using Vector = Kernel::Vector_2;
using Dynamic = CGAL::Dynamic_Delaunay_triangulation_2<Kernel>;

Vector unit(const Vector& v)
{
  return v / std::sqrt(v.squared_length());
}

int main()
{
  std::mt19937 random(1);
  std::uniform_real_distribution<double> coordinate(0, 20), noise(-0.2, 0.2);
  std::vector<Point> birds;
  std::vector<Vector> headings;
  for (int i = 0; i < 400; ++i) {
    const double x = coordinate(random), angle = coordinate(random);
    birds.push_back(Point(x, coordinate(random)));
    headings.push_back(Vector(std::cos(angle), std::sin(angle)));
  }

  Dynamic dt(birds.begin(), birds.end());
  CGAL::Delaunay_neighbor_lists_2 lists;
  CGAL::Delaunay_point_queries_2<Dynamic> queries(dt);
  std::vector<std::size_t> close;
  for (int frame = 0; frame < 200; ++frame) {
    lists.compute(dt); // keeps its memory
    std::vector<Vector> next;
    for (std::size_t i = 0; i < birds.size(); ++i) {
      Vector wish = headings[i] + Vector(noise(random), noise(random));
      for (const std::size_t j : lists.neighbors(i))
        wish += headings[j];
      close.clear();
      queries.neighbors_within(i, 0.5 * 0.5, std::back_inserter(close)); // a squared radius
      for (const std::size_t j : close)
        wish += birds[i] - birds[j];
      next.push_back(unit(wish));
    }
    headings = next;
    for (std::size_t i = 0; i < birds.size(); ++i)
      birds[i] += 0.05 * headings[i];
    dt.update(birds.begin(), birds.end());
  }

  // whoever is nearest to a bird is a neighbor
  lists.compute(dt);
  bool are_right = true;
  Vector sum(0, 0);
  for (std::size_t i = 0; i < birds.size(); ++i) {
    const auto list = lists.neighbors(i);
    const auto nearest = queries.nearest_neighbor(i);
    are_right = are_right && nearest && std::count(list.begin(), list.end(), *nearest) == 1;
    sum += headings[i];
  }
  const double order = std::sqrt(sum.squared_length()) / double(birds.size());
  std::cout << lists.neighbors().size() / 2 << " pairs of neighbors; the birds fly as one to "
            << int(100 * order) << " %\n";
  return are_right && order > 0.9 ? 0 : 1;
}

// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The loop of a game: a dog runs to the nearest sheep, those around it run away, one that is caught
// leaves, and others come.

#include <CGAL/Dynamic_Delaunay_triangulation_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/queries/Delaunay_point_queries_2.h>
#include <CGAL/Dynamic_population_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iostream>
#include <iterator>
#include <map>
#include <random>
#include <vector>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Dynamic = CGAL::Dynamic_Delaunay_triangulation_2<Kernel>;

int main()
{
  std::mt19937 random(1);
  std::uniform_real_distribution<double> coordinate(0, 50);
  std::map<int, Kernel::Point_2> sheep; // by the game's own numbers
  Kernel::Point_2 dog(25, 25);
  CGAL::Dynamic_population_2<Dynamic, int> flock;
  const CGAL::Delaunay_point_queries_2<Dynamic> queries(flock.triangulation());
  int came = 0;
  bool is_right = true;
  for (int tick = 0; tick < 3000; ++tick) {
    while (sheep.size() < 500) {
      const double x = coordinate(random);
      sheep.emplace(came++, Kernel::Point_2(x, coordinate(random)));
    }
    //! [tick]
    is_right = flock.update(sheep).certified && is_right; // who came, left and moved, in one call
    const int nearest = flock.user_id(*queries.nearest(dog));
    std::vector<std::size_t> frightened;
    queries.within(dog, 9, std::back_inserter(frightened)); // a squared radius
    //! [tick]
    const auto way_to = [&](int number) {
      const Kernel::Vector_2 way = sheep.at(number) - dog;
      return way / (std::max)(std::sqrt(way.squared_length()), 0.1);
    };
    for (const std::size_t id : frightened)
      sheep.at(flock.user_id(id)) += 0.05 * way_to(flock.user_id(id));
    dog += 0.1 * way_to(nearest);
    if (CGAL::squared_distance(dog, sheep.at(nearest)) < 0.04)
      sheep.erase(nearest);
  }
  std::cout << came - 500 << " of " << came << " sheep were caught\n";
  return is_right && came > 500 ? 0 : 1;
}

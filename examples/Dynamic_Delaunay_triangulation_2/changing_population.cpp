// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// People walk through a square: some come, some leave, and a camera names those whom it sees by
// numbers of its own. Every frame is given whole; the population finds out what has changed.

#include <CGAL/Dynamic_Delaunay_triangulation_2.h>
#include <CGAL/Dynamic_population_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <cstddef>
#include <iostream>
#include <iterator>
#include <map>
#include <random>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_2;
using Dynamic = CGAL::Dynamic_Delaunay_triangulation_2<Kernel>;

int main()
{
  std::mt19937 random(1);
  std::uniform_real_distribution<double> coordinate(0, 20), chance(0, 1);
  std::map<int, Point> people;
  int next_number = 1'000;
  for (int i = 0; i < 300; ++i) {
    const double x = coordinate(random);
    people.emplace(next_number++, Point(x, coordinate(random)));
  }

  CGAL::Dynamic_population_2<Dynamic, int> population;
  CGAL::Update_report_2 total;
  for (int frame = 0; frame < 200; ++frame) {
    for (auto person = people.begin(); person != people.end();) {
      Point& p = person->second;
      p = Point(p.x() + 0.05, p.y() + 0.02 * (chance(random) - 0.5));
      person = p.x() > 20 ? people.erase(person) : std::next(person); // has left
    }
    while (people.size() < 300)
      people.emplace(next_number++, Point(0, coordinate(random)));
    total += population.update(people.begin(), people.end());
  }

  // the point nearest to another one is its neighbor in the triangulation
  const int number = people.begin()->first;
  const auto& triangulation = population.triangulation().triangulation();
  std::size_t neighbors = 0;
  auto neighbor = triangulation.incident_vertices(population.vertex(number));
  const auto first = neighbor;
  do {
    if (!triangulation.is_infinite(neighbor)) {
      ++neighbors;
      std::cout << population.user_id(neighbor) << ' ';
    }
  } while (++neighbor != first);
  std::cout << "are around " << number << "; in 200 frames " << total.inserted << " came and "
            << total.removed << " left\n";
  return neighbors > 1 && population.size() == people.size() && total.certified ? 0 : 1;
}

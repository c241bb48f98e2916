// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// People in a hall walk to the door, and leave. How dense it is where somebody stands is one over
// the area of the Voronoi cell in the hall (Steffen, Seyfried: Methods for measuring pedestrian
// density, flow, speed and direction with minimal scatter, Physica A 389, 2010).

#include <CGAL/Dynamic_Delaunay_triangulation_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/queries/Delaunay_point_queries_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/queries/Voronoi_cell_measures_2.h>
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
using Point = Kernel::Point_2;
using Dynamic = CGAL::Dynamic_Delaunay_triangulation_2<Kernel>;

int main()
{
  const CGAL::Bbox_2 hall(0, 0, 20, 10); // in meters
  const Point door(20, 5);
  std::mt19937 random(1);
  std::uniform_real_distribution<double> coordinate(0, 1);
  std::map<int, Point> people; // by numbers that a camera gave them
  for (int i = 0; i < 200; ++i) {
    const double x = i % 20 + coordinate(random);
    people.emplace(500 + i, Point(x, i / 20 + coordinate(random))); // one to a square meter
  }

  CGAL::Dynamic_population_2<Dynamic, int> population;
  CGAL::Delaunay_point_queries_2<Dynamic> queries(population.triangulation());
  CGAL::Voronoi_cell_measures_2 cells;
  std::vector<std::size_t> close;
  double largest_density = 0, largest_error = 0;
  for (int frame = 0; frame < 200; ++frame) {
    population.update(people.begin(), people.end());
    cells.compute(population.triangulation(), hall);
    double whole_area = 0;
    for (auto person = people.begin(); person != people.end();) {
      auto& [number, p] = *person;
      const std::size_t id = population.id(number);
      const double area = cells.areas()[id]; // in square meters
      whole_area += area;
      largest_density = (std::max)(largest_density, 1 / area);

      // nobody steps on somebody who is nearer to the door
      close.clear();
      queries.neighbors_within(id, 0.5 * 0.5, std::back_inserter(close)); // a squared radius
      const double squared_distance = CGAL::squared_distance(p, door);
      const bool waits = std::any_of(close.begin(), close.end(), [&](std::size_t other) {
        const Point& q = population.triangulation().point(other);
        return CGAL::squared_distance(q, door) < squared_distance;
      });
      if (!waits)
        p += 0.1 / std::sqrt(squared_distance) * (door - p);
      person = squared_distance < 0.25 ? people.erase(person) : std::next(person);
    }
    largest_error = (std::max)(largest_error, std::abs(whole_area - 200));
  }
  std::cout << people.size() << " of 200 are still there; there were up to " << largest_density
            << " to a square meter\n";
  return people.size() < 200 && largest_density > 2 && largest_error < 1e-9 ? 0 : 1;
}

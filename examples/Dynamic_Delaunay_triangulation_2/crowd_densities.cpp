// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// People leave through a bottleneck between two walls. The density where a person stands is one
// over the area of the Voronoi cell (Steffen, Seyfried: Methods for measuring pedestrian density,
// flow, speed and direction with minimal scatter, Physica A 389, 2010), or more precisely of the
// part that the person can walk to without leaving the cell, and that is within a meter.
//
// crowd_densities [FILE.csv], a recording with the columns frame,time,id,x,y. Without it people are
// simulated. The walls are those of the experiment of the bottleneck in the data of PedPy
// (https://github.com/PedestrianDynamics/PedPy, notebooks/user_guide.ipynb), in meters.

#include <CGAL/Dynamic_Delaunay_triangulation_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/queries/Delaunay_point_queries_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/queries/Voronoi_cells_in_domain_2.h>
#include <CGAL/Dynamic_population_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_2.h>
#include <CGAL/Polygon_with_holes_2.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <exception>
#include <fstream>
#include <iostream>
#include <iterator>
#include <map>
#include <random>
#include <string>
#include <vector>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_2;
using Dynamic = CGAL::Dynamic_Delaunay_triangulation_2<Kernel>;
using Population = CGAL::Dynamic_population_2<Dynamic, int>;
using Cells = CGAL::Voronoi_cells_in_domain_2;
using People = std::map<int, Point>; // by numbers that a camera gave them

CGAL::Polygon_with_holes_2<Kernel> place()
{
  using Polygon = CGAL::Polygon_2<Kernel>;
  const std::vector<Point> all{Point(-3.5, -2), Point(3.5, -2), Point(3.5, 8), Point(-3.5, 8)};
  CGAL::Polygon_with_holes_2<Kernel> place(Polygon(all.begin(), all.end()));
  for (const double side : {-1, 1}) {
    Polygon wall;
    for (const Point& p :
         {Point(0.25, -1.1), Point(0.7, -1.1), Point(0.7, -0.3), Point(3.05, -0.3),
          Point(3.05, 6.7), Point(2.8, 6.7), Point(2.8, 0), Point(0.4, 0), Point(0.25, -0.15)})
      wall.push_back(Point(side * p.x(), p.y()));
    place.add_hole(wall);
  }
  return place;
}

class Crowd_densities
{
public:
  void add(const People& people)
  {
    m_population.update(people.begin(), people.end());
    m_cells.compute(m_population.triangulation(), 1);
    for (const auto& [number, p] : people)
      if (std::abs(p.x()) < 1 && p.y() > 0 && p.y() < 2) { // before the bottleneck
        const double area = m_cells.areas()[m_population.id(number)];
        if (area == 0)
          continue; // in a wall
        m_sum += 1 / area;
        m_most = (std::max)(m_most, 1 / area);
        ++m_count;
      }
  }
  const Population& population() const { return m_population; }
  double mean() const { return m_sum / m_count; }
  double most() const { return m_most; }

private:
  Population m_population{};
  Cells m_cells{place(), Cells::Rule::CONNECTED};
  double m_sum = 0, m_most = 0, m_count = 0;
};

void follow_recording(std::ifstream& file, Crowd_densities& densities)
{
  std::string header;
  std::getline(file, header);
  People people;
  int frame, last_frame = 0, number;
  double time, x, y;
  char comma;
  while (file >> frame >> comma >> time >> comma >> number >> comma >> x >> comma >> y) {
    if (frame != last_frame) {
      densities.add(people);
      people.clear();
      last_frame = frame;
    }
    people.emplace(number, Point(x, y));
  }
  densities.add(people);
}

// They walk to the bottleneck, and through it. Nobody steps on somebody who is nearer to it.
void simulate(Crowd_densities& densities)
{
  const Point before(0, 0.2), behind(0, -2);
  std::mt19937 random(1);
  std::uniform_real_distribution<double> noise(-0.1, 0.1);
  People people;
  for (int i = 0; i < 70; ++i) {
    const double x = i % 7 - 3;
    people.emplace(500 + i, Point(0.8 * x + noise(random), 1 + 0.5 * (i / 7) + noise(random)));
  }
  std::vector<std::size_t> close;
  for (int frame = 0; frame < 600; ++frame) {
    densities.add(people);
    const Dynamic& dt = densities.population().triangulation();
    const CGAL::Delaunay_point_queries_2<Dynamic> queries(dt);
    for (auto person = people.begin(); person != people.end();) {
      auto& [number, p] = *person;
      const bool is_before = p.y() > 0.25;
      const Point& aim = is_before ? before : behind;
      const double squared_distance = CGAL::squared_distance(p, before);
      close.clear();
      queries.neighbors_within(densities.population().id(number), 0.3 * 0.3,
                               std::back_inserter(close));
      const bool waits = is_before && std::any_of(close.begin(), close.end(), [&](std::size_t i) {
                           return CGAL::squared_distance(dt.point(i), before) < squared_distance;
                         });
      if (!waits)
        p += 0.05 / std::sqrt(CGAL::squared_distance(p, aim)) * (aim - p);
      person = p.y() < -1.9 ? people.erase(person) : std::next(person);
    }
  }
}

int main(int argc, char** argv)
{
  Crowd_densities densities;
  try {
    if (argc > 1) {
      std::ifstream file(argv[1]);
      follow_recording(file, densities);
    } else
      simulate(densities);
  } catch (const std::exception& error) { // for a person without a position, it says which
    std::cerr << error.what() << '\n';
    return 1;
  }
  std::cout << "before the bottleneck there were " << densities.mean()
            << " people to a square meter in the mean, and up to " << densities.most() << '\n';
  return densities.population().size() < 70 && densities.mean() > 1 ? 0 : 1;
}

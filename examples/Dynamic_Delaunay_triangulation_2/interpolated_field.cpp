// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Particles of a whirl, which turns the faster the nearer to its middle, carry a temperature along.
// A grid that stays where it is samples it after each frame, by natural neighbors.

#include <CGAL/Dynamic_Delaunay_triangulation_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/queries/Interpolation_weights_2.h>
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

// Where the whirl has taken a point after some time.
Point moved(const Point& p, double time)
{
  const double angle = time * std::exp(-(p.x() * p.x() + p.y() * p.y()) / 8);
  const double s = std::sin(angle), c = std::cos(angle);
  return Point(c * p.x() - s * p.y(), s * p.x() + c * p.y());
}

double temperature_at_begin(const Point& p)
{
  return std::tanh(p.y());
}

int main()
{
  std::mt19937 random(1);
  std::uniform_real_distribution<double> coordinate(-6, 6);
  std::vector<Point> begin;
  std::vector<double> temperatures;
  for (int i = 0; i < 5000; ++i) {
    const double x = coordinate(random);
    begin.push_back(Point(x, coordinate(random)));
    temperatures.push_back(temperature_at_begin(begin.back()));
  }
  std::vector<Point> grid;
  for (int row = 12; row >= -12; --row)
    for (int column = -20; column <= 20; ++column)
      grid.push_back(Point(0.2 * column, 0.3 * row));

  CGAL::Dynamic_Delaunay_triangulation_2<Kernel> dt(begin.begin(), begin.end());
  CGAL::Interpolation_weights_2 weights;
  double largest_error = 0;
  std::vector<double> samples;
  for (double time = 0; time < 3; time += 0.1) {
    std::vector<Point> points;
    for (const Point& p : begin)
      points.push_back(moved(p, time));
    dt.update(points.begin(), points.end());
    weights.compute_natural_neighbor(dt, grid.begin(), grid.end());
    samples.clear();
    weights.interpolate(temperatures.begin(), std::back_inserter(samples), 0); // 0 outside
    for (std::size_t i = 0; i < grid.size(); ++i) {
      const double truth = temperature_at_begin(moved(grid[i], -time)); // distances do not change
      largest_error = (std::max)(largest_error, std::abs(samples[i] - truth));
    }
  }

  for (std::size_t i = 0; i < grid.size(); ++i)
    std::cout << "-+"[samples[i] > 0] << (i % 41 == 40 ? "\n" : "");
  std::cout << "no sample is off by more than " << largest_error << "\n";
  return largest_error < 0.1 ? 0 : 1;
}

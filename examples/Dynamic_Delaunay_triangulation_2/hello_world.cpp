// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// A cloud of points takes a hundred small steps; its Delaunay triangulation follows.

#include <CGAL/Dynamic_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <cstddef>
#include <iostream>
#include <random>
#include <vector>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_2;

int main()
{
  std::mt19937 random(1);
  std::uniform_real_distribution<double> coordinate(0, 30);
  std::normal_distribution<double> step(0, 0.01);

  std::vector<Point> points;
  for (int i = 0; i < 900; ++i)
    points.push_back(Point(coordinate(random), coordinate(random)));

  CGAL::Dynamic_Delaunay_triangulation_2<Kernel> dt(points.begin(), points.end());

  std::size_t flips = 0;
  for (int frame = 0; frame < 100; ++frame) {
    for (Point& p : points)
      p = Point(p.x() + step(random), p.y() + step(random));
    flips += dt.update(points.begin(), points.end()).flips; // point i is where points[i] says
  }

  // any query of CGAL's own triangulation
  const auto nearest = dt.triangulation().nearest_vertex(Point(15, 15));
  std::cout << dt.number_of_points() << " points, " << flips << " edges flipped in 100 frames, "
            << (dt.is_certified() ? "certified" : "not certified") << ", point " << dt.id(nearest)
            << " is nearest to the middle\n";
  return dt.is_certified() ? 0 : 1;
}

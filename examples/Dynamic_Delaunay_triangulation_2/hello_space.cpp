// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Particles in space that move at random, and the neighbors of one of them.

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/convert_to_delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>

#include <cstddef>
#include <iostream>
#include <random>
#include <vector>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Vertex_base = CGAL::Triangulation_vertex_base_with_info_3<std::size_t, Kernel>;
using Triangulation =
    CGAL::Delaunay_triangulation_3<Kernel, CGAL::Triangulation_data_structure_3<Vertex_base>>;

int main()
{
  std::mt19937 random(1);
  std::uniform_real_distribution<double> coordinate(0, 10);
  std::normal_distribution<double> step(0, 0.01);
  std::vector<Point> points;
  for (int i = 0; i < 1000; ++i) {
    const double x = coordinate(random), y = coordinate(random);
    points.emplace_back(x, y, coordinate(random));
  }

  CGAL::Dynamic_Delaunay_triangulation_3<Kernel> dt(points);
  std::size_t flips = 0;
  for (int frame = 0; frame < 100; ++frame) {
    for (Point& p : points) {
      const double x = p.x() + step(random), y = p.y() + step(random);
      p = Point(x, y, p.z() + step(random));
    }
    flips += dt.update(points).flips; // point i is where points[i] says
  }
  std::size_t neighbors = 0;
  dt.for_each_neighbor(7, [&](std::size_t) { ++neighbors; });
  std::cout << dt.number_of_cells() << " cells after " << flips << " flips in 100 frames, "
            << (dt.is_certified() ? "certified" : "not certified") << "; point 7 has " << neighbors
            << " neighbors\n";

  // a copy for all that CGAL can do
  Triangulation copy;
  CGAL::convert_to_delaunay_triangulation_3(dt, copy);
  const auto nearest = copy.nearest_vertex(Point(5, 5, 5));
  std::cout << "point " << nearest->info() << " is nearest to the middle\n";
  return dt.is_certified() && copy.is_valid() ? 0 : 1;
}

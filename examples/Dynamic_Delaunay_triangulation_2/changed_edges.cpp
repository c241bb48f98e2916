// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Which edges have come and gone in a frame: a network of springs between neighbors follows the
// triangulation. The rest length of each spring is the length with which it was made.

#include <CGAL/Dynamic_Delaunay_triangulation_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/visitors/Edge_changes_visitor_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <cmath>
#include <cstddef>
#include <iostream>
#include <map>
#include <random>
#include <vector>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_2;
//! [options]
using Dynamic_triangulation =
    CGAL::Dynamic_Delaunay_triangulation_2<Kernel, CGAL::Default,
                                           CGAL::With_visitor_2<CGAL::Edge_changes_visitor_2>>;
//! [options]

int main()
{
  std::mt19937 random(1);
  std::uniform_real_distribution<double> coordinate(0, 20);
  std::normal_distribution<double> step(0, 0.01);
  std::vector<Point> points;
  for (int i = 0; i < 400; ++i)
    points.push_back(Point(coordinate(random), coordinate(random)));

  //! [changes]
  std::map<CGAL::Edge_changes_visitor_2::Edge, double> springs;
  std::size_t created = 0, removed = 0;
  const auto follow = [&](Dynamic_triangulation& dt) {
    for (const auto& edge : dt.visitor().removed_edges())
      removed += springs.erase(edge);
    for (const auto& [i, j] : dt.visitor().created_edges())
      springs[{i, j}] = std::sqrt(CGAL::squared_distance(points[i], points[j]));
    created += dt.visitor().created_edges().size();
    dt.visitor().clear();
  };
  //! [changes]

  Dynamic_triangulation dt(points.begin(), points.end());
  follow(dt); // all edges are new
  for (int frame = 0; frame < 100; ++frame) {
    for (Point& p : points)
      p = Point(p.x() + step(random), p.y() + step(random));
    dt.update(points.begin(), points.end());
    follow(dt);
  }

  std::size_t edges = 0;
  dt.for_each_edge([&](std::size_t, std::size_t) { ++edges; });
  std::cout << created << " springs made, " << removed << " removed, " << springs.size()
            << " left for " << edges << " edges\n";
  return springs.size() == edges ? 0 : 1;
}

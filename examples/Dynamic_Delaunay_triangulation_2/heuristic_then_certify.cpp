// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// A heuristic classifier saves work and may miss something. The object knows, says so, and is made
// exact when that is wanted.

#include <CGAL/Dynamic_Delaunay_triangulation_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/classifiers/Point_distance_classifier_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <cstddef>
#include <iostream>
#include <random>
#include <vector>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_2;
using Classifier = CGAL::Point_distance_classifier_2;

int main()
{
  std::mt19937 random(1);
  std::uniform_real_distribution<double> coordinate(0, 30);
  std::normal_distribution<double> step(0, 0.005);
  std::vector<Point> points;
  for (int i = 0; i < 900; ++i)
    points.push_back(Point(coordinate(random), coordinate(random)));

  CGAL::Dynamic_Delaunay_triangulation_2<Kernel, Classifier> dt(points.begin(), points.end(),
                                                                Classifier(0.7));
  for (int frame = 0; frame < 30; ++frame) {
    for (Point& p : points)
      p = Point(p.x() + step(random), p.y() + step(random));
    dt.update(points.begin(), points.end());
  }

  // neighbors can be read at any time: the topology is valid, if not Delaunay everywhere
  std::size_t edges = 0;
  dt.for_each_edge([&edges](std::size_t, std::size_t) { ++edges; });
  std::cout << edges << " edges, " << (dt.is_certified() ? "certified" : "not certified") << "\n";

  //! [certainty]
  // CGAL's queries cannot: they need a Delaunay triangulation
  try {
    dt.triangulation();
  } catch (const CGAL::Uncertified_triangulation_error_2& error) {
    std::cout << "refused: " << error.what() << "\n";
  }

  const bool was_delaunay = dt.certify();
  const auto report = dt.mend();
  //! [certainty]
  std::cout << "it was " << (was_delaunay ? "" : "not ") << "Delaunay; mending took "
            << report.flips << " flips and " << report.splices << " splices; now "
            << (dt.is_certified() ? "certified" : "not certified") << "\n";
  return dt.is_certified() && dt.is_valid(true) ? 0 : 1;
}

// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// An exact classifier of one's own: a fast pass proves nearly all edges Delaunay, exact predicates
// decide about the others. It costs what the package's own one does where everything moves.

#include <CGAL/Dynamic_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <cstddef>
#include <iostream>
#include <random>
#include <vector>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_2;

//! [classifier]
struct All_edges_classifier
{
  static constexpr bool is_exact = true; // it misses no broken edge

  template <class Frame, class Classification>
  void operator()(const Frame& frame, Classification& classified)
  {
    unproved.clear();
    frame.append_unproved(0, frame.number_of_edges(), unproved);
    classified.add_unless_delaunay(frame, unproved);
  }

  std::vector<CGAL::Dynamic_Delaunay_triangulations_2::Edge_index> unproved;
};
//! [classifier]

int main()
{
  std::mt19937 random(1);
  std::uniform_real_distribution<double> coordinate(0, 30);
  std::normal_distribution<double> step(0, 0.05);
  std::vector<Point> points;
  for (int i = 0; i < 900; ++i) {
    const double x = coordinate(random);
    points.push_back(Point(x, coordinate(random)));
  }

  CGAL::Dynamic_Delaunay_triangulation_2<Kernel, All_edges_classifier> dt(points.begin(),
                                                                          points.end());
  std::size_t flips = 0, certified = 0;
  for (int frame = 0; frame < 50; ++frame) {
    for (Point& p : points) {
      const double x = p.x() + step(random);
      p = Point(x, p.y() + step(random));
    }
    const auto report = dt.update(points.begin(), points.end());
    flips += report.flips;
    certified += report.certified;
  }
  std::cout << flips / 50 << " flips a frame, " << certified << " of 50 frames certified\n";
  return certified == 50 && dt.is_valid(true) ? 0 : 1;
}

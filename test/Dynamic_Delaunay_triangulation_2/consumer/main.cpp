// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// From here on the first program of README.md. The test `consumer` compares them.

#include <CGAL/Dynamic_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <vector>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

int main()
{
  std::vector<Kernel::Point_2> points = {{0, 0}, {2, 0}, {2, 1}, {0, 1}, {1, 0.4}};
  CGAL::Dynamic_Delaunay_triangulation_2<Kernel> dt(points.begin(), points.end());
  for (int frame = 0; frame < 100; ++frame) {
    points[4] = Kernel::Point_2(1, 0.4 + 0.001 * frame); // points move ...
    dt.update(points.begin(), points.end());             // ... and the triangulation follows
  }
  return dt.triangulation().number_of_faces() == 4 ? 0 : 1; // CGAL's own triangulation, certified
}

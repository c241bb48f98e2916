// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// A ball of particles that swells: how much space each has for itself, its neighbors, and who is
// nearest to a place.

#include <CGAL/Bbox_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/Delaunay_neighbor_lists_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/Delaunay_point_queries_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/Voronoi_cell_measures_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/point_generators_3.h>
#include <CGAL/Random.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iostream>
#include <iterator>
#include <numeric>
#include <random>
#include <vector>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Dynamic = CGAL::Dynamic_Delaunay_triangulation_3<Kernel>;

int main()
{
  CGAL::Random seed(1);
  CGAL::Random_points_in_sphere_3<Point> in_ball(10, seed);
  std::vector<Point> points;
  std::copy_n(in_ball, 2000, std::back_inserter(points));

  Dynamic dt(points);
  CGAL::Voronoi_cell_measures_3 cells;
  CGAL::Delaunay_neighbor_lists_3 lists;
  const CGAL::Bbox_3 box(-15, -15, -15, 15, 15, 15); // cells at the hull end there
  std::mt19937 random(1);
  std::normal_distribution<double> step(0, 0.02);
  double error = 0;
  for (int frame = 0; frame <= 40; ++frame) {
    cells.compute(dt, box);
    const std::vector<double>& volumes = cells.volumes();
    const double sum = std::accumulate(volumes.begin(), volumes.end(), 0.0);
    error = (std::max)(error, std::abs(sum / 27000 - 1));

    if (frame % 20 == 0) {
      const std::size_t middle =
          *CGAL::Delaunay_point_queries_3<Dynamic>(dt).nearest(Point(0, 0, 0));
      double largest = 0;
      for (std::size_t i = cells.offsets()[middle]; i < cells.offsets()[middle + 1]; ++i)
        largest = (std::max)(largest, cells.facet_areas()[i]);
      lists.compute(dt);
      std::cout << "frame " << frame << ": point " << middle << ", in the middle, has a volume of "
                << volumes[middle] << " and " << lists.degree(middle)
                << " neighbors; its largest facet has an area of " << largest << '\n';
    }

    for (Point& p : points) {
      const double x = 1.005 * p.x() + step(random), y = 1.005 * p.y() + step(random);
      p = Point(x, y, 1.005 * p.z() + step(random));
    }
    dt.update(points);
  }
  std::cout << "volumes add up to that of the box, but for "
            << (error < 1e-12 ? "rounding" : "an error") << '\n';
  return error < 1e-12 ? 0 : 1;
}

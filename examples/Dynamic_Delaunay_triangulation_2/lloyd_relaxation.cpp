// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Lloyd's relaxation: again and again, every point of a square moves to the centroid of its Voronoi
// cell in the square, until all cells are about alike (Lloyd: Least squares quantization in PCM,
// IEEE Transactions on Information Theory 28, 1982).
//
// lloyd_relaxation [POINTS [ITERATIONS]]

#include <CGAL/Dynamic_Delaunay_triangulation_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/queries/Voronoi_cell_measures_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <random>
#include <vector>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_2;

// The number in a text; 0 if it is no whole number from 1 to 10,000,000.
int whole_number(const char* text)
{
  char* end = nullptr;
  const long number = std::strtol(text, &end, 10);
  return *end == 0 && number >= 1 && number <= 10'000'000 ? int(number) : 0;
}

int main(int argc, char** argv)
{
  const int number = argc > 1 ? whole_number(argv[1]) : 10'000;
  const int iterations = argc > 2 ? whole_number(argv[2]) : 50;
  if (number == 0 || iterations == 0) {
    std::cerr << "lloyd_relaxation [POINTS [ITERATIONS]], whole numbers from 1 to 10000000\n";
    return 1;
  }
  std::mt19937 random(1);
  std::uniform_real_distribution<double> coordinate(0, 1);
  std::vector<Point> points;
  for (int i = 0; i < number; ++i) {
    const double x = coordinate(random);
    points.push_back(Point(x, coordinate(random)));
  }

  CGAL::Dynamic_Delaunay_triangulation_2<Kernel> dt(points.begin(), points.end());
  CGAL::Voronoi_cell_measures_2 cells; // keeps its memory
  const double mean_area = 1.0 / number;
  double first_step = 0, step = 0, spread = 0;
  bool all_certified = true;
  for (int iteration = 1; iteration <= iterations; ++iteration) {
    cells.compute(dt, CGAL::Bbox_2(0, 0, 1, 1));
    double steps = 0, squares = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Point centroid(cells.centroids()[i].x, cells.centroids()[i].y);
      steps += std::sqrt(CGAL::squared_distance(points[i], centroid));
      squares += std::pow(cells.areas()[i] / mean_area - 1, 2);
      points[i] = centroid;
    }
    const auto report = dt.update(points.begin(), points.end());
    all_certified = all_certified && report.certified;

    step = steps / number / std::sqrt(mean_area); // 1 is about the distance of neighbors
    spread = std::sqrt(squares / number);
    if (iteration == 1)
      first_step = step;
    if (iteration == 1 || iteration % 10 == 0)
      std::cout << "iteration " << iteration << ": mean step " << step << ", areas vary by "
                << 100 * spread << " %, " << report.flips << " flips"
                << (report.rebuilt() ? ", rebuilt\n" : "\n");
  }
  std::cout << (all_certified ? "all" : "not all") << " iterations certified\n";
  return all_certified && (iterations == 1 || step < first_step) ? 0 : 1;
}

// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// A wound that closes, in the finite Voronoi model: a cell is the part of its point's Voronoi cell
// that is no farther away than a radius. Cells resist changes of area and perimeter, and free
// boundary costs energy, as in PyAFV (W. Wang, B. A. Camley: arXiv:2604.15481, 2026). They were
// squeezed, so those at the wound spread into it.

#include <CGAL/Dynamic_Delaunay_triangulation_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/queries/Bounded_voronoi_cells_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/queries/Bounded_voronoi_gradients_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/queries/Bounded_voronoi_surface_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <iomanip>
#include <iostream>
#include <random>
#include <vector>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_2;
using Cells = CGAL::Bounded_voronoi_cells_2;

// A disc of tissue with a hole in the middle.
std::vector<Point> wounded_tissue()
{
  constexpr double spacing = 1.2, size = 16, hole = 3.5;
  std::mt19937 random(1);
  std::normal_distribution<double> noise(0, 0.05);
  std::vector<Point> points;
  for (int row = -20; row <= 20; ++row)
    for (int column = -20; column <= 20; ++column) {
      const double x = spacing * (column + 0.5 * (row % 2)), y = spacing * std::sqrt(0.75) * row;
      const double distance = std::hypot(x, y);
      if (distance > hole && distance < size)
        points.push_back(Point(x + noise(random), y + noise(random)));
    }
  return points;
}

// The area of all holes in the tissue: lines around them have negative areas. Between cells that
// pull at each other gaps open and close again, so the area need not be 0 in the end.
double area_of_wound(const Cells& cells)
{
  CGAL::Bounded_voronoi_surface_2 surface;
  surface.compute(cells);
  double area = 0;
  for (const double line_area : surface.areas())
    if (line_area < 0)
      area -= line_area;
  return area;
}

int main()
{
  constexpr double radius = 1, area = 1.7, perimeter = 4.85, tension = 0.5, step = 0.02;
  constexpr int frames = 500;
  std::vector<Point> points = wounded_tissue();
  CGAL::Dynamic_Delaunay_triangulation_2<Kernel> dt(points.begin(), points.end());
  Cells cells;
  CGAL::Bounded_voronoi_gradients_2 gradients;
  std::vector<double> area_weights, length_weights;
  std::cout << points.size() << " cells\nframe  area of the wound  mean area\n";
  for (int frame = 0; frame <= frames; ++frame) {
    cells.compute(dt, radius);
    if (frame % 100 == 0) {
      double areas = 0;
      for (const double a : cells.areas())
        areas += a;
      std::cout << std::setw(5) << frame << std::setw(19) << area_of_wound(cells) << std::setw(11)
                << areas / double(points.size()) << '\n';
    }
    // the derivatives of (A - area)^2 + (P - perimeter)^2 + tension (free length)
    area_weights.clear();
    length_weights.clear();
    for (std::size_t id = 0; id < points.size(); ++id) {
      area_weights.push_back(2 * (cells.areas()[id] - area));
      for (std::size_t i = cells.first_pieces()[id]; i < cells.first_pieces()[id + 1]; ++i)
        length_weights.push_back(2 * (cells.perimeters()[id] - perimeter) +
                                 (cells.pieces()[i].side == Cells::Side::FREE ? tension : 0));
    }
    gradients.compute(dt, cells, area_weights, length_weights);
    for (std::size_t id = 0; id < points.size(); ++id) {
      const auto& gradient = gradients.by_positions()[id];
      points[id] = Point(points[id].x() - step * gradient.x, points[id].y() - step * gradient.y);
    }
    dt.update(points.begin(), points.end());
  }
  return area_of_wound(cells) < 0.01 ? EXIT_SUCCESS : EXIT_FAILURE;
}

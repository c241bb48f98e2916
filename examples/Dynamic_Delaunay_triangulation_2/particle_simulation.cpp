// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Soft discs in a box push each other away where they overlap; the triangulation finds the pairs.
// Two points a and b without an edge have a third one in the circle with the diameter ab, which is
// no farther from one of them than |ab| / sqrt(2). So while all distances are larger than
// diameter / sqrt(2), all pairs that overlap are edges, none is missed, and energy is kept.

#include <CGAL/Dynamic_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iostream>
#include <random>
#include <vector>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_2;
using Vector = Kernel::Vector_2;

int main()
{
  const double diameter = 1, stiffness = 400, side = 24, time_step = 0.001;
  std::mt19937 random(1);
  std::normal_distribution<double> speed(0, 1);
  std::vector<Point> points;
  std::vector<Vector> velocities; // masses are 1
  for (int i = 0; i < 400; ++i) {
    points.push_back(Point(0.6 + 1.2 * (i % 20), 0.6 + 1.2 * (i / 20)));
    const double vx = speed(random);
    velocities.push_back(Vector(vx, speed(random)));
  }

  CGAL::Dynamic_Delaunay_triangulation_2<Kernel> dt(points.begin(), points.end());
  double first_energy = 0, largest_error = 0, nearest = diameter;
  bool all_certified = true;
  for (int frame = 0; frame <= 5000; ++frame) {
    double energy = 0;
    for (const Vector& v : velocities)
      energy += v.squared_length() / 2;
    const double kinetic_energy = energy;

    std::size_t contacts = 0;
    dt.for_each_edge([&](std::size_t i, std::size_t j) {
      const Vector apart = points[j] - points[i];
      const double distance = std::sqrt(apart.squared_length());
      nearest = (std::min)(nearest, distance);
      const double overlap = diameter - distance;
      if (overlap <= 0)
        return;
      ++contacts;
      energy += stiffness * overlap * overlap / 2;
      const Vector kick = time_step * stiffness * overlap / distance * apart;
      velocities[i] -= kick;
      velocities[j] += kick;
    });

    if (frame == 0)
      first_energy = energy;
    largest_error = (std::max)(largest_error, std::abs(energy / first_energy - 1));
    if (frame % 1000 == 0)
      std::cout << "frame " << frame << ": " << contacts << " contacts, kinetic energy "
                << kinetic_energy << ", with that of the contacts " << energy << '\n';

    for (std::size_t i = 0; i < points.size(); ++i) { // walls turn back who is on the way out
      const Point& p = points[i];
      Vector& v = velocities[i];
      const bool leaves_x = p.x() < 0 ? v.x() < 0 : p.x() > side && v.x() > 0;
      const bool leaves_y = p.y() < 0 ? v.y() < 0 : p.y() > side && v.y() > 0;
      v = Vector(leaves_x ? -v.x() : v.x(), leaves_y ? -v.y() : v.y());
      points[i] += time_step * v;
    }
    all_certified = dt.update(points.begin(), points.end()).certified && all_certified;
  }
  std::cout << (all_certified ? "all" : "not all") << " frames certified, energy kept to "
            << 100 * largest_error << " %, none nearer than " << nearest << '\n';
  return all_certified && largest_error < 0.01 && nearest > diameter / std::sqrt(2.0) ? 0 : 1;
}

// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SPACE_SPACE_POINTS_H
#define SPACE_SPACE_POINTS_H

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/spatial_sort.h>

#include <cmath>
#include <cstddef>
#include <random>
#include <string>
#include <vector>

namespace space {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Points = std::vector<Point>;

// The place from the middle of a sphere where the point in this direction is.
inline Point on_sphere(double x, double y, double z, double radius)
{
  const double scale = radius / std::hypot(x, y, z);
  return Point(scale * x, scale * y, scale * z);
}

inline double radius_of_sphere(std::size_t n)
{
  return std::sqrt(double(n) / (4 * std::acos(-1.0)));
}

// Points of density 1: the mean spacing is 1.
inline Points points_of(const std::string& kind, std::size_t n, std::mt19937_64& random)
{
  std::uniform_real_distribution<double> share(0, 1);
  std::normal_distribution<double> jitter(0, kind == "lattice" ? 0.2 : 1);
  const double side = std::cbrt(double(n));
  Points points;
  if (kind == "lattice" || kind == "exact_lattice") {
    const int edge = int(std::lround(side));
    const double scale = kind == "lattice" ? 1 : 0;
    for (int i = 0; i != edge * edge * edge; ++i) {
      const double x = i / edge / edge + scale * jitter(random);
      const double y = i / edge % edge + scale * jitter(random);
      points.emplace_back(x, y, i % edge + scale * jitter(random));
    }
  } else {
    const double radius = std::cbrt(3 * double(n) / (4 * std::acos(-1.0)));
    const double height = std::cbrt(double(n) / 100);
    while (points.size() < n) {
      const double x = share(random), y = share(random), z = share(random);
      if (kind == "sphere") {
        points.push_back(
            on_sphere(jitter(random), jitter(random), jitter(random), radius_of_sphere(n)));
      } else if (kind == "slab") {
        points.emplace_back(10 * height * x, 10 * height * y, height * z);
      } else if (kind != "ball") {
        points.emplace_back(side * x, side * y, side * z);
      } else if (std::hypot(2 * x - 1, 2 * y - 1, 2 * z - 1) < 1) {
        points.emplace_back(radius * (2 * x - 1), radius * (2 * y - 1), radius * (2 * z - 1));
      }
    }
  }
  CGAL::spatial_sort(points.begin(), points.end());
  return points;
}

inline void move(const std::string& kind, double step, Points& points, std::mt19937_64& random)
{
  std::normal_distribution<double> way(0, step / std::sqrt(3.0));
  const double drift = kind == "drift" ? 0.7 : 0, side = std::cbrt(double(points.size()));
  std::uniform_real_distribution<double> place(0, side);
  for (std::size_t i = 0; i != points.size(); ++i) {
    const Point& p = points[i];
    const double stream = kind == "streams" ? (i % 2 == 0 ? step : -step) : 0;
    const double share = kind == "streams" ? 0.1 : 1;
    const double x = p.x() + drift + stream + share * way(random);
    const double y = p.y() + drift / 3 + share * way(random);
    const double z = p.z() + share * way(random);
    points[i] =
        kind == "sphere" ? on_sphere(x, y, z, radius_of_sphere(points.size())) : Point(x, y, z);
  }
  for (int i = 0; kind == "jumps" && i != 5; ++i) {
    const double x = place(random), y = place(random);
    points[random() % points.size()] = Point(x, y, place(random));
  }
}

} // namespace space

#endif // SPACE_SPACE_POINTS_H

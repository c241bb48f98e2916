// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Positions in arrays of their own, x here and y there, as particle codes keep them: nothing is
// copied into points.

#include <CGAL/Dynamic_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <boost/property_map/function_property_map.hpp>
#include <boost/range/irange.hpp>

#include <cstddef>
#include <iostream>
#include <random>
#include <vector>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_2;

int main()
{
  std::mt19937 random(7);
  std::uniform_real_distribution<double> coordinate(0, 40);
  std::normal_distribution<double> step(0, 0.02);

  std::vector<double> x(1600), y(1600);
  for (std::size_t i = 0; i < x.size(); ++i) {
    x[i] = coordinate(random);
    y[i] = coordinate(random);
  }

  //! [arrays]
  const auto particles = boost::irange<std::size_t>(0, x.size());
  const auto position = boost::make_function_property_map<std::size_t>(
      [&](std::size_t i) { return Point(x[i], y[i]); });

  CGAL::Dynamic_Delaunay_triangulation_2<Kernel> dt(particles.begin(), particles.end(), position);
  for (int frame = 0; frame < 50; ++frame) {
    for (const std::size_t i : particles) {
      x[i] += step(random);
      y[i] += step(random);
    }
    dt.update(particles, position);
  }
  //! [arrays]

  std::cout << dt.number_of_points() << " particles after 50 frames, "
            << (dt.is_certified() ? "certified" : "not certified") << '\n';
  return dt.is_certified() && dt.point(3) == Point(x[3], y[3]) ? 0 : 1;
}

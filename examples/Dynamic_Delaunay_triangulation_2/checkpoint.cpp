// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// A run is interrupted, and goes on from a file as if it had not been. A damaged file is refused.

#include <CGAL/Dynamic_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <cstddef>
#include <iostream>
#include <random>
#include <sstream>
#include <string>
#include <vector>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_2;
using Triangulation = CGAL::Dynamic_Delaunay_triangulation_2<Kernel>;

// Moves every point by a step, the same for the same random numbers. Returns the number of flips.
std::size_t step(Triangulation& dt, std::mt19937& random)
{
  std::normal_distribution<double> length(0, 0.01);
  std::vector<Point> points;
  for (std::size_t id = 0; id < dt.number_of_ids(); ++id) {
    const double dx = length(random);
    points.push_back(Point(dt.point(id).x() + dx, dt.point(id).y() + length(random)));
  }
  return dt.update(points.begin(), points.end()).flips;
}

int main()
{
  std::mt19937 random(1);
  std::uniform_real_distribution<double> coordinate(0, 30);
  std::vector<Point> points;
  for (int i = 0; i < 900; ++i) {
    const double x = coordinate(random);
    points.push_back(Point(x, coordinate(random)));
  }
  Triangulation dt(points.begin(), points.end());
  for (int frame = 0; frame < 50; ++frame)
    step(dt, random);

  //! [checkpoint]
  std::stringstream file; // or a std::fstream, opened as binary
  dt.write_checkpoint(file);
  Triangulation other;
  other.read_checkpoint(file);
  //! [checkpoint]
  std::string damaged = file.str();

  std::mt19937 same_random = random;
  bool is_same = true;
  for (int frame = 0; frame < 50; ++frame)
    is_same = is_same && step(dt, random) == step(other, same_random);
  std::cout << (is_same ? "the same" : "other") << " flips in 50 frames\n";

  damaged[damaged.size() / 2] ^= 1;
  std::istringstream damaged_file(damaged);
  try {
    other.read_checkpoint(damaged_file);
    return 1;
  } catch (const CGAL::Checkpoint_error_2& error) {
    std::cout << "refused: " << error.what() << "\n";
  }
  return is_same && other.is_certified() ? 0 : 1;
}

// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// A classifier of one's own: it picks the vertices that have moved farther, since their
// neighborhood was last triangulated, than a share of the distance to their nearest neighbor at
// that time.

#include <CGAL/Dynamic_Delaunay_triangulation_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/queries/delaunay_agreement.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iostream>
#include <random>
#include <vector>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_2;

//! [classifier]
class Displacement_classifier
{
public:
  static constexpr bool is_exact = false; // it may miss a broken edge

  explicit Displacement_classifier(double limit = 0.1)
    : m_limit(limit)
  {
  }

  template <class Frame, class Classification>
  void operator()(const Frame& frame, Classification& classified)
  {
    m_travelled.resize(frame.number_of_points(), 0);
    for (std::uint32_t i = 0; i < frame.number_of_points(); ++i) {
      const auto& now = frame.position(frame.vertex(i));
      const auto& before = frame.previous_position(frame.vertex(i));
      m_travelled[i] += std::hypot(now.x - before.x, now.y - before.y);
      if (m_travelled[i] > m_limit) {
        classified.add_id(i);
        m_travelled[i] = 0;
      }
    }
  }

private:
  double m_limit;
  std::vector<double> m_travelled; // of each id
};
//! [classifier]

int main()
{
  std::mt19937 random(1);
  std::uniform_real_distribution<double> coordinate(0, 40);
  std::vector<Point> points;
  for (int i = 0; i < 1600; ++i)
    points.push_back(Point(coordinate(random), coordinate(random)));

  CGAL::Dynamic_Delaunay_triangulation_2<Kernel, Displacement_classifier> dt(
      points.begin(), points.end(), Displacement_classifier(0.2));

  std::size_t classified = 0;
  for (int frame = 0; frame < 50; ++frame) {
    for (Point& p : points) { // the cloud is stirred around its middle, faster inside
      const double x = p.x() - 20, y = p.y() - 20;
      const double angle = 0.02 / (1 + 0.01 * (x * x + y * y));
      p = Point(20 + x * std::cos(angle) - y * std::sin(angle),
                20 + x * std::sin(angle) + y * std::cos(angle));
    }
    classified += dt.update(points.begin(), points.end()).classified;
  }

  const CGAL::Delaunay_triangulation_2<Kernel> truth(points.begin(), points.end());
  std::cout << classified / 50 << " of " << dt.number_of_points()
            << " points classified a frame; validity "
            << CGAL::delaunay_agreement(dt, truth).matthews_correlation_coefficient() << "\n";
  return dt.is_valid(true) ? 0 : 1;
}

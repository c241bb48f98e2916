// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Points move by little, by much, and all at once: after each frame the triangulation is that of
// CGAL.

#include "plain_oracle.h"

#include <CGAL/Dynamic_Delaunay_triangulation_2/classifiers/Point_distance_classifier_2.h>

#include <limits>
#include <utility>

using Exact = CGAL::Dynamic_Delaunay_triangulation_2<Kernel>;
using Heuristic = CGAL::Dynamic_Delaunay_triangulation_2<Kernel, CGAL::Point_distance_classifier_2>;

void move_by(std::vector<Point>& points, CGAL::Random& random, double step)
{
  for (Point& p : points) {
    const double x = p.x() + random.get_double(-step, step);
    p = Point(x, p.y() + random.get_double(-step, step));
  }
}

void follow_small_and_large_steps()
{
  CGAL::Random random(1);
  std::vector<Point> points = random_points(random, 300);
  Exact dt(points);
  for (const double step : {0.0001, 0.001, 0.01, 0.1, 1.})
    for (int frame = 0; frame < 5; ++frame) {
      move_by(points, random, step);
      assert(dt.update(points).certified);
      assert_exact(dt, points);
    }
}

void follow_points_that_jump_or_trade_places()
{
  CGAL::Random random(2);
  std::vector<Point> points = random_points(random, 300);
  Exact dt(points);
  for (std::size_t frame = 0; frame < 10; ++frame) {
    std::swap(points[frame], points[299 - frame]);
    points[100 + frame] = random_point(random);
    dt.update(points);
    assert_exact(dt, points);
  }
}

void follow_a_mirror_image()
{
  CGAL::Random random(3);
  std::vector<Point> points = random_points(random, 300);
  Exact dt(points);
  for (Point& p : points)
    p = Point(-p.x(), p.y());
  dt.update(points);
  assert_exact(dt, points);
}

void refuse_a_frame_that_is_not_finite()
{
  CGAL::Random random(4);
  const std::vector<Point> points = random_points(random, 100);
  std::vector<Point> bad = points;
  bad[50] = Point(std::numeric_limits<double>::quiet_NaN(), 0);
  Exact dt(points);
  bool refused = false;
  try {
    dt.update(bad);
  } catch (const CGAL::Non_finite_coordinate_error_2&) {
    refused = true;
  }
  assert(refused);
  assert_exact(dt, points);
}

void mend_what_a_heuristic_classifier_has_left()
{
  CGAL::Random random(5);
  std::vector<Point> points = random_points(random, 300);
  Heuristic dt(points);
  for (int frame = 0; frame < 5; ++frame) {
    move_by(points, random, 0.01);
    dt.update(points);
    assert(dt.is_valid());
  }
  dt.mend();
  assert_exact(dt, points);
}

int main()
{
  follow_small_and_large_steps();
  follow_points_that_jump_or_trade_places();
  follow_a_mirror_image();
  refuse_a_frame_that_is_not_finite();
  mend_what_a_heuristic_classifier_has_left();
  return 0;
}

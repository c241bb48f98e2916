// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Points that coincide, lie on a line or on circles, and hardly any points: after each change the
// triangulation is that of CGAL.

#include "plain_oracle.h"

using Dynamic = CGAL::Dynamic_Delaunay_triangulation_2<Kernel>;

void expect_after_update(Dynamic& dt, const std::vector<Point>& points)
{
  dt.update(points);
  assert_exact(dt, points);
}

std::vector<Point> line(std::size_t number, double slope)
{
  std::vector<Point> points;
  for (std::size_t i = 0; i < number; ++i)
    points.push_back(Point(double(i), slope * double(i)));
  return points;
}

std::vector<Point> lattice(std::size_t number)
{
  std::vector<Point> points;
  for (std::size_t i = 0; i < number; ++i)
    points.push_back(Point(double(i % 10), double(i / 10)));
  return points;
}

void up_to_three_points()
{
  CGAL::Random random(1);
  for (std::size_t number = 0; number <= 3; ++number) {
    std::vector<Point> points = random_points(random, number);
    Dynamic dt(points);
    assert_exact(dt, points);
    expect_after_update(dt, random_points(random, number));
    expect_after_update(dt, std::vector<Point>(number, Point(1, 2)));
    expect_after_update(dt, line(number, 1));
    expect_after_update(dt, points);
  }
}

void all_points_meet_and_part()
{
  CGAL::Random random(2);
  const std::vector<Point> points = random_points(random, 60);
  Dynamic dt(points);
  expect_after_update(dt, std::vector<Point>(60, Point(1, 2)));
  assert(dt.number_of_vertices() == 1);
  expect_after_update(dt, points);
}

void pairs_meet_and_part()
{
  CGAL::Random random(3);
  const std::vector<Point> points = random_points(random, 60);
  Dynamic dt(points);
  std::vector<Point> paired = points;
  for (std::size_t id = 0; id < paired.size(); id += 2)
    paired[id] = paired[id + 1];
  expect_after_update(dt, paired);
  assert(dt.number_of_vertices() == 30);
  for (std::size_t id = 0; id < paired.size(); id += 4)
    paired[id] = points[id];
  expect_after_update(dt, paired);
  expect_after_update(dt, points);
}

void all_points_line_up()
{
  CGAL::Random random(4);
  const std::vector<Point> points = random_points(random, 60);
  Dynamic dt(points);
  for (const double slope : {0., 1., -3.}) {
    expect_after_update(dt, line(60, slope));
    assert(dt.triangulation().dimension() == 1);
    expect_after_update(dt, points);
  }
}

void cocircular_points_shift_and_turn_around()
{
  std::vector<Point> points = lattice(100);
  Dynamic dt(points);
  assert_exact(dt, points);
  for (Point& p : points)
    p = Point(p.x() + 0.5 * p.y(), p.y());
  expect_after_update(dt, points);
  for (Point& p : points)
    p = Point(-p.y(), p.x());
  expect_after_update(dt, points);
  expect_after_update(dt, lattice(100));
}

int main()
{
  up_to_three_points();
  all_points_meet_and_part();
  pairs_meet_and_part();
  all_points_line_up();
  cocircular_points_shift_and_turn_around();
  return 0;
}

// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// What every test asks of a triangulation, and the points that tests are made of.

#ifndef DYNAMIC_DELAUNAY_TRIANGULATION_2_TEST_ORACLE_H
#define DYNAMIC_DELAUNAY_TRIANGULATION_2_TEST_ORACLE_H

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/queries/delaunay_agreement.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <map>
#include <random>
#include <string>
#include <vector>

using Epick = CGAL::Exact_predicates_inexact_constructions_kernel;
using Epeck = CGAL::Exact_predicates_exact_constructions_kernel;

// Expects that no point is lost and that the structure is sound; it may be uncertified.
template <class Dynamic>
void expect_valid(const Dynamic& dt, const std::vector<typename Dynamic::Point>& points)
{
  ASSERT_EQ(dt.number_of_points(), points.size());
  ASSERT_TRUE(dt.is_valid(true));
  for (std::size_t id = 0; id < points.size(); ++id)
    ASSERT_EQ(dt.point(id), points[id]) << "id " << id;
}

// Expects a certified triangulation that agrees with a fresh one of CGAL edge for edge.
template <class Dynamic>
void expect_delaunay(const Dynamic& dt, const std::vector<typename Dynamic::Point>& points)
{
  ASSERT_TRUE(dt.is_certified());
  const CGAL::Delaunay_triangulation_2<typename Dynamic::Geom_traits> fresh(points.begin(),
                                                                            points.end());
  ASSERT_EQ(dt.number_of_vertices(), fresh.number_of_vertices());
  ASSERT_EQ(dt.triangulation().dimension(), fresh.dimension());
  const CGAL::Delaunay_agreement agreement = CGAL::delaunay_agreement(dt, fresh);
  ASSERT_EQ(agreement.false_positives(), 0u);
  ASSERT_EQ(agreement.false_negatives(), 0u);
}

// Expects validity and the Delaunay triangulation of the points.
template <class Dynamic>
void expect_exact(const Dynamic& dt, const std::vector<typename Dynamic::Point>& points)
{
  ASSERT_NO_FATAL_FAILURE(expect_valid(dt, points));
  ASSERT_NO_FATAL_FAILURE(expect_delaunay(dt, points));
}

// The points that a triangulation should have after insertions and removals, by their ids.
template <class Dynamic>
using Model = std::map<std::size_t, typename Dynamic::Point>;

template <class Dynamic>
Model<Dynamic> model_of(const Dynamic& dt)
{
  Model<Dynamic> model;
  for (std::size_t id = 0; id < dt.number_of_ids(); ++id)
    if (dt.has_id(id))
      model.emplace(id, dt.point(id));
  return model;
}

template <class Dynamic>
void expect_valid(const Dynamic& dt, const Model<Dynamic>& model)
{
  ASSERT_TRUE(dt.is_valid(true));
  ASSERT_EQ(dt.number_of_points(), model.size());
  for (std::size_t id = 0; id < dt.number_of_ids(); ++id)
    ASSERT_EQ(dt.has_id(id), model.count(id) == 1) << "id " << id;
  for (const auto& [id, p] : model) {
    ASSERT_TRUE(dt.has_id(id)) << "id " << id;
    ASSERT_EQ(dt.point(id), p) << "id " << id;
    const std::size_t representative = dt.id(dt.vertex(id));
    ASSERT_EQ(dt.vertex(representative), dt.vertex(id)) << "id " << id;
    ASSERT_EQ(model.at(representative), p) << "id " << id << ", a duplicate of " << representative;
  }
}

template <class Dynamic>
void expect_exact(const Dynamic& dt, const Model<Dynamic>& model)
{
  ASSERT_NO_FATAL_FAILURE(expect_valid(dt, model));
  std::vector<typename Dynamic::Point> points;
  for (const auto& [id, p] : model)
    points.push_back(p);
  ASSERT_NO_FATAL_FAILURE(expect_delaunay(dt, points));
}

// Expects the points of the frame by their user's ids, and no others.
template <class People, class Frame>
void expect_people(const People& people, const Frame& frame)
{
  const auto& dt = people.triangulation();
  ASSERT_EQ(people.size(), frame.size());
  ASSERT_EQ(dt.number_of_points(), frame.size());
  for (const auto& [user_id, p] : frame) {
    SCOPED_TRACE(testing::Message() << "user's id " << +user_id);
    ASSERT_TRUE(people.has(user_id));
    ASSERT_EQ(people.point(user_id), p);
    const std::size_t id = people.id(user_id);
    ASSERT_EQ(people.user_id(id), user_id);
    ASSERT_EQ(dt.point(id), p);
    ASSERT_EQ(people.vertex(user_id), dt.vertex(id));
    ASSERT_EQ(people.user_id(people.vertex(user_id)), people.user_id(dt.id(dt.vertex(id))));
  }
}

template <class People, class Frame>
void expect_exact_people(const People& people, const Frame& frame)
{
  ASSERT_NO_FATAL_FAILURE(expect_people(people, frame));
  ASSERT_NO_FATAL_FAILURE(expect_exact(people.triangulation(), model_of(people.triangulation())));
}

// Anywhere in the square from `low` to `high`.
template <class Point>
Point random_point_between(double low, double high, std::mt19937& random)
{
  std::uniform_real_distribution<double> coordinate(low, high);
  const double x = coordinate(random);
  return Point(x, coordinate(random));
}

// Random points and motions over doubles, for any kernel.
template <class Kernel>
class Cloud
{
public:
  using Point = typename Kernel::Point_2;
  using Points = std::vector<Point>;

  explicit Cloud(unsigned seed)
    : m_random(seed)
  {
  }

  // n points in a square, one to a unit of area.
  Points uniform(std::size_t n)
  {
    Points points;
    while (points.size() < n)
      points.push_back(random_point_between<Point>(0, std::sqrt(double(n)), m_random));
    return points;
  }

  // An exact square lattice, full of ties.
  static Points grid(std::size_t columns, std::size_t rows)
  {
    Points points;
    for (std::size_t i = 0; i < rows; ++i)
      for (std::size_t j = 0; j < columns; ++j)
        points.push_back(Point(double(j), double(i)));
    return points;
  }

  Points on_line(std::size_t n)
  {
    std::uniform_int_distribution<int> step(-1000, 1000);
    Points points;
    for (std::size_t i = 0; i < n; ++i) {
      const int t = step(m_random);
      points.push_back(Point(3 * t, 2 * t + 1));
    }
    return points;
  }

  // Exactly cocircular: integer points on the circle of radius 65 around the origin, at most 36.
  static Points on_circle(std::size_t n)
  {
    Points points;
    for (int x = -65; x <= 65; ++x)
      for (int y = -65; y <= 65; ++y)
        if (x * x + y * y == 65 * 65 && points.size() < n)
          points.push_back(Point(x, y));
    return points;
  }

  Point shifted(const Point& p, double step)
  {
    std::normal_distribution<double> normal; // of deviation 1, as 0 would be none
    const double dx = step * normal(m_random);
    return Point(CGAL::to_double(p.x()) + dx, CGAL::to_double(p.y()) + step * normal(m_random));
  }

  void shake(Points& points, double step)
  {
    for (Point& p : points)
      p = shifted(p, step);
  }

  std::mt19937& random() { return m_random; }

private:
  std::mt19937 m_random;
};

template <class Kernel>
std::vector<typename Kernel::Point_2> scaled(const std::vector<typename Kernel::Point_2>& points,
                                             double factor, double offset = 0)
{
  std::vector<typename Kernel::Point_2> result;
  for (const auto& p : points)
    result.emplace_back(CGAL::to_double(p.x()) * factor + offset,
                        CGAL::to_double(p.y()) * factor + offset);
  return result;
}

#endif // DYNAMIC_DELAUNAY_TRIANGULATION_2_TEST_ORACLE_H

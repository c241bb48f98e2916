// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Rough frames that are taken in several steps.

#include "change_ledger.h"
#include "oracle.h"
#include "periodic_oracle.h"
#include "random_points.h"

#include <CGAL/Dynamic_periodic_Delaunay_triangulation_2.h>
#include <CGAL/Dynamic_population_2.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <map>
#include <random>
#include <vector>

namespace test_steps {

using Point = Epick::Point_2;
using Points = std::vector<Point>;

// The default classifier. A frame that is taken in steps, or rebuilt at once, does not call it.
class Counted_classifier : public CGAL::Circumcircle_classifier_2
{
public:
  template <class Frame, class Classification>
  void operator()(const Frame& frame, Classification& classified)
  {
    ++calls;
    CGAL::Circumcircle_classifier_2::operator()(frame, classified);
  }

  int calls = 0;
};

template <class Kernel>
using Counted = CGAL::Dynamic_Delaunay_triangulation_2<Kernel, Counted_classifier>;
using Counted_periodic = CGAL::Dynamic_periodic_Delaunay_triangulation_2<Epick, Counted_classifier>;

// How frames of a triangulation were mended.
struct Tally
{
  int steps = 0, whole = 0, rebuilt = 0;

  template <class Dynamic>
  void count(const Dynamic& dt, const CGAL::Update_report_2& report)
  {
    const int calls = dt.classifier().calls;
    ++(report.rebuilt() ? rebuilt : calls > m_calls ? whole : steps);
    m_calls = calls;
  }

private:
  int m_calls = 0;
};

template <class Kernel, class Move>
Tally tally(std::vector<typename Kernel::Point_2> points, int frames, const Move& move)
{
  Counted<Kernel> dt(points);
  Tally tally;
  for (int frame = 0; frame < frames && !testing::Test::HasFailure(); ++frame) {
    SCOPED_TRACE(testing::Message() << "frame " << frame);
    move(points);
    tally.count(dt, dt.update(points));
    expect_exact(dt, points);
  }
  return tally;
}

TEST(Steps, are_taken_where_much_is_broken)
{
  const auto tally_of = [](double step) {
    Cloud<Epick> cloud(4);
    return tally<Epick>(cloud.uniform(300), 20, [&](Points& moved) { cloud.shake(moved, step); });
  };
  const Tally calm = tally_of(0.01), rough = tally_of(0.15);
  EXPECT_EQ(calm.whole, 20);
  EXPECT_GE(rough.steps, 18);
  EXPECT_LE(rough.rebuilt, 2);
}

TEST(Steps, end_exact_for_any_number_of_points_and_any_step)
{
  int steps = 0;
  for (const std::size_t n : {3u, 5u, 9u, 20u, 70u, 200u})
    for (const double step : {0.08, 0.15, 0.25, 0.6}) {
      SCOPED_TRACE(testing::Message() << n << " points, step " << step);
      Cloud<Epick> cloud{unsigned(n)};
      steps += tally<Epick>(cloud.uniform(n), 25, [&](Points& p) { cloud.shake(p, step); }).steps;
    }
  EXPECT_GT(steps, 150);
}

// Where all points are on the hull, each broken edge takes five flips. A rebuild costs less.
TEST(Steps, are_not_taken_along_a_circle)
{
  constexpr int n = 300;
  std::mt19937_64 random(3);
  std::vector<double> places;
  for (int i = 0; i < n; ++i)
    places.push_back(i);
  const auto go_along = [&](Points& points) {
    points.clear();
    for (double& place : places) {
      place += random_between(random, -0.1, 0.1);
      const double angle = 6.283 * place / n;
      points.emplace_back(100 * std::cos(angle), 100 * std::sin(angle));
    }
  };
  Points start;
  go_along(start);
  EXPECT_GE(tally<Epick>(start, 10, go_along).rebuilt, 8);
}

// Halfway each point of a pair that changes places is where the other one is.
TEST(Steps, end_exact_where_points_meet_on_their_ways)
{
  const auto swap = [](Points& points) {
    for (std::size_t i = 0; i + 1 < points.size(); i += 14)
      std::swap(points[i], points[i + 1]);
  };
  Cloud<Epick> cloud(6);
  Points grid = Cloud<Epick>::grid(12, 12);
  EXPECT_GT(tally<Epick>(grid, 10, swap).steps, 0);
  cloud.shake(grid, 0.1);
  EXPECT_GT(tally<Epick>(grid, 10, swap).steps, 0);
}

TEST(Steps, end_exact_on_lattices_and_for_exact_coordinates)
{
  using Exact_points = std::vector<Epeck::Point_2>;
  Cloud<Epeck> cloud(9);
  const Tally exact =
      tally<Epeck>(cloud.uniform(60), 8, [&](Exact_points& points) { cloud.shake(points, 0.2); });
  EXPECT_GT(exact.steps, 2);
  // everything is on circles and lines, before and after
  const auto shear = [](Points& points) {
    for (Point& p : points)
      p = Point(p.x() + std::floor(p.y()) * 0.25, p.y());
  };
  tally<Epick>(Cloud<Epick>::grid(12, 12), 12, shear);
}

TEST(Steps, end_exact_where_points_share_vertices_and_part)
{
  Cloud<Epick> cloud(2);
  Points points = cloud.uniform(150);
  for (std::size_t i = 0; i < 20; ++i)
    points[i] = points[20 + i % 4];
  const auto move = [&](Points& moved) {
    const Points before = moved;
    cloud.shake(moved, 0.12);
    for (std::size_t i = 0; i < 10; ++i) // half of them stay together
      moved[i] = moved[20 + i % 4];
    moved[140] = moved[141];
  };
  EXPECT_GT(tally<Epick>(points, 12, move).steps, 6);
}

TEST(Steps, are_told_to_classifiers_as_one_frame)
{
  Cloud<Epick> cloud(3);
  Points points = cloud.uniform(200);
  Watched_triangulation<Epick, CGAL::Circumcircle_classifier_2> dt;
  dt.classifier().watch(dt);
  dt.insert(points, CGAL::Emptyset_iterator());
  for (int frame = 0; frame < 20; ++frame) {
    cloud.shake(points, 0.1);
    EXPECT_TRUE(dt.update(points).certified);
    ASSERT_FALSE(testing::Test::HasFailure()) << frame;
  }
  expect_exact(dt, points);
}

TEST(Steps, are_taken_while_some_come_and_go)
{
  Cloud<Epick> cloud(31);
  std::mt19937_64 random(31);
  std::map<int, Point> frame;
  int next = 0;
  for (const Point& p : cloud.uniform(200))
    frame[next++] = p;
  CGAL::Dynamic_population_2<Counted<Epick>, int> people;
  people.update(frame.begin(), frame.end());
  Tally tally;
  tally.count(people.triangulation(), {});
  for (int i = 0; i < 25; ++i) {
    for (auto& [id, p] : frame)
      p = cloud.shifted(p, 0.1);
    for (int k = 0; k < 5; ++k)
      frame.erase(std::next(frame.begin(), std::ptrdiff_t(random() % frame.size())));
    for (const Point& p : cloud.uniform(5))
      frame[next++] = p;
    tally.count(people.triangulation(), people.update(frame.begin(), frame.end()));
    ASSERT_NO_FATAL_FAILURE(expect_exact_people(people, frame)) << i;
  }
  EXPECT_GT(tally.steps, 15);
}

TEST(Steps, go_along_with_a_cell_that_is_sheared_and_in_slabs)
{
  using Cell = CGAL::Periodic_cell_2;
  for (const bool is_slab : {false, true}) {
    std::mt19937_64 random(5);
    std::normal_distribution<double> way(0, 0.13);
    Points points = random_points(random, 200, 14);
    const auto cell = [&](double shear) {
      return is_slab ? Cell::slab(14, 0) : Cell(14, 0, shear, 14);
    };
    Counted_periodic pt(points, cell(0));
    Tally tally;
    for (int frame = 1; frame <= 20; ++frame) {
      for (Point& p : points) {
        const double x = p.x() + way(random) + (is_slab ? 0 : 0.6 / 14 * p.y());
        p = Point(x, p.y() + way(random));
      }
      tally.count(pt, pt.update(points, cell(0.6 * frame)));
      ASSERT_NO_FATAL_FAILURE(expect_periodic_delaunay(pt)) << frame;
    }
    EXPECT_GT(tally.steps, 15) << is_slab;
    EXPECT_EQ(tally.rebuilt, 0) << is_slab;
  }
}

} // namespace test_steps

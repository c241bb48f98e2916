// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Rough frames, where vertices are held, moved on, and taken out.

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
#include <utility>
#include <vector>

namespace test_held_vertices {

using Point = Epick::Point_2;
using Points = std::vector<Point>;
using Dynamic = CGAL::Dynamic_Delaunay_triangulation_2<Epick>;

// Holds, flips and releases, whatever that costs.
struct Holding_repair
{
  template <class Mender>
  void operator()(Mender& mender) const
  {
    EXPECT_TRUE(mender.can_hold());
    mender.hold();
    mender.flip();
    mender.release();
  }
};

template <class Kernel>
using Holding = CGAL::Dynamic_Delaunay_triangulation_2<Kernel, CGAL::Default,
                                                       CGAL::With_repair_2<Holding_repair>>;

// Follows `frames` frames of points that `move(points, frame)` changes. Returns how many of them
// were rebuilt.
template <class Followed, class Kernel_points, class Move>
std::size_t number_rebuilt(Kernel_points points, int frames, const Move& move)
{
  Followed dt(points);
  std::size_t rebuilt = 0;
  for (int frame = 0; frame < frames && !testing::Test::HasFailure(); ++frame) {
    SCOPED_TRACE(testing::Message() << "frame " << frame);
    move(points, frame);
    rebuilt += dt.update(points).rebuilt();
    expect_exact(dt, points);
  }
  return rebuilt;
}

TEST(Held_vertices, follow_any_step_and_any_number_of_points)
{
  for (const std::size_t n : {3u, 4u, 7u, 15u, 40u, 150u})
    for (const double step : {0.03, 0.1, 0.3, 1., 4.}) {
      SCOPED_TRACE(testing::Message() << n << " points, step " << step);
      Cloud<Epick> cloud(unsigned(n) + 7);
      const auto shake = [&](Points& points, int) { cloud.shake(points, step); };
      number_rebuilt<Holding<Epick>>(cloud.uniform(n), 40, shake);
      if (testing::Test::HasFailure())
        return;
    }
}

TEST(Held_vertices, need_no_rebuild_up_to_a_seventh_of_the_spacing)
{
  for (const double step : {0.05, 0.1, 0.14}) {
    Cloud<Epick> cloud(3);
    const auto shake = [&](Points& points, int) { cloud.shake(points, step); };
    EXPECT_EQ(number_rebuilt<Dynamic>(cloud.uniform(500), 30, shake), 0u) << step;
  }
}

// The neighbors' mean takes the common motion out: hardly more has to be mended than without it.
TEST(Held_vertices, go_along_with_their_neighbors)
{
  std::size_t relocated[2] = {0, 0};
  for (const bool drifts : {false, true}) {
    Cloud<Epick> cloud(5);
    Points points = cloud.uniform(800);
    Dynamic dt(points);
    for (int frame = 0; frame < 10; ++frame) {
      cloud.shake(points, 0.08);
      if (drifts)
        for (Point& p : points)
          p = Point(p.x() + 0.5, p.y() - 0.4);
      const auto report = dt.update(points);
      EXPECT_FALSE(report.rebuilt());
      relocated[drifts] += report.relocated;
      ASSERT_NO_FATAL_FAILURE(expect_exact(dt, points));
    }
  }
  EXPECT_GT(relocated[0], 10u);
  EXPECT_LT(relocated[1], 2 * relocated[0]);
}

// Coordinates that are no doubles: where a vertex rests is known exactly all the same.
TEST(Held_vertices, rest_at_exact_places)
{
  using Exact_points = std::vector<Epeck::Point_2>;
  for (const bool alternates : {false, true}) {
    Cloud<Epeck> cloud(9);
    const auto move = [&](Exact_points& points, int frame) {
      cloud.shake(points, 0.2);
      if (alternates && frame % 2 == 0)
        return;
      for (Epeck::Point_2& p : points)
        p = Epeck::Point_2(p.x() + Epeck::FT(1) / 3, p.y() - Epeck::FT(1) / 7);
    };
    number_rebuilt<Holding<Epeck>>(cloud.uniform(60), 15, move);
    number_rebuilt<Holding<Epeck>>(Cloud<Epeck>::grid(6, 6), 10, move);
  }
}

TEST(Held_vertices, on_lines_circles_and_lattices_end_exact)
{
  for (const Points& start : {Cloud<Epick>::grid(8, 8), Cloud<Epick>::on_circle(36)})
    for (const double step : {1., 2., 5.}) {
      std::mt19937_64 random(11);
      const auto by_steps = [&](Points& points, int) {
        for (Point& p : points)
          if (random() % 3 == 0)
            p = Point(p.x() + step * double(int(random() % 3) - 1),
                      p.y() + step * double(int(random() % 3) - 1));
      };
      number_rebuilt<Holding<Epick>>(start, 30, by_steps);
    }
}

// The hull turns, breathes and is crossed from inside.
TEST(Held_vertices, at_the_hull_end_exact)
{
  for (unsigned seed = 0; seed < 6; ++seed) {
    Cloud<Epick> cloud(seed);
    std::mt19937_64 random(seed);
    const auto turn = [&](Points& points, int frame) {
      const double angle = 0.3 * frame, stretch = frame % 3 == 0 ? 0.7 : 1.3;
      for (std::size_t i = 0; i < points.size(); ++i) {
        const double x = points[i].x(), y = points[i].y();
        const double own = i % 5 == 0 ? 1 + random_between(random, -0.5, 0.9) : 1;
        points[i] = Point(own * (std::cos(angle) * x - std::sin(angle) * y),
                          own * stretch * (std::sin(angle) * x + std::cos(angle) * y));
      }
    };
    number_rebuilt<Holding<Epick>>(cloud.uniform(30), 40, turn);
  }
}

// Points stray ten boxes away, each for one frame. Those that return leave the hull together, which
// would fold though all faces are counterclockwise.
TEST(Held_vertices, need_no_rebuild_where_strays_return)
{
  const double side = std::sqrt(2000.);
  for (unsigned seed = 0; seed < 3; ++seed) {
    std::mt19937_64 random(seed);
    const Points home = random_points(random, 2000, side);
    const auto stray = [&](Points& points, int) {
      points = home;
      for (int k = 0; k < 40; ++k) {
        const double angle = random_between(random, 0., 6.3);
        points[random() % points.size()] =
            Point(side / 2 + 10 * side * std::cos(angle), side / 2 + 10 * side * std::sin(angle));
      }
    };
    EXPECT_EQ(number_rebuilt<Dynamic>(home, 10, stray), 0u) << seed;
  }
}

// The straight border of a crystal bends: many flat faces there are inverted together. A few flips
// right them all, and no vertex is taken out.
TEST(Held_vertices, are_none_where_the_border_of_a_crystal_bends)
{
  constexpr int side = 30;
  Points points;
  const auto place_all = [&](double time) {
    points.clear();
    for (int i = 0; i < side; ++i)
      for (int j = 0; j < side; ++j) {
        const Point p(i + (j % 2) * 0.5, j * std::sqrt(0.75));
        const double wave = 0.3 * std::sin(0.02 * time * p.y() + 0.1 * time);
        points.emplace_back(p.x() + wave * std::cos(0.05 * p.x()),
                            p.y() + wave * std::sin(0.04 * p.x()));
      }
  };
  place_all(0);
  Dynamic dt(points);
  std::size_t flips = 0;
  for (int frame = 1; frame < 20; ++frame) {
    place_all(frame);
    const auto report = dt.update(points);
    EXPECT_FALSE(report.rebuilt());
    EXPECT_EQ(report.relocated, 0u);
    flips += report.flips;
    ASSERT_NO_FATAL_FAILURE(expect_exact(dt, points)) << frame;
  }
  EXPECT_GT(flips, 500u);
}

TEST(Held_vertices, merge_where_they_meet_and_part_again)
{
  std::mt19937_64 random(17);
  Cloud<Epick> cloud(17);
  const auto meet = [&](Points& points, int frame) {
    cloud.shake(points, 0.1);
    if (frame % 2 == 0)
      for (int i = 0; i < 8; ++i)
        points[random() % points.size()] = points[random() % points.size()];
  };
  number_rebuilt<Holding<Epick>>(cloud.uniform(80), 40, meet);
}

// Those that have not moved rest where they are, though some of them are held among single points
// that trade places.
TEST(Held_vertices, rest_where_single_points_move_alone)
{
  Cloud<Epick> cloud(21);
  std::mt19937_64 random(21);
  Points points = cloud.uniform(800);
  Dynamic dt(points);
  for (int frame = 0; frame < 60; ++frame) {
    std::map<std::size_t, Point> moves;
    for (int k = 0; k < 6; ++k) {
      const std::size_t i = random() % points.size(), j = random() % points.size();
      std::swap(points[i], points[j]);
      moves[i] = points[i];
      moves[j] = points[j];
    }
    for (int k = 0; k < 6; ++k) {
      const std::size_t i = random() % points.size();
      moves[i] = points[i] = cloud.shifted(points[i], 2);
    }
    EXPECT_FALSE(dt.move(moves).rebuilt());
    ASSERT_NO_FATAL_FAILURE(expect_exact(dt, points)) << frame;
  }
}

// A repair of a user's that forgets to release, or to flip.
template <bool flips>
struct Forgetful_repair
{
  template <class Mender>
  void operator()(Mender& mender) const
  {
    mender.hold();
    if (flips)
      mender.flip();
  }
};

template <class Repair>
void expect_forgetting_is_made_good()
{
  Cloud<Epick> cloud(21);
  const auto shake = [&](Points& points, int) { cloud.shake(points, 0.3); };
  number_rebuilt<
      CGAL::Dynamic_Delaunay_triangulation_2<Epick, CGAL::Default, CGAL::With_repair_2<Repair>>>(
      cloud.uniform(100), 10, shake);
}

TEST(Held_vertices, arrive_though_a_repair_does_not_release_them)
{
  expect_forgetting_is_made_good<Forgetful_repair<true>>();
  expect_forgetting_is_made_good<Forgetful_repair<false>>();
}

// POINTS THAT COME AND GO -------------------------------------------------------------------------

// All move, many leave and many come, at the hull and inside, also where points coincide.
TEST(Held_vertices, rest_where_points_leave_and_come)
{
  for (const double step : {0., 0.05, 0.3}) {
    Cloud<Epick> cloud(31);
    std::mt19937_64 random(31);
    std::map<int, Point> frame;
    int next = 0;
    for (const Point& p : cloud.uniform(200))
      frame[next++] = p;
    CGAL::Dynamic_population_2<Dynamic, int> people;
    people.update(frame.begin(), frame.end());
    int rebuilt = 0;
    for (int i = 0; i < 25; ++i) {
      SCOPED_TRACE(testing::Message() << "step " << step << ", frame " << i);
      for (auto& [id, p] : frame)
        p = step > 0 ? cloud.shifted(p, step) : p;
      for (int k = 0; k < 20; ++k)
        frame.erase(std::next(frame.begin(), std::ptrdiff_t(random() % frame.size())));
      const Points others = cloud.uniform(200);
      for (std::size_t k = 0; k < 20; ++k)
        frame[next++] = others[k];
      for (int k = 0; k < 5; ++k)
        frame[next++] = std::next(frame.begin(), std::ptrdiff_t(random() % frame.size()))->second;
      const auto report = people.update(frame.begin(), frame.end());
      EXPECT_TRUE(report.certified);
      rebuilt += report.rebuilt();
      ASSERT_NO_FATAL_FAILURE(expect_exact_people(people, frame));
    }
    EXPECT_LE(rebuilt, step < 0.1 ? 2 : 25) << step;
  }
}

// PERIODIC SPACE ----------------------------------------------------------------------------------

using Cell = CGAL::Periodic_cell_2;
using Periodic =
    CGAL::Dynamic_periodic_Delaunay_triangulation_2<Epick, CGAL::Default,
                                                    CGAL::With_repair_2<Holding_repair>>;

Points shaken(std::mt19937_64& random, const Points& points, double step)
{
  std::normal_distribution<double> way(0, step);
  Points next;
  for (const Point& p : points) {
    const double x = p.x() + way(random);
    next.emplace_back(x, p.y() + way(random));
  }
  return next;
}

TEST(Held_vertices, follow_any_step_on_a_torus_and_in_a_slab)
{
  for (const std::size_t n : {1u, 2u, 5u, 12u, 60u})
    for (const double step : {0.05, 0.15, 0.5, 2.})
      for (const bool is_slab : {false, true}) {
        SCOPED_TRACE(testing::Message() << n << " points, step " << step << ", slab " << is_slab);
        std::mt19937_64 random(n + 3);
        const double side = std::sqrt(double(n));
        Points points = random_points(random, n, side);
        Periodic pt(points, is_slab ? Cell::slab(side, 0) : Cell(side, 0, 0.3 * side, side));
        for (int frame = 0; frame < 12; ++frame) {
          points = shaken(random, points, step);
          pt.update(points);
          ASSERT_NO_FATAL_FAILURE(expect_periodic_delaunay(pt)) << frame;
        }
      }
}

// At rest a vertex has gone along with the cell.
TEST(Held_vertices, go_along_with_a_cell_that_is_sheared)
{
  std::mt19937_64 random(5);
  Points points = random_points(random, 200, 14);
  CGAL::Dynamic_periodic_Delaunay_triangulation_2<Epick> pt(points, Cell(14, 14));
  std::size_t rebuilt = 0;
  for (int frame = 1; frame <= 20; ++frame) {
    points = shaken(random, points, 0.08);
    const double shear = 0.6 * frame;
    for (Point& p : points)
      p = Point(p.x() + 0.6 / 14 * p.y(), p.y());
    rebuilt += pt.update(points, Cell(14, 0, shear, 14)).rebuilt();
    ASSERT_NO_FATAL_FAILURE(expect_periodic_delaunay(pt)) << frame;
  }
  EXPECT_EQ(rebuilt, 0u);
}

// The lowest and the highest point of a slab, which have edges to their own images, change places
// with others. To triangulate a slab anew takes twenty times as long as such a frame.
TEST(Held_vertices, leave_the_sides_of_a_slab_without_a_rebuild)
{
  for (const double step : {0.03, 0.1, 0.2}) {
    std::mt19937_64 random(8);
    Points points = random_points(random, 150, 12);
    CGAL::Dynamic_periodic_Delaunay_triangulation_2<Epick> pt(points, Cell::slab(12, 0));
    std::size_t rebuilt = 0;
    for (int frame = 0; frame < 150; ++frame) {
      points = shaken(random, points, step);
      rebuilt += pt.update(points).rebuilt();
      ASSERT_TRUE(pt.is_valid(true)) << frame;
    }
    EXPECT_LE(rebuilt, 1u) << step;
  }
}

// In frame 21 a vertex at a side of the slab can neither move on nor be taken out, as its faces
// meet images of themselves. A rebuild would take a hundred times as long as a usual frame.
TEST(Held_vertices, go_on_at_a_side_of_a_slab_where_they_cannot_be_taken_out)
{
  const double side = std::sqrt(1000.0);
  std::mt19937_64 random(1), random_steps(7);
  std::uniform_real_distribution<double> coordinate(0, side);
  std::normal_distribution<double> step(0, 0.03);
  Points points;
  for (int i = 0; i < 1000; ++i) {
    const double x = coordinate(random), y = coordinate(random);
    points.emplace_back(x, y);
  }
  CGAL::Dynamic_periodic_Delaunay_triangulation_2<Epick> pt(points, Cell::slab(side, 0));
  for (int frame = 0; frame < 24; ++frame) {
    for (Point& p : points) {
      const double x = step(random_steps), y = step(random_steps);
      p = Point(p.x() + x, p.y() + y);
    }
    EXPECT_FALSE(pt.update(points).rebuilt()) << frame;
    ASSERT_TRUE(pt.is_valid(true)) << frame;
  }
}

TEST(Held_vertices, beside_a_slab_are_put_in_without_a_search_along_it)
{
  std::mt19937_64 random(6);
  Points points = random_points(random, 300, 17);
  CGAL::Dynamic_periodic_Delaunay_triangulation_2<Epick> pt(points, Cell::slab(17, 0));
  for (int frame = 0; frame < 20; ++frame) {
    points[std::size_t(frame)] = Point(8, frame % 2 == 0 ? 40 + frame : -40 - frame);
    EXPECT_FALSE(pt.update(points).rebuilt());
    ASSERT_NO_FATAL_FAILURE(expect_periodic_delaunay(pt)) << frame;
  }
}

} // namespace test_held_vertices

// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Whatever the points do, an exact update ends with the Delaunay triangulation.

#include "digest_of_motion.h"
#include "oracle.h"

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/proof/Edge_slack_2.h>

#include <random>
#include <utility>
#include <vector>

namespace test_exact_motion {

template <class Kernel>
class Exact_motion : public testing::Test
{
protected:
  using Dynamic = CGAL::Dynamic_Delaunay_triangulation_2<Kernel>;
  using Points = typename Cloud<Kernel>::Points;

  static CGAL::Update_report_2 update(Dynamic& dt, const Points& points)
  {
    const auto report = dt.update(points.begin(), points.end());
    EXPECT_TRUE(report.certified);
    expect_exact(dt, points);
    return report;
  }

  // `move` changes the points from frame to frame.
  template <class Move>
  static void follow(Points points, int frames, const Move& move)
  {
    Dynamic dt(points);
    ASSERT_NO_FATAL_FAILURE(expect_exact(dt, points));
    for (int frame = 0; frame < frames; ++frame) {
      move(points, frame);
      ASSERT_NO_FATAL_FAILURE(update(dt, points)) << "frame " << frame;
    }
  }
};

using Kernels = testing::Types<Epick, Epeck>;
TYPED_TEST_SUITE(Exact_motion, Kernels);

TYPED_TEST(Exact_motion, follows_random_clouds_at_every_step_size)
{
  for (const double step : {1e-6, 1e-4, 1e-3, 1e-2, 3e-2, 0.1, 0.3, 1., 10.})
    for (unsigned seed = 0; seed < 3; ++seed) {
      SCOPED_TRACE(testing::Message() << "step " << step << ", seed " << seed);
      Cloud<TypeParam> cloud(seed);
      ASSERT_NO_FATAL_FAILURE(this->follow(cloud.uniform(300), 12,
                                           [&](auto& points, int) { cloud.shake(points, step); }));
    }
}

TYPED_TEST(Exact_motion, follows_tiny_clouds_through_every_degeneracy)
{
  using Point = typename Cloud<TypeParam>::Point;
  for (unsigned seed = 0; seed < 60; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    std::mt19937 random(seed);
    std::uniform_int_distribution<int> coordinate(0, 2 + int(seed % 4));
    const typename TestFixture::Points at_origin(1 + seed % 9, Point(0, 0));
    ASSERT_NO_FATAL_FAILURE(this->follow(at_origin, 25, [&](auto& points, int frame) {
      for (Point& p : points)
        if (frame % 2 == 0 || random() % 3 == 0) {
          const int x = coordinate(random);
          p = Point(x, coordinate(random));
        }
    }));
  }
}

TYPED_TEST(Exact_motion, follows_lattices_that_tremble_and_come_to_rest)
{
  constexpr double steps[] = {0, 1e-15, 1e-9, 1e-3, 0.05, 0};
  for (unsigned seed = 0; seed < 2; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Cloud<TypeParam> cloud(seed);
    const auto lattice = cloud.grid(18, 14);
    ASSERT_NO_FATAL_FAILURE(this->follow(lattice, 18, [&](auto& points, int frame) {
      if (frame % 3 == 0) { // the other frames are at rest
        points = lattice;
        cloud.shake(points, steps[frame / 3]);
      }
    }));
  }
}

TYPED_TEST(Exact_motion, follows_points_onto_a_line_along_it_and_off_again)
{
  for (unsigned seed = 0; seed < 3; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Cloud<TypeParam> cloud(seed);
    ASSERT_NO_FATAL_FAILURE(this->follow(cloud.uniform(60), 9, [&](auto& points, int frame) {
      points = frame % 3 < 2 ? cloud.on_line(60) : cloud.uniform(60);
    }));
  }
}

TYPED_TEST(Exact_motion, follows_points_onto_a_circle_and_off_again)
{
  Cloud<TypeParam> cloud(5);
  const auto circle = cloud.on_circle(36);
  ASSERT_EQ(circle.size(), 36u);
  this->follow(circle, 12, [&](auto& points, int frame) {
    if (frame % 2 == 1)
      return cloud.shake(points, 1e-7);
    points = circle;
    std::shuffle(points.begin(), points.end(), cloud.random());
  });
}

TYPED_TEST(Exact_motion, follows_teleports_of_all_points_and_of_a_few_among_others_at_rest)
{
  Cloud<TypeParam> cloud(6);
  ASSERT_NO_FATAL_FAILURE(this->follow(
      cloud.uniform(400), 6, [&](auto& points, int) { points = cloud.uniform(points.size()); }));
  this->follow(cloud.uniform(500), 20, [&](auto& points, int) {
    const auto elsewhere = cloud.uniform(points.size());
    for (int i = 0; i < 4; ++i)
      points[cloud.random()() % points.size()] = elsewhere[std::size_t(i)];
  });
}

TYPED_TEST(Exact_motion, follows_everything_shrunk_to_1e_100_and_carried_to_1e9)
{
  Cloud<TypeParam> cloud(8);
  auto first = cloud.uniform(200);
  this->follow(first, 9, [&](auto& points, int frame) {
    cloud.shake(first, 0.02);
    points = frame % 3 == 0   ? scaled<TypeParam>(first, 1e-100)
             : frame % 3 == 1 ? scaled<TypeParam>(first, 1, 1e9)
                              : scaled<TypeParam>(first, 1e100);
  });
}

TYPED_TEST(Exact_motion, needs_no_rebuild_when_everything_is_shrunk_or_turned_around)
{
  const auto points = Cloud<TypeParam>(9).uniform(200);
  typename TestFixture::Dynamic dt(points);
  EXPECT_FALSE(this->update(dt, scaled<TypeParam>(points, 0.5)).rebuilt());
  EXPECT_FALSE(this->update(dt, scaled<TypeParam>(points, -2)).rebuilt());
}

TYPED_TEST(Exact_motion, follows_everything_mirrored_in_one_frame)
{
  this->follow(Cloud<TypeParam>(10).uniform(200), 2, [](auto& points, int) {
    for (auto& p : points)
      p = typename Cloud<TypeParam>::Point(-p.x(), p.y());
  });
}

TYPED_TEST(Exact_motion, keeps_coincident_points_for_any_number_of_frames)
{
  for (unsigned seed = 0; seed < 4; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Cloud<TypeParam> cloud(seed);
    ASSERT_NO_FATAL_FAILURE(this->follow(cloud.uniform(80), 15, [&](auto& points, int frame) {
      cloud.shake(points, 0.01);
      if (frame % 5 != 4) // pairs and a triple that meet, stay together, and part every fifth frame
        for (std::size_t i = 0; i < 6; ++i)
          points[i] = points[i < 3 ? 50 : 60 + i];
    }));
  }
}

TYPED_TEST(Exact_motion, follows_all_points_into_one_place_and_out_again)
{
  const auto first = Cloud<TypeParam>(11).uniform(40);
  this->follow(first, 3, [&](auto& points, int frame) {
    points = first;
    if (frame < 2)
      points.assign(40, first[std::size_t(7 + frame)]);
  });
}

TYPED_TEST(Exact_motion, follows_two_points_that_swap_and_a_hull_that_turns_inside_out)
{
  auto swapped = Cloud<TypeParam>(12).uniform(150);
  std::swap(swapped[3], swapped[4]);
  this->follow(Cloud<TypeParam>(12).uniform(150), 3, [&](auto& points, int frame) {
    points = swapped;
    for (auto& p : points) // inversion in a circle around a point inside
      if (frame == 1) {
        const double x = CGAL::to_double(p.x()) - 6.1, y = CGAL::to_double(p.y()) - 6.2;
        p = typename Cloud<TypeParam>::Point(x / (x * x + y * y), y / (x * x + y * y));
      }
  });
}

// A star of six faces around vertex 0 that winds around it twice: all faces counterclockwise, all
// edges locally Delaunay, the hull convex at each vertex. Only its number of turns gives it away.
TYPED_TEST(Exact_motion, is_not_deceived_by_a_star_that_winds_twice)
{
  typename TestFixture::Points once, twice;
  once.emplace_back(0, 0);
  twice.emplace_back(0, 0);
  for (int i = 0; i < 6; ++i) {
    const double angle = CGAL_PI / 3 * i;
    once.emplace_back(std::cos(angle), std::sin(angle));
    const double radius = 1 + 0.01 * i;
    twice.emplace_back(radius * std::cos(2 * angle + 0.01 * i),
                       radius * std::sin(2 * angle + 0.01 * i));
  }
  typename TestFixture::Dynamic dt(once.begin(), once.end());
  this->update(dt, twice);

  typename TestFixture::Dynamic one_by_one(once.begin(), once.end());
  std::vector<std::pair<std::size_t, typename TestFixture::Points::value_type>> movers;
  for (std::size_t i = 0; i < twice.size(); ++i)
    movers.emplace_back(i, twice[i]);
  one_by_one.move(movers);
  expect_exact(one_by_one, twice);
}

class Exact_coordinates : public Exact_motion<Epeck>
{
};

TEST_F(Exact_coordinates, that_are_no_doubles_leave_the_signs_to_the_kernel)
{
  Cloud<Epeck> cloud(13);
  auto points = cloud.uniform(60);
  CGAL::Dynamic_Delaunay_triangulation_2<Epeck> dt(points.begin(), points.end());
  for (int frame = 1; frame < 5; ++frame) {
    std::vector<Epeck::Point_2> thirds; // a third is no double
    for (const auto& p : points)
      thirds.emplace_back(p.x() / 3 * frame, p.y() / 3 * frame);
    thirds[1] = CGAL::midpoint(thirds[2], thirds[3]); // exactly on their line
    dt.update(thirds.begin(), thirds.end());
    EXPECT_FALSE(dt.frame().positions_are_exact());
    ASSERT_NO_FATAL_FAILURE(expect_exact(dt, thirds));
  }
}

// Their rounded positions are another cloud, on a lattice, for which every filter is certain.
TEST_F(Exact_coordinates, that_differ_by_less_than_doubles_do_are_told_apart)
{
  std::mt19937 random(5);
  std::uniform_int_distribution<int> sevenths(0, 7 * 16);
  const auto coordinate = [&] { return Epeck::FT(1) + Epeck::FT(sevenths(random)) / 7 * 0x1p-52; };
  const auto cloud = [&] {
    std::vector<Epeck::Point_2> points;
    for (int i = 0; i < 60; ++i) {
      const Epeck::FT x = coordinate(), y = coordinate();
      points.emplace_back(x, y);
    }
    return points;
  };
  follow(cloud(), 30, [&](auto& points, int frame) {
    const auto others = cloud();
    for (std::size_t i = 0; i < points.size(); i += frame % 2 == 0 ? 13 : 1)
      points[i] = others[i];
  });
}

// The rounded positions stay where they are while the edges change.
TEST_F(Exact_coordinates, that_move_by_less_than_doubles_tell_are_followed)
{
  std::mt19937 random(6);
  std::vector<std::pair<int, int>> places;
  for (int i = 0; i < 60; ++i)
    places.emplace_back(4 * (i % 8) + int(random() % 4), 4 * (i / 8) + int(random() % 4));
  const auto coordinate = [&](int place) {
    const int sevenths = int(random() % 7) - 3;
    return Epeck::FT(1) + (Epeck::FT(place) + Epeck::FT(sevenths) / 7) * 0x1p-52;
  };
  const auto cloud = [&] {
    std::vector<Epeck::Point_2> points;
    for (const auto& [x, y] : places) {
      const Epeck::FT first = coordinate(x);
      points.emplace_back(first, coordinate(y));
    }
    return points;
  };
  follow(cloud(), 20, [&](auto& points, int) { points = cloud(); });
}

// Faces, numbers of edges, tolerances, and how far edges are from being illegal, on all processors.
TEST(Every_processor, leads_to_the_same_bits)
{
  using CGAL::Dynamic_Delaunay_triangulations_2::internal::Plane_slacks_2;
  Exact_steps steps;
  auto points = steps.start(1000, 32);
  CGAL::Dynamic_Delaunay_triangulation_2<Epick> dt(points);
  Digest digest;
  for (int frame = 0; frame < 200; ++frame) {
    steps.move(points, frame);
    const auto report = dt.update(points);
    add_frame<Plane_slacks_2>(digest, report, dt.frame());
  }
  EXPECT_EQ(digest.value(), 4738771860595654707u);
}

} // namespace test_exact_motion

// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Whatever the points do, an exact update ends with the Delaunay triangulation.

#include "oracle.h"

#include <random>
#include <utility>
#include <vector>

namespace {

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
};

using Kernels = testing::Types<Epick, Epeck>;
TYPED_TEST_SUITE(Exact_motion, Kernels);

TYPED_TEST(Exact_motion, follows_random_clouds_at_every_step_size)
{
  for (const double step : {1e-6, 1e-4, 1e-3, 1e-2, 3e-2, 0.1, 0.3, 1., 10.})
    for (unsigned seed = 0; seed < 3; ++seed) {
      SCOPED_TRACE(testing::Message() << "step " << step << ", seed " << seed);
      Cloud<TypeParam> cloud(seed);
      auto points = cloud.uniform(300);
      typename TestFixture::Dynamic dt(points.begin(), points.end());
      for (int frame = 0; frame < 12; ++frame) {
        cloud.shake(points, step);
        this->update(dt, points);
        if (this->HasFatalFailure())
          return;
      }
    }
}

TYPED_TEST(Exact_motion, follows_tiny_clouds_through_every_degeneracy)
{
  for (unsigned seed = 0; seed < 60; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Cloud<TypeParam> cloud(seed);
    std::uniform_int_distribution<int> coordinate(0, 2 + int(seed % 4));
    typename TestFixture::Points points(1 + seed % 9, typename Cloud<TypeParam>::Point(0, 0));
    typename TestFixture::Dynamic dt(points.begin(), points.end());
    for (int frame = 0; frame < 25; ++frame) {
      for (auto& p : points)
        if (frame % 2 == 0 || cloud.random()() % 3 == 0) {
          const int x = coordinate(cloud.random());
          p = typename Cloud<TypeParam>::Point(x, coordinate(cloud.random()));
        }
      this->update(dt, points);
      if (this->HasFatalFailure())
        return;
    }
  }
}

TYPED_TEST(Exact_motion, follows_lattices_that_tremble_and_come_to_rest)
{
  for (unsigned seed = 0; seed < 2; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Cloud<TypeParam> cloud(seed);
    const auto lattice = cloud.grid(18, 14);
    typename TestFixture::Dynamic dt(lattice.begin(), lattice.end());
    for (const double step : {0., 1e-15, 1e-9, 1e-3, 0.05, 0.}) {
      auto points = lattice;
      if (step > 0)
        cloud.shake(points, step);
      for (int frame = 0; frame < 3; ++frame) {
        this->update(dt, points);
        if (this->HasFatalFailure())
          return;
      }
    }
  }
}

TYPED_TEST(Exact_motion, follows_points_onto_a_line_along_it_and_off_again)
{
  for (unsigned seed = 0; seed < 3; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Cloud<TypeParam> cloud(seed);
    auto points = cloud.uniform(60);
    typename TestFixture::Dynamic dt(points.begin(), points.end());
    for (int round = 0; round < 3; ++round) {
      this->update(dt, cloud.on_line(points.size()));
      this->update(dt, cloud.on_line(points.size()));
      this->update(dt, cloud.uniform(points.size()));
      if (this->HasFatalFailure())
        return;
    }
  }
}

TYPED_TEST(Exact_motion, follows_points_onto_a_circle_and_off_again)
{
  Cloud<TypeParam> cloud(5);
  auto points = cloud.on_circle(36);
  ASSERT_EQ(points.size(), 36u);
  typename TestFixture::Dynamic dt(points.begin(), points.end());
  for (int round = 0; round < 6; ++round) {
    auto moved = cloud.on_circle(36);
    std::shuffle(moved.begin(), moved.end(), cloud.random());
    this->update(dt, moved);
    cloud.shake(moved, 1e-7);
    this->update(dt, moved);
    if (this->HasFatalFailure())
      return;
  }
}

TYPED_TEST(Exact_motion, follows_teleports)
{
  Cloud<TypeParam> cloud(6);
  auto points = cloud.uniform(400);
  typename TestFixture::Dynamic dt(points.begin(), points.end());
  for (int frame = 0; frame < 6; ++frame) {
    this->update(dt, cloud.uniform(points.size()));
    if (this->HasFatalFailure())
      return;
  }
}

TYPED_TEST(Exact_motion, follows_a_few_teleports_among_points_at_rest)
{
  Cloud<TypeParam> cloud(7);
  auto points = cloud.uniform(500);
  typename TestFixture::Dynamic dt(points.begin(), points.end());
  for (int frame = 0; frame < 20; ++frame) {
    const auto elsewhere = cloud.uniform(points.size());
    for (int i = 0; i < 4; ++i)
      points[cloud.random()() % points.size()] = elsewhere[std::size_t(i)];
    this->update(dt, points);
    if (this->HasFatalFailure())
      return;
  }
}

TYPED_TEST(Exact_motion, follows_everything_shrunk_to_1e_100_and_carried_to_1e9)
{
  Cloud<TypeParam> cloud(8);
  auto points = cloud.uniform(200);
  typename TestFixture::Dynamic dt(points.begin(), points.end());
  for (int round = 0; round < 3; ++round) {
    cloud.shake(points, 0.02);
    this->update(dt, scaled<TypeParam>(points, 1e-100));
    cloud.shake(points, 0.02);
    this->update(dt, scaled<TypeParam>(points, 1, 1e9));
    cloud.shake(points, 0.02);
    this->update(dt, scaled<TypeParam>(points, 1e100));
    if (this->HasFatalFailure())
      return;
  }
}

TYPED_TEST(Exact_motion, needs_no_rebuild_when_everything_is_shrunk_or_turned_around)
{
  Cloud<TypeParam> cloud(9);
  const auto points = cloud.uniform(200);
  typename TestFixture::Dynamic dt(points.begin(), points.end());
  EXPECT_FALSE(this->update(dt, scaled<TypeParam>(points, 0.5)).rebuilt());
  EXPECT_FALSE(this->update(dt, scaled<TypeParam>(points, -2)).rebuilt());
}

TYPED_TEST(Exact_motion, follows_everything_mirrored_in_one_frame)
{
  Cloud<TypeParam> cloud(10);
  const auto points = cloud.uniform(200);
  typename TestFixture::Dynamic dt(points.begin(), points.end());
  typename TestFixture::Points mirrored;
  for (const auto& p : points)
    mirrored.emplace_back(-p.x(), p.y());
  this->update(dt, mirrored);
  this->update(dt, points);
}

TYPED_TEST(Exact_motion, keeps_coincident_points_for_any_number_of_frames)
{
  for (unsigned seed = 0; seed < 4; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Cloud<TypeParam> cloud(seed);
    auto points = cloud.uniform(80);
    typename TestFixture::Dynamic dt(points.begin(), points.end());
    for (int frame = 0; frame < 15; ++frame) {
      cloud.shake(points, 0.01);
      if (frame % 5 != 4) // pairs and a triple that meet, stay together, and part every fifth frame
        for (std::size_t i = 0; i < 6; ++i)
          points[i] = points[i < 3 ? 50 : 60 + i];
      this->update(dt, points);
      if (this->HasFatalFailure())
        return;
    }
  }
}

TYPED_TEST(Exact_motion, follows_all_points_into_one_place_and_out_again)
{
  Cloud<TypeParam> cloud(11);
  auto points = cloud.uniform(40);
  typename TestFixture::Dynamic dt(points.begin(), points.end());
  this->update(dt, typename TestFixture::Points(40, points[7]));
  this->update(dt, typename TestFixture::Points(40, points[8]));
  this->update(dt, points);
}

TYPED_TEST(Exact_motion, follows_two_points_that_swap_and_a_hull_that_turns_inside_out)
{
  Cloud<TypeParam> cloud(12);
  auto points = cloud.uniform(150);
  typename TestFixture::Dynamic dt(points.begin(), points.end());
  std::swap(points[3], points[4]);
  this->update(dt, points);
  typename TestFixture::Points inverted;
  for (const auto& p : points) { // inversion in a circle around a point inside
    const double x = CGAL::to_double(p.x()) - 6.1, y = CGAL::to_double(p.y()) - 6.2;
    inverted.emplace_back(x / (x * x + y * y), y / (x * x + y * y));
  }
  this->update(dt, inverted);
  this->update(dt, points);
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

TEST(Exact_coordinates, that_are_no_doubles_leave_the_signs_to_the_kernel)
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

// Their rounded positions are another cloud, on a lattice, of which every filter is sure.
TEST(Exact_coordinates, that_differ_by_less_than_doubles_do_are_told_apart)
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
  const auto points = cloud();
  CGAL::Dynamic_Delaunay_triangulation_2<Epeck> dt(points.begin(), points.end());
  ASSERT_NO_FATAL_FAILURE(expect_exact(dt, points));
  auto next = points;
  for (int frame = 0; frame < 30; ++frame) {
    const auto others = cloud();
    for (std::size_t i = 0; i < next.size(); i += frame % 2 == 0 ? 13 : 1)
      next[i] = others[i];
    dt.update(next.begin(), next.end());
    ASSERT_NO_FATAL_FAILURE(expect_exact(dt, next));
  }
}

// The rounded positions stay where they are while the edges change.
TEST(Exact_coordinates, that_move_by_less_than_doubles_tell_are_followed)
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
  const auto points = cloud();
  CGAL::Dynamic_Delaunay_triangulation_2<Epeck> dt(points.begin(), points.end());
  for (int frame = 0; frame < 20; ++frame) {
    const auto next = cloud();
    dt.update(next.begin(), next.end());
    ASSERT_NO_FATAL_FAILURE(expect_exact(dt, next));
  }
}

} // namespace

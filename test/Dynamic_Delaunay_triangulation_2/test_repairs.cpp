// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// What every repair promises and reports, with every classifier.

#include "oracle.h"

#include <CGAL/Dynamic_Delaunay_triangulation_2/classifiers/Point_distance_classifier_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/classifiers/Random_classifier_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/repairs/Border_splice_repair_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/repairs/Flip_repair_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/repairs/Rebuild_repair_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/repairs/Relocation_repair_2.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

namespace test_repairs {

using Points = Cloud<Epick>::Points;

template <class Repair>
class Repairs : public testing::Test
{
protected:
  using Exact =
      CGAL::Dynamic_Delaunay_triangulation_2<Epick, CGAL::Default, CGAL::With_repair_2<Repair>>;
  using Heuristic = CGAL::Dynamic_Delaunay_triangulation_2<Epick, CGAL::Point_distance_classifier_2,
                                                           CGAL::With_repair_2<Repair>>;
  using Random = CGAL::Dynamic_Delaunay_triangulation_2<Epick, CGAL::Random_classifier_2,
                                                        CGAL::With_repair_2<Repair>>;
};

using All_repairs =
    testing::Types<CGAL::Flip_repair_2, CGAL::Border_splice_repair_2, CGAL::Relocation_repair_2,
                   CGAL::Rebuild_repair_2, CGAL::Hold_and_flip_repair_2>;
TYPED_TEST_SUITE(Repairs, All_repairs);

TYPED_TEST(Repairs, end_certified_with_an_exact_classifier)
{
  for (const double step : {1e-3, 0.02, 0.2, 2.})
    for (unsigned seed = 0; seed < 2; ++seed) {
      SCOPED_TRACE(testing::Message() << "step " << step << ", seed " << seed);
      Cloud<Epick> cloud(seed);
      auto points = cloud.uniform(250);
      typename TestFixture::Exact dt(points.begin(), points.end());
      for (int frame = 0; frame < 12; ++frame) {
        cloud.shake(points, step);
        if (frame == 6)
          points[3] = points[200]; // meet
        dt.update(points.begin(), points.end());
        ASSERT_NO_FATAL_FAILURE(expect_exact(dt, points));
      }
    }
}

TYPED_TEST(Repairs, keep_the_structure_valid_with_heuristic_classifiers)
{
  for (const double step : {0.01, 0.1, 1.}) {
    SCOPED_TRACE(testing::Message() << "step " << step);
    Cloud<Epick> cloud(3);
    auto points = cloud.uniform(250);
    typename TestFixture::Heuristic distance(points.begin(), points.end(),
                                             CGAL::Point_distance_classifier_2(0.6));
    typename TestFixture::Random random(points.begin(), points.end(),
                                        CGAL::Random_classifier_2(0.02, 7));
    for (int frame = 0; frame < 20; ++frame) {
      cloud.shake(points, step);
      distance.update(points.begin(), points.end());
      random.update(points.begin(), points.end());
      ASSERT_NO_FATAL_FAILURE(expect_valid(distance, points));
      ASSERT_NO_FATAL_FAILURE(expect_valid(random, points));
    }
    distance.mend();
    ASSERT_NO_FATAL_FAILURE(expect_exact(distance, points));
  }
}

// A point moves into the circle on which all others are. Few edges are broken then, but each flip
// leads to the next: a repair by flips would take hundreds and gives up before.
TYPED_TEST(Repairs, lose_no_edge_where_flips_end_in_a_long_series)
{
  constexpr int n = 300;
  const auto place = [](double radius, double i) {
    const double angle = 2 * CGAL_PI * i / n;
    return Epick::Point_2(radius * std::cos(angle), radius * std::sin(angle));
  };
  Points points;
  for (int i = 0; i < n; ++i)
    points.push_back(place(100, i));
  points.push_back(place(100.001, 0.5));
  typename TestFixture::Exact dt(points.begin(), points.end());
  points.back() = place(99.999, 0.5);
  const auto report = dt.update(points.begin(), points.end());
  EXPECT_LT(report.classified, 10u);
  expect_exact(dt, points);
}

// Where faces overlap, a flip between two counterclockwise ones could make an edge that exists
// already: its vertices would then be those of two edges, and the flat arrays inconsistent.
TEST(Flips, never_double_an_edge_however_rough_the_motion)
{
  for (unsigned seed = 0; seed < 12; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Cloud<Epick> cloud(seed);
    auto points = cloud.uniform(120);
    CGAL::Dynamic_Delaunay_triangulation_2<Epick, CGAL::Point_distance_classifier_2,
                                           CGAL::With_repair_2<CGAL::Flip_repair_2>>
        dt(points.begin(), points.end(), CGAL::Point_distance_classifier_2(0.6));
    for (int frame = 0; frame < 20; ++frame) {
      cloud.shake(points, 1);
      dt.update(points.begin(), points.end());
      ASSERT_NO_FATAL_FAILURE(expect_valid(dt, points));
    }
  }
}

TEST(Hold_and_flip, needs_no_rebuild_on_brownian_motion)
{
  for (const double step : {0.001, 0.01, 0.05}) {
    Cloud<Epick> cloud(4);
    auto points = cloud.uniform(2000);
    CGAL::Dynamic_Delaunay_triangulation_2<Epick> dt(points.begin(), points.end());
    std::size_t flips = 0;
    for (int frame = 0; frame < 20; ++frame) {
      cloud.shake(points, step);
      const auto report = dt.update(points.begin(), points.end());
      EXPECT_FALSE(report.rebuilt());
      flips += report.flips;
    }
    EXPECT_GT(flips, 0u);
    ASSERT_NO_FATAL_FAILURE(expect_exact(dt, points));
  }
}

// A hopeless frame costs a rebuild and no more: a sample of edges finds it before the classifier
// is asked.
TEST(Hold_and_flip, classifies_nothing_where_all_points_are_elsewhere)
{
  Cloud<Epick> cloud(2);
  auto points = cloud.uniform(2000);
  CGAL::Dynamic_Delaunay_triangulation_2<Epick> dt(points.begin(), points.end());
  for (int frame = 0; frame < 5; ++frame) {
    points = cloud.uniform(2000);
    const CGAL::Update_report_2 report = dt.update(points.begin(), points.end());
    EXPECT_EQ(report.rebuild_reason, CGAL::Rebuild_reason_2::TOO_MUCH_BROKEN);
    EXPECT_EQ(report.classified + report.flips, 0u);
    ASSERT_NO_FATAL_FAILURE(expect_exact(dt, points));
  }
  cloud.shake(points, 1e-4);
  EXPECT_FALSE(dt.update(points.begin(), points.end()).rebuilt());
  ASSERT_NO_FATAL_FAILURE(expect_exact(dt, points));
}

// A hundred frames that look as if they could be mended, and cannot be.
TEST(Hold_and_flip, tries_what_was_in_vain_less_and_less_often)
{
  Cloud<Epick> cloud(5);
  auto points = cloud.uniform(1500);
  CGAL::Dynamic_Delaunay_triangulation_2<Epick> dt(points.begin(), points.end());
  std::size_t in_vain = 0, rebuilt = 0;
  for (int frame = 0; frame < 100; ++frame) {
    for (std::size_t i = std::size_t(frame) % 4; i < points.size(); i += 4)
      points[i] = cloud.shifted(points[i], 2);
    const CGAL::Update_report_2 report = dt.update(points.begin(), points.end());
    in_vain += report.rebuilt() && report.classified > 0;
    rebuilt += report.rebuilt();
    ASSERT_TRUE(report.certified);
  }
  EXPECT_GT(rebuilt, 50u);
  EXPECT_LT(in_vain, 25u);
  ASSERT_NO_FATAL_FAILURE(expect_exact(dt, points));
}

// SHARES OF BROKEN EDGES --------------------------------------------------------------------------

using CGAL::Dynamic_Delaunay_triangulations_2::internal::Repair_experience_2;

TEST(Repair_experience, expects_nothing_before_something_was_in_vain)
{
  Repair_experience_2 experience;
  EXPECT_FALSE(experience.has_failed_recently());
  EXPECT_FALSE(experience.is_hopeless(100, 100));
  experience.record_success(50, 100);
  experience.record_not_tried();
  EXPECT_FALSE(experience.has_failed_recently());
}

TEST(Repair_experience, expects_the_same_of_as_much_until_that_was_mended)
{
  Repair_experience_2 experience;
  experience.record_failure(10, 100);
  EXPECT_TRUE(experience.is_hopeless(100, 10));
  EXPECT_TRUE(experience.is_hopeless(100, 8));
  EXPECT_FALSE(experience.is_hopeless(100, 7));
  experience.record_success(7, 100); // more than half of it: still near
  EXPECT_TRUE(experience.is_hopeless(100, 8));
  experience.record_success(12, 100);
  EXPECT_FALSE(experience.is_hopeless(100, 10));
  EXPECT_TRUE(experience.is_hopeless(100, 12));
  experience.record_success(1, 100);
  EXPECT_FALSE(experience.has_failed_recently());
}

TEST(Repair_experience, tries_again_the_sooner_the_more_that_may_save)
{
  const auto frames_not_tried = [](std::size_t broken) {
    Repair_experience_2 experience;
    experience.record_failure(broken, 1000);
    std::size_t frames = 0;
    while (experience.is_hopeless(1000, broken) && frames < 1000) {
      experience.record_not_tried();
      ++frames;
    }
    return frames;
  };
  EXPECT_LE(frames_not_tried(1), 1u);
  EXPECT_LE(frames_not_tried(30), 3u);
  EXPECT_GT(frames_not_tried(150), 5u);
  EXPECT_GT(frames_not_tried(180), frames_not_tried(150));
  EXPECT_LT(frames_not_tried(180), 40u);
}

TEST(Repair_experience, counts_any_number_of_edges)
{
  Repair_experience_2 experience;
  experience.record_failure(0, 0);
  EXPECT_FALSE(experience.is_hopeless(0, 0));
  experience.record_failure(0, 3);
  EXPECT_FALSE(experience.is_hopeless(3, 0));
  experience = Repair_experience_2();
  experience.record_failure(1u << 31, 3u << 30);
  EXPECT_TRUE(experience.is_hopeless(3, 2));
  EXPECT_FALSE(experience.is_hopeless(3, 1));
}

TEST(Open_edges, are_listed_once_in_their_order_however_dense_they_are)
{
  using CGAL::Dynamic_Delaunay_triangulations_2::Index;
  using CGAL::Dynamic_Delaunay_triangulations_2::internal::make_distinct;
  std::mt19937 random(1);
  for (const std::size_t size : {0u, 1u, 63u, 64u, 65u, 1000u})
    for (const Index smallest : {0u, 63u, 1u << 31})
      for (const Index range : {1u, 64u, 65u, 1000u, 1u << 16, 1u << 20, (1u << 31) - 1}) {
        std::uniform_int_distribution<Index> number(smallest, smallest + range - 1);
        std::vector<Index> edges(size);
        for (Index& e : edges)
          e = number(random);
        std::vector<Index> expected = edges;
        std::sort(expected.begin(), expected.end());
        expected.erase(std::unique(expected.begin(), expected.end()), expected.end());
        make_distinct(edges);
        ASSERT_EQ(edges, expected) << size << " from " << smallest << " in " << range;
      }
}

TEST(Border_splice, catches_a_fast_point_by_growing)
{
  auto points = Cloud<Epick>::grid(20, 20);
  Cloud<Epick> cloud(5);
  cloud.shake(points, 0.01);
  CGAL::Dynamic_Delaunay_triangulation_2<Epick, CGAL::Default,
                                         CGAL::With_repair_2<CGAL::Border_splice_repair_2>>
      dt(points.begin(), points.end(),
         {CGAL::Circumcircle_classifier_2(), CGAL::Border_splice_repair_2(1)});
  points[150] = Epick::Point_2(points[150].x() + 5.3, points[150].y() + 0.2);
  const auto report = dt.update(points.begin(), points.end());
  EXPECT_FALSE(report.rebuilt());
  EXPECT_GT(report.enlargements, 0u);
  ASSERT_NO_FATAL_FAILURE(expect_exact(dt, points));
}

// Classifies only the point with id 0, the only one that moves.
struct Flier_classifier
{
  static constexpr bool is_exact = false;

  template <class Frame, class Classification>
  void operator()(const Frame&, Classification& classified) const
  {
    classified.add_id(0);
  }
};

struct Flight
{
  int right_frames = 0;
  std::size_t enlargements = 0;
};

// Moves a point through a cloud at rest, by two spacings a frame. `check` is called in each frame.
template <class Classifier, class Check>
Flight flight(unsigned padding, const Check& check)
{
  using Dynamic =
      CGAL::Dynamic_Delaunay_triangulation_2<Epick, Classifier,
                                             CGAL::With_repair_2<CGAL::Border_splice_repair_2>>;
  Cloud<Epick> cloud(1);
  auto points = cloud.uniform(900);
  points[0] = Epick::Point_2(2, 6);
  Dynamic dt(points.begin(), points.end(), {Classifier(), CGAL::Border_splice_repair_2(padding)});
  Flight flight;
  for (int frame = 0; frame < 12; ++frame) {
    points[0] = points[0] + Epick::Vector_2(1.8, 0.9);
    const auto report = dt.update(points.begin(), points.end());
    EXPECT_FALSE(report.rebuilt());
    flight.enlargements += report.enlargements;
    check(dt, points);
    flight.right_frames += dt.certify();
  }
  return flight;
}

template <class Classifier>
Flight flight(unsigned padding)
{
  return flight<Classifier>(padding,
                            [](const auto& dt, const Points& points) { expect_valid(dt, points); });
}

// Thesis 6.2.2. The region grows until its boundaries agree, so that no edge goes missing, but with
// a heuristic nothing looks across them.
TEST(Border_splice, is_outrun_by_a_fast_point_under_a_heuristic_with_too_little_padding)
{
  const Flight outrun = flight<Flier_classifier>(0);
  EXPECT_LT(outrun.right_frames, 12);
  EXPECT_GT(outrun.enlargements, 0u);
  EXPECT_LT(flight<Flier_classifier>(1).right_frames, 12);
  const Flight kept_up = flight<Flier_classifier>(4);
  EXPECT_EQ(kept_up.right_frames, 12);
  EXPECT_EQ(kept_up.enlargements, 0u);
}

TEST(Border_splice, is_outrun_by_no_point_under_an_exact_classifier_with_any_padding)
{
  for (const unsigned padding : {0u, 1u, 2u, 4u}) {
    SCOPED_TRACE(testing::Message() << "padding " << padding);
    const Flight kept_up = flight<CGAL::Circumcircle_classifier_2>(
        padding, [](const auto& dt, const Points& points) { expect_exact(dt, points); });
    EXPECT_EQ(kept_up.right_frames, 12);
    EXPECT_TRUE(padding > 0 || kept_up.enlargements > 0);
  }
}

// Names the same vertices in every frame, whatever has happened.
struct Named_vertices_classifier
{
  static constexpr bool is_exact = false;

  template <class Frame, class Classification>
  void operator()(const Frame&, Classification& classified) const
  {
    for (const std::size_t id : ids)
      classified.add_id(id);
  }

  std::vector<std::size_t> ids;
};

using Named_vertices_triangulation =
    CGAL::Dynamic_Delaunay_triangulation_2<Epick, Named_vertices_classifier,
                                           CGAL::With_repair_2<CGAL::Border_splice_repair_2>>;

CGAL::Update_report_2 splice_around(const Points& points, const Points& moved,
                                    const std::vector<std::size_t>& ids)
{
  Named_vertices_triangulation dt(
      points, {Named_vertices_classifier{ids}, CGAL::Border_splice_repair_2(0)});
  const auto report = dt.update(moved);
  expect_valid(dt, moved);
  dt.mend();
  expect_exact(dt, moved);
  return report;
}

// Adds points far from all others, so that the share of a region is small enough for a splice.
void add_ring(Points& points)
{
  for (int i = 0; i < 24; ++i)
    points.push_back(Epick::Point_2(40 * std::cos(0.2618 * i), 40 * std::sin(0.2618 * i)));
}

// The edge between 2 and 3 has 4 on its upper side, then 0 and 1. Then 4 and 0 go below it: alone,
// 0 and 1 with their neighbors have a triangulation with the old boundary in which 2 and 3 are
// joined between 0 and 1. But the old edge is still there, at a face that is not named.
TEST(Border_splice, doubles_no_edge_that_a_face_has_that_is_not_named)
{
  using Point = Epick::Point_2;
  Points points = {Point(0, 2.6), Point(0, 3.8),    Point(-1, 0),    Point(1, 0),   Point(0, 0.7),
                   Point(0, 7.6), Point(-3.7, 4.1), Point(3.7, 4.1), Point(0, -6.9)};
  add_ring(points);
  Points moved = points;
  moved[0] = Point(0, -1.2);
  moved[1] = Point(0, 1.1);
  moved[4] = Point(0, -1.8);
  EXPECT_GT(splice_around(points, moved, {0, 1}).enlargements, 0u);
}

// The triangle of the points 0, 1, 2 holds 4, 5, 6, and these hold 3. Then it is mirrored, 3 stays
// inside, and the others end up around it: alone, all seven have a triangulation with the old
// boundary and as many faces, whose new faces lie outside of it, have the infinite vertex and
// not 3.
TEST(Border_splice, loses_no_point_in_a_cluster_that_is_turned_inside_out)
{
  using Point = Epick::Point_2;
  Points points = {Point(-3, -2),     Point(3, -2),     Point(0, 4),  Point(0, 0),
                   Point(-0.5, -0.5), Point(0.5, -0.4), Point(0, 0.6)};
  Points moved = {Point(3, -2),     Point(-3, -2), Point(0, 4),    Point(0, 0.1),
                  Point(-0.1, -15), Point(12, 9),  Point(-12, 9.1)};
  add_ring(points);
  add_ring(moved);
  splice_around(points, moved, {4, 5, 6});
}

// Alone, the region has a triangulation whose faces around the points 3 and 5 have the old
// boundary, but another number. Found by a search for such a case.
TEST(Border_splice, loses_no_point_where_the_old_boundary_has_another_number_of_faces)
{
  Points points = {{8, -8}, {-6, 1}, {-7, 9}, {-8, -6}, {8, 9}, {-3, -5}, {-6, 0}};
  Points moved = {{8, -8}, {4, 1}, {-10, 6}, {-8, -6}, {-5, -1}, {-7, 0}, {9, -7}};
  add_ring(points);
  add_ring(moved);
  splice_around(points, moved, {3, 5});
}

// Around the point 0, named vertices and triangles that are not named take turns, three of each.
// Two of the triangles change places: the new faces have the old boundary, and meet otherwise at
// the point 0. The triangles beyond fill the same holes.
TEST(Border_splice, needs_no_larger_region_where_triangles_at_its_border_change_places)
{
  Points points = {{0, 0}};
  const auto add = [&](double radius, double degrees) {
    const double angle = degrees * CGAL_PI / 180;
    points.push_back(Epick::Point_2(radius * std::cos(angle), radius * std::sin(angle)));
  };
  for (const double degrees : {40., 80., 160., 200., 280., 320.})
    add(1, degrees); // the triangles, with the point 0: 1 and 2, 3 and 4, 5 and 6
  for (const double degrees : {0., 120., 240.}) {
    add(1, degrees); // between the triangles
    add(2, degrees + 60);
  }
  for (int i = 0; i < 6; ++i)
    add(5, 60 * i);
  add_ring(points);
  Named_vertices_triangulation dt(
      points.begin(), points.end(),
      {Named_vertices_classifier{{7, 8, 9, 10, 11, 12}}, CGAL::Border_splice_repair_2(0)});
  std::swap(points[3], points[5]);
  std::swap(points[4], points[6]);
  const auto report = dt.update(points.begin(), points.end());
  EXPECT_EQ(report.splices, 1u);
  EXPECT_EQ(report.enlargements, 0u);
  expect_valid(dt, points);
  EXPECT_TRUE(dt.certify());
  expect_exact(dt, points);
}

TEST(Border_splice, mends_the_convex_hull)
{
  for (unsigned seed = 0; seed < 20; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Cloud<Epick> cloud(seed);
    auto points = cloud.uniform(300);
    CGAL::Dynamic_Delaunay_triangulation_2<Epick, CGAL::Default,
                                           CGAL::With_repair_2<CGAL::Border_splice_repair_2>>
        dt(points.begin(), points.end());
    // the leftmost point moves out, or so far in that others take its place on the hull
    auto& corner = *std::min_element(points.begin(), points.end());
    corner = Epick::Point_2(corner.x() + (seed % 2 == 0 ? -0.8 : 0.8), corner.y() + 0.1);
    const auto report = dt.update(points.begin(), points.end());
    EXPECT_GT(report.classified, 0u);
    EXPECT_FALSE(report.rebuilt());
    ASSERT_NO_FATAL_FAILURE(expect_exact(dt, points));
  }
}

TEST(Border_splice, reports_its_sets_and_more_padding_makes_them_larger)
{
  Cloud<Epick> cloud(6);
  const auto points = cloud.uniform(2000);
  auto moved = points;
  moved[0] = cloud.shifted(moved[0], 0.3);
  std::size_t last = 0;
  for (unsigned padding = 0; padding < 4; ++padding) {
    CGAL::Dynamic_Delaunay_triangulation_2<Epick, CGAL::Point_distance_classifier_2> dt(
        points.begin(), points.end(),
        {CGAL::Point_distance_classifier_2(0.9), CGAL::Border_splice_repair_2(padding)});
    const auto report = dt.update(moved.begin(), moved.end());
    EXPECT_EQ(report.splices, 1u);
    EXPECT_GT(report.classified, 0u);
    EXPECT_EQ(report.classified, dt.classified_vertices().size());
    EXPECT_EQ(report.padded, dt.padded_vertices().size());
    EXPECT_EQ(report.border, dt.border_vertices().size());
    EXPECT_EQ(report.spliced, report.classified + report.padded + report.border);
    EXPECT_GT(report.padded + report.border, last);
    last = report.padded + report.border;
    ASSERT_NO_FATAL_FAILURE(expect_valid(dt, moved));
  }
}

TEST(Relocation, moves_every_vertex_that_has_moved)
{
  Cloud<Epick> cloud(7);
  auto points = cloud.uniform(300);
  CGAL::Dynamic_Delaunay_triangulation_2<Epick, CGAL::Default,
                                         CGAL::With_repair_2<CGAL::Relocation_repair_2>>
      dt(points.begin(), points.end());
  for (std::size_t id = 0; id < 40; ++id)
    points[id] = cloud.shifted(points[id], 0.3);
  const auto report = dt.update(points.begin(), points.end());
  EXPECT_EQ(report.relocated, 40u);
  EXPECT_FALSE(report.rebuilt());
  ASSERT_NO_FATAL_FAILURE(expect_exact(dt, points));
}

TEST(Relocation, lets_points_take_the_places_of_others_in_turn)
{
  Cloud<Epick> cloud(8);
  auto points = cloud.uniform(100);
  CGAL::Dynamic_Delaunay_triangulation_2<Epick, CGAL::Default,
                                         CGAL::With_repair_2<CGAL::Relocation_repair_2>>
      dt(points.begin(), points.end());
  for (std::size_t id = 0; id < 10; ++id) // a chain with a free place at its end
    points[id] = id == 9 ? Epick::Point_2(4.5, 4.5) : points[id + 1];
  EXPECT_FALSE(dt.update(points.begin(), points.end()).rebuilt());
  ASSERT_NO_FATAL_FAILURE(expect_exact(dt, points));
  std::swap(points[20], points[21]); // a ring without a free place
  EXPECT_TRUE(dt.update(points.begin(), points.end()).rebuilt());
  ASSERT_NO_FATAL_FAILURE(expect_exact(dt, points));
}

// THE LAST THREE VERTICES -------------------------------------------------------------------------

// As the default repair, however little is gained by it.
struct Holding_repair
{
  template <class Mender>
  void operator()(Mender& mender) const
  {
    mender.hold();
    mender.flip();
    mender.release();
  }
};

// All points but three jump anywhere, so all other vertices may have to be taken out.
TEST(Taking_out, leaves_three_vertices_where_all_others_jump)
{
  bool are_all_others_out = false;
  for (std::size_t n = 3; n < 13; ++n)
    for (unsigned seed = 0; seed < 40; ++seed) {
      SCOPED_TRACE(testing::Message() << n << " points, seed " << seed);
      Cloud<Epick> cloud(seed);
      Points points = cloud.uniform(n);
      CGAL::Dynamic_Delaunay_triangulation_2<Epick, CGAL::Default,
                                             CGAL::With_repair_2<Holding_repair>>
          dt(points);
      const Points others = cloud.uniform(n);
      std::copy(others.begin() + 3, others.end(), points.begin() + 3);
      const auto report = dt.update(points);
      EXPECT_LE(report.relocated, n - 3);
      are_all_others_out = are_all_others_out || (n > 5 && report.relocated == n - 3);
      ASSERT_NO_FATAL_FAILURE(expect_exact(dt, points));
    }
  EXPECT_TRUE(are_all_others_out);
}

// Most points come to one place.
TEST(Merging, leaves_three_vertices)
{
  for (std::size_t n = 4; n < 13; ++n)
    for (unsigned seed = 0; seed < 20; ++seed) {
      SCOPED_TRACE(testing::Message() << n << " points, seed " << seed);
      Cloud<Epick> cloud(seed);
      Points points = cloud.uniform(n);
      CGAL::Dynamic_Delaunay_triangulation_2<Epick, CGAL::Default,
                                             CGAL::With_repair_2<CGAL::Border_splice_repair_2>>
          spliced(points);
      CGAL::Dynamic_Delaunay_triangulation_2<Epick> held(points);
      std::fill(points.begin() + 2, points.end(), points[2]);
      spliced.update(points);
      held.update(points);
      ASSERT_NO_FATAL_FAILURE(expect_exact(spliced, points));
      ASSERT_NO_FATAL_FAILURE(expect_exact(held, points));
    }
}

} // namespace test_repairs

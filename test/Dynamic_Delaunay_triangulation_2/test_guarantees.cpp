// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// What the package promises whatever it is used with: honest certificates, all or nothing, stable
// ids, equal results from equal input.

#include "oracle.h"
#include "replaced_heap.h"
#include "stamps.h"

#include <CGAL/Dynamic_Delaunay_triangulation_2/classifiers/Point_distance_classifier_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/classifiers/Random_classifier_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/repairs/Flip_repair_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/repairs/Rebuild_repair_2.h>

#include <array>
#include <vector>

namespace test_guarantees {

using Points = Cloud<Epick>::Points;
using Exact = CGAL::Dynamic_Delaunay_triangulation_2<Epick>;
using Heuristic = CGAL::Dynamic_Delaunay_triangulation_2<Epick, CGAL::Point_distance_classifier_2>;

// Names a point that does not exist, when told to.
struct Faulty_classifier
{
  static constexpr bool is_exact = true;
  std::shared_ptr<bool> is_faulty = std::make_shared<bool>(false);

  template <class Frame, class Classification>
  void operator()(const Frame& frame, Classification& classified)
  {
    CGAL::Circumcircle_classifier_2()(frame, classified);
    if (*is_faulty)
      classified.add_id(frame.number_of_points());
  }
};

TEST(Guarantees, an_exact_update_certifies_and_a_heuristic_one_does_not)
{
  Cloud<Epick> cloud(1);
  auto points = cloud.uniform(300);
  Exact exact(points.begin(), points.end());
  Heuristic heuristic(points.begin(), points.end());
  EXPECT_TRUE(heuristic.is_certified()); // as built
  cloud.shake(points, 0.01);
  EXPECT_TRUE(exact.update(points.begin(), points.end()).certified);
  EXPECT_FALSE(heuristic.update(points.begin(), points.end()).certified);
  EXPECT_FALSE(heuristic.is_certified());
  EXPECT_THROW(heuristic.triangulation(), CGAL::Uncertified_triangulation_error_2);
  expect_valid(heuristic, points);
}

TEST(Guarantees, what_is_not_delaunay_is_not_certified_but_mended_on_demand)
{
  Cloud<Epick> cloud(2);
  auto points = cloud.uniform(300);
  Heuristic dt(points.begin(), points.end(), CGAL::Point_distance_classifier_2(0.1));
  cloud.shake(points, 0.05);
  dt.update(points.begin(), points.end());
  EXPECT_FALSE(dt.certify());
  EXPECT_FALSE(dt.is_certified());
  EXPECT_TRUE(dt.mend().certified);
  expect_exact(dt, points);
}

TEST(Guarantees, what_is_delaunay_by_luck_can_be_certified)
{
  Cloud<Epick> cloud(3);
  auto points = cloud.uniform(300);
  Heuristic dt(points.begin(), points.end());
  const auto moved = scaled<Epick>(points, 1.001);
  dt.update(moved.begin(), moved.end());
  EXPECT_FALSE(dt.is_certified());
  EXPECT_TRUE(dt.certify());
  expect_exact(dt, moved);
}

template <class Repair, class Classifier>
void follow_and_mend(const Classifier& classifier, Points points, Cloud<Epick>& cloud, double step)
{
  CGAL::Dynamic_Delaunay_triangulation_2<Epick, Classifier, CGAL::With_repair_2<Repair>> dt(
      points.begin(), points.end(), classifier);
  for (int frame = 0; frame < 20; ++frame) {
    cloud.shake(points, step);
    dt.update(points.begin(), points.end());
    ASSERT_TRUE(dt.is_valid(true)) << "frame " << frame;
  }
  dt.mend();
  ASSERT_NO_FATAL_FAILURE(expect_exact(dt, points));
}

TEST(Guarantees, thousands_of_rough_frames_under_every_heuristic_stay_valid_and_can_be_mended)
{
  using CGAL::Random_classifier_2;
  for (unsigned seed = 0; seed < 90; ++seed) {
    Cloud<Epick> cloud(seed);
    const auto points = cloud.uniform(60 + 2 * seed);
    const double step = std::pow(10, -2 + 0.35 * (seed % 9));
    SCOPED_TRACE(testing::Message() << "seed " << seed << ", step " << step);
    ASSERT_NO_FATAL_FAILURE(
        follow_and_mend<CGAL::Default>(Random_classifier_2(0.01, seed), points, cloud, step));
    ASSERT_NO_FATAL_FAILURE(
        follow_and_mend<CGAL::Flip_repair_2>(Random_classifier_2(0.05, seed), points, cloud, step));
    ASSERT_NO_FATAL_FAILURE(follow_and_mend<CGAL::Hold_and_flip_repair_2>(
        Random_classifier_2(0.02, seed), points, cloud, step));
    ASSERT_NO_FATAL_FAILURE(follow_and_mend<CGAL::Default>(CGAL::Point_distance_classifier_2(0.3),
                                                           points, cloud, step));
  }
}

TEST(Guarantees, an_unknown_id_from_the_classifier_is_refused_and_nothing_changes)
{
  Cloud<Epick> cloud(8);
  const auto points = cloud.uniform(50);
  auto moved = points;
  cloud.shake(moved, 0.05); // without motion the classifier is not asked
  Faulty_classifier classifier;
  CGAL::Dynamic_Delaunay_triangulation_2<Epick, Faulty_classifier> dt(points, classifier);
  *classifier.is_faulty = true;
  EXPECT_THROW(dt.update(moved), CGAL::Unknown_id_error_2);
  expect_exact(dt, points);
  *classifier.is_faulty = false;
  dt.update(moved);
  expect_exact(dt, moved);
}

TEST(Guarantees, vertices_keep_their_data_through_flips_relocations_and_rebuilds)
{
  Cloud<Epick> cloud(9);
  auto points = cloud.uniform(300);
  CGAL::Dynamic_Delaunay_triangulation_2<Epick, CGAL::Default,
                                         CGAL::With_data_structure_2<Stamped_data_structure<Epick>>>
      dt(points.begin(), points.end());
  const auto stamps = stamps_of(dt);
  std::size_t flips = 0, relocated = 0, rebuilds = 0;
  for (const double step : {0.01, 0.05, 0.07, 0.07, 0.07, 0.07, 0.07, 0.07, 5., 0.01}) {
    cloud.shake(points, step);
    const auto report = dt.update(points.begin(), points.end());
    flips += report.flips;
    relocated += report.relocated;
    rebuilds += report.rebuilt();
    for (std::size_t id = 0; id < points.size(); ++id) {
      ASSERT_EQ(stamp_of(dt, id), stamps.at(id));
      ASSERT_EQ(dt.id(dt.vertex(id)), id);
    }
  }
  EXPECT_GT(flips, 0u);
  EXPECT_GT(relocated, 0u);
  EXPECT_GT(rebuilds, 0u);
}

// A rebuild numbers the vertices anew, and with coincident points there are fewer.
TEST(Guarantees, the_classified_set_names_no_vertex_that_a_rebuild_did_away_with)
{
  Cloud<Epick> cloud(15);
  const auto points = cloud.uniform(200);
  auto elsewhere = points;
  std::copy(elsewhere.begin(), elsewhere.begin() + 50, elsewhere.begin() + 150);
  CGAL::Dynamic_Delaunay_triangulation_2<Epick, CGAL::Default,
                                         CGAL::With_repair_2<CGAL::Rebuild_repair_2>>
      dt(points.begin(), points.end());
  const auto report = dt.update(elsewhere.begin(), elsewhere.end());
  EXPECT_TRUE(report.rebuilt());
  EXPECT_GT(report.classified, 0u);
  EXPECT_TRUE(dt.classified_vertices().empty());
  expect_exact(dt, elsewhere);
}

TEST(Guarantees, equal_input_gives_equal_triangulations_and_reports)
{
  std::array<std::vector<std::array<std::size_t, 2>>, 2> edges;
  std::array<std::vector<std::size_t>, 2> counts;
  for (std::size_t run = 0; run < 2; ++run) {
    Cloud<Epick> cloud(11);
    auto points = cloud.uniform(400);
    Exact dt(points.begin(), points.end());
    for (int frame = 0; frame < 20; ++frame) {
      cloud.shake(points, 0.05);
      const auto report = dt.update(points.begin(), points.end());
      counts[run].insert(counts[run].end(), {report.classified, report.flips, report.splices,
                                             report.padded, report.border, report.enlargements});
    }
    dt.for_each_edge([&](std::size_t i, std::size_t j) { edges[run].push_back({i, j}); });
  }
  EXPECT_EQ(edges[0], edges[1]);
  EXPECT_EQ(counts[0], counts[1]);
}

TEST(Guarantees, none_to_three_points_and_points_on_a_line_work)
{
  for (std::size_t n = 0; n <= 3; ++n) {
    SCOPED_TRACE(testing::Message() << n << " points");
    Cloud<Epick> cloud(12);
    auto points = cloud.uniform(n);
    Exact dt(points.begin(), points.end());
    expect_exact(dt, points);
    for (int frame = 0; frame < 3; ++frame) {
      cloud.shake(points, 0.5);
      dt.update(points.begin(), points.end());
      expect_exact(dt, points);
    }
    std::size_t edges = 0;
    dt.for_each_edge([&](std::size_t, std::size_t) { ++edges; });
    EXPECT_EQ(edges, n < 2 ? 0 : n == 2 ? 1u : 3u);
  }
}

TEST(Guarantees, a_frame_in_which_nothing_breaks_allocates_nothing)
{
  Cloud<Epick> cloud(16);
  auto points = cloud.uniform(1000);
  Exact dt(points.begin(), points.end());
  std::size_t calm_frames = 0;
  for (int frame = 0; frame < 60; ++frame) {
    cloud.shake(points, 1e-5);
    const std::size_t before = replaced_heap::number_of_allocations;
    const auto report = dt.update(points.begin(), points.end());
    if (frame < 20 || report.classified > 0)
      continue;
    ++calm_frames;
    EXPECT_EQ(replaced_heap::number_of_allocations, before) << "frame " << frame;
  }
  EXPECT_GT(calm_frames, 10u);
}

} // namespace test_guarantees

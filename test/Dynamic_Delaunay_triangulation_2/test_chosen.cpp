// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Classifiers, repairs and policies that are chosen while a program runs.

#include "oracle.h"

#include <CGAL/Dynamic_Delaunay_triangulation_2/classifiers/Chosen_classifier_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/classifiers/Estimated_voronoi_circumcenter_classifier_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/classifiers/Nearly_delaunay_classifier_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/classifiers/Point_distance_classifier_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/classifiers/Random_classifier_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/classifiers/Refined_classifier_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/classifiers/Safe_region_classifier_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/policies/Always_static_policy_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/policies/Chosen_policy_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/policies/Key_frame_policy_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/repairs/Chosen_repair_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/repairs/Flip_repair_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/repairs/Repair_by_exactness_2.h>
#include <CGAL/Dynamic_periodic_Delaunay_triangulation_2.h>

#include <gtest/gtest.h>

#include <string>
#include <type_traits>
#include <vector>

namespace test_chosen {

using Points = Cloud<Epick>::Points;
using Circumcircle = CGAL::Circumcircle_classifier_2;
using Safe_region = CGAL::Safe_region_classifier_2;
using Random = CGAL::Random_classifier_2;
using Any = CGAL::Chosen_classifier_2<Circumcircle, Safe_region, Random>;
using Edgewise = CGAL::Chosen_classifier_2<Circumcircle, CGAL::Nearly_delaunay_classifier_2>;
using Reason = CGAL::Rebuild_reason_2;

TEST(A_chosen_classifier, is_the_first_one_by_default)
{
  EXPECT_NE(Any().get_if<Circumcircle>(), nullptr);
  EXPECT_EQ(Any().get_if<Random>(), nullptr);
  const Any random(Random(0.25, 3));
  ASSERT_NE(random.get_if<Random>(), nullptr);
  EXPECT_EQ(random.get_if<Random>()->p(), 0.25);
}

TEST(A_chosen_classifier, is_exact_if_the_chosen_one_is)
{
  static_assert(Any::can_be<Random> && !Any::can_be<CGAL::Point_distance_classifier_2>);
  static_assert(!std::is_constructible_v<Any, CGAL::Point_distance_classifier_2>);
  EXPECT_TRUE(Any().is_exact());
  EXPECT_TRUE(Any(Safe_region()).is_exact());
  EXPECT_FALSE(Any(Random()).is_exact());
  EXPECT_TRUE(CGAL::is_classifier_exact(Any()));
  EXPECT_TRUE(CGAL::is_classifier_exact(Circumcircle()));
  EXPECT_FALSE(CGAL::is_classifier_exact(Random()));
  using Nested = CGAL::Chosen_classifier_2<Any, CGAL::Point_distance_classifier_2>;
  EXPECT_TRUE(Nested(Any()).is_exact());
  EXPECT_FALSE(Nested(Any(Random())).is_exact());
}

TEST(A_chosen_classifier, refines_and_is_refined)
{
  using Refined = CGAL::Refined_classifier_2<Any, Edgewise>;
  EXPECT_TRUE(Refined().is_exact());
  EXPECT_FALSE(Refined(Random()).is_exact());
  EXPECT_FALSE(Refined(Any(), CGAL::Nearly_delaunay_classifier_2()).is_exact());
  EXPECT_FALSE((CGAL::Refined_classifier_2<Random, Any>().is_exact()));
  static_assert(CGAL::Refined_classifier_2<Safe_region, Circumcircle>::is_exact);

  Cloud<Epick> cloud(1);
  Points points = cloud.uniform(200);
  CGAL::Dynamic_Delaunay_triangulation_2<Epick, Refined> dt(points);
  for (int frame = 0; frame < 10; ++frame) {
    cloud.shake(points, 0.02);
    EXPECT_TRUE(dt.update(points).certified);
    ASSERT_NO_FATAL_FAILURE(expect_exact(dt, points));
  }
}

// An exact one holds and flips, a heuristic one splices.
TEST(A_chosen_classifier, has_the_repair_that_goes_with_it)
{
  using Dynamic = CGAL::Dynamic_Delaunay_triangulation_2<Epick, Any>;
  static_assert(std::is_same_v<Dynamic::Delaunay_repair, CGAL::Repair_by_exactness_2>);
  for (const bool is_exact : {true, false}) {
    Cloud<Epick> cloud(2);
    Points points = cloud.uniform(300);
    Dynamic dt(points, {is_exact ? Any() : Any(Random(0.02, 5))});
    std::size_t splices = 0, flips = 0;
    for (int frame = 0; frame < 10; ++frame) {
      cloud.shake(points, 0.03);
      const auto report = dt.update(points);
      EXPECT_EQ(report.certified, is_exact);
      splices += report.splices;
      flips += report.flips;
      ASSERT_TRUE(dt.is_valid());
    }
    EXPECT_EQ(splices > 0, !is_exact);
    EXPECT_EQ(flips > 0, is_exact);
    if (is_exact)
      expect_exact(dt, points);
  }
}

TEST(A_chosen_classifier, serves_on_a_torus)
{
  using Dynamic = CGAL::Dynamic_periodic_Delaunay_triangulation_2<Epick, Any>;
  for (const bool is_exact : {true, false}) {
    Cloud<Epick> cloud(2);
    Points points = cloud.uniform(100);
    Dynamic dt(points, CGAL::Periodic_cell_2(10, 10), {is_exact ? Any() : Any(Random(0.1, 5))});
    for (int frame = 0; frame < 10; ++frame) {
      cloud.shake(points, 0.05);
      const auto report = dt.update(points);
      EXPECT_TRUE(report.certified || !is_exact);
    }
    EXPECT_TRUE(dt.is_valid());
    EXPECT_TRUE(dt.mend().certified);
  }
}

using Any_repair = CGAL::Chosen_repair_2<CGAL::Hold_and_flip_repair_2, CGAL::Flip_repair_2>;
using Any_policy = CGAL::Chosen_policy_2<CGAL::Always_dynamic_policy_2,
                                         CGAL::Always_static_policy_2, CGAL::Key_frame_policy_2>;
using Chosen = CGAL::Dynamic_Delaunay_triangulation_2<Epick, Any, CGAL::With_repair_2<Any_repair>,
                                                      CGAL::With_policy_2<Any_policy>>;

// How often each reason for a rebuild occurred while everything is shaken by `step`.
std::vector<int> reasons(const Any_repair& repair, const Any_policy& policy, double step)
{
  Cloud<Epick> cloud(2);
  Points points = cloud.uniform(300);
  Chosen::Settings settings;
  settings.repair = repair;
  settings.policy = policy;
  Chosen dt(points, settings);
  std::vector<int> counts(20);
  for (int frame = 0; frame < 12; ++frame) {
    cloud.shake(points, step);
    ++counts[std::size_t(dt.update(points).rebuild_reason)];
    expect_exact(dt, points);
  }
  return counts;
}

TEST(A_chosen_policy, decides)
{
  const auto count = [](const Any_policy& policy, Reason reason) {
    return reasons({}, policy, 0.01)[std::size_t(reason)];
  };
  EXPECT_EQ(count({}, Reason::POLICY), 0);
  EXPECT_EQ(count(CGAL::Always_static_policy_2(), Reason::POLICY), 12);
  EXPECT_EQ(count(CGAL::Key_frame_policy_2(4), Reason::POLICY), 3);
}

// Only the usual one lets a sample of edges decide: where everything is elsewhere, it is not
// called. Any other repair is.
TEST(A_chosen_repair, decides)
{
  const auto count = [](const Any_repair& repair, Reason reason) {
    return reasons(repair, {}, 3.)[std::size_t(reason)];
  };
  EXPECT_EQ(count({}, Reason::TOO_MUCH_BROKEN), 12);
  EXPECT_EQ(count(CGAL::Flip_repair_2(), Reason::TOO_MUCH_BROKEN), 0);
}

} // namespace test_chosen

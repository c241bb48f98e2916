// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Update policies: which frames are rebuilt without asking the classifier, and that no point or
// certificate is lost by that.

#include "oracle.h"

#include <CGAL/Dynamic_Delaunay_triangulation_2/classifiers/Estimated_voronoi_circumcenter_classifier_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/classifiers/Inflation_aware_classifier_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/classifiers/Nearly_delaunay_classifier_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/classifiers/Point_distance_classifier_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/classifiers/Random_classifier_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/classifiers/Safe_region_classifier_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/classifiers/Voronoi_circumcenter_classifier_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/classifiers/Voronoi_edge_length_classifier_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/policies/Always_static_policy_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/policies/Hybrid_policy_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/policies/Key_frame_policy_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/repairs/Relocation_repair_2.h>

#include <algorithm>
#include <memory>
#include <set>
#include <type_traits>
#include <vector>

namespace test_policies {

using Points = Cloud<Epick>::Points;
using Reason = CGAL::Rebuild_reason_2;

template <class Policy, class Classifier = CGAL::Circumcircle_classifier_2,
          class Repair = CGAL::Default>
using Triangulation =
    CGAL::Dynamic_Delaunay_triangulation_2<Epick, Classifier, CGAL::With_repair_2<Repair>,
                                           CGAL::With_policy_2<Policy>>;

template <class Policy, class Classifier = CGAL::Circumcircle_classifier_2,
          class Repair = CGAL::Default>
Triangulation<Policy, Classifier, Repair> triangulation(const Points& points, const Policy& policy,
                                                        const Classifier& classifier = Classifier())
{
  using Result = Triangulation<Policy, Classifier, Repair>;
  typename Result::Settings settings{classifier};
  settings.policy = policy;
  return Result(points.begin(), points.end(), settings);
}

template <class Dynamic>
CGAL::Update_report_2 update(Dynamic& dt, const Points& points)
{
  return dt.update(points.begin(), points.end());
}

// How often a classifier was asked, and the ids that it picked last.
struct Answers
{
  int asked = 0;
  bool everything_is_new = false; // when it was told last
  std::set<std::size_t> ids;
};

template <class Classifier>
struct Observed
{
  static constexpr bool is_exact = Classifier::is_exact;
  Classifier classifier{};
  std::shared_ptr<Answers> answers = std::make_shared<Answers>();

  template <class Frame, class Classification>
  void operator()(const Frame& frame, Classification& classified)
  {
    classifier(frame, classified);
    ++answers->asked;
    answers->ids.clear();
    for (const auto v : classified.vertices())
      answers->ids.insert(frame.id(v));
  }

  template <class Frame>
  void after_update(const Frame& frame)
  {
    answers->everything_is_new = frame.everything_is_new();
    CGAL::inform_classifier(classifier, frame);
  }
};

// Picks no vertex, so that only the rebuilds of the policy can make a frame right.
using Blind = Observed<CGAL::Random_classifier_2>;

Blind blind()
{
  return {CGAL::Random_classifier_2(0)};
}

// -------------------------------------------------------------------------------------------------

TEST(Always_dynamic_policy, is_the_default_and_rebuilds_nothing)
{
  using Default_triangulation = CGAL::Dynamic_Delaunay_triangulation_2<Epick>;
  static_assert(
      std::is_same_v<Default_triangulation::Delaunay_update_policy, CGAL::Always_dynamic_policy_2>,
      "unless told otherwise, frames are mended");
  Cloud<Epick> cloud(1);
  auto points = cloud.uniform(300);
  auto dt = triangulation(points, CGAL::Always_dynamic_policy_2());
  for (int frame = 0; frame < 20; ++frame) {
    cloud.shake(points, 0.01);
    ASSERT_EQ(update(dt, points).rebuild_reason, Reason::NONE);
    ASSERT_NO_FATAL_FAILURE(expect_exact(dt, points));
  }
}

TEST(Always_static_policy, rebuilds_and_certifies_every_frame_and_asks_no_classifier)
{
  Cloud<Epick> cloud(2);
  auto points = cloud.uniform(300);
  auto dt = triangulation(points, CGAL::Always_static_policy_2(), blind());
  for (int frame = 0; frame < 20; ++frame) {
    cloud.shake(points, 0.05 * frame);
    const auto report = update(dt, points);
    ASSERT_EQ(report.rebuild_reason, Reason::POLICY);
    ASSERT_TRUE(report.certified);
    ASSERT_EQ(report.classified, 0u);
    ASSERT_TRUE(dt.classifier().answers->everything_is_new);
    ASSERT_NO_FATAL_FAILURE(expect_exact(dt, points));
  }
  EXPECT_EQ(dt.classifier().answers->asked, 0);
}

TEST(Key_frame_policy, is_exact_on_every_kth_frame_also_with_a_classifier_that_sees_nothing)
{
  for (const unsigned k : {1u, 2u, 5u}) {
    SCOPED_TRACE(testing::Message() << "k = " << k);
    Cloud<Epick> cloud(3);
    auto points = cloud.uniform(300);
    auto dt = triangulation(points, CGAL::Key_frame_policy_2(k), blind());
    for (unsigned frame = 1; frame <= 20; ++frame) {
      cloud.shake(points, 0.05);
      const auto report = update(dt, points);
      const bool is_key_frame = frame % k == 0;
      ASSERT_EQ(report.rebuild_reason, is_key_frame ? Reason::POLICY : Reason::NONE);
      ASSERT_EQ(report.certified, is_key_frame);
      ASSERT_NO_FATAL_FAILURE(expect_valid(dt, points));
      if (is_key_frame) {
        ASSERT_NO_FATAL_FAILURE(expect_exact(dt, points));
      } else {
        ASSERT_FALSE(dt.is_certified());
        ASSERT_THROW(dt.triangulation(), CGAL::Uncertified_triangulation_error_2);
      }
    }
    EXPECT_EQ(dt.classifier().answers->asked, int(20 - 20 / k));
  }
}

TEST(Key_frame_policy, counts_the_frames_that_are_rebuilt_for_other_reasons)
{
  Cloud<Epick> cloud(4);
  const auto apart = cloud.uniform(100);
  const auto elsewhere = cloud.uniform(100);
  const auto on_line = cloud.on_line(100);
  auto dt = triangulation(apart, CGAL::Key_frame_policy_2(4));
  const std::vector<Points> frames = {apart, elsewhere, on_line, apart, apart, apart, apart, apart};
  std::vector<Reason> reasons;
  for (const Points& points : frames) {
    reasons.push_back(update(dt, points).rebuild_reason);
    ASSERT_NO_FATAL_FAILURE(expect_exact(dt, points));
  }
  // from the line back to the plane only a rebuild leads, key frame or not
  EXPECT_EQ(reasons[1], Reason::TOO_MUCH_BROKEN);
  EXPECT_EQ(reasons[3], Reason::DIMENSION);
  EXPECT_EQ(std::vector<Reason>(reasons.begin() + 4, reasons.end()),
            (std::vector<Reason>{Reason::NONE, Reason::NONE, Reason::NONE, Reason::POLICY}));
}

TEST(Key_frame_policy, counts_no_frame_that_was_refused)
{
  Cloud<Epick> cloud(5);
  auto points = cloud.uniform(100);
  auto dt = triangulation(points, CGAL::Key_frame_policy_2(2));
  cloud.shake(points, 0.01);
  EXPECT_EQ(update(dt, points).rebuild_reason, Reason::NONE);
  const Points too_few(points.begin() + 1, points.end());
  EXPECT_THROW(update(dt, too_few), CGAL::Point_count_error_2);
  cloud.shake(points, 0.01);
  EXPECT_EQ(update(dt, points).rebuild_reason, Reason::POLICY);
}

TEST(Key_frame_policy, refuses_distances_out_of_range)
{
  EXPECT_THROW(CGAL::Key_frame_policy_2(0), CGAL::Parameter_error_2);
  EXPECT_THROW(CGAL::Key_frame_policy_2(1000001), CGAL::Parameter_error_2);
  EXPECT_THROW(CGAL::Key_frame_policy_2(unsigned(-1)), CGAL::Parameter_error_2);
  EXPECT_EQ(CGAL::Key_frame_policy_2(1000000).k(), 1000000u);
  EXPECT_EQ(CGAL::Key_frame_policy_2(1).k(), 1u);
}

// -------------------------------------------------------------------------------------------------
// Hybrid.

// Calm, wild and everything between, in turn.
double step_of(int frame)
{
  constexpr double steps[] = {1e-3, 0.01, 0.03, 0.06, 0.1, 0.3, 10};
  return steps[(frame / 4) % 7];
}

template <class Classifier>
void expect_equal_reports()
{
  Cloud<Epick> cloud(7);
  auto points = cloud.uniform(400);
  auto first = triangulation(points, CGAL::Hybrid_policy_2(), Classifier());
  auto second = triangulation(points, CGAL::Hybrid_policy_2(), Classifier());
  std::set<Reason> reasons;
  for (int frame = 0; frame < 80; ++frame) {
    cloud.shake(points, step_of(frame));
    const auto a = update(first, points), b = update(second, points);
    reasons.insert(a.rebuild_reason);
    ASSERT_EQ(a.classified, b.classified);
    ASSERT_EQ(a.padded, b.padded);
    ASSERT_EQ(a.border, b.border);
    ASSERT_EQ(a.flips, b.flips);
    ASSERT_EQ(a.splices, b.splices);
    ASSERT_EQ(a.enlargements, b.enlargements);
    ASSERT_EQ(a.rebuild_reason, b.rebuild_reason);
    ASSERT_EQ(a.certified, b.certified);
  }
  EXPECT_TRUE(reasons.count(Reason::NONE) && reasons.count(Reason::POLICY));
}

TEST(Hybrid_policy, gives_equal_reports_on_equal_input)
{
  expect_equal_reports<CGAL::Circumcircle_classifier_2>();
  expect_equal_reports<CGAL::Point_distance_classifier_2>();
}

TEST(Hybrid_policy, mends_calm_motion_rebuilds_teleports_and_goes_back_at_once)
{
  Cloud<Epick> cloud(8);
  auto points = cloud.uniform(1000);
  auto dt = triangulation(points, CGAL::Hybrid_policy_2());
  for (int round = 0; round < 3; ++round) {
    SCOPED_TRACE(testing::Message() << "round " << round);
    for (int frame = 0; frame < 10; ++frame) {
      cloud.shake(points, 1e-3);
      ASSERT_EQ(update(dt, points).rebuild_reason, Reason::NONE) << frame;
      ASSERT_NO_FATAL_FAILURE(expect_exact(dt, points));
    }
    for (int frame = 0; frame < 10; ++frame) {
      points = cloud.uniform(1000);
      // the policy learns from the first failure
      ASSERT_EQ(update(dt, points).rebuild_reason,
                frame == 0 ? Reason::TOO_MUCH_BROKEN : Reason::POLICY);
      ASSERT_NO_FATAL_FAILURE(expect_exact(dt, points));
    }
  }
}

TEST(Hybrid_policy, rests_longer_and_longer_from_a_classifier_that_names_too_much)
{
  using All = Observed<CGAL::Random_classifier_2>;
  Cloud<Epick> cloud(9);
  auto points = cloud.uniform(200);
  auto dt = triangulation(points, CGAL::Hybrid_policy_2(), All{CGAL::Random_classifier_2(1)});
  for (int frame = 0; frame < 200; ++frame) {
    cloud.shake(points, 1e-6);
    const int asked = dt.classifier().answers->asked;
    const bool was_asked = [&] {
      const auto report = update(dt, points);
      EXPECT_EQ(report.rebuild_reason == Reason::POLICY, dt.classifier().answers->asked == asked);
      return report.rebuild_reason != Reason::POLICY;
    }();
    ASSERT_TRUE(was_asked || dt.is_certified());
  }
  EXPECT_GE(dt.classifier().answers->asked, 3);
  EXPECT_LE(dt.classifier().answers->asked, 21); // 0 + 1 + ... + 19 frames of rest
}

// A hundred vertices whose edges are all Delaunay.
struct Calm_frame
{
  using Index = unsigned;
  using Edge_index = CGAL::Dynamic_Delaunay_triangulations_2::Edge_index;
  Index number_of_vertices() const { return 100; }
  Index number_of_edges() const { return 300; }
  bool is_delaunay(Edge_index) const { return true; }
};

// The number of rebuilds before the policy tries again; it is then told the outcome of the try.
int rest(CGAL::Hybrid_policy_2& policy, Reason outcome)
{
  int frames = 0;
  CGAL::Update_report_2 report;
  for (report.rebuild_reason = Reason::POLICY; policy.wants_rebuild(Calm_frame()); ++frames)
    policy.after_update(Calm_frame(), report);
  report.rebuild_reason = outcome;
  policy.after_update(Calm_frame(), report);
  return frames;
}

TEST(Hybrid_policy, lengthens_its_rests_from_failure_to_failure_and_forgets_them_with_a_success)
{
  CGAL::Hybrid_policy_2 policy;
  for (int round = 0; round < 2; ++round) {
    EXPECT_EQ(rest(policy, Reason::STUCK), 0);
    for (int failures = 0; failures < 70; ++failures)
      EXPECT_EQ(rest(policy, Reason::STUCK), (std::min)(failures, 63));
    EXPECT_EQ(rest(policy, Reason::NONE), 63);
  }
}

TEST(Hybrid_policy, gives_up_relocation_where_all_points_move)
{
  Cloud<Epick> cloud(10);
  auto points = cloud.uniform(300);
  auto dt = triangulation<CGAL::Hybrid_policy_2, CGAL::Circumcircle_classifier_2,
                          CGAL::Relocation_repair_2>(points, CGAL::Hybrid_policy_2());
  int relocations = 0;
  for (int frame = 0; frame < 60; ++frame) {
    cloud.shake(points, 0.02);
    relocations += update(dt, points).relocated > 0;
    ASSERT_NO_FATAL_FAILURE(expect_exact(dt, points));
  }
  EXPECT_GE(relocations, 2);
  EXPECT_LE(relocations, 12);
}

TEST(Hybrid_policy, mends_what_costs_less_to_mend_though_vertices_are_taken_out_for_it)
{
  Cloud<Epick> cloud(15);
  auto points = cloud.uniform(1000);
  auto dt = triangulation(points, CGAL::Hybrid_policy_2());
  std::size_t relocated = 0;
  for (int frame = 0; frame < 30; ++frame) {
    cloud.shake(points, 0.04);
    const auto report = update(dt, points);
    ASSERT_NE(report.rebuild_reason, Reason::POLICY) << frame;
    relocated += report.relocated;
  }
  EXPECT_GT(relocated, 10u);
}

TEST(Hybrid_policy, ends_its_rest_when_half_as_much_is_broken)
{
  Cloud<Epick> cloud(16);
  auto points = cloud.uniform(1000);
  auto dt = triangulation<CGAL::Hybrid_policy_2, CGAL::Circumcircle_classifier_2,
                          CGAL::Relocation_repair_2>(points, CGAL::Hybrid_policy_2());
  int frames_since_try = 0;
  for (int frame = 0; frame < 20; ++frame) {
    cloud.shake(points, 0.05);
    frames_since_try = update(dt, points).relocated > 0 ? 0 : frames_since_try + 1;
  }
  ASSERT_GT(frames_since_try, 0) << "it was to rest";
  cloud.shake(points, 0.01);
  EXPECT_GT(update(dt, points).relocated, 0u);
}

TEST(Hybrid_policy, does_well_with_few_points_that_coincide_and_stand_on_lines)
{
  Cloud<Epick> cloud(11);
  Points points;
  for (std::size_t n = 0; n < 8; ++n) {
    SCOPED_TRACE(testing::Message() << n << " points");
    points = cloud.uniform(n);
    auto dt = triangulation(points, CGAL::Hybrid_policy_2());
    for (int frame = 0; frame < 24; ++frame) {
      points = frame % 6 == 5 ? cloud.on_line(n) : cloud.uniform(n);
      if (n > 1 && frame % 4 == 3)
        points.front() = points.back();
      update(dt, points);
      ASSERT_NO_FATAL_FAILURE(expect_exact(dt, points));
    }
  }
}

// -------------------------------------------------------------------------------------------------
// What classifiers remember.

template <class Classifier>
class Classifiers_under_policies : public testing::Test
{
};

using All_classifiers =
    testing::Types<CGAL::Circumcircle_classifier_2, CGAL::Safe_region_classifier_2,
                   CGAL::Point_distance_classifier_2, CGAL::Inflation_aware_classifier_2,
                   CGAL::Voronoi_circumcenter_classifier_2,
                   CGAL::Estimated_voronoi_circumcenter_classifier_2,
                   CGAL::Voronoi_edge_length_classifier_2, CGAL::Nearly_delaunay_classifier_2>;
TYPED_TEST_SUITE(Classifiers_under_policies, All_classifiers);

// After each key frame a classifier picks what a fresh one would pick.
TYPED_TEST(Classifiers_under_policies, start_anew_at_every_key_frame)
{
  using Classifier = Observed<TypeParam>;
  constexpr unsigned k = 5;
  Cloud<Epick> cloud(13);
  auto points = cloud.uniform(400);
  auto dt = triangulation(points, CGAL::Key_frame_policy_2(k), Classifier());
  using Fresh = Triangulation<CGAL::Always_dynamic_policy_2, Classifier>;
  auto fresh = std::make_unique<Fresh>(points.begin(), points.end(), Classifier());
  std::size_t picked = 0;
  for (unsigned frame = 1; frame <= 6 * k; ++frame) {
    cloud.shake(points, 0.015); // calm enough that no sample calls for several steps
    const auto report = update(dt, points);
    if (frame % k == 0) {
      ASSERT_EQ(report.rebuild_reason, Reason::POLICY);
      ASSERT_TRUE(dt.classifier().answers->everything_is_new);
      fresh = std::make_unique<Fresh>(points.begin(), points.end(), Classifier());
    } else {
      update(*fresh, points);
      ASSERT_EQ(dt.classifier().answers->ids, fresh->classifier().answers->ids) << frame;
      picked += dt.classifier().answers->ids.size();
    }
    ASSERT_NO_FATAL_FAILURE(expect_valid(dt, points));
  }
  EXPECT_GT(picked, 0u);
}

TYPED_TEST(Classifiers_under_policies, stay_exact_if_they_are_under_the_hybrid_one)
{
  Cloud<Epick> cloud(14);
  auto points = cloud.uniform(300);
  auto dt = triangulation(points, CGAL::Hybrid_policy_2(), TypeParam());
  for (int frame = 0; frame < 60; ++frame) {
    cloud.shake(points, step_of(frame));
    const auto report = update(dt, points);
    ASSERT_NO_FATAL_FAILURE(expect_valid(dt, points));
    if (TypeParam::is_exact || report.rebuilt()) {
      ASSERT_NO_FATAL_FAILURE(expect_exact(dt, points));
    }
  }
}

} // namespace test_policies

// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// What `./dev bench robustness` has found, reduced to the smallest case.

#include "oracle.h"
#include "stamps.h"

#include <CGAL/Dynamic_Delaunay_triangulation_2/classifiers/Random_classifier_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/repairs/Relocation_repair_2.h>
#include <CGAL/Dynamic_population_2.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace test_robustness_findings {

using Point = Epick::Point_2;
using Points = std::vector<Point>;
using Dynamic = CGAL::Dynamic_Delaunay_triangulation_2<Epick>;
using Moves = std::vector<std::pair<std::size_t, Point>>;

TEST(Robustness_findings, reports_that_a_population_is_certified_if_no_point_is_new)
{
  CGAL::Dynamic_population_2<Dynamic> population;
  const std::vector<std::pair<int, Point>> frame = {
      {7, {0, 0}}, {8, {1, 0}}, {9, {0, 1}}, {6, {2, 2}}};
  EXPECT_TRUE(population.update(frame.begin(), frame.end()).certified);
  EXPECT_TRUE(population.update(frame.begin(), frame.end()).certified);
  EXPECT_TRUE(population.triangulation().is_certified());
}

TEST(Robustness_findings, reports_that_a_population_is_certified_if_it_has_no_points)
{
  CGAL::Dynamic_population_2<Dynamic> population;
  const std::vector<std::pair<int, Point>> no_points;
  EXPECT_TRUE(population.update(no_points.begin(), no_points.end()).certified);
}

void expect_to_keep_vertices(const Moves& moves)
{
  Points points = Cloud<Epick>::grid(8, 8);
  CGAL::Dynamic_Delaunay_triangulation_2<Epick, CGAL::Default,
                                         CGAL::With_data_structure_2<Stamped_data_structure<Epick>>>
      dt(points.begin(), points.end());
  const auto stamps = stamps_of(dt);
  dt.move(moves.begin(), moves.end());
  for (const auto& [id, point] : moves)
    points[id] = point;
  ASSERT_NO_FATAL_FAILURE(expect_exact(dt, points));
  for (std::size_t id = 0; id < points.size(); ++id)
    EXPECT_EQ(stamp_of(dt, id), stamps.at(id)) << "id " << id;
}

TEST(Robustness_findings, lets_points_that_swap_in_one_move_keep_their_vertices)
{
  expect_to_keep_vertices({{9, {6, 6}}, {54, {1, 1}}});
}

TEST(Robustness_findings, lets_points_that_follow_each_other_in_one_move_keep_their_vertices)
{
  expect_to_keep_vertices({{9, {6, 6}}, {54, {3, 6}}, {51, {2.5, 2.5}}});
}

TEST(Robustness_findings, lets_points_that_take_hull_places_in_one_move_keep_their_vertices)
{
  expect_to_keep_vertices({{0, {7, 7}}, {63, {7, 0}}, {7, {0, 0}}});
}

// Relocation leaves no edges, and still points that part must get their own vertices.
TEST(Robustness_findings, lets_points_part_while_relocation_brings_all_onto_a_line)
{
  using Random = CGAL::Random_classifier_2;
  using Relocating =
      CGAL::Dynamic_Delaunay_triangulation_2<Epick, Random,
                                             CGAL::With_repair_2<CGAL::Relocation_repair_2>>;
  Points points = Cloud<Epick>::grid(4, 4);
  points.push_back(points.front());
  Relocating dt(points.begin(), points.end(), Random(1));
  for (std::size_t id = 0; id < points.size(); ++id)
    points[id] = Point(double(id), 0);
  const auto report = dt.update(points.begin(), points.end());
  EXPECT_EQ(report.rebuild_reason, CGAL::Rebuild_reason_2::DIMENSION);
  expect_exact(dt, points);
}

TEST(A_splice_that_merges, names_only_vertices_that_there_are)
{
  using Spliced =
      CGAL::Dynamic_Delaunay_triangulation_2<Epick, CGAL::Default,
                                             CGAL::With_repair_2<CGAL::Border_splice_repair_2>>;
  Cloud<Epick> cloud(1);
  auto points = cloud.uniform(400);
  Spliced dt(points.begin(), points.end());
  std::size_t merged_for_good = 0;
  for (std::size_t id = 0; id < 60; ++id) {
    const auto neighbor = dt.triangulation().incident_vertices(dt.vertex(id));
    if (dt.triangulation().is_infinite(neighbor))
      continue;
    points[id] = neighbor->point();
    const auto report = dt.update(points.begin(), points.end());
    merged_for_good += report.rebuilt() ? 0 : report.merged;
    ASSERT_NO_FATAL_FAILURE(expect_exact(dt, points));
    for (const auto* const set :
         {&dt.classified_vertices(), &dt.padded_vertices(), &dt.border_vertices()})
      for (const auto v : *set)
        ASSERT_LE(v, dt.number_of_vertices());
  }
  EXPECT_GT(merged_for_good, 0u);
}

// Mends as the default repair does where it is not known how the points have moved.
struct Mending_repair
{
  template <class Mender>
  void operator()(Mender& mender) const
  {
    CGAL::Hold_and_flip_repair_2().mend(mender);
  }
};

// One cluster has been spliced when two points of another one are found to coincide: what is around
// the first one must not count as proved, or the result would be certified and not Delaunay
// (--family cocircular --trial 12519586882401566296, and 282966 of a search for smaller ones).
TEST(A_splice_that_merges, proves_what_it_has_spliced_before)
{
  Points points = {{-59, -27}, {28, 59},  {-61, -25}, {-65, -15}, {18, 63},  {-51, -42},
                   {-62, -24}, {-47, 45}, {36, -55},  {38, -53},  {-24, 61}, {66, 9},
                   {-65, 17},  {57, 31},  {-6, -65},  {-21, 63},  {-62, 19}, {67, 2},
                   {13, -66},  {24, -63}, {29, 60},   {22, -61},  {-66, -9}, {-36, 56},
                   {-16, -63}, {58, -31}, {-3, 67},   {-2, 65},   {-6, -67}, {-4, -65}};
  CGAL::Dynamic_Delaunay_triangulation_2<Epick, CGAL::Default, CGAL::With_repair_2<Mending_repair>>
      dt(points);
  points[1] = {29, 60};
  points[2] = {-60, -24};
  const CGAL::Update_report_2 report = dt.update(points);
  EXPECT_EQ(report.merged, 1u);
  EXPECT_FALSE(report.rebuilt());
  expect_exact(dt, points);
}

TEST(A_rebuild, is_for_the_dimension_where_the_plane_was_or_is_not_spanned)
{
  using CGAL::Rebuild_reason_2;
  std::vector<Epick::Point_2> line;
  for (int i = 0; i < 40; ++i)
    line.emplace_back(i, 0);
  Dynamic dt(line.begin(), line.end());
  const Epick::Point_2 beside(3, 1);
  std::size_t id = 0;
  EXPECT_EQ(dt.insert(&beside, &beside + 1, &id).rebuild_reason, Rebuild_reason_2::DIMENSION);
  EXPECT_EQ(dt.move(id, Epick::Point_2(50, 0)).rebuild_reason, Rebuild_reason_2::DIMENSION);
  EXPECT_EQ(dt.move(id, beside).rebuild_reason, Rebuild_reason_2::DIMENSION);
  EXPECT_EQ(dt.remove(id).rebuild_reason, Rebuild_reason_2::DIMENSION);
  EXPECT_EQ(dt.remove(&id, &id).rebuild_reason, Rebuild_reason_2::NONE); // no point
  EXPECT_TRUE(dt.is_certified());
  ASSERT_NO_FATAL_FAILURE(expect_exact(dt, line));
}

} // namespace test_robustness_findings

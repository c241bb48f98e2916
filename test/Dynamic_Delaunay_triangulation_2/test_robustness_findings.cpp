// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// What `./dev bench robustness` has found, reduced to the smallest case.

#include "oracle.h"

#include <CGAL/Dynamic_population_2.h>
#include <CGAL/Random_classifier_2.h>
#include <CGAL/Relocation_repair_2.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace {

using Point = Epick::Point_2;
using Points = std::vector<Point>;
using Dynamic = CGAL::Dynamic_Delaunay_triangulation_2<Epick>;
using Moves = std::vector<std::pair<std::size_t, Point>>;

TEST(Robustness_findings, reports_that_a_population_is_certified_if_nobody_is_new)
{
  CGAL::Dynamic_population_2<Dynamic> population;
  const std::vector<std::pair<int, Point>> frame = {
      {7, {0, 0}}, {8, {1, 0}}, {9, {0, 1}}, {6, {2, 2}}};
  EXPECT_TRUE(population.update(frame.begin(), frame.end()).certified);
  EXPECT_TRUE(population.update(frame.begin(), frame.end()).certified);
  EXPECT_TRUE(population.triangulation().is_certified());
}

TEST(Robustness_findings, reports_that_a_population_is_certified_if_nobody_is_there)
{
  CGAL::Dynamic_population_2<Dynamic> population;
  const std::vector<std::pair<int, Point>> nobody;
  EXPECT_TRUE(population.update(nobody.begin(), nobody.end()).certified);
}

void expect_to_keep_vertices(const Moves& moves)
{
  Points points = Cloud<Epick>::grid(8, 8);
  Dynamic dt(points.begin(), points.end());
  std::vector<Dynamic::Vertex_handle> vertices;
  for (std::size_t id = 0; id < points.size(); ++id)
    vertices.push_back(dt.vertex(id));
  dt.move(moves.begin(), moves.end());
  for (const auto& [id, point] : moves)
    points[id] = point;
  ASSERT_NO_FATAL_FAILURE(expect_exact(dt, points));
  for (std::size_t id = 0; id < points.size(); ++id)
    EXPECT_EQ(dt.vertex(id), vertices[id]) << "id " << id;
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

// Relocation takes the edges away, and who parts has to get a vertex all the same.
TEST(Robustness_findings, lets_points_part_while_relocation_brings_all_onto_a_line)
{
  using Random = CGAL::Random_classifier_2;
  using Relocating =
      CGAL::Dynamic_Delaunay_triangulation_2<Epick, Random, CGAL::Relocation_repair_2>;
  Points points = Cloud<Epick>::grid(4, 4);
  points.push_back(points.front());
  Relocating dt(points.begin(), points.end(), Random(1));
  for (std::size_t id = 0; id < points.size(); ++id)
    points[id] = Point(double(id), 0);
  const auto report = dt.update(points.begin(), points.end());
  EXPECT_EQ(report.rebuild_reason, CGAL::Rebuild_reason_2::DIMENSION);
  expect_exact(dt, points);
}

} // namespace

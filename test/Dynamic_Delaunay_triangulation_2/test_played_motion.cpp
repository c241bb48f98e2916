// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Motion that a user interferes with, as on the page that plays it.

#include "bindings/web/motion/Played_motion.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <exception>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using namespace page;

std::unique_ptr<Played_motion> played(const std::string& text, std::size_t number_of_points)
{
  return make_motion(scenario::parse_scenario("test", text), number_of_points);
}

// A row of discs that touch, and nothing that moves them.
std::unique_ptr<Played_motion> row_of_discs(std::size_t number, const std::string& bonded = "false")
{
  const std::string columns = std::to_string(number);
  return played(R"({ "name": "row", "kind": "particles", "packing": "square", "jitter": 0,
      "seed": 1, "frames": 1, "time_step": 0.1, "diameter": 1, "mass": 1, "stiffness": 1,
      "damping": 0.1, "gravity": 0,
      "bodies": [{ "rows": 1, "columns": )" +
                    columns + R"(, "position": [0, 0], "bonded": )" + bonded + "}] }",
                number);
}

std::unique_ptr<Played_motion> walk(const std::string& cell)
{
  return played(R"({ "name": "walk", "kind": "brownian", "seed": 1, "frames": 1,
      "time_step": 0.001, "points": 9, "box": [3, 3], "cell": ")" +
                    cell + "\" }",
                100);
}

double distance(const Point& p, const Point& q)
{
  return std::hypot(p.x - q.x, p.y - q.y);
}

TEST(Played_particles, fall_where_gravity_points)
{
  const auto motion = row_of_discs(1);
  const Point first = motion->points()[0];
  motion->set_field({2.0, -1.0});
  motion->advance({});
  EXPECT_NEAR(motion->points()[0].x - first.x, 0.02, 1e-15);
  EXPECT_NEAR(motion->points()[0].y - first.y, -0.01, 1e-15);
}

TEST(Played_particles, go_where_they_are_held_and_stay)
{
  const auto motion = row_of_discs(1);
  for (int step = 0; step != 600; ++step) {
    motion->hold(0, {20.0, -30.0});
    motion->advance({});
  }
  EXPECT_LT(distance(motion->points()[0], {20.0, -30.0}), 1e-3);
}

TEST(Played_particles, are_thrown_when_nothing_holds_them_any_more)
{
  const auto motion = row_of_discs(1);
  motion->hold(0, {100.0, 0.5});
  motion->advance({});
  const Point held = motion->points()[0];
  motion->advance({});
  const Point thrown = motion->points()[0];
  EXPECT_GT(thrown.x, held.x);
  motion->advance({});
  EXPECT_DOUBLE_EQ(motion->points()[0].x - thrown.x, thrown.x - held.x);
}

TEST(Played_particles, are_not_torn_away_by_a_hand_that_is_distant)
{
  const auto close = row_of_discs(1), distant = row_of_discs(1);
  close->hold(0, {10.0, 0.5});
  distant->hold(0, {1e6, 0.5});
  close->advance({});
  distant->advance({});
  EXPECT_EQ(close->points()[0].x, distant->points()[0].x);
}

TEST(Played_particles, that_are_added_rest_until_neighbors_push_them)
{
  const auto motion = row_of_discs(2);
  motion->add({2.0, 0.5}); // over half of the second one
  motion->advance({});
  ASSERT_EQ(motion->points().size(), 3u);
  EXPECT_EQ(motion->points()[2].x, 2.0);
  motion->advance({{0u, 1u}, {1u, 2u}});
  EXPECT_GT(motion->points()[2].x, 2.0);
  EXPECT_LT(motion->points()[1].x, 1.5);
}

TEST(Played_particles, that_are_removed_pull_at_no_bond_and_leave_the_others_their_numbers)
{
  const auto bonded = row_of_discs(3, "true"), parted = row_of_discs(3, "true");
  parted->remove(1);
  bonded->hold(0, {-5.0, 0.5});
  parted->hold(0, {-5.0, 0.5});
  for (int step = 0; step != 3; ++step) {
    bonded->advance({});
    parted->advance({});
  }
  EXPECT_TRUE(std::isnan(parted->points()[1].x));
  EXPECT_LT(parted->points()[0].x, 0.5);
  EXPECT_LT(bonded->points()[2].x, 2.5);
  EXPECT_EQ(parted->points()[2].x, 2.5);
}

TEST(Played_particles, that_were_removed_can_be_put_back_and_rest)
{
  const auto motion = row_of_discs(2, "true");
  motion->hold(0, {9.0, 9.0});
  motion->advance({});
  motion->remove(0);
  motion->put_back(0, {5.0, 7.0});
  motion->advance({});
  EXPECT_EQ(distance(motion->points()[0], {5.0, 7.0}), 0.0);
}

TEST(Played_walk, drifts_with_the_wind_in_spacings)
{
  const auto calm = walk("periodic"), windy = walk("periodic");
  EXPECT_DOUBLE_EQ(calm->spacing(), 0.3);
  windy->set_field({0.1, 0.0});
  calm->advance({});
  windy->advance({});
  for (std::size_t i = 0; i != calm->points().size(); ++i) {
    const double moved = windy->points()[i].x - calm->points()[i].x;
    EXPECT_NEAR(moved < 0.0 ? moved + 3.0 : moved, 0.03, 1e-12) << i;
  }
}

TEST(Played_walk, takes_a_point_where_it_is_held_but_not_out_of_its_box)
{
  const auto motion = walk("closed");
  motion->hold(7, {1.0, 2.0});
  motion->hold(8, {4.0, 2.0});
  motion->advance({});
  EXPECT_EQ(distance(motion->points()[7], {1.0, 2.0}), 0.0);
  EXPECT_EQ(distance(motion->points()[8], {2.0, 2.0}), 0.0); // reflected
  motion->advance({});
  EXPECT_NE(distance(motion->points()[7], {1.0, 2.0}), 0.0);
}

TEST(Played_walk, has_added_points_walk_as_well)
{
  const auto motion = walk("periodic");
  motion->add({3.5, 1.0});
  ASSERT_EQ(motion->points().size(), 101u);
  EXPECT_EQ(distance(motion->points()[100], {0.5, 1.0}), 0.0); // its image in the cell
  motion->advance({});
  EXPECT_GT(distance(motion->points()[100], {0.5, 1.0}), 0.0);
}

TEST(Played_motion, of_no_points_is_refused)
{
  EXPECT_THROW(row_of_discs(0), std::exception);
  EXPECT_THROW(played(R"({ "name": "walk", "kind": "brownian", "seed": 1, "frames": 1,
      "time_step": 0.001, "points": 9, "box": [3, 3] })",
                      0),
               std::invalid_argument);
}

} // namespace

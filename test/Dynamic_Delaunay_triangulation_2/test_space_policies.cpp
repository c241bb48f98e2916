// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Update policies of points in space: when they are asked, what they see, what they decide.

#include "space_oracle.h"
#include "space_points.h"

#include <CGAL/Dynamic_Delaunay_triangulation_2/policies/Always_static_policy_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/policies/Chosen_policy_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/policies/Key_frame_policy_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/Dynamic_population_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <stdexcept>
#include <utility>
#include <vector>

namespace test_space_policies {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Points = std::vector<Point>;
using space_points::lattice;
using space_points::random_points;
using space_points::shaken;
using Reason = CGAL::Rebuild_reason_2;

template <class Policy>
using Triangulation = CGAL::Dynamic_Delaunay_triangulation_3<Kernel, CGAL::With_policy_2<Policy>>;

template <class Dynamic>
void expect_exact(const Dynamic& dt, const Points& points)
{
  std::map<std::size_t, Point> by_id;
  for (std::size_t id = 0; id < points.size(); ++id)
    by_id.emplace(id, points[id]);
  space_oracle::expect_exact(dt, by_id);
}

TEST(Policies_in_space, rebuild_every_frame_if_they_are_static)
{
  Points points = random_points(200);
  Triangulation<CGAL::Always_static_policy_2> dt(points);
  for (unsigned frame = 0; frame < 4; ++frame) {
    points = shaken(points, 1e-4, frame);
    EXPECT_EQ(dt.update(points).rebuild_reason, Reason::POLICY);
    expect_exact(dt, points);
  }
  EXPECT_EQ(dt.move(3, Point(0.5, 0.5, 0.5)).rebuild_reason, Reason::NONE) << "that is no frame";
}

TEST(Policies_in_space, rebuild_key_frames)
{
  Points points = random_points(200);
  Triangulation<CGAL::Key_frame_policy_2> dt(points, CGAL::Key_frame_policy_2(3));
  EXPECT_EQ(dt.policy().k(), 3u);
  for (unsigned frame = 1; frame < 10; ++frame) {
    points = shaken(points, 1e-4, frame);
    EXPECT_EQ(dt.update(points).rebuild_reason, frame % 3 == 0 ? Reason::POLICY : Reason::NONE);
    expect_exact(dt, points);
  }
}

TEST(Policies_in_space, may_be_chosen_while_a_program_runs)
{
  using Policy = CGAL::Chosen_policy_2<CGAL::Always_dynamic_policy_2, CGAL::Always_static_policy_2>;
  for (const bool is_static : {false, true}) {
    Points points = random_points(100);
    Triangulation<Policy> dt(points, is_static ? Policy(CGAL::Always_static_policy_2())
                                               : Policy(CGAL::Always_dynamic_policy_2()));
    points = shaken(points, 1e-4);
    EXPECT_EQ(dt.update(points).rebuilt(), is_static);
  }
}

// Counts its calls, compares what it sees with what the test knows, and answers as it is told.
struct Witness
{
  template <class Frame>
  bool wants_rebuild(const Frame& frame)
  {
    ++asked;
    if (throws)
      throw std::runtime_error("policy");
    if (old_points != nullptr)
      look_at(frame);
    return wants;
  }
  template <class Frame>
  void after_update(const Frame& frame, const CGAL::Update_report_3& report)
  {
    ++told;
    EXPECT_TRUE(report.certified);
    broken_afterwards = broken_cells(frame);
    if (throws_afterwards)
      throw std::runtime_error("policy, afterwards");
  }

  template <class Frame>
  static std::size_t broken_cells(const Frame& frame)
  {
    std::size_t broken = 0;
    for (typename Frame::Cell_index c(0); c < frame.number_of_cells(); ++c)
      broken += !frame.is_delaunay(c);
    return broken;
  }

  template <class Frame>
  void look_at(const Frame& frame)
  {
    ASSERT_EQ(frame.number_of_points(), new_points->size());
    ASSERT_EQ(frame.number_of_ids(), new_points->size());
    for (std::size_t id = 0; id < new_points->size(); ++id) {
      ASSERT_TRUE(frame.has_id(id));
      const typename Frame::Vertex_index v = frame.vertex(id);
      ASSERT_TRUE(frame.has_point(v));
      ASSERT_EQ(std::size_t(frame.id(v)), id);
      ASSERT_EQ(frame.position(v).x, (*new_points)[id].x());
      ASSERT_EQ(frame.position(v).z, (*new_points)[id].z());
      ASSERT_EQ(frame.previous_position(v).y, (*old_points)[id].y());
    }
    std::size_t infinite = 0;
    for (typename Frame::Cell_index c(0); c < frame.number_of_cells(); ++c) {
      std::size_t infinite_vertices = 0;
      for (const typename Frame::Vertex_index v : frame.cell(c))
        infinite_vertices += Frame::is_infinite(v);
      ASSERT_EQ(frame.is_infinite(c), infinite_vertices == 1);
      infinite += infinite_vertices;
    }
    EXPECT_GT(infinite, 3u);
    EXPECT_TRUE(std::isnan(frame.position(typename Frame::Vertex_index(0)).x));
    broken_before = broken_cells(frame);
  }

  bool wants = false, throws = false, throws_afterwards = false;
  const Points *old_points = nullptr, *new_points = nullptr;
  std::size_t asked = 0, told = 0, broken_before = 0, broken_afterwards = 0;
};

// A policy that the test can reach while the triangulation has a copy of it.
struct Witness_reference
{
  template <class Frame>
  bool wants_rebuild(const Frame& frame)
  {
    return witness->wants_rebuild(frame);
  }
  template <class Frame>
  void after_update(const Frame& frame, const CGAL::Update_report_3& report)
  {
    witness->after_update(frame, report);
  }
  Witness* witness;
};
using Witnessed = Triangulation<Witness_reference>;

TEST(Policies_in_space, see_new_positions_and_the_cells_of_the_last_frame)
{
  Witness witness;
  Points before = random_points(300);
  Witnessed dt(before, Witness_reference{&witness});
  EXPECT_EQ(witness.asked + witness.told, 0u) << "construction is no frame";
  for (const double step : {0.0, 1e-5, 1e-2}) {
    const Points after = step > 0 ? shaken(before, step) : before;
    witness.old_points = &before;
    witness.new_points = &after;
    const CGAL::Update_report_3 report = dt.update(after);
    EXPECT_EQ(report.rebuild_reason, Reason::NONE);
    EXPECT_EQ(witness.broken_before == 0, report.flips == 0);
    EXPECT_EQ(witness.broken_afterwards, 0u);
    expect_exact(dt, after);
    before = after;
  }
  EXPECT_GT(witness.broken_before, 10u);
  EXPECT_EQ(witness.asked, 3u);
  EXPECT_EQ(witness.told, 3u);
}

TEST(Policies_in_space, decide_by_what_they_see)
{
  Witness witness;
  Points points = random_points(150);
  Witnessed dt(points, Witness_reference{&witness});
  for (unsigned frame = 0; frame < 4; ++frame) {
    witness.wants = frame % 2 == 0;
    points = shaken(points, 1e-3, frame);
    EXPECT_EQ(dt.update(points).rebuild_reason, witness.wants ? Reason::POLICY : Reason::NONE);
    expect_exact(dt, points);
  }
}

TEST(Policies_in_space, change_nothing_where_they_throw)
{
  Witness witness;
  Points points = random_points(150);
  points.push_back(points.front());
  Witnessed dt(points, Witness_reference{&witness});
  const auto cells = space_oracle::cells_of(dt);
  witness.throws = true;
  EXPECT_THROW(dt.update(shaken(points, 0.01)), std::runtime_error);
  EXPECT_TRUE(dt.is_certified());
  EXPECT_EQ(space_oracle::cells_of(dt), cells);
  expect_exact(dt, points);
  EXPECT_EQ(witness.told, 0u);
  witness.throws = false;
  points = shaken(points, 0.01);
  EXPECT_FALSE(dt.update(points).rebuilt());
  expect_exact(dt, points);
}

TEST(Policies_in_space, may_throw_when_all_is_done)
{
  Witness witness;
  Points points = random_points(150);
  Witnessed dt(points, Witness_reference{&witness});
  witness.throws_afterwards = true;
  points = shaken(points, 0.01);
  EXPECT_THROW(dt.update(points), std::runtime_error);
  expect_exact(dt, points);
}

TEST(Policies_in_space, are_asked_only_where_there_is_a_choice)
{
  Witness witness;
  Witnessed flat(Points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}, Witness_reference{&witness});
  EXPECT_EQ(flat.update(Points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 1}}).rebuild_reason,
            Reason::DIMENSION);
  EXPECT_EQ(witness.asked, 0u);
  EXPECT_EQ(witness.told, 1u);
  EXPECT_FALSE(flat.update(Points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 2}}).rebuilt());
  EXPECT_EQ(witness.asked, 1u);
  flat.insert(Point(3, 3, 3));
  flat.move(0, Point(0, 0, -1));
  flat.remove(0);
  flat.mend();
  EXPECT_EQ(witness.asked, 1u) << "these are no frames";
  EXPECT_EQ(witness.told, 2u);
}

using Population = CGAL::Dynamic_population_3<Witnessed, std::int64_t>;
using Identified = std::vector<std::pair<std::int64_t, Point>>;

// A point has the number of its place as its id, but for the first `newcomers`.
Identified identified(const Points& points, std::size_t newcomers)
{
  Identified result;
  for (std::size_t i = 0; i < points.size(); ++i)
    result.emplace_back(std::int64_t(i) + (i < newcomers ? 1000 : 0), points[i]);
  return result;
}

TEST(Policies_in_space, are_asked_for_populations)
{
  Witness witness;
  Points points = random_points(400);
  Population population{Witnessed(Witness_reference{&witness})};
  population.update(identified(points, 0));
  for (unsigned frame = 1; frame < 7; ++frame) {
    witness.wants = frame % 3 == 0;
    points = shaken(points, 1e-4, frame);
    const std::size_t asked = witness.asked;
    const CGAL::Update_report_3 report = population.update(identified(points, 2 * frame));
    EXPECT_EQ(report.removed, 2u);
    EXPECT_EQ(report.inserted, 2u);
    EXPECT_EQ(witness.asked, asked + 1);
    EXPECT_EQ(report.rebuild_reason, witness.wants ? Reason::POLICY : Reason::NONE);
    EXPECT_TRUE(population.triangulation().is_valid(true));
    EXPECT_EQ(population.triangulation().number_of_points(), points.size());
  }
}

TEST(Policies_in_space, may_throw_in_a_frame_of_a_population)
{
  Witness witness;
  const Points points = random_points(200);
  Population population{Witnessed(Witness_reference{&witness})};
  population.update(identified(points, 0));
  witness.throws = true;
  EXPECT_THROW(population.update(identified(shaken(points, 0.001), 3)), std::runtime_error);
  EXPECT_FALSE(population.triangulation().is_certified());
  witness.throws = false;
  const Points after = shaken(points, 0.002);
  population.update(identified(after, 3));
  const Witnessed& dt = population.triangulation();
  EXPECT_TRUE(dt.is_valid(true));
  ASSERT_EQ(dt.number_of_points(), points.size());
  for (std::size_t i = 0; i < after.size(); ++i)
    EXPECT_EQ(dt.point(population.id(std::int64_t(i) + (i < 3 ? 1000 : 0))), after[i]);
}

TEST(Policies_in_space, are_copied_with_their_triangulation)
{
  using Dynamic = Triangulation<CGAL::Key_frame_policy_2>;
  Points points = random_points(100);
  Dynamic dt(points, CGAL::Key_frame_policy_2(2));
  points = shaken(points, 1e-4);
  EXPECT_FALSE(dt.update(points).rebuilt());
  Dynamic copy(dt), moved(std::move(dt));
  EXPECT_EQ(dt.policy().k(), 2u);
  EXPECT_EQ(dt.number_of_points(), 0u);
  points = shaken(points, 1e-4);
  EXPECT_TRUE(copy.update(points).rebuilt()) << "it counts as the other one has counted";
  EXPECT_TRUE(moved.update(points).rebuilt());
}

} // namespace test_space_policies

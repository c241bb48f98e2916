// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Memory that runs out, at each of the allocations of a call, loses no point in space, and mend()
// repairs what is left.

#include "replaced_heap.h"
#include "space_oracle.h"
#include "space_points.h"

#include <CGAL/Dynamic_Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <functional>
#include <map>
#include <new>
#include <sstream>
#include <vector>

namespace test_space_memory {

using Dynamic = CGAL::Dynamic_Delaunay_triangulation_3<CGAL::Epick>;
using Point = Dynamic::Point;
using Points = std::vector<Point>;
using Places = std::map<std::size_t, Point>;
using space_points::random_points;
using space_points::shaken;

Places places_of(const Dynamic& dt)
{
  Places places;
  for (std::size_t id = 0; id < dt.number_of_ids(); ++id)
    if (dt.has_id(id))
      places.emplace(id, dt.point(id));
  return places;
}

bool is_at(const Places& places, std::size_t id, const Point& p)
{
  const auto found = places.find(id);
  return found != places.end() && found->second == p;
}

// Expects each point where it was before the call or where it belongs after it, and each that comes
// or goes there or not.
void expect_between(const Dynamic& dt, const Places& before, const Places& after)
{
  const Places now = places_of(dt);
  ASSERT_EQ(dt.number_of_points(), now.size());
  for (const auto& [id, p] : now)
    ASSERT_TRUE(is_at(before, id, p) || is_at(after, id, p)) << "id " << id << " is at " << p;
  for (const auto& [id, p] : before)
    ASSERT_TRUE(now.count(id) > 0 || after.count(id) == 0) << "id " << id << " is lost";
}

// Without a certificate there are no cells, and no file.
void expect_empty_or_exact(const Dynamic& dt, const Places& before)
{
  if (dt.is_certified())
    return space_oracle::expect_exact(dt, before); // nothing has changed
  ASSERT_FALSE(dt.is_valid());
  ASSERT_EQ(dt.number_of_cells(), 0u);
  ASSERT_EQ(space_oracle::number_of_edges(dt) + space_oracle::number_of_facets(dt), 0u);
  std::ostringstream file;
  EXPECT_THROW(dt.write_checkpoint(file), CGAL::Checkpoint_error_2);
  EXPECT_EQ(file.str(), "");
  Dynamic copy(dt);
  EXPECT_FALSE(copy.certify());
}

// One of the calls that mend everything, each in its turn.
void expect_recovery(Dynamic& dt, long turn)
{
  Places places = places_of(dt);
  switch (places.empty() ? 0 : turn % 5) {
  case 0:
    dt.mend();
    break;
  case 1: {
    Points frame(dt.number_of_ids(), Point(0, 0, 0));
    for (auto& [id, p] : places)
      frame[id] = p = Point(p.x() + 0.1 * p.y(), p.y(), p.z());
    dt.update(frame);
    break;
  }
  case 2: {
    std::size_t smallest = 0;
    while (dt.has_id(smallest))
      ++smallest;
    const Point p(0.5, 0.5, 0.5);
    const std::size_t id = dt.insert(p);
    EXPECT_EQ(id, smallest); // no free id is lost
    places.emplace(id, p);
    break;
  }
  case 3:
    dt.remove(places.begin()->first);
    places.erase(places.begin());
    break;
  default:
    dt.move(places.begin()->first, Point(2, 2, 2));
    places.begin()->second = Point(2, 2, 2);
  }
  ASSERT_NO_FATAL_FAILURE(space_oracle::expect_exact(dt, places));
}

// False if `work` ran out of memory after so many allocations.
bool succeeds(const std::function<void()>& work, long allocations)
{
  try {
    const replaced_heap::Scarcity scarcity(allocations);
    work();
    return true;
  } catch (const std::bad_alloc&) {
    return false;
  }
}

// Makes a call once for each of its allocations, at which memory then runs out. Returns their
// number.
template <class Change>
long expect_survival(const Dynamic& original, const Change& change)
{
  const Places before = places_of(original);
  Dynamic changed(original);
  change(changed);
  const Places after = places_of(changed);
  for (long allocations = 0;; ++allocations) {
    SCOPED_TRACE(testing::Message() << allocations << " allocations");
    Dynamic dt(original);
    if (succeeds([&] { change(dt); }, allocations))
      return allocations;
    expect_between(dt, before, after);
    expect_empty_or_exact(dt, before);
    expect_recovery(dt, allocations);
    if (testing::Test::HasFailure())
      return allocations;
  }
}

// Points that coincide, and free ids.
Dynamic original(Points points)
{
  points[9] = points[4] = points[11];
  Dynamic dt(points);
  dt.remove({3, 17});
  return dt;
}

class Memory_in_space : public testing::TestWithParam<double>
{
};

TEST_P(Memory_in_space, may_run_out_in_a_frame)
{
  const Points points = random_points(60);
  const Points next = shaken(points, GetParam());
  EXPECT_GT(expect_survival(original(points), [&](Dynamic& dt) { dt.update(next); }), 3);
}
INSTANTIATE_TEST_SUITE_P(steps, Memory_in_space, testing::Values(1e-6, 0.002, 0.01, 0.03, 0.3));

TEST(Memory_in_space, may_run_out_where_vertices_are_held_and_stuck)
{
  Points points;
  for (int x = 0; x < 5; ++x)
    for (int y = 0; y < 5; ++y)
      for (int z = 0; z < 5; ++z)
        points.emplace_back(x, y, z);
  const Points first = shaken(points, 0.05), second = shaken(first, 0.1);
  EXPECT_GT(expect_survival(Dynamic(first), [&](Dynamic& dt) { dt.update(second); }), 30);
  EXPECT_GT(expect_survival(Dynamic(points), [&](Dynamic& dt) { dt.update(first); }), 30);
}

TEST(Memory_in_space, may_run_out_where_points_jump_and_meet)
{
  const Points points = random_points(400);
  Points next = shaken(points, 1e-5);
  std::swap(next[100], next[200]);
  next[300] = Point(0.5, 0.5, 0.5);
  next[250] = next[350];
  const Dynamic dt = original(points);
  Dynamic check(dt);
  const CGAL::Update_report_3 report = check.update(next);
  EXPECT_FALSE(report.rebuilt());
  EXPECT_GE(report.relocated, 3u);
  EXPECT_EQ(report.merged, 1u);
  EXPECT_EQ(report.parted, 2u);
  EXPECT_GT(expect_survival(dt, [&](Dynamic& d) { d.update(next); }), 30);
}

TEST(Memory_in_space, may_run_out_where_points_come_and_go)
{
  const Points few = random_points(4, 5), many = random_points(40, 6);
  const std::vector<std::size_t> some{1, 4, 30}, half{1, 4, 9, 11, 20, 21, 22, 23, 24, 25, 26, 30};
  for (const std::size_t number : {60u, 200u}) {
    const Dynamic dt = original(random_points(number));
    EXPECT_GT(expect_survival(dt, [&](Dynamic& d) { d.insert(few.begin(), few.end()); }), 3);
    EXPECT_GT(expect_survival(dt, [&](Dynamic& d) { d.remove(some.begin(), some.end()); }), 3);
    EXPECT_GT(expect_survival(dt, [&](Dynamic& d) { d.move(11, Point(0.1, 0.2, 0.3)); }), 3);
    EXPECT_GT(expect_survival(dt, [&](Dynamic& d) { d.move(30, Point(0.1, 0.2, 0.3)); }), 3);
  }
  const Dynamic dt = original(random_points(60));
  EXPECT_GT(expect_survival(dt, [&](Dynamic& d) { d.insert(many.begin(), many.end()); }), 10);
  EXPECT_GT(expect_survival(dt, [&](Dynamic& d) { d.remove(half.begin(), half.end()); }), 10);
}

TEST(Memory_in_space, may_run_out_in_a_plane)
{
  Points flat = random_points(30);
  for (Point& p : flat)
    p = Point(p.x(), p.y(), 0);
  const Points next = random_points(30, 7);
  const Dynamic dt = original(flat);
  EXPECT_GT(expect_survival(dt, [&](Dynamic& d) { d.update(flat); }), 3);
  EXPECT_GT(expect_survival(dt, [&](Dynamic& d) { d.update(next); }), 3);
  EXPECT_GT(expect_survival(original(next), [&](Dynamic& d) { d.update(flat); }), 3);
  EXPECT_GT(expect_survival(Dynamic(), [&](Dynamic& d) { d.insert(next.begin(), next.end()); }), 3);
}

TEST(Memory_in_space, may_run_out_again_and_again)
{
  const Points points = random_points(80);
  std::size_t failures = 0;
  for (long step = 1; step < 40; ++step) {
    Dynamic dt = original(points);
    for (int turn = 0; turn < 30; ++turn) {
      const Points next = shaken(points, 0.001 * (turn + 1));
      const auto change = [&] {
        if (turn % 3 == 0)
          dt.update(Points(next.begin(), next.begin() + std::ptrdiff_t(dt.number_of_ids())));
        else if (turn % 3 == 1)
          dt.remove(std::size_t(turn));
        else if (dt.number_of_ids() > dt.number_of_points())
          dt.insert(next[0]);
      };
      if (turn % 3 == 1 && !dt.has_id(std::size_t(turn)))
        continue;
      failures += !succeeds(change, step * turn % 97);
      ASSERT_EQ(places_of(dt).size(), dt.number_of_points());
      ASSERT_EQ(dt.number_of_ids(), 80u);
    }
    dt.mend();
    ASSERT_NO_FATAL_FAILURE(space_oracle::expect_exact(dt, places_of(dt)));
  }
  EXPECT_GT(failures, 100u);
}

} // namespace test_space_memory

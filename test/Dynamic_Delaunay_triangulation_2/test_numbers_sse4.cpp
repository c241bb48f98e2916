// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The package as it is compiled for SSE4.1 or newer: CGAL's intervals are unsound then where they
// overflow, and numbers so large that they could are refused.

#include "quadruples.h"
#include "sealed_checkpoint.h"

#include <CGAL/Dynamic_periodic_Delaunay_triangulation_2.h>

#include <cstddef>
#include <limits>
#include <sstream>
#include <string>

namespace {

using CGAL::Dynamic_Delaunay_triangulations_2::internal::coordinate_limit;
static_assert(coordinate_limit < std::numeric_limits<double>::infinity(),
              "this program is about limited coordinates");

using Points = std::vector<Epick::Point_2>;
using Dynamic = CGAL::Dynamic_Delaunay_triangulation_2<Epick>;

TEST(Numbers_of_new_instructions, within_the_limit_have_exact_predicates)
{
  EXPECT_GT(expect_exact_kernel_predicates(1, 300000), 10000u);
}

TEST(Numbers_of_new_instructions, are_limited_because_intervals_lose_a_zero)
{
  const CGAL::Interval_nt<true> not_positive(-1, 0), overflown(1, HUGE_VAL);
  EXPECT_LT((not_positive * overflown).sup(), 0);
}

TEST(Numbers_of_new_instructions, beyond_the_limit_are_refused_and_nothing_changes)
{
  const Points points = Cloud<Epick>(1).uniform(30);
  Dynamic dt(points.begin(), points.end());
  for (const double x : {largest, -largest, coordinate_limit, -coordinate_limit}) {
    Points beyond = points;
    beyond[7] = Epick::Point_2(1, x);
    try {
      dt.update(beyond.begin(), beyond.end());
      FAIL();
    } catch (const CGAL::Coordinate_range_error_2& error) {
      EXPECT_EQ(error.id(), 7u);
      EXPECT_EQ(error.x(), 1);
      EXPECT_EQ(error.y(), x);
      EXPECT_EQ(error.limit(), coordinate_limit);
    }
    ASSERT_NO_FATAL_FAILURE(expect_exact(dt, points));
    EXPECT_THROW(Dynamic(beyond.begin(), beyond.end()), CGAL::Coordinate_range_error_2);
  }
}

TEST(Numbers_of_new_instructions, beyond_the_limit_are_refused_across_a_slab)
{
  Points points = Cloud<Epick>(2).uniform(30);
  points[8] = points[7]; // also where points coincide
  CGAL::Dynamic_periodic_Delaunay_triangulation_2<Epick> pt(
      points, CGAL::Periodic_cell_2(Epick::Vector_2(2, 0)));
  for (const std::size_t id : {7, 8, 20})
    for (const double y : {largest, -coordinate_limit}) {
      Points beyond = points;
      beyond[id] = Epick::Point_2(1, y);
      EXPECT_THROW(pt.update(beyond), CGAL::Coordinate_range_error_2);
      EXPECT_EQ(pt.point(id), points[id]);
      ASSERT_TRUE(pt.is_certified() && pt.is_valid());
    }
}

TEST(Numbers_of_new_instructions, beyond_the_limit_are_refused_in_a_checkpoint)
{
  const Points points = {{0, 0}, {1, 0}, {0, 1e150}};
  const Dynamic dt(points.begin(), points.end());
  std::ostringstream out;
  dt.write_checkpoint(out);
  std::string text = out.str();
  text.replace(text.find("1e+150"), 6, "1e+200");
  std::istringstream in(resealed(text));
  Dynamic read;
  EXPECT_THROW(read.read_checkpoint(in), CGAL::Checkpoint_error_2);
  EXPECT_EQ(read.number_of_points(), 0u);
}

TEST(Numbers_of_new_instructions, just_below_the_limit_are_followed)
{
  const double most = std::nextafter(coordinate_limit, 0);
  Points corners = {{-most, -most}, {most, -most}, {most, most}, {-most, most}, {0, 0}};
  Dynamic dt(corners.begin(), corners.end());
  ASSERT_NO_FATAL_FAILURE(expect_exact(dt, corners));
  corners[4] = Epick::Point_2(1, most);
  dt.update(corners.begin(), corners.end());
  ASSERT_NO_FATAL_FAILURE(expect_exact(dt, corners));
}

} // namespace

// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// What is particular to wires: space that is periodic along one vector and open across it.

#include "periodic_space_tested.h"

#include <CGAL/Dynamic_Delaunay_triangulation_3/Delaunay_neighbor_lists_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/Voronoi_cell_gradients_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/Voronoi_cell_measures_3.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <sstream>
#include <string>

namespace test_periodic_space_wire_3 {

using namespace periodic_space_tested;

const Cell straight(Coordinates{1, 0, 0});

// CELLS -------------------------------------------------------------------------------------------

TEST(Cells_of_wires, have_one_vector)
{
  EXPECT_TRUE(straight.is_wire());
  EXPECT_FALSE(straight.is_slab());
  EXPECT_EQ(straight.dimension(), 1);
  EXPECT_EQ(straight.a(), (Coordinates{1, 0, 0}));
  EXPECT_EQ(straight.b(), (Coordinates{0, 0, 1}));
  EXPECT_EQ(straight.c(), (Coordinates{0, -1, 0}));
  EXPECT_EQ(straight.volume(), infinity);
  EXPECT_FALSE(Cell(1, 1, 1).is_wire());
  EXPECT_NE(straight, Cell(Coordinates{1, 0, 0}, Coordinates{0, 0, 1}));
  EXPECT_EQ(straight, Cell(Kernel::Vector_3(1, 0, 0)));
  for (const double scale : {1e-200, 1e-60, 1e60, 1e200}) {
    const Cell cell(Coordinates{0, scale, 0});
    EXPECT_EQ(cell.b()[1], 0);
    EXPECT_EQ(cell.c()[1], 0);
  }
}

TEST(Cells_of_wires, have_a_vector_that_is_finite_and_not_0)
{
  EXPECT_THROW(Cell(Coordinates{0, 0, 0}), CGAL::Periodic_cell_error_3);
  EXPECT_THROW(Cell(Coordinates{1, infinity, 3}), CGAL::Periodic_cell_error_3);
  EXPECT_THROW(Dynamic(Cell(Coordinates{1e-100, 0, 0})), CGAL::Periodic_cell_error_3);
  try {
    const Cell cell(Coordinates{0, 0, 0});
    FAIL();
  } catch (const CGAL::Periodic_cell_error_3& error) {
    EXPECT_STREQ(error.what(), "a wire has the vector (0, 0, 0): its vector must not be 0");
    EXPECT_EQ(error.a(), (Coordinates{0, 0, 0}));
  }
}

// HULLS -------------------------------------------------------------------------------------------

// On a circular tube around the x-axis.
Points tube(int rings, int around)
{
  Points points;
  for (int i = 0; i < rings; ++i)
    for (int j = 0; j < around; ++j) {
      const double angle = 2 * 3.141592653589793 * (j + 0.5 * (i % 2)) / around;
      points.emplace_back(double(i) / rings, std::cos(angle), std::sin(angle));
    }
  return points;
}

TEST(Wires, may_be_tubes)
{
  for (const int rings : {1, 2, 7})
    for (const int around : {3, 4, 12, 50}) {
      const Points points = tube(rings, around);
      ASSERT_NO_FATAL_FAILURE(expect_exact(Dynamic(points, straight), points, straight)) << around;
    }
}

TEST(Wires, have_no_cells_where_all_points_are_in_a_plane_along_them)
{
  for (const std::size_t number : {1u, 2u, 3u, 30u, 200u}) {
    Points flat, line;
    for (const Point& p : random_points(number)) {
      flat.emplace_back(p.x(), p.y(), 2 * p.y());
      line.emplace_back(p.x(), 0.5, 0.25);
    }
    for (Points points : {flat, line}) {
      points.push_back(Point(points[0].x() + 3, points[0].y(), points[0].z())); // may coincide
      Dynamic dt(points, straight);
      EXPECT_EQ(dt.number_of_cells(), 0u);
      EXPECT_TRUE(dt.certify());
      ASSERT_NO_FATAL_FAILURE(expect_exact(dt, points, straight));
      for (Point& p : points)
        p = Point(p.x() + 0.3, p.y() / 2, p.z() / 2);
      EXPECT_TRUE(dt.update(points).rebuilt());
      ASSERT_NO_FATAL_FAILURE(expect_exact(dt, points, straight));
      points[0] = Point(0, 0, 5);
      dt.update(points);
      ASSERT_NO_FATAL_FAILURE(expect_exact(dt, points, straight));
    }
  }
}

// The second of these is the hull's only vertex out of a plane, by one unit in the last place.
TEST(Wires, may_be_so_flat_that_no_double_is_inside)
{
  const double u = 0x1p-52;
  Points points{Point(0, 1, 1), Point(0.3, 2, 2 + 2 * u), Point(0.4, 1.5, 1.5)};
  for (int frame = 0; frame < 2; ++frame) {
    Dynamic dt(points, straight);
    ASSERT_NO_FATAL_FAILURE(expect_exact(dt, points, straight));
    EXPECT_GT(dt.number_of_cells(), 0u);
    dt.update(points);
    points.push_back(Point(0.7, 1.5, 1.5 + u));
    dt.insert(points.back());
    ASSERT_NO_FATAL_FAILURE(expect_exact(dt, points, straight));
  }
}

// Its hull sweeps over the line that was its axis.
TEST(Motion_in_wires, may_turn_a_wire_inside_out)
{
  const Points start = random_points(12, 5);
  for (const double step : {0.02, 0.1, 0.5}) {
    Points points = start;
    Dynamic dt(points, straight);
    for (double way = 0; way < 2; way += step) {
      for (std::size_t i = 0; i < points.size(); ++i) // the other way, each at its own pace
        points[i] = Point(start[i].x(), start[i].y() + way * (1 - 2 * start[i].y()),
                          start[i].z() + (i % 3 == 0 ? way : 0.5 * way) * (1 - 2 * start[i].z()));
      dt.update(points);
      ASSERT_NO_FATAL_FAILURE(expect_exact(dt, points, straight)) << step << ' ' << way;
    }
  }
}

// REACH -------------------------------------------------------------------------------------------

TEST(Points_in_wires, are_refused_where_they_are_too_far_away)
{
  Points points = random_points(20);
  Dynamic dt(points, straight);
  for (const double x : {2e6, 1e300}) {
    EXPECT_THROW(dt.insert(Point(x, 0, 0)), CGAL::Periodic_range_error_3);
    EXPECT_THROW(dt.insert(Point(0, 0, x)), CGAL::Periodic_range_error_3);
    Points moved = points;
    moved[3] = Point(0, -x, 0);
    EXPECT_THROW(dt.update(moved), CGAL::Periodic_range_error_3);
  }
  EXPECT_THROW(dt.insert(Point(0, 0, std::numeric_limits<double>::quiet_NaN())),
               CGAL::Non_finite_coordinate_error_3);
  ASSERT_NO_FATAL_FAILURE(expect_exact(dt, points, straight));
  points[3] = Point(1e6, 1e5, 0);
  points[4] = Point(0, 0, 1e6);
  dt.update(points);
  ASSERT_NO_FATAL_FAILURE(expect_exact(dt, points, straight));
}

// WITHOUT CELLS -----------------------------------------------------------------------------------

TEST(Voronoi_cells_in_wires, have_no_facets_where_there_are_no_cells)
{
  const Points points = points_in(straight, 20, 0);
  const Dynamic dt(points, straight);
  CGAL::Voronoi_cell_measures_3 measures;
  measures.compute(dt);
  CGAL::Voronoi_cell_gradients_3 gradients;
  gradients.compute(dt);
  CGAL::Delaunay_neighbor_lists_3 lists;
  lists.compute_with_vectors(dt);
  EXPECT_TRUE(lists.neighbors().empty());
  for (std::size_t id = 0; id < points.size(); ++id) {
    EXPECT_FALSE(measures.is_bounded(id));
    EXPECT_EQ(measures.offsets()[id], 0u);
    EXPECT_EQ(measures.volumes()[id], infinity);
    dt.for_each_neighbor(id, [](std::size_t, const Shift&) { FAIL(); });
  }
  Dynamic empty(straight);
  measures.compute(empty);
  lists.compute(empty);
  EXPECT_EQ(lists.number_of_ids(), 0u);
}

TEST(Checkpoints_of_wires, without_cells_have_points_in_a_plane)
{
  const Points points = points_in(straight, 6, 0);
  std::string text = written(Dynamic(points, straight));
  Dynamic read(Cell(Coordinates{1, 0.25, 0.125}));
  std::istringstream in(text);
  read.read_checkpoint(in);
  EXPECT_EQ(read.number_of_points(), 6u);
  EXPECT_TRUE(read.is_valid(true));
  Dynamic dt(random_points(6), straight); // its points, with no cells
  std::string other = written(dt);
  const std::size_t first = other.find("cells "), last = other.find("checksum");
  other.replace(first, last - first, "cells 0\ncorners 0\n");
  std::istringstream refused(other);
  try {
    read.read_checkpoint(refused);
    FAIL();
  } catch (const CGAL::Checkpoint_error_2& error) {
    EXPECT_NE(std::string(error.what()).find("Delaunay"), std::string::npos) << error.what();
  }
}

} // namespace test_periodic_space_wire_3

// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Triangulations of points in wires: space that is periodic along one vector and open across it.

#include "periodic_space_operations.h"
#include "periodic_space_oracle.h"
#include "periodic_space_tested.h"

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Dynamic_periodic_Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <map>
#include <random>
#include <set>
#include <utility>
#include <vector>

namespace test_periodic_space_wire_3 {

using namespace periodic_space_tested;

const Cell straight(Coordinates{1, 0, 0});
const Cell upright(Coordinates{0, 0, -0.7});
const Cell tilted(Coordinates{0.5, -0.9, 0.7});
const Cell oblique(Coordinates{0.1, 3, 0.25});

Points random_points(std::size_t number, double thickness = 1, std::uint64_t seed = 7)
{
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> coordinate(0, 1);
  Points points;
  for (std::size_t i = 0; i < number; ++i) {
    const double x = coordinate(random), y = thickness * coordinate(random);
    points.emplace_back(x, y, thickness * coordinate(random));
  }
  return points;
}

// In the square prism along a wire's vector, with sides of this length.
Points points_in(const Cell& cell, std::size_t number, double thickness = 1, std::uint64_t seed = 7)
{
  Points points;
  for (const Point& p : random_points(number, thickness, seed)) {
    Coordinates x{0, 0, 0};
    for (std::size_t k = 0; k < 3; ++k)
      x[k] = p.x() * cell.a()[k] + p.y() * cell.b()[k] + p.z() * cell.c()[k];
    points.emplace_back(x[0], x[1], x[2]);
  }
  return points;
}

Points lattice(int length, int width, int depth)
{
  Points points;
  for (int x = 0; x < length; ++x)
    for (int y = 0; y < width; ++y)
      for (int z = 0; z < depth; ++z)
        points.emplace_back(x, y, z);
  return points;
}

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

// CELLS -------------------------------------------------------------------------------------------

TEST(Cells_of_wires, have_one_vector)
{
  EXPECT_TRUE(straight.is_wire());
  EXPECT_FALSE(straight.is_slab());
  EXPECT_EQ(straight.dimension(), 1);
  EXPECT_EQ(straight.a(), (Coordinates{1, 0, 0}));
  EXPECT_EQ(straight.b(), (Coordinates{0, 0, 1}));
  EXPECT_EQ(straight.c(), (Coordinates{0, -1, 0}));
  EXPECT_EQ(straight.volume(), std::numeric_limits<double>::infinity());
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
  const double infinity = std::numeric_limits<double>::infinity();
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

// CREATION ----------------------------------------------------------------------------------------

TEST(Wires, may_have_any_number_of_points_in_any_cell)
{
  for (const Cell& cell : {straight, upright, tilted, oblique})
    for (const std::size_t number : {0u, 1u, 2u, 3u, 4u, 5u, 8u, 20u, 101u, 300u}) {
      const Points points = random_points(number);
      ASSERT_NO_FATAL_FAILURE(expect_exact(Dynamic(points, cell), points, cell)) << number;
    }
}

TEST(Wires, may_be_empty)
{
  Dynamic dt(straight);
  for (int n = 0; n < 2; ++n) {
    EXPECT_TRUE(dt.certify());
    EXPECT_TRUE(dt.is_valid(true));
    EXPECT_EQ(dt.number_of_cells(), 0u);
    EXPECT_EQ(dt.number_of_facets(), 0u);
    EXPECT_EQ(dt.number_of_edges(), 0u);
    EXPECT_TRUE(dt.update(Points(), oblique).certified);
    dt.remove(dt.insert(Point(0.5, 0.5, 0.5)));
    dt.update(Points(1, Point(0, 0, 0)), straight);
    EXPECT_TRUE(dt.certify());
    dt = Dynamic(tilted);
  }
}

TEST(Wires, may_be_thin_or_thick)
{
  for (const double thickness : {1e-12, 1e-5, 0.01, 30.0, 1e5})
    for (const std::size_t number : {3u, 7u, 60u}) {
      const Points points = points_in(tilted, number, thickness);
      ASSERT_NO_FATAL_FAILURE(expect_exact(Dynamic(points, tilted), points, tilted)) << thickness;
    }
}

TEST(Wires, may_be_of_any_scale_and_far_away)
{
  for (const double scale : {1e-50, 1e-9, 1e12, 1e50}) {
    const Cell cell(Coordinates{0.3 * scale, 2 * scale, 0.1 * scale});
    Points points;
    for (const Point& p : random_points(40))
      points.emplace_back(scale * p.x(), scale * p.y(), scale * p.z());
    Dynamic dt(points, cell);
    ASSERT_NO_FATAL_FAILURE(expect_exact(dt, points, cell)) << scale;
    for (Point& p : points)
      p = Point(p.x() + 3e5 * scale, p.y(), p.z() - 1e5 * scale);
    dt.update(points);
    ASSERT_NO_FATAL_FAILURE(expect_exact(dt, points, cell)) << scale;
  }
}

TEST(Wires, may_have_flat_walls)
{
  for (const int length : {1, 2, 5})
    for (const int width : {2, 3, 6}) {
      const Cell cell(Coordinates{double(length), 0, 0});
      const Points points = lattice(length, width, 3);
      ASSERT_NO_FATAL_FAILURE(expect_exact(Dynamic(points, cell), points, cell)) << length;
    }
  Points duct = random_points(150);
  for (const Point& p : random_points(150, 1, 8)) {
    duct.emplace_back(p.x(), p.y(), p.z() < 0.5 ? -0.25 : 1.25);
    duct.emplace_back(p.x(), p.z() < 0.5 ? -0.25 : 1.25, p.y());
  }
  ASSERT_NO_FATAL_FAILURE(expect_exact(Dynamic(duct, straight), duct, straight));
}

TEST(Wires, may_be_tubes)
{
  for (const int rings : {1, 2, 7})
    for (const int around : {3, 4, 12, 50}) {
      const Points points = tube(rings, around);
      ASSERT_NO_FATAL_FAILURE(expect_exact(Dynamic(points, straight), points, straight)) << around;
    }
}

TEST(Wires, may_have_all_points_in_one_place)
{
  Points crowd, line, wall, disc;
  for (const Point& p : random_points(150))
    crowd.emplace_back(0.01 * p.x(), 0.01 * p.y(), 0.01 * p.z());
  for (int i = 0; i < 40; ++i)
    line.emplace_back(0.25, 0.5, i / 64.0);
  for (int i = 0; i < 64; ++i)
    wall.emplace_back(0.3, i / 8 / 8.0, i % 8 / 8.0);
  for (const Point& p : random_points(150))
    disc.emplace_back(0.3, p.y(), p.z());
  for (const Points& points : {crowd, line, wall, disc})
    for (const Cell& cell : {straight, tilted})
      ASSERT_NO_FATAL_FAILURE(expect_exact(Dynamic(points, cell), points, cell));
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

// The finite cells of CGAL's triangulation of many images that have a vertex in the middle.
std::set<std::array<Site, 4>> expected_cells(const Points& points, const Cell& cell, int around)
{
  using Base = CGAL::Triangulation_vertex_base_with_info_3<Site, Kernel>;
  using Data = CGAL::Triangulation_data_structure_3<Base>;
  CGAL::Delaunay_triangulation_3<Kernel, Data> dt;
  for (std::size_t id = 0; id < points.size(); ++id)
    for (int i = -around; i <= around; ++i) {
      std::array<double, 3> x{points[id].x(), points[id].y(), points[id].z()};
      for (std::size_t n = 0; n < 3; ++n)
        x[n] += i * cell.a()[n];
      dt.insert(Point(x[0], x[1], x[2]))->info() = {id, {i, 0, 0}};
    }
  std::set<std::array<Site, 4>> cells;
  for (auto c = dt.finite_cells_begin(); c != dt.finite_cells_end(); ++c) {
    std::array<Site, 4> sites;
    for (int i = 0; i < 4; ++i)
      sites[std::size_t(i)] = c->vertex(i)->info();
    if (periodic_space_oracle::normalize(sites) == Shift())
      cells.insert(sites);
  }
  return cells;
}

TEST(Wires, have_the_cells_that_CGAL_finds_among_images)
{
  const Cell exact(Coordinates{0.25, 1.5, 0.5}); // images are not rounded
  for (const std::size_t number : {3u, 5u, 12u, 40u, 200u}) {
    Points points; // without ties
    for (const Point& p : random_points(number, 1, number))
      points.emplace_back(std::floor(0x1p40 * p.x()) / 0x1p40, std::floor(0x1p40 * p.y()) / 0x1p40,
                          std::floor(0x1p40 * p.z()) / 0x1p40);
    EXPECT_EQ(cells_of(Dynamic(points, exact)), expected_cells(points, exact, 4)) << number;
  }
}

// MOTION ------------------------------------------------------------------------------------------

TEST(Motion_in_wires, is_followed_at_any_step)
{
  std::mt19937_64 random(3);
  std::normal_distribution<double> normal;
  for (const std::size_t number : {1u, 2u, 3u, 4u, 10u, 200u})
    for (const double step : {1e-4, 0.01, 0.03, 0.1, 0.3}) {
      Points points = random_points(number);
      Dynamic dt(points, straight);
      for (int frame = 0; frame < 4; ++frame) {
        for (Point& p : points) {
          const double s = step / std::cbrt(double(number)), x = p.x() + s * normal(random);
          const double y = p.y() + s * normal(random), z = p.z() + s * normal(random);
          p = Point(x - std::floor(x), y, z);
        }
        dt.update(points);
        ASSERT_NO_FATAL_FAILURE(expect_exact(dt, points, straight)) << step;
      }
    }
}

// Rebuilds in so many frames of Brownian motion in a round pipe, from whose wall points bounce.
std::size_t rebuilds_of(std::size_t number, double step, int frames)
{
  std::mt19937_64 random(1);
  std::normal_distribution<double> normal;
  Points points;
  for (const Point& p : random_points(2 * number))
    if (const double y = 2 * p.y() - 1, z = 2 * p.z() - 1;
        y * y + z * z < 1 && points.size() < number)
      points.emplace_back(3 * p.x(), y, z);
  const Cell cell(Coordinates{3, 0, 0});
  Dynamic dt(points, cell);
  const double s = step * std::cbrt(9.42 / double(number));
  std::size_t rebuilds = 0;
  for (int frame = 0; frame < frames; ++frame) {
    for (Point& p : points) {
      const double x = p.x() + s * normal(random), y = p.y() + s * normal(random);
      const double z = p.z() + s * normal(random), r = std::hypot(y, z);
      const double factor = r > 1 ? (2 - r) / r : 1;
      p = Point(x, factor * y, factor * z);
    }
    rebuilds += dt.update(points).rebuilt();
  }
  expect_exact(dt, points, cell);
  return rebuilds;
}

TEST(Motion_in_wires, is_mended_where_other_points_come_to_the_hull)
{
  EXPECT_LE(rebuilds_of(1000, 0.001, 60), 1u);
  EXPECT_LE(rebuilds_of(1000, 0.01, 60), 3u);
  EXPECT_LE(rebuilds_of(1000, 0.05, 20), 5u);
}

TEST(Motion_in_wires, may_take_a_point_past_all_others)
{
  Points points = random_points(60);
  Dynamic dt(points, straight);
  for (int frame = 0; frame < 200; ++frame) {
    points[0] = Point(0.5, 0.45, -1.5 + 0.02 * frame);
    dt.update(points);
    if (frame % 20 == 0) {
      ASSERT_NO_FATAL_FAILURE(expect_exact(dt, points, straight));
    }
  }
}

TEST(Motion_in_wires, may_drift_for_ever)
{
  Points points = points_in(tilted, 60);
  Dynamic dt(points, tilted);
  for (int frame = 0; frame < 50; ++frame) {
    int id = 0;
    for (Point& p : points) {
      ++id;
      p = p + Kernel::Vector_3(0.4, id % 2 == 0 ? 0.03 : -0.03, id * 1e-3);
    }
    ASSERT_TRUE(dt.update(points).certified);
  }
  ASSERT_NO_FATAL_FAILURE(expect_exact(dt, points, tilted));
}

TEST(Motion_in_wires, costs_nothing_where_points_are_only_wrapped)
{
  const Points points = points_in(tilted, 300);
  Dynamic dt(points, tilted);
  Points wrapped; // rounded, so that a few cells may change
  for (const Point& p : points)
    wrapped.push_back(p + 2 * Kernel::Vector_3(0.5, -0.9, 0.7));
  const auto report = dt.update(wrapped);
  EXPECT_FALSE(report.rebuilt());
  EXPECT_LT(report.flips, 8u);
  ASSERT_NO_FATAL_FAILURE(expect_exact(dt, wrapped, tilted));
}

TEST(Motion_in_wires, may_begin_and_end_in_flat_walls)
{
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> way(-0.03, 0.03);
  for (const int width : {1, 2, 4}) {
    const Cell cell(Coordinates{5, 0, 0});
    const Points at_rest = lattice(5, width, 3);
    Dynamic dt(at_rest, cell);
    for (int frame = 0; frame < 6; ++frame) {
      Points shaken = at_rest;
      for (Point& p : shaken)
        p = Point(p.x() + way(random), p.y() + (frame < 3 ? way(random) : 0), p.z() + way(random));
      dt.update(shaken);
      ASSERT_NO_FATAL_FAILURE(expect_exact(dt, shaken, cell)) << width;
      if (frame % 2 == 1) {
        dt.update(at_rest);
        ASSERT_NO_FATAL_FAILURE(expect_exact(dt, at_rest, cell)) << width;
      }
    }
  }
}

TEST(Motion_in_wires, may_press_all_points_into_a_plane_and_a_line)
{
  Points points = random_points(80);
  Dynamic dt(points, straight);
  for (const bool is_plane : {true, false})
    for (int frame = 0; frame <= 10; ++frame) {
      for (Point& p : points)
        p = Point(p.x(), (is_plane ? 1 : 1 - 0.1 * frame) * p.y(),
                  (is_plane ? 1 - 0.1 * frame : 1) * p.z());
      dt.update(points);
      ASSERT_NO_FATAL_FAILURE(expect_exact(dt, points, straight)) << frame;
    }
  EXPECT_EQ(dt.number_of_cells(), 0u);
  points[5] = Point(points[5].x(), 1e-9, points[5].y());
  points[6] = Point(points[5].x(), 0, 1e-9);
  dt.update(points);
  EXPECT_GT(dt.number_of_cells(), 0u);
  ASSERT_NO_FATAL_FAILURE(expect_exact(dt, points, straight));
}

// Its hull sweeps over the line that was its axis.
TEST(Motion_in_wires, may_turn_a_wire_inside_out)
{
  const Points start = random_points(12, 1, 5);
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

// CELLS THAT CHANGE -------------------------------------------------------------------------------

TEST(Cells_of_wires, may_turn_in_space_and_be_mirrored_and_stretched)
{
  const Points points = random_points(100);
  Dynamic dt(points, straight);
  std::size_t rebuilds = 0;
  for (int frame = 1; frame <= 60; ++frame) {
    const double angle = 0.01 * frame, c = std::cos(angle), s = std::sin(angle);
    const double stretch = 1 + 0.01 * frame;
    Points turned;
    for (const Point& p : points)
      turned.emplace_back(stretch * c * p.x() - s * p.z(), p.y(), stretch * s * p.x() + c * p.z());
    const double sign = frame % 10 == 9 ? -1 : 1;
    const Cell cell(Coordinates{sign * stretch * c, 0, sign * stretch * s});
    rebuilds += dt.update(turned, cell).rebuilt();
    if (frame % 5 == 4) {
      ASSERT_NO_FATAL_FAILURE(expect_exact(dt, turned, cell)) << frame;
    }
  }
  EXPECT_LT(rebuilds, 30u);
  dt.update(points, upright);
  ASSERT_NO_FATAL_FAILURE(expect_exact(dt, points, upright));
}

TEST(Cells_of_wires, may_not_take_the_place_of_other_cells)
{
  const Points points = random_points(30);
  const Cell slab_cell(Coordinates{1, 0, 0}, Coordinates{0, 1, 0});
  Dynamic wire(points, straight), slab(points, slab_cell), torus(points, Cell(1, 1, 1));
  const auto before = cells_of(wire), before_in_slab = cells_of(slab);
  EXPECT_THROW(wire.update(points, Cell(1, 1, 1)), CGAL::Periodic_cell_error_3);
  EXPECT_THROW(wire.update(points, slab_cell), CGAL::Periodic_cell_error_3);
  EXPECT_THROW(slab.update(points, straight), CGAL::Periodic_cell_error_3);
  EXPECT_THROW(torus.update(points, straight), CGAL::Periodic_cell_error_3);
  EXPECT_EQ(cells_of(wire), before);
  EXPECT_EQ(cells_of(slab), before_in_slab);
  ASSERT_NO_FATAL_FAILURE(expect_exact(wire, points, straight));
}

// POINTS COME AND GO ------------------------------------------------------------------------------

TEST(Points_in_wires, come_and_go_one_by_one)
{
  for (const bool are_on_walls : {false, true}) {
    std::map<std::size_t, Point> points;
    Dynamic dt(tilted);
    std::size_t n = 0;
    for (Point p : points_in(tilted, 120)) {
      if (are_on_walls)
        p = Point(p.x(), p.y(), n++ % 2 == 0 ? 0.5 : 1);
      points.emplace(dt.insert(p), p);
      if (points.size() < 12 || points.size() % 30 == 0) {
        ASSERT_NO_FATAL_FAILURE(periodic_space_oracle::expect_exact(dt, points, tilted));
      }
    }
    while (!points.empty()) {
      dt.remove(points.begin()->first);
      points.erase(points.begin());
      if (points.size() < 12 || points.size() % 30 == 0) {
        ASSERT_NO_FATAL_FAILURE(periodic_space_oracle::expect_exact(dt, points, tilted));
      }
    }
  }
}

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

TEST(Points_in_wires, move_alone)
{
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> way(-0.05, 0.05);
  Points points = random_points(100, 0.6);
  Dynamic dt(points, straight);
  for (int i = 0; i < 200; ++i) {
    Point& p = points[std::size_t(i) % 100];
    p = Point(p.x() + way(random), p.y() + way(random), p.z() + way(random));
    dt.move(std::size_t(i) % 100, p);
    if (i % 20 == 0) {
      ASSERT_NO_FATAL_FAILURE(expect_exact(dt, points, straight));
    }
  }
}

TEST(Points_in_wires, share_a_vertex_where_images_coincide)
{
  Points points;
  for (const Point& p : random_points(60))
    points.emplace_back(std::floor(8 * p.x()) / 8, std::floor(4 * p.y()) / 4,
                        std::floor(4 * p.z()) / 4);
  const Points first = points;
  for (const Point& p : first)
    points.emplace_back(p.x() - 3, p.y(), p.z());
  Dynamic dt(points, straight);
  ASSERT_NO_FATAL_FAILURE(expect_exact(dt, points, straight));
  EXPECT_LE(dt.number_of_vertices(), 60u);
  points[61] = points[61] + Kernel::Vector_3(1, 0, 0);
  points[62] = points[62] + Kernel::Vector_3(0, 0, 1);
  dt.update(points);
  ASSERT_NO_FATAL_FAILURE(expect_exact(dt, points, straight));
}

// RANDOM PROGRAMS ---------------------------------------------------------------------------------

using Program = periodic_space_operations::Program<Dynamic>;

std::size_t programs()
{
  const char* const text = std::getenv("PERIODIC_SPACE_PROGRAMS");
  return text == nullptr ? 24 : std::size_t(std::atoi(text));
}

TEST(Random_programs_in_wires, are_exact_after_each_operation)
{
  const std::size_t numbers[] = {0, 1, 3, 8, 20, 60, 150};
  const double grids[] = {0, 0, 0, 0.25, 0.125};
  const Cell cells[] = {straight, tilted, upright, oblique};
  for (std::size_t seed = 0; seed < programs(); ++seed) {
    periodic_space_operations::Setting setting;
    setting.grid = grids[seed % 5];
    setting.cell = cells[seed % 4];
    Program program(std::mt19937_64(seed), setting);
    program.insert(numbers[seed % 7]);
    for (int i = 0; i < 12; ++i) {
      program.do_something();
      ASSERT_NO_FATAL_FAILURE(program.expect_exact()) << seed << ' ' << i;
      ASSERT_NO_FATAL_FAILURE(program.expect_as_fresh());
      ASSERT_FALSE(testing::Test::HasFailure()) << seed << ' ' << i;
    }
  }
}

TEST(Random_programs_in_wires, lead_to_the_only_triangulation_from_any_other_one)
{
  const std::size_t numbers[] = {1, 2, 4, 9, 30, 90};
  const double grids[] = {0, 0.25, 0, 0.5, 0.125};
  const double scales[] = {1, 1, 0x1p-160, 1, 0x1p160};
  const Cell cells[] = {straight, tilted, Cell(Coordinates{0, 0.03, 0}),
                        Cell(Coordinates{20, 1, 0})};
  for (std::size_t seed = 0; seed < programs(); ++seed) {
    periodic_space_operations::Setting setting;
    setting.grid = grids[seed % 5];
    setting.scale = scales[seed / 2 % 5];
    setting.cell = cells[seed % 4];
    setting.far = seed % 7 == 0 ? 10'000 : 2;
    setting.meetings = seed % 3 == 0 ? 2 : 12;
    setting.deforms = seed % 5 < 2;
    Program program(std::mt19937_64(1000 + seed), setting);
    if (seed % 4 == 3)
      program.insert_crystal(1 + seed / 4 % 3, seed / 8 % 3);
    else
      program.insert(numbers[seed % 6]);
    for (int i = 0; i < 12; ++i) {
      program.do_something();
      ASSERT_NO_FATAL_FAILURE(program.expect_as_fresh()) << seed << ' ' << i;
      ASSERT_FALSE(testing::Test::HasFailure()) << seed << ' ' << i;
    }
  }
}

} // namespace test_periodic_space_wire_3

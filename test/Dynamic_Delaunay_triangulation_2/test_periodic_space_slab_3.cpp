// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Triangulations of points in slabs: space that is periodic along two vectors and open across them.

#include "periodic_space_operations.h"
#include "periodic_space_oracle.h"
#include "periodic_space_tested.h"

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Dynamic_periodic_Delaunay_triangulation_2.h>
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
#include <tuple>
#include <utility>
#include <vector>

namespace test_periodic_space_slab_3 {

using namespace periodic_space_tested;

const Cell square(Coordinates{1, 0, 0}, Coordinates{0, 1, 0});
const Cell oblong(Coordinates{0, 0.4, 0}, Coordinates{3, 0.1, 0});
const Cell oblique(Coordinates{1, 0, 0}, Coordinates{7.3, 0.9, 0});
const Cell tilted(Coordinates{1, 0.1, 0.2}, Coordinates{0.5, -0.9, 0.7});
const Cell upright(Coordinates{0, 0, -1}, Coordinates{0.3, 0, 1.2});

Points random_points(std::size_t number, double thickness = 1, std::uint64_t seed = 7)
{
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> coordinate(0, 1);
  Points points;
  for (std::size_t i = 0; i < number; ++i) {
    const double x = coordinate(random), y = coordinate(random);
    points.emplace_back(x, y, thickness * coordinate(random));
  }
  return points;
}

// In the layer along a slab's vectors, from 0 to `thickness` across them.
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

Points cubic_lattice(int side, int layers)
{
  Points points;
  for (int x = 0; x < side; ++x)
    for (int y = 0; y < side; ++y)
      for (int z = 0; z < layers; ++z)
        points.emplace_back(x, y, z);
  return points;
}

// CELLS -------------------------------------------------------------------------------------------

TEST(Cells_of_slabs, have_two_vectors)
{
  EXPECT_TRUE(square.is_slab());
  EXPECT_EQ(square.dimension(), 2);
  EXPECT_EQ(square.c(), (Coordinates{0, 0, 1}));
  EXPECT_EQ(square.volume(), std::numeric_limits<double>::infinity());
  EXPECT_FALSE(Cell(1, 1, 1).is_slab());
  EXPECT_EQ(Cell(1, 1, 1).dimension(), 3);
  EXPECT_NE(square, Cell(1, 1, 1));
  EXPECT_EQ(square, Cell(Kernel::Vector_3(1, 0, 0), Kernel::Vector_3(0, 1, 0)));
  for (const double scale : {1e-200, 1e-60, 1e60, 1e200}) {
    const Cell cell(Coordinates{0, scale, 0}, Coordinates{scale, 0, 0});
    EXPECT_EQ(cell.c(), (Coordinates{0, 0, -1}));
  }
}

TEST(Cells_of_slabs, have_vectors_that_are_finite_and_not_parallel)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(Cell(Coordinates{1, 2, 3}, Coordinates{2, 4, 6}), CGAL::Periodic_cell_error_3);
  EXPECT_THROW(Cell(Coordinates{1, 2, 3}, Coordinates{0, 0, 0}), CGAL::Periodic_cell_error_3);
  EXPECT_THROW(Cell(Coordinates{1, nan, 3}, Coordinates{0, 0, 1}), CGAL::Periodic_cell_error_3);
  EXPECT_THROW(Dynamic(Cell(Coordinates{1, 0, 0}, Coordinates{1, 1e-15, 0})),
               CGAL::Periodic_cell_error_3);
  try {
    const Cell cell(Coordinates{1, 0, 0}, Coordinates{2, 0, 0});
    FAIL();
  } catch (const CGAL::Periodic_cell_error_3& error) {
    EXPECT_STREQ(
        error.what(),
        "a slab has the vectors (1, 0, 0) and (2, 0, 0): its vectors must not be parallel");
    EXPECT_EQ(error.b(), (Coordinates{2, 0, 0}));
  }
}

// CREATION ----------------------------------------------------------------------------------------

TEST(Slabs, may_have_any_number_of_points_in_any_cell)
{
  for (const Cell& cell : {square, oblong, oblique, tilted, upright})
    for (const std::size_t number : {0u, 1u, 2u, 3u, 4u, 5u, 8u, 20u, 101u, 300u}) {
      const Points points = random_points(number);
      ASSERT_NO_FATAL_FAILURE(expect_exact(Dynamic(points, cell), points, cell)) << number;
    }
}

TEST(Slabs, may_be_empty)
{
  Dynamic dt(square);
  for (int n = 0; n < 2; ++n) {
    EXPECT_TRUE(dt.certify());
    EXPECT_TRUE(dt.is_valid(true));
    EXPECT_EQ(dt.number_of_cells(), 0u);
    EXPECT_EQ(dt.number_of_facets(), 0u);
    EXPECT_EQ(dt.number_of_edges(), 0u);
    EXPECT_TRUE(dt.update(Points(), oblong).certified);
    dt.remove(dt.insert(Point(0.5, 0.5, 0.5)));
    dt.update(Points(1, Point(0, 0, 0)), square);
    EXPECT_TRUE(dt.certify());
    dt = Dynamic(tilted);
  }
}

TEST(Slabs, may_be_thin_or_thick)
{
  for (const double thickness : {1e-12, 1e-5, 0.01, 30.0, 1e5, 1e9})
    for (const std::size_t number : {2u, 7u, 60u}) {
      const Points points = points_in(tilted, number, thickness);
      ASSERT_NO_FATAL_FAILURE(expect_exact(Dynamic(points, tilted), points, tilted)) << thickness;
    }
}

TEST(Slabs, may_be_of_any_scale_and_far_away)
{
  for (const double scale : {1e-40, 1e-9, 1e12, 1e40}) {
    const Cell cell(Coordinates{scale, 0, 0}, Coordinates{0.3 * scale, 2 * scale, 0.1 * scale});
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

TEST(Slabs, may_have_flat_walls)
{
  for (const int side : {1, 2, 3, 6})
    for (const int layers : {1, 2, 3}) {
      const Cell cell(Coordinates{double(side), 0, 0}, Coordinates{0, double(side), 0});
      const Points points = cubic_lattice(side, layers);
      ASSERT_NO_FATAL_FAILURE(expect_exact(Dynamic(points, cell), points, cell)) << side;
    }
  Points channel = random_points(100);
  for (const Point& p : random_points(100, 1, 8))
    channel.emplace_back(p.x(), p.y(), p.z() < 0.5 ? -0.2 : 1.3);
  ASSERT_NO_FATAL_FAILURE(expect_exact(Dynamic(channel, square), channel, square));
}

TEST(Slabs, may_have_all_points_in_one_place)
{
  Points crowd, line, wall;
  for (const Point& p : random_points(150))
    crowd.emplace_back(0.01 * p.x(), 0.01 * p.y(), 0.01 * p.z());
  for (int i = 0; i < 40; ++i)
    line.emplace_back(0.5, 0.5, i / 64.0);
  for (int i = 0; i < 64; ++i)
    wall.emplace_back(i / 8 / 8.0, 0, i % 8 / 8.0);
  for (const Points& points : {crowd, line, wall})
    ASSERT_NO_FATAL_FAILURE(expect_exact(Dynamic(points, square), points, square));
}

// The finite cells of CGAL's triangulation of many images, of those that are near to the middle and
// have no vertex near to the border.
std::set<std::array<Site, 4>> expected_cells(const Points& points, const Cell& cell, int around)
{
  using Base = CGAL::Triangulation_vertex_base_with_info_3<Site, Kernel>;
  using Data = CGAL::Triangulation_data_structure_3<Base>;
  CGAL::Delaunay_triangulation_3<Kernel, Data> dt;
  for (std::size_t id = 0; id < points.size(); ++id)
    for (int i = -around; i <= around; ++i)
      for (int j = -around; j <= around; ++j) {
        std::array<double, 3> x{points[id].x(), points[id].y(), points[id].z()};
        for (std::size_t n = 0; n < 3; ++n)
          x[n] += i * cell.a()[n] + j * cell.b()[n];
        dt.insert(Point(x[0], x[1], x[2]))->info() = {id, {i, j, 0}};
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

TEST(Slabs, have_the_cells_that_CGAL_finds_among_images)
{
  const Cell exact(Coordinates{1, 0, 0}, Coordinates{0.25, 1.5, 0.5}); // images are not rounded
  for (const std::size_t number : {2u, 5u, 12u, 40u}) {
    Points points; // without ties
    for (const Point& p : random_points(number, 1, number))
      points.emplace_back(std::floor(0x1p40 * p.x()) / 0x1p40, std::floor(0x1p40 * p.y()) / 0x1p40,
                          std::floor(0x1p40 * p.z()) / 0x1p40);
    std::set<std::array<Site, 4>> expected = expected_cells(points, exact, 8);
    const std::set<std::array<Site, 4>> found = cells_of(Dynamic(points, exact));
    EXPECT_FALSE(found.empty());
    for (const auto& sites : found)
      EXPECT_EQ(expected.count(sites), 1u) << number;
  }
}

// Whether the spheres of all cells are empty of all images around, by exact fractions.
void expect_empty_spheres(const Dynamic& dt, const Points& points, const Cell& cell, int around)
{
  const std::map<std::size_t, Point> ids = by_id(points);
  const periodic_space_oracle::Oracle<Point> oracle(ids, cell);
  for (const auto& sites : cells_of(dt)) {
    std::array<periodic_space_oracle::Exact_point, 4> p;
    for (std::size_t i = 0; i < 4; ++i)
      p[i] = oracle.position(sites[i]);
    if (CGAL::orientation(p[0], p[1], p[2], p[3]) == CGAL::NEGATIVE)
      std::swap(p[0], p[1]);
    for (std::size_t id = 0; id < points.size(); ++id)
      for (int i = -around; i <= around; ++i)
        for (int j = -around; j <= around; ++j)
          ASSERT_NE(CGAL::side_of_oriented_sphere(p[0], p[1], p[2], p[3],
                                                  oracle.position({id, {i, j, 0}})),
                    CGAL::ON_POSITIVE_SIDE);
  }
}

TEST(Slabs, have_cells_with_empty_spheres)
{
  for (const Cell& cell : {square, oblong, tilted})
    for (const std::size_t number : {1u, 2u, 3u, 9u}) {
      const Points points = random_points(number, 1, 3 + number);
      ASSERT_NO_FATAL_FAILURE(expect_empty_spheres(Dynamic(points, cell), points, cell, 5));
    }
}

// Edges in the plane and in a plane of a slab, from smaller ids to larger ones.
using Flat_edge = std::tuple<std::size_t, std::size_t, int, int>;

Flat_edge flat_edge(std::size_t i, std::size_t j, int a, int b)
{
  return i < j || (i == j && std::pair(a, b) > std::pair(0, 0)) ? Flat_edge(i, j, a, b)
                                                                : Flat_edge(j, i, -a, -b);
}

std::set<Flat_edge> flat_edges(const Dynamic& dt)
{
  std::set<Flat_edge> edges;
  dt.for_each_edge([&](std::size_t i, std::size_t j, const Shift& shift) {
    EXPECT_EQ(shift[2], 0);
    EXPECT_TRUE(edges.insert(flat_edge(i, j, shift[0], shift[1])).second);
  });
  return edges;
}

template <class Dynamic_2>
std::set<Flat_edge> edges_in_plane(const Dynamic_2& dt)
{
  std::set<Flat_edge> edges;
  dt.for_each_edge([&](std::size_t i, std::size_t j, const CGAL::Periodic_shift_2& shift) {
    edges.insert(flat_edge(i, j, shift[0], shift[1]));
  });
  return edges;
}

TEST(Slabs, may_have_all_points_in_a_plane_where_they_are_triangulated_as_there)
{
  using Dynamic_2 = CGAL::Dynamic_periodic_Delaunay_triangulation_2<Kernel>;
  std::mt19937_64 random(5);
  std::normal_distribution<double> normal;
  for (const std::size_t number : {1u, 2u, 3u, 10u, 200u}) {
    const Cell cell(Coordinates{1, 0, 0}, Coordinates{0.25, 0.75, 0});
    Points points = random_points(number, 0);
    std::vector<Kernel::Point_2> flat;
    const auto flatten = [&] {
      flat.clear();
      for (Point& p : points) {
        p = Point(p.x(), p.y(), 0.3);
        flat.emplace_back(p.x(), p.y());
      }
    };
    flatten();
    Dynamic dt(points, cell);
    Dynamic_2 in_plane(flat, CGAL::Periodic_cell_2(1, 0, 0.25, 0.75));
    for (int frame = 0; frame < 6; ++frame) {
      EXPECT_EQ(dt.number_of_cells(), 0u);
      EXPECT_EQ(flat_edges(dt), edges_in_plane(in_plane)) << number << ' ' << frame;
      ASSERT_NO_FATAL_FAILURE(expect_exact(dt, points, cell));
      for (Point& p : points)
        p = Point(p.x() + 0.02 * frame * normal(random), p.y() + 0.02 * normal(random), 0.3);
      flatten();
      dt.update(points);
      in_plane.update(flat);
    }
  }
}

// MOTION ------------------------------------------------------------------------------------------

TEST(Motion_in_slabs, is_followed_at_any_step)
{
  std::mt19937_64 random(3);
  std::normal_distribution<double> normal;
  for (const std::size_t number : {1u, 2u, 3u, 10u, 200u})
    for (const double step : {1e-4, 0.01, 0.03, 0.1, 0.3}) {
      Points points = random_points(number);
      Dynamic dt(points, square);
      for (int frame = 0; frame < 4; ++frame) {
        for (Point& p : points) {
          const double s = step / std::cbrt(double(number)), x = p.x() + s * normal(random);
          const double y = p.y() + s * normal(random), z = p.z() + s * normal(random);
          p = Point(x - std::floor(x), y - std::floor(y), z);
        }
        dt.update(points);
        ASSERT_NO_FATAL_FAILURE(expect_exact(dt, points, square)) << step;
      }
    }
}

// Rebuilds in so many frames of Brownian motion between two walls.
std::size_t rebuilds_of(std::size_t number, double step, int frames)
{
  std::mt19937_64 random(1);
  std::normal_distribution<double> normal;
  Points points = random_points(number);
  Dynamic dt(points, square);
  const double s = step / std::cbrt(double(number));
  std::size_t rebuilds = 0;
  for (int frame = 0; frame < frames; ++frame) {
    for (Point& p : points) {
      const double x = p.x() + s * normal(random), y = p.y() + s * normal(random);
      const double z = std::abs(p.z() + s * normal(random));
      p = Point(x, y, z > 1 ? 2 - z : z);
    }
    rebuilds += dt.update(points).rebuilt();
  }
  expect_exact(dt, points, square);
  return rebuilds;
}

TEST(Motion_in_slabs, is_mended_where_the_topmost_point_becomes_another_one)
{
  EXPECT_LE(rebuilds_of(1000, 0.001, 60), 1u);
  EXPECT_LE(rebuilds_of(1000, 0.01, 60), 2u);
  EXPECT_LE(rebuilds_of(1000, 0.05, 20), 2u);
}

TEST(Motion_in_slabs, may_take_a_point_past_all_others)
{
  Points points = random_points(60);
  Dynamic dt(points, oblong);
  std::size_t rebuilds = 0;
  for (int frame = 0; frame < 200; ++frame) {
    points[0] = Point(0.5, 0.5, -1.5 + 0.02 * frame);
    rebuilds += dt.update(points).rebuilt();
    if (frame % 20 == 0) {
      ASSERT_NO_FATAL_FAILURE(expect_exact(dt, points, oblong));
    }
  }
  EXPECT_LT(rebuilds, 4u);
}

TEST(Motion_in_slabs, may_drift_for_ever)
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

TEST(Motion_in_slabs, costs_nothing_where_points_are_only_wrapped)
{
  const Points points = points_in(tilted, 300);
  Dynamic dt(points, tilted);
  Points wrapped; // rounded, so that a few cells may change
  for (const Point& p : points)
    wrapped.push_back(p + 2 * Kernel::Vector_3(1, 0.1, 0.2));
  const auto report = dt.update(wrapped);
  EXPECT_FALSE(report.rebuilt());
  EXPECT_LT(report.flips, 8u);
  ASSERT_NO_FATAL_FAILURE(expect_exact(dt, wrapped, tilted));
}

TEST(Motion_in_slabs, may_begin_and_end_in_flat_walls)
{
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> way(-0.03, 0.03);
  for (const int layers : {1, 2, 4}) {
    const Cell cell(Coordinates{6, 0, 0}, Coordinates{0, 6, 0});
    const Points lattice = cubic_lattice(6, layers);
    Dynamic dt(lattice, cell);
    for (int frame = 0; frame < 6; ++frame) {
      Points shaken = lattice;
      for (Point& p : shaken)
        p = Point(p.x() + way(random), p.y() + way(random), p.z() + (frame < 3 ? way(random) : 0));
      dt.update(shaken);
      ASSERT_NO_FATAL_FAILURE(expect_exact(dt, shaken, cell)) << layers;
      if (frame % 2 == 1) {
        dt.update(lattice);
        ASSERT_NO_FATAL_FAILURE(expect_exact(dt, lattice, cell)) << layers;
      }
    }
  }
}

// As a piston does: the others follow no more than they are pushed.
TEST(Motion_in_slabs, may_press_all_points_into_a_plane)
{
  Points points = random_points(80);
  Dynamic dt(points, square);
  for (int frame = 0; frame <= 10; ++frame) {
    for (std::size_t i = 0; i < points.size(); ++i)
      points[i] = Point(points[i].x(), points[i].y(), (1 - 0.1 * frame) * points[i].z());
    dt.update(points);
    ASSERT_NO_FATAL_FAILURE(expect_exact(dt, points, square)) << frame;
  }
  EXPECT_EQ(dt.number_of_cells(), 0u);
  points[5] = Point(points[5].x(), points[5].y(), 1e-9);
  dt.update(points);
  ASSERT_NO_FATAL_FAILURE(expect_exact(dt, points, square));
}

// CELLS THAT CHANGE -------------------------------------------------------------------------------

TEST(Cells_of_slabs, may_shear_and_be_flipped)
{
  const Points points = random_points(300);
  Dynamic dt(points, square);
  std::size_t rebuilds = 0;
  for (int frame = 1; frame <= 60; ++frame) {
    double strain = 0.02 * frame;
    Points sheared;
    for (const Point& p : points)
      sheared.emplace_back(p.x() + strain * p.y(), p.y(), p.z());
    if (strain > 0.5)
      strain -= 1;
    const Cell cell(Coordinates{1, 0, 0}, Coordinates{strain, 1, 0});
    rebuilds += dt.update(sheared, cell).rebuilt();
    if (frame % 10 == 0 || frame == 25 || frame == 26) {
      ASSERT_NO_FATAL_FAILURE(expect_exact(dt, sheared, cell)) << frame;
    }
  }
  EXPECT_LT(rebuilds, 4u);
}

TEST(Cells_of_slabs, may_turn_in_space_and_be_mirrored)
{
  const Points points = random_points(100);
  Dynamic dt(points, square);
  for (int frame = 1; frame <= 40; ++frame) {
    const double c = std::cos(0.2 * frame), s = std::sin(0.2 * frame);
    Points turned;
    for (const Point& p : points)
      turned.emplace_back(c * p.x() - s * p.z(), p.y(), s * p.x() + c * p.z());
    const Coordinates a{c, 0, s}, b{0, 1, 0};
    const Cell cell = frame % 3 == 0 ? Cell(b, a) : Cell(a, b);
    dt.update(turned, cell);
    if (frame % 4 == 0) {
      ASSERT_NO_FATAL_FAILURE(expect_exact(dt, turned, cell)) << frame;
    }
  }
}

TEST(Cells_of_slabs, may_not_take_the_place_of_other_cells)
{
  const Points points = random_points(30);
  Dynamic slab(points, square), torus(points, Cell(1, 1, 1));
  const auto before = cells_of(slab), before_in_torus = cells_of(torus);
  EXPECT_THROW(slab.update(points, Cell(1, 1, 1)), CGAL::Periodic_cell_error_3);
  EXPECT_THROW(torus.update(points, square), CGAL::Periodic_cell_error_3);
  EXPECT_THROW(slab.update(points, Cell(Coordinates{1, 0, 0}, Coordinates{0, 1e-300, 0})),
               CGAL::Periodic_cell_error_3);
  EXPECT_EQ(cells_of(slab), before);
  EXPECT_EQ(cells_of(torus), before_in_torus);
  ASSERT_NO_FATAL_FAILURE(expect_exact(slab, points, square));
}

// POINTS COME AND GO ------------------------------------------------------------------------------

TEST(Points_in_slabs, come_and_go_one_by_one)
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

TEST(Points_in_slabs, move_alone)
{
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> way(-0.05, 0.05);
  Points points = random_points(100, 0.3);
  Dynamic dt(points, square);
  for (int i = 0; i < 200; ++i) {
    Point& p = points[std::size_t(i) % 100];
    p = Point(p.x() + way(random), p.y() + way(random), p.z() + way(random));
    dt.move(std::size_t(i) % 100, p);
    if (i % 20 == 0) {
      ASSERT_NO_FATAL_FAILURE(expect_exact(dt, points, square));
    }
  }
  const std::size_t top =
      std::size_t(std::max_element(points.begin(), points.end(),
                                   [](const Point& p, const Point& q) { return p.z() < q.z(); }) -
                  points.begin());
  for (int i = 0; i < 20; ++i) {
    points[top] = points[top] + Kernel::Vector_3(0.01, 0.003, 0.02);
    EXPECT_FALSE(dt.move(top, points[top]).rebuilt());
  }
  ASSERT_NO_FATAL_FAILURE(expect_exact(dt, points, square));
}

TEST(Points_in_slabs, share_a_vertex_where_images_coincide)
{
  Points points;
  for (const Point& p : random_points(60))
    points.emplace_back(std::floor(8 * p.x()) / 8, std::floor(8 * p.y()) / 8,
                        std::floor(4 * p.z()) / 4);
  const Points first = points;
  for (const Point& p : first)
    points.emplace_back(p.x() + 1, p.y() - 3, p.z());
  Dynamic dt(points, square);
  ASSERT_NO_FATAL_FAILURE(expect_exact(dt, points, square));
  EXPECT_LE(dt.number_of_vertices(), 60u);
  points[61] = points[61] + Kernel::Vector_3(0, 1, 0);
  points[62] = points[62] + Kernel::Vector_3(0, 0, 1);
  dt.update(points);
  ASSERT_NO_FATAL_FAILURE(expect_exact(dt, points, square));
}

// RANDOM PROGRAMS ---------------------------------------------------------------------------------

using Program = periodic_space_operations::Program<Dynamic>;

std::size_t programs()
{
  const char* const text = std::getenv("PERIODIC_SPACE_PROGRAMS");
  return text == nullptr ? 24 : std::size_t(std::atoi(text));
}

// Found by `./dev bench space_robustness --family periodic_slab_few --trial 6493717390823460196`:
// flips that gave cells other images of the same vertices were taken back, and a vertex kept a
// corner of a cell that was not there any more.
TEST(Random_programs_in_slabs, take_flips_back_that_exchange_images_of_a_vertex)
{
  constexpr std::uint64_t seed = 6493717390823460196u;
  periodic_space_operations::Setting setting;
  setting.cell = Cell({1, 0.1, 0.2}, {0.5, -0.9, 0.1});
  Program program(std::mt19937_64(seed), setting);
  program.insert(seed % 6);
  for (int i = 0; i < 12; ++i) {
    if (program.points().empty())
      program.insert(1);
    program.do_something();
    program.expect_as_fresh();
  }
}

TEST(Random_programs_in_slabs, are_exact_after_each_operation)
{
  const std::size_t numbers[] = {0, 1, 3, 8, 20, 60, 150};
  const double grids[] = {0, 0, 0, 0.25, 0.125};
  const Cell cells[] = {square, square, tilted, oblong, upright, square};
  for (std::size_t seed = 0; seed < programs(); ++seed) {
    periodic_space_operations::Setting setting;
    setting.grid = grids[seed % 5];
    setting.cell = cells[seed % 6];
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

} // namespace test_periodic_space_slab_3

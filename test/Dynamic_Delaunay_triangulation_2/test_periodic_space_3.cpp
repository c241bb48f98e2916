// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Triangulations of points in periodic space of three dimensions.

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
#include <iterator>
#include <limits>
#include <map>
#include <random>
#include <set>
#include <utility>
#include <vector>

namespace test_periodic_space_3 {

using namespace periodic_space_tested;

Points random_points(std::size_t number, double extent = 1, std::uint64_t seed = 7)
{
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> coordinate(0, extent);
  Points points;
  for (std::size_t i = 0; i < number; ++i) {
    const double x = coordinate(random), y = coordinate(random), z = coordinate(random);
    points.emplace_back(x, y, z);
  }
  return points;
}

Points cubic_lattice(int side)
{
  Points points;
  for (int x = 0; x < side; ++x)
    for (int y = 0; y < side; ++y)
      for (int z = 0; z < side; ++z)
        points.emplace_back(x, y, z);
  return points;
}

Points face_centered_lattice(int side)
{
  Points points;
  for (const Point& p : cubic_lattice(2 * side))
    if (int(p.x() + p.y() + p.z()) % 2 == 0)
      points.push_back(p);
  return points;
}

const Cell unit(1, 1, 1), box(3, 1, 0.5);
const Cell triclinic(Coordinates{1, 0.1, 0.2}, Coordinates{0.5, -0.9, 0.1},
                     Coordinates{7.3, 0.2, 1.1});
const Cell mirrored(Coordinates{0, 1, 0}, Coordinates{1, 0, 0}, Coordinates{0.2, 0.3, 0.8});

// CREATION ----------------------------------------------------------------------------------------

TEST(Periodic_space, may_have_any_number_of_points_in_any_cell)
{
  for (const Cell& cell : {unit, box, triclinic, mirrored})
    for (const std::size_t number : {0u, 1u, 2u, 3u, 4u, 5u, 8u, 20u, 101u, 300u}) {
      const Points points = random_points(number, 5);
      ASSERT_NO_FATAL_FAILURE(expect_exact(Dynamic(points, cell), points, cell)) << number;
    }
}

TEST(Periodic_space, may_be_empty)
{
  Dynamic dt(Cell(1, 1, 1));
  for (int n = 0; n < 2; ++n) {
    EXPECT_TRUE(dt.certify());
    EXPECT_TRUE(dt.is_certified());
    EXPECT_TRUE(dt.is_valid(true));
    EXPECT_EQ(dt.number_of_cells(), 0u);
    EXPECT_TRUE(dt.update(std::vector<Point>(), Cell(2, 1, 1)).certified);
    dt.remove(dt.insert(Point(0.5, 0.5, 0.5)));
    dt.update(std::vector<Point>(1, Point(0, 0, 0)), Cell(1, 1, 1));
    EXPECT_TRUE(dt.certify());
    dt = Dynamic(Cell(1, 2, 1));
  }
}

TEST(Periodic_space, may_be_filled_by_a_lattice)
{
  for (const int side : {1, 2, 3, 5}) {
    const Cell cubic(side, side, side), face_centered(2 * side, 2 * side, 2 * side);
    const Points points = cubic_lattice(side), others = face_centered_lattice(side);
    ASSERT_NO_FATAL_FAILURE(expect_exact(Dynamic(points, cubic), points, cubic)) << side;
    ASSERT_NO_FATAL_FAILURE(expect_exact(Dynamic(others, face_centered), others, face_centered));
  }
}

TEST(Periodic_space, may_have_all_points_in_one_place)
{
  Points crowd, line, plane;
  for (const Point& p : random_points(150))
    crowd.emplace_back(0.01 * p.x(), 0.01 * p.y(), 0.01 * p.z());
  for (int i = 0; i < 40; ++i)
    line.emplace_back(i / 64.0, 0.5, 0.5);
  for (int i = 0; i < 64; ++i)
    plane.emplace_back(i / 8 / 8.0, i % 8 / 8.0, 0);
  for (const Points& points : {crowd, line, plane})
    ASSERT_NO_FATAL_FAILURE(expect_exact(Dynamic(points, unit), points, unit));
}

// The finite cells of CGAL's triangulation of many images, of those that are near to the middle.
std::set<std::array<Site, 4>> expected_cells(const Points& points, const Cell& cell, int around)
{
  using Base = CGAL::Triangulation_vertex_base_with_info_3<Site, Kernel>;
  using Data = CGAL::Triangulation_data_structure_3<Base>;
  CGAL::Delaunay_triangulation_3<Kernel, Data> dt;
  for (std::size_t id = 0; id < points.size(); ++id)
    for (int i = -around; i <= around; ++i)
      for (int j = -around; j <= around; ++j)
        for (int k = -around; k <= around; ++k) {
          std::array<double, 3> x{points[id].x(), points[id].y(), points[id].z()};
          for (std::size_t n = 0; n < 3; ++n)
            x[n] += i * cell.a()[n] + j * cell.b()[n] + k * cell.c()[n];
          dt.insert(Point(x[0], x[1], x[2]))->info() = {id, {i, j, k}};
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

TEST(Periodic_space, has_the_cells_that_CGAL_finds_among_images)
{
  for (const Cell& cell : {unit, box, mirrored})
    for (const std::size_t number : {2u, 5u, 12u}) {
      Points points; // in the cell, so that images around it are enough; no ties
      for (const Point& p : random_points(number, 1, number))
        points.emplace_back(p.x() * cell.a()[0] + p.y() * cell.b()[0] + p.z() * cell.c()[0],
                            p.x() * cell.a()[1] + p.y() * cell.b()[1] + p.z() * cell.c()[1],
                            p.x() * cell.a()[2] + p.y() * cell.b()[2] + p.z() * cell.c()[2]);
      EXPECT_EQ(cells_of(Dynamic(points, cell)), expected_cells(points, cell, 4)) << number;
    }
}

TEST(Periodic_space, may_be_of_any_scale_and_far_away)
{
  for (const double scale : {1e-40, 1e-9, 1e12, 1e40}) {
    const Cell cell(Coordinates{scale, 0, 0}, Coordinates{0.3 * scale, 2 * scale, 0},
                    Coordinates{0, 0.1 * scale, 0.7 * scale});
    Points points = random_points(40, scale);
    Dynamic dt(points, cell);
    ASSERT_NO_FATAL_FAILURE(expect_exact(dt, points, cell)) << scale;
    for (Point& p : points)
      p = Point(p.x() + 3e5 * scale, p.y(), p.z() - 1e5 * scale);
    dt.update(points);
    ASSERT_NO_FATAL_FAILURE(expect_exact(dt, points, cell)) << scale;
  }
}

TEST(Periodic_space, may_have_a_long_and_thin_cell)
{
  const Cell sheared(Coordinates{1, 0, 0}, Coordinates{50.3, 1, 0}, Coordinates{-20.1, 30.7, 1});
  const Cell long_one(1, 1, 30), flat(1, 1, 0.02);
  for (const Cell& cell : {sheared, long_one, flat})
    for (const std::size_t number : {1u, 3u, 40u}) {
      const Points points = random_points(number, 2);
      ASSERT_NO_FATAL_FAILURE(expect_exact(Dynamic(points, cell), points, cell)) << number;
    }
}

// What floating point proves of images that are nearly coplanar or cospherical is true.
TEST(Predicates_in_periodic_space, are_right_where_a_filter_answers)
{
  using namespace CGAL::Dynamic_Delaunay_triangulations_3::internal;
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> coordinate(-1, 1);
  std::uniform_int_distribution<int> multiple(-3, 3);
  std::size_t answers = 0;
  for (int i = 0; i < 20000; ++i) {
    const Cell& cell = i % 2 == 0 ? triclinic : mirrored;
    const Torus_3 torus(cell);
    const double far = std::ldexp(1.0, i % 20), noise = std::ldexp(1.0, -(i / 20 % 60));
    double largest = 0, sum = 0;
    std::array<Torus_place_3, 5> places;
    std::array<Torus_point_3, 5> points;
    for (std::size_t n = 0; n < 5; ++n) {
      // nearly on the unit sphere, and seldom nearly in a plane
      double x = coordinate(random), y = coordinate(random);
      double z = i % 3 == 0 ? 0.5 : coordinate(random);
      const double length = std::sqrt(x * x + y * y + z * z) * (1 + noise * coordinate(random));
      x /= length, y /= length, z /= length;
      const Multiples_3 m{int(far) * multiple(random), multiple(random), multiple(random)};
      const auto way = torus.combination(m);
      places[n] = Torus_place_3({x - way.x, y - way.y, z - way.z}, m, torus);
      for (const double value : {way.x, way.y, way.z})
        largest = (std::max)(largest, 1 + std::abs(value));
      sum = (std::max)(sum, double(std::abs(m[0])) + std::abs(m[1]) + std::abs(m[2]));
    }
    const double squared_error = torus.squared_error(largest, sum);
    const Torus_predicates_3 predicates(torus, squared_error);
    for (std::size_t n = 0; n < 5; ++n)
      points[n] = Torus_point_3(places[n].base, places[n].multiples, places[n].position);
    const auto& [p, q, r, s, t] = points;
    if (const int sign =
            predicates.filtered_orientation(p.rounded, q.rounded, r.rounded, s.rounded)) {
      ++answers;
      ASSERT_EQ(sign, predicates.exact_orientation(p, q, r, s));
    }
    if (const int sign = predicates.filtered_side_of_sphere(p.rounded, q.rounded, r.rounded,
                                                            s.rounded, t.rounded)) {
      ++answers;
      ASSERT_EQ(sign, predicates.exact_side_of_sphere(p, q, r, s, t));
    }
  }
  EXPECT_GT(answers, 10000u);
}

// MOTION ------------------------------------------------------------------------------------------

TEST(Motion_in_periodic_space, is_followed_at_any_step)
{
  std::mt19937_64 random(3);
  std::normal_distribution<double> normal;
  for (const double step : {1e-4, 0.01, 0.03, 0.1, 0.3}) {
    Points points = random_points(200);
    Dynamic dt(points, unit);
    for (int frame = 0; frame < 3; ++frame) {
      for (Point& p : points) {
        const double s = step / std::cbrt(200.0), x = p.x() + s * normal(random);
        const double y = p.y() + s * normal(random), z = p.z() + s * normal(random);
        p = Point(x - std::floor(x), y - std::floor(y), z - std::floor(z));
      }
      dt.update(points);
      ASSERT_NO_FATAL_FAILURE(expect_exact(dt, points, unit)) << step;
    }
  }
}

TEST(Motion_in_periodic_space, costs_nothing_where_points_are_only_wrapped)
{
  const Points points = random_points(500);
  Dynamic dt(points, triclinic);
  const auto before = cells_of(dt);
  Points wrapped; // rounded, so that a few cells may change
  for (const Point& p : points)
    wrapped.push_back(p + 2 * Kernel::Vector_3(1, 0.1, 0.2));
  EXPECT_LT(dt.update(wrapped).flips, 5u);
  ASSERT_NO_FATAL_FAILURE(expect_exact(dt, wrapped, triclinic));
  dt.update(points);
  EXPECT_EQ(cells_of(dt), before);
}

TEST(Motion_in_periodic_space, may_drift_for_ever)
{
  Points points = random_points(60);
  Dynamic dt(points, unit);
  for (int frame = 0; frame < 50; ++frame) {
    int id = 0;
    for (Point& p : points) {
      ++id;
      p = p + Kernel::Vector_3(0.4, id % 2 == 0 ? 0.03 : -0.03, id * 1e-3);
    }
    ASSERT_TRUE(dt.update(points).certified);
  }
  ASSERT_NO_FATAL_FAILURE(expect_exact(dt, points, unit));
}

// Shifts inside of the package have multiples below 2^9.
TEST(Motion_in_periodic_space, may_go_round_hundreds_of_times_while_others_rest)
{
  Points points = random_points(40);
  Dynamic dt(points, unit);
  for (int step = 0; step < 14000; ++step) { // 700 cells
    points[7] = points[7] + Kernel::Vector_3(0.05, 0, 0);
    ASSERT_FALSE(dt.move(7, points[7]).rebuilt());
  }
  ASSERT_NO_FATAL_FAILURE(expect_exact(dt, points, unit));
}

TEST(Cells_in_periodic_space, may_shear_and_be_flipped)
{
  Points points = random_points(300);
  Dynamic dt(points, unit);
  std::size_t rebuilds = 0;
  for (int frame = 1; frame <= 60; ++frame) {
    double strain = 0.02 * frame;
    Points sheared;
    for (const Point& p : points)
      sheared.emplace_back(p.x() + strain * p.y(), p.y(), p.z());
    if (strain > 0.5)
      strain -= 1;
    const Cell cell(Coordinates{1, 0, 0}, Coordinates{strain, 1, 0}, Coordinates{0, 0, 1});
    rebuilds += dt.update(sheared, cell).rebuilt();
    if (frame % 10 == 0 || frame == 25 || frame == 26) {
      ASSERT_NO_FATAL_FAILURE(expect_exact(dt, sheared, cell)) << frame;
    }
  }
  EXPECT_LT(rebuilds, 3u);
}

// POINTS COME AND GO ------------------------------------------------------------------------------

TEST(Points_in_periodic_space, come_and_go_one_by_one)
{
  std::map<std::size_t, Point> points;
  Dynamic dt(mirrored);
  for (const Point& p : random_points(150)) {
    points.emplace(dt.insert(p), p);
    if (points.size() < 12 || points.size() % 30 == 0) {
      ASSERT_NO_FATAL_FAILURE(periodic_space_oracle::expect_exact(dt, points, mirrored));
    }
  }
  while (!points.empty()) {
    dt.remove(points.begin()->first);
    points.erase(points.begin());
    if (points.size() < 12 || points.size() % 30 == 0) {
      ASSERT_NO_FATAL_FAILURE(periodic_space_oracle::expect_exact(dt, points, mirrored));
    }
  }
}

TEST(Points_in_periodic_space, share_a_vertex_where_images_coincide)
{
  Points points = random_points(60);
  for (Point& p : points)
    p = Point(std::floor(16 * p.x()) / 16, std::floor(16 * p.y()) / 16,
              std::floor(16 * p.z()) / 16);
  const Points first = points;
  for (const Point& p : first)
    points.emplace_back(p.x() + 1, p.y() - 3, p.z() + 2);
  Dynamic dt(points, unit);
  ASSERT_NO_FATAL_FAILURE(expect_exact(dt, points, unit));
  EXPECT_LE(dt.number_of_vertices(), 60u);
  for (std::size_t id = 60; id < 63; ++id)
    points[id] = points[id] + Kernel::Vector_3(1e-3, 0, 0);
  dt.update(points);
  ASSERT_NO_FATAL_FAILURE(expect_exact(dt, points, unit));
  points[61] = points[3] + Kernel::Vector_3(0, 1, 0);
  dt.update(points);
  ASSERT_NO_FATAL_FAILURE(expect_exact(dt, points, unit));
  dt.remove(3);
  std::map<std::size_t, Point> left = by_id(points);
  left.erase(3);
  ASSERT_NO_FATAL_FAILURE(periodic_space_oracle::expect_exact(dt, left, unit));
}

// RANDOM PROGRAMS ---------------------------------------------------------------------------------

using Program = periodic_space_operations::Program<Dynamic>;

std::size_t programs()
{
  const char* const text = std::getenv("PERIODIC_SPACE_PROGRAMS");
  return text == nullptr ? 24 : std::size_t(std::atoi(text));
}

TEST(Random_programs_in_periodic_space, are_exact_after_each_operation)
{
  const std::size_t numbers[] = {0, 1, 3, 8, 20, 60, 150};
  const double grids[] = {0, 0, 0, 0.25, 0.125};
  for (std::size_t seed = 0; seed < programs(); ++seed) {
    periodic_space_operations::Setting setting;
    setting.grid = grids[seed % 5];
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

// REFUSALS ----------------------------------------------------------------------------------------

TEST(Refusals_in_periodic_space, change_nothing)
{
  const Points points = random_points(30);
  Dynamic dt(points, unit);
  const auto before = cells_of(dt);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  Points bad = points;
  bad[7] = Point(0, nan, 0);
  EXPECT_THROW(dt.update(bad), CGAL::Non_finite_coordinate_error_3);
  bad[7] = Point(0, 3e6, 0);
  EXPECT_THROW(dt.update(bad), CGAL::Periodic_range_error_3);
  EXPECT_THROW(dt.insert(bad[7]), CGAL::Periodic_range_error_3);
  EXPECT_THROW(dt.move(3, bad[7]), CGAL::Periodic_range_error_3);
  EXPECT_THROW(dt.update(points.begin(), points.end() - 1), CGAL::Point_count_error_2);
  EXPECT_THROW(dt.remove(30), CGAL::Unknown_id_error_2);
  EXPECT_THROW(dt.remove({3, 3}), CGAL::Repeated_id_error_2);
  EXPECT_THROW(dt.update(points, Cell(1, 1, 1e-300)), CGAL::Periodic_cell_error_3);
  EXPECT_THROW(Cell(1, 0, 1), CGAL::Periodic_cell_error_3);
  EXPECT_THROW(Cell(1, nan, 1), CGAL::Periodic_cell_error_3);
  EXPECT_EQ(cells_of(dt), before);
  ASSERT_NO_FATAL_FAILURE(expect_exact(dt, points, unit));
}

TEST(Copies_in_periodic_space, go_their_own_ways)
{
  const Points points = random_points(80), others = random_points(80, 1, 8);
  Dynamic dt(points, unit);
  Dynamic copy(dt);
  copy.update(others);
  ASSERT_NO_FATAL_FAILURE(expect_exact(dt, points, unit));
  ASSERT_NO_FATAL_FAILURE(expect_exact(copy, others, unit));
  dt = std::move(copy);
  ASSERT_NO_FATAL_FAILURE(expect_exact(dt, others, unit));
}

} // namespace test_periodic_space_3

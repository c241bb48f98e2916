// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Points that move, come and go in tori, slabs and wires in space, and cells that change.

#include "periodic_space_operations.h"
#include "periodic_space_oracle.h"
#include "periodic_space_tested.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <limits>
#include <map>
#include <random>
#include <utility>

namespace test_periodic_space_motion_3 {

using namespace periodic_space_tested;

// MOTION ------------------------------------------------------------------------------------------

using Motion_in_periodic_space = Of_kind;
INSTANTIATE_TEST_SUITE_P(kinds, Motion_in_periodic_space, all_kinds(), name_of);

TEST_P(Motion_in_periodic_space, is_followed_at_any_step)
{
  std::mt19937_64 random(3);
  std::normal_distribution<double> normal;
  const auto wrapped = [this](double x, std::size_t axis) {
    return axis < dimension ? x - std::floor(x) : x;
  };
  for (const std::size_t number : {1u, 2u, 3u, 4u, 10u, 200u})
    for (const double step : {1e-4, 0.01, 0.03, 0.1, 0.3}) {
      Points points = points_of_cube(number);
      Dynamic dt(points, unit);
      for (int frame = 0; frame < 4; ++frame) {
        for (Point& p : points) {
          const double s = step / std::cbrt(double(number)), x = p.x() + s * normal(random);
          const double y = p.y() + s * normal(random), z = p.z() + s * normal(random);
          p = Point(wrapped(x, 0), wrapped(y, 1), wrapped(z, 2));
        }
        dt.update(points);
        ASSERT_NO_FATAL_FAILURE(expect_exact(dt, points, unit)) << step;
      }
    }
}

TEST_P(Motion_in_periodic_space, costs_nothing_where_points_are_only_wrapped)
{
  const Points points = points_in(tilted, 500);
  Dynamic dt(points, tilted);
  const auto before = cells_of(dt);
  Points wrapped; // rounded, so that a few cells may change
  for (const Point& p : points)
    wrapped.push_back(image(p, {2, 0, 0}, tilted));
  const auto report = dt.update(wrapped);
  EXPECT_FALSE(report.rebuilt());
  EXPECT_LT(report.flips, 8u);
  ASSERT_NO_FATAL_FAILURE(expect_exact(dt, wrapped, tilted));
  dt.update(points);
  EXPECT_EQ(cells_of(dt), before);
}

TEST_P(Motion_in_periodic_space, may_drift_for_ever)
{
  for (const Cell& cell : {unit, tilted}) {
    Points points = points_in(cell, 60);
    Dynamic dt(points, cell);
    for (int frame = 0; frame < 50; ++frame) {
      int id = 0;
      for (Point& p : points) {
        ++id;
        p = p + Vector(0.4, id % 2 == 0 ? 0.03 : -0.03, id * 1e-3);
      }
      ASSERT_TRUE(dt.update(points).certified);
    }
    ASSERT_NO_FATAL_FAILURE(expect_exact(dt, points, cell));
  }
}

// Shifts inside of the package have multiples below 2^9.
TEST_P(Motion_in_periodic_space, may_go_round_hundreds_of_times_while_others_rest)
{
  Points points = points_of_cube(40);
  Dynamic dt(points, unit);
  for (int step = 0; step < 14000; ++step) { // 700 cells
    points[7] = points[7] + Vector(0.05, 0, 0);
    ASSERT_FALSE(dt.move(7, points[7]).rebuilt());
  }
  ASSERT_NO_FATAL_FAILURE(expect_exact(dt, points, unit));
}

TEST_P(Motion_in_periodic_space, may_begin_and_end_in_a_lattice)
{
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> way(-0.03, 0.03);
  for (const int layers : {1, 2, 4}) {
    std::array<int, 3> sides{5, dimension == 1 ? 3 : 6, dimension == 1 ? 3 : 6};
    const std::size_t axis = (std::min)(dimension, std::size_t(2)); // along which layers rest later
    sides[axis] = layers;
    const Cell cell = kind.box(sides[0], sides[1], sides[2]);
    const Points at_rest = box_lattice(sides[0], sides[1], sides[2]);
    Dynamic dt(at_rest, cell);
    for (int frame = 0; frame < 6; ++frame) {
      Points moved;
      for (const Point& p : at_rest) {
        Coordinates x{p.x(), p.y(), p.z()};
        for (std::size_t k = 0; k < 3; ++k)
          x[k] += k != axis || frame < 3 ? way(random) : 0;
        moved.emplace_back(x[0], x[1], x[2]);
      }
      dt.update(moved);
      ASSERT_NO_FATAL_FAILURE(expect_exact(dt, moved, cell)) << layers;
      if (frame % 2 == 1) {
        dt.update(at_rest);
        ASSERT_NO_FATAL_FAILURE(expect_exact(dt, at_rest, cell)) << layers;
      }
    }
  }
}

// MOTION WHERE SPACE IS OPEN ---------------------------------------------------------------------

using Motion_in_half_open_space = Of_kind;
INSTANTIATE_TEST_SUITE_P(kinds, Motion_in_half_open_space, open_kinds(), name_of);

// Rebuilds in so many frames of Brownian motion between two walls, or in a round pipe: points
// bounce.
std::size_t rebuilds_of(const Kind& kind, std::size_t number, double step, int frames)
{
  std::mt19937_64 random(1);
  std::normal_distribution<double> normal;
  const double share = kind.dimension == 1 ? 1 : 0; // of the second coordinate in the distance
  const Cell cell = kind.box(3, 2, 2);
  Points points;
  for (const Point& p : random_points(2 * number))
    if (const double y = 2 * p.y() - 1, z = 2 * p.z() - 1;
        std::hypot(share * y, z) < 1 && points.size() < number)
      points.emplace_back(3 * p.x(), y, z);
  Dynamic dt(points, cell);
  const double s = step * std::cbrt(10 / double(number));
  std::size_t rebuilds = 0;
  for (int frame = 0; frame < frames; ++frame) {
    for (Point& p : points) {
      const double x = p.x() + s * normal(random), y = p.y() + s * normal(random);
      const double z = p.z() + s * normal(random), r = std::hypot(share * y, z);
      const double factor = r > 1 ? (2 - r) / r : 1;
      p = Point(x, (kind.dimension == 1 ? factor : 1) * y, factor * z);
    }
    rebuilds += dt.update(points).rebuilt();
  }
  expect_exact(dt, points, cell);
  return rebuilds;
}

TEST_P(Motion_in_half_open_space, is_mended_where_other_points_come_to_the_hull)
{
  EXPECT_EQ(rebuilds_of(kind, 1000, 0.001, 60), 0u);
  EXPECT_EQ(rebuilds_of(kind, 1000, 0.01, 60), 0u);
  EXPECT_LE(rebuilds_of(kind, 1000, 0.05, 20), dimension == 2 ? 0u : 1u);
}

// A vertex of the hull of a wire, and of a slab if it is above all others, is a neighbor of its own
// images.
TEST_P(Motion_in_half_open_space, may_take_vertices_of_the_hull_out_and_put_them_back)
{
  for (const Cell& cell : {unit, kind.cells[1]}) {
    const Points points = points_in(cell, 300);
    Dynamic dt(points, cell);
    std::size_t rebuilds = 0;
    for (std::size_t id = 0; id < points.size(); ++id) {
      rebuilds += dt.remove(id).rebuilt();
      if (id % 30 == 0) {
        EXPECT_TRUE(dt.is_valid(true)) << id;
      }
      rebuilds += dt.insert(Points{points[id]}).rebuilt();
    }
    EXPECT_LT(rebuilds, 5u); // of 600
    ASSERT_NO_FATAL_FAILURE(expect_exact(dt, points, cell));
  }
}

// Outside of the hull of a wire, an image of the point is in the way of another one.
TEST_P(Motion_in_half_open_space, may_let_points_jump_a_little_out_of_the_hull)
{
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> share(-0.04, 1.04);
  Points points = points_of_cube(300);
  Dynamic dt(points, unit);
  std::size_t rebuilds = 0;
  for (std::size_t id = 0; id < points.size(); ++id) {
    points[id] = Point(share(random), share(random), share(random));
    rebuilds += dt.move(id, points[id]).rebuilt();
    if (id % 30 == 0) {
      ASSERT_NO_FATAL_FAILURE(expect_exact(dt, points, unit)) << id;
    }
  }
  EXPECT_LT(rebuilds, 3u);
}

TEST_P(Motion_in_half_open_space, may_let_a_point_pass_all_others)
{
  for (const Cell& cell : {unit, kind.cells[1]}) {
    Points points = points_of_cube(60);
    Dynamic dt(points, cell);
    std::size_t rebuilds = 0;
    for (int frame = 0; frame < 200; ++frame) {
      points[0] = Point(0.5, 0.45, -1.5 + 0.02 * frame);
      rebuilds += dt.update(points).rebuilt();
      if (frame % 20 == 0) {
        ASSERT_NO_FATAL_FAILURE(expect_exact(dt, points, cell));
      }
    }
    EXPECT_LT(rebuilds, 2u); // at first it jumps far
  }
}

// As a piston does: the others follow no more than they are pushed.
TEST_P(Motion_in_half_open_space, may_press_all_points_into_a_plane_and_a_line)
{
  Points points = points_of_cube(80);
  Dynamic dt(points, unit);
  for (std::size_t axis = 3; axis-- > dimension;)
    for (int frame = 0; frame <= 10; ++frame) {
      for (Point& p : points) {
        Coordinates x{p.x(), p.y(), p.z()};
        x[axis] *= 1 - 0.1 * frame;
        p = Point(x[0], x[1], x[2]);
      }
      dt.update(points);
      ASSERT_NO_FATAL_FAILURE(expect_exact(dt, points, unit)) << frame;
    }
  EXPECT_EQ(dt.number_of_cells(), 0u);
  points[5] = points[5] + Vector(0, 0, 1e-9);
  points[6] = points[6] + Vector(0, 1e-9, 0);
  dt.update(points);
  EXPECT_GT(dt.number_of_cells(), 0u);
  ASSERT_NO_FATAL_FAILURE(expect_exact(dt, points, unit));
}

// CELLS THAT CHANGE -------------------------------------------------------------------------------

using Cells_in_periodic_space = Of_kind;
INSTANTIATE_TEST_SUITE_P(kinds, Cells_in_periodic_space, all_kinds(), name_of);

TEST_P(Cells_in_periodic_space, may_shear_and_be_flipped)
{
  const Points points = points_of_cube(300);
  Dynamic dt(points, unit);
  std::size_t rebuilds = 0;
  for (int frame = 1; frame <= 60; ++frame) {
    double strain = 0.02 * frame;
    Points sheared;
    for (const Point& p : points)
      sheared.emplace_back(p.x() + strain * p.y(), p.y(), p.z());
    if (strain > 0.5)
      strain -= 1;
    const Cell cell = kind.cell({1, 0, 0}, {strain, 1, 0}, {0, 0, 1});
    rebuilds += dt.update(sheared, cell).rebuilt();
    if (frame % 10 == 0 || frame == 25 || frame == 26) {
      ASSERT_NO_FATAL_FAILURE(expect_exact(dt, sheared, cell)) << frame;
    }
  }
  EXPECT_LT(rebuilds, dimension == 3 ? 3u : 4u);
}

TEST_P(Cells_in_periodic_space, may_turn_in_space_and_be_mirrored_and_stretched)
{
  const Points points = points_of_cube(100);
  for (const double step : {0.01, 0.2}) {
    Dynamic dt(points, unit);
    std::size_t rebuilds = 0;
    for (int frame = 1; frame <= 60; ++frame) {
      const double cosine = std::cos(step * frame), sine = std::sin(step * frame);
      const double stretch = 1 + 0.01 * frame;
      const auto turned = [&](double x, double y, double z) {
        return Coordinates{stretch * cosine * x - sine * z, y, stretch * sine * x + cosine * z};
      };
      Points moved;
      for (const Point& p : points) {
        const Coordinates x = turned(p.x(), p.y(), p.z());
        moved.emplace_back(x[0], x[1], x[2]);
      }
      const bool is_mirrored = frame % (step < 0.1 ? 10 : 3) == 0;
      const Coordinates a = turned(1, 0, 0), b = turned(0, 1, 0), c = turned(0, 0, 1);
      const Cell cell = !is_mirrored     ? kind.cell(a, b, c)
                        : dimension == 1 ? Cell(turned(-1, 0, 0))
                                         : kind.cell(b, a, c);
      rebuilds += dt.update(moved, cell).rebuilt();
      if (frame % 10 == 0 || frame % 10 == 1) { // where mirrored, and back
        ASSERT_NO_FATAL_FAILURE(expect_exact(dt, moved, cell)) << frame;
      }
    }
    if (step < 0.1) {
      EXPECT_LT(rebuilds, 30u);
    }
    dt.update(points, kind.cells.back());
    ASSERT_NO_FATAL_FAILURE(expect_exact(dt, points, kind.cells.back()));
  }
}

TEST_P(Cells_in_periodic_space, may_not_take_the_place_of_other_kinds_of_cells)
{
  const Points points = points_of_cube(30);
  Dynamic dt(points, unit);
  const auto before = cells_of(dt);
  for (const Kind* other : {&torus, &slab, &wire})
    if (other != &kind) {
      EXPECT_THROW(dt.update(points, other->box(1, 1, 1)), CGAL::Periodic_cell_error_3);
    }
  EXPECT_EQ(cells_of(dt), before);
  ASSERT_NO_FATAL_FAILURE(expect_exact(dt, points, unit));
}

// POINTS COME AND GO ------------------------------------------------------------------------------

using Points_in_periodic_space = Of_kind;
INSTANTIATE_TEST_SUITE_P(kinds, Points_in_periodic_space, all_kinds(), name_of);

TEST_P(Points_in_periodic_space, come_and_go_one_by_one)
{
  for (const Cell& cell : {tilted, kind.cells.back()})
    for (const bool are_on_walls : {false, true}) {
      std::map<std::size_t, Point> points;
      Dynamic dt(cell);
      std::size_t n = 0;
      for (Point p : points_in(cell, 120)) {
        if (are_on_walls)
          p = Point(p.x(), p.y(), n++ % 2 == 0 ? 0.5 : 1);
        points.emplace(dt.insert(p), p);
        if (points.size() < 12 || points.size() % 60 == 0) {
          ASSERT_NO_FATAL_FAILURE(periodic_space_oracle::expect_exact(dt, points, cell));
        }
      }
      while (!points.empty()) {
        dt.remove(points.begin()->first);
        points.erase(points.begin());
        if (points.size() < 12 || points.size() % 60 == 0) {
          ASSERT_NO_FATAL_FAILURE(periodic_space_oracle::expect_exact(dt, points, cell));
        }
      }
    }
}

TEST_P(Points_in_periodic_space, move_alone)
{
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> way(-0.05, 0.05);
  for (const double thickness : {0.3, 0.6}) {
    Points points = points_in(unit, 100, thickness);
    Dynamic dt(points, unit);
    for (int i = 0; i < 200; ++i) {
      Point& p = points[std::size_t(i) % 100];
      p = Point(p.x() + way(random), p.y() + way(random), p.z() + way(random));
      dt.move(std::size_t(i) % 100, p);
      if (i % 20 == 0) {
        ASSERT_NO_FATAL_FAILURE(expect_exact(dt, points, unit));
      }
    }
    if (dimension != 2 || thickness > 0.3)
      continue;
    const auto is_lower = [](const Point& p, const Point& q) { return p.z() < q.z(); };
    Point& top = *std::max_element(points.begin(), points.end(), is_lower);
    for (int i = 0; i < 20; ++i) {
      top = top + Vector(0.01, 0.003, 0.02);
      EXPECT_FALSE(dt.move(std::size_t(&top - points.data()), top).rebuilt());
    }
    ASSERT_NO_FATAL_FAILURE(expect_exact(dt, points, unit));
  }
}

TEST_P(Points_in_periodic_space, share_a_vertex_where_images_coincide)
{
  for (const int bits : {2, 3, 4}) {
    Points points;
    for (const Point& p : random_points(60))
      points.push_back(rounded(p, bits));
    for (std::size_t i = 0; i < 60; ++i)
      points.push_back(image(points[i], {1, -3, 2}, unit));
    Dynamic dt(points, unit);
    ASSERT_NO_FATAL_FAILURE(expect_exact(dt, points, unit));
    EXPECT_LE(dt.number_of_vertices(), 60u);
    for (std::size_t id = 60; id < 63; ++id)
      points[id] = points[id] + Vector(1e-3, 0, 0);
    dt.update(points);
    ASSERT_NO_FATAL_FAILURE(expect_exact(dt, points, unit));
    points[61] = image(points[3], {1, 1, 0}, unit);
    points[62] = points[62] + Vector(0, 0, 1);
    dt.update(points);
    ASSERT_NO_FATAL_FAILURE(expect_exact(dt, points, unit));
    dt.remove(3);
    std::map<std::size_t, Point> left = by_id(points);
    left.erase(3);
    ASSERT_NO_FATAL_FAILURE(periodic_space_oracle::expect_exact(dt, left, unit));
  }
}

// RANDOM PROGRAMS ---------------------------------------------------------------------------------

using Program = periodic_space_operations::Program<Dynamic>;
using Random_programs_in_periodic_space = Of_kind;
INSTANTIATE_TEST_SUITE_P(kinds, Random_programs_in_periodic_space, all_kinds(), name_of);

std::size_t programs()
{
  const char* const text = std::getenv("PERIODIC_SPACE_PROGRAMS");
  return text == nullptr ? 16 : std::size_t(std::atoi(text));
}

TEST_P(Random_programs_in_periodic_space, are_exact_after_each_operation)
{
  const std::size_t numbers[] = {0, 1, 3, 8, 20, 60, 150};
  const double grids[] = {0, 0, 0, 0.25, 0.125};
  for (std::size_t seed = 0; seed < programs(); ++seed) {
    periodic_space_operations::Setting setting;
    setting.grid = grids[seed % 5];
    setting.cell = seed % 2 == 0 ? unit : kind.cells[seed / 2 % kind.cells.size()];
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

TEST_P(Random_programs_in_periodic_space, lead_to_the_only_triangulation_from_any_other_one)
{
  const std::size_t numbers[] = {1, 2, 4, 9, 30, 90};
  const double grids[] = {0, 0.25, 0, 0.5, 0.125};
  const double scales[] = {1, 1, 0x1p-160, 1, 0x1p160};
  const double ratio = dimension == 1 ? 30 : 3; // longer tori and slabs take seconds a rebuild
  const Cell cells[] = {unit, tilted, kind.cell({0, 1 / ratio, 0}, {1, 0, 0}, {0, 0, 1}),
                        kind.cell({ratio, 1, 0}, {0, 1, 0}, {0, 0, 1})};
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

// REFUSALS AND COPIES -----------------------------------------------------------------------------

using Refusals_in_periodic_space = Of_kind;
INSTANTIATE_TEST_SUITE_P(kinds, Refusals_in_periodic_space, all_kinds(), name_of);

TEST_P(Refusals_in_periodic_space, change_nothing)
{
  const Points points = points_of_cube(30);
  Dynamic dt(points, unit);
  const auto before = cells_of(dt);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  Points bad = points;
  bad[7] = Point(0, nan, 0);
  EXPECT_THROW(dt.update(bad), CGAL::Non_finite_coordinate_error_3);
  EXPECT_THROW(dt.insert(Point(0, 0, nan)), CGAL::Non_finite_coordinate_error_3);
  for (const double far : {3e6, 1e300}) {
    bad[7] = Point(far, 0, 0);
    EXPECT_THROW(dt.update(bad), CGAL::Periodic_range_error_3);
    EXPECT_THROW(dt.insert(bad[7]), CGAL::Periodic_range_error_3);
    EXPECT_THROW(dt.move(3, bad[7]), CGAL::Periodic_range_error_3);
  }
  EXPECT_THROW(dt.update(points.begin(), points.end() - 1), CGAL::Point_count_error_2);
  EXPECT_THROW(dt.remove(30), CGAL::Unknown_id_error_2);
  EXPECT_THROW(dt.remove({3, 3}), CGAL::Repeated_id_error_2);
  Coordinates sides{1, 1, 1};
  sides[dimension - 1] = 1e-300;
  EXPECT_THROW(dt.update(points, kind.box(sides[0], sides[1], sides[2])),
               CGAL::Periodic_cell_error_3);
  sides[dimension - 1] = 0;
  EXPECT_THROW(kind.box(sides[0], sides[1], sides[2]), CGAL::Periodic_cell_error_3);
  sides[dimension - 1] = nan;
  EXPECT_THROW(kind.box(sides[0], sides[1], sides[2]), CGAL::Periodic_cell_error_3);
  EXPECT_EQ(cells_of(dt), before);
  ASSERT_NO_FATAL_FAILURE(expect_exact(dt, points, unit));
}

using Copies_in_periodic_space = Of_kind;
INSTANTIATE_TEST_SUITE_P(kinds, Copies_in_periodic_space, all_kinds(), name_of);

TEST_P(Copies_in_periodic_space, go_their_own_ways)
{
  const Points points = points_of_cube(80), others = points_of_cube(80, 1, 8);
  Dynamic dt(points, unit);
  Dynamic copy(dt);
  copy.update(others);
  ASSERT_NO_FATAL_FAILURE(expect_exact(dt, points, unit));
  ASSERT_NO_FATAL_FAILURE(expect_exact(copy, others, unit));
  dt = std::move(copy);
  ASSERT_NO_FATAL_FAILURE(expect_exact(dt, others, unit));
}

} // namespace test_periodic_space_motion_3

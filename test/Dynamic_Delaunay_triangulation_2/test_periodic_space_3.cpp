// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Triangulations of points in periodic space of three dimensions: in tori, slabs and wires alike.

#include "periodic_space_oracle.h"
#include "periodic_space_tested.h"

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/property_map.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <random>
#include <set>
#include <utility>
#include <vector>

namespace test_periodic_space_3 {

using namespace periodic_space_tested;
using space_points::lattice;

Points face_centered_lattice(int side)
{
  Points points;
  for (const Point& p : lattice(2 * side))
    if (int(p.x() + p.y() + p.z()) % 2 == 0)
      points.push_back(p);
  return points;
}

// CREATION ----------------------------------------------------------------------------------------

using Periodic_space = Of_kind;
INSTANTIATE_TEST_SUITE_P(kinds, Periodic_space, all_kinds(), name_of);

TEST_P(Periodic_space, may_have_any_number_of_points_in_any_cell)
{
  for (const Cell& cell : kind.cells)
    for (const std::size_t number : {0u, 1u, 2u, 3u, 4u, 5u, 8u, 20u, 101u, 300u}) {
      const Points points = points_of_cube(number, number % 2 == 0 ? 5 : 1);
      ASSERT_NO_FATAL_FAILURE(expect_exact(Dynamic(points, cell), points, cell)) << number;
    }
}

TEST_P(Periodic_space, has_points_that_are_parts_of_any_values)
{
  const Points points = points_of_cube(40, 1), moved = shaken(points, 0.05);
  std::vector<std::pair<Point, int>> particles;
  for (const Point& p : points)
    particles.emplace_back(p, 7);
  const CGAL::First_of_pair_property_map<std::pair<Point, int>> place;
  const Cell &cell = kind.cells[0], &next = kind.cells[1];
  Dynamic dt(particles, place, cell);
  ASSERT_NO_FATAL_FAILURE(expect_exact(dt, points, cell));
  ASSERT_NO_FATAL_FAILURE(
      expect_exact(Dynamic(particles.begin(), particles.end(), place, cell), points, cell));
  for (std::size_t i = 0; i < points.size(); ++i)
    particles[i].first = moved[i];
  dt.update(particles, place);
  ASSERT_NO_FATAL_FAILURE(expect_exact(dt, moved, cell));
  dt.update(particles, place, next);
  ASSERT_NO_FATAL_FAILURE(expect_exact(dt, moved, next));
}

TEST_P(Periodic_space, may_be_empty)
{
  Dynamic dt(unit);
  for (int n = 0; n < 2; ++n) {
    EXPECT_TRUE(dt.certify());
    EXPECT_TRUE(dt.is_certified());
    EXPECT_TRUE(dt.is_valid(true));
    EXPECT_EQ(dt.number_of_cells(), 0u);
    EXPECT_EQ(dt.number_of_facets(), 0u);
    EXPECT_EQ(dt.number_of_edges(), 0u);
    EXPECT_TRUE(dt.update(Points(), kind.cells[1]).certified);
    dt.remove(dt.insert(Point(0.5, 0.5, 0.5)));
    dt.update(Points(1, Point(0, 0, 0)), unit);
    EXPECT_TRUE(dt.certify());
    dt = Dynamic(tilted);
  }
}

TEST_P(Periodic_space, may_be_filled_by_a_lattice)
{
  for (const int length : {1, 2, 5, 6})
    for (const int width : {1, 2, 3, 6})
      for (const int depth : {1, 2, 3}) {
        const Cell cell = kind.box(length, width, depth);
        const Points points = box_lattice(length, width, depth);
        ASSERT_NO_FATAL_FAILURE(expect_exact(Dynamic(points, cell), points, cell)) << length;
      }
  for (const int side : {1, 2, 3, 5}) {
    const Cell cubic = kind.box(side, side, side), doubled = kind.box(2 * side, 2 * side, 2 * side);
    const Points points = lattice(side), others = face_centered_lattice(side);
    ASSERT_NO_FATAL_FAILURE(expect_exact(Dynamic(points, cubic), points, cubic)) << side;
    ASSERT_NO_FATAL_FAILURE(expect_exact(Dynamic(others, doubled), others, doubled)) << side;
  }
}

TEST_P(Periodic_space, may_have_all_points_in_one_place)
{
  std::vector<Points> places{points_of_cube(150, 0.01)};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    Points line, grid, disc;
    const auto add = [axis](Points& points, double along, double x, double y) {
      Coordinates p{along, x, y};
      std::rotate(p.begin(), p.end() - std::ptrdiff_t(axis), p.end());
      points.emplace_back(p[0], p[1], p[2]);
    };
    for (int i = 0; i < 30; ++i)
      add(line, i / 64.0, 0.25, 0.5);
    for (int i = 0; i < 36; ++i)
      add(grid, 0.3, i / 6 / 8.0, i % 6 / 8.0);
    for (const Point& p : random_points(60))
      add(disc, 0.3, p.x(), p.y());
    places.insert(places.end(), {line, grid, disc});
  }
  for (const Points& points : places)
    for (const Cell& cell : {unit, tilted})
      ASSERT_NO_FATAL_FAILURE(expect_exact(Dynamic(points, cell), points, cell));
}

// All shifts of at most so many cells each way along a cell's vectors.
std::vector<Shift> shifts_around(std::size_t dimension, int most)
{
  std::vector<Shift> shifts;
  const int b = dimension > 1 ? most : 0, c = dimension > 2 ? most : 0;
  for (int i = -most; i <= most; ++i)
    for (int j = -b; j <= b; ++j)
      for (int k = -c; k <= c; ++k)
        shifts.push_back({i, j, k});
  return shifts;
}

// The finite cells of CGAL's triangulation of many images, of those that are near to the middle.
std::set<std::array<Site, 4>> expected_cells(const Points& points, const Cell& cell,
                                             const std::vector<Shift>& shifts)
{
  using Base = CGAL::Triangulation_vertex_base_with_info_3<Site, Kernel>;
  using Data = CGAL::Triangulation_data_structure_3<Base>;
  CGAL::Delaunay_triangulation_3<Kernel, Data> dt;
  for (std::size_t id = 0; id < points.size(); ++id)
    for (const Shift& shift : shifts)
      dt.insert(image(points[id], shift, cell))->info() = {id, shift};
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

// Points and cells have few bits, so that images are not rounded, or there are no ties.
TEST_P(Periodic_space, has_the_cells_that_CGAL_finds_among_images)
{
  for (const Cell& cell : {unit, oblique, mirrored, kind.box(3, 1, 0.5)})
    for (const std::size_t number : {2u, 3u, 5u, 12u, 40u, 200u}) {
      if (number > (dimension == 3 ? 12 : dimension == 2 ? 40 : 200))
        continue;
      const Points points = short_points_in(cell, number, 1, unsigned(number));
      const auto found = cells_of(Dynamic(points, cell));
      const auto expected =
          expected_cells(points, cell, shifts_around(dimension, dimension == 2 ? 8 : 4));
      if (dimension == 2) { // where images end, CGAL finds cells that reach over the others
        EXPECT_FALSE(found.empty());
        EXPECT_TRUE(std::includes(expected.begin(), expected.end(), found.begin(), found.end()));
      } else {
        EXPECT_EQ(found, expected) << number;
      }
    }
}

// Whether the spheres of all cells are empty of all images around, by exact fractions.
void expect_empty_spheres(const Dynamic& dt, const Points& points, const Cell& cell,
                          const std::vector<Shift>& shifts)
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
      for (const Shift& shift : shifts)
        ASSERT_NE(
            CGAL::side_of_oriented_sphere(p[0], p[1], p[2], p[3], oracle.position({id, shift})),
            CGAL::ON_POSITIVE_SIDE);
  }
}

TEST_P(Periodic_space, has_cells_with_empty_spheres)
{
  for (const Cell& cell : {unit, kind.cells[1], tilted})
    for (const std::size_t number : {1u, 2u, 3u, 7u}) {
      const Points points = points_of_cube(number, 1, unsigned(3 + number));
      ASSERT_NO_FATAL_FAILURE(expect_empty_spheres(
          Dynamic(points, cell), points, cell, shifts_around(dimension, dimension == 3 ? 2 : 5)));
    }
}

TEST_P(Periodic_space, may_be_of_any_scale_and_far_away)
{
  for (const double scale : {1e-48, 1e-9, 1e12, 1e48}) {
    const Cell cell = kind.cell({0.3 * scale, 2 * scale, 0.1 * scale}, {scale, 0, 0},
                                {0, 0.1 * scale, 0.7 * scale});
    Points points = points_of_cube(40, scale);
    Dynamic dt(points, cell);
    ASSERT_NO_FATAL_FAILURE(expect_exact(dt, points, cell)) << scale;
    for (Point& p : points)
      p = Point(p.x() + 3e5 * scale, p.y(), p.z() - 1e5 * scale);
    dt.update(points);
    ASSERT_NO_FATAL_FAILURE(expect_exact(dt, points, cell)) << scale;
  }
}

TEST_P(Periodic_space, may_have_a_long_and_thin_cell)
{
  const double ratio = dimension == 2 ? 20 : 50;
  for (const Cell& cell : {kind.cell({1, 0, 0}, {50.3, 1, 0}, {-20.1, 30.7, 1}),
                           kind.box(ratio, 1, 1), kind.box(1 / ratio, 1, 1)})
    for (const std::size_t number : {1u, 3u, 40u}) {
      const Points points = points_of_cube(number, 2);
      ASSERT_NO_FATAL_FAILURE(expect_exact(Dynamic(points, cell), points, cell)) << number;
    }
}

// WHERE SPACE IS OPEN -----------------------------------------------------------------------------

using Half_open_space = Of_kind;
INSTANTIATE_TEST_SUITE_P(kinds, Half_open_space, open_kinds(), name_of);

TEST_P(Half_open_space, may_be_thin_or_thick)
{
  for (const double thickness : {1e-12, 1e-5, 0.01, 30.0, 1e5, 1e9})
    for (const std::size_t number : {2u, 3u, 7u, 60u}) {
      if (dimension == 1 && thickness > 1e6)
        continue; // a wire may be as thick as it may be long
      const Points points = points_in(tilted, number, thickness);
      ASSERT_NO_FATAL_FAILURE(expect_exact(Dynamic(points, tilted), points, tilted)) << thickness;
    }
}

TEST_P(Half_open_space, may_be_a_channel_with_flat_walls)
{
  Points points = points_of_cube(150);
  for (const Point& p : points_of_cube(150, 1, 8)) {
    const double at = p.z() < 0.5 ? -0.25 : 1.25;
    points.emplace_back(p.x(), p.y(), at);
    if (dimension == 1)
      points.emplace_back(p.x(), at, p.y());
  }
  ASSERT_NO_FATAL_FAILURE(expect_exact(Dynamic(points, unit), points, unit));
}

// PREDICATES --------------------------------------------------------------------------------------

// What floating point proves of images that are nearly coplanar or cospherical is true.
TEST(Predicates_in_periodic_space, are_right_where_a_filter_answers)
{
  using namespace CGAL::Dynamic_Delaunay_triangulations_3::internal;
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> coordinate(-1, 1);
  std::uniform_int_distribution<int> multiple(-3, 3);
  std::size_t answers = 0;
  for (int i = 0; i < 20000; ++i) {
    const Cell& cell = periodic_space_tested::torus.cells[2 + std::size_t(i % 2)];
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

// No vertex of a frame is looked at alone if a box around all tells that none is far out.
TEST(A_box_around_vertices, tells_whether_one_may_be_far_out)
{
  using namespace CGAL::Dynamic_Delaunay_triangulations_3::internal;
  std::mt19937_64 random(12);
  std::uniform_real_distribution<double> fraction(-1.2, 2.2), side(0, 1);
  std::size_t near = 0;
  for (int i = 0; i < 20000; ++i) {
    const Torus_3 torus(periodic_space_tested::torus.cells[std::size_t(i % 4)]);
    const auto point = [&](auto& share) {
      const double x = share(random), y = share(random);
      return torus.combination(
          CGAL::Dynamic_Delaunay_triangulations_3::Position_3{x, y, share(random)});
    };
    const auto low = point(fraction), way = point(side);
    const auto high = low + CGAL::Dynamic_Delaunay_triangulations_3::Position_3{
                                std::abs(way.x), std::abs(way.y), std::abs(way.z)};
    bool is_one_far_out = false;
    for (const double x : {low.x, high.x})
      for (const double y : {low.y, high.y})
        for (const double z : {low.z, high.z})
          is_one_far_out = is_one_far_out || torus.is_far_out({x, y, z});
    near += !torus.may_be_far_out(low, high);
    ASSERT_LE(is_one_far_out, torus.may_be_far_out(low, high));
  }
  EXPECT_GT(near, 2000u);
}

} // namespace test_periodic_space_3

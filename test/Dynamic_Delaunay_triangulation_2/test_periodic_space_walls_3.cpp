// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Points on the flat walls of slabs and wires in space: what a filter says of cells with points at
// infinity, and how points slide along walls, and leave them.

#include "periodic_space_operations.h"
#include "periodic_space_oracle.h"
#include "periodic_space_tested.h"

#include <CGAL/Dynamic_periodic_Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <set>
#include <utility>
#include <vector>

namespace test_periodic_space_walls_3 {

using namespace periodic_space_tested;
using namespace CGAL::Dynamic_Delaunay_triangulations_3::internal;
using CGAL::Dynamic_Delaunay_triangulations_2::Index;
using CGAL::Dynamic_Delaunay_triangulations_2::Vertex_index;
using CGAL::Dynamic_Delaunay_triangulations_3::Position_3;

const Cell square(Coordinates{1, 0, 0}, Coordinates{0, 1, 0});
const Cell oblique(Coordinates{1, 0.25, 1}, Coordinates{0.25, 1.5, 0.25}); // in the plane x = z
const Cell skew(Coordinates{1, 0.3, -0.2}, Coordinates{0.1, 0.9, 0.7});
const Cell straight(Coordinates{1, 0, 0});
const Cell tilted(Coordinates{0.5, -0.9, 0.7});

// THE FILTER --------------------------------------------------------------------------------------

// Images in a cell, off by noise from where they are given.
class Images
{
public:
  Images(const Cell& cell, double far, std::mt19937_64& random)
    : torus(cell)
    , m_far(int(far))
    , m_random(random)
  {
  }

  // Given at another image than where it is.
  void add(double x, double y, double z)
  {
    std::uniform_int_distribution<int> multiple(-3, 3);
    const Multiples_3 m{m_far * multiple(m_random), torus.is_wire() ? 0 : multiple(m_random), 0};
    const Position_3 way = torus.combination(m);
    const Torus_place_3 place({x - way.x, y - way.y, z - way.z}, m, torus);
    m_measures.include(place.base, place.position, place.multiples);
    m_points.emplace_back(place.base, place.multiples, place.position);
  }
  void add_infinity(int end)
  {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    m_points.emplace_back(Position_3{0, 0, 0}, Multiples_3{0, 0, 8 * end},
                          Position_3{nan, nan, nan});
  }
  void exchange(std::size_t i, std::size_t j) { std::swap(m_points[i], m_points[j]); }

  const Torus_point_3& operator[](std::size_t i) const { return m_points[i]; }
  double squared_error() const { return torus.squared_error(m_measures.largest(), m_measures.sum); }

  const Torus_3 torus;

private:
  int m_far;
  std::mt19937_64& m_random;
  Torus_measures_3 m_measures;
  std::vector<Torus_point_3> m_points;
};

using Exact_vector = CGAL::Vector_3<periodic_space_oracle::Exact>;

Exact_vector exact(const Position_3& p)
{
  return {p.x, p.y, p.z};
}

// A length squared is that of the sine of the angle between a rounded normal and the exact one.
TEST(Predicates_at_walls, know_by_how_much_a_normal_is_off)
{
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> coordinate(-1, 1);
  const auto vector = [&] {
    return Position_3{coordinate(random), coordinate(random), coordinate(random)};
  };
  std::size_t inexact = 0;
  for (int i = 0; i < 3000; ++i) {
    const double scale = std::ldexp(1.0, i % 80 - 40), angle = std::ldexp(1.0, -(i % 30));
    const double error = i % 2 == 0 ? 0 : std::ldexp(scale, -40);
    const Position_3 v = scale * vector(), w = coordinate(random) * v + scale * angle * vector();
    const Rounded_normal_3 normal = Rounded_normal_3::of(v, w, error);
    const auto off = [&] { return exact(0.5 * error * vector()); };
    const Exact_vector c = CGAL::cross_product(exact(v) + off(), exact(w) + off());
    const Exact_vector n = exact(normal.direction), across = CGAL::cross_product(n, c);
    inexact += across != CGAL::NULL_VECTOR;
    if (normal.error < 0.5) {
      ASSERT_GT(n * c, 0) << i;
    }
    ASSERT_LE(across * across, normal.error * normal.error * (c * c)) << i;
  }
  EXPECT_GT(inexact, 1000u);
  const Rounded_normal_3 none = Rounded_normal_3::of({1, 2, 3}, {2, 4, 6}, 0);
  EXPECT_EQ(none.error, std::numeric_limits<double>::infinity());
}

// The facets stand nearly upright.
TEST(Predicates_at_walls, see_facets_from_infinity_as_exact_numbers_do)
{
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> coordinate(-1, 1);
  std::array<int, 3> signs{};
  for (int i = 0; i < 20000; ++i) {
    const Cell& cell = i % 3 == 0 ? square : i % 3 == 1 ? oblique : skew;
    const double noise = std::ldexp(1.0, -(i / 20 % 60));
    Images images(cell, std::ldexp(1.0, i % 20), random);
    const Position_3 p{coordinate(random), coordinate(random), coordinate(random)};
    const Position_3 along{coordinate(random), coordinate(random), coordinate(random)};
    const Position_3 q = p + along;
    const Position_3 r = p + coordinate(random) * along +
                         coordinate(random) * images.torus.vector(2) +
                         noise * Position_3{coordinate(random), coordinate(random), 0};
    for (const Position_3& x : {p, q, r})
      images.add(x.x, x.y, x.z);
    images.add_infinity(i % 2 == 0 ? 1 : -1);
    images.exchange(3, std::size_t(i) % 4);
    const double squared_error = images.squared_error();
    const Torus_predicates_3 predicates(images.torus, squared_error);
    const int sign = predicates.exact_orientation(images[0], images[1], images[2], images[3]);
    ++signs[std::size_t(sign + 1)];
    ASSERT_EQ(predicates.orientation_in_doubt(images[0], images[1], images[2], images[3]), sign)
        << i;
  }
  EXPECT_GT(signs[0], 5000);
  EXPECT_GT(signs[2], 5000);
}

// Four points in a wall, nearly on a circle; in the plane x = z, in one along coordinates, or only
// nearly in one.
TEST(Predicates_at_walls, tell_sides_of_circles_as_exact_numbers_do)
{
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> coordinate(-1, 1);
  std::array<int, 3> sides{};
  for (int i = 0; i < 20000; ++i) {
    const bool is_wire = i % 2 == 0, is_level = i % 3 == 0;
    const Cell cell = is_wire ? Cell(is_level ? Coordinates{1, 0, 0} : Coordinates{1, 0, 1})
                              : (is_level ? square : oblique);
    const double noise = std::ldexp(1.0, -(i / 20 % 60));
    Images images(cell, std::ldexp(1.0, i % 20), random);
    for (int n = 0; n < 4; ++n) {
      const double angle = 3 * coordinate(random);
      const double radius = 1 + (n == 3 ? noise * coordinate(random) : 0);
      const double x = radius * std::cos(angle), y = radius * std::sin(angle);
      const double out = i % 5 == 0 && n == 3 ? noise * coordinate(random) : 0;
      if (is_level)
        images.add(x, y, 0.3 + out);
      else
        images.add(x / 2, y / std::sqrt(2.0), x / 2 + out);
    }
    images.add_infinity(is_wire || i % 7 != 0 ? 1 : -1);
    images.exchange(3, 4);
    images.exchange(3, std::size_t(i) % 4);
    const double squared_error = images.squared_error();
    const Torus_predicates_3 predicates(images.torus, squared_error);
    const int side =
        predicates.exact_side_of_sphere(images[0], images[1], images[2], images[3], images[4]);
    ++sides[std::size_t(side + 1)];
    ASSERT_EQ(
        predicates.side_of_sphere_in_doubt(images[0], images[1], images[2], images[3], images[4]),
        side)
        << i;
  }
  EXPECT_GT(sides[0], 3000);
  EXPECT_GT(sides[2], 3000);
}

// Images by vectors that leave a plane are at other heights than what they are images of.
TEST(Predicates_at_walls, know_points_with_a_coordinate_in_common)
{
  for (const Cell& cell : {square, oblique, straight, tilted})
    for (const bool are_images : {false, true}) {
      const Torus_3 torus(cell);
      std::vector<Torus_point_3> points;
      for (const int i : {0, 1, 2, 4})
        points.emplace_back(Position_3{0.25 * i, 0.125 * i * i, 0.375},
                            Multiples_3{are_images ? i : 0, 0, 0}, Position_3{0, 0, 0});
      const bool is_along = cell == square || cell == straight;
      EXPECT_EQ(torus.are_level(points[0], points[1], points[2], points[3]),
                is_along || !are_images);
    }
}

// Facets whose planes nearly contain the axis.
TEST(Predicates_at_walls, see_facets_from_the_axis_of_a_wire_as_exact_numbers_do)
{
  using State = Torus_state_3<Kernel, CGAL::Sequential_tag>;
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> coordinate(-1, 1);
  std::array<int, 3> signs{};
  for (int i = 0; i < 20000; ++i) {
    State state(i % 2 == 0 ? straight : tilted);
    const double noise = std::ldexp(1.0, -(i / 20 % 60));
    const Position_3 o{coordinate(random), coordinate(random), coordinate(random)};
    const Position_3 out{coordinate(random), coordinate(random), coordinate(random)};
    state.positions.resize(4);
    for (Vertex_index v(1); v < 4; ++v) {
      const double along = std::ldexp(coordinate(random), i % 8);
      const Position_3 p =
          o + (1 + coordinate(random)) * out + along * state.torus.vector(0) +
          noise * Position_3{coordinate(random), coordinate(random), coordinate(random)};
      state.positions.set(v, Torus_place_3(p));
    }
    state.include_all();
    state.set_origin(o);
    const Wire_signs_3<State> wire_signs(state,
                                         Torus_predicates_3(state.torus, state.squared_error));
    const Torus_shift_3 shift = Torus_shift_3::of({i % 3 - 1, 0, 0});
    const auto site = [](Index v, Torus_shift_3 by = {}) {
      return Torus_site_3{Vertex_index(v), by};
    };
    const Torus_facet_3 f{site(1), site(2, shift), site(3)};
    const int sign = wire_signs.exact(f);
    if (const int filtered = wire_signs.filtered(f)) {
      ++signs[std::size_t(sign + 1)];
      ASSERT_EQ(filtered, sign) << i;
    }
  }
  EXPECT_GT(signs[0], 5000);
  EXPECT_GT(signs[2], 500);
}

// MOTION ------------------------------------------------------------------------------------------

// Random points in a cube that is periodic along some axes; of each of some, one coordinate stays 0
// or 1.
class Walled_points
{
public:
  Walled_points(std::size_t number, std::size_t axes, std::size_t sliding)
    : m_axes(axes)
    , m_sliding(sliding)
  {
    std::uniform_real_distribution<double> share(0, 1);
    for (std::size_t i = 0; i < number; ++i) {
      Coordinates x{share(m_random), share(m_random), share(m_random)};
      if (const std::size_t axis = fixed_axis(i); axis < 3)
        x[axis] = x[axis] < 0.5 ? 0 : 1;
      points.emplace_back(x[0], x[1], x[2]);
    }
  }

  Cell cell() const { return m_axes == 2 ? square : straight; }
  void move(double step)
  {
    std::normal_distribution<double> way(0, step / std::cbrt(3 * double(points.size())));
    for (std::size_t i = 0; i < points.size(); ++i) {
      Coordinates x{points[i].x(), points[i].y(), points[i].z()};
      for (std::size_t axis = 0; axis < 3; ++axis)
        if (axis != fixed_axis(i)) {
          const double y = x[axis] + way(m_random);
          x[axis] = axis < m_axes ? y - std::floor(y) : y < 0 ? -y : y > 1 ? 2 - y : y;
        }
      points[i] = Point(x[0], x[1], x[2]);
    }
  }
  bool is_sliding(std::size_t i) const { return fixed_axis(i) < 3; }

  Points points;

private:
  std::size_t fixed_axis(std::size_t i) const
  {
    return i % 3 >= m_sliding ? 3 : m_axes == 2 || i % 2 == 0 ? 2 : 1;
  }

  std::size_t m_axes, m_sliding; // so many of three points slide
  std::mt19937_64 m_random{1};
};

void expect_as_fresh(const Dynamic& dt, const Points& points, const Cell& cell)
{
  EXPECT_TRUE(dt.is_valid(true));
  EXPECT_EQ(cells_of(dt), cells_of(Dynamic(points, cell)));
}

std::size_t rebuilds_of(Walled_points walled, double step, int frames)
{
  Dynamic dt(walled.points, walled.cell());
  std::size_t rebuilds = 0;
  for (int frame = 0; frame < frames; ++frame) {
    walled.move(step);
    rebuilds += dt.update(walled.points).rebuilt();
    if (frame % 10 == 0)
      expect_as_fresh(dt, walled.points, walled.cell());
  }
  expect_exact(dt, walled.points, walled.cell());
  return rebuilds;
}

TEST(Motion_along_walls, of_slabs_is_mended)
{
  EXPECT_LE(rebuilds_of(Walled_points(1000, 2, 1), 0.01, 60), 0u);
  EXPECT_LE(rebuilds_of(Walled_points(1000, 2, 1), 0.05, 60), 0u);
  EXPECT_LE(rebuilds_of(Walled_points(300, 2, 3), 0.05, 60), 0u);
  EXPECT_LE(rebuilds_of(Walled_points(5000, 2, 1), 0.1, 30), 0u);
}

TEST(Motion_along_walls, of_ducts_is_mended)
{
  EXPECT_LE(rebuilds_of(Walled_points(1000, 1, 1), 0.01, 60), 0u);
  EXPECT_LE(rebuilds_of(Walled_points(1000, 1, 1), 0.05, 60), 1u);
  EXPECT_LE(rebuilds_of(Walled_points(300, 1, 3), 0.05, 60), 6u);
}

TEST(Motion_along_walls, of_a_layer_is_mended)
{
  for (const double step : {0.01, 0.05, 0.1}) {
    Points points = Walled_points(400, 2, 0).points;
    for (Point& p : points)
      p = Point(p.x(), p.y(), 0.25);
    std::mt19937_64 random(3);
    std::normal_distribution<double> way(0, step / 20);
    Dynamic dt(points, square);
    for (int frame = 0; frame < 40; ++frame) {
      for (Point& p : points) {
        const double x = p.x() + way(random), y = p.y() + way(random);
        p = Point(x - std::floor(x), y - std::floor(y), 0.25);
      }
      EXPECT_FALSE(dt.update(points).rebuilt()) << step;
      if (frame % 10 == 0) {
        expect_as_fresh(dt, points, square);
      }
    }
    ASSERT_NO_FATAL_FAILURE(expect_exact(dt, points, square));
  }
}

// POINTS THAT LEAVE WALLS -------------------------------------------------------------------------

// One point in each place of a grid.
Points rounded_to(double grid, const Points& points)
{
  std::set<Point> places;
  for (const Point& p : points) {
    const auto rounded = [grid](double x) { return grid * std::floor(x / grid); };
    places.emplace(rounded(p.x()), rounded(p.y()), rounded(p.z()));
  }
  return {places.begin(), places.end()};
}

// On a grid many are in one circle.
TEST(Points_on_walls, are_taken_out_without_a_rebuild)
{
  for (const double grid : {0x1p-40, 0x1p-4})
    for (const std::size_t axes : {2u, 1u})
      for (const std::size_t sliding : {1u, 3u}) {
        const Walled_points walled(400, axes, sliding);
        const Points points = rounded_to(grid, walled.points);
        Dynamic dt(points, walled.cell());
        Points rest;
        for (std::size_t id = 0; id < points.size(); ++id)
          if (id % 5 == 0) {
            EXPECT_FALSE(dt.remove(id).rebuilt()) << axes << ' ' << sliding << ' ' << grid;
          } else
            rest.push_back(points[id]);
        EXPECT_TRUE(dt.is_valid(true));
        const Dynamic fresh(rest, walled.cell());
        EXPECT_EQ(dt.number_of_edges(), fresh.number_of_edges());
        EXPECT_EQ(dt.number_of_cells(), fresh.number_of_cells());
      }
}

TEST(Points_on_walls, may_jump_along_them_without_a_rebuild)
{
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> share(0.1, 0.9);
  for (const std::size_t axes : {2u, 1u}) {
    Walled_points walled(800, axes, 1);
    Points& points = walled.points;
    Dynamic dt(points, walled.cell());
    for (std::size_t id = 0; id < points.size(); id += 24) {
      ASSERT_TRUE(walled.is_sliding(id)); // across z
      points[id] = Point(share(random), share(random), points[id].z());
      EXPECT_FALSE(dt.update(points).rebuilt()) << axes;
      expect_as_fresh(dt, points, walled.cell());
    }
    ASSERT_NO_FATAL_FAILURE(expect_exact(dt, points, walled.cell()));
  }
}

// RANDOM PROGRAMS ---------------------------------------------------------------------------------

TEST(Random_programs_at_walls, lead_to_the_only_triangulation)
{
  const std::size_t numbers[] = {3, 20, 60, 150};
  for (std::size_t seed = 0; seed < 16; ++seed) {
    periodic_space_operations::Setting setting;
    setting.cell = seed % 2 == 0 ? square : straight;
    setting.grid = seed % 4 < 2 ? 0 : 0.125;
    setting.walls = true;
    periodic_space_operations::Program<Dynamic> program(std::mt19937_64(seed), setting);
    program.insert(numbers[seed / 4]);
    for (int i = 0; i < 12; ++i) {
      program.do_something();
      ASSERT_NO_FATAL_FAILURE(program.expect_as_fresh()) << seed << ' ' << i;
      ASSERT_FALSE(testing::Test::HasFailure()) << seed << ' ' << i;
    }
    ASSERT_NO_FATAL_FAILURE(program.expect_exact()) << seed;
  }
}

} // namespace test_periodic_space_walls_3

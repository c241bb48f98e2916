// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Points on the flat walls of slabs and wires in space: what a filter says of cells with points at
// infinity.

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

TEST(Predicates_at_walls, know_points_with_a_coordinate_in_common)
{
  std::mt19937_64 random(9);
  for (const Cell& cell : {square, oblique}) {
    Images images(cell, 1, random);
    for (const double x : {0.25, 0.5, 0.75, 1.25})
      images.add(x, x * x, 0.375);
    const bool is_along = cell == square; // by the other cell's vectors images are at other heights
    const auto multiples = [&](std::size_t i) { return images[i].multiples; };
    const bool are_shifted = multiples(0) - multiples(1) == Multiples_3{0, 0, 0} &&
                             multiples(0) - multiples(2) == Multiples_3{0, 0, 0} &&
                             multiples(0) - multiples(3) == Multiples_3{0, 0, 0};
    EXPECT_FALSE(are_shifted);
    EXPECT_EQ(images.torus.are_level(images[0], images[1], images[2], images[3]), is_along);
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

} // namespace test_periodic_space_walls_3

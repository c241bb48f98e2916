// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// What every proof of an edge rests on: the filters, the kernel's predicates and the tolerances
// claim nothing wrong for any finite doubles. Compiled for SSE4.1 or AVX all that is so below a
// limit, and the larger numbers are left out here.

#include "exact_signs.h"
#include "quadruples.h"

#include <CGAL/Dynamic_Delaunay_triangulation_2/classifiers/Nearly_delaunay_classifier_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/classifiers/Point_distance_times_2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <vector>

namespace {

namespace internal = CGAL::Dynamic_Delaunay_triangulations_2::internal;
using CGAL::Dynamic_Delaunay_triangulations_2::Edge_2;
using CGAL::Dynamic_Delaunay_triangulations_2::Edge_index;
using CGAL::Dynamic_Delaunay_triangulations_2::Index;
using CGAL::Dynamic_Delaunay_triangulations_2::Position_vector;
using CGAL::Dynamic_Delaunay_triangulations_2::Vertex_index;
using internal::Edge_slack_2;

constexpr double tiniest = std::numeric_limits<double>::denorm_min();

// A frame with one edge, from vertex 2 to vertex 3; vertices 1 to 4 are the quadruple. A classifier
// that asks whether the edge is Delaunay is told that it is not.
struct One_edge
{
  using Edge_index = CGAL::Dynamic_Delaunay_triangulations_2::Edge_index;
  using Edge = Edge_2;

  explicit One_edge(const Quadruple& q)
  {
    m_edge = {Vertex_index(2), Vertex_index(3), Vertex_index(1), Vertex_index(4)};
    m_positions.insert(m_positions.end(), q.begin(), q.end());
  }

  const Position_vector& positions() const { return m_positions; }
  const Position_2& position(Vertex_index v) const { return m_positions[v]; }
  bool corners_are_exact(Edge_index) const { return true; }
  const Edge_2& edge(Edge_index = Edge_index(0)) const { return m_edge; }
  CGAL::Dynamic_Delaunay_triangulations_2::Edge_corners_2 corners(Edge_index = Edge_index(0)) const
  {
    return internal::Plane_2::corners(m_edge, m_positions);
  }
  bool is_delaunay(Edge_index) const { return false; }

private:
  Position_vector m_positions{{NAN, NAN}};
  Edge_2 m_edge{};
};

TEST(Predicates, in_integers_know_what_is_obvious)
{
  EXPECT_EQ(exact_signs::orientation({0, 0}, {1, 0}, {0, tiniest}), 1);
  EXPECT_EQ(exact_signs::orientation({0, 0}, {0, tiniest}, {1, 0}), -1);
  EXPECT_EQ(exact_signs::orientation({-largest, -tiniest}, {0, 0}, {largest, tiniest}), 0);
  EXPECT_EQ(exact_signs::side_of_circle({0, 0}, {1, 0}, {1, 1}, {0, 1}), 0);
  EXPECT_EQ(exact_signs::side_of_circle({0, 0}, {1, 0}, {1, 1}, {tiniest, 0.5}), 1);
  EXPECT_EQ(exact_signs::side_of_circle({0, 0}, {1, 0}, {1, 1}, {-1, 1}), -1);
  EXPECT_EQ(exact_signs::compare_distance({0, 0}, {3e-320, 4e-320}, 5e-320), 0);
  EXPECT_EQ(exact_signs::compare_distance({-largest, 0}, {largest, 0}, largest), 1);
}

TEST(Predicates, of_the_kernel_are_right_for_all_coordinates)
{
  EXPECT_GT(expect_exact_kernel_predicates(1, 100000), 5000u);
}

TEST(Predicates, of_the_filters_claim_nothing_wrong_for_any_finite_doubles)
{
  Quadruples quadruples(2);
  std::size_t proved = 0;
  for (int i = 0; i < 100000; ++i) {
    const Quadruple q = quadruples.next();
    const auto& [a, b, c, d] = q;
    const Signs signs(q);
    const auto is_no_contradiction = [](int filtered, int sign) {
      return filtered == 0 || filtered == sign;
    };
    ASSERT_TRUE(is_no_contradiction(internal::filtered_orientation(a, b, c), signs.left))
        << text(q);
    ASSERT_TRUE(is_no_contradiction(internal::filtered_in_circle(a, b, c, d), signs.side))
        << text(q);
    const internal::Edge_filter_2 filter({a, b, c, d});
    const bool is_ccw = signs.are_counterclockwise();
    ASSERT_TRUE(!filter.proves_counterclockwise() || is_ccw) << text(q);
    ASSERT_TRUE(!filter.proves_delaunay() || (is_ccw && signs.side < 0)) << text(q);
    ASSERT_TRUE(!filter.proves_illegal() || (is_ccw && signs.side > 0)) << text(q);
    ASSERT_TRUE(!filter.disproves_delaunay() || signs.left < 0 || signs.right < 0 || signs.side > 0)
        << text(q);
    proved += filter.proves_delaunay();
  }
  EXPECT_GT(proved, 1000u);
}

// Products of some 2^-1026: differences are rounded as ever, and a bound of five units of them in
// the last place is zero.
TEST(Predicates, of_the_orientation_claim_nothing_where_their_bound_underflows)
{
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> number(-1, 1);
  for (int i = 0; i < 50000; ++i) {
    const double scale = std::ldexp(1.0, -511 - int(random() % 3));
    const auto point = [&](double size) {
      const double x = size * number(random), y = size * number(random);
      return Position_2{x, y};
    };
    const Position_2 c = point(1e-3 * scale), a = point(scale);
    const double share = number(random);
    const Position_2 b{c.x + share * (a.x - c.x), c.y + share * (a.y - c.y)};
    const int sign = internal::filtered_orientation(a, b, c);
    ASSERT_TRUE(sign == 0 || sign == exact_signs::orientation(a, b, c)) << text({a, b, c, a});
  }
}

void expect_no_contradiction(const Quadruple& q, const Signs& signs)
{
  const internal::Edge_filter_2 filter({q[0], q[1], q[2], q[3]});
  ASSERT_TRUE(!filter.proves_delaunay() || signs.side < 0) << text(q);
  ASSERT_TRUE(!filter.proves_illegal() || signs.side > 0) << text(q);
  ASSERT_TRUE(!filter.disproves_delaunay() || signs.side > 0) << text(q);
  const int side = internal::filtered_in_circle(q[0], q[1], q[2], q[3]);
  ASSERT_TRUE(side == 0 || side == signs.side) << text(q);
}

// One of three terms overflows and the bound does not: a tie must not count as an empty circle.
TEST(Predicates, of_the_filters_see_a_tie_in_a_huge_square)
{
  const Position_2 a{-1e77, 0}, b{-1e77, -1e77}, c{0, -1e77}, d{0, 0};
  EXPECT_EQ(internal::filtered_in_circle(a, b, c, d), 0);
  const Quadruple with_diagonal{{a, b, d, c}};
  expect_no_contradiction(with_diagonal, Signs(with_diagonal));
}

using Angles = std::array<double, 4>;

// Angles in the order of the corners of an edge, so that its faces are counterclockwise.
Angles any_angles(Random& random)
{
  Angles angles;
  for (double& angle : angles)
    angle = between(random, 0, 6.28);
  std::sort(angles.begin(), angles.end());
  std::swap(angles[2], angles[3]);
  return angles;
}

// Points of a circle around the origin, except for rounding and `spread` times the radius.
Quadruple on_circle(const Angles& angles, double radius, double spread, Random& random)
{
  Quadruple q;
  for (std::size_t i = 0; i < 4; ++i) {
    const double length = radius * (1 + spread * between(random, -0.5, 0.5));
    q[i] = {length * std::cos(angles[i]), length * std::sin(angles[i])};
  }
  return q;
}

// With a radius of some 2^exponent.
void expect_no_contradiction_near_circles(int exponent, double spread)
{
  Random random(1);
  for (int i = 0; i < 40000; ++i) {
    const double radius = std::ldexp(between(random, 1, 2), exponent);
    const Quadruple q = on_circle(any_angles(random), radius, spread, random);
    const Signs signs(q);
    if (signs.are_counterclockwise()) {
      ASSERT_NO_FATAL_FAILURE(expect_no_contradiction(q, signs));
    }
  }
}

// Some terms of the in-circle determinant overflow and others do not, and the product of both sizes
// does.
TEST(Predicates, of_nearly_cocircular_points_claim_nothing_where_terms_overflow)
{
  for (const int exponent : {254, 255, 256})
    expect_no_contradiction_near_circles(exponent, 1e-3);
}

// The terms are nearly equal, and just below or above the largest double.
TEST(Predicates, of_cocircular_points_claim_nothing_where_one_of_two_terms_overflows)
{
  Random random(2);
  for (int i = 0; i < 20000; ++i) {
    const Angles angles = any_angles(random);
    const Quadruple small = on_circle(angles, 1, 0, random);
    const internal::Edge_filter_2 unit({small[0], small[1], small[2], small[3]});
    const double term = unit.left * (unit.right_size - std::abs(unit.right));
    const double radius = std::ldexp(std::pow(term, -0.25), 256);
    for (int k = std::isfinite(radius) ? -4 : 5; k < 5; ++k) {
      const Quadruple q = on_circle(angles, radius * (1 + k * 0x1p-52), 0, random);
      const Signs signs(q);
      if (signs.are_counterclockwise()) {
        ASSERT_NO_FATAL_FAILURE(expect_no_contradiction(q, signs));
      }
    }
  }
}

// Both terms are subnormal numbers, whose last digit is larger than the bound.
TEST(Predicates, of_nearly_cocircular_points_claim_nothing_where_terms_underflow)
{
  for (const int exponent : {-260, -259, -258, -257, -254, -250, -248})
    expect_no_contradiction_near_circles(exponent, 0);
}

TEST(Predicates, of_four_edges_at_once_claim_nothing_wrong_for_any_finite_doubles)
{
  Quadruples quadruples(3);
  std::size_t proved = 0;
  for (int i = 0; i < 100000; ++i) {
    const Quadruple q = quadruples.next();
    const One_edge one(q);
    const Edge_2 edges[] = {one.edge(), one.edge(), one.edge(), one.edge()};
    std::vector<Edge_index> unproved;
    internal::append_unproved<internal::Plane_2>(edges, one.positions(), 0, 4, unproved);
    ASSERT_TRUE(unproved.empty() || unproved.size() == 4) << text(q);
    if (!unproved.empty())
      continue;
    ++proved;
    const Signs signs(q);
    ASSERT_TRUE(signs.are_counterclockwise() && signs.side < 0) << text(q);
  }
  EXPECT_GT(proved, 1000u);
}

// Expects of each lane, with an edge of its own, what a filter of one lane says of that edge.
template <int lanes>
BOOST_FORCEINLINE void expect_what_one_lane_proves(const std::vector<Edge_2>& edges,
                                                   const Position_vector& positions)
{
  for (std::size_t first = 0; first + lanes <= edges.size(); first += lanes) {
    const auto edge_at = [&](int i) CGAL_DYNAMIC_DELAUNAY_INLINE -> const Edge_2& {
      return edges[first + std::size_t(i)];
    };
    const auto filter = internal::Plane_2::filter<lanes>(edge_at, positions.data());
    const unsigned delaunay = internal::bits(filter.proves_delaunay());
    const unsigned illegal = internal::bits(filter.proves_illegal());
    const unsigned not_delaunay = internal::bits(filter.disproves_delaunay());
    for (int i = 0; i < lanes; ++i) {
      const internal::Edge_filter_2 one(internal::Plane_2::corners(edge_at(i), positions));
      ASSERT_EQ((delaunay >> i & 1) != 0, one.proves_delaunay()) << i;
      ASSERT_EQ((illegal >> i & 1) != 0, one.proves_illegal()) << i;
      ASSERT_EQ((not_delaunay >> i & 1) != 0, one.disproves_delaunay()) << i;
    }
  }
}

TEST(Predicates, of_an_edge_are_the_same_in_any_number_of_lanes)
{
  Quadruples quadruples(9);
  std::vector<Edge_2> edges;
  Position_vector positions;
  for (Index i = 0; i < 20000; ++i) {
    const Quadruple q = quadruples.next();
    Edge_2 edge = One_edge(q).edge();
    for (Vertex_index Edge_2::*corner :
         {&Edge_2::left, &Edge_2::source, &Edge_2::target, &Edge_2::right})
      (edge.*corner) += 4 * i - 1;
    edges.push_back(edge);
    positions.insert(positions.end(), q.begin(), q.end());
  }
  expect_what_one_lane_proves<internal::usual_lanes>(edges, positions);
  internal::call_with_lanes([&](auto lanes) CGAL_DYNAMIC_DELAUNAY_INLINE {
    expect_what_one_lane_proves<lanes>(edges, positions);
  });
}

// With fused multiply-add instructions (1 + e) (1 - e) - 1 would be -e^2 instead of 0.
TEST(Predicates, of_products_round_them_before_sums)
{
  using internal::product;
  const volatile double more = 1 + 0x1p-30, less = 1 - 0x1p-30;
  EXPECT_EQ(product(more, less) - 1, 0);
  internal::call_with_lanes([&](auto lanes) CGAL_DYNAMIC_DELAUNAY_INLINE {
    using Number = internal::Lanes<lanes>;
    const auto is_zero = product(Number(more), Number(less)) - Number(1) == Number(0);
    EXPECT_EQ(internal::bits(is_zero), internal::all_bits<lanes>);
  });
}

#ifdef __aarch64__

// With the processor in the state that a game or a library linked with -ffast-math may have set.
TEST(Predicates, compute_with_subnormal_numbers_where_a_program_flushes_them)
{
  constexpr std::uint64_t flushes = 1 << 24;
  std::uint64_t state, after;
  __asm__ volatile("mrs %0, fpcr" : "=r"(state));
  __asm__ volatile("msr fpcr, %0" : : "r"(state | flushes));
  volatile double smallest = (std::numeric_limits<double>::min)(), half = 0.5, inside = 0,
                  outside = 0;
  outside = smallest * half;
  {
    const internal::Default_floating_point default_state;
    inside = smallest * half;
  }
  __asm__ volatile("mrs %0, fpcr" : "=r"(after));
  __asm__ volatile("msr fpcr, %0" : : "r"(state));
  EXPECT_EQ(outside, 0);
  EXPECT_EQ(inside, (std::numeric_limits<double>::min)() / 2);
  EXPECT_EQ(after, state | flushes);
}

#endif

// Whether d is not deeper in the circle of the face abc than eps times its radius:
// 4 left in_circle <= eps (2 - eps) |ab|^2 |bc|^2 |ca|^2, with eps = digits / 2^shift.
bool is_nearly_outside(const Quadruple& q, double eps)
{
  using exact_signs::Integer;
  const auto [a, b, c, d] = exact_signs::as_integers<4>(q);
  const exact_signs::Vector u = a - d, v = b - d, w = c - d;
  const Integer in_circle = exact_signs::square(u) * exact_signs::cross(v, w) +
                            exact_signs::square(v) * exact_signs::cross(w, u) +
                            exact_signs::square(w) * exact_signs::cross(u, v);
  const Integer lengths =
      exact_signs::square(a - b) * exact_signs::square(b - c) * exact_signs::square(c - a);
  const auto shift = unsigned(eps == 0 ? 1 : -exact_signs::exponent(eps));
  const Integer digits(std::int64_t(std::ldexp(eps, int(shift))));
  const Integer factor = digits * ((Integer(1) << (shift + 1)) - digits);
  return Integer((4 * exact_signs::cross(b - a, c - a) * in_circle) << (2 * shift)) <=
         factor * lengths;
}

TEST(Predicates, of_nearly_delaunay_leave_no_edge_alone_beyond_the_bound)
{
  Quadruples quadruples(4);
  std::size_t left_alone = 0;
  constexpr double all_eps[] = {0, tiniest, 1e-200, 1e-60, 1e-17, 1e-15, 1e-9, 0.05, 0.5, 1};
  for (int i = 0; i < 100000; ++i) {
    const Quadruple q = quadruples.next();
    const double eps = all_eps[quadruples.random() % std::size(all_eps)];
    if (CGAL::Nearly_delaunay_classifier_2(eps).names_edge(One_edge(q), Edge_index(0)))
      continue;
    ++left_alone;
    const Signs signs(q);
    ASSERT_TRUE(signs.are_counterclockwise()) << text(q);
    if (signs.side > 0) {
      ASSERT_TRUE(is_nearly_outside(q, eps)) << eps << ": " << text(q);
      ASSERT_TRUE(is_nearly_outside({{q[3], q[2], q[1], q[0]}}, eps)) << eps << ": " << text(q);
    }
  }
  EXPECT_GT(left_alone, 500u);
}

// TOLERANCES --------------------------------------------------------------------------------------

// An edge between faces of any shape, near or far from the origin.
Quadruple any_rhombus(Quadruples& any)
{
  Random& random = any.random;
  const int exponent = any.any_exponent();
  const double offset =
      random() % 2 ? 0 : std::ldexp(between(random, -2, 2), exponent + whole(random, 0, 40));
  const double width = between(random, 0.01, 3), jitter = std::pow(10, between(random, -18, 0));
  const double angle = between(random, 0, 7), cosine = std::cos(angle), sine = std::sin(angle);
  Quadruple q{{{-width, 0}, {0, -1}, {0, 1}, {width, 0}}};
  for (Position_2& p : q) {
    const double x = p.x + between(random, -jitter, jitter);
    const double y = p.y + between(random, -jitter, jitter);
    p = {within_range(offset + std::ldexp(cosine * x - sine * y, exponent)),
         within_range(offset + std::ldexp(sine * x + cosine * y, exponent))};
  }
  return q;
}

// As far as t in a direction, or less, as doubles allow.
Position_2 moved(const Position_2& p, double t, double dx, double dy)
{
  const double length = std::hypot(dx, dy);
  if (!(length > 0) || !std::isfinite(length))
    return p;
  for (int i = 0; i < 60; ++i, t *= 1 - std::ldexp(1., i - 53)) {
    const Position_2 q{p.x + dx / length * t, p.y + dy / length * t};
    if (std::isfinite(q.x) && std::isfinite(q.y) && exact_signs::compare_distance(p, q, t) <= 0)
      return q;
  }
  return p;
}

// The ends of the edge outwards and the others inwards, or all anywhere.
Quadruple moved(const Quadruple& q, double t, bool is_squeezed, Random& random)
{
  Position_2 center{0, 0};
  for (const Position_2& p : q)
    center = {center.x + p.x / 4, center.y + p.y / 4};
  Quadruple result;
  for (std::size_t i = 0; i < 4; ++i) {
    const double sense = i == 1 || i == 2 ? 1 : -1;
    result[i] = is_squeezed
                    ? moved(q[i], t, sense * (q[i].x - center.x), sense * (q[i].y - center.y))
                    : moved(q[i], t, between(random, -1, 1), between(random, -1, 1));
  }
  return result;
}

TEST(Tolerances, are_kept_by_edges_of_any_length_anywhere)
{
  Quadruples any(5);
  std::size_t safe = 0;
  for (int i = 0; i < 50000; ++i) {
    const Quadruple q = any.random() % 4 ? any_rhombus(any) : any.next();
    const One_edge one(q);
    const double t = Edge_slack_2(one.edge(), one.corners()).tolerance();
    if (!(t > 0))
      continue;
    ++safe;
    for (int k = 0; k < 3; ++k) {
      const Quadruple m = moved(q, t, k == 0, any.random);
      const Signs signs(m);
      ASSERT_TRUE(!signs.are_counterclockwise() || signs.side < 0) << t << ": " << text(q);
    }
  }
  EXPECT_GT(safe, 2500u);
}

TEST(Tolerances, are_kept_by_hulls_of_any_extent_anywhere)
{
  Quadruples any(6);
  std::size_t safe = 0;
  for (int i = 0; i < 50000; ++i) {
    const Quadruple q = any.random() % 4 ? any_rhombus(any) : any.next();
    const One_edge one(q);
    Edge_2 edge = one.edge();
    edge.right = internal::infinite_index;
    const double t =
        Edge_slack_2(edge, internal::Plane_2::corners(edge, one.positions())).tolerance();
    if (!(t > 0))
      continue;
    ++safe;
    for (int k = 0; k < 3; ++k) {
      const Quadruple m = moved(q, t, k == 0, any.random);
      ASSERT_GT(exact_signs::orientation(m[0], m[1], m[2]), 0) << t << ": " << text(q);
    }
  }
  EXPECT_GT(safe, 2500u);
}

TEST(Tolerances, take_no_vertex_for_near_that_is_not)
{
  Quadruples any(7);
  std::size_t near = 0;
  for (int i = 0; i < 100000; ++i) {
    const Quadruple q = any.next();
    const double distance = internal::distance(q[0], q[1]);
    const double t = any.random() % 2 ? std::abs(any.any_double()) : (std::min)(distance, largest);
    if (!(t > Edge_slack_2::smallest_tolerance) || !internal::is_within(t, q[0], q[1]))
      continue;
    ++near;
    ASSERT_LE(exact_signs::compare_distance(q[0], q[1], t), 0) << t << ": " << text(q);
  }
  EXPECT_GT(near, 10000u);
}

// Its square is infinite, and so was the bound.
TEST(Tolerances, take_no_vertex_for_near_whose_squared_distance_overflows)
{
  EXPECT_FALSE(internal::is_within(2e154, {0, 0}, {1e200, 0}));
  EXPECT_FALSE(internal::is_within(2e154, {-largest, 0}, {largest, 0}));
  EXPECT_TRUE(internal::is_within(2e154, {0, 0}, {1e154, 0}));
}

using Points = std::vector<Epick::Point_2>;

// Their slack is no number, which spoiled the choice of a tolerance for all.
TEST(Tolerances, are_chosen_among_those_that_are_numbers)
{
  if (!internal::is_within_limit(1e200))
    GTEST_SKIP() << "compiled for SSE4.1 or newer, which refuses points so far away";
  for (unsigned seed = 0; seed < 36; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Points points = Cloud<Epick>(seed).uniform(500);
    for (const double x : {-1e200, 1e200})
      for (const double y : {-1e200, 1e200})
        points.emplace_back(x, y);
    const CGAL::Dynamic_Delaunay_triangulation_2<Epick> dt(points.begin(), points.end());
    for (const std::size_t share : {16u, 32u}) {
      internal::Safe_edges_2 safe_edges;
      safe_edges.start(dt.frame(), share);
      EXPECT_TRUE(safe_edges.holds()) << "one edge in " << share << " may be tight";
    }
  }
}

// Their squared products overflowed or underflowed, and the time was never, or late.
TEST(Tolerances, of_lengths_are_used_up_in_the_same_frame_at_any_scale)
{
  Random random(8);
  for (int i = 0; i < 20000; ++i) {
    const double x = i % 10 == 0 ? 0 : between(random, 0, 1);
    const double px = between(random, -1, 1), py = between(random, -1, 1);
    const double vx = between(random, -0.1, 0.1), vy = between(random, -0.1, 0.1);
    const double square = px * px + py * py;
    const double first = CGAL::Point_distance_times_2(x, square, px, py, vx, vy).first_frame();
    for (const double scale : {0x1p-480, 0x1p-400, 0x1p-260, 0x1p250, 0x1p300, 0x1p500}) {
      const CGAL::Point_distance_times_2 times(x, square * scale * scale, px * scale, py * scale,
                                               vx * scale, vy * scale);
      ASSERT_EQ(times.first_frame(), first) << "scale " << scale;
    }
  }
}

} // namespace

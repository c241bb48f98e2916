// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Calm frames at the hull: the slack of a hull facet against exact predicates, and updates, of
// points on flat walls above all, against those of a copy that leaves out nothing.

#include "space_points.h"
#include "space_twins.h"

#include <CGAL/Dynamic_Delaunay_triangulation_3.h>
#include <CGAL/Dynamic_periodic_Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iterator>
#include <limits>
#include <random>
#include <vector>

namespace {

namespace internal = CGAL::Dynamic_Delaunay_triangulations_3::internal;

using Epick = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Epick::Point_3;
using Points = space_points::Points;
using Open = CGAL::Dynamic_Delaunay_triangulation_3<Epick>;
using Periodic = CGAL::Dynamic_periodic_Delaunay_triangulation_3<Epick>;
using Cell = CGAL::Periodic_cell_3;
using space_twins::follow;
using space_twins::Twins;

// THE SLACK OF A HULL FACET -----------------------------------------------------------------------

using Vector = internal::Points_in_lanes_3<double>;
using Four = std::array<Point, 4>; // a facet, and another point
using Long = std::array<long double, 3>;

Vector between(const Point& p, const Point& q)
{
  return Vector{q.x(), q.y(), q.z()} - Vector{p.x(), p.y(), p.z()};
}

// What has to stay positive of four points, exactly and in long double.
struct Condition
{
  std::function<bool(const Four&)> holds;
  std::function<long double(const Four&)> value;
  std::function<double(const Four&)> slack;
  int fixed = 3; // the axis along which nothing moves
};

Long way(const Point& p, const Point& q)
{
  return {(long double)(q.x()) - p.x(), (long double)(q.y()) - p.y(), (long double)(q.z()) - p.z()};
}
Long cross(const Long& v, const Long& w)
{
  return {v[1] * w[2] - v[2] * w[1], v[2] * w[0] - v[0] * w[2], v[0] * w[1] - v[1] * w[0]};
}
long double dot(const Long& v, const Long& w)
{
  return v[0] * w[0] + v[1] * w[1] + v[2] * w[2];
}

internal::Hull_slack_3 slack_of_facet(const Four& p, double error = 0)
{
  return {between(p[0], p[1]), between(p[0], p[2]), error};
}

// The fourth point stays beneath the others.
Condition volume_condition()
{
  return {
      [](const Four& p) { return CGAL::orientation(p[3], p[0], p[1], p[2]) == CGAL::POSITIVE; },
      [](const Four& p) { return dot(way(p[3], p[0]), cross(way(p[0], p[1]), way(p[0], p[2]))); },
      [](const Four& p) {
        internal::Hull_slack_3 slack = slack_of_facet(p);
        slack.restrict_by_volume(between(p[3], p[0]), 0);
        return slack.slack();
      }};
}

// The facet stays counterclockwise as seen from above; the fourth point does not matter.
Condition area_condition()
{
  return {[](const Four& p) {
            const auto below = [](const Point& q) { return Epick::Point_2(q.x(), q.y()); };
            return CGAL::orientation(below(p[0]), below(p[1]), below(p[2])) == CGAL::POSITIVE;
          },
          [](const Four& p) { return cross(way(p[0], p[1]), way(p[0], p[2]))[2]; },
          [](const Four& p) {
            internal::Hull_slack_3 slack = slack_of_facet(p);
            slack.restrict_by_area({0, 0, 1}, 0);
            return slack.slack();
          }};
}

// The fourth point stays outside of the circle, in a plane across an axis.
Condition circle_condition(int axis)
{
  const int i = (axis + 1) % 3, j = (axis + 2) % 3;
  const auto area = [i, j](const Long& v, const Long& w) {
    return v[std::size_t(i)] * w[std::size_t(j)] - v[std::size_t(j)] * w[std::size_t(i)];
  };
  return {[i, j](const Four& p) {
            const auto flat = [&](const Point& q) { return Epick::Point_2(q[i], q[j]); };
            return CGAL::side_of_bounded_circle(flat(p[0]), flat(p[1]), flat(p[2]), flat(p[3])) ==
                   CGAL::ON_UNBOUNDED_SIDE;
          },
          [area](const Four& p) {
            const Long v = way(p[0], p[1]), w = way(p[0], p[2]), e = way(p[0], p[3]);
            const long double a = area(v, w);
            const long double power =
                a * dot(e, e) - dot(v, v) * area(e, w) - dot(w, w) * area(v, e);
            return a < 0 ? -power : power;
          },
          [axis](const Four& p) {
            internal::Hull_slack_3 slack = slack_of_facet(p);
            slack.restrict_by_circle(between(p[0], p[3]), axis);
            return slack.slack();
          },
          axis};
}

// The gradients of the value by the four points, by differences.
std::array<Long, 4> gradients(const Four& p, const Condition& condition)
{
  std::array<Long, 4> all{};
  for (std::size_t i = 0; i < p.size(); ++i)
    for (int k = 0; k < 3; ++k) {
      const auto with = [&](double x) {
        std::array<double, 3> coordinates{p[i].x(), p[i].y(), p[i].z()};
        coordinates[std::size_t(k)] = x;
        Four other = p;
        other[i] = Point(coordinates[0], coordinates[1], coordinates[2]);
        return condition.value(other);
      };
      const double step = 1e-4 * (std::abs(p[i][k]) + 1e-3 * std::abs(p[i].x()));
      const double low = p[i][k] - step, high = p[i][k] + step;
      if (k != condition.fixed && high > low)
        all[i][std::size_t(k)] = (with(high) - with(low)) / (high - low);
    }
  return all;
}

// Moves each point by that way, against the gradient.
Four moved_by_enemy(const Four& p, double length_of_way, const Condition& condition)
{
  Four moved = p;
  const std::array<Long, 4> all = gradients(p, condition);
  for (std::size_t i = 0; i < p.size(); ++i) {
    const Long& gradient = all[i];
    const long double size = std::sqrt(dot(gradient, gradient));
    if (size > 0)
      moved[i] = Point(p[i].x() - double(length_of_way * gradient[0] / size),
                       p[i].y() - double(length_of_way * gradient[1] / size),
                       p[i].z() - double(length_of_way * gradient[2] / size));
  }
  return moved;
}

// Facets of all shapes, with a point that is near or far; in a plane across an axis, if one is
// given.
Four some_four(std::mt19937_64& random, int axis)
{
  std::uniform_real_distribution<double> coordinate(-1, 1);
  const double scale = std::exp2(40 * coordinate(random));
  const double thin = random() % 2 == 0 ? 1 : std::exp2(-14 * std::abs(coordinate(random)));
  const double far = std::exp2(6 * std::abs(coordinate(random)));
  const double level = coordinate(random);
  Four p;
  for (std::size_t n = 0; n < 4; ++n) {
    std::array<double, 3> x;
    for (std::size_t k = 0; k < 3; ++k)
      x[k] = scale * (k == 1 ? thin : 1) * (n == 3 ? far : 1) * coordinate(random);
    if (axis < 3)
      x[std::size_t(axis)] = scale * level;
    p[n] = Point(x[0], x[1], x[2]);
  }
  if (axis < 3 && random() % 2 == 0) { // beside the circle
    const Point center = CGAL::circumcenter(p[0], p[1], p[2]);
    const Epick::Vector_3 v = p[3] - center;
    const double radius = std::sqrt(CGAL::squared_distance(center, p[0]));
    const double nearness = 1 + std::exp2(-20 * std::abs(coordinate(random)));
    const Point q = center + v * (radius * nearness / std::sqrt(v.squared_length()));
    std::array<double, 3> x{q.x(), q.y(), q.z()};
    x[std::size_t(axis)] = scale * level;
    p[3] = Point(x[0], x[1], x[2]);
  }
  return p;
}

void expect_no_motion_breaks(const Condition& condition, std::size_t least)
{
  std::mt19937_64 random(1);
  std::size_t measured = 0, tight = 0;
  for (int trial = 0; trial < 60000; ++trial) {
    const Four p = some_four(random, condition.fixed);
    const double slack = condition.slack(p);
    if (!(slack > 0))
      continue;
    ++measured;
    ASSERT_TRUE(condition.holds(p)) << "trial " << trial;
    ASSERT_TRUE(condition.holds(moved_by_enemy(p, 0.999 * slack, condition))) << "trial " << trial;
    tight += !condition.holds(moved_by_enemy(p, 4 * slack, condition));
  }
  EXPECT_GT(measured, least);
  EXPECT_GT(tight, measured / 10); // it is no empty promise
}

TEST(Hull_slack, no_motion_within_it_lifts_a_point_over_a_facet)
{
  expect_no_motion_breaks(volume_condition(), 20000);
}

TEST(Hull_slack, no_motion_within_it_turns_a_facet_over)
{
  expect_no_motion_breaks(area_condition(), 20000);
}

TEST(Hull_slack, no_motion_within_it_brings_a_point_into_a_circle)
{
  for (int axis = 0; axis < 3; ++axis)
    expect_no_motion_breaks(circle_condition(axis), 20000);
}

// What the proof in Hull_slack_3.h leaves of the power, with first derivatives as they are.
TEST(Hull_slack, keeps_the_bounds_of_its_proof)
{
  std::mt19937_64 random(4);
  std::size_t measured = 0;
  const Condition condition = circle_condition(2);
  for (int trial = 0; trial < 20000; ++trial) {
    const Four p = some_four(random, 2);
    const long double slack = condition.slack(p);
    if (!(slack > 0))
      continue;
    ++measured;
    long double left = condition.value(p), e1 = 0, squares = 0;
    for (const Long& gradient : gradients(p, condition))
      left -= slack * std::sqrt(dot(gradient, gradient));
    for (const Point& q : p) {
      const Long v = way(p[0], q);
      const long double l = std::sqrt(dot(v, v)) + slack;
      e1 += l;
      squares += l * l;
    }
    const long double e2 = (e1 * e1 - squares) / 2;
    ASSERT_GT(left - slack * slack * (3 * e1 * e1 + 4 * e2), 0) << "trial " << trial;
  }
  EXPECT_GT(measured, 5000u);
}

// The vectors that are given are off by up to the error: the slack is that of each of all that
// they may be.
TEST(Hull_slack, reckons_with_the_error_of_vectors)
{
  std::mt19937_64 random(2);
  std::uniform_real_distribution<double> coordinate(-1, 1);
  std::size_t measured = 0;
  for (int trial = 0; trial < 20000; ++trial) {
    const Four p = some_four(random, 2);
    const double size = std::sqrt((p[1] - p[0]).squared_length());
    const double error = size * std::exp2(-26 - 20 * std::abs(coordinate(random)));
    const auto off = [&](const Vector& v) {
      const double x = coordinate(random), y = coordinate(random), s = error / 1.5;
      return Vector{v.x + s * x, v.y + s * y, v.z};
    };
    internal::Hull_slack_3 slack(off(between(p[0], p[1])), off(between(p[0], p[2])), error);
    slack.restrict_by_circle(off(between(p[0], p[3])), 2);
    if (!(slack.slack() > 0))
      continue;
    ++measured;
    const Condition condition = circle_condition(2);
    ASSERT_TRUE(condition.holds(p)) << "trial " << trial;
    ASSERT_TRUE(condition.holds(moved_by_enemy(p, 0.999 * slack.slack(), condition)));
  }
  EXPECT_GT(measured, 5000u);
}

TEST(Hull_slack, without_a_way_proves_as_much)
{
  std::mt19937_64 random(3);
  std::size_t proved = 0;
  for (int trial = 0; trial < 20000; ++trial) {
    const Four p = some_four(random, 2);
    for (const bool of_circle : {false, true}) {
      const auto slack = [&](bool has_way) {
        internal::Hull_slack_3 result(between(p[0], p[1]), between(p[0], p[2]), 0, has_way);
        if (of_circle)
          result.restrict_by_circle(between(p[0], p[3]), 2);
        else
          result.restrict_by_volume({p[3].x(), p[3].y(), 1}, 0);
        return result.slack();
      };
      EXPECT_EQ(slack(true) > 0, slack(false) > 0) << "trial " << trial;
      proved += slack(false) > 0;
    }
  }
  EXPECT_GT(proved, 10000u);
}

TEST(Hull_slack, is_none_without_numbers)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Vector v{1, 0, 0}, w{0, 1, 0}, e{2, 2, 0}, nothing{nan, nan, nan};
  const auto slack = [](const Vector& a, const Vector& b, const Vector& c, bool of_circle) {
    internal::Hull_slack_3 result(a, b, 0);
    if (of_circle)
      result.restrict_by_circle(c, 2);
    else
      result.restrict_by_volume(c, 0);
    return result.slack();
  };
  const Vector up{0, 0, 1};
  EXPECT_GT(slack(v, w, e, true), 0);
  EXPECT_GT(slack(v, w, up, false), 0);
  for (const bool of_circle : {false, true}) {
    const Vector& x = of_circle ? e : up;
    EXPECT_FALSE(slack(nothing, w, x, of_circle) > 0);
    EXPECT_FALSE(slack(v, nothing, x, of_circle) > 0);
    EXPECT_FALSE(slack(v, w, nothing, of_circle) > 0);
  }
}

// FRAMES ------------------------------------------------------------------------------------------

constexpr double step = 1e-5; // the spacing is about a tenth
const Cell flat_cell({1, 0, 0}, {0, 1, 0}), skew_cell({1, 0.3, 0}, {-0.2, 0.9, 0});
const Cell duct_cell(Cell::Coordinates{1, 0, 0});

double& at(std::array<double, 3>& p, int axis)
{
  return p[std::size_t(axis)];
}
std::array<double, 3> array_of(const Point& p)
{
  return {p.x(), p.y(), p.z()};
}
Point point_of(const std::array<double, 3>& p)
{
  return Point(p[0], p[1], p[2]);
}

// Points of the unit cube, every third of which is on one of the walls across these axes, or all.
struct Walled
{
  explicit Walled(std::vector<int> axes_across, std::size_t number = 600, std::size_t every = 3)
    : axes(std::move(axes_across))
    , share(every)
    , points(space_points::random_points(number, 3))
  {
    for (std::size_t i = 0; i < points.size(); ++i)
      put_back(i);
  }

  bool is_on_wall(std::size_t i) const { return i % share == 0; }
  int axis(std::size_t i) const { return axes[i / share % axes.size()]; }
  // Onto the wall where it was, with the other coordinates as they are.
  void put_back(std::size_t i)
  {
    if (!is_on_wall(i))
      return;
    std::array<double, 3> p = array_of(points[i]);
    at(p, axis(i)) = i / share % 2 == 0 || has_one_wall ? low : high;
    points[i] = point_of(p);
  }
  // All take a step, those on walls along these.
  void slide(double length, int frame)
  {
    points = space_points::shaken(points, length, unsigned(frame));
    for (std::size_t i = 0; i < points.size(); ++i)
      put_back(i);
  }

  std::vector<int> axes;
  std::size_t share;
  Points points;
  double low = 0, high = 1;
  bool has_one_wall = false;
};

Walled layer()
{
  Walled walled({2}, 300, 1);
  walled.has_one_wall = true;
  for (std::size_t i = 0; i < walled.points.size(); ++i)
    walled.put_back(i);
  return walled;
}

Twins<Periodic> twins_of(const Walled& walled, const Cell& cell)
{
  return Twins<Periodic>(Periodic(walled.points.begin(), walled.points.end(), cell));
}
Twins<Open> twins_of(const Walled& walled)
{
  return Twins<Open>(Open(walled.points.begin(), walled.points.end()));
}

// Follows frames, which have to leave out so many infinite cells in the end.
template <class Dynamic>
void follow(Twins<Dynamic> twins, Walled walled, std::size_t safe,
            const std::function<void(Walled&, int)>& move, int frames = 60)
{
  for (int frame = 0; frame < frames; ++frame) {
    move(walled, frame);
    ASSERT_NO_FATAL_FAILURE(follow(twins, walled.points)) << "frame " << frame;
  }
  EXPECT_GE(twins.safe_infinite_cells(), safe);
}

// The same in a slab, in one with a skew cell, in a single layer, in a duct, and in a box in open
// space.
void follow_all(const std::function<void(Walled&, int)>& move, bool is_safe = true)
{
  const Walled slab({2}), duct({1, 2}), box({0, 1, 2});
  follow(twins_of(slab, flat_cell), slab, is_safe ? 200 : 0, move);
  follow(twins_of(slab, skew_cell), slab, is_safe ? 200 : 0, move);
  follow(twins_of(layer(), flat_cell), layer(), is_safe ? 600 : 0, move);
  follow(twins_of(duct, duct_cell), duct, is_safe ? 150 : 0, move);
  follow(twins_of(box), box, is_safe ? 150 : 0, move);
}

TEST(Calm_walls, points_slide_along_them)
{
  follow_all([](Walled& walled, int frame) { walled.slide(step, frame); });
}

TEST(Calm_walls, may_move)
{
  follow_all(
      [](Walled& walled, int frame) { // all the same way, and one wall along it
        for (Point& p : walled.points)
          p = Point(p.x() + 0.01, p.y(), p.z() + 0.003);
        walled.low += 0.003;
        walled.high += 0.003 + step;
        walled.slide(step, frame);
      },
      false);
}

TEST(Calm_walls, points_leave_them_and_come_back_exactly)
{
  for (const double way : {1e-16, 1e-9, 1e-6, 1e-3})
    follow_all(
        [way](Walled& walled, int frame) {
          walled.slide(step, frame);
          for (std::size_t i = 0; i < 8; ++i) { // into the cube, and at times out of it
            const std::size_t n = walled.share * (i + std::size_t(frame / 3) % 4);
            std::array<double, 3> p = array_of(walled.points[n]);
            double& x = at(p, walled.axis(n));
            const double inwards = x == walled.low ? 1 : -1;
            if (frame % 3 == 1)
              x += way * inwards * (frame % 4 == 1 ? -1 : 1);
            walled.points[n] = point_of(p);
          }
        },
        false);
}

TEST(Calm_walls, a_point_moves_by_one_unit_in_the_last_place)
{
  follow_all(
      [](Walled& walled, int frame) {
        walled.slide(step, frame);
        if (frame % 5 < 3)
          return;
        const std::size_t n = walled.share * std::size_t(frame / 10);
        std::array<double, 3> p = array_of(walled.points[n]);
        double& x = at(p, walled.axis(n));
        const double inside = 0.5, outside = x < inside ? -1 : 2;
        x = std::nextafter(x, frame % 10 < 5 ? inside : outside);
        walled.points[n] = point_of(p);
      },
      false);
}

TEST(Calm_walls, all_points_leave_one_at_once)
{
  follow_all([](Walled& walled, int frame) {
    walled.slide(step, frame);
    if (frame % 20 / 4 == 2)
      walled.points = space_points::shaken(walled.points, 1e-7, unsigned(frame));
  });
}

TEST(Calm_walls, points_arrive_one_by_one)
{
  follow_all(
      [](Walled& walled, int frame) {
        walled.slide(step, frame);
        for (std::size_t i = 0; i < walled.points.size(); ++i) {
          if (!walled.is_on_wall(i) || i / walled.share % 40 < std::size_t(frame))
            continue;
          std::array<double, 3> p = array_of(walled.points[i]);
          double& x = at(p, walled.axis(i));
          x += (x == walled.low ? 1 : -1) * 1e-5 * double(1 + i % 7);
          walled.points[i] = point_of(p);
        }
      },
      false);
}

// Ties on walls that rest have no slack; but nothing changes, unless a point moves.
TEST(Calm_walls, lattices_rest_on_them)
{
  Points points = space_points::random_points(500, 5);
  for (Point& p : points)
    p = Point(p.x(), p.y(), 0.1 + 0.8 * p.z());
  for (int i = 0; i < 64; ++i)
    for (const double z : {0.0, 1.0})
      points.emplace_back(i % 8 / 8.0, i / 8 / 8.0, z);
  const auto move = [](Points& all, int frame) {
    const Points moved = space_points::shaken(all, step, unsigned(frame));
    std::copy(moved.begin(), moved.begin() + 500, all.begin());
    Point& p = all[500 + 2 * std::size_t(frame)]; // alone
    p = Point(p.x() + 1e-6, p.y() - 2e-6, p.z());
  };
  follow(Twins<Periodic>(Periodic(points.begin(), points.end(), flat_cell)), points, 60, 40, move);
  follow(Twins<Open>(Open(points.begin(), points.end())), points, 60, 40, move);
}

// Slabs and wires without walls, and walls that are not across an axis.
TEST(Calm_hulls, need_not_be_flat)
{
  const Points points = space_points::random_points(600, 7);
  const auto move = [](Points& all, int frame) {
    all = space_points::shaken(all, step, unsigned(frame));
  };
  const Cell tilted({1, 0.1, 0.2}, {0.1, 0.9, -0.3});
  for (const Cell& cell : {flat_cell, tilted, duct_cell, Cell(Cell::Coordinates{0.6, 0.2, -0.3})}) {
    Twins<Periodic> twins(Periodic(points.begin(), points.end(), cell));
    ASSERT_NO_FATAL_FAILURE(follow(twins, points, 60, 40, move));
  }
  Points on_tilted = points; // z = 0.2 x - 0.35 y, rounded
  for (std::size_t i = 0; i < points.size(); i += 3)
    on_tilted[i] = Point(points[i].x(), points[i].y(),
                         0.2 * points[i].x() - 0.35 * points[i].y() - double(i % 2));
  follow(Twins<Periodic>(Periodic(on_tilted.begin(), on_tilted.end(), tilted)), on_tilted, 60, 0,
         move);
}

// After calm frames, rings of points around an axis go to twice their angles. All cells stay
// positive, and no vertex is held; but they cover space twice, which only the ray tells.
TEST(Calm_hulls, do_not_go_round_twice)
{
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> jitter(-0.001, 0.001);
  const double pi = std::acos(-1.0);
  Points points, doubled;
  for (int level = 0; level < 3; ++level) {
    const Point middle(jitter(random), jitter(random), 0.45 * level);
    points.push_back(middle);
    doubled.push_back(middle);
    for (int i = 0; i < 12; ++i) {
      const double angle = 2 * pi * (i + 0.5) / 12, radius = 0.5 + jitter(random);
      const double height = 0.05 + 0.4 * level + jitter(random);
      points.emplace_back(radius * std::cos(angle), radius * std::sin(angle), height);
      doubled.emplace_back(radius * std::cos(2 * angle), radius * std::sin(2 * angle), height);
    }
  }
  Open dt(points.begin(), points.end());
  for (int frame = 0; frame < 10; ++frame)
    dt.update(space_points::shaken(points, 1e-10, unsigned(frame)));
  EXPECT_TRUE(internal::Triangulation_access::state(dt).arrays.safe_cells().is_on());
  const CGAL::Update_report_3 report = dt.update(doubled);
  EXPECT_EQ(report.held, 0u);
  EXPECT_TRUE(report.rebuilt());
  EXPECT_TRUE(dt.is_valid(true));
}

// Between frames, points on walls move alone, come and go.
template <class Dynamic>
void change_between_frames(Twins<Dynamic> twins, Walled walled)
{
  std::mt19937_64 random(5);
  for (int frame = 0; frame < 60; ++frame) {
    walled.slide(step, frame);
    ASSERT_NO_FATAL_FAILURE(follow(twins, walled.points));
    for (int i = 0; i < 3; ++i) {
      const std::size_t id = random() % walled.points.size();
      const double way = random() % 2 == 0 ? 1e-3 : 0.1; // within the star, or beyond
      std::array<double, 3> p = array_of(walled.points[id]);
      at(p, 0) += way;
      at(p, random() % 2 == 0 ? 1 : 2) += random() % 2 == 0 ? way : 0;
      walled.points[id] = point_of(p);
      ASSERT_NO_FATAL_FAILURE(
          twins.change([&](Dynamic& dt) { return dt.move(id, walled.points[id]); }));
    }
    if (frame % 8 == 5) {
      const std::size_t id = 3 * std::size_t(frame);
      ASSERT_NO_FATAL_FAILURE(twins.change([&](Dynamic& dt) { return dt.remove(id); }));
      walled.points[id] = Point(0.4, 0.001 * frame, 0.6);
      walled.put_back(id);
      ASSERT_NO_FATAL_FAILURE(twins.change([&](Dynamic& dt) {
        std::vector<std::size_t> ids;
        return dt.insert(Points{walled.points[id]}, std::back_inserter(ids));
      }));
    }
  }
  EXPECT_GE(twins.frames_left_out(), 30u);
}

TEST(Calm_walls, know_of_changes_between_frames)
{
  const Walled slab({2}), duct({1, 2}), box({0, 1, 2});
  change_between_frames(twins_of(slab, flat_cell), slab);
  change_between_frames(twins_of(duct, duct_cell), duct);
  change_between_frames(twins_of(box), box);
}

} // namespace

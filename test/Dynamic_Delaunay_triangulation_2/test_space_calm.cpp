// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Calm frames, whose passes leave out cells that are safe: the slack of a cell against the exact
// predicates, and updates against those of a copy that leaves out nothing.

#include "space_oracle.h"
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
#include <iterator>
#include <limits>
#include <map>
#include <random>
#include <set>
#include <sstream>
#include <vector>

namespace {

namespace internal = CGAL::Dynamic_Delaunay_triangulations_3::internal;

using Epick = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Epick::Point_3;
using Points = space_points::Points;
using Open = CGAL::Dynamic_Delaunay_triangulation_3<Epick>;
using Periodic = CGAL::Dynamic_periodic_Delaunay_triangulation_3<Epick>;
using space_twins::follow;
using space_twins::Twins;

// THE SLACK OF A CELL -----------------------------------------------------------------------------

using Vector = internal::Points_in_lanes_3<double>;
using Five = std::array<Point, 5>;

Vector between(const Point& p, const Point& q)
{
  return Vector{q.x(), q.y(), q.z()} - Vector{p.x(), p.y(), p.z()};
}

// The slack of the first four points as a cell with the fifth beyond one of its facets, 0 if the
// filter proves nothing.
double slack_of(const Five& p, double error = 0)
{
  const Vector b = between(p[0], p[1]), c = between(p[0], p[2]), d = between(p[0], p[3]);
  const Vector e = between(p[0], p[4]);
  const internal::Cell_filter_in_lanes_3<double> filter(b, c, d);
  if (filter.may_be_inverted() || filter.may_be_inside(e))
    return 0;
  internal::Cell_slack_in_lanes_3<double> slack(b, c, d, filter, error);
  slack.restrict_by(e);
  return slack.slack();
}

bool holds(const Five& p)
{
  return CGAL::orientation(p[0], p[1], p[2], p[3]) == CGAL::POSITIVE &&
         CGAL::side_of_oriented_sphere(p[0], p[1], p[2], p[3], p[4]) == CGAL::ON_NEGATIVE_SIDE;
}

using Long = std::array<long double, 3>;

// How near the five are to a wrong sign, in long double: what an enemy makes smaller.
long double room(const Five& p, bool of_volume)
{
  const auto way = [&](std::size_t i) {
    return Long{(long double)(p[i].x()) - p[0].x(), (long double)(p[i].y()) - p[0].y(),
                (long double)(p[i].z()) - p[0].z()};
  };
  const auto dot = [](const Long& v, const Long& w) {
    return v[0] * w[0] + v[1] * w[1] + v[2] * w[2];
  };
  const auto cross = [](const Long& v, const Long& w) {
    return Long{v[1] * w[2] - v[2] * w[1], v[2] * w[0] - v[0] * w[2], v[0] * w[1] - v[1] * w[0]};
  };
  const Long b = way(1), c = way(2), d = way(3), e = way(4);
  const long double volume = dot(b, cross(c, d));
  if (of_volume)
    return volume;
  return volume * dot(e, e) - dot(b, b) * dot(cross(c, d), e) - dot(c, c) * dot(cross(d, b), e) -
         dot(d, d) * dot(cross(b, c), e);
}

// The derivatives of the room by the five points, by differences: along a coordinate of one point
// it is quadratic, so that those to both sides give the slope.
std::array<Long, 5> gradients(const Five& p, bool of_volume)
{
  std::array<Long, 5> gradients;
  for (std::size_t i = 0; i < 5; ++i)
    for (std::size_t k = 0; k < 3; ++k) {
      std::array<double, 3> x{p[i].x(), p[i].y(), p[i].z()};
      const double step = (std::max)({std::abs(x[0]), std::abs(x[1]), std::abs(x[2])}) / 1024;
      const double here = x[k], high = here + step, low = here - step;
      Five above = p, below = p;
      x[k] = high;
      above[i] = Point(x[0], x[1], x[2]);
      x[k] = low;
      below[i] = Point(x[0], x[1], x[2]);
      gradients[i][k] = (room(above, of_volume) - room(below, of_volume)) / (high - low);
    }
  return gradients;
}

// Moves each point by that way, against the gradient of the room.
Five moved_by_enemy(const Five& p, double way, bool of_volume)
{
  Five moved = p;
  const std::array<Long, 5> all = gradients(p, of_volume);
  for (std::size_t i = 0; i < 5; ++i) {
    const auto& gradient = all[i];
    const double length = double(std::hypot(gradient[0], gradient[1], gradient[2]));
    if (length > 0)
      moved[i] = Point(p[i].x() - way * double(gradient[0]) / length,
                       p[i].y() - way * double(gradient[1]) / length,
                       p[i].z() - way * double(gradient[2]) / length);
  }
  return moved;
}

// Cells of all shapes, with a point beyond: round, flat, needles, far apexes, near ties.
Five some_five(std::mt19937_64& random)
{
  std::uniform_real_distribution<double> coordinate(-1, 1);
  const auto point = [&](double x, double y, double z) {
    return Point(x * coordinate(random), y * coordinate(random), z * coordinate(random));
  };
  const double flat = std::exp2(-12 * std::abs(coordinate(random)));
  const double thin = random() % 2 == 0 ? 1 : std::exp2(-12 * std::abs(coordinate(random)));
  Five p;
  for (std::size_t i = 0; i < 4; ++i)
    p[i] = point(1, thin, random() % 2 == 0 ? 1 : flat);
  const double far = std::exp2(6 * std::abs(coordinate(random)));
  p[4] = point(far, far, far);
  if (random() % 2 == 0) { // beside the sphere of the others
    const Point center = CGAL::circumcenter(p[0], p[1], p[2], p[3]);
    const double radius = std::sqrt(CGAL::squared_distance(center, p[0]));
    const Epick::Vector_3 way = p[4] - center;
    const double nearness = 1 + std::exp2(-20 * std::abs(coordinate(random)));
    p[4] = center + way * (radius * nearness / std::sqrt(way.squared_length()));
  }
  if (CGAL::orientation(p[0], p[1], p[2], p[3]) == CGAL::NEGATIVE)
    std::swap(p[0], p[1]);
  return p;
}

TEST(Slack, no_motion_within_it_breaks_a_cell)
{
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> coordinate(-1, 1);
  std::size_t measured = 0, tight = 0;
  for (int trial = 0; trial < 100000; ++trial) {
    const double scale = std::exp2(60 * coordinate(random));
    Five p = some_five(random);
    for (Point& q : p)
      q = Point(scale * q.x(), scale * q.y(), scale * q.z());
    const double slack = slack_of(p);
    if (!(slack > 0))
      continue;
    ++measured;
    ASSERT_TRUE(holds(p)) << "trial " << trial;
    for (const bool of_volume : {false, true}) {
      ASSERT_TRUE(holds(moved_by_enemy(p, 0.999 * slack, of_volume))) << "trial " << trial;
      // it is no empty promise: often twice the way breaks what half of it cannot
      tight += !holds(moved_by_enemy(p, 2 * slack, of_volume));
    }
  }
  EXPECT_GT(measured, 30000u);
  EXPECT_GT(tight, measured / 10);
}

// The bounds of the proof in Cell_slack_3.h: first derivatives, and what lies beyond them.
struct Bounds
{
  explicit Bounds(const Five& p, long double way)
  {
    const auto length = [](const auto& v) { return std::hypot(v[0], v[1], v[2]); };
    Long middle{0, 0, 0};
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t k = 0; k < 3; ++k)
        middle[k] += (long double)(p[i][int(k)]) / 4;
    std::array<long double, 5> l;
    for (std::size_t i = 0; i < 5; ++i) {
      Long v;
      for (std::size_t k = 0; k < 3; ++k)
        v[k] = (long double)(p[i][int(k)]) - middle[k];
      l[i] = length(v) + way;
    }
    for (const bool of_volume : {false, true}) {
      long double slope = 0;
      for (const Long& gradient : gradients(p, of_volume))
        slope += length(gradient);
      (of_volume ? volume : power) = room(p, of_volume) - slope * way;
    }
    volume -= way * way * 3 * (l[0] + l[1] + l[2] + l[3]);
    long double e1 = 0, e2 = 0, e3 = 0;
    for (std::size_t i = 0; i < 5; ++i) {
      e1 += l[i];
      for (std::size_t j = 0; j < i; ++j) {
        e2 += l[i] * l[j];
        for (std::size_t k = 0; k < j; ++k)
          e3 += l[i] * l[j] * l[k];
      }
    }
    power -= way * way * (3 * e1 * e2 + 5 * e3);
  }

  long double volume, power; // what is left of them at least
};

// A cell alone, whose facets have no vertex beyond.
double slack_of_volume(const Five& p)
{
  const Vector b = between(p[0], p[1]), c = between(p[0], p[2]), d = between(p[0], p[3]);
  const internal::Cell_filter_in_lanes_3<double> filter(b, c, d);
  return filter.may_be_inverted()
             ? 0
             : internal::Cell_slack_in_lanes_3<double>(b, c, d, filter, 0).slack();
}

TEST(Slack, keeps_the_bounds_of_its_proof)
{
  std::mt19937_64 random(3);
  std::size_t measured = 0;
  for (int trial = 0; trial < 20000; ++trial) {
    const Five p = some_five(random);
    if (const double slack = slack_of(p); slack > 0) {
      ASSERT_GT(Bounds(p, slack).power, 0) << "trial " << trial;
      ++measured;
    }
    if (const double slack = slack_of_volume(p); slack > 0) {
      ASSERT_GT(Bounds(p, slack).volume, 0) << "trial " << trial;
    }
  }
  EXPECT_GT(measured, 6000u);
}

TEST(Slack, of_rounded_positions_is_smaller_by_the_error)
{
  std::mt19937_64 random(2);
  for (int trial = 0; trial < 1000; ++trial) {
    const Five p = some_five(random);
    const double slack = slack_of(p), error = slack / 4;
    if (slack > 0) {
      EXPECT_LE(slack_of(p, error), slack - error);
    }
  }
}

TEST(Slack, ignores_the_infinite_vertex)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Vector b{1, 0, 0}, c{0, 1, 0}, d{0, 0, 1};
  const internal::Cell_filter_in_lanes_3<double> filter(b, c, d);
  internal::Cell_slack_in_lanes_3<double> slack(b, c, d, filter, 0);
  const double before = slack.slack();
  EXPECT_GT(before, 0);
  slack.restrict_by(Vector{nan, nan, nan});
  EXPECT_EQ(slack.slack(), before);
}

// FRAMES ------------------------------------------------------------------------------------------

Twins<Open> open_twins(const Points& points)
{
  return Twins<Open>(Open(points.begin(), points.end()));
}
Twins<Periodic> periodic_twins(const Points& points)
{
  return Twins<Periodic>(Periodic(points.begin(), points.end(), CGAL::Periodic_cell_3(1, 1, 1)));
}

// In the unit cube 1,000 points are 0.1 apart.
constexpr std::size_t number = 1000;

template <class Make_twins>
void follow_all_kinds(const Make_twins& make_twins)
{
  const Points start = space_points::random_points(number, 3);
  follow(make_twins(start), start, 60, 50, [](Points& points, int frame) {
    points = space_points::shaken(points, 1e-5, unsigned(frame));
  });
  follow(make_twins(start), start, 60, 50, [](Points& points, int frame) { // drift
    for (Point& p : points)
      p = Point(p.x() + 0.013, p.y() - 0.007, p.z() + 0.002);
    points = space_points::shaken(points, 1e-6, unsigned(frame));
  });
  follow(make_twins(start), start, 60, 50, [](Points& points, int) { // shear, to and fro
    for (Point& p : points)
      p = Point(p.x() + 1e-5 * p.y(), p.y(), p.z());
  });
  follow(make_twins(start), start, 60, 10, [](Points& points, int frame) { // stops and goes
    if (frame % 20 >= 15)
      points = space_points::shaken(points, 1e-3, unsigned(frame));
  });
  follow(make_twins(start), start, 60, 40, [](Points& points, int frame) { // jumps of some
    points = space_points::shaken(points, 1e-5, unsigned(frame));
    if (frame % 20 == 19)
      for (std::size_t i = 0; i < 5; ++i)
        points[i] = Point(1 - points[i].x(), points[i].z(), points[i].y());
  });
}

TEST(Calm_frames, in_open_space_are_those_of_a_triangulation_that_tests_all_cells)
{
  follow_all_kinds(open_twins);
}

TEST(Calm_frames, in_periodic_space_are_those_of_a_triangulation_that_tests_all_cells)
{
  follow_all_kinds(periodic_twins);
}

// Points that go with the cell hardly move relative to it, but their images do.
TEST(Calm_frames, end_where_a_periodic_cell_changes)
{
  Points points = space_points::random_points(number, 4);
  Twins<Periodic> twins = periodic_twins(points);
  double shear = 0;
  for (int frame = 0; frame < 80; ++frame) {
    points = space_points::shaken(points, 1e-6, unsigned(frame));
    const double strain = frame < 20 || frame >= 60 ? 0 : 2e-3;
    for (Point& p : points)
      p = Point(p.x() + strain * p.y(), p.y(), p.z());
    shear += strain;
    const CGAL::Periodic_cell_3 cell({1, 0, 0}, {shear, 1, 0}, {0, 0, 1});
    ASSERT_NO_FATAL_FAILURE(twins.change([&](Periodic& dt) { return dt.update(points, cell); }))
        << "frame " << frame;
    EXPECT_TRUE(strain == 0 || !twins.leaves_out());
  }
  EXPECT_GE(twins.frames_left_out(), 20u);
}

// Between frames, points move alone, come and go, and meet and part.
template <class Dynamic>
void change_between_frames(Twins<Dynamic> twins, Points points)
{
  std::mt19937_64 random(5);
  std::map<std::size_t, Point> present;
  for (std::size_t i = 0; i < points.size(); ++i)
    present[i] = points[i];
  for (int frame = 0; frame < 80; ++frame) {
    points = space_points::shaken(points, 1e-5, unsigned(frame));
    if (frame % 8 == 3)
      points[10] = points[11]; // until the next frame
    ASSERT_NO_FATAL_FAILURE(follow(twins, points));
    for (int i = 0; i < 3; ++i) {
      const std::size_t id = random() % points.size();
      const double way = random() % 2 == 0 ? 0.01 : 0.1; // within the star, or beyond
      const Point& p = points[id];
      points[id] = Point(p.x() + way, p.y() - way, p.z() + way / 2);
      ASSERT_NO_FATAL_FAILURE(twins.change([&](Dynamic& dt) { return dt.move(id, points[id]); }));
    }
    if (frame % 8 == 5) {
      ASSERT_NO_FATAL_FAILURE(twins.change([&](Dynamic& dt) { return dt.remove(7); }));
      points[7] = Point(0.5, 0.001 * frame, 0.5);
      ASSERT_NO_FATAL_FAILURE(twins.change([&](Dynamic& dt) {
        std::vector<std::size_t> ids;
        return dt.insert(Points{points[7]}, std::back_inserter(ids));
      }));
    }
  }
  EXPECT_GE(twins.frames_left_out(), 40u);
}

TEST(Calm_frames, know_of_changes_between_them)
{
  const Points points = space_points::random_points(number, 6);
  change_between_frames(open_twins(points), points);
  change_between_frames(periodic_twins(points), points);
}

// By what filters reckon must not depend on what has been: found by a random program, in which a
// point that had been far away was gone, and a checkpoint was read before the next frame.
TEST(Calm_frames, reckon_with_the_same_error_after_a_checkpoint)
{
  Points points = space_points::random_points(50, 10);
  for (const CGAL::Periodic_cell_3& cell :
       {CGAL::Periodic_cell_3(1, 1, 1),
        CGAL::Periodic_cell_3(CGAL::Periodic_cell_3::Coordinates{1, 0, 0}, {0, 1, 0})}) {
    Periodic dt(points.begin(), points.end(), cell);
    const Point near = points[7];
    points[7] = Point(near.x() + 1000, near.y(), near.z());
    dt.update(points);
    dt.remove(7);
    std::stringstream file;
    dt.write_checkpoint(file);
    Periodic other(cell);
    other.read_checkpoint(file);
    points[7] = near;
    dt.update(points);
    other.update(points);
    EXPECT_EQ(internal::Triangulation_access::state(dt).squared_error,
              internal::Triangulation_access::state(other).squared_error);
  }
}

// Lattices have ties everywhere: no cell is ever safe, and slacks are not learned in vain.
TEST(Calm_frames, learn_nothing_of_ties)
{
  Points points = space_points::lattice(8);
  Twins<Open> twins = open_twins(points);
  for (int frame = 0; frame < 20; ++frame) {
    for (Point& p : points)
      p = Point(p.x() + 0.125, p.y(), p.z());
    ASSERT_NO_FATAL_FAILURE(follow(twins, points));
    EXPECT_FALSE(twins.leaves_out());
  }
}

TEST(Calm_frames, rough_motion_ends_them)
{
  Points points = space_points::random_points(number, 8);
  Twins<Open> twins = open_twins(points);
  for (int frame = 0; frame < 60; ++frame) {
    points = space_points::shaken(points, frame < 30 ? 1e-6 : 2e-3, unsigned(frame));
    ASSERT_NO_FATAL_FAILURE(follow(twins, points));
    if (frame == 29) {
      EXPECT_TRUE(twins.leaves_out());
    }
  }
  EXPECT_FALSE(twins.leaves_out());
}

// THE NUMBERS THAT ARE KEPT -----------------------------------------------------------------------

using CGAL::Dynamic_Delaunay_triangulations_3::Cell_index;

TEST(Safe_cells, are_those_whose_slack_is_not_used_up)
{
  std::mt19937_64 random(9);
  std::uniform_real_distribution<double> fraction(0, 1);
  for (const double unit : {1e-90, 1e-3, 1.0, 1e20}) {
    internal::Safe_cells_3 cells;
    cells.start(100, unit);
    std::vector<double> left(100, 0);
    std::size_t safe = 0;
    for (int frame = 0; frame < 3000; ++frame) { // long enough for the numbers to begin anew
      const double way = unit * fraction(random) * (frame % 500 == 499 ? 300 : 0.1);
      cells.advance(way);
      std::vector<Cell_index> doubtful;
      cells.list_doubtful(0, 100, doubtful);
      const std::set<std::size_t> tested(doubtful.begin(), doubtful.end());
      for (std::size_t c = 0; c < 100; ++c) {
        left[c] -= way;
        ASSERT_TRUE(left[c] >= 0 || tested.count(c) == 1);
        safe += tested.count(c) == 0;
        if (tested.count(c) == 1) {
          left[c] = unit * std::exp2(10 * fraction(random) - 5);
          cells.set_slack(Cell_index(c), left[c]);
        }
      }
    }
    EXPECT_GT(safe, 200000u);
  }
}

TEST(Safe_cells, none_is_left_by_ways_without_a_number)
{
  for (const double way :
       {1e300, std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()}) {
    internal::Safe_cells_3 cells;
    cells.start(4, 1);
    for (std::size_t c = 0; c < 4; ++c)
      cells.set_slack(Cell_index(c), 1e9);
    cells.advance(way);
    std::vector<Cell_index> doubtful;
    cells.list_doubtful(0, 4, doubtful);
    EXPECT_EQ(doubtful.size(), 4u);
  }
}

} // namespace

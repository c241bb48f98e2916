// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Triangulations of points in space.

#include "space_operations.h"
#include "space_oracle.h"
#include "space_points.h"

#include <CGAL/Dynamic_Delaunay_triangulation_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/convert_to_delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <boost/property_map/property_map.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <iterator>
#include <limits>
#include <list>
#include <map>
#include <random>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace test_space {

using Epick = CGAL::Exact_predicates_inexact_constructions_kernel;
using Epeck = CGAL::Exact_predicates_exact_constructions_kernel;
using Dynamic = CGAL::Dynamic_Delaunay_triangulation_3<Epick>;
using Point = Dynamic::Point;
using Points = std::vector<Point>;
using space_operations::Program;
using space_points::lattice;
using space_points::random_points;

std::map<std::size_t, Point> by_id(const Points& points)
{
  std::map<std::size_t, Point> result;
  for (std::size_t id = 0; id < points.size(); ++id)
    result.emplace(id, points[id]);
  return result;
}

void expect_exact(const Dynamic& dt, const Points& points)
{
  space_oracle::expect_exact(dt, by_id(points));
}

// CREATION ----------------------------------------------------------------------------------------

TEST(Few_points, have_the_dimension_that_they_span)
{
  const Points points{{0, 0, 0}, {0, 0, 0}, {1, 0, 0}, {0.5, 0, 0},
                      {0, 1, 0}, {1, 1, 0}, {0, 0, 1}};
  const int dimensions[] = {-1, 0, 0, 1, 1, 2, 2, 3};
  for (std::size_t number = 0; number <= points.size(); ++number) {
    const Points some(points.begin(), points.begin() + std::ptrdiff_t(number));
    const Dynamic dt(some);
    EXPECT_EQ(dt.dimension(), dimensions[number]);
    ASSERT_NO_FATAL_FAILURE(expect_exact(dt, some));
  }
}

TEST(Few_points, rise_from_a_plane_and_fall_into_it)
{
  Points points = random_points(40);
  Dynamic dt(points);
  for (const double height : {0.0, 0.0, 1e-300, 1.0, 0.0, 1e-9, 0.5}) {
    Points flat;
    for (const Point& p : points)
      flat.emplace_back(p.x(), p.y(), p.z() * height);
    dt.update(flat);
    ASSERT_NO_FATAL_FAILURE(expect_exact(dt, flat)) << height;
  }
}

TEST(Points_in_space, are_triangulated_as_by_CGAL)
{
  for (const std::size_t number : {4u, 5u, 20u, 300u, 3000u})
    ASSERT_NO_FATAL_FAILURE(expect_exact(Dynamic(random_points(number)), random_points(number)));
}

TEST(Points_in_space, may_form_a_lattice)
{
  ASSERT_NO_FATAL_FAILURE(expect_exact(Dynamic(lattice(6)), lattice(6)));
}

// The points of integer coordinates on a sphere around the origin.
Points integer_sphere(int squared_radius)
{
  Points points;
  const int most = int(std::sqrt(squared_radius));
  for (int x = -most; x <= most; ++x)
    for (int y = -most; y <= most; ++y)
      for (int z = -most; z <= most; ++z)
        if (x * x + y * y + z * z == squared_radius)
          points.emplace_back(x, y, z);
  return points;
}

TEST(Points_in_space, may_have_ties_everywhere)
{
  Points half, layers, shells = integer_sphere(41);
  for (const Point& p : random_points(600))
    half.emplace_back(std::floor(8 * p.x()), std::floor(8 * p.y()), std::floor(8 * p.z()));
  for (const Point& p : random_points(300))
    layers.emplace_back(p.x(), p.y(), std::floor(3 * p.z()));
  for (const Point& p : integer_sphere(101))
    shells.push_back(p);
  for (const Points& points : {half, layers, integer_sphere(41), integer_sphere(101), shells})
    ASSERT_NO_FATAL_FAILURE(expect_exact(Dynamic(points), points));
}

// Far more cells than most vertices have.
TEST(Points_in_space, may_be_inserted_amid_hundreds)
{
  Points points;
  for (const Point& p : random_points(300)) {
    const Epick::Vector_3 way = p - Point(0.5, 0.5, 0.5);
    points.push_back(CGAL::ORIGIN + way / std::sqrt(way.squared_length()));
  }
  Dynamic dt(points);
  points.emplace_back(0.01, 0.02, 0.03);
  dt.insert(points.back());
  std::size_t neighbors = 0;
  dt.for_each_neighbor(300, [&](std::size_t) { ++neighbors; });
  EXPECT_GT(neighbors, 200u);
  ASSERT_NO_FATAL_FAILURE(expect_exact(dt, points));
}

TEST(Points_in_space, may_be_read_from_any_range)
{
  const Points points = random_points(50);
  const std::list<Point> list(points.begin(), points.end());
  Dynamic dt(list);
  ASSERT_NO_FATAL_FAILURE(expect_exact(dt, points));
  std::list<Point> moved;
  for (const Point& p : points)
    moved.emplace_back(p.y(), p.z(), p.x());
  dt.update(moved.begin(), moved.end());
  ASSERT_NO_FATAL_FAILURE(expect_exact(dt, Points(moved.begin(), moved.end())));
  dt.update(list);
  ASSERT_NO_FATAL_FAILURE(expect_exact(dt, points));
}

// What a simulation has of a particle.
struct Particle
{
  int id = 0;
  double mass = 1;
  Point center;
};

struct Id_of_particle
{
  using key_type = Particle;
  using value_type = int;
  using reference = const int&;
  using category = boost::readable_property_map_tag;
  friend reference get(Id_of_particle, const Particle& particle) { return particle.id; }
};

struct Center_of_particle
{
  using key_type = Particle;
  using value_type = Point;
  using reference = const Point&;
  using category = boost::readable_property_map_tag;
  friend reference get(Center_of_particle, const Particle& particle) { return particle.center; }
};

TEST(Points_in_space, may_be_parts_of_any_values)
{
  const Points points = random_points(40);
  std::list<Particle> particles;
  for (std::size_t i = 0; i < points.size(); ++i)
    particles.push_back({int(i), 1.5, points[i]});

  const Center_of_particle center;
  ASSERT_NO_FATAL_FAILURE(expect_exact(Dynamic(particles, center), points));
  ASSERT_NO_FATAL_FAILURE(expect_exact(
      Dynamic(particles.begin(), particles.end(), center, Dynamic::Settings()), points));

  Dynamic dt;
  std::vector<std::size_t> ids;
  dt.insert(particles, center, std::back_inserter(ids));
  ASSERT_EQ(ids.size(), points.size());
  ASSERT_NO_FATAL_FAILURE(expect_exact(dt, points));

  Points moved = points;
  for (Particle& particle : particles) {
    particle.center = Point(particle.center.x(), particle.center.z(), particle.center.y());
    moved[std::size_t(particle.id)] = particle.center;
  }
  dt.update(particles, center);
  ASSERT_NO_FATAL_FAILURE(expect_exact(dt, moved));

  particles.resize(3);
  for (Particle& particle : particles)
    particle.center = points[std::size_t(particle.id)];
  std::copy_n(points.begin(), 3, moved.begin());
  dt.move(particles, Id_of_particle(), center);
  ASSERT_NO_FATAL_FAILURE(expect_exact(dt, moved));
  particles.front().id = -1;
  EXPECT_THROW(dt.move(particles, Id_of_particle(), center), CGAL::Unknown_id_error_2);
}

TEST(Points_in_space, come_and_go_as_ranges)
{
  const Points points = random_points(40);
  Dynamic dt;
  dt.insert(points);
  ASSERT_NO_FATAL_FAILURE(expect_exact(dt, points));
  dt.move(std::map<std::size_t, Point>{{0, points[1]}, {1, points[0]}});
  EXPECT_EQ(dt.point(0), points[1]);
  dt.remove(std::set<int>{0, 1, 2});
  EXPECT_EQ(dt.number_of_points(), 37u);
  std::vector<std::size_t> ids;
  dt.insert(Points(points.begin(), points.begin() + 3), std::back_inserter(ids));
  EXPECT_EQ(ids, (std::vector<std::size_t>{0, 1, 2}));
  ASSERT_NO_FATAL_FAILURE(expect_exact(dt, points));
}

// Of points that come to one place together the one with the smallest id is the representative,
// unless another one is there.
TEST(Points_in_space, that_coincide_are_represented_by_the_first)
{
  for (const bool is_flat : {false, true})
    for (unsigned seed = 1; seed <= 20; ++seed) {
      std::mt19937 random(seed);
      std::uniform_int_distribution<int> place(0, 3);
      Points points;
      for (int i = 0; i < 60; ++i)
        points.emplace_back(place(random), place(random), is_flat ? 1 : place(random));
      for (const std::ptrdiff_t first : {0, 20, 40}) { // a rebuild, and insertion of the others
        Dynamic dt(Points(points.begin(), points.begin() + first));
        dt.insert(points.begin() + first, points.begin() + 45);
        for (std::ptrdiff_t i = 45; i < 60; i += 5)
          dt.insert(points.begin() + i, points.begin() + i + 5);
        for (std::size_t id = 0; id < points.size(); ++id)
          EXPECT_EQ(
              dt.representative(id),
              std::size_t(std::find(points.begin(), points.end(), points[id]) - points.begin()));
        ASSERT_NO_FATAL_FAILURE(expect_exact(dt, points));
      }
    }
}

// MOTION ------------------------------------------------------------------------------------------

struct Shaken
{
  const char* name;
  Points points;
  double spacing;
};

class Motion_in_space : public testing::TestWithParam<double>
{
};

TEST_P(Motion_in_space, is_followed_exactly)
{
  const Shaken cases[] = {{"cube", random_points(400), 1 / std::cbrt(400.0)},
                          {"lattice", lattice(7), 1},
                          {"slab", random_points(400), 0.05}};
  for (const Shaken& one : cases) {
    Points points = one.points;
    if (one.name == std::string("slab"))
      for (Point& p : points)
        p = Point(p.x(), p.y(), 0.05 * p.z());
    std::mt19937_64 random(7);
    std::normal_distribution<double> step(0, GetParam() * one.spacing / std::sqrt(3.0));
    Dynamic dt(points);
    for (int frame = 0; frame < 12; ++frame) {
      for (Point& p : points) {
        const double x = p.x() + step(random), y = p.y() + step(random);
        p = Point(x, y, p.z() + step(random));
      }
      dt.update(points);
      ASSERT_NO_FATAL_FAILURE(expect_exact(dt, points)) << one.name << ", frame " << frame;
    }
  }
}
INSTANTIATE_TEST_SUITE_P(steps, Motion_in_space,
                         testing::Values(1e-12, 1e-4, 0.01, 0.05, 0.1, 0.2, 0.5, 2.0));

TEST(Calm_motion, is_mended_not_rebuilt)
{
  Points points = random_points(2000);
  Dynamic dt(points);
  std::mt19937_64 random(3);
  std::normal_distribution<double> step(0, 0.03 / std::cbrt(2000.0) / std::sqrt(3.0));
  std::size_t flips = 0, held = 0;
  for (int frame = 0; frame < 10; ++frame) {
    for (Point& p : points) {
      const double x = p.x() + step(random), y = p.y() + step(random);
      p = Point(x, y, p.z() + step(random));
    }
    const CGAL::Update_report_3 report = dt.update(points);
    EXPECT_FALSE(report.rebuilt());
    flips += report.flips;
    held += report.held;
  }
  EXPECT_GT(flips, 2000u);
  EXPECT_GT(held, 10u);
  ASSERT_NO_FATAL_FAILURE(expect_exact(dt, points));
}

TEST(Points_that_rest, need_no_flip)
{
  for (const Points& points : {random_points(500), lattice(6)}) {
    Dynamic dt(points);
    const CGAL::Update_report_3 report = dt.update(points);
    EXPECT_EQ(report.flips, 0u);
    EXPECT_FALSE(report.rebuilt());
    ASSERT_NO_FATAL_FAILURE(expect_exact(dt, points));
  }
}

TEST(Lattice_in_space, is_rebuilt_by_its_first_motion)
{
  Points points = lattice(12);
  Dynamic dt(points);
  std::mt19937_64 random(1);
  std::normal_distribution<double> way(0, 1e-4);
  for (Point& p : points)
    p = p + Epick::Vector_3(way(random), way(random), way(random));
  const CGAL::Update_report_3 report = dt.update(points);
  EXPECT_EQ(report.rebuild_reason, CGAL::Rebuild_reason_2::TOO_MUCH_BROKEN);
  EXPECT_EQ(report.flips, 0u);
  ASSERT_NO_FATAL_FAILURE(expect_exact(dt, points));
}

// A sixth of a lattice moves a little: in some of these frames flips get stuck, and no vertex that
// steps back helps.
TEST(Lattice_in_space, is_rebuilt_where_flips_are_stuck)
{
  std::size_t stuck = 0;
  for (unsigned seed = 0; seed < 120; ++seed) {
    Points points = lattice(8);
    Dynamic dt(points);
    std::mt19937_64 random(seed);
    std::normal_distribution<double> way(0, 0.028);
    for (Point& p : points)
      if (random() % 6 == 0)
        p = p + Epick::Vector_3(way(random), way(random), way(random));
    stuck += dt.update(points).rebuild_reason == CGAL::Rebuild_reason_2::STUCK;
    ASSERT_TRUE(dt.is_valid(true)) << seed;
  }
  EXPECT_GT(stuck, 0u);
}

// All of them are cospherical but for rounding, so any motion leaves no cell as it is.
TEST(Points_on_a_sphere, are_triangulated_anew_before_any_flip)
{
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  const auto on_sphere = [](double x, double y, double z) {
    const double r = std::hypot(x, y, z);
    return Point(x / r, y / r, z / r);
  };
  Points points;
  for (int i = 0; i < 500; ++i)
    points.push_back(on_sphere(normal(random), normal(random), normal(random)));
  Dynamic dt(points);
  for (const double step : {1e-6, 0.001, 0.1}) {
    for (Point& p : points)
      p = on_sphere(p.x() + step * normal(random), p.y() + step * normal(random), p.z());
    const auto report = dt.update(points);
    EXPECT_EQ(report.rebuild_reason, CGAL::Rebuild_reason_2::TOO_MUCH_BROKEN) << step;
    EXPECT_EQ(report.flips, 0u) << step;
    ASSERT_NO_FATAL_FAILURE(expect_exact(dt, points));
  }
}

TEST(Points_that_jump, are_taken_out_and_inserted_elsewhere)
{
  Points points = random_points(1000);
  Dynamic dt(points);
  const Points others = random_points(100, 2);
  for (std::size_t frame = 0; frame < 20; ++frame) {
    points[37 * frame] = others[frame];
    std::swap(points[37 * frame + 1], points[37 * frame + 20]);
    const CGAL::Update_report_3 report = dt.update(points);
    EXPECT_FALSE(report.rebuilt());
    EXPECT_GE(report.relocated, 2u);
    ASSERT_NO_FATAL_FAILURE(expect_exact(dt, points));
  }
}

TEST(Coincident_points, share_a_vertex_and_part_again)
{
  Points points = random_points(2000);
  const Points home = points;
  Dynamic dt(points);
  for (std::size_t i = 0; i < 9; ++i)
    points[30 * i] = points[30 * i + 11] = points[30 * i + 7];
  const CGAL::Update_report_3 merging = dt.update(points);
  EXPECT_EQ(merging.merged, 18u);
  EXPECT_EQ(dt.number_of_vertices(), 1982u);
  ASSERT_NO_FATAL_FAILURE(expect_exact(dt, points));
  const CGAL::Update_report_3 parting = dt.update(home);
  EXPECT_EQ(parting.parted, 18u);
  ASSERT_NO_FATAL_FAILURE(expect_exact(dt, home));
}

// Random programs. Each has ended wrong, or was chosen at random.
class Random_programs_in_space : public testing::TestWithParam<std::tuple<int, double, double>>
{
};

TEST_P(Random_programs_in_space, stay_exact)
{
  const auto [seed, extent, grid] = GetParam();
  Program<Dynamic> program(std::uint64_t(seed), extent, grid);
  ASSERT_NO_FATAL_FAILURE(program.insert(std::size_t(seed % 60)));
  for (int i = 0; i < 60; ++i) {
    ASSERT_NO_FATAL_FAILURE(program.do_something()) << "operation " << i;
    ASSERT_NO_FATAL_FAILURE(space_oracle::expect_exact(program.triangulation(), program.points()))
        << "operation " << i;
  }
}
INSTANTIATE_TEST_SUITE_P(anywhere, Random_programs_in_space,
                         testing::Combine(testing::Range(1, 20), testing::Values(1.0),
                                          testing::Values(0.0)));
INSTANTIATE_TEST_SUITE_P(on_a_grid, Random_programs_in_space,
                         testing::Combine(testing::Range(20, 40), testing::Values(1.0),
                                          testing::Values(0.25)));
INSTANTIATE_TEST_SUITE_P(far_and_near, Random_programs_in_space,
                         testing::Combine(testing::Range(40, 44),
                                          testing::Values(1e-150, 1e-30, 1e70),
                                          testing::Values(0.0)));

std::size_t wanted_number(const char* variable, std::size_t usual)
{
  const char* const text = std::getenv(variable);
  return text ? std::stoul(text) : usual;
}

// To look for more: SPACE_OPERATIONS=1000000 SPACE_SEED=1 test_space --gtest_filter='Many*'
TEST(Many_programs_in_space, stay_exact)
{
  constexpr std::size_t of_a_program = 50;
  constexpr std::array<double, 5> grids = {0, 0, 0.25, 0.1, 0.5};
  constexpr std::array<double, 7> extents = {1, 1, 1, 1, 1e-150, 1e-30, 1e70};
  const std::size_t number = wanted_number("SPACE_OPERATIONS", 2000);
  std::uint64_t seed = wanted_number("SPACE_SEED", 1);
  for (std::size_t done = 0; done < number && !HasFailure(); ++seed) {
    SCOPED_TRACE("SPACE_SEED=" + std::to_string(seed));
    const double extent = extents[seed / 5 % 7];
    Program<Dynamic> program(seed, extent, grids[seed % 5] * extent);
    program.insert(std::size_t(seed * 7919 % 150));
    for (std::size_t i = 0; i < of_a_program && !HasFailure(); ++i, ++done) {
      SCOPED_TRACE("operation " + std::to_string(i));
      if (seed % 3 == 0 && i % 4 == 0)
        program.move_some();
      else if (seed % 3 == 1 && i % 4 == 0)
        program.move_some_a_little();
      else
        program.do_something();
      space_oracle::expect_exact(program.triangulation(), program.points());
    }
  }
}

// 10134: the hole of a vertex that is taken out grows over all cells. 10417: a frame is rebuilt
// after vertices have changed their numbers. 3142 and 100186: a vertex would be taken out where
// cells cover space twice.
class Found_program_in_space : public testing::TestWithParam<std::tuple<int, double, int>>
{
};

TEST_P(Found_program_in_space, stays_exact)
{
  const auto [seed, grid, points] = GetParam();
  Program<Dynamic> program(std::uint64_t(seed), 1, grid);
  program.insert(std::size_t(points));
  for (int i = 0; i < 50; ++i) {
    ASSERT_NO_FATAL_FAILURE(program.do_something());
    ASSERT_NO_FATAL_FAILURE(space_oracle::expect_exact(program.triangulation(), program.points()));
  }
}
INSTANTIATE_TEST_SUITE_P(seeds, Found_program_in_space,
                         testing::Values(std::make_tuple(10134, 0.5, 134),
                                         std::make_tuple(10417, 0.25, 17),
                                         std::make_tuple(3142, 0.4, 25),
                                         std::make_tuple(100186, 0.25, 16)));

TEST(Random_program_in_space, of_an_exact_kernel_stays_exact)
{
  Program<CGAL::Dynamic_Delaunay_triangulation_3<Epeck>> program(5);
  program.insert(30);
  for (int i = 0; i < 20; ++i) {
    program.do_something();
    ASSERT_NO_FATAL_FAILURE(space_oracle::expect_exact(program.triangulation(), program.points()));
  }
}

TEST(Exact_points_in_space, may_move_by_less_than_doubles_tell)
{
  using Exact = CGAL::Dynamic_Delaunay_triangulation_3<Epeck>;
  using Exact_point = Exact::Point;
  const Epeck::FT third = Epeck::FT(1) / 3, little = Epeck::FT(1e-40);
  std::vector<Exact_point> points{
      {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {third, third, third}};
  Exact dt(points);
  EXPECT_EQ(dt.number_of_cells(), 1u + 2); // on the facet of the first four
  points[4] = Exact_point(third - little, third, third);
  dt.update(points);
  EXPECT_TRUE(dt.is_valid(true));
  EXPECT_EQ(dt.point(4), points[4]);
  EXPECT_EQ(dt.number_of_cells(), 4u);
}

// THE FILTER --------------------------------------------------------------------------------------

using Filter = CGAL::Dynamic_Delaunay_triangulations_3::internal::Cell_filter_in_lanes_3<double>;
using Vector = CGAL::Dynamic_Delaunay_triangulations_3::internal::Points_in_lanes_3<double>;

Vector vector_between(const Point& p, const Point& q)
{
  return {q.x() - p.x(), q.y() - p.y(), q.z() - p.z()};
}

// Five points that are nearly cospherical, the first four nearly coplanar in some trials, at any
// scale, some of them far from the origin.
std::array<Point, 5> nearly_degenerate_points(std::mt19937_64& random, bool is_flat)
{
  std::uniform_real_distribution<double> share(-1, 1);
  const double scale = std::ldexp(1.0, int(random() % 700) - 350);
  const double away = random() % 2 == 0 ? 0 : share(random) * 1e6;
  const double error = std::ldexp(1.0, -int(random() % 60));
  std::array<Point, 5> points;
  for (Point& p : points) {
    double x = share(random), y = share(random), z = share(random);
    const double length = std::sqrt(x * x + y * y + z * z);
    x = x / length + error * share(random);
    y = y / length + error * share(random);
    z = is_flat ? error * share(random) : z / length;
    p = Point(scale * (x + away), scale * (y + away), scale * (z + away));
  }
  return points;
}

TEST(Filter_in_space, claims_nothing_wrong)
{
  std::mt19937_64 random(1);
  const Epick::Orientation_3 orientation{};
  const Epick::Side_of_oriented_sphere_3 side{};
  std::size_t proved = 0;
  for (int trial = 0; trial < 200000; ++trial) {
    const auto [a, b, c, d, e] = nearly_degenerate_points(random, trial % 2 == 0);
    const Filter filter(vector_between(a, b), vector_between(a, c), vector_between(a, d));
    if (!filter.may_be_inverted()) {
      ++proved;
      ASSERT_EQ(orientation(a, b, c, d), CGAL::POSITIVE) << "trial " << trial;
    }
    if (!filter.may_be_inside(vector_between(a, e))) {
      ++proved;
      ASSERT_EQ(side(a, b, c, d, e), CGAL::ON_NEGATIVE_SIDE) << "trial " << trial;
    }
    const int claim = filter.side_of_sphere(vector_between(a, e));
    ASSERT_TRUE(claim == 0 || side(a, b, c, d, e) == claim) << "trial " << trial;
  }
  EXPECT_GT(proved, 50000u);
}

TEST(Filter_in_space, claims_nothing_where_numbers_underflow_or_overflow)
{
  for (const double scale : {1e-320, 1e-200, 1e-60, 1e60, 1e150, 1e300}) {
    const Vector b{scale, 0, 0}, c{0, scale, 0}, d{0, 0, scale}, e{scale, scale, scale};
    const Filter filter(b, c, d);
    EXPECT_TRUE(filter.may_be_inverted() || filter.may_be_inside(e)); // e is on the sphere
    EXPECT_EQ(filter.side_of_sphere(e), 0);
  }
}

TEST(Filter_in_space, proves_the_same_in_all_lanes)
{
  using namespace CGAL::Dynamic_Delaunay_triangulations_3;
  for (const std::size_t number : {5u, 6u, 7u, 8u, 500u}) {
    Points points = random_points(number);
    using Space = internal::Open_space_3<Epick, CGAL::Sequential_tag>;
    Space::State state;
    internal::Update_3<Space> update(state);
    internal::Change_3<Point> change;
    change.coming_points = points;
    state.ids.list_next_ids(number, change.coming);
    update.run(change);
    for (Vertex_index v(1); v <= number; v += 3) { // break something
      const Position_3 p = state.positions.position(v);
      state.positions.set(v, internal::Place_3<Point>(Position_3{p.x + 0.05, p.y, p.z}));
    }
    internal::Unproved_cells_3 unproved;
    internal::find_unproved(state, unproved);
    std::vector<Cell_index> expected;
    const auto at = [&](Vertex_index v) {
      const Position_3& p = state.positions.position(v);
      return Vector{p.x, p.y, p.z};
    };
    for (Cell_index c(0); c < state.arrays.number_of_cells(); ++c) {
      if (state.arrays.is_infinite(c))
        continue;
      const internal::Vertices_3& v = state.arrays.vertices(c);
      const Filter filter(at(v[1]) - at(v[0]), at(v[2]) - at(v[0]), at(v[3]) - at(v[0]));
      bool is_unproved = filter.may_be_inverted();
      for (int i = 0; i < 4; ++i)
        is_unproved =
            is_unproved ||
            filter.may_be_inside(at(state.arrays.apex(state.arrays.corner(c, i))) - at(v[0]));
      if (is_unproved)
        expected.push_back(c);
    }
    std::sort(unproved.finite.begin(), unproved.finite.end());
    EXPECT_EQ(unproved.finite, expected);
  }
}

// SOME POINTS MOVE --------------------------------------------------------------------------------

TEST(Some_points_in_space, move_while_others_stay)
{
  Points points = random_points(200);
  Dynamic dt(points);
  std::mt19937_64 random(1);
  for (int call = 0; call < 10; ++call) {
    std::vector<std::pair<int, Point>> movers;
    const Points targets = random_points(5, unsigned(call + 2));
    for (std::size_t id = random() % 40; id < 200; id += 40)
      movers.emplace_back(int(id), targets[movers.size()]);
    movers.back().second = points[42]; // they come to coincide, and part in a later call
    for (const auto& [id, point] : movers)
      points[std::size_t(id)] = point;
    EXPECT_FALSE(dt.move(movers.begin(), movers.end()).rebuilt());
    ASSERT_NO_FATAL_FAILURE(expect_exact(dt, points));
  }
  const std::vector<std::pair<int, Point>> nobody;
  EXPECT_TRUE(dt.move(nobody.begin(), nobody.end()).certified);
}

TEST(Coincident_points, move_together_and_apart)
{
  Points points = random_points(80);
  for (std::size_t place = 0; place < 20; ++place)
    points.insert(points.end(), 4, points[place]);
  Dynamic dt(points);
  std::mt19937_64 random(1);
  for (int call = 0; call < 60; ++call) {
    std::map<std::size_t, Point> movers; // up to 5, most of them from one place
    const Point here = points[random() % points.size()];
    for (std::size_t id = random() % 3; id < points.size() && movers.size() < 4; ++id)
      if (points[id] == here)
        movers[id] = points[random() % points.size()];
    movers[random() % points.size()] = here;
    for (const auto& [id, point] : movers)
      points[id] = point;
    EXPECT_FALSE(dt.move(movers.begin(), movers.end()).rebuilt());
    ASSERT_NO_FATAL_FAILURE(expect_exact(dt, points)) << "call " << call;
  }
}

TEST(Many_points_in_space, move_by_a_rebuild)
{
  const Points points = random_points(200), targets = random_points(200, 2);
  Dynamic dt(points);
  std::vector<std::pair<std::size_t, Point>> movers;
  for (std::size_t id = 0; id < 200; ++id)
    movers.emplace_back(id, targets[id]);
  EXPECT_EQ(dt.move(movers.begin(), movers.end()).rebuild_reason,
            CGAL::Rebuild_reason_2::POPULATION);
  ASSERT_NO_FATAL_FAILURE(expect_exact(dt, targets));
}

// IDS AND ERRORS ----------------------------------------------------------------------------------

TEST(Ids_in_space, are_reused_from_the_smallest_on)
{
  Dynamic dt(random_points(10));
  dt.remove({3, 7});
  EXPECT_FALSE(dt.has_id(3));
  EXPECT_EQ(dt.number_of_ids(), 10u);
  EXPECT_EQ(dt.insert(Point(2, 0, 0)), 3u);
  EXPECT_EQ(dt.insert(Point(3, 0, 0)), 7u);
  EXPECT_EQ(dt.insert(Point(4, 0, 0)), 10u);
  EXPECT_EQ(dt.point(7), Point(3, 0, 0));
}

template <class Error, class Call>
void expect_refused(const Call& call, const std::string& message)
{
  try {
    call();
    FAIL() << "nothing is thrown";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find(message), std::string::npos) << error.what();
  }
}

TEST(Wrong_input_in_space, is_refused_before_anything_changes)
{
  const Points points = random_points(20);
  Dynamic dt(points);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  Points wrong = points;
  wrong[7] = Point(1, nan, 2);
  expect_refused<CGAL::Non_finite_coordinate_error_3>(
      [&] { dt.update(wrong); }, "point 7 has the coordinates (1, nan, 2): all three must be");
  expect_refused<CGAL::Non_finite_coordinate_error_3>(
      [&] { dt.insert(wrong.begin(), wrong.end()); }, "point 27 has");
  expect_refused<CGAL::Non_finite_coordinate_error_3>([&] { dt.move(3, wrong[7]); }, "point 3 has");
  expect_refused<CGAL::Point_count_error_2>([&] { dt.update(Points(19)); }, "given are 19 entries");
  expect_refused<CGAL::Point_count_error_2>([&] { dt.update(std::list<Point>(21)); },
                                            "given are 21 or more");
  expect_refused<CGAL::Unknown_id_error_2>([&] { dt.remove(20); }, "no point with id 20");
  expect_refused<CGAL::Unknown_id_error_2>([&] { dt.move(20, points[0]); }, "no point with id 20");
  expect_refused<CGAL::Unknown_id_error_2>([&] { dt.point(20); }, "no point with id 20");
  using Movers = std::vector<std::pair<std::size_t, Point>>;
  const auto move = [&](const Movers& movers) { dt.move(movers.begin(), movers.end()); };
  expect_refused<CGAL::Non_finite_coordinate_error_3>(
      [&] {
        move({{1, points[2]}, {3, wrong[7]}});
      },
      "point 3 has");
  expect_refused<CGAL::Unknown_id_error_2>(
      [&] {
        move({{1, points[2]}, {20, points[3]}});
      },
      "no point with id 20");
  expect_refused<CGAL::Repeated_id_error_2>(
      [&] {
        move({{1, points[2]}, {1, points[3]}});
      },
      "1 is there more than");
  expect_refused<CGAL::Repeated_id_error_2>([&] { dt.remove({1, 2, 1}); }, "1 is there more than");
  ASSERT_NO_FATAL_FAILURE(expect_exact(dt, points));
}

TEST(Copies_in_space, go_on_alike)
{
  Points points = random_points(200);
  Dynamic dt(points);
  dt.remove({5});
  Dynamic copy(dt), assigned;
  assigned = copy;
  std::vector<std::vector<std::size_t>> cells(3);
  for (Point& p : points)
    p = Point(p.x() + 0.01 * p.y(), p.y(), p.z());
  Dynamic* const all[] = {&dt, &copy, &assigned};
  for (std::size_t i = 0; i < 3; ++i) {
    all[i]->update(points);
    all[i]->insert(Point(0.5, 0.5, 0.5));
    all[i]->for_each_cell(
        [&](const auto& ids) { cells[i].insert(cells[i].end(), ids.begin(), ids.end()); });
  }
  EXPECT_EQ(cells[1], cells[0]);
  EXPECT_EQ(cells[2], cells[0]);
  const Dynamic moved(std::move(copy));
  EXPECT_EQ(moved.number_of_points(), 200u);
  EXPECT_EQ(copy.number_of_points(), 0u); // it is empty, and can be used
  copy.insert(points.begin(), points.end());
  ASSERT_NO_FATAL_FAILURE(expect_exact(copy, points));
}

TEST(Copies_of_CGAL_in_space, have_the_same_cells_and_ids)
{
  using Triangulation = space_oracle::Fresh<Epick>;
  Points points = random_points(200);
  points.push_back(points[3]); // coincides
  for (const Points& some : {points, lattice(4), Points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}) {
    const Dynamic dt(some);
    Triangulation copy;
    copy.insert(Point(9, 9, 9)); // goes
    CGAL::convert_to_delaunay_triangulation_3(dt, copy);
    EXPECT_TRUE(copy.is_valid(false, 1));
    EXPECT_EQ(copy.number_of_vertices(), dt.number_of_vertices());
    std::set<space_oracle::Cell> cells;
    if (copy.dimension() == 3)
      for (const auto c : copy.finite_cell_handles())
        cells.insert(space_oracle::sorted(
            std::array<std::size_t, 4>{c->vertex(0)->info(), c->vertex(1)->info(),
                                       c->vertex(2)->info(), c->vertex(3)->info()}));
    EXPECT_EQ(cells, space_oracle::cells_of(dt));
    for (const auto v : copy.finite_vertex_handles())
      EXPECT_EQ(v->point(), dt.point(v->info()));
    copy.insert(Point(0.3, 0.3, 0.3)); // goes on as a triangulation of CGAL
    EXPECT_TRUE(copy.is_valid());
  }
}

// ACCESS ------------------------------------------------------------------------------------------

TEST(Neighbors_in_space, are_the_ends_of_edges)
{
  for (const Points& points : {random_points(100), Points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}) {
    const Dynamic dt(points);
    std::set<std::pair<std::size_t, std::size_t>> edges, found;
    dt.for_each_edge([&](std::size_t i, std::size_t j) {
      edges.emplace(i, j);
      edges.emplace(j, i);
    });
    for (std::size_t i = 0; i < points.size(); ++i)
      dt.for_each_neighbor(i, [&](std::size_t j) { found.emplace(i, j); });
    EXPECT_EQ(found, edges);
  }
}

} // namespace test_space

// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The static engines, for the whole and for regions, on points of every kind; and the parts that
// they are made of: the spatial order, the filtered predicates, divide and conquer.

#include "oracle.h"
#include "stamps.h"

#include <CGAL/Dynamic_Delaunay_triangulation_2/classifiers/Nearly_delaunay_classifier_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/classifiers/Random_classifier_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Spatial_order_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/static/Guibas_stolfi_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/repairs/Border_splice_repair_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/repairs/Rebuild_repair_2.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <iterator>
#include <limits>
#include <map>
#include <numeric>
#include <set>
#include <sstream>
#include <utility>

namespace {

namespace internal = CGAL::Dynamic_Delaunay_triangulations_2::internal;
using CGAL::Border_splice_repair_2;
using CGAL::Circumcircle_classifier_2;
using CGAL::Random_classifier_2;
using CGAL::Static_engine_2;
using CGAL::Static_engines_2;
using CGAL::Dynamic_Delaunay_triangulations_2::Face_index;
using CGAL::Dynamic_Delaunay_triangulations_2::Index;
using CGAL::Dynamic_Delaunay_triangulations_2::Vertex_index;
using CGAL::Dynamic_Delaunay_triangulations_2::Position_2;
using Points = Cloud<Epick>::Points;

constexpr Static_engine_2 all_engines[] = {
    Static_engine_2::GUIBAS_STOLFI, Static_engine_2::INSERTION, Static_engine_2::BOWYER_WATSON};

std::string name_of(Static_engine_2 engine)
{
  switch (engine) {
  case Static_engine_2::GUIBAS_STOLFI:
    return "guibas_stolfi";
  case Static_engine_2::INSERTION:
    return "insertion";
  default:
    return "bowyer_watson";
  }
}

// POINTS ------------------------------------------------------------------------------------------

double uniform(std::mt19937& random, double low = 0, double high = 1)
{
  return std::uniform_real_distribution<double>(low, high)(random);
}

template <class Make>
Points made(std::size_t n, Make make)
{
  Points points;
  for (std::size_t i = 0; i < n; ++i)
    points.push_back(make(i));
  return points;
}

Points joined(Points first, const Points& second)
{
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

Points hexagonal(std::size_t columns, std::size_t rows)
{
  return made(columns * rows, [&](std::size_t k) {
    const std::size_t row = k / columns;
    return Epick::Point_2(double(k % columns) + 0.5 * double(row % 2),
                          double(row) * std::sqrt(3.) / 2);
  });
}

// n points on the line through the origin, in an order of their own.
Points on_line(std::size_t n, double dx, double dy)
{
  return made(n, [&](std::size_t k) {
    const double t = double(37 * k % n); // each once, if n has no factor in common with 37
    return Epick::Point_2(t * dx, t * dy);
  });
}

// Points whose distances from the center are equally likely on a logarithmic scale.
Points towards_center(std::size_t n, std::mt19937& random)
{
  return made(n, [&](std::size_t) {
    const double r = std::exp(-30 * uniform(random)), angle = uniform(random, 0, 6.3);
    return Epick::Point_2(r * std::cos(angle), r * std::sin(angle));
  });
}

Points clumps(std::size_t n, double spread, std::mt19937& random)
{
  return made(n, [&](std::size_t k) {
    const double x = double(k * k % 7), y = double(k % 7);
    const double dx = spread * uniform(random);
    return Epick::Point_2(x + dx, y + spread * uniform(random));
  });
}

double of_any_magnitude(std::mt19937& random, double exponents)
{
  return std::ldexp(uniform(random, -1, 1), -int(exponents * uniform(random)));
}

Points of_all_magnitudes(std::size_t n, double exponents, std::mt19937& random)
{
  return made(n, [&](std::size_t) {
    const double x = of_any_magnitude(random, exponents);
    return Epick::Point_2(x, of_any_magnitude(random, exponents));
  });
}

// Multiples of `unit` from -bound to bound.
Points on_lattice(std::size_t n, int bound, double unit, std::mt19937& random)
{
  std::uniform_int_distribution<int> number(-bound, bound);
  return made(n, [&](std::size_t) {
    const int x = number(random);
    return Epick::Point_2(x * unit, number(random) * unit);
  });
}

using Named_points = std::map<std::string, Points>;

// Regular point sets, in the orders in which programs are likely to give them.
Named_points regular_points()
{
  const auto circle = Cloud<Epick>::on_circle(36);
  return {
      {"square grid", Cloud<Epick>::grid(31, 29)},
      {"turned square grid", made(900,
                                  [](std::size_t k) {
                                    const int i = int(k % 30), j = int(k / 30);
                                    return Epick::Point_2(3 * i - 4 * j, 4 * i + 3 * j);
                                  })},
      {"square grid off the doubles", scaled<Epick>(Cloud<Epick>::grid(25, 25), 0.1, 0.3)},
      {"square grid of powers of two", Cloud<Epick>::grid(32, 32)},
      {"hexagonal lattice", hexagonal(30, 30)},
      {"two rows", Cloud<Epick>::grid(200, 2)},
      {"two columns", Cloud<Epick>::grid(2, 200)},
      {"horizontal line", on_line(101, 1, 0)},
      {"vertical line", on_line(101, 0, 1)},
      {"diagonal line", on_line(101, 1, 1)},
      {"falling line", on_line(101, 2, -3)},
      {"line with rounding", on_line(301, 0.1, 0.3)},
      {"steep line with rounding", on_line(301, 1e-3 / 7, 1. / 3)},
      {"line and a point", joined({Epick::Point_2(31.5, 31.25)}, on_line(101, 1, 1))},
      {"line between two points",
       joined({Epick::Point_2(-5, 50), Epick::Point_2(5, 50)}, on_line(101, 0, 1))},
      {"circle", circle},
      {"circle and its center", joined({Epick::Point_2(0, 0)}, circle)},
      {"circles around each other",
       joined(joined(circle, scaled<Epick>(circle, 2)), scaled<Epick>(circle, 3))},
      {"circle and a grid", joined(circle, scaled<Epick>(Cloud<Epick>::grid(9, 9), 16, -64))},
  };
}

Named_points uneven_points()
{
  std::mt19937 random(1);
  const Points cloud = Cloud<Epick>(2).uniform(400);
  const Points grid = Cloud<Epick>::grid(20, 20);
  const double tiniest = std::numeric_limits<double>::denorm_min();
  return {
      {"denser and denser", towards_center(600, random)},
      {"clumps", clumps(700, 1e-9, random)},
      {"clumps of a few doubles", clumps(500, 1e-15, random)},
      {"cloud and an outlier", joined({Epick::Point_2(1e12, -1e9)}, cloud)},
      {"cloud and an outlier far beyond", joined({Epick::Point_2(-1e200, 1e190)}, cloud)},
      {"many magnitudes", of_all_magnitudes(500, 100, random)},
      {"all magnitudes", of_all_magnitudes(500, 1000, random)},
      {"all magnitudes below the normal ones", of_all_magnitudes(300, 1074, random)},
      {"wide", scaled<Epick>(cloud, 1e150)},
      {"so wide that determinants overflow", scaled<Epick>(cloud, 1e76)},
      {"as wide as can be", scaled<Epick>(cloud, 8e306)},
      {"wider than the largest number", made(200,
                                             [&](std::size_t) {
                                               const double x = 1.7e308 * uniform(random, -1, 1);
                                               return Epick::Point_2(x, 1.7e308 *
                                                                            uniform(random, -1, 1));
                                             })},
      {"narrow", scaled<Epick>(cloud, 1e-150)},
      {"very narrow", scaled<Epick>(cloud, 1e-306)},
      {"grid of subnormals", scaled<Epick>(grid, tiniest)},
      {"subnormal differences", on_lattice(400, 1000, tiniest, random)},
      {"subnormal differences between normal numbers",
       joined(on_lattice(200, 20, tiniest, random), on_lattice(200, 20, 1, random))},
      {"far away", scaled<Epick>(cloud, 1e-7, 1e9)},
      {"grid far away", scaled<Epick>(grid, 0x1p-23, 1e9)},
      {"far away, on few doubles", scaled<Epick>(cloud, 1e-6, 1e9)},
      {"zeros of both signs", {{0., 0.}, {-0., 0.}, {1., -0.}, {0., 1.}, {-0., -0.}, {1., 1.}}},
  };
}

// TRIANGULATIONS ----------------------------------------------------------------------------------

template <class Kernel>
using Spliced = CGAL::Dynamic_Delaunay_triangulation_2<Kernel, Random_classifier_2>;

template <class Kernel>
using Exact = CGAL::Dynamic_Delaunay_triangulation_2<Kernel>;

template <class Kernel>
Exact<Kernel> triangulated(const std::vector<typename Kernel::Point_2>& points,
                           const Static_engines_2& engines)
{
  typename Exact<Kernel>::Settings settings;
  settings.engines = engines;
  return Exact<Kernel>(points.begin(), points.end(), settings);
}

template <class Kernel>
void expect_exact_as_a_whole(Static_engine_2 engine,
                             const std::vector<typename Kernel::Point_2>& points)
{
  expect_exact(triangulated<Kernel>(points, {engine, engine}), points);
}

// Triangulates regions anew while no point moves: the result must be exact after each frame.
// Returns the number of splices.
template <class Kernel>
std::size_t expect_exact_by_regions(Static_engine_2 engine,
                                    const std::vector<typename Kernel::Point_2>& points,
                                    double share = 0.01)
{
  typename Spliced<Kernel>::Settings settings{Random_classifier_2(share, 3)};
  settings.engines = {Static_engine_2::INSERTION, engine};
  Spliced<Kernel> dt(points.begin(), points.end(), settings);
  std::size_t splices = 0;
  for (int frame = 0; frame < 3; ++frame) {
    splices += dt.update(points.begin(), points.end()).splices;
    EXPECT_TRUE(dt.certify());
  }
  expect_exact(dt, points);
  return splices;
}

// Vertices exchange their places with neighbors, there and back.
void expect_exact_after_exchanges(Static_engine_2 engine, const Points& points)
{
  using Dynamic =
      CGAL::Dynamic_Delaunay_triangulation_2<Epick, Circumcircle_classifier_2,
                                             CGAL::With_repair_2<Border_splice_repair_2>>;
  Dynamic::Settings settings;
  settings.engines = {Static_engine_2::INSERTION, engine};
  Dynamic dt(points.begin(), points.end(), settings);
  Points exchanged = points;
  std::size_t edges = 0;
  dt.for_each_edge([&](std::size_t i, std::size_t j) {
    if (edges++ % 200 == 0)
      std::swap(exchanged[i], exchanged[j]);
  });
  dt.update(exchanged.begin(), exchanged.end());
  ASSERT_NO_FATAL_FAILURE(expect_exact(dt, exchanged));
  dt.update(points.begin(), points.end());
  ASSERT_NO_FATAL_FAILURE(expect_exact(dt, points));
}

class Static_engines : public testing::TestWithParam<Static_engine_2>
{
protected:
  template <class Kernel>
  void expect_exact_in_all_ways(const std::vector<typename Kernel::Point_2>& points) const
  {
    ASSERT_NO_FATAL_FAILURE(expect_exact_as_a_whole<Kernel>(GetParam(), points));
    ASSERT_NO_FATAL_FAILURE(expect_exact_by_regions<Kernel>(GetParam(), points));
    if constexpr (std::is_same_v<Kernel, Epick>)
      expect_exact_after_exchanges(GetParam(), points);
  }
};

INSTANTIATE_TEST_SUITE_P(All, Static_engines, testing::ValuesIn(all_engines),
                         [](const auto& engine) { return name_of(engine.param); });

TEST_P(Static_engines, triangulate_clouds_of_any_size)
{
  for (const unsigned n : {0u, 1u, 2u, 3u, 4u, 5u, 8u, 20u, 1000u, 20000u}) {
    SCOPED_TRACE(n);
    const auto points = Cloud<Epick>(n).uniform(n);
    ASSERT_NO_FATAL_FAILURE(expect_exact_as_a_whole<Epick>(GetParam(), points));
    const std::size_t splices = expect_exact_by_regions<Epick>(GetParam(), points);
    EXPECT_EQ(splices, n >= 1000 ? 3u : 0u);
  }
}

TEST_P(Static_engines, triangulate_many_small_clouds)
{
  for (unsigned seed = 0; seed < 300; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    const auto points = Cloud<Epick>(seed).uniform(3 + seed % 30);
    ASSERT_NO_FATAL_FAILURE(expect_exact_as_a_whole<Epick>(GetParam(), points));
  }
}

TEST_P(Static_engines, triangulate_few_points_in_any_position)
{
  std::mt19937 random(1);
  for (unsigned i = 0; i < 600; ++i) {
    const Points points = on_lattice(1 + i % 12, 1 + int(i % 3), 1, random);
    SCOPED_TRACE(testing::PrintToString(points));
    ASSERT_NO_FATAL_FAILURE(expect_exact_as_a_whole<Epick>(GetParam(), points));
  }
}

TEST_P(Static_engines, triangulate_regular_points_and_those_of_any_density_and_magnitude)
{
  for (const Named_points& all : {regular_points(), uneven_points()})
    for (const auto& [name, points] : all) {
      SCOPED_TRACE(name);
      ASSERT_NO_FATAL_FAILURE(expect_exact_in_all_ways<Epick>(points));
    }
}

TEST_P(Static_engines, do_splice_regions_of_hard_points)
{
  const Points grid = Cloud<Epick>::grid(40, 40);
  EXPECT_GT(expect_exact_by_regions<Epick>(GetParam(), grid, 0.001), 0u);
  std::mt19937 random(1);
  EXPECT_GT(expect_exact_by_regions<Epick>(GetParam(), towards_center(1000, random)), 0u);
  EXPECT_GT(expect_exact_by_regions<Epick>(GetParam(), of_all_magnitudes(1000, 100, random)), 0u);
}

TEST_P(Static_engines, work_with_exact_constructions)
{
  for (const unsigned n : {0u, 1u, 2u, 3u, 8u, 400u}) {
    SCOPED_TRACE(n);
    ASSERT_NO_FATAL_FAILURE(expect_exact_in_all_ways<Epeck>(Cloud<Epeck>(n).uniform(n)));
  }
  ASSERT_NO_FATAL_FAILURE(expect_exact_as_a_whole<Epeck>(GetParam(), Cloud<Epeck>::grid(15, 15)));
  ASSERT_NO_FATAL_FAILURE(expect_exact_as_a_whole<Epeck>(GetParam(), Cloud<Epeck>(1).on_line(30)));
}

// Such points are ordered by comparisons instead of cells of the curve.
TEST_P(Static_engines, work_where_coordinates_are_no_doubles)
{
  using Number = Epeck::FT;
  for (const int bound : {1, 2, 5, 40}) {
    SCOPED_TRACE(bound);
    Cloud<Epeck> cloud{unsigned(bound)};
    std::uniform_int_distribution<int> number(-bound, bound);
    const auto make = [&] {
      std::vector<Epeck::Point_2> points;
      for (int i = 0; i < 150; ++i) {
        const Number x = Number(number(cloud.random())) / 3;
        points.emplace_back(x, Number(number(cloud.random())) / 7);
      }
      return points;
    };
    auto points = make();
    ASSERT_NO_FATAL_FAILURE(expect_exact_in_all_ways<Epeck>(points));
    auto dt = triangulated<Epeck>(points, {GetParam(), GetParam()});
    for (int frame = 0; frame < 3; ++frame) { // doubles in between
      points = frame == 1 ? cloud.uniform(150) : make();
      dt.update(points.begin(), points.end());
      ASSERT_NO_FATAL_FAILURE(expect_exact(dt, points));
    }
  }
}

// Different points that are rounded to the same doubles.
TEST_P(Static_engines, tell_points_apart_that_no_double_does)
{
  std::vector<Epeck::Point_2> points;
  for (int i = 0; i < 40; ++i)
    points.emplace_back(Epeck::FT(1) + Epeck::FT(i % 7) * std::ldexp(1, -200),
                        Epeck::FT(2) / 3 + Epeck::FT(i / 7) * std::ldexp(1, -300));
  ASSERT_NO_FATAL_FAILURE(expect_exact_in_all_ways<Epeck>(points));
}

using Edges = std::set<std::pair<Epick::Point_2, Epick::Point_2>>;

template <class Dynamic>
Edges edges_of(const Dynamic& dt)
{
  Edges edges;
  dt.for_each_edge(
      [&](std::size_t i, std::size_t j) { edges.insert(std::minmax(dt.point(i), dt.point(j))); });
  return edges;
}

TEST_P(Static_engines, give_the_same_edges_in_whatever_order_the_points_come)
{
  const auto edges_with = [](Static_engine_2 engine, const Points& points) {
    return edges_of(triangulated<Epick>(points, {engine, engine}));
  };
  std::mt19937 random(5);
  for (Points points : {Cloud<Epick>(1).uniform(1500), towards_center(1500, random)}) {
    const Edges edges = edges_with(Static_engine_2::INSERTION, points);
    for (int i = 0; i < 5; ++i) {
      std::shuffle(points.begin(), points.end(), random);
      EXPECT_EQ(edges_with(GetParam(), points), edges);
    }
  }
}

// COINCIDENCE -------------------------------------------------------------------------------------

// The id of the representative of each point.
template <class Dynamic>
std::vector<std::size_t> representatives_of(const Dynamic& dt)
{
  std::vector<std::size_t> representatives(dt.number_of_points());
  for (std::size_t id = 0; id < representatives.size(); ++id)
    representatives[id] = dt.id(dt.vertex(id));
  return representatives;
}

template <class Dynamic>
std::vector<std::size_t> stamps_of_all(const Dynamic& dt)
{
  std::vector<std::size_t> stamps;
  for (std::size_t id = 0; id < dt.number_of_points(); ++id)
    stamps.push_back(stamp_of(dt, id));
  return stamps;
}

// Expects that each representative was one before and has kept its vertex, unless none of the
// points at its place was one.
template <class Dynamic>
void expect_representatives_stay(const Dynamic& dt,
                                 const std::vector<std::size_t>& old_representatives,
                                 const std::vector<std::size_t>& old_stamps)
{
  const auto representatives = representatives_of(dt);
  for (std::size_t id = 0; id < representatives.size(); ++id) {
    ASSERT_EQ(representatives[representatives[id]], representatives[id]);
    ASSERT_EQ(dt.point(representatives[id]), dt.point(id));
    const bool was_representative = old_representatives[representatives[id]] == representatives[id];
    ASSERT_TRUE(was_representative || old_representatives[id] != id)
        << "id " << id << " had to make way for " << representatives[id];
    ASSERT_TRUE(!was_representative ||
                stamp_of(dt, representatives[id]) == old_stamps[representatives[id]])
        << "id " << representatives[id] << " has lost its vertex";
  }
}

TEST_P(Static_engines, keep_the_representatives_of_coincident_points_through_rebuilds)
{
  using Dynamic = CGAL::Dynamic_Delaunay_triangulation_2<
      Epick, Circumcircle_classifier_2, CGAL::With_repair_2<CGAL::Rebuild_repair_2>,
      CGAL::With_data_structure_2<Stamped_data_structure<Epick>>>;
  std::mt19937 random(7);
  for (const int bound : {0, 1, 2, 4, 12}) {
    SCOPED_TRACE(bound);
    Points points = on_lattice(80, bound, 1, random);
    Dynamic::Settings settings;
    settings.engines = {GetParam(), GetParam()};
    Dynamic dt(points.begin(), points.end(), settings);
    ASSERT_NO_FATAL_FAILURE(expect_exact(dt, points));
    for (int frame = 0; frame < 20; ++frame) {
      const auto representatives = representatives_of(dt);
      const auto stamps = stamps_of_all(dt);
      const Points others = on_lattice(80, bound, 1, random);
      for (std::size_t id = 0; id < points.size(); ++id)
        if (frame % 3 != 0 || id % 4 == 0) // all, or some
          points[id] = others[id];
      dt.update(points.begin(), points.end());
      ASSERT_NO_FATAL_FAILURE(expect_exact(dt, points));
      ASSERT_NO_FATAL_FAILURE(expect_representatives_stay(dt, representatives, stamps));
    }
  }
}

// An order from which duplicates have been removed has adjacent cuts of equal rank.
TEST_P(Static_engines, triangulate_points_most_of_which_coincide)
{
  std::mt19937 random(8);
  for (int i = 0; i < 60; ++i) {
    SCOPED_TRACE(i);
    const Points places = on_lattice(5 + std::size_t(i) % 20, 3, 1, random);
    const Points points = made(300, [&](std::size_t) { return places[random() % places.size()]; });
    ASSERT_NO_FATAL_FAILURE(expect_exact_as_a_whole<Epick>(GetParam(), points));
  }
}

// MOTION ------------------------------------------------------------------------------------------

class Engine_pairs : public testing::TestWithParam<std::pair<Static_engine_2, Static_engine_2>>
{
protected:
  Static_engines_2 engines() const { return {GetParam().first, GetParam().second}; }
};

std::vector<std::pair<Static_engine_2, Static_engine_2>> all_pairs()
{
  std::vector<std::pair<Static_engine_2, Static_engine_2>> pairs;
  for (const Static_engine_2 whole : all_engines)
    for (const Static_engine_2 region : all_engines)
      pairs.emplace_back(whole, region);
  return pairs;
}

INSTANTIATE_TEST_SUITE_P(All, Engine_pairs, testing::ValuesIn(all_pairs()), [](const auto& pair) {
  return name_of(pair.param.first) + "_and_" + name_of(pair.param.second);
});

struct Work_done
{
  std::size_t splices = 0, enlargements = 0, rebuilds = 0;
};

// Each point takes a random step, and one in 50 jumps anywhere.
template <class Repair>
Work_done follow(const Static_engines_2& engines, double step, bool with_jumps)
{
  Cloud<Epick> cloud(9);
  Points points = cloud.uniform(500);
  using Dynamic = CGAL::Dynamic_Delaunay_triangulation_2<Epick, Circumcircle_classifier_2,
                                                         CGAL::With_repair_2<Repair>>;
  typename Dynamic::Settings settings;
  settings.engines = engines;
  Dynamic dt(points.begin(), points.end(), settings);
  Work_done done;
  for (int frame = 0; frame < 8; ++frame) {
    cloud.shake(points, step);
    const Points others = cloud.uniform(500);
    for (std::size_t id = std::size_t(frame); with_jumps && id < points.size(); id += 50)
      points[id] = others[id];
    const auto report = dt.update(points.begin(), points.end());
    done.splices += report.splices;
    done.enlargements += report.enlargements;
    done.rebuilds += report.rebuilt();
    expect_exact(dt, points);
  }
  return done;
}

TEST_P(Engine_pairs, stay_exact_on_brownian_motion)
{
  for (const double step : {0.05, 0.2}) {
    SCOPED_TRACE(step);
    follow<CGAL::Hold_and_flip_repair_2>(engines(), step, false);
    follow<Border_splice_repair_2>(engines(), step, false);
    follow<CGAL::Rebuild_repair_2>(engines(), step, false);
  }
}

TEST_P(Engine_pairs, stay_exact_when_points_jump)
{
  const Work_done jumps = follow<Border_splice_repair_2>(engines(), 0.001, true);
  EXPECT_GT(jumps.splices + jumps.rebuilds, 0u);
  follow<CGAL::Hold_and_flip_repair_2>(engines(), 0.001, true);
  follow<CGAL::Hold_and_flip_repair_2>(engines(), 0.05, true);
}

TEST_P(Engine_pairs, stay_exact_when_one_point_crosses_many_others)
{
  Points points = Cloud<Epick>::grid(24, 24);
  using Dynamic =
      CGAL::Dynamic_Delaunay_triangulation_2<Epick, Circumcircle_classifier_2,
                                             CGAL::With_repair_2<Border_splice_repair_2>>;
  Dynamic::Settings settings;
  settings.engines = engines();
  Dynamic dt(points.begin(), points.end(), settings);
  std::size_t splices = 0;
  for (int frame = 0; frame < 5; ++frame) { // onto lines of the grid, and between them
    points[250] = Epick::Point_2(3 + 2.5 * frame, 12 + 0.25 * frame);
    splices += dt.update(points.begin(), points.end()).splices;
    ASSERT_NO_FATAL_FAILURE(expect_exact(dt, points));
  }
  EXPECT_GT(splices, 0u);
}

TEST_P(Engine_pairs, stay_exact_when_all_points_leave_their_places)
{
  Cloud<Epick> cloud(10);
  Points points = cloud.uniform(300);
  auto dt = triangulated<Epick>(points, engines());
  for (int frame = 0; frame < 8; ++frame) {
    points = frame % 4 == 3 ? cloud.on_line(300) : cloud.uniform(300); // and meet on a line
    dt.update(points.begin(), points.end());
    ASSERT_NO_FATAL_FAILURE(expect_exact(dt, points));
  }
}

// FILTERS -----------------------------------------------------------------------------------------

TEST(Filtered_predicates, decide_random_points_nearly_always)
{
  std::mt19937 random(1);
  int decided = 0;
  for (int i = 0; i < 1000; ++i) {
    std::array<Position_2, 4> q;
    for (Position_2& p : q)
      p = {uniform(random), uniform(random)};
    decided += internal::filtered_orientation(q[0], q[1], q[2]) != 0 &&
               internal::filtered_in_circle(q[0], q[1], q[2], q[3]) != 0;
  }
  EXPECT_GT(decided, 995);
}

TEST(Filtered_predicates, certify_nothing_false_where_a_term_overflows)
{
  for (unsigned seed = 0; seed < 300; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Cloud<Epick> cloud(seed);
    Points points = scaled<Epick>(cloud.uniform(9), 0.8e77, -1.2e77);
    auto dt = triangulated<Epick>(points, {});
    ASSERT_NO_FATAL_FAILURE(expect_exact(dt, points));
    cloud.shake(points, 1e76);
    dt.update(points.begin(), points.end());
    ASSERT_NO_FATAL_FAILURE(expect_exact(dt, points));
  }
}

// The bound is a product of six lengths; where it is out of range, all broken edges are picked.
TEST(Filtered_predicates, let_nearly_delaunay_pick_edges_of_any_length)
{
  const Points points = Cloud<Epick>(13).uniform(300);
  Points moved = points;
  Cloud<Epick>(14).shake(moved, 0.05);
  const auto classified = [&](double factor) {
    const Points first = scaled<Epick>(points, factor), second = scaled<Epick>(moved, factor);
    CGAL::Dynamic_Delaunay_triangulation_2<Epick, CGAL::Nearly_delaunay_classifier_2> dt(
        first.begin(), first.end());
    return dt.update(second.begin(), second.end()).classified;
  };
  EXPECT_GT(classified(1), 0u);
  for (const double factor : {0x1p180, 0x1p250, 0x1p-180, 0x1p-250})
    EXPECT_GE(classified(factor), classified(1));
}

// SPATIAL ORDER -----------------------------------------------------------------------------------

using Positions = std::vector<Position_2>;

// Positions by the indices of vertices; index 0 is not used.
Positions positions_of(const Points& points)
{
  Positions positions(1, Position_2{0, 0});
  for (const auto& p : points)
    positions.push_back(Position_2{p.x(), p.y()});
  return positions;
}

std::vector<Index> vertices_of(const Positions& positions)
{
  std::vector<Index> vertices(positions.size() - 1);
  std::iota(vertices.begin(), vertices.end(), Index(1));
  return vertices;
}

internal::Spatial_order_2 spatial_order(const Positions& positions)
{
  const auto vertices = vertices_of(positions);
  internal::Spatial_order_2 order;
  order.sort(positions, vertices.begin(), vertices.end());
  return order;
}

bool is_less_xy(const Position_2& p, const Position_2& q)
{
  return p.x != q.x ? p.x < q.x : p.y < q.y;
}

bool coincide(const Position_2& p, const Position_2& q)
{
  return p.x == q.x && p.y == q.y;
}

// The i-th cut with the two stretches of the order on its sides.
struct Parted_stretches
{
  Parted_stretches(const internal::Spatial_order_2& order, const Positions& positions,
                   std::size_t i)
    : cut(order.cut(i))
  {
    std::size_t first = i - 1, beyond = i + 1;
    while (first > 0 && order.cut(first).rank <= cut.rank)
      --first;
    while (beyond < order.size() && order.cut(beyond).rank <= cut.rank)
      ++beyond;
    for (std::size_t k = first; k < beyond; ++k)
      ((k < i) != cut.is_descending ? low : high).push_back(positions[order[k]]);
  }

  bool are_parted() const
  {
    const auto coordinate = [this](const Position_2& p) { return cut.is_horizontal ? p.y : p.x; };
    const auto is_less = [&](const Position_2& p, const Position_2& q) {
      return coordinate(p) < coordinate(q);
    };
    return is_less(*std::max_element(low.begin(), low.end(), is_less),
                   *std::min_element(high.begin(), high.end(), is_less));
  }

  // Coincident points may stand on both sides.
  bool are_parted_lexicographically() const
  {
    return !cut.is_horizontal && !cut.is_descending &&
           !is_less_xy(*std::min_element(high.begin(), high.end(), is_less_xy),
                       *std::max_element(low.begin(), low.end(), is_less_xy));
  }

  internal::Cut_2 cut;
  Positions low, high;
};

void expect_sound(const internal::Spatial_order_2& order, const Positions& positions)
{
  std::vector<Index> members;
  for (std::size_t i = 0; i < order.size(); ++i)
    members.push_back(order[i]);
  std::sort(members.begin(), members.end());
  ASSERT_EQ(members, vertices_of(positions)) << "no permutation";
  for (std::size_t i = 1; i < order.size(); ++i) {
    const Parted_stretches stretches(order, positions, i);
    ASSERT_TRUE(stretches.are_parted() || stretches.are_parted_lexicographically())
        << "cut " << i << " of rank " << stretches.cut.rank;
  }
  std::set<std::pair<double, double>> places;
  for (std::size_t i = 0; i < order.size(); ++i) {
    const Position_2& p = positions[order[i]];
    const bool is_new = places.emplace(p.x, p.y).second;
    ASSERT_EQ(is_new, i == 0 || !coincide(p, positions[order[i - 1]])) << "place " << i;
  }
}

TEST(Spatial_order, has_cuts_that_part_what_they_say)
{
  std::mt19937 random(1);
  for (const unsigned n : {0u, 1u, 2u, 3u, 8u, 9u, 100u, 3000u}) {
    SCOPED_TRACE(n);
    const Positions positions = positions_of(Cloud<Epick>(n).uniform(n));
    ASSERT_NO_FATAL_FAILURE(expect_sound(spatial_order(positions), positions));
  }
  for (const auto& set : {regular_points(), uneven_points()})
    for (const auto& [name, points] : set) {
      SCOPED_TRACE(name);
      const Positions positions = positions_of(points);
      ASSERT_NO_FATAL_FAILURE(expect_sound(spatial_order(positions), positions));
    }
}

TEST(Spatial_order, brings_coincident_points_together)
{
  std::mt19937 random(2);
  for (const int bound : {0, 1, 3, 20}) {
    const Positions positions = positions_of(on_lattice(500, bound, 0.1, random));
    ASSERT_NO_FATAL_FAILURE(expect_sound(spatial_order(positions), positions));
  }
}

TEST(Spatial_order, by_comparisons_has_sound_cuts_as_well)
{
  std::mt19937 random(3);
  for (const int bound : {0, 2, 10, 1000}) {
    const Positions positions = positions_of(on_lattice(300, bound, 1, random));
    const auto vertices = vertices_of(positions);
    internal::Spatial_order_2 order;
    order.sort_by_comparisons(vertices.begin(), vertices.end(), [&](Index v, Index w) {
      return is_less_xy(positions[v], positions[w]);
    });
    ASSERT_NO_FATAL_FAILURE(expect_sound(order, positions));
  }
}

TEST(Spatial_order, keeps_the_cuts_between_what_is_left_when_coincident_points_merge)
{
  std::mt19937 random(4);
  for (const int bound : {0, 1, 3, 8, 20}) {
    const Positions positions = positions_of(on_lattice(400, bound, 1, random));
    internal::Spatial_order_2 order = spatial_order(positions);
    Positions kept(1, Position_2{0, 0});
    order.merge_coincident([&](Index v, Index w) { return coincide(positions[v], positions[w]); },
                           [&](std::size_t first, std::size_t) {
                             kept.push_back(positions[order[first]]);
                             return Index(kept.size() - 1);
                           });
    ASSERT_NO_FATAL_FAILURE(expect_sound(order, kept));
    for (std::size_t i = 0; i < order.size(); ++i)
      EXPECT_EQ(order[i], i + 1);
  }
}

// THE CURVE ---------------------------------------------------------------------------------------

const internal::Hilbert_curve_2 curve;

struct Cell
{
  std::uint32_t x, y;
};

bool are_neighbors(const Cell& c, const Cell& d)
{
  const auto distance = [](std::uint32_t i, std::uint32_t j) { return i < j ? j - i : i - j; };
  return distance(c.x, d.x) + distance(c.y, d.y) == 1;
}

// The cells of a square along the curve, each `unit` cells wide, by their places in `unit`^2.
std::map<std::uint32_t, Cell> cells_along_curve(Cell corner, std::uint32_t width,
                                                std::uint32_t unit)
{
  std::map<std::uint32_t, Cell> cells;
  for (std::uint32_t x = 0; x < width; ++x)
    for (std::uint32_t y = 0; y < width; ++y)
      cells[curve.place(corner.x + x * unit, corner.y + y * unit) / (unit * unit)] =
          Cell{corner.x / unit + x, corner.y / unit + y};
  return cells;
}

// The corner of a square, a multiple of its width.
Cell random_corner(std::uint32_t width, std::mt19937& random)
{
  const auto coordinate = [&] { return std::uint32_t(random() % (65536 / width)) * width; };
  const std::uint32_t x = coordinate();
  return {x, coordinate()};
}

// A square whose corner is a multiple of its width holds one stretch of the curve.
TEST(Hilbert_curve, goes_from_neighbor_to_neighbor_through_every_cell)
{
  constexpr std::uint32_t width = 128;
  std::mt19937 random(1);
  for (const std::uint32_t unit : {1u, 2u, 16u, 512u})
    for (int i = 0; i < 4; ++i) {
      const auto cells = cells_along_curve(random_corner(width * unit, random), width, unit);
      ASSERT_EQ(cells.size(), width * width);
      ASSERT_EQ(cells.rbegin()->first - cells.begin()->first + 1, width * width);
      for (auto cell = cells.begin(), next = std::next(cell); next != cells.end(); ++cell, ++next)
        ASSERT_TRUE(are_neighbors(cell->second, next->second)) << "place " << cell->first;
    }
}

TEST(Hilbert_curve, ends_where_it_says)
{
  EXPECT_EQ(curve.place(0, 0), 0u);
  EXPECT_EQ(curve.place(65535, 0), 0xffffffffu);
}

using Cells = std::vector<Cell>;

// The cut along the only axis-parallel line between both sets.
internal::Cut_2 cut_between(const Cells& before, const Cells& after)
{
  const auto ends_below = [](const Cells& low, const Cells& high, std::uint32_t Cell::*coordinate) {
    const auto is_less = [&](const Cell& c, const Cell& d) {
      return c.*coordinate < d.*coordinate;
    };
    return (*std::max_element(low.begin(), low.end(), is_less)).*coordinate <
           (*std::min_element(high.begin(), high.end(), is_less)).*coordinate;
  };
  const bool is_horizontal =
      ends_below(before, after, &Cell::y) || ends_below(after, before, &Cell::y);
  const auto coordinate = is_horizontal ? &Cell::y : &Cell::x;
  EXPECT_NE(ends_below(before, after, coordinate), ends_below(after, before, coordinate));
  return internal::Cut_2{0, is_horizontal, ends_below(after, before, coordinate)};
}

// The cut between random places in two squares of 2^log_unit x 2^log_unit cells each.
internal::Cut_2 cut_inside(const Cell& before, const Cell& after, int log_unit,
                           std::mt19937& random)
{
  const auto place = [&](const Cell& square) {
    const auto coordinate = [&](std::uint32_t x) {
      return x << log_unit | std::uint32_t(random() & ((1u << log_unit) - 1));
    };
    const std::uint32_t x = coordinate(square.x);
    return curve.place(x, coordinate(square.y));
  };
  const std::uint32_t first = place(before);
  return internal::hilbert_cut(first, place(after));
}

// Squares that follow each other on the curve, 2^k of them, halved again and again.
void expect_cuts(const Cells& squares, int log_unit, std::mt19937& random)
{
  int rank = 2 * log_unit;
  const auto number = std::ptrdiff_t(squares.size());
  for (std::ptrdiff_t half = 1; half < number; half *= 2, ++rank)
    for (auto first = squares.begin(); first != squares.end(); first += 2 * half) {
      const Cells before(first, first + half), after(first + half, first + 2 * half);
      const internal::Cut_2 expected = cut_between(before, after);
      for (const Cell& c : before)
        for (const Cell& d : after) {
          const internal::Cut_2 cut = cut_inside(c, d, log_unit, random);
          ASSERT_EQ(cut.rank, rank);
          ASSERT_EQ(cut.is_horizontal, expected.is_horizontal);
          ASSERT_EQ(cut.is_descending, expected.is_descending);
        }
    }
}

TEST(Hilbert_curve, has_the_cuts_that_part_its_halves)
{
  constexpr std::uint32_t width = 16;
  std::mt19937 random(2);
  for (const int log_unit : {0, 1, 4, 7, 11, 12})
    for (int i = 0; i < 8; ++i) {
      Cells squares;
      for (const auto& [place, square] :
           cells_along_curve(random_corner(width << log_unit, random), width, 1u << log_unit))
        squares.push_back(square);
      ASSERT_NO_FATAL_FAILURE(expect_cuts(squares, log_unit, random));
    }
}

// DIVIDE AND CONQUER ------------------------------------------------------------------------------

// The kernel's predicates on points by the indices of vertices.
struct Plain_predicates
{
  const Points* points;

  const Epick::Point_2& at(Vertex_index v) const { return (*points)[v - 1]; }
  CGAL::Orientation orientation(Vertex_index a, Vertex_index b, Vertex_index c) const
  {
    return CGAL::orientation(at(a), at(b), at(c));
  }
  CGAL::Oriented_side side_of_circle(Vertex_index a, Vertex_index b, Vertex_index c,
                                     Vertex_index d) const
  {
    return CGAL::side_of_oriented_circle(at(a), at(b), at(c), at(d));
  }
  CGAL::Comparison_result compare_xy(Vertex_index v, Vertex_index w) const
  {
    return CGAL::compare_xy(at(v), at(w));
  }
  CGAL::Comparison_result compare_yx(Vertex_index v, Vertex_index w) const
  {
    return CGAL::compare_yx(at(v), at(w));
  }
};

// The faces that divide and conquer gives, without the rest of the package.
class Sphere
{
public:
  explicit Sphere(const Points& points)
    : m_points(points)
  {
    internal::Guibas_stolfi_2<Plain_predicates>(Plain_predicates{&m_points}, m_faces)
        .run(spatial_order(positions_of(points)));
  }

  Index number_of_faces() const { return m_faces.number_of_faces(); }

  // Every half-edge of each face has the twin of which it is the twin, the other way around.
  void expect_closed() const
  {
    for (Face_index f(0); f < number_of_faces(); ++f)
      for (Index i = 0; i < 3; ++i) {
        const auto h = Flat_faces::first_halfedge(f) + i, g = m_faces.twin(h);
        ASSERT_EQ(Flat_faces::next(Flat_faces::previous(h)), h);
        ASSERT_EQ(m_faces.twin(g), h);
        ASSERT_EQ(m_faces.source(g), m_faces.target(h));
        ASSERT_EQ(m_faces.target(g), m_faces.source(h));
        ASSERT_NE(Flat_faces::face_of(g), f);
      }
  }

  // Of all points none is in the circle of a face, or outside of a hull edge.
  void expect_delaunay() const
  {
    const Plain_predicates predicates{&m_points};
    for (Face_index f(0); f < number_of_faces(); ++f) {
      const auto [a, b, c] = from_infinity(f);
      ASSERT_TRUE(b != internal::infinite_index && c != internal::infinite_index);
      const bool is_infinite = a == internal::infinite_index;
      ASSERT_TRUE(is_infinite || predicates.orientation(a, b, c) == CGAL::LEFT_TURN);
      for (Vertex_index v(1); v <= Index(m_points.size()); ++v)
        ASSERT_FALSE(is_infinite ? predicates.orientation(b, c, v) == CGAL::LEFT_TURN
                                 : predicates.side_of_circle(a, b, c, v) == CGAL::ON_POSITIVE_SIDE);
    }
  }

  // The hull passes each of its points once, and no point is missing.
  void expect_complete() const
  {
    std::set<Index> vertices, on_hull;
    for (Face_index f(0); f < number_of_faces(); ++f) {
      const auto [a, b, c] = from_infinity(f);
      vertices.insert({a, b, c});
      ASSERT_TRUE(a != internal::infinite_index || on_hull.insert(b).second);
    }
    ASSERT_EQ(vertices.size(), number_of_faces() == 0 ? 0 : m_points.size() + 1);
  }

private:
  using Flat_faces = internal::Flat_faces_2;

  // The vertices of a face, counterclockwise, the infinite one first if it is among them.
  std::array<Vertex_index, 3> from_infinity(Face_index f) const
  {
    auto h = Flat_faces::first_halfedge(f);
    for (int i = 0; i < 3 && m_faces.apex(h) != internal::infinite_index; ++i)
      h = Flat_faces::next(h);
    return {m_faces.apex(h), m_faces.source(h), m_faces.target(h)};
  }

  Points m_points;
  internal::Flat_faces_2 m_faces;
};

bool span_the_plane(const Points& points)
{
  for (std::size_t i = 2; i < points.size(); ++i)
    if (!CGAL::collinear(points[0], points[1], points[i]))
      return true;
  return false;
}

void expect_sphere(const Points& points)
{
  const Sphere sphere(points);
  ASSERT_EQ(sphere.number_of_faces(), span_the_plane(points) ? 2 * points.size() - 2 : 0);
  ASSERT_NO_FATAL_FAILURE(sphere.expect_closed());
  ASSERT_NO_FATAL_FAILURE(sphere.expect_delaunay());
  ASSERT_NO_FATAL_FAILURE(sphere.expect_complete());
}

Points without_coincidences(Points points)
{
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  return points;
}

TEST(Divide_and_conquer, is_right_on_every_subset_of_a_small_grid)
{
  for (const auto& [columns, rows] : {std::pair(4u, 3u), std::pair(3u, 4u), std::pair(2u, 5u)}) {
    const Points grid = Cloud<Epick>::grid(columns, rows);
    for (unsigned subset = 0; subset < 1u << grid.size(); ++subset) {
      Points points;
      for (std::size_t i = 0; i < grid.size(); ++i)
        if (subset >> i & 1)
          points.push_back(grid[i]);
      ASSERT_NO_FATAL_FAILURE(expect_sphere(points)) << testing::PrintToString(points);
    }
  }
}

TEST(Divide_and_conquer, is_right_on_random_subsets_of_larger_grids)
{
  std::mt19937 random(1);
  for (int i = 0; i < 4000; ++i) {
    const Points points =
        without_coincidences(on_lattice(9 + random() % 24, 2 + int(random() % 4), 1, random));
    ASSERT_NO_FATAL_FAILURE(expect_sphere(points)) << testing::PrintToString(points);
  }
}

TEST(Divide_and_conquer, is_right_on_points_of_every_kind)
{
  for (const auto& set : {regular_points(), uneven_points()})
    for (const auto& [name, points] : set) {
      SCOPED_TRACE(name);
      Points some = without_coincidences(points);
      some.resize((std::min)(some.size(), std::size_t(150)));
      ASSERT_NO_FATAL_FAILURE(expect_sphere(some));
    }
}

} // namespace

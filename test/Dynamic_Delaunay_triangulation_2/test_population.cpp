// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Points come, go, move without the others, meet and part; points that stay keep id and vertex.

#include "change_ledger.h"
#include "oracle.h"
#include "population_player.h"

#include <CGAL/Dynamic_Delaunay_triangulation_2/classifiers/Inflation_aware_classifier_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/classifiers/Point_distance_classifier_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/classifiers/Random_classifier_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/classifiers/Safe_region_classifier_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/classifiers/Voronoi_circumcenter_classifier_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/classifiers/Voronoi_edge_length_classifier_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/repairs/Flip_repair_2.h>
#include <CGAL/Dynamic_population_2.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <functional>
#include <iterator>
#include <limits>
#include <list>
#include <map>
#include <numeric>
#include <random>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace test_population {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

// A point with a coordinate that no double holds.
template <class Kernel>
typename Kernel::Point_2 nan_point()
{
  if constexpr (std::is_same_v<typename Kernel::FT, double>)
    return {nan, 0};
  else
    return {typename Kernel::FT(1e300) * typename Kernel::FT(1e300), 0};
}

double seconds_of(const std::function<void()>& work)
{
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

// -------------------------------------------------------------------------------------------------
// Points that come and go.

template <class Kernel>
class Population : public testing::Test
{
protected:
  using Dynamic = CGAL::Dynamic_Delaunay_triangulation_2<
      Kernel, CGAL::Default, CGAL::With_data_structure_2<Stamped_data_structure<Kernel>>>;
  using Point = typename Kernel::Point_2;
  using Points = std::vector<Point>;
  using Stamps = std::map<std::size_t, std::size_t>;

  // Expects that points that were alone at their vertices have kept them, if they still represent
  // them.
  static void expect_kept(const Dynamic& dt, const Stamps& stamps)
  {
    for (const auto& [id, stamp] : stamps)
      if (dt.has_id(id) && dt.id(dt.vertex(id)) == id) {
        ASSERT_EQ(stamp_of(dt, id), stamp) << "id " << id;
      }
  }

  static std::vector<std::size_t> insert_all(Dynamic& dt, const Points& points)
  {
    std::vector<std::size_t> ids;
    dt.insert(points.begin(), points.end(), std::back_inserter(ids));
    return ids;
  }

  // Inserts points in the given order, then removes them in a random one; exact after each call.
  static void expect_exact_one_by_one(const Points& points, unsigned seed)
  {
    Dynamic dt;
    Model<Dynamic> model;
    for (const Point& p : points) {
      const Stamps stamps = stamps_of(dt);
      const std::size_t id = dt.insert(p);
      ASSERT_EQ(id, model.size());
      model.emplace(id, p);
      ASSERT_NO_FATAL_FAILURE(expect_exact(dt, model));
      ASSERT_NO_FATAL_FAILURE(expect_kept(dt, stamps));
    }
    std::vector<std::size_t> ids(points.size());
    std::iota(ids.begin(), ids.end(), std::size_t(0));
    std::mt19937 random(seed);
    std::shuffle(ids.begin(), ids.end(), random);
    for (const std::size_t id : ids) {
      const Stamps stamps = stamps_of(dt);
      EXPECT_EQ(dt.remove(id).removed, 1u);
      model.erase(id);
      ASSERT_NO_FATAL_FAILURE(expect_exact(dt, model));
      ASSERT_NO_FATAL_FAILURE(expect_kept(dt, stamps));
    }
    EXPECT_EQ(dt.number_of_points(), 0u);
    EXPECT_EQ(dt.number_of_ids(), points.size());
  }

  static Points shuffled(Points points, unsigned seed)
  {
    std::mt19937 random(seed);
    std::shuffle(points.begin(), points.end(), random);
    return points;
  }
};

using Kernels = testing::Types<Epick, Epeck>;
TYPED_TEST_SUITE(Population, Kernels);

TYPED_TEST(Population, comes_and_goes_one_by_one_at_random_places)
{
  ASSERT_NO_FATAL_FAILURE(this->expect_exact_one_by_one(Cloud<TypeParam>(1).uniform(120), 1));
}

TYPED_TEST(Population, comes_and_goes_one_by_one_on_lattices_circles_and_lines_and_beside_them)
{
  ASSERT_NO_FATAL_FAILURE(this->expect_exact_one_by_one(Cloud<TypeParam>::grid(8, 6), 4));
  for (unsigned seed = 0; seed < 6; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    auto circle = Cloud<TypeParam>::on_circle(36), line = Cloud<TypeParam>(seed).on_line(24);
    if (seed > 0)
      circle.emplace_back(0, 0);
    for (unsigned i = 0; i < seed; ++i)
      line.emplace_back(int(i), 5000 * int(i % 2) - 2500);
    for (const auto& points : {Cloud<TypeParam>::grid(7, 7), circle, line})
      ASSERT_NO_FATAL_FAILURE(this->expect_exact_one_by_one(this->shuffled(points, seed), seed));
  }
}

TYPED_TEST(Population, comes_and_goes_one_by_one_at_few_places)
{
  for (unsigned seed = 0; seed < 30; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    std::mt19937 random(seed);
    typename TestFixture::Points points;
    for (int i = 0; i < 14; ++i) {
      const int x = int(random() % (2 + seed % 3));
      points.emplace_back(x, int(random() % 3));
    }
    ASSERT_NO_FATAL_FAILURE(this->expect_exact_one_by_one(points, seed));
  }
}

TYPED_TEST(Population, comes_and_goes_in_ranges_from_no_point_to_hundreds_and_back)
{
  Cloud<TypeParam> cloud(2);
  typename TestFixture::Dynamic dt;
  Model<typename TestFixture::Dynamic> model;
  for (const std::size_t number : {0u, 1u, 1u, 2u, 7u, 1u, 40u, 3u, 200u, 20u, 0u, 9u}) {
    const auto points = cloud.uniform(number);
    const auto stamps = stamps_of(dt);
    const auto ids = this->insert_all(dt, points);
    for (std::size_t i = 0; i < number; ++i)
      model.emplace(ids[i], points[i]);
    ASSERT_NO_FATAL_FAILURE(expect_exact(dt, model));
    ASSERT_NO_FATAL_FAILURE(this->expect_kept(dt, stamps));
  }
  for (const std::size_t number : {0u, 20u, 1u, 100u, 30u, 5u, 90u, 20u, 10u, 1u, 3u, 2u, 1u, 1u}) {
    std::vector<std::size_t> ids;
    for (std::size_t i = 0; i < number; ++i)
      ids.push_back(std::next(model.begin(), std::ptrdiff_t(i))->first);
    const auto stamps = stamps_of(dt);
    EXPECT_EQ(dt.remove(ids.begin(), ids.end()).removed, number);
    for (const std::size_t id : ids)
      model.erase(id);
    ASSERT_NO_FATAL_FAILURE(expect_exact(dt, model));
    ASSERT_NO_FATAL_FAILURE(this->expect_kept(dt, stamps));
  }
  EXPECT_EQ(dt.number_of_points(), 0u);
}

TYPED_TEST(Population, takes_a_point_at_any_special_place_and_gives_it_back)
{
  const auto grid = scaled<TypeParam>(Cloud<TypeParam>::grid(6, 5), 2);
  typename TestFixture::Dynamic dt(grid.begin(), grid.end());
  auto model = model_of(dt);
  const std::vector<std::array<double, 2>> places = {
      {4, 4},       // at another point
      {0, 0},       // at a corner of the hull
      {5, 4},       // on an edge
      {5, 5},       // in the middle of a square, on either diagonal
      {5, 0},       // on the hull
      {-2, 0},      // on the hull's line, outside
      {12, 8},      // on it, beyond another corner
      {-1e-300, 2}, // just outside
      {5, -1e9},    // far outside
      {1e150, 1e150}};
  for (const auto& [x, y] : places) {
    SCOPED_TRACE(testing::Message() << x << " " << y);
    const auto stamps = stamps_of(dt);
    const typename TestFixture::Point p(x, y);
    const std::size_t id = dt.insert(p);
    EXPECT_EQ(id, grid.size());
    model.emplace(id, p);
    ASSERT_NO_FATAL_FAILURE(expect_exact(dt, model));
    EXPECT_FALSE(dt.remove(id).rebuilt());
    model.erase(id);
    ASSERT_NO_FATAL_FAILURE(expect_exact(dt, model));
    ASSERT_NO_FATAL_FAILURE(this->expect_kept(dt, stamps));
  }
}

TYPED_TEST(Population, gives_hull_vertices_and_vertices_of_degree_3_away_until_few_are_left)
{
  const auto points = Cloud<TypeParam>(3).uniform(150);
  for (const bool takes_hull : {true, false}) {
    SCOPED_TRACE(takes_hull ? "hull" : "small degrees");
    typename TestFixture::Dynamic dt(points.begin(), points.end());
    auto model = model_of(dt);
    while (model.size() > 3) {
      const auto& t = dt.triangulation();
      std::size_t id = dt.id(t.infinite_vertex()->face()->vertex(
          t.ccw(t.infinite_vertex()->face()->index(t.infinite_vertex()))));
      if (!takes_hull)
        for (const auto& [other, p] : model)
          if (t.degree(dt.vertex(other)) < t.degree(dt.vertex(id)))
            id = other;
      dt.remove(id);
      model.erase(id);
      ASSERT_NO_FATAL_FAILURE(expect_exact(dt, model));
    }
  }
}

TYPED_TEST(Population, loses_its_only_point_beside_a_line_and_gets_it_back)
{
  typename TestFixture::Points points;
  for (int i = 0; i < 40; ++i)
    points.emplace_back(i, 0);
  points.emplace_back(7, 3);
  typename TestFixture::Dynamic dt(points.begin(), points.end());
  auto model = model_of(dt);
  for (int round = 0; round < 3; ++round) {
    const auto stamps = stamps_of(dt);
    EXPECT_TRUE(dt.remove(40).rebuilt());
    model.erase(40);
    ASSERT_NO_FATAL_FAILURE(expect_exact(dt, model));
    EXPECT_EQ(dt.triangulation().dimension(), 1);
    EXPECT_EQ(dt.insert(points[40]), 40u);
    model.emplace(40, points[40]);
    ASSERT_NO_FATAL_FAILURE(expect_exact(dt, model));
    for (int id = 0; id < 40; ++id)
      EXPECT_EQ(stamp_of(dt, std::size_t(id)), stamps.at(std::size_t(id)));
  }
}

TYPED_TEST(Population, gives_the_smallest_free_id_first)
{
  const auto points = Cloud<TypeParam>(4).uniform(100);
  typename TestFixture::Dynamic dt(points.begin(), points.end());
  for (const std::size_t id : {70u, 3u, 99u, 12u, 41u})
    dt.remove(id);
  EXPECT_EQ(dt.number_of_ids(), 100u);
  EXPECT_EQ(dt.number_of_points(), 95u);
  EXPECT_FALSE(dt.has_id(12));
  EXPECT_TRUE(dt.has_id(13));
  EXPECT_FALSE(dt.has_id(100));
  EXPECT_THROW(dt.vertex(12), CGAL::Unknown_id_error_2);
  EXPECT_EQ(dt.insert(points[3]), 3u);
  dt.remove(5);
  const auto ids = this->insert_all(
      dt, {points[0], points[1], points[2], points[3], points[4], points[5], points[6]});
  EXPECT_EQ(ids, (std::vector<std::size_t>{5, 12, 41, 70, 99, 100, 101}));
  EXPECT_EQ(dt.number_of_ids(), 102u);
}

TYPED_TEST(Population, gives_the_smallest_free_id_first_also_after_everything_was_rebuilt)
{
  const auto points = Cloud<TypeParam>(5).uniform(60);
  typename TestFixture::Dynamic dt(points.begin(), points.end());
  std::vector<std::size_t> ids;
  for (std::size_t id = 0; id < 60; id += 2)
    ids.push_back(id);
  EXPECT_TRUE(dt.remove(ids.begin(), ids.end()).rebuilt());
  EXPECT_EQ(this->insert_all(dt, {points[0], points[2]}), (std::vector<std::size_t>{0, 2}));
  EXPECT_EQ(this->insert_all(dt, points).front(), 4u);
  EXPECT_EQ(dt.number_of_ids(), 92u);
}

TYPED_TEST(Population, does_not_look_at_positions_of_ids_that_are_free)
{
  Cloud<TypeParam> cloud(6);
  auto points = cloud.uniform(100);
  typename TestFixture::Dynamic dt(points.begin(), points.end());
  auto model = model_of(dt);
  for (const std::size_t id : {0u, 50u, 99u}) {
    dt.remove(id);
    model.erase(id);
    points[id] = nan_point<TypeParam>();
  }
  for (int frame = 0; frame < 5; ++frame) {
    for (auto& [id, p] : model)
      p = points[id] = cloud.shifted(p, 0.1);
    const std::list<typename TestFixture::Point> list(points.begin(), points.end());
    if (frame % 2 == 0)
      dt.update(points.begin(), points.end());
    else
      dt.update(list.begin(), list.end());
    ASSERT_NO_FATAL_FAILURE(expect_exact(dt, model));
  }
  EXPECT_THROW(dt.update(points.begin(), points.end() - 1), CGAL::Point_count_error_2);
  points[1] = nan_point<TypeParam>();
  EXPECT_THROW(dt.update(points.begin(), points.end()), CGAL::Non_finite_coordinate_error_2);
  ASSERT_NO_FATAL_FAILURE(expect_exact(dt, model));
}

TYPED_TEST(Population, is_exact_whatever_happens_to_it)
{
  for (const Playground& ground : {Playground{4, true}, Playground{9, true}, Playground{8, false}})
    for (unsigned seed = 0; seed < 6; ++seed) {
      SCOPED_TRACE(testing::Message() << "side " << ground.side << ", seed " << seed);
      Population_player<typename TestFixture::Dynamic> player(ground, seed, 10 + 20 * (seed % 3));
      ASSERT_NO_FATAL_FAILURE(player.play(60));
    }
}

// -------------------------------------------------------------------------------------------------
// What it costs.

using Exact = CGAL::Dynamic_Delaunay_triangulation_2<Epick>;
using Points = std::vector<Epick::Point_2>;

Points around(const Epick::Point_2& center, std::size_t number)
{
  Points points;
  for (std::size_t i = 0; i < number; ++i) {
    const double angle = 2 * CGAL_PI * double(i) / double(number);
    points.emplace_back(center.x() + std::cos(angle), center.y() + std::sin(angle));
  }
  return points;
}

// The time to insert a vertex with so many neighbors, move it away and back, and remove it.
double seconds_for_hub(std::size_t neighbors)
{
  const Points points = around({0, 0}, neighbors);
  Exact dt(points.begin(), points.end());
  const double seconds = seconds_of([&] {
    const std::size_t hub = dt.insert(Epick::Point_2(0, 0));
    EXPECT_EQ(dt.triangulation().degree(dt.vertex(hub)), neighbors);
    dt.move(hub, Epick::Point_2(5, 0));
    dt.move(hub, Epick::Point_2(0, 0));
    EXPECT_EQ(dt.triangulation().degree(dt.vertex(hub)), neighbors);
    dt.remove(hub);
  });
  expect_exact(dt, points);
  return seconds;
}

TEST(Cost, of_a_hub_is_proportional_to_its_neighbors)
{
  seconds_for_hub(1000);
  const double few = seconds_for_hub(2000), many = seconds_for_hub(40000);
  RecordProperty("few", std::to_string(few));
  EXPECT_LT(many, 100 * few) << "twenty times as many neighbors";
}

TEST(Cost, of_single_points_does_not_grow_with_the_others)
{
  std::array<double, 2> seconds;
  std::array<std::size_t, 2> flips = {0, 0};
  std::size_t run = 0;
  for (const std::size_t number : {1000u, 100000u}) {
    Cloud<Epick> cloud(8);
    const Points points = cloud.uniform(number), others = cloud.uniform(number);
    Exact dt(points.begin(), points.end());
    const auto change = [&] {
      for (std::size_t i = 0; i < 100; ++i) {
        const auto inserted = dt.insert(others[i]);
        for (const auto& report :
             {dt.move(i, others[i + 200]), dt.move(i, points[i]),
              dt.move(inserted, cloud.shifted(others[i], 0.1)), dt.remove(inserted)}) {
          EXPECT_FALSE(report.rebuilt());
          flips[run] += report.flips;
        }
      }
    };
    // the fastest of three runs: in the first one, many points are not in the cache yet
    seconds[run] = (std::min)({seconds_of(change), seconds_of(change), seconds_of(change)});
    EXPECT_LT(flips[run++], 3 * 100u * 60);
    expect_exact(dt, points);
  }
  EXPECT_LT(seconds[1], 20 * seconds[0]) << "a hundred times as many points";
}

TEST(Cost, of_an_update_after_which_few_points_meet_and_part_is_no_rebuild)
{
  Cloud<Epick> cloud(9);
  Points points = cloud.uniform(1000);
  points[3] = cloud.shifted(points[10], 0.1);
  points[4] = cloud.shifted(points[700], 0.1);
  points[5] = cloud.shifted(points[700], 0.1);
  Exact dt(points.begin(), points.end());
  const Points apart = points;
  for (int round = 0; round < 5; ++round) {
    points[3] = points[10];
    points[4] = points[700];
    points[5] = points[700];
    const auto meeting = dt.update(points.begin(), points.end());
    EXPECT_FALSE(meeting.rebuilt());
    EXPECT_EQ(meeting.merged, 3u);
    EXPECT_EQ(meeting.parted, 0u);
    ASSERT_NO_FATAL_FAILURE(expect_exact(dt, points));
    EXPECT_EQ(dt.number_of_vertices(), 997u);
    points = apart;
    const auto parting = dt.update(points.begin(), points.end());
    EXPECT_FALSE(parting.rebuilt());
    EXPECT_EQ(parting.merged, 0u);
    EXPECT_EQ(parting.parted, 3u);
    ASSERT_NO_FATAL_FAILURE(expect_exact(dt, points));
  }
}

TEST(Cost, of_many_points_in_few_places_is_that_of_many_points)
{
  Points points = Cloud<Epick>(10).uniform(2000);
  for (std::size_t i = 0; i < 40000; ++i)
    points.push_back(points[i % 2000]);
  Exact dt(points.begin(), points.end());
  EXPECT_LT(seconds_of([&] {
              std::vector<std::pair<std::size_t, Epick::Point_2>> movers;
              for (std::size_t id = 0; id < points.size(); ++id)
                movers.emplace_back(id, points[points.size() - 1 - id]);
              dt.move(movers.begin(), movers.end());
              std::vector<std::size_t> ids(38000);
              std::iota(ids.begin(), ids.end(), std::size_t(2000));
              EXPECT_TRUE(dt.remove(ids.begin(), ids.end()).rebuilt());
            }),
            10);
  ASSERT_NO_FATAL_FAILURE(expect_exact(dt, model_of(dt)));
}

// -------------------------------------------------------------------------------------------------
// Some points move, the others do not.

TYPED_TEST(Population, moves_some_near_and_far_and_the_others_stay)
{
  Cloud<TypeParam> cloud(11);
  auto points = cloud.uniform(300);
  typename TestFixture::Dynamic dt(points.begin(), points.end());
  for (const std::size_t number : {0u, 1u, 2u, 5u, 30u, 60u, 299u, 300u})
    for (const double step : {1e-9, 0.01, 0.3, 10.}) {
      std::vector<std::pair<std::size_t, typename TestFixture::Point>> movers;
      for (std::size_t i = 0; i < number; ++i) {
        const std::size_t id = (7 * i + number) % points.size();
        movers.emplace_back(id, points[id] = cloud.shifted(points[id], step));
      }
      const auto stamps = stamps_of(dt);
      ASSERT_TRUE(dt.move(movers.begin(), movers.end()).certified);
      ASSERT_NO_FATAL_FAILURE(expect_exact(dt, points));
      ASSERT_NO_FATAL_FAILURE(this->expect_kept(dt, stamps));
    }
}

TYPED_TEST(Population, moves_points_onto_others_and_all_to_one_place_and_back)
{
  const auto home = Cloud<TypeParam>(13).uniform(100);
  auto points = home;
  typename TestFixture::Dynamic dt(points.begin(), points.end());
  for (std::size_t i = 0; i < 30; ++i) {
    points[i] = points[(7 * i + 31) % 100];
    dt.move(i, points[i]);
    ASSERT_NO_FATAL_FAILURE(expect_exact(dt, points));
  }
  std::vector<std::pair<std::size_t, typename TestFixture::Point>> together, apart;
  for (std::size_t i = 0; i < 100; ++i) {
    together.emplace_back(i, home[50]);
    apart.emplace_back(i, home[i]);
  }
  dt.move(together.begin(), together.end());
  ASSERT_NO_FATAL_FAILURE(expect_exact(dt, typename TestFixture::Points(points.size(), home[50])));
  dt.move(apart.begin(), apart.end());
  ASSERT_NO_FATAL_FAILURE(expect_exact(dt, home));
}

struct Traveller
{
  signed char name;
  double x, y;
};

template <class Point>
struct Place_of_traveller
{
  using key_type = Traveller;
  using value_type = Point;
  using reference = Point;
  using category = boost::readable_property_map_tag;
  friend Point get(const Place_of_traveller&, const Traveller& t) { return Point(t.x, t.y); }
};

struct Name_of_traveller
{
  using key_type = Traveller;
  using value_type = signed char;
  using reference = signed char;
  using category = boost::readable_property_map_tag;
  friend signed char get(const Name_of_traveller&, const Traveller& t) { return t.name; }
};

template <class Id, class Dynamic, class Points>
void move_and_remove_by(Dynamic& dt, Points& points)
{
  const std::list<std::pair<Id, typename Dynamic::Point>> movers = {{Id(0), {0.5, 0.25}},
                                                                    {Id(100), {7, 3}}};
  dt.move(movers.begin(), movers.end());
  points[0] = movers.front().second;
  points[100] = movers.back().second;
  ASSERT_NO_FATAL_FAILURE(expect_exact(dt, points));
  const std::vector<Id> id = {Id(100)};
  dt.remove(id.begin(), id.end());
  EXPECT_EQ(dt.insert(points[100]), 100u);
  ASSERT_NO_FATAL_FAILURE(expect_exact(dt, points));
}

TYPED_TEST(Population, takes_ids_of_any_integer_type_and_its_movers_through_property_maps)
{
  auto points = Cloud<TypeParam>(14).uniform(120);
  typename TestFixture::Dynamic dt(points.begin(), points.end());
  ASSERT_NO_FATAL_FAILURE(move_and_remove_by<signed char>(dt, points));
  ASSERT_NO_FATAL_FAILURE(move_and_remove_by<unsigned char>(dt, points));
  ASSERT_NO_FATAL_FAILURE(move_and_remove_by<short>(dt, points));
  ASSERT_NO_FATAL_FAILURE(move_and_remove_by<std::uint32_t>(dt, points));
  ASSERT_NO_FATAL_FAILURE(move_and_remove_by<std::int64_t>(dt, points));
  ASSERT_NO_FATAL_FAILURE(move_and_remove_by<std::size_t>(dt, points));
  const std::list<Traveller> travellers = {{5, 2, 2}, {4, 2.25, 7}};
  const Place_of_traveller<typename TestFixture::Point> place;
  dt.move(travellers.begin(), travellers.end(), Name_of_traveller(), place);
  points[5] = {2, 2};
  points[4] = {2.25, 7};
  ASSERT_NO_FATAL_FAILURE(expect_exact(dt, points));
  std::vector<std::size_t> ids;
  dt.insert(travellers.begin(), travellers.end(), place, std::back_inserter(ids));
  points.insert(points.end(), {points[5], points[4]});
  EXPECT_EQ(ids, (std::vector<std::size_t>{120, 121}));
  ASSERT_NO_FATAL_FAILURE(expect_exact(dt, points));
}

// -------------------------------------------------------------------------------------------------
// Points that share a place.

TYPED_TEST(Population, keeps_any_number_of_points_at_one_place_for_many_frames)
{
  Cloud<TypeParam> cloud(15);
  auto points = cloud.uniform(60);
  typename TestFixture::Dynamic dt(points.begin(), points.end());
  for (int frame = 0; frame < 20; ++frame) {
    cloud.shake(points, 0.05);
    for (std::size_t i = 1; i < 25; ++i)
      points[i] = points[0];
    const auto report = dt.update(points.begin(), points.end());
    EXPECT_EQ(report.rebuilt(), frame == 0);
    ASSERT_NO_FATAL_FAILURE(expect_exact(dt, points));
    EXPECT_EQ(dt.number_of_vertices(), 36u);
  }
}

enum class Way { UPDATE, MOVE, REMOVE };

template <class Dynamic>
void part(Dynamic& dt, Model<Dynamic>& model, std::size_t id, Way way)
{
  const typename Dynamic::Point elsewhere(0.25 + double(id), 0.75);
  if (way == Way::REMOVE) {
    dt.remove(id);
    model.erase(id);
    return;
  }
  model[id] = elsewhere;
  if (way == Way::MOVE) {
    dt.move(id, elsewhere);
    return;
  }
  std::vector<typename Dynamic::Point> points;
  for (const auto& [other, p] : model)
    points.push_back(p);
  dt.update(points.begin(), points.end());
}

TYPED_TEST(Population, lets_four_points_at_one_place_part_in_every_order_and_by_every_way)
{
  const auto others = Cloud<TypeParam>::grid(7, 6);
  for (const Way way : {Way::UPDATE, Way::MOVE, Way::REMOVE}) {
    std::array<std::size_t, 4> order = {0, 1, 2, 3};
    do {
      SCOPED_TRACE(testing::Message()
                   << int(way) << ": " << order[0] << order[1] << order[2] << order[3]);
      typename TestFixture::Points points(4, others[17]);
      points[3] = others[20]; // it comes to the others
      points.insert(points.end(), others.begin(), others.end());
      typename TestFixture::Dynamic dt(points.begin(), points.end());
      dt.move(3, others[17]);
      points[3] = others[17];
      auto model = model_of(dt);
      ASSERT_NO_FATAL_FAILURE(expect_exact(dt, points));
      for (const std::size_t id : order) {
        ASSERT_NO_FATAL_FAILURE(part(dt, model, id, way));
        ASSERT_NO_FATAL_FAILURE(expect_exact(dt, model));
      }
    } while (std::next_permutation(order.begin(), order.end()));
  }
}

TYPED_TEST(Population,
           lets_duplicates_stay_when_their_representative_goes_and_newcomers_be_their_duplicates)
{
  auto points = Cloud<TypeParam>::grid(6, 6);
  points[7] = points[8] = points[9];
  typename TestFixture::Dynamic dt(points.begin(), points.end());
  auto model = model_of(dt);
  for (int round = 0; round < 6; ++round) {
    const std::size_t representative = dt.id(dt.vertex(9)), other = representative == 7 ? 8 : 7;
    const auto vertex = dt.vertex(representative);
    const auto removed = dt.remove(representative);
    EXPECT_FALSE(removed.rebuilt());
    EXPECT_EQ(removed.flips, 0u);
    EXPECT_EQ(dt.vertex(other), vertex);
    model.erase(representative);
    ASSERT_NO_FATAL_FAILURE(expect_exact(dt, model));
    EXPECT_EQ(dt.insert(points[9]), representative);
    model.emplace(representative, points[9]);
    EXPECT_EQ(dt.vertex(representative), vertex);
    EXPECT_NE(dt.id(vertex), representative);
    ASSERT_NO_FATAL_FAILURE(expect_exact(dt, model));
  }
}

// -------------------------------------------------------------------------------------------------
// Populations with ids of the user's own.

template <class UserId>
class User_ids : public testing::Test
{
protected:
  using People = CGAL::Dynamic_population_2<Exact, UserId>;
  using Frame = std::map<UserId, Epick::Point_2>;

  UserId any_id()
  {
    switch (m_random() % 8) {
    case 0:
      return (std::numeric_limits<UserId>::min)();
    case 1:
      return (std::numeric_limits<UserId>::max)();
    default:
      return UserId(m_random() % 120);
    }
  }

  std::mt19937 m_random{16};
};

using User_id_types = testing::Types<std::int8_t, std::uint8_t, std::int16_t, std::uint16_t,
                                     std::int32_t, std::uint32_t, std::int64_t, std::uint64_t>;
TYPED_TEST_SUITE(User_ids, User_id_types);

TYPED_TEST(User_ids, name_a_population_that_changes_while_it_moves)
{
  typename TestFixture::People people;
  typename TestFixture::Frame frame;
  std::uniform_real_distribution<double> step(0, 0.04);
  for (int i = 0; i < 300; ++i) {
    SCOPED_TRACE(testing::Message() << "frame " << i);
    const typename TestFixture::Frame before = frame;
    for (auto& [user_id, p] : frame)
      p = Epick::Point_2(p.x() + step(this->m_random), p.y());
    for (std::size_t changes = this->m_random() % 4; changes > 0; --changes)
      frame.erase(this->any_id());
    for (std::size_t changes = this->m_random() % 5; changes > 0; --changes)
      frame.emplace(this->any_id(), random_point_between<Epick::Point_2>(0, 8, this->m_random));
    if (i % 50 == 49)
      frame.clear();
    std::vector<std::pair<TypeParam, Epick::Point_2>> range(frame.begin(), frame.end());
    std::shuffle(range.begin(), range.end(), this->m_random);
    std::size_t came = 0;
    for (const auto& [user_id, p] : frame)
      came += before.count(user_id) == 0;
    const auto report = people.update(range.begin(), range.end());
    ASSERT_TRUE(report.certified);
    ASSERT_EQ(report.inserted, came);
    ASSERT_EQ(report.removed, before.size() + came - frame.size());
    ASSERT_NO_FATAL_FAILURE(expect_exact_people(people, frame));
  }
}

TYPED_TEST(User_ids, name_points_that_come_move_and_go_one_by_one_or_are_refused)
{
  typename TestFixture::People people;
  typename TestFixture::Frame frame;
  std::uniform_int_distribution<int> coordinate(0, 6);
  for (int turn = 0; turn < 200; ++turn) {
    const TypeParam id = this->any_id();
    const int x = coordinate(this->m_random);
    const Epick::Point_2 p(x, coordinate(this->m_random));
    const std::vector<std::pair<TypeParam, Epick::Point_2>> mover = {{id, p}};
    // an id, known or new, that is there twice, or at no place
    std::vector<std::pair<TypeParam, Epick::Point_2>> twice(frame.begin(), frame.end());
    twice.insert(twice.end(), 2 - frame.count(id), mover.front());
    EXPECT_THROW(people.update(twice), CGAL::Repeated_id_error_2);
    auto bad = frame;
    bad[id] = Epick::Point_2(0, nan);
    EXPECT_THROW(people.update(bad), CGAL::Non_finite_coordinate_error_2);
    ASSERT_NO_FATAL_FAILURE(expect_exact_people(people, frame));
    if (frame.count(id) == 0) {
      EXPECT_THROW(people.insert(id, bad[id]), CGAL::Non_finite_coordinate_error_2);
      EXPECT_THROW(people.remove(id), CGAL::Unknown_user_id_error_2);
      EXPECT_THROW(people.move(mover.begin(), mover.end()), CGAL::Unknown_user_id_error_2);
      EXPECT_THROW(people.point(id), CGAL::Unknown_user_id_error_2);
      EXPECT_EQ(people.insert(id, p).inserted, 1u);
      frame.emplace(id, p);
    } else if (this->m_random() % 2 == 0) {
      EXPECT_THROW(people.insert(id, p), CGAL::Repeated_id_error_2);
      people.move(mover.begin(), mover.end());
      frame[id] = p;
    } else {
      EXPECT_EQ(people.remove(id).removed, 1u);
      frame.erase(id);
    }
    ASSERT_NO_FATAL_FAILURE(expect_exact_people(people, frame));
  }
}

// Expects that a table finds the same as a std::map after the same calls.
template <class UserId>
void expect_a_table_like_a_map(const std::vector<UserId>& user_ids, unsigned seed)
{
  CGAL::Dynamic_Delaunay_triangulations_2::internal::User_id_table<UserId> table;
  std::map<UserId, std::size_t> map;
  std::mt19937_64 random(seed);
  for (int step = 0; step < 4000; ++step) {
    const UserId user_id = user_ids[random() % user_ids.size()];
    // it grows for a while, then shrinks
    if (random() % 1000 < (step % 2000 < 1000 ? 700u : 300u)) {
      table.reserve_extra(1);
      table.set(user_id, std::size_t(step));
      map[user_id] = std::size_t(step);
    } else {
      table.erase(user_id);
      map.erase(user_id);
    }
    ASSERT_EQ(table.size(), map.size());
    if (step % 50 == 0)
      for (const UserId id : user_ids) {
        const auto found = map.find(id);
        ASSERT_EQ(table.find(id), found == map.end() ? table.no_id : found->second) << +id;
      }
  }
}

TEST(User_id_table, finds_what_is_there_whatever_steps_ids_make)
{
  using Limits = std::numeric_limits<std::int64_t>;
  for (const std::int64_t step : {1ll, 2ll, 64ll, 1000ll, 1ll << 20, 1ll << 40, 1ll << 55, -7ll}) {
    SCOPED_TRACE(testing::Message() << "step " << step);
    std::vector<std::int64_t> user_ids = {0, -1, (Limits::min)(), (Limits::max)()};
    for (std::int64_t i = 1; i < 120; ++i)
      user_ids.push_back(i * step);
    ASSERT_NO_FATAL_FAILURE(expect_a_table_like_a_map(user_ids, 3));
  }
  std::vector<signed char> letters;
  for (int i = -128; i < 128; ++i)
    letters.push_back(static_cast<signed char>(i));
  ASSERT_NO_FATAL_FAILURE(expect_a_table_like_a_map(letters, 4));
}

// The multiplicative inverse of an odd number modulo 2^64, by Newton's method.
std::uint64_t inverse(std::uint64_t factor)
{
  std::uint64_t inverse = factor;
  for (int i = 0; i < 6; ++i)
    inverse *= 2 - factor * inverse;
  return inverse;
}

// Ids whose products with a factor are 0, 1, 2, ... collide in a table that takes places from the
// first bits of such a product; ids of the other kinds where single bits decide. Half of the slots
// are empty, so some two are read for each id; with all ids in one place it would be 20,000.
TEST(User_id_table, reads_few_slots_for_ids_that_an_enemy_has_chosen)
{
  constexpr std::uint64_t number = 40000;
  std::vector<std::uint64_t> steps{1, 1ull << 32, 1ull << 47, 0x100000001u};
  for (const std::uint64_t known_factor :
       {0x9E3779B97F4A7C15u, 0xC6A4A7935BD1E995u, 0xFF51AFD7ED558CCDu, 0xC4CEB9FE1A85EC53u})
    steps.push_back(inverse(known_factor));
  for (const std::uint64_t step : steps) {
    CGAL::Dynamic_Delaunay_triangulations_2::internal::User_id_table<std::uint64_t> table;
    table.reserve_extra(number);
    for (std::uint64_t i = 0; i < number; ++i)
      table.set(i * step, i);
    std::size_t probes = 0;
    for (std::uint64_t i = 0; i < number; ++i)
      probes += table.number_of_probes(i * step);
    EXPECT_LT(probes, 3 * number) << "step " << step;
  }
}

TEST(User_id_table, is_empty_after_it_was_moved)
{
  CGAL::Dynamic_Delaunay_triangulations_2::internal::User_id_table<int> table;
  table.reserve_extra(2);
  table.set(5, 1);
  auto other = std::move(table);
  EXPECT_EQ(other.find(5), 1u);
  EXPECT_EQ(table.size(), 0u);
  EXPECT_EQ(table.find(5), table.no_id);
  table.reserve_extra(1);
  table.set(4, 2);
  EXPECT_EQ(table.find(4), 2u);
}

// A new point is found without the table in the next frame, at the place that it had in the range:
// order, gaps and new points in any places change nothing.
TEST(User_id_report, does_not_depend_on_the_order_of_frames)
{
  using Frame = std::vector<std::pair<std::int64_t, Epick::Point_2>>;
  Cloud<Epick> cloud(8);
  CGAL::Dynamic_population_2<Exact> people;
  Frame frame;
  std::int64_t next_id = 1000;
  for (int step = 0; step < 60; ++step) {
    SCOPED_TRACE(testing::Message() << "frame " << step);
    if (step % 7 == 0)
      std::shuffle(frame.begin(), frame.end(), cloud.random());
    for (int k = 0; k < 5; ++k)
      frame.insert(frame.begin() + std::ptrdiff_t(cloud.random()() % (frame.size() + 1)),
                   {step % 2 == 0 ? next_id++ : -next_id++, cloud.uniform(1)[0]});
    for (int k = 0; k < 3 && frame.size() > 9; ++k)
      frame.erase(frame.begin() + std::ptrdiff_t(cloud.random()() % frame.size()));
    for (auto& [id, p] : frame)
      p = cloud.shifted(p, 0.01);
    people.update(frame.begin(), frame.end());
    ASSERT_NO_FATAL_FAILURE(expect_exact_people(people, frame));
  }
}

// -------------------------------------------------------------------------------------------------
// What classifiers are told.

template <class Classifier>
class News : public testing::Test
{
};

using Classifiers =
    testing::Types<CGAL::Circumcircle_classifier_2, CGAL::Safe_region_classifier_2,
                   CGAL::Point_distance_classifier_2, CGAL::Inflation_aware_classifier_2,
                   CGAL::Voronoi_edge_length_classifier_2, CGAL::Voronoi_circumcenter_classifier_2>;
TYPED_TEST_SUITE(News, Classifiers);

TYPED_TEST(News, tell_all_that_has_changed_and_whose_the_numbers_are)
{
  using Watched = Watched_triangulation<Epick, TypeParam>;
  for (const Playground& ground : {Playground{7, false}, Playground{8, true}})
    for (unsigned seed = 0; seed < 4; ++seed) {
      SCOPED_TRACE(testing::Message() << "seed " << seed);
      Population_player<Watched, void> player(ground, seed);
      Population_player<Watched, std::int8_t> named(ground, seed);
      player.triangulation().classifier().watch(player.triangulation());
      named.triangulation().classifier().watch(named.triangulation());
      ASSERT_NO_FATAL_FAILURE(player.play(150, TypeParam::is_exact ? 0 : 20));
      ASSERT_NO_FATAL_FAILURE(named.play(60, TypeParam::is_exact ? 0 : 20));
    }
}

// A slightly perturbed lattice.
Points uneven_lattice()
{
  Points points;
  for (int i = 0; i < 20; ++i)
    for (int j = 0; j < 20; ++j)
      points.emplace_back(i + 0.01 * ((7 * i + 3 * j) % 10), j + 0.01 * ((5 * i + 11 * j) % 10));
  return points;
}

// How many vertices far from the corner at the origin the next update classifies.
template <class Dynamic>
std::size_t classified_far_away(Dynamic& dt, const Points& points)
{
  dt.update(points.begin(), points.end());
  std::size_t classified = 0;
  for (const auto v : dt.classified_vertices()) {
    const auto& position = dt.frame().position(v);
    classified += position.x + position.y > 8;
  }
  return classified;
}

// An edge is stretched, but not enough; then, elsewhere, a point comes, moves, and goes.
template <class Classifier>
void expect_references_kept(const Classifier& classifier, double little, double more)
{
  using Dynamic = CGAL::Dynamic_Delaunay_triangulation_2<Epick, Classifier>;
  auto points = uneven_lattice();
  Dynamic dt(points.begin(), points.end(), classifier);
  points.back() = Epick::Point_2(points.back().x() + little, points.back().y());
  EXPECT_EQ(classified_far_away(dt, points), 0u);
  points.emplace_back(0.4, 0.6);
  EXPECT_EQ(dt.insert(points.back()), 400u);
  EXPECT_EQ(classified_far_away(dt, points), 0u) << "after an insertion";
  points[0] = Epick::Point_2(1.4, 1.6);
  EXPECT_FALSE(dt.move(0, points[0]).rebuilt());
  EXPECT_EQ(classified_far_away(dt, points), 0u) << "after a move";
  dt.remove(1);
  EXPECT_EQ(classified_far_away(dt, points), 0u) << "after a removal";
  points[399] = Epick::Point_2(points[399].x() + more, points[399].y());
  EXPECT_GT(classified_far_away(dt, points), 0u) << "stretched further";
}

TEST(References, of_lengths_stay_where_nothing_came_or_went)
{
  expect_references_kept(CGAL::Point_distance_classifier_2(0.7), 0.25, 0.1);
  expect_references_kept(CGAL::Inflation_aware_classifier_2(0.7), 0.25, 0.4);
}

// -------------------------------------------------------------------------------------------------
// Populations of triangulations that are not Delaunay.

template <class Dynamic>
void expect_valid_whatever_happens(const Playground& ground, unsigned seed,
                                   const std::function<Dynamic()>& empty)
{
  Population_player<Dynamic> player(ground, seed, 80, empty);
  player.play(60, 15);
}

// The classifier sees the vertex where its representative was. The duplicate that becomes its
// representative is elsewhere.
TEST(A_duplicate, that_moves_while_its_representative_is_removed_is_proved_anew)
{
  using Dynamic = CGAL::Dynamic_Delaunay_triangulation_2<Epick>;
  std::mt19937 random(1);
  const auto place = [&] { return random_point_between<Epick::Point_2>(0, 10, random); };
  for (int run = 0; run < 20; ++run) {
    std::vector<std::pair<int, Epick::Point_2>> frame;
    for (int id = 0; id < 60; ++id)
      frame.emplace_back(id, place());
    frame.emplace_back(60, Epick::Point_2(5, 5)); // represents both
    frame.emplace_back(61, Epick::Point_2(5, 5));
    CGAL::Dynamic_population_2<Dynamic, int> population;
    population.update(frame);

    frame.erase(frame.end() - 2);
    frame.back().second = place();
    population.update(frame);
    ASSERT_TRUE(population.triangulation().is_certified());
    ASSERT_TRUE(population.triangulation().triangulation().is_valid()) << "run " << run;
  }
}

// Counts its calls.
struct Counting_classifier : CGAL::Circumcircle_classifier_2
{
  int* calls = nullptr;

  template <class Frame, class Classification>
  void operator()(const Frame& frame, Classification& classified)
  {
    ++*calls;
    CGAL::Circumcircle_classifier_2::operator()(frame, classified);
  }
};

TEST(A_frame_at_rest, is_classified_only_if_a_point_has_moved)
{
  using Dynamic = CGAL::Dynamic_Delaunay_triangulation_2<Epick, Counting_classifier>;
  int calls = 0;
  Counting_classifier classifier;
  classifier.calls = &calls;
  CGAL::Dynamic_population_2<Dynamic, int> population{Dynamic(classifier)};
  std::mt19937 random(1);
  const auto place = [&] { return random_point_between<Epick::Point_2>(0, 10, random); };
  std::vector<std::pair<int, Epick::Point_2>> frame;
  for (int id = 0; id < 300; ++id)
    frame.emplace_back(id, place());
  population.update(frame);
  const auto expect_calls = [&](int number) {
    calls = 0;
    const auto report = population.update(frame);
    EXPECT_FALSE(report.rebuilt());
    EXPECT_EQ(calls, number);
    EXPECT_TRUE(population.triangulation().is_certified());
    EXPECT_TRUE(population.triangulation().is_valid());
  };
  expect_calls(1); // the same points
  frame[7] = {300, place()};
  expect_calls(0);
  frame[8] = {301, frame[9].second}; // coincides with another one
  expect_calls(0);
  frame[7] = {302, place()};
  frame[8].second = place(); // a covered point parts
  expect_calls(1);
  frame[10] = {303, place()};
  frame.back().second = Epick::Point_2(frame.back().second.x() + 1e-9, frame.back().second.y());
  expect_calls(1);
  frame.erase(frame.begin() + 20, frame.begin() + 40);
  expect_calls(0);
}

TEST(Heuristic_population, stays_valid_and_can_be_mended_whatever_happens_to_it)
{
  using CGAL::Point_distance_classifier_2, CGAL::Random_classifier_2;
  using Distance = CGAL::Dynamic_Delaunay_triangulation_2<Epick, Point_distance_classifier_2>;
  using Flipped = CGAL::Dynamic_Delaunay_triangulation_2<Epick, Random_classifier_2,
                                                         CGAL::With_repair_2<CGAL::Flip_repair_2>>;
  using Exactly_constructed = CGAL::Dynamic_Delaunay_triangulation_2<Epeck, Random_classifier_2>;
  for (const Playground& ground : {Playground{9, false}, Playground{9, true}, Playground{3, false}})
    for (unsigned seed = 0; seed < 10; ++seed) {
      SCOPED_TRACE(testing::Message() << "side " << ground.side << ", seed " << seed);
      const Random_classifier_2 random(0.02, seed);
      ASSERT_NO_FATAL_FAILURE(expect_valid_whatever_happens<Distance>(
          ground, seed, [] { return Distance(Point_distance_classifier_2(0)); }));
      ASSERT_NO_FATAL_FAILURE(
          expect_valid_whatever_happens<Flipped>(ground, seed, [&] { return Flipped(random); }));
      ASSERT_NO_FATAL_FAILURE(expect_valid_whatever_happens<Exactly_constructed>(
          ground, seed, [&] { return Exactly_constructed(random); }));
    }
}

} // namespace test_population

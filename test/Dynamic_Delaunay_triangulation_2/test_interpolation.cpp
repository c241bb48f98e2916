// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Weights of natural neighbors and linear ones, against CGAL's natural neighbors of exact numbers
// and against exact faces; in periodic space among all images around.

#include "query_oracle.h"

#include <CGAL/Dynamic_Delaunay_triangulation_2/classifiers/Random_classifier_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/queries/Interpolation_weights_2.h>
#include <CGAL/Dynamic_periodic_Delaunay_triangulation_2.h>
#include <CGAL/natural_neighbor_coordinates_2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <map>
#include <numeric>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace query_oracle;

constexpr double largest_error = 1e-12;

using Weights = CGAL::Interpolation_weights_2;
using Number = Epeck::FT;
using Exact_triangulation = CGAL::Delaunay_triangulation_2<Epeck>;
using Shift = CGAL::Periodic_shift_2;
using Periodic = CGAL::Dynamic_periodic_Delaunay_triangulation_2<Epick>;

template <class Point>
Exact_triangulation exact_triangulation(const std::vector<Point>& points)
{
  const Exact_points all = exact_points(points);
  return Exact_triangulation(all.begin(), all.end());
}

// The weights that are not 0, by their points.
using Weight_of = std::map<Exact_point, double>;

// Natural neighbor weights by CGAL, without rounding; empty outside of the hull.
Weight_of oracle(const Exact_triangulation& dt, const Exact_point& place)
{
  if (dt.dimension() < 2)
    return {};
  std::vector<std::pair<Exact_point, Number>> parts;
  const auto result = CGAL::natural_neighbor_coordinates_2(dt, place, std::back_inserter(parts));
  Weight_of weights;
  if (result.third)
    for (const auto& [p, part] : parts)
      if (part != 0)
        weights[p] = rounded(part / result.second);
  return weights;
}

void expect_near(const Weight_of& weights, const Weight_of& expected)
{
  Weight_of both = weights;
  both.insert(expected.begin(), expected.end());
  for (const auto& [p, ignored] : both) {
    const auto in = [&point = p](const Weight_of& some) {
      const auto found = some.find(point);
      return found == some.end() ? 0.0 : found->second;
    };
    ASSERT_NEAR(in(weights), in(expected), largest_error) << p;
  }
}

// The weights at one of the places: `where(i)` is the point of entry i.
template <class Where>
Weight_of weights_at(const Weights& weights, std::size_t place, const Where& where)
{
  Weight_of result;
  for (std::size_t i = weights.offsets()[place]; i < weights.offsets()[place + 1]; ++i)
    if (weights.weights()[i] != 0)
      result[where(i)] = weights.weights()[i];
  return result;
}

// Expects what holds for both kinds of weights at one place: `where(i)` is the point of entry i.
template <class Where>
void expect_sound(const Weights& weights, std::size_t place, const Exact_point& p,
                  const Where& where)
{
  const std::size_t first = weights.offsets()[place], beyond = weights.offsets()[place + 1];
  ASSERT_EQ(weights.is_outside(place), first == beyond);
  if (first == beyond)
    return;
  double sum = 0, extent = 0;
  Epeck::Vector_2 off = CGAL::NULL_VECTOR;
  for (std::size_t i = first; i < beyond; ++i) {
    ASSERT_GE(weights.weights()[i], 0);
    ASSERT_LE(weights.weights()[i], 1);
    sum += weights.weights()[i];
    const Epeck::Vector_2 way = where(i) - p;
    off = off + Number(weights.weights()[i]) * way;
    extent = (std::max)(extent, std::hypot(rounded(way.x()), rounded(way.y())));
  }
  const double rounding = double(beyond - first) * 0x1p-53;
  EXPECT_NEAR(sum, 1, rounding);
  EXPECT_LE(std::hypot(rounded(off.x()), rounded(off.y())), largest_error * extent);
}

template <class Kernel>
class Interpolation_of : public testing::Test
{
protected:
  using Subject = CGAL::Dynamic_Delaunay_triangulation_2<Kernel>;
  using Place = typename Kernel::Point_2;
  using Places = std::vector<Place>;

  static std::map<std::string, Places> clouds()
  {
    using Source = Cloud<Kernel>;
    std::map<std::string, Places> clouds = clouds_of_all_kinds<Kernel>();
    clouds["triangle"] = {Place(0, 0), Place(4, 1), Place(1, 3)};
    clouds["flat"] = Source(4).uniform(40);
    for (Place& p : clouds["flat"])
      p = Place(p.x(), p.y() * 1e-6);
    clouds["nearly straight hull"] = cloud_with_nearly_straight_hull<Kernel>();
    clouds["huge"] = scaled<Kernel>(Source(6).uniform(40), 1e90);
    clouds["largest"] = scaled<Kernel>(Source(6).uniform(20), 1e150);
    clouds["tiny"] = scaled<Kernel>(Source(7).uniform(40), 1e-90);
    clouds["tiniest"] = scaled<Kernel>(Source(7).uniform(20), 1e-200);
    clouds["far away"] = scaled<Kernel>(Source(8).uniform(40), 1e-3, 1e6);
    return clouds;
  }

  // Anywhere among and around some points, on them, between two, and close by.
  static Places places_for(const Places& points)
  {
    if (points.empty())
      return {Place(1, 2)};
    Places places = points;
    std::mt19937 random(9);
    const auto any = [&] {
      return points[std::uniform_int_distribution<std::size_t>(0, points.size() - 1)(random)];
    };
    std::uniform_real_distribution<double> share(-0.2, 1.1);
    for (int i = 0; i < 60; ++i) {
      const Place p = any(), q = any(), r = any();
      const double s = share(random), t = share(random) / 2;
      const auto between = [&](const auto& x, const auto& y, const auto& z) {
        return x + s * (y - x) + t * (z - x);
      };
      places.push_back(Place(between(p.x(), q.x(), r.x()), between(p.y(), q.y(), r.y())));
      places.push_back(Place((p.x() + q.x()) / 2, (p.y() + q.y()) / 2));
      places.push_back(Place(p.x() + (q.x() - p.x()) * 1e-9, p.y() + (q.y() - p.y()) * 1e-9));
    }
    return places;
  }

  static bool has_empty_circle(const Exact_points& points,
                               const std::array<Exact_point, 3>& corners)
  {
    return !CGAL::collinear(corners[0], corners[1], corners[2]) &&
           std::none_of(points.begin(), points.end(), [&](const Exact_point& q) {
             return CGAL::side_of_bounded_circle(corners[0], corners[1], corners[2], q) ==
                    CGAL::ON_BOUNDED_SIDE;
           });
  }

  // The exact linear weights at a place, which must be in the triangle of three points with a
  // circle that no point is in, or on a side of such a triangle.
  static Weight_of linear_oracle(const Exact_points& points, const Exact_points& corners,
                                 const Exact_point& p)
  {
    Weight_of weights;
    if (corners.size() == 1)
      weights[corners[0]] = corners[0] == p;
    if (corners.size() == 2) {
      const Epeck::Vector_2 way = corners[1] - corners[0];
      EXPECT_TRUE(CGAL::collinear_are_strictly_ordered_along_line(corners[0], p, corners[1]));
      EXPECT_TRUE(std::any_of(points.begin(), points.end(), [&](const Exact_point& q) {
        return has_empty_circle(points, {corners[0], corners[1], q});
      }));
      const Number share = ((p - corners[0]) * way) / (way * way);
      weights[corners[0]] = rounded(1 - share);
      weights[corners[1]] = rounded(share);
    }
    if (corners.size() == 3) {
      EXPECT_TRUE(has_empty_circle(points, {corners[0], corners[1], corners[2]}));
      const Number whole = CGAL::area(corners[0], corners[1], corners[2]);
      for (std::size_t i = 0; i < 3; ++i)
        weights[corners[i]] =
            rounded(CGAL::area(p, corners[(i + 1) % 3], corners[(i + 2) % 3]) / whole);
    }
    return weights;
  }
};

using Kernels = testing::Types<Epick, Epeck>;
TYPED_TEST_SUITE(Interpolation_of, Kernels);

TYPED_TEST(Interpolation_of, natural_neighbors_have_the_weights_that_cgal_finds_without_rounding)
{
  for (const auto& [name, points] : this->clouds()) {
    SCOPED_TRACE(name);
    const typename TestFixture::Subject dt(points.begin(), points.end());
    const auto places = this->places_for(points);
    Weights weights;
    weights.compute_natural_neighbor(dt, places.begin(), places.end());
    ASSERT_EQ(weights.number_of_query_points(), places.size());
    const Exact_triangulation fresh = exact_triangulation(points);
    const auto where = [&](std::size_t entry) { return exact(dt.point(weights.ids()[entry])); };
    for (std::size_t i = 0; i < places.size(); ++i) {
      SCOPED_TRACE(i);
      const Exact_point p = exact(places[i]);
      ASSERT_NO_FATAL_FAILURE(expect_near(weights_at(weights, i, where), oracle(fresh, p)));
      ASSERT_NO_FATAL_FAILURE(expect_sound(weights, i, p, where));
    }
  }
}

TYPED_TEST(Interpolation_of, linear_weights_are_those_of_the_face_or_edge_that_the_place_is_in)
{
  for (const auto& [name, points] : this->clouds()) {
    SCOPED_TRACE(name);
    const typename TestFixture::Subject dt(points.begin(), points.end());
    const auto places = this->places_for(points);
    Weights weights, natural;
    weights.compute_linear(dt, places.begin(), places.end());
    natural.compute_natural_neighbor(dt, places.begin(), places.end());
    const Exact_points all = exact_points(points);
    const auto where = [&](std::size_t entry) { return exact(dt.point(weights.ids()[entry])); };
    for (std::size_t i = 0; i < places.size(); ++i) {
      SCOPED_TRACE(i);
      ASSERT_EQ(weights.is_outside(i), natural.is_outside(i));
      Exact_points corners;
      for (std::size_t entry = weights.offsets()[i]; entry < weights.offsets()[i + 1]; ++entry)
        corners.push_back(where(entry));
      if (corners.size() == 3 &&
          CGAL::orientation(corners[0], corners[1], corners[2]) == CGAL::RIGHT_TURN)
        std::swap(corners[0], corners[1]);
      const Exact_point p = exact(places[i]);
      Weight_of expected = this->linear_oracle(all, corners, p);
      ASSERT_NO_FATAL_FAILURE(expect_near(weights_at(weights, i, where), expected));
      ASSERT_NO_FATAL_FAILURE(expect_sound(weights, i, p, where));
    }
  }
}

// WHERE THERE IS NOTHING TO WEIGH -----------------------------------------------------------------

using Plane = CGAL::Dynamic_Delaunay_triangulation_2<Epick>;
using Points = std::vector<Epick::Point_2>;

Weights natural(const Plane& dt, const Points& places)
{
  Weights weights;
  weights.compute_natural_neighbor(dt, places.begin(), places.end());
  return weights;
}

TEST(Interpolation, a_place_on_a_point_has_that_point_alone_or_who_stands_for_it)
{
  Points points = Cloud<Epick>(1).uniform(40);
  points.push_back(points[7]);
  const Plane dt(points.begin(), points.end());
  const Weights weights = natural(dt, points);
  ASSERT_EQ(weights.ids().size(), points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_EQ(weights.ids()[i], i < 40 ? i : 7);
    EXPECT_EQ(weights.weights()[i], 1);
  }
}

TEST(Interpolation, a_place_on_the_hull_has_the_two_ends_of_its_edge)
{
  const Plane dt(Cloud<Epick>::grid(4, 4));
  const Weights weights = natural(dt, {{1.25, 0}, {3, 2.5}, {0, 0.5}});
  EXPECT_EQ(weights.offsets(), (std::vector<std::size_t>{0, 2, 4, 6}));
  EXPECT_EQ(weights.ids(), (std::vector<Weights::Id>{1, 2, 11, 15, 0, 4}));
  EXPECT_EQ(weights.weights(), (std::vector<double>{0.75, 0.25, 0.5, 0.5, 0.5, 0.5}));
}

TEST(Interpolation, outside_of_the_hull_however_near_there_are_no_weights)
{
  const Plane dt(Cloud<Epick>::grid(4, 4));
  const Weights weights =
      natural(dt, {{1, -1e-300}, {3, 3.5}, {-0x1p-1074, 2}, {4, 0}, {1e300, 1}, {1, 1e-300}});
  for (std::size_t i = 0; i < 5; ++i)
    EXPECT_TRUE(weights.is_outside(i)) << i;
  EXPECT_FALSE(weights.is_outside(5));
  EXPECT_TRUE(weights.shifts().empty());
}

TEST(Interpolation, values_are_weighted_and_places_outside_get_what_the_caller_says)
{
  const Points points = Cloud<Epick>(2).uniform(50);
  const Plane dt(points.begin(), points.end());
  std::vector<double> values;
  for (const auto& p : points)
    values.push_back(3 * p.x() - 2 * p.y() + 5);
  const Points places{{3, 4}, {-9, 1}, {2.5, 2.5}};
  for (const bool are_linear : {false, true}) {
    Weights weights;
    if (are_linear)
      weights.compute_linear(dt, places.begin(), places.end());
    else
      weights.compute_natural_neighbor(dt, places.begin(), places.end());
    std::vector<double> results;
    weights.interpolate(values.begin(), std::back_inserter(results), -1);
    ASSERT_EQ(results.size(), 3u);
    EXPECT_NEAR(results[0], 6, 1e-11);
    EXPECT_EQ(results[1], -1);
    EXPECT_NEAR(results[2], 7.5, 1e-11);
  }
}

TEST(Interpolation, errors_say_which_place_it_is_and_change_nothing)
{
  const Points points = Cloud<Epick>(3).uniform(50);
  const Plane dt(points.begin(), points.end());
  Weights weights = natural(dt, {{3, 4}});
  const std::vector<double> before = weights.weights();
  const Points places{{3, 4}, {3, std::numeric_limits<double>::quiet_NaN()}};
  try {
    weights.compute_natural_neighbor(dt, places.begin(), places.end());
    FAIL() << "no error";
  } catch (const CGAL::Non_finite_coordinate_error_2& error) {
    EXPECT_EQ(error.id(), 1u);
  }
  EXPECT_EQ(weights.weights(), before);

  using Heuristic = CGAL::Dynamic_Delaunay_triangulation_2<Epick, CGAL::Random_classifier_2>;
  Heuristic uncertified(points.begin(), points.end(), CGAL::Random_classifier_2(0, 1));
  Points moved = points;
  Cloud<Epick>(4).shake(moved, 0.5);
  uncertified.update(moved.begin(), moved.end());
  EXPECT_THROW(weights.compute_linear(uncertified, places.begin(), places.end()),
               CGAL::Uncertified_triangulation_error_2);
  EXPECT_EQ(weights.weights(), before);
}

#ifdef CGAL_LINKED_WITH_TBB
TEST(Interpolation, threads_find_the_same_weights)
{
  using Parallel =
      CGAL::Dynamic_Delaunay_triangulation_2<Epick, CGAL::Default,
                                             CGAL::With_concurrency_2<CGAL::Parallel_tag>>;
  const Points points = Cloud<Epick>(5).uniform(500), places = Cloud<Epick>(6).uniform(3000);
  const Plane dt(points.begin(), points.end());
  const Parallel parallel(points.begin(), points.end());
  Weights weights;
  weights.compute_natural_neighbor(parallel, places.begin(), places.end());
  const Weights alone = natural(dt, places);
  EXPECT_EQ(weights.offsets(), alone.offsets());
  EXPECT_EQ(weights.ids(), alone.ids());
  EXPECT_EQ(weights.weights(), alone.weights());
}
#endif

// A place in the middle of many cocircular points is in the circles of a fan of faces, and all of
// them are its neighbors.
TEST(Interpolation, any_number_of_points_can_be_natural_neighbors)
{
  constexpr double turn = 6.283185307179586;
  constexpr std::size_t number = 2000;
  Points points;
  for (std::size_t i = 0; i < number; ++i)
    points.emplace_back(std::cos(turn * double(i) / number), std::sin(turn * double(i) / number));
  const Plane dt(points.begin(), points.end());
  const Weights weights = natural(dt, {{0, 0}, {0.3, 0.1}});
  ASSERT_EQ(weights.offsets()[1], number);
  EXPECT_NEAR(std::accumulate(weights.weights().begin(), weights.weights().end(), 0.0), 2, 1e-9);
}

// PERIODIC SPACE ----------------------------------------------------------------------------------

// Compares weights with those among all images around. The points may be given many cells away
// along the first vector.
void expect_periodic(const Periodic& dt, const Points& places, int away = 0)
{
  const CGAL::Periodic_cell_2& cell = dt.cell();
  Weights weights;
  weights.compute_natural_neighbor(dt, places.begin(), places.end());
  ASSERT_EQ(weights.shifts().size(), weights.ids().size());
  const Exact_points images = images_around(dt, 4, away);
  const Exact_triangulation fresh(images.begin(), images.end());
  const auto image = [&](std::size_t entry) {
    const Shift& shift = weights.shifts()[entry];
    const auto p = exact(dt.point(weights.ids()[entry]));
    const Epeck::Vector_2 a(cell.ax(), cell.ay()), b(cell.bx(), cell.by());
    return shift[1] == 0 ? p + Number(shift[0]) * a
                         : p + Number(shift[0]) * a + Number(shift[1]) * b;
  };
  for (std::size_t place = 0; place < places.size(); ++place) {
    SCOPED_TRACE(place);
    const Exact_point p = exact(places[place]);
    ASSERT_NO_FATAL_FAILURE(expect_near(weights_at(weights, place, image), oracle(fresh, p)));
    ASSERT_NO_FATAL_FAILURE(expect_sound(weights, place, p, image));
  }
}

TEST(Interpolation, on_a_torus_neighbors_are_images)
{
  for (const CGAL::Periodic_cell_2& cell :
       {CGAL::Periodic_cell_2(1, 1), CGAL::Periodic_cell_2(1, 0.1, 0.4, 0.9)})
    for (const std::size_t number : {1u, 2u, 5u, 30u}) {
      SCOPED_TRACE(number);
      const double scale = 1 / std::sqrt(double(number));
      const Points points = scaled<Epick>(Cloud<Epick>(7).uniform(number), scale);
      Points places = scaled<Epick>(Cloud<Epick>(8).uniform(9), 0.5, -0.3);
      places.push_back(points[0]);
      places.emplace_back(points[0].x() / 2, points[0].y() / 2);
      ASSERT_NO_FATAL_FAILURE(expect_periodic(Periodic(points, cell), places));
    }
}

TEST(Interpolation, points_that_are_given_a_million_cells_away_lose_no_digit)
{
  constexpr int away = 1000003;
  const CGAL::Periodic_cell_2 cell(1, 0.1, 0.4, 0.9);
  Points points = scaled<Epick>(Cloud<Epick>(7).uniform(30), 1 / std::sqrt(30));
  for (auto& p : points)
    p = {p.x() + away * cell.ax(), p.y() + away * cell.ay()};
  ASSERT_NO_FATAL_FAILURE(expect_periodic(
      Periodic(points, cell), scaled<Epick>(Cloud<Epick>(8).uniform(9), 0.5, -0.3), away));
}

TEST(Interpolation, on_a_lattice_that_winds_all_ties_are_decided)
{
  const Periodic dt(scaled<Epick>(Cloud<Epick>::grid(4, 4), 0.25), CGAL::Periodic_cell_2(1, 1));
  ASSERT_NO_FATAL_FAILURE(
      expect_periodic(dt, {{0, 0}, {0.125, 0.125}, {0.125, 0}, {0.9375, -0.0625}, {1.3, 0.2}}));
}

// Where points and places are few and small integers or halves of them, everything that can
// coincide does: places are on points, edges, hulls and circles.
TEST(Interpolation, ties_of_all_kinds_are_decided_as_without_rounding)
{
  std::mt19937 random(10);
  for (int round = 0; round < 40; ++round) {
    SCOPED_TRACE(round);
    std::uniform_int_distribution<int> coordinate(0, 4), half(-1, 9);
    Points points, places;
    for (int i = 0; i < 14; ++i) {
      const int x = coordinate(random);
      points.emplace_back(x, coordinate(random));
    }
    for (int i = 0; i < 40; ++i) {
      const int x = half(random);
      places.emplace_back(x / 2.0, half(random) / 2.0);
    }
    const Plane dt(points.begin(), points.end());
    const Weights weights = natural(dt, places);
    const Exact_triangulation fresh = exact_triangulation(points);
    const auto where = [&](std::size_t entry) { return exact(dt.point(weights.ids()[entry])); };
    for (std::size_t place = 0; place < places.size(); ++place) {
      SCOPED_TRACE(place);
      ASSERT_NO_FATAL_FAILURE(
          expect_near(weights_at(weights, place, where), oracle(fresh, exact(places[place]))));
    }
    places.resize(6);
    points = scaled<Epick>(points, 0.25);
    places = scaled<Epick>(places, 0.25);
    ASSERT_NO_FATAL_FAILURE(expect_periodic(Periodic(points, CGAL::Periodic_cell_2(1, 1)), places));
  }
}

TEST(Interpolation, in_a_slab_there_is_an_outside_and_a_border)
{
  const Points points{{0.1, 0}, {0.6, 0}, {0.3, 0.5}, {0.8, 0.75}, {0.2, 1}, {0.7, 1}};
  const Periodic dt(points, CGAL::Periodic_cell_2::slab(1, 0));
  ASSERT_NO_FATAL_FAILURE(expect_periodic(
      dt, {{0.3, 0}, {0.95, 1}, {1.1, 0}, {0.5, 0.5}, {-0.7, 0.25}, {0.4, -0.1}, {0.4, 1.5}}));
  Weights weights;
  const Points outside{{0.4, -1e-300}, {7, 1 + 0x1p-52}, {0.3, 1e-300}};
  weights.compute_linear(dt, outside.begin(), outside.end());
  EXPECT_TRUE(weights.is_outside(0));
  EXPECT_TRUE(weights.is_outside(1));
  EXPECT_FALSE(weights.is_outside(2));
}

TEST(Interpolation, without_faces_there_is_only_outside)
{
  const Points place{{0.5, 0.5}};
  Weights weights;
  weights.compute_linear(Periodic(CGAL::Periodic_cell_2(1, 1)), place.begin(), place.end());
  EXPECT_TRUE(weights.is_outside(0));
  weights.compute_linear(Periodic(Points{{0, 0.5}, {0.4, 0.5}}, CGAL::Periodic_cell_2::slab(1, 0)),
                         place.begin(), place.end());
  EXPECT_TRUE(weights.is_outside(0));
}

} // namespace

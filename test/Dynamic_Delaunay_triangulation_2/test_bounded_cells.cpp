// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Voronoi cells that end at a radius or at the walls of a domain, against sweeps around their
// points that know no Delaunay neighbors, in long double.

#include "oracle.h"
#include "visible_cell.h"

#include <CGAL/Dynamic_Delaunay_triangulation_2/queries/Bounded_voronoi_cells_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/queries/Bounded_voronoi_gradients_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/queries/Bounded_voronoi_surface_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/queries/Voronoi_cell_gradients_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/queries/Voronoi_cell_measures_2.h>
#include <CGAL/Dynamic_periodic_Delaunay_triangulation_2.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <numeric>
#include <random>
#include <set>
#include <utility>
#include <vector>

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

using namespace domain_oracle;
using Point = Epick::Point_2;
using Numbers = std::vector<double>;
using Plane = CGAL::Dynamic_Delaunay_triangulation_2<Epick>;
using Torus = CGAL::Dynamic_periodic_Delaunay_triangulation_2<Epick>;
using Cells = CGAL::Bounded_voronoi_cells_2;
using Side = Cells::Side;

Plane triangulation(const Points& points)
{
  return Plane(points.begin(), points.end());
}

double sum(const Numbers& numbers)
{
  return std::accumulate(numbers.begin(), numbers.end(), 0.0);
}

Real between(std::mt19937& random, double low, double high)
{
  return std::uniform_real_distribution<double>(low, high)(random);
}

// -------------------------------------------------------------------------------------------------
// Comparison with sweeps: the cells are convex, so all of a cell is visible from its point.

// The lines of all images that are no farther than `reach`.
std::vector<Line> lines_around_images(const Points& points, std::size_t id,
                                      const CGAL::Periodic_cell_2& cell, Real reach)
{
  std::vector<Line> lines;
  for (std::size_t j = 0; j < points.size(); ++j)
    for (int s = -7; s <= 7; ++s)
      for (int t = -7; t <= 7; ++t)
        if (j != id || s != 0 || t != 0) {
          const Line line = bisector(points[id], points[j].x() + s * cell.ax() + t * cell.bx(),
                                     points[j].y() + s * cell.ay() + t * cell.by(), j);
          if (line.distance(vector(points[id])) <= reach)
            lines.push_back(line);
        }
  return lines;
}

std::map<std::size_t, Real> contacts_of(const Cells& cells, std::size_t id)
{
  std::map<std::size_t, Real> contacts;
  for (std::size_t i = cells.first_pieces()[id]; i < cells.first_pieces()[id + 1]; ++i)
    if (cells.pieces()[i].side == Side::NEIGHBOR)
      contacts[cells.pieces()[i].other] += cells.pieces()[i].length;
  return contacts;
}

// Expects lengths within rounding of the size of the whole, and areas within a relative 1e-12.
void expect_swept(const Cells& cells, std::size_t id, const Measured& swept, double unit)
{
  SCOPED_TRACE(testing::Message() << "id " << id);
  const double error = 1e-13 * unit;
  ASSERT_NEAR(cells.areas()[id], double(swept.area), 1e-12 * double(swept.area));
  ASSERT_NEAR(cells.perimeters()[id], double(swept.perimeter), 10 * error);
  ASSERT_NEAR(cells.wall_lengths()[id], double(swept.wall), 10 * error);
  ASSERT_NEAR(cells.free_lengths()[id], double(swept.free), 10 * error);
  auto contacts = contacts_of(cells, id);
  for (const auto& [other, length] : swept.contacts)
    ASSERT_NEAR(double(contacts[other]), double(length), 10 * error) << "with " << other;
  for (const auto& [other, length] : contacts)
    ASSERT_TRUE(length < error || swept.contacts.count(other) == 1) << "with " << other;
}

// Expects that each piece of the boundary of a cell begins where the one before it ends.
void expect_closed(const Cells& cells, std::size_t id, double unit)
{
  const std::size_t first = cells.first_pieces()[id], beyond = cells.first_pieces()[id + 1];
  double length = 0;
  for (std::size_t i = first; i < beyond; ++i) {
    const auto &piece = cells.pieces()[i], &next = cells.pieces()[i + 1 < beyond ? i + 1 : first];
    ASSERT_GT(piece.length, 0);
    ASSERT_NEAR(piece.to.x, next.from.x, 1e-12 * unit);
    ASSERT_NEAR(piece.to.y, next.from.y, 1e-12 * unit);
    length += piece.length;
  }
  ASSERT_NEAR(length, cells.perimeters()[id], 1e-13 * unit);
}

// -------------------------------------------------------------------------------------------------
// Discs.

std::vector<Points> clouds()
{
  Cloud<Epick> cloud(1);
  return {cloud.uniform(2), cloud.uniform(30), Cloud<Epick>::grid(6, 5),
          Cloud<Epick>::on_circle(30), cloud.on_line(12)};
}

TEST(Discs, are_cut_by_the_bisectors_of_all_other_points)
{
  for (const Points& points : clouds()) {
    const Plane dt = triangulation(points);
    if (dt.number_of_vertices() < points.size())
      continue;
    for (const double radius : {0.01, 0.4, 0.5, 0.7, 1.0, 5.0, 65.0, 1000.0}) {
      SCOPED_TRACE(testing::Message() << points.size() << " points, radius " << radius);
      Cells cells;
      cells.compute(dt, radius);
      const Numbers radii(points.size(), radius);
      for (std::size_t id = 0; id < points.size(); ++id) {
        const Visible_cell sweep(points[id], lines_around(points, id, {}), radius);
        ASSERT_NO_FATAL_FAILURE(expect_swept(cells, id, sweep.measure(radii), radius));
        ASSERT_NO_FATAL_FAILURE(expect_closed(cells, id, radius));
      }
    }
  }
}

TEST(Discs, touch_where_both_of_them_reach_if_their_radii_differ)
{
  std::mt19937 random(2);
  for (int round = 0; round < 40; ++round) {
    SCOPED_TRACE(testing::Message() << "round " << round);
    const Points points = Cloud<Epick>(unsigned(round)).uniform(40);
    Numbers radii;
    for (std::size_t id = 0; id < points.size(); ++id)
      radii.push_back(double(between(random, 0.05, 1.5)));
    Cells cells;
    cells.compute(triangulation(points), radii);
    for (std::size_t id = 0; id < points.size(); ++id) {
      const Visible_cell sweep(points[id], lines_around(points, id, {}), radii[id]);
      ASSERT_NO_FATAL_FAILURE(expect_swept(cells, id, sweep.measure(radii), 2));
      ASSERT_NO_FATAL_FAILURE(expect_closed(cells, id, 2));
      for (const auto& [other, length] : contacts_of(cells, id))
        ASSERT_NEAR(double(contacts_of(cells, other)[id]), double(length), 1e-13);
    }
  }
}

TEST(Discs, are_whole_where_no_other_one_is_near)
{
  Cells cells;
  cells.compute(triangulation({Point(3, 4)}), 2);
  EXPECT_DOUBLE_EQ(cells.areas()[0], double(4 * pi));
  EXPECT_DOUBLE_EQ(cells.free_lengths()[0], double(4 * pi));
  ASSERT_EQ(cells.pieces().size(), 1u);
  EXPECT_DOUBLE_EQ(cells.pieces()[0].angle, double(2 * pi));
  EXPECT_DOUBLE_EQ(cells.centroids()[0].x, 3);
  cells.compute(triangulation({Point(0, 0), Point(4, 0)}), 2); // they touch in one point
  EXPECT_DOUBLE_EQ(cells.areas()[1], double(4 * pi));
  EXPECT_TRUE(contacts_of(cells, 0).empty());
  cells.compute(triangulation({}), 2);
  EXPECT_TRUE(cells.areas().empty());
  EXPECT_EQ(cells.first_pieces(), std::vector<std::size_t>{0});
}

TEST(Discs, that_hardly_overlap_are_neither_whole_nor_empty)
{
  for (double distance = 2; distance > 1.999; distance -= 1e-5) {
    const Points points{Point(0, 0), Point(distance, 0)};
    Cells cells;
    cells.compute(triangulation(points), 1);
    const Visible_cell sweep(points[0], lines_around(points, 0, {}), 1);
    ASSERT_NO_FATAL_FAILURE(expect_swept(cells, 0, sweep.measure({1, 1}), 1));
  }
  // a sliver between two bisectors far away from each other, and nothing else
  for (const double gap : {1e-3, 1e-6, 1e-9, 1e-12, 1e-15}) {
    const Points points{Point(0, 0), Point(gap, 0), Point(-gap, 0)};
    Cells cells;
    cells.compute(triangulation(points), 1);
    const double chord = 2 * std::sqrt(1 - gap * gap / 4), arc = 2 * std::asin(gap / 2);
    ASSERT_NEAR(cells.areas()[0], (gap * chord + 2 * arc) / 2, 1e-15 * gap);
    ASSERT_NEAR(cells.free_lengths()[0], 2 * arc, 1e-14 * gap);
    ASSERT_NEAR(cells.perimeters()[0], 2 * chord + 2 * arc, 1e-15);
  }
}

// -------------------------------------------------------------------------------------------------
// Domains.

const Points corners_of_triangle{Point(-1, -2), Point(9, 1), Point(2, 8)};
const Points corners_of_trapezium{Point(-0.5, -0.25), Point(6, 0), Point(4, 5.5), Point(0.125, 6)};
const Polygon triangle(corners_of_triangle.begin(), corners_of_triangle.end());
const Polygon trapezium(corners_of_trapezium.begin(), corners_of_trapezium.end());

TEST(Domains, end_cells_at_their_walls)
{
  for (const Polygon& domain : {triangle, trapezium})
    for (const double radius : {0.3, 0.8, 3.0, infinity}) {
      SCOPED_TRACE(testing::Message() << domain.size() << " walls, radius " << radius);
      const Points points = Cloud<Epick>(7).uniform(40);
      Cells cells;
      cells.set_domain(domain.begin(), domain.end());
      cells.compute(triangulation(points), radius);
      const Numbers radii(points.size(), radius);
      int inside = 0;
      for (std::size_t id = 0; id < points.size(); ++id) {
        ASSERT_NO_FATAL_FAILURE(expect_closed(cells, id, 10));
        if (!domain.has_on_bounded_side(points[id]))
          continue;
        ++inside;
        const Visible_cell sweep(points[id], lines_around(points, id, Domain(domain)), radius);
        ASSERT_NO_FATAL_FAILURE(expect_swept(cells, id, sweep.measure(radii), 10));
      }
      EXPECT_GT(inside, 10);
    }
}

TEST(Domains, are_filled_by_cells_without_radius_wherever_the_points_are)
{
  for (const Polygon& domain : {triangle, trapezium})
    for (const std::size_t number : {1u, 2u, 3u, 50u, 2000u}) {
      Cells cells;
      cells.set_domain(domain.begin(), domain.end());
      const Points points = Cloud<Epick>(3).uniform(number);
      cells.compute(triangulation(points), infinity);
      EXPECT_NEAR(sum(cells.areas()), domain.area(), 1e-13 * domain.area());
      EXPECT_EQ(sum(cells.free_lengths()), 0);
      double walls = 0;
      for (std::size_t i = 0; i < domain.size(); ++i)
        walls += std::sqrt(CGAL::squared_distance(domain[i], domain[(i + 1) % domain.size()]));
      EXPECT_NEAR(sum(cells.wall_lengths()), walls, 1e-13 * walls);
    }
}

TEST(Domains, that_are_boxes_have_the_cells_of_measures_in_a_box)
{
  const Points points = Cloud<Epick>(4).uniform(300);
  const CGAL::Bbox_2 box(2, -1, 15, 20);
  const Plane dt = triangulation(points);
  Cells cells;
  cells.set_domain(box);
  cells.compute(dt, infinity);
  CGAL::Voronoi_cell_measures_2 measures;
  measures.compute(dt, box);
  for (std::size_t id = 0; id < points.size(); ++id) {
    EXPECT_NEAR(cells.areas()[id], measures.areas()[id], 1e-12);
    EXPECT_NEAR(cells.perimeters()[id], measures.perimeters()[id], 1e-12);
    if (cells.areas()[id] > 1e-6) {
      EXPECT_NEAR(cells.centroids()[id].x, measures.centroids()[id].x, 1e-8);
      EXPECT_NEAR(cells.centroids()[id].y, measures.centroids()[id].y, 1e-8);
    }
  }
}

TEST(Domains, may_have_points_outside_whose_cells_reach_in)
{
  Cells cells;
  cells.set_domain(CGAL::Bbox_2(-1, -5, 1, 5));
  cells.compute(triangulation({Point(1.5, 0.5)}), 1); // a segment of a disc
  const double angle = 2 * std::acos(0.5);
  EXPECT_NEAR(cells.areas()[0], (angle - std::sin(angle)) / 2, 1e-14);
  EXPECT_NEAR(cells.wall_lengths()[0], std::sqrt(3), 1e-14);
  cells.compute(triangulation({Point(3, 3)}), 1);
  EXPECT_EQ(cells.areas()[0], 0);
  EXPECT_EQ(cells.centroids()[0].x, 3);
  EXPECT_TRUE(cells.pieces().empty());
  cells.compute(triangulation({Point(3, 3)}), 100);
  EXPECT_NEAR(cells.areas()[0], 20, 1e-12);
  cells.compute(triangulation({Point(1, 0.5)}), 0.25); // on a wall
  EXPECT_NEAR(cells.areas()[0], double(pi) / 32, 1e-15);
  EXPECT_NEAR(cells.wall_lengths()[0], 0.5, 1e-15);
  cells.remove_domain();
  cells.compute(triangulation({Point(3, 3)}), 1);
  EXPECT_DOUBLE_EQ(cells.areas()[0], double(pi));
}

TEST(Domains, must_be_convex_and_counterclockwise)
{
  Cells cells;
  const auto refused_corner = [&](const Points& corners) {
    try {
      cells.set_domain(corners.begin(), corners.end());
    } catch (const CGAL::Domain_error_2& error) {
      return int(error.corner());
    }
    return -1;
  };
  EXPECT_EQ(refused_corner({Point(0, 0), Point(1, 0)}), 2);
  EXPECT_EQ(refused_corner({Point(0, 0), Point(0, 1), Point(1, 0)}), 0);
  EXPECT_EQ(refused_corner({Point(0, 0), Point(4, 0), Point(2, 1), Point(0, 4)}), 2);
  EXPECT_EQ(refused_corner({Point(0, 0), Point(4, 0), Point(8, 0), Point(0, 4)}), 1);
  EXPECT_EQ(refused_corner({Point(0, 0), Point(1, 0), Point(0, infinity)}), 2);
  Points star;
  for (int i = 0; i < 5; ++i)
    star.push_back(Point(std::cos(i * 4 * double(pi) / 5), std::sin(i * 4 * double(pi) / 5)));
  EXPECT_EQ(refused_corner(star), 0);
  EXPECT_THROW(cells.set_domain(CGAL::Bbox_2(0, 0, 0, 1)), CGAL::Domain_error_2);
  // the last valid domain stays, and is refused in periodic space
  EXPECT_EQ(refused_corner(corners_of_trapezium), -1);
  EXPECT_EQ(refused_corner(star), 0);
  cells.compute(triangulation({Point(1, 1)}), infinity);
  EXPECT_NEAR(cells.areas()[0], trapezium.area(), 1e-12);
  const Points point{Point(1, 1)};
  const Torus torus(point.begin(), point.end(), CGAL::Periodic_cell_2(5, 5));
  EXPECT_THROW(cells.compute(torus, 1), CGAL::Domain_error_2);
  EXPECT_NEAR(cells.areas()[0], trapezium.area(), 1e-12);
}

// -------------------------------------------------------------------------------------------------
// Periodic space.

TEST(Periodic_cells, are_cut_by_the_bisectors_of_all_images)
{
  for (const CGAL::Periodic_cell_2& cell :
       {CGAL::Periodic_cell_2(5, 5), CGAL::Periodic_cell_2(4, 0, 9, 4)})
    for (const std::size_t number : {1u, 2u, 20u}) {
      const Points points = Cloud<Epick>(5).uniform(number);
      const Torus dt(points.begin(), points.end(), cell);
      for (const double radius : {0.3, 0.8, 1.9, 30.0}) {
        SCOPED_TRACE(testing::Message() << number << " points, radius " << radius);
        Cells cells;
        cells.compute(dt, radius);
        const Numbers radii(points.size(), radius);
        for (std::size_t id = 0; id < points.size(); ++id) {
          const auto lines = lines_around_images(points, id, cell, number < 20 ? 5 : 2);
          const Visible_cell sweep(points[id], lines, radius);
          ASSERT_NO_FATAL_FAILURE(expect_swept(cells, id, sweep.measure(radii), 10));
          ASSERT_NO_FATAL_FAILURE(expect_closed(cells, id, 10));
        }
      }
    }
}

// An arc from one corner of a cell to another was missing where both were on the circle.
TEST(Corners, may_be_on_the_circle)
{
  // a tangent contact is off by the root of rounding, some 5e-8, and a cell can have eight
  constexpr double error = 1e-6;
  std::mt19937 random(15);
  const auto below = [&](int n) { return int(random() % unsigned(n)); };
  const CGAL::Periodic_cell_2 periodic_cell(4, 4);
  const Points corners{Point(0.25, 0.25), Point(3.75, 0.25), Point(3.75, 3.25), Point(0.25, 3.25)};
  const Domain domain(Polygon(corners.begin(), corners.end()));
  for (int round = 0; round < 400; ++round) {
    SCOPED_TRACE(testing::Message() << "round " << round);
    const double steps[] = {0.5, std::sqrt(0.5), 1, std::sqrt(1.25), std::sqrt(2.0), 1.25, 1.5};
    std::set<std::pair<int, int>> places;
    for (int i = 1 + below(12); i > 0; --i)
      places.insert({below(4), below(4)});
    Points points;
    Numbers radii;
    const double common = steps[below(7)];
    const bool have_one = below(2) == 0;
    for (const auto& [x, y] : places) {
      points.emplace_back(x, y);
      radii.push_back(have_one ? common : steps[below(7)]);
    }
    const auto expect = [&](const Cells& cells, std::size_t id, const std::vector<Line>& lines) {
      const Measured swept = Visible_cell(points[id], lines, radii[id]).measure(radii);
      ASSERT_NEAR(cells.areas()[id], double(swept.area), 1e-12) << "id " << id;
      ASSERT_NEAR(cells.perimeters()[id], double(swept.perimeter), 1e-12) << "id " << id;
      ASSERT_NEAR(cells.free_lengths()[id], double(swept.free), error) << "id " << id;
      ASSERT_NO_FATAL_FAILURE(expect_closed(cells, id, 2));
    };
    Cells cells;
    cells.compute(triangulation(points), radii);
    for (std::size_t id = 0; id < points.size(); ++id)
      ASSERT_NO_FATAL_FAILURE(expect(cells, id, lines_around(points, id, {})));
    cells.compute(Torus(points.begin(), points.end(), periodic_cell), radii);
    for (std::size_t id = 0; id < points.size(); ++id)
      ASSERT_NO_FATAL_FAILURE(expect(cells, id, lines_around_images(points, id, periodic_cell, 2)));
    cells.set_domain(corners.begin(), corners.end());
    cells.compute(triangulation(points), radii);
    for (std::size_t id = 0; id < points.size(); ++id)
      if (domain.outer_boundary().has_on_bounded_side(points[id])) {
        ASSERT_NO_FATAL_FAILURE(expect(cells, id, lines_around(points, id, domain)));
      }
  }
}

TEST(Periodic_cells, fill_the_cell_if_their_radius_is_large)
{
  const Points points = Cloud<Epick>(6).uniform(500);
  const Torus dt(points.begin(), points.end(), CGAL::Periodic_cell_2(30, 10, -5, 20));
  Cells cells;
  cells.compute(dt, 1000);
  EXPECT_NEAR(sum(cells.areas()), 650, 1e-13 * 650);
  for (const auto& piece : cells.pieces())
    ASSERT_EQ(piece.side, Side::NEIGHBOR);
}

// -------------------------------------------------------------------------------------------------
// Ids.

TEST(Ids, that_are_removed_have_nothing_and_those_that_coincide_share)
{
  Points points = Cloud<Epick>(8).uniform(60);
  points[20] = points[40] = points[7];
  Plane dt = triangulation(points);
  dt.remove(3);
  Cells cells;
  cells.compute(dt, 0.8);
  EXPECT_EQ(cells.areas()[3], 0);
  EXPECT_EQ(cells.first_pieces()[3], cells.first_pieces()[4]);
  std::size_t with_pieces = 0;
  for (const std::size_t id : {7u, 20u, 40u}) {
    EXPECT_EQ(cells.areas()[id], cells.areas()[7]);
    EXPECT_EQ(cells.perimeters()[id], cells.perimeters()[7]);
    with_pieces += cells.first_pieces()[id] < cells.first_pieces()[id + 1];
  }
  EXPECT_EQ(with_pieces, 1u);
  Cells of_one;
  dt.remove(20);
  dt.remove(40);
  of_one.compute(dt, 0.8);
  EXPECT_DOUBLE_EQ(3 * cells.areas()[7], of_one.areas()[7]);
}

// Expects measures that are equal to the last bit.
void expect_equal_measures(const Cells& cells, const Cells& others)
{
  EXPECT_EQ(cells.areas(), others.areas());
  EXPECT_EQ(cells.perimeters(), others.perimeters());
  EXPECT_EQ(cells.wall_lengths(), others.wall_lengths());
  EXPECT_EQ(cells.free_lengths(), others.free_lengths());
  EXPECT_EQ(cells.radii(), others.radii());
  for (std::size_t id = 0; id < cells.centroids().size(); ++id) {
    EXPECT_EQ(cells.centroids()[id].x, others.centroids()[id].x);
    EXPECT_EQ(cells.centroids()[id].y, others.centroids()[id].y);
  }
}

TEST(Measures, are_equal_without_pieces)
{
  Points points = Cloud<Epick>(11).uniform(300);
  points[20] = points[40] = points[7];
  Plane dt = triangulation(points);
  const Torus torus(points, CGAL::Periodic_cell_2(20, 20));
  dt.remove(3);
  Numbers radii(points.size());
  for (std::size_t id = 0; id < radii.size(); ++id)
    radii[id] = 0.3 + double(id % 7) / 8;
  Cells cells, measured;
  const auto expect_equal = [&](const auto& dynamic, const auto& radius) {
    cells.compute(dynamic, radius);
    measured.compute_measures(dynamic, radius);
    expect_equal_measures(cells, measured);
    EXPECT_TRUE(cells.has_pieces());
    EXPECT_FALSE(measured.has_pieces());
    EXPECT_TRUE(measured.pieces().empty());
    EXPECT_EQ(measured.first_pieces(), std::vector<std::size_t>(points.size() + 1, 0));
  };
  expect_equal(dt, 0.8);
  expect_equal(dt, radii);
  expect_equal(torus, 0.8);
  expect_equal(torus, radii);
  for (Cells* both : {&cells, &measured})
    both->set_domain(triangle.begin(), triangle.end());
  expect_equal(dt, infinity);
  expect_equal(dt, radii);
  EXPECT_THROW(measured.compute_measures(dt, -1.0), CGAL::Parameter_error_2);
  EXPECT_THROW(measured.compute_measures(dt, Numbers(9, 1)), CGAL::Point_count_error_2);
  expect_equal_measures(cells, measured); // nothing has changed
  measured.compute(dt, radii);
  EXPECT_EQ(measured.first_pieces(), cells.first_pieces());
}

TEST(Radii, must_be_positive_and_as_many_as_ids)
{
  const Plane dt = triangulation(Cloud<Epick>(9).uniform(10));
  Cells cells;
  cells.compute(dt, 1);
  const Numbers areas = cells.areas();
  for (const double radius : {0.0, -1.0, nan, infinity, 1e200}) {
    EXPECT_THROW(cells.compute(dt, radius), CGAL::Parameter_error_2);
    Numbers radii(10, 1);
    radii[4] = radius;
    EXPECT_THROW(cells.compute(dt, radii), CGAL::Parameter_error_2);
  }
  EXPECT_THROW(cells.compute(dt, Numbers(9, 1)), CGAL::Point_count_error_2);
  EXPECT_EQ(cells.areas(), areas);
}

// -------------------------------------------------------------------------------------------------
// Gradients, against differences of an energy that has another weight for every area and length.

// A weight that depends only on what is on both sides of the piece.
double length_weight(const Cells::Piece& piece, std::size_t id)
{
  const double other = piece.angle > 0 ? 99 : double(piece.other);
  return std::sin(double(id + 1) * (other + 2.5) + 7.3 * int(piece.side) + 3 * piece.shift[0] +
                  5.7 * piece.shift[1]);
}
double area_weight(std::size_t id)
{
  return std::cos(3.7 * double(id));
}

struct Energy
{
  double value = 0;
  Numbers area_weights{}, length_weights{};

  explicit Energy(const Cells& cells)
  {
    for (std::size_t id = 0; id < cells.areas().size(); ++id) {
      area_weights.push_back(area_weight(id));
      value += area_weight(id) * cells.areas()[id];
      for (std::size_t i = cells.first_pieces()[id]; i < cells.first_pieces()[id + 1]; ++i) {
        length_weights.push_back(length_weight(cells.pieces()[i], id));
        value += length_weights.back() * cells.pieces()[i].length;
      }
    }
  }
};

template <class Triangulation>
void expect_gradients(Triangulation& dt, const Points& points, const Numbers& radii,
                      const Polygon& domain)
{
  Cells cells;
  if (!domain.is_empty())
    cells.set_domain(domain.begin(), domain.end());
  const auto energy = [&](const Points& where, const Numbers& reach) {
    dt.update(where.begin(), where.end());
    cells.compute(dt, reach);
    return Energy(cells);
  };
  const Energy here = energy(points, radii);
  CGAL::Bounded_voronoi_gradients_2 gradients;
  gradients.compute(dt, cells, here.area_weights, here.length_weights);
  const double step = 1e-6;
  // The change of energy as a point moves by (x, y) and radii grow by `growth`, per unit of time.
  const auto difference = [&](std::size_t id, double x, double y, const Numbers& growth) {
    const auto at = [&](double t) {
      Points moved = points;
      moved[id] = Point(points[id].x() + t * x, points[id].y() + t * y);
      Numbers reach = radii;
      for (std::size_t i = 0; i < reach.size(); ++i)
        reach[i] += t * growth[i];
      return energy(moved, reach).value;
    };
    return (at(step) - at(-step)) / (2 * step);
  };
  const Numbers none(points.size(), 0);
  for (std::size_t id = 0; id < points.size(); ++id) {
    SCOPED_TRACE(testing::Message() << "id " << id);
    const auto& gradient = gradients.by_positions()[id];
    const double size = 1 + std::abs(gradient.x) + std::abs(gradient.y);
    ASSERT_NEAR(gradient.x, difference(id, 1, 0, none), 1e-6 * size);
    ASSERT_NEAR(gradient.y, difference(id, 0, 1, none), 1e-6 * size);
    const double by_radius = gradients.by_radii()[id];
    Numbers growth = none;
    growth[id] = 1;
    if (radii[0] != radii[1]) { // a contact between equal radii ends where the smaller one does
      ASSERT_NEAR(by_radius, difference(id, 0, 0, growth), 1e-6 * (1 + std::abs(by_radius)));
    }
  }
  if (std::isfinite(radii[0])) {
    ASSERT_NEAR(sum(gradients.by_radii()), difference(0, 0, 0, Numbers(points.size(), 1)),
                1e-5 * double(points.size()));
  }
}

TEST(Gradients, are_limits_of_differences_in_the_plane)
{
  std::mt19937 random(11);
  for (unsigned seed = 1; seed <= 8; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    const Points points = Cloud<Epick>(seed).uniform(25);
    Plane dt = triangulation(points);
    Numbers radii(points.size(), 0.7);
    ASSERT_NO_FATAL_FAILURE(expect_gradients(dt, points, radii, {}));
    ASSERT_NO_FATAL_FAILURE(expect_gradients(dt, points, radii, trapezium));
    ASSERT_NO_FATAL_FAILURE(
        expect_gradients(dt, points, Numbers(points.size(), infinity), trapezium));
    for (double& radius : radii)
      radius = double(between(random, 0.2, 1.2));
    ASSERT_NO_FATAL_FAILURE(expect_gradients(dt, points, radii, {}));
    ASSERT_NO_FATAL_FAILURE(expect_gradients(dt, points, radii, triangle));
  }
}

TEST(Gradients, are_limits_of_differences_in_periodic_space)
{
  std::mt19937 random(12);
  for (unsigned seed = 1; seed <= 8; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    const Points points = Cloud<Epick>(seed).uniform(20);
    Torus dt(points.begin(), points.end(), CGAL::Periodic_cell_2(5, 1, -0.5, 4));
    Numbers radii(points.size(), 0.6);
    ASSERT_NO_FATAL_FAILURE(expect_gradients(dt, points, radii, {}));
    ASSERT_NO_FATAL_FAILURE(expect_gradients(dt, points, Numbers(points.size(), 50), {}));
    for (double& radius : radii)
      radius = double(between(random, 0.2, 1.2));
    ASSERT_NO_FATAL_FAILURE(expect_gradients(dt, points, radii, {}));
  }
}

TEST(Gradients, by_radius_of_a_whole_disc_are_its_circumference)
{
  const Plane dt = triangulation({Point(3, 4)});
  Cells cells;
  cells.compute(dt, 2);
  CGAL::Bounded_voronoi_gradients_2 gradients;
  gradients.compute(dt, cells, {1}, {10});
  EXPECT_DOUBLE_EQ(gradients.by_radii()[0], double(4 * pi + 20 * pi));
  EXPECT_EQ(gradients.by_positions()[0].x, 0);
  EXPECT_THROW(gradients.compute(dt, cells, {1, 1}, {10}), CGAL::Point_count_error_2);
  EXPECT_THROW(gradients.compute(dt, cells, {1}, {}), CGAL::Point_count_error_2);
}

// -------------------------------------------------------------------------------------------------
// Surfaces.

// The number of connected components of points that are joined by contacts.
std::size_t components(const Cells& cells)
{
  std::vector<std::size_t> root(cells.areas().size());
  std::iota(root.begin(), root.end(), std::size_t(0));
  const auto find = [&](std::size_t id) {
    while (root[id] != id)
      id = root[id];
    return id;
  };
  for (std::size_t id = 0; id < root.size(); ++id)
    for (const auto& contact : contacts_of(cells, id))
      root[find(id)] = find(contact.first);
  std::size_t number = 0;
  for (std::size_t id = 0; id < root.size(); ++id)
    number += root[id] == id;
  return number;
}

// Edges with a contact, and faces whose circumcenter is in the discs: with the points they have the
// homotopy type of the union of the discs (H. Edelsbrunner, 1995).
long euler_characteristic(const Plane& dt, const Cells& cells, double radius)
{
  long edges = 0, faces = 0;
  for (std::size_t id = 0; id < cells.areas().size(); ++id)
    for (const auto& contact : contacts_of(cells, id))
      edges += contact.first > id;
  for (const auto& face : dt.triangulation().finite_face_handles()) {
    const Point &p = face->vertex(0)->point(), &q = face->vertex(1)->point(),
                &r = face->vertex(2)->point();
    faces += std::sqrt(CGAL::squared_radius(p, q, r)) < radius;
  }
  return long(cells.areas().size()) - edges + faces;
}

TEST(Surfaces, surround_every_component_and_every_hole)
{
  for (unsigned seed = 1; seed <= 10; ++seed)
    for (const double radius : {0.2, 0.45, 0.6, 0.75, 0.9, 1.2}) {
      SCOPED_TRACE(testing::Message() << "seed " << seed << ", radius " << radius);
      const Plane dt = triangulation(Cloud<Epick>(seed).uniform(200));
      Cells cells;
      cells.compute(dt, radius);
      CGAL::Bounded_voronoi_surface_2 surface;
      surface.compute(cells);
      long outer = 0, holes = 0;
      double length = 0;
      for (std::size_t line = 0; line < surface.number_of_lines(); ++line) {
        ASSERT_TRUE(surface.is_closed(line));
        (surface.areas()[line] > 0 ? outer : holes) += 1;
        const std::size_t first = surface.first_pieces()[line],
                          beyond = surface.first_pieces()[line + 1];
        for (std::size_t i = first; i < beyond; ++i) {
          const auto& piece = cells.pieces()[surface.pieces()[i]];
          const auto& next = cells.pieces()[surface.pieces()[i + 1 < beyond ? i + 1 : first]];
          ASSERT_EQ(piece.side, Side::FREE);
          ASSERT_GT(cells.free_lengths()[surface.ids()[i]], 0);
          ASSERT_NEAR(piece.to.x, next.from.x, 1e-12);
          ASSERT_NEAR(piece.to.y, next.from.y, 1e-12);
          length += piece.length;
        }
      }
      ASSERT_EQ(outer, long(components(cells)));
      ASSERT_EQ(outer - holes, euler_characteristic(dt, cells, radius));
      ASSERT_NEAR(sum(surface.areas()), sum(cells.areas()), 1e-11);
      ASSERT_NEAR(length, sum(cells.free_lengths()), 1e-11);
    }
}

TEST(Surfaces, go_from_wall_to_wall_where_a_domain_cuts_them)
{
  Cells cells;
  cells.set_domain(CGAL::Bbox_2(0, 0, 4, 1));
  cells.compute(triangulation({Point(0.5, 0.5), Point(1.5, 0.5), Point(3.5, 0.5)}), 0.7);
  CGAL::Bounded_voronoi_surface_2 surface;
  surface.compute(cells);
  // one in each of four corners, two in the gap, and one each above and below the contact
  EXPECT_EQ(surface.number_of_lines(), 8u);
  for (std::size_t line = 0; line < surface.number_of_lines(); ++line)
    EXPECT_FALSE(surface.is_closed(line));
  cells.remove_domain();
  cells.compute(triangulation({Point(0.5, 0.5)}), 0.7);
  surface.compute(cells); // a whole circle
  ASSERT_EQ(surface.number_of_lines(), 1u);
  EXPECT_NEAR(surface.areas()[0], double(pi) * 0.49, 1e-14);
  cells.compute(triangulation({}), 1);
  surface.compute(cells);
  EXPECT_EQ(surface.number_of_lines(), 0u);
}

TEST(Surfaces, are_made_of_all_that_is_free_whatever_the_radii_and_in_periodic_space)
{
  std::mt19937 random(13);
  for (unsigned seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    const Points points = Cloud<Epick>(seed).uniform(100);
    Numbers radii;
    for (std::size_t id = 0; id < points.size(); ++id)
      radii.push_back(double(between(random, 0.2, 1)));
    Cells of_plane, of_torus;
    of_plane.compute(triangulation(points), radii);
    of_torus.compute(Torus(points.begin(), points.end(), CGAL::Periodic_cell_2(10, 10)), radii);
    for (const Cells* cells : {&of_plane, &of_torus}) {
      CGAL::Bounded_voronoi_surface_2 surface;
      surface.compute(*cells);
      double length = 0;
      for (const std::size_t piece : surface.pieces())
        length += cells->pieces()[piece].length;
      ASSERT_NEAR(length, sum(cells->free_lengths()), 1e-11);
      for (std::size_t line = 0; line < surface.number_of_lines(); ++line)
        ASSERT_TRUE(surface.is_closed(line));
    }
  }
}

// Areas mixed the images of points on both sides of the border.
TEST(Surfaces, enclose_equal_areas_wherever_the_border_of_a_periodic_cell_is)
{
  std::mt19937 random(14);
  const CGAL::Periodic_cell_2 cell(10, 10);
  for (const int size : {40, 160}) { // of 1/16: alone in the middle, and all around
    for (unsigned seed = 1; seed <= 10; ++seed) {
      SCOPED_TRACE(testing::Message() << "size " << size << ", seed " << seed);
      Points here, there;
      for (int i = 0; i < size; ++i) {
        const int x = int(random() % unsigned(size)), y = int(random() % unsigned(size));
        here.emplace_back(x / 16.0, y / 16.0);
        there.emplace_back((x + 140) % 160 / 16.0, (y + 150) % 160 / 16.0);
      }
      Cells cells, moved;
      cells.compute(Torus(here.begin(), here.end(), cell), 0.6);
      moved.compute(Torus(there.begin(), there.end(), cell), 0.6);
      CGAL::Bounded_voronoi_surface_2 surface, of_moved;
      surface.compute(cells);
      of_moved.compute(moved);
      ASSERT_EQ(of_moved.number_of_lines(), surface.number_of_lines());
      Numbers areas, areas_of_moved;
      CGAL::Periodic_shift_2 winding{0, 0};
      for (std::size_t line = 0; line < surface.number_of_lines(); ++line) {
        ASSERT_TRUE(of_moved.is_closed(line));
        const CGAL::Periodic_shift_2 turns = of_moved.windings()[line];
        ASSERT_EQ(std::isnan(of_moved.areas()[line]), turns[0] != 0 || turns[1] != 0);
        winding = {winding[0] + turns[0], winding[1] + turns[1]};
        if (!std::isnan(of_moved.areas()[line]))
          areas_of_moved.push_back(of_moved.areas()[line]);
        if (!std::isnan(surface.areas()[line]))
          areas.push_back(surface.areas()[line]);
      }
      EXPECT_EQ(winding, (CGAL::Periodic_shift_2{0, 0})); // all of them bound the cells
      std::sort(areas.begin(), areas.end());
      std::sort(areas_of_moved.begin(), areas_of_moved.end());
      ASSERT_EQ(areas.size(), areas_of_moved.size());
      for (std::size_t i = 0; i < areas.size(); ++i)
        ASSERT_NEAR(areas[i], areas_of_moved[i], 1e-12);
      if (size == 40) {
        Cells of_plane;
        of_plane.compute(triangulation(here), 0.6);
        ASSERT_NEAR(sum(areas_of_moved), sum(of_plane.areas()), 1e-11);
      }
    }
  }
}

TEST(Surfaces, wind_around_a_torus_on_both_sides_of_a_strip)
{
  Points points;
  for (int i = 0; i < 20; ++i)
    points.emplace_back(i / 2.0, 5);
  Cells cells;
  cells.compute(Torus(points.begin(), points.end(), CGAL::Periodic_cell_2(10, 10)), 0.4);
  CGAL::Bounded_voronoi_surface_2 surface;
  surface.compute(cells);
  ASSERT_EQ(surface.number_of_lines(), 2u);
  for (std::size_t line = 0; line < 2; ++line) {
    EXPECT_TRUE(surface.is_closed(line));
    EXPECT_TRUE(std::isnan(surface.areas()[line]));
    EXPECT_EQ(std::abs(surface.windings()[line][0]), 1);
    EXPECT_EQ(surface.windings()[line][1], 0);
  }
  EXPECT_EQ(surface.windings()[0][0], -surface.windings()[1][0]);
}

} // namespace

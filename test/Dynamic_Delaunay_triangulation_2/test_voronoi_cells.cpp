// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Voronoi cells in periodic space and in the plane, compared with polygons that are cut by
// bisectors with all images, and gradients, compared with finite differences.

#include "oracle.h"

#include <CGAL/Dynamic_Delaunay_triangulation_2/queries/Voronoi_cell_gradients_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/queries/Voronoi_cell_measures_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/queries/Voronoi_cells_2.h>
#include <CGAL/Dynamic_periodic_Delaunay_triangulation_2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <map>
#include <numeric>
#include <random>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

namespace test_voronoi_cells {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

using Point = Epick::Point_2;
using Points = std::vector<Point>;
using Periodic_cell = CGAL::Periodic_cell_2;
using Shift = CGAL::Periodic_shift_2;
using Plane = CGAL::Dynamic_Delaunay_triangulation_2<Epick>;
using Torus = CGAL::Dynamic_periodic_Delaunay_triangulation_2<Epick>;
using Measures = CGAL::Voronoi_cell_measures_2;
using Gradients = CGAL::Voronoi_cell_gradients_2;
using Position = Measures::Position;
using Polygon = std::vector<Position>;
using Numbers = std::vector<double>;

double random_between(std::mt19937& random, double low, double high)
{
  return std::uniform_real_distribution<double>(low, high)(random);
}

Numbers random_numbers(std::mt19937& random, std::size_t number)
{
  Numbers numbers(number);
  for (double& x : numbers)
    x = random_between(random, -1, 2);
  return numbers;
}

Point image(const Point& p, const Periodic_cell& cell, int i, int j)
{
  return Point(p.x() + i * cell.ax() + j * cell.bx(), p.y() + i * cell.ay() + j * cell.by());
}

// Points all over the cell.
Points random_points(std::mt19937& random, std::size_t number, const Periodic_cell& cell)
{
  Points points;
  for (std::size_t i = 0; i < number; ++i) {
    const double s = random_between(random, 0, 1), t = random_between(random, 0, 1);
    points.push_back(Point(s * cell.ax() + t * cell.bx(), s * cell.ay() + t * cell.by()));
  }
  return points;
}

// Images other than those chosen, up to some cells away.
Points unwrapped(std::mt19937& random, const Points& points, const Periodic_cell& cell, int most)
{
  std::uniform_int_distribution<int> shift(-most, most);
  Points result;
  for (const Point& p : points) {
    const int i = shift(random);
    result.push_back(image(p, cell, i, shift(random)));
  }
  return result;
}

std::vector<Periodic_cell> cells()
{
  return {Periodic_cell(5, 5),          Periodic_cell(3, 0.5, 1, 4),
          Periodic_cell(4, 0, 9, 4),    Periodic_cell(0.2, 1, 3, 0.1),
          Periodic_cell(-3, 1, 2.5, 2), Periodic_cell(1, 0, 12.3, 1)};
}

double sum(const Numbers& numbers)
{
  return std::accumulate(numbers.begin(), numbers.end(), 0.0);
}

// -------------------------------------------------------------------------------------------------
// The oracle: polygons around a point, relative to it.

// The part of the polygon that is no nearer to q than to the origin.
Polygon clipped(const Polygon& polygon, const Position& q)
{
  const auto excess = [&](const Position& p) {
    return p.x * q.x + p.y * q.y - (q.x * q.x + q.y * q.y) / 2;
  };
  Polygon result;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Position &p = polygon[i], &next = polygon[(i + 1) % polygon.size()];
    const double here = excess(p), there = excess(next);
    if (here <= 0)
      result.push_back(p);
    if ((here < 0 && there > 0) || (here > 0 && there < 0)) {
      const double t = here / (here - there);
      result.push_back({p.x + t * (next.x - p.x), p.y + t * (next.y - p.y)});
    }
  }
  return result;
}

double radius_of(const Polygon& polygon)
{
  double radius = 0;
  for (const Position& p : polygon)
    radius = (std::max)(radius, std::hypot(p.x, p.y));
  return radius;
}

// Cut by the bisectors with all images within `reach` cells. The images of the point itself come
// first: most of the others are then too far away to matter.
Polygon clipped_cell(const Points& points, std::size_t id, const Periodic_cell& cell)
{
  constexpr int reach = 16;
  constexpr double side = 100;
  Polygon polygon{{-side, -side}, {side, -side}, {side, side}, {-side, side}};
  Points all{points[id]};
  all.insert(all.end(), points.begin(), points.end());
  for (const Point& p : all) {
    const double radius = radius_of(polygon);
    for (int i = -reach; i <= reach; ++i)
      for (int j = -reach; j <= reach; ++j) {
        const Epick::Vector_2 v = image(p, cell, i, j) - points[id];
        if (v.squared_length() > 1e-20 && v.squared_length() < 4.1 * radius * radius)
          polygon = clipped(polygon, {v.x(), v.y()});
      }
  }
  return polygon;
}

struct Measured
{
  double area = 0, perimeter = 0;
  Position centroid{0, 0};
};

Measured measured(const Polygon& polygon)
{
  Measured result;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Position &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
    const double doubled = p.x * q.y - p.y * q.x;
    result.area += doubled / 2;
    result.perimeter += std::hypot(p.x - q.x, p.y - q.y);
    result.centroid.x += doubled * (p.x + q.x) / 6;
    result.centroid.y += doubled * (p.y + q.y) / 6;
  }
  result.centroid.x /= result.area;
  result.centroid.y /= result.area;
  return result;
}

// The length of the sides of a polygon that are equally far from the origin and from q.
double length_towards(const Polygon& polygon, const Epick::Vector_2& q)
{
  const auto is_between = [&](const Position& p) {
    return std::abs(std::hypot(p.x, p.y) - std::hypot(p.x - q.x(), p.y - q.y())) < 1e-9;
  };
  double length = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Position &p = polygon[i], &next = polygon[(i + 1) % polygon.size()];
    if (is_between(p) && is_between(next))
      length += std::hypot(p.x - next.x, p.y - next.y);
  }
  return length;
}

// -------------------------------------------------------------------------------------------------
// Cells of periodic space.

// Compares measures with polygons of the points, wrapped into the cell.
void expect_measures(const Measures& measures, const Torus& torus, const Points& wrapped)
{
  ASSERT_EQ(measures.areas().size(), wrapped.size());
  ASSERT_EQ(measures.perimeters().size(), wrapped.size());
  ASSERT_EQ(measures.centroids().size(), wrapped.size());
  ASSERT_EQ(measures.shape_indices().size(), wrapped.size());
  for (std::size_t id = 0; id < wrapped.size(); ++id) {
    const Measured cell = measured(clipped_cell(wrapped, id, torus.cell()));
    ASSERT_NEAR(measures.areas()[id], cell.area, 1e-10) << id;
    ASSERT_NEAR(measures.perimeters()[id], cell.perimeter, 1e-10) << id;
    ASSERT_NEAR(measures.shape_indices()[id], cell.perimeter / std::sqrt(cell.area), 1e-9) << id;
    ASSERT_NEAR(measures.centroids()[id].x - torus.point(id).x(), cell.centroid.x, 1e-10) << id;
    ASSERT_NEAR(measures.centroids()[id].y - torus.point(id).y(), cell.centroid.y, 1e-10) << id;
  }
  ASSERT_NEAR(sum(measures.areas()), torus.cell().area(), 1e-12 * torus.cell().area());
}

TEST(Periodic_cells, are_what_the_bisectors_with_all_images_leave)
{
  std::mt19937 random(1);
  Measures measures;
  for (const Periodic_cell& cell : cells())
    for (const std::size_t number : {1u, 2u, 3u, 7u, 25u}) {
      const Points points = random_points(random, number, cell);
      const Torus torus(unwrapped(random, points, cell, 3), cell);
      measures.compute(torus);
      ASSERT_NO_FATAL_FAILURE(expect_measures(measures, torus, points)) << number;
    }
}

TEST(Periodic_cells, of_a_lattice_are_alike)
{
  Points squares, hexagons;
  for (int i = 0; i < 6; ++i)
    for (int j = 0; j < 6; ++j) {
      squares.push_back(Point(i, j));
      hexagons.push_back(Point(i + 0.5 * j, std::sqrt(0.75) * j));
    }
  Measures measures;
  measures.compute(Torus(squares, Periodic_cell(6, 6)));
  for (std::size_t id = 0; id < 36; ++id) {
    EXPECT_NEAR(measures.areas()[id], 1, 1e-14);
    EXPECT_NEAR(measures.shape_indices()[id], 4, 1e-14);
    EXPECT_NEAR(measures.centroids()[id].x, squares[id].x(), 1e-14);
  }
  measures.compute(Torus(hexagons, Periodic_cell(6, 0, 3, 6 * std::sqrt(0.75))));
  for (std::size_t id = 0; id < 36; ++id)
    EXPECT_NEAR(measures.shape_indices()[id], std::sqrt(8 * std::sqrt(3.0)), 1e-13);
}

TEST(Periodic_cells, are_shared_by_points_that_coincide_and_removed_ids_have_none)
{
  const Periodic_cell cell(4, 1, 0.5, 3);
  std::mt19937 random(2);
  Points points = random_points(random, 10, cell);
  points[7] = Point(1.375, 2.25);
  points[4] = image(points[7], cell, 2, -1);
  Torus torus(points, cell);
  ASSERT_EQ(torus.number_of_vertices(), 9u);
  Measures measures;
  measures.compute(torus);
  const Measured whole = measured(clipped_cell(points, 7, cell));
  for (const std::size_t id : {4u, 7u}) {
    EXPECT_NEAR(measures.areas()[id], whole.area / 2, 1e-12);
    EXPECT_NEAR(measures.perimeters()[id], whole.perimeter, 1e-12);
    EXPECT_NEAR(measures.shape_indices()[id], whole.perimeter / std::sqrt(whole.area), 1e-12);
    EXPECT_NEAR(measures.centroids()[id].x, points[id].x() + whole.centroid.x, 1e-12);
    EXPECT_NEAR(measures.centroids()[id].y, points[id].y() + whole.centroid.y, 1e-12);
  }
  EXPECT_NEAR(sum(measures.areas()), cell.area(), 1e-12);

  torus.remove(7); // the point with which it coincides then has the whole cell
  torus.remove(2);
  measures.compute(torus);
  EXPECT_GT(measures.areas()[4], whole.area / 2);
  EXPECT_NEAR(sum(measures.areas()), cell.area(), 1e-12);
  for (const std::size_t id : {2u, 7u}) {
    EXPECT_EQ(measures.areas()[id], 0);
    EXPECT_EQ(measures.perimeters()[id], 0);
    EXPECT_EQ(measures.shape_indices()[id], 0);
    EXPECT_EQ(measures.centroids()[id].x, 0);
  }
}

TEST(Periodic_cells, of_no_points_are_none)
{
  Measures measures;
  measures.compute(Torus(Periodic_cell(1, 1)));
  EXPECT_TRUE(measures.areas().empty());
}

TEST(Periodic_cells, lose_no_more_digits_than_coordinates_far_away)
{
  const Periodic_cell cell(5, 0.25, 1, 4);
  std::mt19937 random(3);
  const Points points = random_points(random, 20, cell);
  Measures measures, distant;
  measures.compute(Torus(points, cell));
  distant.compute(Torus(unwrapped(random, points, cell, 100'000), cell));
  for (std::size_t id = 0; id < 20; ++id) {
    EXPECT_NEAR(distant.areas()[id], measures.areas()[id], 1e-7);
    EXPECT_NEAR(distant.perimeters()[id], measures.perimeters()[id], 1e-7);
  }
  EXPECT_NEAR(sum(distant.areas()), cell.area(), 1e-7);
}

TEST(Periodic_cells, at_a_face_whose_orientation_drowns_in_rounding_are_unbounded)
{
  // Two points that are hardly apart, as far away as points may be.
  const double away = 0x1p19;
  const Torus torus(Points{Point(away, 0.5), Point(away + 0x1p-33, 0.5), Point(0.5, 0)},
                    Periodic_cell(1, 1));
  ASSERT_EQ(torus.number_of_vertices(), 3u);
  Measures measures;
  measures.compute(torus);
  EXPECT_EQ(measures.areas()[0], infinity);
  EXPECT_EQ(measures.shape_indices()[0], infinity);
  EXPECT_EQ(measures.centroids()[0].x, away);
}

// -------------------------------------------------------------------------------------------------
// Edges and corners.

using Edge = std::tuple<std::size_t, std::size_t, Shift>;

Edge smaller(std::size_t i, std::size_t j, const Shift& shift)
{
  return (std::min)(Edge(i, j, shift), Edge(j, i, Shift{-shift[0], -shift[1]}));
}

TEST(Voronoi_edges, of_periodic_space_are_the_sides_of_the_polygons_each_of_them_once)
{
  std::mt19937 random(4);
  for (const Periodic_cell& cell : cells())
    for (const std::size_t number : {1u, 2u, 5u, 20u}) {
      const Torus torus(unwrapped(random, random_points(random, number, cell), cell, 2), cell);
      Points points;
      std::vector<Polygon> polygons;
      for (std::size_t id = 0; id < number; ++id)
        points.push_back(torus.point(id));
      for (std::size_t id = 0; id < number; ++id)
        polygons.push_back(clipped_cell(points, id, cell));
      std::multiset<Edge> expected, listed;
      torus.for_each_edge([&](std::size_t i, std::size_t j, const Shift& shift) {
        expected.insert(smaller(i, j, shift));
      });
      CGAL::for_each_voronoi_edge(
          torus, [&](std::size_t i, std::size_t j, const Shift& shift, double length) {
            listed.insert(smaller(i, j, shift));
            EXPECT_NEAR(length, length_towards(polygons[i], torus.vector(i, j, shift)), 1e-8)
                << number << ": " << i << ' ' << j;
          });
      EXPECT_EQ(listed, expected);
    }
}

TEST(Voronoi_edges, of_the_plane_add_up_to_perimeters_and_are_infinite_on_the_hull)
{
  std::mt19937 random(5);
  Points points = random_points(random, 60, Periodic_cell(8, 8));
  points.push_back(points[3]);
  Plane dt(points.begin(), points.end());
  dt.remove(17);
  Measures measures;
  measures.compute(dt);
  Numbers perimeters(points.size());
  std::set<std::array<std::size_t, 2>> expected, listed;
  std::size_t infinite = 0, hull = 0;
  dt.for_each_edge([&](std::size_t i, std::size_t j) {
    expected.insert({(std::min)(i, j), (std::max)(i, j)});
  });
  CGAL::for_each_voronoi_edge(dt, [&](std::size_t i, std::size_t j, double length) {
    EXPECT_TRUE(listed.insert({i, j}).second);
    EXPECT_GT(length, -1e-12);
    perimeters[i] += length;
    perimeters[j] += length;
    infinite += length == infinity;
  });
  EXPECT_EQ(listed, expected);
  for (std::size_t id = 0; id < 60; ++id)
    if (measures.perimeters()[id] == infinity) {
      EXPECT_EQ(perimeters[id], infinity) << id;
      ++hull;
    } else {
      EXPECT_NEAR(perimeters[id], measures.perimeters()[id], 1e-10) << id;
    }
  EXPECT_EQ(infinite, hull); // the hull is a cycle
  EXPECT_EQ(perimeters[60], 0);
}

TEST(Voronoi_edges, of_points_on_a_line_are_infinite)
{
  const Points line{Point(0, 0), Point(3, 1), Point(6, 2), Point(-3, -1)};
  for (std::size_t number = 0; number <= line.size(); ++number) {
    const Plane dt(line.begin(), line.begin() + std::ptrdiff_t(number));
    std::size_t edges = 0;
    CGAL::for_each_voronoi_edge(dt, [&](std::size_t, std::size_t, double length) {
      EXPECT_EQ(length, infinity);
      ++edges;
    });
    EXPECT_EQ(edges, number == 0 ? 0 : number - 1);
    for (std::size_t id = 0; id < number; ++id) {
      Polygon corners;
      CGAL::voronoi_cell_corners(dt, id, std::back_inserter(corners));
      EXPECT_TRUE(corners.empty());
    }
  }
}

TEST(Corners, are_a_counterclockwise_polygon_around_the_point_as_it_was_given)
{
  std::mt19937 random(6);
  for (const Periodic_cell& cell : cells()) {
    Points points = unwrapped(random, random_points(random, 12, cell), cell, 2);
    points.push_back(points[5]);
    const Torus torus(points, cell);
    Measures measures;
    measures.compute(torus);
    for (std::size_t id = 0; id < points.size(); ++id) {
      Polygon corners;
      CGAL::voronoi_cell_corners(torus, id, std::back_inserter(corners));
      ASSERT_GE(corners.size(), 4u);
      for (std::size_t i = 0; i < corners.size(); ++i) {
        const Position &p = corners[i], &q = corners[(i + 1) % corners.size()];
        const Position u{p.x - points[id].x(), p.y - points[id].y()};
        const Position v{q.x - points[id].x(), q.y - points[id].y()};
        EXPECT_GT(u.x * v.y - u.y * v.x, -1e-10);
      }
      const Measured polygon = measured(corners);
      EXPECT_NEAR(polygon.perimeter, measures.perimeters()[id], 1e-10);
      EXPECT_NEAR(polygon.centroid.x, measures.centroids()[id].x, 1e-8);
      EXPECT_NEAR(polygon.centroid.y, measures.centroids()[id].y, 1e-8);
    }
  }
}

TEST(Corners, of_the_plane_are_those_of_bounded_cells)
{
  std::mt19937 random(7);
  const Points points = random_points(random, 40, Periodic_cell(6, 6));
  const Plane dt(points.begin(), points.end());
  Measures measures;
  measures.compute(dt);
  std::size_t bounded = 0;
  for (std::size_t id = 0; id < points.size(); ++id) {
    Polygon corners;
    CGAL::voronoi_cell_corners(dt, id, std::back_inserter(corners));
    if (measures.areas()[id] == infinity) {
      EXPECT_TRUE(corners.empty());
      continue;
    }
    ++bounded;
    EXPECT_NEAR(measured(corners).area, measures.areas()[id], 1e-9);
    EXPECT_NEAR(measured(corners).centroid.x, measures.centroids()[id].x, 1e-9);
    EXPECT_NEAR(measured(corners).centroid.y, measures.centroids()[id].y, 1e-9);
  }
  EXPECT_GT(bounded, 20u);
}

TEST(Corners, of_an_id_that_no_point_has_are_refused)
{
  Torus torus(Points{Point(0, 0), Point(0.5, 0.25)}, Periodic_cell(1, 1));
  torus.remove(0);
  Polygon corners;
  EXPECT_THROW(CGAL::voronoi_cell_corners(torus, 0, std::back_inserter(corners)),
               CGAL::Unknown_id_error_2);
  EXPECT_THROW(CGAL::voronoi_cell_corners(Plane(), 0, std::back_inserter(corners)),
               CGAL::Unknown_id_error_2);
  EXPECT_TRUE(corners.empty());
}

// -------------------------------------------------------------------------------------------------
// Gradients.

// The weighted sum of areas and perimeters of the cells that are bounded in both.
double energy(const Measures& measures, const Numbers& area_weights,
              const Numbers& perimeter_weights)
{
  double energy = 0;
  for (std::size_t id = 0; id < area_weights.size(); ++id)
    if (measures.areas()[id] < infinity)
      energy += area_weights[id] * measures.areas()[id] +
                perimeter_weights[id] * measures.perimeters()[id];
  return energy;
}

// Central differences of the energy along x and y, as the points `moving` move together.
template <class Make>
Position differences(const Make& make, const Points& points, const std::vector<std::size_t>& moving,
                     double step, const Numbers& area_weights, const Numbers& perimeter_weights)
{
  const auto energy_at = [&](double x, double y) {
    Points moved = points;
    for (const std::size_t id : moving)
      moved[id] = Point(points[id].x() + x, points[id].y() + y);
    Measures measures;
    measures.compute(make(moved));
    return energy(measures, area_weights, perimeter_weights);
  };
  return {(energy_at(step, 0) - energy_at(-step, 0)) / (2 * step),
          (energy_at(0, step) - energy_at(0, -step)) / (2 * step)};
}

template <class Make>
void expect_gradients(const Make& make, const Points& points, std::mt19937& random)
{
  const Numbers area_weights = random_numbers(random, points.size());
  const Numbers perimeter_weights = random_numbers(random, points.size());
  Gradients gradients;
  gradients.compute(make(points), area_weights, perimeter_weights);
  ASSERT_EQ(gradients.gradients().size(), points.size());
  Position total{0, 0};
  for (std::size_t id = 0; id < points.size(); ++id) {
    const Position gradient = gradients.gradients()[id];
    total.x += gradient.x;
    total.y += gradient.y;
    for (const double step : {1e-5, 1e-6, 1e-7}) {
      const Position expected =
          differences(make, points, {id}, step, area_weights, perimeter_weights);
      const double scale = 1 + std::hypot(expected.x, expected.y);
      const double tolerance = scale * (1e3 * step * step + 1e-14 / step) * 10;
      ASSERT_NEAR(gradient.x, expected.x, tolerance) << id << ", step " << step;
      ASSERT_NEAR(gradient.y, expected.y, tolerance) << id << ", step " << step;
    }
  }
  EXPECT_NEAR(total.x, 0, 1e-10);
  EXPECT_NEAR(total.y, 0, 1e-10);
}

TEST(Gradients, of_periodic_space_are_finite_differences_from_one_point_on)
{
  std::mt19937 random(8);
  for (const Periodic_cell& cell : cells())
    for (const std::size_t number : {1u, 2u, 3u, 12u}) {
      const auto make = [&](const Points& points) { return Torus(points, cell); };
      const Points points = unwrapped(random, random_points(random, number, cell), cell, 2);
      ASSERT_NO_FATAL_FAILURE(expect_gradients(make, points, random)) << number;
    }
}

TEST(Gradients, of_the_plane_are_finite_differences_of_the_bounded_cells)
{
  std::mt19937 random(9);
  const auto make = [](const Points& points) { return Plane(points.begin(), points.end()); };
  for (int run = 0; run < 3; ++run)
    ASSERT_NO_FATAL_FAILURE(
        expect_gradients(make, random_points(random, 25, Periodic_cell(5, 5)), random));
}

TEST(Gradients, ignore_the_weights_of_unbounded_cells_and_of_removed_ids)
{
  std::mt19937 random(10);
  const Points points = random_points(random, 30, Periodic_cell(5, 5));
  Plane dt(points.begin(), points.end());
  dt.remove(11);
  Measures measures;
  measures.compute(dt);
  Numbers area_weights = random_numbers(random, 30), perimeter_weights = area_weights;
  for (std::size_t id = 0; id < 30; ++id)
    if (measures.areas()[id] == infinity)
      area_weights[id] = perimeter_weights[id] = 0;
  Gradients without, with;
  without.compute(dt, area_weights, perimeter_weights);
  for (std::size_t id = 0; id < 30; ++id)
    if (measures.areas()[id] == infinity || id == 11) {
      area_weights[id] = nan;
      perimeter_weights[id] = infinity;
    }
  with.compute(dt, area_weights, perimeter_weights);
  for (std::size_t id = 0; id < 30; ++id) {
    EXPECT_EQ(with.gradients()[id].x, without.gradients()[id].x) << id;
    EXPECT_EQ(with.gradients()[id].y, without.gradients()[id].y) << id;
  }
  EXPECT_EQ(with.gradients()[11].x, 0);
  EXPECT_NE(with.gradients()[12].x, 0);
}

TEST(Gradients, of_points_that_span_no_plane_are_0)
{
  const Points line{Point(0, 0), Point(3, 1), Point(6, 2)};
  Gradients gradients;
  gradients.compute(Plane(line.begin(), line.end()), {1, 2, 3}, {1, 2, 3});
  for (const Position& gradient : gradients.gradients())
    EXPECT_EQ(std::hypot(gradient.x, gradient.y), 0);
}

TEST(Gradients, of_points_that_coincide_are_equal_shares_of_their_common_one)
{
  const Periodic_cell cell(3, 0.2, 0.7, 3);
  std::mt19937 random(11);
  Points points = random_points(random, 9, cell);
  points[6] = points[2];
  points[8] = points[2];
  const auto make = [&](const Points& all) { return Torus(all, cell); };
  const Numbers area_weights = random_numbers(random, 9);
  const Numbers perimeter_weights = random_numbers(random, 9);
  Gradients gradients;
  gradients.compute(make(points), area_weights, perimeter_weights);
  const Position expected =
      differences(make, points, {2, 6, 8}, 1e-6, area_weights, perimeter_weights);
  for (const std::size_t id : {2u, 6u, 8u}) {
    EXPECT_NEAR(3 * gradients.gradients()[id].x, expected.x, 1e-7);
    EXPECT_NEAR(3 * gradients.gradients()[id].y, expected.y, 1e-7);
  }
}

TEST(Gradients, do_not_feel_which_images_of_the_points_are_given)
{
  const Periodic_cell cell(4, 0.5, 1, 4);
  std::mt19937 random(12);
  const Points points = random_points(random, 30, cell);
  const Numbers weights = random_numbers(random, 30);
  Gradients wrapped, distant;
  wrapped.compute(Torus(points, cell), weights, weights);
  distant.compute(Torus(unwrapped(random, points, cell, 50), cell), weights, weights);
  for (std::size_t id = 0; id < 30; ++id) {
    EXPECT_NEAR(wrapped.gradients()[id].x, distant.gradients()[id].x, 1e-9);
    EXPECT_NEAR(wrapped.gradients()[id].y, distant.gradients()[id].y, 1e-9);
  }
}

TEST(Gradients, of_equal_areas_weights_are_0)
{
  std::mt19937 random(13);
  const Torus torus(random_points(random, 50, Periodic_cell(7, 7)), Periodic_cell(7, 7));
  Gradients gradients;
  gradients.compute(torus, Numbers(50, 3.0), Numbers(50, 0.0));
  for (const Position& gradient : gradients.gradients())
    EXPECT_EQ(std::hypot(gradient.x, gradient.y), 0);
}

TEST(Gradients, need_a_weight_for_each_id)
{
  const Torus torus(Points{Point(0, 0), Point(0.5, 0.25)}, Periodic_cell(1, 1));
  Gradients gradients;
  gradients.compute(torus, {1, 2}, {1, 2});
  EXPECT_THROW(gradients.compute(torus, {1}, {1, 2}), CGAL::Point_count_error_2);
  EXPECT_THROW(gradients.compute(torus, {1, 2}, {1, 2, 3}), CGAL::Point_count_error_2);
  EXPECT_EQ(gradients.gradients().size(), 2u);
}

// -------------------------------------------------------------------------------------------------
// Space with an open side.

TEST(Cells_at_an_open_side, are_unbounded_as_on_the_hull)
{
  using Direction = std::pair<double, double>;
  for (const auto& [c, s] : {Direction(1, 0), Direction(0, 1), Direction(-1, 0)}) {
    const double height = std::sqrt(0.75);
    Points points; // rows of five, four of them
    for (int row = 0; row < 4; ++row)
      for (int i = 0; i < 5; ++i) {
        const double x = i + 0.5 * row, y = height * row;
        points.push_back(Point(c * x - s * y, s * x + c * y));
      }
    const Torus torus(points, Periodic_cell(5 * c, 5 * s, -50 * s, 50 * c));
    const Torus strip(points, Periodic_cell(Epick::Vector_2(5 * c, 5 * s)));
    Measures measures;
    measures.compute(strip);
    const auto is_inside = [](std::size_t id) { return id >= 5 && id < 15; };
    for (std::size_t id = 0; id < 20; ++id) {
      Polygon corners;
      CGAL::voronoi_cell_corners(strip, id, std::back_inserter(corners));
      if (is_inside(id)) {
        EXPECT_NEAR(measures.areas()[id], height, 1e-12);
        EXPECT_NEAR(measured(corners).area, height, 1e-12);
      } else {
        EXPECT_EQ(measures.areas()[id], infinity);
        EXPECT_EQ(measures.shape_indices()[id], infinity);
        EXPECT_EQ(measures.centroids()[id].y, points[id].y());
        EXPECT_TRUE(corners.empty());
      }
    }
    std::size_t edges = 0;
    CGAL::for_each_voronoi_edge(
        strip, [&](std::size_t i, std::size_t j, const Shift&, double length) {
          const double expected =
              is_inside(i) || is_inside(j) || i / 5 != j / 5 ? std::sqrt(1 / 3.0) : infinity;
          EXPECT_TRUE(length == expected || std::abs(length - expected) < 1e-12) << i << ' ' << j;
          ++edges;
        });
    EXPECT_EQ(edges, 4 * 5 + 3 * 10u);

    std::mt19937 random(14);
    Numbers weights = random_numbers(random, 20);
    for (std::size_t id = 0; id < 20; ++id)
      if (!is_inside(id))
        weights[id] = 0;
    Gradients expected, gradients;
    expected.compute(torus, weights, weights);
    for (std::size_t id = 0; id < 20; ++id)
      if (!is_inside(id))
        weights[id] = nan;
    gradients.compute(strip, weights, weights);
    for (std::size_t id = 0; id < 20; ++id) {
      EXPECT_NEAR(gradients.gradients()[id].x, expected.gradients()[id].x, 1e-12);
      EXPECT_NEAR(gradients.gradients()[id].y, expected.gradients()[id].y, 1e-12);
    }
  }
}

TEST(Cells_of_a_slab, are_those_of_a_plane_full_of_its_images_and_unbounded_at_its_sides)
{
  std::mt19937 random(17);
  const Periodic_cell slab(Epick::Vector_2(8, 1.5));
  Points points;
  for (int i = 0; i < 60; ++i) {
    const double x = random_between(random, 0, 8);
    points.push_back(Point(x, random_between(random, 0, 4)));
  }
  Points images = points; // the middle ones come first
  for (int i = -6; i <= 6; ++i)
    if (i != 0)
      for (const Point& p : points)
        images.push_back(image(p, slab, i, 0));
  Measures measures, of_plane;
  measures.compute(Torus(points, slab));
  of_plane.compute(Plane(images.begin(), images.end()));
  std::size_t unbounded = 0;
  for (std::size_t id = 0; id < points.size(); ++id) {
    if (measures.areas()[id] == infinity) {
      ++unbounded;
    } else if (measures.areas()[id] < 100) { // a larger one may see the ends of the row of images
      EXPECT_NEAR(measures.areas()[id], of_plane.areas()[id], 1e-9);
      EXPECT_NEAR(measures.perimeters()[id], of_plane.perimeters()[id], 1e-9);
      EXPECT_NEAR(measures.centroids()[id].x, of_plane.centroids()[id].x, 1e-9);
    }
  }
  EXPECT_EQ(unbounded, 2u);
}

} // namespace test_voronoi_cells

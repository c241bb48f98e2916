// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// How the volumes of Voronoi cells in space change when points move.

#include "space_points.h"

#include <CGAL/Dynamic_Delaunay_triangulation_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/Voronoi_cell_gradients_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/Voronoi_cell_measures_3.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <random>
#include <string>
#include <vector>

namespace test_space_gradients {

using Epick = CGAL::Exact_predicates_inexact_constructions_kernel;
using Epeck = CGAL::Exact_predicates_exact_constructions_kernel;
using Dynamic = CGAL::Dynamic_Delaunay_triangulation_3<Epick>;
using Point = Dynamic::Point;
using Points = std::vector<Point>;
using Box = std::optional<CGAL::Bbox_3>;
using Measures = CGAL::Voronoi_cell_measures_3;
using Gradients = CGAL::Voronoi_cell_gradients_3;
using Vector = std::array<double, 3>;
using space_points::lattice;
using space_points::random_points;
using space_points::shaken;

const CGAL::Bbox_3 unit_box(0, 0, 0, 1, 1, 1);

template <class Result, class Triangulation>
void compute(const Triangulation& dt, const Box& box, Result& result)
{
  if (box)
    result.compute(dt, *box);
  else
    result.compute(dt);
}

template <class Triangulation>
Gradients gradients_of(const Triangulation& dt, const Box& box)
{
  Gradients gradients;
  compute(dt, box, gradients);
  return gradients;
}

Measures measures_of(const Points& points, const Box& box)
{
  Measures measures;
  compute(Dynamic(points), box, measures);
  return measures;
}

Vector array_of(const Gradients::Vector& v)
{
  return {v.x, v.y, v.z};
}

// The derivative of the volume of a cell by the position of a point.
Vector derivative(const Gradients& gradients, std::size_t cell, std::size_t point)
{
  if (cell == point)
    return array_of(gradients.by_positions()[cell]);
  for (std::size_t i = gradients.offsets()[cell]; i < gradients.offsets()[cell + 1]; ++i)
    if (gradients.neighbors()[i] == point)
      return array_of(gradients.by_neighbors()[i]);
  return {0, 0, 0};
}

Point moved(const Point& p, std::size_t axis, double by)
{
  Vector its{p.x(), p.y(), p.z()};
  its[axis] += by;
  return Point(its[0], its[1], its[2]);
}

// Compares the derivatives of all cells by the position of one point with central differences of
// the volumes in fresh triangulations. Huge cells, as there are at the hull, are left out.
void expect_differences(const Points& points, const Box& box, std::size_t point, double tolerance)
{
  constexpr double h = 1e-6;
  const Gradients gradients = gradients_of(Dynamic(points), box);
  const Measures measures = measures_of(points, box);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    Points before = points, after = points;
    before[point] = moved(points[point], axis, -h);
    after[point] = moved(points[point], axis, h);
    const Measures low = measures_of(before, box), high = measures_of(after, box);
    for (std::size_t cell = 0; cell < points.size(); ++cell) {
      if (!(measures.volumes()[cell] < 1))
        continue;
      const double expected = (high.volumes()[cell] - low.volumes()[cell]) / (2 * h);
      ASSERT_NEAR(derivative(gradients, cell, point)[axis], expected,
                  tolerance * (1 + std::abs(expected)))
          << "cell " << cell << " by point " << point << " along axis " << axis;
    }
  }
}

TEST(Gradients_of_volumes, are_those_of_two_cells)
{
  const Points points{{0.25, 0.5, 0.5}, {0.75, 0.5, 0.5}};
  const Gradients gradients = gradients_of(Dynamic(points), unit_box);
  ASSERT_EQ(gradients.neighbors().size(), 2u);
  for (const std::size_t point : {0u, 1u})
    for (std::size_t axis = 0; axis < 3; ++axis) { // the facet follows by half
      EXPECT_NEAR(derivative(gradients, 0, point)[axis], axis == 0 ? 0.5 : 0, 1e-15);
      EXPECT_NEAR(derivative(gradients, 1, point)[axis], axis == 0 ? -0.5 : 0, 1e-15);
    }
}

TEST(Gradients_of_volumes, are_half_a_facet_for_each_neighbor_in_a_lattice)
{
  const Points points = lattice(4);
  const Gradients gradients = gradients_of(Dynamic(points), std::nullopt);
  for (std::size_t id = 0; id < points.size(); ++id) {
    const auto is_inner = [](double x) { return x == 1 || x == 2; };
    const Point& p = points[id];
    EXPECT_EQ(derivative(gradients, id, id), (Vector{0, 0, 0}));
    for (std::size_t i = gradients.offsets()[id]; i < gradients.offsets()[id + 1]; ++i) {
      const Point& q = points[gradients.neighbors()[i]];
      const double half = is_inner(p.x()) && is_inner(p.y()) && is_inner(p.z()) ? 0.5 : 0;
      for (int axis = 0; axis < 3; ++axis)
        EXPECT_NEAR(array_of(gradients.by_neighbors()[i])[std::size_t(axis)],
                    half * (q[axis] - p[axis]), 1e-15);
    }
  }
}

TEST(Gradients_of_volumes, are_central_differences_of_whole_cells)
{
  const Points points = random_points(200);
  for (std::size_t point = 0; point < points.size(); point += 20)
    ASSERT_NO_FATAL_FAILURE(expect_differences(points, std::nullopt, point, 2e-6));
}

TEST(Gradients_of_volumes, are_central_differences_of_cells_in_boxes)
{
  const Points points = random_points(60);
  for (const CGAL::Bbox_3& box :
       {unit_box, CGAL::Bbox_3(0.2, 0.1, 0.3, 0.7, 0.8, 0.6), // some points are outside of it
        CGAL::Bbox_3(1.5, 1.6, 1.7, 1.9, 2.1, 2.2)})          // all are at a distance
    for (std::size_t point = 0; point < points.size(); point += 4)
      ASSERT_NO_FATAL_FAILURE(expect_differences(points, box, point, 1e-5));
}

TEST(Gradients_of_volumes, are_central_differences_where_points_do_not_span_space)
{
  Points line, plane;
  for (const Point& p : random_points(12)) {
    line.emplace_back(p.x(), 0.5 * p.x(), 0.25);
    plane.emplace_back(p.x(), p.y(), 0.5 * p.x());
  }
  for (const Points& points : {line, plane}) {
    for (std::size_t point = 0; point < points.size(); ++point)
      ASSERT_NO_FATAL_FAILURE(expect_differences(points, unit_box, point, 1e-5));
    const Gradients gradients = gradients_of(Dynamic(points), std::nullopt);
    EXPECT_GT(gradients.neighbors().size(), 0u);
    for (const auto& vector : gradients.by_neighbors()) // all cells are unbounded
      EXPECT_EQ(array_of(vector), (Vector{0, 0, 0}));
  }
}

// The sum of the derivatives of the volume of a cell: what it changes by if all points move alike.
Vector sum_of(const Gradients& gradients, std::size_t cell)
{
  Vector sum = array_of(gradients.by_positions()[cell]);
  for (std::size_t i = gradients.offsets()[cell]; i < gradients.offsets()[cell + 1]; ++i) {
    const Vector part = array_of(gradients.by_neighbors()[i]);
    for (std::size_t axis = 0; axis < 3; ++axis)
      sum[axis] += part[axis];
  }
  return sum;
}

TEST(Gradients_of_volumes, vanish_where_all_points_move_alike)
{
  const Points points = random_points(1000);
  const Dynamic dt(points);
  const Gradients whole = gradients_of(dt, std::nullopt), boxed = gradients_of(dt, unit_box);
  Measures measures;
  measures.compute(dt);
  std::size_t number = 0;
  Vector walls{0, 0, 0};
  for (std::size_t id = 0; id < points.size(); ++id) {
    const double surface = measures.surface_areas()[id];
    const Vector sum = sum_of(whole, id), into_box = sum_of(boxed, id);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (measures.is_bounded(id)) {
        ASSERT_NEAR(sum[axis], 0, 1e-11 * surface) << "id " << id;
      }
      walls[axis] += std::abs(into_box[axis]);
    }
    number += measures.is_bounded(id);
  }
  EXPECT_GT(number, 700u);
  for (const double area : walls) // two walls, unless a cell has both
    EXPECT_NEAR(area, 2, 1e-11);
}

TEST(Gradients_of_volumes, vanish_for_the_volume_of_the_box)
{
  const Points points = random_points(500);
  const Gradients gradients = gradients_of(Dynamic(points), unit_box);
  for (const auto& vector : gradients.gradients(std::vector<double>(points.size(), 1)))
    for (const double coordinate : array_of(vector))
      ASSERT_NEAR(coordinate, 0, 1e-12);
}

TEST(Gradients_of_volumes, have_units_of_area)
{
  const double scale = std::ldexp(1.0, 40);
  Points points = random_points(300), scaled;
  for (const Point& p : points)
    scaled.emplace_back(scale * p.x(), scale * p.y(), scale * p.z());
  const Gradients gradients = gradients_of(Dynamic(points), std::nullopt),
                  others = gradients_of(Dynamic(scaled), std::nullopt);
  ASSERT_EQ(gradients.neighbors(), others.neighbors());
  for (std::size_t i = 0; i < gradients.by_neighbors().size(); ++i)
    EXPECT_EQ(scale * scale * gradients.by_neighbors()[i].y, others.by_neighbors()[i].y);
  for (std::size_t id = 0; id < points.size(); ++id)
    EXPECT_EQ(scale * scale * gradients.by_positions()[id].z, others.by_positions()[id].z);
}

// ENERGIES ----------------------------------------------------------------------------------------

TEST(Gradients_of_energies, add_up_what_weights_say)
{
  const Points points = random_points(100);
  std::mt19937_64 random(4);
  std::uniform_real_distribution<double> share(-1, 1);
  std::vector<double> weights;
  for (std::size_t id = 0; id < points.size(); ++id)
    weights.push_back(share(random));
  const Gradients gradients = gradients_of(Dynamic(points), unit_box);
  const auto result = gradients.gradients(weights);
  for (std::size_t point = 0; point < points.size(); ++point)
    for (std::size_t axis = 0; axis < 3; ++axis) {
      double expected = 0;
      for (std::size_t cell = 0; cell < points.size(); ++cell)
        expected += weights[cell] * derivative(gradients, cell, point)[axis];
      ASSERT_NEAR(array_of(result[point])[axis], expected, 1e-14);
    }
}

TEST(Gradients_of_energies, ignore_weights_of_unbounded_cells_and_removed_ids)
{
  Dynamic dt(random_points(200));
  dt.remove({7});
  Measures measures;
  measures.compute(dt);
  std::vector<double> weights(200, 1), others(200, 1);
  for (std::size_t id = 0; id < 200; ++id)
    if (!measures.is_bounded(id)) // so is a removed id
      others[id] = std::numeric_limits<double>::quiet_NaN();
  const Gradients gradients = gradients_of(dt, std::nullopt);
  const auto result = gradients.gradients(weights), other = gradients.gradients(others);
  for (std::size_t id = 0; id < 200; ++id)
    EXPECT_EQ(array_of(result[id]), array_of(other[id]));
  EXPECT_EQ(array_of(result[7]), (Vector{0, 0, 0}));
  EXPECT_EQ(gradients.offsets()[7], gradients.offsets()[8]);
}

TEST(Gradients_of_energies, are_shared_by_points_that_coincide)
{
  Points points = shaken(lattice(3), 0.1), alone = points;
  points.push_back(points[13]); // that in the middle
  points.push_back(points[13]);
  points.push_back(points[0]); // on the hull
  const std::vector<double> of_alone(27, 3);
  std::vector<double> all(30, 3);
  all[13] = 1, all[27] = 2, all[28] = 6; // 3 in the mean
  for (const Box& box : {Box(), Box(CGAL::Bbox_3(-0.5, -0.5, -0.5, 2.5, 2.5, 2.5))}) {
    const Dynamic dt(points);
    const Gradients shared = gradients_of(dt, box), single = gradients_of(Dynamic(alone), box);
    const auto result = shared.gradients(all), expected = single.gradients(of_alone);
    for (std::size_t id = 0; id < points.size(); ++id) {
      const std::size_t first = id < 27 ? id : id < 29 ? 13 : 0;
      const double share = first == 13 ? 3 : first == 0 ? 2 : 1;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const double its = array_of(expected[first])[axis] / share;
        EXPECT_NEAR(array_of(result[id])[axis], its, 1e-12 * (1 + std::abs(its))) << "id " << id;
      }
      if (dt.representative(id) != id) {
        EXPECT_EQ(shared.offsets()[id], shared.offsets()[id + 1]);
        EXPECT_EQ(array_of(shared.by_positions()[id]), (Vector{0, 0, 0}));
      }
    }
  }
}

TEST(Gradients_of_energies, relax_a_foam)
{
  // bubbles in a box that all want the same volume go down the gradient
  Points points = random_points(40);
  Dynamic dt(points);
  Measures measures;
  Gradients gradients;
  const auto energy = [&] {
    measures.compute(dt, unit_box);
    double sum = 0;
    for (const double volume : measures.volumes())
      sum += (volume - 1.0 / 40) * (volume - 1.0 / 40);
    return sum;
  };
  const double first = energy();
  double last = first;
  for (int step = 0; step < 30; ++step) {
    gradients.compute(dt, unit_box);
    std::vector<double> weights;
    for (const double volume : measures.volumes())
      weights.push_back(2 * (volume - 1.0 / 40));
    const auto result = gradients.gradients(weights);
    for (std::size_t id = 0; id < points.size(); ++id)
      points[id] = Point(points[id].x() - result[id].x, points[id].y() - result[id].y,
                         points[id].z() - result[id].z);
    dt.update(points);
    const double next = energy();
    ASSERT_LT(next, last) << "step " << step;
    last = next;
  }
  EXPECT_LT(last, 0.5 * first);
}

// INPUT -------------------------------------------------------------------------------------------

TEST(Gradients_in_space, refuse_wrong_input_before_anything_changes)
{
  const Dynamic dt(random_points(20));
  Gradients gradients = gradients_of(dt, unit_box);
  const auto neighbors = gradients.neighbors();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const CGAL::Bbox_3& box : {CGAL::Bbox_3(0, 0, 0, -1, 1, 1), CGAL::Bbox_3(0, 0, 0, 1, nan, 1),
                                  CGAL::Bbox_3(0, 0, -2e100, 1, 1, 2e100)})
    EXPECT_THROW(gradients.compute(dt, box), CGAL::Parameter_error_2);
  for (const std::size_t number : {0u, 19u, 21u})
    EXPECT_THROW(gradients.gradients(std::vector<double>(number, 1)), CGAL::Point_count_error_2);
  EXPECT_EQ(gradients.neighbors(), neighbors);
}

TEST(Gradients_in_space, of_no_points_are_none)
{
  EXPECT_TRUE(Gradients().gradients({}).empty());
  Gradients gradients = gradients_of(Dynamic(), unit_box);
  EXPECT_EQ(gradients.number_of_ids(), 0u);
  EXPECT_EQ(gradients.offsets().size(), 1u);
}

TEST(Gradients_in_space, are_the_same_for_exact_points_and_boxes_of_the_kernel)
{
  const Points points = random_points(40);
  std::vector<Epeck::Point_3> exact;
  for (const Point& p : points)
    exact.emplace_back(p.x(), p.y(), p.z());
  Gradients gradients;
  gradients.compute(CGAL::Dynamic_Delaunay_triangulation_3<Epeck>(exact),
                    Epeck::Iso_cuboid_3(0, 0, 0, 1, 1, 1));
  const Gradients expected = gradients_of(Dynamic(points), unit_box);
  ASSERT_EQ(gradients.neighbors(), expected.neighbors());
  for (std::size_t i = 0; i < expected.by_neighbors().size(); ++i)
    EXPECT_NEAR(gradients.by_neighbors()[i].x, expected.by_neighbors()[i].x, 1e-12);
}

#ifdef CGAL_LINKED_WITH_TBB
TEST(Gradients_in_space, do_not_depend_on_threads)
{
  const Points points = random_points(4000);
  const Dynamic dt(points);
  const CGAL::Dynamic_Delaunay_triangulation_3<Epick, CGAL::With_concurrency_2<CGAL::Parallel_tag>>
      parallel(points);
  for (const Box& box : {Box(), Box(unit_box)}) {
    const Gradients one = gradients_of(dt, box), other = gradients_of(parallel, box);
    EXPECT_EQ(one.offsets(), other.offsets());
    ASSERT_EQ(one.neighbors(), other.neighbors());
    for (std::size_t i = 0; i < one.by_neighbors().size(); ++i)
      ASSERT_EQ(array_of(one.by_neighbors()[i]), array_of(other.by_neighbors()[i]));
    for (std::size_t id = 0; id < points.size(); ++id)
      ASSERT_EQ(array_of(one.by_positions()[id]), array_of(other.by_positions()[id]));
  }
}
#endif // CGAL_LINKED_WITH_TBB

} // namespace test_space_gradients

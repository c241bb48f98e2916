// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// What comes out of a triangulation in space: Voronoi cells, neighbor lists, nearest points.

#include "exact_cell.h"
#include "space_operations.h"
#include "space_points.h"
#include "voronoi_volumes.h"

#include <CGAL/Dynamic_Delaunay_triangulation_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/Delaunay_neighbor_lists_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/Delaunay_point_queries_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/Voronoi_cell_measures_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/Voronoi_cell_volumes_3.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <map>
#include <optional>
#include <random>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace test_space_cells {

using Epick = CGAL::Exact_predicates_inexact_constructions_kernel;
using Epeck = CGAL::Exact_predicates_exact_constructions_kernel;
using Dynamic = CGAL::Dynamic_Delaunay_triangulation_3<Epick>;
using Point = Dynamic::Point;
using Points = std::vector<Point>;
using Measures = CGAL::Voronoi_cell_measures_3;
using Volumes = CGAL::Voronoi_cell_volumes_3;
using Lists = CGAL::Delaunay_neighbor_lists_3;
using space_operations::Program;
using space_points::lattice;
using space_points::random_points;
using space_points::shaken;

constexpr double infinity = std::numeric_limits<double>::infinity();

template <class Of_neighbors>
std::map<std::size_t, double> facets(const Of_neighbors& measures, std::size_t id)
{
  std::map<std::size_t, double> result;
  for (std::size_t i = measures.offsets()[id]; i < measures.offsets()[id + 1]; ++i)
    EXPECT_TRUE(result.emplace(measures.neighbors()[i], measures.facet_areas()[i]).second);
  return result;
}

std::set<std::size_t> neighbors(const Measures& measures, std::size_t id)
{
  std::set<std::size_t> result;
  for (const auto& [neighbor, area] : facets(measures, id))
    result.insert(neighbor);
  return result;
}

double volume(const CGAL::Bbox_3& box)
{
  return (box.xmax() - box.xmin()) * (box.ymax() - box.ymin()) * (box.zmax() - box.zmin());
}

// CELLS -------------------------------------------------------------------------------------------

TEST(Cells_in_space, of_a_lattice_are_cubes)
{
  Points points = lattice(4);
  for (Point& p : points)
    p = Point(p.x() + 1e8, p.y() - 1e8, p.z()); // lengths are as accurate anywhere
  Dynamic dt(points);
  Measures measures;
  for (const double step : {1e-9, 0.01, 0.1}) {
    dt.update(shaken(points, step, 5));
    dt.update(points); // other cells than before where points are cospherical
    measures.compute(dt);
    for (std::size_t id = 0; id < points.size(); ++id) {
      const Point p = points[id];
      const auto is_inner = [](double x) { return x == 1 || x == 2; };
      const double x = p.x() - 1e8, y = p.y() + 1e8, z = p.z();
      std::set<std::size_t> six;
      for (std::size_t other = 0; other < points.size(); ++other)
        if (CGAL::squared_distance(p, points[other]) == 1)
          six.insert(other);
      ASSERT_EQ(neighbors(measures, id), six) << "id " << id;
      const bool is_bounded = is_inner(x) && is_inner(y) && is_inner(z);
      ASSERT_EQ(measures.is_bounded(id), is_bounded) << "id " << id;
      if (!is_bounded) {
        EXPECT_EQ(measures.volumes()[id], infinity);
        EXPECT_EQ(measures.surface_areas()[id], infinity);
        EXPECT_EQ(measures.centroids()[id].x, p.x());
        continue;
      }
      EXPECT_NEAR(measures.volumes()[id], 1, 1e-14);
      EXPECT_NEAR(measures.surface_areas()[id], 6, 1e-14);
      EXPECT_EQ(measures.centroids()[id].x, p.x());
      for (const auto& [other, area] : facets(measures, id))
        EXPECT_NEAR(area, 1, 1e-14);
    }
  }
}

TEST(Cells_in_space, of_coincident_points_are_shared)
{
  Points points = lattice(3);
  points.push_back(points[13]); // that in the middle
  points.push_back(points[13]);
  Dynamic dt(points);
  Measures measures;
  for (const bool is_in_box : {false, true}) {
    if (is_in_box)
      measures.compute(dt, CGAL::Bbox_3(-1, -1, -1, 3, 3, 3));
    else
      measures.compute(dt);
    for (const std::size_t id : {13u, 27u, 28u}) {
      EXPECT_NEAR(measures.volumes()[id], 1.0 / 3, 1e-15);
      EXPECT_NEAR(measures.surface_areas()[id], 6, 1e-14);
      EXPECT_NEAR(measures.centroids()[id].y, 1, 1e-15);
      EXPECT_TRUE(measures.is_bounded(id));
      EXPECT_EQ(facets(measures, id).size(), id == 13 ? 6u : 0u);
    }
  }
}

TEST(Cells_in_space, of_removed_ids_measure_nothing)
{
  Dynamic dt(lattice(4));
  dt.remove({21});
  Measures measures;
  measures.compute(dt);
  EXPECT_EQ(measures.number_of_ids(), 64u);
  EXPECT_EQ(measures.volumes()[21], 0);
  EXPECT_EQ(measures.surface_areas()[21], 0);
  EXPECT_EQ(measures.centroids()[21].x, 0);
  EXPECT_FALSE(measures.is_bounded(21));
  EXPECT_TRUE(neighbors(measures, 21).empty());
  EXPECT_NEAR(measures.volumes()[22], 1 + 1.0 / 6, 1e-14); // a pyramid more
}

template <class Triangulation>
void expect_volumes(const Triangulation& dt, double accuracy, double largest = infinity)
{
  Measures measures;
  measures.compute(dt);
  voronoi_volumes::expect_measured(dt, measures, accuracy, largest);
}

TEST(Volumes_in_space, are_those_that_measures_have)
{
  ASSERT_NO_FATAL_FAILURE(expect_volumes(Dynamic(), 0));
  for (const std::size_t number : {1u, 3u, 4u, 5u, 20u, 3000u})
    ASSERT_NO_FATAL_FAILURE(expect_volumes(Dynamic(random_points(number)), 1e-9));
  Points points = lattice(5);
  for (std::size_t i = 0; i < 100; ++i)
    points.push_back(points[i % 7 == 0 ? 62 : i]); // some of them thrice and more
  Dynamic dt(points);
  ASSERT_NO_FATAL_FAILURE(expect_volumes(dt, 1e-14));
  dt.remove({30, 31, 62, 107, 124});
  ASSERT_NO_FATAL_FAILURE(expect_volumes(dt, 1e-14));
  for (const double step : {1e-15, 1e-9, 1e-3, 0.1}) {
    dt.update(shaken(points, step, 1));
    ASSERT_NO_FATAL_FAILURE(expect_volumes(dt, 1e-9, 10));
  }
  for (Point& p : points)
    p = Point(p.x(), p.y(), 0); // in a plane
  dt.update(points);
  ASSERT_NO_FATAL_FAILURE(expect_volumes(dt, 0));
}

// A few points of some kind, and how much worse than usual facets may be conditioned.
struct Few
{
  Points points;
  double condition = 1;
};

Few few_points(std::mt19937_64& random)
{
  const auto below = [&](int n) { return int(random() % std::uint64_t(n)); };
  const auto share = [&] { return std::ldexp(double(below(1 << 30)), -30) - 0.5; };
  const int kind = below(10), number = below(13);
  const double scale = std::ldexp(1.0, below(4) == 0 ? below(600) - 300 : 0);
  const double offset = below(4) == 0 ? 1e5 : 0;
  Few few;
  if (kind == 6 || kind == 7 || kind == 8) // bisectors that enclose tiny angles
    few.condition = kind == 8 ? infinity : 1e10;
  for (int i = 0; i < number; ++i) {
    double x = share(), y = share(), z = share();
    switch (kind) {
    case 1: // on a lattice, where points coincide
      x = below(3), y = below(3), z = below(3);
      break;
    case 2: // in a plane
      z = x + y;
      break;
    case 3: // in a plane, on a lattice
      x = below(3), y = below(3), z = 2 - x;
      break;
    case 4: // on a line
      x = y = z = below(2) == 0 ? below(5) : x;
      break;
    case 5: { // on a sphere
      const double one = below(2) * 2 - 1, two = below(2) * 4 - 2, other = below(2) * 4 - 2;
      const int axis = below(3);
      x = axis == 0 ? one : two;
      y = axis == 1 ? one : axis == 0 ? two : other;
      z = axis == 2 ? one : other;
      break;
    }
    case 6: // in two clusters
      x = below(2) + 1e-9 * x, y = 1e-9 * y, z = 1e-9 * z;
      break;
    case 7: // nearly in a plane
      z = std::ldexp(z, -30);
      break;
    case 8: // closer than doubles of this size tell
      if (below(2) == 0)
        x = 1e-320 * below(100), y = 1e-320 * below(100), z = 0;
      break;
    default:
      break;
    }
    few.points.emplace_back(scale * (x + offset), scale * (y - offset), scale * z);
  }
  return few;
}

// The extent of points, or 1 if it is 0.
double extent_of(const Points& points)
{
  double most = 0;
  for (const Point& p : points)
    for (const Point& q : points)
      for (int i = 0; i < 3; ++i)
        most = (std::max)(most, std::abs(p[i] - q[i]));
  return most > 0 ? most : 1;
}

// The points other than those at p, each vertex once.
std::vector<std::pair<std::size_t, Point>> others_of(const Dynamic& dt, std::size_t id)
{
  std::vector<std::pair<std::size_t, Point>> others;
  for (std::size_t other = 0; other < dt.number_of_ids(); ++other)
    if (dt.has_id(other) && dt.representative(other) == other && dt.representative(id) != other)
      others.emplace_back(other, dt.point(other));
  return others;
}

void expect_cells(const Dynamic& dt, const Measures& measures,
                  const std::optional<CGAL::Bbox_3>& box, double extent, double condition)
{
  Volumes volumes;
  volumes.compute(dt);
  for (std::size_t id = 0; id < dt.number_of_ids(); ++id) {
    if (!dt.has_id(id) || dt.representative(id) != id)
      continue;
    double points = 0;
    for (std::size_t other = 0; other < dt.number_of_ids(); ++other)
      points += dt.has_id(other) && dt.representative(other) == id;
    const exact_cell::Cell cell =
        exact_cell::cell(dt.point(id), others_of(dt, id), box, 1e40 * extent);
    SCOPED_TRACE("id " + std::to_string(id));
    ASSERT_EQ(measures.is_bounded(id), cell.is_bounded);
    const auto found = facets(measures, id);
    if (!box) { // the same neighbors
      ASSERT_EQ(found.size(), cell.areas.size());
      for (const auto& [neighbor, area] : cell.areas)
        ASSERT_EQ(found.count(neighbor), 1u) << neighbor;
    }
    const double size = box ? extent : cell.reach, unit = 1e-12 * size * size;
    const double of_area = std::isinf(condition) ? infinity : condition * unit;
    for (const auto& [neighbor, area] : found) {
      const auto expected = cell.areas.find(neighbor);
      const double expected_area = expected == cell.areas.end() ? 0 : expected->second;
      if (std::isinf(expected_area) || std::isinf(area)) {
        ASSERT_EQ(area, expected_area) << neighbor;
      } else {
        ASSERT_NEAR(area, expected_area, of_area) << neighbor;
      }
      ASSERT_EQ(facets(measures, neighbor).at(id), area) << neighbor;
    }
    for (const auto& [neighbor, area] : cell.areas)
      if (found.count(neighbor) == 0) {
        ASSERT_LT(area, unit);
      }
    if (!cell.is_bounded) {
      ASSERT_EQ(measures.volumes()[id], infinity);
      ASSERT_EQ(volumes.volumes()[id], infinity);
      ASSERT_EQ(measures.surface_areas()[id], infinity);
      ASSERT_EQ(measures.centroids()[id].z, dt.point(id).z());
      continue;
    }
    ASSERT_NEAR(measures.volumes()[id] * points, cell.volume, unit * size);
    if (!box) {
      ASSERT_NEAR(volumes.volumes()[id] * points, cell.volume, unit * size);
    }
    ASSERT_NEAR(measures.surface_areas()[id], cell.surface, of_area);
    if (cell.volume > 1e-3 * size * size * size) {
      const auto expect_near = [&](double x, double expected) {
        ASSERT_NEAR(x, expected, 1e-8 * size + 1e-15 * std::abs(expected));
      };
      expect_near(measures.centroids()[id].x, cell.centroid[0]);
      expect_near(measures.centroids()[id].y, cell.centroid[1]);
      expect_near(measures.centroids()[id].z, cell.centroid[2]);
    }
  }
}

class Few_cells : public testing::TestWithParam<unsigned>
{
};

TEST_P(Few_cells, measure_what_rational_numbers_say)
{
  std::mt19937_64 random(GetParam());
  for (int trial = 0; trial < 16; ++trial) {
    SCOPED_TRACE("trial " + std::to_string(trial));
    const Few few = few_points(random);
    Dynamic dt(few.points);
    if (trial % 3 == 0) { // other cells than before where points are cospherical
      dt.update(shaken(few.points, 0.1 * extent_of(few.points), unsigned(trial)));
      dt.update(few.points);
    }
    const double scale = extent_of(few.points);
    Measures measures;
    measures.compute(dt);
    ASSERT_NO_FATAL_FAILURE(expect_cells(dt, measures, std::nullopt, scale, few.condition));
    if (few.points.empty())
      continue;

    // a box around some of the points, beside them, or at a distance
    const auto share = [&] { return std::ldexp(double(random() >> 24), -40) - 0.5; };
    const double distance = trial % 5 == 0 ? 1e6 : trial % 5 == 1 ? 10 : 1;
    const Point& p = few.points[random() % few.points.size()];
    std::array<double, 3> low, high;
    for (std::size_t i = 0; i < 3; ++i) {
      low[i] = p[int(i)] + scale * distance * share();
      high[i] = low[i] + scale * 2 * (share() + 0.5);
    }
    const CGAL::Bbox_3 box(low[0], low[1], low[2], high[0], high[1], high[2]);
    measures.compute(dt, box);
    double extent = 0, sum = 0;
    for (std::size_t i = 0; i < 3; ++i)
      extent = (std::max)(extent, high[i] - low[i]);
    ASSERT_NO_FATAL_FAILURE(expect_cells(dt, measures, box, extent, few.condition));
    for (const double its : measures.volumes())
      sum += its;
    ASSERT_NEAR(sum, volume(box), 1e-13 * extent * extent * extent);
  }
}
INSTANTIATE_TEST_SUITE_P(seeds, Few_cells, testing::Range(1u, 21u));

// The volumes in a box add up, and the mean of the centroids is its center.
template <class Triangulation>
void expect_sum(const Triangulation& dt, const CGAL::Bbox_3& box)
{
  Measures measures;
  measures.compute(dt, box);
  double sum = 0, extent = 0, away = 0;
  std::array<double, 3> mean{0, 0, 0};
  for (std::size_t id = 0; id < dt.number_of_ids(); ++id) {
    const double its = measures.volumes()[id];
    const auto& c = measures.centroids()[id];
    ASSERT_GE(its, 0);
    sum += its;
    if (its > 0)
      mean = {mean[0] + its * (c.x - box.xmin()), mean[1] + its * (c.y - box.ymin()),
              mean[2] + its * (c.z - box.zmin())};
  }
  for (int i = 0; i < 3; ++i) {
    extent = (std::max)(extent, (box.max)(i) - (box.min)(i));
    away = (std::max)(away, std::abs((box.max)(i)));
  }
  const double whole = volume(box), cube = extent * extent * extent;
  ASSERT_NEAR(sum, dt.number_of_points() > 0 ? whole : 0, 1e-13 * cube);
  for (int i = 0; dt.number_of_points() > 0 && i < 3; ++i)
    ASSERT_NEAR(mean[std::size_t(i)] / whole, ((box.max)(i) - (box.min)(i)) / 2,
                1e-13 * (extent + away) * cube / whole);
}

TEST(Cells_in_a_box, add_up)
{
  const Points cube = random_points(1500);
  Points flat, sphere, cylinder;
  for (const Point& p : cube) {
    flat.emplace_back(p.x(), p.y(), 1e-9 * p.z());
    const double x = p.x() - 0.5, y = p.y() - 0.5, z = p.z() - 0.5;
    const double r = std::sqrt(x * x + y * y + z * z), s = std::sqrt(x * x + y * y);
    sphere.emplace_back(x / r, y / r, z / r);
    cylinder.emplace_back(x / s, y / s, z);
  }
  for (const Points& points : {cube, flat, sphere, cylinder, lattice(10),
                               shaken(lattice(10), 1e-13, 1), shaken(lattice(10), 1e-7, 1)})
    for (const CGAL::Bbox_3& box :
         {CGAL::Bbox_3(0, 0, 0, 1, 1, 1), CGAL::Bbox_3(-5, -4, -3, 5, 4, 12),
          CGAL::Bbox_3(0.25, 0.25, 0.25, 0.75, 0.75, 0.251), CGAL::Bbox_3(40, 50, 60, 41, 53, 62),
          CGAL::Bbox_3(1e7, 1e7, 0, 1e7 + 1, 1e7 + 1, 1)})
      ASSERT_NO_FATAL_FAILURE(expect_sum(Dynamic(points), box));
}

TEST(Cells_in_a_box, add_up_however_distant_points_are)
{
  Points points;
  for (const Point& p : random_points(60)) {
    const double x = p.x() - 0.5, y = p.y() - 0.5, z = p.z() - 0.5;
    const double r = std::sqrt(x * x + y * y + z * z);
    points.emplace_back(x / r, y / r, z / r);
  }
  const Dynamic dt(points);
  std::size_t shared = 0;
  dt.for_each_edge([&](std::size_t i, std::size_t j) { // whose bisector goes through the box
    std::array<double, 3> low;
    for (int k = 0; k < 3; ++k)
      low[std::size_t(k)] = 1e9 * (points[i][k] + points[j][k]) - 10.3;
    const CGAL::Bbox_3 box(low[0], low[1], low[2], low[0] + 20, low[1] + 21, low[2] + 22);
    ASSERT_NO_FATAL_FAILURE(expect_sum(dt, box));
    Measures measures;
    measures.compute(dt, box);
    shared += measures.volumes()[i] > 0 && measures.volumes()[j] > 0;
  });
  EXPECT_GT(shared, 100u);
}

TEST(Cells_in_a_box, may_have_no_volume)
{
  const Points points = random_points(50);
  const Dynamic dt(points);
  Measures measures;
  measures.compute(dt, CGAL::Bbox_3(0.5, 0, 0, 0.5, 1, 1));
  for (std::size_t id = 0; id < points.size(); ++id) {
    EXPECT_EQ(measures.volumes()[id], 0);
    EXPECT_EQ(measures.centroids()[id].x, points[id].x());
    EXPECT_TRUE(measures.is_bounded(id));
  }
}

TEST(Cells_in_a_box, are_whole_where_the_box_has_them)
{
  const Dynamic dt(random_points(400));
  Measures whole, in_box;
  whole.compute(dt);
  in_box.compute(dt, Epick::Iso_cuboid_3(-0.1, -0.1, -0.1, 1.1, 1.1, 1.1));
  std::size_t number = 0;
  for (std::size_t id = 0; id < 400; ++id) {
    EXPECT_EQ(neighbors(whole, id), neighbors(in_box, id));
    EXPECT_LE(in_box.volumes()[id], whole.volumes()[id] * (1 + 1e-12));
    if (in_box.volumes()[id] > whole.volumes()[id] * (1 - 1e-12)) {
      ++number;
      EXPECT_NEAR(in_box.surface_areas()[id], whole.surface_areas()[id], 1e-12);
      EXPECT_NEAR(in_box.centroids()[id].x, whole.centroids()[id].x, 1e-12);
    }
  }
  EXPECT_GT(number, 150u);
}

TEST(Cells_in_a_box, that_is_none_are_refused_before_anything_changes)
{
  const Dynamic dt(random_points(20));
  Measures measures;
  measures.compute(dt);
  const std::vector<double> volumes = measures.volumes();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const CGAL::Bbox_3& box : {CGAL::Bbox_3(0, 0, 0, -1, 1, 1), CGAL::Bbox_3(0, 0, 0, 1, nan, 1),
                                  CGAL::Bbox_3(0, 0, -2e100, 1, 1, 2e100)})
    EXPECT_THROW(measures.compute(dt, box), CGAL::Parameter_error_2);
  EXPECT_EQ(measures.volumes(), volumes);
}

TEST(Cells_in_space, may_be_huge_and_flat)
{
  Points points;
  for (const Point& p : random_points(60))
    points.emplace_back(p.x(), p.y(), 1e-300 * p.z());
  const Dynamic dt(points);
  Measures measures;
  measures.compute(dt);
  Volumes volumes;
  volumes.compute(dt);
  for (std::size_t id = 0; id < points.size(); ++id) {
    EXPECT_GT(measures.volumes()[id], 1e10);
    EXPECT_GE(volumes.volumes()[id], 0);
    EXPECT_TRUE(std::isfinite(measures.centroids()[id].z));
    for (const auto& [neighbor, area] : facets(measures, id))
      EXPECT_GE(area, 0);
  }
  ASSERT_NO_FATAL_FAILURE(expect_sum(dt, CGAL::Bbox_3(0, 0, -1, 1, 1, 1)));
}

// EXACT KERNELS -----------------------------------------------------------------------------------

TEST(Cells_of_exact_points, may_differ_by_less_than_doubles_tell)
{
  using Exact = CGAL::Dynamic_Delaunay_triangulation_3<Epeck>;
  const Epeck::FT third = Epeck::FT(1) / 3, little = Epeck::FT(1e-40);
  Exact dt(std::vector<Exact::Point>{{third, third, third},
                                     {third + little, third, third},
                                     {third, third + little, third},
                                     {third, third, third + little},
                                     {1, 0, 0}});
  Measures measures;
  measures.compute(dt);
  EXPECT_EQ(neighbors(measures, 0).size(), 4u);
  ASSERT_NO_FATAL_FAILURE(expect_volumes(dt, 1e-9));
  ASSERT_NO_FATAL_FAILURE(expect_sum(dt, CGAL::Bbox_3(0, 0, 0, 1, 1, 1)));
  ASSERT_NO_FATAL_FAILURE(expect_sum(dt, CGAL::Bbox_3(9, 8, 7, 10, 10, 8)));
  CGAL::Delaunay_point_queries_3<Exact> queries(dt);
  EXPECT_EQ(queries.nearest(Exact::Point(third + little, third, third)), 1u);
  EXPECT_EQ(queries.nearest_neighbor(4), 1u);
  EXPECT_EQ(queries.nearest_neighbor(1), 0u);
}

// PROGRAMS ----------------------------------------------------------------------------------------

void expect_lists(const Dynamic& dt)
{
  Lists lists;
  lists.compute(dt);
  ASSERT_EQ(lists.number_of_ids(), dt.number_of_ids());
  std::map<std::size_t, std::vector<Lists::Id>> duplicates;
  for (std::size_t id = 0; id < dt.number_of_ids(); ++id)
    if (dt.has_id(id) && dt.representative(id) != id)
      duplicates[dt.representative(id)].push_back(Lists::Id(id));
  for (std::size_t id = 0; id < dt.number_of_ids(); ++id) {
    std::vector<Lists::Id> expected;
    if (dt.has_id(id) && dt.representative(id) == id) {
      dt.for_each_neighbor(id, [&](std::size_t j) { expected.push_back(Lists::Id(j)); });
      std::sort(expected.begin(), expected.end());
      expected.insert(expected.end(), duplicates[id].begin(), duplicates[id].end());
    } else if (dt.has_id(id)) {
      expected.push_back(Lists::Id(dt.representative(id)));
    }
    const auto list = lists.neighbors(id);
    ASSERT_EQ(std::vector<Lists::Id>(list.begin(), list.end()), expected) << "id " << id;
    ASSERT_EQ(lists.degree(id), expected.size());
  }
}

// Queries at some places and at some points, against a look at all points.
template <class Points_by_id>
void expect_queries(const Dynamic& dt, const CGAL::Delaunay_point_queries_3<Dynamic>& queries,
                    const Points_by_id& points, const Points& places, double squared_radius)
{
  std::vector<std::optional<std::size_t>> all;
  queries.nearest(places.begin(), places.end(), std::back_inserter(all));
  std::vector<std::size_t> answers, begins;
  queries.within(places.begin(), places.end(), squared_radius, answers, begins);
  for (std::size_t i = 0; i < places.size(); ++i) {
    std::optional<std::size_t> nearest;
    std::vector<std::size_t> within, found;
    for (const auto& [id, p] : points) {
      if (!nearest || CGAL::compare_distance(places[i], p, dt.point(*nearest)) == CGAL::SMALLER)
        nearest = id;
      if (Epick().compare_squared_distance_3_object()(places[i], p, squared_radius) != CGAL::LARGER)
        within.push_back(id);
    }
    ASSERT_EQ(queries.nearest(places[i]), nearest);
    ASSERT_EQ(all[i], nearest);
    queries.within(places[i], squared_radius, std::back_inserter(found));
    std::sort(found.begin(), found.end());
    ASSERT_EQ(found, within);
    ASSERT_EQ(std::vector<std::size_t>(answers.begin() + std::ptrdiff_t(begins[i]),
                                       answers.begin() + std::ptrdiff_t(begins[i + 1])),
              within);
  }
  int number = 0;
  for (const auto& [id, p] : points) {
    if (++number > 8)
      break;
    std::optional<std::size_t> nearest;
    std::vector<std::size_t> within, found;
    for (const auto& [other, q] : points) {
      if (other == id)
        continue;
      if (!nearest || CGAL::compare_distance(p, q, dt.point(*nearest)) == CGAL::SMALLER)
        nearest = other;
      if (Epick().compare_squared_distance_3_object()(p, q, squared_radius) != CGAL::LARGER)
        within.push_back(other);
    }
    ASSERT_EQ(queries.nearest_neighbor(id), nearest) << "id " << id;
    queries.neighbors_within(id, squared_radius, std::back_inserter(found));
    std::sort(found.begin(), found.end());
    ASSERT_EQ(found, within) << "id " << id;
  }
}

class Programs_of_cells : public testing::TestWithParam<std::tuple<unsigned, double, double>>
{
};

TEST_P(Programs_of_cells, agree_with_what_all_points_say)
{
  const unsigned seed = std::get<0>(GetParam());
  const double extent = std::get<1>(GetParam()), grid = std::get<2>(GetParam());
  Program<Dynamic> program(seed, extent, grid);
  const CGAL::Delaunay_point_queries_3<Dynamic> queries(program.triangulation());
  program.insert(seed % 60);
  std::mt19937_64 random(seed);
  for (int i = 0; i < 25; ++i) {
    SCOPED_TRACE("operation " + std::to_string(i));
    ASSERT_NO_FATAL_FAILURE(program.do_something());
    ASSERT_NO_FATAL_FAILURE(expect_lists(program.triangulation()));
    ASSERT_NO_FATAL_FAILURE(
        expect_sum(program.triangulation(), CGAL::Bbox_3(-0.3 * extent, 0, -0.1 * extent,
                                                         0.75 * extent, extent, 0.5 * extent)));
    Points places;
    for (int k = 0; k < 6; ++k) {
      const auto coordinate = [&] {
        const double x = std::ldexp(double(random() >> 24), -40) * 1.5 - 0.25;
        return extent * (grid > 0 ? std::floor(2 * x / grid) * grid / 2 : x);
      };
      const double x = coordinate(), y = coordinate();
      places.emplace_back(x, y, coordinate());
    }
    for (const double radius : {0.0, 0.25, 0.5})
      ASSERT_NO_FATAL_FAILURE(expect_queries(program.triangulation(), queries, program.points(),
                                             places, radius * radius * extent * extent));
  }
}
INSTANTIATE_TEST_SUITE_P(anywhere, Programs_of_cells,
                         testing::Combine(testing::Range(1u, 9u), testing::Values(1.0),
                                          testing::Values(0.0)));
INSTANTIATE_TEST_SUITE_P(on_a_grid, Programs_of_cells,
                         testing::Combine(testing::Range(20u, 28u), testing::Values(1.0),
                                          testing::Values(0.25)));
INSTANTIATE_TEST_SUITE_P(far_and_near, Programs_of_cells,
                         testing::Combine(testing::Range(40u, 42u), testing::Values(1e-70, 1e70),
                                          testing::Values(0.0)));

TEST(Queries_in_space, refuse_wrong_input)
{
  const Dynamic dt(random_points(20));
  const CGAL::Delaunay_point_queries_3<Dynamic> queries(dt);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Points places{{0, 0, 0}, {0, nan, 0}};
  std::vector<std::size_t> found{7}, begins{8};
  EXPECT_THROW(queries.nearest(places[1]), CGAL::Non_finite_coordinate_error_3);
  try {
    queries.within(places.begin(), places.end(), 1, found, begins);
    FAIL();
  } catch (const CGAL::Non_finite_coordinate_error_3& error) {
    EXPECT_EQ(error.id(), 1u);
  }
  EXPECT_THROW(queries.within(places.begin(), places.end(), -1, found, begins),
               CGAL::Parameter_error_2);
  EXPECT_THROW(queries.nearest_neighbor(20), CGAL::Unknown_id_error_2);
  EXPECT_THROW(queries.neighbors_within(3, nan, std::back_inserter(found)),
               CGAL::Parameter_error_2);
  EXPECT_EQ(found, std::vector<std::size_t>{7});
  EXPECT_EQ(begins, std::vector<std::size_t>{8});
}

TEST(Vertices_with_many_neighbors, are_measured_and_listed)
{
  Points points{{0, 0, 0}};
  for (const Point& p : random_points(2000)) {
    const double x = p.x() - 0.5, y = p.y() - 0.5, z = p.z() - 0.5;
    const double r = std::sqrt(x * x + y * y + z * z);
    points.emplace_back(x / r, y / r, z / r);
  }
  const Dynamic dt(points);
  ASSERT_NO_FATAL_FAILURE(expect_lists(dt));
  Measures measures;
  measures.compute(dt);
  EXPECT_EQ(neighbors(measures, 0).size(), 2000u);
  EXPECT_NEAR(measures.volumes()[0], CGAL_PI / 6, 0.01); // nearly a ball of radius 1/2
  ASSERT_NO_FATAL_FAILURE(expect_volumes(dt, 1e-12));
  EXPECT_NEAR(measures.centroids()[0].x, 0, 1e-3);
}

// THREADS -----------------------------------------------------------------------------------------

#ifdef CGAL_LINKED_WITH_TBB
TEST(Threads, measure_and_list_the_same)
{
  Points points = random_points(6000);
  for (std::size_t i = 0; i < 100; ++i)
    points.push_back(points[17 * i]);
  const Dynamic dt(points);
  const CGAL::Dynamic_Delaunay_triangulation_3<Epick, CGAL::With_concurrency_2<CGAL::Parallel_tag>>
      parallel(points);
  Lists lists, parallel_lists;
  lists.compute(dt);
  parallel_lists.compute(parallel);
  EXPECT_EQ(lists.offsets(), parallel_lists.offsets());
  EXPECT_EQ(lists.neighbors(), parallel_lists.neighbors());
  Volumes volumes, parallel_volumes;
  volumes.compute(dt);
  parallel_volumes.compute(parallel);
  EXPECT_EQ(volumes.volumes(), parallel_volumes.volumes());
  for (const bool is_in_box : {false, true}) {
    Measures measures, parallel_measures;
    const CGAL::Bbox_3 box(0, 0, 0, 1, 0.5, 1);
    if (is_in_box) {
      measures.compute(dt, box);
      parallel_measures.compute(parallel, box);
    } else {
      measures.compute(dt);
      parallel_measures.compute(parallel);
    }
    EXPECT_EQ(measures.volumes(), parallel_measures.volumes());
    EXPECT_EQ(measures.surface_areas(), parallel_measures.surface_areas());
    EXPECT_EQ(measures.offsets(), parallel_measures.offsets());
    EXPECT_EQ(measures.neighbors(), parallel_measures.neighbors());
    EXPECT_EQ(measures.facet_areas(), parallel_measures.facet_areas());
  }
}
#endif // CGAL_LINKED_WITH_TBB

} // namespace test_space_cells

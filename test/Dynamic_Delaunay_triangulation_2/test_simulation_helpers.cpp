// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Neighbor lists, measures of Voronoi cells, and queries for points, compared with results that do
// not depend on them: of CGAL's circulators, of exact polygons, and of searches among all points.

#include "query_oracle.h"
#include "replaced_heap.h"

#include <CGAL/Dynamic_Delaunay_triangulation_2/classifiers/Random_classifier_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/queries/Delaunay_neighbor_lists_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/queries/Delaunay_point_queries_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/queries/Voronoi_cell_measures_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/visitors/Edge_changes_visitor_2.h>
#include <CGAL/Dynamic_population_2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <map>
#include <new>
#include <numeric>
#include <optional>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace test_simulation_helpers {

using namespace query_oracle;

constexpr double infinity = std::numeric_limits<double>::infinity();

using Ids = std::vector<std::size_t>;
using Lists = CGAL::Delaunay_neighbor_lists_2;
using Measures = CGAL::Voronoi_cell_measures_2;
template <class Dynamic>
using Queries = CGAL::Delaunay_point_queries_2<Dynamic>;
using Heuristic = CGAL::Dynamic_Delaunay_triangulation_2<Epick, CGAL::Random_classifier_2>;

template <class Kernel>
class Simulation_helpers : public testing::Test
{
protected:
  using Subject = CGAL::Dynamic_Delaunay_triangulation_2<Kernel>;
  using Place = typename Kernel::Point_2;
  using Number = typename Kernel::FT;
  using Places = std::vector<Place>;

  // A triangulation after an update, removals and insertions.
  static Subject veteran()
  {
    Cloud<Kernel> cloud(4);
    auto points = cloud.uniform(100);
    points[50] = points[51] = points[3];
    Subject dt(points.begin(), points.end());
    cloud.shake(points, 0.2);
    points[60] = points[61] = points[5];
    dt.update(points.begin(), points.end());
    for (const std::size_t id : {0u, 5u, 17u, 99u, 42u})
      dt.remove(id);
    dt.insert(Place(5.25, 5.5));
    dt.insert(points[20]);
    return dt;
  }

  // Calls `check(dt)` for triangulations of all kinds.
  template <class Check>
  static void for_each_triangulation(const Check& check)
  {
    for (const auto& [name, points] : clouds_of_all_kinds<Kernel>()) {
      SCOPED_TRACE(name);
      ASSERT_NO_FATAL_FAILURE(check(Subject(points.begin(), points.end())));
    }
    SCOPED_TRACE("updated, inserted, removed");
    ASSERT_NO_FATAL_FAILURE(check(veteran()));
  }

  static bool is_representative(const Subject& dt, std::size_t id)
  {
    return dt.id(dt.vertex(id)) == id;
  }

  static Ids ids_of(const Subject& dt)
  {
    Ids ids;
    for (const auto& [id, p] : model_of(dt))
      ids.push_back(id);
    return ids;
  }
};

using Kernels = testing::Types<Epick, Epeck>;
TYPED_TEST_SUITE(Simulation_helpers, Kernels);

// -------------------------------------------------------------------------------------------------
// Neighbor lists.

template <class Dynamic>
Ids finite_neighbors(const Dynamic& dt, std::size_t id)
{
  Ids ids;
  if (dt.triangulation().dimension() < 1)
    return ids;
  auto neighbor = dt.triangulation().incident_vertices(dt.vertex(id));
  const auto first = neighbor;
  do
    if (!dt.triangulation().is_infinite(neighbor))
      ids.push_back(dt.id(neighbor));
  while (++neighbor != first);
  return ids;
}

Ids list_of(const Lists& lists, std::size_t id)
{
  const auto list = lists.neighbors(id);
  return Ids(list.begin(), list.end());
}

// The ids in their cyclic order, the smallest one first.
Ids rotated(Ids ids)
{
  std::rotate(ids.begin(), std::min_element(ids.begin(), ids.end()), ids.end());
  return ids;
}

TYPED_TEST(Simulation_helpers, lists_are_cgals_incident_vertices_counterclockwise)
{
  using Dynamic = typename TestFixture::Subject;
  Lists lists;
  TestFixture::for_each_triangulation([&](const Dynamic& dt) {
    lists.compute(dt);
    ASSERT_EQ(lists.number_of_ids(), dt.number_of_ids());
    std::map<std::size_t, Ids> duplicates;
    for (const std::size_t id : TestFixture::ids_of(dt))
      if (!TestFixture::is_representative(dt, id)) {
        duplicates[dt.id(dt.vertex(id))].push_back(id);
        ASSERT_EQ(list_of(lists, id), Ids{dt.id(dt.vertex(id))});
      }
    for (const std::size_t id : TestFixture::ids_of(dt)) {
      if (!TestFixture::is_representative(dt, id))
        continue;
      Ids list = list_of(lists, id);
      const Ids& its_duplicates = duplicates[id];
      ASSERT_GE(list.size(), its_duplicates.size());
      const auto first_duplicate = list.end() - Ids::difference_type(its_duplicates.size());
      ASSERT_EQ(Ids(first_duplicate, list.end()), its_duplicates) << id;
      list.erase(first_duplicate, list.end());
      ASSERT_EQ(rotated(list), rotated(finite_neighbors(dt, id))) << id;
    }
    for (std::size_t id = 0; id < dt.number_of_ids(); ++id)
      if (!dt.has_id(id)) {
        ASSERT_EQ(lists.degree(id), 0u) << id;
      }
  });
}

TYPED_TEST(Simulation_helpers, lists_are_symmetric_and_stand_one_after_the_other)
{
  using Dynamic = typename TestFixture::Subject;
  Lists lists;
  TestFixture::for_each_triangulation([&](const Dynamic& dt) {
    lists.compute(dt);
    std::set<std::pair<std::size_t, std::size_t>> pairs;
    ASSERT_EQ(lists.offsets().size(), dt.number_of_ids() + 1);
    ASSERT_EQ(lists.offsets().front(), 0u);
    ASSERT_EQ(lists.offsets().back(), lists.neighbors().size());
    ASSERT_LE(lists.neighbors().size(), 6 * dt.number_of_points());
    for (std::size_t id = 0; id < dt.number_of_ids(); ++id)
      for (std::size_t i = lists.offsets()[id]; i < lists.offsets()[id + 1]; ++i)
        ASSERT_TRUE(pairs.emplace(id, lists.neighbors()[i]).second) << id;
    for (const auto& [i, j] : pairs)
      ASSERT_EQ(pairs.count({j, i}), 1u) << i << ' ' << j;
  });
}

TYPED_TEST(Simulation_helpers, neighbors_and_faces_are_those_of_cgals_triangulation)
{
  using Dynamic = typename TestFixture::Subject;
  TestFixture::for_each_triangulation([](const Dynamic& dt) {
    for (const std::size_t id : TestFixture::ids_of(dt)) {
      Ids neighbors;
      dt.for_each_neighbor(id, [&](std::size_t j) { neighbors.push_back(j); });
      ASSERT_EQ(rotated(neighbors), rotated(finite_neighbors(dt, id))) << id;
    }
    std::multiset<Ids> faces, expected;
    dt.for_each_face([&](const std::array<std::size_t, 3>& ids) {
      faces.insert(rotated(Ids(ids.begin(), ids.end())));
    });
    const auto& cgal = dt.triangulation();
    for (auto f = cgal.finite_faces_begin(); f != cgal.finite_faces_end(); ++f)
      expected.insert(rotated({dt.id(f->vertex(0)), dt.id(f->vertex(1)), dt.id(f->vertex(2))}));
    ASSERT_EQ(faces, expected);
    ASSERT_THROW(dt.for_each_neighbor(dt.number_of_ids(), [](std::size_t) {}),
                 CGAL::Unknown_id_error_2);
  });
}

TEST(Simulation_helpers, lists_neighbors_and_faces_are_there_without_a_certificate)
{
  Cloud<Epick> cloud(5);
  auto points = cloud.uniform(200);
  Heuristic dt(points.begin(), points.end(), CGAL::Random_classifier_2(0.01));
  cloud.shake(points, 0.05);
  dt.update(points.begin(), points.end());
  ASSERT_FALSE(dt.is_certified());
  Lists lists;
  lists.compute(dt);
  std::multiset<std::pair<std::size_t, std::size_t>> expected, listed, met;
  dt.for_each_edge([&](std::size_t i, std::size_t j) {
    expected.emplace(i, j);
    expected.emplace(j, i);
  });
  for (std::size_t id = 0; id < points.size(); ++id) {
    for (const std::size_t neighbor : lists.neighbors(id))
      listed.emplace(id, neighbor);
    dt.for_each_neighbor(id, [&](std::size_t neighbor) { met.emplace(id, neighbor); });
  }
  EXPECT_EQ(listed, expected);
  EXPECT_EQ(met, expected);
  std::size_t faces = 0;
  dt.for_each_face([&](const auto&) { ++faces; });
  EXPECT_EQ(points.size() + faces, expected.size() / 2 + 1); // Euler
}

// -------------------------------------------------------------------------------------------------
// Voronoi cells, by exact polygons.

struct Cell
{
  double area = infinity, perimeter = infinity;
  std::optional<Exact_point> centroid{};
};

Cell measured(const Exact_points& polygon)
{
  Epeck::FT doubled_area = 0;
  Epeck::Vector_2 moment(0, 0);
  double perimeter = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Exact_point &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
    const Epeck::FT cross = p.x() * q.y() - p.y() * q.x();
    doubled_area += cross;
    moment += cross * ((p - CGAL::ORIGIN) + (q - CGAL::ORIGIN));
    perimeter += std::sqrt(CGAL::to_double(CGAL::squared_distance(p, q)));
  }
  Cell cell{CGAL::to_double(doubled_area) / 2, perimeter};
  if (doubled_area != 0)
    cell.centroid = CGAL::ORIGIN + moment / (3 * doubled_area);
  return cell;
}

// The cell of a vertex, by the circumcenters of its faces.
template <class Dynamic>
Cell whole_cell(const Dynamic& dt, std::size_t id)
{
  const auto& triangulation = dt.triangulation();
  if (triangulation.dimension() < 2)
    return {};
  Exact_points polygon;
  auto face = triangulation.incident_faces(dt.vertex(id));
  const auto first = face;
  do {
    if (triangulation.is_infinite(face))
      return {};
    polygon.push_back(CGAL::circumcenter(exact(face->vertex(0)->point()),
                                         exact(face->vertex(1)->point()),
                                         exact(face->vertex(2)->point())));
  } while (++face != first);
  return measured(polygon);
}

template <class Dynamic>
std::vector<typename Dynamic::Point> places_of(const Dynamic& dt)
{
  std::vector<typename Dynamic::Point> places;
  for (const auto& [id, p] : model_of(dt))
    places.push_back(p);
  return places;
}

void expect_close(double value, double expected, double tolerance, std::size_t id)
{
  if (std::isinf(expected))
    ASSERT_EQ(value, expected) << "id " << id;
  else
    ASSERT_NEAR(value, expected, tolerance * (std::max)(1.0, expected)) << "id " << id;
}

// Expects the centroid of a cell, or its point for a cell that has none.
template <class Dynamic>
void expect_centroid(const Measures& measures, const Dynamic& dt, std::size_t id, const Cell& cell,
                     double tolerance)
{
  const Measures::Position centroid = measures.centroids()[id];
  if (!dt.has_id(id)) {
    ASSERT_EQ(centroid.x, 0) << "id " << id;
    ASSERT_EQ(centroid.y, 0) << "id " << id;
    return;
  }
  if (!cell.centroid && measures.areas()[id] > 0)
    return; // what rounding has left of a cell that only touches the box
  const Exact_point expected = cell.centroid.value_or(exact(dt.point(id)));
  const double error = cell.centroid ? tolerance : 0;
  ASSERT_NEAR(centroid.x, rounded(expected.x()), error) << "id " << id;
  ASSERT_NEAR(centroid.y, rounded(expected.y()), error) << "id " << id;
}

// Expects the shape index of a cell, unless it is too thin.
void expect_shape(const Measures& measures, std::size_t id, const Cell& cell)
{
  const double index = measures.shape_indices()[id];
  if (measures.perimeters()[id] == 0) {
    ASSERT_EQ(index, 0) << "id " << id;
  } else if (cell.area == infinity) {
    ASSERT_EQ(index, infinity) << "id " << id;
  } else if (cell.area > 1e-3) {
    ASSERT_NEAR(index, cell.perimeter / std::sqrt(cell.area), 1e-7) << "id " << id;
  }
}

// Expects all measures of a cell, whose area coincident points share; those of a free id are 0.
// `cell_of()` finds the cell.
template <class Dynamic, class Cell_of>
void expect_cell(const Measures& measures, const Dynamic& dt, std::size_t id,
                 double tolerance_of_centroid, const Cell_of& cell_of)
{
  Cell cell{0, 0};
  double sharers = 1;
  if (dt.has_id(id)) {
    cell = cell_of();
    const auto places = places_of(dt);
    sharers = double(std::count(places.begin(), places.end(), dt.point(id)));
  }
  ASSERT_NO_FATAL_FAILURE(expect_close(measures.areas()[id], cell.area / sharers, 1e-10, id));
  ASSERT_NO_FATAL_FAILURE(expect_close(measures.perimeters()[id], cell.perimeter, 1e-10, id));
  ASSERT_NO_FATAL_FAILURE(expect_shape(measures, id, cell));
  ASSERT_NO_FATAL_FAILURE(expect_centroid(measures, dt, id, cell, tolerance_of_centroid));
}

double sum(const std::vector<double>& numbers)
{
  return std::accumulate(numbers.begin(), numbers.end(), 0.0);
}

TYPED_TEST(Simulation_helpers, whole_cells_are_the_polygons_of_the_circumcenters)
{
  using Dynamic = typename TestFixture::Subject;
  Measures measures;
  TestFixture::for_each_triangulation([&](const Dynamic& dt) {
    measures.compute(dt);
    ASSERT_EQ(measures.areas().size(), dt.number_of_ids());
    ASSERT_EQ(measures.perimeters().size(), dt.number_of_ids());
    ASSERT_EQ(measures.centroids().size(), dt.number_of_ids());
    ASSERT_EQ(measures.shape_indices().size(), dt.number_of_ids());
    for (std::size_t id = 0; id < dt.number_of_ids(); ++id)
      ASSERT_NO_FATAL_FAILURE(
          expect_cell(measures, dt, id, 1e-9, [&] { return whole_cell(dt, id); }));
  });
}

TYPED_TEST(Simulation_helpers, clipped_cells_are_what_all_bisectors_leave_of_the_box)
{
  using Dynamic = typename TestFixture::Subject;
  Measures measures;
  TestFixture::for_each_triangulation([&](const Dynamic& dt) {
    const auto places = places_of(dt);
    for (const CGAL::Bbox_2 box : {CGAL::Bbox_2(0, 0, 9, 9), CGAL::Bbox_2(2.5, 3, 4, 3.25),
                                   CGAL::Bbox_2(-80, -90, 70, 100), CGAL::Bbox_2(20, 30, 40, 50)}) {
      measures.compute(dt, box);
      ASSERT_EQ(measures.centroids().size(), dt.number_of_ids());
      for (std::size_t id = 0; id < dt.number_of_ids(); ++id)
        ASSERT_NO_FATAL_FAILURE(expect_cell(measures, dt, id, 1e-10, [&] {
          return measured(clipped_cell(places, dt.point(id), box));
        }));
    }
  });
}

TYPED_TEST(Simulation_helpers, clipped_cells_add_up_to_the_box_wherever_the_points_are)
{
  using Dynamic = typename TestFixture::Subject;
  Measures measures;
  for (const double scale : {1e-6, 0.01, 1.0, 100.0, 1e6})
    for (const double offset : {0.0, -3.0, 1e4}) {
      SCOPED_TRACE(std::to_string(scale) + " " + std::to_string(offset));
      for (auto [name, points] : clouds_of_all_kinds<TypeParam>()) {
        if (points.empty())
          continue;
        SCOPED_TRACE(name);
        points = scaled<TypeParam>(points, scale, offset);
        const Dynamic dt(points.begin(), points.end());
        measures.compute(dt, CGAL::Bbox_2(-4, 1, 12, 6));
        for (const double area : measures.areas())
          ASSERT_GE(area, -1e-12);
        ASSERT_NEAR(sum(measures.areas()), 80, 80e-13);
      }
    }
  const auto points = Cloud<TypeParam>(6).uniform(3000);
  const Dynamic dt(points.begin(), points.end());
  measures.compute(dt, CGAL::Bbox_2(0, 0, 50, 50));
  EXPECT_NEAR(sum(measures.areas()), 2500, 1e-9);
}

TYPED_TEST(Simulation_helpers, centroids_weighted_by_areas_are_the_center_of_the_box)
{
  const auto points = Cloud<TypeParam>(13).uniform(3000);
  const typename TestFixture::Subject dt(points.begin(), points.end());
  Measures measures;
  for (const double low : {0.0, 30.0, -1e6}) {
    measures.compute(dt, CGAL::Bbox_2(low, 2, 50, 12));
    const double area = (50 - low) * 10;
    double x = 0, y = 0;
    for (std::size_t id = 0; id < points.size(); ++id) {
      const auto [centroid_x, centroid_y] = measures.centroids()[id];
      x += measures.areas()[id] * centroid_x / area;
      y += measures.areas()[id] * centroid_y / area;
    }
    EXPECT_NEAR(x, (low + 50) / 2, 1e-12 * (50 - low)) << low;
    EXPECT_NEAR(y, 7, 1e-12 * (50 - low)) << low;
  }
}

TEST(Simulation_helpers, centroids_of_thin_cells_stay_in_the_box)
{
  // Cells so thin that rounding decides about their areas.
  Cloud<Epick> cloud(14);
  auto points = cloud.uniform(40);
  for (const auto& p : cloud.uniform(200))
    points.push_back(Epick::Point_2(3 + 1e-15 * CGAL::to_double(p.x()), p.y()));
  const CGAL::Dynamic_Delaunay_triangulation_2<Epick> dt(points.begin(), points.end());
  Measures measures;
  measures.compute(dt, CGAL::Bbox_2(2, 2, 4, 5));
  for (std::size_t id = 0; id < points.size(); ++id)
    if (measures.areas()[id] > 0) {
      const auto [x, y] = measures.centroids()[id];
      EXPECT_TRUE(x > 2 - 1e-12 && x < 4 + 1e-12) << id << ": " << x;
      EXPECT_TRUE(y > 2 - 1e-12 && y < 5 + 1e-12) << id << ": " << y;
    }
}

TYPED_TEST(Simulation_helpers, centroids_are_right_at_all_sizes)
{
  using Dynamic = typename TestFixture::Subject;
  Measures measures;
  for (const double unit : {1e-100, 1e100, 1e150}) {
    const auto points = scaled<TypeParam>(Cloud<TypeParam>(15).uniform(50), unit);
    const Dynamic dt(points.begin(), points.end());
    const CGAL::Bbox_2 box(unit, unit, 5 * unit, 6 * unit);
    measures.compute(dt, box);
    for (std::size_t id = 0; id < points.size(); ++id)
      ASSERT_NO_FATAL_FAILURE(expect_centroid(
          measures, dt, id, measured(clipped_cell(points, points[id], box)), 1e-10 * unit));
  }
}

TYPED_TEST(Simulation_helpers, a_box_of_the_kernel_is_as_good_as_one_of_doubles)
{
  const auto dt = TestFixture::veteran();
  Measures of_kernel, of_doubles;
  of_kernel.compute(dt, typename TypeParam::Iso_rectangle_2(1, 2, 8, 7.5));
  of_doubles.compute(dt, CGAL::Bbox_2(1, 2, 8, 7.5));
  EXPECT_EQ(of_kernel.areas(), of_doubles.areas());
  EXPECT_EQ(of_kernel.perimeters(), of_doubles.perimeters());
  for (std::size_t id = 0; id < dt.number_of_ids(); ++id) {
    EXPECT_EQ(of_kernel.centroids()[id].x, of_doubles.centroids()[id].x);
    EXPECT_EQ(of_kernel.centroids()[id].y, of_doubles.centroids()[id].y);
  }
  EXPECT_NEAR(sum(of_kernel.areas()), 7 * 5.5, 1e-11);
}

TYPED_TEST(Simulation_helpers, a_box_without_an_inside_has_no_area)
{
  const auto dt = TestFixture::veteran();
  Measures measures;
  measures.compute(dt, CGAL::Bbox_2(1, 2, 1, 7));
  EXPECT_EQ(sum(measures.areas()), 0);
  for (std::size_t id = 0; id < dt.number_of_ids(); ++id) {
    expect_centroid(measures, dt, id, {}, 0);
    EXPECT_EQ(measures.shape_indices()[id], measures.perimeters()[id] > 0 ? infinity : 0);
  }
}

TYPED_TEST(Simulation_helpers, a_box_that_is_none_is_refused_and_the_measures_stay)
{
  const auto dt = TestFixture::veteran();
  Measures measures;
  measures.compute(dt);
  const auto areas = measures.areas();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const CGAL::Bbox_2& box :
       {CGAL::Bbox_2(1, 0, 0, 1), CGAL::Bbox_2(0, 1, 1, 0), CGAL::Bbox_2(0, 0, infinity, 1),
        CGAL::Bbox_2(0, nan, 1, 1), CGAL::Bbox_2(-1.5e308, 0, 1.5e308, 1), CGAL::Bbox_2()})
    EXPECT_THROW(measures.compute(dt, box), CGAL::Parameter_error_2);
  EXPECT_EQ(measures.areas(), areas);
}

TEST(Simulation_helpers, cells_at_a_face_that_is_nearly_flat_reach_far_and_add_up_in_the_box)
{
  // The circle through the first three has a radius of 2^60 or so: no point is in it.
  const std::vector<Epick::Point_2> points = {{-1, 0}, {0, -0x1p-61}, {1, 0}, {0, -5}};
  const CGAL::Dynamic_Delaunay_triangulation_2<Epick> dt(points.begin(), points.end());
  Measures measures;
  measures.compute(dt);
  ASSERT_EQ(finite_neighbors(dt, 1).size(), 3u);
  for (const double area : measures.areas())
    EXPECT_TRUE(area > 1e15) << area;
  measures.compute(dt, CGAL::Bbox_2(-4, -4, 4, 4));
  EXPECT_NEAR(sum(measures.areas()), 64, 1e-12);
  const std::vector<double>& areas = measures.areas();
  EXPECT_NEAR(areas[0], areas[2], 1e-12);
  EXPECT_NEAR(areas[1], 6.5, 1e-12); // from -2.5 to 4, between -1/2 and 1/2
}

TEST(Simulation_helpers, a_face_whose_orientation_drowns_in_rounding_leaves_its_cells_unbounded)
{
  // The second one is hardly below the line through the first and the third.
  const std::vector<Epick::Point_2> points = {
      {0, 0}, {0.3, std::nextafter(0.1, 0.0)}, {0.6, 0.2}, {0.3, -5}};
  const CGAL::Dynamic_Delaunay_triangulation_2<Epick> dt(points.begin(), points.end());
  ASSERT_EQ(finite_neighbors(dt, 1).size(), 3u);
  EXPECT_FALSE(std::isinf(whole_cell(dt, 1).area));
  Measures measures;
  measures.compute(dt);
  EXPECT_EQ(measures.areas(), std::vector<double>(4, infinity));
  EXPECT_EQ(measures.perimeters(), std::vector<double>(4, infinity));
}

TEST(Simulation_helpers, needles_keep_their_digits_however_thin)
{
  // Two points hardly apart, in the middle of others.
  const std::vector<Epick::Point_2> points = {{0, 0}, {1e-30, 1e-31}, {1, 0},
                                              {0, 1}, {-1, 0.25},     {0.25, -1}};
  const CGAL::Dynamic_Delaunay_triangulation_2<Epick> dt(points.begin(), points.end());
  Measures measures;
  measures.compute(dt);
  for (const std::size_t id : {0u, 1u}) {
    const Cell cell = whole_cell(dt, id);
    EXPECT_NEAR(measures.areas()[id], cell.area, 1e-14);
    EXPECT_NEAR(measures.perimeters()[id], cell.perimeter, 1e-14);
  }
}

TEST(Simulation_helpers, points_that_only_an_exact_kernel_tells_apart_have_cells_of_their_own)
{
  using Exact = CGAL::Dynamic_Delaunay_triangulation_2<Epeck>;
  const Epeck::FT tiny = Epeck::FT(1) / Epeck::FT(3e20);
  const std::vector<Epeck::Point_2> points = {{1, 1}, {1 + tiny, 1}, {Epeck::FT(1) / 3, -2},
                                              {3, 1}, {1, 3},        {-2, 1.5}};
  const Exact dt(points.begin(), points.end());
  ASSERT_EQ(dt.number_of_vertices(), 6u);
  Measures measures;
  measures.compute(dt);
  for (const std::size_t id : {0u, 1u})
    EXPECT_NEAR(measures.areas()[id], whole_cell(dt, id).area, 1e-12);
  const CGAL::Bbox_2 box(-3, -3, 4, 4);
  measures.compute(dt, box);
  for (std::size_t id = 0; id < points.size(); ++id)
    EXPECT_NEAR(measures.areas()[id], measured(clipped_cell(points, points[id], box)).area, 1e-12)
        << id;
  EXPECT_NEAR(sum(measures.areas()), 49, 1e-12);
  Queries<Exact> queries(dt);
  EXPECT_EQ(queries.nearest({2, 1}), 1u);
  EXPECT_EQ(queries.nearest({0, 1}), 0u);
  EXPECT_EQ(queries.nearest({1 + tiny / 2, 0}), 0u);
  EXPECT_EQ(queries.nearest({1 + tiny * 2 / 3, 0}), 1u);
  EXPECT_EQ(queries.nearest_neighbor(0), 1u);
  Ids ids;
  queries.neighbors_within(0, tiny * tiny, std::back_inserter(ids));
  queries.neighbors_within(1, tiny * tiny * 99 / 100, std::back_inserter(ids));
  EXPECT_EQ(ids, Ids{1});
}

// -------------------------------------------------------------------------------------------------
// Queries, by looking at all points.

template <class Dynamic>
std::optional<std::size_t> nearest_by_looking(const Dynamic& dt, const typename Dynamic::Point& p,
                                              std::size_t asking = std::size_t(-1))
{
  std::optional<std::size_t> nearest;
  Epeck::FT least = 0;
  for (const auto& [id, q] : model_of(dt)) {
    const Epeck::FT square = CGAL::squared_distance(exact(p), exact(q));
    if (id != asking && (!nearest || square < least)) {
      nearest = id;
      least = square;
    }
  }
  return nearest;
}

template <class Dynamic>
Ids within_by_looking(const Dynamic& dt, const typename Dynamic::Point& p,
                      const typename Dynamic::Geom_traits::FT& squared_radius,
                      std::size_t asking = std::size_t(-1))
{
  Ids ids;
  for (const auto& [id, q] : model_of(dt))
    if (id != asking && CGAL::squared_distance(exact(p), exact(q)) <= Epeck::FT(squared_radius))
      ids.push_back(id);
  return ids;
}

// The ids that `search(ids)` writes, ascending.
template <class Search>
Ids found(const Search& search)
{
  Ids ids;
  search(std::back_inserter(ids));
  std::sort(ids.begin(), ids.end());
  return ids;
}

// Places among points and far away, and for ties the places of points and midpoints of them.
template <class Kernel, class Dynamic>
std::vector<typename Kernel::Point_2> locations(const Dynamic& dt)
{
  using Point = typename Kernel::Point_2;
  std::vector<Point> result = {Point(0, 0), Point(3.5, 2.5), Point(3, 2.5),
                               Point(4, 4), Point(1e9, -3),  Point(-1e-9, 7)};
  const auto places = places_of(dt);
  for (std::size_t i = 0; i < places.size(); i += 3) {
    result.push_back(places[i]);
    result.push_back(CGAL::midpoint(places[i], places[places.size() / 2]));
  }
  const auto more = Cloud<Kernel>(7).uniform(30);
  result.insert(result.end(), more.begin(), more.end());
  return result;
}

TYPED_TEST(Simulation_helpers, the_nearest_point_is_the_one_that_looking_at_all_finds)
{
  using Dynamic = typename TestFixture::Subject;
  TestFixture::for_each_triangulation([&](const Dynamic& dt) {
    Queries<Dynamic> queries(dt);
    for (const auto& p : locations<TypeParam>(dt))
      ASSERT_EQ(queries.nearest(p), nearest_by_looking(dt, p)) << p;
    for (const std::size_t id : TestFixture::ids_of(dt))
      ASSERT_EQ(queries.nearest_neighbor(id), nearest_by_looking(dt, dt.point(id), id)) << id;
  });
}

TYPED_TEST(Simulation_helpers, those_within_a_radius_are_the_ones_that_looking_at_all_finds)
{
  using Dynamic = typename TestFixture::Subject;
  TestFixture::for_each_triangulation([&](const Dynamic& dt) {
    Queries<Dynamic> queries(dt);
    // some are squared distances in lattices and on circles
    for (const double square : {0.0, 0.25, 1.0, 2.0, 5.0, 25.0, 4225.0, 1e18, 1e300}) {
      for (const auto& p : locations<TypeParam>(dt))
        ASSERT_EQ(found([&](auto ids) { queries.within(p, square, ids); }),
                  within_by_looking(dt, p, square))
            << p << ", " << square;
      for (const std::size_t id : TestFixture::ids_of(dt))
        ASSERT_EQ(found([&](auto ids) { queries.neighbors_within(id, square, ids); }),
                  within_by_looking(dt, dt.point(id), square, id))
            << id << ", " << square;
    }
  });
}

TYPED_TEST(Simulation_helpers, points_on_the_circle_are_within_and_those_a_rounding_beyond_are_not)
{
  using Dynamic = typename TestFixture::Subject;
  using Point = typename TestFixture::Place;
  auto points = Cloud<TypeParam>::on_circle(36);
  const double beyond = std::nextafter(65.0, 66.0);
  points.push_back(Point(beyond, 0));
  points.push_back(Point(0, -beyond));
  const Dynamic dt(points.begin(), points.end());
  Queries<Dynamic> queries(dt);
  const auto ids = found([&](auto out) { queries.within(Point(0, 0), 4225, out); });
  Ids expected(36);
  std::iota(expected.begin(), expected.end(), std::size_t(0));
  EXPECT_EQ(ids, expected);
  EXPECT_EQ(queries.nearest(Point(0, 0)), 0u);
  const double less = std::nextafter(4225.0, 0.0);
  EXPECT_TRUE(found([&](auto out) { queries.within(Point(0, 0), less, out); }).empty());
}

TYPED_TEST(Simulation_helpers, queries_see_differences_that_drown_in_rounding)
{
  using Dynamic = typename TestFixture::Subject;
  using Point = typename TestFixture::Place;
  std::mt19937 random(12);
  std::uniform_real_distribution<double> coordinate(-1, 1);
  for (const double unit : {1.0, 1e-160})
    for (int i = 0; i < 500; ++i) {
      const double x = unit * coordinate(random), y = unit * coordinate(random);
      const double qx = unit * coordinate(random), qy = unit * coordinate(random);
      const Point q(qx, qy); // two points that would be equally far from it but for rounding
      const std::vector<Point> points = {Point(qx + x, qy + y),
                                         Point(qx + (3 * x - 4 * y) / 5, qy + (4 * x + 3 * y) / 5)};
      const Dynamic dt(points.begin(), points.end());
      Queries<Dynamic> queries(dt);
      ASSERT_EQ(queries.nearest(q), nearest_by_looking(dt, q)) << i;
      const double square = CGAL::to_double(CGAL::squared_distance(exact(q), exact(points[0])));
      ASSERT_EQ(found([&](auto ids) { queries.within(q, square, ids); }),
                within_by_looking(dt, q, square))
          << i;
    }
}

TYPED_TEST(Simulation_helpers, queries_are_exact_where_squares_leave_the_doubles)
{
  using Dynamic = typename TestFixture::Subject;
  using Point = typename TestFixture::Place;
  for (const double unit : {1e-200, 1e-160, 1e152}) {
    const auto points = scaled<TypeParam>(Cloud<TypeParam>::grid(6, 6), unit);
    const Dynamic dt(points.begin(), points.end());
    Queries<Dynamic> queries(dt);
    for (const Point& p : points) {
      const Point q(CGAL::to_double(p.x()) + 0.25 * unit, CGAL::to_double(p.y()) - 0.375 * unit);
      ASSERT_EQ(queries.nearest(q), nearest_by_looking(dt, q)) << unit;
    }
    for (std::size_t id = 0; id < points.size(); ++id)
      ASSERT_EQ(queries.nearest_neighbor(id), nearest_by_looking(dt, points[id], id)) << unit;
  }
}

TYPED_TEST(Simulation_helpers, queries_follow_the_triangulation_while_it_changes)
{
  using Dynamic = typename TestFixture::Subject;
  using Point = typename TestFixture::Place;
  Cloud<TypeParam> cloud(8);
  auto points = cloud.uniform(150);
  Dynamic dt;
  Queries<Dynamic> queries(dt);
  EXPECT_FALSE(queries.nearest(Point(0, 0)));
  dt.insert(points.begin(), points.end(), std::vector<std::size_t>(points.size()).begin());
  for (int frame = 0; frame < 20; ++frame) {
    cloud.shake(points, 0.1);
    dt.update(points.begin(), points.end());
    if (frame % 5 == 4) {
      const std::size_t last = dt.number_of_ids() - 1;
      dt.remove(last - std::size_t(frame));
    }
    for (const auto& p : locations<TypeParam>(dt)) {
      ASSERT_EQ(queries.nearest(p), nearest_by_looking(dt, p));
      ASSERT_EQ(found([&](auto ids) { queries.within(p, 4, ids); }), within_by_looking(dt, p, 4));
    }
  }
  for (std::size_t id = 0; id < 150; ++id)
    if (dt.has_id(id) && id != 77)
      dt.remove(id);
  EXPECT_EQ(queries.nearest(Point(0, 0)), 77u);
  EXPECT_FALSE(queries.nearest_neighbor(77));
}

TYPED_TEST(Simulation_helpers, queries_refuse_what_is_no_place_no_radius_and_no_id)
{
  using Dynamic = typename TestFixture::Subject;
  using Point = typename TestFixture::Place;
  using FT = typename TestFixture::Number;
  const Dynamic dt = TestFixture::veteran();
  Queries<Dynamic> queries(dt);
  Ids ids;
  const auto out = std::back_inserter(ids);
  const FT huge = FT(1e300) * FT(1e300);
  EXPECT_THROW(queries.nearest(Point(0, huge)), CGAL::Non_finite_coordinate_error_2);
  EXPECT_THROW(queries.within(Point(huge, 0), 1, out), CGAL::Non_finite_coordinate_error_2);
  EXPECT_THROW(queries.within(Point(0, 0), -1, out), CGAL::Parameter_error_2);
  EXPECT_THROW(queries.within(Point(0, 0), huge, out), CGAL::Parameter_error_2);
  EXPECT_THROW(queries.neighbors_within(1, -1, out), CGAL::Parameter_error_2);
  EXPECT_THROW(queries.neighbors_within(17, 1, out), CGAL::Unknown_id_error_2);
  EXPECT_THROW(queries.neighbors_within(1000, 1, out), CGAL::Unknown_id_error_2);
  EXPECT_THROW(queries.nearest_neighbor(1000), CGAL::Unknown_id_error_2);
  EXPECT_TRUE(ids.empty());
}

// -------------------------------------------------------------------------------------------------
// All of them.

TEST(Simulation_helpers, without_a_certificate_there_are_no_cells_and_no_answers)
{
  Cloud<Epick> cloud(9);
  auto points = cloud.uniform(100);
  Heuristic dt(points.begin(), points.end(), CGAL::Random_classifier_2(0.01));
  Queries<Heuristic> queries(dt);
  Measures measures;
  measures.compute(dt);
  const auto areas = measures.areas();
  cloud.shake(points, 0.2);
  dt.update(points.begin(), points.end());
  ASSERT_FALSE(dt.is_certified());
  using Error = CGAL::Uncertified_triangulation_error_2;
  Ids ids;
  EXPECT_THROW(measures.compute(dt), Error);
  EXPECT_THROW(measures.compute(dt, CGAL::Bbox_2(0, 0, 1, 1)), Error);
  EXPECT_EQ(measures.areas(), areas);
  EXPECT_THROW(queries.nearest({1, 1}), Error);
  EXPECT_THROW(queries.nearest_neighbor(1), Error);
  EXPECT_THROW(queries.within({1, 1}, 1, std::back_inserter(ids)), Error);
  EXPECT_THROW(queries.neighbors_within(1, 1, std::back_inserter(ids)), Error);
  dt.mend();
  EXPECT_EQ(queries.nearest({1, 1}), nearest_by_looking(dt, {1, 1}));
}

TEST(Simulation_helpers, another_calm_frame_allocates_nothing)
{
  using Dynamic = CGAL::Dynamic_Delaunay_triangulation_2<Epick>;
  Cloud<Epick> cloud(10);
  auto points = cloud.uniform(1000);
  points[7] = points[8];
  Dynamic dt(points.begin(), points.end());
  Lists lists;
  Measures whole, clipped;
  Queries<Dynamic> queries(dt);
  Ids ids(points.size());
  for (int frame = 0; frame < 10; ++frame) {
    cloud.shake(points, 1e-6);
    points[7] = points[8];
    dt.update(points.begin(), points.end());
    const std::size_t before = replaced_heap::number_of_allocations;
    lists.compute(dt);
    whole.compute(dt);
    clipped.compute(dt, CGAL::Bbox_2(0, 0, 31, 31));
    for (std::size_t id = 0; id < points.size(); ++id) {
      queries.nearest(points[id]);
      queries.nearest_neighbor(id);
      queries.within(points[id], 4, ids.begin());
    }
    if (frame > 0) {
      EXPECT_EQ(replaced_heap::number_of_allocations, before) << "frame " << frame;
    }
  }
}

TEST(Simulation_helpers, lists_and_cells_are_gone_if_memory_runs_out_and_can_be_had_again)
{
  const auto points = Cloud<Epick>(11).uniform(50);
  const CGAL::Dynamic_Delaunay_triangulation_2<Epick> dt(points.begin(), points.end());
  const auto compute = [&](Lists& lists, Measures& measures) {
    lists.compute(dt);
    measures.compute(dt, CGAL::Bbox_2(0, 0, 7, 7));
  };
  bool has_run_out = true;
  for (long allocations = 0; has_run_out; ++allocations) {
    Lists lists;
    Measures measures;
    has_run_out = false;
    try {
      const replaced_heap::Scarcity scarcity(allocations);
      compute(lists, measures);
    } catch (const std::bad_alloc&) {
      has_run_out = true;
      EXPECT_TRUE(measures.areas().empty());
      EXPECT_TRUE(measures.perimeters().empty());
      EXPECT_TRUE(measures.centroids().empty());
      EXPECT_TRUE(measures.shape_indices().empty());
      compute(lists, measures);
    }
    EXPECT_EQ(lists.number_of_ids(), points.size());
    EXPECT_NEAR(sum(measures.areas()), 49, 1e-11);
  }
}

TEST(Simulation_helpers, a_population_has_all_that_by_the_ids_of_its_triangulation)
{
  using Dynamic = CGAL::Dynamic_Delaunay_triangulation_2<Epick>;
  using Point = Epick::Point_2;
  CGAL::Dynamic_population_2<Dynamic, long> people;
  std::map<long, Point> frame = {{-7, {1, 1}}, {40, {3, 1}}, {41, {3, 4}}, {5, {0, 3}}};
  people.update(frame.begin(), frame.end());
  frame.erase(40);
  frame[1'000'000'000'000] = {2, 2};
  people.update(frame.begin(), frame.end());

  const Dynamic& dt = people.triangulation();
  Lists lists;
  lists.compute(dt);
  std::set<long> neighbors;
  for (const std::size_t id : lists.neighbors(people.id(1'000'000'000'000)))
    neighbors.insert(people.user_id(id));
  EXPECT_EQ(neighbors, (std::set<long>{-7, 5, 41}));

  Measures measures;
  measures.compute(dt, CGAL::Bbox_2(0, 0, 4, 4));
  double area = 0;
  for (const auto& [user_id, p] : frame)
    area += measures.areas()[people.id(user_id)];
  EXPECT_NEAR(area, 16, 1e-13);

  Queries<Dynamic> queries(dt);
  EXPECT_EQ(people.user_id(*queries.nearest({1.25, 1})), -7);
  EXPECT_EQ(people.user_id(*queries.nearest_neighbor(people.id(-7))), 1'000'000'000'000);
}

TEST(Simulation_helpers, whoever_may_only_look_can_ask)
{
  using Dynamic =
      CGAL::Dynamic_Delaunay_triangulation_2<Epick, CGAL::Default,
                                             CGAL::With_visitor_2<CGAL::Edge_changes_visitor_2>>;
  using Edges = std::vector<CGAL::Edge_changes_visitor_2::Edge>;
  using Point = Epick::Point_2;
  CGAL::Dynamic_population_2<Dynamic, int> changing;
  changing.update(std::map<int, Point>{{10, {0, 0}}, {11, {4, 0}}, {12, {0, 3}}});

  const auto& people = changing;
  EXPECT_EQ(people.visitor().created_edges(), (Edges{{0, 1}, {0, 2}, {1, 2}}));

  const Queries<Dynamic> queries(people.triangulation());
  EXPECT_EQ(queries.nearest(Point(3, 1)), people.id(11));
  EXPECT_EQ(queries.nearest_neighbor(people.id(11)), people.id(10));
  EXPECT_EQ(found([&](auto ids) { queries.within(Point(0, 1), 4, ids); }),
            (Ids{people.id(10), people.id(12)}));
  EXPECT_EQ(found([&](auto ids) { queries.neighbors_within(people.id(10), 9, ids); }),
            Ids{people.id(12)});
}

} // namespace test_simulation_helpers

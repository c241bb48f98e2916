// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// What comes out of a triangulation in tori, slabs and wires in space: Voronoi cells, how their
// volumes change, neighbor lists.

#include "periodic_space_tested.h"
#include "voronoi_volumes.h"

#include <CGAL/Dynamic_Delaunay_triangulation_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/Delaunay_neighbor_lists_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/Voronoi_cell_gradients_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/Voronoi_cell_measures_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/Voronoi_cell_volumes_3.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <map>
#include <numeric>
#include <random>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace test_periodic_space_cells_3 {

using namespace periodic_space_tested;
using space_points::lattice;

using Open = CGAL::Dynamic_Delaunay_triangulation_3<Kernel>;
using Areas = std::map<Site, double, Site_order>;
using Measures = CGAL::Voronoi_cell_measures_3;
using Volumes = CGAL::Voronoi_cell_volumes_3;
using Gradients = CGAL::Voronoi_cell_gradients_3;
using Lists = CGAL::Delaunay_neighbor_lists_3;

Shift operator-(const Shift& s)
{
  return {-s[0], -s[1], -s[2]};
}

Areas facets(const Measures& measures, std::size_t id)
{
  Areas result;
  for (std::size_t i = measures.offsets()[id]; i < measures.offsets()[id + 1]; ++i) {
    const Site site(measures.neighbors()[i], measures.shifts()[i]);
    EXPECT_TRUE(result.emplace(site, measures.facet_areas()[i]).second);
    EXPECT_EQ(result.rbegin()->first, site); // in order
  }
  return result;
}

double sum(const std::vector<double>& numbers)
{
  return std::accumulate(numbers.begin(), numbers.end(), 0.0);
}

// What must be true of all cells: in a torus these are bounded.
void expect_consistent(const Dynamic& dt, const Measures& measures)
{
  const double whole = dt.cell().volume();
  ASSERT_EQ(measures.number_of_ids(), dt.number_of_ids());
  ASSERT_EQ(measures.shifts().size(), measures.neighbors().size());
  ASSERT_EQ(measures.facet_areas().size(), measures.neighbors().size());
  if (dt.number_of_points() > 0 && whole < infinity) {
    ASSERT_NEAR(sum(measures.volumes()), whole, 1e-12 * whole);
  }
  for (std::size_t id = 0; id < dt.number_of_ids(); ++id) {
    if (whole < infinity || !dt.has_id(id)) {
      ASSERT_EQ(measures.is_bounded(id), dt.has_id(id));
    }
    double surface = 0;
    for (const auto& [site, area] : facets(measures, id)) {
      const auto& [other, shift] = site;
      ASSERT_GE(area, 0);
      ASSERT_EQ(facets(measures, other).at({id, -shift}), area) << "ids " << id << ", " << other;
      surface += area;
    }
    if (!dt.has_id(id) || dt.representative(id) != id)
      continue;
    if (measures.is_bounded(id)) {
      ASSERT_NEAR(measures.surface_areas()[id], surface, 1e-12 * surface);
    } else {
      ASSERT_EQ(measures.volumes()[id], infinity);
    }
  }
}

Measures measures_of(const Dynamic& dt)
{
  Measures measures;
  measures.compute(dt);
  expect_consistent(dt, measures);
  voronoi_volumes::expect_measured(dt, measures, 1e-9);
  return measures;
}

// LATTICES ----------------------------------------------------------------------------------------

TEST(Periodic_cells, of_one_point_are_boxes)
{
  for (const double side : {1.0, 0.7, 3e-30, 1e30})
    for (const double at : {0.0, 0.3, -1234.5}) {
      const Dynamic dt(Points{Point(at * side, -at * side, 2 * side)}, Cell(side, side, side));
      const Measures measures = measures_of(dt);
      const double square = side * side;
      EXPECT_NEAR(measures.volumes()[0], square * side, 1e-14 * square * side);
      EXPECT_NEAR(measures.surface_areas()[0], 6 * square, 1e-13 * square);
      EXPECT_NEAR(measures.centroids()[0].x, at * side, 1e-12 * side);
      std::set<Shift> six{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
      for (const auto& [site, area] : facets(measures, 0)) {
        EXPECT_EQ(six.erase(site.second), 1u);
        EXPECT_NEAR(area, square, 1e-14 * square);
      }
      EXPECT_TRUE(six.empty());
    }
}

void expect_alike(const Dynamic& dt, double volume, double surface, std::size_t number_of_facets)
{
  const Measures measures = measures_of(dt);
  for (std::size_t id = 0; id < dt.number_of_ids(); ++id) {
    const Point p = dt.point(id);
    ASSERT_NEAR(measures.volumes()[id], volume, 1e-13 * volume);
    ASSERT_NEAR(measures.surface_areas()[id], surface, 1e-13 * surface);
    ASSERT_EQ(facets(measures, id).size(), number_of_facets);
    ASSERT_NEAR(measures.centroids()[id].x, p.x(), 1e-13 * (1 + std::abs(p.x())));
    ASSERT_NEAR(measures.centroids()[id].z, p.z(), 1e-13 * (1 + std::abs(p.z())));
  }
}

TEST(Periodic_cells, of_lattices_have_facets_with_an_area_only)
{
  for (int side = 1; side <= 4; ++side) {
    SCOPED_TRACE("side " + std::to_string(side));
    const Points cubic = lattice(side);
    const Cell cell(side, side, side), doubled(2 * side, 2 * side, 2 * side);
    Points face_centered, body_centered;
    for (const Point& p : cubic)
      for (int i = 0; i < 4; ++i) {
        const auto is = [i](int other) { return double(i > 0 && i != other); };
        face_centered.emplace_back(2 * p.x() + is(1), 2 * p.y() + is(2), 2 * p.z() + is(3));
        if (i < 2)
          body_centered.emplace_back(2 * p.x() + i, 2 * p.y() + i, 2 * p.z() + i);
      }
    Dynamic dt(cubic, cell), f(face_centered, doubled), b(body_centered, doubled);
    for (const double step : {0.0, 1e-9, 0.05}) {
      if (step > 0)
        for (const auto& [some, points] :
             {std::pair(&dt, cubic), {&f, face_centered}, {&b, body_centered}}) {
          some->update(shaken(points, step, 5));
          measures_of(*some);
          some->update(points); // other cells than before where points are cospherical
        }
      ASSERT_NO_FATAL_FAILURE(expect_alike(dt, 1, 6, 6));
      ASSERT_NO_FATAL_FAILURE(expect_alike(f, 2, 6 * std::sqrt(2.0), 12)); // rhombic dodecahedra
      ASSERT_NO_FATAL_FAILURE(                                             // truncated octahedra
          expect_alike(b, 4, 3 * (1 + 2 * std::sqrt(3.0)), 14));
    }
  }
}

using Periodic_cells_of_kind = Of_kind;
INSTANTIATE_TEST_SUITE_P(kinds, Periodic_cells_of_kind, all_kinds(), name_of);

TEST_P(Periodic_cells_of_kind, of_lattices_have_facets_with_an_area_only)
{
  for (const int length : {1, 2, 4})
    for (int depth = dimension == 1 ? 2 : 1; depth <= 4; ++depth) {
      const std::array<int, 3> sides{length, dimension == 1 ? depth : length, depth};
      const Points points = box_lattice(sides[0], sides[1], sides[2]);
      Measures measures;
      measures.compute(Dynamic(points, kind.box(sides[0], sides[1], sides[2])));
      for (std::size_t id = 0; id < points.size(); ++id) {
        std::array<std::size_t, 3> walls{0, 0, 0}; // beyond which there are no neighbors
        for (std::size_t k = dimension; k < 3; ++k) {
          const double x = points[id][int(k)];
          walls[k] = std::size_t(x == 0) + std::size_t(x == sides[k] - 1);
        }
        const std::size_t all = walls[0] + walls[1] + walls[2];
        std::size_t finite = 0; // facets between neighbors that have no walls across
        for (const std::size_t own : walls)
          finite += all == own ? 2 - own : 0;
        EXPECT_EQ(facets(measures, id).size(), 6u - all);
        EXPECT_EQ(measures.is_bounded(id), all == 0);
        if (all == 0) {
          EXPECT_NEAR(measures.volumes()[id], 1, 1e-14);
        }
        double area = 0;
        for (const auto& [site, of_facet] : facets(measures, id))
          area += of_facet < infinity ? of_facet : 0;
        EXPECT_NEAR(area, double(finite), 1e-14);
      }
    }
}

TEST(Periodic_cells, of_lattices_do_not_depend_on_the_vectors)
{
  Dynamic dt(lattice(3), Cell(3, 3, 3));
  for (const Cell& cell :
       {Cell({3, 0, 0}, {3, 3, 0}, {-3, 6, 3}), Cell({0, 3, 0}, {0, 0, -3}, {3, 0, 0}),
        Cell({3, 0, 0}, {1, 3, 0}, {1, -1, 3})}) {
    dt.update(lattice(3), cell);
    ASSERT_NO_FATAL_FAILURE(expect_alike(dt, 1, 6, 6));
    ASSERT_NO_FATAL_FAILURE(expect_alike(Dynamic(lattice(3), cell), 1, 6, 6));
  }
}

// ORACLE ------------------------------------------------------------------------------------------

void expect_close(double found, double expected, double tolerance)
{
  if (found != expected) { // both may be infinite
    EXPECT_NEAR(found, expected, tolerance);
  }
}

// Compares cells with those in open space of all images that are shifted by less than a radius,
// where these suffice. (Those at the hull of a slab or a wire have facets there that do not.)
void expect_cells_of_images(const Dynamic& dt, double radius)
{
  constexpr int most = 24; // a skew cell has short combinations of such multiples
  const int along_b = dt.cell().dimension() > 1 ? most : 0;
  const int along_c = dt.cell().dimension() > 2 ? most : 0;
  std::vector<Shift> shifts;
  for (int x = -most; x <= most; ++x)
    for (int y = -along_b; y <= along_b; ++y)
      for (int z = -along_c; z <= along_c; ++z)
        if (combination(dt.cell(), x, y, z).squared_length() < radius * radius)
          shifts.push_back({x, y, z});
  std::vector<Site> sites;
  Points images;
  std::map<std::size_t, std::size_t> middle; // the unshifted image of each representative
  for (std::size_t id = 0; id < dt.number_of_ids(); ++id)
    if (dt.has_id(id) && dt.representative(id) == id)
      for (const Shift& shift : shifts) {
        if (shift == Shift{0, 0, 0})
          middle[id] = images.size();
        sites.emplace_back(id, shift);
        images.push_back(image(dt.point(id), shift, dt.cell()));
      }
  const Open open(images);
  Measures expected;
  Gradients gradients, expected_gradients;
  expected.compute(open);
  expected_gradients.compute(open);
  gradients.compute(dt);
  const Measures measures = measures_of(dt);
  for (const auto& [id, i] : middle) {
    SCOPED_TRACE("id " + std::to_string(id));
    ASSERT_EQ(measures.is_bounded(id), expected.is_bounded(i));
    Areas areas;
    for (std::size_t k = expected.offsets()[i]; k < expected.offsets()[i + 1]; ++k)
      areas.emplace(sites[expected.neighbors()[k]], expected.facet_areas()[k]);
    const bool is_bounded = measures.is_bounded(id);
    const double length = std::cbrt(is_bounded ? expected.volumes()[i] : 1) + 1;
    const double little = 1e-9 * length * length;
    for (const auto& [site, area] : facets(measures, id)) {
      ASSERT_NO_FATAL_FAILURE(expect_close(area, areas[site], little));
      areas[site] = 0;
    }
    if (!is_bounded)
      continue;
    for (const auto& [site, area] : areas)
      ASSERT_LT(area, little);
    const auto &found = measures.centroids()[id], &centroid = expected.centroids()[i];
    EXPECT_NEAR(measures.volumes()[id], expected.volumes()[i], little * length);
    EXPECT_NEAR(measures.surface_areas()[id], expected.surface_areas()[i], little);
    EXPECT_NEAR(found.x, centroid.x, 1e-6 * length);
    EXPECT_NEAR(found.y, centroid.y, 1e-6 * length);
    EXPECT_NEAR(found.z, centroid.z, 1e-6 * length);
    if (dt.cell().dimension() < 3) { // where a point is its own neighbor, images go with it
      EXPECT_NEAR(gradients.by_positions()[id].x, expected_gradients.by_positions()[i].x,
                  1e-6 * length * length);
    }
  }
}

class Periodic_cells_of_points
  : public testing::TestWithParam<std::tuple<const Kind*, std::size_t, unsigned>>
{
};

// Where space is open, images must not be rounded: they have a hull.
TEST_P(Periodic_cells_of_points, are_those_of_their_images)
{
  const auto& [kind, number, seed] = GetParam();
  const bool is_torus = kind == &torus;
  const double radius = !is_torus ? 7 : number < 20 ? 4 : 2.2;
  for (const Cell& cell :
       {kind->box(1, 1, 1), is_torus ? Cell({1.1, 0.03, -0.2}, {0.4, 0.9, 0.1}, {-0.3, 0.45, 1.2})
                                     : kind->cell({1, 0.25, 0.125}, {0.25, 1.125, 0.5}, {})}) {
    Points points = short_points_in(cell, number, 1, seed);
    Dynamic dt(points, cell);
    ASSERT_NO_FATAL_FAILURE(expect_cells_of_images(dt, radius));
    points = shaken(points, 0.05, seed);
    std::transform(points.begin(), points.end(), points.begin(),
                   [](const Point& p) { return rounded(p); });
    dt.update(points);
    ASSERT_NO_FATAL_FAILURE(expect_cells_of_images(dt, radius));
  }
}
INSTANTIATE_TEST_SUITE_P(few, Periodic_cells_of_points,
                         testing::Combine(all_kinds(), testing::Values(1u, 2u, 3u, 4u, 5u, 8u, 13u),
                                          testing::Range(1u, 4u)));
INSTANTIATE_TEST_SUITE_P(more, Periodic_cells_of_points,
                         testing::Combine(all_kinds(), testing::Values(40u, 150u),
                                          testing::Range(1u, 3u)));

TEST_P(Periodic_cells_of_kind, are_those_of_images_in_a_skew_cell)
{
  for (const std::size_t number : {1u, 3u})
    for (unsigned seed = 1; seed < 4; ++seed) {
      const Points points = random_points(number, seed);
      Dynamic dt(points, skew);
      ASSERT_NO_FATAL_FAILURE(expect_cells_of_images(dt, dimension == 3 ? 4 : 7));
      dt.update(shaken(points, 0.05, seed));
      ASSERT_NO_FATAL_FAILURE(expect_cells_of_images(dt, dimension == 3 ? 4 : 7));
    }
}

// MOTION ------------------------------------------------------------------------------------------

TEST_P(Periodic_cells_of_kind, add_up_in_every_frame)
{
  for (const Cell& cell : {unit, triclinic, skew, kind.box(1, 0.9, 0.06)})
    for (const std::size_t number : {1u, 2u, 7u, 60u, 500u}) {
      SCOPED_TRACE(std::to_string(number) + " points");
      Points points = points_in(cell, number, 1, unsigned(number));
      Dynamic dt(points, cell);
      for (unsigned frame = 0; frame < 6; ++frame) {
        points = shaken(points, frame % 2 == 0 ? 0.02 : 0.3, frame); // some leave the cell
        const double shear = 0.2 * frame;
        const auto &a = cell.a(), &b = cell.b();
        dt.update(points,
                  kind.cell(a, {b[0] + shear * a[0], b[1] + shear * a[1], b[2] + shear * a[2]},
                            cell.c()));
        measures_of(dt);
      }
    }
}

TEST_P(Periodic_cells_of_kind, of_slightly_moved_lattices_add_up)
{
  for (const double step : {1e-15, 1e-12, 1e-9, 1e-6})
    measures_of(Dynamic(shaken(lattice(6), step), kind.box(6, 6, 6)));
}

TEST(Periodic_cells, of_very_close_points_are_measured)
{
  // across the border, closer than doubles of this size tell
  const double little = 1e-40;
  const Dynamic dt(Points{{little, 0.5, 0.5}, {1, 0.5, 0.5}, {0.5, 0.2, 0.1}}, Cell(1, 1, 1));
  const Measures measures = measures_of(dt);
  const auto areas = facets(measures, 1);
  ASSERT_EQ(areas.count({0, {1, 0, 0}}), 1u);
  EXPECT_GT(areas.at({0, {1, 0, 0}}), 0.1);
  Lists lists;
  lists.compute_with_vectors(dt);
  const auto found = std::find(lists.shifts().begin() + std::ptrdiff_t(lists.offsets()[1]),
                               lists.shifts().end(), Shift{1, 0, 0});
  ASSERT_NE(found, lists.shifts().end());
  EXPECT_NEAR(lists.vectors()[std::size_t(found - lists.shifts().begin())].x, little,
              1e-15 * little);
}

// IMAGES ------------------------------------------------------------------------------------------

TEST_P(Periodic_cells_of_kind, do_not_depend_on_the_images_that_are_given)
{
  std::mt19937_64 random(3);
  // so that images of short doubles are doubles
  const Cell cell = kind.cell({8, 0, 0}, {1, 7, 0}, {-2, 3, 9});
  Points points, images;
  std::vector<Shift> shifts;
  for (int i = 0; i < 60; ++i) {
    const auto share = [&] { return std::ldexp(double(random() >> 44), -17); };
    const double x = share(), y = share(), z = share();
    points.emplace_back(x, y, z);
    const int most = i % 2 == 0 ? 2 : 500000;
    const auto multiple = [&] { return int(random() % unsigned(2 * most + 1)) - most; };
    const int j = multiple(), k = multiple();
    shifts.push_back({j, dimension > 1 ? k : 0, dimension > 2 ? multiple() : 0});
    images.push_back(image(points.back(), shifts.back(), cell));
  }
  const Dynamic dt(points, cell);
  Dynamic other(images, cell);
  const Measures expected = measures_of(dt);
  for (int frame = 0; frame < 2; ++frame) {
    const Measures measures = measures_of(other);
    for (std::size_t id = 0; id < points.size(); ++id) {
      const double volume = expected.volumes()[id], size = volume < infinity ? volume + 1 : 1;
      ASSERT_NO_FATAL_FAILURE(expect_close(measures.volumes()[id], volume, 1e-13 * size));
      const auto& c = measures.centroids()[id];
      const auto& d = expected.centroids()[id];
      const Point p = other.point(id);
      if (measures.is_bounded(id)) {
        ASSERT_NEAR(c.x - p.x(), d.x - points[id].x(), 1e-8);
        ASSERT_NEAR(c.z - p.z(), d.z - points[id].z(), 1e-8);
      }
      Areas areas;
      for (const auto& [site, area] : facets(measures, id)) {
        auto [j, shift] = site;
        if (frame == 0)
          for (std::size_t n = 0; n < 3; ++n)
            shift[n] += shifts[j][n] - shifts[id][n];
        areas.emplace(Site(j, shift), area);
      }
      ASSERT_EQ(areas.size(), facets(expected, id).size());
      for (const auto& [site, area] : facets(expected, id))
        ASSERT_NO_FATAL_FAILURE(expect_close(areas.at(site), area, 1e-12 * size));
    }
    other.update(points); // all are wrapped, and nothing moves
  }
}

TEST(Periodic_cells, of_coincident_points_are_shared)
{
  Points points = lattice(2);
  points.emplace_back(0, 0, 0);
  points.emplace_back(4, -2, 2); // an image of the first one
  const Dynamic dt(points, Cell(2, 2, 2));
  const Measures measures = measures_of(dt);
  for (const std::size_t id : {0u, 8u, 9u}) {
    EXPECT_NEAR(measures.volumes()[id], 1.0 / 3, 1e-15);
    EXPECT_NEAR(measures.surface_areas()[id], 6, 1e-14);
    EXPECT_NEAR(measures.centroids()[id].x, points[id].x(), 1e-15);
    EXPECT_NEAR(measures.centroids()[id].y, points[id].y(), 1e-15);
    EXPECT_EQ(facets(measures, id).size(), id == 0 ? 6u : 0u);
  }
  Lists lists;
  lists.compute_with_vectors(dt);
  EXPECT_EQ(lists.degree(8), 1u);
  EXPECT_EQ(lists.shifts()[lists.offsets()[8]], (Shift{0, 0, 0}));
  EXPECT_EQ(lists.shifts()[lists.offsets()[9]], (Shift{2, -1, 1}));
  EXPECT_EQ(*std::prev(lists.neighbors(0).end()), 9u);
  EXPECT_EQ(lists.shifts()[lists.offsets()[1] - 1], (Shift{-2, 1, -1}));
  EXPECT_EQ(lists.vectors()[lists.offsets()[1] - 1].x, 0);
}

TEST(Periodic_cells, of_removed_ids_measure_nothing)
{
  Dynamic dt(lattice(3), Cell(3, 3, 3));
  dt.remove({13});
  const Measures measures = measures_of(dt);
  EXPECT_EQ(measures.volumes()[13], 0);
  EXPECT_EQ(measures.centroids()[13].x, 0);
  EXPECT_TRUE(facets(measures, 13).empty());
  EXPECT_NEAR(measures.volumes()[14], 1 + 1.0 / 6, 1e-14); // a pyramid more
  dt.remove(dt.number_of_ids() - 1);
  const Dynamic empty(Cell(1, 1, 1));
  EXPECT_EQ(measures_of(empty).number_of_ids(), 0u);
  Lists lists;
  lists.compute(empty);
  EXPECT_EQ(lists.number_of_ids(), 0u);
}

TEST(Open_cells, have_no_shifts)
{
  Measures measures;
  measures.compute(Dynamic(lattice(2), Cell(2, 2, 2)));
  EXPECT_FALSE(measures.shifts().empty());
  measures.compute(Open(lattice(2)));
  EXPECT_TRUE(measures.shifts().empty());
  EXPECT_FALSE(measures.is_bounded(0));
}

// LISTS -------------------------------------------------------------------------------------------

void expect_lists(const Dynamic& dt)
{
  Lists lists;
  lists.compute_with_vectors(dt);
  ASSERT_EQ(lists.number_of_ids(), dt.number_of_ids());
  ASSERT_EQ(lists.shifts().size(), lists.neighbors().size());
  ASSERT_EQ(lists.vectors().size(), lists.neighbors().size());
  std::map<std::size_t, std::multiset<Site>> expected;
  dt.for_each_edge([&](std::size_t i, std::size_t j, const Shift& shift) {
    expected[i].emplace(j, shift);
    expected[j].emplace(i, -shift);
  });
  std::multiset<std::tuple<std::size_t, std::size_t, Shift>> ways, ways_back;
  for (std::size_t id = 0; id < dt.number_of_ids(); ++id) {
    std::multiset<Site> found;
    Site last(0, Shift{});
    for (std::size_t i = lists.offsets()[id]; i < lists.offsets()[id + 1]; ++i) {
      const Site site(lists.neighbors()[i], lists.shifts()[i]);
      const auto& [other, shift] = site;
      const auto& v = lists.vectors()[i];
      const Vector way = dt.vector(id, other, shift);
      const double size = 1 + std::abs(dt.point(id).x()) + std::abs(dt.point(other).x());
      ASSERT_NEAR(v.x, way.x(), 1e-14 * size);
      ASSERT_NEAR(v.y, way.y(), 1e-14 * size);
      ASSERT_NEAR(v.z, way.z(), 1e-14 * size);
      ways.emplace(id, other, shift);
      ways_back.emplace(other, id, -shift);
      if (dt.representative(id) == dt.representative(other) &&
          (dt.representative(id) != id || dt.representative(other) != other)) {
        ASSERT_EQ(v.x, 0);
        continue;
      }
      ASSERT_TRUE(found.empty() || last < site);
      found.insert(last = site);
    }
    ASSERT_EQ(found, expected[id]) << "id " << id;
    if (dt.has_id(id) && dt.representative(id) == id) {
      std::multiset<Site> told;
      dt.for_each_neighbor(id, [&](std::size_t j, const Shift& shift) { told.emplace(j, shift); });
      ASSERT_EQ(found, told) << "id " << id;
    }
  }
  ASSERT_EQ(ways, ways_back);
}

using Periodic_lists = Of_kind;
INSTANTIATE_TEST_SUITE_P(kinds, Periodic_lists, all_kinds(), name_of);

TEST_P(Periodic_lists, have_both_ends_of_all_edges)
{
  for (const Cell& cell : {unit, triclinic, skew, kind.box(1, 0.9, 0.06)})
    for (const double thickness : {0.0, 1.0})
      for (const std::size_t number : {1u, 2u, 3u, 5u, 30u, 300u}) {
        SCOPED_TRACE(std::to_string(number) + " points");
        Points points = points_in(cell, number, thickness, unsigned(number));
        for (std::size_t i = 0; i < number; i += 3) // some coincide
          points.push_back(image(points[i], {int(i % 5) - 2, int(i % 2), 0}, cell));
        Dynamic dt(points, cell);
        ASSERT_NO_FATAL_FAILURE(expect_lists(dt));
        dt.update(shaken(points, 0.2));
        ASSERT_NO_FATAL_FAILURE(expect_lists(dt));
        dt.remove(number / 2);
        ASSERT_NO_FATAL_FAILURE(expect_lists(dt));
      }
  ASSERT_NO_FATAL_FAILURE(expect_lists(Dynamic(lattice(2), kind.box(2, 2, 2))));
}

TEST(Open_lists, have_vectors_on_request)
{
  for (const Points& points : {random_points(100), Points{{0, 0, 0}, {1, 0, 0}, {3, 0, 0}}}) {
    const Open dt(points);
    Lists lists;
    lists.compute_with_vectors(dt);
    ASSERT_EQ(lists.vectors().size(), lists.neighbors().size());
    for (std::size_t id = 0; id < points.size(); ++id)
      for (std::size_t i = lists.offsets()[id]; i < lists.offsets()[id + 1]; ++i) {
        const Point& other = points[lists.neighbors()[i]];
        EXPECT_EQ(lists.vectors()[i].x, other.x() - points[id].x());
        EXPECT_EQ(lists.vectors()[i].z, other.z() - points[id].z());
      }
    EXPECT_TRUE(lists.shifts().empty());
    lists.compute(dt);
    EXPECT_TRUE(lists.vectors().empty());
  }
}

// GRADIENTS ---------------------------------------------------------------------------------------

TEST(Periodic_gradients, are_limits_of_differences)
{
  const Cell triclinic({1.1, 0.03, -0.2}, {0.4, 0.9, 0.1}, {-0.3, 0.45, 1.2});
  for (const std::size_t number : {1u, 2u, 5u, 40u}) {
    const Points points = points_in(triclinic, number, 1, 9);
    Dynamic dt(points, triclinic);
    Gradients gradients;
    gradients.compute(dt);
    ASSERT_EQ(gradients.shifts().size(), gradients.neighbors().size());
    std::vector<double> weights;
    for (std::size_t id = 0; id < number; ++id)
      weights.push_back(std::sin(double(id)));
    const auto energy = [&] {
      const Measures measures = measures_of(dt);
      return std::inner_product(weights.begin(), weights.end(), measures.volumes().begin(), 0.0);
    };
    const double step = 1e-5;
    const auto found = gradients.gradients(weights);
    const Point p = points[0];
    double forward = 0;
    for (const double x : {p.x() + step, p.x() - step}) {
      dt.move(0, Point(x, p.y(), p.z()));
      forward = energy() - forward;
    }
    EXPECT_NEAR(found[0].x, -forward / (2 * step), 1e-8);
    for (const auto& g : gradients.gradients(std::vector<double>(number, 1)))
      EXPECT_NEAR(g.x, 0, 1e-12); // the sum of all volumes stays
  }
}

// THREADS -----------------------------------------------------------------------------------------

#ifdef CGAL_LINKED_WITH_TBB
using Threads_in_periodic_space = Of_kind;
INSTANTIATE_TEST_SUITE_P(kinds, Threads_in_periodic_space, all_kinds(), name_of);

TEST_P(Threads_in_periodic_space, measure_and_list_the_same)
{
  Points points = points_of_cube(6000);
  for (std::size_t i = 0; i < 100; ++i)
    points.push_back(image(points[17 * i], {1, 0, -1}, unit));
  const Dynamic dt(points, unit);
  const CGAL::Dynamic_periodic_Delaunay_triangulation_3<
      Kernel, CGAL::With_concurrency_2<CGAL::Parallel_tag>>
      parallel(points, unit);
  Lists lists, parallel_lists;
  lists.compute(dt);
  parallel_lists.compute(parallel);
  EXPECT_EQ(lists.offsets(), parallel_lists.offsets());
  EXPECT_EQ(lists.neighbors(), parallel_lists.neighbors());
  EXPECT_EQ(lists.shifts(), parallel_lists.shifts());
  Measures measures, parallel_measures;
  measures.compute(dt);
  parallel_measures.compute(parallel);
  EXPECT_EQ(measures.volumes(), parallel_measures.volumes());
  Volumes volumes, parallel_volumes;
  volumes.compute(dt);
  parallel_volumes.compute(parallel);
  EXPECT_EQ(volumes.volumes(), parallel_volumes.volumes());
  EXPECT_EQ(measures.surface_areas(), parallel_measures.surface_areas());
  EXPECT_EQ(measures.neighbors(), parallel_measures.neighbors());
  EXPECT_EQ(measures.shifts(), parallel_measures.shifts());
  EXPECT_EQ(measures.facet_areas(), parallel_measures.facet_areas());
}
#endif // CGAL_LINKED_WITH_TBB

} // namespace test_periodic_space_cells_3

// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// What is asked about points in slabs, who is told of changes, and files.

#include "periodic_space_oracle.h"
#include "periodic_space_tested.h"

#include <CGAL/Dynamic_Delaunay_triangulation_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/conversions/convert_to_periodic_3_delaunay_triangulation_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/Delaunay_neighbor_lists_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/Delaunay_point_queries_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/Dynamic_population_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/Periodic_edge_changes_visitor_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/Voronoi_cell_gradients_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/Voronoi_cell_measures_3.h>
#include <CGAL/Dynamic_periodic_Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Periodic_3_Delaunay_triangulation_3.h>
#include <CGAL/Periodic_3_Delaunay_triangulation_traits_3.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <map>
#include <random>
#include <set>
#include <sstream>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace test_periodic_space_slab_uses_3 {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Dynamic = CGAL::Dynamic_periodic_Delaunay_triangulation_3<Kernel>;
using Open = CGAL::Dynamic_Delaunay_triangulation_3<Kernel>;
using Point = Dynamic::Point;
using Points = std::vector<Point>;
using Cell = CGAL::Periodic_cell_3;
using Coordinates = Cell::Coordinates;
using periodic_space_oracle::cells_of;
using periodic_space_oracle::Shift;
using periodic_space_oracle::operator-;
using periodic_space_oracle::operator+;

constexpr double infinity = std::numeric_limits<double>::infinity();

const Cell square(Coordinates{1, 0, 0}, Coordinates{0, 1, 0});
const Cell oblique(Coordinates{1, 0, 0}, Coordinates{0.25, 1.125, 0.5}); // images are not rounded

// In multiples of 2^-30.
double rounded(double x)
{
  return std::ldexp(std::rint(std::ldexp(x, 30)), -30);
}
Point near(const Point& p, double step, std::mt19937_64& random)
{
  std::uniform_real_distribution<double> x(-step, step);
  return Point(p.x() + rounded(x(random)), p.y() + rounded(x(random)), p.z() + rounded(x(random)));
}
Points random_points(std::size_t number, double thickness = 1, std::uint64_t seed = 7)
{
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> x(0, 1);
  Points points;
  for (std::size_t i = 0; i < number; ++i) {
    const double first = rounded(x(random)), second = rounded(x(random));
    points.emplace_back(first, second, rounded(thickness * x(random)));
  }
  return points;
}
Point image(const Point& p, const Shift& shift, const Cell& cell)
{
  Coordinates x{p.x(), p.y(), p.z()};
  for (std::size_t i = 0; i < 2; ++i)
    for (std::size_t k = 0; k < 3; ++k)
      x[k] += shift[i] * cell.vector(i)[k];
  return Point(x[0], x[1], x[2]);
}

using Site = std::pair<std::size_t, Shift>;

// That of the pairs. (g++ 12 warns that these, compared as arrays, may be uninitialized.)
struct Site_order
{
  bool operator()(const Site& a, const Site& b) const
  {
    return std::tie(a.first, a.second[0], a.second[1], a.second[2]) <
           std::tie(b.first, b.second[0], b.second[1], b.second[2]);
  }
};
using Sites = std::set<Site, Site_order>;

// Images of points around the cell, those in the cell first; and their names.
struct Images
{
  Images(const Points& some, const Cell& cell, int around)
  {
    for (std::size_t id = 0; id < some.size(); ++id)
      add(some[id], id, {0, 0, 0});
    for (std::size_t id = 0; id < some.size(); ++id)
      for (int i = -around; i <= around; ++i)
        for (int j = -around; j <= around; ++j)
          if (i != 0 || j != 0)
            add(image(some[id], {i, j, 0}, cell), id, {i, j, 0});
  }
  void add(const Point& p, std::size_t id, const Shift& shift)
  {
    points.push_back(p);
    names.emplace_back(id, shift);
  }

  Points points;
  std::vector<Site> names;
};

// VORONOI CELLS -----------------------------------------------------------------------------------

TEST(Voronoi_cells_in_slabs, are_those_of_images_in_open_space)
{
  for (const Cell& cell : {square, oblique})
    for (const std::size_t number : {2u, 7u, 40u}) {
      const Points points = random_points(number, 1, number);
      const Images images(points, cell, 6);
      const Dynamic dt(points, cell);
      const Open open(images.points);
      CGAL::Voronoi_cell_measures_3 measures, expected;
      CGAL::Voronoi_cell_gradients_3 gradients, expected_gradients;
      measures.compute(dt);
      expected.compute(open);
      gradients.compute(dt);
      expected_gradients.compute(open);
      std::size_t unbounded = 0;
      for (std::size_t id = 0; id < number; ++id) {
        std::map<Site, double, Site_order> areas;
        for (std::size_t i = expected.offsets()[id]; i < expected.offsets()[id + 1]; ++i)
          areas[images.names[expected.neighbors()[i]]] = expected.facet_areas()[i];
        EXPECT_EQ(measures.is_bounded(id), expected.is_bounded(id));
        for (std::size_t i = measures.offsets()[id]; i < measures.offsets()[id + 1]; ++i) {
          const auto at = areas.find({measures.neighbors()[i], measures.shifts()[i]});
          ASSERT_NE(at, areas.end());
          if (at->second < infinity) {
            EXPECT_NEAR(at->second, measures.facet_areas()[i], 1e-9 * (1 + at->second));
          } else {
            EXPECT_EQ(at->second, measures.facet_areas()[i]);
          }
        }
        if (!measures.is_bounded(id)) {
          ++unbounded;
          EXPECT_EQ(measures.volumes()[id], infinity);
          continue;
        }
        EXPECT_EQ(areas.size(), measures.offsets()[id + 1] - measures.offsets()[id]);
        const double volume = expected.volumes()[id];
        EXPECT_NEAR(measures.volumes()[id], volume, 1e-9 * volume);
        EXPECT_NEAR(measures.centroids()[id].z, expected.centroids()[id].z, 1e-9 * (1 + volume));
        EXPECT_NEAR(gradients.by_positions()[id].x, expected_gradients.by_positions()[id].x,
                    1e-6 * (1 + volume));
      }
      EXPECT_EQ(unbounded, 2u); // the highest and the lowest one
    }
}

TEST(Voronoi_cells_in_slabs, of_lattices_have_facets_with_an_area_only)
{
  for (const int side : {1, 2, 4})
    for (const int layers : {1, 2, 3}) {
      Points points;
      for (int x = 0; x < side; ++x)
        for (int y = 0; y < side; ++y)
          for (int z = 0; z < layers; ++z)
            points.emplace_back(x, y, z);
      const Dynamic dt(points,
                       Cell(Coordinates{double(side), 0, 0}, Coordinates{0, double(side), 0}));
      CGAL::Voronoi_cell_measures_3 measures;
      measures.compute(dt);
      for (std::size_t id = 0; id < points.size(); ++id) {
        const bool is_lowest = points[id].z() == 0, is_highest = points[id].z() == layers - 1;
        const std::size_t facets = measures.offsets()[id + 1] - measures.offsets()[id];
        EXPECT_EQ(facets, 6u - is_lowest - is_highest);
        EXPECT_EQ(measures.is_bounded(id), !is_lowest && !is_highest);
        if (measures.is_bounded(id)) {
          EXPECT_NEAR(measures.volumes()[id], 1, 1e-14);
        }
        double area = 0;
        for (std::size_t i = measures.offsets()[id]; i < measures.offsets()[id + 1]; ++i)
          area += measures.facet_areas()[i] < infinity ? measures.facet_areas()[i] : 0;
        EXPECT_NEAR(area, measures.is_bounded(id) ? 6 : layers == 1 ? 0 : 1, 1e-14);
      }
    }
}

TEST(Voronoi_cells_in_slabs, of_one_layer_are_prisms_without_end)
{
  const Points points = random_points(50, 0);
  const Dynamic dt(points, oblique);
  const Dynamic flat(points, square);
  CGAL::Voronoi_cell_measures_3 measures;
  measures.compute(flat);
  std::size_t facets = 0;
  for (std::size_t id = 0; id < points.size(); ++id) {
    EXPECT_FALSE(measures.is_bounded(id));
    for (std::size_t i = measures.offsets()[id]; i < measures.offsets()[id + 1]; ++i)
      EXPECT_EQ(measures.facet_areas()[i], infinity);
    facets += measures.offsets()[id + 1] - measures.offsets()[id];
  }
  EXPECT_EQ(facets, 6 * points.size()); // three edges a point, from both ends
  measures.compute(dt); // one layer along one of two axes, and not in a plane along the slab
  EXPECT_GT(dt.number_of_cells(), 0u);
}

// NEIGHBORS AND NEAREST POINTS --------------------------------------------------------------------

TEST(Neighbors_in_slabs, are_the_ends_of_edges)
{
  for (const double thickness : {0.0, 1.0})
    for (const std::size_t number : {1u, 2u, 30u}) {
      const Points points = random_points(number, thickness);
      const Dynamic dt(points, square);
      CGAL::Delaunay_neighbor_lists_3 lists;
      lists.compute_with_vectors(dt);
      EXPECT_EQ(lists.neighbors().size(), 2 * dt.number_of_edges());
      for (std::size_t id = 0; id < number; ++id) {
        Sites expected, found;
        dt.for_each_neighbor(
            id, [&](std::size_t j, const Shift& shift) { expected.emplace(j, shift); });
        for (std::size_t i = lists.offsets()[id]; i < lists.offsets()[id + 1]; ++i) {
          const std::size_t j = lists.neighbors()[i];
          found.emplace(j, lists.shifts()[i]);
          EXPECT_EQ(lists.vectors()[i].x,
                    image(points[j], lists.shifts()[i], square).x() - points[id].x());
        }
        EXPECT_EQ(found, expected);
      }
    }
}

TEST(Nearest_points_in_slabs, are_those_of_all_images)
{
  using Queries = CGAL::Delaunay_point_queries_3<Dynamic>;
  std::mt19937_64 random(2);
  for (const double thickness : {0.0, 1.0})
    for (const std::size_t number : {1u, 2u, 3u, 40u}) {
      const Points points = random_points(number, thickness);
      const Images images(points, oblique, 8);
      const Dynamic dt(points, oblique);
      const Queries queries(dt);
      for (int i = 0; i < 15; ++i) {
        const Point p = near(Point(0.5, 0.5, 0.5), i % 3 == 0 ? 1.5 : 1, random);
        std::map<Kernel::FT, Sites> by_distance;
        for (std::size_t n = 0; n < images.points.size(); ++n)
          by_distance[CGAL::squared_distance(p, images.points[n])].insert(images.names[n]);
        EXPECT_EQ(by_distance.begin()->second.count(*queries.nearest(p)), 1u);
        std::vector<Queries::Answer> found;
        const Kernel::FT radius = 2 * by_distance.begin()->first;
        queries.within(p, radius, std::back_inserter(found));
        std::size_t expected = 0;
        for (const auto& [distance, answers] : by_distance)
          expected += distance < radius ? answers.size() : 0;
        EXPECT_EQ(found.size(), expected);
      }
      EXPECT_TRUE(queries.nearest_neighbor(0).has_value());
    }
}

// VISITORS AND POPULATIONS ------------------------------------------------------------------------

using Visitor = CGAL::Periodic_edge_changes_visitor_3;
using Watched =
    CGAL::Dynamic_periodic_Delaunay_triangulation_3<Kernel, CGAL::With_visitor_2<Visitor>>;

Visitor::Edge in_order(const Visitor::Edge& e)
{
  const Visitor::Edge reverse{e.j, e.i, Shift{0, 0, 0} - e.shift};
  if (e.i != e.j)
    return e.i < e.j ? e : reverse;
  return reverse < e ? e : reverse;
}
std::set<Visitor::Edge> edges_of(const Watched& dt)
{
  std::set<Visitor::Edge> edges;
  dt.for_each_edge([&](std::size_t i, std::size_t j, const Shift& shift) {
    EXPECT_TRUE(edges.insert(in_order({i, j, shift})).second);
  });
  return edges;
}

TEST(Visitors_in_slabs, lead_from_former_edges_to_present_ones)
{
  std::mt19937_64 random(3);
  for (const double thickness : {0.0, 0.5, 2.0})
    for (const std::size_t number : {1u, 5u, 80u}) {
      Watched dt(random_points(number, thickness), oblique);
      dt.visitor().clear();
      std::set<Visitor::Edge> before = edges_of(dt);
      Cell cell = oblique;
      for (int frame = 0; frame < 12; ++frame) {
        Points points;
        for (std::size_t id = 0; id < dt.number_of_ids(); ++id)
          points.push_back(near(dt.point(id), 0.01 * frame, random));
        if (frame % 4 == 3) { // another basis: b becomes b + a
          Coordinates b = cell.b();
          for (std::size_t k = 0; k < 3; ++k)
            b[k] += cell.a()[k];
          cell = Cell(cell.a(), b);
          std::set<Visitor::Edge> renamed;
          for (Visitor::Edge e : before) {
            e.shift[0] -= e.shift[1];
            renamed.insert(in_order(e));
          }
          before.swap(renamed);
        }
        dt.update(points, cell);
        if (frame % 5 == 4)
          dt.insert(near(Point(0.5, 0.5, 0.5), 0.5, random));
        std::set<Visitor::Edge> edges = edges_of(dt);
        for (const Visitor::Edge& e : dt.visitor().created_edges())
          EXPECT_EQ(edges.erase(e), 1u);
        for (const Visitor::Edge& e : dt.visitor().removed_edges())
          EXPECT_TRUE(edges.insert(e).second);
        ASSERT_EQ(edges, before) << thickness << ' ' << number << ' ' << frame;
      }
    }
}

using periodic_space_tested::Facets_visitor;

TEST(Visitors_in_slabs, are_told_of_facets)
{
  std::mt19937_64 random(3);
  CGAL::Dynamic_periodic_Delaunay_triangulation_3<Kernel, CGAL::With_visitor_2<Facets_visitor>> dt(
      oblique);
  Points points = random_points(50, 0.3);
  dt.insert(points);
  for (int frame = 0; frame < 20; ++frame) {
    EXPECT_EQ(dt.visitor().facets.size(), dt.number_of_facets());
    for (Point& p : points)
      p = near(p, frame < 10 ? 0.01 : 0.1, random);
    dt.update(points);
  }
}

TEST(Populations_in_slabs, come_and_go)
{
  std::mt19937_64 random(4);
  CGAL::Dynamic_population_3<Dynamic> population{Dynamic(square)};
  std::map<int, Point> points;
  int next = 0;
  for (int frame = 0; frame < 30; ++frame) {
    for (auto& [id, point] : points)
      point = near(point, 0.02, random);
    for (int i = 0; i < 10; ++i)
      points.emplace(next++, near(Point(0.5, 0.5, 0.5), 0.5, random));
    while (points.size() > 60)
      points.erase(std::next(points.begin(), int(random() % points.size())));
    const std::vector<std::pair<int, Point>> listed(points.begin(), points.end());
    const Cell cell(Coordinates{1 + 0.01 * frame, 0, 0}, Coordinates{0, 1, 0});
    population.update(listed, cell);
    const Dynamic& dt = population.triangulation();
    std::map<std::size_t, Point> by_id;
    for (std::size_t id = 0; id < dt.number_of_ids(); ++id)
      if (dt.has_id(id))
        by_id.emplace(id, dt.point(id));
    ASSERT_EQ(by_id.size(), points.size());
    ASSERT_NO_FATAL_FAILURE(periodic_space_oracle::expect_exact(dt, by_id, cell));
  }
}

// Wants no rebuild if it sees four infinite cells, two of each side.
struct Counting_policy : CGAL::Always_dynamic_policy_2
{
  template <class Frame>
  bool wants_rebuild(const Frame& frame)
  {
    std::size_t infinite = 0;
    for (typename Frame::Cell_index c(0); c < frame.number_of_cells(); ++c) {
      infinite += frame.is_infinite(c);
      for (const auto v : frame.cell(c))
        EXPECT_EQ(std::isnan(frame.position(v).x), frame.is_infinite(v));
    }
    return infinite != 4;
  }
};

TEST(Policies_in_slabs, see_infinite_cells)
{
  using Policed =
      CGAL::Dynamic_periodic_Delaunay_triangulation_3<Kernel, CGAL::With_policy_2<Counting_policy>>;
  const Points points = random_points(40);
  EXPECT_FALSE(Policed(points, square).update(points).rebuilt());
}

// FILES -------------------------------------------------------------------------------------------

template <class Triangulation>
std::string text_of(const Triangulation& dt)
{
  std::ostringstream out;
  dt.write_checkpoint(out);
  return out.str();
}

TEST(Checkpoints_of_slabs, go_on_as_if_nothing_had_happened)
{
  std::mt19937_64 random(5);
  for (const double thickness : {0.0, 1.0})
    for (const std::size_t number : {0u, 1u, 2u, 60u}) {
      Points points = random_points(number, thickness);
      Dynamic dt(points, oblique);
      const Cell later(Coordinates{1, 0, 0}, Coordinates{1.3, 1.125, 0.5});
      dt.update(points, later);
      std::istringstream in(text_of(dt));
      Dynamic read(Cell(1, 1, 1));
      read.read_checkpoint(in);
      EXPECT_EQ(read.cell(), later);
      EXPECT_TRUE(read.is_valid(true));
      EXPECT_EQ(text_of(read), text_of(dt));
      for (int frame = 0; frame < 5; ++frame) {
        for (Point& p : points)
          p = near(p, 0.03, random);
        dt.update(points);
        read.update(points);
        ASSERT_EQ(text_of(read), text_of(dt));
      }
    }
}

TEST(Checkpoints_of_slabs, are_refused_if_they_are_not_right)
{
  const Dynamic dt(random_points(6), square);
  const std::string text = text_of(dt);
  Dynamic read(square);
  const auto refuse = [&](const std::string& from, const std::string& to) {
    std::string changed = text;
    const std::size_t at = changed.find(from);
    ASSERT_NE(at, std::string::npos) << from;
    changed.replace(at, from.size(), to);
    std::istringstream in(changed);
    try {
      read.read_checkpoint(in);
      FAIL() << to;
    } catch (const CGAL::Checkpoint_error_2& error) {
      EXPECT_EQ(std::string(error.what()).find("checksum"), std::string::npos) << error.what();
    }
    EXPECT_EQ(read.number_of_points(), 0u);
  };
  refuse("slab 1 0 0 0 1 0", "slab 1 0 0 2 0 0");
  refuse("slab 1 0 0 0 1 0", "slab 1 0 0 0 1 0 0 0 1");
  refuse("slab 1 0 0 0 1 0", "slub 1 0 0 0 1 0");
  refuse("slab 1 0 0 0 1 0", "cell 1 0 0 0 1 0 0 0 1");
  refuse("basis 1 0 0 1", "basis 1 0 0 2");
  refuse("basis 1 0 0 1", "basis 1 0 0 1 0");
  refuse(" 0 0 1", " 0 0 2");
  refuse(" 0 0 -1", " 0 0 1");
  refuse(" 0 0 -1", " 1 0 -1");
}

TEST(Conversions_of_slabs, are_refused)
{
  using Traits = CGAL::Periodic_3_Delaunay_triangulation_traits_3<Kernel>;
  CGAL::Periodic_3_Delaunay_triangulation_3<Traits> target;
  EXPECT_THROW(CGAL::convert_to_periodic_3_delaunay_triangulation_3(
                   Dynamic(random_points(300), square), target),
               CGAL::Periodic_cell_error_3);
}

} // namespace test_periodic_space_slab_uses_3

// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// What users do with a periodic triangulation: they convert it to CGAL's, list neighbors, ask which
// points are where, and draw it.

#define CGAL_TEST_SUITE 1 // the viewer then opens no window

#include "random_points.h"

#include <CGAL/convert_to_periodic_2_delaunay_triangulation_2.h>
#include <CGAL/draw_dynamic_periodic_delaunay_triangulation_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/queries/Delaunay_neighbor_lists_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/queries/Delaunay_point_queries_2.h>
#include <CGAL/Dynamic_periodic_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Periodic_2_Delaunay_triangulation_2.h>
#include <CGAL/Periodic_2_Delaunay_triangulation_traits_2.h>

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

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_2;
using Vector = Kernel::Vector_2;
using Cell = CGAL::Periodic_cell_2;
using Shift = CGAL::Periodic_shift_2;
using Triangulation = CGAL::Dynamic_periodic_Delaunay_triangulation_2<Kernel>;

// Points in the unit square, with so few bits that wrapping them needs no rounding.
std::vector<Point> short_points(std::mt19937_64& random, std::size_t number)
{
  return random_points(random, number, 1, 0x1p-30);
}

// NEIGHBOR LISTS ----------------------------------------------------------------------------------

using Lists = CGAL::Delaunay_neighbor_lists_2;
using Entry = std::pair<std::size_t, Shift>;
using Entries = std::vector<Entry>;

Entries list_of(const Lists& lists, std::size_t id)
{
  Entries entries;
  for (std::size_t i = lists.offsets()[id]; i < lists.offsets()[id + 1]; ++i)
    entries.emplace_back(lists.neighbors()[i], lists.shifts()[i]);
  return entries;
}

// Expects the neighbors of each point, then the points that coincide with it; and symmetric lists.
void expect_lists(const Lists& lists, const Triangulation& pt)
{
  ASSERT_EQ(lists.number_of_ids(), pt.number_of_ids());
  ASSERT_EQ(lists.shifts().size(), lists.neighbors().size());
  std::multiset<std::pair<std::size_t, Entry>> there, back;
  for (std::size_t id = 0; id < pt.number_of_ids(); ++id) {
    const Entries list = list_of(lists, id);
    for (const auto& [j, shift] : list) {
      there.insert({id, {j, shift}});
      back.insert({j, {id, {-shift[0], -shift[1]}}});
    }
    Entries expected;
    if (pt.has_id(id) && pt.representative(id) == id)
      pt.for_each_neighbor(
          id, [&](std::size_t j, const Shift& shift) { expected.emplace_back(j, shift); });
    ASSERT_GE(list.size(), expected.size());
    const auto duplicates = list.begin() + Entries::difference_type(expected.size());
    ASSERT_EQ(Entries(list.begin(), duplicates), expected) << id;
    for (auto entry = duplicates; entry != list.end(); ++entry) {
      ASSERT_EQ(pt.representative(entry->first), pt.representative(id));
      ASSERT_EQ(pt.vector(id, entry->first, entry->second), Vector(0, 0));
    }
  }
  ASSERT_EQ(there, back);
}

TEST(Neighbor_lists, have_each_edge_at_both_ends_with_its_shifts_and_where_duplicates_are)
{
  std::mt19937_64 random(5);
  Lists lists;
  for (const Cell& cell : {Cell(1, 1), Cell(1, 0, 2.25, 1), Cell::slab(1, 0)})
    for (const std::size_t number : {0u, 1u, 2u, 3u, 60u}) {
      std::vector<Point> points = short_points(random, number);
      for (std::size_t i = 0; i < number / 3; ++i)
        points.push_back(points[i] + Vector(double(i % 5) - 2, 0));
      Triangulation pt(points, cell);
      lists.compute(pt);
      ASSERT_NO_FATAL_FAILURE(expect_lists(lists, pt)) << number;
      if (number == 60) {
        pt.remove(std::vector<int>{0, 17, 61}); // 0 leaves a duplicate
        lists.compute(pt);
        ASSERT_NO_FATAL_FAILURE(expect_lists(lists, pt));
        EXPECT_EQ(lists.degree(17), 0u);
      }
    }
}

TEST(Neighbor_lists, of_the_plane_have_no_shifts_also_after_those_of_a_cell)
{
  std::mt19937_64 random(6);
  const std::vector<Point> points = short_points(random, 20);
  Lists lists, of_plane;
  lists.compute(Triangulation(points, Cell(1, 1)));
  EXPECT_EQ(lists.shifts().size(), 120u);
  const CGAL::Dynamic_Delaunay_triangulation_2<Kernel> dt(points);
  lists.compute(dt);
  of_plane.compute(dt);
  EXPECT_TRUE(lists.shifts().empty());
  EXPECT_EQ(lists.neighbors(), of_plane.neighbors());
}

// CONVERSION --------------------------------------------------------------------------------------

using Cgal_triangulation = CGAL::Periodic_2_Delaunay_triangulation_2<
    CGAL::Periodic_2_Delaunay_triangulation_traits_2<Kernel>>;
// From an id to another, by a vector in units of 2^-30.
using Edge = std::tuple<std::size_t, std::size_t, long, long>;

Edge edge(std::size_t i, std::size_t j, const Vector& v)
{
  return {i, j, std::lround(v.x() * 0x1p30), std::lround(v.y() * 0x1p30)};
}

std::set<Edge> edges_of(const Triangulation& pt)
{
  std::set<Edge> edges;
  pt.for_each_edge([&](std::size_t i, std::size_t j, const Shift& shift) {
    const Vector v = pt.vector(i, j, shift);
    edges.insert(edge(i, j, v));
    edges.insert(edge(j, i, -v));
  });
  return edges;
}

template <class Vertices>
std::set<Edge> edges_of(const Cgal_triangulation& cgal, const Vertices& vertices,
                        const Triangulation& pt)
{
  std::map<Cgal_triangulation::Vertex_handle, std::size_t> ids;
  for (std::size_t id = 0; id < vertices.size(); ++id)
    if (pt.has_id(id))
      ids[vertices[id]] = pt.representative(id);
  std::set<Edge> edges;
  for (auto e = cgal.edges_begin(); e != cgal.edges_end(); ++e) {
    const auto ends = cgal.segment(*e);
    const int i = e->second;
    const std::size_t source = ids.at(e->first->vertex(cgal.ccw(i)));
    const std::size_t target = ids.at(e->first->vertex(cgal.cw(i)));
    edges.insert(edge(source, target, ends.target() - ends.source()));
    edges.insert(edge(target, source, ends.source() - ends.target()));
  }
  return edges;
}

void expect_same(const Triangulation& pt, const Point& corner = Point(0, 0))
{
  Cgal_triangulation cgal;
  const auto vertices = CGAL::convert_to_periodic_2_delaunay_triangulation_2(pt, cgal, corner);
  ASSERT_TRUE(cgal.is_valid());
  ASSERT_TRUE(cgal.is_1_cover());
  ASSERT_TRUE(cgal.is_extensible_triangulation_in_1_sheet_h1());
  ASSERT_EQ(cgal.number_of_vertices(), pt.number_of_vertices());
  ASSERT_EQ(cgal.number_of_faces(), pt.number_of_faces());
  ASSERT_EQ(cgal.number_of_edges(), pt.number_of_edges());
  ASSERT_EQ(cgal.domain().xmin(), corner.x());
  ASSERT_EQ(cgal.domain().ymin(), corner.y());
  ASSERT_EQ(vertices.size(), pt.number_of_ids());
  for (std::size_t id = 0; id < vertices.size(); ++id) {
    ASSERT_EQ(pt.has_id(id), vertices[id] != Cgal_triangulation::Vertex_handle());
    if (pt.has_id(id)) {
      ASSERT_EQ(vertices[id], vertices[pt.representative(id)]);
      ASSERT_TRUE(cgal.domain().has_on_bounded_side(vertices[id]->point()) ||
                  vertices[id]->point().x() == corner.x() ||
                  vertices[id]->point().y() == corner.y());
    }
  }
  ASSERT_EQ(edges_of(cgal, vertices, pt), edges_of(pt));
}

TEST(Conversion, has_the_same_edges_whatever_the_order_and_directions_of_the_sides)
{
  std::mt19937_64 random(1);
  for (const Cell& cell :
       {Cell(1, 1), Cell(-1, 0, 0, 1), Cell(0, -1, 1, 0), Cell(0, 1, -1, 0), Cell(0, 1, 1, 0)})
    ASSERT_NO_FATAL_FAILURE(expect_same(Triangulation(short_points(random, 200), cell)));
}

TEST(Conversion, wraps_points_that_have_left_the_cell_into_the_domain)
{
  std::mt19937_64 random(2);
  std::vector<Point> points = short_points(random, 200);
  Triangulation pt(points, Cell(1, 1));
  for (Point& p : points)
    p = p + Vector(double(random() % 7) - 3, double(random() % 7) - 3);
  pt.update(points);
  ASSERT_NO_FATAL_FAILURE(expect_same(pt));
  ASSERT_NO_FATAL_FAILURE(expect_same(pt, Point(-0.5, -0.5)));
  ASSERT_NO_FATAL_FAILURE(expect_same(pt, Point(17.25, -3)));
}

TEST(Conversion, has_one_vertex_for_points_that_coincide_and_none_for_free_ids)
{
  std::mt19937_64 random(3);
  std::vector<Point> points = short_points(random, 150);
  for (std::size_t i = 0; i < 50; ++i)
    points.push_back(points[i] + Vector(double(i % 3), -1));
  Triangulation pt(points, Cell(1, 1));
  for (const std::size_t id : {3u, 77u, 180u})
    pt.remove(id);
  ASSERT_NO_FATAL_FAILURE(expect_same(pt));
}

TEST(Conversion, can_be_changed_by_CGAL_afterwards)
{
  std::mt19937_64 random(4);
  const Triangulation pt(short_points(random, 100), Cell(1, 1));
  Cgal_triangulation cgal;
  const auto vertices = CGAL::convert_to_periodic_2_delaunay_triangulation_2(pt, cgal);
  for (const Point& p : short_points(random, 100))
    cgal.insert(p);
  for (std::size_t id = 0; id < 50; ++id)
    cgal.remove(vertices[id]);
  EXPECT_TRUE(cgal.is_valid());
  EXPECT_EQ(cgal.number_of_vertices(), 150u);
}

TEST(Conversion, of_no_points_is_empty_and_replaces_what_was_there)
{
  Cgal_triangulation cgal;
  cgal.insert(Point(0.5, 0.5));
  EXPECT_TRUE(CGAL::convert_to_periodic_2_delaunay_triangulation_2(Triangulation(Cell(3, 3)), cgal)
                  .empty());
  EXPECT_EQ(cgal.number_of_vertices(), 0u);
  EXPECT_EQ(cgal.domain().xmax(), 3);
}

template <class Error>
void expect_refusal(const Triangulation& pt, const std::string& why, const Point& corner)
{
  Cgal_triangulation cgal;
  cgal.insert(Point(0.5, 0.5));
  try {
    CGAL::convert_to_periodic_2_delaunay_triangulation_2(pt, cgal, corner);
    FAIL() << "was not refused: " << why;
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find(why), std::string::npos) << error.what();
  }
  EXPECT_EQ(cgal.number_of_vertices(), 1u);
}

TEST(Conversion, refuses_what_CGAL_cannot_represent_and_leaves_the_target_as_it_was)
{
  using Cell_error = CGAL::Periodic_cell_error_2;
  using Error = CGAL::Periodic_conversion_error_2;
  std::mt19937_64 random(5);
  std::vector<Point> points = short_points(random, 200);
  const Point origin(0, 0);
  expect_refusal<Cell_error>(Triangulation(points, Cell(1, 0, 0.125, 1)), "square", origin);
  expect_refusal<Cell_error>(Triangulation(points, Cell::slab(1, 0)), "square", origin);
  expect_refusal<Cell_error>(Triangulation(points, Cell(1, 2)), "square", origin);
  const Triangulation pt(points, Cell(1, 1));
  expect_refusal<Error>(pt, "corner", Point(1e-20, 0));
  expect_refusal<Error>(pt, "corner", Point(0, std::numeric_limits<double>::infinity()));
  expect_refusal<Error>(pt, "wrapped", Point(0x1p50, 0));
  points[7] = Point(-1e-20, 0.5);
  expect_refusal<Error>(Triangulation(points, Cell(1, 1)), "point 7", origin);
  for (const std::size_t few : {1u, 2u, 3u, 5u})
    expect_refusal<Error>(Triangulation(short_points(random, few), Cell(1, 1)), "one sheet",
                          origin);
}

// QUERIES -----------------------------------------------------------------------------------------

using Queries = CGAL::Delaunay_point_queries_2<Triangulation>;
using Image = Queries::Answer;

// Answers queries by a search among all images, with CGAL's exact numbers.
class Images
{
  using Exact = CGAL::Exact_predicates_exact_constructions_kernel::FT;

public:
  explicit Images(const Triangulation& pt)
    : m_pt(pt)
  {
  }

  std::optional<Image> nearest(const Point& p, const std::optional<Image>& asking = {}) const
  {
    std::optional<Image> nearest;
    Exact least = 0;
    for_each(p, reach(p), [&](const Image& image, const Exact& square) {
      if (image == asking || (nearest && (least < square || (least == square && *nearest < image))))
        return;
      nearest = image;
      least = square;
    });
    return nearest;
  }

  std::set<Image> within(const Point& p, double square,
                         const std::optional<Image>& asking = {}) const
  {
    std::set<Image> found;
    for_each(p, std::sqrt(square), [&](const Image& image, const Exact& other) {
      if (other <= Exact(square) && image != asking)
        found.insert(image);
    });
    return found;
  }

private:
  // Far enough to find the nearest image, and another one should the nearest be the one asking.
  double reach(const Point& p) const
  {
    const Cell& cell = m_pt.cell();
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t id = 0; id < m_pt.number_of_ids(); ++id)
      if (m_pt.has_id(id)) {
        const auto [x, y] = multiples(p, id);
        const Vector v = m_pt.point(id) - p;
        const double i = std::round(x), j = cell.is_slab() ? 0 : std::round(y);
        least = (std::min)(least, std::hypot(v.x() + i * cell.ax() + j * cell.bx(),
                                             v.y() + i * cell.ay() + j * cell.by()));
      }
    return least + std::hypot(cell.ax(), cell.ay());
  }

  // The vector from the point `id` to p, as multiples of the cell's vectors.
  std::array<double, 2> multiples(const Point& p, std::size_t id) const
  {
    const Cell& cell = m_pt.cell();
    const double determinant = cell.ax() * cell.by() - cell.ay() * cell.bx();
    const Vector v = p - m_pt.point(id);
    return {(v.x() * cell.by() - v.y() * cell.bx()) / determinant,
            (v.y() * cell.ax() - v.x() * cell.ay()) / determinant};
  }

  template <class Function>
  void for_each(const Point& p, double reach, const Function& f) const
  {
    const Cell& cell = m_pt.cell();
    const double determinant = std::abs(cell.ax() * cell.by() - cell.ay() * cell.bx());
    const double wide = 1 + 1.01 * reach * std::hypot(cell.bx(), cell.by()) / determinant;
    const double high = 1 + 1.01 * reach * std::hypot(cell.ax(), cell.ay()) / determinant;
    for (std::size_t id = 0; id < m_pt.number_of_ids(); ++id) {
      if (!m_pt.has_id(id))
        continue;
      const auto [x, y] = multiples(p, id);
      const int first = cell.is_slab() ? 0 : int(std::floor(y - high));
      const int last = cell.is_slab() ? 0 : int(std::ceil(y + high));
      for (int i = int(std::floor(x - wide)); i <= x + wide; ++i)
        for (int j = first; j <= last; ++j) {
          const Vector about = m_pt.point(id) - p;
          if (std::hypot(about.x() + i * cell.ax() + j * cell.bx(),
                         about.y() + i * cell.ay() + j * cell.by()) > 1.01 * reach + 1e-3)
            continue;
          const Exact vx =
              Exact(m_pt.point(id).x()) - p.x() + Exact(i) * cell.ax() + Exact(j) * cell.bx();
          const Exact vy =
              Exact(m_pt.point(id).y()) - p.y() + Exact(i) * cell.ay() + Exact(j) * cell.by();
          f(Image(id, {i, j}), Exact(vx * vx + vy * vy));
        }
    }
  }

  const Triangulation& m_pt;
};

void expect_right_answers(const Triangulation& pt, const std::vector<Point>& places)
{
  const Queries queries(pt);
  const Images images(pt);
  for (const Point& p : places) {
    ASSERT_EQ(queries.nearest(p), images.nearest(p)) << p;
    for (const double square : {0.0, 0.25, 2.0, 9.0}) {
      std::vector<Image> found;
      queries.within(p, square, std::back_inserter(found));
      ASSERT_EQ(std::set<Image>(found.begin(), found.end()), images.within(p, square)) << p;
      ASSERT_EQ(found.size(), images.within(p, square).size());
    }
  }
  for (std::size_t id = 0; id < pt.number_of_ids(); ++id) {
    if (!pt.has_id(id))
      continue;
    const Image self(id, {0, 0});
    ASSERT_EQ(queries.nearest_neighbor(id), images.nearest(pt.point(id), self)) << id;
    std::vector<Image> found;
    queries.neighbors_within(id, 2, std::back_inserter(found));
    ASSERT_EQ(std::set<Image>(found.begin(), found.end()), images.within(pt.point(id), 2, self));
  }
}

// Places in the cell and around it; on a grid many of them coincide or are on one circle.
std::vector<Point> places_around(std::mt19937_64& random, std::size_t number, double extent,
                                 double grid)
{
  std::vector<Point> points = random_points(random, number, 3 * extent, grid);
  for (Point& p : points)
    p = p - Vector(extent, extent);
  return points;
}

const std::vector<Cell> cells{Cell(3, 3),        Cell(3, 0, 1.5, 2.5), Cell(1, 4),
                              Cell(3, 0, 31, 3), Cell(-3, 1, 2, 2),    Cell(0, -3, 3, 0),
                              Cell::slab(3, 0),  Cell::slab(0, -2),    Cell::slab(1, 2)};

TEST(Queries, find_what_looking_at_all_images_finds_in_cells_and_slabs_of_any_shape)
{
  std::mt19937_64 random(11);
  for (const Cell& cell : cells)
    for (const std::size_t number : {1u, 2u, 3u, 12u})
      for (const double grid : {0.0, 0.5}) {
        const Triangulation pt(places_around(random, number, 3, grid), cell);
        ASSERT_NO_FATAL_FAILURE(expect_right_answers(pt, places_around(random, 6, 6, grid)))
            << number << ' ' << grid;
      }
}

TEST(Queries, see_differences_that_drown_in_rounding)
{
  const double tiny = std::numeric_limits<double>::epsilon();
  // both images are a quarter of the cell away, but for less than the rounding of their distance
  const Triangulation pt(std::vector<Point>{Point(0.25 + tiny / 4, 0), Point(0.75, 0)},
                         Cell(1, 0, 0.1, 1));
  const Queries queries(pt);
  EXPECT_EQ(queries.nearest(Point(0.5, 0)), Image(0, {0, 0}));
  EXPECT_EQ(queries.nearest(Point(0, 0)), Image(1, {-1, 0}));
  EXPECT_EQ(queries.nearest(Point(1000, 0)), Image(1, {999, 0}));
  ASSERT_NO_FATAL_FAILURE(expect_right_answers(
      pt, {Point(0.5, 0), Point(0, 0), Point(0.5 + tiny / 8, 0), Point(1000, 0)}));
  std::vector<Image> found;
  queries.within(Point(1000.5, 0), 0.0625, std::back_inserter(found));
  EXPECT_EQ(std::set<Image>(found.begin(), found.end()),
            (std::set<Image>{{0, {1000, 0}}, {1, {1000, 0}}}));
}

// In the middle of an edge, and at its length, only exact arithmetic tells what is nearer.
TEST(Queries, decide_between_images_whose_distances_are_the_same_but_for_rounding)
{
  std::mt19937_64 random(13);
  std::uniform_real_distribution<double> between(0.1, 1);
  for (int run = 0; run < 20; ++run) {
    const Cell cell = run % 4 == 0 ? Cell::slab(3 * between(random), between(random))
                                   : Cell(2 + between(random), between(random), between(random), 2);
    std::vector<Point> points;
    for (int i = 0; i < 5; ++i) {
      const double away = run % 2 == 0 ? 0 : std::floor(1000 * between(random)),
                   x = between(random);
      points.push_back(Point(3 * x + away * cell.ax(), 3 * between(random) + away * cell.ay()));
    }
    const Triangulation pt(points, cell);
    const Queries queries(pt);
    const Images images(pt);
    pt.for_each_edge([&](std::size_t i, std::size_t j, const Shift& shift) {
      const Vector v = pt.vector(i, j, shift);
      const Point middle = pt.point(i) + v / 2;
      EXPECT_EQ(queries.nearest(middle), images.nearest(middle)) << middle;
      std::vector<Image> found;
      queries.within(middle, (v / 2).squared_length(), std::back_inserter(found));
      EXPECT_EQ(std::set<Image>(found.begin(), found.end()),
                images.within(middle, (v / 2).squared_length()));
    });
  }
}

TEST(Queries, follow_the_triangulation_while_it_changes)
{
  std::mt19937_64 random(12);
  Triangulation pt(Cell(3, 3));
  const Queries queries(pt);
  std::vector<Image> found;
  EXPECT_EQ(queries.nearest(Point(1, 1)), std::nullopt);
  queries.within(Point(1, 1), 100, std::back_inserter(found));
  EXPECT_TRUE(found.empty());
  for (const Point& p : places_around(random, 30, 3, 0))
    pt.insert(p);
  for (int round = 0; round < 5; ++round) {
    for (std::size_t i = 0; i < 5; ++i)
      pt.remove(std::size_t(round) + 5 * i);
    std::vector<Point> points = places_around(random, 30, 3, 0);
    pt.update(points, Cell(3, 0, 0.5 * round, 3));
    for (const Point& p : places_around(random, 4, 3, 0)) {
      EXPECT_EQ(queries.nearest(p), Images(pt).nearest(p));
    }
  }
}

TEST(Queries, refuse_what_is_no_place_no_radius_and_no_id)
{
  const Triangulation pt(std::vector<Point>{Point(0, 0), Point(1, 1)}, Cell(3, 3));
  const Queries queries(pt);
  const double infinity = std::numeric_limits<double>::infinity();
  std::vector<Image> found;
  const auto out = std::back_inserter(found);
  EXPECT_THROW(queries.nearest(Point(infinity, 0)), CGAL::Non_finite_coordinate_error_2);
  EXPECT_THROW(queries.nearest(Point(1e7, 0)), CGAL::Periodic_range_error_2);
  EXPECT_THROW(queries.within(Point(0, 1e7), 1, out), CGAL::Periodic_range_error_2);
  EXPECT_THROW(queries.within(Point(0, 0), -1, out), CGAL::Parameter_error_2);
  EXPECT_THROW(queries.within(Point(0, 0), infinity, out), CGAL::Parameter_error_2);
  EXPECT_THROW(queries.neighbors_within(2, 1, out), CGAL::Unknown_id_error_2);
  EXPECT_THROW(queries.neighbors_within(1, -1, out), CGAL::Parameter_error_2);
  EXPECT_THROW(queries.nearest_neighbor(2), CGAL::Unknown_id_error_2);
  EXPECT_TRUE(found.empty());
  // across a slab there is no limit
  const Triangulation slab(std::vector<Point>{Point(0, 0)}, Cell::slab(3, 0));
  EXPECT_EQ(Queries(slab).nearest(Point(0, 1e9)), Image(0, {0, 0}));
}

// PICTURES ----------------------------------------------------------------------------------------

// What CGAL's viewers are given to draw.
struct Scene
{
  void add_point(const Point& p) { points.push_back(p); }
  void add_segment(const Point& p, const Point& q) { segments.push_back({p, q}); }
  void add_segment(const Point& p, const Point& q, const CGAL::IO::Color&)
  {
    outline.push_back({p, q});
  }
  void face_begin(const CGAL::IO::Color&) { faces.emplace_back(); }
  void add_point_in_face(const Point& p) { faces.back().push_back(p); }
  void face_end() { EXPECT_EQ(faces.back().size(), 3u); }

  double area_of_faces() const
  {
    double area = 0;
    for (const std::vector<Point>& face : faces)
      area += CGAL::area(face[0], face[1], face[2]);
    return area;
  }

  std::vector<Point> points;
  std::vector<std::array<Point, 2>> segments, outline;
  std::vector<std::vector<Point>> faces;
};

Scene picture_of(const Triangulation& pt, bool are_faces_filled = true)
{
  Scene scene;
  CGAL::Dynamic_Delaunay_triangulations_2::internal::draw_periodic(pt, scene, are_faces_filled);
  return scene;
}

TEST(Pictures, have_each_face_once_all_vertices_in_the_cell_and_its_outline)
{
  std::mt19937_64 random(21);
  std::vector<Point> points = places_around(random, 40, 20, 0);
  points.push_back(points[0]);
  const Scene scene = picture_of(Triangulation(points, Cell(4, 0, 1, 3)));
  EXPECT_EQ(scene.points.size(), 40u);
  EXPECT_EQ(scene.faces.size(), 80u);
  EXPECT_EQ(scene.segments.size(), 240u);
  EXPECT_NEAR(scene.area_of_faces(), 12, 1e-9);
  for (const Point& p : scene.points) {
    const double j = p.y() / 3, i = (p.x() - j) / 4;
    EXPECT_TRUE(-1e-9 < i && i < 1 + 1e-9 && -1e-9 < j && j < 1 + 1e-9) << p;
  }
  for (const std::vector<Point>& face : scene.faces)
    EXPECT_NE(std::find(scene.points.begin(), scene.points.end(), face[0]), scene.points.end());
  const std::vector<std::array<Point, 2>> outline{{Point(0, 0), Point(4, 0)},
                                                  {Point(4, 0), Point(5, 3)},
                                                  {Point(5, 3), Point(1, 3)},
                                                  {Point(1, 3), Point(0, 0)}};
  EXPECT_EQ(scene.outline, outline);
}

TEST(Pictures, can_leave_out_the_faces_but_not_their_sides)
{
  const Scene scene = picture_of(Triangulation(std::vector<Point>{Point(1, 1)}, Cell(3, 3)), false);
  EXPECT_TRUE(scene.faces.empty());
  EXPECT_EQ(scene.segments.size(), 6u);
}

TEST(Pictures, of_a_slab_end_at_its_outermost_points)
{
  const Scene scene = picture_of(
      Triangulation(std::vector<Point>{Point(1, -1), Point(5, 3), Point(2, 0)}, Cell::slab(3, 0)));
  EXPECT_NEAR(scene.area_of_faces(), 12, 1e-9);
  ASSERT_EQ(scene.outline.size(), 4u);
  EXPECT_EQ(scene.outline[0], (std::array<Point, 2>{Point(0, -1), Point(3, -1)}));
  EXPECT_EQ(scene.outline[2], (std::array<Point, 2>{Point(3, 3), Point(0, 3)}));

  const Scene line =
      picture_of(Triangulation(std::vector<Point>{Point(1, 1), Point(2, 1)}, Cell::slab(3, 0)));
  EXPECT_TRUE(line.faces.empty());
  EXPECT_EQ(line.segments.size(), 2u);

  const Scene empty = picture_of(Triangulation(Cell::slab(3, 0)));
  EXPECT_TRUE(empty.outline.empty());
  EXPECT_EQ(picture_of(Triangulation(Cell(3, 3))).outline.size(), 4u);
}

TEST(Pictures, are_drawn_by_CGALs_viewer_or_it_says_that_it_cannot)
{
#ifdef CGAL_USE_BASIC_VIEWER
  const std::string expected;
#else
  const std::string expected = "Impossible to draw, CGAL_USE_BASIC_VIEWER is not defined.\n";
#endif
  const Triangulation pt(std::vector<Point>{Point(0, 0), Point(1, 1)}, Cell(3, 3));
  testing::internal::CaptureStderr();
  CGAL::draw(pt);
  EXPECT_EQ(testing::internal::GetCapturedStderr(), expected);
  testing::internal::CaptureStderr();
  CGAL::draw(pt, "two points", true);
  EXPECT_EQ(testing::internal::GetCapturedStderr(), expected);
#ifdef CGAL_GRAPHICS_SCENE_H
  CGAL::Graphics_scene scene;
  CGAL::add_to_graphics_scene(pt, scene);
  EXPECT_FALSE(scene.empty());
#endif
}

} // namespace

// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Triangulations in periodic space of three dimensions, as CGAL's class has them.

#include "periodic_space_tested.h"

#include <CGAL/Dynamic_Delaunay_triangulation_3/conversions/convert_to_periodic_3_delaunay_triangulation_3.h>
#include <CGAL/Periodic_3_Delaunay_triangulation_3.h>
#include <CGAL/Periodic_3_Delaunay_triangulation_traits_3.h>
#include <CGAL/Periodic_3_triangulation_ds_cell_base_3.h>
#include <CGAL/Periodic_3_triangulation_ds_vertex_base_3.h>
#include <CGAL/Triangulation_cell_base_3.h>
#include <CGAL/Triangulation_data_structure_3.h>
#include <CGAL/Triangulation_vertex_base_3.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <random>
#include <set>
#include <string>
#include <vector>

namespace test_periodic_space_conversion_3 {

using namespace periodic_space_tested;
using space_points::lattice;

using Traits = CGAL::Periodic_3_Delaunay_triangulation_traits_3<Kernel>;
using Vertex_base = CGAL::Triangulation_vertex_base_with_info_3<
    std::size_t, Traits,
    CGAL::Triangulation_vertex_base_3<Traits, CGAL::Periodic_3_triangulation_ds_vertex_base_3<>>>;
using Cell_base =
    CGAL::Triangulation_cell_base_3<Traits, CGAL::Periodic_3_triangulation_ds_cell_base_3<>>;
using Of_cgal = CGAL::Periodic_3_Delaunay_triangulation_3<
    Traits, CGAL::Triangulation_data_structure_3<Vertex_base, Cell_base>>;
using Plain_of_cgal = CGAL::Periodic_3_Delaunay_triangulation_3<Traits>;
using Vertices = std::vector<Of_cgal::Vertex_handle>;

// A cell by its vertices: ids and positions from the first one, in units of 2^-30.
using Corner = std::array<long, 4>;
using Cells = std::multiset<std::array<Corner, 4>>;

void add(std::array<Corner, 4> cell, Cells& cells)
{
  std::sort(cell.begin(), cell.end());
  for (std::size_t i = 4; i-- > 0;)
    for (std::size_t k = 1; k < 4; ++k)
      cell[i][k] -= cell[0][k];
  cells.insert(cell);
}

long scaled(double x)
{
  return std::lround(std::ldexp(x, 30));
}

Cells cells_of(const Dynamic& pt)
{
  Cells cells;
  pt.for_each_cell([&](const std::array<std::size_t, 4>& ids, const std::array<Shift, 4>& shifts) {
    std::array<Corner, 4> cell;
    for (std::size_t i = 0; i < 4; ++i) {
      const auto v = pt.vector(ids[0], ids[i], shifts[i]);
      cell[i] = {long(ids[i]), scaled(v.x()), scaled(v.y()), scaled(v.z())};
    }
    add(cell, cells);
  });
  return cells;
}

Cells cells_of(const Of_cgal& cgal)
{
  Cells cells;
  for (auto t = cgal.periodic_tetrahedra_begin(Of_cgal::UNIQUE);
       t != cgal.periodic_tetrahedra_end(Of_cgal::UNIQUE); ++t) {
    const auto tetrahedron = cgal.construct_tetrahedron(*t);
    std::array<Corner, 4> cell;
    for (int i = 0; i < 4; ++i) {
      const auto way = tetrahedron[i] - tetrahedron[0];
      cell[std::size_t(i)] = {long(t.get_cell()->vertex(i)->info()), scaled(way.x()),
                              scaled(way.y()), scaled(way.z())};
    }
    add(cell, cells);
  }
  return cells;
}

Points short_points(std::size_t number, unsigned seed)
{
  return short_points_in(Cell(1, 1, 1), number, 1, seed); // wrapping them needs no rounding
}

// How CGAL's triangulation has come about; where there are ties, it may be either way.
enum class Way { COPIED, IN_ONE_SHEET, INSERTED };

void expect_right(const Dynamic& pt, Way way, const Point& corner = Point(0, 0, 0))
{
  Of_cgal cgal;
  const Vertices vertices = CGAL::convert_to_periodic_3_delaunay_triangulation_3(pt, cgal, corner);
  ASSERT_TRUE(cgal.is_valid());
  ASSERT_EQ(cgal.number_of_vertices(), pt.number_of_vertices());
  ASSERT_EQ(cgal.domain().xmin(), corner.x());
  ASSERT_EQ(cgal.domain().zmax() - corner.z(), std::cbrt(pt.cell().volume()));
  ASSERT_EQ(vertices.size(), pt.number_of_ids());
  for (std::size_t id = 0; id < vertices.size(); ++id) {
    ASSERT_EQ(pt.has_id(id), vertices[id] != Of_cgal::Vertex_handle());
    if (!pt.has_id(id))
      continue;
    ASSERT_EQ(vertices[id], vertices[pt.representative(id)]);
    ASSERT_EQ(vertices[id]->info(), pt.representative(id));
    ASSERT_TRUE(cgal.tds().is_vertex(vertices[id]));
    const Point p = vertices[id]->point(), q = pt.point(pt.representative(id));
    for (int axis = 0; axis < 3; ++axis) {
      ASSERT_TRUE(corner[axis] <= p[axis] &&
                  p[axis] < corner[axis] + cgal.domain().xmax() - cgal.domain().xmin());
      const double sides = (q[axis] - p[axis]) / (cgal.domain().xmax() - cgal.domain().xmin());
      ASSERT_EQ(sides, std::round(sides));
    }
  }
  if (way != Way::INSERTED) {
    ASSERT_TRUE(cgal.is_1_cover());
    ASSERT_TRUE(cgal.is_extensible_triangulation_in_1_sheet_h1());
  }
  if (way == Way::COPIED) {
    ASSERT_EQ(cells_of(cgal), cells_of(pt));
  }
}

TEST(Conversion_of_periodic_space, has_the_same_cells_whatever_the_order_and_directions_of_sides)
{
  for (const Cell& cell :
       {Cell(1, 1, 1), Cell(-1, 1, 1), Cell(Coordinates{0, 0, 1}, {-1, 0, 0}, {0, 1, 0}),
        Cell(Coordinates{0, -1, 0}, {-1, 0, 0}, {0, 0, -1})})
    for (const std::size_t number : {300u, 1000u})
      ASSERT_NO_FATAL_FAILURE(expect_right(Dynamic(short_points(number, 3), cell), Way::COPIED));
}

TEST(Conversion_of_periodic_space, wraps_points_that_have_left_the_cell_into_the_domain)
{
  std::mt19937_64 random(2);
  Points points = short_points(400, 2);
  Dynamic pt(points, Cell(1, 1, 1));
  for (Point& p : points)
    p = p + Vector(double(random() % 7) - 3, double(random() % 7) - 3, 2);
  pt.update(points);
  for (const Point& corner : {Point(0, 0, 0), Point(-0.5, 0.25, -0.5), Point(17.25, -3, 0)})
    ASSERT_NO_FATAL_FAILURE(expect_right(pt, Way::COPIED, corner));
}

TEST(Conversion_of_periodic_space, has_one_vertex_for_points_that_coincide_and_none_for_free_ids)
{
  Points points = short_points(300, 4);
  for (std::size_t i = 0; i < 50; ++i)
    points.push_back(points[i] + Vector(double(i % 3), -1, 0));
  Dynamic pt(points, Cell(1, 1, 1));
  for (const std::size_t id : {3u, 77u, 330u})
    pt.remove(id);
  ASSERT_NO_FATAL_FAILURE(expect_right(pt, Way::COPIED));
}

TEST(Conversion_of_periodic_space, of_few_points_lets_CGAL_insert_them)
{
  for (const std::size_t number : {1u, 2u, 3u, 5u, 20u, 60u})
    ASSERT_NO_FATAL_FAILURE(
        expect_right(Dynamic(short_points(number, 5), Cell(1, 1, 1)), Way::INSERTED));
  // in 27 sheets, where each copy of a vertex tells whose it is
  Of_cgal cgal;
  CGAL::convert_to_periodic_3_delaunay_triangulation_3(Dynamic(short_points(5, 5), Cell(1, 1, 1)),
                                                       cgal);
  EXPECT_FALSE(cgal.is_1_cover());
  std::map<std::size_t, int> copies;
  for (auto v = cgal.vertices_begin(); v != cgal.vertices_end(); ++v)
    ++copies[v->info()];
  EXPECT_EQ(copies, (std::map<std::size_t, int>{{0, 27}, {1, 27}, {2, 27}, {3, 27}, {4, 27}}));
}

TEST(Conversion_of_periodic_space, of_ties_is_what_CGAL_chooses)
{
  for (const int side : {2, 4, 5}) {
    ASSERT_NO_FATAL_FAILURE(expect_right(Dynamic(lattice(side), Cell(side, side, side)),
                                         side < 5 ? Way::INSERTED : Way::IN_ONE_SHEET));
    Points face_centered;
    for (const Point& p : lattice(2 * side))
      if (int(p.x() + p.y() + p.z()) % 2 == 0)
        face_centered.push_back(p);
    ASSERT_NO_FATAL_FAILURE(expect_right(Dynamic(face_centered, Cell(2 * side, 2 * side, 2 * side)),
                                         side < 4 ? Way::INSERTED : Way::IN_ONE_SHEET));
  }
}

// Both break most ties alike, but not all.
TEST(Conversion_of_periodic_space, of_some_points_on_a_sphere_is_what_CGAL_chooses)
{
  Points on_sphere;
  for (int x = -3; x <= 3; ++x)
    for (int y = -3; y <= 3; ++y)
      for (int z = -3; z <= 3; ++z)
        if (x * x + y * y + z * z == 9)
          on_sphere.emplace_back(0.5 + x * 0x1p-5, 0.5 + y * 0x1p-5, 0.5 + z * 0x1p-5);
  const Point middle(0.5, 0.5, 0.5);
  std::mt19937_64 random(1);
  for (unsigned seed = 1; seed <= 30; ++seed) {
    Points points;
    for (const Point& p : short_points(400, seed))
      if (CGAL::squared_distance(p, middle) > 9 * 0x1p-10)
        points.push_back(p);
    std::shuffle(on_sphere.begin(), on_sphere.end(), random);
    points.insert(points.end(), on_sphere.begin(), on_sphere.begin() + 8);
    ASSERT_NO_FATAL_FAILURE(expect_right(Dynamic(points, Cell(1, 1, 1)), Way::IN_ONE_SHEET));
  }
}

TEST(Conversion_of_periodic_space, can_be_changed_by_CGAL_afterwards)
{
  const Dynamic pt(short_points(300, 6), Cell(1, 1, 1));
  Of_cgal cgal;
  const Vertices vertices = CGAL::convert_to_periodic_3_delaunay_triangulation_3(pt, cgal);
  for (const Point& p : short_points(100, 7))
    cgal.insert(p);
  for (std::size_t id = 0; id < 50; ++id)
    cgal.remove(vertices[id]);
  EXPECT_TRUE(cgal.is_valid());
  EXPECT_EQ(cgal.number_of_vertices(), 350u);
}

TEST(Conversion_of_periodic_space, of_no_points_is_empty_and_replaces_what_was_there)
{
  Of_cgal cgal;
  cgal.insert(Point(0.5, 0.5, 0.5));
  EXPECT_TRUE(
      CGAL::convert_to_periodic_3_delaunay_triangulation_3(Dynamic(Cell(3, 3, 3)), cgal).empty());
  EXPECT_EQ(cgal.number_of_vertices(), 0u);
  EXPECT_EQ(cgal.domain().xmax(), 3);
  Plain_of_cgal plain;
  CGAL::convert_to_periodic_3_delaunay_triangulation_3(Dynamic(short_points(300, 2), Cell(1, 1, 1)),
                                                       plain);
  EXPECT_TRUE(plain.is_valid());
}

TEST(Conversion_of_periodic_space, has_a_way_back)
{
  const Points points = short_points(300, 9);
  const Of_cgal cgal(points.begin(), points.end());
  Points found;
  for (auto v = cgal.unique_vertices_begin(); v != cgal.unique_vertices_end(); ++v) {
    v->info() = found.size();
    found.push_back(v->point());
  }
  const double side = cgal.domain().xmax() - cgal.domain().xmin();
  EXPECT_EQ(cells_of(Dynamic(found, Cell(side, side, side))), cells_of(cgal));
}

template <class Error>
void expect_refusal(const Dynamic& pt, const std::string& why, const Point& corner)
{
  Of_cgal cgal;
  cgal.insert(Point(0.5, 0.5, 0.5));
  try {
    CGAL::convert_to_periodic_3_delaunay_triangulation_3(pt, cgal, corner);
    FAIL() << "was not refused: " << why;
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find(why), std::string::npos) << error.what();
  }
  EXPECT_EQ(cgal.number_of_vertices(), 1u);
}

TEST(Conversion_of_periodic_space, refuses_what_CGAL_cannot_represent_and_leaves_the_target)
{
  using Cell_error = CGAL::Periodic_cell_error_3;
  using Error = CGAL::Periodic_conversion_error_2;
  Points points = short_points(300, 1);
  const Point origin(0, 0, 0);
  for (const Cell& cell : {Cell(1, 1, 2), Cell(Coordinates{1, 0, 0}, {0.125, 1, 0}, {0, 0, 1}),
                           Cell(Coordinates{1, 0, 0}, {0, 1, 0}, {0, 0x1p-20, 1}),
                           Cell(Coordinates{0.6, 0.8, 0}, {-0.8, 0.6, 0}, {0, 0, 1})})
    expect_refusal<Cell_error>(Dynamic(points, cell), "cube", origin);
  for (const Kind* kind : {&slab, &wire})
    expect_refusal<Cell_error>(Dynamic(points, kind->box(1, 1, 1)), "cube", origin);
  const Dynamic pt(points, Cell(1, 1, 1));
  expect_refusal<Error>(pt, "corner", Point(1e-20, 0, 0));
  expect_refusal<Error>(pt, "corner", Point(0, 0, infinity));
  expect_refusal<Error>(pt, "wrapped", Point(0x1p50, 0, 0));
  points[7] = Point(-1e-20, 0.5, 0.5);
  expect_refusal<Error>(Dynamic(points, Cell(1, 1, 1)), "point 7", origin);
}

} // namespace test_periodic_space_conversion_3

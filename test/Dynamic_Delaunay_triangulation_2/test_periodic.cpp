// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Triangulations of flat tori whose points and cells move.

#include "digest_of_motion.h"
#include "periodic_operations.h"
#include "periodic_oracle.h"
#include "random_points.h"

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/periodic/Torus_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/proof/Edge_slack_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/visitors/Periodic_edge_changes_visitor_2.h>
#include <CGAL/Dynamic_population_2.h>

#include <algorithm>
#include <array>
#include <cfenv>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <iterator>
#include <limits>
#include <map>
#include <random>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace test_periodic {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_2;
using Cell = CGAL::Periodic_cell_2;
using Triangulation = CGAL::Dynamic_periodic_Delaunay_triangulation_2<Kernel>;
template <class Visitor>
using Visited = CGAL::Dynamic_periodic_Delaunay_triangulation_2<Kernel, CGAL::Default,
                                                                CGAL::With_visitor_2<Visitor>>;
using Vector = Kernel::Vector_2;
namespace internal = CGAL::Dynamic_Delaunay_triangulations_2::internal;
using CGAL::Dynamic_Delaunay_triangulations_2::Edge_index;
using CGAL::Dynamic_Delaunay_triangulations_2::Edge_state_2;
using CGAL::Dynamic_Delaunay_triangulations_2::Position_2;

// A visitor that keeps a set of edges only by the changes of which it is notified.
class Ledger : public CGAL::Delaunay_update_visitor_base_2
{
  using Shift = CGAL::Periodic_shift_2;
  using Edge = Directed_edge;

public:
  const std::set<Edge>& edges() const { return m_edges; }

  template <class Dynamic>
  void after_edge_removal(const Dynamic&, std::size_t i, std::size_t j, const Shift& shift)
  {
    EXPECT_EQ(m_edges.erase({i, j, shift}), 1u);
    EXPECT_EQ(m_edges.erase(reversed({i, j, shift})), 1u);
  }
  template <class Dynamic>
  void after_edge_creation(const Dynamic&, std::size_t i, std::size_t j, const Shift& shift)
  {
    EXPECT_TRUE(m_edges.insert({i, j, shift}).second);
    EXPECT_TRUE(m_edges.insert(reversed({i, j, shift})).second);
  }
  template <class Dynamic>
  void after_translation(const Dynamic&, std::size_t id, const Shift& shift)
  {
    rename([&](Edge edge) {
      auto& [i, j, s] = edge;
      const int sign = int(i == id) - int(j == id);
      s = {s[0] + sign * shift[0], s[1] + sign * shift[1]};
      return edge;
    });
  }
  template <class Dynamic>
  void after_cell_exchange(const Dynamic&, const std::array<Shift, 2>& m)
  {
    rename([&](Edge edge) {
      Shift& s = std::get<2>(edge);
      s = {s[0] * m[0][0] + s[1] * m[1][0], s[0] * m[0][1] + s[1] * m[1][1]};
      return edge;
    });
  }

private:
  template <class Function>
  void rename(const Function& f)
  {
    std::set<Edge> edges;
    for (const Edge& edge : m_edges)
      edges.insert(f(edge));
    m_edges.swap(edges);
  }

  std::set<Edge> m_edges;
};

// FEW POINTS ------------------------------------------------------------------------------------

TEST(One_point, is_its_own_six_neighbors)
{
  const Triangulation pt(std::vector<Point>{Point(0.3, 7.1)}, Cell(1, 0.1, 0.4, 1));
  ASSERT_NO_FATAL_FAILURE(expect_periodic_delaunay(pt));
  std::size_t neighbors = 0;
  pt.for_each_neighbor(0, [&](std::size_t j, const CGAL::Periodic_shift_2& shift) {
    EXPECT_EQ(j, 0u);
    EXPECT_NE(shift, (CGAL::Periodic_shift_2{0, 0}));
    ++neighbors;
  });
  EXPECT_EQ(neighbors, 6u);
}

TEST(No_point, has_no_edge)
{
  Triangulation pt(Cell(1, 1));
  ASSERT_NO_FATAL_FAILURE(expect_periodic_delaunay(pt));
  EXPECT_EQ(pt.number_of_edges(), 0u);
  EXPECT_TRUE(pt.update(std::vector<Point>()).certified);
}

TEST(No_point, moves_for_as_long_as_it_likes_and_comes_back)
{
  for (const Cell& cell : {Cell(1, 1), Cell::slab(1, 0)}) {
    Triangulation pt(cell);
    for (int round = 0; round < 3; ++round) {
      for (int frame = 0; frame < 50; ++frame) {
        pt.update(std::vector<Point>(pt.number_of_ids(), Point(0.01 * frame, 0.5)));
        ASSERT_NO_FATAL_FAILURE(expect_periodic_delaunay(pt));
      }
      if (pt.number_of_points() == 0)
        pt.insert(Point(0.5, 0.5));
      else
        pt.remove(0);
    }
  }
}

TEST(Few_points, are_right_from_the_first_to_the_last_in_cells_of_any_shape)
{
  std::mt19937_64 random(1);
  for (const Cell& cell : {Cell(1, 1), Cell(1, 0, 0.5, 0.866), Cell(10, 0.1), Cell(1, 0, 12.3, 1),
                           Cell(0, 1, 1, 0), Cell(-3, 1, 2, 2), Cell(0.02, 0, 0, 1)}) {
    Triangulation pt(cell);
    for (int i = 0; i < 7; ++i) {
      pt.insert(Point(random_between(random, -2, 2), random_between(random, -2, 2)));
      ASSERT_NO_FATAL_FAILURE(expect_periodic_delaunay(pt));
    }
    for (std::size_t id : {3u, 0u, 6u, 1u, 2u, 5u, 4u}) {
      pt.remove(id);
      ASSERT_NO_FATAL_FAILURE(expect_periodic_delaunay(pt));
    }
    EXPECT_EQ(pt.number_of_points(), 0u);
  }
}

TEST(Lattices, and_points_on_a_line_are_no_exception)
{
  std::vector<Point> lattice, line;
  for (int i = 0; i < 5; ++i) {
    line.push_back(Point(i * 0.2, 0.5));
    for (int j = 0; j < 5; ++j)
      lattice.push_back(Point(i, j));
  }
  ASSERT_NO_FATAL_FAILURE(expect_periodic_delaunay(Triangulation(lattice, Cell(5, 5))));
  ASSERT_NO_FATAL_FAILURE(expect_periodic_delaunay(Triangulation(lattice, Cell(5, 0, 2.5, 5))));
  ASSERT_NO_FATAL_FAILURE(expect_periodic_delaunay(Triangulation(line, Cell(1, 1))));
  ASSERT_NO_FATAL_FAILURE(expect_periodic_delaunay(Triangulation(line, Cell(1, 0.01))));
}

TEST(Coincident_points, share_a_vertex_also_by_a_translation_and_part_again)
{
  const Cell cell(4, 1, 0, 2);
  std::vector<Point> points{Point(1, 1), Point(5, 2), Point(1, 3), Point(2, 1.5)};
  Triangulation pt(points, cell);
  EXPECT_EQ(pt.number_of_vertices(), 2u);
  EXPECT_EQ(pt.number_of_points(), 4u);
  ASSERT_NO_FATAL_FAILURE(expect_periodic_delaunay(pt));

  points[1] = Point(5.25, 2);
  pt.update(points);
  EXPECT_EQ(pt.number_of_vertices(), 3u);
  ASSERT_NO_FATAL_FAILURE(expect_periodic_delaunay(pt));

  points[1] = Point(5, 4);
  pt.update(points);
  EXPECT_EQ(pt.number_of_vertices(), 2u);
  ASSERT_NO_FATAL_FAILURE(expect_periodic_delaunay(pt));

  pt.remove(0); // another one represents them
  EXPECT_EQ(pt.number_of_vertices(), 2u);
  ASSERT_NO_FATAL_FAILURE(expect_periodic_delaunay(pt));
  pt.move(1, Point(0, 0));
  EXPECT_EQ(pt.number_of_vertices(), 3u);
  ASSERT_NO_FATAL_FAILURE(expect_periodic_delaunay(pt));
  pt.move(1, Point(2, 1.5));
  EXPECT_EQ(pt.number_of_vertices(), 2u);
  ASSERT_NO_FATAL_FAILURE(expect_periodic_delaunay(pt));
}

// MOTION ----------------------------------------------------------------------------------------

TEST(Motion, is_followed_at_every_step_size_from_one_point_to_fifty)
{
  std::mt19937_64 random(2);
  for (const std::size_t number : {1u, 2u, 3u, 4u, 7u, 20u, 50u})
    for (const double step : {0.001, 0.03, 0.3, 3.0}) {
      const double side = std::sqrt(double(number));
      std::vector<Point> points = random_points(random, number, side);
      Triangulation pt(points, Cell(side, 0.2, 0.3, side));
      for (int frame = 0; frame < 4; ++frame) {
        move_randomly(random, points, step);
        pt.update(points);
        ASSERT_NO_FATAL_FAILURE(expect_periodic_delaunay(pt)) << number << ' ' << step;
      }
    }
}

TEST(Motion, on_a_grid_is_followed_with_all_its_coincidences_and_circles)
{
  std::mt19937_64 random(3);
  for (int run = 0; run < 12; ++run) {
    Triangulation pt(random_points(random, 12, 4, 0.5), Cell(4, 0, run % 3, 4));
    for (int frame = 0; frame < 6; ++frame) {
      pt.update(random_points(random, 12, 4, 0.5));
      ASSERT_NO_FATAL_FAILURE(expect_periodic_delaunay(pt)) << run << ' ' << frame;
    }
  }
}

TEST(Calm_motion, flips_what_breaks_and_rebuilds_nothing)
{
  std::mt19937_64 random(4);
  std::vector<Point> points = random_points(random, 2000, 44);
  Triangulation pt(points, Cell(44, 44));
  CGAL::Update_report_2 total;
  for (int frame = 0; frame < 40; ++frame) {
    move_randomly(random, points, 0.02);
    for (Point& p : points)
      p = image(p, pt.cell(), -int(std::floor(p.x() / 44)), -int(std::floor(p.y() / 44)));
    total += pt.update(points);
  }
  EXPECT_FALSE(total.rebuilt());
  EXPECT_GT(total.flips, 1000u);
  EXPECT_TRUE(pt.is_valid());
}

TEST(Points_that_jump, are_inserted_anew_without_a_rebuild)
{
  std::mt19937_64 random(5);
  std::vector<Point> points = random_points(random, 1000, 30);
  Triangulation pt(points, Cell(30, 30));
  for (int frame = 0; frame < 20; ++frame) {
    for (std::size_t i = 0; i < 5; ++i)
      points[random() % 1000] = random_points(random, 1, 30)[0];
    const CGAL::Update_report_2 report = pt.update(points);
    EXPECT_FALSE(report.rebuilt());
    EXPECT_GE(report.relocated, 3u);
  }
  EXPECT_TRUE(pt.is_valid());
}

TEST(Translations_of_the_lattice, change_no_edge_where_they_are_exact)
{
  std::mt19937_64 random(6);
  const Cell cell(16, 2, 4, 16);
  std::vector<Point> points = random_points(random, 40, 16, 0x1p-20);
  Triangulation pt(points, cell), wrapped(points, cell);
  std::vector<std::array<int, 2>> images(points.size(), {0, 0});
  for (int frame = 0; frame < 10; ++frame) {
    std::vector<Point> moved;
    for (std::size_t i = 0; i < points.size(); ++i) {
      points[i] = Point(points[i].x() + double(int(random() % 1000) - 500) * 0x1p-12,
                        points[i].y() + double(int(random() % 1000) - 500) * 0x1p-12);
      if (random() % 3 == 0)
        images[i] = {int(random() % 7) - 3, int(random() % 7) - 3};
      moved.push_back(image(points[i], cell, images[i][0], images[i][1]));
    }
    pt.update(points);
    wrapped.update(moved);
    ASSERT_NO_FATAL_FAILURE(expect_periodic_delaunay(wrapped));
    std::set<Directed_edge> edges_of_wrapped;
    for (const auto& [i, j, s] : edges_both_ways(wrapped))
      edges_of_wrapped.insert(
          {i, j, {s[0] + images[j][0] - images[i][0], s[1] + images[j][1] - images[i][1]}});
    ASSERT_EQ(edges_both_ways(pt), edges_of_wrapped) << frame;
  }
}

// CELLS THAT CHANGE -----------------------------------------------------------------------------

TEST(A_cell, expands_and_shrinks_with_its_points)
{
  std::mt19937_64 random(7);
  std::vector<Point> points = random_points(random, 30, 5);
  Triangulation pt(points, Cell(5, 5));
  double width = 5, height = 5;
  for (int frame = 0; frame < 30; ++frame) {
    const double x = frame % 2 ? 0.97 : 1.01, y = frame % 3 ? 1.02 : 0.99;
    for (Point& p : points)
      p = Point(p.x() * x, p.y() * y);
    width *= x;
    height *= y;
    const CGAL::Update_report_2 report = pt.update(points, Cell(width, height));
    EXPECT_FALSE(report.rebuilt());
    ASSERT_NO_FATAL_FAILURE(expect_periodic_delaunay(pt));
  }
}

// A shear to a strain of ten. With `flips`, the cell is exchanged for a less skew one of the same
// lattice, as with the boundary conditions of Lees and Edwards.
void shear(bool flips)
{
  std::mt19937_64 random(8);
  const std::size_t number = 100;
  const double side = std::sqrt(double(number));
  std::vector<Point> points = random_points(random, number, side);
  Triangulation pt(points, Cell(side, side));
  double skew = 0;
  for (int frame = 1; frame <= 1000; ++frame) {
    const double step = 0.01;
    for (Point& p : points)
      p = Point(p.x() + step * p.y(), p.y());
    move_randomly(random, points, 0.005);
    skew += step * side;
    if (flips && skew > side / 2)
      skew -= side;
    for (Point& p : points) { // as simulations do, into the rectangle
      const int j = -int(std::floor(p.y() / side));
      p = Point(p.x() + j * skew, p.y() + j * side);
      p = Point(p.x() - std::floor(p.x() / side) * side, p.y());
    }
    const CGAL::Update_report_2 report = pt.update(points, Cell(side, 0, skew, side));
    ASSERT_FALSE(report.rebuilt()) << "frame " << frame;
    if (frame % 100 == 0) {
      ASSERT_TRUE(pt.is_valid());
    }
  }
  ASSERT_NO_FATAL_FAILURE(expect_periodic_delaunay(pt));
}

TEST(A_sheared_cell, is_followed_to_a_strain_of_ten_without_a_rebuild)
{
  shear(false);
}

TEST(A_sheared_cell, may_be_exchanged_for_a_less_skew_one_without_a_rebuild)
{
  shear(true);
}

TEST(A_cell, may_have_its_vectors_exchanged_and_recombined)
{
  std::mt19937_64 random(9);
  const std::vector<Point> points = random_points(random, 25, 5, 0x1p-10);
  Triangulation pt(points, Cell(5, 0, 1, 5));
  for (const Cell& same :
       {Cell(1, 5, 5, 0), Cell(6, 5, 5, 0), Cell(-5, 0, 6, 5), Cell(5, 0, 1, 5)}) {
    const CGAL::Update_report_2 report = pt.update(points, same);
    EXPECT_FALSE(report.rebuilt());
    EXPECT_EQ(report.flips, 0u);
    ASSERT_NO_FATAL_FAILURE(expect_periodic_delaunay(pt));
  }
}

TEST(A_cell, may_change_its_orientation)
{
  std::mt19937_64 random(10);
  const std::vector<Point> points = random_points(random, 25, 2);
  Triangulation pt(points, Cell(4, 1));
  for (const Cell& other : {Cell(0, 2, 2, 0), Cell(2, 2), Cell(-0.6, 0, 0, 0.6)}) {
    EXPECT_TRUE(pt.update(points, other).certified);
    ASSERT_NO_FATAL_FAILURE(expect_periodic_delaunay(pt));
  }
}

// WRONG INPUT -----------------------------------------------------------------------------------

TEST(A_cell, must_be_finite_and_have_an_area)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(Cell(nan, 1), CGAL::Periodic_cell_error_2);
  EXPECT_THROW(Cell(0, 1), CGAL::Periodic_cell_error_2);
  EXPECT_THROW(Cell(1, 2, 3, 6), CGAL::Periodic_cell_error_2);
  EXPECT_THROW(Cell::slab(0, 0), CGAL::Periodic_cell_error_2);
  EXPECT_THROW(Cell::slab(nan, 0), CGAL::Periodic_cell_error_2);
  EXPECT_THROW(Triangulation(Cell(1e-200, 1e-200)), CGAL::Periodic_cell_error_2);
  EXPECT_THROW(Triangulation(Cell(1, 0, 1e12, 1)), CGAL::Periodic_cell_error_2);
  EXPECT_THROW(Triangulation(Cell(1e200, 1e200)), CGAL::Periodic_cell_error_2);
  try {
    Cell(1, 2, 3, 6);
    FAIL() << "its vectors are parallel";
  } catch (const CGAL::Periodic_cell_error_2& error) {
    EXPECT_EQ(error.ax(), 1);
    EXPECT_EQ(error.ay(), 2);
    EXPECT_EQ(error.bx(), 3);
    EXPECT_EQ(error.by(), 6);
  }
  const Cell from_vectors(Kernel::Vector_2(1, 2), Kernel::Vector_2(3, 5));
  EXPECT_EQ(from_vectors, Cell(1, 2, 3, 5));
  EXPECT_EQ(from_vectors.area(), 1);
}

TEST(Wrong_input, is_refused_also_where_points_walk_out_of_range_in_small_steps)
{
  const double limit = 0x1p20; // in cells
  std::vector<Point> points{Point(limit - 0.1, 0), Point(0.4, 0.3)};
  Triangulation pt(points, Cell(1, 1));
  points[0] = Point(limit - 0.05, 0);
  EXPECT_NO_THROW(pt.update(points));
  points[0] = Point(limit + 0.05, 0);
  EXPECT_THROW(pt.update(points), CGAL::Periodic_range_error_2);
  EXPECT_EQ(pt.point(0), Point(limit - 0.05, 0));
  ASSERT_NO_FATAL_FAILURE(expect_periodic_delaunay(pt));
}

TEST(The_rounding_mode_of_the_caller, changes_nothing_and_is_given_back)
{
  std::mt19937_64 random(15);
  std::vector<std::vector<Point>> frames{random_points(random, 60, 7, 0.125)};
  for (int frame = 0; frame < 20; ++frame) {
    frames.push_back(frames.back());
    move_randomly(random, frames.back(), 0.05);
  }
  std::set<std::vector<std::tuple<std::size_t, std::size_t, CGAL::Periodic_shift_2>>> results;
  for (const int mode : {FE_TONEAREST, FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
    std::fesetround(mode);
    Triangulation pt(Cell(7, 0.1, 0.3, 7.7));
    pt.insert(frames[0].begin(), frames[0].end(), CGAL::Emptyset_iterator());
    for (const std::vector<Point>& points : frames)
      pt.update(points);
    const bool is_valid = pt.is_valid();
    const int mode_after = std::fegetround();
    std::fesetround(FE_TONEAREST);
    EXPECT_TRUE(is_valid);
    EXPECT_EQ(mode_after, mode);
    std::vector<std::tuple<std::size_t, std::size_t, CGAL::Periodic_shift_2>> edges;
    pt.for_each_edge([&](std::size_t i, std::size_t j, const CGAL::Periodic_shift_2& shift) {
      edges.emplace_back(i, j, shift);
    });
    results.insert(edges);
  }
  EXPECT_EQ(results.size(), 1u);
}

// OBJECTS ---------------------------------------------------------------------------------------

TEST(A_copy, goes_its_own_way_and_a_moved_one_is_empty)
{
  std::mt19937_64 random(11);
  std::vector<Point> points = random_points(random, 20, 4);
  Triangulation pt(points, Cell(4, 4));
  Triangulation copy(pt);
  move_randomly(random, points, 0.2);
  copy.update(points);
  ASSERT_NO_FATAL_FAILURE(expect_periodic_delaunay(copy));
  ASSERT_NO_FATAL_FAILURE(expect_periodic_delaunay(pt));
  EXPECT_NE(pt.point(0), copy.point(0));

  Triangulation taken(std::move(copy));
  EXPECT_EQ(copy.number_of_points(), 0u);
  EXPECT_EQ(copy.insert(Point(1, 1)), 0u);
  ASSERT_NO_FATAL_FAILURE(expect_periodic_delaunay(copy));
  copy = taken;
  swap(copy, pt);
  EXPECT_EQ(pt.point(0), taken.point(0));
  ASSERT_NO_FATAL_FAILURE(expect_periodic_delaunay(pt));
  ASSERT_NO_FATAL_FAILURE(expect_periodic_delaunay(copy));
}

TEST(Vectors_between_neighbors, are_those_to_the_nearest_images)
{
  const Triangulation pt(std::vector<Point>{Point(0.1, 0.5), Point(0.9, 0.5)}, Cell(1, 1));
  std::size_t ways = 0;
  pt.for_each_edge([&](std::size_t i, std::size_t j, const CGAL::Periodic_shift_2& shift) {
    if (i == j)
      return;
    const Kernel::Vector_2 v = pt.vector(i, j, shift);
    ways += std::abs(std::abs(v.x()) - 0.2) < 1e-12 && v.y() == 0;
    EXPECT_EQ(v, -pt.vector(j, i, {-shift[0], -shift[1]}));
  });
  EXPECT_EQ(ways, 1u);
}

// PREDICATES ------------------------------------------------------------------------------------

// Four images near a circle, or nearly on it, in cells of all sizes: where the filter claims a sign
// it is that of exact arithmetic, for one edge and for four at once.
TEST(Predicates_of_the_torus, are_those_of_exact_arithmetic)
{
  using namespace CGAL::Dynamic_Delaunay_triangulations_2;
  using CGAL::Periodic_shift_2;
  using namespace CGAL::Dynamic_Delaunay_triangulations_2::internal;
  using Exact = CGAL::Exact_predicates_exact_constructions_kernel;
  std::mt19937_64 random(12);
  std::size_t undecided = 0;
  for (int i = 0; i < 30000; ++i) {
    const double side = std::pow(2.0, random_between(random, -3, 12));
    const Cell cell(side, random_between(random, -1, 1) * side, random_between(random, -1, 1),
                    side * random_between(random, 0.5, 2));
    const Torus_2 torus(cell);
    const double radius = std::pow(10.0, random_between(random, -3, 0)),
                 turn = random_between(random, 0, 6.3);
    std::array<Image_2, 4> images;
    std::array<Exact::Point_2, 4> exact;
    for (std::size_t k = 0; k < 4; ++k) {
      const double angle = turn + 1.57 * double(k) + random_between(random, -0.7, 0.7);
      const Periodic_shift_2 shift{int(random() % 9) - 4, int(random() % 9) - 4};
      const Position_2 way = torus.vector({double(shift[0]), double(shift[1])});
      images[k] = {{radius * std::cos(angle) - way.x, radius * std::sin(angle) - way.y}, shift};
      exact[k] = Exact::Point_2(images[k].position.x, images[k].position.y) +
                 Exact::FT(shift[0]) * Exact::Vector_2(cell.ax(), cell.ay()) +
                 Exact::FT(shift[1]) * Exact::Vector_2(cell.bx(), cell.by());
    }
    ASSERT_EQ(torus.orientation(images[0], images[1], images[2]),
              CGAL::orientation(exact[0], exact[1], exact[2]));
    // the third one nearly on the line through the others
    Image_2 middle = images[0];
    middle.position = {
        middle.position.x + (torus.rounded(images[1]).x - torus.rounded(images[0]).x) / 2,
        middle.position.y + (torus.rounded(images[1]).y - torus.rounded(images[0]).y) / 2};
    const Exact::Point_2 exact_middle =
        Exact::Point_2(middle.position.x, middle.position.y) +
        (exact[0] - Exact::Point_2(images[0].position.x, images[0].position.y));
    ASSERT_EQ(torus.orientation(images[0], images[1], middle),
              CGAL::orientation(exact[0], exact[1], exact_middle));
    // the faces (0, 1, 2) and (3, 2, 1) of an edge from 1 to 2, counterclockwise or not
    const Edge_images_2 corners{images[0], images[1], images[3], images[2]};
    const bool are_counterclockwise = CGAL::left_turn(exact[0], exact[1], exact[3]) &&
                                      CGAL::left_turn(exact[2], exact[3], exact[1]);
    if (!are_counterclockwise)
      continue;
    const bool is_inside = CGAL::side_of_oriented_circle(exact[0], exact[1], exact[3], exact[2]) ==
                           CGAL::ON_POSITIVE_SIDE;
    ASSERT_EQ(torus.edge_state(corners),
              is_inside ? Edge_state_2::ILLEGAL : Edge_state_2::DELAUNAY);
    ASSERT_TRUE(!is_inside ||
                torus.filter_proves_delaunay({corners, corners, corners, corners}) == 0);
    undecided += !is_inside && !torus.filter_proves_delaunay(corners);
  }
  EXPECT_GT(undecided, 100u); // otherwise no case was hard
}

// A corner is nearly on the line through the edge, beyond its end: the face of this corner is
// nearly flat, counterclockwise or not, and its circle is far from the corner on the other side.
TEST(Predicates_of_the_torus, see_flat_faces_of_edges_with_empty_circles)
{
  using namespace CGAL::Dynamic_Delaunay_triangulations_2;
  using namespace CGAL::Dynamic_Delaunay_triangulations_2::internal;
  using Exact = CGAL::Exact_predicates_exact_constructions_kernel;
  std::mt19937_64 random(13);
  std::size_t flat = 0;
  for (int i = 0; i < 3000; ++i) {
    const Cell cell(random_between(random, 100, 200), random_between(random, -1, 1),
                    random_between(random, -1, 1), random_between(random, 100, 200));
    const Torus_2 torus(cell);
    const CGAL::Periodic_shift_2 shift{int(random() % 9) - 4, int(random() % 9) - 4};
    const Position_2 way = torus.vector({double(shift[0]), double(shift[1])});
    const Point b(random_between(random, 0, 1), random_between(random, 0, 1));
    const Point c(b.x() + random_between(random, 0, 1), b.y() + random_between(random, 0, 1));
    const double beyond = random_between(random, 1.2, 2);
    const Position_2 a{b.x() + beyond * (c.x() - b.x()) - way.x,
                       b.y() + beyond * (c.y() - b.y()) - way.y};
    const Point d(b.x() + (c.y() - b.y()), b.y() - (c.x() - b.x()));
    const Exact::Point_2 exact_a = Exact::Point_2(a.x, a.y) +
                                   Exact::FT(shift[0]) * Exact::Vector_2(cell.ax(), cell.ay()) +
                                   Exact::FT(shift[1]) * Exact::Vector_2(cell.bx(), cell.by());
    const bool is_left =
        CGAL::left_turn(exact_a, Exact::Point_2(b.x(), b.y()), Exact::Point_2(c.x(), c.y()));
    const Edge_images_2 corners{
        {a, shift}, {{b.x(), b.y()}, {0, 0}}, {{c.x(), c.y()}, {0, 0}}, {{d.x(), d.y()}, {0, 0}}};
    const Edge_images_2 turned{corners.right, corners.target, corners.source, corners.left};
    for (const Edge_images_2& edge : {corners, turned}) {
      ASSERT_EQ(torus.edge_state(edge) == Edge_state_2::DELAUNAY, is_left) << i;
      ASSERT_TRUE(is_left || torus.filter_proves_delaunay({edge, edge, edge, edge}) == 0) << i;
    }
    flat += !is_left;
  }
  EXPECT_GT(flat, 500u);
}

// The points differ by 3 a + b, as their coordinates are -a and c = 2 a + b. This difference is
// rounded once; the sum of the multiples of vectors is rounded more than once, to another number.
TEST(Coincident_points, are_seen_where_their_translations_are_rounded)
{
  std::mt19937_64 random(14);
  for (int i = 0; i < 300; ++i) {
    const double a = random_between(random, 0.1, 0.2), c = random_between(random, 2 * a, 4 * a);
    const double b = c - 2 * a; // exact, as 2a and c are within a factor of two
    const std::vector<Point> points{Point(-a, 0.5), Point(c, 1.5)};
    Triangulation pt(points, Cell(a, 0, b, 1));
    ASSERT_EQ(pt.number_of_vertices(), 1u) << i;
    ASSERT_TRUE(pt.is_valid());
    ASSERT_EQ(pt.update(points).parted, 0u) << i;
  }
}

// Four cocircular images whose rounded positions are not cocircular.
TEST(Predicates_of_the_torus, see_ties_that_roundings_hide)
{
  using namespace CGAL::Dynamic_Delaunay_triangulations_2;
  using namespace CGAL::Dynamic_Delaunay_triangulations_2::internal;
  const Torus_2 torus(Cell(0.1, 0, 0, 0.1));
  const Position_2 p{0.7, 0.3};
  const Edge_images_2 square{{p, {3, 3}}, {p, {2, 3}}, {p, {3, 2}}, {p, {2, 2}}};
  EXPECT_EQ(torus.orientation({p, {-7, -3}}, {p, {0, 0}}, {p, {7, 3}}), CGAL::COLLINEAR);
  EXPECT_EQ(torus.edge_state(square), Edge_state_2::DELAUNAY);
  EXPECT_FALSE(torus.filter_proves_delaunay(square));
}

// Each of the four edges has the answer that it has alone, also where images are across a slab.
TEST(Predicates_of_the_torus, are_the_same_for_four_edges_at_once)
{
  using namespace CGAL::Dynamic_Delaunay_triangulations_2::internal;
  std::mt19937_64 random(15);
  for (const Cell& cell : {Cell(3, 1, -0.5, 4), Cell(Vector(4, 0.5))}) {
    const Torus_2 torus(cell);
    std::size_t proved = 0;
    for (int i = 0; i < 2000; ++i) {
      std::array<Edge_images_2, 4> edges;
      for (Edge_images_2& edge : edges) {
        const auto place = [&](Image_2& image, double x, double y) {
          image.shift = {int(random() % 5) - 2, int(random() % 3 == 0)};
          const Position_2 way =
              torus.vector({double(image.shift[0]), cell.is_slab() ? 0 : double(image.shift[1])});
          image.position = {x - way.x, y - way.y};
        };
        place(edge.left, random_between(random, -1, 1), random_between(random, -0.1, 2));
        place(edge.source, -1, 0);
        place(edge.target, 1, 0);
        place(edge.right, random_between(random, -1, 1), random_between(random, -2, 0.1));
      }
      const int of_four = torus.filter_proves_delaunay(edges);
      for (std::size_t k = 0; k < 4; ++k) {
        const bool is_proved = torus.filter_proves_delaunay(edges[k]);
        ASSERT_EQ(bool(of_four >> k & 1), is_proved) << i << ' ' << k;
        proved += is_proved;
      }
    }
    EXPECT_GT(proved, 500u);
  }
}

// SLABS -------------------------------------------------------------------------------------------

using Exact_point = CGAL::Exact_predicates_exact_constructions_kernel::Point_2;

// An image in a slab, as if its second vector were finite, but so long that predicates of these
// numbers, some of which are subnormal, cannot tell it from an infinite one.
Exact_point far_image(const internal::Image_2& image, const Cell& slab)
{
  using Exact = CGAL::Exact_predicates_exact_constructions_kernel;
  const Exact::FT part = std::ldexp(1.0, 1000), long_enough = part * part * part;
  const Exact::Vector_2 a(slab.ax(), slab.ay());
  return Exact_point(image.position.x, image.position.y) + Exact::FT(image.shift[0]) * a +
         Exact::FT(image.shift[1]) * long_enough * a.perpendicular(CGAL::COUNTERCLOCKWISE);
}

// For points in rows along the slab, near such rows, on lines, on grids and anywhere.
TEST(Predicates_of_a_slab, are_those_of_a_torus_whose_second_vector_is_long_enough)
{
  using namespace CGAL::Dynamic_Delaunay_triangulations_2::internal;
  std::mt19937_64 random(25);
  const auto coordinate = [&](bool is_on_grid) {
    return is_on_grid ? double(random() % 4) / 2 : random_between(random, 0, 2);
  };
  std::map<int, std::size_t> counts;
  const char* const more = std::getenv("PERIODIC_RUNS");
  const std::uint64_t runs = more ? 1000 * std::strtoull(more, nullptr, 10) : 20000;
  for (std::uint64_t i = 0; i < runs; ++i) {
    const double length = (random() % 2 == 0 ? 1 : -1) * (random() % 2 == 0 ? 2 : 0.7);
    const std::array<Cell, 3> slabs{Cell::slab(length, 0), Cell::slab(0, length),
                                    Cell::slab(length, 0.3)};
    const Cell& slab = slabs[random() % 3];
    const bool is_on_grid = random() % 2 == 0, is_in_rows = random() % 2 == 0;
    const std::array<double, 2> heights{coordinate(is_on_grid), coordinate(is_on_grid)};
    std::array<Image_2, 4> images;
    std::array<Exact_point, 4> points;
    const int row = int(random() % 3) - 1;
    for (std::size_t k = 0; k < 4; ++k) {
      const int above = random() % 4 == 0 ? 2 * int(random() % 2) : int(random() % 2);
      const double along = coordinate(is_on_grid);
      double across = is_in_rows ? heights[std::size_t(above % 2)] : coordinate(is_on_grid);
      if (random() % 32 == 0)
        across = std::nextafter(across, 9);
      const Position_2 p = slab.ax() == 0 ? Position_2{across, along} : Position_2{along, across};
      images[k] = {p, {int(random() % 5) - 2, row + above}};
      points[k] = far_image(images[k], slab);
    }
    const auto& [a, b, c, d] = images;
    const Torus_2 torus(slab);
    const CGAL::Orientation turn = CGAL::orientation(points[0], points[1], points[2]);
    ASSERT_EQ(torus.orientation(a, b, c), turn) << i;
    if (turn != CGAL::LEFT_TURN)
      continue;
    const CGAL::Oriented_side side =
        CGAL::side_of_oriented_circle(points[0], points[1], points[2], points[3]);
    ASSERT_EQ(torus.side_of_circle(a, b, c, d), side) << i;
    ++counts[side];
  }
  EXPECT_GT(counts[CGAL::ON_POSITIVE_SIDE], runs / 10);
  EXPECT_GT(counts[CGAL::ON_NEGATIVE_SIDE], runs / 10);
  EXPECT_GT(counts[CGAL::ON_ORIENTED_BOUNDARY], runs / 500);
}

// Two points in each of two rows; the midpoints of both pairs coincide, or nearly.
TEST(Predicates_of_a_slab, see_ties_between_rows_and_what_is_none_by_a_hair)
{
  using namespace CGAL::Dynamic_Delaunay_triangulations_2::internal;
  std::mt19937_64 random(26);
  const Cell slab = Cell::slab(0.7, 0);
  const Torus_2 torus(slab);
  std::map<int, std::size_t> counts;
  while (counts[0] < 200 || counts[1] < 200 || counts[-1] < 200) {
    std::array<Image_2, 4> images; // the first and the last one are in one row
    for (std::size_t k = 0; k < 4; ++k)
      images[k] = {{random_between(random, 0, 8), k % 3 == 0 ? 0.3 : 0.8},
                   {int(random() % 9), k % 3 == 0 ? 0 : 1}};
    auto& [a, b, c, d] = images;
    if (random() % 2 == 0)
      c.shift[0] = a.shift[0] + d.shift[0] - b.shift[0];
    c.position.x = a.position.x + (d.position.x - b.position.x) +
                   0.7 * (a.shift[0] + d.shift[0] - b.shift[0] - c.shift[0]);
    if (torus.orientation(a, b, c) != CGAL::LEFT_TURN)
      continue;
    const Exact_point pa = far_image(a, slab), pb = far_image(b, slab), pc = far_image(c, slab),
                      pd = far_image(d, slab);
    const CGAL::Oriented_side side = CGAL::side_of_oriented_circle(pa, pb, pc, pd);
    ASSERT_EQ(torus.side_of_circle(a, b, c, d), side);
    ++counts[side];
  }
}

TEST(A_point_in_a_slab, is_its_own_two_neighbors)
{
  const Triangulation pt(std::vector<Point>{Point(0.3, 0.4)}, Cell(Vector(2, 1)));
  ASSERT_NO_FATAL_FAILURE(expect_periodic_delaunay(pt));
  EXPECT_TRUE(pt.cell().is_slab());
  EXPECT_EQ(pt.number_of_edges(), 1u);
  EXPECT_EQ(pt.number_of_faces(), 0u);
  pt.for_each_edge([&](std::size_t i, std::size_t j, const CGAL::Periodic_shift_2& shift) {
    EXPECT_EQ(std::abs(pt.vector(i, j, shift).x()), 2);
    EXPECT_EQ(std::abs(pt.vector(i, j, shift).y()), 1);
  });
}

TEST(Points_in_a_row_along_a_slab, have_edges_but_no_faces_until_one_leaves_the_row)
{
  Triangulation pt(std::vector<Point>{Point(0.1, 1), Point(0.5, 1), Point(0.8, 1)},
                   Cell::slab(1, 0));
  ASSERT_NO_FATAL_FAILURE(expect_periodic_delaunay(pt));
  EXPECT_EQ(pt.number_of_edges(), 3u);
  EXPECT_EQ(pt.number_of_faces(), 0u);
  for (const double height : {1 + 1e-15, 1.3, 5e8, 1.0, -7.0, 1.0}) {
    pt.move(1, Point(0.5, height));
    ASSERT_NO_FATAL_FAILURE(expect_periodic_delaunay(pt)) << height;
    EXPECT_EQ(pt.number_of_faces(), height == 1 ? 0u : 3u);
  }
}

TEST(Few_points_in_a_slab, are_right_from_the_first_to_the_last_along_any_vector)
{
  std::mt19937_64 random(21);
  for (const Cell& slab : {Cell::slab(1, 0), Cell::slab(0, -3), Cell::slab(0.7, 0.3),
                           Cell::slab(1e-3, 0), Cell::slab(40, -11)})
    for (const double grid : {0.0, 0.25}) {
      Triangulation pt(slab);
      std::vector<Point> points = random_points(random, 12, 3, grid);
      for (const Point& p : points) {
        pt.insert(p);
        ASSERT_NO_FATAL_FAILURE(expect_periodic_delaunay(pt));
      }
      for (std::size_t id = 0; id < points.size(); ++id) {
        pt.remove(id);
        ASSERT_NO_FATAL_FAILURE(expect_periodic_delaunay(pt));
      }
    }
}

TEST(Motion_in_a_slab, is_followed_at_every_step_size_without_an_end_at_the_walls)
{
  std::mt19937_64 random(22);
  for (const std::size_t number : {2u, 5u, 40u})
    for (const double step : {1e-4, 1e-2, 0.1, 1.0}) {
      std::vector<Point> points = random_points(random, number, 3, number == 5 ? 0.5 : 0);
      Triangulation pt(points, Cell(Vector(3, 0.2)));
      for (int frame = 0; frame < 20; ++frame) {
        move_randomly(random, points, step);
        std::vector<Point> wrapped;
        for (const Point& p : points)
          wrapped.push_back(image(p, pt.cell(), -int(std::floor(p.x() / 3)), 0));
        pt.update(frame % 2 == 0 ? wrapped : points);
        ASSERT_NO_FATAL_FAILURE(expect_periodic_delaunay(pt)) << number << ' ' << step;
      }
    }
}

// The outermost points have images of themselves for neighbors, and cannot be taken out.
TEST(Rough_motion_in_a_slab, rebuilds_nothing_where_points_cross_its_open_sides)
{
  std::mt19937_64 random(27);
  std::vector<Point> points = random_points(random, 600, 24);
  Triangulation pt(points, Cell::slab(24, 0));
  std::size_t taken_out = 0;
  for (int frame = 0; frame < 40; ++frame) {
    move_randomly(random, points, 0.1);
    const CGAL::Update_report_2 report = pt.update(points);
    EXPECT_FALSE(report.rebuilt()) << frame;
    taken_out += report.relocated;
    ASSERT_TRUE(pt.is_valid()) << frame;
  }
  ASSERT_NO_FATAL_FAILURE(expect_periodic_delaunay(pt));
  EXPECT_GT(taken_out, 0u);
}

// The walls are rows of points: level with each other at some times, and not at others.
TEST(Walls_of_a_slab, may_slide_along_each_other)
{
  for (const bool is_upright : {false, true}) {
    std::mt19937_64 random(24);
    std::vector<Point> points = random_points(random, 30, 3);
    for (int i = 0; i < 12; ++i)
      points.push_back(Point(0.5 * (i % 6), i < 6 ? -1 : 4));
    const auto turned = [&] {
      std::vector<Point> result = points;
      for (Point& p : result)
        p = is_upright ? Point(p.y(), p.x()) : p;
      return result;
    };
    Triangulation pt(turned(), is_upright ? Cell::slab(0, 3) : Cell::slab(3, 0));
    for (int frame = 0; frame < 40; ++frame) {
      for (std::size_t i = 0; i < 30; ++i)
        points[i] = Point(points[i].x() + random_between(random, -0.05, 0.05), points[i].y());
      for (std::size_t i = 36; i < 42; ++i)
        points[i] = Point(points[i].x() + 0.125, 4);
      EXPECT_FALSE(pt.update(turned()).rebuilt());
      ASSERT_NO_FATAL_FAILURE(expect_periodic_delaunay(pt)) << frame;
    }
  }
}

TEST(Calm_motion_in_a_channel, rebuilds_nothing_and_takes_no_vertex_out)
{
  std::mt19937_64 random(23);
  std::vector<Point> points;
  for (int i = 0; i < 400; ++i) // between walls of points in rows
    points.push_back(i < 80
                         ? Point(0.25 * (i % 40), i < 40 ? 0 : 10)
                         : Point(random_between(random, 0, 10), random_between(random, 0.1, 9.9)));
  Triangulation pt(points, Cell::slab(10, 0));
  std::size_t taken_out = 0, flips = 0;
  for (int frame = 0; frame < 50; ++frame) {
    for (std::size_t i = 80; i < points.size(); ++i) {
      const double x = points[i].x() + 0.02 * points[i].y() / 10; // a plug that shears
      points[i] = Point(x >= 10 ? x - 10 : x, points[i].y());
    }
    const CGAL::Update_report_2 report = pt.update(points);
    EXPECT_FALSE(report.rebuilt());
    taken_out += report.relocated;
    flips += report.flips;
    ASSERT_TRUE(pt.is_valid());
  }
  ASSERT_NO_FATAL_FAILURE(expect_periodic_delaunay(pt));
  EXPECT_EQ(taken_out, 0u);
  EXPECT_GT(flips, 0u);
}

TEST(A_slab, may_be_stretched_and_turned_with_its_points_and_run_the_other_way)
{
  std::mt19937_64 random(24);
  std::vector<Point> points = random_points(random, 50, 2);
  Triangulation pt(points, Cell::slab(2, 0));
  for (int frame = 1; frame <= 40; ++frame) {
    const double angle = 0.1 * frame, stretch = 1 + 0.02 * frame;
    std::vector<Point> turned;
    for (const Point& p : points) {
      const double x = stretch * p.x();
      turned.push_back(Point(std::cos(angle) * x - std::sin(angle) * p.y(),
                             std::sin(angle) * x + std::cos(angle) * p.y()));
    }
    const double length = 2 * stretch * (frame % 7 == 0 ? -1 : 1);
    const CGAL::Update_report_2 report =
        pt.update(turned, Cell::slab(length * std::cos(angle), length * std::sin(angle)));
    EXPECT_FALSE(report.rebuilt()) << frame;
    ASSERT_NO_FATAL_FAILURE(expect_periodic_delaunay(pt)) << frame;
  }
}

// ALL AT ONCE -------------------------------------------------------------------------------------

TEST(Many_points, are_triangulated_at_once_in_cells_of_any_shape)
{
  std::mt19937_64 random(41);
  for (const Cell& cell : {Cell(20, 20), Cell(2, 200), Cell(20, 3, -50, 20), Cell(-20, 0, 0, 20)})
    for (const double extent : {1.0, 20.0, 500.0}) { // crowded in a corner, all over, unwrapped
      const std::vector<Point> points = random_points(random, 120, extent);
      const Triangulation pt(points, cell);
      ASSERT_NO_FATAL_FAILURE(expect_periodic_delaunay(pt)) << extent;
    }
}

TEST(Many_points, may_coincide_or_form_a_grid)
{
  std::mt19937_64 random(42);
  for (const double grid : {0.5, 1.0, 2.0}) {
    std::vector<Point> points = random_points(random, 120, 20, grid);
    points.push_back(image(points[7], Cell(20, 20), 1, -1));
    const Triangulation pt(points, Cell(20, 20));
    ASSERT_NO_FATAL_FAILURE(expect_periodic_delaunay(pt)) << grid;
  }
}

// A cluster is as small as the error by which its points are wrapped, as they are in images far
// away. So some faces of the rounded images are inverted, and flips cannot mend all of them.
TEST(Many_points, are_inserted_one_by_one_where_rounding_turns_faces_over)
{
  std::mt19937_64 random(45);
  const auto between = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  const Cell cell(0.7713, 0.0131, -0.1177, 0.8191);
  const auto image_in = [&](const Point& p, double cells) {
    return image(p, cell, int(between(-cells, cells)), int(between(-cells, cells)));
  };
  for (int cloud = 0; cloud < 40; ++cloud) {
    std::vector<Point> points;
    for (int i = 0; i < 120; ++i)
      points.push_back(image_in(Point(between(0, 1), between(0, 1)), 4));
    for (int cluster = 0; cluster < 3; ++cluster) {
      const double x = between(0, 1), y = between(0, 1), size = 0x1p-37 * between(0.5, 4);
      for (int i = 0; i < 8; ++i)
        points.push_back(
            image_in(Point(x + between(-size, size), y + between(-size, size)), 0x1p16));
    }
    const Triangulation pt(points, cell);
    ASSERT_TRUE(pt.is_valid()) << cloud;
    if (cloud < 5) {
      ASSERT_NO_FATAL_FAILURE(expect_periodic_delaunay(pt)) << cloud;
    }
  }
}

TEST(A_builder, has_a_result_for_points_all_over_the_cell_and_none_for_a_grid)
{
  std::mt19937_64 random(43);
  const internal::Torus_2 torus(Cell(20, 5, 1, 20));
  internal::Torus_triangulator_2<> builder;
  const auto run = [&](const std::vector<Point>& points) {
    std::vector<Position_2> positions;
    for (const Point& p : points)
      positions.push_back({p.x(), p.y()});
    return builder.run(torus, positions);
  };
  for (const std::size_t number : {100u, 300u, 3000u}) {
    EXPECT_TRUE(run(random_points(random, number, 400))) << number;
    EXPECT_EQ(builder.faces().apexes.size(), 6 * number);
  }
  EXPECT_FALSE(run(random_points(random, 99, 400)));
  EXPECT_FALSE(run(random_points(random, 300, 0.1)));
  EXPECT_FALSE(run(std::vector<Point>(200, Point(1, 1))));
}

TEST(A_frame_in_which_everything_breaks, is_triangulated_anew_at_once)
{
  std::mt19937_64 random(44);
  Visited<Ledger> pt(random_points(random, 120, 20), Cell(20, 20));
  const CGAL::Update_report_2 report = pt.update(random_points(random, 120, 20));
  EXPECT_EQ(report.rebuild_reason, CGAL::Rebuild_reason_2::TOO_MUCH_BROKEN);
  EXPECT_EQ(report.flips, 0u);
  ASSERT_NO_FATAL_FAILURE(expect_periodic_delaunay(pt));
  EXPECT_EQ(pt.visitor().edges(), edges_both_ways(pt));
}

TEST(A_stream, in_which_all_go_far_together_is_followed_by_flips)
{
  std::mt19937_64 random(45);
  std::vector<Point> points = random_points(random, 400, 20);
  Triangulation pt(points, Cell(20, 20));
  for (int frame = 0; frame < 10; ++frame) {
    for (Point& p : points) // two halves against each other, a spacing a frame
      p = Point(p.x() + 0.7 * std::sin(p.y() * 3.14159265358979 / 10), p.y());
    EXPECT_FALSE(pt.update(points).rebuilt());
    ASSERT_TRUE(pt.is_valid());
  }
}

// SAFE EDGES --------------------------------------------------------------------------------------

// Skips edges as the default classifier does, and counts the frames in which it does.
class Skipping_classifier
{
public:
  static constexpr bool is_exact = true;

  template <class Frame, class Classification>
  void operator()(const Frame& frame, Classification& classified)
  {
    m_was_asked = true;
    if (m_schedule.is_near() && !m_safe_edges.holds())
      m_safe_edges.measure_step(frame);
    m_safe_edges.take_changes(frame);
    std::vector<Edge_index> unproved;
    const bool skips = m_safe_edges.holds() && m_safe_edges.append_unproved(frame, unproved);
    m_frames_skipping += skips;
    if (!skips)
      frame.append_unproved(0, frame.number_of_edges(), unproved);
    classified.add_unless_delaunay(frame, unproved);
  }

  template <class Frame>
  void after_update(const Frame& frame)
  {
    m_safe_edges.learn(frame);
    if (std::exchange(m_was_asked, false) && m_schedule.is_due(m_safe_edges.holds()) &&
        !frame.everything_is_new())
      m_safe_edges.start(frame, m_schedule.share());
  }

  std::size_t frames_skipping() const { return m_frames_skipping; }

private:
  internal::Safe_edges_2 m_safe_edges;
  internal::Safe_edges_schedule_2 m_schedule;
  bool m_was_asked = false;
  std::size_t m_frames_skipping = 0;
};

class Skipping
{
public:
  Skipping(const std::vector<Point>& points, const Cell& cell)
    : m_pt(points, cell)
  {
  }

  void update(const std::vector<Point>& points, const Cell& cell)
  {
    m_flips += m_pt.update(points, cell).flips;
    ASSERT_TRUE(m_pt.is_valid());
  }
  void move(std::size_t id, const Point& p) { m_pt.move(id, p); }

  std::size_t frames_skipping() const { return m_pt.classifier().frames_skipping(); }
  std::size_t flips() const { return m_flips; }

private:
  CGAL::Dynamic_periodic_Delaunay_triangulation_2<Kernel, Skipping_classifier> m_pt;
  std::size_t m_flips = 0;
};

TEST(Safe_edges_of_a_torus, are_skipped_in_calm_motion_which_stays_exact)
{
  std::mt19937_64 random(31);
  for (const Cell& cell : {Cell(20, 20), Cell(20, 3, -5, 20), Cell(Vector(20, 4))}) {
    std::vector<Point> points = random_points(random, 400, 20);
    Skipping triangulation(points, cell);
    for (int frame = 0; frame < 150; ++frame) {
      move_randomly(random, points, 2e-4);
      for (Point& p : points)
        if (random() % 2000 == 0) // the references of its edges get other shifts
          p = image(p, cell, int(random() % 3) - 1, cell.is_slab() ? 0 : int(random() % 3) - 1);
      if (frame % 40 == 39)
        points[random() % 400] = random_points(random, 1, 20)[0]; // one that jumps
      if (frame % 25 == 24) {
        const std::size_t id = random() % 400;
        points[id] = Point(points[id].x() + 0.2, points[id].y());
        triangulation.move(id, points[id]);
      }
      ASSERT_NO_FATAL_FAILURE(triangulation.update(points, cell)) << frame;
    }
    EXPECT_GT(triangulation.frames_skipping(), 50u);
    EXPECT_GT(triangulation.flips(), 20u);
  }
}

TEST(Safe_edges_of_a_torus, are_found_anew_around_points_that_jump_in_calm_motion)
{
  for (const std::uint64_t seed : {31u, 32u, 33u, 34u}) {
    std::mt19937_64 random(seed);
    const Cell cell = seed == 34 ? Cell(Vector(20, 0)) : Cell(20, 20);
    std::vector<Point> points = random_points(random, 400, 20);
    Skipping triangulation(points, cell);
    for (int frame = 0; frame < 300; ++frame) {
      move_randomly(random, points, 2e-4);
      if (frame % 2 == 0)
        points[random() % 400] = random_points(random, 1, 20)[0];
      ASSERT_NO_FATAL_FAILURE(triangulation.update(points, cell)) << seed << ' ' << frame;
    }
    EXPECT_GT(triangulation.frames_skipping(), 50u);
  }
}

// The reference of the point follows it to each image, so edges around it must be proved anew.
TEST(Safe_edges_of_a_torus, are_found_anew_around_a_point_that_walks_from_image_to_image)
{
  std::mt19937_64 random(35);
  const Cell cell(20, 20);
  std::vector<Point> points = random_points(random, 400, 20);
  Skipping triangulation(points, cell);
  for (int frame = 0; frame < 200; ++frame) {
    move_randomly(random, points, 1e-4);
    if (frame > 40)
      points[7] = image(points[7] + Vector(0.004, 0), cell, frame % 2 == 0 ? 1 : -1, 0);
    ASSERT_NO_FATAL_FAILURE(triangulation.update(points, cell)) << frame;
  }
  EXPECT_GT(triangulation.frames_skipping(), 50u);
}

TEST(Safe_edges_of_a_torus, are_forgotten_where_the_cell_changes)
{
  std::mt19937_64 random(32);
  std::vector<Point> points = random_points(random, 400, 20);
  Skipping triangulation(points, Cell(20, 20));
  double width = 20;
  for (int frame = 0; frame < 120; ++frame) {
    move_randomly(random, points, 2e-4);
    if (frame % 30 == 29)
      width += 0.4; // points do not follow: what is across the boundary comes apart
    ASSERT_NO_FATAL_FAILURE(triangulation.update(points, Cell(width, 20))) << frame;
  }
  EXPECT_GT(triangulation.frames_skipping(), 30u);
}

TEST(An_edge_that_is_safe, stays_delaunay_wherever_its_corners_go_within_the_tolerance)
{
  using Slacks = internal::Periodic_slacks_2;
  using Images = internal::Edge_images_2;
  std::mt19937_64 random(33);
  std::size_t safe = 0;
  for (int i = 0; i < 20000; ++i) {
    const internal::Torus_2 torus(Cell(3, random_between(random, -1, 1), 0.5, 3));
    Images corners;
    for (internal::Image_2* image :
         {&corners.left, &corners.source, &corners.target, &corners.right})
      image->shift = {int(random() % 5) - 2, int(random() % 5) - 2};
    const auto place = [&](internal::Image_2& image, double x, double y) {
      const Position_2 way = torus.vector({double(image.shift[0]), double(image.shift[1])});
      image.position = {x - way.x, y - way.y};
    };
    place(corners.left, random_between(random, -1, 1), random_between(random, 0.01, 1));
    place(corners.source, -1, 0);
    place(corners.target, 1, 0);
    place(corners.right, random_between(random, -1, 1), random_between(random, -1, -0.01));
    const double tolerance = std::pow(10.0, random_between(random, -15, 0));
    if (!Slacks::is_safe(torus, corners, tolerance))
      continue;
    ++safe;
    for (int k = 0; k < 5; ++k) {
      Images moved = corners;
      for (internal::Image_2* image : {&moved.left, &moved.source, &moved.target, &moved.right}) {
        const double angle = random_between(random, 0, 6.3);
        image->position = {image->position.x + tolerance * 0.999999 * std::cos(angle),
                           image->position.y + tolerance * 0.999999 * std::sin(angle)};
      }
      // only the side of the circle is promised; orientations of faces depend on all edges
      const Edge_state_2 state = torus.edge_state(moved);
      EXPECT_TRUE(state == Edge_state_2::DELAUNAY || state == Edge_state_2::NOT_FLIPPABLE);
    }
  }
  EXPECT_GT(safe, 1000u);
}

// VISITORS ----------------------------------------------------------------------------------------

using Changes = CGAL::Periodic_edge_changes_visitor_2;
using Watched = Visited<Changes>;

TEST(Neighbor_exchanges, are_one_edge_for_another)
{
  // the wide diagonal of a rhombus of points gives way to the other one
  std::vector<Point> points{Point(1, 2), Point(3, 2), Point(2, 1.2), Point(2, 2.8)};
  Watched pt(points, Cell(4, 4));
  pt.visitor().clear();
  points[2] = Point(2, 0.8);
  points[3] = Point(2, 3.2);
  pt.update(points);
  const Changes::Edge wide{0, 1, {0, 0}}, tall{2, 3, {0, 0}};
  const auto& created = pt.visitor().created_edges();
  const auto& removed = pt.visitor().removed_edges();
  EXPECT_EQ(std::count(created.begin(), created.end(), wide), 1);
  EXPECT_EQ(std::count(removed.begin(), removed.end(), tall), 1);
  EXPECT_EQ(created.size(), removed.size());
}

TEST(Edge_changes, are_none_where_points_are_wrapped_and_cells_exchanged)
{
  std::mt19937_64 random(25);
  const std::vector<Point> points = random_points(random, 30, 4);
  Watched pt(points, Cell(4, 4));
  pt.visitor().clear();
  std::vector<Point> wrapped;
  for (std::size_t i = 0; i < points.size(); ++i)
    wrapped.push_back(image(points[i], pt.cell(), int(i % 3) - 1, int(i % 5) - 2));
  pt.update(wrapped);
  pt.update(wrapped, Cell(4, 0, 4, 4));
  EXPECT_TRUE(pt.visitor().created_edges().empty());
  EXPECT_TRUE(pt.visitor().removed_edges().empty());
}

TEST(Edge_changes, of_a_point_and_its_own_images_cancel_where_the_vectors_of_the_cell_turn_round)
{
  const std::vector<Point> points{Point(0.5, 0.5)};
  Watched pt(points, Cell(1, 0, 0.2, 1));
  pt.update(points, Cell(-1, 0, -0.2, -1));
  pt.update(points, Cell(-1, 0, 0.2, -1)); // the third edge is another one
  std::set<Directed_edge> edges;
  for (const Changes::Edge& e : pt.visitor().created_edges()) {
    edges.insert({e.i, e.j, e.shift});
    edges.insert(reversed({e.i, e.j, e.shift}));
  }
  EXPECT_EQ(edges, edges_both_ways(pt));
  EXPECT_TRUE(pt.visitor().removed_edges().empty());
}

TEST(Edge_changes, are_as_many_where_points_that_go_far_are_wrapped_as_where_they_are_not)
{
  std::mt19937_64 random(27);
  // few go so far that they are taken out before the motion
  std::normal_distribution<double> calm(0, 0.02), far(0, 0.6);
  std::vector<Point> points = random_points(random, 40, 4);
  const Cell cell(4, 4);
  Watched wrapped(points, cell), free(points, cell);
  for (int frame = 0; frame < 30; ++frame) {
    wrapped.visitor().clear();
    free.visitor().clear();
    std::vector<Point> images;
    for (Point& p : points) {
      auto& step = images.size() % 13 == 0 ? far : calm;
      p = Point(p.x() + step(random), p.y() + step(random));
      images.push_back(image(p, cell, -int(std::floor(p.x() / 4)), -int(std::floor(p.y() / 4))));
    }
    wrapped.update(images);
    free.update(points);
    EXPECT_EQ(wrapped.visitor().created_edges().size(), free.visitor().created_edges().size());
    EXPECT_EQ(wrapped.visitor().removed_edges().size(), free.visitor().removed_edges().size());
  }
}

TEST(Edge_changes, turn_the_edges_of_before_into_those_of_now)
{
  std::mt19937_64 random(26);
  for (const Cell& cell : {Cell(3, 3), Cell::slab(3, 0.5)}) {
    std::vector<Point> points = random_points(random, 25, 3);
    Watched pt(points, cell);
    for (int frame = 0; frame < 20; ++frame) {
      auto edges = edges_both_ways(pt);
      pt.visitor().clear();
      move_randomly(random, points, 0.1); // never wrapped, so no edge gets another name
      pt.update(points);
      for (const Changes::Edge& e : pt.visitor().removed_edges()) {
        EXPECT_EQ(edges.erase({e.i, e.j, e.shift}), 1u);
        EXPECT_EQ(edges.erase(reversed({e.i, e.j, e.shift})), 1u);
      }
      for (const Changes::Edge& e : pt.visitor().created_edges()) {
        edges.insert({e.i, e.j, e.shift});
        edges.insert(reversed({e.i, e.j, e.shift}));
      }
      ASSERT_EQ(edges, edges_both_ways(pt));
    }
  }
}

TEST(Edge_changes, of_a_checkpoint_are_all_edges_also_where_a_slab_becomes_a_torus)
{
  std::mt19937_64 random(28);
  const auto checkpoint = [&](std::size_t points, const Cell& cell) {
    std::ostringstream file;
    file << Triangulation(random_points(random, points, 3), cell);
    return file.str();
  };
  const std::string torus = checkpoint(20, Cell(3, 0, 1, 3)),
                    slab = checkpoint(15, Cell(Vector(3, 1))), empty = checkpoint(0, Cell(1, 1));
  Visited<Ledger> pt(random_points(random, 10, 3), Cell(3, 3));
  for (const std::string* text : {&slab, &torus, &torus, &slab, &slab, &empty, &slab}) {
    std::istringstream file(*text);
    ASSERT_TRUE(file >> pt);
    ASSERT_EQ(pt.visitor().edges(), edges_both_ways(pt));
    pt.insert(Point(1, 1));
    ASSERT_EQ(pt.visitor().edges(), edges_both_ways(pt));
  }
}

struct Thrower : CGAL::Delaunay_update_visitor_base_2
{
  template <class Dynamic>
  void before_update(const Dynamic&)
  {
    if (throws_before)
      throw std::runtime_error("before");
  }
  template <class Dynamic>
  void after_edge_creation(const Dynamic&, std::size_t, std::size_t, const CGAL::Periodic_shift_2&)
  {
    if (throws_after)
      throw std::runtime_error("after");
  }
  bool throws_before = false, throws_after = false;
};

TEST(A_visitor_that_throws, changes_nothing_or_hears_no_more)
{
  Visited<Thrower> pt(Cell(2, 2));
  pt.insert(Point(0, 0));
  pt.visitor().throws_before = true;
  EXPECT_THROW(pt.insert(Point(1, 1)), std::runtime_error);
  EXPECT_EQ(pt.number_of_points(), 1u);
  pt.visitor().throws_before = false;
  pt.visitor().throws_after = true;
  EXPECT_THROW(pt.insert(Point(1, 1)), std::runtime_error);
  ASSERT_NO_FATAL_FAILURE(expect_periodic_delaunay(pt));
  EXPECT_EQ(pt.number_of_points(), 2u);

  std::stringstream file;
  file << pt;
  pt.visitor().throws_after = false;
  pt.remove(1);
  pt.visitor().throws_before = true;
  EXPECT_THROW(pt.read_checkpoint(file), std::runtime_error);
  EXPECT_EQ(pt.number_of_points(), 1u);
  file.seekg(0);
  pt.visitor().throws_before = false;
  pt.visitor().throws_after = true;
  EXPECT_THROW(pt.read_checkpoint(file), std::runtime_error);
  ASSERT_NO_FATAL_FAILURE(expect_periodic_delaunay(pt));
  EXPECT_EQ(pt.number_of_points(), 2u);
}

// POPULATIONS -------------------------------------------------------------------------------------

TEST(A_population, comes_and_goes_under_its_own_ids_while_the_cell_changes)
{
  using Population = CGAL::Dynamic_population_2<Triangulation, int>;
  std::mt19937_64 random(27);
  Population population(Triangulation(Cell(3, 3)));
  std::map<int, Point> points;
  for (int frame = 0; frame < 60; ++frame) {
    for (auto it = points.begin(); it != points.end();)
      it = random() % 5 == 0 ? points.erase(it) : std::next(it);
    for (auto& [id, p] : points)
      p = image(Point(p.x() + random_between(random, -0.1, 0.1), p.y()),
                population.triangulation().cell(), int(random() % 3) - 1, 0);
    for (std::size_t i = random() % 8; i-- > 0;)
      points[int(random() % 1000)] = random_points(random, 1, 3)[0];
    const std::vector<std::pair<int, Point>> given(points.begin(), points.end());
    if (frame % 2 == 0)
      population.update(given);
    else if (frame % 4 == 1)
      population.update(given, Cell(3, 0.01 * frame, 0, 3));
    else
      population.update(given.begin(), given.end(), Cell(3, 0.01 * frame, 0, 3));
    ASSERT_NO_FATAL_FAILURE(expect_periodic_delaunay(population.triangulation())) << frame;
    ASSERT_EQ(population.size(), points.size());
    for (const auto& [id, p] : points)
      ASSERT_EQ(population.point(id), p);
  }
}

// The point that leaves is too many of the small cells away from the origin to be in range.
TEST(A_population, takes_a_frame_in_whose_cell_a_point_that_has_left_could_not_be)
{
  CGAL::Dynamic_population_2<Triangulation> population(Triangulation(Cell(1000, 1000)));
  using Frame = std::vector<std::pair<std::int64_t, Point>>;
  population.update(Frame{{1, Point(1, 1)}, {2, Point(900, 900)}, {3, Point(5, 5)}});
  population.update(Frame{{1, Point(1e-4, 1e-4)}, {3, Point(5e-4, 2e-4)}}, Cell(5e-4, 5e-4));
  EXPECT_TRUE(population.has(1) && !population.has(2) && population.has(3));
  ASSERT_NO_FATAL_FAILURE(expect_periodic_delaunay(population.triangulation()));
}

// With so few points a removal may triangulate all the others anew, before they move.
TEST(A_population, of_a_few_points_that_coincide_leave_and_come_is_right_in_every_frame)
{
  for (const std::uint64_t seed : {1u, 2u, 3u}) {
    std::mt19937_64 random(seed);
    const std::vector<Point> places = random_points(random, 12, 0.45);
    CGAL::Dynamic_population_2<Triangulation> population{Triangulation(Cell(1, 1))};
    for (int frame = 0; frame < 300; ++frame) {
      std::map<std::size_t, Point> points;
      for (std::size_t size = random() % 20; points.size() < size;)
        points[random() % 30] = places[random() % 12];
      const std::vector<std::pair<std::size_t, Point>> all(points.begin(), points.end());
      population.update(all);
      ASSERT_TRUE(population.triangulation().is_valid() &&
                  population.triangulation().is_certified())
          << frame;
    }
  }
}

// A point that leaves keeps its old position until its removal, and so seems to jump in the flow.
TEST(A_population, loses_points_while_all_others_flow_in_cells_and_slabs_that_change)
{
  for (const std::uint64_t seed : {1u, 2u, 3u, 4u, 5u, 6u}) {
    std::mt19937_64 random(seed);
    const auto cell = [&](int frame) {
      const double growth = 1 + 0.01 * frame;
      return seed % 2 == 0 ? Cell::slab(8 * growth, 0.3 * frame)
                           : Cell(8 * growth, 0.1 * frame, 2 * growth, 5 * growth);
    };
    std::vector<Point> points = random_points(random, 80, 5);
    CGAL::Dynamic_population_2<Triangulation> population{Triangulation(cell(0))};
    std::size_t first = 0;
    for (int frame = 0; frame < 20; ++frame, first += random() % 4) {
      std::vector<std::pair<std::size_t, Point>> all;
      for (std::size_t i = first; i < points.size(); ++i) {
        points[i] = Point(points[i].x() + 1, points[i].y() + random_between(random, -0.02, 0.02));
        all.emplace_back(i, points[i]);
      }
      population.update(all, cell(frame));
      ASSERT_TRUE(population.triangulation().is_valid() &&
                  population.triangulation().is_certified())
          << seed << ' ' << frame;
      ASSERT_EQ(population.triangulation().number_of_points(), all.size());
    }
  }
}

// EVERYTHING AT RANDOM --------------------------------------------------------------------------

void operate_randomly(std::uint64_t seed)
{
  Random_operations<Visited<Ledger>> operations(seed, seed % 10 == 0 ? 200 : 12);
  const auto& pt = operations.triangulation();
  for (int i = 0; i < 200; ++i) {
    ASSERT_NO_FATAL_FAILURE(operations.step());
    ASSERT_NO_FATAL_FAILURE(operations.expect_points());
    ASSERT_TRUE(pt.is_valid()) << i;
    ASSERT_EQ(pt.visitor().edges(), edges_both_ways(pt)) << i;
    if (i % 20 == 0) {
      ASSERT_NO_FATAL_FAILURE(expect_periodic_delaunay(pt)) << i;
    }
  }
}

TEST(Random_operations, end_exactly_delaunay)
{
  const char* const more = std::getenv("PERIODIC_RUNS");
  const std::uint64_t runs = more ? std::strtoull(more, nullptr, 10) : 20;
  for (std::uint64_t seed = 1; seed <= runs; ++seed)
    ASSERT_NO_FATAL_FAILURE(operate_randomly(seed)) << "seed " << seed;
}

// A step takes vertices out, and leaves their edges empty; in the next one nearly all edges break.
TEST(Random_operations, end_exactly_delaunay_where_all_breaks_after_a_step)
{
  operate_randomly(800);
}

// The digest of a motion with edges across the border of an oblique cell.
TEST(Every_processor, leads_to_the_same_bits)
{
  Exact_steps steps;
  auto points = steps.start(500, 16);
  Triangulation pt(points, Cell(Vector(16, 0.375), Vector(2.625, 16)));
  Digest digest;
  for (int frame = 0; frame < 100; ++frame) {
    steps.move(points, frame);
    const auto report = pt.update(points);
    add_frame<internal::Periodic_slacks_2>(digest, report, pt.frame());
  }
  EXPECT_EQ(digest.value(), 7141187709968212301u);
}

} // namespace test_periodic

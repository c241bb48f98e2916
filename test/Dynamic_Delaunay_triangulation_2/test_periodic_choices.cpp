// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Classifiers, repairs and policies in periodic space: the same classes as in the plane.

#include "periodic_oracle.h"

#include <CGAL/Dynamic_Delaunay_triangulation_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/classifiers/Estimated_voronoi_circumcenter_classifier_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/classifiers/Inflation_aware_classifier_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/classifiers/Nearly_delaunay_classifier_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/classifiers/Point_distance_classifier_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/classifiers/Predictive_point_distance_classifier_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/classifiers/Random_classifier_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/classifiers/Refined_classifier_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/classifiers/Safe_region_classifier_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/classifiers/Voronoi_circumcenter_classifier_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/classifiers/Voronoi_edge_length_classifier_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/policies/Always_static_policy_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/policies/Hybrid_policy_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/policies/Key_frame_policy_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/repairs/Border_splice_repair_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/repairs/Flip_repair_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/repairs/Rebuild_repair_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/repairs/Relocation_repair_2.h>
#include <CGAL/Dynamic_periodic_Delaunay_triangulation_2.h>
#include <CGAL/Dynamic_population_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <random>
#include <set>
#include <sstream>
#include <stdexcept>
#include <tuple>
#include <utility>
#include <vector>

namespace test_periodic_choices {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_2;
using Vector = Kernel::Vector_2;
using Cell = CGAL::Periodic_cell_2;
using Shift = CGAL::Periodic_shift_2;
using Reason = CGAL::Rebuild_reason_2;

template <class Classifier, class Repair = CGAL::Default, class Policy = CGAL::Default>
using Triangulation =
    CGAL::Dynamic_periodic_Delaunay_triangulation_2<Kernel, Classifier, CGAL::With_repair_2<Repair>,
                                                    CGAL::With_policy_2<Policy>>;

// Points in a square, which move at random.
class Cloud
{
public:
  Cloud(std::uint64_t seed, std::size_t number, double side)
    : m_random(seed)
    , m_side(side)
  {
    for (std::size_t i = 0; i < number; ++i)
      points.push_back(anywhere());
  }

  Point anywhere()
  {
    const double x = between(0, m_side);
    return Point(x, between(0, m_side));
  }

  void shake(double step)
  {
    std::normal_distribution<double> way(0, step);
    for (Point& p : points) {
      const double dx = way(m_random);
      p = p + Vector(dx, way(m_random));
    }
  }

  // Replaces some points by other images of them.
  void wrap(const Cell& cell)
  {
    for (Point& p : points)
      if (m_random() % 50 == 0) {
        const double i = double(m_random() % 3) - 1;
        const double j = cell.is_slab() ? 0 : double(m_random() % 3) - 1;
        p = p + Vector(i * cell.ax() + j * cell.bx(), i * cell.ay() + j * cell.by());
      }
  }

  void jump() { points[m_random() % points.size()] = anywhere(); }
  double between(double low, double high)
  {
    return std::uniform_real_distribution<double>(low, high)(m_random);
  }

  std::vector<Point> points;

private:
  std::mt19937_64 m_random;
  double m_side;
};

// CLASSIFIERS -------------------------------------------------------------------------------------

template <class Classifier>
class An_exact_classifier : public testing::Test
{
};
using Exact_classifiers = testing::Types<
    CGAL::Circumcircle_classifier_2, CGAL::Safe_region_classifier_2,
    CGAL::Refined_classifier_2<CGAL::Safe_region_classifier_2, CGAL::Circumcircle_classifier_2>>;
TYPED_TEST_SUITE(An_exact_classifier, Exact_classifiers);

TYPED_TEST(An_exact_classifier, ends_each_frame_with_a_certificate)
{
  for (const Cell& cell : {Cell(20, 20), Cell(20, 3, -5, 20), Cell(Vector(20, 4))}) {
    Cloud cloud(1, 300, 20);
    Triangulation<TypeParam> pt(cloud.points, cell);
    for (int frame = 0; frame < 40; ++frame) {
      cloud.shake(frame % 20 < 15 ? 0.001 : 0.1);
      cloud.wrap(cell);
      if (frame % 4 == 0)
        cloud.jump();
      EXPECT_TRUE(pt.update(cloud.points).certified);
      ASSERT_TRUE(pt.is_certified() && pt.is_valid()) << frame;
    }
  }
}

TYPED_TEST(An_exact_classifier, forgets_what_it_has_proved_where_the_cell_changes)
{
  Cloud cloud(2, 300, 20);
  Triangulation<TypeParam> pt(cloud.points, Cell(20, 20));
  double width = 20;
  for (int frame = 0; frame < 100; ++frame) {
    if (frame % 25 == 24)
      width += 0.3; // points do not follow: what is across the boundary comes apart
    pt.update(cloud.points, Cell(width, 20));
    ASSERT_TRUE(pt.is_valid()) << frame;
  }
}

TYPED_TEST(An_exact_classifier, works_for_few_points)
{
  for (std::size_t number = 0; number < 6; ++number) {
    Cloud cloud(3, number, 2);
    Triangulation<TypeParam> pt(cloud.points, Cell(2, 0.5, 0, 2));
    for (int frame = 0; frame < 24; ++frame) {
      cloud.shake(frame < 12 ? 0.01 : 0.5);
      pt.update(cloud.points);
      ASSERT_NO_FATAL_FAILURE(expect_periodic_delaunay(pt)) << number << ' ' << frame;
    }
  }
}

template <class Classifier>
class A_heuristic_classifier : public testing::Test
{
};
using Heuristic_classifiers = testing::Types<
    CGAL::Point_distance_classifier_2, CGAL::Inflation_aware_classifier_2,
    CGAL::Voronoi_circumcenter_classifier_2, CGAL::Estimated_voronoi_circumcenter_classifier_2,
    CGAL::Voronoi_edge_length_classifier_2, CGAL::Random_classifier_2,
    CGAL::Nearly_delaunay_classifier_2,
    CGAL::Refined_classifier_2<CGAL::Point_distance_classifier_2, CGAL::Circumcircle_classifier_2>>;
TYPED_TEST_SUITE(A_heuristic_classifier, Heuristic_classifiers);

TYPED_TEST(A_heuristic_classifier, leaves_a_torus_and_says_what_it_does_not_know)
{
  std::size_t uncertified = 0;
  for (const Cell& cell : {Cell(20, 20), Cell(20, 3, -5, 20), Cell(Vector(20, 4))}) {
    Cloud cloud(4, 300, 20);
    Triangulation<TypeParam> pt(cloud.points, cell);
    EXPECT_TRUE(pt.is_certified());
    for (int frame = 0; frame < 30; ++frame) {
      cloud.shake(0.02);
      cloud.wrap(cell);
      if (frame % 10 == 9)
        cloud.jump();
      const CGAL::Update_report_2 report = pt.update(cloud.points);
      EXPECT_EQ(report.certified, pt.is_certified());
      uncertified += !report.certified;
      ASSERT_TRUE(pt.is_valid()) << frame;
      ASSERT_EQ(pt.number_of_points(), 300u);
    }
    const bool was_delaunay = pt.certify();
    EXPECT_EQ(was_delaunay, pt.is_certified());
    const CGAL::Update_report_2 report = pt.mend();
    EXPECT_EQ(was_delaunay, report.flips == 0 && !report.rebuilt());
    ASSERT_TRUE(pt.is_certified() && pt.is_valid());
  }
  EXPECT_GT(uncertified, 30u);
}

// Expects a valid torus from which a program can go on, also by a checkpoint of it.
template <class Dynamic>
void expect_torus(const Dynamic& pt)
{
  ASSERT_TRUE(pt.is_valid());
  std::stringstream file;
  pt.write_checkpoint(file);
  Dynamic(pt.cell()).read_checkpoint(file);
}

TYPED_TEST(A_heuristic_classifier, leaves_a_torus_where_the_cell_changes_its_orientation)
{
  Cloud cloud(7, 30, 2);
  Triangulation<TypeParam> pt(cloud.points, Cell(4, 1));
  for (const Cell& cell : {Cell(0, 2, 2, 0), Cell(2, 2), Cell(-0.6, 0, 0, 0.6), Cell(0, 1, 1, 0)}) {
    pt.update(cloud.points, cell);
    ASSERT_NO_FATAL_FAILURE(expect_torus(pt));
    pt.update(cloud.points);
    ASSERT_NO_FATAL_FAILURE(expect_torus(pt));
  }
}

// The vectors of the new lattice that are nearest to those of the first cell are multiples of
// (1, 2) and (0, 1), which have the other orientation.
TYPED_TEST(A_heuristic_classifier,
           leaves_a_torus_where_the_nearest_vectors_have_another_orientation)
{
  Cloud cloud(8, 30, 1);
  Triangulation<TypeParam> pt(cloud.points, Cell(0.4, 0.6, 0.9, 1.6));
  pt.update(cloud.points, Cell(1, 1));
  ASSERT_NO_FATAL_FAILURE(expect_torus(pt));
}

TYPED_TEST(A_heuristic_classifier, leaves_a_torus_whatever_cells_follow_each_other)
{
  Cloud cloud(9, 12, 2);
  Triangulation<TypeParam> pt(cloud.points, Cell(2, 2));
  for (int frame = 0; frame < 200; ++frame) {
    const auto number = [&] { return cloud.between(-2, 2); };
    const double ax = number(), ay = number(), bx = number();
    pt.update(cloud.points, Cell(ax, ay, bx, number()));
    ASSERT_NO_FATAL_FAILURE(expect_torus(pt)) << frame;
  }
}

TYPED_TEST(A_heuristic_classifier, is_followed_by_a_repair_of_all_where_points_come_and_go)
{
  Cloud cloud(5, 30, 6);
  Triangulation<TypeParam> pt(cloud.points, Cell(6, 6));
  for (int frame = 0; frame < 30; ++frame) {
    cloud.shake(0.1);
    pt.update(cloud.points);
    switch (frame % 3) {
    case 0:
      cloud.points.push_back(cloud.anywhere());
      EXPECT_EQ(pt.insert(cloud.points.back()), cloud.points.size() - 1);
      break;
    case 1:
      pt.remove(cloud.points.size() - 1);
      cloud.points.pop_back();
      EXPECT_EQ(pt.number_of_points(), cloud.points.size());
      pt.insert(cloud.anywhere());
      cloud.points.push_back(pt.point(cloud.points.size()));
      break;
    default:
      cloud.points[7] = cloud.anywhere();
      pt.move(7, cloud.points[7]);
    }
    ASSERT_TRUE(pt.is_certified());
    ASSERT_NO_FATAL_FAILURE(expect_periodic_delaunay(pt)) << frame;
  }
}

TYPED_TEST(A_heuristic_classifier, works_for_few_points_and_for_points_that_coincide)
{
  for (std::size_t number = 0; number < 6; ++number) {
    Cloud cloud(6, number, 2);
    const Cell cell(2, 0.5, 0, 2);
    Triangulation<TypeParam> pt(cloud.points, cell);
    for (int frame = 0; frame < 30; ++frame) {
      cloud.shake(frame < 15 ? 0.01 : 0.5);
      if (number > 1 && frame % 6 < 3) // comes, stays and leaves; by a translation
        cloud.points[1] = cloud.points[0] + Vector(cell.ax(), cell.ay());
      pt.update(cloud.points);
      ASSERT_TRUE(pt.is_valid()) << number << ' ' << frame;
      if (frame % 5 == 4) {
        pt.mend();
        ASSERT_NO_FATAL_FAILURE(expect_periodic_delaunay(pt)) << number << ' ' << frame;
      }
    }
  }
}

// Going back to the first cell counts as shear beyond it, not as the inverse of the shear before.
// So edges that are never repaired have more cells between their ends with each frame.
TEST(A_random_classifier, that_names_nobody_leaves_a_torus_while_cells_are_exchanged_in_turn)
{
  Cloud cloud(10, 20, 1);
  Triangulation<CGAL::Random_classifier_2> pt(cloud.points, Cell(1, 1),
                                              CGAL::Random_classifier_2(0));
  int most = 0;
  for (int frame = 0; frame < 50; ++frame) {
    for (const Cell& cell :
         {Cell(1.4, 0.55, 0, 1), Cell(1, 1), Cell(1, 0, 0.55, 1.4), Cell(1, 1)}) {
      pt.update(cloud.points, cell);
      ASSERT_NO_FATAL_FAILURE(expect_torus(pt)) << frame;
    }
    pt.for_each_edge([&](std::size_t, std::size_t, const Shift& shift) {
      most = (std::max)({most, std::abs(shift[0]), std::abs(shift[1])});
    });
  }
  EXPECT_GT(most, 1 << 20);
  pt.mend();
  ASSERT_NO_FATAL_FAILURE(expect_periodic_delaunay(pt));
}

// Points are located where all is Delaunay: among inverted faces a walk may never end.
TEST(A_random_classifier, that_names_nobody_is_followed_by_a_repair_of_all_where_points_come)
{
  using Careless = Triangulation<CGAL::Random_classifier_2>;
  std::size_t flips = 0;
  for (const Cell& cell : {Cell(20, 20), Cell(20, 3, -5, 20), Cell(Vector(20, 4))})
    for (std::uint64_t seed = 0; seed < 10; ++seed) {
      Cloud cloud(seed, 20, 20);
      CGAL::Dynamic_population_2<Careless> population{Careless(cell, CGAL::Random_classifier_2(0))};
      for (int frame = 0; frame < 42; ++frame) {
        cloud.shake(0.4);
        if (frame % 20 == 1)
          cloud.points.push_back(cloud.anywhere());
        std::vector<std::pair<std::size_t, Point>> places;
        for (std::size_t i = 0; i < cloud.points.size(); ++i)
          places.push_back({i, cloud.points[i]});
        flips += population.update(places).flips;
        ASSERT_TRUE(population.triangulation().is_valid()) << seed << ' ' << frame;
      }
      EXPECT_EQ(population.triangulation().number_of_points(), 23u);
    }
  EXPECT_GT(flips, 1000u);
}

// WITHOUT A CERTIFICATE ---------------------------------------------------------------------------

template <class Dynamic>
void expect_that_empty_ranges_change_nothing(Dynamic& dt, const std::vector<Point>& moved)
{
  dt.update(moved);
  ASSERT_FALSE(dt.is_certified());
  const std::vector<Point> no_points;
  const std::vector<std::size_t> no_ids;
  const std::vector<std::pair<std::size_t, Point>> no_movers;
  for (const CGAL::Update_report_2& report :
       {dt.insert(no_points), dt.remove(no_ids), dt.move(no_movers)}) {
    EXPECT_FALSE(report.certified);
    EXPECT_EQ(report.flips, 0u);
  }
  EXPECT_FALSE(dt.is_certified());
  EXPECT_FALSE(dt.certify());
  dt.mend();
  dt.insert(no_points);
  EXPECT_TRUE(dt.is_certified());
}

TEST(An_empty_range, changes_nothing_after_a_heuristic_frame_in_any_space)
{
  Cloud cloud(41, 60, 10);
  const std::vector<Point> before = cloud.points;
  cloud.shake(0.5);
  CGAL::Dynamic_Delaunay_triangulation_2<Kernel, CGAL::Random_classifier_2> plane(
      before.begin(), before.end(), CGAL::Random_classifier_2(0));
  ASSERT_NO_FATAL_FAILURE(expect_that_empty_ranges_change_nothing(plane, cloud.points));
  for (const Cell& cell : {Cell(10, 10), Cell(Vector(10, 0))}) {
    Triangulation<CGAL::Random_classifier_2> pt(before, cell, CGAL::Random_classifier_2(0));
    ASSERT_NO_FATAL_FAILURE(expect_that_empty_ranges_change_nothing(pt, cloud.points));
  }
}

using Edges = std::set<std::tuple<std::size_t, std::size_t, Shift>>;

// All listed edges, in both directions.
template <class Periodic>
Edges edges_of(const Periodic& pt)
{
  Edges edges;
  pt.for_each_edge([&](std::size_t i, std::size_t j, const Shift& shift) {
    edges.emplace(i, j, shift);
    edges.emplace(j, i, Shift{-shift[0], -shift[1]});
  });
  return edges;
}

// The sides of all listed faces, counterclockwise.
template <class Periodic>
Edges sides_of(const Periodic& pt)
{
  Edges sides;
  pt.for_each_face([&](const auto& ids, const auto& shifts) {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t k = (i + 1) % 3;
      sides.emplace(ids[i], ids[k],
                    Shift{shifts[k][0] - shifts[i][0], shifts[k][1] - shifts[i][1]});
    }
  });
  return sides;
}

template <class Periodic>
Triangulation<CGAL::Circumcircle_classifier_2> fresh(const Periodic& pt)
{
  std::vector<Point> points;
  for (std::size_t id = 0; id < pt.number_of_ids(); ++id)
    points.push_back(pt.point(id));
  return Triangulation<CGAL::Circumcircle_classifier_2>(points, pt.cell());
}

// An edge across the gap, which nobody sees, was not Delaunay.
TEST(A_slab, is_certified_where_all_listed_edges_are_delaunay)
{
  std::vector<Point> points{Point(0, 0),      Point(0.5, 0),    Point(0.25, 0.5),
                            Point(0.75, 0.5), Point(0.0625, 1), Point(0.5625, 1)};
  Triangulation<CGAL::Random_classifier_2> pt(points, Cell(Vector(1, 0)),
                                              CGAL::Random_classifier_2(0));
  points[4] = Point(-0.0625, 1);
  points[5] = Point(0.4375, 1);
  EXPECT_FALSE(pt.update(points).certified);
  const Edges edges = edges_of(pt);
  ASSERT_EQ(edges, edges_of(fresh(pt)));
  EXPECT_TRUE(pt.certify());
  EXPECT_EQ(edges_of(pt), edges);
  EXPECT_TRUE(pt.is_valid(true));
  ASSERT_NO_FATAL_FAILURE(expect_periodic_delaunay(pt));
  pt.insert(Point(0.3, 2));
  ASSERT_NO_FATAL_FAILURE(expect_periodic_delaunay(pt));
}

// A point of the side has gone into the slab. The flip that would mend it exchanges an edge across
// the gap for a listed one.
TEST(A_slab, whose_side_misses_an_edge_is_not_certified_by_adding_it)
{
  std::vector<Point> points{Point(0, 0), Point(0.3, 0), Point(0.7, 0),
                            Point(0, 1), Point(0.3, 1), Point(0.7, 1)};
  Triangulation<CGAL::Random_classifier_2> pt(points, Cell(Vector(1, 0)),
                                              CGAL::Random_classifier_2(0));
  points[5] = Point(0.7, 0.9375);
  EXPECT_FALSE(pt.update(points).certified);
  const Edges edges = edges_of(pt);
  ASSERT_NE(edges, edges_of(fresh(pt)));
  EXPECT_FALSE(pt.certify());
  EXPECT_EQ(edges_of(pt), edges);
  pt.mend();
  ASSERT_NO_FATAL_FAILURE(expect_periodic_delaunay(pt));
}

// Edges alone do not tell: if a strip is turned over, all its faces are clockwise.
TEST(A_slab, is_certified_if_and_only_if_its_edges_and_faces_are_those_of_a_fresh_one)
{
  int certified = 0, refused = 0, gaps = 0;
  for (std::uint64_t seed = 0; seed < 150; ++seed) {
    SCOPED_TRACE(seed);
    Cloud cloud(seed, seed % 3 == 0 ? 3 + seed % 17 : 3, 1);
    const Cell cell(seed % 2 == 0 ? Vector(1, 0) : Vector(-0.5, 1));
    Triangulation<CGAL::Point_distance_classifier_2> pt(
        cloud.points, cell, CGAL::Point_distance_classifier_2(seed % 4 == 0 ? 0.5 : 0.0));
    for (int frame = 0; frame < 6; ++frame) {
      cloud.shake(seed % 5 == 0 ? 0.2 : 0.03);
      cloud.wrap(cell);
      pt.update(cloud.points);
      const Edges edges = edges_of(pt), sides = sides_of(pt);
      const auto changes = pt.frame().new_edges();
      const auto expected = fresh(pt);
      const bool is_right = edges == edges_of(expected) && sides == sides_of(expected);
      const bool was_certified = pt.is_certified();
      ASSERT_EQ(pt.certify(), is_right) << frame;
      ASSERT_TRUE(edges_of(pt) == edges && sides_of(pt) == sides) << frame;
      ASSERT_TRUE(pt.is_valid(true)) << frame;
      certified += is_right && !was_certified;
      gaps += is_right && pt.frame().new_edges() != changes;
      refused += !is_right;
      if (is_right) {
        ASSERT_NO_FATAL_FAILURE(expect_periodic_delaunay(pt)) << frame;
      }
    }
  }
  EXPECT_GT(certified, 50);
  EXPECT_GT(refused, 50);
  EXPECT_GT(gaps, 5);
}

// The edges that no face has, and that the boundary does not visit in both directions.
template <class Periodic>
std::pair<std::size_t, std::size_t> edges_without_faces(const Periodic& pt)
{
  const Edges sides = sides_of(pt);
  Edges boundary;
  pt.for_each_boundary_edge(
      [&](std::size_t i, std::size_t j, const Shift& shift) { boundary.emplace(i, j, shift); });
  std::size_t without_faces = 0, not_twice = 0;
  for (const auto& [i, j, shift] : edges_of(pt))
    if (sides.count({i, j, shift}) == 0 && sides.count({j, i, {-shift[0], -shift[1]}}) == 0) {
      ++without_faces;
      not_twice += boundary.count({i, j, shift}) == 0;
    }
  return {without_faces / 2, not_twice};
}

TEST(An_uncertified_slab, may_have_edges_in_no_face_with_the_gap_on_both_sides)
{
  std::vector<Point> points;
  for (int i = 0; i < 8; ++i)
    points.emplace_back(i, 0);
  Triangulation<CGAL::Random_classifier_2> row(points, Cell(Vector(8, 0)),
                                               CGAL::Random_classifier_2(0));
  points[3] = Point(3, 0.5); // nobody names it: the row stays
  row.update(points);
  EXPECT_EQ(edges_without_faces(row), (std::pair<std::size_t, std::size_t>(8, 0)));
  EXPECT_FALSE(row.certify());
  row.mend();
  EXPECT_EQ(edges_without_faces(row).first, 0u);
}

// CLASSIFIERS AND POINTS THAT COME AND GO
// -----------------------------------------------------------

// Among few points a vertex may have several images of one neighbor around it. Then the polygon
// that it leaves cannot always be triangulated without doubling an edge.
TEST(A_random_classifier, that_names_nobody_loses_points_on_a_torus_of_few)
{
  using Careless = Triangulation<CGAL::Random_classifier_2>;
  for (std::uint64_t seed = 0; seed < 120; ++seed) {
    Cloud cloud(seed, 20, 1);
    CGAL::Dynamic_population_2<Careless> population{
        Careless(Cell(1, 1), CGAL::Random_classifier_2(0))};
    for (std::size_t frame = 0; frame < 20; ++frame) {
      std::vector<std::pair<std::size_t, Point>> places;
      for (std::size_t i = frame / 2; i < cloud.points.size(); ++i)
        places.push_back({i, cloud.points[i]});
      population.update(places);
      ASSERT_TRUE(population.triangulation().is_valid()) << seed << ' ' << frame;
      cloud.shake(0.25);
    }
  }
}

TEST(A_voronoi_circumcenter_classifier, finds_all_that_breaks_where_nothing_is_near_a_tie)
{
  for (const Cell& cell : {Cell(20, 20), Cell(20, 3, -5, 20), Cell(Vector(20, 4))}) {
    Cloud cloud(7, 300, 20);
    Triangulation<CGAL::Voronoi_circumcenter_classifier_2> pt(cloud.points, cell);
    for (int frame = 0; frame < 50; ++frame) {
      cloud.shake(0.02);
      cloud.wrap(cell);
      pt.update(cloud.points);
      ASSERT_TRUE(pt.certify()) << frame;
    }
  }
}

TEST(A_point_distance_classifier, with_x_of_1_examines_all_edges)
{
  Cloud cloud(8, 300, 20);
  Triangulation<CGAL::Point_distance_classifier_2> pt(cloud.points, Cell(20, 20),
                                                      CGAL::Point_distance_classifier_2(1));
  for (int frame = 0; frame < 50; ++frame) {
    cloud.shake(0.05);
    cloud.wrap(pt.cell());
    EXPECT_EQ(pt.update(cloud.points).classified, 300u);
    ASSERT_TRUE(pt.certify()) << frame;
  }
}

TEST(A_point_distance_classifier, names_no_vertex_while_all_flow_across_the_border)
{
  Cloud cloud(9, 300, 20);
  Triangulation<CGAL::Point_distance_classifier_2> pt(cloud.points, Cell(20, 20));
  for (int frame = 0; frame < 100; ++frame) {
    for (Point& p : cloud.points)
      p = Point(std::fmod(p.x() + 0.5, 20), p.y());
    EXPECT_EQ(pt.update(cloud.points).classified, 0u);
    ASSERT_TRUE(pt.certify());
  }
}

TEST(An_inflation_aware_classifier, names_no_vertex_while_the_cell_grows)
{
  Cloud cloud(10, 300, 20);
  const std::vector<Point> initial = cloud.points;
  Triangulation<CGAL::Inflation_aware_classifier_2> pt(cloud.points, Cell(20, 4, 0, 20));
  Triangulation<CGAL::Point_distance_classifier_2> sees_growth(cloud.points, Cell(20, 4, 0, 20));
  std::size_t seen = 0;
  for (int frame = 1; frame <= 50; ++frame) {
    const double scale = 1 + 0.02 * frame;
    for (std::size_t i = 0; i < initial.size(); ++i)
      cloud.points[i] = Point(initial[i].x() * scale, initial[i].y() * scale);
    const Cell cell(20 * scale, 4 * scale, 0, 20 * scale);
    EXPECT_EQ(pt.update(cloud.points, cell).classified, 0u);
    seen += sees_growth.update(cloud.points, cell).classified;
  }
  EXPECT_GE(seen, 300u);
  EXPECT_TRUE(pt.certify());
}

TEST(A_predictive_classifier, knows_the_velocities_of_points_across_the_border)
{
  struct Ways // with the members x and y
  {
    double x, y;
  };
  const auto velocity = [](std::size_t id) { return Ways{id % 2 == 0 ? 0.01 : -0.01, 0}; };
  using Predictive = CGAL::Predictive_point_distance_classifier_2<decltype(velocity)>;
  Cloud cloud(11, 200, 15);
  Triangulation<Predictive> predicts(cloud.points, Cell(15, 15), Predictive(velocity, 0.5));
  Triangulation<CGAL::Point_distance_classifier_2> looks(cloud.points, Cell(15, 15),
                                                         CGAL::Point_distance_classifier_2(0.5));
  for (int frame = 0; frame < 100; ++frame) {
    for (std::size_t id = 0; id < cloud.points.size(); ++id) {
      const double x = cloud.points[id].x() + velocity(id).x;
      cloud.points[id] = Point(x < 0 ? x + 15 : x >= 15 ? x - 15 : x, cloud.points[id].y());
    }
    ASSERT_EQ(predicts.update(cloud.points).classified, looks.update(cloud.points).classified)
        << frame;
  }
}

// What the manual's page on classifiers shows, with lengths that are right in both spaces.
struct Long_edges
{
  static constexpr bool is_exact = false;
  double limit = 2;

  template <class Frame, class Classification>
  void operator()(const Frame& frame, Classification& classified)
  {
    for (typename Frame::Edge_index e(0); e < frame.number_of_edges(); ++e) {
      const auto way = frame.edge_vector(e);
      if (way.x * way.x + way.y * way.y > limit * limit)
        classified.add_edge(e);
    }
  }
};

TEST(A_classifier_of_ones_own, sees_edges_across_the_border_as_short_as_they_are)
{
  Cloud cloud(12, 2000, 20);
  Triangulation<Long_edges> pt(cloud.points, Cell(20, 20), Long_edges{10});
  EXPECT_EQ(pt.update(cloud.points).classified, 0u);
  const auto frame = pt.frame();
  EXPECT_EQ(frame.number_of_edges(), 6000u);
  std::size_t across = 0;
  for (Triangulation<Long_edges>::Frame::Edge_index e(0); e < frame.number_of_edges(); ++e) {
    const auto corners = frame.corners(e);
    const auto way = frame.edge_vector(e);
    EXPECT_NEAR(corners.target.x - corners.source.x, way.x, 1e-12);
    EXPECT_NEAR(corners.target.y - corners.source.y, way.y, 1e-12);
    const auto &p = frame.position(frame.edge(e).source), &q = frame.position(frame.edge(e).target);
    across += std::abs(q.x - p.x - way.x) > 1 || std::abs(q.y - p.y - way.y) > 1;
    EXPECT_TRUE(frame.is_delaunay(e));
    for (const auto f : frame.faces_at(e)) {
      const auto face = frame.face(f);
      EXPECT_EQ(std::count(face.begin(), face.end(), frame.edge(e).source), 1);
    }
  }
  EXPECT_GT(across, 50u);
}

// Reads all that a frame offers.
struct Curious
{
  static constexpr bool is_exact = true;

  template <class Frame, class Classification>
  void operator()(const Frame& frame, Classification& classified)
  {
    using Edge_index = typename Frame::Edge_index;
    using Face_index = typename Frame::Face_index;
    using Vertex_index = typename Frame::Vertex_index;
    for (Face_index f(0); f < frame.number_of_faces(); ++f) {
      const auto corners = frame.face_corners(f);
      const auto vertices = frame.face(f);
      EXPECT_EQ(frame.is_infinite(vertices[0]), std::isnan(corners[0].x));
      for (const Vertex_index v : vertices)
        EXPECT_LE(v, frame.number_of_vertices());
    }
    for (Edge_index e(0); e < frame.number_of_edges(); ++e) {
      for (const Face_index f : frame.faces_at(e))
        EXPECT_LT(f, frame.number_of_faces());
      frame.for_each_side(e, [&](Edge_index side) { EXPECT_LT(side, frame.number_of_edges()); });
      EXPECT_FALSE(frame.is_infinite(frame.edge(e)));
      classified.add_unless_delaunay(frame, e);
    }
    for (Vertex_index v(1); v <= frame.number_of_vertices(); ++v) {
      frame.for_each_neighbor(v, [&](Vertex_index w) { EXPECT_LE(w, frame.number_of_vertices()); });
      EXPECT_FALSE(std::isnan(frame.previous_position(v).x));
    }
  }
};

TEST(A_classifier_of_ones_own, may_look_at_everything_where_points_jump)
{
  for (const Cell& cell : {Cell(10, 10), Cell(10, 2, 1, 10), Cell(Vector(10, 1))}) {
    Cloud cloud(14, 60, 10);
    Triangulation<Curious> pt(cloud.points, cell);
    for (int frame = 0; frame < 20; ++frame) {
      cloud.shake(0.05);
      cloud.jump();
      EXPECT_TRUE(pt.update(cloud.points).certified);
      ASSERT_TRUE(pt.is_valid());
    }
  }
}

struct Thrower
{
  static constexpr bool is_exact = true;
  std::shared_ptr<bool> throws = std::make_shared<bool>(false);
  CGAL::Circumcircle_classifier_2 classifier{};

  template <class Frame, class Classification>
  void operator()(const Frame& frame, Classification& classified)
  {
    if (*throws)
      throw std::runtime_error("refused");
    classifier(frame, classified);
  }
};

TEST(A_classifier_that_throws, changes_nothing)
{
  const std::array<std::vector<Cell>, 2> cells{
      {{Cell(10, 0, 1, 10), Cell(10, 0, 11, 10), Cell(10.1, 0, 1, 9.9), Cell(-11, -10, 10, 0)},
       {Cell(Vector(10, 1)), Cell(Vector(10.1, 1))}}};
  for (const std::vector<Cell>& all : cells) {
    Cloud cloud(13, 40, 10);
    // with the default repair a sample of edges may decide that everything is triangulated anew
    Triangulation<Thrower, CGAL::Border_splice_repair_2> pt(cloud.points, all[0]);
    for (std::size_t frame = 0; frame < 60; ++frame) {
      const Cell before = pt.cell(), cell = all[frame % all.size()];
      const std::vector<Point> points = cloud.points;
      const std::set<Directed_edge> edges = edges_both_ways(pt);
      cloud.shake(0.05);
      cloud.wrap(before);
      cloud.jump();
      *pt.classifier().throws = true;
      EXPECT_THROW(pt.update(cloud.points, cell), std::runtime_error);
      *pt.classifier().throws = false;
      ASSERT_TRUE(pt.is_certified() && pt.is_valid()) << frame;
      EXPECT_EQ(pt.cell(), before);
      for (std::size_t id = 0; id < points.size(); ++id)
        EXPECT_EQ(pt.point(id), points[id]);
      ASSERT_EQ(edges_both_ways(pt), edges) << frame;
      EXPECT_TRUE(pt.update(cloud.points, cell).certified);
      ASSERT_TRUE(pt.is_valid()) << frame;
    }
  }
}

struct Throwing_repair
{
  template <class Mender>
  void operator()(Mender&) const
  {
    throw std::runtime_error("refused");
  }
};

TEST(A_repair_that_throws, leaves_all_points_where_they_went_and_the_next_call_mends)
{
  Cloud cloud(13, 40, 10);
  Triangulation<CGAL::Circumcircle_classifier_2, Throwing_repair> pt(cloud.points, Cell(10, 10));
  cloud.shake(0.2);
  EXPECT_THROW(pt.update(cloud.points), std::runtime_error);
  EXPECT_FALSE(pt.is_certified());
  EXPECT_FALSE(pt.certify());
  EXPECT_EQ(pt.number_of_points(), 40u);
  EXPECT_EQ(pt.point(39), cloud.points[39]);
  auto copy = pt;
  EXPECT_GT(pt.mend().flips, 0u);
  ASSERT_NO_FATAL_FAILURE(expect_periodic_delaunay(pt));
  copy.insert(Point(1, 1));
  ASSERT_NO_FATAL_FAILURE(expect_periodic_delaunay(copy));
}

// REPAIRS -----------------------------------------------------------------------------------------

template <class Repair>
class A_repair : public testing::Test
{
};
using Repairs =
    testing::Types<CGAL::Hold_and_flip_repair_2, CGAL::Border_splice_repair_2, CGAL::Flip_repair_2,
                   CGAL::Relocation_repair_2, CGAL::Rebuild_repair_2>;
TYPED_TEST_SUITE(A_repair, Repairs);

TYPED_TEST(A_repair, ends_in_the_same_triangulation_as_any_other)
{
  for (const Cell& cell : {Cell(20, 20), Cell(20, 3, -5, 20), Cell(Vector(20, 4))}) {
    Cloud cloud(14, 300, 20);
    Triangulation<CGAL::Circumcircle_classifier_2, TypeParam> pt(cloud.points, cell);
    Triangulation<CGAL::Circumcircle_classifier_2> usual(cloud.points, cell);
    for (int frame = 0; frame < 40; ++frame) {
      cloud.shake(frame % 10 == 9 ? 0.3 : 0.02);
      cloud.wrap(cell);
      if (frame % 3 == 0)
        cloud.jump();
      EXPECT_TRUE(pt.update(cloud.points).certified);
      usual.update(cloud.points);
      ASSERT_TRUE(pt.is_valid()) << frame;
      ASSERT_EQ(edges_both_ways(pt), edges_both_ways(usual)) << frame;
    }
  }
}

TYPED_TEST(A_repair, leaves_a_torus_after_a_heuristic_classifier)
{
  Cloud cloud(15, 300, 20);
  Triangulation<CGAL::Voronoi_circumcenter_classifier_2, TypeParam> pt(cloud.points, Cell(20, 20));
  for (int frame = 0; frame < 40; ++frame) {
    cloud.shake(0.05);
    cloud.wrap(pt.cell());
    if (frame % 5 == 0)
      cloud.jump();
    pt.update(cloud.points);
    ASSERT_TRUE(pt.is_valid()) << frame;
  }
  pt.mend();
  ASSERT_TRUE(pt.is_certified() && pt.is_valid());
}

TEST(A_rebuild_repair, rebuilds_where_anything_is_classified)
{
  Cloud cloud(16, 200, 15);
  Triangulation<CGAL::Circumcircle_classifier_2, CGAL::Rebuild_repair_2> pt(cloud.points,
                                                                            Cell(15, 15));
  EXPECT_FALSE(pt.update(cloud.points).rebuilt());
  cloud.shake(0.1);
  EXPECT_EQ(pt.update(cloud.points).rebuild_reason, Reason::REPAIR);
}

// Vertices are located where all is Delaunay, so the repair needs a proof, whatever was classified.
TEST(A_relocation_repair, proves_everything_where_a_heuristic_classifier_names_few_of_many)
{
  Cloud cloud(18, 100, 10);
  Triangulation<CGAL::Random_classifier_2, CGAL::Relocation_repair_2> pt(
      cloud.points, Cell(10, 10), CGAL::Random_classifier_2(0.04));
  for (int frame = 0; frame < 20; ++frame) {
    cloud.shake(0.2);
    const CGAL::Update_report_2 report = pt.update(cloud.points);
    EXPECT_EQ(report.certified, report.classified > 0);
    if (report.certified) {
      ASSERT_NO_FATAL_FAILURE(expect_periodic_delaunay(pt)) << frame;
    }
    ASSERT_TRUE(pt.is_valid()) << frame;
  }
}

// The outermost points of a slab cannot be taken out.
TEST(A_relocation_repair, proves_everything_where_a_heuristic_classifier_names_who_has_to_stay)
{
  std::size_t classified = 0;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    Cloud cloud(seed, 8, 4);
    Triangulation<CGAL::Random_classifier_2, CGAL::Relocation_repair_2> pt(
        cloud.points, Cell(Vector(4, 1)), CGAL::Random_classifier_2(0.05));
    for (int frame = 0; frame < 20; ++frame) {
      cloud.shake(0.3);
      const CGAL::Update_report_2 report = pt.update(cloud.points);
      EXPECT_EQ(report.certified, report.classified > 0) << seed << ' ' << frame;
      ASSERT_TRUE(pt.is_valid()) << seed << ' ' << frame;
      classified += report.classified;
    }
  }
  EXPECT_GT(classified, 50u);
}

TEST(A_relocation_repair, moves_the_classified_vertices)
{
  Cloud cloud(17, 200, 15);
  Triangulation<CGAL::Circumcircle_classifier_2, CGAL::Relocation_repair_2> pt(cloud.points,
                                                                               Cell(15, 15));
  cloud.shake(0.01);
  const CGAL::Update_report_2 report = pt.update(cloud.points);
  EXPECT_GT(report.classified, 0u);
  EXPECT_EQ(report.relocated, report.classified);
}

TEST(A_border_splice, has_padding_and_a_border_around_what_is_classified)
{
  Cloud cloud(18, 400, 20);
  using Classifier = CGAL::Voronoi_circumcenter_classifier_2;
  Triangulation<Classifier, CGAL::Border_splice_repair_2>::Settings settings;
  settings.repair = CGAL::Border_splice_repair_2(2);
  Triangulation<Classifier, CGAL::Border_splice_repair_2> pt(cloud.points, Cell(20, 20), settings);
  EXPECT_EQ(pt.repair().padding(), 2u);
  std::size_t frames = 0;
  for (int frame = 0; frame < 20; ++frame) {
    cloud.shake(0.003);
    const CGAL::Update_report_2 report = pt.update(cloud.points);
    if (report.classified == 0)
      continue;
    ++frames;
    EXPECT_EQ(report.padded, pt.padded_vertices().size());
    EXPECT_EQ(report.border, pt.border_vertices().size());
    std::set<std::size_t> all;
    for (const auto* set :
         {&pt.classified_vertices(), &pt.padded_vertices(), &pt.border_vertices()})
      all.insert(set->begin(), set->end());
    EXPECT_EQ(all.size(), report.classified + report.padded + report.border);
    EXPECT_GT(report.padded, 0u);
    EXPECT_GT(report.border, 0u);
  }
  EXPECT_GT(frames, 5u);
}

// POLICIES AND ENGINES ----------------------------------------------------------------------------

TEST(Policies, decide_which_frames_are_rebuilt)
{
  Cloud cloud(19, 200, 15);
  using Static =
      Triangulation<CGAL::Circumcircle_classifier_2, CGAL::Default, CGAL::Always_static_policy_2>;
  using Key_frames =
      Triangulation<CGAL::Point_distance_classifier_2, CGAL::Default, CGAL::Key_frame_policy_2>;
  Static rebuilds(cloud.points, Cell(15, 15));
  Key_frames::Settings settings;
  settings.policy = CGAL::Key_frame_policy_2(5);
  Key_frames has_key_frames(cloud.points, Cell(15, 15), settings);
  EXPECT_EQ(has_key_frames.policy().k(), 5u);
  for (int frame = 1; frame <= 20; ++frame) {
    cloud.shake(0.01);
    EXPECT_EQ(rebuilds.update(cloud.points).rebuild_reason, Reason::POLICY);
    ASSERT_TRUE(rebuilds.is_valid());
    const CGAL::Update_report_2 report = has_key_frames.update(cloud.points);
    EXPECT_EQ(report.rebuild_reason == Reason::POLICY, frame % 5 == 0) << frame;
    EXPECT_TRUE(frame % 5 != 0 || report.certified);
  }
}

TEST(A_hybrid_policy, rebuilds_rough_frames_and_mends_calm_ones)
{
  Cloud cloud(20, 500, 22);
  Triangulation<CGAL::Circumcircle_classifier_2, CGAL::Default, CGAL::Hybrid_policy_2> pt(
      cloud.points, Cell(22, 22));
  std::size_t rough = 0, calm = 0;
  for (int frame = 0; frame < 40; ++frame) {
    cloud.shake(frame < 20 ? 0.5 : 0.001);
    (frame < 20 ? rough : calm) += pt.update(cloud.points).rebuilt();
    ASSERT_TRUE(pt.is_valid());
  }
  EXPECT_GT(rough, 15u);
  EXPECT_LT(calm, 10u);
}

TEST(Engines, end_in_the_same_triangulation)
{
  Cloud cloud(21, 500, 22);
  using Dynamic = Triangulation<CGAL::Circumcircle_classifier_2>;
  Dynamic::Settings settings;
  settings.engines.whole = CGAL::Static_engine_2::INSERTION;
  const Dynamic inserts(cloud.points, Cell(22, 22), settings);
  EXPECT_EQ(edges_both_ways(inserts), edges_both_ways(Dynamic(cloud.points, Cell(22, 22))));
}

// OBJECTS -----------------------------------------------------------------------------------------

TEST(A_copy, goes_on_with_the_same_classifier_and_results)
{
  Cloud cloud(22, 200, 15);
  using Dynamic = Triangulation<CGAL::Point_distance_classifier_2>;
  Dynamic pt(cloud.points, Cell(15, 15), CGAL::Point_distance_classifier_2(0.9));
  for (int frame = 0; frame < 10; ++frame) {
    cloud.shake(0.02);
    pt.update(cloud.points);
  }
  Dynamic copy(pt);
  EXPECT_EQ(copy.classifier().x(), 0.9);
  EXPECT_EQ(copy.is_certified(), pt.is_certified());
  for (int frame = 0; frame < 10; ++frame) {
    cloud.shake(0.02);
    const CGAL::Update_report_2 report = pt.update(cloud.points);
    const CGAL::Update_report_2 of_copy = copy.update(cloud.points);
    EXPECT_EQ(report.classified, of_copy.classified);
    EXPECT_EQ(report.flips, of_copy.flips);
    ASSERT_EQ(edges_both_ways(pt), edges_both_ways(copy));
  }
  Dynamic taken(std::move(pt));
  EXPECT_EQ(pt.number_of_points(), 0u);
  EXPECT_EQ(pt.classifier().x(), 0.9);
  EXPECT_EQ(edges_both_ways(taken), edges_both_ways(copy));
  pt.insert(Point(1, 1));
  EXPECT_TRUE(pt.is_valid());
}

TEST(A_population, has_the_same_choices)
{
  Cloud cloud(23, 100, 10);
  using Dynamic = Triangulation<CGAL::Voronoi_circumcenter_classifier_2>;
  CGAL::Dynamic_population_2<Dynamic, int> population{Dynamic(Cell(10, 10))};
  for (int frame = 0; frame < 30; ++frame) {
    cloud.shake(0.02);
    std::vector<std::pair<int, Point>> present; // some come, some go
    for (int i = frame; i < frame + 60; ++i)
      present.push_back({i, cloud.points[std::size_t(i)]});
    population.update(present);
    ASSERT_EQ(population.triangulation().number_of_points(), 60u);
    ASSERT_TRUE(population.triangulation().is_valid());
  }
  population.mend();
  ASSERT_TRUE(population.triangulation().is_certified() && population.triangulation().is_valid());
}

} // namespace test_periodic_choices

// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The confusion matrix of edges: what counts as right, with and without ties.

#include "oracle.h"

#include <CGAL/Dynamic_Delaunay_triangulation_2/classifiers/Point_distance_classifier_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/classifiers/Random_classifier_2.h>
#include <CGAL/Dynamic_periodic_Delaunay_triangulation_2.h>
#include <CGAL/iterator.h>
#include <CGAL/Periodic_cell_2.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <set>
#include <stdexcept>
#include <tuple>
#include <utility>
#include <vector>

namespace test_agreement {

using Points = Cloud<Epick>::Points;
using Fresh = CGAL::Delaunay_triangulation_2<Epick>;
// keeps its edges however points move
using Frozen = CGAL::Dynamic_Delaunay_triangulation_2<Epick, CGAL::Point_distance_classifier_2>;

Frozen frozen(const Points& built, const Points& moved)
{
  Frozen dt(built.begin(), built.end(), CGAL::Point_distance_classifier_2(0));
  dt.update(moved.begin(), moved.end());
  return dt;
}

TEST(Delaunay_agreement, of_a_triangulation_with_itself_is_perfect)
{
  Cloud<Epick> cloud(1);
  const auto points = cloud.uniform(100);
  const Fresh fresh(points.begin(), points.end());
  const auto agreement = CGAL::delaunay_agreement(
      CGAL::Dynamic_Delaunay_triangulation_2<Epick>(points.begin(), points.end()), fresh);
  EXPECT_TRUE(agreement.is_perfect());
  EXPECT_EQ(agreement.matthews_correlation_coefficient(), 1);
  EXPECT_EQ(agreement.true_positives() + agreement.true_negatives(), 100u * 99 / 2);
}

TEST(Delaunay_agreement, counts_one_wrong_diagonal_and_the_right_one_that_is_missing)
{
  // the diagonal of a rhombus must be the short one; the edge 0-2 was built, 1-3 is right
  const Points built = {{0, 0}, {2, -1}, {1, 0.1}, {-1, 1.2}};
  const Points moved = {{-2, 0}, {0, -1}, {2, 0}, {0, 1}};
  const Points stretched = {{-1, 0}, {0, -2}, {1, 0}, {0, 2}};
  const auto dt = frozen(stretched, moved);
  const auto agreement = CGAL::delaunay_agreement(dt, Fresh(moved.begin(), moved.end()));
  EXPECT_EQ(agreement.true_positives(), 4u);
  EXPECT_EQ(agreement.false_positives(), 1u);
  EXPECT_EQ(agreement.false_negatives(), 1u);
  EXPECT_EQ(agreement.true_negatives(), 0u);
  EXPECT_NEAR(agreement.matthews_correlation_coefficient(), -0.2, 1e-12); // (4*0 - 1*1) / 5
}

TEST(Delaunay_agreement, takes_either_diagonal_of_a_square_for_right)
{
  const Points square = {{-1, 0}, {0, -1}, {1, 0}, {0, 1}};
  for (const Points& built :
       {Points{{-1, 0}, {0, -2}, {1, 0}, {0, 2}}, Points{{-2, 0}, {0, -1}, {2, 0}, {0, 1}}}) {
    const auto agreement =
        CGAL::delaunay_agreement(frozen(built, square), Fresh(square.begin(), square.end()));
    EXPECT_TRUE(agreement.is_perfect());
    EXPECT_EQ(agreement.true_positives(), 5u);
  }
}

TEST(Delaunay_agreement, takes_any_triangulation_of_a_cocircular_polygon_for_right)
{
  for (unsigned seed = 0; seed < 10; ++seed) {
    Cloud<Epick> cloud(seed);
    const auto circle = cloud.on_circle(36);
    auto bumpy = circle;
    for (auto& p : bumpy) {
      const double factor = 1 + 1e-3 * double(cloud.random()() % 1000);
      p = Epick::Point_2(p.x() * factor, p.y() * factor);
    }
    const auto dt = frozen(bumpy, circle);
    const auto agreement = CGAL::delaunay_agreement(dt, Fresh(circle.begin(), circle.end()));
    // 36 sides and 33 chords; sides that the bumpy hull skipped are missing, and so wrong
    EXPECT_LE(agreement.true_positives(), 69u);
    EXPECT_EQ(agreement.false_negatives(), 69u - agreement.true_positives());
  }
  Cloud<Epick> cloud(0);
  const auto circle = cloud.on_circle(36);
  auto shuffled = circle;
  std::shuffle(shuffled.begin(), shuffled.end(), cloud.random());
  EXPECT_TRUE(CGAL::delaunay_agreement(
                  CGAL::Dynamic_Delaunay_triangulation_2<Epick>(shuffled.begin(), shuffled.end()),
                  Fresh(circle.begin(), circle.end()))
                  .is_perfect());
}

TEST(Delaunay_agreement, does_not_excuse_a_chord_across_two_clusters)
{
  // two squares side by side: a chord from one into the other is no Delaunay edge
  const Points squares = {{0, 0}, {1, 0}, {2, 0}, {2, 1}, {1, 1}, {0, 1}};
  const Points built = {{0, 0}, {1, 0.9}, {2, 0}, {2, 1}, {1, 1.8}, {0, 1}};
  const auto dt = frozen(built, squares);
  const auto agreement = CGAL::delaunay_agreement(dt, Fresh(squares.begin(), squares.end()));
  EXPECT_FALSE(agreement.is_perfect());
}

TEST(Delaunay_agreement, works_for_no_point_up_to_three_and_for_points_on_a_line)
{
  for (const Points& points :
       {Points{}, Points{{0, 0}}, Points{{0, 0}, {1, 1}}, Points{{0, 0}, {1, 1}, {2, 2}, {5, 5}},
        Points{{0, 0}, {1, 1}, {2, 1}}}) {
    const CGAL::Dynamic_Delaunay_triangulation_2<Epick> dt(points.begin(), points.end());
    const auto agreement = CGAL::delaunay_agreement(dt, Fresh(points.begin(), points.end()));
    EXPECT_TRUE(agreement.is_perfect()) << points.size();
    EXPECT_EQ(agreement.matthews_correlation_coefficient(), 1);
  }
}

TEST(Delaunay_agreement, refuses_triangulations_of_different_points)
{
  const Points points = {{0, 0}, {1, 0}, {0, 1}}, others = {{0, 0}, {1, 0}, {0, 2}};
  const CGAL::Dynamic_Delaunay_triangulation_2<Epick> dt(points.begin(), points.end());
  EXPECT_THROW(CGAL::delaunay_agreement(dt, Fresh(others.begin(), others.end())),
               std::invalid_argument);
}

// PERIODIC SPACE ----------------------------------------------------------------------------------

using Point = Epick::Point_2;
using Cell = CGAL::Periodic_cell_2;
using Shift = CGAL::Periodic_shift_2;
using Periodic = CGAL::Dynamic_periodic_Delaunay_triangulation_2<Epick>;
// classifies no vertex, and so keeps its edges
using Frozen_periodic =
    CGAL::Dynamic_periodic_Delaunay_triangulation_2<Epick, CGAL::Random_classifier_2>;

Frozen_periodic frozen(const Points& built, const Points& moved, const Cell& cell)
{
  Frozen_periodic pt(built, cell, CGAL::Random_classifier_2(0));
  pt.update(moved);
  return pt;
}

// Points with so few bits that adding vectors of the lattice is exact.
Points short_points(std::size_t number, unsigned seed)
{
  Points points;
  for (const Point& p : Cloud<Epick>(seed).uniform(number))
    points.emplace_back(std::floor(p.x() * 0x1p20) * 0x1p-20, std::floor(p.y() * 0x1p20) * 0x1p-20);
  return points;
}

using Undirected_edge = std::tuple<std::size_t, std::size_t, Shift>;

template <class Triangulation>
std::set<Undirected_edge> edges_of(const Triangulation& pt)
{
  std::set<Undirected_edge> edges;
  pt.for_each_edge([&](std::size_t i, std::size_t j, const Shift& shift) {
    edges.insert(
        (std::min)(Undirected_edge(i, j, shift), Undirected_edge(j, i, {-shift[0], -shift[1]})));
  });
  return edges;
}

TEST(Periodic_agreement, is_perfect_for_the_same_points_by_other_ids_and_images)
{
  for (const Cell& cell : {Cell(7, 7), Cell(7, 0, 17, 7), Cell::slab(7, 0)})
    for (const std::size_t number : {0u, 1u, 2u, 3u, 50u}) {
      Points points = short_points(number, 3);
      for (std::size_t i = 0; i < number / 5; ++i) // these coincide with others
        points.emplace_back(points[i].x() - 7, points[i].y());
      const Periodic reference(points, cell);
      std::reverse(points.begin(), points.end());
      for (std::size_t i = 0; i < points.size(); i += 3)
        points[i] = Point(points[i].x() + 7 * double(i % 4), points[i].y());
      Periodic pt(points, cell);
      const auto agreement = CGAL::delaunay_agreement(pt, reference);
      EXPECT_TRUE(agreement.is_perfect());
      EXPECT_EQ(agreement.true_positives(), reference.number_of_edges());
      EXPECT_EQ(agreement.matthews_correlation_coefficient(), 1);
    }
}

TEST(Periodic_agreement, counts_the_edges_that_are_wrong_and_those_that_are_missing)
{
  const Cell cell(10, 0, 3, 10);
  Cloud<Epick> cloud(4);
  const Points built = cloud.uniform(100);
  Points moved = built;
  cloud.shake(moved, 0.1);
  const auto pt = frozen(built, moved, cell);
  ASSERT_FALSE(pt.is_certified());
  const Periodic reference(moved, cell);
  const auto maintained = edges_of(pt), right = edges_of(reference);
  std::size_t common = 0;
  for (const auto& edge : maintained)
    common += right.count(edge);
  ASSERT_LT(common, right.size());
  const auto agreement = CGAL::delaunay_agreement(pt, reference);
  EXPECT_EQ(agreement.true_positives(), common);
  EXPECT_EQ(agreement.false_positives(), maintained.size() - common);
  EXPECT_EQ(agreement.false_negatives(), right.size() - common);
  EXPECT_EQ(agreement.true_negatives(), 100u * 99 / 2 - 300 - (300 - common));
}

// Of the edges of a lattice all sides are right, and one of the two diagonals of each square.
TEST(Periodic_agreement, takes_either_diagonal_of_each_square_of_a_lattice_for_right)
{
  for (const std::size_t size : {1u, 2u, 12u})
    for (const double step : {0.01, 0.3}) {
      const Points lattice = Cloud<Epick>::grid(size, size);
      Points built = lattice;
      Cloud<Epick>(5).shake(built, step);
      const double width = double(size);
      const Cell cell(width, width);
      const auto pt = frozen(built, lattice, cell);
      std::set<std::tuple<std::size_t, std::size_t, Shift>> sides;
      std::set<std::pair<int, int>> squares;
      for (const auto& [i, j, shift] : edges_of(pt)) {
        const auto v = pt.vector(i, j, shift);
        const int n = int(size), x = int(lattice[i].x()), y = int(lattice[i].y());
        if (v.squared_length() == 1)
          sides.insert({i, j, shift});
        else if (v.squared_length() == 2)
          squares.insert({(x + n - (v.x() < 0)) % n, (y + n - (v.y() < 0)) % n});
      }
      const auto agreement = CGAL::delaunay_agreement(pt, Periodic(lattice, cell));
      EXPECT_EQ(agreement.true_positives(), sides.size() + squares.size());
      EXPECT_EQ(agreement.true_positives() + agreement.false_negatives(), 3 * size * size);
      if (size == 12) {
        EXPECT_EQ(agreement.is_perfect(), step == 0.01);
      }
    }
}

TEST(Periodic_agreement, takes_any_triangulation_of_a_cocircular_polygon_for_right)
{
  Cloud<Epick> cloud(6);
  Points circle = cloud.on_circle(36);
  for (Point& p : circle) // around a corner of the cell
    p = Point(p.x() + (p.x() < 0 ? 200 : 0), p.y() + (p.y() < 0 ? 200 : 0));
  std::size_t others = 0;
  for (const Cell& cell : {Cell(200, 200), Cell::slab(200, 0)}) {
    if (cell.is_slab())
      circle = cloud.on_circle(36);
    const Periodic reference(circle, cell);
    for (int order = 0; order < 10; ++order) {
      Periodic pt(cell);
      std::vector<std::size_t> ids(circle.size());
      for (std::size_t i = 0; i < ids.size(); ++i)
        ids[i] = i;
      std::shuffle(ids.begin(), ids.end(), cloud.random());
      pt.insert(circle, CGAL::Emptyset_iterator());
      for (const std::size_t id : ids) { // the next point gets this id
        pt.remove(id);
        pt.insert(circle[id]);
      }
      others += edges_of(pt) != edges_of(reference);
      EXPECT_TRUE(CGAL::delaunay_agreement(pt, reference).is_perfect());
    }
  }
  EXPECT_GT(others, 0u);
}

TEST(Periodic_agreement, is_refused_for_other_points_and_cells_and_without_a_certificate)
{
  const Points points = {{0, 0}, {1, 0}, {0, 1}}, others = {{0, 0}, {1, 0}, {0, 2}};
  const Cell cell(3, 3);
  const Periodic pt(points, cell);
  EXPECT_THROW(CGAL::delaunay_agreement(pt, Periodic(others, cell)), std::invalid_argument);
  EXPECT_THROW(CGAL::delaunay_agreement(pt, Periodic(cell)), std::invalid_argument);
  EXPECT_THROW(CGAL::delaunay_agreement(pt, Periodic(points, Cell(3, 4))), std::invalid_argument);
  const auto uncertified = frozen(points, {{0.1, 0}, {1, 0}, {0, 1}}, cell);
  ASSERT_FALSE(uncertified.is_certified());
  EXPECT_THROW(CGAL::delaunay_agreement(uncertified, uncertified),
               CGAL::Uncertified_triangulation_error_2);
}

} // namespace test_agreement

// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The confusion matrix of edges: what counts as right, with and without ties.

#include "oracle.h"

#include <CGAL/Dynamic_Delaunay_triangulation_2/classifiers/Point_distance_classifier_2.h>

namespace test_agreement {

using Points = Cloud<Epick>::Points;
using Fresh = CGAL::Delaunay_triangulation_2<Epick>;
// keeps its edges whatever happens
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

} // namespace test_agreement

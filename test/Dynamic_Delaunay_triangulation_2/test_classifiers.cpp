// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// What the classifiers pick, and that a user can plug in another one.

#include "oracle.h"

#include <CGAL/Dynamic_Delaunay_triangulation_2/classifiers/Point_distance_classifier_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/classifiers/Random_classifier_2.h>

#include <algorithm>
#include <chrono>
#include <set>
#include <vector>

namespace test_classifiers {

using Points = Cloud<Epick>::Points;
using Distance = CGAL::Dynamic_Delaunay_triangulation_2<Epick, CGAL::Point_distance_classifier_2>;

// A user's own heuristic classifier: the points that have moved far since the previous frame.
struct Fast_mover_classifier
{
  static constexpr bool is_exact = false;
  double limit;

  template <class Frame, class Classification>
  void operator()(const Frame& frame, Classification& classified) const
  {
    for (typename Frame::Vertex_index v(1); v <= frame.number_of_vertices(); ++v) {
      const auto &p = frame.position(v), &q = frame.previous_position(v);
      if (std::hypot(p.x - q.x, p.y - q.y) > limit)
        classified.add_id(frame.id(v));
    }
  }
};

// A user's own exact classifier that names vertices, not edges.
struct Vertex_classifier
{
  static constexpr bool is_exact = true;

  template <class Frame, class Classification>
  void operator()(const Frame& frame, Classification& classified) const
  {
    for (typename Frame::Edge_index e(0); e < frame.number_of_edges(); ++e)
      if (!frame.is_delaunay(e))
        classified.add_vertex(frame.is_infinite(frame.edge(e).source) ? frame.edge(e).target
                                                                      : frame.edge(e).source);
  }
};

// However many lanes the processor has, the same edges are proved.
TEST(Edge_filter, proves_the_same_edges_in_one_lane_and_in_all)
{
  using namespace CGAL::Dynamic_Delaunay_triangulations_2;
  std::mt19937 random(4);
  Position_vector positions(1, {std::nan(""), std::nan("")});
  for (int i = 0; i < 400; ++i) {
    std::uniform_int_distribution<int> digit(0, 30);
    const double scale = i % 4 == 0 ? 0.1 : i % 4 == 1 ? 0x1p45 : i % 4 == 2 ? 1e-160 : 1;
    const double x = digit(random) * scale;
    positions.push_back({x, digit(random) * scale});
  }
  std::vector<Edge_2> edges;
  std::uniform_int_distribution<Index> any(0, Index(positions.size()) - 1);
  for (int i = 0; i < 200003; ++i) { // no multiple of four
    // mostly points of one scale
    const Index scale = Index(i % 4);
    const auto vertex = [&] {
      return Vertex_index(i % 10 == 0 ? any(random) : any(random) / 4 * 4 + scale);
    };
    Edge_2 edge{vertex(), vertex(), vertex(), vertex()};
    for (auto* v : {&edge.source, &edge.target, &edge.left, &edge.right})
      *v = (std::min)(*v, Vertex_index(positions.size() - 1));
    edges.push_back(edge);
  }
  std::vector<Edge_index> plain, chosen;
  internal::append_unproved_in_lanes<internal::Plane_2, 1>(
      internal::Consecutive_edges_2{edges.data()}, positions.data(), 0, edges.size(), plain);
  internal::append_unproved<internal::Plane_2>(edges.data(), positions, 0, Index(edges.size()),
                                               chosen);
  EXPECT_EQ(plain, chosen);
  positions.resize(internal::min_vertices_to_prefetch); // far apart in memory, on another path
  chosen.clear();
  internal::append_unproved<internal::Plane_2>(edges.data(), positions, 0, Index(edges.size()),
                                               chosen);
  EXPECT_EQ(plain, chosen);
  EXPECT_GT(edges.size() - plain.size(), 1000u); // both answers occur
  EXPECT_GT(plain.size(), 1000u);
}

// The classifier picks nothing, so the hull stays as it was.
TEST(Frames, know_where_a_straight_hull_turns_back_and_where_a_face_at_the_hull_is_flat)
{
  const Points points = {{0, 0}, {1, 0}, {2, 0}, {3, 0}, {3, 3}, {0, 3}, {0.5, 0.2}, {1.5, 1.6}};
  using Ids = std::set<std::set<std::size_t>>;
  const auto broken_at_hull = [&](std::size_t id, const Epick::Point_2& p) {
    CGAL::Dynamic_Delaunay_triangulation_2<Epick, CGAL::Random_classifier_2> dt(
        points.begin(), points.end(), CGAL::Random_classifier_2(0));
    Points moved = points;
    moved[id] = p;
    dt.update(moved.begin(), moved.end());
    const auto frame = dt.frame();
    Ids broken;
    for (CGAL::Dynamic_Delaunay_triangulations_2::Edge_index e(0); e < frame.number_of_edges(); ++e)
      if (frame.is_at_infinity(e) && !frame.is_delaunay(e)) {
        std::set<std::size_t> ids;
        for (const auto v : {frame.edge(e).source, frame.edge(e).target})
          if (!frame.is_infinite(v))
            ids.insert(frame.id(v));
        broken.insert(ids);
      }
    EXPECT_TRUE(dt.mend().certified && dt.is_valid());
    return broken;
  };
  EXPECT_EQ(broken_at_hull(1, {1.2, 0}), Ids());
  EXPECT_EQ(broken_at_hull(1, {2.5, 0}), (Ids{{1}, {2}, {1, 2}})); // beyond the next corner
  EXPECT_EQ(broken_at_hull(6, {0.5, 0}), (Ids{{0, 1}}));
  EXPECT_EQ(broken_at_hull(6, {-0.5, 0}), (Ids{{0, 1}, {0, 5}})); // on the line, outside
}

TEST(Point_distance_classifier, picks_the_ends_of_edges_that_left_their_range)
{
  const Points points = {{0, 0}, {10, 0}, {10, 10}, {0, 10}, {5, 4}};
  for (const double x : {0., 0.3, 0.7, 0.9}) {
    Distance dt(points.begin(), points.end(), CGAL::Point_distance_classifier_2(x));
    Points moved = points;
    moved[1] = Epick::Point_2(0 + 10 * (2 - x) - 1e-6, 0); // the edge 0-1 is just within its range
    dt.update(moved.begin(), moved.end());
    std::set<std::size_t> classified;
    for (const auto v : dt.classified_vertices())
      classified.insert(dt.frame().id(v));
    EXPECT_EQ(classified.count(0), 0u) << "x = " << x;
  }
  Distance dt(points.begin(), points.end(), CGAL::Point_distance_classifier_2(0.9));
  Points moved = points;
  moved[1] = Epick::Point_2(11.01, 0);
  EXPECT_GT(dt.update(moved.begin(), moved.end()).classified, 0u);
}

TEST(Point_distance_classifier, reacts_to_any_change_at_one_and_to_no_small_one_at_zero)
{
  Cloud<Epick> cloud(4);
  auto points = cloud.uniform(200);
  Distance one(points.begin(), points.end(), CGAL::Point_distance_classifier_2(1));
  Distance zero(points.begin(), points.end(), CGAL::Point_distance_classifier_2(0));
  EXPECT_EQ(one.update(points.begin(), points.end()).classified, 0u);
  cloud.shake(points, 1e-4);
  EXPECT_EQ(one.update(points.begin(), points.end()).classified, 200u);
  EXPECT_EQ(zero.update(points.begin(), points.end()).classified, 0u);
}

TEST(Point_distance_classifier, measures_from_the_last_time_that_an_edge_was_triangulated)
{
  Cloud<Epick> cloud(5);
  auto points = cloud.uniform(300);
  Distance dt(points.begin(), points.end(), CGAL::Point_distance_classifier_2(0.9));
  points[0] = Epick::Point_2(points[0].x() + 0.3, points[0].y());
  EXPECT_GT(dt.update(points.begin(), points.end()).classified, 0u);
  EXPECT_EQ(dt.update(points.begin(), points.end()).classified, 0u);
}

TEST(Point_distance_classifier, misses_what_a_distance_cannot_see)
{
  // the diagonal of a square that becomes a slightly flat rhombus
  const Points points = {{0, 0}, {1, 0}, {1.01, 1.01}, {0, 1}};
  Distance dt(points.begin(), points.end(), CGAL::Point_distance_classifier_2(0.7));
  const Points moved = {{0, 0}, {1, 0}, {0.98, 0.98}, {0, 1}};
  EXPECT_EQ(dt.update(moved.begin(), moved.end()).classified, 0u);
  EXPECT_FALSE(dt.certify());
}

TEST(Own_classifiers, plug_in_whether_heuristic_or_exact)
{
  Cloud<Epick> cloud(7);
  auto points = cloud.uniform(300);
  CGAL::Dynamic_Delaunay_triangulation_2<Epick, Fast_mover_classifier> heuristic(
      points.begin(), points.end(), Fast_mover_classifier{0.1});
  CGAL::Dynamic_Delaunay_triangulation_2<Epick, Vertex_classifier> exact(points.begin(),
                                                                         points.end());
  for (int frame = 0; frame < 10; ++frame) {
    cloud.shake(points, 0.05);
    EXPECT_GT(heuristic.update(points.begin(), points.end()).classified, 0u);
    ASSERT_NO_FATAL_FAILURE(expect_valid(heuristic, points));
    exact.update(points.begin(), points.end());
    ASSERT_NO_FATAL_FAILURE(expect_exact(exact, points));
  }
}

// As in the example own_exact_classifier.cpp.
struct All_edges_classifier
{
  static constexpr bool is_exact = true;

  template <class Frame, class Classification>
  void operator()(const Frame& frame, Classification& classified)
  {
    unproved.clear();
    frame.append_unproved(0, frame.number_of_edges(), unproved);
    classified.add_unless_delaunay(frame, unproved);
  }

  std::vector<CGAL::Dynamic_Delaunay_triangulations_2::Edge_index> unproved{};
};

// The median ratio over frames, taken in alternating order. Too much moves for edges to be skipped.
double time_over_that_of_the_built_in_classifier(unsigned seed)
{
  using Clock = std::chrono::steady_clock;
  Cloud<Epick> cloud(seed);
  auto points = cloud.uniform(2000);
  CGAL::Dynamic_Delaunay_triangulation_2<Epick> built_in(points.begin(), points.end());
  CGAL::Dynamic_Delaunay_triangulation_2<Epick, All_edges_classifier> own(points.begin(),
                                                                          points.end());
  const auto time_of = [&](auto& dt) {
    const Clock::time_point start = Clock::now();
    EXPECT_TRUE(dt.update(points.begin(), points.end()).certified);
    return std::chrono::duration<double>(Clock::now() - start).count();
  };
  std::vector<double> ratios;
  for (int frame = 0; frame < 101; ++frame) {
    cloud.shake(points, 1e-3);
    const bool comes_first = frame % 2 == 0;
    const double before = comes_first ? time_of(own) : 0;
    const double time_of_built_in = time_of(built_in);
    ratios.push_back((comes_first ? before : time_of(own)) / time_of_built_in);
  }
  expect_exact(own, points);
  std::nth_element(ratios.begin(), ratios.begin() + 50, ratios.end());
  return ratios[50];
}

TEST(A_classifier_of_ones_own, of_a_few_lines_is_as_fast_as_the_built_in_one)
{
  double ratio = 0;
  for (unsigned seed = 1; seed <= 5; ++seed) {
    ratio = time_over_that_of_the_built_in_classifier(seed);
    if (ratio < 1.15)
      return;
  }
  ADD_FAILURE() << "it takes " << ratio << " times as long";
}

} // namespace test_classifiers

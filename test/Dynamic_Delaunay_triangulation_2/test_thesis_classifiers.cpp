// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The thesis's classifiers and their relatives: the exact ones miss nothing, the others do what
// their formulas say, and what they remember is right whatever has happened to the triangulation.

#include "oracle.h"

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
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/proof/Edge_slack_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/repairs/Flip_repair_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/repairs/Rebuild_repair_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/repairs/Relocation_repair_2.h>

#include <algorithm>
#include <array>
#include <functional>
#include <iterator>
#include <limits>
#include <map>
#include <memory>
#include <set>
#include <utility>

namespace test_thesis_classifiers {

using Points = Cloud<Epick>::Points;
using CGAL::Dynamic_Delaunay_triangulations_2::Edge_2;
using CGAL::Dynamic_Delaunay_triangulations_2::Edge_index;
using CGAL::Dynamic_Delaunay_triangulations_2::Face_index;
using CGAL::Dynamic_Delaunay_triangulations_2::Index;
using CGAL::Dynamic_Delaunay_triangulations_2::Position_2;
using CGAL::Dynamic_Delaunay_triangulations_2::Vertex_index;

template <class Classifier, class Repair = CGAL::Default>
using Triangulation =
    CGAL::Dynamic_Delaunay_triangulation_2<Epick, Classifier, CGAL::With_repair_2<Repair>>;

using Safe_and_circumcircle =
    CGAL::Refined_classifier_2<CGAL::Safe_region_classifier_2, CGAL::Circumcircle_classifier_2>;

Points turned(const Points& points, double angle, const Epick::Point_2& center = {0, 0})
{
  const double c = std::cos(angle), s = std::sin(angle);
  Points result;
  for (const auto& p : points) {
    const double x = p.x() - center.x(), y = p.y() - center.y();
    result.emplace_back(center.x() + c * x - s * y, center.y() + s * x + c * y);
  }
  return result;
}

// Moves all points along straight lines.
class Drift
{
public:
  Drift(Cloud<Epick>& cloud, std::size_t n, double speed)
    : m_start(cloud.uniform(n))
    , m_end(m_start)
  {
    cloud.shake(m_end, speed);
  }

  Points points(int frame) const
  {
    Points result;
    for (std::size_t i = 0; i < m_start.size(); ++i)
      result.push_back(m_start[i] + frame * (m_end[i] - m_start[i]));
    return result;
  }

  Position_2 velocity(std::size_t id) const
  {
    const auto step = m_end[id] - m_start[id];
    return {step.x(), step.y()};
  }

private:
  Points m_start, m_end;
};

template <class Dynamic>
std::set<std::size_t> classified_ids(const Dynamic& dt)
{
  std::set<std::size_t> ids;
  for (const Vertex_index v : dt.classified_vertices())
    ids.insert(dt.frame().id(v));
  return ids;
}

template <class Dynamic>
std::set<std::size_t> neighbors_of(const Dynamic& dt, std::size_t id)
{
  std::set<std::size_t> ids;
  const auto frame = dt.frame();
  frame.for_each_neighbor(frame.vertex(Index(id)), [&](Vertex_index w) {
    if (!frame.is_infinite(w))
      ids.insert(frame.id(w));
  });
  return ids;
}

// Does what another classifier does; derived ones look on. It lacks the members by which a
// classifier declares that it decides edge by edge.
template <class Classifier>
struct Wrapped_classifier
{
  static constexpr bool is_exact = Classifier::is_exact;
  Classifier classifier{};

  template <class Frame, class Classification>
  void operator()(const Frame& frame, Classification& classified)
  {
    classifier(frame, classified);
  }

  template <class Frame>
  void after_update(const Frame& frame)
  {
    CGAL::inform_classifier(classifier, frame);
  }
};

// -------------------------------------------------------------------------------------------------
// Exactness.

struct Audit
{
  std::size_t edges = 0, named = 0, broken = 0, missed = 0, false_alarms = 0;
};

// Counts, before anything is repaired, the broken edges that a classifier has missed, and the edges
// that it has named in vain.
template <class Classifier>
struct Audited : Wrapped_classifier<Classifier>
{
  std::shared_ptr<Audit> audit = std::make_shared<Audit>();

  template <class Frame, class Classification>
  void operator()(const Frame& frame, Classification& classified)
  {
    this->classifier(frame, classified);
    const std::set<Index> named(classified.edges().begin(), classified.edges().end());
    for (Edge_index e(0); e < frame.number_of_edges(); ++e) {
      const bool is_broken = !frame.is_delaunay(e);
      const bool is_picked = named.count(e) > 0 ||
                             classified.is_whole_vertex(frame.edge(e).source) ||
                             classified.is_whole_vertex(frame.edge(e).target);
      audit->broken += is_broken;
      audit->missed += is_broken && !is_picked;
      audit->false_alarms += !is_broken && is_picked && !classified.is_everything();
    }
    audit->edges += frame.number_of_edges();
    audit->named += named.size();
  }
};

// An exact classifier that names one end of each broken edge, the one with the smaller or the
// larger number.
template <bool smaller>
struct End_classifier
{
  static constexpr bool is_exact = true;

  template <class Frame, class Classification>
  void operator()(const Frame& frame, Classification& classified) const
  {
    for (Edge_index e(0); e < frame.number_of_edges(); ++e) {
      const auto [low, high] = std::minmax({frame.edge(e).source, frame.edge(e).target});
      if (!frame.is_delaunay(e))
        classified.add_vertex(smaller && low != 0 ? low : high);
    }
  }
};

template <class Classifier>
class Exact_classifiers : public testing::Test
{
protected:
  static_assert(Classifier::is_exact, "exact ones are audited");
  using Dynamic = Triangulation<Audited<Classifier>>;

  // `move` changes the points from one frame to the next.
  void follow(Points points, int frames, const std::function<void(Points&, int)>& move)
  {
    Dynamic dt(points.begin(), points.end(), m_classifier);
    for (int frame = 0; frame < frames; ++frame) {
      move(points, frame);
      dt.update(points.begin(), points.end());
      ASSERT_TRUE(dt.is_certified());
      if (frame % 32 == 31) {
        ASSERT_NO_FATAL_FAILURE(expect_exact(dt, points));
      }
    }
  }

  const Audit& audit() const { return *m_classifier.audit; }

  Audited<Classifier> m_classifier;
};

using All_exact = testing::Types<
    CGAL::Circumcircle_classifier_2, CGAL::Safe_region_classifier_2, Safe_and_circumcircle,
    CGAL::Refined_classifier_2<CGAL::Circumcircle_classifier_2, CGAL::Safe_region_classifier_2>,
    CGAL::Refined_classifier_2<End_classifier<true>, End_classifier<false>>,
    CGAL::Refined_classifier_2<End_classifier<false>, CGAL::Safe_region_classifier_2>>;
TYPED_TEST_SUITE(Exact_classifiers, All_exact);

TYPED_TEST(Exact_classifiers, miss_nothing_in_a_million_edges)
{
  Cloud<Epick> cloud(1);
  for (const double step : {1e-6, 1e-5, 1e-4, 1e-3, 1e-2, 0.1, 1.}) {
    SCOPED_TRACE(testing::Message() << "step " << step);
    ASSERT_NO_FATAL_FAILURE(this->follow(cloud.uniform(300), 100,
                                         [&](Points& points, int) { cloud.shake(points, step); }));
  }
  // most at rest, some on the move, now and then all of them
  ASSERT_NO_FATAL_FAILURE(this->follow(cloud.uniform(500), 200, [&](Points& points, int frame) {
    for (int i = 0; i < 10; ++i)
      points[cloud.random()() % points.size()] =
          cloud.shifted(points[cloud.random()() % points.size()], 0.1);
    if (frame % 50 == 49)
      cloud.shake(points, 0.01);
  }));
  // all points slowly straight on, so that results of one frame are used in many
  for (const double speed : {1e-5, 1e-4}) {
    const Drift drift(cloud, 1000, speed);
    ASSERT_NO_FATAL_FAILURE(this->follow(drift.points(0), 400, [&](Points& points, int frame) {
      points = drift.points(frame + 1);
    }));
  }
  // ties: a lattice that trembles by thousandths and comes to rest
  const Points grid = cloud.grid(20, 20);
  ASSERT_NO_FATAL_FAILURE(this->follow(grid, 100, [&](Points& points, int frame) {
    points = grid;
    std::uniform_int_distribution<int> digit(-1, 1);
    for (std::size_t i = 0; frame % 3 != 0 && i < points.size(); ++i)
      points[i] = Epick::Point_2(points[i].x() + digit(cloud.random()) * 0x1p-10,
                                 points[i].y() + digit(cloud.random()) * 0x1p-10);
  }));
  // turning and trembling, and going far away, where the coordinates get coarse
  ASSERT_NO_FATAL_FAILURE(this->follow(cloud.uniform(400), 100, [&](Points& points, int) {
    points = turned(points, 0.01, {10, 10});
    cloud.shake(points, 1e-4);
  }));
  const Points first = cloud.uniform(400);
  ASSERT_NO_FATAL_FAILURE(this->follow(first, 100, [&](Points& points, int frame) {
    points = scaled<Epick>(first, 1, std::ldexp(1., frame / 2));
  }));
  // breathing in and out at the hull alone
  ASSERT_NO_FATAL_FAILURE(this->follow(cloud.uniform(300), 100, [&](Points& points, int frame) {
    for (auto& p : points)
      if ((std::max)(std::abs(p.x() - 8.7), std::abs(p.y() - 8.7)) > 7)
        p = Epick::Point_2(p.x(), p.y() + (frame % 2 == 0 ? 0.02 : -0.02) * (p.x() - 5));
  }));
  const Audit& audit = this->audit();
  EXPECT_GE(audit.edges, 1000000u);
  EXPECT_GT(audit.broken, 20000u);
  EXPECT_EQ(audit.missed, 0u);
}

TYPED_TEST(Exact_classifiers, pick_no_vertex_when_everything_moves_grows_and_turns_by_any_angle)
{
  Cloud<Epick> cloud(2);
  const Points points = cloud.uniform(400);
  Triangulation<TypeParam> dt(points.begin(), points.end());
  std::uniform_real_distribution<double> angle(-3.2, 3.2);
  for (int frame = 0; frame < 50; ++frame) {
    const Points moved = scaled<Epick>(turned(points, angle(cloud.random()), {7, -3}),
                                       frame % 2 == 0 ? 1 : 1.7, frame % 2 == 0 ? 0 : -8);
    EXPECT_EQ(dt.update(moved.begin(), moved.end()).classified, 0u);
  }
}

struct Failure
{
};

// A repair that gives up, before it has begun or half-way, when it is told to.
struct Failing_repair
{
  std::shared_ptr<int> frame = std::make_shared<int>(0);

  template <class Mender>
  void operator()(Mender& mender)
  {
    const int number = (*frame)++ % 6;
    if (number == 2)
      throw Failure();
    if (number == 4) {
      mender.flip();
      throw Failure();
    }
    CGAL::Hold_and_flip_repair_2()(mender);
  }
};

TYPED_TEST(Exact_classifiers, miss_nothing_when_the_last_frame_was_left_unrepaired)
{
  for (const double speed : {1e-4, 1e-3, 1e-2}) {
    Cloud<Epick> cloud(3);
    const Drift drift(cloud, 500, speed);
    Points points = drift.points(0);
    CGAL::Dynamic_Delaunay_triangulation_2<Epick, Audited<TypeParam>,
                                           CGAL::With_repair_2<Failing_repair>>
        dt(points.begin(), points.end(), this->m_classifier);
    int failures = 0;
    for (int frame = 1; frame <= 200; ++frame) {
      points = drift.points(frame);
      try {
        dt.update(points.begin(), points.end());
        ASSERT_TRUE(dt.is_certified());
      } catch (const Failure&) {
        ++failures;
        ASSERT_FALSE(dt.is_certified());
        ASSERT_NO_FATAL_FAILURE(expect_valid(dt, points));
      }
    }
    dt.mend();
    ASSERT_NO_FATAL_FAILURE(expect_exact(dt, points));
    EXPECT_GT(failures, 5);
  }
  EXPECT_EQ(this->audit().missed, 0u);
}

template <class Classifier>
void expect_no_edge_named_for_nothing()
{
  Cloud<Epick> cloud(4);
  Points points = cloud.uniform(400);
  Audited<Classifier> classifier;
  Triangulation<Audited<Classifier>> dt(points.begin(), points.end(), classifier);
  for (int frame = 0; frame < 50; ++frame) {
    cloud.shake(points, frame % 10 == 9 ? 0.5 : frame % 2 == 0 ? 0.01 : 1e-5);
    dt.update(points.begin(), points.end());
  }
  EXPECT_GT(classifier.audit->broken, 100u);
  EXPECT_EQ(classifier.audit->missed, 0u);
  EXPECT_EQ(classifier.audit->false_alarms, 0u);
}

TEST(Exact_classifiers_by_edges, name_no_edge_for_nothing)
{
  expect_no_edge_named_for_nothing<CGAL::Circumcircle_classifier_2>();
  expect_no_edge_named_for_nothing<CGAL::Safe_region_classifier_2>();
  expect_no_edge_named_for_nothing<Safe_and_circumcircle>();
}

TEST(Exact_coordinates, that_are_no_doubles_are_missed_by_no_exact_classifier)
{
  Cloud<Epeck> cloud(5);
  auto points = cloud.uniform(60);
  Audited<Safe_and_circumcircle> classifier;
  CGAL::Dynamic_Delaunay_triangulation_2<Epeck, Audited<Safe_and_circumcircle>> dt(
      points.begin(), points.end(), classifier);
  const Epeck::FT third = Epeck::FT(1) / 3;
  for (int frame = 0; frame < 12; ++frame) {
    cloud.shake(points, 0.02);
    if (frame % 3 == 1) // no double is a third
      points[7] = Epeck::Point_2(points[7].x() + third, points[7].y());
    dt.update(points.begin(), points.end());
    ASSERT_NO_FATAL_FAILURE(expect_exact(dt, points));
  }
  EXPECT_EQ(classifier.audit->missed, 0u);
}

// -------------------------------------------------------------------------------------------------
// The safe region.

// Counts how often a classifier asks for all edges, and how many it looks at one by one.
template <class Frame>
struct Counting_frame : Frame
{
  Counting_frame(const Frame& frame, std::size_t& passes, std::size_t& looks)
    : Frame(frame)
    , m_passes(passes)
    , m_looks(looks)
  {
  }

  const std::vector<Edge_2>& edges() const
  {
    ++m_passes;
    return Frame::edges();
  }

  template <class... Arguments>
  void append_unproved(Arguments&&... arguments) const
  {
    ++m_passes;
    Frame::append_unproved(std::forward<Arguments>(arguments)...);
  }

  auto edge_state(Edge_index e) const
  {
    ++m_looks;
    return Frame::edge_state(e);
  }

  std::size_t& m_passes;
  std::size_t& m_looks;
};

struct Counted_safe_region_classifier : Wrapped_classifier<CGAL::Safe_region_classifier_2>
{
  std::shared_ptr<std::array<std::size_t, 2>> counts =
      std::make_shared<std::array<std::size_t, 2>>();

  template <class Frame, class Classification>
  void operator()(const Frame& frame, Classification& classified)
  {
    classifier(Counting_frame<Frame>(frame, (*counts)[0], (*counts)[1]), classified);
  }
};

TEST(Safe_region_classifier, looks_at_nothing_while_vertices_stay_in_their_disks)
{
  Cloud<Epick> cloud(6);
  Points points = cloud.uniform(1000);
  Counted_safe_region_classifier classifier;
  Triangulation<Counted_safe_region_classifier> dt(points.begin(), points.end(), classifier);
  for (int frame = 0; frame < 50; ++frame) {
    cloud.shake(points, 1e-7);
    EXPECT_EQ(dt.update(points.begin(), points.end()).classified, 0u);
  }
  EXPECT_EQ((*classifier.counts)[0], 0u) << "a pass over all edges";
  EXPECT_LT((*classifier.counts)[1], 200u) << "edges";
}

TEST(Safe_region_classifier, looks_at_a_few_edges_where_a_few_vertices_move)
{
  Cloud<Epick> cloud(7);
  Points points = cloud.uniform(1000);
  Counted_safe_region_classifier classifier;
  Triangulation<Counted_safe_region_classifier> dt(points.begin(), points.end(), classifier);
  std::size_t classified = 0;
  for (int frame = 0; frame < 100; ++frame) {
    points[500] = cloud.shifted(points[500], 0.3);
    classified += dt.update(points.begin(), points.end()).classified;
    ASSERT_NO_FATAL_FAILURE(expect_exact(dt, points));
  }
  EXPECT_GT(classified, 50u);
  EXPECT_EQ((*classifier.counts)[0], 0u) << "a pass over all edges";
  EXPECT_LT((*classifier.counts)[1], 100u * 60u) << "edges";
}

// A vertex leaps and breaks edges; then a neighbor of its neighbor takes a step, which is safe only
// by disks that follow the changed edges.
template <class Repair>
void leap_and_step(const Repair& repair)
{
  Cloud<Epick> cloud(25);
  Points points = cloud.uniform(150);
  const Audited<CGAL::Safe_region_classifier_2> classifier;
  Triangulation<Audited<CGAL::Safe_region_classifier_2>, Repair> dt(points.begin(), points.end(),
                                                                    {classifier, repair});
  const auto neighbor = [&](std::size_t id) {
    const auto neighbors = neighbors_of(dt, id);
    return *std::next(neighbors.begin(), std::ptrdiff_t(cloud.random()() % neighbors.size()));
  };
  std::size_t id = 0;
  for (int frame = 0; frame < 6000; ++frame) {
    const bool leaps = frame % 2 == 0;
    id = leaps ? cloud.random()() % points.size() : neighbor(neighbor(id));
    const Epick::Point_2 p = cloud.shifted(points[id], leaps ? 0.5 : 0.15);
    if ((std::min)(p.x(), p.y()) > 0 && (std::max)(p.x(), p.y()) < 12)
      points[id] = p;
    try {
      dt.update(points.begin(), points.end());
    } catch (const Failure&) {
    }
  }
  EXPECT_GT(classifier.audit->broken, 5000u);
  EXPECT_EQ(classifier.audit->missed, 0u);
}

TEST(Safe_region_classifier, misses_nothing_near_what_was_flipped_before)
{
  leap_and_step(CGAL::Hold_and_flip_repair_2());
}

TEST(Safe_region_classifier, misses_nothing_near_what_was_spliced_before)
{
  leap_and_step(CGAL::Border_splice_repair_2());
}

TEST(Safe_region_classifier, misses_nothing_near_what_was_left_unrepaired)
{
  leap_and_step(Failing_repair());
}

TEST(Edge_slack, gives_the_largest_tolerance_that_is_safe)
{
  using CGAL::Dynamic_Delaunay_triangulations_2::internal::Edge_slack_2;
  Cloud<Epick> cloud(8);
  const Points points = cloud.uniform(500);
  const Triangulation<CGAL::Circumcircle_classifier_2> dt(points.begin(), points.end());
  const auto frame = dt.frame();
  for (Edge_index e(0); e < frame.number_of_edges(); ++e) {
    const Edge_slack_2 slack(frame.edge(e), frame.corners(e));
    const double t = slack.tolerance();
    ASSERT_GT(t, 0) << "edge " << e;
    ASSERT_TRUE(slack.is_safe(t));
    ASSERT_FALSE(slack.is_safe(t * 1.0001));
  }
  const Points grid = Cloud<Epick>::grid(5, 5);
  const Triangulation<CGAL::Circumcircle_classifier_2> tied(grid.begin(), grid.end());
  std::size_t without = 0;
  for (const Edge_2& edge : tied.frame().edges())
    without +=
        Edge_slack_2(edge, CGAL::Dynamic_Delaunay_triangulations_2::internal::Plane_2::corners(
                               edge, tied.frame().positions()))
            .tolerance() < 0;
  EXPECT_EQ(without, 16u + 16u - 4u) << "sixteen diagonals, and the way along the sides";
}

// -------------------------------------------------------------------------------------------------
// Refinement.

// Names the vertices and edges that it is given.
template <bool exact>
struct Scripted_classifier
{
  static constexpr bool is_exact = exact;
  std::vector<Vertex_index> vertices{};
  std::vector<Edge_index> edges{};

  template <class Frame, class Classification>
  void operator()(const Frame&, Classification& classified) const
  {
    for (const Vertex_index v : vertices)
      classified.add_vertex(v);
    for (const Edge_index e : edges)
      classified.add_edge(e);
  }
};

// Records the vertices and edges that a classifier has named.
template <class Classifier>
struct Noting_classifier : Wrapped_classifier<Classifier>
{
  static constexpr bool is_exact = false;
  std::shared_ptr<std::set<Vertex_index>> vertices = std::make_shared<std::set<Vertex_index>>();
  std::shared_ptr<std::set<Edge_index>> edges = std::make_shared<std::set<Edge_index>>();

  template <class Frame, class Classification>
  void operator()(const Frame& frame, Classification& classified)
  {
    this->classifier(frame, classified);
    vertices->insert(classified.whole_vertices().begin(), classified.whole_vertices().end());
    edges->insert(classified.edges().begin(), classified.edges().end());
  }
};

template <class Classifier>
Noting_classifier<Classifier> note(const Classifier& classifier, const Points& points)
{
  Noting_classifier<Classifier> noting{{classifier}};
  Triangulation<Noting_classifier<Classifier>> dt(points.begin(), points.end(), noting);
  dt.update(points.begin(), points.end());
  return noting;
}

TEST(Refined_classifier, keeps_what_both_pick)
{
  Cloud<Epick> cloud(9);
  const Points points = cloud.uniform(50);
  const Triangulation<CGAL::Circumcircle_classifier_2> dt(points.begin(), points.end());
  const auto frame = dt.frame();
  Edge_index e(0), f(0);
  while (frame.is_infinite(frame.edge(e)))
    ++e;
  const auto [v, w, left, right] = frame.edge(e);
  // an edge that shares no vertex with the first one
  for (;; ++f) {
    const Edge_2& other = frame.edge(f);
    const std::set<Vertex_index> all = {v, w, other.source, other.target};
    if (all.size() == 4 && all.count(Vertex_index(0)) == 0)
      break;
  }
  using Some = Scripted_classifier<false>;
  using Exact = Scripted_classifier<true>;
  using Vertices = std::set<Vertex_index>;
  using Edges = std::set<Edge_index>;

  const auto vertices =
      note(CGAL::Refined_classifier_2(Some{{v, left}, {}}, Some{{v, w}, {}}), points);
  EXPECT_EQ(*vertices.vertices, Vertices{v});
  EXPECT_EQ(*vertices.edges, Edges{});
  const auto by_end = note(CGAL::Refined_classifier_2(Some{{w}, {}}, Some{{}, {e, f}}), points);
  EXPECT_EQ(*by_end.vertices, Vertices{});
  EXPECT_EQ(*by_end.edges, Edges{e});
  const auto turned = note(CGAL::Refined_classifier_2(Some{{}, {e, f}}, Some{{w}, {}}), points);
  EXPECT_EQ(*turned.edges, Edges{e});
  const auto edges = note(CGAL::Refined_classifier_2(Some{{}, {e, f}}, Some{{}, {f}}), points);
  EXPECT_EQ(*edges.edges, Edges{f});
  const auto heuristic = note(CGAL::Refined_classifier_2(Some{{v}, {}}, Exact{{w}, {}}), points);
  EXPECT_EQ(*heuristic.edges, Edges{});
  const auto exact = note(CGAL::Refined_classifier_2(Exact{{v}, {}}, Exact{{w}, {}}), points);
  EXPECT_EQ(*exact.vertices, Vertices{});
  EXPECT_EQ(*exact.edges, Edges{e});
  const auto none = note(CGAL::Refined_classifier_2(Some{{v}, {e}}, Some{}), points);
  EXPECT_EQ(none.vertices->size() + none.edges->size(), 0u);
}

TEST(Refined_classifier, is_exact_only_if_both_are)
{
  using Exact = CGAL::Circumcircle_classifier_2;
  using Heuristic = CGAL::Point_distance_classifier_2;
  static_assert(Safe_and_circumcircle::is_exact);
  static_assert(!CGAL::Refined_classifier_2<Exact, Heuristic>::is_exact);
  static_assert(!CGAL::Refined_classifier_2<Heuristic, Exact>::is_exact);
  static_assert(!CGAL::Refined_classifier_2<Heuristic, Heuristic>::is_exact);
}

TEST(Refined_classifier, leaves_only_broken_edges_of_what_a_heuristic_picks)
{
  using Refined = CGAL::Refined_classifier_2<CGAL::Point_distance_classifier_2,
                                             CGAL::Circumcircle_classifier_2>;
  Cloud<Epick> cloud(10);
  Points points = cloud.uniform(500);
  Triangulation<CGAL::Point_distance_classifier_2> distance(
      points.begin(), points.end(), CGAL::Point_distance_classifier_2(0.95));
  Triangulation<Refined> refined(
      points.begin(), points.end(),
      Refined(CGAL::Point_distance_classifier_2(0.95), CGAL::Circumcircle_classifier_2()));
  Triangulation<CGAL::Circumcircle_classifier_2> exact(points.begin(), points.end());
  cloud.shake(points, 0.04);
  const auto all = distance.update(points.begin(), points.end()).classified;
  const auto some = refined.update(points.begin(), points.end()).classified;
  const auto broken = exact.update(points.begin(), points.end()).classified;
  EXPECT_GT(some, 10u);
  EXPECT_LT(some, all);
  EXPECT_LE(some, broken);
}

// Refines a classification edge by edge and as a whole, and compares the results.
template <class First, class Second>
struct Twofold_classifier
{
  static constexpr bool is_exact = false;
  First first;
  Second second;
  CGAL::Refined_classifier_2<First, Second> by_edges{first, second};
  CGAL::Refined_classifier_2<First, Wrapped_classifier<Second>> in_full{first, {second}};
  std::shared_ptr<std::size_t> kept = std::make_shared<std::size_t>(0);

  template <class Frame, class Classification>
  void operator()(const Frame& frame, Classification& classified)
  {
    Classification same = classified.empty_copy();
    by_edges(frame, classified);
    in_full(frame, same);
    const std::set<Index> edges(classified.edges().begin(), classified.edges().end());
    EXPECT_EQ(edges, std::set<Index>(same.edges().begin(), same.edges().end()));
    EXPECT_EQ(edges.size(), classified.edges().size()) << "an edge twice";
    EXPECT_EQ(edges.size(), same.edges().size()) << "an edge twice";
    EXPECT_EQ(classified.whole_vertices().size() + same.whole_vertices().size(), 0u);
    *kept += edges.size();
  }

  template <class Frame>
  void after_update(const Frame& frame)
  {
    by_edges.after_update(frame);
    in_full.after_update(frame);
  }
};

template <class First, class Second>
void expect_equal_refinements(const First& first, const Second& second)
{
  const Twofold_classifier<First, Second> classifier{first, second};
  Cloud<Epick> cloud(24);
  Points points = cloud.uniform(300);
  Triangulation<Twofold_classifier<First, Second>> dt(points.begin(), points.end(), classifier);
  for (int frame = 0; frame < 40; ++frame) {
    cloud.shake(points, 0.01);
    dt.update(points.begin(), points.end());
  }
  EXPECT_GT(*classifier.kept, 20u);
}

TEST(Refined_classifier, keeps_the_same_edges_whether_the_second_one_is_asked_for_all_or_one_by_one)
{
  const CGAL::Point_distance_classifier_2 distance(0.95);
  expect_equal_refinements(distance, CGAL::Circumcircle_classifier_2());
  expect_equal_refinements(distance, CGAL::Voronoi_circumcenter_classifier_2());
  expect_equal_refinements(distance, CGAL::Estimated_voronoi_circumcenter_classifier_2());
  expect_equal_refinements(distance, CGAL::Voronoi_edge_length_classifier_2(0.5));
  expect_equal_refinements(distance, CGAL::Nearly_delaunay_classifier_2(0.01));
  expect_equal_refinements(CGAL::Safe_region_classifier_2(), CGAL::Nearly_delaunay_classifier_2(0));
  expect_equal_refinements(CGAL::Circumcircle_classifier_2(),
                           CGAL::Voronoi_circumcenter_classifier_2());
}

// -------------------------------------------------------------------------------------------------
// Distances.

TEST(Inflation_aware_classifier, picks_no_vertex_while_everything_grows_and_point_distance_all)
{
  Cloud<Epick> cloud(11);
  const Points first = cloud.uniform(500);
  Triangulation<CGAL::Inflation_aware_classifier_2> aware(
      first.begin(), first.end(), CGAL::Inflation_aware_classifier_2(1 - 1e-9));
  Triangulation<CGAL::Point_distance_classifier_2> distance(first.begin(), first.end());
  std::size_t most = 0;
  double growth = 1;
  for (int frame = 0; frame < 200; ++frame) {
    growth *= 1.01;
    const Points points = turned(scaled<Epick>(first, growth), 0.1 * frame);
    EXPECT_EQ(aware.update(points.begin(), points.end()).classified, 0u);
    const auto report = distance.update(points.begin(), points.end());
    most = (std::max)(most, report.classified);
  }
  EXPECT_GT(growth, 7);
  EXPECT_GE(most, 495u);
  EXPECT_TRUE(aware.certify()) << "and no vertex had to be picked";
}

TEST(Inflation_aware_classifier, picks_the_ends_of_what_grows_otherwise_than_its_surroundings)
{
  // a hexagon around a center that leaves it
  Points points;
  for (int i = 0; i < 6; ++i)
    points.emplace_back(std::cos(i * 1.0471975511965976), std::sin(i * 1.0471975511965976));
  points.emplace_back(0.01, 0.02);
  Triangulation<CGAL::Inflation_aware_classifier_2> dt(points.begin(), points.end(),
                                                       CGAL::Inflation_aware_classifier_2(0.9));
  EXPECT_EQ(dt.update(points.begin(), points.end()).classified, 0u);
  points.back() = Epick::Point_2(0.4, 0.02);
  EXPECT_GT(dt.update(points.begin(), points.end()).classified, 2u);
}

TEST(Point_distance_classifier, picks_the_ends_of_every_edge_that_changed_at_all_if_x_is_1)
{
  Cloud<Epick> cloud(12);
  const Points points = cloud.uniform(300);
  for (const double step : {1e-12, 1e-3, 0.3})
    for (std::size_t id = 0; id < points.size(); id += 17) {
      Triangulation<CGAL::Point_distance_classifier_2> dt(points.begin(), points.end(),
                                                          CGAL::Point_distance_classifier_2(1));
      std::set<std::size_t> around = neighbors_of(dt, id);
      around.insert(id);
      Points moved = points;
      moved[id] = Epick::Point_2(moved[id].x() + step, moved[id].y() + step / 3);
      dt.update(moved.begin(), moved.end());
      const std::set<std::size_t> classified = classified_ids(dt);
      if (step == 0.3) // everything may have been rebuilt
        ASSERT_GE(around.size(), classified.size());
      else
        ASSERT_EQ(classified, around) << "id " << id << ", step " << step;
    }
}

// Thesis 6.2.6.
TEST(Point_distance_classifier, misses_what_two_far_clusters_change_when_they_turn_past_each_other)
{
  Cloud<Epick> cloud(13);
  const Points left = scaled<Epick>(cloud.uniform(40), 0.2);
  const Points right = scaled<Epick>(cloud.uniform(40), 0.2, 0);
  const auto both = [&](double angle) {
    Points points = turned(left, angle);
    for (const auto& p : turned(right, angle))
      points.emplace_back(p.x() + 100, p.y());
    return points;
  };
  Points points = both(0);
  Triangulation<CGAL::Point_distance_classifier_2> distance(points.begin(), points.end());
  Triangulation<CGAL::Circumcircle_classifier_2> exact(points.begin(), points.end());
  Triangulation<CGAL::Safe_region_classifier_2> safe_region(points.begin(), points.end());
  std::size_t classified = 0, certified = 0, flips = 0;
  double validity = 1;
  for (int frame = 1; frame <= 60; ++frame) {
    points = both(0.02 * frame);
    classified += distance.update(points.begin(), points.end()).classified;
    certified += distance.certify();
    flips += exact.update(points.begin(), points.end()).flips;
    safe_region.update(points.begin(), points.end());
    ASSERT_NO_FATAL_FAILURE(expect_exact(exact, points));
    ASSERT_NO_FATAL_FAILURE(expect_exact(safe_region, points));
    validity = CGAL::delaunay_agreement(distance, exact.triangulation())
                   .matthews_correlation_coefficient();
  }
  EXPECT_EQ(classified, 0u);
  EXPECT_LT(certified, 10u);
  EXPECT_LT(validity, 0.97);
  EXPECT_GT(flips, 10u);
}

// -------------------------------------------------------------------------------------------------
// Prediction.

TEST(Point_distance_times, are_those_of_the_thesis_where_an_edge_is_stretched_lengthwise)
{
  using Times = CGAL::Point_distance_times_2;
  // of length 10 when it was triangulated, now 9, changing by 0.5 a frame
  const Times shrinking(0.8, 100, 9, 0, -0.5, 0);
  EXPECT_NEAR(shrinking.t_min(), (9 - 8) / 0.5, 1e-9);
  EXPECT_EQ(shrinking.first_frame(), 2) << "a margin before, as 2 is on the edge";
  const Times growing(0.8, 100, 9, 0, 0.5, 0);
  EXPECT_NEAR(growing.t_max(), (12 - 9) / 0.5, 1e-9);
  EXPECT_EQ(growing.t_min(), Times::never);
  EXPECT_EQ(growing.t_t(), growing.t_max());
  EXPECT_EQ(Times(0.8, 100, 9, 0, 0, 0).t_t(), Times::never);
  EXPECT_EQ(Times(1, 100, 10, 0, 0, 0).first_frame(), Times::never);
  EXPECT_EQ(Times(0.8, 100, 7, 0, 0, 0).t_t(), 0) << "out of range already";
  EXPECT_EQ(Times(0.8, 100, 13, 0, 0, 0).first_frame(), 1);
  EXPECT_EQ(Times(0, 100, 10, 1, -10, -1).t_min(), Times::never) << "nothing is too short at 0";
}

TEST(Point_distance_times, give_the_first_frame_that_stepping_frame_by_frame_finds)
{
  std::mt19937 random(14);
  std::uniform_real_distribution<double> coordinate(-1, 1), share(0, 1);
  constexpr int last_frame = 10000;
  std::size_t finite = 0, passed_between_frames = 0;
  for (int i = 0; i < 20000; ++i) {
    const double x = i % 10 == 0 ? 1 : i % 10 == 1 ? 0 : share(random);
    const double px = coordinate(random), py = coordinate(random);
    const double length = std::hypot(px, py);
    const double reference = i % 3 == 0 ? length : length * (x + (2 - 2 * x) * share(random));
    const double speed = std::pow(10, -3 * share(random));
    const double vx = speed * coordinate(random), vy = speed * coordinate(random);
    if (!(length >= x * reference && length <= (2 - x) * reference))
      continue;
    const CGAL::Point_distance_times_2 times(x, reference * reference, px, py, vx, vy);
    const double predicted = times.first_frame();
    double stepped = CGAL::Point_distance_times_2::never;
    double margin = 1; // how close to its range the length has come before
    for (int frame = 1; frame <= last_frame; ++frame) {
      const double now = std::hypot(px + frame * vx, py + frame * vy);
      if (now < x * reference || now > (2 - x) * reference) {
        stepped = frame;
        break;
      }
      margin = (std::min)({margin, now / reference - x, 2 - x - now / reference});
    }
    ASSERT_LE(predicted, stepped) << "never late";
    if ((margin > 1e-9 || x == 1) && predicted < last_frame) {
      ASSERT_EQ(predicted, stepped) << "x " << x << ", p " << px << " " << py << ", v " << vx << " "
                                    << vy << ", reference " << reference;
    }
    finite += stepped <= last_frame;
    passed_between_frames += times.t_min() < stepped - 1;
  }
  EXPECT_GT(finite, 5000u);
  EXPECT_GT(passed_between_frames, 20u) << "too short, but in no frame";
}

struct Velocities
{
  const Drift* drift;
  Position_2 operator()(Index id) const { return drift->velocity(id); }
};

TEST(Point_distance_classifier, predicts_the_frame_in_which_it_picks_a_vertex)
{
  Cloud<Epick> cloud(15);
  for (int trial = 0; trial < 20; ++trial) {
    const Drift drift(cloud, 200, 0.002);
    const Points start = drift.points(0);
    Triangulation<CGAL::Point_distance_classifier_2> dt(start.begin(), start.end());
    int now = 0;
    for (int round = 0; round < 3; ++round) { // also with references of different ages
      const double predicted = dt.classifier().predict(dt.frame(), Velocities{&drift});
      ASSERT_LT(predicted, 100000);
      for (int frame = 1; frame <= int(predicted); ++frame) {
        const Points points = drift.points(++now);
        const auto classified = dt.update(points.begin(), points.end()).classified;
        ASSERT_EQ(classified > 0, frame == int(predicted)) << "frame " << frame;
      }
    }
  }
}

TEST(Predictive_point_distance_classifier, looks_only_when_point_distance_would_classify_a_vertex)
{
  Cloud<Epick> cloud(16);
  const Drift drift(cloud, 100, 2e-4);
  Points points = drift.points(0);
  using Predictive = CGAL::Predictive_point_distance_classifier_2<Velocities>;
  Triangulation<CGAL::Point_distance_classifier_2> plain(points.begin(), points.end());
  Triangulation<Predictive> predictive(points.begin(), points.end(),
                                       Predictive(Velocities{&drift}));
  std::size_t quiet = 0, picked = 0;
  for (int frame = 1; frame <= 2000; ++frame) {
    points = drift.points(frame);
    const bool is_quiet = predictive.classifier().number_of_quiet_frames() > 0;
    const auto expected = plain.update(points.begin(), points.end());
    const auto report = predictive.update(points.begin(), points.end());
    ASSERT_EQ(report.classified, expected.classified) << "frame " << frame;
    ASSERT_EQ(report.spliced, expected.spliced) << "frame " << frame;
    ASSERT_TRUE(!is_quiet || report.classified == 0) << "frame " << frame;
    quiet += is_quiet;
    picked += report.classified > 0;
  }
  EXPECT_GT(picked, 50u);
  EXPECT_GT(quiet, 1000u);
  ASSERT_NO_FATAL_FAILURE(expect_valid(predictive, points));
}

// -------------------------------------------------------------------------------------------------
// Circumcenters.

// Any number of edges that share no vertices.
struct Loose_edges
{
  using Edge_index = CGAL::Dynamic_Delaunay_triangulations_2::Edge_index;
  using Edge = Edge_2;
  std::vector<Position_2> m_positions{{std::nan(""), std::nan("")}};
  std::vector<Edge_2> m_edges{};

  Index number_of_edges() const { return Index(m_edges.size()); }
  const Edge_2& edge(Edge_index e) const { return m_edges[e]; }
  const Position_2& position(Vertex_index v) const { return m_positions[v]; }
  const std::vector<Position_2>& positions() const { return m_positions; }
  bool is_at_infinity(Edge_index) const { return false; }
  bool breaks_hull(Edge_index) const { return false; }
  CGAL::Dynamic_Delaunay_triangulations_2::Edge_corners_2 corners(Edge_index e) const
  {
    using CGAL::Dynamic_Delaunay_triangulations_2::internal::Plane_2;
    return Plane_2::corners(m_edges[e], m_positions);
  }
};

struct Picked_edges
{
  std::set<Index> edges{};
  void add_edge(Edge_index e) { edges.insert(e); }
};

TEST(Voronoi_circumcenter_classifier, agrees_with_the_in_circle_predicate_away_from_ties)
{
  std::mt19937 random(16);
  std::uniform_real_distribution<double> coordinate(-1, 1);
  std::size_t broken = 0, whole = 0, inverted = 0;
  for (int i = 0; i < 200000; ++i) {
    Loose_edges frame;
    Epick::Point_2 p[4];
    for (auto& q : p) {
      const double x = coordinate(random);
      q = Epick::Point_2(x, coordinate(random));
      frame.m_positions.push_back({q.x(), q.y()});
    }
    // both ways to write down the edge from 0 to 1, with 2 to its left and 3 to its right
    const Vertex_index source(1), target(2), left(3), right(4);
    frame.m_edges = {{source, target, left, right}, {target, source, right, left}};
    Picked_edges picked;
    CGAL::Voronoi_circumcenter_classifier_2()(frame, picked);
    const bool are_left_turns = CGAL::orientation(p[2], p[0], p[1]) == CGAL::LEFT_TURN &&
                                CGAL::orientation(p[3], p[1], p[0]) == CGAL::LEFT_TURN;
    const CGAL::Dynamic_Delaunay_triangulations_2::internal::Edge_filter_2 filter(
        frame.corners(Edge_index(0)));
    const double smallest = (std::min)({std::abs(filter.left), std::abs(filter.right), 1.});
    if (std::abs(filter.in_circle) < 1e-12 || smallest < 1e-6)
      continue; // a tie, or nearly no triangle
    const bool is_broken = !are_left_turns || CGAL::side_of_oriented_circle(
                                                  p[2], p[0], p[1], p[3]) == CGAL::ON_POSITIVE_SIDE;
    ASSERT_EQ(picked.edges.size(), is_broken ? 2u : 0u) << "quadrilateral " << i;
    inverted += !are_left_turns;
    broken += are_left_turns && is_broken;
    whole += !is_broken;
  }
  EXPECT_GT(inverted, 10000u);
  EXPECT_GT(broken, 10000u);
  EXPECT_GT(whole, 10000u);
}

TEST(Circumcenters, are_the_same_from_each_vertex_in_each_order)
{
  using namespace CGAL::Dynamic_Delaunay_triangulations_2::internal;
  std::mt19937 random(17);
  std::uniform_real_distribution<double> coordinate(-1, 1);
  for (int i = 0; i < 10000; ++i) {
    std::array<Position_2, 3> p;
    for (auto& q : p) {
      q.x = coordinate(random);
      q.y = coordinate(random);
    }
    if (std::abs(cross(p[1] - p[0], p[2] - p[0])) < 1e-3)
      continue;
    const auto known =
        CGAL::circumcenter(Epick::Point_2(p[0].x, p[0].y), Epick::Point_2(p[1].x, p[1].y),
                           Epick::Point_2(p[2].x, p[2].y));
    std::array<int, 3> order = {0, 1, 2};
    do {
      const Position_2& origin = p[std::size_t(order[0])];
      const Position_2 center =
          circumcenter(p[std::size_t(order[1])] - origin, p[std::size_t(order[2])] - origin);
      ASSERT_NEAR(origin.x + center.x, known.x(), 1e-6);
      ASSERT_NEAR(origin.y + center.y, known.y(), 1e-6);
    } while (std::next_permutation(order.begin(), order.end()));
  }
}

TEST(Voronoi_circumcenter_classifier, agrees_with_the_exact_one_on_moving_clouds_and_their_hulls)
{
  using Classifier = Audited<CGAL::Voronoi_circumcenter_classifier_2>;
  const Classifier classifier;
  const Audit& audit = *classifier.audit;
  for (const double step : {1e-3, 0.03, 0.3}) {
    SCOPED_TRACE(testing::Message() << "step " << step);
    Cloud<Epick> cloud(18);
    Points points = cloud.uniform(400);
    Triangulation<Classifier, CGAL::Hold_and_flip_repair_2> dt(points.begin(), points.end(),
                                                               classifier);
    for (int frame = 0; frame < 30; ++frame) {
      cloud.shake(points, step);
      dt.update(points.begin(), points.end());
      EXPECT_EQ(audit.missed, 0u) << "frame " << frame;
      EXPECT_EQ(audit.false_alarms, 0u) << "frame " << frame;
      EXPECT_TRUE(dt.certify());
    }
  }
  EXPECT_GT(audit.edges, 100000u);
  EXPECT_GT(audit.broken, 10000u);
  EXPECT_EQ(audit.named, audit.broken);
}

TEST(Estimated_voronoi_circumcenter_classifier, follows_translations)
{
  Cloud<Epick> cloud(19);
  const Points first = cloud.uniform(400);
  Triangulation<CGAL::Estimated_voronoi_circumcenter_classifier_2> dt(first.begin(), first.end());
  for (int frame = 1; frame < 100; ++frame) {
    Points points;
    for (const auto& p : first)
      points.emplace_back(p.x() + 0.5 * frame, p.y() - 0.25 * frame);
    EXPECT_EQ(dt.update(points.begin(), points.end()).classified, 0u);
  }
}

// -------------------------------------------------------------------------------------------------
// What classifiers remember.

using Key = std::pair<std::size_t, std::size_t>; // of an edge: ids; 0 is at infinity

template <class Frame>
std::size_t key(const Frame& frame, Vertex_index v)
{
  return frame.is_infinite(v) ? 0 : 1 + frame.id(v);
}

template <class Frame>
Key key(const Frame& frame, const Edge_2& edge)
{
  return std::minmax({key(frame, edge.source), key(frame, edge.target)});
}

// The ends and opposite vertices of each edge index, and the vertices of each face index, by ids.
struct Snapshot
{
  std::vector<std::array<Key, 2>> edges{};
  std::vector<std::array<std::size_t, 3>> faces{};

  template <class Frame>
  void take(const Frame& frame)
  {
    edges.clear();
    faces.clear();
    for (const Edge_2& edge : frame.edges())
      edges.push_back(
          {key(frame, edge), std::minmax({key(frame, edge.left), key(frame, edge.right)})});
    for (Face_index f(0); f < frame.number_of_faces(); ++f) {
      const auto vertices = frame.face(f);
      faces.push_back({key(frame, vertices[0]), key(frame, vertices[1]), key(frame, vertices[2])});
      std::sort(faces.back().begin(), faces.back().end());
    }
  }
};

struct News
{
  Snapshot before{}, now{};
  std::size_t changed_edges = 0, changed_sides = 0, changed_faces = 0;

  // Expects that every difference between two snapshots is announced.
  template <class Frame>
  void check(const Frame& frame)
  {
    now.take(frame);
    std::set<Index> edges, faces;
    frame.for_each_changed_edge([&](Edge_index e) { edges.insert(e); });
    frame.for_each_changed_face([&](Face_index f) { faces.insert(f); });
    if (frame.everything_is_new()) {
      EXPECT_EQ(edges.size(), frame.number_of_edges());
      EXPECT_EQ(faces.size(), frame.number_of_faces());
    } else {
      frame.follow_edges(before.edges);
      frame.follow_faces(before.faces);
      const std::set<Index> new_edges(frame.new_edges().begin(), frame.new_edges().end());
      for (Edge_index e(0); e < frame.number_of_edges(); ++e)
        if (now.edges[e] != before.edges[e]) {
          EXPECT_EQ(edges.count(e), 1u) << "edge " << e;
          ++changed_edges;
          changed_sides += new_edges.count(e) == 0;
        }
      for (Face_index f(0); f < frame.number_of_faces(); ++f)
        if (now.faces[f] != before.faces[f]) {
          EXPECT_EQ(faces.count(f), 1u) << "face " << f;
          ++changed_faces;
        }
    }
    for (Edge_index e(0); e < frame.number_of_edges(); ++e) {
      const auto [left, right] = frame.faces_at(e);
      const auto of_left = frame.face(left), of_right = frame.face(right);
      EXPECT_EQ(std::count(of_left.begin(), of_left.end(), frame.edge(e).left), 1);
      EXPECT_EQ(std::count(of_right.begin(), of_right.end(), frame.edge(e).right), 1);
    }
    std::swap(before, now);
  }
};

struct Changes_classifier : Wrapped_classifier<CGAL::Point_distance_classifier_2>
{
  std::shared_ptr<News> news = std::make_shared<News>();

  template <class Frame>
  void after_update(const Frame& frame)
  {
    classifier.after_update(frame);
    news->check(frame);
  }
};

double length(const Position_2& p, const Position_2& q)
{
  return std::hypot(p.x - q.x, p.y - q.y);
}

Epick::Point_2 point(const Position_2& p)
{
  return Epick::Point_2(p.x, p.y);
}

template <class Frame>
bool is_at_infinity(const Frame& frame, const Edge_2& edge)
{
  return frame.is_infinite(edge) || frame.is_infinite(edge.left) || frame.is_infinite(edge.right);
}

template <class Frame>
bool is_left_turn(const Frame& frame, Vertex_index a, Vertex_index b, Vertex_index c)
{
  return CGAL::orientation(point(frame.position(a)), point(frame.position(b)),
                           point(frame.position(c))) == CGAL::LEFT_TURN;
}

// The signed distance between c1, to the right of the edge, and c2, to its left: negative once they
// have passed each other.
template <class Frame>
double gap(const Frame& frame, const Edge_2& edge, const Epick::Point_2& c1,
           const Epick::Point_2& c2)
{
  const Position_2 &p = frame.position(edge.source), &q = frame.position(edge.target);
  return ((c1.x() - c2.x()) * (q.y - p.y) - (c1.y() - c2.y()) * (q.x - p.x)) / length(p, q);
}

// Calls f with each edge that was not there in the last frame.
template <class Frame, class Function>
void for_each_new_edge(const Frame& frame, const Function& f)
{
  if (frame.everything_is_new())
    for (const Edge_2& edge : frame.edges())
      f(edge);
  else
    for (const Edge_index e : frame.new_edges())
      f(frame.edge(e));
}

// Each model computes by how much an edge is inside of its bound, from references that it keeps by
// ids and may renew before it is asked. Positive: the edge must not be picked. Infinite: either is
// right.
struct Model_of_edges
{
  template <class Frame>
  void begin(const Frame&)
  {
  }
};

struct Point_distance_model : Model_of_edges
{
  using Classifier = CGAL::Point_distance_classifier_2;
  static Classifier classifier() { return Classifier(0.9); }
  std::map<Key, double> references{};

  template <class Frame>
  double slack(const Frame& frame, Edge_index e) const
  {
    const Edge_2& edge = frame.edge(e);
    if (frame.is_infinite(edge))
      return 1;
    const double growth = length(frame.position(edge.source), frame.position(edge.target)) /
                          references.at(key(frame, edge));
    return (std::min)(growth - 0.9, 1.1 - growth);
  }

  template <class Frame>
  void end(const Frame& frame)
  {
    for_each_new_edge(frame, [&](const Edge_2& edge) {
      references[key(frame, edge)] =
          length(frame.position(edge.source), frame.position(edge.target));
    });
  }
};

// The product of relative growths from frame to frame.
struct Inflation_aware_model
{
  using Classifier = CGAL::Inflation_aware_classifier_2;
  static Classifier classifier() { return Classifier(0.9); }
  std::map<Key, double> growths{};
  std::vector<Position_2> last{}; // by ids

  template <class Frame, class Place>
  static double relative_length(const Frame& frame, const Edge_2& edge, const Place& place)
  {
    double sum = 0;
    int edges = 0;
    for (const Vertex_index v : {edge.source, edge.target})
      frame.for_each_neighbor(v, [&](Vertex_index w) {
        if (!frame.is_infinite(w) && w != edge.source && w != edge.target) {
          sum += std::pow(length(place(v), place(w)), 2);
          ++edges;
        }
      });
    return length(place(edge.source), place(edge.target)) / std::sqrt(sum / edges);
  }

  template <class Frame>
  void begin(const Frame& frame)
  {
    for (const Edge_2& edge : frame.edges())
      if (!frame.is_infinite(edge))
        growths.at(key(frame, edge)) *=
            relative_length(frame, edge, [&](Vertex_index v) { return frame.position(v); }) /
            relative_length(frame, edge, [&](Vertex_index v) { return last[frame.id(v)]; });
  }

  template <class Frame>
  double slack(const Frame& frame, Edge_index e) const
  {
    if (frame.is_infinite(frame.edge(e)))
      return 1;
    const double growth = growths.at(key(frame, frame.edge(e)));
    return (std::min)(growth - 0.9, 1.1 - growth);
  }

  template <class Frame>
  void end(const Frame& frame)
  {
    for_each_new_edge(frame, [&](const Edge_2& edge) { growths[key(frame, edge)] = 1; });
    last.resize(frame.number_of_points());
    for (Vertex_index v(1); v <= frame.number_of_vertices(); ++v)
      last[frame.id(v)] = frame.position(v);
  }
};

struct Voronoi_edge_length_model : Model_of_edges
{
  using Classifier = CGAL::Voronoi_edge_length_classifier_2;
  static Classifier classifier() { return Classifier(0.5); }
  std::map<Key, double> limits{};

  template <class Frame>
  static double stretch(const Frame& frame, const Edge_2& edge)
  {
    return length(frame.position(edge.source), frame.position(edge.target)) -
           length(frame.position(edge.left), frame.position(edge.right));
  }

  template <class Frame>
  double slack(const Frame& frame, Edge_index e) const
  {
    const Edge_2& edge = frame.edge(e);
    if (is_at_infinity(frame, edge))
      return std::numeric_limits<double>::infinity();
    return limits.at(key(frame, edge)) - stretch(frame, edge);
  }

  template <class Frame>
  void end(const Frame& frame)
  {
    frame.for_each_changed_edge([&](Edge_index e) {
      const Edge_2& edge = frame.edge(e);
      if (is_at_infinity(frame, edge))
        return;
      const auto at = [&](Vertex_index v) { return point(frame.position(v)); };
      const bool is_sound = is_left_turn(frame, edge.left, edge.source, edge.target) &&
                            is_left_turn(frame, edge.right, edge.target, edge.source);
      limits[key(frame, edge)] =
          is_sound
              ? stretch(frame, edge) +
                    0.5 * gap(frame, edge,
                              CGAL::circumcenter(at(edge.right), at(edge.target), at(edge.source)),
                              CGAL::circumcenter(at(edge.left), at(edge.source), at(edge.target)))
              : -(std::numeric_limits<double>::max)();
    });
  }
};

struct Estimated_circumcenter_model : Model_of_edges
{
  using Classifier = CGAL::Estimated_voronoi_circumcenter_classifier_2;
  static Classifier classifier() { return Classifier(); }
  using Triple = std::array<std::size_t, 3>;
  struct Old_face
  {
    Epick::Point_2 circumcenter, mean;
  };
  std::map<Triple, Old_face> faces{};

  template <class Frame>
  static Triple triple(const Frame& frame, Face_index f)
  {
    const auto v = frame.face(f);
    Triple result = {key(frame, v[0]), key(frame, v[1]), key(frame, v[2])};
    std::sort(result.begin(), result.end());
    return result;
  }

  template <class Frame>
  static Epick::Point_2 mean(const Frame& frame, Face_index f)
  {
    const auto v = frame.face(f);
    return CGAL::centroid(point(frame.position(v[0])), point(frame.position(v[1])),
                          point(frame.position(v[2])));
  }

  template <class Frame>
  double slack(const Frame& frame, Edge_index e) const
  {
    if (is_at_infinity(frame, frame.edge(e)))
      return std::numeric_limits<double>::infinity();
    const auto estimate = [&](Face_index f) {
      const Old_face& old = faces.at(triple(frame, f));
      return old.circumcenter + (mean(frame, f) - old.mean);
    };
    const auto [left, right] = frame.faces_at(e);
    return gap(frame, frame.edge(e), estimate(right), estimate(left));
  }

  template <class Frame>
  void end(const Frame& frame)
  {
    frame.for_each_changed_face([&](Face_index f) {
      const auto v = frame.face(f);
      if (std::count(v.begin(), v.end(), 0u) == 0)
        faces[triple(frame, f)] = {CGAL::circumcenter(point(frame.position(v[0])),
                                                      point(frame.position(v[1])),
                                                      point(frame.position(v[2]))),
                                   mean(frame, f)};
    });
  }
};

// Compares what a classifier picks with what its model expects.
template <class Model>
struct Modelled
{
  static constexpr bool is_exact = false;
  typename Model::Classifier classifier = Model::classifier();
  std::shared_ptr<Model> model = std::make_shared<Model>();
  std::shared_ptr<std::array<std::size_t, 3>> counts =
      std::make_shared<std::array<std::size_t, 3>>();

  template <class Frame, class Classification>
  void operator()(const Frame& frame, Classification& classified)
  {
    classifier(frame, classified);
    model->begin(frame);
    const std::set<Index> named(classified.edges().begin(), classified.edges().end());
    for (Edge_index e(0); e < frame.number_of_edges(); ++e) {
      const double slack = model->slack(frame, e);
      const auto& edge = frame.edge(e);
      const bool is_picked = named.count(e) > 0 || (classified.is_whole_vertex(edge.source) &&
                                                    classified.is_whole_vertex(edge.target));
      if (slack < -1e-7) {
        EXPECT_TRUE(is_picked) << "edge " << e << ": " << slack;
      } else if (slack > 1e-7 && slack < 1e300 && !named.empty()) {
        EXPECT_FALSE(is_picked) << "edge " << e << ": " << slack;
      }
      ++(*counts)[slack < -1e-7 ? 0 : slack > 1e-7 ? 1 : 2];
    }
    expect_vertices_of(frame, classified);
  }

  // Expects that no vertex is named in vain.
  template <class Frame, class Classification>
  void expect_vertices_of(const Frame& frame, const Classification& classified) const
  {
    for (const Vertex_index v : classified.whole_vertices()) {
      double smallest = 1;
      frame.for_each_incident_edge(
          v, [&](Edge_index e) { smallest = (std::min)(smallest, model->slack(frame, e)); });
      EXPECT_LT(smallest, 1e-7) << "vertex " << v;
    }
  }

  template <class Frame>
  void after_update(const Frame& frame)
  {
    classifier.after_update(frame);
    model->end(frame);
  }
};

// Rough and calm motion, a few teleports, meetings and mirrorings, under one repair.
template <class Classifier, class Repair>
void lead_through_everything(const Classifier& classifier, unsigned seed)
{
  Cloud<Epick> cloud(seed);
  Points points = cloud.uniform(150);
  Triangulation<Classifier, Repair> dt(points.begin(), points.end(), classifier);
  for (int frame = 0; frame < 60; ++frame) {
    cloud.shake(points, frame % 20 == 10 ? 0.1 : 0.004);
    if (frame % 15 == 7)
      points[3] = cloud.shifted(points[100], 0.2);
    if (frame == 33)
      points[5] = points[60];
    if (frame == 44)
      for (auto& p : points)
        p = Epick::Point_2(-p.x(), p.y());
    dt.update(points.begin(), points.end());
    if (frame == 50)
      dt.mend();
    ASSERT_NO_FATAL_FAILURE(expect_valid(dt, points));
  }
}

template <class Classifier>
void lead_through_everything_with_every_repair(const Classifier& classifier)
{
  for (unsigned seed = 0; seed < 3; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    lead_through_everything<Classifier, CGAL::Border_splice_repair_2>(classifier, seed);
    lead_through_everything<Classifier, CGAL::Flip_repair_2>(classifier, seed);
    lead_through_everything<Classifier, CGAL::Hold_and_flip_repair_2>(classifier, seed);
    lead_through_everything<Classifier, CGAL::Relocation_repair_2>(classifier, seed);
    lead_through_everything<Classifier, CGAL::Rebuild_repair_2>(classifier, seed);
  }
}

TEST(Frames, announce_every_edge_and_face_that_flips_splices_and_rebuilds_have_changed)
{
  const Changes_classifier classifier{{CGAL::Point_distance_classifier_2(0.9)}};
  lead_through_everything_with_every_repair(classifier);
  EXPECT_GT(classifier.news->changed_edges, 1000u);
  EXPECT_GT(classifier.news->changed_sides, 100u) << "not new, but another opposite vertex";
  EXPECT_GT(classifier.news->changed_faces, 1000u);
}

template <class Model>
class Remembering_classifiers : public testing::Test
{
};

using All_models = testing::Types<Point_distance_model, Inflation_aware_model,
                                  Voronoi_edge_length_model, Estimated_circumcenter_model>;
TYPED_TEST_SUITE(Remembering_classifiers, All_models);

TYPED_TEST(Remembering_classifiers, remember_the_right_edge_through_flips_splices_and_rebuilds)
{
  Modelled<TypeParam> classifier;
  lead_through_everything_with_every_repair(classifier);
  const auto [picked, left_alone, too_close] = *classifier.counts;
  EXPECT_GT(picked, 1000u);
  EXPECT_GT(left_alone, 50000u);
  EXPECT_LT(100 * too_close, left_alone);
}

TEST(Voronoi_edge_length_classifier, sees_vertices_part_and_approach_but_nothing_turn_or_travel)
{
  // a rhombus whose Voronoi edge is about as long as its sides
  const Points points = {{-0.5, 0}, {0.5, 0}, {0.01, 0.87}, {0, -0.87},
                         {-9, 1},   {9, 2},   {1, 12},      {0, -11}};
  using Dynamic = Triangulation<CGAL::Voronoi_edge_length_classifier_2>;
  const auto classified = [&](const Points& moved) {
    Dynamic dt(points.begin(), points.end(), CGAL::Voronoi_edge_length_classifier_2(0.5));
    return dt.update(moved.begin(), moved.end()).classified;
  };
  EXPECT_EQ(classified(points), 0u);
  Points travelled;
  for (const auto& p : turned(points, 2))
    travelled.emplace_back(p.x() + 100, p.y());
  EXPECT_EQ(classified(travelled), 0u);
  Points parted = points, approached = points;
  parted[0] = Epick::Point_2(-0.95, 0);
  approached[2] = Epick::Point_2(0.01, 0.4);
  EXPECT_GE(classified(parted), 4u);
  EXPECT_GE(classified(approached), 4u);
}

// -------------------------------------------------------------------------------------------------
// Chance.

TEST(Random_classifier, picks_the_same_p_of_all_points_under_the_same_seed)
{
  Cloud<Epick> cloud(20);
  const Points points = cloud.uniform(1000);
  using Dynamic = Triangulation<CGAL::Random_classifier_2>;
  for (const double p : {0., 0.0025, 0.02}) {
    Dynamic first(points.begin(), points.end(), CGAL::Random_classifier_2(p, 5));
    Dynamic same(points.begin(), points.end(), CGAL::Random_classifier_2(p, 5));
    Dynamic other(points.begin(), points.end(), CGAL::Random_classifier_2(p, 6));
    double total = 0;
    bool differs = false;
    for (int frame = 0; frame < 100; ++frame) {
      total += double(first.update(points.begin(), points.end()).classified);
      same.update(points.begin(), points.end());
      other.update(points.begin(), points.end());
      ASSERT_EQ(classified_ids(first), classified_ids(same));
      differs = differs || classified_ids(first) != classified_ids(other);
    }
    EXPECT_EQ(differs, p > 0);
    const double mean = 100 * 1000 * p;
    EXPECT_NEAR(total, mean, 5 * std::sqrt(mean * (1 - p)));
  }
  Dynamic all(points.begin(), points.end(), CGAL::Random_classifier_2(1));
  EXPECT_EQ(all.update(points.begin(), points.end()).classified, 1000u);
}

// -------------------------------------------------------------------------------------------------
// Nearly Delaunay.

struct Nearness
{
  std::size_t edges = 0, not_delaunay = 0, violations = 0, inverted = 0;
};

// Computed by exact constructions, from CGAL's faces alone.
template <class Dynamic>
Nearness nearness(const Dynamic& dt, double eps)
{
  const auto& tds = dt.tds();
  const auto at = [](auto v) { return Epeck::Point_2(v->point().x(), v->point().y()); };
  const auto is_infinite = [&](auto f) { return f->has_vertex(dt.infinite_vertex()); };
  const Epeck::FT share = (1 - Epeck::FT(eps)) * (1 - Epeck::FT(eps));
  Nearness result;
  for (auto f = tds.faces_begin(); f != tds.faces_end(); ++f) {
    if (is_infinite(f))
      continue;
    const auto &p = f->vertex(0)->point(), &q = f->vertex(1)->point(), &r = f->vertex(2)->point();
    if (CGAL::orientation(p, q, r) != CGAL::LEFT_TURN) {
      ++result.inverted;
      continue;
    }
    for (int i = 0; i < 3; ++i) {
      const auto g = f->neighbor(i);
      if (is_infinite(g))
        continue;
      const auto d = g->vertex(g->index(f));
      ++result.edges;
      if (CGAL::side_of_oriented_circle(p, q, r, d->point()) != CGAL::ON_POSITIVE_SIDE)
        continue;
      ++result.not_delaunay;
      const Epeck::Point_2 o =
          CGAL::circumcenter(at(f->vertex(0)), at(f->vertex(1)), at(f->vertex(2)));
      result.violations +=
          CGAL::squared_distance(o, at(d)) < share * CGAL::squared_distance(o, at(f->vertex(0)));
    }
  }
  return result;
}

TEST(Nearly_delaunay_classifier, keeps_its_bound_at_every_edge_of_every_frame)
{
  using Dynamic = Triangulation<CGAL::Nearly_delaunay_classifier_2>;
  static_assert(std::is_same_v<Dynamic::Delaunay_repair, CGAL::Hold_and_flip_repair_2>);
  for (const double eps : {1e-6, 0.01, 0.1, 0.5, 1.}) {
    Nearness total;
    std::size_t flips = 0, exact_flips = 0;
    for (const double step : {1e-3, 0.02, 0.05, 0.5}) {
      SCOPED_TRACE(testing::Message() << "eps " << eps << ", step " << step);
      Cloud<Epick> cloud(21);
      Points points = step == 0.02 ? cloud.grid(12, 12) : cloud.uniform(150);
      Dynamic dt(points.begin(), points.end(), CGAL::Nearly_delaunay_classifier_2(eps));
      Triangulation<CGAL::Circumcircle_classifier_2> exact(points.begin(), points.end());
      for (int frame = 0; frame < 60; ++frame) {
        cloud.shake(points, step);
        if (frame == 40)
          points = scaled<Epick>(points, 1, 1e6);
        flips += dt.update(points.begin(), points.end()).flips;
        exact_flips += exact.update(points.begin(), points.end()).flips;
        ASSERT_NO_FATAL_FAILURE(expect_valid(dt, points));
        const Nearness now = nearness(dt, eps);
        ASSERT_EQ(now.violations, 0u) << "frame " << frame;
        ASSERT_EQ(now.inverted, 0u) << "frame " << frame;
        total.edges += now.edges;
        total.not_delaunay += now.not_delaunay;
      }
    }
    if (eps >= 0.01) {
      EXPECT_GT(total.not_delaunay, 100u) << "else the bound bounds nothing";
      EXPECT_LT(flips, exact_flips);
    }
  }
}

// The edges at the boundary of a splice have to be examined, too.
TEST(Nearly_delaunay_classifier, keeps_its_bound_where_flips_get_stuck_and_regions_are_spliced)
{
  std::size_t splices = 0;
  for (unsigned seed = 0; seed < 4; ++seed) {
    Cloud<Epick> cloud(seed);
    Points points = cloud.uniform(300);
    Triangulation<CGAL::Nearly_delaunay_classifier_2> dt(points.begin(), points.end());
    for (int frame = 0; frame < 100; ++frame) {
      cloud.shake(points, 0.1);
      splices += dt.update(points.begin(), points.end()).splices;
      const Nearness now = nearness(dt, dt.classifier().eps());
      ASSERT_EQ(now.violations, 0u) << "frame " << frame;
      ASSERT_EQ(now.inverted, 0u) << "frame " << frame;
    }
  }
  EXPECT_GT(splices, 100u);
}

TEST(Nearly_delaunay_classifier, leaves_a_delaunay_triangulation_at_zero)
{
  Cloud<Epick> cloud(22);
  Points points = cloud.uniform(200);
  Triangulation<CGAL::Nearly_delaunay_classifier_2> dt(points.begin(), points.end(),
                                                       CGAL::Nearly_delaunay_classifier_2(0));
  for (int frame = 0; frame < 40; ++frame) {
    cloud.shake(points, frame % 2 == 0 ? 0.01 : 0.1);
    const auto report = dt.update(points.begin(), points.end());
    EXPECT_EQ(report.certified, report.rebuilt());
    EXPECT_EQ(report.certified, dt.is_certified());
    EXPECT_TRUE(dt.certify());
    ASSERT_NO_FATAL_FAILURE(expect_exact(dt, points));
  }
}

// -------------------------------------------------------------------------------------------------
// All of them.

// Expects that a classifier, at any setting, keeps a sound triangulation, loses no point, and leads
// to no false certificate.
template <class Classifier>
void expect_sound_under(const Classifier& classifier)
{
  for (const double step : {1e-6, 0.05, 2.}) {
    Cloud<Epick> cloud(23);
    Points points = cloud.uniform(120);
    Triangulation<Classifier> dt(points.begin(), points.end(), classifier);
    for (int frame = 0; frame < 25; ++frame) {
      cloud.shake(points, step);
      if (frame == 10)
        points[7] = points[8] = points[9];
      if (frame == 14)
        for (auto& p : points)
          p = Epick::Point_2(p.x(), 2 * p.x());
      if (frame == 16)
        points = cloud.uniform(points.size());
      if (frame == 20)
        points.assign(points.size(), points[0]);
      dt.update(points.begin(), points.end());
      ASSERT_NO_FATAL_FAILURE(expect_valid(dt, points));
      if (dt.is_certified()) {
        ASSERT_NO_FATAL_FAILURE(expect_exact(dt, points));
      }
    }
    dt.mend();
    ASSERT_NO_FATAL_FAILURE(expect_exact(dt, points));
  }
}

TEST(All_classifiers, keep_a_sound_triangulation_and_all_points_at_absurd_settings)
{
  for (const double x : {0., 1e-300, 0.5, 1.}) {
    SCOPED_TRACE(testing::Message() << "parameter " << x);
    expect_sound_under(CGAL::Point_distance_classifier_2(x));
    expect_sound_under(CGAL::Inflation_aware_classifier_2(x));
    expect_sound_under(CGAL::Voronoi_edge_length_classifier_2(x));
    expect_sound_under(CGAL::Nearly_delaunay_classifier_2(x));
    expect_sound_under(CGAL::Random_classifier_2(x));
    expect_sound_under(CGAL::Refined_classifier_2(CGAL::Random_classifier_2(x),
                                                  CGAL::Voronoi_edge_length_classifier_2(1 - x)));
  }
  expect_sound_under(CGAL::Voronoi_circumcenter_classifier_2());
  expect_sound_under(CGAL::Estimated_voronoi_circumcenter_classifier_2());
  expect_sound_under(CGAL::Safe_region_classifier_2());
  expect_sound_under(Safe_and_circumcircle());
}

// On a line there are no edges and no flat arrays to be read.
template <class Classifier>
void expect_sound_from_a_line_on(const Classifier& classifier)
{
  for (const unsigned n : {0u, 1u, 2u, 3u, 20u}) {
    SCOPED_TRACE(testing::Message() << n << " points");
    Cloud<Epick> cloud(n);
    Points points = cloud.on_line(n);
    Triangulation<Classifier> dt(points.begin(), points.end(), classifier);
    for (int frame = 0; frame < 6; ++frame) {
      points = frame % 3 == 2 ? cloud.uniform(n) : cloud.on_line(n);
      dt.update(points.begin(), points.end());
      ASSERT_NO_FATAL_FAILURE(expect_valid(dt, points));
    }
    dt.mend();
    ASSERT_NO_FATAL_FAILURE(expect_exact(dt, points));
  }
}

TEST(All_classifiers, start_where_points_do_not_span_the_plane)
{
  expect_sound_from_a_line_on(CGAL::Circumcircle_classifier_2());
  expect_sound_from_a_line_on(CGAL::Safe_region_classifier_2());
  expect_sound_from_a_line_on(Safe_and_circumcircle());
  expect_sound_from_a_line_on(CGAL::Point_distance_classifier_2());
  expect_sound_from_a_line_on(CGAL::Inflation_aware_classifier_2());
  expect_sound_from_a_line_on(CGAL::Voronoi_circumcenter_classifier_2());
  expect_sound_from_a_line_on(CGAL::Estimated_voronoi_circumcenter_classifier_2());
  expect_sound_from_a_line_on(CGAL::Voronoi_edge_length_classifier_2());
  expect_sound_from_a_line_on(CGAL::Nearly_delaunay_classifier_2());
  expect_sound_from_a_line_on(CGAL::Random_classifier_2());
}

TEST(All_classifiers, refuse_parameters_out_of_range)
{
  for (const double x : {-0.1, 1.1, -1e-300, double(std::nan("")), 1e300}) {
    EXPECT_THROW(CGAL::Point_distance_classifier_2{x}, CGAL::Parameter_error_2);
    EXPECT_THROW(CGAL::Random_classifier_2{x}, CGAL::Parameter_error_2);
    EXPECT_THROW(CGAL::Inflation_aware_classifier_2{x}, CGAL::Parameter_error_2);
    EXPECT_THROW(CGAL::Voronoi_edge_length_classifier_2{x}, CGAL::Parameter_error_2);
    EXPECT_THROW(CGAL::Nearly_delaunay_classifier_2{x}, CGAL::Parameter_error_2);
  }
  try {
    CGAL::Nearly_delaunay_classifier_2(2);
    FAIL() << "no exception";
  } catch (const CGAL::Parameter_error_2& error) {
    EXPECT_EQ(error.value(), 2);
    EXPECT_STREQ(error.what(), "the parameter eps of nearly_delaunay is 2: it must be from 0 to 1");
  }
}

} // namespace test_thesis_classifiers

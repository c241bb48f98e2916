// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Any motion: points jump, trade places, meet and part, come and go, all in one update.

#include "change_ledger.h"
#include "interrupting_visitor.h"
#include "listening_visitor.h"
#include "oracle.h"
#include "population_player.h"

#include <CGAL/Dynamic_Delaunay_triangulation_2/classifiers/Estimated_voronoi_circumcenter_classifier_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/classifiers/Inflation_aware_classifier_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/classifiers/Nearly_delaunay_classifier_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/classifiers/Point_distance_classifier_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/classifiers/Random_classifier_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/classifiers/Safe_region_classifier_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/classifiers/Voronoi_circumcenter_classifier_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/classifiers/Voronoi_edge_length_classifier_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/repairs/Hold_and_flip_repair_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/visitors/Edge_changes_visitor_2.h>
#include <CGAL/Dynamic_population_2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <map>
#include <memory>
#include <numeric>
#include <random>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace {

using Ids = std::vector<std::size_t>;
// Keeps sets of edges and faces up to date by its notifications, and records relocated ids.
class Diary : public Listening_visitor<CGAL::Edge_changes_visitor_2>
{
  using Base = Listening_visitor<CGAL::Edge_changes_visitor_2>;

public:
  int begun() const { return m_begun; }
  int finished() const { return m_finished; }
  // The ids that the last call relocated, in the order of its notifications.
  const Ids& relocated() const { return m_relocated; }
  std::size_t merges() const { return m_merges; }
  void refuse() { m_refuses = true; }

  template <class Dynamic>
  void before_update(const Dynamic& dt)
  {
    if (std::exchange(m_refuses, false))
      throw Refusal();
    Base::before_update(dt);
    ++m_begun;
    m_relocated.clear();
    m_merges = 0;
  }

  template <class Dynamic>
  void after_update(const Dynamic& dt, const CGAL::Update_report_2& report)
  {
    Base::after_update(dt, report);
    ++m_finished;
    for (const Edge& e : removed_edges())
      EXPECT_EQ(m_edges.erase(e), 1u);
    for (const Edge& e : created_edges())
      EXPECT_TRUE(m_edges.insert(e).second);
    Base::clear();
    EXPECT_TRUE(m_edges == edges_of(dt));
    expect_to_know_all_faces(dt);
    EXPECT_EQ(std::set<std::size_t>(m_relocated.begin(), m_relocated.end()).size(),
              m_relocated.size());
    if (!report.rebuilt()) {
      EXPECT_LE(report.relocated, m_relocated.size());
      EXPECT_GE(report.relocated + report.merged, m_relocated.size());
    }
  }

  template <class Dynamic>
  void before_vertex_relocation(const Dynamic& dt, typename Dynamic::Vertex_handle v,
                                std::size_t id)
  {
    EXPECT_NE(v, dt.infinite_vertex());
    EXPECT_EQ(dt.id(v), id);
    EXPECT_EQ(dt.vertex(id), v);
    m_relocated.push_back(id);
  }

  template <class Dynamic>
  void before_vertex_merge(const Dynamic&, typename Dynamic::Vertex_handle, std::size_t,
                           typename Dynamic::Vertex_handle)
  {
    ++m_merges;
  }

private:
  int m_begun = 0, m_finished = 0;
  bool m_refuses = false;
  Ids m_relocated;
  std::size_t m_merges = 0;
  std::set<Edge> m_edges;
};

template <class Kernel, class Classifier = CGAL::Circumcircle_classifier_2>
using Visited = CGAL::Dynamic_Delaunay_triangulation_2<
    Kernel, Classifier, CGAL::With_data_structure_2<Stamped_data_structure<Kernel>>,
    CGAL::With_visitor_2<Diary>>;

// Moves points, and checks the triangulation after each call.
template <class Kernel>
class Stage
{
public:
  using Dynamic = Visited<Kernel>;
  using Point = typename Kernel::Point_2;
  using Points = std::vector<Point>;

  explicit Stage(const Points& initial)
    : points(initial)
    , m_dt(initial.begin(), initial.end())
  {
  }

  // Where all points go next.
  Points points;

  const Dynamic& dt() const { return m_dt; }
  const CGAL::Update_report_2& report() const { return m_report; }
  Ids relocated() const
  {
    Ids ids = m_dt.visitor().relocated();
    std::sort(ids.begin(), ids.end());
    return ids;
  }

  void update()
  {
    check([this] { return m_dt.update(points.begin(), points.end()); });
  }

  // Moves only the points whose places have changed.
  void move()
  {
    std::vector<std::pair<std::size_t, Point>> movers;
    for (std::size_t id = 0; id < points.size(); ++id)
      if (m_dt.point(id) != points[id])
        movers.emplace_back(id, points[id]);
    check([&] { return m_dt.move(movers.begin(), movers.end()); });
  }

  void trade(std::size_t i, std::size_t j) { std::swap(points[i], points[j]); }

  // Each point takes the place of the next one, the last one that of the first.
  void shift(const Ids& ids)
  {
    const Point first = points[ids.front()];
    for (std::size_t k = 0; k + 1 < ids.size(); ++k)
      points[ids[k]] = points[ids[k + 1]];
    points[ids.back()] = first;
  }

private:
  template <class Call>
  void check(const Call& call)
  {
    const auto stamps = stamps_of(m_dt);
    const int visits = m_dt.visitor().begun();
    m_report = call();
    ASSERT_TRUE(m_report.certified);
    ASSERT_NO_FATAL_FAILURE(expect_exact(m_dt, points));
    ASSERT_EQ(m_dt.visitor().begun(), visits + 1);
    ASSERT_EQ(m_dt.visitor().finished(), m_dt.visitor().begun());
    for (const auto& [id, stamp] : stamps)
      if (m_dt.id(m_dt.vertex(id)) == id) {
        ASSERT_EQ(stamp_of(m_dt, id), stamp) << "id " << id;
      }
    ASSERT_FALSE(testing::Test::HasFailure());
  }

  Dynamic m_dt;
  CGAL::Update_report_2 m_report;
};

// Some of the first `number` ids, each once.
Ids some_ids(std::size_t number, std::size_t count, std::mt19937& random)
{
  Ids ids(number);
  std::iota(ids.begin(), ids.end(), std::size_t(0));
  std::shuffle(ids.begin(), ids.end(), random);
  ids.resize(count);
  std::sort(ids.begin(), ids.end());
  return ids;
}

template <class Point>
double distance(const Point& p, const Point& q)
{
  return std::hypot(CGAL::to_double(p.x()) - CGAL::to_double(q.x()),
                    CGAL::to_double(p.y()) - CGAL::to_double(q.y()));
}

// Some points jump, each at least `least` far, to anywhere in the square from `low` to `high`.
template <class Kernel>
Ids jump(std::vector<typename Kernel::Point_2>& points, std::size_t count, double low, double high,
         double least, std::mt19937& random)
{
  const Ids ids = some_ids(points.size(), count, random);
  for (const std::size_t id : ids)
    for (;;) {
      const auto p = random_point_between<typename Kernel::Point_2>(low, high, random);
      if (distance(p, points[id]) < least)
        continue;
      points[id] = p;
      break;
    }
  return ids;
}

template <class Dynamic>
Ids neighbors_of(const Dynamic& dt, typename Dynamic::Vertex_handle vertex)
{
  Ids ids;
  const auto first = dt.triangulation().incident_vertices(vertex);
  auto v = first;
  do
    if (v != dt.infinite_vertex())
      ids.push_back(dt.id(v));
  while (++v != first);
  return ids;
}

// -------------------------------------------------------------------------------------------------
// Points that jump.

template <class Kernel>
class Jumps : public testing::Test
{
protected:
  using Point = typename Kernel::Point_2;
  using Points = std::vector<Point>;

  // All in a square as large as the `scale`, but for the parabola.
  static std::map<std::string, Points> shapes()
  {
    std::map<std::string, Points> shapes;
    shapes["uniform"] = Cloud<Kernel>(1).uniform(200);
    shapes["lattice"] = Cloud<Kernel>::grid(15, 15);
    shapes["circle"] = Cloud<Kernel>::on_circle(36);
    Cloud<Kernel> cloud(2);
    for (const Point& center : cloud.uniform(8))
      for (int i = 0; i < 25; ++i)
        shapes["clusters"].push_back(cloud.shifted(center, 1e-3));
    for (int i = -60; i < 60; ++i)
      shapes["parabola"].push_back(Point(i / 8., i * i / 64.));
    for (const Point& p : Cloud<Kernel>(3).uniform(150))
      shapes["needles"].push_back(Point(CGAL::to_double(p.x()) * 1e-6, p.y()));
    return shapes;
  }

  static void expect_exact_frames(const Points& points, double scale, unsigned seed)
  {
    Stage<Kernel> stage(points);
    std::mt19937 random(seed);
    Cloud<Kernel> cloud(seed);
    for (const double step : {0., 0.02}) {
      for (int frame = 0; frame < 6; ++frame) {
        SCOPED_TRACE(testing::Message() << "step " << step << ", frame " << frame);
        cloud.shake(stage.points, step * scale);
        jump<Kernel>(stage.points, 3, -scale, 10 * scale, 0, random);
        ASSERT_NO_FATAL_FAILURE(frame % 3 == 2 ? stage.move() : stage.update());
      }
      stage.points = points;
      ASSERT_NO_FATAL_FAILURE(stage.update());
    }
  }
};

using Kernels = testing::Types<Epick, Epeck>;
TYPED_TEST_SUITE(Jumps, Kernels);

TYPED_TEST(Jumps, of_a_few_relocate_just_these_while_all_others_rest_or_shake)
{
  for (const auto& [is_lattice, step] :
       {std::pair(true, 0.), std::pair(false, 0.), std::pair(false, 0.02)}) {
    Cloud<TypeParam> cloud(3);
    Stage<TypeParam> stage(is_lattice ? cloud.grid(20, 20) : cloud.uniform(400));
    for (int frame = 0; frame < 12; ++frame) {
      SCOPED_TRACE(testing::Message() << "step " << step << ", frame " << frame);
      cloud.shake(stage.points, step);
      const Ids jumpers = jump<TypeParam>(stage.points, 4, 1, 18, 5, cloud.random());
      ASSERT_NO_FATAL_FAILURE(stage.update());
      ASSERT_FALSE(stage.report().rebuilt());
      ASSERT_EQ(stage.relocated(), jumpers);
      if (step == 0) {
        ASSERT_EQ(stage.report().relocated, jumpers.size());
        ASSERT_EQ(stage.report().enlargements, 0u);
      }
    }
  }
}

TYPED_TEST(Jumps, are_mended_exactly_whatever_the_points_look_like)
{
  for (const auto& [name, points] : this->shapes()) {
    SCOPED_TRACE(name);
    ASSERT_NO_FATAL_FAILURE(this->expect_exact_frames(points, 1, 4));
  }
}

TYPED_TEST(Jumps, are_mended_exactly_in_huge_and_in_tiny_units)
{
  for (const double unit : {1e150, 1e-150, 1e-300}) {
    SCOPED_TRACE(testing::Message() << "unit " << unit);
    const auto points = scaled<TypeParam>(Cloud<TypeParam>(5).uniform(60), unit);
    ASSERT_NO_FATAL_FAILURE(this->expect_exact_frames(points, unit, 5));
  }
}

TYPED_TEST(Jumps, onto_others_merge)
{
  Stage<TypeParam> stage(Cloud<TypeParam>(6).uniform(400));
  const auto home = stage.points;
  const Ids jumpers{3, 50, 120, 333, 390};
  for (const std::size_t id : jumpers)
    stage.points[id] = stage.points[(id + 200) % 400];
  ASSERT_NO_FATAL_FAILURE(stage.update());
  EXPECT_FALSE(stage.report().rebuilt());
  EXPECT_EQ(stage.report().merged, 5u);
  EXPECT_EQ(stage.report().relocated, 0u);
  EXPECT_EQ(stage.dt().visitor().merges(), 5u);
  EXPECT_EQ(stage.relocated(), jumpers) << "told of merged ones, too";
  for (const std::size_t id : jumpers)
    EXPECT_EQ(stage.dt().id(stage.dt().vertex(id)), (id + 200) % 400) << "was there first";
  stage.points = home;
  ASSERT_NO_FATAL_FAILURE(stage.update());
  EXPECT_FALSE(stage.report().rebuilt());
  EXPECT_EQ(stage.report().parted, 5u);
  EXPECT_EQ(stage.report().merged, 0u);
}

TYPED_TEST(Jumps, of_shared_vertices_take_all_duplicates_along)
{
  auto points = Cloud<TypeParam>(7).uniform(300);
  for (const std::size_t id : {11u, 12u, 13u})
    points[id] = points[10];
  points[21] = points[20];
  Stage<TypeParam> stage(points);
  for (const std::array<double, 2>& place : {std::array<double, 2>{3.3, 4.4}, {15.1, 2.2}}) {
    for (const std::size_t id : {10u, 11u, 12u, 13u})
      stage.points[id] = typename TestFixture::Point(place[0], place[1]);
    for (const std::size_t id : {20u, 21u})
      stage.points[id] = typename TestFixture::Point(place[1], place[0]);
    ASSERT_NO_FATAL_FAILURE(stage.update());
    EXPECT_FALSE(stage.report().rebuilt());
    EXPECT_EQ(stage.report().relocated, 2u);
    EXPECT_EQ(stage.report().merged + stage.report().parted, 0u);
    EXPECT_EQ(stage.relocated(), (Ids{10, 20}));
    EXPECT_EQ(stage.dt().number_of_vertices(), 296u);
  }
  // one onto the other
  for (const std::size_t id : {10u, 11u, 12u, 13u})
    stage.points[id] = stage.points[20];
  ASSERT_NO_FATAL_FAILURE(stage.update());
  EXPECT_EQ(stage.report().merged, 1u);
  EXPECT_EQ(stage.dt().number_of_vertices(), 295u);
}

TYPED_TEST(
    Jumps,
    of_duplicates_leave_the_representative_and_of_a_representative_the_duplicates_where_they_were)
{
  for (const bool moves : {false, true}) {
    SCOPED_TRACE(moves ? "move" : "update");
    auto points = Cloud<TypeParam>(8).uniform(300);
    points[11] = points[12] = points[13] = points[10];
    Stage<TypeParam> stage(points);
    const auto go = [&] { moves ? stage.move() : stage.update(); };
    const auto representative = stage.dt().vertex(10);
    stage.points[12] = typename TestFixture::Point(2.1, 3.2);
    ASSERT_NO_FATAL_FAILURE(go());
    EXPECT_FALSE(stage.report().rebuilt());
    EXPECT_EQ(stage.report().parted, 1u);
    EXPECT_EQ(stage.dt().vertex(10), representative);
    EXPECT_EQ(stage.dt().vertex(13), representative);
    stage.points[10] = typename TestFixture::Point(12.3, 9.4);
    ASSERT_NO_FATAL_FAILURE(go());
    EXPECT_FALSE(stage.report().rebuilt());
    EXPECT_EQ(stage.dt().vertex(11), stage.dt().vertex(13));
    EXPECT_EQ(stage.dt().number_of_vertices(), 299u);
    // representative and duplicate trade places
    stage.trade(11, 10);
    ASSERT_NO_FATAL_FAILURE(go());
    EXPECT_FALSE(stage.report().rebuilt());
    EXPECT_EQ(stage.dt().vertex(10), stage.dt().vertex(13));
  }
}

TYPED_TEST(Jumps, may_be_trades_of_pairs_and_cycles)
{
  for (const bool moves : {false, true}) {
    SCOPED_TRACE(moves ? "move" : "update");
    Stage<TypeParam> stage(Cloud<TypeParam>(9).uniform(600));
    const auto go = [&] { moves ? stage.move() : stage.update(); };
    std::mt19937 random(9);
    for (const std::size_t pairs : {1u, 1u, 4u, 8u}) {
      Ids ids = some_ids(600, 2 * pairs, random);
      std::shuffle(ids.begin(), ids.end(), random);
      for (std::size_t k = 0; k < ids.size(); k += 2)
        stage.trade(ids[k], ids[k + 1]);
      ASSERT_NO_FATAL_FAILURE(go());
      EXPECT_FALSE(stage.report().rebuilt()) << pairs << " pairs";
      EXPECT_LE(stage.report().relocated, 2 * pairs);
      EXPECT_EQ(stage.report().merged, 0u);
    }
    for (const std::size_t length : {3u, 5u, 12u}) {
      Ids ids = some_ids(600, length, random);
      std::shuffle(ids.begin(), ids.end(), random);
      stage.shift(ids);
      ASSERT_NO_FATAL_FAILURE(go());
      EXPECT_FALSE(stage.report().rebuilt()) << "cycle of " << length;
      EXPECT_EQ(stage.report().merged, 0u);
    }
    // so many that a rebuild is cheaper
    Ids all(600);
    std::iota(all.begin(), all.end(), std::size_t(0));
    stage.shift(all);
    ASSERT_NO_FATAL_FAILURE(go());
  }
}

TYPED_TEST(Jumps, may_be_trades_of_neighbors_and_of_shared_vertices)
{
  auto points = Cloud<TypeParam>(10).uniform(300);
  points[1] = points[2] = points[0];
  points[11] = points[10];
  Stage<TypeParam> stage(points);
  std::mt19937 random(10);
  for (int round = 0; round < 4; ++round) {
    const auto place = stage.points[0];
    const auto first = stage.dt().vertex(0), second = stage.dt().vertex(10);
    for (const std::size_t id : {0u, 1u, 2u})
      stage.points[id] = stage.points[10];
    stage.points[10] = stage.points[11] = place;
    ASSERT_NO_FATAL_FAILURE(round % 2 == 0 ? stage.update() : stage.move());
    EXPECT_FALSE(stage.report().rebuilt());
    EXPECT_EQ(stage.dt().vertex(2), first);
    EXPECT_EQ(stage.dt().vertex(11), second);
    EXPECT_EQ(stage.dt().number_of_vertices(), 297u);
  }
  for (int round = 0; round < 20; ++round) {
    const std::size_t i = 20 + random() % 200;
    const Ids neighbors = neighbors_of(stage.dt(), stage.dt().vertex(i));
    const std::size_t j = neighbors[random() % neighbors.size()];
    if (j < 20)
      continue;
    stage.trade(i, j);
    ASSERT_NO_FATAL_FAILURE(round % 2 == 0 ? stage.update() : stage.move());
    EXPECT_FALSE(stage.report().rebuilt());
  }
}

TYPED_TEST(Jumps, may_leave_the_hull_and_come_back_from_far_away)
{
  Stage<TypeParam> stage(Cloud<TypeParam>(11).uniform(300));
  const auto home = stage.points;
  for (const double far : {30., 1e3, 1e6, 1e12, 1e100}) {
    SCOPED_TRACE(testing::Message() << "far " << far);
    stage.points[5] = typename TestFixture::Point(far, 3);
    stage.points[77] = typename TestFixture::Point(-1, -far);
    ASSERT_NO_FATAL_FAILURE(stage.update());
    EXPECT_FALSE(stage.report().rebuilt());
    stage.points = home;
    ASSERT_NO_FATAL_FAILURE(stage.update());
    EXPECT_FALSE(stage.report().rebuilt());
    EXPECT_LE(stage.report().flips, 100u);
  }
}

TYPED_TEST(Jumps, may_be_those_of_the_hull)
{
  Stage<TypeParam> stage(Cloud<TypeParam>(12).uniform(300));
  std::mt19937 random(12);
  for (int round = 0; round < 6; ++round) {
    SCOPED_TRACE(testing::Message() << "round " << round);
    const Ids hull = neighbors_of(stage.dt(), stage.dt().infinite_vertex());
    const auto before = stage.points;
    for (std::size_t k = 0; k < hull.size(); k += round == 5 ? 1 : 2)
      stage.points[hull[k]] = random_point_between<typename TestFixture::Point>(2, 15, random);
    ASSERT_NO_FATAL_FAILURE(round % 2 == 0 ? stage.update() : stage.move());
    stage.points = before;
    ASSERT_NO_FATAL_FAILURE(stage.update());
  }
  // a hull that is nothing but corners, one after the other into the middle
  Stage<TypeParam> corners(Cloud<TypeParam>::grid(9, 9));
  for (const std::size_t id : {0u, 8u, 72u, 80u}) {
    corners.points[id] = typename TestFixture::Point(4.25, 3.5 + double(id) / 160);
    ASSERT_NO_FATAL_FAILURE(corners.update());
    EXPECT_FALSE(corners.report().rebuilt());
    EXPECT_EQ(corners.report().relocated, 1u);
  }
}

TYPED_TEST(Jumps, may_be_those_of_neighbors_together)
{
  Stage<TypeParam> stage(Cloud<TypeParam>(13).uniform(600));
  int rebuilds = 0;
  for (std::size_t id = 0; id < 600; id += 25) {
    SCOPED_TRACE(testing::Message() << "id " << id);
    Ids flock = neighbors_of(stage.dt(), stage.dt().vertex(id));
    flock.push_back(id);
    for (const double dx : {7.3, -7.3}) {
      for (const std::size_t i : flock)
        stage.points[i] = typename TestFixture::Point(CGAL::to_double(stage.points[i].x()) + dx,
                                                      stage.points[i].y());
      ASSERT_NO_FATAL_FAILURE(stage.update());
      rebuilds += stage.report().rebuilt();
      if (!stage.report().rebuilt()) {
        EXPECT_LE(stage.report().relocated, 2 * flock.size());
      }
    }
  }
  EXPECT_LE(rebuilds, 12) << "of 48 frames";
}

TYPED_TEST(Jumps, are_right_however_few_points_there_are)
{
  for (unsigned seed = 0; seed < 60; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    std::mt19937 random(seed);
    const bool is_lattice = seed % 2 == 0;
    const auto place = [&] {
      if (is_lattice) {
        const int x = int(random() % 4);
        return typename TestFixture::Point(x, int(random() % 4));
      }
      const double x = double(random() % 1000);
      return typename TestFixture::Point(x, double(random() % 1000));
    };
    typename TestFixture::Points points;
    for (unsigned i = 0; i < 3 + seed / 2 % 5; ++i)
      points.push_back(place());
    Stage<TypeParam> stage(points);
    for (int frame = 0; frame < 8; ++frame) {
      for (std::size_t count = 1 + random() % points.size(); count > 0; --count)
        stage.points[random() % points.size()] = place();
      ASSERT_NO_FATAL_FAILURE(frame % 2 == 0 ? stage.update() : stage.move());
    }
  }
}

TYPED_TEST(Jumps, may_be_those_of_all_but_three)
{
  for (unsigned seed = 0; seed < 4; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Cloud<TypeParam> cloud(seed);
    Stage<TypeParam> stage(cloud.uniform(60));
    for (const std::size_t count : {57u, 59u, 60u, 30u, 57u}) {
      jump<TypeParam>(stage.points, count, 0, 8, 0, cloud.random());
      ASSERT_NO_FATAL_FAILURE(seed % 2 == 0 ? stage.update() : stage.move());
    }
  }
}

// However many points jump, by mending or, past the budget for that, by a rebuild.
TEST(Jumps_of_many, end_exact_whatever_they_cost)
{
  std::vector<Epick::Point_2> parabola;
  for (int i = -500; i < 500; ++i)
    parabola.emplace_back(i / 8., i * i / 64.);
  std::mt19937 random(14);
  for (const auto& points : {parabola, Cloud<Epick>(14).uniform(1000)}) {
    Stage<Epick> stage(points);
    for (const std::size_t count : {10u, 10u, 30u, 100u, 200u, 400u, 10u}) {
      SCOPED_TRACE(testing::Message() << count << " jump");
      jump<Epick>(stage.points, count, 0, 30, 0, random);
      ASSERT_NO_FATAL_FAILURE(stage.update());
    }
    stage.points = points;
    ASSERT_NO_FATAL_FAILURE(stage.update());
    stage.points.assign(points.rbegin(), points.rend());
    ASSERT_NO_FATAL_FAILURE(stage.update());
  }
}

// All vertices are on the hull, and flips join each of them with some that are far away. A walk
// that began at one of these to find the next vertex took some four hundred steps, and the budget
// of two of these three frames was spent by that.
TEST(Jumps_along_a_parabola, are_found_from_beside_one_another)
{
  constexpr std::size_t size = 10000, jumps = size / 100;
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> place(-1, 1);
  const auto on_parabola = [](double x) { return Epick::Point_2(x, x * x); };
  std::vector<Epick::Point_2> points;
  for (std::size_t i = 0; i < size; ++i)
    points.push_back(on_parabola((2 * double(i) + 1) / size - 1));
  std::shuffle(points.begin(), points.end(), random);
  Stage<Epick> stage(points);
  for (int frame = 0; frame < 3; ++frame) {
    for (std::size_t k = 0; k < jumps; ++k) {
      const double x = place(random);
      stage.points[random() % size] = on_parabola(x);
    }
    ASSERT_NO_FATAL_FAILURE(stage.update());
    EXPECT_FALSE(stage.report().rebuilt()) << "frame " << frame;
  }
}

TEST(Jumps_of_a_few_of_thousands, cost_little_and_move_no_other_point)
{
  Stage<Epick> stage(Cloud<Epick>(15).uniform(3000));
  std::mt19937 random(15);
  for (int frame = 0; frame < 3; ++frame) {
    const Ids jumpers = jump<Epick>(stage.points, 5, 2, 52, 10, random);
    ASSERT_NO_FATAL_FAILURE(stage.update());
    EXPECT_FALSE(stage.report().rebuilt());
    EXPECT_LT(stage.report().flips, 200u);
    EXPECT_EQ(stage.report().enlargements, 0u);
    EXPECT_EQ(stage.report().spliced, 0u);
    EXPECT_EQ(stage.relocated(), jumpers);
    EXPECT_EQ(stage.report().relocated, 5u);
  }
  // points that meet cost about as many flips as they have edges, in a cloud of any size
  const Ids ids = some_ids(3000, 20, random);
  for (std::size_t k = 0; k < ids.size(); k += 2)
    stage.points[ids[k]] = stage.points[ids[k + 1]];
  ASSERT_NO_FATAL_FAILURE(stage.update());
  EXPECT_FALSE(stage.report().rebuilt());
  EXPECT_EQ(stage.report().merged, 10u);
  EXPECT_LT(stage.report().flips, 300u);
}

// -------------------------------------------------------------------------------------------------
// Points that move alone.

TEST(Movers, trade_places_among_thousands_without_a_rebuild)
{
  Stage<Epick> stage(Cloud<Epick>(20).uniform(3000));
  std::mt19937 random(20);
  for (int frame = 0; frame < 3; ++frame) {
    Ids ids = some_ids(3000, 7, random);
    std::shuffle(ids.begin(), ids.end(), random);
    stage.shift(ids);
    ASSERT_NO_FATAL_FAILURE(stage.move());
    EXPECT_FALSE(stage.report().rebuilt());
    EXPECT_EQ(stage.report().relocated, 7u);
    EXPECT_EQ(stage.report().merged, 0u);
    EXPECT_LT(stage.report().flips, 300u);
  }
}

TEST(Movers, go_near_and_far_trade_and_meet_in_one_call)
{
  Cloud<Epick> cloud(21);
  Stage<Epick> stage(cloud.uniform(800));
  auto& random = cloud.random();
  for (int frame = 0; frame < 25; ++frame) {
    SCOPED_TRACE(testing::Message() << "frame " << frame);
    Ids ids = some_ids(800, 20, random);
    std::shuffle(ids.begin(), ids.end(), random);
    for (std::size_t k = 0; k < 10; ++k)
      stage.points[ids[k]] = cloud.shifted(stage.points[ids[k]], std::pow(10., double(k) - 8));
    for (std::size_t k = 10; k < 16; k += 2)
      stage.trade(ids[k], ids[k + 1]);
    stage.points[ids[16]] = stage.points[ids[17]]; // onto one that stays
    stage.points[ids[18]] = stage.points[ids[0]];  // onto one that comes there
    stage.points[ids[19]] = stage.points[ids[10]];
    ASSERT_NO_FATAL_FAILURE(stage.move());
    EXPECT_FALSE(stage.report().rebuilt());
  }
}

// -------------------------------------------------------------------------------------------------
// Populations.

template <class Dynamic>
class Crowd
{
public:
  using Point = typename Dynamic::Point;
  using Frame = std::map<int, Point>;
  using People = CGAL::Dynamic_population_2<Dynamic, int>;

  explicit Crowd(Dynamic&& dt = Dynamic())
    : people(std::move(dt))
  {
  }

  People people;
  Frame frame; // who shall be where

  const CGAL::Update_report_2& report() const { return m_report; }

  // Updates in the order of the frame, or in a random one.
  void update(std::mt19937* random = nullptr)
  {
    std::vector<std::pair<int, Point>> range(frame.begin(), frame.end());
    if (random != nullptr)
      std::shuffle(range.begin(), range.end(), *random);
    const auto ids = expected_ids(range);
    const auto stamps = stamps_of(people.triangulation());
    std::size_t newcomers = 0;
    for (const auto& person : frame)
      newcomers += m_ids.count(person.first) == 0;
    m_most = (std::max)(m_most, frame.size());
    const std::size_t removed = m_ids.size() + newcomers - frame.size();
    m_report = people.update(range.begin(), range.end());
    ASSERT_EQ(m_report.inserted, newcomers);
    ASSERT_EQ(m_report.removed, removed);
    for (const auto& [user_id, id] : ids)
      ASSERT_EQ(people.id(user_id), id) << "user's id " << user_id;
    const auto& dt = people.triangulation();
    for (const auto& [id, stamp] : stamps)
      if (dt.has_id(id) && m_ids.count(people.user_id(id)) && m_ids.at(people.user_id(id)) == id &&
          dt.id(dt.vertex(id)) == id) {
        ASSERT_EQ(stamp_of(dt, id), stamp) << "id " << id;
      }
    m_ids = ids;
    ASSERT_NO_FATAL_FAILURE(check());
  }

  // Expects the points of the frame, at their places, with their ids.
  void check()
  {
    const auto& dt = people.triangulation();
    ASSERT_NO_FATAL_FAILURE(expect_people(people, frame));
    for (const auto& person : frame)
      ASSERT_EQ(people.id(person.first), m_ids.at(person.first)) << "user's id " << person.first;
    ASSERT_EQ(dt.number_of_ids(), m_most);
    ASSERT_EQ(m_report.certified, dt.is_certified());
    ASSERT_NO_FATAL_FAILURE(expect_exact(dt, model_of(dt)));
    ASSERT_FALSE(testing::Test::HasFailure());
  }

private:
  // Points that stay keep their ids; new ones get the smallest that are free after all removals.
  std::map<int, std::size_t> expected_ids(const std::vector<std::pair<int, Point>>& range) const
  {
    std::map<int, std::size_t> ids;
    std::set<std::size_t> taken;
    for (const auto& [user_id, id] : m_ids)
      if (frame.count(user_id) > 0) {
        ids.emplace(user_id, id);
        taken.insert(id);
      }
    std::size_t next = 0;
    for (const auto& person : range)
      if (ids.count(person.first) == 0) {
        while (!taken.insert(next).second)
          ++next;
        ids.emplace(person.first, next);
      }
    return ids;
  }

  CGAL::Update_report_2 m_report;
  std::map<int, std::size_t> m_ids; // of those who are there
  std::size_t m_most = 0;           // that there have been at once
};

template <class Kernel>
class Populations : public testing::Test
{
protected:
  using Point = typename Kernel::Point_2;
  using Watched_crowd = Crowd<Visited<Kernel>>;

  static void settle(Watched_crowd& crowd, std::size_t number, unsigned seed)
  {
    int user_id = 100;
    for (const Point& p : Cloud<Kernel>(seed).uniform(number))
      crowd.frame.emplace(user_id += 3, p);
    crowd.update();
  }

  static int user_id(std::size_t place) { return 103 + 3 * int(place); }
};

TYPED_TEST_SUITE(Populations, Kernels);

TYPED_TEST(Populations, go_come_move_and_jump_in_one_frame_which_is_one_update)
{
  typename TestFixture::Watched_crowd crowd;
  ASSERT_NO_FATAL_FAILURE(this->settle(crowd, 400, 30));
  Cloud<TypeParam> cloud(30);
  auto& random = cloud.random();
  const auto place = [&] {
    return random_point_between<typename TestFixture::Point>(1, 18, random);
  };
  int next = 5000;
  for (int frame = 0; frame < 10; ++frame) {
    SCOPED_TRACE(testing::Message() << "frame " << frame);
    if (frame % 2 == 0)
      for (auto& person : crowd.frame)
        person.second = cloud.shifted(person.second, 0.02);
    for (int i = 0; i < 4; ++i)
      crowd.frame.erase(std::next(crowd.frame.begin(), int(random() % crowd.frame.size())));
    for (int i = 0; i < 4; ++i)
      crowd.frame.emplace(next++, place());
    for (int i = 0; i < 3; ++i)
      std::next(crowd.frame.begin(), int(random() % crowd.frame.size()))->second = place();
    const auto& visitor = crowd.people.triangulation().visitor();
    const int visits = visitor.begun();
    ASSERT_NO_FATAL_FAILURE(crowd.update(frame % 3 == 0 ? &random : nullptr));
    EXPECT_FALSE(crowd.report().rebuilt());
    EXPECT_LE(crowd.report().relocated, 6u) << "three jump";
    EXPECT_EQ(visitor.begun(), visits + 1);
    EXPECT_EQ(visitor.finished(), visits + 1);
    EXPECT_EQ(crowd.people.triangulation().number_of_ids(), 400u);
  }
}

TYPED_TEST(Populations, let_newcomers_take_the_places_of_those_who_went_and_sit_on_others)
{
  typename TestFixture::Watched_crowd crowd;
  ASSERT_NO_FATAL_FAILURE(this->settle(crowd, 200, 31));
  const auto gone = crowd.frame.at(this->user_id(7));
  const auto stays = crowd.frame.at(this->user_id(8));
  const auto moves = crowd.frame.at(this->user_id(9));
  crowd.frame.erase(this->user_id(7));
  crowd.frame.emplace(1, gone);  // at the place of one who went
  crowd.frame.emplace(2, stays); // onto one who stays
  crowd.frame.emplace(3, moves); // to the place of one who jumps away
  crowd.frame[this->user_id(9)] = typename TestFixture::Point(3.25, 4.75);
  crowd.frame.emplace(4, typename TestFixture::Point(3.25, 4.75)); // onto one who jumps there
  crowd.frame.emplace(5, typename TestFixture::Point(6.5, 4.75));
  crowd.frame.emplace(6, typename TestFixture::Point(6.5, 4.75)); // both new
  ASSERT_NO_FATAL_FAILURE(crowd.update());
  EXPECT_FALSE(crowd.report().rebuilt());
  EXPECT_EQ(crowd.report().inserted, 6u);
  EXPECT_EQ(crowd.report().removed, 1u);
  EXPECT_EQ(crowd.people.id(1), 7u);
  EXPECT_EQ(crowd.people.triangulation().number_of_ids(), 205u);
  EXPECT_EQ(crowd.people.triangulation().number_of_vertices(), 202u);
  EXPECT_EQ(crowd.people.vertex(2), crowd.people.vertex(this->user_id(8)));
  EXPECT_EQ(crowd.people.vertex(4), crowd.people.vertex(this->user_id(9)));
  EXPECT_EQ(crowd.people.vertex(5), crowd.people.vertex(6));
}

TYPED_TEST(Populations, lose_representatives_whose_duplicates_stay_part_or_jump_in_the_same_frame)
{
  for (unsigned way = 0; way < 16; ++way) {
    SCOPED_TRACE(testing::Message() << "way " << way);
    typename TestFixture::Watched_crowd crowd;
    ASSERT_NO_FATAL_FAILURE(this->settle(crowd, 100, 32));
    const auto place = crowd.frame.at(this->user_id(50));
    for (int id = 1; id <= 4; ++id)
      crowd.frame.emplace(id, place);
    ASSERT_NO_FATAL_FAILURE(crowd.update());
    EXPECT_EQ(crowd.people.triangulation().number_of_vertices(), 100u);
    crowd.frame.erase(this->user_id(50));
    for (int id = 1; id <= 4; ++id) {
      if (way & 1)
        crowd.frame[id] = typename TestFixture::Point(2.5 + (way & 2 ? id : 0), 6.75);
      if (id == 2 && (way & 4))
        crowd.frame.erase(id);
      if (id == 3 && (way & 8))
        crowd.frame[id] = crowd.frame.at(this->user_id(0));
    }
    ASSERT_NO_FATAL_FAILURE(crowd.update());
    EXPECT_FALSE(crowd.report().rebuilt());
    ASSERT_NO_FATAL_FAILURE(crowd.update());
    EXPECT_EQ(crowd.report().flips, 0u);
  }
}

TYPED_TEST(Populations, are_replaced_and_dwindle_to_no_point_and_grow_again)
{
  typename TestFixture::Watched_crowd crowd;
  Cloud<TypeParam> cloud(33);
  int next = 0;
  for (const std::size_t number :
       {30u, 30u, 3u, 2u, 2u, 1u, 1u, 0u, 0u, 1u, 2u, 3u, 4u, 60u, 5u, 3u, 60u, 0u, 10u}) {
    SCOPED_TRACE(testing::Message() << "to " << number);
    const auto points = cloud.uniform(number);
    // all points are replaced
    crowd.frame.clear();
    for (const auto& p : points)
      crowd.frame.emplace(next++, p);
    ASSERT_NO_FATAL_FAILURE(crowd.update());
    // in a line
    for (auto& person : crowd.frame)
      person.second = typename TestFixture::Point(person.first, 2 * person.first);
    ASSERT_NO_FATAL_FAILURE(crowd.update());
    // one point leaves, one comes, and all others leave the line
    if (number > 1)
      crowd.frame.erase(crowd.frame.begin());
    for (auto& person : crowd.frame)
      person.second = cloud.shifted(person.second, 1);
    crowd.frame.emplace(next++, typename TestFixture::Point(1, 2));
    ASSERT_NO_FATAL_FAILURE(crowd.update());
  }
}

TYPED_TEST(Populations, lose_the_last_point_beside_a_line_while_another_one_comes_or_jumps)
{
  for (const bool comes : {false, true}) {
    typename TestFixture::Watched_crowd crowd;
    for (int i = 0; i < 30; ++i)
      crowd.frame.emplace(i, typename TestFixture::Point(i, 0));
    crowd.frame.emplace(30, typename TestFixture::Point(12, 5));
    ASSERT_NO_FATAL_FAILURE(crowd.update());
    crowd.frame.erase(30);
    if (comes)
      crowd.frame.emplace(40, typename TestFixture::Point(3, -1));
    else
      crowd.frame[7] = typename TestFixture::Point(3, -1);
    ASSERT_NO_FATAL_FAILURE(crowd.update());
    crowd.frame.erase(comes ? 40 : 7);
    ASSERT_NO_FATAL_FAILURE(crowd.update());
    crowd.frame.emplace(50, typename TestFixture::Point(3, 8));
    ASSERT_NO_FATAL_FAILURE(crowd.update());
  }
}

// -------------------------------------------------------------------------------------------------
// Random programs.

// The name of a point that has left is often used again.
template <class Dynamic>
using Program = Population_player<Dynamic, std::int8_t>;

template <class Dynamic>
Program<Dynamic> program(unsigned seed)
{
  const bool is_lattice = seed % 3 == 0;
  return {{is_lattice ? 4 + int(seed % 6) : 8, is_lattice}, seed, 5 + seed % 7 * 9};
}

template <class Dynamic>
void expect_right_programs(unsigned programs, int frames, unsigned first_seed = 0,
                           int frames_per_mending = 0)
{
  for (unsigned seed = first_seed; seed < first_seed + programs; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    ASSERT_NO_FATAL_FAILURE(program<Dynamic>(seed).play(frames, frames_per_mending));
    ASSERT_FALSE(testing::Test::HasFailure());
  }
}

TEST(Programs, of_any_motion_are_right_in_each_frame)
{
  ASSERT_NO_FATAL_FAILURE(expect_right_programs<Visited<Epick>>(100, 150));
}

TEST(Programs, of_any_motion_are_right_with_exact_coordinates)
{
  ASSERT_NO_FATAL_FAILURE(expect_right_programs<Visited<Epeck>>(20, 80));
}

TEST(Programs, of_any_motion_are_right_in_safe_regions)
{
  using Dynamic = Visited<Epick, CGAL::Safe_region_classifier_2>;
  ASSERT_NO_FATAL_FAILURE(expect_right_programs<Dynamic>(30, 150, 1000));
}

// -------------------------------------------------------------------------------------------------
// What classifiers are told.

TEST(Watched_jumps, are_news)
{
  using Dynamic = Watched_triangulation<Epick, CGAL::Circumcircle_classifier_2>;
  Cloud<Epick> cloud(40);
  auto points = cloud.uniform(400);
  Dynamic dt;
  dt.classifier().watch(dt);
  Ids ids;
  dt.insert(points.begin(), points.end(), std::back_inserter(ids));
  for (int frame = 0; frame < 15; ++frame) {
    SCOPED_TRACE(testing::Message() << "frame " << frame);
    if (frame % 3 != 0)
      cloud.shake(points, 0.02);
    jump<Epick>(points, 4, 0, 20, 0, cloud.random());
    points[std::size_t(frame)] = points[std::size_t(frame) + 100];
    const auto report = dt.update(points.begin(), points.end());
    EXPECT_FALSE(report.rebuilt());
    ASSERT_NO_FATAL_FAILURE(expect_exact(dt, points));
    ASSERT_FALSE(testing::Test::HasFailure());
  }
}

// -------------------------------------------------------------------------------------------------
// Heuristic classifiers.

template <class Classifier>
class Heuristic : public testing::Test
{
};

using Heuristics =
    testing::Types<CGAL::Point_distance_classifier_2, CGAL::Inflation_aware_classifier_2,
                   CGAL::Nearly_delaunay_classifier_2, CGAL::Voronoi_edge_length_classifier_2,
                   CGAL::Voronoi_circumcenter_classifier_2,
                   CGAL::Estimated_voronoi_circumcenter_classifier_2, CGAL::Random_classifier_2>;
TYPED_TEST_SUITE(Heuristic, Heuristics);

TYPED_TEST(Heuristic, populations_stay_valid_and_can_be_mended)
{
  ASSERT_NO_FATAL_FAILURE((expect_right_programs<Visited<Epick, TypeParam>>(30, 120, 0, 12)));
}

// -------------------------------------------------------------------------------------------------
// Equal calls.

auto numbers_of(const CGAL::Update_report_2& r)
{
  return std::make_tuple(r.classified, r.padded, r.border, r.flips, r.splices, r.spliced,
                         r.enlargements, r.relocated, r.inserted, r.removed, r.merged, r.parted,
                         r.rebuild_reason, r.certified);
}

auto figures_of(const random_operations::Counts& c)
{
  return std::make_tuple(c.operations, c.points, c.flips, c.splices, c.relocated, c.merged,
                         c.parted, c.rebuilds, c.certified);
}

template <class Dynamic>
std::vector<std::pair<std::size_t, std::size_t>> listed_edges(const Dynamic& dt)
{
  std::vector<std::pair<std::size_t, std::size_t>> edges;
  dt.for_each_edge([&](std::size_t i, std::size_t j) { edges.emplace_back(i, j); });
  return edges;
}

TEST(Equal_calls, have_equal_reports_and_edges)
{
  using Dynamic = CGAL::Dynamic_Delaunay_triangulation_2<Epick>;
  for (unsigned seed = 0; seed < 6; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    auto one = program<Dynamic>(seed), other = program<Dynamic>(seed);
    ASSERT_NO_THROW(one.start());
    ASSERT_NO_THROW(other.start());
    for (int frame = 0; frame < 40; ++frame) {
      ASSERT_NO_THROW(one.play());
      // memory is elsewhere
      const auto in_the_way = std::make_unique<std::vector<int>>(1000);
      ASSERT_NO_THROW(other.play());
      ASSERT_EQ(figures_of(one.counts()), figures_of(other.counts()));
      ASSERT_EQ(listed_edges(one.triangulation()), listed_edges(other.triangulation()));
    }
  }
}

TEST(Equal_calls, have_equal_results_on_jumps_among_many)
{
  using Dynamic = CGAL::Dynamic_Delaunay_triangulation_2<Epick>;
  Cloud<Epick> cloud(50);
  auto points = cloud.uniform(500);
  Dynamic one(points.begin(), points.end()), other(points.begin(), points.end());
  for (const std::size_t count : {1u, 5u, 20u, 80u, 500u}) {
    cloud.shake(points, 0.03);
    jump<Epick>(points, count, 0, 22, 0, cloud.random());
    const auto report = one.update(points.begin(), points.end());
    ASSERT_EQ(numbers_of(report), numbers_of(other.update(points.begin(), points.end())));
    ASSERT_EQ(listed_edges(one), listed_edges(other));
  }
}

// -------------------------------------------------------------------------------------------------
// What goes wrong.

// Throws at its next call, once refuse() has been called.
class Refusing_classifier : public CGAL::Circumcircle_classifier_2
{
public:
  void refuse() const { *m_refuses = true; }

  template <class Frame, class Classification>
  void operator()(const Frame& frame, Classification& classified)
  {
    if (std::exchange(*m_refuses, false))
      throw Refusal();
    CGAL::Circumcircle_classifier_2::operator()(frame, classified);
  }

private:
  std::shared_ptr<bool> m_refuses = std::make_shared<bool>(false);
};

using Frame = std::map<int, Epick::Point_2>;

Frame frame_of(const Cloud<Epick>::Points& points)
{
  Frame frame;
  for (const auto& p : points)
    frame.emplace(int(frame.size()), p);
  for (const int duplicate : {20, 21})
    frame[duplicate] = frame[22];
  return frame;
}

// Some points leave, among them a representative; new ones come, one of them onto another point;
// some jump, and two meet.
Frame next_of(Frame frame, Cloud<Epick>& cloud)
{
  for (auto& person : frame)
    person.second = cloud.shifted(person.second, 0.02);
  for (const int user_id : {3, 4, 20, 599})
    frame.erase(user_id);
  frame[900] = Epick::Point_2(5, 5.5);
  frame[901] = frame[30];
  frame[902] = Epick::Point_2(1, 5.5);
  std::swap(frame[7], frame[270]);
  frame[50] = Epick::Point_2(1, 2);
  frame[51] = frame[52];
  return frame;
}

template <class People>
CGAL::Update_report_2 update(People& people, const Frame& frame)
{
  const std::vector<std::pair<int, Epick::Point_2>> range(frame.begin(), frame.end());
  return people.update(range.begin(), range.end());
}

class Wrong_frames : public testing::Test
{
protected:
  using Dynamic = Visited<Epick, Refusing_classifier>;

  void SetUp() override
  {
    m_crowd.frame = frame_of(m_cloud.uniform(600));
    ASSERT_NO_FATAL_FAILURE(m_crowd.update());
    // the ids of the triangulation are no longer the user's
    m_crowd.frame.erase(5);
    m_crowd.frame.emplace(800, Epick::Point_2(2, 3));
    ASSERT_NO_FATAL_FAILURE(m_crowd.update());
  }

  Frame next_frame() { return next_of(m_crowd.frame, m_cloud); }

  template <class Error, class Call>
  void expect_nothing_changes(const Call& call)
  {
    const auto& dt = m_crowd.people.triangulation();
    ASSERT_TRUE(dt.is_certified());
    const auto edges = edges_of(dt);
    const auto stamps = stamps_of(dt);
    const std::size_t ids = dt.number_of_ids();
    EXPECT_THROW(call(), Error);
    EXPECT_TRUE(dt.is_certified());
    EXPECT_EQ(dt.number_of_ids(), ids);
    EXPECT_TRUE(edges_of(dt) == edges);
    EXPECT_TRUE(stamps_of(dt) == stamps);
    for (const int user_id : {900, 901, 902})
      EXPECT_FALSE(m_crowd.people.has(user_id)) << "user's id " << user_id;
    ASSERT_NO_FATAL_FAILURE(m_crowd.check());
  }

  void expect_next_frame_is_right()
  {
    m_crowd.frame = next_frame();
    ASSERT_NO_FATAL_FAILURE(m_crowd.update());
    EXPECT_FALSE(m_crowd.report().rebuilt());
  }

  Cloud<Epick> m_cloud{60};
  Crowd<Dynamic> m_crowd;
};

TEST_F(Wrong_frames, that_the_classifier_refuses_change_nothing)
{
  ASSERT_NO_FATAL_FAILURE(expect_nothing_changes<Refusal>([this] {
    m_crowd.people.triangulation().classifier().refuse();
    update(m_crowd.people, next_frame());
  }));
  ASSERT_NO_FATAL_FAILURE(expect_next_frame_is_right());
}

TEST_F(Wrong_frames, that_the_visitor_refuses_change_nothing)
{
  ASSERT_NO_FATAL_FAILURE(expect_nothing_changes<Refusal>([this] {
    m_crowd.people.visitor().refuse();
    update(m_crowd.people, next_frame());
  }));
  ASSERT_NO_FATAL_FAILURE(expect_next_frame_is_right());
}

TEST_F(Wrong_frames, that_the_visitor_refuses_do_not_lose_who_has_come_before)
{
  // 800 came by the last frame
  ASSERT_NO_FATAL_FAILURE(expect_nothing_changes<Refusal>([this] {
    m_crowd.people.visitor().refuse();
    m_crowd.people.remove(800);
  }));
  ASSERT_NO_FATAL_FAILURE(expect_nothing_changes<Refusal>([this] {
    Frame next = m_crowd.frame;
    next.erase(800);
    m_crowd.people.visitor().refuse();
    update(m_crowd.people, next);
  }));
  ASSERT_NO_FATAL_FAILURE(expect_nothing_changes<Refusal>([this] {
    m_crowd.people.visitor().refuse();
    m_crowd.people.insert(900, Epick::Point_2(4, 4));
  }));
  ASSERT_NO_FATAL_FAILURE(expect_next_frame_is_right());
}

TEST_F(Wrong_frames, with_what_is_no_number_or_repeated_ids_change_nothing)
{
  const Frame next = next_frame();
  for (const int user_id : {50, 900}) {
    Frame bad = next;
    bad[user_id] = Epick::Point_2(std::numeric_limits<double>::quiet_NaN(), 1);
    ASSERT_NO_FATAL_FAILURE(expect_nothing_changes<CGAL::Non_finite_coordinate_error_2>(
        [&] { update(m_crowd.people, bad); }));
    std::vector<std::pair<int, Epick::Point_2>> twice(next.begin(), next.end());
    twice.emplace_back(user_id, Epick::Point_2(1, 1));
    ASSERT_NO_FATAL_FAILURE(expect_nothing_changes<CGAL::Repeated_id_error_2>(
        [&] { m_crowd.people.update(twice.begin(), twice.end()); }));
  }
  ASSERT_NO_FATAL_FAILURE(expect_next_frame_is_right());
}

TEST_F(Wrong_frames, of_jumps_that_the_classifier_refuses_change_nothing)
{
  ASSERT_NO_FATAL_FAILURE(expect_nothing_changes<Refusal>([this] {
    Frame next = m_crowd.frame;
    std::swap(next[7], next[70]);
    next[8] = next[80];
    m_crowd.people.triangulation().classifier().refuse();
    update(m_crowd.people, next);
  }));
  ASSERT_NO_FATAL_FAILURE(expect_next_frame_is_right());
}

// Throws, when it is told to, before it mends, halfway, or after it has mended.
class Failing_repair : public CGAL::Hold_and_flip_repair_2
{
public:
  enum class Way {
    MENDS,
    THROWS_BEFORE,
    THROWS_WHILE_VERTICES_ARE_HELD,
    THROWS_WHILE_VERTICES_ARE_OUT,
    THROWS_AFTER
  };

  void go(Way way) const { *m_way = way; }

  template <class Mender>
  void operator()(Mender& mender) const
  {
    const Way way = std::exchange(*m_way, Way::MENDS);
    if (way == Way::THROWS_BEFORE)
      throw Refusal();
    mender.hold();
    if (way == Way::THROWS_WHILE_VERTICES_ARE_HELD)
      throw Refusal();
    mender.flip();
    mender.release();
    if (way == Way::THROWS_WHILE_VERTICES_ARE_OUT)
      throw Refusal();
    CGAL::Hold_and_flip_repair_2::operator()(mender);
    if (way == Way::THROWS_AFTER)
      throw Refusal();
  }

private:
  std::shared_ptr<Way> m_way = std::make_shared<Way>(Way::MENDS);
};

TEST(Visitor_that_throws_amid_a_frame, does_not_keep_it_from_its_end)
{
  using Dynamic =
      CGAL::Dynamic_Delaunay_triangulation_2<Epick, CGAL::Default,
                                             CGAL::With_visitor_2<Interrupting_visitor>>;
  Cloud<Epick> cloud(61);
  const Frame first = frame_of(cloud.uniform(300)), next = next_of(first, cloud);
  bool has_thrown = true;
  for (int n = 1; has_thrown; n += 1 + n / 8) {
    SCOPED_TRACE(testing::Message() << "thing " << n);
    CGAL::Dynamic_population_2<Dynamic, int> people;
    update(people, first);
    people.visitor().throw_at(n);
    try {
      EXPECT_FALSE(update(people, next).rebuilt());
      has_thrown = false;
      ASSERT_GT(n, 100) << "it is told more than that";
    } catch (const Refusal&) {
    }
    ASSERT_NO_FATAL_FAILURE(expect_exact_people(people, next));
  }
}

TEST(Repair_that_throws_in_a_frame, leaves_what_the_next_frame_mends)
{
  using Dynamic = CGAL::Dynamic_Delaunay_triangulation_2<Epick, CGAL::Default,
                                                         CGAL::With_repair_2<Failing_repair>>;
  using Way = Failing_repair::Way;
  Cloud<Epick> cloud(62);
  const Frame first = frame_of(cloud.uniform(300)), next = next_of(first, cloud);
  for (const Way way : {Way::THROWS_BEFORE, Way::THROWS_WHILE_VERTICES_ARE_HELD,
                        Way::THROWS_WHILE_VERTICES_ARE_OUT, Way::THROWS_AFTER})
    for (const bool mends : {false, true}) {
      SCOPED_TRACE(testing::Message() << "way " << int(way) << ", mends " << mends);
      CGAL::Dynamic_population_2<Dynamic, int> people;
      update(people, first);
      people.triangulation().repair().go(way);
      EXPECT_THROW(update(people, next), Refusal);
      EXPECT_TRUE(people.triangulation().is_valid(true));
      // the points that leave are removed, and no new point is inserted
      Frame between = next;
      for (const int user_id : {900, 901, 902})
        between.erase(user_id);
      ASSERT_NO_FATAL_FAILURE(expect_people(people, between));
      if (mends) {
        EXPECT_TRUE(people.mend().certified);
        ASSERT_NO_FATAL_FAILURE(
            expect_exact(people.triangulation(), model_of(people.triangulation())));
      }
      update(people, next);
      ASSERT_NO_FATAL_FAILURE(expect_exact_people(people, next));
    }
}

} // namespace

// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Traits, data structures, classifiers, repairs, policies and visitors that users bring along:
// terrain, another metric, data in vertices and faces, and models of the concepts that can do no
// more than these demand. Kernels have their turn in all other tests.

#include "anisotropic_plane.h"
#include "archetypes.h"
#include "oracle.h"

#include <CGAL/Dynamic_Delaunay_triangulation_2/classifiers/Point_distance_classifier_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/repairs/Relocation_repair_2.h>
#include <CGAL/Indexed_triangulation_data_structure_2.h>
#include <CGAL/Projection_traits_xy_3.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <limits>
#include <map>
#include <random>
#include <set>
#include <type_traits>
#include <utility>
#include <vector>

namespace test_traits {

using Terrain = CGAL::Projection_traits_xy_3<Epick>;

namespace internal = CGAL::Dynamic_Delaunay_triangulations_2::internal;
// Points of the other types go from frame to frame with all their data, and not into checkpoints.
static_assert(internal::is_two_doubles<Epick::Point_2>);
static_assert(!internal::is_two_doubles<Epeck::Point_2>);
static_assert(internal::is_made_of_x_and_y<Epeck::Point_2>);
static_assert(!internal::is_made_of_x_and_y<Terrain::Point_2>);
static_assert(!internal::is_made_of_x_and_y<Named_point_archetype>);

template <class Traits>
using With_info = CGAL::Indexed_triangulation_data_structure_2<Traits, int, int>;

template <class Traits, class Tds>
struct Exact
{
  using Dynamic = CGAL::Dynamic_Delaunay_triangulation_2<Traits, CGAL::Default,
                                                         CGAL::With_data_structure_2<Tds>>;
  static Dynamic triangulation(const std::vector<typename Traits::Point_2>& points,
                               const CGAL::Static_engines_2& engines)
  {
    typename Dynamic::Settings settings;
    settings.engines = engines;
    return Dynamic(points.begin(), points.end(), settings);
  }
};

// A kernel, with archetypes of all that works on its points.
struct Plain
{
  using Dynamic = CGAL::Dynamic_Delaunay_triangulation_2<
      Epick, Classifier_archetype, CGAL::With_repair_2<Repair_archetype>,
      CGAL::With_data_structure_2<With_info<Epick>>, CGAL::With_policy_2<Policy_archetype>,
      CGAL::With_visitor_2<Visitor_archetype>>;
  static Dynamic triangulation(const std::vector<Epick::Point_2>& points,
                               const CGAL::Static_engines_2& engines)
  {
    const Dynamic::Settings settings{Classifier_archetype::make(), Repair_archetype::make(),
                                     engines, Policy_archetype::make(), Visitor_archetype::make()};
    return Dynamic(points.begin(), points.end(), settings);
  }
  static Epick::Point_2 at(double x, double y, int) { return {x, y}; }
  static int mark(const Epick::Point_2&) { return 0; }
};

// Points that hold more than their place.
struct Heights : Exact<Terrain, With_info<Terrain>>
{
  static Epick::Point_3 at(double x, double y, int mark) { return {x, y, double(mark)}; }
  static int mark(const Epick::Point_3& p) { return int(p.z()); }
};

struct Names : Exact<Delaunay_traits_archetype, With_info<Delaunay_traits_archetype>>
{
  static Named_point_archetype at(double x, double y, int mark)
  {
    return Named_point_archetype::at(float(x), float(y), mark);
  }
  static int mark(const Named_point_archetype& p) { return p.name(); }
};

// Circles that are ellipses.
struct Ellipses : Exact<Anisotropic_traits, With_info<Anisotropic_traits>>
{
  static Epick::Point_2 at(double x, double y, int) { return {x, y}; }
  static int mark(const Epick::Point_2&) { return 0; }
};

// Changes points, and knows where all of them have to be.
template <class Kind>
class Play
{
public:
  using Dynamic = typename Kind::Dynamic;
  using Point = typename Dynamic::Point;

  // Begins with a square lattice, full of ties.
  explicit Play(const CGAL::Static_engines_2& engines = {})
    : dt(Kind::triangulation(first_points(), engines))
  {
    for (const Point& p : first_points())
      points.emplace(points.size(), p);
  }

  // A point at (x, y), with a new mark.
  Point at(double x, double y) { return Kind::at(x, y, ++m_mark); }
  Point anywhere(double deviation = 3)
  {
    std::normal_distribution<double> coordinate(4, deviation);
    const double x = coordinate(m_random);
    return at(x, coordinate(m_random));
  }
  // A new point near the first place of a point.
  Point near_home(std::size_t id)
  {
    std::normal_distribution<double> step(0, 0.3);
    const double x = double(id % columns) + step(m_random);
    return at(x, double(id / columns) + step(m_random));
  }

  CGAL::Update_report_2 update()
  {
    std::vector<Point> all(dt.number_of_ids());
    for (const auto& [id, p] : points)
      all[id] = p;
    return dt.update(all.begin(), all.end());
  }
  std::size_t insert(const Point& p)
  {
    const std::size_t id = dt.insert(p);
    points.emplace(id, p);
    return id;
  }
  void remove(std::size_t id)
  {
    dt.remove(id);
    points.erase(id);
  }
  void move(std::size_t id, const Point& p)
  {
    dt.move(id, p);
    points[id] = p;
  }

  // Expects that no point and no mark is lost, and that the triangulation is right.
  void expect_right() const
  {
    ASSERT_NO_FATAL_FAILURE(expect_all_points());
    std::vector<Point> all;
    for (const auto& [id, p] : points)
      all.push_back(p);
    ASSERT_NO_FATAL_FAILURE(expect_delaunay(dt, all));
  }
  void expect_all_points() const
  {
    ASSERT_TRUE(dt.is_valid(true));
    ASSERT_EQ(dt.number_of_points(), points.size());
    for (const auto& [id, p] : points) {
      SCOPED_TRACE(testing::Message() << "id " << id);
      ASSERT_TRUE(are_same(dt.point(id), p));
      const auto vertex = dt.vertex(id);
      const Point& there = points.at(dt.id(vertex));
      ASSERT_TRUE(are_same(vertex->point(), there));
      ASSERT_TRUE(there.x() == p.x() && there.y() == p.y());
    }
  }

  static constexpr std::size_t columns = 9, rows = 9;
  Dynamic dt;
  std::map<std::size_t, Point> points;

private:
  static std::vector<Point> first_points()
  {
    std::vector<Point> result;
    for (std::size_t i = 0; i < rows; ++i)
      for (std::size_t j = 0; j < columns; ++j)
        result.push_back(Kind::at(double(j), double(i), -int(i * columns + j)));
    return result;
  }

  static bool are_same(const Point& p, const Point& q)
  {
    return p.x() == q.x() && p.y() == q.y() && Kind::mark(p) == Kind::mark(q);
  }

  std::mt19937 m_random{1};
  int m_mark = 0;
};

template <class Kind>
class Traits : public testing::Test
{
};
using Kinds = testing::Types<Plain, Heights, Names, Ellipses>;
TYPED_TEST_SUITE(Traits, Kinds);

TYPED_TEST(Traits, points_move_come_and_go_with_all_that_they_hold)
{
  Play<TypeParam> play;
  ASSERT_NO_FATAL_FAILURE(play.expect_right());
  for (int frame = 0; frame < 12; ++frame) {
    SCOPED_TRACE(testing::Message() << "frame " << frame);
    for (auto& [id, p] : play.points)
      p = frame % 4 == 3 ? play.anywhere() : play.near_home(id);
    EXPECT_TRUE(play.update().certified);
    ASSERT_NO_FATAL_FAILURE(play.expect_right());
    const std::size_t newcomer = play.insert(play.anywhere());
    ASSERT_NO_FATAL_FAILURE(play.expect_right());
    play.move(5, play.anywhere());
    play.move(newcomer, play.anywhere(20));
    ASSERT_NO_FATAL_FAILURE(play.expect_right());
    play.remove(newcomer);
    ASSERT_NO_FATAL_FAILURE(play.expect_right());
  }
}

TYPED_TEST(Traits, floating_point_filters_decide_whatever_else_points_hold)
{
  constexpr bool has_ellipses = std::is_same_v<TypeParam, Ellipses>;
  EXPECT_EQ(Play<TypeParam>().dt.frame().positions_are_exact(), !has_ellipses);
}

TYPED_TEST(Traits, points_in_one_place_share_a_vertex_and_part_with_all_that_they_hold)
{
  Play<TypeParam> play;
  for (const std::size_t id : {20u, 40u, 60u})
    play.points[id] = play.at(4.25, 4.5);
  play.update();
  EXPECT_EQ(play.dt.number_of_vertices(), play.points.size() - 2);
  ASSERT_NO_FATAL_FAILURE(play.expect_right());
  play.points[60] = play.at(4.25, 4.5); // the same place, but another mark
  play.update();
  ASSERT_NO_FATAL_FAILURE(play.expect_right());
  play.move(40, play.at(4.25, 4.5));
  ASSERT_NO_FATAL_FAILURE(play.expect_right());
  play.move(20, play.anywhere()); // and leaves its vertex to the others
  EXPECT_EQ(play.dt.vertex(40), play.dt.vertex(60));
  ASSERT_NO_FATAL_FAILURE(play.expect_right());
  const std::size_t newcomer = play.insert(play.at(4.25, 4.5));
  EXPECT_EQ(play.dt.vertex(newcomer), play.dt.vertex(60));
  play.remove(play.dt.id(play.dt.vertex(60)));
  ASSERT_NO_FATAL_FAILURE(play.expect_right());
  for (auto& [id, p] : play.points)
    p = play.near_home(id);
  play.update();
  EXPECT_EQ(play.dt.number_of_vertices(), play.points.size());
  ASSERT_NO_FATAL_FAILURE(play.expect_right());
  for (auto& [id, p] : play.points)
    p = play.at(double(id % 5), double(id % 7));
  play.update();
  EXPECT_EQ(play.dt.number_of_vertices(), 35u);
  ASSERT_NO_FATAL_FAILURE(play.expect_right());
}

TYPED_TEST(Traits, points_that_trade_places_take_all_that_they_hold_along)
{
  Play<TypeParam> play;
  using Mover = std::pair<std::size_t, typename Play<TypeParam>::Point>;
  const std::vector<Mover> movers{{30, play.at(4, 3)}, {31, play.at(3, 3)}};
  play.dt.move(movers.begin(), movers.end());
  for (const auto& [id, p] : movers)
    play.points[id] = p;
  ASSERT_NO_FATAL_FAILURE(play.expect_right());
}

TYPED_TEST(Traits, points_on_a_line_are_kept_and_span_the_plane_again)
{
  Play<TypeParam> play;
  for (auto& [id, p] : play.points)
    p = play.at(double(id % 50), 2 * double(id % 50));
  EXPECT_TRUE(play.update().certified);
  EXPECT_EQ(play.dt.triangulation().dimension(), 1);
  ASSERT_NO_FATAL_FAILURE(play.expect_right());
  play.move(49, play.at(30, 60)); // to where two others are
  play.remove(3);
  ASSERT_NO_FATAL_FAILURE(play.expect_right());
  play.insert(play.at(1, 70));
  EXPECT_EQ(play.dt.triangulation().dimension(), 2);
  ASSERT_NO_FATAL_FAILURE(play.expect_right());
}

TYPED_TEST(Traits, each_engine_takes_points_as_they_are)
{
  for (const auto engine :
       {CGAL::Static_engine_2::INSERTION, CGAL::Static_engine_2::BOWYER_WATSON}) {
    Play<TypeParam> play({engine, engine});
    play.points[17] = play.at(5, 5); // to another one
    for (int frame = 0; frame < 3; ++frame) {
      play.update();
      ASSERT_NO_FATAL_FAILURE(play.expect_right());
      for (auto& [id, p] : play.points)
        p = play.near_home(id);
    }
  }
}

TYPED_TEST(Traits, what_is_kept_in_a_vertex_stays_through_updates_and_rebuilds)
{
  Play<TypeParam> play;
  const auto founders = play.points;
  for (const auto& founder : founders)
    play.dt.vertex(founder.first)->info() = int(founder.first) + 1;
  const auto expect_info = [&] {
    ASSERT_NO_FATAL_FAILURE(play.expect_right());
    for (const auto& founder : founders)
      ASSERT_EQ(play.dt.vertex(founder.first)->info(), int(founder.first) + 1);
  };
  for (auto& [id, p] : play.points)
    p = id == 40 ? play.near_home(id) : p;
  EXPECT_FALSE(play.update().rebuilt());
  ASSERT_NO_FATAL_FAILURE(expect_info());
  for (auto& [id, p] : play.points)
    p = play.anywhere();
  EXPECT_TRUE(play.update().rebuilt());
  ASSERT_NO_FATAL_FAILURE(expect_info());
  play.move(7, play.anywhere());
  play.remove(play.insert(play.anywhere()));
  ASSERT_NO_FATAL_FAILURE(expect_info());
  std::vector<typename Play<TypeParam>::Point> crowd;
  for (int i = 0; i < 50; ++i) {
    crowd.push_back(play.anywhere());
    play.points.emplace(founders.size() + std::size_t(i), crowd.back());
  }
  std::vector<std::size_t> ids;
  EXPECT_TRUE(play.dt.insert(crowd.begin(), crowd.end(), std::back_inserter(ids)).rebuilt());
  ASSERT_NO_FATAL_FAILURE(expect_info());
}

template <class Dynamic>
std::set<std::pair<std::size_t, std::size_t>> edges_by_ids(const Dynamic& dt)
{
  std::set<std::pair<std::size_t, std::size_t>> edges;
  for (const auto& [face, i] : dt.triangulation().finite_edges())
    edges.insert(std::minmax({dt.id(face->vertex((i + 1) % 3)), dt.id(face->vertex((i + 2) % 3))}));
  return edges;
}

TEST(Another_metric, has_the_edges_of_points_that_are_stretched_until_circles_are_round)
{
  Play<Ellipses> play;
  for (auto& [id, p] : play.points)
    p = play.near_home(id);
  play.update();
  std::vector<Epick::Point_2> points, stretched;
  for (const auto& [id, p] : play.points) {
    points.push_back(p);
    stretched.emplace_back(3 * p.x() + p.y(), p.y() / 2 - p.x() / 4);
  }
  using Usual = CGAL::Dynamic_Delaunay_triangulation_2<Epick>;
  EXPECT_EQ(edges_by_ids(play.dt), edges_by_ids(Usual(stretched.begin(), stretched.end())));
  EXPECT_NE(edges_by_ids(play.dt), edges_by_ids(Usual(points.begin(), points.end())));
}

TEST(Terrain, a_height_that_changes_alone_breaks_nothing)
{
  Play<Heights> play;
  for (auto& [id, p] : play.points)
    p = play.at(p.x(), p.y());
  const auto report = play.update();
  EXPECT_EQ(report.flips + report.splices, 0u);
  EXPECT_FALSE(report.rebuilt());
  ASSERT_NO_FATAL_FAILURE(play.expect_right());
}

TEST(Terrain, heights_stay_as_they_are_if_a_frame_is_refused)
{
  Play<Heights> play;
  const auto points = play.points;
  for (auto& [id, p] : play.points)
    p = play.anywhere();
  play.points[80] = play.at(0, std::numeric_limits<double>::quiet_NaN());
  EXPECT_THROW(play.update(), CGAL::Non_finite_coordinate_error_2);
  play.points = points;
  ASSERT_NO_FATAL_FAILURE(play.expect_right());
}

TEST(Terrain, heights_may_be_anything)
{
  Play<Heights> play;
  const double infinity = std::numeric_limits<double>::infinity();
  play.dt.move(11, Epick::Point_3(0.5, 0.5, infinity));
  EXPECT_EQ(play.dt.point(11).z(), infinity);
  EXPECT_TRUE(play.dt.is_certified());
}

// CGAL's own relocation, for a heuristic classifier.
struct Relocated_heights : Heights
{
  using Dynamic =
      CGAL::Dynamic_Delaunay_triangulation_2<Terrain, CGAL::Point_distance_classifier_2,
                                             CGAL::With_repair_2<CGAL::Relocation_repair_2>,
                                             CGAL::With_data_structure_2<With_info<Terrain>>>;
  static Dynamic triangulation(const std::vector<Epick::Point_3>& points,
                               const CGAL::Static_engines_2&)
  {
    return Dynamic(points.begin(), points.end());
  }
};

TEST(Terrain, heuristics_and_relocation_take_heights_along)
{
  Play<Relocated_heights> play;
  for (int frame = 0; frame < 4; ++frame) {
    SCOPED_TRACE(testing::Message() << "frame " << frame);
    for (auto& [id, p] : play.points)
      p = id % 2 == 0 ? play.near_home(id) : play.at(p.x(), p.y());
    const auto report = play.update();
    EXPECT_FALSE(report.certified);
    EXPECT_EQ(report.relocated, 41u);
    ASSERT_NO_FATAL_FAILURE(play.expect_all_points());
    play.dt.mend();
    ASSERT_NO_FATAL_FAILURE(play.expect_right());
  }
}

} // namespace test_traits

// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Any finite doubles are coordinates: the result is as exact at the ends of their range, and where
// differences are subnormal, as it is at ordinary numbers. What no double can hold is refused.
// Compiled for SSE4.1 or AVX all that is so below a limit, and the larger numbers are left out
// here.

#include "exact_signs.h"
#include "oracle.h"
#include "quadruples.h"

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
#include <CGAL/Dynamic_Delaunay_triangulation_2/repairs/Flip_repair_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/repairs/Relocation_repair_2.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace {

namespace internal = CGAL::Dynamic_Delaunay_triangulations_2::internal;
using CGAL::Dynamic_Delaunay_triangulations_2::Edge_2;
using CGAL::Dynamic_Delaunay_triangulations_2::Edge_index;
using CGAL::Dynamic_Delaunay_triangulations_2::Index;
using CGAL::Dynamic_Delaunay_triangulations_2::Vertex_index;

constexpr double tiniest = std::numeric_limits<double>::denorm_min();

// No number may make an algorithm slow: each test must end within a minute.
class Numbers : public testing::Test
{
protected:
  void TearDown() override
  {
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - m_start;
    EXPECT_LT(elapsed.count(), 60);
  }

private:
  std::chrono::steady_clock::time_point m_start = std::chrono::steady_clock::now();
};

// MOTION ------------------------------------------------------------------------------------------

using Positions = std::vector<Position_2>;

constexpr double half_width = 1 << 20;

Positions cloud_of(std::size_t n, Random& random)
{
  Positions points;
  for (std::size_t i = 0; i < n; ++i) {
    const double x = std::round(between(random, -half_width, half_width));
    points.push_back({x, std::round(between(random, -half_width, half_width))});
  }
  return points;
}

Positions lattice_of(std::size_t n)
{
  Positions points;
  for (std::size_t i = 0; i < n; ++i)
    points.push_back({(double(i % 6) - 3) * 0x1p18, (double(i / 6) - 3) * 0x1p18});
  return points;
}

Positions circle_of(std::size_t n)
{
  Positions points;
  for (const auto& p : Cloud<Epick>::on_circle(n))
    points.push_back({p.x() * 0x1p13, p.y() * 0x1p13});
  return points;
}

Positions line_of(std::size_t n, Random& random)
{
  Positions points;
  for (std::size_t i = 0; i < n; ++i) {
    const int k = whole(random, -1000, 1000);
    points.push_back({k * 0x1p10, k * 0x1p9});
  }
  return points;
}

Positions shaken(Positions points, double step, Random& random)
{
  for (Position_2& p : points) {
    p.x = std::round(p.x + between(random, -step, step));
    p.y = std::round(p.y + between(random, -step, step));
  }
  return points;
}

Positions mirrored(Positions points)
{
  for (Position_2& p : points)
    p.x = -p.x;
  return points;
}

// Moves the first points to the last one.
Positions with_coincidences(Positions points)
{
  for (std::size_t i = 0; i < 5; ++i)
    points[i] = points.back();
  return points;
}

Positions with_teleports(Positions points, Random& random)
{
  for (int i = 0; i < 3; ++i)
    points[random() % points.size()] = cloud_of(1, random).front();
  return points;
}

// Everything that can happen to a few points, all coordinates whole numbers of up to 21 bits.
std::vector<Positions> story_of(const Positions& start, Random& random)
{
  std::vector<Positions> frames{start};
  const auto add = [&](const Positions& points) { frames.push_back(points); };
  for (int i = 0; i < 3; ++i)
    add(shaken(frames.back(), 0x1p8, random));
  add(frames.back());
  for (int i = 0; i < 2; ++i)
    add(shaken(frames.back(), 0x1p15, random));
  add(mirrored(frames.back()));
  add(with_coincidences(frames.back()));
  add(with_coincidences(shaken(frames.back(), 0x1p10, random)));
  add(shaken(frames.back(), 0x1p10, random));
  add(with_teleports(frames.back(), random));
  add(cloud_of(start.size(), random));
  add(line_of(start.size(), random));
  add(Positions(start.size(), start.back()));
  add(start);
  return frames;
}

std::vector<std::vector<Positions>> stories(std::size_t n)
{
  Random random(9);
  std::vector<std::vector<Positions>> result;
  for (const Positions& start :
       {cloud_of(n, random), lattice_of(n), circle_of(n), line_of(n, random)})
    result.push_back(story_of(start, random));
  return result;
}

// PLACES ------------------------------------------------------------------------------------------

// How the whole numbers of a story are mapped to coordinates.
struct Place
{
  std::string name;
  double (*x)(double);
  double (*y)(double);
};

double mixed(double k)
{
  return k == 0 ? 0 : std::copysign(std::pow(10, 300 * (std::abs(k) / half_width) - 150), k);
}

// In sixteen clusters along the unit interval.
double clustered(double k)
{
  const double cluster = std::floor(k * 0x1p-17);
  return cluster / 16 + 1e-12 * (k * 0x1p-17 - cluster);
}

#define SCALED(factor) +[](double k) { return k * (factor); }
#define SHIFTED(offset, step) +[](double k) { return (offset) + k * (step); }

std::vector<Place> all_places()
{
  const auto same = [](const std::string& name, double (*f)(double)) { return Place{name, f, f}; };
  return {
      same("1", SCALED(1)),
      same("1e-300", SCALED(1e-300)),
      same("1e-150", SCALED(1e-150)),
      same("1e-100", SCALED(1e-100)),
      same("1e100", SCALED(1e100)),
      same("1e150", SCALED(1e150)),
      same("1e300", SCALED(1e300)),
      same("2^-500", SCALED(0x1p-500)),
      same("2^-260, where products of four begin to underflow", SCALED(0x1p-260)),
      same("2^236, where they begin to overflow", SCALED(0x1p236)),
      same("2^490, where squares begin to overflow", SCALED(0x1p490)),
      same("up to the largest double", SCALED(largest * 0x1p-22)),
      same("so wide that differences overflow", SCALED(largest * 0x1p-20 / 1.125)),
      same("multiples of the tiniest double", SCALED(tiniest)),
      same("subnormal and normal", SCALED(0x1p-1040)),
      same("1 and a few of its last bits", SHIFTED(1.5, 0x1p-52)),
      same("tiny motion at 1e15", SHIFTED(1e15, 0.125)),
      same("tiny motion at 1e15 that rounds", SHIFTED(1e15, 1e-4)),
      same("tiny motion at 1e150", SHIFTED(1e150, 0x1p446)),
      same("mixed from 1e-150 to 1e150", mixed),
      same("clusters of 1e-12", clustered),
      {"x huge, y tiny", SCALED(1e150), SCALED(1e-150)},
      {"x as huge and y as tiny as can be", SCALED(largest * 0x1p-22), SCALED(tiniest)},
      {"x mixed, y subnormal", mixed, SCALED(tiniest)},
      {"x far away, y around 0", SHIFTED(1e300, 0x1p944), SCALED(1)},
  };
}

#undef SCALED
#undef SHIFTED

std::vector<Place> places()
{
  std::vector<Place> result = all_places();
  const auto is_beyond = [](const Place& place) {
    return !internal::is_within_limit(within_range(place.x(-2 * half_width))) ||
           !internal::is_within_limit(within_range(place.y(-2 * half_width)));
  };
  result.erase(std::remove_if(result.begin(), result.end(), is_beyond), result.end());
  return result;
}

template <class Kernel>
std::vector<typename Kernel::Point_2> put(const Positions& points, const Place& place)
{
  std::vector<typename Kernel::Point_2> result;
  for (const Position_2& p : points)
    result.emplace_back(within_range(place.x(p.x)), within_range(place.y(p.y)));
  return result;
}

// TRUTH -------------------------------------------------------------------------------------------

// The certificate in integers, for frames whose positions are exact.
template <class Frame>
class Delaunay_by_integers
{
public:
  explicit Delaunay_by_integers(const Frame& frame)
    : m_frame(frame)
  {
  }

  bool holds() const
  {
    if (m_frame.number_of_edges() == 0)
      return are_on_a_line();
    for (Edge_index e(0); e < m_frame.number_of_edges(); ++e)
      if (!is_delaunay(m_frame.edge(e)))
        return false;
    return hull_turns_once();
  }

private:
  static constexpr Vertex_index infinite = internal::infinite_index;

  const Position_2& at(Vertex_index v) const { return m_frame.position(v); }

  int orientation(Vertex_index a, Vertex_index b, Vertex_index c) const
  {
    return exact_signs::orientation(at(a), at(b), at(c));
  }

  bool is_less(Vertex_index v, Vertex_index w) const
  {
    return at(v).x != at(w).x ? at(v).x < at(w).x : at(v).y < at(w).y;
  }

  bool are_on_a_line() const
  {
    for (Vertex_index v(3); v <= m_frame.number_of_vertices(); ++v)
      if (orientation(Vertex_index(1), Vertex_index(2), v) != 0)
        return false;
    return true;
  }

  bool is_delaunay(const Edge_2& edge) const
  {
    if (edge.source == infinite)
      return is_convex(edge.left, edge.target, edge.right);
    if (edge.target == infinite)
      return is_convex(edge.right, edge.source, edge.left);
    const bool is_left = edge.left != infinite, is_right = edge.right != infinite;
    return (!is_left || orientation(edge.left, edge.source, edge.target) > 0) &&
           (!is_right || orientation(edge.right, edge.target, edge.source) > 0) &&
           (!is_left || !is_right ||
            exact_signs::side_of_circle(at(edge.left), at(edge.source), at(edge.target),
                                        at(edge.right)) <= 0);
  }

  bool is_convex(Vertex_index before, Vertex_index v, Vertex_index after) const
  {
    const int turn = orientation(before, v, after);
    return turn > 0 || (turn == 0 && is_less(before, v) == is_less(v, after));
  }

  bool hull_turns_once() const
  {
    int summits = 0;
    for (Edge_index e(0); e < m_frame.number_of_edges(); ++e) {
      const Edge_2& edge = m_frame.edge(e);
      if (edge.source == infinite || edge.target == infinite) {
        const Vertex_index v = edge.source == infinite ? edge.target : edge.source;
        summits += is_less(edge.left, v) && is_less(edge.right, v);
      }
    }
    return summits == 1;
  }

  const Frame& m_frame;
};

template <class Dynamic>
bool is_delaunay_by_integers(const Dynamic& dt)
{
  const auto frame = dt.frame();
  return Delaunay_by_integers<typename Dynamic::Frame>(frame).holds();
}

template <class Dynamic>
void expect_exact_by_integers(const Dynamic& dt, const std::vector<typename Dynamic::Point>& points)
{
  ASSERT_NO_FATAL_FAILURE(expect_exact(dt, points));
  ASSERT_TRUE(is_delaunay_by_integers(dt));
}

// EXACT UPDATES -----------------------------------------------------------------------------------

class Motion : public Numbers
{
protected:
  template <class Kernel, class Classifier = CGAL::Circumcircle_classifier_2,
            class Repair = CGAL::Default>
  static void expect_exact_everywhere(std::size_t n)
  {
    const auto all_stories = stories(n);
    for (const Place& place : places())
      for (std::size_t i = 0; i < all_stories.size(); ++i) {
        SCOPED_TRACE(place.name + ", story " + std::to_string(i));
        expect_exact_through<Kernel, Classifier, Repair>(all_stories[i], place);
        if (HasFatalFailure())
          return;
      }
  }

  template <class Kernel, class Classifier, class Repair>
  static void expect_exact_through(const std::vector<Positions>& frames, const Place& place)
  {
    auto points = put<Kernel>(frames.front(), place);
    CGAL::Dynamic_Delaunay_triangulation_2<Kernel, Classifier, CGAL::With_repair_2<Repair>> dt(
        points.begin(), points.end());
    ASSERT_NO_FATAL_FAILURE(expect_exact_by_integers(dt, points));
    for (std::size_t i = 1; i < frames.size(); ++i) {
      SCOPED_TRACE(testing::Message() << "frame " << i);
      points = put<Kernel>(frames[i], place);
      ASSERT_TRUE(dt.update(points.begin(), points.end()).certified);
      ASSERT_NO_FATAL_FAILURE(expect_exact_by_integers(dt, points));
    }
  }
};

TEST_F(Motion, is_followed_exactly_at_any_numbers)
{
  expect_exact_everywhere<Epick>(36);
}

TEST_F(Motion, is_followed_exactly_at_any_numbers_by_safe_regions)
{
  expect_exact_everywhere<Epick, CGAL::Safe_region_classifier_2>(25);
}

TEST_F(Motion, is_followed_exactly_at_any_numbers_by_splices)
{
  expect_exact_everywhere<Epick, CGAL::Circumcircle_classifier_2, CGAL::Border_splice_repair_2>(25);
}

TEST_F(Motion, is_followed_exactly_at_any_numbers_by_relocations)
{
  expect_exact_everywhere<Epick, CGAL::Circumcircle_classifier_2, CGAL::Relocation_repair_2>(25);
}

TEST_F(Motion, is_followed_exactly_at_any_numbers_with_exact_constructions)
{
  expect_exact_everywhere<Epeck>(16);
}

// So many frames that edges and vertices are skipped.
template <class Classifier>
void expect_exact_in_calm(const Place& place, double step)
{
  Random random(10);
  const Positions rest = cloud_of(80, random);
  auto points = put<Epick>(rest, place);
  CGAL::Dynamic_Delaunay_triangulation_2<Epick, Classifier> dt(points.begin(), points.end());
  for (int frame = 0; frame < 20; ++frame) {
    Positions moved = shaken(rest, step, random);
    if (frame % 10 == 9)
      moved = with_teleports(moved, random);
    points = put<Epick>(moved, place);
    dt.update(points.begin(), points.end());
    ASSERT_TRUE(is_delaunay_by_integers(dt)) << "frame " << frame;
  }
  ASSERT_NO_FATAL_FAILURE(expect_exact(dt, points));
}

TEST_F(Motion, is_followed_exactly_at_any_numbers_where_all_is_calm)
{
  for (const Place& place : places())
    for (const double step : {1., 0x1p9}) {
      SCOPED_TRACE(testing::Message() << place.name << ", steps of " << step);
      ASSERT_NO_FATAL_FAILURE(expect_exact_in_calm<CGAL::Circumcircle_classifier_2>(place, step));
      ASSERT_NO_FATAL_FAILURE(expect_exact_in_calm<CGAL::Safe_region_classifier_2>(place, step));
    }
}

TEST_F(Motion, of_thousands_of_points_is_followed_at_any_numbers)
{
  Random random(11);
  const Positions rest = cloud_of(1500, random), moved = shaken(rest, 0x1p9, random);
  for (const Place& place : places()) {
    SCOPED_TRACE(place.name);
    auto points = put<Epick>(rest, place);
    CGAL::Dynamic_Delaunay_triangulation_2<Epick> dt(points.begin(), points.end());
    points = put<Epick>(moved, place);
    dt.update(points.begin(), points.end());
    ASSERT_NO_FATAL_FAILURE(expect_exact(dt, points));
  }
}

TEST_F(Motion, from_one_magnitude_to_another_is_followed)
{
  Random random(12);
  const Positions rest = cloud_of(36, random);
  CGAL::Dynamic_Delaunay_triangulation_2<Epick> dt;
  {
    const auto points = put<Epick>(rest, places().front());
    dt = CGAL::Dynamic_Delaunay_triangulation_2<Epick>(points.begin(), points.end());
  }
  for (int round = 0; round < 2; ++round)
    for (const Place& place : places()) {
      SCOPED_TRACE(place.name);
      const auto points = put<Epick>(shaken(rest, 0x1p12, random), place);
      dt.update(points.begin(), points.end());
      ASSERT_NO_FATAL_FAILURE(expect_exact_by_integers(dt, points));
    }
}

// READING -----------------------------------------------------------------------------------------

template <class Point>
using Segments = std::vector<std::pair<Point, Point>>;

template <class Point>
std::pair<Point, Point> ordered(const Point& p, const Point& q)
{
  return p < q ? std::make_pair(p, q) : std::make_pair(q, p);
}

class Reading : public Numbers
{
};

TEST_F(Reading, edges_by_their_ids_gives_those_of_the_true_triangulation)
{
  Random random(13);
  const Positions cloud = cloud_of(40, random);
  for (const Place& place : places()) {
    SCOPED_TRACE(place.name);
    const auto points = put<Epick>(cloud, place);
    const CGAL::Dynamic_Delaunay_triangulation_2<Epick> dt(points.begin(), points.end());
    Segments<Epick::Point_2> edges, true_edges;
    dt.for_each_edge(
        [&](std::size_t i, std::size_t j) { edges.push_back(ordered(points[i], points[j])); });
    const auto& triangulation = dt.triangulation();
    for (auto e = triangulation.finite_edges_begin(); e != triangulation.finite_edges_end(); ++e)
      true_edges.push_back(ordered(e->first->vertex(triangulation.cw(e->second))->point(),
                                   e->first->vertex(triangulation.ccw(e->second))->point()));
    std::sort(edges.begin(), edges.end());
    std::sort(true_edges.begin(), true_edges.end());
    EXPECT_EQ(edges, true_edges);
  }
}

// HEURISTICS --------------------------------------------------------------------------------------

struct Absurd_velocity
{
  Position_2 value;

  Position_2 operator()(Index) const { return value; }
};

class Heuristics : public Numbers
{
protected:
  // Expects that no point is lost, that the structure is sound, and that certificates are true.
  template <class Classifier, class Repair = CGAL::Default>
  static void expect_honest(const Classifier& classifier = Classifier())
  {
    static const auto all_stories = stories(25);
    for (const Place& place : places())
      for (std::size_t i : {0u, 1u}) {
        SCOPED_TRACE(place.name + ", story " + std::to_string(i));
        expect_honest<Classifier, Repair>(classifier, all_stories[i], place);
        if (HasFatalFailure())
          return;
      }
  }

private:
  template <class Classifier, class Repair>
  static void expect_honest(const Classifier& classifier, const std::vector<Positions>& frames,
                            const Place& place)
  {
    auto points = put<Epick>(frames.front(), place);
    CGAL::Dynamic_Delaunay_triangulation_2<Epick, Classifier, CGAL::With_repair_2<Repair>> dt(
        points.begin(), points.end(), classifier);
    for (std::size_t i = 1; i < frames.size(); ++i) {
      SCOPED_TRACE(testing::Message() << "frame " << i);
      points = put<Epick>(frames[i], place);
      dt.update(points.begin(), points.end());
      ASSERT_NO_FATAL_FAILURE(expect_valid(dt, points));
      const bool is_delaunay = is_delaunay_by_integers(dt);
      ASSERT_TRUE(is_delaunay || !dt.is_certified());
      if (i % 3 == 0) {
        ASSERT_EQ(dt.certify(), is_delaunay);
      }
      if (i % 5 == 0)
        dt.mend();
    }
    dt.mend();
    ASSERT_NO_FATAL_FAILURE(expect_exact_by_integers(dt, points));
  }
};

TEST_F(Heuristics, by_lengths_are_honest_at_any_numbers)
{
  for (const double x : {0., 0.7, 1.}) {
    SCOPED_TRACE(x);
    ASSERT_NO_FATAL_FAILURE(expect_honest(CGAL::Point_distance_classifier_2(x)));
    ASSERT_NO_FATAL_FAILURE(expect_honest(CGAL::Inflation_aware_classifier_2(x)));
  }
}

TEST_F(Heuristics, that_predict_are_honest_at_any_numbers_and_velocities)
{
  using Predictive = CGAL::Predictive_point_distance_classifier_2<Absurd_velocity>;
  for (const Position_2 velocity : {Position_2{0, tiniest}, Position_2{largest, -largest},
                                    Position_2{HUGE_VAL, 1}, Position_2{NAN, NAN}}) {
    SCOPED_TRACE(velocity.x);
    ASSERT_NO_FATAL_FAILURE(expect_honest(Predictive(Absurd_velocity{velocity}, 0.9)));
  }
}

TEST_F(Heuristics, by_circumcenters_are_honest_at_any_numbers)
{
  ASSERT_NO_FATAL_FAILURE(expect_honest<CGAL::Voronoi_circumcenter_classifier_2>());
  ASSERT_NO_FATAL_FAILURE(expect_honest<CGAL::Estimated_voronoi_circumcenter_classifier_2>());
  for (const double x : {0., 1.}) {
    SCOPED_TRACE(x);
    ASSERT_NO_FATAL_FAILURE(expect_honest(CGAL::Voronoi_edge_length_classifier_2(x)));
  }
}

TEST_F(Heuristics, of_nearly_delaunay_are_honest_at_any_numbers)
{
  for (const double eps : {0., tiniest, 0.05, 1.}) {
    SCOPED_TRACE(eps);
    ASSERT_NO_FATAL_FAILURE(expect_honest(CGAL::Nearly_delaunay_classifier_2(eps)));
  }
}

TEST_F(Heuristics, by_chance_are_honest_at_any_numbers_with_any_repair)
{
  using CGAL::Random_classifier_2;
  ASSERT_NO_FATAL_FAILURE(expect_honest(Random_classifier_2(0)));
  ASSERT_NO_FATAL_FAILURE(expect_honest(Random_classifier_2(1)));
  const Random_classifier_2 some(0.2);
  ASSERT_NO_FATAL_FAILURE((expect_honest<Random_classifier_2, CGAL::Flip_repair_2>(some)));
  ASSERT_NO_FATAL_FAILURE((expect_honest<Random_classifier_2, CGAL::Border_splice_repair_2>(some)));
  ASSERT_NO_FATAL_FAILURE((expect_honest<Random_classifier_2, CGAL::Hold_and_flip_repair_2>(some)));
  ASSERT_NO_FATAL_FAILURE((expect_honest<Random_classifier_2, CGAL::Relocation_repair_2>(some)));
}

TEST_F(Heuristics, that_are_refined_are_honest_at_any_numbers)
{
  using CGAL::Point_distance_classifier_2;
  using CGAL::Voronoi_circumcenter_classifier_2;
  ASSERT_NO_FATAL_FAILURE(
      (expect_honest<CGAL::Refined_classifier_2<Point_distance_classifier_2,
                                                Voronoi_circumcenter_classifier_2>>()));
  ASSERT_NO_FATAL_FAILURE(
      (expect_honest<CGAL::Refined_classifier_2<CGAL::Circumcircle_classifier_2,
                                                CGAL::Safe_region_classifier_2>>()));
}

// WHAT NO DOUBLE HOLDS ----------------------------------------------------------------------------

class Exact_numbers : public Numbers
{
protected:
  using Point = Epeck::Point_2;
  using Dynamic = CGAL::Dynamic_Delaunay_triangulation_2<Epeck>;

  static std::vector<Point> times(const std::vector<Point>& points, const Epeck::FT& factor)
  {
    std::vector<Point> result;
    for (const Point& p : points)
      result.emplace_back(p.x() * factor, p.y() * factor);
    return result;
  }
};

TEST_F(Exact_numbers, too_large_for_doubles_are_refused_and_nothing_changes)
{
  std::vector<Point> points = Cloud<Epeck>(1).uniform(30);
  Dynamic dt(points.begin(), points.end());
  for (const int sign : {1, -1}) {
    auto beyond = points;
    beyond[7] = Point(1, Epeck::FT(largest) * 4 * sign);
    try {
      dt.update(beyond.begin(), beyond.end());
      FAIL();
    } catch (const CGAL::Non_finite_coordinate_error_2& error) {
      EXPECT_EQ(error.id(), 7u);
      EXPECT_EQ(error.y(), sign * HUGE_VAL);
    }
    ASSERT_NO_FATAL_FAILURE(expect_exact(dt, points));
    EXPECT_THROW(Dynamic(beyond.begin(), beyond.end()), CGAL::Non_finite_coordinate_error_2);
  }
}

// Between doubles it depends on the kernel how large is too large.
TEST_F(Exact_numbers, next_to_the_largest_double_are_refused_or_followed)
{
  for (const double x : {0.4 * largest, 0.6 * largest, std::nextafter(largest, 0)}) {
    std::vector<Point> points = Cloud<Epeck>(3).uniform(10);
    Dynamic dt(points.begin(), points.end());
    auto moved = points;
    moved[7] = Point(Epeck::FT(x) + Epeck::FT(1) / 3, -x);
    try {
      dt.update(moved.begin(), moved.end());
      points = moved;
    } catch (const CGAL::Non_finite_coordinate_error_2& error) {
      EXPECT_EQ(error.id(), 7u);
      EXPECT_GT(x, largest / 2);
    } catch (const CGAL::Coordinate_range_error_2& error) {
      EXPECT_EQ(error.id(), 7u);
      EXPECT_GT(x, error.limit());
    }
    ASSERT_NO_FATAL_FAILURE(expect_exact(dt, points));
  }
}

TEST_F(Exact_numbers, too_small_or_too_close_for_doubles_are_told_apart)
{
  Cloud<Epeck> cloud(2);
  std::vector<Point> points = cloud.uniform(30);
  Dynamic dt(points.begin(), points.end());
  const Epeck::FT tiny = Epeck::FT(1e-300) * Epeck::FT(1e-300);
  for (int frame = 0; frame < 3; ++frame) {
    cloud.shake(points, 0.05);
    const auto small = times(points, tiny);
    dt.update(small.begin(), small.end());
    EXPECT_FALSE(dt.frame().positions_are_exact());
    ASSERT_NO_FATAL_FAILURE(expect_exact(dt, small));
    std::vector<Point> close;
    for (const Point& p : small)
      close.emplace_back(1 + p.x(), 1e150 + p.y());
    dt.update(close.begin(), close.end());
    ASSERT_NO_FATAL_FAILURE(expect_exact(dt, close));
  }
}

TEST_F(Exact_numbers, up_to_the_largest_double_are_coordinates)
{
  if (!internal::is_within_limit(largest))
    GTEST_SKIP() << "compiled for SSE4.1 or newer, which refuses coordinates so large";
  const std::vector<Point> corners = {{-largest, -largest},
                                      {largest, -largest},
                                      {largest, largest},
                                      {-largest, largest},
                                      {tiniest, -tiniest}};
  Dynamic dt(corners.begin(), corners.end());
  ASSERT_NO_FATAL_FAILURE(expect_exact_by_integers(dt, corners));
  auto moved = corners;
  moved[4] = Point(largest, 0);
  dt.update(moved.begin(), moved.end());
  ASSERT_NO_FATAL_FAILURE(expect_exact_by_integers(dt, moved));
}

} // namespace

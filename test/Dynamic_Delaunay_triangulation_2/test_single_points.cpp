// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Single points are removed, moved and inserted. A certified triangulation stays certified without
// a look at all edges; an uncertified one must not become certified by a shortcut.

#include "oracle.h"
#include "population_player.h"

#include <CGAL/Dynamic_Delaunay_triangulation_2/classifiers/Random_classifier_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/topology/Point_ids_2.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <iterator>
#include <limits>
#include <map>
#include <random>
#include <set>
#include <vector>

namespace test_single_points {

using Dynamic = CGAL::Dynamic_Delaunay_triangulation_2<Epick>;
using Point = Epick::Point_2;
using Points = std::vector<Point>;

std::size_t degree_of(const Dynamic& dt, std::size_t id)
{
  return dt.tds().degree(dt.vertex(id));
}

bool is_on_hull(const Dynamic& dt, std::size_t id)
{
  return dt.triangulation().is_edge(dt.vertex(id), dt.infinite_vertex());
}

// Adds points far away from the origin, so many that one change is not worth a rebuild.
void add_surroundings(Points& points)
{
  std::mt19937 random(1);
  std::uniform_real_distribution<double> distance(900, 1100);
  for (int i = 0; i < 60; ++i) {
    const double angle = 2 * CGAL_PI * i / 60, r = distance(random);
    points.push_back(Point(r * std::cos(angle), r * std::sin(angle)));
  }
}

// A point in the middle of so many others, which are nearly on a circle, and surroundings.
Points wheel(std::size_t spokes, unsigned seed)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> part(0, 0.4);
  Points points(1, Point(0, 0));
  for (std::size_t i = 0; i < spokes; ++i) {
    const double angle = 2 * CGAL_PI * (double(i) + part(random)) / double(spokes);
    points.push_back(Point(2 * std::cos(angle), 2 * std::sin(angle)));
  }
  add_surroundings(points);
  return points;
}

// A point inside of so many others, which are exactly on a circle, and surroundings.
Points exact_wheel(std::size_t spokes)
{
  const Points circle = Cloud<Epick>::on_circle(36);
  Points upper, lower;
  for (const Point& p : circle)
    (p.y() > 0 ? upper : lower).push_back(p);
  Points points(1, Point(1, 2));
  for (std::size_t i = 0; i < spokes / 2; ++i) {
    points.push_back(upper[i * upper.size() / (spokes / 2)]);
    points.push_back(lower[i * lower.size() / (spokes / 2)]);
  }
  add_surroundings(points);
  return points;
}

// How many flips are expected after a removal.
enum class Flips { NONE, ANY };

void expect_exact_without_first(const Points& points, Flips flips)
{
  Dynamic dt(points.begin(), points.end());
  const CGAL::Update_report_2 report = dt.remove(0);
  if (flips == Flips::NONE) {
    EXPECT_FALSE(report.rebuilt());
    EXPECT_EQ(report.flips, 0u);
  }
  const Model<Dynamic> model = model_of(dt);
  EXPECT_EQ(model.size() + 1, points.size());
  expect_exact(dt, model);
}

TEST(A_removal, leaves_faces_that_are_delaunay_whatever_the_degree)
{
  for (std::size_t spokes = 3; spokes <= 24; ++spokes)
    for (unsigned seed = 0; seed < 20; ++seed) {
      SCOPED_TRACE(spokes);
      const Points points = wheel(spokes, seed);
      ASSERT_EQ(degree_of(Dynamic(points.begin(), points.end()), 0), spokes);
      ASSERT_NO_FATAL_FAILURE(expect_exact_without_first(points, Flips::NONE));
    }
}

TEST(A_removal, of_a_hub_with_many_neighbors_is_exact_too)
{
  for (const std::size_t spokes : {25, 26, 40, 300})
    ASSERT_NO_FATAL_FAILURE(expect_exact_without_first(wheel(spokes, 1), Flips::ANY));
}

TEST(A_removal, inside_of_points_on_one_circle_leaves_any_of_their_triangulations)
{
  for (const std::size_t n : {4, 6, 8, 12, 16, 24})
    ASSERT_NO_FATAL_FAILURE(expect_exact_without_first(exact_wheel(n), Flips::NONE));
}

// One of several vertices on a circle: the vertex itself is on the circle of the new faces.
TEST(A_removal, of_one_of_many_points_on_one_circle_is_exact)
{
  Points points = Cloud<Epick>::on_circle(24);
  for (const double place : {-1000., 1000.}) {
    points.push_back(Point(place, 7));
    points.push_back(Point(3, place));
  }
  for (std::size_t id = 0; id < points.size(); ++id) {
    Dynamic dt(points.begin(), points.end());
    dt.remove(id);
    ASSERT_NO_FATAL_FAILURE(expect_exact(dt, model_of(dt)));
  }
}

// Points that are moved off a circle by the least that doubles can tell.
TEST(A_removal, amid_ties_that_are_off_by_one_digit_is_exact)
{
  std::mt19937 random(3);
  const double up = std::numeric_limits<double>::infinity();
  const auto nearly = [&](double x) {
    const auto kind = random() % 3;
    return kind == 0 ? x : std::nextafter(x, kind == 1 ? up : -up);
  };
  for (int run = 0; run < 200; ++run) {
    Points points = exact_wheel(12);
    for (std::size_t i = 1; i <= 12; ++i) {
      const double x = nearly(points[i].x());
      points[i] = Point(x, nearly(points[i].y()));
    }
    ASSERT_NO_FATAL_FAILURE(expect_exact_without_first(points, Flips::NONE));
  }
}

TEST(A_removal, of_vertices_of_a_cloud_meets_all_usual_degrees_and_hardly_ever_flips)
{
  Cloud<Epick> cloud(5);
  const Points points = cloud.uniform(2000);
  Dynamic dt(points.begin(), points.end());
  std::set<std::size_t> degrees;
  for (std::size_t id = 0; id < 1500; ++id) {
    const bool is_outside = is_on_hull(dt, id);
    degrees.insert(degree_of(dt, id));
    const CGAL::Update_report_2 report = dt.remove(id);
    if (!is_outside) {
      ASSERT_EQ(report.flips, 0u);
    }
    ASSERT_TRUE(report.certified);
  }
  for (std::size_t degree = 3; degree <= 10; ++degree)
    EXPECT_EQ(degrees.count(degree), 1u) << degree;
  expect_exact(dt, model_of(dt));
}

TEST(Removals, of_many_vertices_in_one_call_are_exact_whether_they_are_at_the_hull_or_not)
{
  for (unsigned seed = 0; seed < 20; ++seed) {
    Cloud<Epick> cloud(seed);
    const Points points = cloud.uniform(400);
    Dynamic dt(points.begin(), points.end());
    std::vector<std::size_t> ids;
    for (std::size_t id = 0; id < points.size(); ++id)
      if ((is_on_hull(dt, id) && ids.size() < 20) || id % 40 == seed)
        ids.push_back(id);
    const CGAL::Update_report_2 report = dt.remove(ids.begin(), ids.end());
    EXPECT_FALSE(report.rebuilt());
    ASSERT_NO_FATAL_FAILURE(expect_exact(dt, model_of(dt)));
  }
}

std::size_t number_of_steps()
{
  const char* const steps = std::getenv("DYNAMIC_DELAUNAY_SINGLE_CHANGES");
  return steps == nullptr ? 20000 : std::size_t(std::strtoull(steps, nullptr, 10));
}

TEST(Single_changes, are_exact_whatever_comes_goes_and_moves_near_or_far)
{
  constexpr unsigned seeds = 20;
  for (unsigned seed = 0; seed < seeds; ++seed) {
    SCOPED_TRACE(seed);
    Population_player<Dynamic> player({9, seed % 2 == 0, true}, seed, 6 + seed % 5 * 15);
    ASSERT_NO_FATAL_FAILURE(player.play(int(number_of_steps() / seeds)));
  }
}

// A few points jump, and a classifier that names no vertex leaves the faces as they are: some
// overlap, and some are inverted. Then single points change.
class Single_changes_of_overlapping_faces
{
public:
  Single_changes_of_overlapping_faces(std::size_t points, unsigned seed)
    : m_random(seed)
    , m_dt(CGAL::Random_classifier_2(0))
  {
    while (m_model.size() < points)
      insert(place());
    for (std::size_t k = 0; k < points / 20; ++k)
      m_model[m_random() % points] = place();
    Points moved;
    for (const auto& [id, p] : m_model)
      moved.push_back(p);
    m_dt.update(moved.begin(), moved.end());
  }

  // Changes points until a change has triangulated everything anew.
  void run(std::size_t steps)
  {
    ASSERT_FALSE(m_dt.is_certified());
    for (std::size_t step = 0; step < steps && !m_dt.is_certified(); ++step) {
      change();
      ++m_changes;
      ASSERT_NO_FATAL_FAILURE(expect_valid(m_dt, m_model)) << "step " << step;
    }
  }

  std::size_t number_of_changes() const { return m_changes; }

private:
  using Blind = CGAL::Dynamic_Delaunay_triangulation_2<Epick, CGAL::Random_classifier_2>;

  Point place() { return random_point_between<Point>(0, 9, m_random); }

  void insert(const Point& p) { m_model.emplace(m_dt.insert(p), p); }

  void change()
  {
    const auto any = std::next(m_model.begin(), std::ptrdiff_t(m_random() % m_model.size()));
    switch (m_random() % 3) {
    case 0:
      insert(place());
      break;
    case 1:
      m_dt.remove(any->first);
      m_model.erase(any);
      break;
    default:
      any->second = place();
      m_dt.move(any->first, any->second);
    }
  }

  std::mt19937 m_random;
  Blind m_dt;
  Model<Blind> m_model;
  std::size_t m_changes = 0; // made while faces overlap
};

TEST(Single_changes, keep_a_valid_structure_where_faces_overlap)
{
  constexpr unsigned seeds = 300;
  std::size_t changes_of_overlapping = 0;
  for (unsigned seed = 0; seed < seeds; ++seed) {
    SCOPED_TRACE(seed);
    Single_changes_of_overlapping_faces changes(40 + seed % 4 * 60, seed);
    ASSERT_NO_FATAL_FAILURE(changes.run(12));
    changes_of_overlapping += changes.number_of_changes();
  }
  EXPECT_GT(changes_of_overlapping, 2 * seeds);
}

// The ids of points, which are numbers here, at vertices that come, go, merge and lose points. A
// map knows where each of them is.
class Ids_and_their_vertices
{
  using Vertex_index = CGAL::Dynamic_Delaunay_triangulations_2::Vertex_index;
  using Point_id = CGAL::Dynamic_Delaunay_triangulations_2::Point_id;
  using Ids = CGAL::Dynamic_Delaunay_triangulations_2::internal::Point_ids_2<int>;
  struct Where
  {
    Vertex_index vertex;
    bool is_covered;
    int point; // of the covered ones
  };

public:
  explicit Ids_and_their_vertices(unsigned seed)
    : m_random(seed)
  {
    m_ids.reset(0);
    m_ids.finish_numbering();
    add_vertex(new_id());
  }

  void change()
  {
    const Point_id id = any_id();
    const Vertex_index vertex = m_model.at(id).vertex, other = any_vertex();
    const auto kind = m_random() % 8;
    if (kind == 0 || m_model.size() < 8)
      add_vertex(new_id());
    else if (kind < 3)
      cover(new_id(), other);
    else if (kind == 3 && m_model.at(id).is_covered)
      cover(id, other);
    else if (kind == 4 && m_model.at(id).is_covered)
      add_vertex(id);
    else if (kind == 5)
      exchange_representative(vertex);
    else if (kind == 6 && other != vertex)
      merge(other, vertex);
    else if (kind == 7)
      remove(id);
  }

  void expect_all() const
  {
    std::map<Vertex_index, std::set<Point_id>> covered_at;
    std::vector<Point_id> covered;
    ASSERT_EQ(m_ids.number_of_points(), m_model.size());
    for (const auto& [id, where] : m_model) {
      ASSERT_TRUE(m_ids.is_taken(id));
      ASSERT_EQ(m_ids.vertex(id), where.vertex);
      ASSERT_EQ(m_ids.is_representative(id), !where.is_covered);
      if (where.is_covered) {
        ASSERT_EQ(m_ids.covered_point(id), where.point);
        ASSERT_EQ(m_ids.covered_id(m_ids.covered_number(id)), id);
        covered.push_back(id);
        covered_at[where.vertex].insert(id);
      } else
        ASSERT_EQ(m_ids.representative(where.vertex), id);
    }
    ASSERT_EQ(m_ids.covered_ids(), covered);
    for (Vertex_index v(1); v <= m_ids.number_of_representatives(); ++v) {
      std::vector<Point_id> found;
      m_ids.for_each_covered_at(v, [&](Point_id id, int) { found.push_back(id); });
      std::sort(found.begin(), found.end());
      const std::set<Point_id>& expected = covered_at[v];
      ASSERT_EQ(found, std::vector<Point_id>(expected.begin(), expected.end()));
    }
  }

private:
  Point_id any_id()
  {
    return std::next(m_model.begin(), std::ptrdiff_t(m_random() % m_model.size()))->first;
  }
  Vertex_index any_vertex()
  {
    return Vertex_index(1 + m_random() % m_ids.number_of_representatives());
  }

  Point_id new_id()
  {
    std::vector<Point_id> ids;
    m_ids.list_next_ids(1, ids);
    m_ids.reserve(ids);
    return ids.front();
  }

  void add_vertex(Point_id id)
  {
    m_ids.append_vertex();
    const Vertex_index vertex(m_ids.number_of_representatives());
    m_ids.place_representative(id, vertex);
    m_model[id] = {vertex, false, 0};
  }

  void cover(Point_id id, Vertex_index vertex)
  {
    const int point = int(m_random() % 100);
    m_ids.place_covered(id, vertex, point);
    m_model[id] = {vertex, true, point};
  }

  // Makes the smallest id whose point is even the representative.
  void exchange_representative(Vertex_index vertex)
  {
    const auto is_even = [](int point) { return point % 2 == 0; };
    const Point_id id = m_ids.find_covered_at(vertex, is_even);
    const auto expected = std::find_if(m_model.begin(), m_model.end(), [&](const auto& entry) {
      const Where& where = entry.second;
      return where.vertex == vertex && where.is_covered && is_even(where.point);
    });
    constexpr Point_id none = CGAL::Dynamic_Delaunay_triangulations_2::internal::null_index;
    ASSERT_EQ(id, expected == m_model.end() ? none : expected->first);
    if (id == none)
      return;
    m_model[m_ids.representative(vertex)] = {vertex, true, 7};
    m_ids.exchange_representative(id, 7);
    expected->second.is_covered = false;
  }

  void merge(Vertex_index goes, Vertex_index stays)
  {
    m_model[m_ids.representative(goes)] = {goes, true, 5};
    m_ids.merge(goes, stays, 5);
    for (auto& [id, where] : m_model)
      if (where.vertex == goes)
        where.vertex = stays;
    drop(goes);
  }

  void remove(Point_id id)
  {
    const Where where = m_model.at(id);
    if (where.is_covered)
      m_ids.remove_covered(id);
    else {
      bool is_alone = true;
      m_ids.for_each_covered_at(where.vertex, [&](Point_id, int) { is_alone = false; });
      if (!is_alone)
        return;
      m_ids.remove_representative(id);
    }
    m_model.erase(id);
    if (!where.is_covered)
      drop(where.vertex);
  }

  void drop(Vertex_index vertex)
  {
    const Vertex_index last(m_ids.number_of_representatives());
    if (vertex != last)
      m_ids.move_points(last, vertex);
    m_ids.resize(last - 1);
    for (auto& [id, where] : m_model)
      if (where.vertex == last)
        where.vertex = vertex;
  }

  std::mt19937 m_random;
  Ids m_ids;
  std::map<Point_id, Where> m_model;
};

TEST(Covered_points, merge_part_and_get_other_vertices_and_numbers_as_a_map_does)
{
  for (unsigned seed = 0; seed < 20; ++seed) {
    Ids_and_their_vertices ids(seed);
    for (int step = 0; step < 400; ++step) {
      SCOPED_TRACE(testing::Message() << "seed " << seed << ", step " << step);
      ids.change();
      ASSERT_NO_FATAL_FAILURE(ids.expect_all());
    }
  }
}

} // namespace test_single_points

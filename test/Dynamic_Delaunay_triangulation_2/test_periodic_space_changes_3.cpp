// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// What follows a triangulation of periodic space from call to call: visitors, policies, populations
// and checkpoints.

#include "forged_checkpoint.h"
#include "periodic_space_oracle.h"

#include <CGAL/Dynamic_Delaunay_triangulation_2/policies/Always_static_policy_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/Dynamic_population_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/Periodic_edge_changes_visitor_3.h>
#include <CGAL/Dynamic_periodic_Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <random>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace test_periodic_space_changes_3 {

using Epick = CGAL::Exact_predicates_inexact_constructions_kernel;
using Visitor = CGAL::Periodic_edge_changes_visitor_3;
using Edge = Visitor::Edge;
using Plain = CGAL::Dynamic_periodic_Delaunay_triangulation_3<Epick>;
using Watched =
    CGAL::Dynamic_periodic_Delaunay_triangulation_3<Epick, CGAL::With_visitor_2<Visitor>>;
using Point = Plain::Point;
using Cell = CGAL::Periodic_cell_3;
using Shift = CGAL::Periodic_shift_3;
using periodic_space_oracle::cells_of;
using periodic_space_oracle::operator+;
using periodic_space_oracle::operator-;

Edge in_order(const Edge& e)
{
  const Edge reverse{e.j, e.i, Shift{0, 0, 0} - e.shift};
  if (e.i != e.j)
    return e.i < e.j ? e : reverse;
  return reverse < e ? e : reverse;
}

template <class Dynamic>
std::set<Edge> edges_of(const Dynamic& dt)
{
  std::set<Edge> edges;
  dt.for_each_edge([&](std::size_t i, std::size_t j, const Shift& shift) {
    EXPECT_TRUE(edges.insert(in_order({i, j, shift})).second);
  });
  return edges;
}

// Positions in multiples of 2^-30, vectors of 2^-6: translations are exact.
double rounded(double x)
{
  return std::ldexp(std::rint(std::ldexp(x, 30)), -30);
}
Point random_point(std::mt19937_64& random)
{
  std::uniform_real_distribution<double> x(-1, 2);
  return Point(rounded(x(random)), rounded(x(random)), rounded(x(random)));
}
Point translated(const Point& p, const Cell& cell, const Shift& shift)
{
  std::array<double, 3> x{p.x(), p.y(), p.z()};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k)
      x[k] += shift[i] * cell.vector(i)[k];
  return Point(x[0], x[1], x[2]);
}
Shift random_shift(std::mt19937_64& random)
{
  std::uniform_int_distribution<int> number(-2, 2);
  return {number(random), number(random), number(random)};
}
Point near(const Point& p, double step, std::mt19937_64& random)
{
  std::uniform_real_distribution<double> x(-step, step);
  return Point(p.x() + rounded(x(random)), p.y() + rounded(x(random)), p.z() + rounded(x(random)));
}

const Cell sheared({1, 0, 0}, {0.25, 1.125, 0}, {-0.125, 0.375, 0.875});

// VISITORS ----------------------------------------------------------------------------------------

// Follows a triangulation whose points are translated by known shifts, and what the edges at the
// beginning are called meanwhile.
class Followed
{
public:
  Followed(std::size_t points, unsigned seed)
    : m_random(seed)
    , m_dt(sheared)
  {
    for (std::size_t i = 0; i < points; ++i)
      m_dt.insert(random_point(m_random));
    if (points > 6)
      m_dt.move(3, translated(m_dt.point(1), sheared, {1, 0, -1})); // both coincide
    m_dt.visitor().clear();
    m_start = edges_of(m_dt);
  }

  void do_something()
  {
    switch (m_random() % 7) {
    case 0:
      return move_all(0.02);
    case 1:
      return move_all(0.2);
    case 2:
      return exchange_cell();
    case 3:
      m_dt.insert(random_point(m_random));
      return;
    case 4:
      if (m_dt.number_of_points() > 1)
        m_dt.remove(random_id());
      return;
    default:
      return move_one();
    }
  }

  // What the visitor lists leads from the edges at the beginning to the present ones.
  void expect_changes() const
  {
    std::set<Edge> edges = edges_of(m_dt);
    for (const Edge& e : m_dt.visitor().created_edges())
      EXPECT_EQ(edges.erase(e), 1u);
    for (const Edge& e : m_dt.visitor().removed_edges())
      EXPECT_TRUE(edges.insert(e).second);
    EXPECT_EQ(edges, m_start);
    EXPECT_TRUE(m_dt.is_valid(true));
  }

private:
  void move_all(double step)
  {
    std::vector<Point> points;
    std::map<std::size_t, Shift> shifts;
    for (std::size_t i = 0; i < m_dt.number_of_ids(); ++i) {
      shifts[i] = m_dt.has_id(i) ? random_shift(m_random) : Shift{0, 0, 0};
      points.push_back(m_dt.has_id(i)
                           ? translated(near(m_dt.point(i), step, m_random), m_dt.cell(), shifts[i])
                           : Point(0, 0, 0));
    }
    m_dt.update(points);
    translate(shifts);
  }

  void move_one()
  {
    const std::size_t id = random_id();
    const Shift shift = random_shift(m_random);
    m_dt.move(id, translated(near(m_dt.point(id), 0.05, m_random), m_dt.cell(), shift));
    translate({{id, shift}});
  }

  // The first vector becomes the sum of the first two; the third loses the first one.
  void exchange_cell()
  {
    const auto a = m_dt.cell().a(), b = m_dt.cell().b(), c = m_dt.cell().c();
    if (std::abs(a[0]) + std::abs(b[0]) + std::abs(c[0]) > 20)
      return;
    const Cell::Coordinates first{a[0] + b[0], a[1] + b[1], a[2] + b[2]};
    const Cell::Coordinates third{c[0] - a[0], c[1] - a[1], c[2] - a[2]};
    std::vector<Point> points;
    for (std::size_t i = 0; i < m_dt.number_of_ids(); ++i)
      points.push_back(m_dt.has_id(i) ? m_dt.point(i) : Point(0, 0, 0));
    m_dt.update(points, Cell(first, b, third));
    // a = first - b, and c = third + a
    std::set<Edge> renamed;
    for (Edge e : m_start) {
      const int of_a = e.shift[0] + e.shift[2];
      e.shift = {of_a, e.shift[1] - of_a, e.shift[2]};
      renamed.insert(in_order(e));
    }
    m_start.swap(renamed);
  }

  void translate(const std::map<std::size_t, Shift>& shifts)
  {
    const auto of = [&](std::size_t id) {
      const auto at = shifts.find(id);
      return at == shifts.end() ? Shift{0, 0, 0} : at->second;
    };
    std::set<Edge> renamed;
    for (Edge e : m_start) {
      e.shift = e.shift + of(e.i) - of(e.j);
      renamed.insert(in_order(e));
    }
    m_start.swap(renamed);
  }

  std::size_t random_id()
  {
    std::vector<std::size_t> ids;
    for (std::size_t i = 0; i < m_dt.number_of_ids(); ++i)
      if (m_dt.has_id(i))
        ids.push_back(i);
    return ids[m_random() % ids.size()];
  }

  std::mt19937_64 m_random;
  Watched m_dt;
  std::set<Edge> m_start;
};

TEST(Visitors_in_periodic_space, lead_from_former_edges_to_present_ones)
{
  for (unsigned seed = 0; seed < 40; ++seed) {
    SCOPED_TRACE(seed);
    Followed followed(seed < 20 ? 1 + seed : 4 * seed, seed);
    for (int step = 0; step < 12; ++step) {
      followed.do_something();
      ASSERT_NO_FATAL_FAILURE(followed.expect_changes());
      if (testing::Test::HasFailure())
        return;
    }
  }
}

// Tells facets, too, in a map of its own.
struct Facets_visitor : CGAL::Delaunay_update_visitor_base_3
{
  using Facet = std::vector<int>; // ids and shifts

  static Facet facet(const std::array<std::size_t, 3>& ids, const std::array<Shift, 3>& shifts)
  {
    Facet numbers;
    for (std::size_t i = 0; i < 3; ++i) {
      numbers.push_back(int(ids[i]));
      numbers.insert(numbers.end(), shifts[i].begin(), shifts[i].end());
    }
    return numbers;
  }

  template <class Dynamic>
  void after_facet_removal(const Dynamic&, const std::array<std::size_t, 3>& ids,
                           const std::array<Shift, 3>& shifts)
  {
    EXPECT_EQ(facets.erase(facet(ids, shifts)), 1u);
  }
  template <class Dynamic>
  void after_facet_creation(const Dynamic&, const std::array<std::size_t, 3>& ids,
                            const std::array<Shift, 3>& shifts)
  {
    EXPECT_EQ(shifts[0], Shift());
    EXPECT_TRUE(facets.insert(facet(ids, shifts)).second);
  }

  std::set<Facet> facets;
};

TEST(Visitors_in_periodic_space, are_told_of_facets)
{
  std::mt19937_64 random(3);
  CGAL::Dynamic_periodic_Delaunay_triangulation_3<Epick, CGAL::With_visitor_2<Facets_visitor>> dt(
      sheared);
  std::vector<Point> points;
  for (int i = 0; i < 50; ++i)
    points.push_back(random_point(random));
  dt.insert(points);
  for (int frame = 0; frame < 20; ++frame) {
    EXPECT_EQ(dt.visitor().facets.size(), dt.number_of_facets());
    for (Point& p : points)
      p = near(p, frame < 10 ? 0.01 : 0.1, random);
    dt.update(points);
  }
}

struct Failing_visitor : Visitor
{
  template <class Dynamic>
  void before_update(const Dynamic&)
  {
    if (fails)
      throw std::runtime_error("no");
  }
  bool fails = false;
};

TEST(Visitors_in_periodic_space, that_throw_before_an_update_stop_it)
{
  CGAL::Dynamic_periodic_Delaunay_triangulation_3<Epick, CGAL::With_visitor_2<Failing_visitor>> dt(
      Cell(1, 1, 1));
  dt.insert(Point(0.5, 0.5, 0.5));
  dt.visitor().fails = true;
  EXPECT_THROW(dt.insert(Point(0.25, 0.5, 0.5)), std::runtime_error);
  EXPECT_EQ(dt.number_of_points(), 1u);
  dt.visitor().fails = false;
  dt.insert(Point(0.25, 0.5, 0.5));
  EXPECT_TRUE(dt.is_valid(true));
}

// POLICIES ----------------------------------------------------------------------------------------

TEST(Policies_in_periodic_space, choose_rebuilds)
{
  using Static = CGAL::Dynamic_periodic_Delaunay_triangulation_3<
      Epick, CGAL::With_policy_2<CGAL::Always_static_policy_2>>;
  std::mt19937_64 random(4);
  std::vector<Point> points;
  for (int i = 0; i < 60; ++i)
    points.push_back(random_point(random));
  Static rebuilt(points, sheared);
  Plain mended(points, sheared);
  for (int frame = 0; frame < 5; ++frame) {
    for (Point& p : points)
      p = near(p, 0.01, random);
    const Cell cell(1.0 + 0.01 * frame, 1.0, 1.0);
    EXPECT_EQ(rebuilt.update(points, cell).rebuild_reason, CGAL::Rebuild_reason_2::POLICY);
    mended.update(points, cell);
    EXPECT_EQ(cells_of(rebuilt), cells_of(mended));
  }
}

struct Throwing_policy : CGAL::Always_static_policy_2
{
  template <class Frame>
  bool wants_rebuild(const Frame& frame)
  {
    EXPECT_GT(frame.number_of_cells(), 0u);
    throw std::runtime_error("no");
  }
};

TEST(Policies_in_periodic_space, that_throw_change_nothing)
{
  std::mt19937_64 random(5);
  std::vector<Point> points;
  for (int i = 0; i < 30; ++i)
    points.push_back(random_point(random));
  CGAL::Dynamic_periodic_Delaunay_triangulation_3<Epick, CGAL::With_policy_2<Throwing_policy>> dt(
      points, sheared);
  const auto before = cells_of(dt);
  std::vector<Point> moved = points;
  for (Point& p : moved)
    p = near(p, 0.05, random);
  EXPECT_THROW(dt.update(moved, Cell(2, 1, 1)), std::runtime_error);
  EXPECT_EQ(dt.cell(), sheared);
  EXPECT_EQ(cells_of(dt), before);
  EXPECT_TRUE(dt.is_certified());
  EXPECT_TRUE(dt.is_valid(true));
  for (std::size_t i = 0; i < points.size(); ++i)
    EXPECT_EQ(dt.point(i), points[i]);
}

// POPULATIONS -------------------------------------------------------------------------------------

using Population = CGAL::Dynamic_population_3<Plain>;
using Crowd = std::map<std::int64_t, Point>;

void expect_population(const Population& population, const Crowd& crowd)
{
  ASSERT_EQ(population.size(), crowd.size());
  std::map<std::size_t, Point> points;
  for (const auto& [user_id, p] : crowd) {
    EXPECT_EQ(population.point(user_id), p);
    points[population.id(user_id)] = p;
  }
  EXPECT_TRUE(population.triangulation().is_valid(true));
  periodic_space_oracle::Oracle<Point>(points, population.triangulation().cell())
      .expect_Delaunay(population.triangulation());
}

TEST(Populations_in_periodic_space, come_and_go_in_cells_that_change)
{
  for (unsigned seed = 0; seed < 6; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    Population population(Plain(Cell(1, 1, 1)));
    Crowd crowd;
    std::int64_t next = 7;
    for (int frame = 0; frame < 12; ++frame) {
      for (auto& [id, p] : crowd)
        p = near(p, 0.01, random);
      for (std::size_t n = 0; n < 4; ++n)
        if (!crowd.empty() && random() % 2 == 0)
          crowd.erase(std::next(crowd.begin(), std::ptrdiff_t(random() % crowd.size())));
      for (std::size_t n = 0; n < (frame == 0 ? 30 * seed : 4); ++n)
        crowd[next += 3] = random_point(random);
      if (frame % 3 == 2 && crowd.size() > 1) // at the same place, another image
        crowd.begin()->second =
            translated(crowd.rbegin()->second, population.triangulation().cell(), {0, 1, 0});
      if (frame % 4 == 3)
        population.update(crowd, Cell(1.0 + 0.125 * frame, 1, 1));
      else
        population.update(crowd);
      ASSERT_NO_FATAL_FAILURE(expect_population(population, crowd));
    }
  }
}

TEST(Populations_in_periodic_space, change_by_single_points_too)
{
  Population population(Plain(Cell(1, 1, 1)));
  population.insert(5, Point(0.1, 0.2, 0.3));
  population.insert(2, Point(0.6, 0.2, 0.3));
  population.move(5, Point(2.1, 0.2, 0.4));
  EXPECT_THROW(population.move(5, Point(1e9, 0, 0)), CGAL::Periodic_range_error_3);
  EXPECT_THROW(population.insert(5, Point(0, 0, 0)), CGAL::Repeated_id_error_2);
  expect_population(population, {{5, Point(2.1, 0.2, 0.4)}, {2, Point(0.6, 0.2, 0.3)}});
  population.remove(2);
  expect_population(population, {{5, Point(2.1, 0.2, 0.4)}});
  Crowd crowd{{5, Point(0, 0, 0)}, {6, Point(0, 0, 4e6)}};
  EXPECT_THROW(population.update(crowd, Cell(1, 1, 2)), CGAL::Periodic_range_error_3);
  EXPECT_EQ(population.triangulation().cell(), Cell(1, 1, 1));
  population.update(crowd, Cell(1, 1, 8));
  expect_population(population, crowd);
}

// CHECKPOINTS -------------------------------------------------------------------------------------

template <class Any>
std::string written(const Any& any)
{
  std::ostringstream out;
  any.write_checkpoint(out);
  return out.str();
}

TEST(Checkpoints_in_periodic_space, go_on_as_if_nothing_had_been)
{
  for (const std::size_t number : {0u, 1u, 2u, 9u, 80u}) {
    SCOPED_TRACE(number);
    std::mt19937_64 random(number);
    std::vector<Point> points;
    for (std::size_t i = 0; i < number; ++i)
      points.push_back(random_point(random));
    if (number > 8)
      points[4] = translated(points[7], sheared, {0, -1, 1});
    Plain dt(points, sheared);
    if (number > 2)
      dt.remove(2);
    for (int frame = 0; frame < 3; ++frame) {
      for (Point& p : points)
        p = near(p, 0.02, random);
      if (number > 8)
        points[4] = translated(points[7], sheared, {0, -1, 1});
      dt.update(points);
    }
    const std::string file = written(dt);
    Plain other(Cell(5, 6, 7));
    std::istringstream in(file);
    in >> other;
    ASSERT_TRUE(in);
    EXPECT_TRUE(other.is_certified());
    EXPECT_TRUE(other.is_valid(true));
    EXPECT_EQ(other.cell(), dt.cell());
    EXPECT_EQ(written(other), file);
    for (int frame = 0; frame < 3; ++frame) {
      for (Point& p : points)
        p = near(p, 0.05, random);
      const Cell cell(1.0, 1.0 + 0.03125 * frame, 1.0);
      const auto first = dt.update(points, cell), second = other.update(points, cell);
      EXPECT_EQ(first.flips, second.flips);
      EXPECT_EQ(first.held, second.held);
      EXPECT_EQ(first.unproved, second.unproved);
      EXPECT_EQ(written(dt), written(other));
    }
  }
}

TEST(Checkpoints_in_periodic_space, keep_populations)
{
  std::mt19937_64 random(8);
  Population population{Plain(sheared)};
  Crowd crowd;
  for (int i = 0; i < 20; ++i)
    crowd[100 - 3 * i] = random_point(random);
  population.update(crowd);
  Population other{Plain(Cell(1, 1, 1))};
  std::istringstream in(written(population));
  other.read_checkpoint(in);
  expect_population(other, crowd);
  crowd.erase(100);
  crowd[-5] = random_point(random);
  other.update(crowd);
  expect_population(other, crowd);
}

TEST(Checkpoints_in_periodic_space, tell_visitors_what_has_changed)
{
  std::mt19937_64 random(9);
  Watched dt(sheared), other(Cell(1, 2, 1));
  for (int i = 0; i < 12; ++i) {
    dt.insert(random_point(random));
    other.insert(random_point(random));
  }
  std::set<Edge> edges = edges_of(dt);
  dt.visitor().clear();
  std::istringstream in(written(other));
  dt.read_checkpoint(in);
  for (const Edge& e : dt.visitor().removed_edges())
    EXPECT_EQ(edges.erase(e), 1u);
  for (const Edge& e : dt.visitor().created_edges())
    EXPECT_TRUE(edges.insert(e).second);
  EXPECT_EQ(edges, edges_of(dt));
  EXPECT_EQ(edges, edges_of(other));
}

// Whatever number is replaced by another one, the file is refused, or is another right file.
TEST(Checkpoints_in_periodic_space, are_refused_or_right)
{
  std::mt19937_64 random(10);
  std::vector<Point> points;
  for (int i = 0; i < 5; ++i)
    points.push_back(random_point(random));
  Plain dt(points, sheared);
  dt.insert(translated(points[0], sheared, {1, 1, 1}));
  const std::string file = written(dt);
  Plain other(Cell(2, 2, 2));
  other.insert(Point(0, 0, 0));
  const std::string before = written(other);
  int refused = 0, accepted = 0;
  for (std::size_t at = 0; at < file.size(); ++at)
    for (const char c : {'0', '1', '7', '-', ' '}) {
      if (file[at] == c || file[at] == '\n')
        continue;
      std::string forged = file;
      forged[at] = c;
      std::istringstream in(resealed(forged));
      Plain subject = other;
      try {
        subject.read_checkpoint(in);
        EXPECT_TRUE(subject.is_valid(true));
        ++accepted;
      } catch (const CGAL::Checkpoint_error_2&) {
        EXPECT_EQ(written(subject), before);
        ++refused;
      }
    }
  EXPECT_GT(refused, 1000);
  EXPECT_GT(accepted, 0); // a point that is a little elsewhere
}

} // namespace test_periodic_space_changes_3

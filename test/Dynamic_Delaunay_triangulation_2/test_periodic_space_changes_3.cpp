// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// What follows a triangulation of periodic space from call to call, in tori, slabs and wires:
// visitors, policies, populations and checkpoints.

#include "forged_checkpoint.h"
#include "periodic_space_oracle.h"
#include "periodic_space_tested.h"

#include <CGAL/Dynamic_Delaunay_triangulation_2/policies/Always_dynamic_policy_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/policies/Always_static_policy_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/Dynamic_population_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/visitors/Delaunay_update_visitor_base_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/visitors/Periodic_edge_changes_visitor_3.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <map>
#include <random>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace test_periodic_space_changes_3 {

using namespace periodic_space_tested;

using Visitor = CGAL::Periodic_edge_changes_visitor_3;
using Edge = Visitor::Edge;
template <class Visitor>
using With_visitor =
    CGAL::Dynamic_periodic_Delaunay_triangulation_3<Kernel, CGAL::With_visitor_2<Visitor>>;
template <class Policy>
using With_policy =
    CGAL::Dynamic_periodic_Delaunay_triangulation_3<Kernel, CGAL::With_policy_2<Policy>>;
using Watched = With_visitor<Visitor>;

Edge in_order(const Edge& e)
{
  const Edge reverse{e.j, e.i, Shift{0, 0, 0} - e.shift};
  if (e.i != e.j)
    return e.i < e.j ? e : reverse;
  return reverse < e ? e : reverse;
}

std::set<Edge> edges_of(const Watched& dt)
{
  std::set<Edge> edges;
  dt.for_each_edge([&](std::size_t i, std::size_t j, const Shift& shift) {
    EXPECT_TRUE(edges.insert(in_order({i, j, shift})).second);
  });
  return edges;
}

Shift random_shift(std::mt19937_64& random, std::size_t dimension)
{
  std::uniform_int_distribution<int> number(-2, 2);
  return {number(random), dimension > 1 ? number(random) : 0, dimension > 2 ? number(random) : 0};
}

// VISITORS ----------------------------------------------------------------------------------------

// Follows a triangulation whose points are translated by known shifts, and what the edges at the
// beginning are called meanwhile.
class Followed
{
public:
  Followed(const Kind& kind, const Cell& cell, const Points& points, unsigned seed)
    : m_kind(kind)
    , m_random(seed)
    , m_dt(points, cell)
  {
    if (points.size() > 6)
      m_dt.move(3, image(m_dt.point(1), {1, 0, -1}, cell)); // both coincide
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
      m_dt.insert(near(Point(0.5, 0.5, 0.5), 1.5, m_random));
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
    Points points;
    std::map<std::size_t, Shift> shifts;
    for (std::size_t i = 0; i < m_dt.number_of_ids(); ++i) {
      shifts[i] = m_dt.has_id(i) ? random_shift(m_random, m_kind.dimension) : Shift{0, 0, 0};
      points.push_back(m_dt.has_id(i)
                           ? image(near(m_dt.point(i), step, m_random), shifts[i], m_dt.cell())
                           : Point(0, 0, 0));
    }
    m_dt.update(points);
    translate(shifts);
  }

  void move_one()
  {
    const std::size_t id = random_id();
    const Shift shift = random_shift(m_random, m_kind.dimension);
    m_dt.move(id, image(near(m_dt.point(id), 0.05, m_random), shift, m_dt.cell()));
    translate({{id, shift}});
  }

  // The first vector becomes the sum of the first two; the third loses the first one. That of a
  // wire becomes the opposite one.
  void exchange_cell()
  {
    const auto a = m_dt.cell().a(), b = m_dt.cell().b(), c = m_dt.cell().c();
    if (std::abs(a[0]) + std::abs(b[0]) + std::abs(c[0]) > 20)
      return;
    Points points;
    for (std::size_t i = 0; i < m_dt.number_of_ids(); ++i)
      points.push_back(m_dt.has_id(i) ? m_dt.point(i) : Point(0, 0, 0));
    const bool is_wire = m_kind.dimension == 1;
    m_dt.update(points, is_wire ? Cell(Coordinates{-a[0], -a[1], -a[2]})
                                : m_kind.cell({a[0] + b[0], a[1] + b[1], a[2] + b[2]}, b,
                                              {c[0] - a[0], c[1] - a[1], c[2] - a[2]}));
    // a = first - b, and c = third + a
    rename([&](const Edge& e) {
      const int of_a = e.shift[0] + e.shift[2];
      return is_wire ? Shift{-e.shift[0], 0, 0} : Shift{of_a, e.shift[1] - of_a, e.shift[2]};
    });
  }

  void translate(const std::map<std::size_t, Shift>& shifts)
  {
    const auto of = [&](std::size_t id) {
      const auto at = shifts.find(id);
      return at == shifts.end() ? Shift{0, 0, 0} : at->second;
    };
    rename([&](const Edge& e) { return e.shift + of(e.i) - of(e.j); });
  }

  template <class New_shift>
  void rename(const New_shift& new_shift)
  {
    std::set<Edge> renamed;
    for (const Edge& e : m_start)
      renamed.insert(in_order({e.i, e.j, new_shift(e)}));
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

  const Kind& m_kind;
  std::mt19937_64 m_random;
  Watched m_dt;
  std::set<Edge> m_start;
};

using Visitors_in_periodic_space = Of_kind;
INSTANTIATE_TEST_SUITE_P(kinds, Visitors_in_periodic_space, all_kinds(), name_of);

TEST_P(Visitors_in_periodic_space, lead_from_former_edges_to_present_ones)
{
  const double thicknesses[] = {0, 0.5, 2};
  for (unsigned seed = 0; seed < 40; ++seed) {
    SCOPED_TRACE(seed);
    const Points points =
        short_points_in(oblique, seed < 20 ? 1 + seed : 4 * seed, thicknesses[seed % 3], seed);
    Followed followed(kind, oblique, points, seed);
    for (int step = 0; step < 12; ++step) {
      followed.do_something();
      ASSERT_NO_FATAL_FAILURE(followed.expect_changes());
      if (testing::Test::HasFailure())
        return;
    }
  }
}

// Follows the facets that come and go.
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

TEST_P(Visitors_in_periodic_space, are_told_of_facets)
{
  std::mt19937_64 random(3);
  With_visitor<Facets_visitor> dt(oblique);
  Points points = short_points_in(oblique, 50, 0.3);
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

TEST_P(Visitors_in_periodic_space, that_throw_before_an_update_stop_it)
{
  With_visitor<Failing_visitor> dt(unit);
  dt.insert(Point(0.5, 0.5, 0.5));
  dt.visitor().fails = true;
  EXPECT_THROW(dt.insert(Point(0.25, 0.5, 0.5)), std::runtime_error);
  EXPECT_EQ(dt.number_of_points(), 1u);
  dt.visitor().fails = false;
  dt.insert(Point(0.25, 0.5, 0.5));
  EXPECT_TRUE(dt.is_valid(true));
}

// POLICIES ----------------------------------------------------------------------------------------

using Policies_in_periodic_space = Of_kind;
INSTANTIATE_TEST_SUITE_P(kinds, Policies_in_periodic_space, all_kinds(), name_of);

TEST_P(Policies_in_periodic_space, choose_rebuilds)
{
  std::mt19937_64 random(4);
  Points points = short_points_in(oblique, 60);
  With_policy<CGAL::Always_static_policy_2> rebuilt(points, oblique);
  Dynamic mended(points, oblique);
  for (int frame = 0; frame < 5; ++frame) {
    for (Point& p : points)
      p = near(p, 0.01, random);
    const Cell cell = kind.box(1.0 + 0.01 * frame, 1, 1);
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

TEST_P(Policies_in_periodic_space, that_throw_change_nothing)
{
  std::mt19937_64 random(5);
  const Points points = short_points_in(oblique, 30);
  With_policy<Throwing_policy> dt(points, oblique);
  const auto before = cells_of(dt);
  Points moved = points;
  for (Point& p : moved)
    p = near(p, 0.05, random);
  EXPECT_THROW(dt.update(moved, kind.box(2, 1, 1)), std::runtime_error);
  EXPECT_EQ(dt.cell(), oblique);
  EXPECT_EQ(cells_of(dt), before);
  EXPECT_TRUE(dt.is_certified());
  EXPECT_TRUE(dt.is_valid(true));
  for (std::size_t i = 0; i < points.size(); ++i)
    EXPECT_EQ(dt.point(i), points[i]);
}

// Wants a rebuild if it sees eight infinite cells: a wire with four corners; a slab has 2 a side.
struct Counting_policy : CGAL::Always_dynamic_policy_2
{
  template <class Frame>
  bool wants_rebuild(const Frame& frame)
  {
    std::size_t infinite = 0;
    for (typename Frame::Cell_index c(0); c < frame.number_of_cells(); ++c) {
      infinite += frame.is_infinite(c);
      for (const auto v : frame.cell(c))
        EXPECT_EQ(std::isnan(frame.position(v).x), frame.is_infinite(v));
    }
    seen = infinite;
    return infinite == 8;
  }
  static inline std::size_t seen = 0;
};

TEST_P(Policies_in_periodic_space, see_infinite_cells)
{
  Points points = short_points_in(unit, 40);
  if (dimension == 1)
    for (const double y : {-1, 2})
      for (const double z : {-1, 2})
        points.emplace_back(0, y, z);
  EXPECT_EQ(With_policy<Counting_policy>(points, unit).update(points).rebuilt(), dimension == 1);
  EXPECT_EQ(Counting_policy::seen, dimension == 3 ? 0u : dimension == 2 ? 4u : 8u);
}

// POPULATIONS -------------------------------------------------------------------------------------

using Population = CGAL::Dynamic_population_3<Dynamic>;
using Crowd = std::map<std::int64_t, Point>;

void expect_population(const Population& population, const Crowd& crowd, const Cell& cell)
{
  ASSERT_EQ(population.size(), crowd.size());
  std::map<std::size_t, Point> points;
  for (const auto& [user_id, p] : crowd) {
    EXPECT_EQ(population.point(user_id), p);
    points[population.id(user_id)] = p;
  }
  periodic_space_oracle::expect_exact(population.triangulation(), points, cell);
}

using Populations_in_periodic_space = Of_kind;
INSTANTIATE_TEST_SUITE_P(kinds, Populations_in_periodic_space, all_kinds(), name_of);

TEST_P(Populations_in_periodic_space, come_and_go_in_cells_that_change)
{
  for (unsigned seed = 0; seed < 6; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    Population population(Dynamic{unit});
    Crowd crowd;
    Cell cell = unit;
    std::int64_t next = 7;
    for (int frame = 0; frame < 12; ++frame) {
      for (auto& [id, p] : crowd)
        p = near(p, 0.01, random);
      for (std::size_t n = 0; n < 4; ++n)
        if (!crowd.empty() && random() % 2 == 0)
          crowd.erase(std::next(crowd.begin(), std::ptrdiff_t(random() % crowd.size())));
      for (std::size_t n = 0; n < (frame == 0 ? 15 * seed : 4); ++n)
        crowd[next += 3] = near(Point(0.5, 0.5, 0.5), 1.5, random);
      if (frame % 3 == 2 && crowd.size() > 1) // at the same place, another image
        crowd.begin()->second = image(crowd.rbegin()->second, {-1, 1, 0}, cell);
      if (seed == 3 || frame % 4 == 3) {
        cell = kind.box(1.0 + 0.125 * frame, 1, 1);
        population.update(std::vector<std::pair<int, Point>>(crowd.begin(), crowd.end()), cell);
      } else {
        population.update(crowd);
      }
      ASSERT_NO_FATAL_FAILURE(expect_population(population, crowd, cell));
    }
  }
}

TEST_P(Populations_in_periodic_space, change_by_single_points_too)
{
  Population population(Dynamic{unit});
  population.insert(5, Point(0.1, 0.2, 0.3));
  population.insert(2, Point(0.6, 0.2, 0.3));
  population.move(5, Point(2.1, 0.2, 0.4));
  EXPECT_THROW(population.move(5, Point(1e9, 0, 0)), CGAL::Periodic_range_error_3);
  EXPECT_THROW(population.insert(5, Point(0, 0, 0)), CGAL::Repeated_id_error_2);
  expect_population(population, {{5, Point(2.1, 0.2, 0.4)}, {2, Point(0.6, 0.2, 0.3)}}, unit);
  population.remove(2);
  expect_population(population, {{5, Point(2.1, 0.2, 0.4)}}, unit);
  const Crowd crowd{{5, Point(0, 0, 0)}, {6, Point(4e6, 0, 0)}};
  EXPECT_THROW(population.update(crowd, kind.box(2, 1, 1)), CGAL::Periodic_range_error_3);
  EXPECT_EQ(population.triangulation().cell(), unit);
  population.update(crowd, kind.box(8, 1, 1));
  expect_population(population, crowd, kind.box(8, 1, 1));
}

// CHECKPOINTS -------------------------------------------------------------------------------------

using Checkpoints_in_periodic_space = Of_kind;
INSTANTIATE_TEST_SUITE_P(kinds, Checkpoints_in_periodic_space, all_kinds(), name_of);

TEST_P(Checkpoints_in_periodic_space, go_on_as_if_nothing_had_been)
{
  for (const double thickness : {0.0, 1.0})
    for (const std::size_t number : {0u, 1u, 2u, 9u, 80u}) {
      SCOPED_TRACE(number);
      std::mt19937_64 random(number);
      Points points = short_points_in(oblique, number, thickness, unsigned(number));
      const auto move_all = [&](double step) {
        for (Point& p : points)
          p = near(p, step, random);
        if (number > 8)
          points[4] = image(points[7], {1, -1, 1}, oblique);
      };
      move_all(0);
      Dynamic dt(points, oblique);
      if (number > 2)
        dt.remove(2);
      for (int frame = 0; frame < 3; ++frame) {
        move_all(0.02 * thickness);
        dt.update(points);
      }
      const std::string file = written(dt);
      Dynamic other(Cell(5, 6, 7));
      std::istringstream in(file);
      in >> other;
      ASSERT_TRUE(in);
      EXPECT_TRUE(other.is_certified());
      EXPECT_TRUE(other.is_valid(true));
      EXPECT_EQ(other.cell(), dt.cell());
      EXPECT_EQ(written(other), file);
      for (int frame = 0; frame < 5; ++frame) {
        for (Point& p : points)
          p = near(p, 0.05, random);
        const Cell cell = kind.box(1, 1.0 + 0.03125 * frame, 1);
        const auto first = dt.update(points, cell), second = other.update(points, cell);
        EXPECT_EQ(first.flips, second.flips);
        EXPECT_EQ(first.held, second.held);
        EXPECT_EQ(first.unproved, second.unproved);
        EXPECT_EQ(written(dt), written(other));
      }
    }
}

// How far points have been decides what filters may prove: a checkpoint has it, and the next frame
// measures anew.
TEST_P(Checkpoints_in_periodic_space, go_on_alike_after_a_point_has_been_far_away)
{
  Points points = short_points_in(oblique, 30);
  Dynamic dt(points, oblique), never_away(points, oblique);
  dt.move(3, image(points[3], {500, 0, 0}, oblique));
  dt.move(3, points[3]);
  EXPECT_NE(written(dt), written(never_away));
  Dynamic other(unit);
  std::istringstream in(written(dt));
  other.read_checkpoint(in);
  std::mt19937_64 random(1);
  for (Point& p : points)
    p = near(p, 0.01, random);
  for (Dynamic* const each : {&dt, &other, &never_away})
    each->update(points);
  EXPECT_EQ(written(dt), written(other));
  EXPECT_EQ(written(dt), written(never_away));
}

TEST_P(Checkpoints_in_periodic_space, keep_populations)
{
  Population population{Dynamic(oblique)};
  Crowd crowd;
  for (const Point& p : short_points_in(oblique, 20))
    crowd[100 - 3 * std::int64_t(crowd.size())] = p;
  population.update(crowd);
  Population other{Dynamic(unit)};
  std::istringstream in(written(population));
  other.read_checkpoint(in);
  expect_population(other, crowd, oblique);
  crowd.erase(100);
  crowd[-5] = Point(0.25, 1.5, 0.75);
  other.update(crowd);
  expect_population(other, crowd, oblique);
}

TEST_P(Checkpoints_in_periodic_space, tell_visitors_what_has_changed)
{
  Watched dt(short_points_in(oblique, 12), oblique);
  const Watched other(short_points_in(unit, 12, 1, 9), kind.box(1, 2, 1));
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
TEST_P(Checkpoints_in_periodic_space, are_refused_or_right)
{
  Dynamic dt(short_points_in(oblique, 5), oblique);
  dt.insert(image(dt.point(0), {1, 1, 1}, oblique));
  const std::string file = written(dt);
  Dynamic other(kind.box(2, 2, 2));
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
      Dynamic subject = other;
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

// What is wrong in a file of six points, and what stands there.
std::vector<std::array<std::string, 2>> forgeries(const Kind& kind)
{
  const std::string cube = "cell 1 0 0 0 1 0 0 0 1", square = "slab 1 0 0 0 1 0",
                    line = "wire 1 0 0";
  if (&kind == &torus)
    return {{"cell 1 0 0 0 1 0 0 0 0", cube},
            {"cell 1 0 0 0 1 0", cube},
            {"cull 1 0 0", cube},
            {square, cube},
            {" 0 0 2", " 0 0 1"},
            {" 1 0 -1", " 0 0 -1"}};
  if (&kind == &slab)
    return {{"slab 1 0 0 2 0 0", square},
            {"slab 1 0 0 0 1 0 0 0 1", square},
            {"slub 1 0 0 0 1 0", square},
            {cube, square},
            {"basis 1 0 0 2", "basis 1 0 0 1"},
            {"basis 1 0 0 1 0", "basis 1 0 0 1"},
            {" 0 0 2", " 0 0 1"},
            {" 0 0 1", " 0 0 -1"},
            {" 1 0 -1", " 0 0 -1"}};
  return {{"wire 0 0 0", line},       {"wire 1 0 0 0 1 0", line},
          {"wyre 1 0 0", line},       {square, line},
          {"basis 2\n", "basis 1\n"}, {"basis 1 0\n", "basis 1\n"},
          {"e3\ncells ", "\ncells "}, {"origin none ", "origin "},
          {"source ", "origin "},     {" 0 0 2", " 0 0 1"},
          {" 0 0 -1", " 0 0 1"},      {" 1 0 1", " 0 0 1"},
          {"1 1 0\n", "1 0 0\n"}};
}

TEST_P(Checkpoints_in_periodic_space, are_refused_if_they_are_not_right)
{
  const std::string text = written(Dynamic(short_points_in(unit, 6), unit));
  Dynamic read(unit);
  for (const auto& [to, from] : forgeries(kind)) {
    std::string changed = text;
    const std::size_t at = changed.find(from);
    ASSERT_NE(at, std::string::npos) << from;
    changed.replace(at, from.size(), to);
    std::istringstream in(changed);
    try {
      read.read_checkpoint(in);
      FAIL() << to;
    } catch (const CGAL::Checkpoint_error_2& error) {
      EXPECT_EQ(std::string(error.what()).find("checksum"), std::string::npos) << error.what();
    }
    EXPECT_EQ(read.number_of_points(), 0u);
  }
}

} // namespace test_periodic_space_changes_3

// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Visitors in space are told of every edge and facet that comes or goes, and of nothing else.

#include "replaced_heap.h"
#include "sealed_checkpoint.h"
#include "space_operations.h"
#include "space_points.h"

#include <CGAL/Dynamic_Delaunay_triangulation_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/convert_to_delaunay_triangulation_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/Dynamic_population_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/visitors/Edge_changes_visitor_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <new>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace test_space_visitors {

using Edge = std::array<std::size_t, 2>;
using Facet = std::array<std::size_t, 3>;

// All edges and facets, as far as the visitor was told of them.
struct Ledger : CGAL::Delaunay_update_visitor_base_3
{
  template <class Dynamic>
  void before_update(const Dynamic&)
  {
    ++begun;
  }
  template <class Dynamic>
  void after_facet_removal(const Dynamic&, const Facet& facet)
  {
    EXPECT_EQ(facets.erase(facet), 1u);
    ++told;
  }
  template <class Dynamic>
  void after_edge_removal(const Dynamic&, std::size_t i, std::size_t j)
  {
    EXPECT_EQ(edges.erase({i, j}), 1u);
    ++told;
  }
  template <class Dynamic>
  void after_edge_creation(const Dynamic&, std::size_t i, std::size_t j)
  {
    EXPECT_LT(i, j);
    EXPECT_TRUE(edges.insert({i, j}).second);
    ++told;
  }
  template <class Dynamic>
  void after_facet_creation(const Dynamic&, const Facet& facet)
  {
    EXPECT_TRUE(facets.insert(facet).second);
    ++told;
  }
  template <class Dynamic>
  void after_update(const Dynamic& dt, const CGAL::Update_report_3& report)
  {
    EXPECT_TRUE(report.certified);
    EXPECT_TRUE(dt.is_certified());
    ++ended;
  }

  std::set<Edge> edges;
  std::set<Facet> facets;
  std::size_t begun = 0, ended = 0, told = 0;
};

template <class Visitor>
using Watched_by =
    CGAL::Dynamic_Delaunay_triangulation_3<CGAL::Epick, CGAL::With_visitor_2<Visitor>>;
using Watched = Watched_by<Ledger>;
using Point = Watched::Point;
using Points = std::vector<Point>;
using space_points::random_points;

template <class Dynamic>
std::set<Edge> edges_of(const Dynamic& dt)
{
  std::set<Edge> edges;
  dt.for_each_edge([&](std::size_t i, std::size_t j) {
    edges.insert({(std::min)(i, j), (std::max)(i, j)});
  });
  return edges;
}

template <class Dynamic>
std::set<Facet> facets_of(const Dynamic& dt)
{
  std::set<Facet> facets;
  dt.for_each_facet([&](Facet facet) {
    std::sort(facet.begin(), facet.end());
    facets.insert(facet);
  });
  return facets;
}

template <class Dynamic>
void expect_told(const Dynamic& dt)
{
  ASSERT_EQ(dt.visitor().edges, edges_of(dt));
  ASSERT_EQ(dt.visitor().facets, facets_of(dt));
  ASSERT_EQ(dt.visitor().begun, dt.visitor().ended);
}

class Watched_program : public testing::TestWithParam<std::tuple<int, double>>
{
};

TEST_P(Watched_program, tells_what_has_changed)
{
  const auto [seed, grid] = GetParam();
  space_operations::Program<Watched> program(std::uint64_t(seed), 1, grid);
  program.insert(std::size_t(17 * seed % 150));
  ASSERT_NO_FATAL_FAILURE(expect_told(program.triangulation()));
  for (int i = 0; i < 60; ++i) {
    ASSERT_NO_FATAL_FAILURE(program.do_something());
    ASSERT_NO_FATAL_FAILURE(expect_told(program.triangulation())) << "operation " << i;
    if (i % 9 == 8) {
      program.interrupt();
      ASSERT_NO_FATAL_FAILURE(expect_told(program.triangulation())) << "operation " << i;
    }
  }
}
INSTANTIATE_TEST_SUITE_P(anywhere, Watched_program,
                         testing::Combine(testing::Range(0, 20), testing::Values(0.0)));
INSTANTIATE_TEST_SUITE_P(on_a_grid, Watched_program,
                         testing::Combine(testing::Range(20, 40), testing::Values(0.25)));

TEST(Visitors_in_space, are_told_of_few_changes_where_few_happen)
{
  Points points = random_points(2000);
  Watched dt(points);
  dt.visitor().told = 0;
  dt.update(points);
  EXPECT_EQ(dt.visitor().told, 0u);
  for (Point& p : points)
    p = Point(p.x() + 0.005 * p.y(), p.y(), p.z());
  const CGAL::Update_report_3 report = dt.update(points);
  EXPECT_FALSE(report.rebuilt());
  EXPECT_GT(report.flips, 10u);
  EXPECT_GT(dt.visitor().told, 10u);
  EXPECT_LT(dt.visitor().told, 10 * report.flips);
  ASSERT_NO_FATAL_FAILURE(expect_told(dt));
}

// The cells stay, and the names of their vertices change.
TEST(Visitors_in_space, are_told_of_new_representatives)
{
  Points points = random_points(600);
  points[500] = points[501] = points[100];
  points[502] = points[200];
  Watched dt(points);
  EXPECT_FALSE(dt.remove(100).rebuilt());
  ASSERT_NO_FATAL_FAILURE(expect_told(dt));
  EXPECT_FALSE(dt.move(200, Point(0.5, 0.5, 0.5)).rebuilt());
  ASSERT_NO_FATAL_FAILURE(expect_told(dt));
}

TEST(Visitors_in_space, follow_their_triangulations)
{
  Watched dt(random_points(50));
  Watched copy(dt);
  copy.remove({3, 5});
  ASSERT_NO_FATAL_FAILURE(expect_told(copy));
  ASSERT_NO_FATAL_FAILURE(expect_told(dt));
  Watched moved(std::move(copy));
  moved.insert(Point(3, 3, 3));
  ASSERT_NO_FATAL_FAILURE(expect_told(moved));
  std::stringstream file;
  file << dt;
  file >> moved; // the visitor stays, and is told of the difference
  ASSERT_NO_FATAL_FAILURE(expect_told(moved));
  EXPECT_EQ(moved.visitor().edges, dt.visitor().edges);
  CGAL::Delaunay_triangulation_3<CGAL::Epick> of_cgal;
  CGAL::convert_to_delaunay_triangulation_3(moved, of_cgal);
  EXPECT_EQ(of_cgal.number_of_finite_edges(), moved.visitor().edges.size());
}

TEST(Visitors_in_space, are_told_after_the_next_call_where_memory_runs_out)
{
  Points points = random_points(60);
  points[7] = points[8];
  Points next;
  for (const Point& p : points)
    next.emplace_back(p.x() + 0.1 * p.y(), p.y(), p.z());
  const Watched original(points);
  for (int kind = 0; kind < 3; ++kind) {
    bool is_done = false;
    for (long allocations = 0; !is_done; ++allocations) {
      SCOPED_TRACE(testing::Message() << kind << ", " << allocations << " allocations");
      Watched dt(original);
      try {
        const replaced_heap::Scarcity scarcity(allocations);
        if (kind == 0)
          dt.update(next);
        else if (kind == 1)
          dt.remove(8);
        else
          dt.insert(next.begin(), next.begin() + 3);
        is_done = true;
      } catch (const std::bad_alloc&) {
        dt.visitor().begun = dt.visitor().ended;
        if (allocations % 2 == 0) { // the file has what was there before
          std::stringstream file;
          file << original;
          ASSERT_TRUE(file >> dt);
          ASSERT_NO_FATAL_FAILURE(expect_told(dt));
        }
      }
      if (!is_done) {
        dt.insert(Point(0.4, 0.4, 0.4));
        ASSERT_NO_FATAL_FAILURE(expect_told(dt));
      }
    }
  }
}

TEST(Visitors_in_space, of_populations_are_told_of_frames)
{
  CGAL::Dynamic_population_3<Watched> population;
  std::map<std::int64_t, Point> crowd;
  std::int64_t next = 0;
  for (const Point& p : random_points(300))
    crowd[next++] = p;
  for (unsigned frame = 0; frame < 15; ++frame) {
    population.update(crowd);
    ASSERT_NO_FATAL_FAILURE(expect_told(population.triangulation()));
    EXPECT_EQ(population.visitor().ended, frame + 1);
    for (auto& [id, p] : crowd)
      p = Point(p.x() + 0.003 * p.y(), p.y(), p.z());
    crowd[next - 2] = crowd[next - 1];
    for (const Point& p : random_points(4, frame)) {
      crowd.erase(crowd.begin());
      crowd[next++] = p;
    }
  }
}

struct Faulty : Ledger
{
  template <class Dynamic>
  void after_update(const Dynamic& dt, const CGAL::Update_report_3& report)
  {
    Ledger::after_update(dt, report);
    if (throws)
      throw std::runtime_error("visitor");
  }
  bool throws = false;
};

TEST(Visitors_in_space, may_throw_after_an_update)
{
  Watched_by<Faulty> dt(random_points(30));
  dt.visitor().throws = true;
  EXPECT_THROW(dt.remove(7), std::runtime_error);
  EXPECT_FALSE(dt.has_id(7));
  EXPECT_TRUE(dt.is_valid(true));
  ASSERT_NO_FATAL_FAILURE(expect_told(dt));
  dt.visitor().throws = false;
  dt.insert(Point(0.1, 0.1, 0.1));
  ASSERT_NO_FATAL_FAILURE(expect_told(dt));
}

TEST(Visitors_in_space, that_do_not_listen_are_told_of_calls_alone)
{
  struct Deaf : Ledger
  {
    static bool is_listening() { return false; }
  };
  using Dynamic = CGAL::Dynamic_Delaunay_triangulation_3<CGAL::Epick, CGAL::With_visitor_2<Deaf>>;
  Points points = random_points(100);
  Dynamic dt(points);
  for (Point& p : points)
    p = Point(p.x() + 0.2 * p.y(), p.y() - 0.2 * p.z(), p.z());
  EXPECT_GT(dt.update(points).flips, 0u);
  std::stringstream checkpoint;
  dt.write_checkpoint(checkpoint);
  dt.read_checkpoint(checkpoint);
  EXPECT_EQ(dt.visitor().begun, 3u);
  EXPECT_EQ(dt.visitor().ended, 3u);
  EXPECT_EQ(dt.visitor().told, 0u);
}

TEST(Edge_changes_in_space, are_the_difference_since_they_were_cleared)
{
  using Listed = Watched_by<CGAL::Edge_changes_visitor_3>;
  Points points = random_points(300);
  Listed dt(points);
  EXPECT_EQ(dt.visitor().created_edges().size(), edges_of(dt).size());
  std::set<Edge> edges;
  std::set<Facet> facets;
  const auto apply = [](const auto& removed, const auto& created, auto& simplices) {
    for (const auto& simplex : removed)
      EXPECT_EQ(simplices.erase(simplex), 1u);
    for (const auto& simplex : created)
      EXPECT_TRUE(simplices.insert(simplex).second);
  };
  std::size_t removed = 0;
  for (int frame = 0; frame < 12; ++frame) {
    const auto& changes = dt.visitor();
    apply(changes.removed_edges(), changes.created_edges(), edges);
    apply(changes.removed_facets(), changes.created_facets(), facets);
    removed += changes.removed_edges().size();
    ASSERT_EQ(edges, edges_of(dt));
    ASSERT_EQ(facets, facets_of(dt));
    dt.visitor().clear();
    for (int part = 0; part < 3; ++part) {
      for (Point& p : points)
        p = Point(p.x() + 0.01 * p.y(), p.y() - 0.01 * p.z(), p.z());
      dt.update(points);
    }
  }
  EXPECT_GT(removed, 50u);
}

} // namespace test_space_visitors

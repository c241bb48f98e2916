// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Parts of space, in which threads flip, hold and release, have nothing to do with each other: in
// whatever order they are taken, checkpoints are the same. Visitors are told what parts change, and
// memory that runs out in a part loses no point.

#define CGAL_DYNAMIC_DELAUNAY_POINTS_OF_PART 64

#include "replaced_heap.h"
#include "sealed_checkpoint.h"
#include "space_oracle.h"
#include "space_points.h"

#include <CGAL/Dynamic_Delaunay_triangulation_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/Edge_changes_visitor_3.h>
#include <CGAL/Dynamic_periodic_Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <new>
#include <set>
#include <string>
#include <vector>

namespace {

// Parts are done one after the other, from the last one on.
struct Backward_tag
{
};

} // namespace

template <>
class CGAL::Dynamic_Delaunay_triangulations_2::internal::Part_runner<Backward_tag>
{
public:
  static constexpr bool is_parallel = true;
  static std::size_t most_workers() { return 2; }
  template <class Function>
  static void run(std::size_t parts, std::size_t, const Function& f)
  {
    for (std::size_t part = parts; part-- > 0;)
      f(part);
  }
};

namespace {

using Backward_option = CGAL::With_concurrency_2<Backward_tag>;
using Dynamic = CGAL::Dynamic_Delaunay_triangulation_3<CGAL::Epick>;
using Backward = CGAL::Dynamic_Delaunay_triangulation_3<CGAL::Epick, Backward_option>;
using Periodic = CGAL::Dynamic_periodic_Delaunay_triangulation_3<CGAL::Epick>;
using Periodic_backward =
    CGAL::Dynamic_periodic_Delaunay_triangulation_3<CGAL::Epick, Backward_option>;
using Point = Dynamic::Point;
using Points = std::vector<Point>;
using space_points::random_points;
using space_points::shaken;

template <class Forward, class Other>
void expect_same(Forward& forward, Other& backward, const Points& points)
{
  const CGAL::Update_report_3 report = forward.update(points), other = backward.update(points);
  EXPECT_EQ(report.flips, other.flips);
  EXPECT_EQ(report.held, other.held);
  EXPECT_EQ(report.relocated, other.relocated);
  EXPECT_EQ(report.rebuild_reason, other.rebuild_reason);
  EXPECT_EQ(checkpoint_of(forward), checkpoint_of(backward));
}

class Parts_of_space : public testing::TestWithParam<double> // steps, in spacings
{
protected:
  static constexpr std::size_t number = 3000;
  static double step() { return GetParam() / std::cbrt(double(number)); }
};

TEST_P(Parts_of_space, may_be_taken_in_any_order)
{
  Points points = random_points(number);
  Dynamic forward(points);
  Backward backward(points);
  for (unsigned frame = 0; frame < 6; ++frame) {
    points = shaken(points, step(), frame);
    ASSERT_NO_FATAL_FAILURE(expect_same(forward, backward, points));
  }
  EXPECT_TRUE(forward.is_valid());
}

TEST_P(Parts_of_space, may_be_taken_in_any_order_in_periodic_space)
{
  const CGAL::Periodic_cell_3 cells[] = {{1, 1, 1}, {{1, 0, 0}, {0.3, 1, 0}}};
  for (const CGAL::Periodic_cell_3& cell : cells) {
    Points points = random_points(number);
    Periodic forward(points, cell);
    Periodic_backward backward(points, cell);
    for (unsigned frame = 0; frame < 3; ++frame) {
      points = shaken(points, step(), frame);
      ASSERT_NO_FATAL_FAILURE(expect_same(forward, backward, points));
    }
    EXPECT_TRUE(forward.is_valid());
  }
}

// A lattice, of which some points go an eighth of the way to a neighbor, and return.
TEST_P(Parts_of_space, may_be_taken_in_any_order_with_ties)
{
  const Points lattice = space_points::lattice(14);
  Dynamic forward(lattice);
  Backward backward(lattice);
  for (std::size_t frame = 1; frame < 5; ++frame) {
    Points points = lattice;
    for (std::size_t i = frame; i < points.size(); i += std::size_t(1 / GetParam()))
      points[i] =
          Point(points[i].x() + 0.125, points[i].y() + 0.125 * double(i % 3), points[i].z());
    ASSERT_NO_FATAL_FAILURE(expect_same(forward, backward, points));
    ASSERT_NO_FATAL_FAILURE(expect_same(forward, backward, lattice));
  }
  EXPECT_TRUE(forward.is_valid());
}

// What is gone and what has come, and both together.
TEST_P(Parts_of_space, tell_visitors_what_has_changed)
{
  using Watched =
      CGAL::Dynamic_Delaunay_triangulation_3<CGAL::Epick,
                                             CGAL::With_visitor_2<CGAL::Edge_changes_visitor_3>>;
  using Edge = std::array<std::size_t, 2>;
  const auto edges_of = [](const Watched& dt) {
    std::vector<Edge> edges;
    dt.for_each_edge([&](std::size_t i, std::size_t j) {
      edges.push_back({(std::min)(i, j), (std::max)(i, j)});
    });
    std::sort(edges.begin(), edges.end());
    return edges;
  };
  const auto difference = [](const std::vector<Edge>& a, const std::vector<Edge>& b) {
    std::vector<Edge> edges;
    std::set_difference(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(edges));
    return edges;
  };
  Points points = random_points(number);
  Watched dt(points);
  for (unsigned frame = 0; frame < 4; ++frame) {
    const std::vector<Edge> before = edges_of(dt);
    dt.visitor().clear();
    points = shaken(points, step(), frame);
    dt.update(points);
    const std::vector<Edge> after = edges_of(dt);
    EXPECT_EQ(dt.visitor().removed_edges(), difference(before, after));
    EXPECT_EQ(dt.visitor().created_edges(), difference(after, before));
  }
}

INSTANTIATE_TEST_SUITE_P(steps, Parts_of_space, testing::Values(0.01, 0.05, 0.1));

// Memory runs out after each of so many allocations that there is one in each phase of a frame.
TEST(Memory_of_parts_of_space, may_run_out)
{
  const Points points = random_points(600), next = shaken(points, 0.01);
  const Dynamic original(points);
  bool has_failed = true;
  for (long allocations = 0; has_failed; allocations += 1 + allocations / 50) {
    SCOPED_TRACE(testing::Message() << allocations << " allocations");
    Dynamic dt(original);
    has_failed = false;
    try {
      const replaced_heap::Scarcity scarcity(allocations);
      dt.update(next);
    } catch (const std::bad_alloc&) {
      has_failed = true;
    }
    for (std::size_t id = 0; id < points.size(); ++id)
      ASSERT_TRUE(dt.point(id) == points[id] || dt.point(id) == next[id]) << "id " << id;
    dt.update(next);
    ASSERT_TRUE(dt.is_valid());
  }
}

// The cells of each part, and what a part may not have.
TEST(Division_of_space, gives_each_vertex_one_part)
{
  using CGAL::Dynamic_Delaunay_triangulations_3::Position_3;
  using CGAL::Dynamic_Delaunay_triangulations_3::Vertex_index;
  namespace internal = CGAL::Dynamic_Delaunay_triangulations_3::internal;
  internal::Positions_3<Point> positions;
  const Points points = random_points(5000);
  positions.resize(5001);
  for (std::size_t i = 0; i < points.size(); ++i) // every seventh one in a plane
    positions.set(Vertex_index(i + 1),
                  internal::Place_3<Point>(
                      Position_3{i % 7 == 0 ? 0.25 : points[i].x(), points[i].y(), points[i].z()}));
  for (const std::size_t in_row : {2u, 3u}) {
    const internal::Spatial_parts_3<internal::Positions_3<Point>> parts(positions, in_row);
    ASSERT_EQ(parts.number(), in_row * in_row * in_row);
    std::vector<std::size_t> sizes(parts.number(), 0);
    for (Vertex_index v(1); v < positions.number(); ++v) {
      ++sizes.at(parts.part_of(v));
      for (std::size_t part = 0; part < parts.number(); ++part)
        ASSERT_EQ(parts.has(part, v), part == parts.part_of(v));
    }
    for (std::size_t part = 0; part < parts.number(); ++part) {
      EXPECT_FALSE(parts.has(part, Vertex_index(0))); // the infinite one
      EXPECT_LT(sizes[part], 2 * points.size() / parts.number());
    }
  }
}

} // namespace

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
#include <CGAL/Dynamic_Delaunay_triangulation_3/visitors/Edge_changes_visitor_3.h>
#include <CGAL/Dynamic_periodic_Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/hilbert_sort.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <new>
#include <random>
#include <set>
#include <string>
#include <utility>
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
using Backward_parts =
    CGAL::Dynamic_Delaunay_triangulations_2::internal::Parallel_parts<Backward_tag>;
using Dynamic = CGAL::Dynamic_Delaunay_triangulation_3<CGAL::Epick>;
using Backward = CGAL::Dynamic_Delaunay_triangulation_3<CGAL::Epick, Backward_option>;
using Periodic = CGAL::Dynamic_periodic_Delaunay_triangulation_3<CGAL::Epick>;
using Periodic_backward =
    CGAL::Dynamic_periodic_Delaunay_triangulation_3<CGAL::Epick, Backward_option>;
using Point = Dynamic::Point;
using Points = std::vector<Point>;
using space_points::random_points;
using space_points::shaken;

// Where walks around vertices begin.
template <class Triangulation>
std::vector<std::size_t> corners_of(const Triangulation& dt)
{
  const auto& arrays =
      CGAL::Dynamic_Delaunay_triangulations_2::internal::Triangulation_access::state(dt).arrays;
  std::vector<std::size_t> corners;
  for (CGAL::Dynamic_Delaunay_triangulations_3::Vertex_index v(0); v < arrays.number_of_vertices();
       ++v) {
    const auto k = arrays.corner_of(v);
    corners.push_back(k);
    if (v > 0 || k < 4 * arrays.number_of_cells()) { // a torus has no infinite vertex
      EXPECT_EQ(arrays.vertex(k), v);
    }
  }
  return corners;
}

template <class Forward, class Other>
void expect_same(Forward& forward, Other& backward, const Points& points)
{
  const CGAL::Update_report_3 report = forward.update(points), other = backward.update(points);
  EXPECT_EQ(report.flips, other.flips);
  EXPECT_EQ(report.held, other.held);
  EXPECT_EQ(report.relocated, other.relocated);
  EXPECT_EQ(report.rebuild_reason, other.rebuild_reason);
  EXPECT_EQ(checkpoint_of(forward), checkpoint_of(backward));
  EXPECT_EQ(corners_of(forward), corners_of(backward));
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
template <class Triangulation>
void expect_nothing_lost(const Triangulation& original, const Points& points, const Points& next)
{
  bool has_failed = true;
  for (long allocations = 0; has_failed; allocations += 1 + allocations / 50) {
    SCOPED_TRACE(testing::Message() << allocations << " allocations");
    Triangulation dt(original);
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

TEST(Memory_of_parts_of_space, may_run_out)
{
  const Points points = random_points(600);
  expect_nothing_lost(Dynamic(points), points, shaken(points, 0.01));
}

TEST(Memory_of_parts_of_space, may_run_out_in_a_rebuild)
{
  const Points points = random_points(600);
  expect_nothing_lost(Backward(points), points, random_points(600, 5));
}

// To be taken out, a vertex of the hull of a wire goes inside.
TEST(Memory_of_a_wire, may_run_out_where_a_point_leaves_its_hull)
{
  const CGAL::Periodic_cell_3 wire(CGAL::Epick::Vector_3(1, 0, 0));
  const Points points = random_points(200);
  const auto top = std::max_element(points.begin(), points.end(),
                                    [](const auto& p, const auto& q) { return p.z() < q.z(); });
  const auto id = std::size_t(top - points.begin());
  const Point to(0.5, 0.5, 0.5);
  const Periodic original(points, wire);
  std::size_t failures = 0;
  for (bool has_failed = true; has_failed; failures += std::size_t(has_failed)) {
    SCOPED_TRACE(testing::Message() << failures << " allocations");
    Periodic dt(original);
    has_failed = false;
    try {
      const replaced_heap::Scarcity scarcity(static_cast<long>(failures));
      EXPECT_FALSE(dt.move(id, to).rebuilt());
    } catch (const std::bad_alloc&) {
      has_failed = true;
    }
    for (std::size_t i = 0; i < points.size(); ++i)
      ASSERT_TRUE(dt.point(i) == points[i] || (i == id && dt.point(i) == to)) << "id " << i;
    dt.move(id, to);
    ASSERT_TRUE(dt.is_valid(true));
  }
  EXPECT_GT(failures, 20u);
}

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
  using Division = internal::Spatial_parts_3<internal::Positions_3<Point>, Backward_parts>;
  for (const Division::Numbers& numbers :
       {Division::Numbers{2, 2, 2}, {3, 3, 3}, {3, 3, 1}, {1, 1, 3}}) {
    const Division parts(positions, numbers);
    ASSERT_EQ(parts.number(), numbers[0] * numbers[1] * numbers[2]);
    std::vector<std::size_t> sizes(parts.number(), 0);
    for (Vertex_index v(1); v < positions.number(); ++v) {
      ++sizes.at(parts.part_of(v));
      for (std::size_t part = 0; part < parts.number(); ++part)
        ASSERT_EQ(parts.has(part, v), part == parts.part_of(v));
    }
    for (std::size_t part = 0; part < parts.number(); ++part) {
      EXPECT_TRUE(parts.has(part, Vertex_index(0))); // the infinite one
      EXPECT_LT(sizes[part], 2 * points.size() / parts.number());
    }
  }
}

// Cells in which random facets can be flipped, wherever their vertices are.
class Flipped_cells
{
public:
  using Arrays = CGAL::Dynamic_Delaunay_triangulations_3::internal::Tetrahedra_arrays_3;
  using Vertex_index = CGAL::Dynamic_Delaunay_triangulations_3::Vertex_index;
  using Cell_index = CGAL::Dynamic_Delaunay_triangulations_3::Cell_index;
  using Corner_index = CGAL::Dynamic_Delaunay_triangulations_3::Corner_index;
  using Cells = std::vector<std::array<Vertex_index, 4>>;

  // A cell and its infinite neighbors, into which vertices are inserted.
  explicit Flipped_cells(CGAL::Dynamic_Delaunay_triangulations_2::Index vertices)
  {
    m_arrays.reset(vertices);
    begin();
    std::vector<Arrays::Star_cell> star;
    for (Vertex_index v(5); v < vertices; ++v) {
      const Cell_index c(m_random() % m_arrays.number_of_cells());
      std::vector<Corner_index> border;
      for (int i = 0; i < 4; ++i)
        border.push_back(Arrays::corner(c, i));
      m_arrays.replace_by_star({c}, border, v, star);
    }
  }

  Arrays& arrays() { return m_arrays; }

  // Replaces two cells at a facet by three, as a step. Returns one of them.
  Cell_index flip(std::size_t part = Arrays::whole)
  {
    for (;;) {
      const Corner_index k(m_random() % (4 * m_arrays.number_of_cells()));
      if (m_arrays.is_free(Arrays::cell_of(k)) ||
          are_neighbors(m_arrays.vertex(k), m_arrays.apex(k)))
        continue;
      m_arrays.begin_step(part);
      m_touched = {m_arrays.vertex(k), m_arrays.apex(k)};
      for (const Vertex_index v : m_arrays.vertices(Arrays::cell_of(k)))
        m_touched.insert(v);
      return m_arrays.flip_2_3(k, part).cells[0];
    }
  }

  // Whether the last flip has changed cells of a vertex.
  bool has_touched(Vertex_index v) const { return m_touched.count(v) > 0; }

  // Of those that are not free, in the order of their numbers.
  Cells cells() const
  {
    Cells cells;
    for (Cell_index c(0); c < m_arrays.number_of_cells(); ++c)
      if (!m_arrays.is_free(c)) {
        const auto& v = m_arrays.vertices(c);
        cells.push_back({v[0], v[1], v[2], v[3]});
      }
    return cells;
  }

  void expect_fit() const
  {
    for (Corner_index k(0); k < 4 * m_arrays.number_of_cells(); ++k) {
      const Cell_index c = Arrays::cell_of(k);
      if (m_arrays.is_free(c))
        continue;
      const Corner_index mirror = m_arrays.mirror(k);
      ASSERT_EQ(m_arrays.mirror(mirror), k);
      for (int i = 0; i < 4; ++i)
        if (i != Arrays::place_of(k)) {
          ASSERT_LT(m_arrays.place_of(Arrays::cell_of(mirror), m_arrays.vertices(c)[i]), 4);
        }
    }
    for (Vertex_index v(0); v < m_arrays.number_of_vertices(); ++v)
      ASSERT_EQ(m_arrays.vertex(m_arrays.corner_of(v)), v);
  }

private:
  void begin()
  {
    using Vertices = CGAL::Dynamic_Delaunay_triangulations_3::internal::Vertices_3;
    const Vertices v{Vertex_index(1), Vertex_index(2), Vertex_index(3), Vertex_index(4)};
    std::array<Cell_index, 5> cells;
    for (Cell_index& c : cells)
      c = m_arrays.make_cell();
    m_arrays.set_vertices(cells[4], v);
    for (int i = 0; i < 4; ++i) {
      Vertices w = v;
      std::swap(w[(i + 1) % 4], w[(i + 2) % 4]);
      w[i] = Vertex_index(0);
      m_arrays.set_vertices(cells[std::size_t(i)], w);
      m_arrays.connect(Arrays::corner(cells[4], i), Arrays::corner(cells[std::size_t(i)], i));
    }
    const auto corner = [&](int i, int j) {
      const Cell_index c = cells[std::size_t(i)];
      return Arrays::corner(c, m_arrays.place_of(c, v[j]));
    };
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < i; ++j)
        m_arrays.connect(corner(i, j), corner(j, i));
  }

  bool are_neighbors(Vertex_index v, Vertex_index w) const
  {
    for (const auto& cell : cells())
      if (std::count(cell.begin(), cell.end(), v) + std::count(cell.begin(), cell.end(), w) == 2)
        return true;
    return false;
  }

  std::mt19937 m_random{1};
  Arrays m_arrays;
  std::set<Vertex_index> m_touched;
};

// Flips that share cells go together, and what remains can be undone.
TEST(Steps_of_space, are_undone_around_some_cells)
{
  Flipped_cells flipped(100);
  CGAL::Dynamic_Delaunay_triangulations_3::internal::Cell_marks_3 marks;
  const Flipped_cells::Cells before = flipped.cells();
  std::size_t undone = 0, kept = 0;
  for (int turn = 0; turn < 50; ++turn) {
    flipped.arrays().begin();
    std::vector<Flipped_cells::Cell_index> some;
    for (int i = 0; i < 6; ++i)
      some.assign(1, flipped.flip());
    const std::size_t all = flipped.cells().size();
    flipped.arrays().undo_around(some, marks);
    undone += all - flipped.cells().size();
    kept += flipped.cells().size() - before.size();
    EXPECT_GT(some.size(), 1u);
    ASSERT_NO_FATAL_FAILURE(flipped.expect_fit());
    flipped.flip();
    flipped.arrays().undo();
    ASSERT_EQ(flipped.cells(), before);
    ASSERT_NO_FATAL_FAILURE(flipped.expect_fit());
  }
  EXPECT_GT(undone, 60u); // of 300 flips
  EXPECT_GT(kept, 60u);
}

// Other vertices of cells that get other neighbors may belong to other parts.
TEST(Steps_of_space, of_a_part_leave_other_vertices_alone)
{
  Flipped_cells flipped(100);
  auto& arrays = flipped.arrays();
  const Flipped_cells::Cells before = flipped.cells();
  for (int turn = 0; turn < 50; ++turn) {
    std::vector<Flipped_cells::Corner_index> corners;
    for (Flipped_cells::Vertex_index v(0); v < arrays.number_of_vertices(); ++v)
      corners.push_back(arrays.corner_of(v));
    arrays.begin_parts<Backward_parts>(1, [](std::size_t) { return std::size_t(1); });
    arrays.begin(0);
    flipped.flip(0);
    arrays.undo(0);
    for (Flipped_cells::Vertex_index v(0); v < arrays.number_of_vertices(); ++v)
      if (!flipped.has_touched(v)) {
        ASSERT_EQ(arrays.corner_of(v), corners[v]);
      }
    arrays.end_parts();
    ASSERT_EQ(flipped.cells(), before);
    ASSERT_NO_FATAL_FAILURE(flipped.expect_fit());
  }
}

// Blocks that threads order follow each other as if there was one curve.
TEST(Order_along_curve, takes_each_position_once_on_a_short_way)
{
  namespace internal = CGAL::Dynamic_Delaunay_triangulations_3::internal;
  using Position = CGAL::Dynamic_Delaunay_triangulations_3::Position_3;
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> coordinate(0, 1);
  std::vector<Position> positions(2000);
  std::vector<Dynamic::Point> curve;
  for (Position& p : positions) {
    p = {coordinate(random), coordinate(random), coordinate(random)};
    curve.emplace_back(p.x, p.y, p.z);
  }
  const std::vector<CGAL::Dynamic_Delaunay_triangulations_3::Index> order =
      internal::Order_along_curve_3<Backward_parts>(positions).run();
  std::vector<Dynamic::Point> ordered;
  for (const auto i : order)
    ordered.push_back(curve[i]);
  EXPECT_EQ(std::set(order.begin(), order.end()).size(), positions.size());
  CGAL::hilbert_sort(curve.begin(), curve.end());
  const auto length = [](const std::vector<Dynamic::Point>& points) {
    double sum = 0;
    for (std::size_t i = 1; i < points.size(); ++i)
      sum += std::sqrt(CGAL::squared_distance(points[i - 1], points[i]));
    return sum;
  };
  EXPECT_LT(length(ordered), 1.08 * length(curve)); // 1.1 if rows of blocks began on one side
}

} // namespace

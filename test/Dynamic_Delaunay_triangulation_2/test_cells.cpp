// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// What holds for Voronoi cells of every kind, whatever ends them: they need a certificate, keep
// their memory, are gone if it runs out, and do not depend on threads.

#include "oracle.h"
#include "replaced_heap.h"

#include <CGAL/Dynamic_Delaunay_triangulation_2/queries/Bounded_voronoi_cells_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/queries/Bounded_voronoi_gradients_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/queries/Voronoi_cell_gradients_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/queries/Voronoi_cell_measures_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/queries/Voronoi_cells_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/queries/Voronoi_cells_in_domain_2.h>
#include <CGAL/Dynamic_periodic_Delaunay_triangulation_2.h>
#include <CGAL/Polygon_with_holes_2.h>

#include <algorithm>
#include <cstddef>
#include <new>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace test_cells {

using Points = Cloud<Epick>::Points;
using Point = Epick::Point_2;
using Numbers = std::vector<double>;

// KINDS -------------------------------------------------------------------------------------------

// All numbers and coordinates in the lists, one list after the other.
template <class... Lists>
Numbers numbers_in(const Lists&... lists)
{
  Numbers numbers;
  const auto add = [&](const auto& value) {
    if constexpr (std::is_arithmetic_v<std::decay_t<decltype(value)>>)
      numbers.push_back(double(value));
    else
      numbers.insert(numbers.end(), {value.x, value.y});
  };
  (std::for_each(lists.begin(), lists.end(), add), ...);
  return numbers;
}

template <class Cells>
Numbers numbers_of_pieces(const Cells& cells)
{
  Numbers numbers =
      numbers_in(cells.areas(), cells.perimeters(), cells.centroids(), cells.first_pieces());
  for (const auto& piece : cells.pieces())
    numbers.push_back(piece.length);
  return numbers;
}

template <class Cells, class Compute, class List>
struct Kind
{
  Cells cells;
  Compute computes;
  List lists;
  bool keeps_memory = true; // all that it needs for another calm frame

  template <class Dynamic>
  void compute(const Dynamic& dt)
  {
    computes(cells, dt);
  }
  Numbers numbers() const { return lists(cells); }
};

template <class Cells, class Compute, class List>
Kind<Cells, Compute, List> kind(Cells cells, Compute compute, List list)
{
  return {std::move(cells), compute, list};
}

// In memory that they keep.
const Numbers& equal_weights(std::size_t number)
{
  static Numbers weights;
  weights.assign(number, 1.5);
  return weights;
}

auto kinds_of_every_space()
{
  using Corners = std::vector<CGAL::Voronoi_cell_measures_2::Position>;
  const auto measures = kind(
      CGAL::Voronoi_cell_measures_2(), [](auto& cells, const auto& dt) { cells.compute(dt); },
      [](const auto& c) { return numbers_in(c.areas(), c.perimeters(), c.centroids()); });
  const auto gradients = kind(
      CGAL::Voronoi_cell_gradients_2(),
      [](auto& cells, const auto& dt) {
        const Numbers& weights = equal_weights(dt.number_of_ids());
        cells.compute(dt, weights, weights);
      },
      [](const auto& cells) { return numbers_in(cells.gradients()); });
  const auto edges = kind(
      0.0,
      [](double& sum, const auto& dt) {
        sum = 0;
        CGAL::for_each_voronoi_edge(dt, [&](std::size_t i, std::size_t j, const auto&... last) {
          sum += double(i + j) + (double(sizeof(last)) + ...);
        });
      },
      [](double sum) { return Numbers{sum}; });
  const auto corners_of_last = kind(
      Corners(100, {0, 0}),
      [](Corners& corners, const auto& dt) {
        for (std::size_t id = 0; id < dt.number_of_ids(); ++id)
          CGAL::voronoi_cell_corners(dt, id, corners.begin());
      },
      [](const Corners& corners) { return numbers_in(corners); });
  const auto bounded = kind(
      CGAL::Bounded_voronoi_cells_2(), [](auto& cells, const auto& dt) { cells.compute(dt, 0.6); },
      [](const auto& cells) { return numbers_of_pieces(cells); });
  const auto bounded_gradients = kind(
      std::pair<CGAL::Bounded_voronoi_cells_2, CGAL::Bounded_voronoi_gradients_2>(),
      [](auto& both, const auto& dt) {
        both.first.compute(dt, 0.8);
        both.second.compute(dt, both.first, both.first.areas(),
                            equal_weights(both.first.pieces().size()));
      },
      [](const auto& both) {
        return both.first.areas().empty()
                   ? Numbers()
                   : numbers_in(both.second.by_positions(), both.second.by_radii());
      });
  return std::tuple(measures, gradients, edges, corners_of_last, bounded, bounded_gradients);
}

// Also cells in a box, and in a hall with two pillars.
auto kinds_of_the_plane(double side)
{
  const auto box = [side](double x, double y, double size) {
    const Points corners{Point(x * side, y * side), Point((x + size) * side, y * side),
                         Point((x + size) * side, (y + size) * side),
                         Point(x * side, (y + size) * side)};
    return CGAL::Polygon_2<Epick>(corners.begin(), corners.end());
  };
  auto others = kinds_of_every_space();
  auto in_box = std::get<4>(others);
  in_box.cells.set_domain(CGAL::Bbox_2(side / 8, side / 4, side, 2 * side));
  CGAL::Polygon_with_holes_2<Epick> hall(box(0, 0, 1));
  hall.add_hole(box(0.25, 0.25, 0.125));
  hall.add_hole(box(0.625, 0.5, 0.25));
  auto in_hall = kind(
      CGAL::Voronoi_cells_in_domain_2(hall), [](auto& cells, const auto& dt) { cells.compute(dt); },
      [](const auto& cells) {
        Numbers numbers = numbers_of_pieces(cells);
        const Numbers of_rings = numbers_in(cells.first_rings(), cells.ring_areas());
        numbers.insert(numbers.end(), of_rings.begin(), of_rings.end());
        return numbers;
      });
  in_hall.keeps_memory = false;
  return std::tuple_cat(others, std::tuple(in_box, in_hall));
}

// SPACES ------------------------------------------------------------------------------------------

// Each with its cell around points in so large a square.
struct Plane
{
  template <class... Options>
  using Dynamic = CGAL::Dynamic_Delaunay_triangulation_2<Epick, CGAL::Default, Options...>;
  static std::tuple<> cell(double) { return {}; }
};

struct Torus
{
  template <class... Options>
  using Dynamic = CGAL::Dynamic_periodic_Delaunay_triangulation_2<Epick, CGAL::Default, Options...>;
  static std::tuple<CGAL::Periodic_cell_2> cell(double side) { return {{side, side}}; }
};

struct Slab : Torus
{
  static std::tuple<CGAL::Periodic_cell_2> cell(double side)
  {
    return CGAL::Periodic_cell_2::slab(side, 1);
  }
};

template <class Space, class... Options>
auto triangulated(const Points& points, double side)
{
  return std::apply(
      [&](const auto&... cell) {
        return typename Space::template Dynamic<Options...>(points, cell...);
      },
      Space::cell(side));
}

template <class Space>
struct Cells_of_all_kinds : testing::Test
{
  // Calls f for cells of each kind that there are in the space, around points in so large a square.
  template <class Function>
  static void for_each_kind(double side, const Function& f)
  {
    std::size_t number = 0;
    const auto call = [&](auto& kind) {
      SCOPED_TRACE(testing::Message() << "kind " << number++);
      f(kind);
    };
    auto kinds = [side] {
      if constexpr (std::is_base_of_v<Torus, Space>)
        return kinds_of_every_space();
      else
        return kinds_of_the_plane(side);
    }();
    std::apply([&](auto&... kind) { (call(kind), ...); }, kinds);
  }
};
using Spaces = testing::Types<Plane, Torus, Slab>;
TYPED_TEST_SUITE(Cells_of_all_kinds, Spaces);

TYPED_TEST(Cells_of_all_kinds, need_a_certificate)
{
  const Points few = Cloud<Epick>(16).uniform(10), more = Cloud<Epick>(17).uniform(100);
  auto dt = triangulated<TypeParam>(few, 9);
  for (long allocations = 0; dt.is_certified() && allocations < 200; ++allocations) {
    dt = triangulated<TypeParam>(few, 9);
    try {
      const replaced_heap::Scarcity scarcity(allocations);
      dt.insert(more);
    } catch (const std::bad_alloc&) {
    }
  }
  ASSERT_FALSE(dt.is_certified());
  this->for_each_kind(9, [&](auto& cells) {
    EXPECT_THROW(cells.compute(dt), CGAL::Uncertified_triangulation_error_2);
  });
  dt.mend();
  this->for_each_kind(9, [&](auto& cells) { EXPECT_NO_THROW(cells.compute(dt)); });
}

TYPED_TEST(Cells_of_all_kinds, keep_their_memory_for_another_calm_frame)
{
  this->for_each_kind(20, [](auto& cells) {
    Cloud<Epick> cloud(17);
    auto points = cloud.uniform(400);
    auto dt = triangulated<TypeParam>(points, 20);
    for (int frame = 0; frame < 5; ++frame) {
      cloud.shake(points, 1e-7);
      points[7] = points[8];
      dt.update(points);
      const std::size_t before = replaced_heap::number_of_allocations;
      cells.compute(dt);
      const std::size_t allocations = replaced_heap::number_of_allocations - before;
      if (frame > 1 && cells.keeps_memory) {
        EXPECT_EQ(allocations, 0u) << "frame " << frame;
      }
    }
  });
}

TYPED_TEST(Cells_of_all_kinds, are_gone_if_memory_runs_out_and_can_be_had_again)
{
  const auto few = triangulated<TypeParam>(Cloud<Epick>(18).uniform(4), 5),
             more = triangulated<TypeParam>(Cloud<Epick>(19).uniform(25), 5);
  this->for_each_kind(5, [&](const auto& kind) {
    auto whole = kind;
    whole.compute(more);
    bool has_run_out = true;
    for (long allocations = 0; has_run_out; ++allocations) {
      auto cells = kind;
      cells.compute(few);
      has_run_out = false;
      try {
        const replaced_heap::Scarcity scarcity(allocations);
        cells.compute(more);
      } catch (const std::bad_alloc&) {
        has_run_out = true;
        EXPECT_TRUE(cells.numbers().empty()) << allocations;
        cells.compute(more);
      }
      EXPECT_EQ(cells.numbers(), whole.numbers());
    }
  });
}

// So many faces are shared, in the torus also so many cells.
TYPED_TEST(Cells_of_all_kinds, are_the_same_by_threads)
{
  constexpr double side = 270;
  Points points = Cloud<Epick>(10).uniform(std::size_t(side * side));
  points[17] = points[33000]; // they have one cell
  const auto one = triangulated<TypeParam>(points, side);
  using Shared = CGAL::With_concurrency_2<CGAL::Parallel_if_available_tag>;
  const auto many = triangulated<TypeParam, Shared>(points, side);
  this->for_each_kind(side, [&](auto& alone) {
    auto together = alone;
    alone.compute(one);
    together.compute(many);
    ASSERT_FALSE(alone.numbers().empty());
    EXPECT_TRUE(alone.numbers() == together.numbers());
  });
}

} // namespace test_cells

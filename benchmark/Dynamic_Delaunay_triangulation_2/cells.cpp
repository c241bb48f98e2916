// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What Voronoi cells cost, beside one update: whole, or ending at a radius, at a convex domain, or
// in a hall with walls, by each rule. The points are uniform in a square hall, one to a unit of
// area; there are 16 pillars in it in all, or in a `forest` one for each 16 points. Ids say nothing
// about places. The triangulation is there; peers triangulate too, as their users have to. The
// counter s/cell is the time divided by the points.
//
//   update             of points that take normal steps of a hundredth of the spacing
//   plain_cells        area, perimeter and centroid of unbounded or whole cells
//   periodic_cells     the same in a torus, and in a slab
//   periodic_radius    Bounded_voronoi_cells_2, with radius 0.7, in a torus: measures alone
//   ..._threads        the same by all threads, by the clock
//   radius, hexagon    Bounded_voronoi_cells_2, with radius 0.7, and in a convex domain: measures
//                      alone, or with the pieces of all boundaries
//   hall, forest       Voronoi_cells_in_domain_2, by its three rules, and with a radius
//   cgal, boost        CGAL's triangulation, and its Boolean operations in exact numbers, or
//                      Boost.Geometry in doubles, for every cell
//   python             SciPy's Voronoi and Shapely, in Python; reading them in is not timed
//
// The areas have to add up to that of the hall, to 1e-13 of it, and peers' to 1e-6. A case where
// they do not says so, and the program ends with an error.

#include "cells/Cell_peers.h"

#include <CGAL/Dynamic_Delaunay_triangulation_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/queries/Bounded_voronoi_cells_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/queries/Voronoi_cell_measures_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/queries/Voronoi_cells_in_domain_2.h>
#include <CGAL/Dynamic_periodic_Delaunay_triangulation_2.h>

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <limits>
#include <numeric>
#include <random>
#include <tuple>
#include <vector>

namespace {

using namespace cells;
using Dynamic = CGAL::Dynamic_Delaunay_triangulation_2<Kernel>;
template <class ConcurrencyTag>
using Periodic =
    CGAL::Dynamic_periodic_Delaunay_triangulation_2<Kernel, CGAL::Default,
                                                    CGAL::With_concurrency_2<ConcurrencyTag>>;
using Cells = CGAL::Voronoi_cells_in_domain_2;
using Rule = Cells::Rule;

constexpr double infinity = std::numeric_limits<double>::infinity();
bool all_right = true;

double side(const benchmark::State& state)
{
  return std::sqrt(double(state.range(0)));
}

// The number of pillars in each row and column.
std::size_t pillars(const benchmark::State& state, bool is_forest)
{
  return is_forest ? std::size_t(side(state) / 4) : 4;
}

Domain hall(const benchmark::State& state, std::size_t pillars)
{
  const double spacing = side(state) / double(pillars);
  const auto box = [](double x, double y, double size) {
    const Points corners{Point(x, y), Point(x + size, y), Point(x + size, y + size),
                         Point(x, y + size)};
    return CGAL::Polygon_2<Kernel>(corners.begin(), corners.end());
  };
  Domain hall(box(0, 0, side(state)));
  for (std::size_t i = 0; i < pillars; ++i)
    for (std::size_t j = 0; j < pillars; ++j) {
      auto pillar = box((double(i) + 0.375) * spacing, (double(j) + 0.375) * spacing, spacing / 4);
      pillar.reverse_orientation();
      hall.add_hole(pillar);
    }
  return hall;
}

// Random points, none of them in a pillar.
Points cloud(const benchmark::State& state, std::size_t pillars)
{
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> coordinate(0, side(state));
  const double spacing = side(state) / double(pillars);
  const auto off_middle = [&](double x) { return std::abs(std::fmod(x / spacing, 1) - 0.5); };
  Points points;
  while (points.size() < std::size_t(state.range(0))) {
    const Point p(coordinate(random), coordinate(random));
    if ((std::max)(off_middle(p.x()), off_middle(p.y())) > 0.126)
      points.push_back(p);
  }
  return points;
}

void count(benchmark::State& state)
{
  state.counters["s/cell"] =
      benchmark::Counter(double(state.range(0)), benchmark::Counter::kIsIterationInvariantRate |
                                                     benchmark::Counter::kInvert);
}

void check_sum(benchmark::State& state, double sum, double tolerance)
{
  const double expected = double(state.range(0)) * 15 / 16; // pillars take one part of 16
  if (std::abs(sum - expected) <= tolerance * expected)
    return;
  all_right = false;
  state.SkipWithError("the areas do not add up");
}

double sum(const std::vector<double>& areas)
{
  return std::accumulate(areas.begin(), areas.end(), 0.0);
}

void update(benchmark::State& state)
{
  Points points = cloud(state, 4);
  Dynamic dt(points.begin(), points.end());
  std::mt19937_64 random(2);
  std::normal_distribution<double> step(0, 0.01);
  for (auto _ : state) {
    state.PauseTiming();
    for (Point& p : points)
      p = Point(p.x() + step(random), p.y() + step(random));
    state.ResumeTiming();
    dt.update(points.begin(), points.end());
  }
  count(state);
}

// The first call, which touches its memory for the first time, does not count.
template <class Triangulation, class Computation>
void run(benchmark::State& state, const Triangulation& dt, const Computation& compute)
{
  compute(dt);
  for (auto _ : state)
    compute(dt);
  count(state);
}
template <class Computation>
void run(benchmark::State& state, bool is_forest, const Computation& compute)
{
  const Points points = cloud(state, pillars(state, is_forest));
  run(state, Dynamic(points.begin(), points.end()), compute);
}

void plain_cells(benchmark::State& state)
{
  CGAL::Voronoi_cell_measures_2 cells;
  run(state, false, [&](const Dynamic& dt) { cells.compute(dt); });
}

template <class Computation>
void run_periodic(benchmark::State& state, bool is_slab, bool by_threads,
                  const Computation& compute)
{
  const CGAL::Periodic_cell_2 torus(side(state), side(state)),
      slab(Kernel::Vector_2(side(state), 0));
  const CGAL::Periodic_cell_2& cell = is_slab ? slab : torus;
  const Points points = cloud(state, 4);
  if (by_threads)
    run(state, Periodic<CGAL::Parallel_if_available_tag>(points, cell), compute);
  else
    run(state, Periodic<CGAL::Sequential_tag>(points, cell), compute);
}

void periodic_cells(benchmark::State& state, bool is_slab, bool by_threads)
{
  CGAL::Voronoi_cell_measures_2 cells;
  run_periodic(state, is_slab, by_threads, [&](const auto& dt) { cells.compute(dt); });
}

void periodic_radius(benchmark::State& state, bool by_threads)
{
  CGAL::Bounded_voronoi_cells_2 cells;
  run_periodic(state, false, by_threads, [&](const auto& dt) { cells.compute_measures(dt, 0.7); });
}

void bounded(benchmark::State& state, CGAL::Bounded_voronoi_cells_2& cells, double radius,
             bool lists_pieces)
{
  run(state, false, [&](const Dynamic& dt) {
    if (lists_pieces)
      cells.compute(dt, radius);
    else
      cells.compute_measures(dt, radius);
  });
}

void radius(benchmark::State& state, bool lists_pieces)
{
  CGAL::Bounded_voronoi_cells_2 cells;
  bounded(state, cells, 0.7, lists_pieces);
}

void hexagon(benchmark::State& state, bool lists_pieces)
{
  Points corners;
  for (int i = 0; i < 6; ++i) {
    const double angle = i * 1.0471975512, middle = side(state) / 2;
    corners.push_back(Point(middle * (1 + std::cos(angle)), middle * (1 + std::sin(angle))));
  }
  CGAL::Bounded_voronoi_cells_2 cells;
  cells.set_domain(corners.begin(), corners.end());
  bounded(state, cells, infinity, lists_pieces);
}

void in_domain(benchmark::State& state, bool is_forest, Rule rule, double radius)
{
  Cells cells(hall(state, pillars(state, is_forest)), rule);
  run(state, is_forest, [&](const Dynamic& dt) { cells.compute(dt, radius); });
  if (rule == Rule::WHOLE)
    check_sum(state, sum(cells.areas()), 1e-13);
}

template <class Sum>
void peer(benchmark::State& state, const Sum& sum_of)
{
  const Domain domain = hall(state, pillars(state, false));
  const Points points = cloud(state, pillars(state, false));
  double sum = 0;
  for (auto _ : state)
    sum = sum_of(points, domain);
  count(state);
  check_sum(state, sum, 1e-6);
}

void python(benchmark::State& state)
{
  double sum = 0;
  try {
    for (auto _ : state) {
      double seconds;
      std::tie(sum, seconds) = sum_by_python(SHAPELY_CELLS, std::size_t(state.range(0)), 4);
      state.SetIterationTime(seconds);
    }
  } catch (const std::exception& error) {
    return state.SkipWithError(error.what());
  }
  count(state);
  check_sum(state, sum, 1e-6);
}

void sizes(benchmark::internal::Benchmark* benchmark)
{
  benchmark->ArgName("points")->Unit(benchmark::kMicrosecond);
  for (const int size : {1000, 10000, 100000, 1000000})
    benchmark->Arg(size);
}

void small_sizes(benchmark::internal::Benchmark* benchmark)
{
  benchmark->ArgName("points")->Unit(benchmark::kMicrosecond)->Arg(1000)->Arg(10000);
}

BENCHMARK(update)->Apply(sizes);
BENCHMARK(plain_cells)->Apply(sizes);
BENCHMARK_CAPTURE(periodic_cells, torus, false, false)->Apply(sizes);
BENCHMARK_CAPTURE(periodic_cells, torus_threads, false, true)->Apply(sizes)->UseRealTime();
BENCHMARK_CAPTURE(periodic_cells, slab, true, false)->Apply(sizes);
BENCHMARK_CAPTURE(periodic_cells, slab_threads, true, true)->Apply(sizes)->UseRealTime();
BENCHMARK_CAPTURE(periodic_radius, torus, false)->Apply(sizes);
BENCHMARK_CAPTURE(periodic_radius, torus_threads, true)->Apply(sizes)->UseRealTime();
BENCHMARK_CAPTURE(radius, measures, false)->Apply(sizes);
BENCHMARK_CAPTURE(radius, pieces, true)->Apply(sizes);
BENCHMARK_CAPTURE(hexagon, measures, false)->Apply(sizes);
BENCHMARK_CAPTURE(hexagon, pieces, true)->Apply(sizes);
BENCHMARK_CAPTURE(in_domain, hall_whole, false, Rule::WHOLE, infinity)->Apply(sizes);
BENCHMARK_CAPTURE(in_domain, hall_connected, false, Rule::CONNECTED, infinity)->Apply(sizes);
BENCHMARK_CAPTURE(in_domain, hall_visible, false, Rule::VISIBLE, infinity)->Apply(sizes);
BENCHMARK_CAPTURE(in_domain, hall_radius, false, Rule::CONNECTED, 0.7)->Apply(sizes);
BENCHMARK_CAPTURE(in_domain, forest_whole, true, Rule::WHOLE, infinity)->Apply(sizes);
BENCHMARK_CAPTURE(in_domain, forest_connected, true, Rule::CONNECTED, infinity)->Apply(sizes);
BENCHMARK_CAPTURE(in_domain, forest_visible, true, Rule::VISIBLE, infinity)->Apply(sizes);
BENCHMARK_CAPTURE(peer, cgal, sum_by_cgal)->Apply(small_sizes);
BENCHMARK_CAPTURE(peer, boost, sum_by_boost)->Apply(small_sizes);
BENCHMARK(python)->Apply(small_sizes)->UseManualTime();

} // namespace

int main(int argc, char** argv)
{
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
  return all_right ? 0 : 1;
}

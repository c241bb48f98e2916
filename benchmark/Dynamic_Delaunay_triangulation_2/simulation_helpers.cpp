// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What simulations get from an existing triangulation, and what that costs a point, or a query:
// neighbor lists, Voronoi cells and forces, nearest points and those within a radius, and weights
// by which to interpolate. The points are a uniform cloud, one to a unit of area, whose ids say
// nothing about where they are; places that are asked for are anywhere among them, or those of a
// grid, row by row. Cases with `cgal` do the same by CGAL's own means, with the face of the last
// place as a hint, cases with `periodic` in a periodic square. The counter s/point is the time
// divided by the points or queries.

#include <CGAL/Dynamic_Delaunay_triangulation_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/queries/Bounded_voronoi_cells_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/queries/Bounded_voronoi_gradients_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/queries/Delaunay_neighbor_lists_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/queries/Delaunay_point_queries_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/queries/Interpolation_weights_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/queries/Voronoi_cell_gradients_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/queries/Voronoi_cell_measures_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/queries/Voronoi_cells_2.h>
#include <CGAL/Dynamic_periodic_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/natural_neighbor_coordinates_2.h>

#include <benchmark/benchmark.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <random>
#include <type_traits>
#include <utility>
#include <vector>

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_2;
using Dynamic = CGAL::Dynamic_Delaunay_triangulation_2<Kernel>;
using Periodic = CGAL::Dynamic_periodic_Delaunay_triangulation_2<Kernel>;
using Queries = CGAL::Delaunay_point_queries_2<Dynamic>;
using Ids = std::vector<std::size_t>;

// One to a unit of area.
std::vector<Point> cloud(const benchmark::State& state, std::uint64_t seed)
{
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> coordinate(0, std::sqrt(double(state.range(0))));
  std::vector<Point> points;
  for (std::int64_t i = 0; i < state.range(0); ++i) {
    const double x = coordinate(random);
    points.push_back(Point(x, coordinate(random)));
  }
  return points;
}

// Places among the points.
std::vector<Point> anywhere(const benchmark::State& state)
{
  return cloud(state, 2);
}

double side(const benchmark::State& state)
{
  return std::sqrt(double(state.range(0)));
}

template <class Triangulation>
Triangulation made(const benchmark::State& state)
{
  if constexpr (std::is_same_v<Triangulation, Periodic>)
    return Periodic(cloud(state, 1), CGAL::Periodic_cell_2(side(state), side(state)));
  else
    return Dynamic(cloud(state, 1));
}

// Runs `work(dt)`, which does something for every point, or place. The first call, which touches
// its memory for the first time, does not count.
template <class Triangulation = Dynamic, class Work>
void run(benchmark::State& state, const Work& work)
{
  const auto dt = made<Triangulation>(state);
  work(dt);
  for (auto _ : state)
    work(dt);
  state.counters["s/point"] =
      benchmark::Counter(double(state.range(0)), benchmark::Counter::kIsIterationInvariantRate |
                                                     benchmark::Counter::kInvert);
}

void neighbor_lists(benchmark::State& state)
{
  CGAL::Delaunay_neighbor_lists_2 lists;
  run(state, [&](const Dynamic& dt) {
    lists.compute(dt);
    benchmark::DoNotOptimize(lists.neighbors().data());
  });
}

// Writes the neighbor lists into arrays of the same form.
void neighbor_lists_cgal(benchmark::State& state)
{
  Ids offsets, neighbors;
  run(state, [&](const Dynamic& dt) {
    const auto& triangulation = dt.triangulation();
    offsets.assign(1, 0);
    neighbors.clear();
    for (std::size_t id = 0; id < dt.number_of_ids(); ++id) {
      auto neighbor = triangulation.incident_vertices(dt.vertex(id));
      const auto first = neighbor;
      do
        if (!triangulation.is_infinite(neighbor))
          neighbors.push_back(dt.id(neighbor));
      while (++neighbor != first);
      offsets.push_back(neighbors.size());
    }
    benchmark::DoNotOptimize(neighbors.data());
  });
}

template <class Triangulation>
void whole_cells(benchmark::State& state)
{
  CGAL::Voronoi_cell_measures_2 cells;
  run<Triangulation>(state, [&](const Triangulation& dt) {
    cells.compute(dt);
    benchmark::DoNotOptimize(cells.areas().data());
  });
}

// The forces of all points, without the measures that their weights would come from.
template <class Triangulation>
void forces(benchmark::State& state)
{
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> weight(-1, 1);
  std::vector<double> weights;
  for (std::int64_t i = 0; i < state.range(0); ++i)
    weights.push_back(weight(random));
  CGAL::Voronoi_cell_gradients_2 gradients;
  run<Triangulation>(state, [&](const Triangulation& dt) {
    gradients.compute(dt, weights, weights);
    benchmark::DoNotOptimize(gradients.gradients().data());
  });
}

void voronoi_edges(benchmark::State& state)
{
  run(state, [&](const Dynamic& dt) {
    CGAL::for_each_voronoi_edge(
        dt, [](std::size_t, std::size_t, double length) { benchmark::DoNotOptimize(length); });
  });
}

void voronoi_edges_periodic(benchmark::State& state)
{
  run<Periodic>(state, [&](const Periodic& dt) {
    CGAL::for_each_voronoi_edge(dt, [](std::size_t, std::size_t, const auto&, double length) {
      benchmark::DoNotOptimize(length);
    });
  });
}

void clipped_cells(benchmark::State& state)
{
  CGAL::Voronoi_cell_measures_2 cells;
  run(state, [&](const Dynamic& dt) {
    cells.compute(dt, CGAL::Bbox_2(0, 0, side(state), side(state)));
    benchmark::DoNotOptimize(cells.areas().data());
  });
}

void nearest_neighbor_of_each(benchmark::State& state)
{
  run(state, [](const Dynamic& dt) {
    Queries queries(dt);
    for (std::size_t id = 0; id < dt.number_of_ids(); ++id)
      benchmark::DoNotOptimize(queries.nearest_neighbor(id));
  });
}

// About ten others.
void within_radius_of_each(benchmark::State& state)
{
  constexpr double squared_radius = 3.2;
  Ids ids;
  std::size_t found = 0, asked = 0;
  run(state, [&](const Dynamic& dt) {
    Queries queries(dt);
    for (std::size_t id = 0; id < dt.number_of_ids(); ++id) {
      ids.clear();
      queries.neighbors_within(id, squared_radius, std::back_inserter(ids));
      found += ids.size();
    }
    asked += dt.number_of_ids();
  });
  state.counters["found"] = double(found) / double(asked);
}

void nearest_to_places(benchmark::State& state)
{
  const std::vector<Point> places = anywhere(state);
  run(state, [&](const Dynamic& dt) {
    Queries queries(dt);
    for (const Point& place : places)
      benchmark::DoNotOptimize(queries.nearest(place));
  });
}

void nearest_to_places_cgal(benchmark::State& state)
{
  const std::vector<Point> places = anywhere(state);
  run(state, [&](const Dynamic& dt) {
    for (const Point& place : places)
      benchmark::DoNotOptimize(dt.id(dt.triangulation().nearest_vertex(place)));
  });
}

// The places of a grid, as many as points. Rows alternate in their direction.
std::vector<Point> grid(const benchmark::State& state)
{
  const auto columns = std::int64_t(side(state));
  std::vector<Point> places;
  for (std::int64_t i = 0; i < state.range(0); ++i) {
    const std::int64_t row = i / columns, column = i % columns;
    places.push_back(Point(double(row % 2 == 0 ? column : columns - 1 - column) + 0.5,
                           double(row) * side(state) / double(columns + 1)));
  }
  return places;
}

// To interpolate at.
using Places = std::vector<Point> (*)(const benchmark::State& state);

template <class Triangulation, Places places_of>
void natural_neighbors(benchmark::State& state)
{
  const std::vector<Point> places = places_of(state);
  CGAL::Interpolation_weights_2 weights;
  run<Triangulation>(state, [&](const Triangulation& dt) {
    weights.compute_natural_neighbor(dt, places.begin(), places.end());
    benchmark::DoNotOptimize(weights.weights().data());
  });
}

// Writes the weights into arrays of the same form.
template <Places places_of>
void natural_neighbors_cgal(benchmark::State& state)
{
  const std::vector<Point> places = places_of(state);
  using Triangulation = Dynamic::Triangulation;
  std::vector<std::pair<Triangulation::Vertex_handle, double>> parts;
  Ids offsets, ids;
  std::vector<double> weights;
  run(state, [&](const Dynamic& dt) {
    const Triangulation& triangulation = dt.triangulation();
    Triangulation::Face_handle face;
    offsets.assign(1, 0);
    ids.clear();
    weights.clear();
    for (const Point& place : places) {
      parts.clear();
      face = triangulation.locate(place, face);
      const auto result = CGAL::natural_neighbor_coordinates_2(
          triangulation, place, std::back_inserter(parts), [](const auto& found) { return found; },
          face);
      for (const auto& [vertex, part] : parts) {
        ids.push_back(dt.id(vertex));
        weights.push_back(part / result.second);
      }
      offsets.push_back(ids.size());
    }
    benchmark::DoNotOptimize(weights.data());
  });
}

void linear_in_a_grid(benchmark::State& state)
{
  const std::vector<Point> places = grid(state);
  CGAL::Interpolation_weights_2 weights;
  run(state, [&](const Dynamic& dt) {
    weights.compute_linear(dt, places.begin(), places.end());
    benchmark::DoNotOptimize(weights.weights().data());
  });
}

// The radius of bounded cells: discs of this radius hardly leave a gap.
constexpr double radius = 0.7;

template <class Triangulation>
void bounded_cells(benchmark::State& state)
{
  CGAL::Bounded_voronoi_cells_2 cells;
  run<Triangulation>(state, [&](const Triangulation& dt) {
    cells.compute(dt, radius);
    benchmark::DoNotOptimize(cells.pieces().data());
  });
}

void bounded_cells_in_a_hexagon(benchmark::State& state)
{
  std::vector<Point> corners;
  for (int i = 0; i < 6; ++i) {
    const double angle = i * 1.0471975512, middle = side(state) / 2;
    corners.push_back(Point(middle * (1 + std::cos(angle)), middle * (1 + std::sin(angle))));
  }
  CGAL::Bounded_voronoi_cells_2 cells;
  cells.set_domain(corners.begin(), corners.end());
  run(state, [&](const Dynamic& dt) {
    cells.compute(dt, radius);
    benchmark::DoNotOptimize(cells.pieces().data());
  });
}

void bounded_forces(benchmark::State& state)
{
  const Dynamic dt(cloud(state, 1));
  CGAL::Bounded_voronoi_cells_2 cells;
  cells.compute(dt, radius);
  const std::vector<double> by_area(cells.areas().size(), 1), by_length(cells.pieces().size(), 2);
  CGAL::Bounded_voronoi_gradients_2 gradients;
  run(state, [&](const Dynamic& same) {
    gradients.compute(same, cells, by_area, by_length);
    benchmark::DoNotOptimize(gradients.by_positions().data());
  });
}

// Queries of a walker through the cloud: each place is a little further on than the last one.
void nearest_to_places_in_a_row(benchmark::State& state)
{
  run(state, [&](const Dynamic& dt) {
    Queries queries(dt);
    for (std::int64_t i = 0; i < state.range(0); ++i) {
      const double x = std::fmod(0.1 * double(i), side(state));
      benchmark::DoNotOptimize(queries.nearest(Point(x, 0.7 * x)));
    }
  });
}

void sizes(benchmark::internal::Benchmark* benchmark)
{
  benchmark->ArgName("points")->Unit(benchmark::kMicrosecond)->Arg(1000)->Arg(100000);
}

BENCHMARK(neighbor_lists)->Apply(sizes);
BENCHMARK(neighbor_lists_cgal)->Apply(sizes);
BENCHMARK_TEMPLATE(whole_cells, Dynamic)->Name("whole_cells")->Apply(sizes);
BENCHMARK_TEMPLATE(whole_cells, Periodic)->Name("whole_cells_periodic")->Apply(sizes);
BENCHMARK(voronoi_edges)->Apply(sizes);
BENCHMARK(voronoi_edges_periodic)->Apply(sizes);
BENCHMARK_TEMPLATE(forces, Dynamic)->Name("forces")->Apply(sizes);
BENCHMARK_TEMPLATE(forces, Periodic)->Name("forces_periodic")->Apply(sizes);
BENCHMARK(clipped_cells)->Apply(sizes);
BENCHMARK_TEMPLATE(bounded_cells, Dynamic)->Name("bounded_cells")->Apply(sizes);
BENCHMARK_TEMPLATE(bounded_cells, Periodic)->Name("bounded_cells_periodic")->Apply(sizes);
BENCHMARK(bounded_cells_in_a_hexagon)->Apply(sizes);
BENCHMARK(bounded_forces)->Apply(sizes);
BENCHMARK(nearest_neighbor_of_each)->Apply(sizes);
BENCHMARK(within_radius_of_each)->Apply(sizes);
BENCHMARK(nearest_to_places)->Apply(sizes);
BENCHMARK(nearest_to_places_cgal)->Apply(sizes);
BENCHMARK(nearest_to_places_in_a_row)->Apply(sizes);
BENCHMARK_TEMPLATE(natural_neighbors, Dynamic, grid)
    ->Name("natural_neighbors_in_a_grid")
    ->Apply(sizes);
BENCHMARK_TEMPLATE(natural_neighbors_cgal, grid)
    ->Name("natural_neighbors_in_a_grid_cgal")
    ->Apply(sizes);
BENCHMARK_TEMPLATE(natural_neighbors, Periodic, grid)
    ->Name("natural_neighbors_in_a_grid_periodic")
    ->Apply(sizes);
BENCHMARK_TEMPLATE(natural_neighbors, Dynamic, anywhere)
    ->Name("natural_neighbors_anywhere")
    ->Apply(sizes);
BENCHMARK_TEMPLATE(natural_neighbors_cgal, anywhere)
    ->Name("natural_neighbors_anywhere_cgal")
    ->Apply(sizes);
BENCHMARK(linear_in_a_grid)->Apply(sizes);

} // namespace

BENCHMARK_MAIN();

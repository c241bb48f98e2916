// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What one frame of Brownian motion costs: kept by an exact update, by the thesis's point distance
// with its border splice, and triangulated anew by CGAL. Arguments: the number of points, and the
// step in millionths of the mean spacing. The counter ns/point is the time of a frame divided by
// the points.

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/classifiers/Point_distance_classifier_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/hilbert_sort.h>

#include <benchmark/benchmark.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <random>
#include <vector>

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_2;
using Exact = CGAL::Dynamic_Delaunay_triangulation_2<Kernel>;
using Distance = CGAL::Dynamic_Delaunay_triangulation_2<Kernel, CGAL::Point_distance_classifier_2>;

// A uniform cloud, one point to a unit of area, whose points take Gaussian steps.
class Brownian_cloud
{
public:
  explicit Brownian_cloud(const benchmark::State& state)
    : m_step(0, double(state.range(1)) * 1e-6)
  {
    std::uniform_real_distribution<double> coordinate(0, std::sqrt(double(state.range(0))));
    for (std::int64_t i = 0; i < state.range(0); ++i) {
      const double x = coordinate(m_random);
      m_points.push_back(Point(x, coordinate(m_random)));
    }
    CGAL::hilbert_sort(m_points.begin(), m_points.end());
  }

  const std::vector<Point>& points() const { return m_points; }

  void move()
  {
    for (Point& p : m_points) {
      const double dx = m_step(m_random);
      p = Point(p.x() + dx, p.y() + m_step(m_random));
    }
  }

private:
  std::mt19937_64 m_random{1};
  std::normal_distribution<double> m_step;
  std::vector<Point> m_points;
};

// Runs `frame` on the moved cloud, the motion untimed.
template <class Frame>
void run(benchmark::State& state, Brownian_cloud& cloud, const Frame& frame)
{
  for (auto _ : state) {
    state.PauseTiming();
    cloud.move();
    state.ResumeTiming();
    frame(cloud.points());
  }
  state.counters["s/point"] =
      benchmark::Counter(double(state.range(0)), benchmark::Counter::kIsIterationInvariantRate |
                                                     benchmark::Counter::kInvert);
}

void exact_update(benchmark::State& state)
{
  Brownian_cloud cloud(state);
  Exact dt(cloud.points().begin(), cloud.points().end());
  double flips = 0;
  run(state, cloud, [&](const std::vector<Point>& points) {
    flips += double(dt.update(points.begin(), points.end()).flips);
  });
  state.counters["flips"] = benchmark::Counter(flips, benchmark::Counter::kAvgIterations);
}

void point_distance_update(benchmark::State& state)
{
  Brownian_cloud cloud(state);
  Distance dt(cloud.points().begin(), cloud.points().end());
  run(state, cloud,
      [&](const std::vector<Point>& points) { dt.update(points.begin(), points.end()); });
}

void static_insert(benchmark::State& state)
{
  Brownian_cloud cloud(state);
  run(state, cloud, [](const std::vector<Point>& points) {
    CGAL::Delaunay_triangulation_2<Kernel> dt;
    benchmark::DoNotOptimize(dt.insert(points.begin(), points.end()));
  });
}

// One by one, each point located from the one before, in the order of `indices`.
void insert_in_order(benchmark::State& state, Brownian_cloud& cloud,
                     const std::vector<std::size_t>& indices)
{
  run(state, cloud, [&](const std::vector<Point>& points) {
    CGAL::Delaunay_triangulation_2<Kernel> dt;
    CGAL::Delaunay_triangulation_2<Kernel>::Face_handle hint;
    for (const std::size_t i : indices)
      hint = dt.insert(points[i], hint)->face();
    benchmark::DoNotOptimize(dt.number_of_vertices());
  });
}

// The cloud is numbered along a Hilbert curve, and small steps keep it so.
void static_along_curve(benchmark::State& state)
{
  Brownian_cloud cloud(state);
  std::vector<std::size_t> indices(cloud.points().size());
  std::iota(indices.begin(), indices.end(), std::size_t(0));
  insert_in_order(state, cloud, indices);
}

// In rounds along the curve, every 8^k-th point first.
void static_fastest(benchmark::State& state)
{
  Brownian_cloud cloud(state);
  std::vector<std::size_t> indices;
  CGAL::Dynamic_Delaunay_triangulations_2::internal::for_each_in_rounds(
      cloud.points().size(), [&](std::size_t i) { indices.push_back(i); });
  insert_in_order(state, cloud, indices);
}

void sizes_and_steps(benchmark::internal::Benchmark* benchmark)
{
  benchmark->ArgNames({"points", "step"})->Unit(benchmark::kMicrosecond);
  for (const std::int64_t points : {1000, 10000, 100000})
    for (const std::int64_t step : {100, 1000, 10000})
      benchmark->Args({points, step});
}

BENCHMARK(exact_update)->Apply(sizes_and_steps);
BENCHMARK(point_distance_update)->Apply(sizes_and_steps);
BENCHMARK(static_insert)->Apply(sizes_and_steps);
BENCHMARK(static_along_curve)->Apply(sizes_and_steps);
BENCHMARK(static_fastest)->Apply(sizes_and_steps);

} // namespace

BENCHMARK_MAIN();

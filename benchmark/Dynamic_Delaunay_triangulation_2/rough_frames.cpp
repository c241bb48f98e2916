// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// What frames cost that are neither calm nor new: the figures to which the prices of
// internal/update/Cost_model_2.h are fitted, and those of the manual about such frames. In each
// frame the same points go to three triangulations in turn: one is updated as usual, one is mended
// in one step, however much is broken, and one is rebuilt. Time is that of the thread, in
// nanoseconds a point; `update` and `worst` are of the first one, `rebuilds` its rebuilt frames in
// percent, `/mended` and `/rebuild` the medians of its ratios to the others in a frame. `open` is
// the number of edges a point that are not proved after the motion, `out` the vertices that are
// taken out and put in where that is mended in one step, in percent of all points.
//
// Motion: every point takes a Gaussian step, whose standard deviation is `step` spacings; in the
// plane, on a torus and in a slab. Population: at rest, `share` of all points leave and as many
// come, anywhere.
//
// After the last frame all have to be certified and valid. The first fault ends the program.

#include "common/Program.h"
#include "common/Statistics.h"
#include "common/Table.h"
#include "common/Thread_time.h"

#include <CGAL/Dynamic_Delaunay_triangulation_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/policies/Always_static_policy_2.h>
#include <CGAL/Dynamic_periodic_Delaunay_triangulation_2.h>
#include <CGAL/Dynamic_population_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/spatial_sort.h>

#include <CLI/CLI.hpp>

#include <cmath>
#include <cstddef>
#include <iostream>
#include <memory>
#include <random>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_2;
using Points = std::vector<Point>;
using Report = CGAL::Update_report_2;
using CGAL::Default;

struct Options
{
  std::vector<std::size_t> points{1000, 10000, 100000};
  std::vector<double> steps{0.001, 0.01, 0.03, 0.06, 0.1, 0.15, 0.2, 0.3};
  std::vector<double> shares{0, 0.01, 0.05, 0.1, 0.2};
  int frames = 0;
  bool is_quick = false;

  int frames_of(std::size_t n) const
  {
    return frames > 0 ? frames : is_quick ? 3 : n < 5000 ? 200 : n < 50000 ? 40 : 12;
  }
};

// Mends in one step, whatever that costs, and counts the edges to mend.
struct Unlimited_repair
{
  std::shared_ptr<std::size_t> open = std::make_shared<std::size_t>(0);

  template <class Mender>
  void operator()(Mender& mender) const
  {
    *open += mender.number_of_open_edges();
    mender.hold();
    mender.flip();
    mender.release();
  }
};

// The times of frames, and what was done in them.
struct Times
{
  std::vector<double> nanoseconds;
  std::size_t rebuilt = 0, relocated = 0;

  template <class Update>
  void add(std::size_t points, const Update& update)
  {
    const double begin = common::thread_nanoseconds();
    const Report report = update();
    nanoseconds.push_back((common::thread_nanoseconds() - begin) / double(points));
    rebuilt += report.rebuilt();
    relocated += report.relocated;
  }
};

template <class Triangulation>
void check(const Triangulation& triangulation)
{
  if (!triangulation.is_certified() || !triangulation.is_valid(true)) {
    throw std::runtime_error("a triangulation is wrong");
  }
}

Points random_points(std::mt19937_64& random, std::size_t n)
{
  std::uniform_real_distribution<double> place(0, std::sqrt(double(n)));
  Points points;
  for (std::size_t i = 0; i != n; ++i) {
    const double x = place(random);
    points.emplace_back(x, place(random));
  }
  CGAL::spatial_sort(points.begin(), points.end());
  return points;
}

// MOTION ------------------------------------------------------------------------------------------

struct Motion_figures
{
  Times usual, unlimited, rebuilt;
  double open = 0; // edges a point
};

// `make(repair, policy)` makes a triangulation of the points.
template <class Make>
Motion_figures follow_motion(Points points, double step, int frames, std::mt19937_64& random,
                             const Make& make)
{
  const Unlimited_repair unlimited_repair;
  auto usual = make(points, CGAL::Hold_and_flip_repair_2(), CGAL::Always_dynamic_policy_2());
  auto unlimited = make(points, unlimited_repair, CGAL::Always_dynamic_policy_2());
  auto rebuilt = make(points, CGAL::Hold_and_flip_repair_2(), CGAL::Always_static_policy_2());
  const std::size_t n = points.size();
  std::normal_distribution<double> way(0, step);
  Motion_figures figures;
  for (int frame = 0; frame != frames; ++frame) {
    for (Point& p : points) {
      const double x = p.x() + way(random);
      p = Point(x, p.y() + way(random));
    }
    figures.usual.add(n, [&] { return usual.update(points); });
    figures.unlimited.add(n, [&] { return unlimited.update(points); });
    figures.rebuilt.add(n, [&] { return rebuilt.update(points); });
  }
  check(usual);
  check(unlimited);
  figures.open = double(*unlimited_repair.open) / double(n) / frames;
  return figures;
}

Motion_figures run_motion(const std::string& space, std::size_t n, double step, int frames)
{
  std::mt19937_64 random(1);
  const Points points = random_points(random, n);
  const double side = std::sqrt(double(n));
  if (space == "plane") {
    return follow_motion(
        points, step, frames, random, [](const Points& p, auto repair, auto policy) {
          using Triangulation =
              CGAL::Dynamic_Delaunay_triangulation_2<Kernel, Default,
                                                     CGAL::With_repair_2<decltype(repair)>,
                                                     CGAL::With_policy_2<decltype(policy)>>;
          return Triangulation(p, typename Triangulation::Settings{{}, repair, {}, policy, {}});
        });
  }
  const CGAL::Periodic_cell_2 cell =
      space == "slab" ? CGAL::Periodic_cell_2::slab(side, 0) : CGAL::Periodic_cell_2(side, side);
  return follow_motion(
      points, step, frames, random, [&](const Points& p, auto repair, auto policy) {
        using Triangulation =
            CGAL::Dynamic_periodic_Delaunay_triangulation_2<Kernel, Default,
                                                            CGAL::With_repair_2<decltype(repair)>,
                                                            CGAL::With_policy_2<decltype(policy)>>;
        return Triangulation(p, cell, typename Triangulation::Settings{{}, repair, {}, policy, {}});
      });
}

void write_motion(const Options& options)
{
  common::Table table(std::cout, 24,
                      {{"update", 9, 1},
                       {"worst", 9, 1},
                       {"rebuilds", 9, 0},
                       {"mended", 9, 1},
                       {"rebuilt", 9, 1},
                       {"/mended", 9, 2},
                       {"/rebuild", 9, 2},
                       {"open", 7, 2},
                       {"out %", 7, 2}});
  for (const std::string space : {"plane", "torus", "slab"}) {
    for (const std::size_t n : options.points) {
      table.write_head(space + ", " + std::to_string(n) + " points");
      for (const double step : options.steps) {
        const int frames = options.frames_of(space == "slab" ? 5 * n : n);
        const Motion_figures f = run_motion(space, n, step, frames);
        table.write_row(
            "  step " + common::cell(step, 3), common::median(f.usual.nanoseconds),
            common::largest(f.usual.nanoseconds), 100.0 * double(f.usual.rebuilt) / frames,
            common::median(f.unlimited.nanoseconds), common::median(f.rebuilt.nanoseconds),
            common::median_ratio(f.usual.nanoseconds, f.unlimited.nanoseconds),
            common::median_ratio(f.usual.nanoseconds, f.rebuilt.nanoseconds), f.open,
            100.0 * double(f.unlimited.relocated) / frames / double(n));
      }
    }
  }
}

// POPULATION --------------------------------------------------------------------------------------

template <class Policy>
using People = CGAL::Dynamic_population_2<
    CGAL::Dynamic_Delaunay_triangulation_2<Kernel, Default, CGAL::With_policy_2<Policy>>, int>;

void write_population(const Options& options)
{
  common::Table table(std::cout, 24,
                      {{"update", 9, 1},
                       {"worst", 9, 1},
                       {"rebuilds", 9, 0},
                       {"rebuilt", 9, 1},
                       {"/rebuild", 9, 2}});
  for (const std::size_t n : options.points) {
    table.write_head("population of " + std::to_string(n));
    for (const double share : options.shares) {
      std::mt19937_64 random(1);
      std::vector<std::pair<int, Point>> frame;
      int next = 0;
      for (const Point& p : random_points(random, n)) {
        frame.emplace_back(next++, p);
      }
      People<CGAL::Always_dynamic_policy_2> usual;
      People<CGAL::Always_static_policy_2> rebuilt;
      usual.update(frame);
      rebuilt.update(frame);
      std::uniform_real_distribution<double> place(0, std::sqrt(double(n)));
      const int frames = options.frames_of(n);
      Times of_usual, of_rebuilt;
      for (int i = 0; i != frames; ++i) {
        for (std::size_t k = 0; k < std::size_t(share * double(n)); ++k) {
          const double x = place(random);
          frame[random() % n] = {next++, Point(x, place(random))};
        }
        of_usual.add(n, [&] { return usual.update(frame); });
        of_rebuilt.add(n, [&] { return rebuilt.update(frame); });
      }
      check(usual.triangulation());
      table.write_row("  share " + common::cell(share, 2), common::median(of_usual.nanoseconds),
                      common::largest(of_usual.nanoseconds),
                      100.0 * double(of_usual.rebuilt) / frames,
                      common::median(of_rebuilt.nanoseconds),
                      common::median_ratio(of_usual.nanoseconds, of_rebuilt.nanoseconds));
    }
  }
}

// THE PROGRAM -------------------------------------------------------------------------------------

void add_options(CLI::App& app, Options& options)
{
  app.description("Times rough frames, and frames in which many points come and go, against "
                  "rebuilds.");
  common::add_option(app, "--points", options.points, "N...", "how many; default 1000 10000 100000",
                     CLI::Range(10, 10'000'000));
  common::add_option(app, "--steps", options.steps, "S...", "in spacings", CLI::Range(0.0, 1e3));
  common::add_option(app, "--frames", options.frames, "N", "of each kind; default 200 to 12",
                     CLI::Range(1, 100'000));
  app.add_flag("--quick", options.is_quick, "only check: a few frames");
}

bool run_rough_frames(const Options& options, const std::string& command)
{
  write_motion(options);
  write_population(options);
  std::cout << '\n' << command << std::endl;
  return true;
}

} // namespace

int main(int argc, char** argv)
{
  return common::run_program<Options>("rough_frames", argc, argv, add_options, run_rough_frames);
}

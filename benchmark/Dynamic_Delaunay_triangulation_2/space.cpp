// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// What an update costs in space, and what CGAL's insertion costs on the same frames. Each frame
// goes in turn to the dynamic triangulation, to CGAL's insertion of the range (`insert`), and to
// its insertion one by one with the last cell as hint, in an order that CGAL has sorted once
// (`sorted`). Time is that of the thread, in nanoseconds a point; `worst` is the slowest update,
// `/fastest` the median of the ratios of the faster of both to the update. `flips` a point, `held`
// in percent of the points, `relocated` a frame, `rebuilds` in percent of the frames.
//
// Kinds: `poisson`, `lattice` (jittered by 0.2 spacings) and `ball` take Gaussian steps, of `step`
// spacings in r.m.s.; `exact_lattice` likewise; `slab` is 10 : 10 : 1. With a drift, all points
// move 0.7 spacings besides; `streams` are two, each by a step in its direction; in `jumps` five
// points go anywhere. In a `population` all points are at rest, but a share of them leaves in each
// frame, and as many come, anywhere: an update of Dynamic_population_3. There, `sorted` knows an
// order of those that stay, and sorts the others while the clock runs.
//
// `threads` are wall-clock times of Poisson clouds, in open space and in a cube that is repeated in
// all directions: of a triangulation with the Sequential_tag, and of two with the Parallel_tag, in
// one thread and in all that the machine has, or in as many as asked for. Each follows bursts of
// frames in turn; the first frame of a burst does not count. `worst` is the slowest update of all
// threads, `/one` the median of the ratios of the second time to the third, `/sequential` of the
// first to the third. All have to do the same flips. `anew` are constructors in the same ways,
// beside CGAL's parallel insertion of the range by as many threads, or its periodic insertion,
// which one thread does, all in turns.
//
// `periodic` are Poisson clouds in a cell that is repeated in all directions, a cube or
// `triclinic`: the update, that of as many points in open space, and CGAL's insertion of the points
// in a periodic cube, as a large set of points. `/CGAL` is the ratio of the medians of the last and
// the first.
//
// `walls` are points in a cell that is repeated in some directions, and has walls in the others,
// from which they bounce: a `slab`, a round `pipe`, a square `duct`, beside a `cube` without walls;
// in `slab_walls` and `duct_walls` a third of them slides along the walls, and in a `layer` all do,
// which are in one plane. They are a tenth as many as elsewhere, in 20 times as many frames, and as
// many in as many. `open` is as above, but starts again in every twentieth frame, as points drift
// apart there; `anew` is the construction, `/anew` the median of the updates that were rebuilds
// over that.
//
// `out of it` are nanoseconds a point of what comes out of a triangulation, beside the same by
// CGAL's Delaunay triangulation: lists of all neighbors, volumes of all Voronoi cells, alone and
// with all other measures (of CGAL's both times the volumes, from the circumcenters around each
// edge; it clips none to a box), and the nearest points of as many random places along a curve,
// each found from the last. voro++ makes cells in a box from points alone, and so it does here. Of
// `volumes in a box` it measures nothing but these; of `cells in a box` all that
// Voronoi_cell_measures_3 always does; `from points` has the latter triangulate first, which a
// program does once and not in each frame. The volumes of each cell have to agree, and both sums
// with the box. `bytes` are those a point that the dynamic triangulation has
// allocated, after its construction and after a frame of 0.01 spacings, and those of CGAL's.
//
// `construction` is the ratio of the constructor's time to that of CGAL's insertion of the range.
// After the last frame every triangulation has to be valid, by exact predicates, and to have as
// many vertices as CGAL's. The first fault ends the program.

#include "common/Program.h"
#include "common/Table.h"
#include "space/Frame_cases.h"
#include "space/Outcome.h"
#include "space/Periodic_cases.h"
#include "space/Thread_cases.h"
#include "space/Walled_cases.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstddef>
#include <iostream>
#include <string>
#include <vector>

namespace {

struct Options
{
  std::vector<std::size_t> points{10000, 100000};
  std::vector<double> steps{0.0001, 0.001, 0.01, 0.03, 0.1};
  std::vector<double> shares{0.01, 0.05, 0.08, 0.1, 0.2};
  std::vector<std::string> kinds{"poisson", "lattice",  "ball",    "exact_lattice", "slab",
                                 "sphere",  "drift",    "streams", "jumps",         "population",
                                 "threads", "periodic", "walls"};
  unsigned threads = 0; // all
  int frames = 0;

  int frames_of(std::size_t n) const
  {
    return frames > 0 ? frames : n < 50000 ? 20 : n < 500000 ? 8 : 4;
  }
  bool has_kind(const std::string& kind) const
  {
    return std::find(kinds.begin(), kinds.end(), kind) != kinds.end();
  }
};

void add_options(CLI::App& app, Options& options)
{
  app.description("Times updates in space against CGAL's insertion.");
  common::add_option(app, "--points", options.points, "N...", "how many; default 10000 100000",
                     CLI::Range(10, 100'000'000));
  common::add_option(app, "--steps", options.steps, "S...", "in spacings", CLI::Range(0.0, 1e3));
  common::add_option(app, "--shares", options.shares, "S...",
                     "of a population that leave in a frame; default 0.01 0.05 0.08 0.1 0.2",
                     CLI::Range(0.0, 1.0));
  common::add_option(app, "--kinds", options.kinds, "KIND...", "default: all",
                     CLI::IsMember(options.kinds));
  common::add_option(app, "--threads", options.threads, "N", "default: all of the machine",
                     CLI::Range(2, 1024));
  common::add_option(app, "--frames", options.frames, "N", "of each case; default 20 to 4",
                     CLI::Range(1, 100'000));
}

void write_frames(const Options& options, std::size_t n)
{
  common::Table table = space::frame_table();
  table.write_head(std::to_string(n) + " points");
  space::write_construction(table, n);
  for (const std::string& kind : options.kinds) {
    if (kind == "population" || kind == "threads" || kind == "periodic" || kind == "walls") {
      continue;
    }
    for (const double step : options.steps) {
      space::write_motion(table, kind, n, step, options.frames_of(n));
    }
  }
  if (options.has_kind("population")) {
    for (const double share : options.shares) {
      space::write_population(table, n, share, options.frames_of(n));
    }
  }
}

void write_periodic(const Options& options, std::size_t n)
{
  common::Table table = space::periodic_table();
  table.write_head(std::to_string(n) + " periodic points");
  for (const std::string kind : {"cube", "triclinic"}) {
    for (const double step : options.steps) {
      space::write_periodic(table, kind, n, step, options.frames_of(n));
    }
  }
}

constexpr std::size_t most_with_walls = 10000; // more cost as much a point, and are seldom rebuilt

void write_walls(const Options& options, std::size_t n)
{
  constexpr std::size_t share = 10;
  constexpr int times = 20;
  constexpr double exchanged = 0.01;
  common::Table table = space::walled_table();
  for (const std::size_t number : {n / share, n}) {
    const int frames = options.frames_of(n) * (number < n ? times : 1);
    table.write_head(std::to_string(number) + " points, walls");
    for (const std::string& kind : space::walled_kinds()) {
      for (const double step : options.steps) {
        space::write_walled(table, kind, number, step, frames);
      }
      space::write_walled_exchange(table, kind, number, exchanged, frames);
    }
  }
}

#ifdef CGAL_LINKED_WITH_TBB

void write_threads(const Options& options, std::size_t n)
{
  const unsigned threads = options.threads > 0 ? options.threads : space::most_threads();
  if (threads < 2) {
    std::cout << "no threads: the machine has a single one\n";
    return;
  }
  const std::string title = std::to_string(n) + " points, " + std::to_string(threads) + " threads";
  common::Table anew = space::construction_table();
  anew.write_head(title + ", anew");
  space::write_construction_by_threads<space::In_open_space>(anew, "poisson", n, threads);
  space::write_construction_by_threads<space::In_periodic_space>(anew, "periodic", n, threads);
  common::Table table = space::thread_table();
  table.write_head(title);
  for (const double step : options.steps) {
    space::write_threads<space::In_open_space>(table, "poisson", n, step, threads,
                                               options.frames_of(n));
  }
  for (const double step : options.steps) {
    space::write_threads<space::In_periodic_space>(table, "periodic", n, step, threads,
                                                   options.frames_of(n));
  }
}

#else

void write_threads(const Options&, std::size_t)
{
  std::cout << "no threads: they need TBB\n";
}

#endif // CGAL_LINKED_WITH_TBB

bool run_space(const Options& options, const std::string& command)
{
  for (const std::size_t n : options.points) {
    common::Table out = space::outcome_table();
    out.write_head("out of " + std::to_string(n) + " points");
    space::write_out_of_it(out, n);
    write_frames(options, n);
    if (options.has_kind("threads")) {
      write_threads(options, n);
    }
    if (options.has_kind("periodic")) {
      write_periodic(options, n);
    }
    if (options.has_kind("walls") && n <= most_with_walls) {
      write_walls(options, n);
    }
  }
  std::cout << '\n' << command << std::endl;
  return true;
}

} // namespace

int main(int argc, char** argv)
{
  return common::run_program<Options>("space", argc, argv, add_options, run_space);
}

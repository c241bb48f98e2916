// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// What does an update of points in periodic space cost, next to an update in the plane, and to
// triangulating anew? The points diffuse in a periodic square. All contestants follow the same
// frames in one process, in turn, the order rotating, each with its own triangulation:
//
//   periodic  Dynamic_periodic_Delaunay_triangulation_2::update() of the wrapped points
//   plane     Dynamic_Delaunay_triangulation_2::update() of the same points, not wrapped: it has a
//             border instead of periodic space, and no point jumps
//   ghosts    triangulates the points and their images in a margin anew in the plane, by CGAL's
//             insertion one by one in the last frame's spatial order; periodic/Ghost_rebuild.h
//   CGAL      a new Periodic_2_Delaunay_triangulation_2, by its insertion of a range as a large
//             point set; in some of the frames, as it takes long
//
// Columns of the table, times in nanoseconds a point, ghosts not counted as points:
//   step      standard deviation of a coordinate's step in a frame, in mean spacings
//   q1, q3    quartiles of the column before, which is a median over the frames
//   worst     the slowest frame of the periodic update
//   p/plane, ghosts/p, CGAL/p   periodic over plane, the others over periodic: medians of the
//             ratios in a frame
//   flips, relocated, rebuilds  of the periodic update, means of a frame
//   copies    points and ghosts a point, mean
//
// A second table is of slabs, where the points diffuse between two walls: alone, and with walls
// that are rows of points, one of which slides.
//
// Time is that of the thread. Outside of the timing every update has to be certified; at the end of
// a case the periodic triangulation has to be valid and to have three edges for each point, and the
// one with ghosts has to have two faces for each point in the square. The first fault ends the
// program.

#include "common/Program.h"
#include "periodic/Channel_run.h"
#include "periodic/Periodic_cases.h"
#include "periodic/Periodic_output.h"
#include "periodic/Periodic_run.h"
#include "scenario_runner/Progress.h"

#include <CLI/CLI.hpp>

#include <cstddef>
#include <exception>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using namespace periodic;

void add_options(CLI::App& app, Periodic_options& options)
{
  // Among fewer points the margin of ghosts is wider than the square.
  constexpr int fewest_points = 100, most_points = 10'000'000, most_frames = 100'000;
  constexpr double smallest_step = 1e-9, largest_step = 1.0;
  app.description("Times updates in periodic space against updates in the plane and against "
                  "triangulating anew, on the same frames, in turn.");
  common::add_option(app, "--points", options.chosen_points, "N...",
                     "how many; default 1000 10000 100000", CLI::Range(fewest_points, most_points));
  common::add_option(app, "--steps", options.steps, "X...",
                     "of a coordinate in a frame, in spacings; default 0.001 0.01 0.03 0.1",
                     CLI::Range(smallest_step, largest_step));
  common::add_option(app, "--frames", options.frames, "N",
                     "timed ones of each case; default 600 to 40", CLI::Range(1, most_frames));
  common::add_option(app, "--repetitions", options.repetitions, "N",
                     "of each case, with other points, whose frames are taken together; default 1",
                     CLI::Range(1, most_frames));
  common::add_option(app, "--csv", options.csv, "FILE", "write every frame");
  app.add_flag("--quick", options.is_quick, "a first look, in some seconds");
}

Case_figures run_case(const Periodic_options& options, std::size_t points, double step)
{
  Case_figures figures{points, step};
  for (std::size_t seed = 1; seed <= options.repetitions; ++seed) {
    const Periodic_case wanted = periodic_case(options, points, step, seed);
    run::Progress_display progress(wanted.warm_up + wanted.frames, true);
    const std::vector<Frame_figures> frames =
        Periodic_run(wanted).run([&](std::size_t frame) { progress.show(frame); });
    figures.frames.insert(figures.frames.end(), frames.begin(), frames.end());
  }
  return figures;
}

bool run_periodic(const Periodic_options& options, const std::string& command)
{
  Case_table table(std::cout);
  std::vector<Case_figures> all;
  for (const std::size_t points : options.points()) {
    for (const double step : options.steps) {
      try {
        all.push_back(run_case(options, points, step));
      } catch (const std::exception& error) {
        throw std::runtime_error(std::to_string(points) + " points, step " +
                                 common::csv_cell(step) + ": " + error.what());
      }
      table.write_row(all.back());
    }
  }
  std::cout << "\nBetween the walls of a slab\n";
  Channel_table channels(std::cout);
  for (const std::size_t points : options.points()) {
    for (const double step : options.steps) {
      const std::size_t frames = periodic_case(options, points, step, 1).frames;
      channels.write_row(std::to_string(points) + ", " + common::csv_cell(step),
                         Channel_run(points, step, 1).run(frames));
    }
  }
  std::cout << '\n' << command << std::endl;
  if (!options.csv.empty()) {
    write_csv(options.csv, command, all);
  }
  return true;
}

} // namespace

int main(int argc, char** argv)
{
  return common::run_program<Periodic_options>("periodic", argc, argv, add_options, run_periodic);
}

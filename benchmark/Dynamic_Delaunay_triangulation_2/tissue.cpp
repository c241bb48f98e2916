// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Where does a tissue begin to flow? The self-propelled Voronoi model (Bi, Yang, Marchetti,
// Manning: Motility-driven glass and jamming transitions in biological tissues, Physical Review X
// 6, 021011, 2016), as the example voronoi_tissue has it, for a range of preferred perimeters p0.
// In the source a tissue of slow cells is a glass below p0 = 3.81, and a fluid above.
//
// Columns of the table, means over the seeds:
//   msd      mean squared displacement over the whole time, without the drift of all cells
//   to cage  the same, relative to the mean of the cells that were neighbors at the start
//   staying  share of cells within half a unit of where they were, in the end
//   D_eff    diffusivity in the second half of the time, over that of a cell that crawls alone;
//            a fluid is here what has 0.001 or more
//   least, most  of that, over the seeds
//   T1 rate  new pairs of neighbors, per cell and unit of time, counted in every step
//   shape    perimeter over the square root of the area, mean over cells and time
//   rebuilds of the triangulation
//
// Every step has to be certified; the first fault ends the program.

#include "common/Program.h"
#include "tissue/Tissue_output.h"
#include "tissue/Tissue_sweep.h"

#include <CLI/CLI.hpp>

#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

namespace {

using namespace tissue;

void add_options(CLI::App& app, Sweep_options& options)
{
  constexpr int fewest_cells = 10, most_cells = 1'000'000, most_seeds = 1000;
  constexpr double smallest = 1e-6, largest = 1e9;
  app.description("Finds the preferred perimeter at which the cells of a tissue begin to flow.");
  common::add_option(app, "--shapes", options.shapes, "X...",
                     "preferred perimeters p0, ascending; default eleven from 3.5 to 4",
                     CLI::Range(3.0, 5.0));
  common::add_option(app, "--cells", options.cells, "N", "how many; default 400",
                     CLI::Range(fewest_cells, most_cells));
  common::add_option(app, "--speed", options.speed, "X", "of a cell by itself; default 0.1",
                     CLI::Range(smallest, largest));
  common::add_option(app, "--time", options.time, "T", "that is observed; default 3000",
                     CLI::Range(smallest, largest));
  common::add_option(app, "--settling", options.settling, "T", "the time before that; default 1000",
                     CLI::Range(0.0, largest));
  common::add_option(app, "--time-step", options.time_step, "T", "default 0.1",
                     CLI::Range(smallest, largest));
  common::add_option(app, "--seeds", options.seeds, "N", "runs of each shape, from 1; default 4",
                     CLI::Range(1, most_seeds));
  common::add_option(app, "--output", options.output, "DIR",
                     "where tissue.csv and motion.csv go; default build/dev/bench/tissue");
  app.add_flag("--quick", options.is_quick, "a first look, in some seconds");
}

bool run_tissue(Sweep_options& options, const std::string& command)
{
  if (options.is_quick) {
    options.be_quick();
  }
  std::filesystem::create_directories(options.output);
  Shape_table table(std::cout);
  std::vector<Shape_record> records;
  for (const double shape : options.shapes) {
    records.push_back(observe_shape(options, shape));
    table.write_row(records.back());
  }
  if (const auto shape = transition(records)) {
    std::cout << "\nD_eff passes " << fluid_diffusivity << " at p0 = " << *shape << '\n';
  }
  std::cout << '\n' << command << std::endl;
  write_csv(options, command, records);
  return records.back().diffusivity() > records.front().diffusivity() || records.size() == 1;
}

} // namespace

int main(int argc, char** argv)
{
  return common::run_program<Sweep_options>("tissue", argc, argv, add_options, run_tissue);
}

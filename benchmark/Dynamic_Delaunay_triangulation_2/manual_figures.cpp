// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Draws the figures of the user manual, from what the package does in runs of the scenarios; no
// figure is drawn by hand. Each of them is a deterministic function of the scenario file, so the
// same code draws the same picture. `--output doc/Dynamic_Delaunay_triangulation_2/fig` renews
// those of the manual:
//
//   sets.svg          the Classified, Padded and Border sets of a frame of the dam break
//   detail.svg        the same, as small as the picture of the package in an overview is
//   splice.svg        a border splice, before, in between and after
//   safe_edge.svg     an edge that is safe, and its annulus
//   tolerances.svg    how far vertices may go before an edge has to be looked at
//   motion.svg        the dam break with few points, moving
//   cells_in_domain.svg  a Voronoi cell in a hall with walls, by three rules
//   space.svg         tetrahedra that a frame removes and makes, in a section
//   glass.svg         the same of a sheared glass in periodic space

#include "common/Program.h"
#include "manual_figures/Domain_figure.h"
#include "manual_figures/Glass_figure.h"
#include "manual_figures/Motion_figure.h"
#include "manual_figures/Safety_figures.h"
#include "manual_figures/Set_figures.h"
#include "manual_figures/Space_figure.h"
#include "scenario_runner/Output_file.h"

#include <CLI/CLI.hpp>

#include <filesystem>
#include <iostream>
#include <string>

namespace {

void write(const run::Output_directory& directory, const std::string& name, const std::string& svg)
{
  run::Output_file file(directory.path_of(name));
  file.stream() << svg;
  file.finish();
  std::cout << directory.path_of(name) << '\n';
}

void draw_all(const std::string& path)
{
  using namespace manual_figures;
  const run::Output_directory directory(path);
  const Panel sets = draw_sets(300);
  write(directory, "sets.svg", svg_of({&sets}));
  write(directory, "detail.svg", svg_of({&sets}, 0.2));
  write(directory, "splice.svg", Splice_figure::draw());
  const Safety_figures safety(600);
  write(directory, "safe_edge.svg", safety.draw_edge());
  write(directory, "tolerances.svg", safety.draw_tolerances(16));
  write(directory, "motion.svg", Motion_figure::draw(180, 36, 30));
  write(directory, "cells_in_domain.svg", Domain_figure::draw());
  write(directory, "space.svg", Space_figure::draw(500, 20));
  write(directory, "glass.svg", Glass_figure(5).draw());
}

} // namespace

int main(int argc, char** argv)
{
  const auto add_options = [](CLI::App& app, std::string& output) {
    app.description("Draws the figures of the user manual.");
    output = (std::filesystem::path(RESULTS_DIR) / "manual_figures").string();
    app.add_option("--output", output, "The directory to write them to")->capture_default_str();
  };
  const auto draw = [](const std::string& output, const std::string&) {
    draw_all(output);
    return true;
  };
  return common::run_program<std::string>("manual_figures", argc, argv, add_options, draw);
}

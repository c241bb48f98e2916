// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "scenario_runner/Run_options.h"

#include "scenario_runner/Command_line.h"
#include "scenario_runner/Open_motion.h"
#include "scenario_runner/Output_file.h"

#include <CGAL/Dynamic_Delaunay_triangulation_2/version.h>

#include <cstdint>
#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

namespace run {

namespace {

constexpr std::size_t max_frames = 1'000'000'000;

void add_method_options(CLI::App& app, Run_options& options)
{
  constexpr unsigned max_padding = 100;
  constexpr unsigned max_threads = 1024;
  add_option(app, "--classifier", "NAME[:PARAMETER]",
             "what finds the vertices to mend: " + classifier_list() + "; default circumcircle",
             [&](const std::string& text) { options.classifier = classifier_choice(text); });
  app.add_option("--padding", options.padding,
                 "layers of neighbors around the classified vertices; default 1")
      ->type_name("N")
      ->transform(whole_number(0, max_padding));
  app.add_option("--repair", options.repair,
                 "what mends; default hold_and_flip, with a heuristic classifier but "
                 "nearly_delaunay splice")
      ->type_name("NAME")
      ->check(CLI::IsMember(repair_names()));
  add_option(app, "--policy", "NAME[:PARAMETER]",
             "which frames are rebuilt instead: " + policy_list() + "; default always_dynamic",
             [&](const std::string& text) { options.policy = policy_choice(text); });
  app.add_option("--engine", options.engine,
                 "what triangulates anew, everything or a region; default " + options.engine)
      ->type_name("NAME")
      ->check(CLI::IsMember(engine_names()));
  app.add_option("--threads", options.threads, "threads that keep the triangulation; default 1")
      ->type_name("N")
      ->transform(whole_number(1, max_threads));
}

void add_motion_options(CLI::App& app, Run_options& options)
{
  scenario::Overrides& overrides = options.overrides;
  add_option(
      app, "--columns", "LIST",
      "what the columns of a table are, where their names do not tell: frame, time, id, x, y and "
      "z in their order and a dash for any other, as frame,id,-,x,y; or with their titles, as "
      "frame=t,id=label",
      [&](const std::string& text) { options.columns = scenario::table_columns(text); });
  app.add_option("--dimension", options.dimension,
                 "2 for the plane: of a recording in space x and y are taken alone; 3 for space; "
                 "default 3 if z is there and differs, else 2")
      ->type_name("2|3")
      ->check(CLI::IsMember({2, 3}));
  app.add_option("--frames", options.frames,
                 "frames after the first one; default what the scenario says")
      ->type_name("N")
      ->transform(whole_number(0, max_frames));
  app.add_option("--points", overrides.points, "points that the scenario is scaled to")
      ->type_name("N")
      ->transform(whole_number(1, scenario::max_points));
  app.add_option("--time-step", overrides.time_step,
                 "motion between two frames; small ones are the favorable ones")
      ->type_name("F")
      ->check(number(scenario::positive_up_to(scenario::largest_time_step)));
  app.add_option_function<std::string>(
         "--packing",
         [&](const std::string& name) {
           overrides.packing =
               name == "square" ? scenario::Packing::square : scenario::Packing::hexagonal;
         },
         "first places of the points")
      ->type_name("NAME")
      ->check(CLI::IsMember({"square", "hexagonal"}));
  app.add_option("--seed", overrides.seed, "seed of the scenario and of the random classifier")
      ->type_name("N")
      ->transform(whole_number(0, (std::numeric_limits<std::uint64_t>::max)()));
}

void add_output_options(CLI::App& app, Run_options& options)
{
  app.add_option("--report", options.report, "write what came out, as one JSON object")
      ->type_name("FILE.json");
  app.add_option("--csv", options.csv, "write a row for each frame")->type_name("FILE.csv");
  app.add_option("--svg", options.svg,
                 "draw about 30 frames: classified vertices red, padded green, border cyan; "
                 "index.html shows them one after another")
      ->type_name("DIR");
  app.add_option("--html", options.html,
                 "write all frames as one page that plays them in any browser, without a network")
      ->type_name("FILE.html");
  app.add_option("--vtk", options.vtk,
                 "write about 30 frames for ParaView: triangles, or in space tetrahedra, in .vtu "
                 "files, all times in "
                 "frames.pvd")
      ->type_name("DIR");
  app.add_option("--xyz", options.xyz, "write the points of all frames as extended XYZ")
      ->type_name("FILE.xyz");
  app.add_option("--lammps", options.lammps,
                 "write the points of all frames as a LAMMPS dump, which can be run again")
      ->type_name("FILE.lammpstrj");
  app.add_option("--cells", options.cells,
                 "write the Voronoi cells of all frames, a row for each point: area, density, "
                 "perimeter, contacts, free length and length on walls; needs --radius, --domain "
                 "or both; in space volume, density, surface area and contacts, in the scenario's "
                 "box or whole")
      ->type_name("FILE.csv");
  app.add_option("--radius", options.radius, "where the cells of --cells end around their points")
      ->type_name("R")
      ->check(number(scenario::positive_up_to(1e100)));
  app.add_option("--domain", options.domain,
                 "the polygon, perhaps with holes, in which the cells of --cells are, as "
                 "well-known text or GeoJSON")
      ->type_name("FILE.wkt|FILE.geojson");
  add_option(app, "--cell-rule", "whole|connected|visible",
             "what counts of a cell that walls of --domain divide: all of it, what is connected "
             "with the point, or what is in line of sight from it; default whole",
             [&](const std::string& name) { options.cell_rule = cell_rule(name); });
  app.add_option("--every", options.every,
                 "every N-th frame and the last one for --svg, --html, --vtk, --xyz, --lammps and "
                 "--cells")
      ->type_name("N")
      ->transform(whole_number(1, max_frames));
  app.add_flag("--quiet", options.quiet, "no progress, no table");
}

bool is_one_file(const std::filesystem::path& a, const std::filesystem::path& b)
{
  std::error_code ignored;
  return a.lexically_normal() == b.lexically_normal() || std::filesystem::equivalent(a, b, ignored);
}

// Two outputs must not write the same file, and none may replace the recording. Tables of ids are
// written only if ids are text, which is not known yet.
void check_files(const Run_options& options)
{
  std::vector<std::pair<std::string, std::string>> files;
  std::error_code ignored;
  if (std::filesystem::is_regular_file(options.scenario, ignored)) {
    files.emplace_back("SCENARIO", options.scenario);
  }
  if (options.domain) {
    files.emplace_back("--domain", *options.domain);
  }
  const auto ids_of = [](const std::optional<std::string>& file) {
    return file ? std::optional(id_table_of(*file)) : std::nullopt;
  };
  for (const auto& [name, file] :
       {std::pair("--report", options.report), std::pair("--csv", options.csv),
        std::pair("--html", options.html), std::pair("--xyz", options.xyz),
        std::pair("the table of ids of --xyz", ids_of(options.xyz)),
        std::pair("--lammps", options.lammps),
        std::pair("the table of ids of --lammps", ids_of(options.lammps)),
        std::pair("--cells", options.cells)}) {
    if (!file) {
      continue;
    }
    for (const auto& [other_name, other_file] : files) {
      if (is_one_file(*file, other_file)) {
        throw CLI::ValidationError(name, "is the file of " + other_name + " too");
      }
    }
    files.emplace_back(name, *file);
  }
}

void check_every(const Run_options& options)
{
  if (options.every && !options.svg && !options.html && !options.vtk && !options.xyz &&
      !options.lammps && !options.cells) {
    throw CLI::ValidationError("--every", "chooses frames for --svg, --html, --vtk, --xyz, "
                                          "--lammps or --cells, and none of them is there");
  }
}

void check_cells(const Run_options& options)
{
  if (!options.cells && (options.radius || options.domain)) {
    throw CLI::ValidationError(options.radius ? "--radius" : "--domain",
                               "says where the cells of --cells end, and it is not there");
  }
  if (options.cell_rule && !options.domain) {
    throw CLI::ValidationError("--cell-rule", "says what counts of a cell that walls of --domain "
                                              "divide, and it is not there");
  }
  if (options.cells && !options.classifier.is_exact) {
    throw CLI::ValidationError("--cells", "needs an exact classifier, and " +
                                              options.classifier.text() + " is heuristic");
  }
}

} // namespace

std::optional<Run_options> parse_options(int argc, const char* const* argv)
{
  Run_options options;
  CLI::App app("Runs a scenario, keeps its Delaunay triangulation, checks every frame, and "
               "compares the time with fresh triangulations.",
               "run_scenario");
  app.add_option("SCENARIO", options.scenario,
                 "a scenario; or a " + scenario::motion_extensions +
                     " file, also followed by .gz, or any LAMMPS dump; or - for a recording from "
                     "standard input; default dam_break")
      ->type_name("");
  add_method_options(app, options);
  add_motion_options(app, options);
  add_output_options(app, options);
  app.set_version_flag("--version", "run_scenario " CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_VERSION);
  app.footer("Scenarios: " + scenario::joined(scenario::known_scenarios()) + "; in space " +
             scenario::joined(scenario::known_scenarios_3()) +
             "\nHow to write one, and which recordings are read: "
             "doc/Dynamic_Delaunay_triangulation_2/Scenario_files.txt");
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& help_or_version) {
    app.exit(help_or_version);
    return std::nullopt;
  }
  for (const char* const name : {"--classifier", "--padding", "--repair", "--engine", "--packing",
                                 "--svg", "--html", "--radius", "--domain", "--cell-rule"}) {
    if (app.count(name) != 0) {
      options.given_for_plane.emplace_back(name);
    }
  }
  check_files(options);
  check_every(options);
  check_cells(options);
  return options;
}

} // namespace run

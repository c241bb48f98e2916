// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Is an update ever slower than triangulating anew? For motions of all kinds, from calm ones to the
// worst that we could think of, every frame is updated, and triangulated anew in three ways: by
// CGAL's insertion of the range, by its insertion in the spatial order of the frame before, and by
// its insertion in the spatial order of this frame, which is found while the clock runs; see
// common/Fastest_static.h. The ratio of a frame is the time of the update over that of the fastest
// of these three. Time is that of the thread.
//
// A sequence that seems slow, by its median or by a single frame, is repeated up to twice, and the
// smallest ratio of each frame counts. A frame of more than two seconds is the last one of its
// sequence.
//
// Columns of the table:
//   median, worst     ratios of the frames: below 1 the update is faster
//   dynamic, static   medians, in nanoseconds a point
//   rebuilds          frames whose update triangulated anew
//   relocated, flips, splices   means of a frame
//
// Outside of the timing every frame has to be certified. Up to 10000 points each also has to be
// valid, and to have the edges of a fresh triangulation. The first fault ends the program.
//
// A kind of frames is a program of one line, made of a base cloud and motions; see
// random_operations/Program.h. --program runs one program. --adversary draws programs at random and
// searches for slower ones among variations of the slowest.

#include "any_motion/Adversary.h"
#include "any_motion/Kinds.h"
#include "any_motion/Sequence_output.h"
#include "any_motion/Tasks.h"
#include "common/Program.h"
#include "scenario_runner/Open_motion.h"

#include <CLI/CLI.hpp>

#include <cstddef>
#include <iostream>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using namespace any_motion;

void add_options(CLI::App& app, Any_motion_options& options)
{
  constexpr int min_points = 10, max_points = 10'000'000, max_frames = 100'000;
  constexpr double shortest = (std::numeric_limits<double>::min)(), longest = 1e6;
  app.description("Times updates against the fastest static way, frame by frame, for motions of "
                  "all kinds, and compares what comes out.");
  common::add_option(app, "--points", options.chosen_points, "N...",
                     "how many; default 1000 10000 100000", CLI::Range(min_points, max_points));
  common::add_option(app, "--frames", options.frames, "N",
                     "measured ones of each kind; default 16 to 8, of recordings 200",
                     CLI::Range(1, max_frames));
  common::add_option(app, "--seed", options.seed, "N", "what is drawn by chance; default 1");
  common::add_repeated(app, "--kind", options.kinds, "TEXT",
                       "only kinds with this in their names; may be repeated");
  app.add_option("--only", options.only, "kinds or recorded; default both")
      ->check(CLI::IsMember({"kinds", "recorded"}));
  common::add_option(app, "--recorded", options.recorded, "DIR", "where recorded motion is");
  common::add_option(app, "--csv", options.csv, "FILE", "write every frame");
  common::add_option(app, "--program", options.program, "TEXT",
                     "run this one, and show its frames");
  common::add_option(app, "--adversary", options.adversary, "SECONDS",
                     "look for slow programs by chance for so long", CLI::Range(shortest, longest));
  common::add_repeated(app, "--without", options.left_out, "MOTION",
                       "a motion that the adversary leaves out; may be repeated",
                       CLI::IsMember(names_of(all_motions())));
  app.add_flag("--quick", options.is_quick,
               "only check: every frame, nothing is repeated, and no recordings by default");
  app.add_flag("--list", options.is_list, "the kinds and the parts of programs");
}

std::vector<Task> chosen_tasks(const Any_motion_options& options)
{
  std::vector<Task> tasks;
  if (options.has_kinds()) {
    tasks = kind_tasks(options);
  }
  if (options.has_recordings()) {
    const std::vector<Task> recorded = recorded_tasks(options);
    tasks.insert(tasks.end(), recorded.begin(), recorded.end());
  }
  if (tasks.empty()) {
    throw std::runtime_error("there are no such frames; --list lists the kinds");
  }
  return tasks;
}

void run_tasks(const Any_motion_options& options, const std::string& command)
{
  const std::vector<Task> tasks = chosen_tasks(options);
  Sequence_table table(std::cout);
  std::vector<Sequence_figures> all;
  for (const Task& task : tasks) {
    all.push_back(run_task(task, settings_of(options)));
    table.write_row(all.back());
  }
  table.write_summary(all);
  std::cout << '\n' << command << std::endl;
  if (!options.csv.empty()) {
    write_csv(options.csv, command, all);
  }
}

void run_program(const Any_motion_options& options)
{
  const Program program = program_in(options.program);
  for (const std::size_t points : options.points()) {
    const Task task = program_task(text_of(program), "", program, points,
                                   measured_frames(options, points), options.seed);
    write_frames(std::cout, run_task(task, settings_of(options)));
  }
}

void list_kinds()
{
  for (const Kind& kind : all_kinds()) {
    std::cout << kind.name << ": " << kind.is << "\n  " << kind.program << '\n';
  }
  std::cout << "\nBases of programs\n";
  for (const Base_cloud& base : all_base_clouds()) {
    std::cout << "  " << base.name << ": " << base.is << '\n';
  }
  std::cout << "\nMotions of programs\n";
  for (const Motion& motion : all_motions()) {
    std::cout << "  " << motion.name << ": " << motion.does << '\n';
  }
}

bool run_any_motion(const Any_motion_options& options, const std::string& command)
{
  if (options.is_list) {
    list_kinds();
  } else if (!options.program.empty()) {
    run_program(options);
  } else if (options.adversary > 0.0) {
    Adversary(options, std::cout).run(options.adversary);
  } else {
    run_tasks(options, command);
  }
  return true;
}

} // namespace

int main(int argc, char** argv)
{
  return common::run_program<Any_motion_options>("any_motion", argc, argv, add_options,
                                                 run_any_motion);
}

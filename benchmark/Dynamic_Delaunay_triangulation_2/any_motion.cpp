// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Is an update ever slower than triangulating anew? For motions of all kinds, calm ones and the
// worst that we could think of, every frame is updated, and triangulated anew in three ways:
// CGAL's insertion of the range, its insertion in the spatial order of the frame before, and in
// that of this frame, found while the clock runs; any_motion/Fastest_static.h. The ratio of a
// frame is the time of the update over that of the fastest of these three. Time is that of the
// thread.
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
// A kind of frames is a program of one line, any_motion/Program.h, of a base cloud and motions.
// --program runs one, and --adversary puts them together by chance and goes on from the slowest.

#include "any_motion/Adversary.h"
#include "any_motion/Any_motion_options.h"
#include "any_motion/Frames_csv.h"
#include "any_motion/Frames_table.h"
#include "any_motion/Kinds.h"
#include "any_motion/Program.h"
#include "any_motion/Sequence_table.h"
#include "any_motion/Tasks.h"
#include "results/Command.h"

#include <CLI/CLI.hpp>

#include <cstddef>
#include <exception>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using namespace any_motion;

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
  table.write_head();
  std::vector<Sequence_figures> all;
  for (const Task& task : tasks) {
    all.push_back(run_task(task, settings_of(options)));
    table.write_row(all.back());
  }
  table.write_summary(all);
  std::cout << '\n' << command << std::endl;
  if (options.csv) {
    write_csv(*options.csv, command, all);
  }
}

void run_program(const Any_motion_options& options)
{
  const std::string text = text_of(*options.program);
  for (const std::size_t points : options.points()) {
    const Task task = program_task(text, "", *options.program, points,
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

void run_any_motion(const Any_motion_options& options, const std::string& command)
{
  if (options.is_list) {
    list_kinds();
  } else if (options.program) {
    run_program(options);
  } else if (options.adversary) {
    Adversary(options, std::cout).run(*options.adversary);
  } else {
    run_tasks(options, command);
  }
}

} // namespace

int main(int argc, char** argv)
{
  CLI::App app("", "any_motion");
  try {
    run_any_motion(parse_options(app, argc, argv), results::command_of("any_motion", argc, argv));
    return 0;
  } catch (const CLI::ParseError& error) { // or help
    return app.exit(error);
  } catch (const std::exception& error) {
    std::cerr << "any_motion: " << error.what() << std::endl;
    return 1;
  }
}

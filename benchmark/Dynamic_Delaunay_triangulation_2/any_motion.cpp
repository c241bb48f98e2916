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
// --adversary puts such programs together by chance, and goes on from the slowest.

#include "any_motion/Any_motion_options.h"
#include "any_motion/Frames_csv.h"
#include "any_motion/Kinds.h"
#include "any_motion/Program_frames.h"
#include "any_motion/Sequence_run.h"
#include "any_motion/Sequence_table.h"
#include "any_motion/Status_line.h"
#include "results/Command.h"
#include "scenario/Open_motion.h"

#include <CLI/CLI.hpp>

#include <cstddef>
#include <exception>
#include <filesystem>
#include <functional>
#include <iostream>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using namespace any_motion;

// A sequence that is still to be made.
struct Task
{
  std::string kind;
  std::string group;
  std::size_t points; // 0 if the recording says it
  std::function<scenario::Recording()> frames;
};

std::size_t usual_frames(std::size_t points)
{
  return points < 100'000 ? 16 : 8;
}

std::vector<Task> kind_tasks(const Any_motion_options& options, const Sequence_settings& settings)
{
  std::vector<Task> tasks;
  for (const Kind& kind : all_kinds()) {
    for (const std::size_t points : options.points()) {
      if (options.wants(kind.name) && kind.has(points)) {
        const std::size_t frames =
            1 + settings.warm_up + options.frames.value_or(usual_frames(points));
        tasks.push_back(
            {kind.name, kind.group, points, [=, seed = options.seed] {
               return Program_frames(program_in(kind.program), points, seed).record(frames);
             }});
      }
    }
  }
  return tasks;
}

scenario::Recording first_frames(const std::string& path, std::size_t frames)
{
  const auto motion = scenario::open_motion(path);
  scenario::Recording recording;
  do {
    recording.push_back({motion->time(), motion->ids(), motion->points()});
  } while (recording.size() != frames && motion->advance({}));
  return recording;
}

std::vector<Task> recorded_tasks(const Any_motion_options& options,
                                 const Sequence_settings& settings)
{
  constexpr std::size_t usual_recorded_frames = 200;
  const std::size_t frames = 1 + settings.warm_up + options.frames.value_or(usual_recorded_frames);
  std::vector<Task> tasks;
  for (const std::string& path : scenario::recordings_in(options.recorded)) {
    const std::string name = "recorded_" + std::filesystem::path(path).stem().string();
    if (options.wants(name)) {
      tasks.push_back({name, "recorded", 0, [=] { return first_frames(path, frames); }});
    }
  }
  return tasks;
}

Sequence_settings settings_of(const Any_motion_options& options)
{
  Sequence_settings settings;
  if (options.is_quick) {
    settings.repetitions = 0;
    settings.most_checked_points = std::numeric_limits<std::size_t>::max();
  }
  return settings;
}

Sequence_figures run_task(const Task& task, const Sequence_settings& settings)
{
  const Status_line status(task.kind + ", " + std::to_string(task.points) + " points");
  try {
    Sequence_figures figures = measured(task.frames(), settings);
    figures.kind = task.kind;
    figures.group = task.group;
    return figures;
  } catch (const std::exception& error) {
    const std::string size = task.points == 0 ? "" : ", " + std::to_string(task.points) + " points";
    throw std::runtime_error(task.kind + size + ", " + error.what());
  }
}

void run_tasks(const Any_motion_options& options, const std::string& command)
{
  const Sequence_settings settings = settings_of(options);
  std::vector<Task> tasks;
  if (options.has_kinds()) {
    tasks = kind_tasks(options, settings);
  }
  if (options.has_recordings()) {
    const std::vector<Task> recorded = recorded_tasks(options, settings);
    tasks.insert(tasks.end(), recorded.begin(), recorded.end());
  }
  if (tasks.empty()) {
    throw std::runtime_error("there is no such kind; --list lists them");
  }
  Sequence_table table(std::cout);
  table.write_head();
  std::vector<Sequence_figures> all;
  for (const Task& task : tasks) {
    all.push_back(run_task(task, settings));
    table.write_row(all.back());
  }
  table.write_summary(all);
  std::cout << '\n' << command << std::endl;
  if (options.csv) {
    write_csv(*options.csv, command, all);
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

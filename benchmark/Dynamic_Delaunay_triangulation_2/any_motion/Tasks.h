// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ANY_MOTION_TASKS_H
#define ANY_MOTION_TASKS_H

#include "../random_operations/Program_frames.h"
#include "Kinds.h"
#include "scenario_runner/Open_motion.h"
#include "scenario_runner/Progress.h"
#include "Sequence_run.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <filesystem>
#include <functional>
#include <iostream>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

namespace any_motion {

using namespace random_operations;

// The options of the command line.
struct Any_motion_options
{
  std::vector<std::size_t> chosen_points{};
  std::size_t frames = 0; // 0: as many as are usual
  std::uint64_t seed = 1;
  std::vector<std::string> kinds{};
  std::string only{};
  std::string recorded = scenario::recordings_directory();
  std::string csv{};      // empty: none
  std::string program{};  // empty: all kinds
  double adversary = 0.0; // seconds; 0: none
  std::vector<std::string> left_out{};
  bool is_quick = false;
  bool is_list = false;

  std::vector<std::size_t> points() const
  {
    if (!chosen_points.empty()) {
      return chosen_points;
    }
    return !program.empty() || adversary > 0.0 ? std::vector<std::size_t>{1'000}
                                               : std::vector<std::size_t>{1'000, 10'000, 100'000};
  }

  std::size_t frames_or(std::size_t usual) const { return frames == 0 ? usual : frames; }

  bool has_kinds() const { return only != "recorded"; }
  bool has_recordings() const { return only == "recorded" || (only.empty() && !is_quick); }

  bool wants(const std::string& kind) const
  {
    return kinds.empty() || std::any_of(kinds.begin(), kinds.end(), [&](const auto& part) {
             return kind.find(part) != std::string::npos;
           });
  }
};

// A line of progress on a terminal, which is erased when this is destroyed.
class Status_line
{
public:
  explicit Status_line(const std::string& text)
  {
    if (run::stderr_is_a_terminal()) {
      std::cerr << "\r\033[K" << text << std::flush;
    }
  }
  Status_line(const Status_line&) = delete;
  Status_line& operator=(const Status_line&) = delete;

  ~Status_line()
  {
    if (run::stderr_is_a_terminal()) {
      std::cerr << "\r\033[K" << std::flush;
    }
  }
};

// A sequence of frames that is still to be made.
struct Task
{
  std::string kind;
  std::string group;
  std::string points; // as text, empty if the recording says it
  std::function<scenario::Recording()> frames;
};

inline Sequence_settings settings_of(const Any_motion_options& options)
{
  Sequence_settings settings;
  if (options.is_quick) {
    settings.repetitions = 0;
    settings.max_checked_points = (std::numeric_limits<std::size_t>::max)();
  }
  return settings;
}

inline std::size_t measured_frames(const Any_motion_options& options, std::size_t points)
{
  return options.frames_or(points < 100'000 ? 16 : 8);
}

// `frames` are measured ones.
inline Task program_task(const std::string& name, const std::string& group, const Program& program,
                         std::size_t points, std::size_t frames, std::uint64_t seed)
{
  return {name, group, std::to_string(points), [=] {
            return Program_frames(program, points, seed)
                .record(1 + Sequence_settings().warm_up + frames);
          }};
}

inline std::vector<Task> kind_tasks(const Any_motion_options& options)
{
  std::vector<Task> tasks;
  for (const Kind& kind : all_kinds()) {
    for (const std::size_t points : options.points()) {
      if (options.wants(kind.name) && kind.has(points)) {
        tasks.push_back(program_task(kind.name, kind.group, program_in(kind.program), points,
                                     measured_frames(options, points), options.seed));
      }
    }
  }
  return tasks;
}

// `frames` frames from the middle, where most points exist; all if there are fewer frames.
inline scenario::Recording middle_frames(const std::string& path, std::size_t frames)
{
  const auto motion = scenario::open_motion(path);
  const std::size_t all = motion->frames() + 1;
  for (std::size_t i = 0; i < (all - (std::min)(all, frames)) / 2; ++i) {
    motion->advance({});
  }
  scenario::Recording recording;
  do {
    recording.push_back({motion->time(), motion->ids(), motion->points()});
  } while (recording.size() != frames && motion->advance({}));
  return recording;
}

inline std::vector<Task> recorded_tasks(const Any_motion_options& options)
{
  constexpr std::size_t usual_frames = 200;
  const std::size_t frames = 1 + Sequence_settings().warm_up + options.frames_or(usual_frames);
  std::vector<Task> tasks;
  for (const std::string& path : scenario::recordings_in(options.recorded)) {
    const std::string name = "recorded_" + std::filesystem::path(path).stem().string();
    if (options.wants(name)) {
      tasks.push_back({name, "recorded", "", [=] { return middle_frames(path, frames); }});
    }
  }
  return tasks;
}

// \throws std::runtime_error that names the task if anything is wrong.
inline Sequence_figures run_task(const Task& task, const Sequence_settings& settings)
{
  const std::string name = task.kind + (task.points.empty() ? "" : ", " + task.points + " points");
  const Status_line status(name);
  try {
    Sequence_figures figures = measured(task.frames(), settings);
    figures.kind = task.kind;
    figures.group = task.group;
    return figures;
  } catch (const std::exception& error) {
    throw std::runtime_error(name + ", " + error.what());
  }
}

} // namespace any_motion

#endif // ANY_MOTION_TASKS_H

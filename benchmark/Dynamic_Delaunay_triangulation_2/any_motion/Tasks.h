// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ANY_MOTION_TASKS_H
#define ANY_MOTION_TASKS_H

#include "Any_motion_options.h"
#include "Kinds.h"
#include "Program_frames.h"
#include "scenario_runner/Open_motion.h"
#include "Sequence_run.h"
#include "Status_line.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <filesystem>
#include <functional>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

namespace any_motion {

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
  return options.frames.value_or(points < 100'000 ? 16 : 8);
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

// So many from the middle, where most points are there; all if there are not so many.
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
  const std::size_t frames =
      1 + Sequence_settings().warm_up + options.frames.value_or(usual_frames);
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

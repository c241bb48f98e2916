// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ANY_MOTION_PROGRAM_FRAMES_H
#define ANY_MOTION_PROGRAM_FRAMES_H

#include "Program.h"
#include "scenario_runner/Recorded_motion.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace any_motion {

// Lets a program run.
class Program_frames
{
public:
  Program_frames(const Program& program, std::size_t points, std::uint64_t seed)
    : m_program(program)
    , m_random(seed)
  {
    base_cloud(program.base).make(m_cloud, points, m_random);
    for (const Step& step : program.steps) {
      m_steps.push_back({step, motion_named(step.motion), {step.amount, step.choice}, {}});
    }
  }

  // The first frame is the base cloud.
  scenario::Recording record(std::size_t frames)
  {
    scenario::Recording recording;
    recording.push_back(frame(0));
    for (std::size_t i = 1; i < frames; ++i) {
      advance(i);
      recording.push_back(frame(i));
    }
    return recording;
  }

private:
  struct Running_step
  {
    Step step;
    Motion motion;
    Selection selection;
    Memory memory;
  };

  void advance(std::size_t frame)
  {
    for (Running_step& running : m_steps) {
      if (frame % running.step.every == 0) {
        const Places& chosen = running.selection.choose(m_cloud, m_random);
        running.motion.move({m_cloud, chosen, running.step.size, m_random, running.memory});
        ++running.memory.calls;
      }
    }
  }

  scenario::Recorded_frame frame(std::size_t number) const
  {
    scenario::Recorded_frame result{static_cast<double>(number), m_cloud.ids(), {}};
    for (const Point& point : m_cloud.points) {
      result.points.push_back(
          {kept(m_program.scale_x * point.x), kept(m_program.scale_y * point.y)});
    }
    return result;
  }

  // What is too far away for the package, or nowhere, is put to where it can be.
  static double kept(double value)
  {
    constexpr double limit = 1e153;
    return std::isnan(value) ? 0.0 : (std::max)(-limit, (std::min)(limit, value));
  }

  Program m_program;
  Random m_random;
  Cloud m_cloud;
  std::vector<Running_step> m_steps;
};

} // namespace any_motion

#endif // ANY_MOTION_PROGRAM_FRAMES_H

// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef RANDOM_OPERATIONS_PROGRAM_FRAMES_H
#define RANDOM_OPERATIONS_PROGRAM_FRAMES_H

#include "Program.h"
#include "scenario_runner/Recorded_motion.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace random_operations {

// Which points a step moves.
class Selection
{
public:
  Selection(const Amount& amount, Choice choice)
    : m_amount(amount)
    , m_choice(choice)
  {
  }

  // Chooses the points of this frame.
  const Indices& choose(const Cloud& cloud, Decisions& decisions)
  {
    const std::size_t wanted = m_amount.of(cloud.size());
    if (m_choice == Choice::FIXED) {
      choose_fixed(wanted, cloud, decisions);
    } else if (m_choice == Choice::DISC) {
      choose_disc(wanted, cloud, decisions);
    } else {
      choose_random(wanted, cloud, decisions);
    }
    return m_chosen;
  }

private:
  void choose_random(std::size_t wanted, const Cloud& cloud, Decisions& decisions)
  {
    if (m_all.size() != cloud.size()) {
      m_all.resize(cloud.size());
      std::iota(m_all.begin(), m_all.end(), std::size_t(0));
    }
    for (std::size_t i = 0; i != wanted; ++i) {
      std::swap(m_all[i], m_all[i + decisions.below(m_all.size() - i)]);
    }
    m_chosen.assign(m_all.begin(), m_all.begin() + static_cast<std::ptrdiff_t>(wanted));
  }

  void choose_fixed(std::size_t wanted, const Cloud& cloud, Decisions& decisions)
  {
    if (m_is_first) {
      choose_random(wanted, cloud, decisions);
      for (const std::size_t place : m_chosen) {
        m_fixed.push_back(cloud.ids()[place]);
      }
      m_is_first = false;
    }
    m_chosen.clear();
    for (const Id id : m_fixed) {
      if (const auto index = cloud.index(id)) {
        m_chosen.push_back(*index);
      }
    }
  }

  void choose_disc(std::size_t wanted, const Cloud& cloud, Decisions& decisions)
  {
    m_chosen.resize(cloud.size());
    std::iota(m_chosen.begin(), m_chosen.end(), std::size_t(0));
    if (wanted == cloud.size()) {
      return;
    }
    const Place middle = cloud.points[decisions.below(cloud.size())];
    const auto distance = [&](std::size_t place) {
      const Place& point = cloud.points[place];
      return std::hypot(point.x - middle.x, point.y - middle.y);
    };
    std::nth_element(m_chosen.begin(), m_chosen.begin() + static_cast<std::ptrdiff_t>(wanted),
                     m_chosen.end(), [&](std::size_t place, std::size_t other) {
                       return std::make_pair(distance(place), place) <
                              std::make_pair(distance(other), other);
                     });
    m_chosen.resize(wanted);
  }

  Amount m_amount;
  Choice m_choice;
  bool m_is_first = true;
  std::vector<Id> m_fixed;
  Indices m_all;
  Indices m_chosen;
};

// Lets a program run.
class Program_frames
{
public:
  Program_frames(const Program& program, std::size_t points, std::uint64_t seed)
    : m_program(program)
    , m_decisions(seed)
  {
    named(all_base_clouds(), program.base, "base cloud").make(m_cloud, points, m_decisions);
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
        const Indices& chosen = running.selection.choose(m_cloud, m_decisions);
        running.motion.move(
            {m_cloud, chosen, m_cloud.points, running.step.size, m_decisions, running.memory});
        ++running.memory.calls;
      }
    }
  }

  scenario::Recorded_frame frame(std::size_t number) const
  {
    // Replaces coordinates that are too large for the package by the limit, and NaN by 0.
    Field limits;
    limits.limit = 1e153;
    scenario::Recorded_frame result{static_cast<double>(number), m_cloud.ids(), {}};
    for (const Place& place : m_cloud.points) {
      const auto [x, y] = limits.kept({m_program.scale_x * place.x, m_program.scale_y * place.y});
      result.points.push_back({x, y});
    }
    return result;
  }

  Program m_program;
  Normal_decisions m_decisions;
  Cloud m_cloud;
  std::vector<Running_step> m_steps;
};

} // namespace random_operations

#endif // RANDOM_OPERATIONS_PROGRAM_FRAMES_H

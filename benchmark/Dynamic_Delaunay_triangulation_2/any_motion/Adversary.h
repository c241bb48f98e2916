// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ANY_MOTION_ADVERSARY_H
#define ANY_MOTION_ADVERSARY_H

#include "../random_operations/Random_programs.h"
#include "Tasks.h"

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <ostream>
#include <string>
#include <vector>

namespace any_motion {

// A program that is slow.
struct Slow_program
{
  Program program;
  std::size_t points = 0;
  Sequence_figures figures{};

  // The worst ratio of frames, except where nearly all points have left: their free ids cost time.
  double ratio() const
  {
    double worst = 0.0;
    for (const Frame_figures& frame : figures.frames) {
      worst = 10 * frame.points < points ? worst : (std::max)(worst, frame.ratio());
    }
    return worst;
  }

  // The names of the base cloud and of the motions, without any numbers.
  std::string parts() const
  {
    std::vector<std::string> names;
    for (const Step& step : program.steps) {
      names.push_back(step.motion);
    }
    std::sort(names.begin(), names.end());
    std::string text = program.base;
    for (const std::string& name : names) {
      text += ' ' + name;
    }
    return text;
  }
};

// Looks for the programs with the slowest frames: draws some by chance, and changes the slowest so
// far a little.
class Adversary
{
public:
  Adversary(const Any_motion_options& options, std::ostream& out)
    : m_options(options)
    , m_out(out)
    , m_programs(options.seed, options.left_out)
    , m_settings(settings_of(options))
    , m_glance(m_settings)
  {
    m_glance.repetitions = 0;
  }

  void run(double seconds)
  {
    const auto end = Clock::now() + std::chrono::duration<double>(seconds);
    while (Clock::now() < end) {
      try_one();
    }
    write_slowest();
  }

private:
  using Clock = std::chrono::steady_clock;

  // More programs are kept than shown. No two of them are made of the same parts.
  static constexpr std::size_t max_kept = 20, max_shown = 10;

  void try_one()
  {
    ++m_tried;
    Slow_program found = next();
    measure(found, m_glance);
    if (!is_among_slowest(found)) {
      return;
    }
    measure(found, m_settings);
    if (is_among_slowest(found)) {
      simplify(found);
      keep(found);
    }
  }

  // A random program at the beginning and now and then, otherwise a changed one of the slowest.
  Slow_program next()
  {
    constexpr std::size_t beginning = 20, rarely = 4;
    Decisions& decisions = m_programs.decisions();
    if (m_tried <= beginning || m_slowest.empty() || decisions.one_in(rarely)) {
      return {m_programs.any(), any_number_of_points()};
    }
    const Slow_program& parent = decisions.any_of(m_slowest);
    return {m_programs.changed(parent.program), any_number_of_points()};
  }

  // Mostly few points, so that more programs can be tried.
  std::size_t any_number_of_points()
  {
    constexpr std::size_t many = 10'000, rarely = 20;
    if (m_options.chosen_points.empty() && m_programs.decisions().one_in(rarely)) {
      return many;
    }
    return m_programs.decisions().any_of(m_options.points());
  }

  void measure(Slow_program& found, const Sequence_settings& settings) const
  {
    constexpr std::size_t usual_frames = 6;
    found.figures = run_task(program_task(text_of(found.program), "", found.program, found.points,
                                          m_options.frames_or(usual_frames), m_options.seed),
                             settings);
  }

  // Removes the steps, the base cloud and the scales without which it is nearly as slow.
  void simplify(Slow_program& found) const
  {
    for (std::size_t i = found.program.steps.size(); i-- > 0 && found.program.steps.size() > 1;) {
      Slow_program simple = found;
      simple.program.steps.erase(simple.program.steps.begin() + static_cast<std::ptrdiff_t>(i));
      take_if_as_slow(simple, found);
    }
    Slow_program simple = found;
    simple.program.base = Program().base;
    simple.program.scale_x = simple.program.scale_y = 1.0;
    take_if_as_slow(simple, found);
  }

  void take_if_as_slow(Slow_program& simple, Slow_program& found) const
  {
    constexpr double nearly = 0.9;
    if (text_of(simple.program) != text_of(found.program)) {
      measure(simple, m_settings);
      if (simple.ratio() >= nearly * found.ratio()) {
        found = simple;
      }
    }
  }

  bool is_among_slowest(const Slow_program& found) const
  {
    return m_slowest.size() < max_kept || found.ratio() > m_slowest.back().ratio();
  }

  // Keeps the program, unless a slower one is made of the same parts.
  void keep(const Slow_program& found)
  {
    const bool is_record = m_slowest.empty() || found.ratio() > m_slowest.front().ratio();
    const auto like_it =
        std::find_if(m_slowest.begin(), m_slowest.end(),
                     [&](const Slow_program& other) { return other.parts() == found.parts(); });
    if (like_it == m_slowest.end()) {
      m_slowest.push_back(found);
    } else if (like_it->ratio() < found.ratio()) {
      *like_it = found;
    }
    std::stable_sort(
        m_slowest.begin(), m_slowest.end(),
        [](const Slow_program& a, const Slow_program& b) { return a.ratio() > b.ratio(); });
    m_slowest.resize((std::min)(m_slowest.size(), max_kept));
    if (is_record) {
      m_out << "after " << m_tried << " programs: ";
      write(found);
    }
  }

  void write_slowest() const
  {
    m_out << '\n' << m_tried << " programs, the slowest of them by their worst frames\n";
    for (std::size_t i = 0; i != (std::min)(m_slowest.size(), max_shown); ++i) {
      write(m_slowest[i]);
    }
  }

  void write(const Slow_program& found) const
  {
    m_out << found.ratio() << "  --points " << found.points << " --seed " << m_options.seed
          << " --program \"" << text_of(found.program) << '"' << std::endl;
  }

  const Any_motion_options& m_options;
  std::ostream& m_out;
  Random_programs m_programs;
  Sequence_settings m_settings;
  Sequence_settings m_glance;
  std::size_t m_tried = 0;
  std::vector<Slow_program> m_slowest; // the slowest first
};

} // namespace any_motion

#endif // ANY_MOTION_ADVERSARY_H

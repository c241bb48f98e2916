// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SCENARIO_RUNNER_PROGRESS_H
#define SCENARIO_RUNNER_PROGRESS_H

#include <chrono>
#include <cstddef>

namespace run {

bool stderr_is_a_terminal();

// One line on the terminal, for whoever waits; gone when it is destroyed.
class Progress_display
{
public:
  Progress_display(std::size_t frames, bool is_wanted, const char* what = "frame");
  Progress_display(const Progress_display&) = delete;
  Progress_display& operator=(const Progress_display&) = delete;
  ~Progress_display();

  void show(std::size_t frame);

private:
  using Clock = std::chrono::steady_clock;

  std::size_t m_frames;
  const char* m_what;
  bool m_is_shown;
  Clock::time_point m_start = Clock::now();
  Clock::time_point m_last = m_start;
};

// Ctrl-C, or a request to end: the frame that is under way comes to its end, and what was written
// is finished for the frames that were done. A second one ends the program at once.
namespace interruption {

void expect();
bool has_come();

// What a shell expects of a program that a signal has ended.
int exit_code();

} // namespace interruption

} // namespace run

#endif // SCENARIO_RUNNER_PROGRESS_H

// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SCENARIO_RUNNER_PROGRESS_H
#define SCENARIO_RUNNER_PROGRESS_H

#include <chrono>
#include <csignal>
#include <cstddef>
#include <iomanip>
#include <iostream>

#ifdef _WIN32
#include <io.h>
#else
#include <unistd.h>
#endif

namespace run {

inline bool stderr_is_a_terminal()
{
#ifdef _WIN32
  return _isatty(2) != 0;
#else
  return isatty(STDERR_FILENO) != 0;
#endif
}

// One line on the terminal, for whoever waits; gone when it is destroyed.
class Progress_display
{
public:
  Progress_display(std::size_t frames, bool is_wanted, const char* what = "frame")
    : m_frames(frames)
    , m_what(what)
    , m_is_shown(is_wanted && stderr_is_a_terminal())
  {
  }
  Progress_display(const Progress_display&) = delete;
  Progress_display& operator=(const Progress_display&) = delete;

  ~Progress_display()
  {
    if (m_is_shown) {
      std::cerr << "\r\033[K" << std::flush;
    }
  }

  void show(std::size_t frame)
  {
    using namespace std::chrono_literals;
    const Clock::time_point now = Clock::now();
    if (!m_is_shown || frame == 0 || now - m_last < 100ms) {
      return;
    }
    m_last = now;
    const double share = static_cast<double>(frame) / static_cast<double>(m_frames);
    const double seconds = std::chrono::duration<double>(now - m_start).count();
    std::cerr << "\r\033[K" << m_what << ' ' << frame << '/' << m_frames << std::fixed
              << std::setprecision(0) << "  " << 100.0 * share << " %  "
              << seconds / share - seconds << " s left" << std::flush;
  }

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
class Interruption
{
public:
  static void expect()
  {
    std::signal(SIGINT, take_note);
    std::signal(SIGTERM, take_note);
  }

  static bool has_come() { return s_signal != 0; }

  // What a shell expects of a program that a signal has ended.
  static int exit_code() { return 128 + s_signal; }

private:
  static void take_note(int signal)
  {
    s_signal = signal;
    std::signal(signal, SIG_DFL);
  }

  inline static volatile std::sig_atomic_t s_signal = 0;
};

} // namespace run

#endif // SCENARIO_RUNNER_PROGRESS_H

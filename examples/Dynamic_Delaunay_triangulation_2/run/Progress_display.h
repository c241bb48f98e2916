// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef RUN_PROGRESS_DISPLAY_H
#define RUN_PROGRESS_DISPLAY_H

#include <chrono>
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

} // namespace run

#endif // RUN_PROGRESS_DISPLAY_H

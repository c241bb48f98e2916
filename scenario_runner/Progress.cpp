// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "scenario_runner/Progress.h"

#include "scenario_runner/Number_text.h"

#include <csignal>
#include <iostream>

#ifdef _WIN32
#include <io.h>
#else
#include <unistd.h>
#endif

namespace run {

bool stderr_is_a_terminal()
{
#ifdef _WIN32
  return _isatty(2) != 0;
#else
  return isatty(STDERR_FILENO) != 0;
#endif
}

Progress_display::Progress_display(std::size_t frames, bool is_wanted, const char* what)
  : m_frames(frames)
  , m_what(what)
  , m_is_shown(is_wanted && stderr_is_a_terminal())
{
}

Progress_display::~Progress_display()
{
  if (m_is_shown) {
    std::cerr << "\r\033[K" << std::flush;
  }
}

void Progress_display::show(std::size_t frame)
{
  using namespace std::chrono_literals;
  const Clock::time_point now = Clock::now();
  if (!m_is_shown || frame == 0 || now - m_last < 100ms) {
    return;
  }
  m_last = now;
  const double share = static_cast<double>(frame) / static_cast<double>(m_frames);
  const double seconds = std::chrono::duration<double>(now - m_start).count();
  std::cerr << "\r\033[K" << m_what << ' ' << frame << '/' << m_frames << "  "
            << fixed_text(100.0 * share, 0) << " %  " << fixed_text(seconds / share - seconds, 0)
            << " s left" << std::flush;
}

namespace interruption {

namespace {

volatile std::sig_atomic_t s_signal = 0;

void take_note(int signal)
{
  s_signal = signal;
  std::signal(signal, SIG_DFL);
}

} // namespace

void expect()
{
  std::signal(SIGINT, take_note);
  std::signal(SIGTERM, take_note);
}

bool has_come()
{
  return s_signal != 0;
}

int exit_code()
{
  return 128 + s_signal;
}

} // namespace interruption

} // namespace run

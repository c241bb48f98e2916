// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef RUN_INTERRUPTION_H
#define RUN_INTERRUPTION_H

#include <csignal>

namespace run {

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

#endif // RUN_INTERRUPTION_H

// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ANY_MOTION_STATUS_LINE_H
#define ANY_MOTION_STATUS_LINE_H

#include "scenario_runner/Progress.h"

#include <iostream>
#include <string>

namespace any_motion {

// What is going on, for whoever waits at a terminal; gone when it is destroyed.
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

} // namespace any_motion

#endif // ANY_MOTION_STATUS_LINE_H

// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Recordings as text, for tests to compare.

#ifndef DYNAMIC_DELAUNAY_TRIANGULATION_2_TEST_RECORDING_TEXT_H
#define DYNAMIC_DELAUNAY_TRIANGULATION_2_TEST_RECORDING_TEXT_H

#include "scenario_runner/Recorded_motion.h"

#include <cstddef>
#include <sstream>
#include <string>

// The corner and the sides of a cell, and which are periodic.
inline std::string text_of(const scenario::Cell& cell)
{
  std::ostringstream text;
  const auto& [a, b] = cell.sides;
  text << " [(" << cell.corner.x << ' ' << cell.corner.y << ") (" << a.x << ' ' << a.y << ") ("
       << b.x << ' ' << b.y << ") " << (cell.is_periodic[0] ? 'p' : 'f')
       << (cell.is_periodic[1] ? 'p' : 'f') << ']';
  return text.str();
}

// A line for each frame: its number and time, the cell, and each point as id:(x y).
inline std::string text_of(const scenario::Recording& recording)
{
  std::ostringstream text;
  for (const scenario::Recorded_frame& frame : recording) {
    text << frame.number << " t=" << frame.time << (frame.cell ? text_of(*frame.cell) : "");
    for (std::size_t i = 0; i != frame.ids.size(); ++i) {
      text << ' ';
      if (frame.names) {
        text << frame.names->at(static_cast<std::size_t>(frame.ids[i]));
      } else {
        text << frame.ids[i];
      }
      text << ":(" << frame.points[i].x << ' ' << frame.points[i].y << ')';
    }
    text << '\n';
  }
  return text.str();
}

#endif // DYNAMIC_DELAUNAY_TRIANGULATION_2_TEST_RECORDING_TEXT_H

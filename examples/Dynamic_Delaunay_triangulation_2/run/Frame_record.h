// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef RUN_FRAME_RECORD_H
#define RUN_FRAME_RECORD_H

#include <CGAL/Update_report_2.h>

#include <cstddef>

namespace run {

// Nanoseconds.
struct Frame_times
{
  double dynamic = 0.0;
  double static_insert = 0.0;
  double static_fastest = 0.0;
};

struct Frame_record
{
  std::size_t frame = 0;
  double time = 0.0; // of the motion
  std::size_t points = 0;
  bool population_changed = false;
  CGAL::Update_report_2 update{};
  bool certified = false;
  double validity = 1.0;
  Frame_times nanoseconds{};
};

} // namespace run

#endif // RUN_FRAME_RECORD_H

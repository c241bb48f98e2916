// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SPEED_SPEED_RECORD_H
#define SPEED_SPEED_RECORD_H

#include "Phase_marks.h"
#include "scenario_runner/Frame_record.h"

namespace speed {

struct Speed_record
{
  run::Frame_record frame{};
  Phase_times phases{};
};

} // namespace speed

#endif // SPEED_SPEED_RECORD_H

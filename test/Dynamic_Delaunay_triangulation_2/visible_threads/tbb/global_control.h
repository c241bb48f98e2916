// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// See parallel_for.h, which starts as many threads as it is asked for.

#ifndef DYNAMIC_DELAUNAY_TRIANGULATION_2_TEST_VISIBLE_GLOBAL_CONTROL_H
#define DYNAMIC_DELAUNAY_TRIANGULATION_2_TEST_VISIBLE_GLOBAL_CONTROL_H

#include <cstddef>

namespace tbb {

class global_control
{
public:
  enum parameter { max_allowed_parallelism };

  global_control(parameter, std::size_t) {}
};

} // namespace tbb

#endif // DYNAMIC_DELAUNAY_TRIANGULATION_2_TEST_VISIBLE_GLOBAL_CONTROL_H

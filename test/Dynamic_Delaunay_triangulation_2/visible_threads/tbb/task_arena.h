// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// See parallel_for.h, which starts its own threads.

#ifndef DYNAMIC_DELAUNAY_TRIANGULATION_2_TEST_VISIBLE_TASK_ARENA_H
#define DYNAMIC_DELAUNAY_TRIANGULATION_2_TEST_VISIBLE_TASK_ARENA_H

namespace tbb {

class task_arena
{
public:
  explicit task_arena(int) {}

  template <class Function>
  void execute(const Function& function)
  {
    function();
  }
};

} // namespace tbb

#endif // DYNAMIC_DELAUNAY_TRIANGULATION_2_TEST_VISIBLE_TASK_ARENA_H

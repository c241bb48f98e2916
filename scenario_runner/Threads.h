// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SCENARIO_RUNNER_THREADS_H
#define SCENARIO_RUNNER_THREADS_H

#include <CGAL/tags.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/task_arena.h>
#endif

#include <algorithm>
#include <stdexcept>
#include <string>

namespace run {

// The triangulations of run_scenario use threads where TBB is there, as many as they are given.
using Concurrency_tag = CGAL::Parallel_if_available_tag;

// Executes functions with a number of threads, the caller's among them.
class Threads
{
public:
  // 0 for all threads that the machine has; never more than these.
  explicit Threads(unsigned number)
#ifdef CGAL_LINKED_WITH_TBB
    : m_arena(number == 0 ? tbb::task_arena::automatic
                          : (std::min)(int((std::min)(number, max_number)),
                                       tbb::this_task_arena::max_concurrency()))
#endif
  {
    if (number > max_number) {
      throw std::invalid_argument("the number of threads is " + std::to_string(number) +
                                  ", allowed are at most " + std::to_string(max_number) +
                                  (max_number == 1 ? " without TBB" : ""));
    }
  }

  template <class Function>
  decltype(auto) execute(const Function& f)
  {
#ifdef CGAL_LINKED_WITH_TBB
    return m_arena.execute(f);
#else
    return f();
#endif
  }

private:
#ifdef CGAL_LINKED_WITH_TBB
  static constexpr unsigned max_number = 1024;

  tbb::task_arena m_arena;
#else
  static constexpr unsigned max_number = 1;
#endif
};

} // namespace run

#endif // SCENARIO_RUNNER_THREADS_H

// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// See parallel_for.h, which starts its own threads.

#ifndef DYNAMIC_DELAUNAY_TRIANGULATION_2_TEST_VISIBLE_TASK_ARENA_H
#define DYNAMIC_DELAUNAY_TRIANGULATION_2_TEST_VISIBLE_TASK_ARENA_H

#define TBB_INTERFACE_VERSION 12000

namespace tbb {

namespace this_task_arena {

inline int& concurrency()
{
  thread_local int threads = 2;
  return threads;
}

inline int max_concurrency()
{
  return concurrency();
}

template <class Function>
void isolate(const Function& function)
{
  function();
}

} // namespace this_task_arena

class task_arena
{
public:
  static constexpr int automatic = -1;

  explicit task_arena(int threads)
    : m_threads(threads)
  {
  }

  template <class Function>
  auto execute(const Function& function)
  {
    const Concurrency concurrency(m_threads);
    return function();
  }

private:
  struct Concurrency
  {
    explicit Concurrency(int threads)
      : before(this_task_arena::concurrency())
    {
      if (threads != automatic)
        this_task_arena::concurrency() = threads;
    }
    Concurrency(const Concurrency&) = delete;
    Concurrency& operator=(const Concurrency&) = delete;
    ~Concurrency() { this_task_arena::concurrency() = before; }

    int before;
  };

  int m_threads;
};

} // namespace tbb

#endif // DYNAMIC_DELAUNAY_TRIANGULATION_2_TEST_VISIBLE_TASK_ARENA_H

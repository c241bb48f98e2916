// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_BASE_PART_RUNNER_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_BASE_PART_RUNNER_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Floating_point.h>
#include <CGAL/tags.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#if TBB_INTERFACE_VERSION >= 12000 // older ones have it as a preview that programs must ask for
#include <tbb/global_control.h>
#endif
#endif

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <memory>
#include <mutex>
#include <new>
#include <type_traits>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

// Is told which phase of an update in space begins. The benchmark `scale` has a tag of its own,
// whose log measures each phase.
template <class ConcurrencyTag>
struct Phase_log
{
  static void enter(const char*) {}
};

// Who does the parts of some work: threads, or without `Parallel_tag` the calling thread. The
// benchmark `scale` has a tag of its own, whose runner measures each part.
//
// The threads are those of the caller's TBB arena. Each takes the first part that no thread has
// taken, until all are taken. The calling thread works, too. If TBB has no memory for tasks, or
// cancels them together with an algorithm of the caller, the calling thread does the remaining
// parts. So only exceptions of parts are thrown. Of several exceptions, that of the first part is
// thrown, as without threads: when a part throws, all parts before it have been taken, and are
// completed.
template <class ConcurrencyTag>
class Part_runner
{
public:
  static constexpr bool is_parallel = std::is_convertible_v<ConcurrencyTag, Parallel_tag>;
#ifndef CGAL_LINKED_WITH_TBB
  static_assert(!is_parallel, "Parallel_tag needs TBB: link with CGAL::TBB_support");
#endif

  // How many threads may share work: an arena's, unless the program allows fewer for all arenas.
  static std::size_t most_workers()
  {
#ifdef CGAL_LINKED_WITH_TBB
    if constexpr (is_parallel) {
      const std::size_t of_arena = std::size_t(tbb::this_task_arena::max_concurrency());
#if TBB_INTERFACE_VERSION >= 12000
      using Control = tbb::global_control;
      const std::size_t allowed = Control::active_value(Control::max_allowed_parallelism);
      return (std::max)((std::min)(of_arena, allowed), std::size_t(1));
#else
      return of_arena;
#endif
    }
#endif
    return 1;
  }

  // Calls f(part) for all parts, by so many threads.
  template <class Function>
  static void run(std::size_t parts, [[maybe_unused]] std::size_t workers, const Function& f)
  {
#ifdef CGAL_LINKED_WITH_TBB
    if constexpr (is_parallel)
      if (workers > 1)
        return run_by_threads(parts, workers, Part_function(f));
#endif
    for (std::size_t part = 0; part < parts; ++part)
      f(part);
  }

#ifdef CGAL_LINKED_WITH_TBB
private:
  // A function of a part, whatever its type is. TBB's templates are then compiled once for all
  // functions, which are many; they were a quarter of the compiled updates for threads.
  class Part_function
  {
  public:
    template <class Function>
    explicit Part_function(const Function& f)
      : m_object(std::addressof(f))
      , m_call([](const void* object, std::size_t part) {
        (*static_cast<const Function*>(object))(part);
      })
    {
    }
    void operator()(std::size_t part) const { m_call(m_object, part); }

  private:
    const void* m_object;
    void (*m_call)(const void*, std::size_t);
  };

  static void run_by_threads(std::size_t parts, std::size_t workers, const Part_function& f)
  {
    Part_queue queue(parts);
    try {
      // a thread that waits must not take other work of the caller, who may hold a lock
      tbb::this_task_arena::isolate(
          [&] { tbb::parallel_for(std::size_t(0), workers, [&](std::size_t) { queue.work(f); }); });
    } catch (const std::bad_alloc&) { // thrown by TBB: work() throws nothing
    }
    queue.work(f);
    queue.finish();
  }

  class Part_queue
  {
  public:
    explicit Part_queue(std::size_t parts)
      : m_parts(parts)
    {
    }

    // Takes parts until none is left. Each thread has a floating-point mode of its own.
    void work(const Part_function& f)
    {
      const Default_floating_point floating_point;
      for (;;) {
        const std::size_t part = m_next.fetch_add(1, std::memory_order_relaxed);
        if (part >= m_parts)
          return;
        try {
          f(part);
        } catch (...) {
          note_failure(part);
        }
      }
    }

    void finish()
    {
      if (m_failure)
        std::rethrow_exception(m_failure);
    }

  private:
    void note_failure(std::size_t part)
    {
      m_next.store(m_parts, std::memory_order_relaxed); // no further parts
      const std::lock_guard<std::mutex> lock(m_mutex);
      if (part < m_failed_part) {
        m_failed_part = part;
        m_failure = std::current_exception();
      }
    }

    const std::size_t m_parts;
    std::atomic<std::size_t> m_next{0};
    std::mutex m_mutex;
    std::size_t m_failed_part = std::size_t(-1);
    std::exception_ptr m_failure;
  };
#endif // CGAL_LINKED_WITH_TBB
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_BASE_PART_RUNNER_H

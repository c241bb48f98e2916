// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Stands in for TBB under the thread sanitizer. TBB is compiled without the sanitizer, which does
// not see how TBB synchronizes its threads: it would report everything that they touch, and a
// suppression would hide true races with the false ones.

#ifndef DYNAMIC_DELAUNAY_TRIANGULATION_2_TEST_VISIBLE_PARALLEL_FOR_H
#define DYNAMIC_DELAUNAY_TRIANGULATION_2_TEST_VISIBLE_PARALLEL_FOR_H

#include <thread>
#include <vector>

namespace tbb {

// Each index on a thread of its own.
template <class Index, class Function>
void parallel_for(Index first, Index last, const Function& function)
{
  std::vector<std::thread> threads;
  for (Index i = first; i != last; ++i)
    threads.emplace_back([&function, i] { function(i); });
  for (std::thread& thread : threads)
    thread.join();
}

} // namespace tbb

#endif // DYNAMIC_DELAUNAY_TRIANGULATION_2_TEST_VISIBLE_PARALLEL_FOR_H

// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef RUN_STOPWATCH_H
#define RUN_STOPWATCH_H

#include <chrono>

namespace run {

template <class Work>
double nanoseconds_of(Work work)
{
  const auto start = std::chrono::steady_clock::now();
  work();
  const auto end = std::chrono::steady_clock::now();
  return std::chrono::duration<double, std::nano>(end - start).count();
}

} // namespace run

#endif // RUN_STOPWATCH_H

// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef COMMON_THREAD_TIME_H
#define COMMON_THREAD_TIME_H

#include <chrono>
#include <ctime>

namespace common {

// The processor time of this thread, which excludes other work on the machine; wall-clock time on
// systems that do not count it.
inline double thread_nanoseconds()
{
#ifdef CLOCK_THREAD_CPUTIME_ID
  std::timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return 1e9 * static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_nsec);
#else
  const auto time = std::chrono::steady_clock::now().time_since_epoch();
  return std::chrono::duration<double, std::nano>(time).count();
#endif
}

template <class Work>
double thread_nanoseconds_of(const Work& work)
{
  const double start = thread_nanoseconds();
  work();
  return thread_nanoseconds() - start;
}

} // namespace common

#endif // COMMON_THREAD_TIME_H

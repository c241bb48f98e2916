// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ANY_MOTION_THREAD_TIME_H
#define ANY_MOTION_THREAD_TIME_H

#include "scenario_runner/Measurement.h"

#include <ctime>

namespace any_motion {

// What this thread has worked: other work on the machine is not in it. Where nobody counts that,
// what the clock on the wall says.
#ifdef CLOCK_THREAD_CPUTIME_ID
inline double thread_nanoseconds()
{
  std::timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return 1e9 * static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_nsec);
}

template <class Work>
double thread_nanoseconds_of(Work work)
{
  const double start = thread_nanoseconds();
  work();
  return thread_nanoseconds() - start;
}
#else
template <class Work>
double thread_nanoseconds_of(Work work)
{
  return run::nanoseconds_of(work);
}
#endif

} // namespace any_motion

#endif // ANY_MOTION_THREAD_TIME_H

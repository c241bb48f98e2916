// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SCENARIO_RUNNER_MEASUREMENT_H
#define SCENARIO_RUNNER_MEASUREMENT_H

#include <chrono>
#include <optional>
#include <vector>

namespace run {

template <class Work>
double nanoseconds_of(Work work)
{
  const auto start = std::chrono::steady_clock::now();
  work();
  const auto end = std::chrono::steady_clock::now();
  return std::chrono::duration<double, std::nano>(end - start).count();
}

// Lets freed memory stay in the process, where the C library can. Otherwise the opponents' large
// blocks go back to the system between frames, and the next frame of the dynamic triangulation pays
// for page tables that a virtual machine makes again, and takes up to five times as long at 100,000
// points. Call before anything is timed.
void keep_freed_memory();

// The median and the quartiles of measurements.
struct Spread
{
  double low_quartile;
  double median;
  double high_quartile;
};

double quantile(const std::vector<double>& sorted, double share);

// The spread of values; nothing if there are none.
std::optional<Spread> spread(std::vector<double> values);

} // namespace run

#endif // SCENARIO_RUNNER_MEASUREMENT_H

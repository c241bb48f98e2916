// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SCENARIO_RUNNER_MEASUREMENT_H
#define SCENARIO_RUNNER_MEASUREMENT_H

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
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

// Of a set of measurements.
struct Spread
{
  double low_quartile;
  double median;
  double high_quartile;
};

inline double quantile(const std::vector<double>& sorted, double share)
{
  const double place = share * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(std::floor(place));
  const std::size_t above = (std::min)(below + 1, sorted.size() - 1);
  return sorted[below] + (place - std::floor(place)) * (sorted[above] - sorted[below]);
}

// Nothing has no spread.
inline std::optional<Spread> spread(std::vector<double> values)
{
  if (values.empty()) {
    return std::nullopt;
  }
  std::sort(values.begin(), values.end());
  return Spread{quantile(values, 0.25), quantile(values, 0.5), quantile(values, 0.75)};
}

} // namespace run

#endif // SCENARIO_RUNNER_MEASUREMENT_H

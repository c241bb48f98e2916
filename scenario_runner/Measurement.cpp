// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "scenario_runner/Measurement.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace run {

void keep_freed_memory()
{
#ifdef __GLIBC__
  mallopt(M_MMAP_MAX, 0); // no blocks beside the heap
  mallopt(M_TRIM_THRESHOLD, (std::numeric_limits<int>::max)());
#endif
}

double quantile(const std::vector<double>& sorted, double share)
{
  const double place = share * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(std::floor(place));
  const std::size_t above = (std::min)(below + 1, sorted.size() - 1);
  return sorted[below] + (place - std::floor(place)) * (sorted[above] - sorted[below]);
}

std::optional<Spread> spread(std::vector<double> values)
{
  if (values.empty()) {
    return std::nullopt;
  }
  std::sort(values.begin(), values.end());
  return Spread{quantile(values, 0.25), quantile(values, 0.5), quantile(values, 0.75)};
}

} // namespace run

// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef COMMON_STATISTICS_H
#define COMMON_STATISTICS_H

#include "scenario_runner/Measurement.h"

#include <algorithm>
#include <cstddef>
#include <functional>
#include <numeric>
#include <vector>

namespace common {

// `value(item)` of all items, as numbers. A value may be a pointer to a member.
template <class Items, class Value>
std::vector<double> values_of(const Items& items, const Value& value)
{
  std::vector<double> values;
  for (const auto& item : items) {
    values.push_back(static_cast<double>(std::invoke(value, item)));
  }
  return values;
}

inline double sum(const std::vector<double>& values)
{
  return std::accumulate(values.begin(), values.end(), 0.0);
}

// These and the following are of at least one value.
inline double mean(const std::vector<double>& values)
{
  return sum(values) / static_cast<double>(values.size());
}

inline double median(const std::vector<double>& values)
{
  return run::spread(values)->median;
}

inline double largest(const std::vector<double>& values)
{
  return *std::max_element(values.begin(), values.end());
}

// The median of the ratios of single measurements: what disturbs both hardly counts.
inline double median_ratio(const std::vector<double>& above, const std::vector<double>& below)
{
  std::vector<double> ratios;
  for (std::size_t i = 0; i != above.size(); ++i) {
    ratios.push_back(above[i] / below[i]);
  }
  return median(ratios);
}

} // namespace common

#endif // COMMON_STATISTICS_H

// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ROBUSTNESS_TRIAL_SEED_H
#define ROBUSTNESS_TRIAL_SEED_H

#include <cstddef>
#include <cstdint>

namespace robustness {

inline constexpr std::size_t operations_of_trial = 200;

// A seed that is independent of those of other trials (SplitMix64).
inline std::uint64_t seed_of_trial(std::uint64_t seed, std::uint64_t trial)
{
  std::uint64_t x = (seed + 1) * 0x9E3779B97F4A7C15u + trial * 0xD1B54A32D192ED03u;
  x = (x ^ (x >> 30)) * 0xBF58476D1CE4E5B9u;
  x = (x ^ (x >> 27)) * 0x94D049BB133111EBu;
  return x ^ (x >> 31);
}

} // namespace robustness

#endif // ROBUSTNESS_TRIAL_SEED_H

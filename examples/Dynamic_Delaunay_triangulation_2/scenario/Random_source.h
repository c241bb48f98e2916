// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SCENARIO_RANDOM_SOURCE_H
#define SCENARIO_RANDOM_SOURCE_H

#include <cmath>
#include <cstdint>
#include <random>

namespace scenario {

// The distributions of the standard library differ between its implementations; these do not.
class Random_source
{
public:
  explicit Random_source(std::uint64_t seed)
    : m_engine(seed)
  {
  }

  // Uniform in [0, 1).
  double uniform() { return static_cast<double>(m_engine() >> 11) * 0x1p-53; }

  double uniform(double low, double high) { return low + (high - low) * uniform(); }

  // Mean 0, standard deviation 1 (Box and Muller).
  double gaussian()
  {
    if (m_has_spare) {
      m_has_spare = false;
      return m_spare;
    }
    const double radius = std::sqrt(-2.0 * std::log(1.0 - uniform()));
    const double angle = 6.283185307179586 * uniform();
    m_spare = radius * std::sin(angle);
    m_has_spare = true;
    return radius * std::cos(angle);
  }

private:
  std::mt19937_64 m_engine;
  double m_spare = 0.0;
  bool m_has_spare = false;
};

} // namespace scenario

#endif // SCENARIO_RANDOM_SOURCE_H

// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_IO_WRAPPED_COORDINATE_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_IO_WRAPPED_COORDINATE_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Number_types/internal/Exact_type_selector.h>

#include <cmath>
#include <limits>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

// A coordinate plus whole sides of a periodic domain. Not a number where that would be rounded.
struct Wrapped_coordinate
{
  double value = std::numeric_limits<double>::quiet_NaN();
  int sides = 0; // from it to the coordinate that was wrapped
};

// The domain is from `low` to before `high`, which is exactly `low + side`.
inline Wrapped_coordinate wrapped(double x, double low, double high, double side)
{
  using Exact = CGAL::internal::Exact_ring_selector<double>::Type;
  constexpr double most_sides = 0x1p21;
  const double about = std::floor((x - low) / side);
  for (int i = -1; i <= 1 && std::abs(about) < most_sides; ++i) {
    const double k = about + i, candidate = std::fma(-k, side, x);
    if (low <= candidate && candidate < high &&
        Exact(candidate) == Exact(x) - Exact(k) * Exact(side))
      return {candidate, int(k)};
  }
  return {};
}

// Whether `high` is finite, and exactly `low + side`.
inline bool is_exact_sum(double low, double side, double high)
{
  using Exact = CGAL::internal::Exact_ring_selector<double>::Type;
  return std::isfinite(high) && Exact(high) == Exact(low) + Exact(side);
}

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_IO_WRAPPED_COORDINATE_H

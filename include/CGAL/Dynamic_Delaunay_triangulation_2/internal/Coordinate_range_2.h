// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_COORDINATE_RANGE_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_COORDINATE_RANGE_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Interval_nt.h>

#include <cmath>
#include <limits>

namespace CGAL {
namespace Dynamic_Delaunay_triangulations_2 {
namespace internal {

// Below which magnitude of the coordinates the kernel's predicates are exact.
//
// Compiled for SSE4.1 or AVX, CGAL's interval product loses a 0 that meets an infinity: [-1, 0]
// times [1, inf] is [-inf, -1] (CGAL 5.5; cf. its issue 4312). Such an interval can exclude the
// true sign, and no exact number is asked. It takes an operand of a product that overflows. In the
// in-circle determinant, which has the largest ones, these are sums of two products of two
// differences: with coordinates below 2^510 they are at most 2 * 2^511 * 2^511 = 2^1023.
#if defined(CGAL_USE_SSE2) && (defined(__SSE4_1__) || defined(__AVX__))
constexpr double coordinate_limit = 0x1p510;
// What coordinates from the limit on overflow with.
constexpr double factor_beyond_limit = 0x1p514;
#else
constexpr double coordinate_limit = std::numeric_limits<double>::infinity();
constexpr double factor_beyond_limit = 1;
#endif

inline bool is_within_limit(double coordinate)
{
  return std::isfinite(factor_beyond_limit * coordinate);
}

} // namespace internal
} // namespace Dynamic_Delaunay_triangulations_2
} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_COORDINATE_RANGE_2_H

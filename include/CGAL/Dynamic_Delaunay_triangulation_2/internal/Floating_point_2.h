// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_FLOATING_POINT_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_FLOATING_POINT_2_H

#include <CGAL/FPU.h>

// -ffast-math, -Ofast and -ffinite-math-only let a compiler take NaN and infinity for impossible,
// and rounding errors for any: no coordinate could be checked, and no sign proved.
#if defined(__FAST_MATH__) || (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__ > 0)
#error                                                                                             \
    "Dynamic_Delaunay_triangulation_2 proves signs of rounded numbers, which is impossible under \
-ffast-math, -Ofast and -ffinite-math-only: compile the files that include it without these flags \
(-O3 -fno-math-errno -fno-trapping-math keeps most of their speed)"
#endif

namespace CGAL {
namespace Dynamic_Delaunay_triangulations_2 {
namespace internal {

// Rounds to nearest while it lives, whatever the caller's mode is, and gives that back. Every bound
// of a filter is proved for this mode.
class Rounding_to_nearest_2
{
public:
  Rounding_to_nearest_2()
    : m_mode(FPU_get_and_set_cw(CGAL_FE_TONEAREST))
  {
  }
  ~Rounding_to_nearest_2() { FPU_set_cw(m_mode); }
  Rounding_to_nearest_2(const Rounding_to_nearest_2&) = delete;
  Rounding_to_nearest_2& operator=(const Rounding_to_nearest_2&) = delete;

private:
  FPU_CW_t m_mode;
};

} // namespace internal
} // namespace Dynamic_Delaunay_triangulations_2
} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_FLOATING_POINT_2_H

// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_BASE_FLOATING_POINT_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_BASE_FLOATING_POINT_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#if defined(__SSE2_MATH__) || defined(_M_X64)
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_HAS_MXCSR
#include <xmmintrin.h>
#else
#include <cfenv>
#endif

// Under these options a compiler takes NaN and infinity for impossible and allows any rounding
// error: coordinates could not be checked, and signs could not be proved.
#if defined(__FAST_MATH__) || (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__ > 0) ||       \
    defined(__ASSOCIATIVE_MATH__)
static_assert(false,
              "Dynamic_Delaunay_triangulation_2 proves the signs of rounded numbers, which is "
              "impossible under -ffast-math, -Ofast, -ffinite-math-only and -fassociative-math: "
              "compile the files that include it without these flags");
#endif
#if defined(__FLT_EVAL_METHOD__) && __FLT_EVAL_METHOD__ != 0 && __FLT_EVAL_METHOD__ != 16
static_assert(false,
              "Dynamic_Delaunay_triangulation_2 proves the signs of doubles, which is impossible "
              "where they are computed in more digits than they have: compile for SSE2 "
              "(-msse2 -mfpmath=sse)");
#endif

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

// During its lifetime, floating-point arithmetic is in its default state, for which every bound of
// a filter is proved: rounding to nearest, with subnormal numbers, without traps. Its destructor
// restores the caller's state. Other states are common: games flush subnormal numbers to zero, and
// so does any program that loads a library linked with -ffast-math by a compiler from before 2023.
class Default_floating_point
{
public:
  Default_floating_point(const Default_floating_point&) = delete;
  Default_floating_point& operator=(const Default_floating_point&) = delete;

#ifdef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_HAS_MXCSR
  // Takes a few nanoseconds in the default state, which most programs have, and some 20 in others.
  // <cfenv> takes hundreds, because it also sets the x87 unit.
  Default_floating_point()
    : m_state(_mm_getcsr())
  {
    constexpr unsigned default_state = 0x1f80, exceptions_so_far = 0x3f;
    if ((m_state & ~exceptions_so_far) != default_state)
      _mm_setcsr(default_state);
  }
  ~Default_floating_point()
  {
    if (_mm_getcsr() != m_state)
      _mm_setcsr(m_state);
  }

private:
  unsigned m_state;
#else
  Default_floating_point()
  {
    std::fegetenv(&m_state);
    std::fesetenv(FE_DFL_ENV);
  }
  ~Default_floating_point()
  {
    std::fesetenv(&m_state);
  }

private:
  std::fenv_t m_state;
#endif
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_BASE_FLOATING_POINT_H

// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_VECTOR_SUPPORT_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_VECTOR_SUPPORT_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

// AVX2 is picked at run time, so that a plain build has it. CGAL_DYNAMIC_DELAUNAY_NO_SIMD leaves it
// out.
#if defined(__x86_64__) && (defined(__GNUC__) || defined(__clang__)) &&                            \
    !defined(CGAL_DYNAMIC_DELAUNAY_NO_SIMD)
#define CGAL_DYNAMIC_DELAUNAY_HAS_AVX2
#include <immintrin.h>

namespace CGAL {
namespace Dynamic_Delaunay_triangulations_2 {
namespace internal {

inline bool has_avx2()
{
  static const bool has = __builtin_cpu_supports("avx2");
  return has;
}

} // namespace internal
} // namespace Dynamic_Delaunay_triangulations_2
} // namespace CGAL
#endif

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_VECTOR_SUPPORT_2_H

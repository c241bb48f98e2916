// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_PROCESSOR_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_PROCESSOR_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <cstdint>

// AVX2 is picked at run time, so that a plain build has it. CGAL_DYNAMIC_DELAUNAY_NO_SIMD leaves it
// out.
#if defined(__x86_64__) && (defined(__GNUC__) || defined(__clang__)) &&                            \
    !defined(CGAL_DYNAMIC_DELAUNAY_NO_SIMD)
#define CGAL_DYNAMIC_DELAUNAY_HAS_AVX2
#define CGAL_DYNAMIC_DELAUNAY_AVX2 __attribute__((target("avx2"), always_inline)) static inline
#include <immintrin.h>
#endif

namespace CGAL {
namespace Dynamic_Delaunay_triangulations_2 {
namespace internal {

#ifdef CGAL_DYNAMIC_DELAUNAY_HAS_AVX2

inline bool has_avx2()
{
  static const bool has = __builtin_cpu_supports("avx2");
  return has;
}

#endif // CGAL_DYNAMIC_DELAUNAY_HAS_AVX2

// With more vertices, and other work between the frames, the flat arrays are not in the
// second-level cache, and a pass over them fetches ahead: at 4,000 points that takes a fifth off
// the pass over the edges, at 10^5 half. At 1,000 it would add a fifth.
constexpr std::uint32_t min_vertices_to_prefetch = 3 << 10;

// Asks for memory that will be needed soon; without compiler support nothing happens. The empty
// statement is an effect that cannot be left out: g++ takes a function that does nothing but
// prefetch for one without effects, and removes its calls.
inline void prefetch(const void* address)
{
#if defined(__GNUC__) || defined(__clang__)
  __builtin_prefetch(address);
  __asm__ volatile("");
#else
  static_cast<void>(address);
#endif
}

} // namespace internal
} // namespace Dynamic_Delaunay_triangulations_2
} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_PROCESSOR_2_H

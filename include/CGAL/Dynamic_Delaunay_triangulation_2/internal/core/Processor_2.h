// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_CORE_PROCESSOR_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_CORE_PROCESSOR_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <cstdint>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

// With more vertices than this, and other work between the frames, the flat arrays are not in the
// second-level cache, and passes over them prefetch. That saves a fifth of the pass over the edges
// at 4,000 points and half at 10^5; at 1,000 it would add a fifth.
constexpr std::uint32_t min_vertices_to_prefetch = 3 << 10;

// Fetches memory that will be needed soon; does nothing if the compiler does not support it. The
// empty statement is a side effect: g++ would remove calls of a function that only prefetches.
inline void prefetch(const void* address)
{
#if defined(__GNUC__) || defined(__clang__)
  __builtin_prefetch(address);
  __asm__ volatile("");
#else
  static_cast<void>(address);
#endif
}

// The place of the lowest bit that is set in `word`, which must not be 0.
inline unsigned lowest_bit(std::uint64_t word)
{
#if defined(__GNUC__) || defined(__clang__)
  return unsigned(__builtin_ctzll(word));
#else
  unsigned place = 0;
  for (; (word & 1) == 0; word >>= 1)
    ++place;
  return place;
#endif
}

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_CORE_PROCESSOR_2_H

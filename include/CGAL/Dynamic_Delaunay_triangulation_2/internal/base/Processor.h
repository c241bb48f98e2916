// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_BASE_PROCESSOR_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_BASE_PROCESSOR_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <boost/integer/integer_log2.hpp>

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

// The place of the highest bit that is set. One of them must be.
inline unsigned highest_bit(std::uint64_t word)
{
#if defined(__GNUC__) // without the branches of Boost's function, which cannot be predicted
  return 63u - unsigned(__builtin_clzll(word));
#else
  return unsigned(boost::integer_log2(word));
#endif
}

// The place of the lowest bit that is set. One of them must be.
inline unsigned lowest_bit(std::uint64_t word)
{
  return highest_bit(word & (~word + 1));
}

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_BASE_PROCESSOR_H

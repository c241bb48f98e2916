// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_PREFETCH_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_PREFETCH_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <cstdint>

namespace CGAL {
namespace Dynamic_Delaunay_triangulations_2 {
namespace internal {

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

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_PREFETCH_2_H

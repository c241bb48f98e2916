// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_DISPLACEMENTS_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_DISPLACEMENTS_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Computed_geometry_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Neighborhood_mirror_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Vector_support_2.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Dynamic_Delaunay_triangulations_2 {
namespace internal {

// What a computed squared distance must not exceed to prove that the distance is not larger than
// `tolerance`: it is within 4u of the true one, relatively, u = 2^-53. Where the square of the
// tolerance overflows it is larger than all doubles, and an infinite distance still proves nothing.
// Squares of tolerances below 1e-150 underflow: these must not be asked for.
inline double squared_bound(double tolerance)
{
  return (std::min)(tolerance * tolerance, (std::numeric_limits<double>::max)()) *
         (1 - 16 * 0x1p-53);
}

inline bool is_within(double tolerance, const Position_2& p, const Position_2& q)
{
  return squared_distance(p, q) <= squared_bound(tolerance);
}

// Appends the vertices [first, beyond) that are farther than the root of `bound` from their
// references.
inline void append_moved_plain(const Position_2* positions, const Position_2* references,
                               Index first, Index beyond, double bound, std::vector<Index>& moved)
{
  for (Index v = first; v < beyond; ++v)
    if (!(squared_distance(positions[v], references[v]) <= bound))
      moved.push_back(v);
}

#ifdef CGAL_DYNAMIC_DELAUNAY_HAS_AVX2

// The same, operation for operation, sixteen vertices at once.
__attribute__((target("avx2"))) inline void
append_moved_avx2(const Position_2* positions, const Position_2* references, Index first,
                  Index beyond, double bound, std::vector<Index>& moved)
{
  constexpr Index block = 16;
  const __m256d bounds = _mm256_set1_pd(bound);
  Index v = first;
  for (; v + block <= beyond; v += block) {
    const double *p = &positions[v].x, *r = &references[v].x;
    __m256d are_near = _mm256_castsi256_pd(_mm256_set1_epi64x(-1));
    for (int i = 0; i < 2 * int(block); i += 8) {
      const __m256d d = _mm256_sub_pd(_mm256_loadu_pd(p + i), _mm256_loadu_pd(r + i));
      const __m256d e = _mm256_sub_pd(_mm256_loadu_pd(p + i + 4), _mm256_loadu_pd(r + i + 4));
      const __m256d squares = _mm256_hadd_pd(_mm256_mul_pd(d, d), _mm256_mul_pd(e, e));
      are_near = _mm256_and_pd(are_near, _mm256_cmp_pd(squares, bounds, _CMP_LE_OQ));
    }
    if (_mm256_movemask_pd(are_near) != 15)
      append_moved_plain(positions, references, v, v + block, bound, moved);
  }
  append_moved_plain(positions, references, v, beyond, bound, moved);
}

#endif // CGAL_DYNAMIC_DELAUNAY_HAS_AVX2

// Appends all finite vertices that are not proved to be within `tolerance` of their references.
// False, and the vertices are not complete, if they are more than `most`.
inline bool append_moved(const std::vector<Position_2>& positions,
                         const std::vector<Position_2>& references, double tolerance,
                         std::size_t most, std::vector<Index>& moved)
{
  const double bound = squared_bound(tolerance);
  const Index vertices = Index(positions.size());
  constexpr Index part = 1 << 10; // motion everywhere is found out early
  for (Index first = 1; first < vertices && moved.size() <= most; first += part) {
    const Index beyond = vertices - first < part ? vertices : first + part;
#ifdef CGAL_DYNAMIC_DELAUNAY_HAS_AVX2
    if (has_avx2()) {
      append_moved_avx2(positions.data(), references.data(), first, beyond, bound, moved);
      continue;
    }
#endif
    append_moved_plain(positions.data(), references.data(), first, beyond, bound, moved);
  }
  return moved.size() <= most;
}

} // namespace internal
} // namespace Dynamic_Delaunay_triangulations_2
} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_DISPLACEMENTS_2_H

// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_EDGE_PROOFS_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_EDGE_PROOFS_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Edge_filter_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Neighborhood_mirror_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Prefetch_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Vector_support_2.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Dynamic_Delaunay_triangulations_2 {
namespace internal {

inline void prefetch_corners(const Edge_2& edge, const Position_2* positions)
{
  for (const Index v : {edge.source, edge.target, edge.left, edge.right})
    prefetch(positions + v);
}

// Appends those of the edges [first, beyond) that Edge_filter_2 does not prove Delaunay.
inline void append_unproved_plain(const Edge_2* edges, const Position_2* positions, Index first,
                                  Index beyond, std::vector<Index>& unproved)
{
  for (Index e = first; e < beyond; ++e) {
    const Edge_2& edge = edges[e];
    const Edge_filter_2 filter(positions[edge.left], positions[edge.source], positions[edge.target],
                               positions[edge.right]);
    if (!filter.proves_delaunay())
      unproved.push_back(e);
  }
}

#ifdef CGAL_DYNAMIC_DELAUNAY_HAS_AVX2

#define CGAL_DYNAMIC_DELAUNAY_AVX2 __attribute__((target("avx2"), always_inline)) static inline

// Edge_filter_2 on four edges at once, operation for operation, so that both prove the same edges.
class Edge_filter_avx2_2
{
  struct Corners
  {
    __m256d x, y;
  };

  CGAL_DYNAMIC_DELAUNAY_AVX2 Corners load(const Position_2* positions, Index i, Index j, Index k,
                                          Index l)
  {
    const __m256d ik = _mm256_insertf128_pd(_mm256_castpd128_pd256(_mm_loadu_pd(&positions[i].x)),
                                            _mm_loadu_pd(&positions[k].x), 1);
    const __m256d jl = _mm256_insertf128_pd(_mm256_castpd128_pd256(_mm_loadu_pd(&positions[j].x)),
                                            _mm_loadu_pd(&positions[l].x), 1);
    return {_mm256_unpacklo_pd(ik, jl), _mm256_unpackhi_pd(ik, jl)};
  }

  CGAL_DYNAMIC_DELAUNAY_AVX2 Corners minus(const Corners& p, const Corners& q)
  {
    return {_mm256_sub_pd(p.x, q.x), _mm256_sub_pd(p.y, q.y)};
  }

  CGAL_DYNAMIC_DELAUNAY_AVX2 __m256d times(__m256d a, __m256d b) { return _mm256_mul_pd(a, b); }
  CGAL_DYNAMIC_DELAUNAY_AVX2 __m256d plus(__m256d a, __m256d b) { return _mm256_add_pd(a, b); }
  CGAL_DYNAMIC_DELAUNAY_AVX2 __m256d cross(const Corners& p, const Corners& q)
  {
    return _mm256_sub_pd(times(p.x, q.y), times(q.x, p.y));
  }
  CGAL_DYNAMIC_DELAUNAY_AVX2 __m256d squared_length(const Corners& p)
  {
    return plus(times(p.x, p.x), times(p.y, p.y));
  }

public:
  // Bit i of the result: edges[i] is proved.
  CGAL_DYNAMIC_DELAUNAY_AVX2 int prove(const Edge_2* edges, const Position_2* positions)
  {
    const Corners d =
        load(positions, edges[0].right, edges[1].right, edges[2].right, edges[3].right);
    const Corners a =
        minus(load(positions, edges[0].left, edges[1].left, edges[2].left, edges[3].left), d);
    const Corners b = minus(
        load(positions, edges[0].source, edges[1].source, edges[2].source, edges[3].source), d);
    const Corners c = minus(
        load(positions, edges[0].target, edges[1].target, edges[2].target, edges[3].target), d);

    const __m256d bc = cross(b, c), ca = cross(c, a), ab = cross(a, b);
    const __m256d aa = squared_length(a), bb = squared_length(b), cc = squared_length(c);
    const __m256d s = plus(plus(aa, bb), cc);
    const __m256d left = plus(plus(ab, bc), ca);
    const __m256d in_circle = plus(plus(times(aa, bc), times(bb, ca)), times(cc, ab));

    const __m256d bound = times(_mm256_set1_pd(Edge_filter_2::orientation_factor), s);
    const __m256d in_circle_bound =
        times(_mm256_set1_pd(Edge_filter_2::in_circle_factor), times(s, s));
    const __m256d sign = _mm256_set1_pd(-0.0);
    const __m256d is_left = _mm256_cmp_pd(left, bound, _CMP_GT_OQ);
    const __m256d is_right = _mm256_cmp_pd(_mm256_xor_pd(sign, bc), bound, _CMP_GT_OQ);
    const __m256d is_empty =
        _mm256_cmp_pd(in_circle, _mm256_xor_pd(sign, in_circle_bound), _CMP_LT_OQ);
    const __m256d is_large =
        _mm256_cmp_pd(s, _mm256_set1_pd(Edge_filter_2::smallest_s), _CMP_GT_OQ);
    return _mm256_movemask_pd(
        _mm256_and_pd(_mm256_and_pd(is_empty, is_large), _mm256_and_pd(is_left, is_right)));
  }
};

#undef CGAL_DYNAMIC_DELAUNAY_AVX2

template <bool prefetches>
__attribute__((target("avx2"))) inline void
append_unproved_avx2(const Edge_2* edges, const Position_2* positions, Index first, Index beyond,
                     std::vector<Index>& unproved)
{
  constexpr Index ahead = 128, far_ahead = 512;
  Index e = first;
  for (; e + 4 <= beyond; e += 4) {
    if (prefetches && e + far_ahead < beyond) {
      prefetch(edges + e + far_ahead);
      for (Index i = e + ahead; i < e + ahead + 4; ++i)
        prefetch_corners(edges[i], positions);
    }
    const int proved = Edge_filter_avx2_2::prove(edges + e, positions);
    if (proved != 15)
      for (Index i = 0; i < 4; ++i)
        if (!(proved >> i & 1))
          unproved.push_back(e + i);
  }
  append_unproved_plain(edges, positions, e, beyond, unproved);
}

// The same for the edges in a list.
__attribute__((target("avx2"))) inline void append_unproved_of_avx2(const Edge_2* edges,
                                                                    const Position_2* positions,
                                                                    const std::vector<Index>& list,
                                                                    std::vector<Index>& unproved)
{
  std::size_t i = 0;
  for (; i + 4 <= list.size(); i += 4) {
    const Edge_2 four[4] = {edges[list[i]], edges[list[i + 1]], edges[list[i + 2]],
                            edges[list[i + 3]]};
    const int proved = Edge_filter_avx2_2::prove(four, positions);
    if (proved != 15)
      for (std::size_t k = 0; k < 4; ++k)
        if (!(proved >> k & 1))
          unproved.push_back(list[i + k]);
  }
  for (; i < list.size(); ++i)
    append_unproved_plain(edges, positions, list[i], list[i] + 1, unproved);
}

#endif // CGAL_DYNAMIC_DELAUNAY_HAS_AVX2

inline void append_unproved(const Edge_2* edges, const std::vector<Position_2>& positions,
                            Index first, Index beyond, std::vector<Index>& unproved)
{
#ifdef CGAL_DYNAMIC_DELAUNAY_HAS_AVX2
  if (has_avx2()) {
    if (positions.size() < min_vertices_to_prefetch)
      append_unproved_avx2<false>(edges, positions.data(), first, beyond, unproved);
    else
      append_unproved_avx2<true>(edges, positions.data(), first, beyond, unproved);
    return;
  }
#endif
  append_unproved_plain(edges, positions.data(), first, beyond, unproved);
}

inline void append_unproved_of(const Edge_2* edges, const std::vector<Position_2>& positions,
                               const std::vector<Index>& list, std::vector<Index>& unproved)
{
#ifdef CGAL_DYNAMIC_DELAUNAY_HAS_AVX2
  if (has_avx2())
    return append_unproved_of_avx2(edges, positions.data(), list, unproved);
#endif
  for (const Index e : list)
    append_unproved_plain(edges, positions.data(), e, e + 1, unproved);
}

} // namespace internal
} // namespace Dynamic_Delaunay_triangulations_2
} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_EDGE_PROOFS_2_H

// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_EDGE_FILTER_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_EDGE_FILTER_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Floating_point_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Neighborhood_mirror_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Processor_2.h>

#include <boost/config.hpp>

#include <cmath>

namespace CGAL {
namespace Dynamic_Delaunay_triangulations_2 {
namespace internal {

// The three signs that decide an edge, in floating point with proved error bounds.
//
// For an edge (b, c) with faces (a, b, c) and (d, c, b), all coordinates relative to d:
//
//     ab, bc, ca    the 2x2 minors: bc = bx cy - cx by, and so on
//     right         orientation(d, c, b) = -bc
//     left          orientation(a, b, c) = ab + bc + ca
//     in_circle     |a|^2 bc + |b|^2 ca + |c|^2 ab, positive if d is inside the circle of abc
//
// The bounds. Let u = 2^-53 and s = |a|^2 + |b|^2 + |c|^2. Each difference, product and sum is
// rounded once, by a factor between 1 - u and 1 + u.
//
// Orientation. A term of a minor is a product of two differences: three roundings. The subtraction
// in the minor is the fourth, and at most two additions in `left` make six. So the error of `left`
// is at most 6u T + O(u^2), where T = |bx cy| + |cx by| + ... is the sum of the absolute values of
// all terms. T <= s, because
//     |bx cy| + |cx by| <= |b||c| <= (|b|^2 + |c|^2) / 2
// and likewise for the others. The same bound holds for `right`.
//
// In-circle. A square |a|^2 takes four roundings: two differences, a product and a sum. The minor
// has four as well, their product one: nine. Two additions make eleven. So the error is at most
// 11u P + O(u^2), where
//     P = |a|^2 (|bx cy| + |cx by|) + ... <= |a|^2 |b||c| + |b|^2 |c||a| + |c|^2 |a||b| <= s^2 / 3,
// because the sum of x^2 yz is at most the sum of x^2 y^2, which follows from
// xy yz <= (x^2 y^2 + y^2 z^2) / 2. The error is thus at most 3.67u s^2.
//
// The relative error of the computed s is at most 6u. The computed bounds 8u s and 5u s^2 cover it.
//
// Underflow. Differences are exact then. A product that underflows is off by at most 2^-1075, and
// may be multiplied by at most 2s: some 30 s 2^-1075 in all. For s >= 1e-120 that is far below u s
// and u s^2. Smaller s are left to the kernel.
//
// Overflow. All summands are at most s, or s^2 / 3. If one overflows, the bound is infinite, as s^2
// is computed before the factor is applied, and all comparisons below are false.
//
// Fused multiply-adds only omit roundings.
struct Edge_filter_2
{
  static constexpr double orientation_factor = 8 * 0x1p-53;
  static constexpr double in_circle_factor = 5 * 0x1p-53;
  static constexpr double smallest_s = 1e-120;

  double s, left, right, in_circle;

  BOOST_FORCEINLINE explicit Edge_filter_2(const Edge_corners_2& corners)
  {
    const auto& [a, b, c, d] = corners;
    const double ax = a.x - d.x, ay = a.y - d.y;
    const double bx = b.x - d.x, by = b.y - d.y;
    const double cx = c.x - d.x, cy = c.y - d.y;
    const double bc = bx * cy - cx * by;
    const double ca = cx * ay - ax * cy;
    const double ab = ax * by - bx * ay;
    const double aa = ax * ax + ay * ay;
    const double bb = bx * bx + by * by;
    const double cc = cx * cx + cy * cy;
    s = aa + bb + cc;
    right = -bc;
    left = ab + bc + ca;
    in_circle = aa * bc + bb * ca + cc * ab;
  }

  // True only if both faces are counterclockwise.
  bool proves_counterclockwise() const
  {
    const double bound = orientation_factor * s;
    return (left > bound) & (right > bound) & (s > smallest_s);
  }

  // True only if both faces are counterclockwise and the edge is strictly locally Delaunay.
  bool proves_delaunay() const
  {
    return proves_counterclockwise() & (in_circle < -(in_circle_factor * (s * s)));
  }

  // True only if both faces are counterclockwise and the edge is not locally Delaunay.
  bool proves_illegal() const
  {
    return proves_counterclockwise() & (in_circle > in_circle_factor * (s * s));
  }

  // True only if a face is clockwise, or the edge is not locally Delaunay.
  bool disproves_delaunay() const
  {
    const double bound = orientation_factor * s;
    return ((left < -bound) | (right < -bound) | (in_circle > in_circle_factor * (s * s))) &
           (s > smallest_s);
  }
};

// The sign of orientation(a, b, c) if it is proved, 0 if not. The determinant is the rounded
// difference of two products with three roundings each. So its error is at most 4u T + O(u^2),
// where T is the sum of the products' absolute values. The relative error of the computed T is at
// most 3u. Nothing is proved where products or the bound could underflow.
inline int filtered_orientation(const Position_2& a, const Position_2& b, const Position_2& c)
{
  constexpr double factor = 5 * 0x1p-53, smallest = 1e-280;
  const double p = (a.x - c.x) * (b.y - c.y), q = (b.x - c.x) * (a.y - c.y);
  const double determinant = p - q, t = std::abs(p) + std::abs(q), bound = factor * t;
  const bool is_large = t > smallest;
  return int((determinant > bound) & is_large) - int((determinant < -bound) & is_large);
}

// The same for the side of d of the circle through a, b and c, which must be counterclockwise.
inline int filtered_in_circle(const Position_2& a, const Position_2& b, const Position_2& c,
                              const Position_2& d)
{
  const Edge_filter_2 filter({a, b, c, d});
  const double bound = Edge_filter_2::in_circle_factor * (filter.s * filter.s);
  const bool is_large = filter.s > Edge_filter_2::smallest_s;
  return int((filter.in_circle > bound) & is_large) - int((filter.in_circle < -bound) & is_large);
}

#ifdef CGAL_DYNAMIC_DELAUNAY_HAS_AVX2

// The coordinates of four points, and the corners of four edges.
struct Four_positions_2
{
  __m256d x, y;
};
struct Four_corners_2
{
  Four_positions_2 left, source, target, right;
};

CGAL_DYNAMIC_DELAUNAY_AVX2 Four_positions_2 load_four(const Position_2& p, const Position_2& q,
                                                      const Position_2& r, const Position_2& s)
{
  const __m256d pr =
      _mm256_insertf128_pd(_mm256_castpd128_pd256(_mm_loadu_pd(&p.x)), _mm_loadu_pd(&r.x), 1);
  const __m256d qs =
      _mm256_insertf128_pd(_mm256_castpd128_pd256(_mm_loadu_pd(&q.x)), _mm_loadu_pd(&s.x), 1);
  return {_mm256_unpacklo_pd(pr, qs), _mm256_unpackhi_pd(pr, qs)};
}

// Edge_filter_2 on four edges at once, by the same operations, so that both prove the same edges.
class Edge_filter_avx2_2
{
public:
  using Four = Four_positions_2;
  struct Signs
  {
    __m256d s, left, right, in_circle;
  };

  CGAL_DYNAMIC_DELAUNAY_AVX2 Four minus(const Four& p, const Four& q)
  {
    return {_mm256_sub_pd(p.x, q.x), _mm256_sub_pd(p.y, q.y)};
  }

  CGAL_DYNAMIC_DELAUNAY_AVX2 __m256d times(__m256d a, __m256d b) { return _mm256_mul_pd(a, b); }
  CGAL_DYNAMIC_DELAUNAY_AVX2 __m256d plus(__m256d a, __m256d b) { return _mm256_add_pd(a, b); }
  CGAL_DYNAMIC_DELAUNAY_AVX2 __m256d cross(const Four& p, const Four& q)
  {
    return _mm256_sub_pd(times(p.x, q.y), times(q.x, p.y));
  }
  CGAL_DYNAMIC_DELAUNAY_AVX2 __m256d squared_length(const Four& p)
  {
    return plus(times(p.x, p.x), times(p.y, p.y));
  }
  CGAL_DYNAMIC_DELAUNAY_AVX2 __m256d negative(__m256d a)
  {
    return _mm256_xor_pd(_mm256_set1_pd(-0.0), a);
  }

  // Of the vectors from the right corners to the others.
  CGAL_DYNAMIC_DELAUNAY_AVX2 Signs signs(const Four& a, const Four& b, const Four& c)
  {
    const __m256d bc = cross(b, c), ca = cross(c, a), ab = cross(a, b);
    const __m256d aa = squared_length(a), bb = squared_length(b), cc = squared_length(c);
    return {plus(plus(aa, bb), cc), plus(plus(ab, bc), ca), negative(bc),
            plus(plus(times(aa, bc), times(bb, ca)), times(cc, ab))};
  }

  CGAL_DYNAMIC_DELAUNAY_AVX2 __m256d orientation_bound(const Signs& signs)
  {
    return times(_mm256_set1_pd(Edge_filter_2::orientation_factor), signs.s);
  }
  CGAL_DYNAMIC_DELAUNAY_AVX2 __m256d in_circle_bound(const Signs& signs)
  {
    return times(_mm256_set1_pd(Edge_filter_2::in_circle_factor), times(signs.s, signs.s));
  }

  // Bit i of the result is set if the i-th edge is proved Delaunay.
  CGAL_DYNAMIC_DELAUNAY_AVX2 int prove(const Four_corners_2& corners)
  {
    const Four& d = corners.right;
    const Signs four =
        signs(minus(corners.left, d), minus(corners.source, d), minus(corners.target, d));
    return prove(four, orientation_bound(four), in_circle_bound(four));
  }

  // The same with other bounds.
  CGAL_DYNAMIC_DELAUNAY_AVX2 int prove(const Signs& signs, __m256d orientation_bound,
                                       __m256d in_circle_bound)
  {
    const __m256d is_left = _mm256_cmp_pd(signs.left, orientation_bound, _CMP_GT_OQ);
    const __m256d is_right = _mm256_cmp_pd(signs.right, orientation_bound, _CMP_GT_OQ);
    const __m256d is_empty = _mm256_cmp_pd(signs.in_circle, negative(in_circle_bound), _CMP_LT_OQ);
    const __m256d is_large =
        _mm256_cmp_pd(signs.s, _mm256_set1_pd(Edge_filter_2::smallest_s), _CMP_GT_OQ);
    return _mm256_movemask_pd(
        _mm256_and_pd(_mm256_and_pd(is_empty, is_large), _mm256_and_pd(is_left, is_right)));
  }
};

#endif // CGAL_DYNAMIC_DELAUNAY_HAS_AVX2

} // namespace internal
} // namespace Dynamic_Delaunay_triangulations_2
} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_EDGE_FILTER_2_H

// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_PROOF_EDGE_FILTER_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_PROOF_EDGE_FILTER_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/core/Floating_point_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/core/Processor_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/topology/Halfedge_arrays_2.h>

#include <boost/config.hpp>

#include <cmath>

namespace CGAL {
namespace Dynamic_Delaunay_triangulations_2 {
namespace internal {

// The three signs that decide an edge, in floating point with proved error bounds.
//
// For an edge (b, c) with faces (a, b, c) and (d, c, b):
//
//     left, left_dot      the cross and the dot product of b - a and c - a
//     right, right_dot    those of c - d and b - d
//     in_circle           -(left right_dot + left_dot right)
//
// `left` and `right` are the orientations of the faces. The angle at a has the cotangent left_dot /
// left, the one at d likewise. So between counterclockwise faces `in_circle` is negative if and
// only if these two angles are less than 180 degrees together. Multiplied out it is the in-circle
// determinant of a, b, c and d, so it has its sign wherever the points are. This form takes fewer
// operations than the determinant: the pass over the edges takes a tenth less time.
//
// The bounds. Let u = 2^-53. Each difference, product and sum is rounded once, by a factor between
// 1 - u and 1 + u. Let L = |b - a||c - a| and S = |left| + |left_dot|, as `left_size` is computed.
// By Lagrange's identity left^2 + left_dot^2 = L^2, so L <= S. Let M and T be the same at d.
//
// Orientation. A term of `left` or `left_dot` is a product of two differences: three roundings. The
// sum of the terms is the fourth. So their errors are at most 4u L + O(u^2), as the sum of the
// absolute values of both terms is at most L. The same bound holds at d, with M.
//
// In-circle. The errors of the factors change the two products by at most
//     4u (L |right_dot| + M |left|) + 4u (M |left_dot| + L |right|) <= 8u S T
// and rounding the products and their sum by at most 2u S T. So the error is at most 10u S T +
// O(u^2).
//
// The relative errors of the computed S and T are at most 9u. The computed bounds 5u S, 5u T and
// 11u S T cover all that.
//
// Underflow. Differences are exact then. A product that underflows is off by at most 2^-1075.
// Nothing is proved unless S and T are above 1e-150; for orientations the bound itself is larger.
// So what underflow adds to an error is below 1e-320 S or T, or 1e-320, while u S, u T and u S T,
// by which the computed bounds are too large, are above 1e-166 and 1e-316.
//
// Overflow. No summand is larger than S, T or S T, as rounding is monotonic. So if one overflows,
// the bound is infinite or NaN, as the factor is applied last, and all comparisons below are false.
// If only the sum in `in_circle` overflows, it is far larger than its error.
struct Edge_filter_2
{
  static constexpr double orientation_factor = 5 * 0x1p-53;
  static constexpr double in_circle_factor = 11 * 0x1p-53;
  static constexpr double smallest_size = 1e-150;

  double left, right, left_size, right_size, in_circle;

  BOOST_FORCEINLINE explicit Edge_filter_2(const Edge_corners_2& corners)
  {
    const auto& [a, b, c, d] = corners;
    const double abx = b.x - a.x, aby = b.y - a.y, acx = c.x - a.x, acy = c.y - a.y;
    const double dcx = c.x - d.x, dcy = c.y - d.y, dbx = b.x - d.x, dby = b.y - d.y;
    left = abx * acy - acx * aby;
    right = dcx * dby - dbx * dcy;
    const double left_dot = abx * acx + aby * acy, right_dot = dcx * dbx + dcy * dby;
    left_size = std::abs(left) + std::abs(left_dot);
    right_size = std::abs(right) + std::abs(right_dot);
    in_circle = -(left * right_dot + left_dot * right);
  }

  // How far the signs' values may be off.
  double left_bound() const { return orientation_factor * left_size + smallest_size; }
  double right_bound() const { return orientation_factor * right_size + smallest_size; }
  double in_circle_bound() const { return in_circle_factor * (left_size * right_size); }

  // False where products may have underflowed.
  bool is_large() const { return (left_size > smallest_size) & (right_size > smallest_size); }

  // True only if both faces are counterclockwise.
  bool proves_counterclockwise() const
  {
    const double left_error = left_bound(), right_error = right_bound();
    return (left > left_error) & (right > right_error);
  }

  // True only if both faces are counterclockwise and the edge is strictly locally Delaunay.
  bool proves_delaunay() const
  {
    const bool are_counterclockwise = proves_counterclockwise();
    const double error = in_circle_bound();
    return are_counterclockwise & (in_circle < -error);
  }

  // True only if both faces are counterclockwise and the edge is not locally Delaunay.
  bool proves_illegal() const
  {
    const bool are_counterclockwise = proves_counterclockwise();
    const double error = in_circle_bound();
    return are_counterclockwise & (in_circle > error);
  }

  // True only if a face is clockwise, or the edge is not locally Delaunay.
  bool disproves_delaunay() const
  {
    const double left_error = left_bound(), right_error = right_bound(), error = in_circle_bound();
    const bool has_large_terms = is_large();
    return (left < -left_error) | (right < -right_error) | ((in_circle > error) & has_large_terms);
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

// The proved sign of the side of d of the circle through a, b and c, which must be
// counterclockwise.
inline int filtered_in_circle(const Position_2& a, const Position_2& b, const Position_2& c,
                              const Position_2& d)
{
  const Edge_filter_2 filter({a, b, c, d});
  const double bound = filter.in_circle_bound();
  const bool is_large = filter.is_large();
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
    __m256d left, right, left_size, right_size, in_circle;
  };

  CGAL_DYNAMIC_DELAUNAY_AVX2 Four minus(const Four& p, const Four& q)
  {
    return {_mm256_sub_pd(p.x, q.x), _mm256_sub_pd(p.y, q.y)};
  }

  CGAL_DYNAMIC_DELAUNAY_AVX2 __m256d times(__m256d a, __m256d b) { return _mm256_mul_pd(a, b); }
  CGAL_DYNAMIC_DELAUNAY_AVX2 __m256d plus(__m256d a, __m256d b) { return _mm256_add_pd(a, b); }
  CGAL_DYNAMIC_DELAUNAY_AVX2 __m256d magnitude(__m256d a)
  {
    return _mm256_andnot_pd(_mm256_set1_pd(-0.0), a);
  }
  CGAL_DYNAMIC_DELAUNAY_AVX2 __m256d negative(__m256d a)
  {
    return _mm256_xor_pd(_mm256_set1_pd(-0.0), a);
  }

  // Of the vectors from the left corners to the ends, and from the right corners.
  CGAL_DYNAMIC_DELAUNAY_AVX2 Signs signs(const Four& ab, const Four& ac, const Four& db,
                                         const Four& dc)
  {
    const __m256d left = cross(ab, ac), right = cross(dc, db);
    const __m256d left_dot = dot(ab, ac), right_dot = dot(dc, db);
    return {left, right, plus(magnitude(left), magnitude(left_dot)),
            plus(magnitude(right), magnitude(right_dot)),
            negative(plus(times(left, right_dot), times(left_dot, right)))};
  }

  CGAL_DYNAMIC_DELAUNAY_AVX2 __m256d left_bound(const Signs& four)
  {
    return orientation_bound(four.left_size);
  }
  CGAL_DYNAMIC_DELAUNAY_AVX2 __m256d right_bound(const Signs& four)
  {
    return orientation_bound(four.right_size);
  }
  CGAL_DYNAMIC_DELAUNAY_AVX2 __m256d in_circle_bound(const Signs& four)
  {
    return times(_mm256_set1_pd(Edge_filter_2::in_circle_factor),
                 times(four.left_size, four.right_size));
  }

  // Bit i of the result is set if the i-th edge is proved Delaunay.
  CGAL_DYNAMIC_DELAUNAY_AVX2 int prove(const Four_corners_2& corners)
  {
    const auto& [a, b, c, d] = corners;
    const Signs four = signs(minus(b, a), minus(c, a), minus(b, d), minus(c, d));
    return prove(four, left_bound(four), right_bound(four), in_circle_bound(four));
  }

  // With other bounds.
  CGAL_DYNAMIC_DELAUNAY_AVX2 int prove(const Signs& four, __m256d left_bound, __m256d right_bound,
                                       __m256d in_circle_bound)
  {
    const __m256d is_left = _mm256_cmp_pd(four.left, left_bound, _CMP_GT_OQ);
    const __m256d is_right = _mm256_cmp_pd(four.right, right_bound, _CMP_GT_OQ);
    const __m256d is_empty = _mm256_cmp_pd(four.in_circle, negative(in_circle_bound), _CMP_LT_OQ);
    return _mm256_movemask_pd(_mm256_and_pd(is_empty, _mm256_and_pd(is_left, is_right)));
  }

private:
  CGAL_DYNAMIC_DELAUNAY_AVX2 __m256d cross(const Four& p, const Four& q)
  {
    return _mm256_sub_pd(times(p.x, q.y), times(q.x, p.y));
  }
  CGAL_DYNAMIC_DELAUNAY_AVX2 __m256d dot(const Four& p, const Four& q)
  {
    return plus(times(p.x, q.x), times(p.y, q.y));
  }
  CGAL_DYNAMIC_DELAUNAY_AVX2 __m256d orientation_bound(__m256d size)
  {
    return plus(times(_mm256_set1_pd(Edge_filter_2::orientation_factor), size),
                _mm256_set1_pd(Edge_filter_2::smallest_size));
  }
};

#endif // CGAL_DYNAMIC_DELAUNAY_HAS_AVX2

} // namespace internal
} // namespace Dynamic_Delaunay_triangulations_2
} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_PROOF_EDGE_FILTER_2_H

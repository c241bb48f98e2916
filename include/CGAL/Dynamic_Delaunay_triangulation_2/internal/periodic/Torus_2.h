// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_PERIODIC_TORUS_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_PERIODIC_TORUS_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/core/Flat_arrays_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/core/Processor_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/proof/Edge_filter_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/proof/Edge_test_2.h>
#include <CGAL/enum.h>
#include <CGAL/Number_types/internal/Exact_type_selector.h>
#include <CGAL/Periodic_cell_2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace CGAL {
namespace Dynamic_Delaunay_triangulations_2 {
namespace internal {

inline Periodic_shift_2 operator+(const Periodic_shift_2& s, const Periodic_shift_2& t)
{
  return {s[0] + t[0], s[1] + t[1]};
}
inline Periodic_shift_2 operator-(const Periodic_shift_2& s, const Periodic_shift_2& t)
{
  return {s[0] - t[0], s[1] - t[1]};
}
constexpr Periodic_shift_2 no_shift{0, 0};

// Compilers make a call of a comparison of arrays.
inline bool are_equal(const Periodic_shift_2& s, const Periodic_shift_2& t)
{
  return s[0] == t[0] && s[1] == t[1];
}

// An image of a point: the real numbers `position` + shift[0] a + shift[1] b, never rounded.
struct Image_2
{
  Position_2 position;
  Periodic_shift_2 shift;
};

// The images at the corners of an edge.
struct Edge_images_2
{
  Image_2 left, source, target, right;
};

// The flat torus: the plane, in which the lattice of a cell identifies points.
//
// A slab is the torus whose second vector is infinitely long: H times a's perpendicular (-ay, ax),
// with an H larger than all numbers. Then a sign is that of a polynomial in H, and that of its
// leading coefficient. Faces and edges between images with the same multiple of H are those of the
// slab, and the others fill the gap between its two sides. Nothing else is different in a slab:
// finitely many signs are the same for all H from some finite one on, and there it is a torus.
//
// The filter. Let u = 2^-53. The vector between two images has coordinates D + i a + j b, where D
// is the difference of two coordinates, and i and j are integers. Rounded are the difference, both
// products, their sum, and the whole sum. With m = |D| + |i a| + |j b| the error is at most
// 3u m + O(u^2). Let E be 4u times the largest m of an edge's vectors, which covers the rounding of
// m. Then each computed coordinate is off by at most E.
//
// Edge_filter_2 gets the vectors from the right corner to the others, and takes them for exact. Let
// t be the largest one of the absolute values of their coordinates, and E be below 2^-20 t. In the
// filter's terms
//   - b - d and c - d have coordinates up to t, off by at most E; b - a and c - a up to 2t, off by
//     at most 2E. So `right` and `right_dot` change by at most 4t E + 2 E^2, and `left` and
//     `left_dot` by at most 16t E + 8 E^2, less than 17t E;
//   - the former two are at most 2 t^2, the latter two 8 t^2. So `in_circle` changes by at most
//     2 (8 t^2 4t E + 2 t^2 16t E) = 128 t^3 E in the first order, and less than 135 t^3 E.
// That is added to the bounds of Edge_filter_2, and covers the rounding of these summands, too. If
// E is larger nothing is proved.
//
// Underflow. Products of integers and subnormal numbers are exact, and so are sums of them; for the
// rest, sizes are bounded from below as in Edge_filter_2, so t is above 1e-76 and t^3 E above
// 1e-319, where doubles have three digits. Overflow makes E or t infinite, or NaN.
class Torus_2
{
public:
  explicit Torus_2(const Periodic_cell_2& cell)
    : m_cell(cell)
  {
    const double determinant = cell.ax() * cell.by() - cell.ay() * cell.bx();
    m_inverse_x = {cell.by() / determinant, -cell.bx() / determinant};
    m_inverse_y = {-cell.ay() / determinant, cell.ax() / determinant};
    constexpr double less_than_half = 0.49; // by more than rounding
    m_short_way = less_than_half / largest_multiple(1);
  }

  const Periodic_cell_2& cell() const { return m_cell; }

  // Whether multiples() can be computed.
  bool is_measurable() const
  {
    return std::isfinite(m_inverse_x.x) && std::isfinite(m_inverse_x.y) &&
           std::isfinite(m_inverse_y.x) && std::isfinite(m_inverse_y.y) &&
           (m_cell.is_slab() || (std::isfinite(m_cell.area()) && m_cell.area() > 0));
  }

  // Whether images by these shifts are on different sides of the gap of a slab.
  bool are_across(const Periodic_shift_2& s, const Periodic_shift_2& t) const
  {
    return m_cell.is_slab() && s[1] != t[1];
  }

  // The coordinates of a vector in multiples of the cell's vectors, rounded.
  Position_2 multiples(const Position_2& v) const
  {
    return {v.x * m_inverse_x.x + v.y * m_inverse_x.y, v.x * m_inverse_y.x + v.y * m_inverse_y.y};
  }
  // The reverse.
  Position_2 vector(const Position_2& s) const
  {
    return {s.x * m_cell.ax() + s.y * m_cell.bx(), s.x * m_cell.ay() + s.y * m_cell.by()};
  }

  // What no multiple of a vector of this length exceeds by which the lattice can translate, but for
  // rounding.
  double largest_multiple(double length) const
  {
    const double x = std::hypot(m_inverse_x.x, m_inverse_x.y);
    const double y = m_cell.is_slab() ? 0 : std::hypot(m_inverse_y.x, m_inverse_y.y);
    return length * (std::max)(x, y);
  }

  // True only if no other image is nearer, by multiples, to where such a step goes.
  bool is_short(const Position_2& step) const
  {
    return std::abs(step.x) + std::abs(step.y) <= m_short_way;
  }
  // The largest sum of the absolute coordinates of such a step.
  double short_way() const { return m_short_way; }

  // The multiples by which the lattice can translate: none across a slab.
  Position_2 periodic(const Position_2& multiples) const
  {
    return {multiples.x, m_cell.is_slab() ? 0 : multiples.y};
  }
  Periodic_shift_2 nearest_shift(const Position_2& multiples) const
  {
    const Position_2 m = periodic(multiples);
    return {int(std::lround(m.x)), int(std::lround(m.y))};
  }

  // The image in the cell of a position, rounded.
  Position_2 wrapped(const Position_2& p) const
  {
    const Position_2 m = periodic(multiples(p));
    const Position_2 way = vector({std::floor(m.x), std::floor(m.y)});
    return {p.x - way.x, p.y - way.y};
  }

  // An image as a position, rounded. In a slab it must be on the side where points are given.
  Position_2 rounded(const Image_2& p) const
  {
    return {p.position.x + (p.shift[0] * m_cell.ax() + p.shift[1] * m_cell.bx()),
            p.position.y + (p.shift[0] * m_cell.ay() + p.shift[1] * m_cell.by())};
  }

  bool coincide(const Image_2& p, const Image_2& q) const
  {
    if (are_equal(p.shift, q.shift))
      return p.position.x == q.position.x && p.position.y == q.position.y;
    if (are_across(p.shift, q.shift))
      return false;
    double m = 0;
    const Position_2 v = vector(q, p, m);
    if ((std::max)(std::abs(v.x), std::abs(v.y)) > m * error_factor)
      return false;
    const Exact_vector exact(*this, q, p);
    return CGAL::is_zero(exact.x) && CGAL::is_zero(exact.y);
  }

  // Whether two positions differ by a vector of the lattice.
  bool coincide(const Position_2& p, const Position_2& q) const
  {
    return coincide({p, no_shift}, {q, nearest_shift(multiples({p.x - q.x, p.y - q.y}))});
  }

  Orientation orientation(const Image_2& a, const Image_2& b, const Image_2& c) const
  {
    if (are_across(a.shift, c.shift) || are_across(b.shift, c.shift))
      return exact_orientation(a, b, c);
    double m = 0;
    const Position_2 p = vector(c, a, m), q = vector(c, b, m);
    const double left = p.x * q.y, right = q.x * p.y, e = error_factor * m;
    const double products = std::abs(left) + std::abs(right);
    const double lengths = std::abs(p.x) + std::abs(p.y) + std::abs(q.x) + std::abs(q.y);
    const double bound = 3 * unit * products + 1.01 * e * (lengths + 2 * e);
    const double determinant = left - right;
    if (products > smallest_products && std::abs(determinant) > bound)
      return determinant > 0 ? LEFT_TURN : RIGHT_TURN;
    return exact_orientation(a, b, c);
  }

  // The side of d of the circle through a, b and c, which must be counterclockwise.
  Oriented_side side_of_circle(const Image_2& a, const Image_2& b, const Image_2& c,
                               const Image_2& d) const
  {
    const Filter filter(*this, {a, b, c, d});
    if (filter.proves_inside())
      return ON_POSITIVE_SIDE;
    if (filter.proves_outside())
      return ON_NEGATIVE_SIDE;
    return exact_side_of_circle(a, b, c, d);
  }

  // As `Edge_test_2` has it in the plane. No corner is at infinity.
  Edge_state_2 edge_state(const Edge_images_2& corners) const
  {
    const Filter filter(*this, corners);
    if (filter.proves_delaunay())
      return Edge_state_2::DELAUNAY;
    if (filter.proves_illegal())
      return Edge_state_2::ILLEGAL;
    const auto& [a, b, c, d] = corners;
    const bool is_twisted = orientation(a, b, c) != LEFT_TURN || orientation(d, c, b) != LEFT_TURN;
    if (filter.proves_inside() ||
        (!filter.proves_outside() && exact_side_of_circle(a, b, c, d) == ON_POSITIVE_SIDE))
      return is_twisted ? Edge_state_2::INVERTED : Edge_state_2::ILLEGAL;
    return is_twisted ? Edge_state_2::NOT_FLIPPABLE : Edge_state_2::DELAUNAY;
  }

  bool filter_proves_delaunay(const Edge_images_2& corners) const
  {
    return Filter(*this, corners).proves_delaunay();
  }

  // Of four edges: bit i of the result is set if the i-th one is proved Delaunay.
  int filter_proves_delaunay(const std::array<Edge_images_2, 4>& edges) const
  {
#ifdef CGAL_DYNAMIC_DELAUNAY_HAS_AVX2
    if (has_avx2())
      return Filter_avx2::prove(*this, edges);
#endif
    int proved = 0;
    for (std::size_t i = 0; i < 4; ++i)
      proved |= int(filter_proves_delaunay(edges[i])) << i;
    return proved;
  }

  bool filter_proves_counterclockwise(const Edge_images_2& corners) const
  {
    return Filter(*this, corners).proves_counterclockwise();
  }

  // The corners relative to the right one, rounded, and a bound on the distance by which each of
  // them is off. None may be across a slab.
  std::pair<Edge_corners_2, double> rounded_corners(const Edge_images_2& corners) const
  {
    double m = 0;
    const auto& [a, b, c, d] = corners;
    const Edge_corners_2 rounded{vector(d, a, m), vector(d, b, m), vector(d, c, m), {0, 0}};
    return {rounded, 1.5 * error_factor * m};
  }

  using Exact = CGAL::internal::Exact_ring_selector<double>::Type;
  // A number, or in a slab a polynomial in H: the constant first.
  template <std::size_t degree>
  using Polynomial = std::array<Exact, degree + 1>;

  // Twice the area of the triangle, exactly; negative if it is clockwise.
  Polynomial<1> exact_double_area(const Image_2& a, const Image_2& b, const Image_2& c) const
  {
    return product(Exact_vector(*this, c, a), Exact_vector(*this, c, b));
  }
  // Twice the area of the cell, negative if its vectors are clockwise.
  Polynomial<1> exact_double_area() const
  {
    const Exact ax(m_cell.ax()), ay(m_cell.ay());
    if (m_cell.is_slab())
      return {Exact(0), Exact(2) * (ax * ax + ay * ay)};
    return {Exact(2) * (ax * Exact(m_cell.by()) - ay * Exact(m_cell.bx())), Exact(0)};
  }

  // The vector from one image to another, rounded. Raises m to the largest sum of absolute
  // values: each coordinate is off by at most error_factor times that.
  BOOST_FORCEINLINE Position_2 vector(const Image_2& from, const Image_2& to, double& m) const
  {
    const double i = to.shift[0] - from.shift[0], j = to.shift[1] - from.shift[1];
    const double dx = to.position.x - from.position.x, dy = to.position.y - from.position.y;
    const double iax = i * m_cell.ax(), jbx = j * m_cell.bx();
    const double iay = i * m_cell.ay(), jby = j * m_cell.by();
    const double mx = std::abs(dx) + std::abs(iax) + std::abs(jbx);
    const double my = std::abs(dy) + std::abs(iay) + std::abs(jby);
    const double larger = mx < my ? my : mx;
    m = m < larger ? larger : m;
    return {dx + (iax + jbx), dy + (iay + jby)};
  }

  // The vector from one image to another: (x, y), and in a slab h times H (-ay, ax).
  struct Exact_vector
  {
    Exact_vector(const Torus_2& torus, const Image_2& from, const Image_2& to)
      : x(Exact(to.position.x) - Exact(from.position.x))
      , y(Exact(to.position.y) - Exact(from.position.y))
    {
      const Exact i(double(to.shift[0]) - from.shift[0]), j(double(to.shift[1]) - from.shift[1]);
      const Periodic_cell_2& cell = torus.cell();
      x += i * Exact(cell.ax());
      y += i * Exact(cell.ay());
      if (cell.is_slab()) {
        h = j;
      } else {
        x += j * Exact(cell.bx());
        y += j * Exact(cell.by());
      }
    }
    Exact x, y, h = Exact(0);
  };

  static constexpr double unit = 0x1p-53;
  static constexpr double error_factor = 4 * unit;

private:
  static constexpr double smallest_products = 1e-280;
  // Of the filter, in t.
  static constexpr double orientation_share = 17, in_circle_share = 135, largest_error = 0x1p-20;

  class Filter
  {
  public:
    Filter(const Torus_2& torus, const Edge_images_2& corners)
      : Filter(torus, corners, 0)
    {
    }

    bool proves_counterclockwise() const { return is_counterclockwise; }
    bool proves_delaunay() const { return is_counterclockwise & proves_outside(); }
    bool proves_illegal() const { return is_counterclockwise & proves_inside(); }
    bool proves_inside() const { return is_usable & (m_filter.in_circle > m_in_circle_bound); }
    bool proves_outside() const { return is_usable & (m_filter.in_circle < -m_in_circle_bound); }

  private:
    Filter(const Torus_2& torus, const Edge_images_2& corners, double m)
      : m_vectors{torus.vector(corners.right, corners.left, m),
                  torus.vector(corners.right, corners.source, m),
                  torus.vector(corners.right, corners.target, m), Position_2{0, 0}}
      , m_filter(m_vectors)
    {
      const auto& [a, b, c, d] = m_vectors;
      const double t = (std::max)({std::abs(a.x), std::abs(a.y), std::abs(b.x), std::abs(b.y),
                                   std::abs(c.x), std::abs(c.y)});
      const double e = error_factor * m, more = orientation_share * t * e;
      const double left_error = m_filter.left_bound() + more;
      const double right_error = m_filter.right_bound() + more;
      m_in_circle_bound = m_filter.in_circle_bound() + in_circle_share * (t * t * t) * e;
      is_usable = m_filter.is_large() && e < largest_error * t &&
                  !torus.are_across(corners.left.shift, corners.right.shift) &&
                  !torus.are_across(corners.source.shift, corners.right.shift) &&
                  !torus.are_across(corners.target.shift, corners.right.shift);
      is_counterclockwise =
          is_usable & (m_filter.left > left_error) & (m_filter.right > right_error);
    }

    Edge_corners_2 m_vectors; // from the right corner
    Edge_filter_2 m_filter;
    double m_in_circle_bound;
    bool is_usable, is_counterclockwise;
  };

#ifdef CGAL_DYNAMIC_DELAUNAY_HAS_AVX2

  // Filter on four edges at once, by the same operations, so that both prove the same edges.
  class Filter_avx2
  {
    using Plane = Edge_filter_avx2_2;
    using Four = Four_positions_2;

  public:
    __attribute__((target("avx2"))) static int prove(const Torus_2& torus,
                                                     const std::array<Edge_images_2, 4>& edges)
    {
      const auto& [e, f, g, h] = edges;
      const Four_images d = load(e.right, f.right, g.right, h.right);
      __m256d m = _mm256_setzero_pd(), rows = _mm256_setzero_pd();
      const Four a = vector(torus, d, load(e.left, f.left, g.left, h.left), m, rows);
      const Four b = vector(torus, d, load(e.source, f.source, g.source, h.source), m, rows);
      const Four c = vector(torus, d, load(e.target, f.target, g.target, h.target), m, rows);
      const Plane::Signs signs = Plane::signs(Plane::minus(b, a), Plane::minus(c, a), b, c);
      const __m256d t = _mm256_max_pd(largest(a), _mm256_max_pd(largest(b), largest(c)));
      const __m256d error = times(error_factor, m);
      const __m256d more = Plane::times(times(orientation_share, t), error);
      const __m256d more_in_circle =
          Plane::times(times(in_circle_share, Plane::times(Plane::times(t, t), t)), error);
      const __m256d is_small = _mm256_cmp_pd(error, times(largest_error, t), _CMP_LT_OQ);
      const int is_across =
          torus.m_cell.is_slab()
              ? _mm256_movemask_pd(_mm256_cmp_pd(rows, _mm256_setzero_pd(), _CMP_NEQ_UQ))
              : 0;
      return Plane::prove(signs, Plane::plus(Plane::left_bound(signs), more),
                          Plane::plus(Plane::right_bound(signs), more),
                          Plane::plus(Plane::in_circle_bound(signs), more_in_circle)) &
             _mm256_movemask_pd(is_small) & ~is_across;
    }

  private:
    struct Four_images
    {
      Four position, shift;
    };

    CGAL_DYNAMIC_DELAUNAY_AVX2 __m256d times(double a, __m256d b)
    {
      return Plane::times(_mm256_set1_pd(a), b);
    }
    CGAL_DYNAMIC_DELAUNAY_AVX2 __m256d magnitude(__m256d a, __m256d b, __m256d c)
    {
      return Plane::plus(Plane::plus(Plane::magnitude(a), Plane::magnitude(b)),
                         Plane::magnitude(c));
    }
    CGAL_DYNAMIC_DELAUNAY_AVX2 __m256d largest(const Four& p)
    {
      return _mm256_max_pd(Plane::magnitude(p.x), Plane::magnitude(p.y));
    }

    CGAL_DYNAMIC_DELAUNAY_AVX2 __m128i load_shifts(const Image_2& p, const Image_2& q)
    {
      return _mm_unpacklo_epi64(_mm_loadl_epi64(reinterpret_cast<const __m128i*>(p.shift.data())),
                                _mm_loadl_epi64(reinterpret_cast<const __m128i*>(q.shift.data())));
    }

    CGAL_DYNAMIC_DELAUNAY_AVX2 Four_images load(const Image_2& p, const Image_2& q,
                                                const Image_2& r, const Image_2& s)
    {
      const __m128 pq = _mm_castsi128_ps(load_shifts(p, q));
      const __m128 rs = _mm_castsi128_ps(load_shifts(r, s));
      return {load_four(p.position, q.position, r.position, s.position),
              {_mm256_cvtepi32_pd(_mm_castps_si128(_mm_shuffle_ps(pq, rs, 0x88))),
               _mm256_cvtepi32_pd(_mm_castps_si128(_mm_shuffle_ps(pq, rs, 0xdd)))}};
    }

    // Also raises `rows` where the images are in different rows of cells.
    CGAL_DYNAMIC_DELAUNAY_AVX2 Four vector(const Torus_2& torus, const Four_images& from,
                                           const Four_images& to, __m256d& m, __m256d& rows)
    {
      const Periodic_cell_2& cell = torus.m_cell;
      const auto [dx, dy] = Plane::minus(to.position, from.position);
      const auto [i, j] = Plane::minus(to.shift, from.shift);
      const __m256d iax = times(cell.ax(), i), jbx = times(cell.bx(), j);
      const __m256d iay = times(cell.ay(), i), jby = times(cell.by(), j);
      m = _mm256_max_pd(m, _mm256_max_pd(magnitude(dx, iax, jbx), magnitude(dy, iay, jby)));
      rows = Plane::plus(rows, Plane::magnitude(j));
      return {Plane::plus(dx, Plane::plus(iax, jbx)), Plane::plus(dy, Plane::plus(iay, jby))};
    }
  };

#endif // CGAL_DYNAMIC_DELAUNAY_HAS_AVX2

  // The cross product.
  Polynomial<1> product(const Exact_vector& p, const Exact_vector& q) const
  {
    const Exact bx(-m_cell.ay()), by(m_cell.ax());
    return {p.x * q.y - p.y * q.x, q.h * (p.x * by - p.y * bx) - p.h * (q.x * by - q.y * bx)};
  }

  Polynomial<2> squared_length(const Exact_vector& p) const
  {
    const Exact bx(-m_cell.ay()), by(m_cell.ax());
    return {p.x * p.x + p.y * p.y, Exact(2) * p.h * (p.x * bx + p.y * by),
            p.h * p.h * (bx * bx + by * by)};
  }

  template <std::size_t size>
  static Sign sign_of(const std::array<Exact, size>& polynomial)
  {
    for (std::size_t i = size; i-- > 1;)
      if (!CGAL::is_zero(polynomial[i]))
        return CGAL::sign(polynomial[i]);
    return CGAL::sign(polynomial[0]);
  }

  BOOST_NOINLINE Orientation exact_orientation(const Image_2& a, const Image_2& b,
                                               const Image_2& c) const
  {
    return sign_of(exact_double_area(a, b, c));
  }

  BOOST_NOINLINE Oriented_side exact_side_of_circle(const Image_2& a, const Image_2& b,
                                                    const Image_2& c, const Image_2& d) const
  {
    const std::array<Exact_vector, 3> v{Exact_vector(*this, d, a), Exact_vector(*this, d, b),
                                        Exact_vector(*this, d, c)};
    Polynomial<3> determinant{Exact(0), Exact(0), Exact(0), Exact(0)};
    for (std::size_t i = 0; i < 3; ++i) {
      const Polynomial<2> square = squared_length(v[i]);
      const Polynomial<1> area = product(v[(i + 1) % 3], v[(i + 2) % 3]);
      for (std::size_t k = 0; k < 3; ++k)
        for (std::size_t l = 0; l < 2; ++l)
          determinant[k + l] += square[k] * area[l];
    }
    return sign_of(determinant);
  }

  Periodic_cell_2 m_cell;
  Position_2 m_inverse_x, m_inverse_y; // the rows of the inverse matrix
  double m_short_way;
};

} // namespace internal
} // namespace Dynamic_Delaunay_triangulations_2
} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_PERIODIC_TORUS_2_H

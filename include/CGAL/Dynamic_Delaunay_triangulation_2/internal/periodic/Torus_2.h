// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_PERIODIC_TORUS_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_PERIODIC_TORUS_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Flat_arrays.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Edge_filter_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Flat_elements_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Lanes_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/proof/Edge_test_2.h>
#include <CGAL/enum.h>
#include <CGAL/Number_types/internal/Exact_type_selector.h>
#include <CGAL/Periodic_cell_2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

inline Periodic_shift_2 operator+(const Periodic_shift_2& s, const Periodic_shift_2& t)
{
  return {s[0] + t[0], s[1] + t[1]};
}
inline Periodic_shift_2 operator-(const Periodic_shift_2& s, const Periodic_shift_2& t)
{
  return {s[0] - t[0], s[1] - t[1]};
}
constexpr Periodic_shift_2 no_shift{0, 0};

// Compares both numbers, because compilers turn `==` on arrays into a function call.
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

// An image of a vertex.
struct Periodic_site_2
{
  Vertex_index vertex;
  Periodic_shift_2 shift;

  friend bool operator<(const Periodic_site_2& a, const Periodic_site_2& b)
  {
    return a.vertex != b.vertex ? a.vertex < b.vertex : a.shift < b.shift;
  }
  friend bool operator==(const Periodic_site_2& a, const Periodic_site_2& b)
  {
    return a.vertex == b.vertex && are_equal(a.shift, b.shift);
  }
};

// The images at the corners of an edge.
struct Edge_images_2
{
  Image_2 left, source, target, right;
};

// The flat torus: the plane, in which the lattice of a cell identifies points.
//
// A slab is the torus whose second vector is infinitely long: H times a's perpendicular (-ay, ax),
// with an H larger than all numbers. Then each sign is that of a polynomial in H, and so that of
// its leading coefficient. Faces and edges between images with the same multiple of H are those of
// the slab, and the others fill the gap between its two sides. Nothing else is different in a slab:
// finitely many signs are the same for all large enough H, and for such a finite H it is a torus.
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
    const double determinant = product(cell.ax(), cell.by()) - product(cell.ay(), cell.bx());
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
    return {product(v.x, m_inverse_x.x) + product(v.y, m_inverse_x.y),
            product(v.x, m_inverse_y.x) + product(v.y, m_inverse_y.y)};
  }
  // The vector with these multiples, rounded.
  Position_2 vector(const Position_2& s) const
  {
    return {product(s.x, m_cell.ax()) + product(s.y, m_cell.bx()),
            product(s.x, m_cell.ay()) + product(s.y, m_cell.by())};
  }

  // Returns a bound on both numbers in periodic(multiples(v)), for all vectors v of this length, up
  // to rounding.
  double largest_multiple(double length) const
  {
    const double x = std::hypot(m_inverse_x.x, m_inverse_x.y);
    const double y = m_cell.is_slab() ? 0 : std::hypot(m_inverse_y.x, m_inverse_y.y);
    return length * (std::max)(x, y);
  }

  // True only if nearest_shift(multiples(step)) is 0: no other image is nearer, by multiples.
  bool is_short(const Position_2& step) const
  {
    return std::abs(step.x) + std::abs(step.y) <= m_short_way;
  }
  // The largest |x| + |y| of a short step.
  double short_way() const { return m_short_way; }

  // The multiples in the directions in which the lattice can translate: 0 across a slab.
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
    const Position_2 way = vector({double(p.shift[0]), double(p.shift[1])});
    return {p.position.x + way.x, p.position.y + way.y};
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
      return orientation_across(a, b, c);
    double m = 0;
    const Position_2 p = vector(c, a, m), q = vector(c, b, m);
    const double left = product(p.x, q.y), right = product(q.x, p.y), e = error_factor * m;
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
    const Edge_images_2 corners{a, b, c, d};
    const Filter<1> filter(*this, &corners);
    if (filter.proves_inside())
      return ON_POSITIVE_SIDE;
    if (filter.proves_outside())
      return ON_NEGATIVE_SIDE;
    return unfiltered_side_of_circle(a, b, c, d);
  }

  // The state of an edge, as `Edge_test_2` defines it in the plane. No corner is at infinity.
  Edge_state_2 edge_state(const Edge_images_2& corners) const
  {
    const Filter<1> filter(*this, &corners);
    if (filter.proves_delaunay())
      return Edge_state_2::DELAUNAY;
    if (filter.proves_illegal())
      return Edge_state_2::ILLEGAL;
    const auto& [a, b, c, d] = corners;
    const bool is_twisted = orientation(a, b, c) != LEFT_TURN || orientation(d, c, b) != LEFT_TURN;
    if (filter.proves_inside() ||
        (!filter.proves_outside() && unfiltered_side_of_circle(a, b, c, d) == ON_POSITIVE_SIDE))
      return is_twisted ? Edge_state_2::INVERTED : Edge_state_2::ILLEGAL;
    return is_twisted ? Edge_state_2::NOT_FLIPPABLE : Edge_state_2::DELAUNAY;
  }

  bool filter_proves_delaunay(const Edge_images_2& corners) const
  {
    return Filter<1>(*this, &corners).proves_delaunay();
  }

  // Tests four edges: bit i of the result is set if edges[i] is proved Delaunay.
  int filter_proves_delaunay(const std::array<Edge_images_2, 4>& edges) const
  {
    return call_with_lanes([&](auto lanes) CGAL_DYNAMIC_DELAUNAY_INLINE {
      constexpr int at_once = (std::min)(int(lanes), 4);
      unsigned proved = 0;
      for (int i = 0; i < 4; i += at_once)
        proved |= bits(Filter<at_once>(*this, &edges[std::size_t(i)]).proves_delaunay()) << i;
      return int(proved);
    });
  }

  bool filter_proves_counterclockwise(const Edge_images_2& corners) const
  {
    return Filter<1>(*this, &corners).proves_counterclockwise();
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
  // A number, or in a slab a polynomial in H: the constant coefficient first.
  template <std::size_t degree>
  using Polynomial = std::array<Exact, degree + 1>;

  // Twice the area of the triangle, exactly; negative if it is clockwise.
  Polynomial<1> exact_double_area(const Image_2& a, const Image_2& b, const Image_2& c) const
  {
    return cross(Exact_vector(*this, c, a), Exact_vector(*this, c, b));
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
  // values: each coordinate is off by at most error_factor m.
  BOOST_FORCEINLINE Position_2 vector(const Image_2& from, const Image_2& to, double& m) const
  {
    double rows = 0;
    const auto [x, y] =
        vector(Images<double>{in_one_lane(from.position), in_one_lane(from.shift)},
               Images<double>{in_one_lane(to.position), in_one_lane(to.shift)}, m, rows);
    return {x, y};
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
  // The filter's 17 t E, 135 t^3 E, and limit of 2^-20 t on E.
  static constexpr double orientation_share = 17, in_circle_share = 135, largest_error = 0x1p-20;

  template <class Number>
  struct Images
  {
    Points_in_lanes_2<Number> position, shift;
  };

  // The images at this corner of the edges: that of edges[i] is in lane i.
  template <int lanes>
  BOOST_FORCEINLINE static Images<Lanes<lanes>> images(const Edge_images_2* edges,
                                                       Image_2 Edge_images_2::*corner)
  {
    return {
        points_in_lanes<lanes>([&](int i) CGAL_DYNAMIC_DELAUNAY_INLINE -> const Position_2& {
          return (edges[i].*corner).position;
        }),
        points_in_lanes<lanes>([&](int i) CGAL_DYNAMIC_DELAUNAY_INLINE -> const Periodic_shift_2& {
          return (edges[i].*corner).shift;
        })};
  }

  // Also raises `rows` where the images are in different rows of cells.
  template <class Number>
  BOOST_FORCEINLINE Points_in_lanes_2<Number>
  vector(const Images<Number>& from, const Images<Number>& to, Number& m, Number& rows) const
  {
    const auto [dx, dy] = to.position - from.position;
    const auto [i, j] = to.shift - from.shift;
    const Number iax = product(i, m_cell.ax()), jbx = product(j, m_cell.bx());
    const Number iay = product(i, m_cell.ay()), jby = product(j, m_cell.by());
    rows = rows + magnitude(j);
    m = larger(m, larger(magnitude(dx) + magnitude(iax) + magnitude(jbx),
                         magnitude(dy) + magnitude(iay) + magnitude(jby)));
    return {dx + (iax + jbx), dy + (iay + jby)};
  }

  // The filter for one edge in each lane.
  template <int lanes>
  class Filter
  {
    using Number = Lanes<lanes>;
    using Points = Points_in_lanes_2<Number>;
    using Plane_filter = Edge_filter_in_lanes_2<Number>;
    using Answers = typename Plane_filter::Answers;

  public:
    BOOST_FORCEINLINE Filter(const Torus_2& torus, const Edge_images_2* edges)
      : Filter(torus, edges, images<lanes>(edges, &Edge_images_2::right), 0, 0)
    {
    }

    BOOST_FORCEINLINE Answers proves_counterclockwise() const
    {
      const Number more = product(product(orientation_share, m_size), m_error);
      const Number left_error = m_filter.left_bound() + more;
      const Number right_error = m_filter.right_bound() + more;
      return m_is_usable & (m_filter.left > left_error) & (m_filter.right > right_error);
    }
    BOOST_FORCEINLINE Answers proves_delaunay() const
    {
      return is_outside(proves_counterclockwise());
    }
    BOOST_FORCEINLINE Answers proves_illegal() const
    {
      return is_inside(proves_counterclockwise());
    }
    BOOST_FORCEINLINE Answers proves_inside() const { return is_inside(has_large_terms()); }
    BOOST_FORCEINLINE Answers proves_outside() const { return is_outside(has_large_terms()); }

  private:
    BOOST_FORCEINLINE Filter(const Torus_2& torus, const Edge_images_2* edges,
                             const Images<Number>& d, Number m, Number rows)
      : m_a(torus.vector(d, images<lanes>(edges, &Edge_images_2::left), m, rows))
      , m_b(torus.vector(d, images<lanes>(edges, &Edge_images_2::source), m, rows))
      , m_c(torus.vector(d, images<lanes>(edges, &Edge_images_2::target), m, rows))
      , m_filter(m_b - m_a, m_c - m_a, m_b, m_c)
      , m_size(larger(largest(m_a), larger(largest(m_b), largest(m_c))))
      , m_error(product(error_factor, m))
      , m_is_usable(m_error < product(largest_error, m_size))
    {
      if (torus.cell().is_slab())
        m_is_usable = m_is_usable & (rows == Number(0));
    }

    BOOST_FORCEINLINE static Number largest(const Points& p)
    {
      return larger(magnitude(p.x), magnitude(p.y));
    }

    BOOST_FORCEINLINE Answers has_large_terms() const
    {
      const Answers are_large = m_filter.is_large();
      return m_is_usable & are_large;
    }
    BOOST_FORCEINLINE Answers is_inside(const Answers& is_known) const
    {
      const Number error = in_circle_bound();
      return is_known & (m_filter.in_circle > error);
    }
    BOOST_FORCEINLINE Answers is_outside(const Answers& is_known) const
    {
      const Number error = in_circle_bound();
      return is_known & (m_filter.in_circle < -error);
    }
    BOOST_FORCEINLINE Number in_circle_bound() const
    {
      const Number cube = product(product(m_size, m_size), m_size);
      return m_filter.in_circle_bound() + product(product(in_circle_share, cube), m_error);
    }

    Points m_a, m_b, m_c; // from the right corner
    Plane_filter m_filter;
    Number m_size, m_error;
    Answers m_is_usable;
  };

  Polynomial<1> cross(const Exact_vector& p, const Exact_vector& q) const
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

  // ACROSS THE GAP OF A SLAB --------------------------------------------------------------------

  // These functions find signs of polynomials in H by their leading coefficients. A row is the set
  // of all images by the same multiple of the second vector. Without rounding, each sign would take
  // a microsecond, and points along a wall have several edges across the gap for each point.

  // If p and q are in one row, and r is k rows away, the leading coefficient is k (q - p) a.
  Orientation orientation_across(const Image_2& a, const Image_2& b, const Image_2& c) const
  {
    const auto turn = [this](const Image_2& p, const Image_2& q, const Image_2& r) {
      return sign_along(p, q) * sign_of_rows(p, r);
    };
    Sign sign = ZERO;
    if (a.shift[1] == b.shift[1])
      sign = turn(a, b, c);
    else if (b.shift[1] == c.shift[1])
      sign = turn(b, c, a);
    else if (c.shift[1] == a.shift[1])
      sign = turn(c, a, b);
    return sign != ZERO ? sign : exact_orientation(a, b, c);
  }

  Oriented_side unfiltered_side_of_circle(const Image_2& a, const Image_2& b, const Image_2& c,
                                          const Image_2& d) const
  {
    std::optional<Sign> sign;
    if (m_cell.is_slab())
      sign = side_of_circle_across({a, b, c, d});
    return sign ? *sign : exact_side_of_circle(a, b, c, d);
  }

  // Returns the side of p[3] if three corners are in one row, or two in each of two rows, and that
  // decides it; else nothing. Sorts the corners by rows: exchanging two of them changes the sign.
  std::optional<Sign> side_of_circle_across(std::array<Image_2, 4> p) const
  {
    Sign sign = POSITIVE;
    const auto exchange = [&](std::size_t i, std::size_t k) {
      std::swap(p[i], p[k]);
      sign = -sign;
    };
    const auto row = [&](std::size_t i) { return p[i].shift[1]; };
    for (std::size_t sorted = 1; sorted < 4; ++sorted)
      for (std::size_t i = sorted; i > 0 && row(i) < row(i - 1); --i)
        exchange(i, i - 1);
    std::optional<Sign> side;
    if (row(0) != row(1) && row(1) == row(3))
      exchange(0, 3);
    if (row(0) == row(2) && row(2) != row(3))
      side = side_of_far_point(p[0], p[1], p[2], p[3]);
    else if (row(0) == row(1) && row(1) != row(2) && row(2) == row(3))
      side = side_of_opposite_pair(p[0], p[2], p[3], p[1]);
    return side ? sign * *side : side;
  }

  // The side of d, which is k rows away from the others. Let u and v go from c to a and b, and w be
  // the slab's vector. The leading coefficient is -k^2 w^2 (u x v) or, if that is 0,
  // -k (u^2 (v w) - v^2 (u w)). Where u and v go s and t along w, that is -k |w| s t (s - t).
  std::optional<Sign> side_of_far_point(const Image_2& a, const Image_2& b, const Image_2& c,
                                        const Image_2& d) const
  {
    if (are_in_line(a, b) && are_in_line(b, c)) {
      const Sign sign = sign_of_rows(d, a) * sign_along(c, a) * sign_along(c, b) * sign_along(b, a);
      return sign != ZERO ? std::optional<Sign>(sign) : std::nullopt;
    }
    const Orientation turn = orientation(a, b, c);
    return turn != COLLINEAR ? std::optional<Sign>(-turn) : std::nullopt;
  }

  // The side of d if b and c are k rows away from a and d. If a and d are on a line along the slab,
  // and b and c as well, the leading coefficient is 2k times the product of three steps along the
  // slab: from d to a, from b to c, and from the middle of a and d to that of b and c. If it is 0,
  // the four corners are on a circle.
  std::optional<Sign> side_of_opposite_pair(const Image_2& a, const Image_2& b, const Image_2& c,
                                            const Image_2& d) const
  {
    const Sign pairs = sign_along(d, a) * sign_along(b, c);
    if (pairs == ZERO || !are_in_line(a, d) || !are_in_line(b, c))
      return {};
    return pairs * sign_of_rows(d, b) * sign_of_middles(a, b, c, d);
  }

  // True if the slab is along an axis, and p and q are on one line along it.
  bool are_in_line(const Image_2& p, const Image_2& q) const
  {
    return (m_cell.ay() == 0 && p.position.y == q.position.y) ||
           (m_cell.ax() == 0 && p.position.x == q.position.x);
  }

  // The sign of the number of rows from p to q.
  static Sign sign_of_rows(const Image_2& p, const Image_2& q)
  {
    return CGAL::sign(q.shift[1] - p.shift[1]);
  }

  // The sign of (q - p) a, if both are in one row. The rounding of products and sum adds less than
  // the error of the vector does.
  Sign sign_along(const Image_2& p, const Image_2& q) const
  {
    double m = 0;
    const Position_2 v = vector(p, q, m);
    const double along = product(v.x, m_cell.ax()) + product(v.y, m_cell.ay());
    const double size = std::abs(m_cell.ax()) + std::abs(m_cell.ay());
    const double bound = 2 * error_factor * m * size;
    if (bound > smallest_products && std::abs(along) > bound)
      return CGAL::sign(along);
    const Exact_vector exact(*this, p, q);
    return CGAL::sign(exact.x * Exact(m_cell.ax()) + exact.y * Exact(m_cell.ay()));
  }

  // The sign of (b + c - a - d) a for rows along an axis.
  Sign sign_of_middles(const Image_2& a, const Image_2& b, const Image_2& c, const Image_2& d) const
  {
    const auto along = [&](const auto& v) { return m_cell.ay() == 0 ? v.x : v.y; };
    const Sign of_vector = CGAL::sign(along(Position_2{m_cell.ax(), m_cell.ay()}));
    double m = 0;
    const double sum = along(vector(d, b, m)) + along(vector(a, c, m));
    if (std::abs(sum) > 3 * error_factor * m)
      return CGAL::sign(sum) * of_vector;
    return CGAL::sign(along(Exact_vector(*this, d, b)) + along(Exact_vector(*this, a, c))) *
           of_vector;
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
      const Polynomial<1> area = cross(v[(i + 1) % 3], v[(i + 2) % 3]);
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

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_PERIODIC_TORUS_2_H

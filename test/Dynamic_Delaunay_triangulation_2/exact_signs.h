// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The signs of the predicates for any finite doubles, in integers: nothing is shared with the
// kernels or with the number types below them.

#ifndef DYNAMIC_DELAUNAY_TRIANGULATION_2_TEST_EXACT_SIGNS_H
#define DYNAMIC_DELAUNAY_TRIANGULATION_2_TEST_EXACT_SIGNS_H

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/topology/Halfedge_arrays_2.h>

#include <boost/multiprecision/cpp_int.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace exact_signs {

using Integer = boost::multiprecision::cpp_int;
using Position = CGAL::Dynamic_Delaunay_triangulations_2::Position_2;

struct Vector
{
  Integer x, y;

  Vector operator-(const Vector& other) const { return {x - other.x, y - other.y}; }
};

// A double is an integer of 53 bits times a power of two.
inline int exponent(double x)
{
  return x == 0 ? (std::numeric_limits<int>::max)() : (std::max)(std::ilogb(x), -1022) - 52;
}

// Doubles times one power of two, the least that makes integers of them all: it changes no sign.
template <std::size_t n>
std::array<Vector, n> as_integers(const std::array<Position, n>& positions)
{
  int lowest = (std::numeric_limits<int>::max)();
  for (const Position& p : positions)
    lowest = (std::min)({lowest, exponent(p.x), exponent(p.y)});
  const auto integer = [&](double x) {
    if (x == 0)
      return Integer(0);
    const int own = exponent(x);
    const auto digits = std::int64_t(std::ldexp(std::abs(x), -own));
    const Integer shifted = Integer(digits) << unsigned(own - lowest);
    return x < 0 ? Integer(-shifted) : shifted;
  };
  std::array<Vector, n> result;
  for (std::size_t i = 0; i < n; ++i)
    result[i] = {integer(positions[i].x), integer(positions[i].y)};
  return result;
}

inline Integer cross(const Vector& u, const Vector& v)
{
  return u.x * v.y - u.y * v.x;
}

inline Integer square(const Vector& u)
{
  return u.x * u.x + u.y * u.y;
}

// 1 for a left turn.
inline int orientation(const Position& a, const Position& b, const Position& c)
{
  const auto [p, q, r] = as_integers<3>({a, b, c});
  return cross(q - p, r - p).sign();
}

// 1 if d is inside the circle through a, b, c, which is given counterclockwise.
inline int side_of_circle(const Position& a, const Position& b, const Position& c,
                          const Position& d)
{
  const auto [p, q, r, o] = as_integers<4>({a, b, c, d});
  const Vector u = p - o, v = q - o, w = r - o;
  const Integer in_circle =
      square(u) * cross(v, w) + square(v) * cross(w, u) + square(w) * cross(u, v);
  return in_circle.sign();
}

// The sign of |pq| - t, for t >= 0.
inline int compare_distance(const Position& p, const Position& q, double t)
{
  const auto [u, v, w] = as_integers<3>({p, q, Position{t, 0}});
  return Integer(square(u - v) - w.x * w.x).sign();
}

} // namespace exact_signs

#endif // DYNAMIC_DELAUNAY_TRIANGULATION_2_TEST_EXACT_SIGNS_H

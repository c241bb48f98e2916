// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_QUERIES_SCALED_SITES_3_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_QUERIES_SCALED_SITES_3_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Exact_number_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/passes/Elements_3.h>
#include <CGAL/number_type_basic.h>

#include <algorithm>
#include <cmath>
#include <type_traits>
#include <utility>

namespace CGAL::Dynamic_Delaunay_triangulations_3::internal {

inline double dot(const Position_3& p, const Position_3& q)
{
  return p.x * q.x + p.y * q.y + p.z * q.z;
}
inline Position_3 cross(const Position_3& p, const Position_3& q)
{
  return {p.y * q.z - p.z * q.y, p.z * q.x - p.x * q.z, p.x * q.y - p.y * q.x};
}
inline double largest_coordinate(const Position_3& p)
{
  return (std::max)({std::abs(p.x), std::abs(p.y), std::abs(p.z)});
}

// Squares of tiny vectors underflow.
inline double length_of(const Position_3& p)
{
  const double square = squared_length(p);
  return square > 1e-290 ? std::sqrt(square) : std::hypot(p.x, p.y, p.z);
}

inline Position_3 divided(const Position_3& p, double by)
{
  return {p.x / by, p.y / by, p.z / by};
}

// All x with normal * x = distance, where the normal has the length 1.
struct Plane_3
{
  Position_3 normal;
  double distance;
};

// The vertices in units of a power of two, in which the largest coordinate is about 1. So
// coordinates stay exact, and products of several of them overflow nowhere; they underflow only
// where points are closer to each other than 1e-50 of the largest coordinate.
template <class State>
class Scaled_sites_3
{
  using Coordinate = std::decay_t<decltype(std::declval<typename State::Point>().x())>;
  using Exact = Dynamic_Delaunay_triangulations_2::internal::Exact_number_2<Coordinate>;

public:
  using Number = typename Exact::Type;
  struct Exact_vector
  {
    Number x, y, z;
  };

  // The unit suits other coordinates of this size, too.
  explicit Scaled_sites_3(const State& state, double size = 0)
    : m_state(state)
  {
    for (Vertex_index v(1); v <= state.number_of_vertices(); ++v)
      size = (std::max)(size, largest_coordinate(state.positions.position(v)));
    // both powers of two are doubles
    const int exponent = size > 0 ? (std::min)((std::max)(std::ilogb(size), -1000), 1000) : 0;
    m_unit = std::ldexp(1.0, exponent);
    m_scale = std::ldexp(1.0, -exponent);
  }

  const State& state() const { return m_state; }
  double unit() const { return m_unit; }
  Position_3 scaled(const Position_3& p) const { return m_scale * p; }
  Position_3 at(Vertex_index v) const { return scaled(m_state.positions.position(v)); }

  // The vector from v to w. Differences of doubles are rounded once. Points that are not doubles
  // may have equal ones, so they are subtracted first.
  Position_3 vector(Vertex_index v, Vertex_index w) const
  {
    return m_state.positions_are_exact ? at(w) - at(v) : rounded(exact_vector(v, w));
  }
  Exact_vector exact_vector(Vertex_index v, Vertex_index w) const
  {
    const auto& p = m_state.point(v);
    const auto& q = m_state.point(w);
    return {Number(Exact::of(q.x()) - Exact::of(p.x())),
            Number(Exact::of(q.y()) - Exact::of(p.y())),
            Number(Exact::of(q.z()) - Exact::of(p.z()))};
  }
  // The scale comes first: else a number may be too large for a double.
  Position_3 rounded(const Exact_vector& v) const
  {
    const Number scale(m_scale);
    return {CGAL::to_double(Number(scale * v.x)), CGAL::to_double(Number(scale * v.y)),
            CGAL::to_double(Number(scale * v.z))};
  }

  // The bisector of v and w, relative to v. Its normal is that from v to w.
  Plane_3 bisector(Vertex_index v, Vertex_index w) const
  {
    const Position_3 way = vector(v, w);
    const double length = length_of(way);
    if (length > 1e-300) // else digits are lost
      return {divided(way, length), length / 2};
    const Exact_vector exact = exact_vector(v, w);
    return {direction(exact, size_of(exact)), length / 2};
  }

  // The same relative to an origin, rounded at the end.
  Plane_3 bisector(Vertex_index v, Vertex_index w, const Position_3& origin) const
  {
    const auto& p = m_state.point(v);
    const auto& q = m_state.point(w);
    const Exact_vector way = exact_vector(v, w);
    const auto doubled_middle = [&](const Coordinate& from, const Coordinate& to, double c) {
      return Number(Exact::of(from) + Exact::of(to) - Number(2 * c) * Number(m_unit));
    };
    const Number product(way.x * doubled_middle(p.x(), q.x(), origin.x) +
                         way.y * doubled_middle(p.y(), q.y(), origin.y) +
                         way.z * doubled_middle(p.z(), q.z(), origin.z));
    const Number size = size_of(way), half_scale(m_scale / 2);
    return {direction(way, size),
            CGAL::to_double(Number(product * half_scale / size)) / length_of(share(way, size))};
  }

private:
  static Number size_of(const Exact_vector& v)
  {
    return (std::max)({Number(CGAL::abs(v.x)), Number(CGAL::abs(v.y)), Number(CGAL::abs(v.z))});
  }
  // The vector divided by its size.
  static Position_3 share(const Exact_vector& v, const Number& size)
  {
    return {CGAL::to_double(Number(v.x / size)), CGAL::to_double(Number(v.y / size)),
            CGAL::to_double(Number(v.z / size))};
  }
  static Position_3 direction(const Exact_vector& v, const Number& size)
  {
    const Position_3 its = share(v, size);
    return divided(its, length_of(its));
  }

  const State& m_state;
  double m_unit = 1, m_scale = 1;
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_3::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_QUERIES_SCALED_SITES_3_H

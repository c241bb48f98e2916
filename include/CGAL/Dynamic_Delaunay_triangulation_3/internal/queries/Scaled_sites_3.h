// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_QUERIES_SCALED_SITES_3_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_QUERIES_SCALED_SITES_3_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Exact_number_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/passes/Elements_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/proof/Cell_signs_3.h>
#include <CGAL/enum.h>
#include <CGAL/number_type_basic.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
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

// Vectors in units of a power of two, in which the largest coordinate is about 1. So products of
// several of them overflow nowhere; they underflow only where points are closer to each other than
// 1e-50 of the largest coordinate.
template <class Exact_number>
class Scaled_vectors_3
{
public:
  using Number = Exact_number;
  struct Exact_vector
  {
    Number x, y, z;
  };

  double unit() const { return m_unit; }
  Position_3 scaled(const Position_3& p) const { return m_scale * p; }
  // The scale comes first: else a number may be too large for a double.
  Position_3 rounded(const Exact_vector& v) const
  {
    const Number scale(m_scale);
    return {CGAL::to_double(Number(scale * v.x)), CGAL::to_double(Number(scale * v.y)),
            CGAL::to_double(Number(scale * v.z))};
  }

protected:
  // The unit suits coordinates of this size.
  explicit Scaled_vectors_3(double size)
  {
    // both powers of two are doubles
    const int exponent = size > 0 ? (std::min)((std::max)(std::ilogb(size), -1000), 1000) : 0;
    m_unit = std::ldexp(1.0, exponent);
    m_scale = std::ldexp(1.0, -exponent);
  }

  double scale() const { return m_scale; }

  // The bisector of the ends of a vector, relative to where it begins; `exact()` is the vector.
  template <class Exactly>
  static Plane_3 bisector_of(const Position_3& way, const Exactly& exactly)
  {
    const double length = length_of(way);
    if (length > 1e-300) // else digits are lost
      return {divided(way, length), length / 2};
    const Exact_vector exact = exactly();
    return {direction(exact, size_of(exact)), length / 2};
  }

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

private:
  double m_unit = 1, m_scale = 1;
};

// A neighbor in rows by id: the id of its representative, and on a torus the code of the shift of
// its site, as seen from that of the row's vertex.
struct Neighbor_entry_3
{
  Point_id id;
  int code;
};

// The number type of the coordinates of points.
template <class Point>
using Coordinate_of_3 = std::decay_t<decltype(std::declval<const Point&>().x())>;
template <class Point>
using Exact_coordinate_3 =
    Dynamic_Delaunay_triangulations_2::internal::Exact_number_2<Coordinate_of_3<Point>>;

// The geometry of sites, and how users are told them. In open space they are the vertices; there
// is another one for a torus. This is all that differs for cells and lists, beside the charts.
template <class State, class Arrays = typename State::Arrays>
class Scaled_sites_3
  : public Scaled_vectors_3<typename Exact_coordinate_3<typename State::Point>::Type>
{
  using Point = typename State::Point;
  using Coordinate = Coordinate_of_3<Point>;
  using Exact = Exact_coordinate_3<Point>;
  using Base = Scaled_vectors_3<typename Exact::Type>;

public:
  using typename Base::Exact_vector;
  using typename Base::Number;

  // The unit suits other coordinates of this size, too.
  explicit Scaled_sites_3(const State& state, double size = 0)
    : Base(largest_coordinate_of(state, size))
    , m_state(state)
    , m_signs(state)
  {
  }

  const State& state() const { return m_state; }
  Position_3 at(Vertex_index v) const { return this->scaled(m_state.positions.position(v)); }

  // The vector from v to w. Differences of doubles are rounded once. Points that are not doubles
  // may have equal ones, so they are subtracted first.
  Position_3 vector(Vertex_index v, Vertex_index w) const
  {
    return m_state.positions_are_exact ? at(w) - at(v) : this->rounded(exact_vector(v, w));
  }
  Exact_vector exact_vector(Vertex_index v, Vertex_index w) const
  {
    const auto& p = m_state.point(v);
    const auto& q = m_state.point(w);
    return {Number(Exact::of(q.x()) - Exact::of(p.x())),
            Number(Exact::of(q.y()) - Exact::of(p.y())),
            Number(Exact::of(q.z()) - Exact::of(p.z()))};
  }

  // Whether a vertex is on the sphere of a finite cell.
  bool are_on_a_sphere(const Vertices_3& cell, Vertex_index other) const
  {
    return m_signs.side_of_sphere(cell, other) == 0;
  }
  // Whether all of these are in a plane.
  bool are_coplanar(Vertex_index v, Vertex_index w, Vertex_index x, Vertex_index y) const
  {
    return m_state.traits.orientation_3_object()(m_state.point(v), m_state.point(w),
                                                 m_state.point(x), m_state.point(y)) == COPLANAR;
  }

  // The bisector of v and w, relative to v. Its normal is that from v to w.
  Plane_3 bisector(Vertex_index v, Vertex_index w) const
  {
    return this->bisector_of(vector(v, w), [&] { return exact_vector(v, w); });
  }

  // The same relative to an origin, rounded at the end.
  Plane_3 bisector(Vertex_index v, Vertex_index w, const Position_3& origin) const
  {
    const auto& p = m_state.point(v);
    const auto& q = m_state.point(w);
    const Exact_vector way = exact_vector(v, w);
    const auto doubled_middle = [&](const Coordinate& from, const Coordinate& to, double c) {
      return Number(Exact::of(from) + Exact::of(to) - Number(2 * c) * Number(this->unit()));
    };
    const Number product(way.x * doubled_middle(p.x(), q.x(), origin.x) +
                         way.y * doubled_middle(p.y(), q.y(), origin.y) +
                         way.z * doubled_middle(p.z(), q.z(), origin.z));
    const Number size = this->size_of(way), half_scale(this->scale() / 2);
    return {this->direction(way, size), CGAL::to_double(Number(product * half_scale / size)) /
                                            length_of(this->share(way, size))};
  }

  // FOR ROWS BY ID --------------------------------------------------------------------------------

  static constexpr std::size_t shown_shifts = 0; // that users are told with an id

  static Vertex_index site(Vertex_index v) { return v; }
  Neighbor_entry_3 entry(Vertex_index w) const { return {m_state.ids.representative(w), 0}; }
  // Whether an entry of the row of v comes before another one.
  bool is_before(Vertex_index, const Neighbor_entry_3& a, const Neighbor_entry_3& b) const
  {
    return a.id < b.id;
  }
  // Calls f with the shift of an entry of the row of v if users are told it.
  template <class Function>
  void show_shift(Vertex_index, const Neighbor_entry_3&, const Function&) const
  {
  }
  // The vector to an entry, in units of the coordinates.
  Position_3 vector(Vertex_index v, const Neighbor_entry_3& entry) const
  {
    return this->unit() * vector(v, m_state.ids.vertex(entry.id));
  }

  // Where the point of a vertex is, or another one that is covered there.
  const Position_3& given_position(Vertex_index v) const { return m_state.positions.position(v); }
  const Position_3& given_position(Vertex_index v, const Point&) const { return given_position(v); }

private:
  static double largest_coordinate_of(const State& state, double size)
  {
    for (Vertex_index v(1); v <= state.number_of_vertices(); ++v)
      size = (std::max)(size, largest_coordinate(state.positions.position(v)));
    return size;
  }

  const State& m_state;
  const Cell_signs_3<State> m_signs;
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_3::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_QUERIES_SCALED_SITES_3_H

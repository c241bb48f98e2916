// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_PROOF_CELL_SIGNS_3_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_PROOF_CELL_SIGNS_3_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/passes/Cell_filter_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/topology/Tetrahedra_arrays_3.h>

#include <algorithm>
#include <array>
#include <utility>

namespace CGAL::Dynamic_Delaunay_triangulations_3::internal {

// The exact signs that decide cells and facets. A finite cell has the orientation of its vertices,
// an infinite one that of the cone over its hull facet, as the origin sees it: the origin takes the
// place of the infinite vertex, on the other side of the facet, so the sign changes.
template <class State>
class Cell_signs_3
{
  using Point = typename State::Point;

public:
  explicit Cell_signs_3(const State& state)
    : m_state(state)
    , m_orientation(state.traits.orientation_3_object())
    , m_side_of_sphere(state.traits.side_of_oriented_sphere_3_object())
  {
  }

  // 1 if the cell is positive, -1 if it is inverted, 0 if it is flat.
  int of(const Vertices_3& v) const
  {
    for (int i = 0; i < 4; ++i)
      if (v[i] == infinite_index)
        return -sign_from_origin(v, i);
    return int(m_orientation(point(v[0]), point(v[1]), point(v[2]), point(v[3])));
  }
  bool is_positive(const Vertices_3& v) const { return of(v) > 0; }

  // The sign of the cell if `other` took one of the places.
  int with(Vertices_3 v, int place, Vertex_index other) const
  {
    v[place] = other;
    return of(v);
  }

  // 1 if `other` is strictly inside of the sphere of a positive finite cell, 0 if it is on it.
  int side_of_sphere(const Vertices_3& v, Vertex_index other) const
  {
    if (m_state.positions_are_exact)
      if (const int sign = filter_of(v).side_of_sphere(seen_from(v[0], other)))
        return sign;
    return int(m_side_of_sphere(point(v[0]), point(v[1]), point(v[2]), point(v[3]), point(other)));
  }

  // The same without ties: where `other` is on the sphere, as if points were lifted from their
  // paraboloid by amounts of different orders of magnitude, the last one in some order by the
  // largest (Devillers and Teillaud 2003). Then points have one Delaunay triangulation only,
  // without flat cells: that which insertion in this order leads to, if no cell is replaced because
  // of a tie. `other` must not be where a vertex of the cell is.
  template <class Order>
  int side_of_sphere_in_order(const Vertices_3& v, Vertex_index other, const Order& precedes) const
  {
    if (const int sign = side_of_sphere(v, other))
      return sign;
    Few<Vertex_index, 5> sites{v[0], v[1], v[2], v[3], other};
    for (int last = 4; last > 0; --last) { // at most twice: no three on a sphere are collinear
      std::swap(sites[last], *std::max_element(sites.begin(), sites.begin() + last + 1, precedes));
      if (sites[last] == other)
        return -1;
      const int place = int(std::find(v.begin(), v.end(), sites[last]) - v.begin());
      if (const int sign = with(v, place, other))
        return sign;
    }
    return -1;
  }

  // Whether the facet between two positive cells with all vertices but one in common is not locally
  // Delaunay. `other` is the vertex of the second that the first does not have. Ties are legal.
  bool is_illegal(const Vertices_3& first, Vertex_index other) const
  {
    for (int i = 0; i < 4; ++i)
      if (first[i] == infinite_index)
        return other != infinite_index && with(first, i, other) > 0;
    return other != infinite_index && side_of_sphere(first, other) > 0;
  }

  // Calls f(place) for each facet of a cell, of those for which is_wanted(place), that floating
  // point does not prove legal, by the place opposite to it.
  template <class Predicate, class Function>
  void for_each_doubtful(Cell_index c, const Predicate& is_wanted, const Function& f) const
  {
    const Tetrahedra_arrays_3& arrays = m_state.arrays;
    const Vertices_3 v = arrays.vertices(c);
    if (arrays.is_infinite(c) || !m_state.positions_are_exact) {
      for (int i = 0; i < 4; ++i)
        if (is_wanted(i))
          f(i);
      return;
    }
    const auto filter = filter_of(v);
    for (int i = 0; i < 4; ++i)
      if (is_wanted(i) && filter.may_be_inside(seen_from(v[0], arrays.apex(arrays.corner(c, i)))))
        f(i);
  }

  // The orientation of the origin and three points.
  int orientation_from_origin(const Point& p, const Point& q, const Point& r) const
  {
    return int(m_orientation(origin(), p, q, r));
  }

  // The filter of a finite cell, which takes positions as seen from its first vertex.
  Cell_filter_in_lanes_3<double> filter_of(const Vertices_3& v) const
  {
    return {seen_from(v[0], v[1]), seen_from(v[0], v[2]), seen_from(v[0], v[3])};
  }
  Points_in_lanes_3<double> seen_from(Vertex_index origin, Vertex_index v) const
  {
    const Position_3 way = m_state.positions.position(v) - m_state.positions.position(origin);
    return {way.x, way.y, way.z};
  }

private:
  decltype(auto) point(Vertex_index v) const { return m_state.point(v); }
  Point origin() const { return Point(m_state.origin.x, m_state.origin.y, m_state.origin.z); }

  int sign_from_origin(const Vertices_3& v, int place) const
  {
    const auto at = [&](int i) -> Point { return i == place ? origin() : Point(point(v[i])); };
    return int(m_orientation(at(0), at(1), at(2), at(3)));
  }

  const State& m_state;
  typename State::Traits::Orientation_3 m_orientation;
  typename State::Traits::Side_of_oriented_sphere_3 m_side_of_sphere;
};

// The signs of the cells of a state.
template <class State>
struct Signs_of_3
{
  using type = Cell_signs_3<State>;
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_3::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_PROOF_CELL_SIGNS_3_H

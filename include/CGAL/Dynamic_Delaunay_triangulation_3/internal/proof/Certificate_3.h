// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_PROOF_CERTIFICATE_3_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_PROOF_CERTIFICATE_3_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/proof/Cell_signs_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/topology/Tetrahedra_arrays_3.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_3::internal {

// Proves that cells that are all positive cover space once. All of them cover every point equally
// often, infinite ones as cones; so it is enough to count how often one ray from the origin meets
// the hull.
template <class State>
class Hull_count_3
{
public:
  explicit Hull_count_3(const State& state)
    : m_state(state)
    , m_signs(state)
  {
  }

  // Whether a ray meets exactly one of the hull facets of these infinite cells.
  bool is_one(const std::vector<Cell_index>& infinite) const
  {
    // a ray that meets an edge does not count: another one is tried
    for (int attempt = 0; attempt < 32 && !infinite.empty(); ++attempt) {
      const std::size_t some = infinite.size() * std::size_t(attempt) / 32;
      const int number = count(infinite, target(infinite[some], attempt));
      if (number >= 0)
        return number == 1;
    }
    return false;
  }

private:
  using Point = typename State::Point;

  // A point near to the middle of a hull facet.
  Point target(Cell_index c, int attempt) const
  {
    Position_3 sum{0, 0, 0};
    double weight = 1 + 0.1 * attempt, weights = 0;
    for (const Vertex_index v : m_state.arrays.vertices(c))
      if (v != infinite_index) {
        sum = sum + weight * m_state.positions.position(v);
        weights += weight;
        weight *= 1.3;
      }
    sum = (1 / weights) * sum;
    return Point(sum.x, sum.y, sum.z);
  }

  // How many facets the ray from the origin through a point meets; -1 if it meets an edge.
  int count(const std::vector<Cell_index>& infinite, const Point& target) const
  {
    int number = 0;
    for (const Cell_index c : infinite) {
      const int sides = sides_of(c, target);
      if (sides < 0)
        return -1;
      number += sides;
    }
    return number;
  }

  // 1 if the ray meets the facet, 0 if not, -1 if it meets its border.
  int sides_of(Cell_index c, const Point& target) const
  {
    Few<Vertex_index, 3> v = hull_facet(m_state.arrays, c);
    bool is_on_border = false;
    for (int i = 0; i < 3; ++i) {
      const int side = m_signs.orientation_from_origin(m_state.point(v[i]),
                                                       m_state.point(v[(i + 1) % 3]), target);
      if (side < 0)
        return 0;
      is_on_border = is_on_border || side == 0;
    }
    return is_on_border ? -1 : 1;
  }

public:
  // The hull facet of an infinite cell, oriented so that the orientation of a point beneath and the
  // facet is positive.
  static Few<Vertex_index, 3> hull_facet(const Tetrahedra_arrays_3& arrays, Cell_index c)
  {
    const Vertices_3& v = arrays.vertices(c);
    switch (arrays.place_of(c, infinite_index)) {
    case 0:
      return {v[1], v[3], v[2]};
    case 1:
      return {v[0], v[2], v[3]};
    case 2:
      return {v[0], v[3], v[1]};
    default:
      return {v[0], v[1], v[2]};
    }
  }

private:
  const State& m_state;
  Cell_signs_3<State> m_signs;
};

// Tests everything by exact predicates: each corner's mirror, all cells positive, all facets legal,
// and the hull met once. Without an origin, infinite cells are not tested for their sign, nor is
// the hull counted. Cost: about a microsecond a point.
template <class State>
class Certificate_3
{
public:
  explicit Certificate_3(const State& state)
    : m_state(state)
    , m_signs(state)
  {
  }

  // Whether cells fit together, and each vertex has one of its own.
  bool is_combinatorially_valid() const
  {
    const Tetrahedra_arrays_3& arrays = m_state.arrays;
    Column<Vertex_index, char> is_there(arrays.number_of_vertices(), 0);
    for (Cell_index c(0); c < arrays.number_of_cells(); ++c) {
      if (arrays.is_free(c))
        return false;
      for (int i = 0; i < 4; ++i) {
        const Corner_index k = arrays.corner(c, i);
        is_there[arrays.vertex(k)] = 1;
        if (arrays.mirror(arrays.mirror(k)) != k || !fits(k))
          return false;
      }
    }
    for (Vertex_index v(0); v < arrays.number_of_vertices(); ++v)
      if (!is_there[v] || arrays.vertex(arrays.corner_of(v)) != v)
        return false;
    return arrays.number_of_vertices() == m_state.number_of_vertices() + 1;
  }

  bool holds() const
  {
    const Tetrahedra_arrays_3& arrays = m_state.arrays;
    std::vector<Cell_index> infinite;
    for (Cell_index c(0); c < arrays.number_of_cells(); ++c) {
      const bool is_infinite = arrays.is_infinite(c);
      if ((!is_infinite || m_state.has_origin) && !m_signs.is_positive(arrays.vertices(c)))
        return false;
      if (is_infinite)
        infinite.push_back(c);
      for (int i = 0; i < 4; ++i) {
        const Corner_index k = arrays.corner(c, i);
        if (k < arrays.mirror(k) &&
            is_infinite == arrays.is_infinite(arrays.cell_of(arrays.mirror(k))) &&
            m_signs.is_illegal(arrays.vertices(c), arrays.apex(k)))
          return false;
      }
    }
    return !m_state.has_origin || Hull_count_3<State>(m_state).is_one(infinite);
  }

private:
  // Whether the two cells at a facet share its vertices, with opposite orientations.
  bool fits(Corner_index k) const
  {
    const Tetrahedra_arrays_3& arrays = m_state.arrays;
    const Cell_index c = arrays.cell_of(k), other = arrays.cell_of(arrays.mirror(k));
    Few<int, 4> places;
    for (int i = 0; i < 4; ++i)
      places[i] = i == arrays.place_of(k) ? arrays.place_of(arrays.mirror(k))
                                          : arrays.place_of(other, arrays.vertices(c)[i]);
    return c != other && *std::max_element(places.begin(), places.end()) < 4 && !is_even(places);
  }

  const State& m_state;
  Cell_signs_3<State> m_signs;
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_3::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_PROOF_CERTIFICATE_3_H

// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_PERIODIC_WIRES_WIRE_PLANES_3_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_PERIODIC_WIRES_WIRE_PLANES_3_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/periodic/Torus_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/periodic/Torus_shift_3.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_3::internal {

// The points of a wire that has no cells, as they are all in a plane along its vector.
template <class State>
class Wire_planes_3
{
public:
  explicit Wire_planes_3(const State& state)
    : m_state(state)
  {
  }

  // Whether all points are in such a plane.
  bool are_in_one() const
  {
    const Exact_vector_3& a = m_state.torus.exact_vector(0);
    std::optional<Exact_vector_3> normal;
    for (Vertex_index v(2); v < m_state.positions.number(); ++v) {
      const Exact_vector_3 way = way_to(v);
      if (normal && !CGAL::is_zero(dot(*normal, way)))
        return false;
      if (const Exact_vector_3 n = cross(a, way); !normal && !is_zero(n))
        normal = n;
    }
    return true;
  }

  // Lists vertices that coincide with others modulo the wire, each with the first of them.
  void find_covered(std::vector<std::pair<Vertex_index, Vertex_index>>& covered) const
  {
    std::vector<Line_place> places;
    for (Vertex_index v(1); v < m_state.positions.number(); ++v)
      places.push_back(place_on_line(v));
    std::sort(places.begin(), places.end(), [](const Line_place& p, const Line_place& q) {
      return p.key() != q.key() ? p.key() < q.key() : p.vertex < q.vertex;
    });
    for (std::size_t i = 1, first = 0; i < places.size(); ++i)
      if (places[i].key() == places[first].key())
        covered.emplace_back(places[i].vertex, places[first].vertex);
      else
        first = i;
  }

private:
  // The line along the wire that a vertex is on, and where it is there, within a period.
  struct Line_place
  {
    Exact_vector_3 line;
    Exact_number_3 height;
    Vertex_index vertex;

    auto key() const { return std::tie(line.x, line.y, line.z, height); }
  };

  static bool is_zero(const Exact_vector_3& v)
  {
    return CGAL::is_zero(v.x) && CGAL::is_zero(v.y) && CGAL::is_zero(v.z);
  }

  // From the first vertex.
  Exact_vector_3 way_to(Vertex_index v) const
  {
    return m_state.torus.exact_vector(m_state.image({Vertex_index(1), {}}), m_state.image({v, {}}));
  }

  Line_place place_on_line(Vertex_index v) const
  {
    const Exact_vector_3& a = m_state.torus.exact_vector(0);
    const Exact_vector_3 way = way_to(v);
    const Exact_number_3 period = dot(a, a);
    Exact_number_3 height = dot(a, way);
    height = height -
             Exact_number_3(std::floor(CGAL::to_double(height) / CGAL::to_double(period))) * period;
    while (height < Exact_number_3(0)) // the quotient was rounded
      height = height + period;
    while (!(height < period))
      height = height - period;
    return {cross(a, way), height, v};
  }

  const State& m_state;
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_3::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_PERIODIC_WIRES_WIRE_PLANES_3_H

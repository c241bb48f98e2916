// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_PROOF_EXACT_HULL_COUNT_3_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_PROOF_EXACT_HULL_COUNT_3_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/proof/Certificate_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/topology/Tetrahedra_arrays_3.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Simple_cartesian.h>

#include <type_traits>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_3::internal {

// What the origin proves, where no double is strictly inside of the hull, such as for neighboring
// doubles: the origin is a point with exact coordinates instead.
template <class State>
class Exact_hull_count_3
{
public:
  explicit Exact_hull_count_3(const State& state)
    : m_state(state)
  {
  }

  // Whether all infinite cells are positive, as seen from a point inside of some finite cell, and a
  // ray from there meets exactly one hull facet. Finite cells have to be positive.
  bool is_one() const
  {
    std::vector<Facet> facets;
    const Point origin = origin_and_facets(facets);
    for (const Facet& f : facets)
      if (orientation(origin, f[0], f[1], f[2]) != POSITIVE)
        return false;
    // a ray that meets an edge does not count: another one is tried
    for (int attempt = 0; attempt < 32 && !facets.empty(); ++attempt) {
      const Point target = inside_of(facets.front(), attempt);
      const int number = count(facets, origin, target);
      if (number >= 0)
        return number == 1;
    }
    return false;
  }

private:
  using Coordinate = std::decay_t<decltype(std::declval<const typename State::Point&>().x())>;
  using Number =
      std::conditional_t<std::is_floating_point_v<Coordinate>, Exact_rational, Coordinate>;
  using Kernel = Simple_cartesian<Number>;
  using Point = typename Kernel::Point_3;
  using Vector = typename Kernel::Vector_3;
  using Facet = Few<Point, 3>;

  Point exact(Vertex_index v) const
  {
    const auto& p = m_state.point(v);
    return Point(Number(p.x()), Number(p.y()), Number(p.z()));
  }

  // The middle of the first finite cell, and all hull facets.
  Point origin_and_facets(std::vector<Facet>& facets) const
  {
    const Tetrahedra_arrays_3& arrays = m_state.arrays;
    Point origin(0, 0, 0);
    bool has_origin = false;
    for (Cell_index c(0); c < arrays.number_of_cells(); ++c)
      if (arrays.is_infinite(c)) {
        const auto v = Hull_count_3<State>::hull_facet(arrays, c);
        facets.push_back({exact(v[0]), exact(v[1]), exact(v[2])});
      } else if (!has_origin) {
        has_origin = true;
        const Vertices_3& v = arrays.vertices(c);
        const Point a = exact(v[0]);
        origin = a + ((exact(v[1]) - a) + (exact(v[2]) - a) + (exact(v[3]) - a)) / Number(4);
      }
    return origin;
  }

  // Another point for each attempt.
  static Point inside_of(const Facet& f, int attempt)
  {
    const Number share = Number(1) / Number(3 + attempt);
    return f[0] + share * (f[1] - f[0]) + share / Number(2) * (f[2] - f[0]);
  }

  // How many facets the ray from the origin through a point meets; -1 if it meets an edge.
  static int count(const std::vector<Facet>& facets, const Point& origin, const Point& target)
  {
    int number = 0;
    for (const Facet& f : facets) {
      int smallest = 1;
      for (int i = 0; i < 3; ++i)
        smallest = (std::min)(smallest, int(orientation(origin, f[i], f[(i + 1) % 3], target)));
      if (smallest == 0)
        return -1;
      number += smallest > 0;
    }
    return number;
  }

  const State& m_state;
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_3::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_PROOF_EXACT_HULL_COUNT_3_H

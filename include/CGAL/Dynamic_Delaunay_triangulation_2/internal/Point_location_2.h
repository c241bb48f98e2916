// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_POINT_LOCATION_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_POINT_LOCATION_2_H

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Computed_geometry_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Neighborhood_mirror_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Vertex_predicates_2.h>
#include <CGAL/enum.h>

#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Dynamic_Delaunay_triangulations_2 {
namespace internal {

// Where a point is: at a vertex, or else in a face or on its boundary, an infinite one if it is
// outside of the hull.
struct Place_2
{
  Index face = no_index;
  Index vertex = no_index;
};

// Jump and walk (Mücke, Saias and Zhu, 1999): from the nearest of about the cube root of n vertices
// through faces, always across an edge that has the point on its other side. In a Delaunay
// triangulation such a walk meets no face twice. In another one it may not end, or lead nowhere:
// the face is then any one that holds the point, or just any.
template <class Maintained>
class Point_location_2
{
  using Mirror = Neighborhood_mirror_2;

public:
  explicit Point_location_2(const Maintained& maintained)
    : m_maintained(maintained)
    , m_predicates(maintained)
  {
  }

  // Of vertex v, which is in the list, but in no face. `near` is one that is.
  Place_2 locate(Index v, Index near) const
  {
    const Mirror& mirror = m_maintained.mirror;
    Index f = mirror.corner(nearest(v, near)) / 3;
    Index entry = no_index;
    for (Index steps = 0; steps < mirror.number_of_faces(); ++steps) {
      const Index h = way_out(f, v, entry, steps);
      if (h == no_index)
        return place_in(f, v);
      entry = mirror.twin(h);
      f = entry / 3;
    }
    for (Index g = 0; g < mirror.number_of_faces(); ++g)
      if (way_out(g, v, no_index, 0) == no_index)
        return place_in(g, v);
    return place_in(f, v);
  }

private:
  Index nearest(Index v, Index near) const
  {
    const auto& positions = m_maintained.positions;
    const Index vertices = m_maintained.number_of_vertices();
    const Index samples = Index(std::cbrt(double(vertices)));
    Index best = near;
    double smallest = squared_distance(positions[v], positions[near]);
    for (Index i = 0; i < samples; ++i) {
      const Index w = 1 + Index(std::size_t(i) * vertices / samples);
      const double square = squared_distance(positions[v], positions[w]);
      if (w != v && square < smallest) {
        smallest = square;
        best = w;
      }
    }
    return best;
  }

  // The edge of face f, other than the one that the walk came in by, that v is beyond; `no_index`
  // if v is in the face. Which edge is looked at first depends on `turn`: a walk that always
  // prefers the same one can take detours.
  Index way_out(Index f, Index v, Index entry, Index turn) const
  {
    const Mirror& mirror = m_maintained.mirror;
    for (Index i = 0; i < 3; ++i) // an infinite face has one finite edge
      if (mirror.apex(3 * f + i) == infinite_index)
        return orientation(3 * f + i, v) == LEFT_TURN ? no_index : 3 * f + i;
    for (Index i = 0; i < 3; ++i) {
      const Index h = 3 * f + (i + turn) % 3;
      if (h != entry && orientation(h, v) == RIGHT_TURN)
        return h;
    }
    return no_index;
  }

  Orientation orientation(Index h, Index v) const
  {
    const Mirror& mirror = m_maintained.mirror;
    return m_predicates.orientation(mirror.source(h), mirror.target(h), v);
  }

  Place_2 place_in(Index f, Index v) const
  {
    Place_2 place;
    for (const Index w : m_maintained.mirror.face(f))
      if (w != infinite_index && m_predicates.compare_xy(v, w) == EQUAL)
        place.vertex = w;
    place.face = f;
    return place;
  }

  const Maintained& m_maintained;
  Vertex_predicates_2<Maintained> m_predicates;
};

} // namespace internal
} // namespace Dynamic_Delaunay_triangulations_2
} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_POINT_LOCATION_2_H

// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_POINT_LOCATION_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_POINT_LOCATION_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

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
  Index steps = 0; // that it took to find it
};

// Jump and walk (Mücke, Saias and Zhu, 1999): from the nearest of some vertices through faces,
// always across an edge that has the point on its other side. In a Delaunay triangulation such a
// walk meets no face twice. In another one it may not end, or lead nowhere: the face is then any
// one that holds the point, or just any.
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

  // Of vertex v, which is in no face. `nearby` is a finite one that is in some; the vertices around
  // v may be expected to have numbers that differ from its by no more than `spread`.
  Place_2 locate(Index v, Index nearby, Index spread) const
  {
    const Mirror& mirror = m_maintained.mirror();
    Index f = mirror.corner(nearest(v, nearby, spread)) / 3;
    Index entry = no_index;
    Index steps = 0;
    for (; steps < mirror.number_of_faces(); ++steps) {
      const Index h = way_out(f, v, entry, steps);
      if (h == no_index)
        return place_in(f, v, steps);
      entry = mirror.twin(h);
      f = entry / 3;
    }
    for (Index g = 0; g < mirror.number_of_faces(); ++g)
      if (!mirror.is_empty_face(g) && way_out(g, v, no_index, 0) == no_index)
        return place_in(g, v, steps);
    return place_in(f, v, steps);
  }

private:
  // The nearest vertex to v that a search finds: first, if `nearby` says little, among about the
  // cube root of n vertices, evenly spread over their numbers, then around the best one, at ever
  // smaller steps, as the numbers follow a curve through the plane. At 100,000 points the second
  // part takes as long as two steps of the walk, and saves some forty.
  Index nearest(Index v, Index nearby, Index spread) const
  {
    const Index vertices = m_maintained.number_of_vertices();
    const Index samples = Index(std::cbrt(double(vertices)));
    Nearest best{v, nearby, squared_distance(position(v), position(nearby))};
    if (samples > 0 && spread > vertices / samples) {
      for (Index i = 0; i < samples; ++i)
        consider(1 + Index(std::size_t(i) * vertices / samples), best);
      spread = vertices / samples / 2;
    }
    for (Index step = spread; step > 0; step /= 2) {
      const Index middle = best.vertex;
      if (middle > step)
        consider(middle - step, best);
      if (step <= vertices - middle)
        consider(middle + step, best);
    }
    return best.vertex;
  }

  struct Nearest
  {
    Index of, vertex;
    double squared_distance;
  };

  void consider(Index w, Nearest& best) const
  {
    const double square = squared_distance(position(best.of), position(w));
    if (square < best.squared_distance && !m_maintained.mirror().is_outside(w)) {
      best.squared_distance = square;
      best.vertex = w;
    }
  }

  const Position_2& position(Index v) const { return m_maintained.positions()[v]; }

  // The edge of face f, other than the one that the walk came in by, that v is beyond; `no_index`
  // if v is in the face. Which edge is looked at first depends on `turn`: a walk that always
  // prefers the same one can take detours.
  Index way_out(Index f, Index v, Index entry, Index turn) const
  {
    const Mirror& mirror = m_maintained.mirror();
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
    const Mirror& mirror = m_maintained.mirror();
    return m_predicates.orientation(mirror.source(h), mirror.target(h), v);
  }

  Place_2 place_in(Index f, Index v, Index steps) const
  {
    Place_2 place;
    place.steps = steps;
    for (const Index w : m_maintained.mirror().face(f))
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

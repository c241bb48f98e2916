// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_MENDING_POINT_LOCATION_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_MENDING_POINT_LOCATION_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Flat_arrays.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Points_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/topology/Halfedge_arrays_2.h>
#include <CGAL/enum.h>

#include <algorithm>
#include <cstddef>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

// The place of a point: a vertex, or a face that contains it, boundary included. The face is
// infinite if the point is outside of the hull.
template <class State>
struct Place_2
{
  Face_index face = null_index;
  typename State::Chart chart{}; // of the face, as seen from the point
  Vertex_index vertex = null_index;
  Halfedge_index edge =
      null_index;         // on a torus, a half-edge of the face that the point is on, if any
  Index steps = 0;        // of the walk to find it
  bool is_inside = false; // strictly inside of a finite face
};

// Jump and walk (Mücke, Saias and Zhu, 1999): walks from the nearest of some vertices through
// faces, always across an edge that has the point on its other side. In a Delaunay triangulation
// such a walk meets no face twice. In other ones it may not end; after as many steps as there are
// faces, the result is any face that contains the point or, if there is none, the face in which the
// walk began. On a torus everything has to be Delaunay.
template <class State>
class Point_location_2
{
  using Arrays = Halfedge_arrays_2;
  using Chart = typename State::Chart;
  using Place = Place_2<State>;

public:
  explicit Point_location_2(const State& state)
    : m_state(state)
    , m_predicates(state)
  {
  }

  // Locates vertex v, which is in no face. `nearby` is a finite vertex in some face. The numbers of
  // the vertices around v are expected to differ from the number of `nearby` by at most `spread`.
  Place locate(Vertex_index v, Vertex_index nearby, Index spread) const
  {
    const Arrays& arrays = m_state.arrays();
    const Index start = arrays.corner(nearest(v, nearby, spread));
    Place place;
    place.face = Arrays::face_of(start);
    place.chart = m_state.chart_seen_from(v, start);
    Halfedge_index h = way_out(place, v);
    while (h != null_index && may_go_on(++place.steps)) {
      const Index entry = arrays.twin(h);
      place.chart = m_state.chart_beyond(h, place.chart);
      place.face = Arrays::face_of(entry);
      h = way_on(entry, place.chart, v, place.steps % 2 == 0);
    }
    if (h != null_index)
      place.face = any_face_with(v, Arrays::face_of(start));
    complete(place, v);
    return place;
  }

private:
  // Returns a vertex near v. If `spread` is large, first takes the nearest of half to all of the
  // cube root of n vertices, evenly spread over the numbers. Then searches around the nearest one
  // at ever smaller steps of the numbers, which follow a curve through the plane. At 100,000 points
  // the second search takes as long as two steps of the walk, and saves some forty.
  Index nearest(Vertex_index v, Vertex_index nearby, Index spread) const
  {
    const Index vertices = m_state.number_of_vertices();
    Index samples = 1;
    while (8 * std::size_t(samples) * samples * samples <= vertices)
      samples *= 2;
    Nearest best{v, nearby, m_state.rounded_squared_distance(v, nearby)};
    if (spread > vertices / samples) {
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

  void consider(Vertex_index w, Nearest& best) const
  {
    const double square = m_state.rounded_squared_distance(best.of, w);
    if (square < best.squared_distance && !m_state.arrays().is_outside(w)) {
      best.squared_distance = square;
      best.vertex = w;
    }
  }

  bool may_go_on(Index steps) const
  {
    return !State::can_locate_anywhere || steps < m_state.arrays().number_of_faces();
  }

  Index any_face_with(Vertex_index v, Index otherwise) const
  {
    const Arrays& arrays = m_state.arrays();
    Place place;
    for (place.face = 0; place.face < arrays.number_of_faces(); ++place.face)
      if (!arrays.is_empty_face(place.face) && way_out(place, v) == null_index)
        return place.face;
    return otherwise;
  }

  // Returns an edge that separates the place's face from v, or `null_index` if v is in the face.
  Halfedge_index way_out(const Place& place, Vertex_index v) const
  {
    const Arrays& arrays = m_state.arrays();
    const Halfedge_index first = Arrays::halfedge_in(place.face, 0);
    for (Halfedge_index h = first; h < first + 3; ++h) // an infinite face has one finite edge
      if (arrays.apex(h) == infinite_index)
        return orientation(h, place.chart, v) == LEFT_TURN ? Halfedge_index(null_index) : h;
    for (Halfedge_index h = first; h < first + 3; ++h)
      if (orientation(h, place.chart, v) == RIGHT_TURN)
        return h;
    return null_index;
  }

  // Returns the edge through which to leave the face of `entry`, a half-edge that does not have v
  // on its right, or `null_index` if v is in that face. `turn` determines which edge is tested
  // first: always preferring the same one can cause detours.
  Halfedge_index way_on(Halfedge_index entry, const Chart& chart, Vertex_index v, bool turn) const
  {
    if (m_state.arrays().apex(entry) == infinite_index)
      return null_index;
    const Halfedge_index next = Arrays::next(entry), previous = Arrays::previous(entry);
    const Halfedge_index first = turn ? next : previous, second = turn ? previous : next;
    if (orientation(first, chart, v) == RIGHT_TURN)
      return first;
    return orientation(second, chart, v) == RIGHT_TURN ? second : Halfedge_index(null_index);
  }

  // The orientation of the source of half-edge h, its target and v.
  Orientation orientation(Halfedge_index h, const Chart& chart, Vertex_index v) const
  {
    return m_predicates.orientation(m_state.site_in(Arrays::next(h), chart),
                                    m_state.site_in(Arrays::previous(h), chart), State::site_of(v));
  }

  // Finds out where in its face v is.
  void complete(Place& place, Vertex_index v) const
  {
    const Arrays& arrays = m_state.arrays();
    const Halfedge_index first = Arrays::halfedge_in(place.face, 0);
    const auto corners = arrays.face(place.face);
    const bool is_finite =
        std::find(corners.begin(), corners.end(), infinite_index) == corners.end();
    place.is_inside = is_finite;
    for (Halfedge_index h = first; h < first + 3 && place.is_inside; ++h)
      place.is_inside = orientation(h, place.chart, v) == LEFT_TURN;
    if (place.is_inside)
      return;
    for (Halfedge_index h = first; h < first + 3; ++h) {
      if (arrays.apex(h) != infinite_index &&
          m_predicates.coincide(State::site_of(v), m_state.site_in(h, place.chart)))
        place.vertex = arrays.apex(h);
      if (State::is_periodic && orientation(h, place.chart, v) == COLLINEAR)
        place.edge = h;
    }
  }

  const State& m_state;
  typename State::Predicates m_predicates;
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_MENDING_POINT_LOCATION_2_H

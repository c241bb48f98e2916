// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_MENDING_POINT_LOCATION_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_MENDING_POINT_LOCATION_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Flat_arrays.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Points_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/topology/Halfedge_arrays_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/topology/Star_polygon_2.h>
#include <CGAL/enum.h>

#include <algorithm>
#include <cstddef>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

// Where a target is: at a vertex, or in a face, boundary included. The face is infinite if the
// target is outside of the hull.
template <class State>
struct Location_2
{
  Face_index face = null_index;
  typename State::Chart chart{}; // of the face, as seen from the target
  Vertex_index vertex = null_index;
  Index steps = 0;        // of the walk to find it
  bool is_inside = false; // strictly inside of a finite face
};

// A vertex that is in no face, as a target. Positions that belong to no vertex are targets as well,
// by the same functions: `Query_2`.
template <class State>
class Vertex_target_2
{
  using Site = typename State::Site;

public:
  Vertex_target_2(const State& state, Vertex_index v)
    : m_state(state)
    , m_predicates(state)
    , m_vertex(v)
  {
  }

  // How the face of h is seen from the target.
  typename State::Chart chart_at(Halfedge_index h) const
  {
    return m_state.chart_seen_from(m_vertex, h);
  }
  double rounded_squared_distance(Vertex_index w) const
  {
    return m_state.rounded_squared_distance(m_vertex, w);
  }
  // The orientation of a, b and the target.
  Orientation orientation(const Site& a, const Site& b) const
  {
    return m_predicates.orientation(a, b, State::site_of(m_vertex));
  }
  bool is_at(const Site& site) const
  {
    return m_predicates.coincide(State::site_of(m_vertex), site);
  }

private:
  const State& m_state;
  const typename State::Predicates m_predicates;
  const Vertex_index m_vertex;
};

// Jump and walk (Mücke, Saias and Zhu, 1999): walks from the nearest of some vertices through
// faces, always across an edge that has the target on its other side. In a Delaunay triangulation
// such a walk meets no face twice. In other ones it may not end; after as many steps as there are
// faces, the result is any face that contains the target or, if there is none, the face in which
// the walk began. On a torus everything has to be Delaunay.
//
// If some vertices are not free, because other threads change what is around them, the walk starts
// from one that is, and crosses edges between free ones only. Then it may find nothing.
template <class State, class Target, class Is_free = All_vertices_2>
class Point_location_2
{
  using Arrays = Halfedge_arrays_2;
  using Chart = typename State::Chart;
  using Location = Location_2<State>;

public:
  // Both must live as long as this object.
  Point_location_2(const State& state, const Target& target, const Is_free& is_free = Is_free())
    : m_state(state)
    , m_target(target)
    , m_is_free(is_free)
  {
  }

  // `nearby` is a finite vertex in some face, and free. The numbers of the vertices around the
  // target are expected to differ from the number of `nearby` by at most `spread`.
  Location locate(Vertex_index nearby, Index spread) const
  {
    const Arrays& arrays = m_state.arrays();
    const Halfedge_index start = arrays.corner(nearest(nearby, spread));
    Location location;
    location.face = Arrays::face_of(start);
    location.chart = m_target.chart_at(start);
    Halfedge_index h = way_out(location);
    bool are_ends_free =
        h == null_index || (m_is_free(arrays.source(h)) && m_is_free(arrays.target(h)));
    while (h != null_index && may_go_on(++location.steps)) {
      if (!are_ends_free) {
        location.face = null_index;
        return location;
      }
      const Halfedge_index entry = arrays.twin(h);
      location.chart = m_state.chart_beyond(h, location.chart);
      location.face = Arrays::face_of(entry);
      are_ends_free = m_is_free(arrays.apex(entry)); // those of `entry` are
      if (are_ends_free)
        for (const Halfedge_index exit : {Arrays::next(entry), Arrays::previous(entry)})
          arrays.prefetch_face(arrays.twin(exit)); // which it will be cannot be predicted
      h = way_on(entry, location.chart, location.steps % 2 == 0);
    }
    if (h != null_index)
      location.face = any_face_with_target(Arrays::face_of(start));
    complete(location);
    return location;
  }

private:
  // Returns a vertex near the target. If `spread` is large, first takes the nearest of half to all
  // of the cube root of n vertices, evenly spread over the numbers. Then searches around the
  // nearest one at ever smaller steps of the numbers, which follow a curve through the plane. At
  // 100,000 points the second search takes as long as two steps of the walk, and saves some forty.
  Vertex_index nearest(Vertex_index nearby, Index spread) const
  {
    const Index vertices = m_state.number_of_vertices();
    Index samples = 1;
    while (8 * std::size_t(samples) * samples * samples <= vertices)
      samples *= 2;
    Nearest best{nearby, m_target.rounded_squared_distance(nearby)};
    if (spread > vertices / samples) {
      for (Index i = 0; i < samples; ++i)
        consider(Vertex_index(1 + std::size_t(i) * vertices / samples), best);
      spread = vertices / samples / 2;
    }
    for (Index step = spread; step > 0; step /= 2) {
      const Vertex_index middle = best.vertex;
      if (middle > step)
        consider(Vertex_index(middle - step), best);
      if (step <= vertices - middle)
        consider(middle + step, best);
    }
    return best.vertex;
  }

  struct Nearest
  {
    Vertex_index vertex;
    double squared_distance;
  };

  void consider(Vertex_index w, Nearest& best) const
  {
    const double square = m_target.rounded_squared_distance(w);
    if (square < best.squared_distance && m_is_free(w) && !m_state.arrays().is_outside(w))
      best = {w, square};
  }

  bool may_go_on(Index steps) const
  {
    return !State::can_locate_anywhere || steps < m_state.arrays().number_of_faces();
  }

  Face_index any_face_with_target(Face_index otherwise) const
  {
    const Arrays& arrays = m_state.arrays();
    Location location;
    for (location.face = Face_index(0); location.face < arrays.number_of_faces(); ++location.face)
      if (!arrays.is_empty_face(location.face) && way_out(location) == null_index)
        return location.face;
    return otherwise;
  }

  // Returns an edge that separates the face from the target, or `null_index` if the target is in
  // the face.
  Halfedge_index way_out(const Location& location) const
  {
    const Arrays& arrays = m_state.arrays();
    const Halfedge_index first = Arrays::halfedge_in(location.face, 0);
    for (Halfedge_index h = first; h < first + 3; ++h) // an infinite face has one finite edge
      if (arrays.apex(h) == infinite_index)
        return orientation(h, location.chart) == LEFT_TURN ? null_index : h;
    for (Halfedge_index h = first; h < first + 3; ++h)
      if (orientation(h, location.chart) == RIGHT_TURN)
        return h;
    return null_index;
  }

  // Returns the edge through which to leave the face of `entry`, a half-edge that does not have the
  // target on its right, or `null_index` if the target is in that face. `turn` determines which
  // edge is tested first: always preferring the same one can cause detours.
  Halfedge_index way_on(Halfedge_index entry, const Chart& chart, bool turn) const
  {
    if (m_state.arrays().apex(entry) == infinite_index)
      return null_index;
    const Halfedge_index next = Arrays::next(entry), previous = Arrays::previous(entry);
    const Halfedge_index first = turn ? next : previous, second = turn ? previous : next;
    if (orientation(first, chart) == RIGHT_TURN)
      return first;
    return orientation(second, chart) == RIGHT_TURN ? second : null_index;
  }

  // The orientation of the source of half-edge h, its target and the target of the search.
  Orientation orientation(Halfedge_index h, const Chart& chart) const
  {
    return m_target.orientation(m_state.site_in(Arrays::next(h), chart),
                                m_state.site_in(Arrays::previous(h), chart));
  }

  // Finds out where in its face the target is.
  void complete(Location& location) const
  {
    const Arrays& arrays = m_state.arrays();
    const Halfedge_index first = Arrays::halfedge_in(location.face, 0);
    const auto corners = arrays.face(location.face);
    const bool is_finite =
        std::find(corners.begin(), corners.end(), infinite_index) == corners.end();
    location.is_inside = is_finite;
    for (Halfedge_index h = first; h < first + 3 && location.is_inside; ++h)
      location.is_inside = orientation(h, location.chart) == LEFT_TURN;
    if (location.is_inside)
      return;
    for (Halfedge_index h = first; h < first + 3; ++h)
      if (arrays.apex(h) != infinite_index && m_target.is_at(m_state.site_in(h, location.chart)))
        location.vertex = arrays.apex(h);
  }

  const State& m_state;
  const Target& m_target;
  const Is_free m_is_free;
};

// Where to start a search: `nearby` is a vertex in some face, `spread` as for locate().
struct Location_hint_2
{
  Vertex_index nearby;
  Index spread;
};

// The hint, or one that is nearer to v. Where v has gone a short way, the vertex with the number
// before its own is near: numbers follow a curve.
template <class State, class Is_free = All_vertices_2>
Location_hint_2 nearer_hint(const State& state, Vertex_index v, const Location_hint_2& hint,
                            const Is_free& is_free = Is_free())
{
  constexpr Index few = 4;
  const Vertex_target_2<State> target(state, v);
  const Vertex_index before(v - 1);
  const bool is_nearer =
      before != infinite_index && is_free(before) && !state.arrays().is_outside(before) &&
      target.rounded_squared_distance(before) < target.rounded_squared_distance(hint.nearby);
  return is_nearer ? Location_hint_2{before, few} : hint;
}

// Locates a vertex that is in no face.
template <class State, class Is_free = All_vertices_2>
Location_2<State> locate_vertex(const State& state, Vertex_index v, const Location_hint_2& hint,
                                const Is_free& is_free = Is_free())
{
  const Vertex_target_2<State> target(state, v);
  return Point_location_2<State, Vertex_target_2<State>, Is_free>(state, target, is_free)
      .locate(hint.nearby, hint.spread);
}

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_MENDING_POINT_LOCATION_2_H

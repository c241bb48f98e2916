// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_SPACE_TRIANGULATION_STATE_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_SPACE_TRIANGULATION_STATE_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Flat_arrays.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Parallel_parts.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Edge_kinds_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Flat_elements_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Points_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/proof/Edge_slack_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/proof/Edge_test_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/space/Positions_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/topology/Change_log_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/topology/Halfedge_arrays_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/topology/Topology_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/policies/accepts_inexact_predicates_2.h>
#include <CGAL/tags.h>

#include <array>
#include <cstddef>
#include <type_traits>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

template <class State>
class Plane_editing_2;
template <class State>
class Topology_builder_2;

// What an update works on: the topology and the positions of its vertices. Reading is public; only
// the friends of each class can write.
template <class Traits_, class Tds_, class Visitor_calls_, class ConcurrencyTag>
class Triangulation_state_2
{
public:
  using Traits = Traits_;
  using Tds = Tds_;
  using Visitor_calls = Visitor_calls_;
  using Topology = Topology_2<Traits, Tds, Visitor_calls>;
  using Triangulation = typename Topology::Triangulation;
  using Vertex_handle = typename Topology::Vertex_handle;
  using Face_handle = typename Topology::Face_handle;
  using Point = typename Topology::Point;
  using Ids = typename Topology::Ids;
  using Positions = Positions_2<Point>;
  using Space = Plane_2;
  using Edge_test = Edge_test_2<Triangulation_state_2>;
  using Editing = Plane_editing_2<Triangulation_state_2>;
  using Builder = Topology_builder_2<Triangulation_state_2>;
  using Slacks = Plane_slacks_2;

  static constexpr bool is_periodic = false;

  // The properties of the space on which repairs depend.
  static constexpr bool has_hull = true;
  static constexpr bool can_splice = true; // a region can be triangulated separately
  static constexpr bool can_locate_anywhere = true;

  static constexpr bool coordinates_are_doubles = has_double_coordinates<Point>;

  // How passes are divided. Passes over lazy numbers, which several points may share, are left to
  // one thread.
  using Parts =
      Parallel_parts<std::conditional_t<coordinates_are_doubles, ConcurrencyTag, Sequential_tag>>;

  explicit Triangulation_state_2(const Traits& traits = Traits())
    : m_topology(traits)
    , m_positions(m_topology.points())
  {
  }

  const Traits& traits() const { return triangulation().geom_traits(); }

  // TOPOLOGY ------------------------------------------------------------------------------------

  const Triangulation& triangulation() const { return m_topology.triangulation(); }
  const Halfedge_arrays_2& arrays() const { return m_topology.arrays(); }
  bool is_written_by_handles() const { return m_topology.is_written_by_handles(); }
  Vertex_handle vertex_handle(Vertex_index v) const { return m_topology.vertex_handle(v); }
  const Ids& ids() const { return m_topology.ids(); }
  const Change_log_2& changes() const { return m_topology.changes(); }

  auto& vertex_properties() { return m_topology.vertex_properties(); }
  auto& face_properties() { return m_topology.face_properties(); }

  // The number of finite vertices.
  Index number_of_vertices() const { return Index(positions().size()) - 1; }

  // If false, there are no edges and faces, and every frame is a rebuild.
  bool spans_plane() const { return triangulation().dimension() == 2; }

  // POSITIONS -----------------------------------------------------------------------------------

  const std::vector<Position_2>& positions() const { return m_positions.positions(); }
  // Whether signs may be concluded from positions.
  bool positions_are_exact() const
  {
    return Has_euclidean_circles_2<Traits>::value && m_positions.are_exact();
  }
  bool are_coordinates_rounded() const { return !m_positions.are_exact(); }
  bool have_points_moved() const { return m_positions.have_moved(); }

  const Edge_2& edge(Edge_index e) const { return arrays().edge(e); }
  std::array<Index, 3> face(Face_index f) const { return arrays().face(f); }
  // Whether half-edge h of edge e goes from the edge's source to the edge's target.
  bool is_along(Edge_index e, Halfedge_index h) const
  {
    return arrays().source(h) == edge(e).source;
  }
  bool is_infinite_face(Face_index f) const
  {
    const auto [a, b, c] = arrays().face(f);
    return a == infinite_index || b == infinite_index || c == infinite_index;
  }
  // Whether the face of h is finite, and the one beyond h is not.
  bool is_hull_edge(Halfedge_index h) const
  {
    return arrays().apex(arrays().twin(h)) == infinite_index;
  }
  static bool is_shown_right(Index) { return true; }
  bool is_at_infinity(Edge_index e) const { return internal::is_at_infinity(edge(e)); }
  bool breaks_hull(Edge_index e) const { return internal::breaks_hull(edge(e), positions()); }
  static bool covers_space() { return true; } // there is nothing beside the hull to leave open

  Position_2 edge_vector(Edge_index e) const
  {
    return positions()[edge(e).target] - positions()[edge(e).source];
  }
  std::array<Position_2, 3> face_corners(Face_index f) const
  {
    const auto [a, b, c] = arrays().face(f);
    return {positions()[a], positions()[b], positions()[c]};
  }

  // Calls f(w) for every finite neighbor w of the finite vertex v, counterclockwise. Where the
  // points do not span the plane there are no flat arrays, and CGAL's data structure has the
  // neighbors.
  template <class Function>
  void for_each_finite_neighbor(Vertex_index v, const Function& f) const
  {
    const auto call_if_finite = [&](Vertex_index w) {
      if (w != infinite_index)
        f(w);
    };
    if (!spans_plane())
      for_each_neighbor_on_line(v, call_if_finite);
    else if (!arrays().is_outside(v))
      arrays().for_each_neighbor(v, call_if_finite);
  }

  static constexpr std::size_t number_of_cell_changes() { return 0; }

  // Fewer vertices than these are triangulated from scratch.
  static constexpr std::size_t min_vertices = 3;
  // The number of vertices in the plane that cost as much to triangulate from scratch.
  std::size_t rebuilt_vertices() const { return number_of_vertices(); }

  // SITES AND CHARTS ------------------------------------------------------------------------------
  // A site is a vertex as seen in a chart, which says how a face is seen. In the plane all charts
  // are alike.

  using Site = Index;
  struct Chart
  {
  };
  using Predicates = Vertex_predicates_2<Triangulation_state_2>;
  static constexpr bool predicates_are_exact = !Are_known_to_be_inexact_2<Traits>::value;

  static Vertex_index vertex_of(Site site) { return site; }
  static Site site_of(Vertex_index v) { return v; }
  // The apex of half-edge h, as seen in a chart of the half-edge's face.
  Site site_in(Halfedge_index h, Chart) const { return arrays().apex(h); }
  // The chart of the face of h as seen from the apex of h, and the chart of the face beyond h.
  static Chart chart_at(Index) { return {}; }
  static Chart chart_beyond(Index, Chart) { return {}; }
  const Position_2& rounded_position(Site site) const { return positions()[site]; }
  // Whether a point is where vertex v is.
  bool is_at(const Point& p, Vertex_index v) const { return coincide(traits(), p, point(v)); }
  static Chart chart_seen_from(Index, Index) { return {}; }
  double rounded_squared_distance(Vertex_index v, Vertex_index w) const
  {
    return rounded_squared_distance(positions()[v], positions()[w]);
  }
  static double rounded_squared_distance(const Position_2& p, const Position_2& q)
  {
    return squared_distance(p, q);
  }
  // The position of v one frame ago, as seen from where the present position of v is `now`.
  Position_2 previous_position_at(Vertex_index v, const Position_2&) const
  {
    return previous_position(v);
  }
  // The position by which p is sorted in a spatial order.
  static const Position_2& place_in_order(const Position_2& p) { return p; }
  bool are_neighbors(Site a, Site b) const { return arrays().are_neighbors(a, b); }

  bool corners_are_exact(Index) const { return positions_are_exact(); }
  // The corners of an edge, as seen from the edge.
  Edge_corners_2 corners(Edge_index e) const { return corners(e, positions()); }
  // The corners of an edge if the vertices had other positions.
  Edge_corners_2 corners(Edge_index e, const std::vector<Position_2>& others) const
  {
    return Space::corners(arrays().edge(e), others);
  }

  // The present point of a vertex.
  decltype(auto) point(Vertex_index v) const { return m_positions.point(v); }

  // The position of a vertex one frame ago, or before it moved alone in this call.
  Position_2 previous_position(Vertex_index v) const { return m_positions.previous_position(v); }

  // The position where the vertex rests: the previous one.
  Position_2 rest_position(Vertex_index v) const { return previous_position(v); }

  void prefetch_positions(Vertex_index v) const { m_positions.prefetch(v); }

  // The present point with this id.
  Point point_of_id(Point_id id) const
  {
    return ids().is_representative(id) ? point(ids().vertex(id)) : ids().duplicate(id).point;
  }

private:
  template <class Function>
  void for_each_neighbor_on_line(Vertex_index v, const Function& f) const
  {
    if (triangulation().dimension() < 1)
      return;
    auto neighbor = triangulation().tds().incident_vertices(vertex_handle(v));
    const auto first = neighbor;
    do
      f(neighbor.base().index());
    while (++neighbor != first);
  }

  template <class State>
  friend class Input_frame_2;
  template <class State>
  friend class Topology_builder_2;
  template <class State>
  friend class Plane_editing_2;

  Topology m_topology;
  Positions m_positions;
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_SPACE_TRIANGULATION_STATE_2_H

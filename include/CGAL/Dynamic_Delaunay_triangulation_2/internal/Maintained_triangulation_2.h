// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_MAINTAINED_TRIANGULATION_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_MAINTAINED_TRIANGULATION_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Planar_points_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Positions_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Topology_2.h>

#include <vector>

namespace CGAL {
namespace Dynamic_Delaunay_triangulations_2 {
namespace internal {

// What an update works on: the topology, and where its vertices are. Everybody reads both here. Who
// writes which of them is decided by their classes.
template <class Traits_, class Tds_, class Visitor_calls_>
class Maintained_triangulation_2
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

  static constexpr bool coordinates_are_doubles = has_double_coordinates<Point>;

  explicit Maintained_triangulation_2(const Traits& traits = Traits())
    : m_topology(traits)
  {
  }

  const Traits& traits() const { return triangulation().geom_traits(); }

  // TOPOLOGY ------------------------------------------------------------------------------------

  const Topology& topology() const { return m_topology; }
  const Triangulation& triangulation() const { return m_topology.triangulation(); }
  const Neighborhood_mirror_2& mirror() const { return m_topology.mirror(); }
  const std::vector<Vertex_handle>& vertices() const { return m_topology.vertices(); }
  const std::vector<Face_handle>& faces() const { return m_topology.faces(); }
  const Ids& ids() const { return m_topology.ids(); }
  const Change_log_2& changes() const { return m_topology.changes(); }

  Index number_of_vertices() const { return Index(vertices().size()) - 1; }

  // The mirror exists in dimension 2 only: below, every frame is a rebuild.
  bool is_mirrored() const { return triangulation().dimension() == 2; }

  // POSITIONS -----------------------------------------------------------------------------------

  const std::vector<Position_2>& positions() const { return m_positions.positions(); }
  const std::vector<Point>& points() const { return m_positions.points(); }
  bool positions_are_exact() const { return m_positions.are_exact(); }
  bool points_are_written() const { return m_positions.are_written(); }

  // Where a vertex is.
  decltype(auto) point(Index v) const { return m_positions.point(v, vertices()[v]); }

  // Where it was a frame ago, while the points are not written.
  const Point& previous_point(Index v) const { return vertices()[v]->point(); }

  // Where a point is.
  Point point_of_id(Index id) const
  {
    return ids().is_representative(id) ? point(ids().vertex(id)) : ids().duplicate(id).point;
  }

private:
  template <class Maintained>
  friend class Input_frame_2;
  template <class Maintained>
  friend class Topology_builder_2;
  template <class Maintained>
  friend class Topology_editor_2;

  Topology m_topology;
  Positions m_positions;
};

} // namespace internal
} // namespace Dynamic_Delaunay_triangulations_2
} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_MAINTAINED_TRIANGULATION_2_H

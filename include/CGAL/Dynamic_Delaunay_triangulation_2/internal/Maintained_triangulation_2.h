// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_MAINTAINED_TRIANGULATION_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_MAINTAINED_TRIANGULATION_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Computed_geometry_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Edge_slack_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Edge_test_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Flat_arrays_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Neighborhood_mirror_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Parallel_parts_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Points_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Processor_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Topology_2.h>
#include <CGAL/number_type_basic.h>
#include <CGAL/tags.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Dynamic_Delaunay_triangulations_2 {
namespace internal {

// The positions of the vertices. The points of a frame are *staged* here during the update: CGAL's
// vertices keep the points of the last frame, from which everything can be restored, until the
// staged ones are written to them. Reading is public. `Input_frame_2` stages, restores and writes;
// the editor and the builder add and remove entries along with vertices.
template <class Point>
class Positions_2
{
public:
  static constexpr bool points_are_two_doubles = is_two_doubles<Point>;

  // The points, rounded if their coordinates are not doubles. Indexed by vertices, as points().
  const std::vector<Position_2>& positions() const { return m_positions; }
  // The points themselves. Empty if they are just two doubles.
  const std::vector<Point>& points() const { return m_points; }
  // Whether no coordinate was rounded in positions().
  bool are_exact() const { return m_are_exact; }
  // Whether CGAL's vertices have these points.
  bool are_written() const { return m_are_written; }

  // The point of vertex v, whose handle is `vertex`.
  template <class Vertex_handle>
  decltype(auto) point(Index v, Vertex_handle vertex) const
  {
    if constexpr (points_are_two_doubles)
      return Point(m_positions[v].x, m_positions[v].y);
    else
      return (m_are_written ? vertex->point() : m_points[v]);
  }

private:
  template <class Maintained>
  friend class Input_frame_2;
  template <class Maintained>
  friend class Topology_builder_2;
  template <class Maintained>
  friend class Topology_editor_2;

  // STAGING -------------------------------------------------------------------------------------

  void stage(Index v, const Point& p) { stage(v, approximation(p), p); }

  void stage(Index v, const Position_2& position, const Point& p)
  {
    m_positions[v] = position;
    if constexpr (!points_are_two_doubles)
      m_points[v] = p;
  }

  // Writes the staged points to CGAL's vertices.
  template <class Parts, class Vertex_handle>
  void write(const std::vector<Vertex_handle>& vertices)
  {
    if (!std::exchange(m_are_written, true))
      Parts::for_each(vertices.size(), [&](std::size_t, std::size_t first, std::size_t beyond) {
        first = (std::max)(first, std::size_t(1)); // the infinite vertex has no point
        if (vertices.size() < min_vertices_to_prefetch)
          write_part<false>(vertices, Index(first), Index(beyond));
        else
          write_part<true>(vertices, Index(first), Index(beyond));
      });
  }

  // The vertices are stored in the order of their creation; after much motion, vertices that are
  // consecutive here are scattered over memory.
  template <bool prefetches, class Vertex_handle>
  void write_part(const std::vector<Vertex_handle>& vertices, Index first, Index beyond) const
  {
    constexpr Index ahead = 16;
    for (Index v = first; v < beyond; ++v) {
      if (prefetches && v + ahead < beyond)
        prefetch(&*vertices[v + ahead]);
      write_one(v, vertices[v]);
    }
  }

  template <class Vertex_handle>
  void write_one(Index v, Vertex_handle vertex) const
  {
    if constexpr (points_are_two_doubles)
      vertex->set_point(Point(m_positions[v].x, m_positions[v].y));
    else
      vertex->set_point(m_points[v]);
  }

  // Restores the points of CGAL's vertices.
  template <class Vertex_handle>
  void take_back(const std::vector<Vertex_handle>& vertices, bool were_exact)
  {
    m_are_written = true;
    m_are_exact = were_exact;
    for (Index v = 1; v < Index(vertices.size()); ++v)
      stage(v, vertices[v]->point());
  }

  // IN STEP WITH THE VERTICES -------------------------------------------------------------------

  void reserve(std::size_t number)
  {
    m_positions.reserve(number);
    if constexpr (!points_are_two_doubles)
      m_points.reserve(number);
  }

  // After this, append() throws only what copying a point throws.
  void provide_for_vertex()
  {
    provide(m_positions, 1);
    if constexpr (!points_are_two_doubles)
      provide(m_points, 1);
  }

  void append(const Point& p) { append(approximation(p), p); }

  void append(const Position_2& position, const Point& p)
  {
    m_positions.push_back(position);
    if constexpr (!points_are_two_doubles)
      m_points.push_back(p);
  }

  void resize(std::size_t number)
  {
    m_positions.resize(number);
    if constexpr (!points_are_two_doubles)
      m_points.resize(number);
  }

  void move_last_to(Index v)
  {
    m_positions[v] = m_positions.back();
    m_positions.pop_back();
    if constexpr (!points_are_two_doubles) {
      m_points[v] = m_points.back();
      m_points.pop_back();
    }
  }

  std::vector<Position_2> m_positions = {nowhere()};
  std::vector<Point> m_points = std::vector<Point>(points_are_two_doubles ? 0 : 1);
  bool m_are_written = true;
  bool m_are_exact = true;
};

// What an update works on: the topology and the positions of its vertices. Reading is public; only
// the friends of each class can write.
template <class Traits_, class Tds_, class Visitor_calls_, class ConcurrencyTag>
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
  using Space = Plane_2;
  using Edge_test = Edge_test_2<Maintained_triangulation_2>;
  using Slacks = Plane_slacks_2;

  static constexpr bool is_periodic = false;

  static constexpr bool coordinates_are_doubles = has_double_coordinates<Point>;

  // How passes are divided. Numbers that are computed when they are needed, and shared by points,
  // are left to one thread.
  using Parts =
      Parallel_parts_2<std::conditional_t<coordinates_are_doubles, ConcurrencyTag, Sequential_tag>>;

  explicit Maintained_triangulation_2(const Traits& traits = Traits())
    : m_topology(traits)
  {
  }

  const Traits& traits() const { return triangulation().geom_traits(); }

  // TOPOLOGY ------------------------------------------------------------------------------------

  const Triangulation& triangulation() const { return m_topology.triangulation(); }
  const Neighborhood_mirror_2& mirror() const { return m_topology.mirror(); }
  const std::vector<Vertex_handle>& vertices() const { return m_topology.vertices(); }
  const std::vector<Face_handle>& faces() const { return m_topology.faces(); }
  const Ids& ids() const { return m_topology.ids(); }
  const Change_log_2& changes() const { return m_topology.changes(); }

  Index number_of_vertices() const { return Index(vertices().size()) - 1; }

  // The mirror exists in dimension 2 only. In lower dimensions every frame is a rebuild.
  bool is_mirrored() const { return triangulation().dimension() == 2; }

  // POSITIONS -----------------------------------------------------------------------------------

  const std::vector<Position_2>& positions() const { return m_positions.positions(); }
  const std::vector<Point>& points() const { return m_positions.points(); }
  bool positions_are_exact() const { return m_positions.are_exact(); }
  bool points_are_written() const { return m_positions.are_written(); }

  const Edge_2& edge(Index e) const { return mirror().edge(e); }
  std::array<Index, 3> face(Index f) const { return mirror().face(f); }
  // Whether half-edge h of edge e goes from its source to its target.
  bool is_along(Index e, Index h) const { return mirror().source(h) == edge(e).source; }
  bool is_at_infinity(Index e) const { return internal::is_at_infinity(edge(e)); }
  bool breaks_hull(Index e) const { return internal::breaks_hull(edge(e), positions()); }

  Position_2 edge_vector(Index e) const
  {
    return positions()[edge(e).target] - positions()[edge(e).source];
  }
  std::array<Position_2, 3> face_corners(Index f) const
  {
    const auto [a, b, c] = mirror().face(f);
    return {positions()[a], positions()[b], positions()[c]};
  }

  static constexpr std::size_t number_of_cell_changes() { return 0; }

  bool corners_are_exact(Index) const { return positions_are_exact(); }
  // The corners of an edge, as seen from it.
  Edge_corners_2 corners(Index e) const { return corners(e, positions()); }
  // The same for other positions of the vertices.
  Edge_corners_2 corners(Index e, const std::vector<Position_2>& others) const
  {
    return Space::corners(mirror().edge(e), others);
  }

  // The present point of a vertex.
  decltype(auto) point(Index v) const { return m_positions.point(v, vertices()[v]); }

  // The point of a vertex in the last frame. Valid while the present points are not written.
  const Point& previous_point(Index v) const { return vertices()[v]->point(); }

  Position_2 previous_position(Index v) const { return approximation(previous_point(v)); }

  // The present point with this id.
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

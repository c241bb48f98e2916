// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_SPACE_PLANE_SPACE_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_SPACE_PLANE_SPACE_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Flat_arrays.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/cgal/Indexed_storage_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/cgal/Visitor_calls_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Edge_kinds_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Flat_elements_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Points_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/proof/Edge_slack_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/proof/Edge_test_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/space/Writable_positions_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/topology/Halfedge_arrays_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/policies/accepts_inexact_predicates_2.h>
#include <CGAL/exceptions.h>

#include <array>
#include <cstddef>
#include <iostream>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

template <class State>
class Plane_builder_2;
template <class State>
class Plane_editing_2;

// The open plane: the arrays of a triangulation of it, on which CGAL's triangulation runs, too, the
// positions of its vertices, and what the kernel asks about them. Vertex 0 is at infinity.
template <class Traits_, class Tds_>
class Plane_space_2
{
public:
  using Traits = Traits_;
  using Tds = Tds_;
  using Triangulation = Delaunay_triangulation_2<Traits, Tds>;
  using Vertex_handle = typename Triangulation::Vertex_handle;
  using Face_handle = typename Triangulation::Face_handle;
  using Point = typename Triangulation::Point;
  using Storage = Indexed_storage_2<Point, typename Tds::Vertex_info, typename Tds::Face_info>;
  using Positions = Positions_2<Point>;
  using Argument = Traits; // from what an empty space is made

  using Predicates = Vertex_predicates_2<Plane_space_2>;
  using Edge_test = Edge_test_2<Plane_space_2>;
  using Slacks = Plane_slacks_2;
  template <class State>
  using Editing = Plane_editing_2<State>;
  template <class State>
  using Builder = Plane_builder_2<State>;
  using Visitor_calls = Visitor_calls_2<Triangulation>;

  static constexpr bool is_periodic = false;                   // for users of frames only
  static constexpr Vertex_index first_vertex = infinite_index; // in the arrays

  // The properties of the space on which repairs depend.
  static constexpr bool has_hull = true;
  static constexpr bool can_splice = true; // a region can be triangulated separately
  static constexpr bool can_locate_anywhere = true;

  static constexpr bool coordinates_are_doubles = has_double_coordinates<Point>;
  static constexpr bool predicates_are_exact = !Are_known_to_be_inexact_2<Traits>::value;

  explicit Plane_space_2(const Traits& traits)
    : m_triangulation(triangulation_on<Triangulation>(m_storage, traits))
    , m_positions(m_storage.writable_points())
  {
    m_storage.note_written_by_editor();
  }
  Plane_space_2(const Plane_space_2&) = delete;
  Plane_space_2& operator=(const Plane_space_2&) = delete;

  const Traits& traits() const { return m_triangulation.geom_traits(); }
  const Argument& argument() const { return traits(); }

  // TOPOLOGY ------------------------------------------------------------------------------------

  const Triangulation& triangulation() const { return m_triangulation; }
  const Halfedge_arrays_2& arrays() const { return m_storage.arrays(); }
  // Whether the user has changed anything through handles.
  bool is_written_by_handles() const { return m_storage.is_written_by_handles(); }
  Vertex_handle vertex_handle(Vertex_index v) const
  {
    return m_triangulation.tds().vertex_handle(v);
  }
  Face_handle face_handle(Face_index f) const { return m_triangulation.tds().face_handle(f); }

  auto& vertex_properties() { return m_storage.vertex_data(); }
  auto& face_properties() { return m_storage.face_data(); }

  // The number of finite vertices.
  Index number_of_vertices() const { return Index(positions().size()) - 1; }

  // If false, there are no edges and faces, and every frame is a rebuild.
  bool spans_plane() const { return m_triangulation.dimension() == 2; }

  const Edge_2& edge(Edge_index e) const { return arrays().edge(e); }
  std::array<Vertex_index, 3> face(Face_index f) const { return arrays().face(f); }
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
  static bool is_shown_right(Edge_index) { return true; }
  bool is_at_infinity(Edge_index e) const { return internal::is_at_infinity(edge(e)); }
  bool breaks_hull(Edge_index e) const { return internal::breaks_hull(edge(e), positions()); }
  static bool covers_space() { return true; } // there is nothing beside the hull to leave open
  static constexpr bool has_gap() { return false; }
  static bool flips_across_gap(Index) { return false; }

  // Whether CGAL's data structure is valid. CGAL's own check throws instead of answering where its
  // assertions are enabled.
  bool is_structure_valid(bool verbose, int level) const
  {
    if (is_written_by_handles() && verbose)
      std::cerr << "handles have changed a vertex or a face" << std::endl;
    return !is_written_by_handles() &&
           m_triangulation.number_of_vertices() == number_of_vertices() &&
           passes([&] { return m_triangulation.tds().is_valid(verbose, level); });
  }
  // Whether points that do not span the plane are triangulated rightly, which is CGAL's own work.
  bool is_right_on_line() const
  {
    return passes([this] { return m_triangulation.is_valid(); });
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
  // A vertex with more neighbors is taken out by flips, which then take less time.
  static constexpr std::size_t max_degree_to_divide = 24;

  // POSITIONS -----------------------------------------------------------------------------------

  const Position_vector& positions() const { return m_positions.positions(); }
  decltype(auto) point(Vertex_index v) const { return m_positions.point(v); }
  bool have_points_moved() const { return m_positions.have_moved(); }
  bool is_frame_at_rest() const { return positions_are_exact() && m_positions.is_frame_at_rest(); }
  // Whether signs may be concluded from positions.
  bool positions_are_exact() const
  {
    return Has_euclidean_circles_2<Traits>::value && m_positions.are_exact();
  }
  bool are_coordinates_rounded() const { return !m_positions.are_exact(); }

  // The position of a vertex one frame ago, or before it moved alone in this call.
  Position_2 previous_position(Vertex_index v) const { return m_positions.previous_position(v); }
  // The position where the vertex rests: the previous one.
  Position_2 rest_position(Vertex_index v) const { return previous_position(v); }

  // Whether a point is where vertex v is.
  bool is_at(const Point& p, Vertex_index v) const { return coincide(traits(), p, point(v)); }

  Position_2 edge_vector(Edge_index e) const
  {
    return positions()[edge(e).target] - positions()[edge(e).source];
  }
  std::array<Position_2, 3> face_corners(Face_index f) const
  {
    const auto [a, b, c] = arrays().face(f);
    return {positions()[a], positions()[b], positions()[c]};
  }
  bool corners_are_exact(Edge_index) const { return positions_are_exact(); }
  // The corners of an edge, as seen from the edge.
  Edge_corners_2 corners(Edge_index e) const { return corners(e, positions()); }
  // The corners of an edge if the vertices had other positions.
  Edge_corners_2 corners(Edge_index e, const Position_vector& others) const
  {
    return Plane_2::corners(arrays().edge(e), others);
  }

  double rounded_squared_distance(Vertex_index v, Vertex_index w) const
  {
    return rounded_squared_distance(positions()[v], positions()[w]);
  }
  static double rounded_squared_distance(const Position_2& p, const Position_2& q)
  {
    return squared_distance(p, q);
  }
  // The position by which p is sorted in a spatial order.
  static const Position_2& position_in_order(const Position_2& p) { return p; }

  // SITES AND CHARTS ------------------------------------------------------------------------------
  // A site is a vertex as seen in a chart, which says how a face is seen. In the plane all charts
  // are alike.

  using Site = Vertex_index;
  struct Chart
  {
  };

  static Vertex_index vertex_of(Site site) { return site; }
  static Site site_of(Vertex_index v) { return v; }
  // The apex of half-edge h, as seen in a chart of the half-edge's face.
  Site site_in(Halfedge_index h, Chart) const { return arrays().apex(h); }
  // The chart of the face of h as seen from the apex of h, and the chart of the face beyond h.
  static Chart chart_at(Halfedge_index) { return {}; }
  static Chart chart_beyond(Halfedge_index, Chart) { return {}; }
  static Chart chart_seen_from(Vertex_index, Halfedge_index) { return {}; }
  const Position_2& rounded_position(Site site) const { return positions()[site]; }
  // The position of v one frame ago, as seen from where the present position of v is `now`.
  Position_2 previous_position_at(Vertex_index v, const Position_2&) const
  {
    return previous_position(v);
  }
  bool are_neighbors(Site a, Site b) const { return arrays().are_neighbors(a, b); }

  // WRITING -------------------------------------------------------------------------------------

  // The parts of the space that can be written.
  class Writer
  {
  public:
    using Positions = Writable_positions_2<Point>;

    explicit Writer(Plane_space_2& space)
      : m_space(space)
    {
    }

    Writable_halfedge_arrays_2& arrays() const { return storage().writable_arrays(); }
    Storage& storage() const { return m_space.m_storage; }
    Positions& positions() const { return m_space.m_positions; }
    void set_dimension(int dimension) const
    {
      m_space.m_triangulation.tds().set_dimension(dimension);
    }

    // Copies everything that is kept between calls.
    void copy(const Plane_space_2& other) const
    {
      storage().copy(other.m_storage);
      set_dimension(other.m_triangulation.dimension());
      positions().copy(other.m_positions);
    }
    // Exchanges that, but for data of users, which are then as in new elements.
    void exchange(Plane_space_2& other) const
    {
      const int dimension = m_space.m_triangulation.dimension();
      set_dimension(other.m_triangulation.dimension());
      Writer(other).set_dimension(dimension);
      storage().exchange(other.m_storage);
      positions().exchange_all_but_points(other.m_positions);
    }

  private:
    Plane_space_2& m_space;
  };

private:
  // Whether a check of CGAL's is true, and does not throw.
  template <class Check>
  static bool passes(const Check& check)
  {
    try {
      return check();
    } catch (const Failure_exception&) {
      return false;
    }
  }

  template <class Function>
  void for_each_neighbor_on_line(Vertex_index v, const Function& f) const
  {
    if (m_triangulation.dimension() < 1)
      return;
    auto neighbor = m_triangulation.tds().incident_vertices(vertex_handle(v));
    const auto first = neighbor;
    do
      f(Vertex_index(neighbor.base().index()));
    while (++neighbor != first);
  }

  Storage m_storage;
  Triangulation m_triangulation; // on m_storage
  Writable_positions_2<Point> m_positions;
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_SPACE_PLANE_SPACE_2_H

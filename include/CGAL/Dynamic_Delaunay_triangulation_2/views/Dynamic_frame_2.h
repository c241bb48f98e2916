// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_VIEWS_DYNAMIC_FRAME_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_VIEWS_DYNAMIC_FRAME_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Flat_elements_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/proof/Certificate_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/proof/Edge_test_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/topology/Halfedge_arrays_2.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgDynamicDelaunayTriangulation2Ref

The view that a classifier gets: the points, edges and faces of the maintained triangulation as flat
arrays, with the positions of the current frame and the topology of the last one. A view copies
nothing, and is valid until the next update.

The plane and periodic space have the same view. There is no infinite vertex in periodic space, and
the corners of edges and faces are images of points: take the lengths and directions of edges from
`edge_vector()`, `corners()` and `face_corners()`, not from `position()`.

Vertices are numbered from 1 to `number_of_vertices()`, in a spatial order; 0 is the infinite
vertex. Edges and faces are numbered from 0. A rebuild may change all of these numbers, and an
insertion or a removal a few of them; the ids of points never change. A frame has edges and faces
only while the points span the plane; otherwise no classifier is asked.

\tparam State an internal type.
*/
template <class State>
class Dynamic_frame_2
{
public:
  /// the type of all numbers: an unsigned integer of 32 bits.
  using Index = Dynamic_Delaunay_triangulations_2::Index;
  /// the number of a vertex. A number becomes one as in `Vertex_index(1)`, and it converts to
  /// `Index`; but it neither converts to nor compares with the number of another kind of element.
  /// Likewise the following types.
  using Vertex_index = Dynamic_Delaunay_triangulations_2::Vertex_index;
  using Halfedge_index = Dynamic_Delaunay_triangulations_2::Halfedge_index; ///< of a half-edge.
  using Edge_index = Dynamic_Delaunay_triangulations_2::Edge_index;         ///< of an edge.
  using Face_index = Dynamic_Delaunay_triangulations_2::Face_index;         ///< of a face.
  using Point_id = Dynamic_Delaunay_triangulations_2::Point_id;             ///< the id of a point.
  /// two doubles, `x` and `y`. If the kernel's coordinates are not doubles, these are the nearest
  /// ones.
  using Position = Dynamic_Delaunay_triangulations_2::Position_2;
  /// a `std::vector` of positions, indexed by the numbers of vertices, whose `resize()` sets no new
  /// ones.
  using Positions = Dynamic_Delaunay_triangulations_2::Position_vector;
  /// four vertices, `source`, `target`, `left` and `right`: the ends of an edge, and the vertices
  /// opposite to it in its two faces.
  using Edge = Dynamic_Delaunay_triangulations_2::Edge_2;
  /// four positions, `left`, `source`, `target` and `right`: those of the vertices of an edge.
  using Corners = Dynamic_Delaunay_triangulations_2::Edge_corners_2;
  /// whether it is a frame of periodic space.
  static constexpr bool is_periodic = State::is_periodic;

  /// \cond
  explicit Dynamic_frame_2(const State& state)
    : m_state(&state)
  {
  }
  /// \endcond

  /// \name Sizes
  /// @{

  /// the number of points.
  Index number_of_points() const { return m_state->ids().number_of_points(); }
  /// one more than the largest id ever in use.
  Index number_of_ids() const { return m_state->ids().number_of_ids(); }
  /// the number of finite vertices: less than the number of points if points coincide.
  Index number_of_vertices() const { return m_state->number_of_vertices(); }
  /// the number of edges, including those to the infinite vertex.
  Index number_of_edges() const { return m_state->arrays().number_of_edges(); }
  /// the number of faces, including the infinite ones.
  Index number_of_faces() const { return m_state->arrays().number_of_faces(); }

  /// @}
  /// \name Points
  /// @{

  /// whether a point has the id `id`.
  bool has_id(std::size_t id) const { return m_state->ids().is_taken(id); }
  /// the vertex of the point `id`. \pre `has_id(id)`
  Vertex_index vertex(std::size_t id) const { return m_state->ids().vertex(Point_id(id)); }
  void vertex(Vertex_index) const = delete; ///< a vertex is no id.
  /// the id of the point at the finite vertex `v`. If several points share it, this is the id of
  /// their representative, the one that was there first.
  Point_id id(Vertex_index v) const { return m_state->ids().representative(v); }
  /// calls `f(i)` for the id `i` of every duplicate, that is, every point that shares the vertex of
  /// a representative, smaller ids first. Cost: proportional to their number.
  template <class Function>
  void for_each_duplicate(Function&& f) const
  {
    for (const Point_id id : m_state->ids().covered_ids())
      f(id);
  }
  /// whether `v` is the infinite vertex.
  static bool is_infinite(Vertex_index v)
  {
    return v == Dynamic_Delaunay_triangulations_2::internal::infinite_index;
  }
  /// the position of vertex `v`; NaNs for the infinite vertex.
  const Position& position(Vertex_index v) const { return m_state->positions()[v]; }
  /// the positions of all vertices, indexed by their numbers.
  const Positions& positions() const { return m_state->positions(); }
  /// the position of vertex `v` one frame ago, in periodic space the image of it that is nearest to
  /// the present position. Valid only while classifying.
  Position previous_position(Vertex_index v) const { return m_state->previous_position(v); }
  /// whether all positions equal the coordinates of the points, none of them rounded, and circles
  /// are Euclidean. Otherwise nothing exact follows from positions.
  bool positions_are_exact() const { return m_state->positions_are_exact(); }

  /// @}
  /// \name Edges and Faces
  /// @{

  /// edge `e` with its two opposite vertices.
  decltype(auto) edge(Edge_index e) const { return m_state->edge(e); }
  /// all edges, indexed by their numbers. Not in periodic space.
  const std::vector<Edge>& edges() const
  {
    static_assert(!State::is_periodic, "periodic space has no array of edges: use edge()");
    return m_state->arrays().edges();
  }
  /// whether one end of `edge` is the infinite vertex.
  static bool is_infinite(const Edge& edge)
  {
    return is_infinite(edge.source) || is_infinite(edge.target);
  }
  /// the three vertices of face `f`. They were counterclockwise when the face was made.
  std::array<Vertex_index, 3> face(Face_index f) const { return m_state->face(f); }

  /// the two faces at edge `e`: first the one with the vertex `left` of `edge(e)`, then the one
  /// with `right`.
  std::array<Face_index, 2> faces_at(Edge_index e) const
  {
    const auto& arrays = m_state->arrays();
    if (arrays.is_empty_edge(e))
      return {Face_index(0), Face_index(0)};
    const Halfedge_index h = arrays.halfedge(e);
    const Face_index f = arrays.face_of(h), g = arrays.face_of(arrays.twin(h));
    return m_state->is_along(e, h) ? std::array<Face_index, 2>{f, g}
                                   : std::array<Face_index, 2>{g, f};
  }

  /// calls `f(w)` for every neighbor `w` of vertex `v`, including the infinite vertex.
  template <class Function>
  void for_each_neighbor(Vertex_index v, Function&& f) const
  {
    if (!m_state->arrays().is_outside(v))
      m_state->arrays().for_each_neighbor(v, f);
  }
  /// calls `f(s)` for the four other edges `s` of the two faces at edge `e`.
  template <class Function>
  void for_each_side(Edge_index e, Function&& f) const
  {
    if (!m_state->arrays().is_empty_edge(e))
      m_state->arrays().for_each_side(e, f);
  }
  /// calls `f(e)` for every edge `e` at vertex `v`.
  template <class Function>
  void for_each_incident_edge(Vertex_index v, Function&& f) const
  {
    const auto& arrays = m_state->arrays();
    if (!arrays.is_outside(v))
      arrays.for_each_corner(v, [&](Halfedge_index h) { f(arrays.edge_of(arrays.previous(h))); });
  }

  /// calls `f(e)` for every edge `e` whose test depends on the position of vertex `v`: the edges
  /// that end at `v`, and those to which `v` is opposite.
  template <class Function>
  void for_each_edge_that_sees(Vertex_index v, Function&& f) const
  {
    if (!m_state->arrays().is_outside(v))
      m_state->arrays().for_each_edge_that_sees(v, f);
  }

  /// how often the cell of periodic space has changed; 0 in the plane. What was proved for
  /// positions in an earlier cell does not hold in this one.
  std::size_t number_of_cell_changes() const { return m_state->number_of_cell_changes(); }

  /// @}
  /// \name Testing Edges
  /// @{

  /// the positions of the four vertices of edge `e`, as seen from the edge; NaNs for an infinite
  /// vertex.
  Corners corners(Edge_index e) const { return m_state->corners(e); }
  /// the corners of edge `e` for other positions, indexed by vertex numbers.
  Corners corners(Edge_index e, const Positions& positions) const
  {
    return m_state->corners(e, positions);
  }

  /// whether `corners(e)` equal the coordinates of the points, or of their images, with none of
  /// them rounded.
  bool corners_are_exact(Edge_index e) const { return m_state->corners_are_exact(e); }

  /// the vector from the source of edge `e` to its target; NaNs if one of them is infinite.
  Position edge_vector(Edge_index e) const { return m_state->edge_vector(e); }
  /// the positions of the three vertices of face `f`, as seen from the face; NaNs for an infinite
  /// vertex.
  std::array<Position, 3> face_corners(Face_index f) const { return m_state->face_corners(f); }

  /// whether one of the four vertices of edge `e` is the infinite one; in a slab, whether they are
  /// not all on one side of the gap beside the slab.
  bool is_at_infinity(Edge_index e) const { return m_state->is_at_infinity(e); }
  /// for an edge at infinity: whether its finite face is not counterclockwise, or the hull turns
  /// right at the edge's end, in floating point (in a slab exactly). False for other edges.
  bool breaks_hull(Edge_index e) const { return m_state->breaks_hull(e); }

  /// whether edge `e` needs no repair: it is locally Delaunay, its faces are counterclockwise, and
  /// the hull is convex there. Decided exactly.
  bool is_delaunay(Edge_index e) const
  {
    return edge_state(e) == Dynamic_Delaunay_triangulations_2::Edge_state_2::DELAUNAY;
  }
  /// what is wrong with edge `e`, if anything. Decided exactly, except that in the plane a
  /// `NOT_FLIPPABLE` edge may be reported as `INVERTED`.
  Dynamic_Delaunay_triangulations_2::Edge_state_2 edge_state(Edge_index e) const
  {
    return Edge_test(*m_state).rough_state(e);
  }

  /// true only if edge `e` is Delaunay and not at infinity. Decided in floating point with proved
  /// bounds alone: false if these do not suffice, or if positions are rounded.
  bool proves_delaunay(Edge_index e) const { return Edge_test(*m_state).proves_delaunay(e); }

  /// appends to `unproved` the edges from `first` to before `beyond` for which `proves_delaunay()`
  /// is false: all that are not Delaunay, and a few others. An exact classifier tests all edges
  /// this way, and lets `Dynamic_classification_2::add_unless_delaunay()` decide about the appended
  /// ones. Cost: one pass, with AVX2 four edges at once.
  /// \pre `first <= beyond`, and `beyond <= number_of_edges()`
  void append_unproved(Index first, Index beyond, std::vector<Edge_index>& unproved) const
  {
    Edge_test(*m_state).append_unproved(first, beyond, unproved);
  }
  /// appends to `unproved` those of the edges in a list for which `proves_delaunay()` is false.
  void append_unproved(const std::vector<Edge_index>& edges,
                       std::vector<Edge_index>& unproved) const
  {
    Edge_test(*m_state).append_unproved(edges, unproved);
  }

  /// whether the hull turns around once, given that it is convex at each of its vertices. Otherwise
  /// a triangulation could overlap itself although all its edges are Delaunay. Cost: a walk around
  /// the hull. Always true in periodic space.
  bool hull_turns_once() const
  {
    return Dynamic_Delaunay_triangulations_2::internal::Certificate_2<State>(*m_state)
        .hull_turns_once();
  }

  /// @}
  /// \name What the last update triangulated anew
  /// @{

  /// whether everything was triangulated anew: at the start, after a rebuild, after
  /// `read_checkpoint()`, and after CGAL's relocations.
  bool everything_is_new() const { return m_state->changes().everything_is_new; }
  /// if not everything is new: the edges in the regions that were triangulated anew. After an
  /// update each of them is listed once.
  const std::vector<Edge_index>& new_edges() const { return m_state->changes().new_edges; }
  /// the vertices that jumped and were moved to other faces, if not everything is new and no
  /// numbers changed. All their edges are among `new_edges()`. In periodic space also the vertices
  /// of points that are given by another image than before, as where they were wrapped: their edges
  /// need not be new, and a classifier is told of them already while it classifies. A classifier
  /// that remembers positions has to replace those of these vertices.
  const std::vector<Vertex_index>& relocated_vertices() const
  {
    return m_state->changes().relocated;
  }
  /// whether vertices were inserted or removed, but not everything is new. Then some vertices,
  /// edges and faces have taken the numbers of removed ones.
  bool has_other_numbers() const
  {
    return !everything_is_new() && !m_state->changes().renumberings.are_none();
  }
  /// updates per-vertex data, indexed by vertex numbers from 0 on, after vertices were inserted or
  /// removed, if not everything is new. Moves the data of vertices whose numbers changed, and
  /// appends `make(v)` for every inserted vertex `v`. Cost: proportional to the number of both.
  template <class T, class Allocator, class Make>
  void follow_vertices(std::vector<T, Allocator>& data, const Make& make) const
  {
    m_state->changes().renumberings.vertices.follow(data, number_of_vertices() + std::size_t(1),
                                                    make);
  }
  /// updates per-edge data as `follow_vertices()` does per-vertex data, with `T()` for new edges,
  /// which are all among `new_edges()`.
  template <class T>
  void follow_edges(std::vector<T>& data) const
  {
    m_state->changes().renumberings.edges.follow(data, number_of_edges(),
                                                 [](Edge_index) { return T(); });
  }
  /// updates per-face data, with `T()` for new faces, all of which `for_each_changed_face()`
  /// visits.
  template <class T>
  void follow_faces(std::vector<T>& data) const
  {
    m_state->changes().renumberings.faces.follow(data, number_of_faces(),
                                                 [](Face_index) { return T(); });
  }
  /// whether anything was triangulated anew. While classifying, this is true only if an exception
  /// ended the last update before the classifier was told.
  bool has_changes() const
  {
    return everything_is_new() || !new_edges().empty() || has_other_numbers();
  }

  /// calls `f(e)` for every edge `e` that was triangulated anew, or whose opposite vertices may
  /// have changed; for some of them more than once. Every changed face has a new edge, so these are
  /// the new edges and the other edges of their faces.
  template <class Function>
  void for_each_changed_edge(Function&& f) const
  {
    if (everything_is_new()) {
      for (Edge_index e(0); e < number_of_edges(); ++e)
        f(e);
      return;
    }
    for (const Edge_index e : new_edges()) {
      f(e);
      for_each_side(e, f);
    }
  }

  /// calls `f(g)` for every face `g` at a new edge, for some of them more than once. These are all
  /// the faces that may have changed.
  template <class Function>
  void for_each_changed_face(Function&& f) const
  {
    if (everything_is_new()) {
      for (Face_index g(0); g < number_of_faces(); ++g)
        f(g);
      return;
    }
    for (const Edge_index e : new_edges())
      for (const Face_index g : faces_at(e))
        f(g);
  }

  /// @}

  /// \cond
  // The proofs of tolerances for edges.
  using Slacks = typename State::Slacks;
  // How passes are divided among threads.
  using Parts = typename State::Parts;
  const State& state() const { return *m_state; }
  /// \endcond

private:
  using Edge_test = typename State::Edge_test;

  const State* m_state;
};

} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_VIEWS_DYNAMIC_FRAME_2_H

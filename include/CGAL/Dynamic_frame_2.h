// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_FRAME_2_H
#define CGAL_DYNAMIC_FRAME_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Certificate_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Computed_geometry_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Edge_test_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Neighborhood_mirror_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Points_2.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgDynamicDelaunayTriangulation2Ref

What a classifier sees: the points, edges and faces of the maintained triangulation as flat arrays,
at the positions of the current frame and with the topology of the last one. It is a view: it copies
nothing, and is good until the next update.

Vertices are numbered from 1 to `number_of_vertices()` along the plane, 0 is the infinite vertex;
edges and faces are numbered from 0. These numbers may change when the triangulation is rebuilt, and
a few of them when points come or go; the ids of the points never do. A frame has edges and faces
only while the points span the plane; otherwise classifiers are not asked.

\tparam Maintained an internal type.
*/
template <class Maintained>
class Dynamic_frame_2
{
public:
  /// the type of all numbers: an unsigned integer of 32 bits.
  using Index = Dynamic_Delaunay_triangulations_2::Index;
  /// two doubles, `x` and `y`. Where the kernel's coordinates are not doubles, the nearest ones.
  using Position = Dynamic_Delaunay_triangulations_2::Position_2;
  /// four vertices, `source`, `target`, `left` and `right`: the ends of an edge, and the vertices
  /// opposite to it in its two faces.
  using Edge = Dynamic_Delaunay_triangulations_2::Edge_2;
  /// four positions, `left`, `source`, `target` and `right`: where the vertices of an edge are.
  using Corners = Dynamic_Delaunay_triangulations_2::Edge_corners_2;

  /// \cond
  explicit Dynamic_frame_2(const Maintained& maintained)
    : m_maintained(&maintained)
  {
  }
  /// \endcond

  /// \name Sizes
  /// @{

  /// the number of points.
  Index number_of_points() const { return m_maintained->ids().number_of_points(); }
  /// one more than the largest id ever in use.
  Index number_of_ids() const { return m_maintained->ids().number_of_ids(); }
  /// the number of finite vertices: fewer than points, if some of these coincide.
  Index number_of_vertices() const { return m_maintained->number_of_vertices(); }
  /// the number of edges, those to the infinite vertex included.
  Index number_of_edges() const { return m_maintained->mirror().number_of_edges(); }
  /// the number of faces, the infinite ones included.
  Index number_of_faces() const { return m_maintained->mirror().number_of_faces(); }

  /// @}
  /// \name Points
  /// @{

  /// whether there is a point `id`.
  bool has_id(std::size_t id) const { return m_maintained->ids().is_taken(id); }
  /// the vertex of the point `id`. \pre `has_id(id)`
  Index vertex(std::size_t id) const { return m_maintained->ids().vertex(Index(id)); }
  /// the id of a point at the finite vertex `v`; of the one that was there first, if several are.
  Index id(Index v) const { return m_maintained->ids().representative(v); }
  /// calls `f(i)` for the id `i` of every point that shares the vertex of one that was there first,
  /// smaller ids first. Cost: proportional to their number.
  template <class Function>
  void for_each_duplicate(Function&& f) const
  {
    for (const auto& duplicate : m_maintained->ids().duplicates())
      f(duplicate.id);
  }
  /// whether `v` is the infinite vertex.
  static bool is_infinite(Index v)
  {
    return v == Dynamic_Delaunay_triangulations_2::internal::infinite_index;
  }
  /// where vertex `v` is; NaNs for the infinite one.
  const Position& position(Index v) const { return m_maintained->positions()[v]; }
  /// where all vertices are, by their numbers.
  const std::vector<Position>& positions() const { return m_maintained->positions(); }
  /// where vertex `v` was one frame ago. Only while classifying.
  Position previous_position(Index v) const
  {
    return Dynamic_Delaunay_triangulations_2::internal::approximation(
        m_maintained->previous_point(v));
  }
  /// whether all positions are the very coordinates of the points, none of them rounded.
  bool positions_are_exact() const { return m_maintained->positions_are_exact(); }

  /// @}
  /// \name Edges and Faces
  /// @{

  /// edge `e` with its two opposite vertices.
  const Edge& edge(Index e) const { return m_maintained->mirror().edge(e); }
  /// all edges, in their numbering.
  const std::vector<Edge>& edges() const { return m_maintained->mirror().edges(); }
  /// whether one end of `edge` is the infinite vertex.
  static bool is_infinite(const Edge& edge)
  {
    return is_infinite(edge.source) || is_infinite(edge.target);
  }
  /// the three vertices of face `f`, counterclockwise when the face was made.
  std::array<Index, 3> face(Index f) const { return m_maintained->mirror().face(f); }

  /// the two faces at edge `e`: the one with the vertex `left` of `edge(e)`, and the one with
  /// `right`.
  std::array<Index, 2> faces_at(Index e) const
  {
    const auto& mirror = m_maintained->mirror();
    const Index h = mirror.halfedge(e);
    const Index f = mirror.face_of(h), g = mirror.face_of(mirror.twin(h));
    if (mirror.source(h) == edge(e).source)
      return {f, g};
    return {g, f};
  }

  /// calls `f(w)` for every neighbor `w` of vertex `v`, the infinite vertex included.
  template <class Function>
  void for_each_neighbor(Index v, Function&& f) const
  {
    m_maintained->mirror().for_each_neighbor(v, f);
  }
  /// calls `f(s)` for the four other edges `s` of the two faces at edge `e`.
  template <class Function>
  void for_each_side(Index e, Function&& f) const
  {
    m_maintained->mirror().for_each_side(e, f);
  }
  /// calls `f(e)` for every edge `e` at vertex `v`.
  template <class Function>
  void for_each_incident_edge(Index v, Function&& f) const
  {
    const auto& mirror = m_maintained->mirror();
    mirror.for_each_corner(v, [&](Index h) { f(mirror.edge_of(mirror.previous(h))); });
  }

  /// calls `f(e)` for every edge `e` that changes if vertex `v` moves: those that end at `v`, and
  /// those to which it is opposite.
  template <class Function>
  void for_each_edge_that_sees(Index v, Function&& f) const
  {
    const auto& mirror = m_maintained->mirror();
    mirror.for_each_corner(v, [&](Index h) {
      f(mirror.edge_of(h));
      f(mirror.edge_of(mirror.previous(h)));
    });
  }

  /// @}
  /// \name Testing Edges
  /// @{

  /// where the four vertices of edge `e` are, as seen from the edge; NaNs for an infinite vertex.
  Corners corners(Index e) const { return m_maintained->corners(e); }
  /// the same if the vertices were at other positions, given by their numbers.
  Corners corners(Index e, const std::vector<Position>& positions) const
  {
    return m_maintained->corners(e, positions);
  }

  /// whether one of the four vertices of edge `e` is the infinite one.
  bool is_at_infinity(Index e) const
  {
    return Dynamic_Delaunay_triangulations_2::internal::is_at_infinity(edge(e));
  }
  /// for an edge at infinity: whether its finite face is not counterclockwise, or the hull turns
  /// right where it passes the edge's end, as computed in floating point. False for all other
  /// edges.
  bool breaks_hull(Index e) const
  {
    return Dynamic_Delaunay_triangulations_2::internal::breaks_hull(edge(e), positions());
  }

  /// whether edge `e` needs no repair: it is locally Delaunay, its faces are counterclockwise, and
  /// the hull is convex there. Decided exactly.
  bool is_delaunay(Index e) const
  {
    return edge_state(e) == Dynamic_Delaunay_triangulations_2::Edge_state_2::DELAUNAY;
  }
  /// what is wrong with edge `e`, if anything. Decided exactly, except that an edge that is twisted
  /// may be called crossed.
  Dynamic_Delaunay_triangulations_2::Edge_state_2 edge_state(Index e) const
  {
    return Dynamic_Delaunay_triangulations_2::internal::Edge_test_2<Maintained>(*m_maintained)
        .rough_state(e);
  }

  /// appends to `unproved` edges from `first` to before `beyond` among which are all of those that
  /// are not Delaunay, and few others. This is how an exact classifier looks at all edges: some two
  /// nanoseconds an edge, in floating point with proved bounds, four edges at once where the
  /// processor has AVX2. Where positions are rounded all edges are appended.
  /// `Dynamic_classification_2::add_unless_delaunay()` decides about what it appended. \pre `first
  /// <= beyond <= number_of_edges()`
  void append_unproved(Index first, Index beyond, std::vector<Index>& unproved) const
  {
    if (positions_are_exact())
      return Dynamic_Delaunay_triangulations_2::internal::append_unproved<
          typename Maintained::Space>(edges().data(), positions(), first, beyond, unproved);
    for (Index e = first; e < beyond; ++e)
      unproved.push_back(e);
  }
  /// the same for the edges in a list.
  void append_unproved(const std::vector<Index>& edges, std::vector<Index>& unproved) const
  {
    using namespace Dynamic_Delaunay_triangulations_2::internal;
    if (positions_are_exact())
      append_unproved_of<typename Maintained::Space>(this->edges().data(), positions(), edges,
                                                     unproved);
    else
      unproved.insert(unproved.end(), edges.begin(), edges.end());
  }

  /// whether the hull turns around once, if it is convex at each of its vertices. Without that a
  /// triangulation of which all edges are Delaunay can lie on top of itself. Cost: a walk around
  /// the hull.
  bool hull_turns_once() const
  {
    return Dynamic_Delaunay_triangulations_2::internal::Certificate_2<Maintained>(*m_maintained)
        .hull_turns_once();
  }

  /// @}
  /// \name What the last update triangulated anew
  /// @{

  /// whether that was everything: at the start, after a rebuild, and after CGAL's relocations.
  bool everything_is_new() const { return m_maintained->changes().everything_is_new; }
  /// the edges in the regions that were triangulated anew, if not everything was; after an update
  /// each of them once.
  const std::vector<Index>& new_edges() const { return m_maintained->changes().new_edges; }
  /// the vertices that jumped, and were put into other faces, if not everything is new and numbers
  /// have stayed: all edges at them are among `new_edges()`.
  const std::vector<Index>& relocated_vertices() const { return m_maintained->changes().relocated; }
  /// whether vertices came or went, and everything else is not new: then some vertices, edges and
  /// faces have taken the numbers of others that went.
  bool has_other_numbers() const
  {
    return !everything_is_new() && !m_maintained->changes().renumberings.are_none();
  }
  /// brings data of each vertex, in the order of their numbers from 0 on, in step after vertices
  /// came or went, if not everything is new: moves those of vertices that have other numbers now,
  /// and appends `make(v)` for every vertex `v` that came. Cost: proportional to those.
  template <class T, class Make>
  void follow_vertices(std::vector<T>& data, const Make& make) const
  {
    m_maintained->changes().renumberings.vertices.follow(
        data, number_of_vertices() + std::size_t(1), make);
  }
  /// the same for data of each edge, with `T()` for those that came: all of them are among
  /// `new_edges()`.
  template <class T>
  void follow_edges(std::vector<T>& data) const
  {
    m_maintained->changes().renumberings.edges.follow(data, number_of_edges(),
                                                      [](Index) { return T(); });
  }
  /// the same for data of each face; all that came are visited by `for_each_changed_face()`.
  template <class T>
  void follow_faces(std::vector<T>& data) const
  {
    m_maintained->changes().renumberings.faces.follow(data, number_of_faces(),
                                                      [](Index) { return T(); });
  }
  /// whether anything was. While classifying that is so only if an exception ended the last update
  /// before the classifier was told.
  bool has_changes() const
  {
    return everything_is_new() || !new_edges().empty() || has_other_numbers();
  }

  /// calls `f(e)` for every edge `e` that was triangulated anew or may have got another opposite
  /// vertex by that; for some of them more than once. Every face that has changed has a new edge,
  /// so these are the new edges and the other edges of their faces.
  template <class Function>
  void for_each_changed_edge(Function&& f) const
  {
    if (everything_is_new()) {
      for (Index e = 0; e < number_of_edges(); ++e)
        f(e);
      return;
    }
    for (const Index e : new_edges()) {
      f(e);
      for_each_side(e, f);
    }
  }

  /// calls `f(g)` for every face `g` that may have changed by that, for some of them more than
  /// once.
  template <class Function>
  void for_each_changed_face(Function&& f) const
  {
    if (everything_is_new()) {
      for (Index g = 0; g < number_of_faces(); ++g)
        f(g);
      return;
    }
    for (const Index e : new_edges())
      for (const Index g : faces_at(e))
        f(g);
  }

  /// @}

private:
  const Maintained* m_maintained;
};

} // namespace CGAL

#endif // CGAL_DYNAMIC_FRAME_2_H

// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_MENDING_CLUSTER_SPLICE_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_MENDING_CLUSTER_SPLICE_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Flat_arrays.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/static/Flat_faces_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/static/Static_triangulator_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/static/Vertex_order_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/topology/Halfedge_arrays_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/topology/Topology_editor_2.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <utility>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

enum class Splice_result_2 {
  DONE,
  KEPT, // the old faces, as no others were found that fit
  TOO_LARGE,
  TOO_DEAR,
  COINCIDENCE
};

// What splices may do (in), and what they have done (out).
struct Splice_limits_2
{
  std::size_t max_enlargements; // in, per cluster: if it needs more, it keeps its old faces
  std::size_t max_vertices;     // in: to triangulate in all; out: how many of these are left
  std::size_t enlargements = 0; // out, of all clusters
};

// Adds the finite neighbors of the vertices of a region, from the `first` vertex on.
template <class State>
void add_layer(const State& state, Index_set<Vertex_index>& region, std::size_t first = 0)
{
  for (const std::size_t beyond = region.size(); first < beyond; ++first)
    state.arrays().for_each_neighbor(region[first], [&](Vertex_index w) {
      if (w != infinite_index)
        region.insert(w);
    });
}

// Replaces a region by those of these vertices that are in faces, and some layers around them.
// Returns how many of these vertices there are; they come first.
template <class State>
std::size_t collect_region(const State& state, const std::vector<Vertex_index>& vertices,
                           unsigned layers, Index_set<Vertex_index>& region)
{
  region.clear(state.arrays().number_of_vertices());
  for (const Vertex_index v : vertices)
    if (!state.arrays().is_outside(v))
      region.insert(v);
  const std::size_t inner = region.size();
  for (unsigned layer = 0; layer < layers; ++layer)
    add_layer(state, region);
  return inner;
}

// Triangulates a cluster of connected vertices and its border alone, and puts the new faces around
// the cluster in place of the old ones.
//
// A splice is correct only if the old and the new faces have the same boundary, edge for edge (an
// open problem of the thesis: an edge could get lost). Where the boundaries differ, their vertices
// join the cluster, which is then triangulated again.
template <class State>
class Cluster_splice_2
{
  using Arrays = Halfedge_arrays_2;

public:
  explicit Cluster_splice_2(const State& state)
    : m_state(state)
    , m_order(state)
    , m_triangulator(state)
  {
  }

  void set_engine(Static_engine_2 engine) { m_triangulator.set_engine(engine); }

  // Starts a cluster: v, and all vertices that can be reached from v through vertices w for which
  // `belongs(w)` is true.
  template <class Belongs>
  void collect(Vertex_index v, const Belongs& belongs)
  {
    m_cluster.clear(m_state.arrays().number_of_vertices());
    m_cluster.insert(v);
    for (std::size_t i = 0; i < m_cluster.size(); ++i)
      m_state.arrays().for_each_neighbor(m_cluster[i], [&](Vertex_index w) {
        if (belongs(w))
          m_cluster.insert(w);
      });
  }

  // Makes new faces, and writes nothing. Enlarges the cluster until they fit, within `limits`.
  Splice_result_2 make(Splice_limits_2& limits)
  {
    constexpr std::size_t gentle_enlargements = 3;
    for (std::size_t enlargements = 0;; ++enlargements) {
      collect_old_faces();
      const std::size_t size = m_cluster.size() + m_border.size();
      if (is_too_large(size))
        return Splice_result_2::TOO_LARGE;
      if (size > limits.max_vertices)
        return Splice_result_2::TOO_DEAR;
      limits.max_vertices -= size;
      if (!triangulate())
        return Splice_result_2::COINCIDENCE;
      collect_new_faces();
      if (boundaries_agree() && !doubles_an_edge())
        return Splice_result_2::DONE;
      if (enlargements == limits.max_enlargements)
        return Splice_result_2::KEPT;
      grow(enlargements >= gentle_enlargements);
      ++limits.enlargements;
    }
  }

  // Replaces the old faces by the new ones, if these fit. Lists their boundary edges: all others of
  // them are Delaunay.
  void put_in(Topology_editor_2<State>& editor, std::vector<Edge_index>& boundary_edges)
  {
    m_outside.clear();
    for (const Boundary_edge_2& edge : m_old_boundary) {
      m_outside.push_back(m_state.arrays().twin(edge.halfedge));
      boundary_edges.push_back(m_state.arrays().edge_of(edge.halfedge));
    }
    editor.replace(m_old_faces, m_new, m_outside);
  }

  // From half of all points on, a fresh triangulation of all points costs less.
  bool is_too_large(std::size_t region) const { return 2 * region > m_state.number_of_vertices(); }

  const Index_set<Vertex_index>& cluster() const { return m_cluster; }
  const Index_set<Vertex_index>& border() const { return m_border; }
  // The vertices that were triangulated last. If a coincidence was found, two of them coincide.
  const std::vector<Vertex_index>& region() const { return m_region; }

private:
  // Adds the vertices where the two boundaries differ, or the whole border if none of these is new.
  // From the fourth enlargement on, adds the border and further layers until the cluster has
  // doubled, so that all enlargements together cost at most about twice as much as the last one.
  void grow(bool doubles)
  {
    const std::size_t size = m_cluster.size();
    for (const Vertex_index v : m_disagreeing)
      if (v != infinite_index)
        m_cluster.insert(v);
    if (m_cluster.size() == size || doubles)
      for (const Vertex_index v : m_border)
        m_cluster.insert(v);
    for (std::size_t first = 0; doubles && m_cluster.size() < 2 * size;) {
      const std::size_t beyond = m_cluster.size();
      add_layer(m_state, m_cluster, std::exchange(first, beyond));
      if (m_cluster.size() == beyond)
        return;
    }
  }

  // FACES ---------------------------------------------------------------------------------------

  // Collects the faces around the cluster, their outer vertices and their boundary.
  void collect_old_faces()
  {
    const Arrays& arrays = m_state.arrays();
    m_old_faces.clear(arrays.number_of_faces());
    m_border.clear(m_state.arrays().number_of_vertices());
    m_has_infinite_faces = false;
    for (const Vertex_index v : m_cluster)
      arrays.for_each_corner(v, [&](Halfedge_index h) {
        m_old_faces.insert(Arrays::face_of(h));
        const Vertex_index w = arrays.source(h);
        if (w == infinite_index)
          m_has_infinite_faces = true;
        else if (!m_cluster.contains(w))
          m_border.insert(w);
      });
    m_old_boundary.clear();
    for (const Face_index f : m_old_faces)
      for (const Halfedge_index h : Arrays::halfedges_of(f))
        if (!m_old_faces.contains(Arrays::face_of(arrays.twin(h))))
          m_old_boundary.push_back({arrays.source(h), arrays.target(h), h});
    std::sort(m_old_boundary.begin(), m_old_boundary.end());
  }

  // False if two of the points coincide: triangulating them would lose a vertex.
  bool triangulate()
  {
    m_region.assign(m_cluster.begin(), m_cluster.end());
    m_region.insert(m_region.end(), m_border.begin(), m_border.end());
    m_order.sort(m_region.begin(), m_region.end());
    if (m_order.has_coincident_vertices())
      return false;
    m_triangulator.run(m_order.order());
    return true;
  }

  // Collects the faces that have a vertex of the cluster.
  void collect_new_faces()
  {
    const Flat_faces_2& faces = m_triangulator.faces();
    m_new.clear();
    m_new_number.assign(faces.number_of_faces(), null_index);
    Face_index number(0);
    for (Face_index f(0); f < faces.number_of_faces(); ++f) {
      const Flat_halfedge_index h = Flat_faces_2::first_halfedge(f);
      if (m_cluster.contains(faces.apex(h)) || m_cluster.contains(faces.apex(h + 1)) ||
          m_cluster.contains(faces.apex(h + 2)))
        m_new_number[f] = number++;
    }
    for (Face_index f(0); f < faces.number_of_faces(); ++f)
      if (m_new_number[f] != null_index)
        for (Index i = 0; i < 3; ++i) {
          const Flat_halfedge_index h = Flat_faces_2::first_halfedge(f) + i;
          const Halfedge_index g = Flat_faces_2::number_in_arrays(faces.twin(h));
          const Face_index neighbor = m_new_number[Arrays::face_of(g)];
          m_new.apexes.push_back(faces.apex(h));
          m_new.twins.push_back(neighbor == null_index
                                    ? null_index
                                    : Arrays::halfedge_in(neighbor, Arrays::number_in_face(g)));
        }
    m_new.find_boundary();
  }

  // BOUNDARIES ----------------------------------------------------------------------------------

  // Whether the result is a sphere with all vertices again (guarantee 1 in the manual): the old and
  // the new faces have equal boundary edges, are equally many, and both or neither of them include
  // infinite faces. No condition suffices alone: a cluster that was turned inside out can swap the
  // infinite vertex for a vertex of its border.
  bool boundaries_agree()
  {
    find_disagreeing();
    return m_disagreeing.empty() && m_old_faces.size() == m_new.number_of_faces() &&
           m_has_infinite_faces == has_new_infinite_faces();
  }

  bool has_new_infinite_faces() const
  {
    return std::find(m_new.apexes.begin(), m_new.apexes.end(), infinite_index) !=
           m_new.apexes.end();
  }

  void find_disagreeing()
  {
    m_unmatched.clear();
    m_disagreeing.clear();
    std::set_symmetric_difference(m_old_boundary.begin(), m_old_boundary.end(),
                                  m_new.boundary.begin(), m_new.boundary.end(),
                                  std::back_inserter(m_unmatched));
    for (const Boundary_edge_2& edge : m_unmatched)
      m_disagreeing.insert(m_disagreeing.end(), {edge.source, edge.target});
  }

  // Whether an edge between two new faces joins vertices outside of the cluster that another edge,
  // which is not between two old faces, joins already. This is possible only where old faces
  // overlap. Adds such vertices to the disagreeing ones.
  bool doubles_an_edge()
  {
    for (Halfedge_index h(0); h < Index(m_new.twins.size()); ++h) {
      const Vertex_index v = m_new.apexes[Arrays::next(h)], w = m_new.apexes[Arrays::previous(h)];
      if (m_new.twins[h] != null_index && v < w && !m_cluster.contains(v) &&
          !m_cluster.contains(w) && is_edge_outside(w, v)) {
        m_disagreeing.push_back(v);
        m_disagreeing.push_back(w);
      }
    }
    return !m_disagreeing.empty();
  }

  // Whether some edge from v to w is not between two old faces. Walks around the finite vertex v.
  bool is_edge_outside(Vertex_index v, Vertex_index w)
  {
    const Arrays& arrays = m_state.arrays();
    bool is_outside = false;
    arrays.for_each_corner(v, [&](Halfedge_index h) {
      const Halfedge_index beyond = arrays.twin(Arrays::previous(h));
      is_outside = is_outside || (arrays.apex(Arrays::next(h)) == w &&
                                  !(m_old_faces.contains(Arrays::face_of(h)) &&
                                    m_old_faces.contains(Arrays::face_of(beyond))));
    });
    return is_outside;
  }

  const State& m_state;
  Vertex_order_2<State> m_order;
  Static_triangulator_2<State> m_triangulator;
  Index_set<Vertex_index> m_cluster, m_border;
  Index_set<Face_index> m_old_faces;
  bool m_has_infinite_faces = false;           // among the old faces
  std::vector<Boundary_edge_2> m_old_boundary; // sorted by source, then target
  std::vector<Boundary_edge_2> m_unmatched;    // boundary edges of either faces alone
  std::vector<Halfedge_index> m_outside;       // beyond the old boundary
  std::vector<Vertex_index> m_region;
  Column<Face_index, Face_index> m_new_number; // of each face of the triangulator
  Patch_2 m_new;
  std::vector<Vertex_index> m_disagreeing;
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_MENDING_CLUSTER_SPLICE_2_H

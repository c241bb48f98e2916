// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_MENDING_BORDER_SPLICE_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_MENDING_BORDER_SPLICE_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Flat_arrays.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/mending/Cluster_splice_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/topology/Topology_editor_2.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

// The border splice (thesis 4.1.3 and 4.1.4). The Triangulation set is the Classified set, its
// padding and one layer of border around both. It is triangulated alone, and the faces of that
// triangulation around the Classified and Padded vertices replace the old ones. Clusters of
// connected vertices are spliced one after the other (`Cluster_splice_2`), so that their data stay
// in the cache.
template <class State>
class Border_splice_2
{
public:
  explicit Border_splice_2(const State& state)
    : m_state(state)
    , m_cluster(state)
  {
  }

  void set_engine(Static_engine_2 engine) { m_cluster.set_engine(engine); }

  // Splices around `classified` with `padding` layers. Vertices that are in no face are skipped.
  Splice_result_2 run(Topology_editor_2<State>& editor, const std::vector<Vertex_index>& classified,
                      unsigned padding, Splice_limits_2& limits)
  {
    const std::size_t bound = m_state.arrays().number_of_vertices();
    m_border.clear(bound);
    m_spliced.clear(bound);
    m_boundary_edges.clear();
    m_number_of_classified = collect_region(m_state, classified, padding, m_inner);
    if (m_cluster.is_too_large(m_inner.size()))
      return Splice_result_2::TOO_LARGE;
    for (std::size_t i = 0; i < m_inner.size(); ++i)
      if (!m_spliced.contains(m_inner[i])) {
        const Splice_result_2 result = make_cluster(i, limits);
        if (result != Splice_result_2::DONE)
          return result;
        put_in(editor);
      }
    return Splice_result_2::DONE;
  }

  // The sets of the last run. Padded includes all vertices that joined by enlargements.
  std::size_t number_of_padded() const { return m_inner.size() - m_number_of_classified; }
  std::size_t number_of_border() const { return m_border.size(); }
  std::size_t number_of_vertices() const { return m_inner.size() + m_border.size(); }
  const Index_set<Vertex_index>& border() const { return m_border; }
  Vertex_index padded(std::size_t i) const { return m_inner[m_number_of_classified + i]; }
  // The vertices that were triangulated last. If a coincidence was found, two of them coincide.
  const std::vector<Vertex_index>& region() const { return m_cluster.region(); }
  // The boundary edges of the new faces. All other edges of these faces are Delaunay.
  const std::vector<Edge_index>& boundary_edges() const { return m_boundary_edges; }

private:
  // Makes new faces for the cluster of the i-th inner vertex: all inner vertices that are connected
  // with it and not spliced yet.
  Splice_result_2 make_cluster(std::size_t i, Splice_limits_2& limits)
  {
    m_cluster.collect(m_inner[i], [this](Vertex_index w) {
      return m_inner.contains(w) && !m_spliced.contains(w);
    });
    return m_cluster.make(limits);
  }

  void put_in(Topology_editor_2<State>& editor)
  {
    if (!m_cluster.fits()) {
      for (std::size_t i = 0; i < m_cluster.first_size(); ++i)
        m_spliced.insert(m_cluster.cluster()[i]);
      return;
    }
    m_outside.clear();
    for (const Boundary_edge_2& edge : m_cluster.old_boundary()) {
      m_outside.push_back(m_state.arrays().twin(edge.halfedge));
      m_boundary_edges.push_back(m_state.arrays().edge_of(edge.halfedge));
    }
    for (const Vertex_index v : m_cluster.cluster()) {
      m_spliced.insert(v);
      m_inner.insert(v);
    }
    for (const Vertex_index v : m_cluster.border())
      m_border.insert(v);
    editor.replace(m_cluster.old_faces(), m_cluster.new_faces(), m_outside);
  }

  const State& m_state;
  Cluster_splice_2<State> m_cluster; // the cluster that is being spliced
  Index_set<Vertex_index> m_inner;                 // Classified, then Padded
  Index_set<Vertex_index> m_spliced;               // a subset of m_inner
  Index_set<Vertex_index> m_border;
  std::vector<Edge_index> m_boundary_edges;
  std::size_t m_number_of_classified = 0;
  std::vector<Halfedge_index> m_outside; // half-edges beyond the boundary of a cluster
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_MENDING_BORDER_SPLICE_2_H

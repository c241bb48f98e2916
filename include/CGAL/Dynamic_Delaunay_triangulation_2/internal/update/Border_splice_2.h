// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_UPDATE_BORDER_SPLICE_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_UPDATE_BORDER_SPLICE_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/core/Flat_arrays_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/topology/Topology_editor_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/update/Cluster_splice_2.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

// The border splice (thesis 4.1.3 and 4.1.4). The Triangulation set is the Classified set, its
// padding and one layer of border around both. It is triangulated alone, and the faces of that
// triangulation around the Classified and Padded vertices replace the old ones. Clusters of
// connected vertices are spliced one after the other (`Cluster_splice_2`), so that their data stay
// in the cache. If clusters are many, threads make their new faces ahead (`Prepared_splices_2`).
template <class State>
class Border_splice_2
{
public:
  explicit Border_splice_2(const State& state)
    : m_state(state)
    , m_cluster(state)
    , m_prepared(state)
  {
  }

  void set_engine(Static_engine_2 engine)
  {
    m_cluster.set_engine(engine);
    m_prepared.set_engine(engine);
  }

  // Splices around `classified` with `padding` layers. Vertices that are in no face are skipped.
  Splice_result_2 run(Topology_editor_2<State>& editor, const std::vector<Index>& classified,
                      unsigned padding, Splice_limits_2& limits)
  {
    const std::size_t bound = m_state.arrays().number_of_vertices();
    m_border.clear(bound);
    m_spliced.clear(bound);
    m_boundary_edges.clear();
    m_prepared.clear();
    m_number_of_classified = collect_region(m_state, classified, padding, m_inner);
    if (m_cluster.is_too_large(m_inner.size()))
      return Splice_result_2::TOO_LARGE;
    for (std::size_t i = 0; i < m_inner.size(); ++i)
      if (!m_spliced.contains(m_inner[i])) {
        const Splice_result_2 result = make_cluster(editor, i, limits);
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
  const Index_set_2& border() const { return m_border; }
  Index padded(std::size_t i) const { return m_inner[m_number_of_classified + i]; }
  // The vertices that were triangulated last. If a coincidence was found, two of them coincide.
  const std::vector<Index>& region() const { return m_cluster.region(); }
  // The boundary edges of the new faces. All other edges of these faces are Delaunay.
  const std::vector<Index>& boundary_edges() const { return m_boundary_edges; }

private:
  // Makes new faces for the cluster of the i-th inner vertex: all inner vertices that are connected
  // with it and not spliced yet.
  Splice_result_2 make_cluster(const Topology_editor_2<State>& editor, std::size_t i,
                               Splice_limits_2& limits)
  {
    constexpr std::size_t any = std::size_t(-1);
    m_prepared.prepare(i, m_inner, m_spliced, limits.max_enlargements);
    if (auto* const record = m_prepared.find(i, limits)) {
      m_cluster.take(std::move(*record));
      prefetch_following(editor);
      return Splice_result_2::DONE;
    }
    m_cluster.collect(m_inner[i], any, [this](Vertex_index w) {
      return m_inner.contains(w) && !m_spliced.contains(w);
    });
    return m_cluster.make(limits);
  }

  // Fetches what the next records replace: other threads prepared these, so it is not in the cache.
  void prefetch_following(const Topology_editor_2<State>& editor) const
  {
    constexpr std::size_t ahead = 2;
    if (const auto* const record = m_prepared.following(2 * ahead))
      editor.prefetch(record->old_faces);
    if (const auto* const record = m_prepared.following(ahead))
      editor.prefetch_edges(record->old_faces);
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
    m_prepared.note_replaced(m_cluster.old_faces());
    editor.replace(m_cluster.old_faces(), m_cluster.new_faces(), m_outside);
  }

  const State& m_state;
  Cluster_splice_2<State> m_cluster; // the cluster that is being spliced
  Prepared_splices_2<State> m_prepared;
  Index_set_2 m_inner;   // Classified, then Padded
  Index_set_2 m_spliced; // a subset of m_inner
  Index_set_2 m_border;
  std::vector<Index> m_boundary_edges;
  std::size_t m_number_of_classified = 0;
  std::vector<Index> m_outside; // half-edges beyond the boundary of a cluster
};

// A region of a torus: some vertices, their padding, and one layer of border around both. It is not
// triangulated apart: the repair flips edges in the region, or puts its vertices in anew.
template <class State>
class Padded_region_2
{
public:
  explicit Padded_region_2(const State& state)
    : m_state(state)
  {
  }

  // Collects the region around `classified`. Skips vertices that are in no face.
  void run(const std::vector<Index>& classified, unsigned padding)
  {
    m_number_of_classified = collect_region(m_state, classified, padding, m_vertices);
    m_number_of_inner = m_vertices.size();
    add_layer(m_state, m_vertices);
  }

  // All vertices of the region, except the border.
  std::vector<Index> inner() const { return part(0, m_number_of_inner); }
  std::vector<Index> padded() const { return part(m_number_of_classified, m_number_of_inner); }
  std::vector<Index> border() const { return part(m_number_of_inner, m_vertices.size()); }

private:
  std::vector<Index> part(std::size_t first, std::size_t beyond) const
  {
    const std::vector<Index>& all = m_vertices.members();
    return {all.begin() + std::ptrdiff_t(first), all.begin() + std::ptrdiff_t(beyond)};
  }

  const State& m_state;
  Index_set_2 m_vertices; // classified, then padded, then border
  std::size_t m_number_of_classified = 0, m_number_of_inner = 0;
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_UPDATE_BORDER_SPLICE_2_H

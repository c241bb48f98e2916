// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_UPDATE_SPLICE_TOOL_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_UPDATE_SPLICE_TOOL_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Flat_arrays.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/mending/Cluster_splice_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/proof/Certificate_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/update/Cost_model_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/update/Flip_tool_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/update/Update_context_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/policies/Static_engine_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/policies/Update_report_2.h>

#include <cstddef>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

// The repairs of the thesis in the plane: the border splice (4.1.3 and 4.1.4), or CGAL's moves of
// one vertex after the other.
//
// The Triangulation set of a splice is the Classified set, its padding and one layer of border
// around both. It is triangulated alone, and the faces of that triangulation around the Classified
// and Padded vertices replace the old ones. Clusters of connected vertices are spliced one after
// the other, so that their data stay in the cache.
template <class State>
class Splice_tool_2
{
  using Context = Update_context_2<State>;

public:
  Splice_tool_2(Context& context, Flip_tool_2<State>&)
    : m_context(context)
    , m_state(context.state)
    , m_cluster(context.state)
  {
  }

  void set_engine(Static_engine_2 engine) { m_cluster.set_engine(engine); }

  void splice_classified(unsigned padding)
  {
    constexpr std::size_t any = std::size_t(-2);
    m_context.proof.open_illegal();
    if (!splice(m_context.classification.vertices(), padding, any, m_context.proof.is_required()))
      return;
    const auto padded = m_inner.end() - std::ptrdiff_t(number_of_padded());
    m_context.padded.assign(padded, m_inner.end());
    m_context.border = m_border.members();
  }

  void splice_open(unsigned padding)
  {
    constexpr std::size_t max_enlargements = 3; // then more padding does better
    m_context.proof.open_illegal();
    splice(m_context.proof.uncertain_vertices(m_state), padding, max_enlargements, true);
  }

  void relocate()
  {
    if (m_context.relocation.is_under_way())
      return m_context.rebuild(Rebuild_reason_2::POPULATION);
    if (!m_context.proof.is_rest_known() || !m_state.have_points_moved())
      return m_context.rebuild(Rebuild_reason_2::STUCK);
    const bool all_arrived = m_context.builder.relocate_all(m_context.report().relocated);
    m_context.proof.clear();
    if (!all_arrived)
      m_context.rebuild(Rebuild_reason_2::COINCIDENCE);
    else if (!m_state.spans_plane()) // without edges, nothing but a rebuild can help
      m_context.rebuild(Rebuild_reason_2::DIMENSION);
    else if (!Certificate_2<State>(m_state).holds())
      m_context.rebuild(Rebuild_reason_2::STUCK);
  }

private:
  // Splices around these vertices. Tests the uncertain and the boundary edges if `has_to_look`,
  // otherwise closes all. False if everything is rebuilt, or if this has merged vertices instead.
  bool splice(const std::vector<Vertex_index>& vertices, unsigned padding,
              std::size_t max_enlargements, bool has_to_look)
  {
    if (m_context.has_rebuilt())
      return false;
    m_context.proof.set_faces_tile_hull(false);
    m_context.proof.forget_hull();
    const std::size_t most = m_context.budget.left() / Cost_model_2::spliced_vertex;
    Splice_limits_2 limits{max_enlargements, most};
    const Splice_result_2 result = splice_clusters(vertices, padding, limits);
    m_context.budget.spend((most - limits.max_vertices) * Cost_model_2::spliced_vertex);
    m_context.report().enlargements += limits.enlargements;
    if (result == Splice_result_2::TOO_LARGE)
      m_context.rebuild(limits.enlargements == 0 ? Rebuild_reason_2::TOO_MUCH_BROKEN
                                                 : Rebuild_reason_2::STUCK);
    else if (result == Splice_result_2::TOO_DEAR)
      m_context.rebuild(Rebuild_reason_2::BUDGET_SPENT);
    else if (result == Splice_result_2::COINCIDENCE)
      merge();
    if (result != Splice_result_2::DONE)
      return false;
    Update_report_2& report = m_context.report();
    ++report.splices;
    report.padded += number_of_padded();
    report.border += m_border.size();
    report.spliced += m_inner.size() + m_border.size();
    // the spliced faces are Delaunay among themselves, but their boundary edges may not be
    if (has_to_look)
      m_context.proof.reopen(m_state, m_boundary_edges);
    else
      m_context.proof.clear();
    return true;
  }

  // DONE if nothing ends the splice, although some clusters may have kept their faces.
  Splice_result_2 splice_clusters(const std::vector<Vertex_index>& vertices, unsigned padding,
                                  Splice_limits_2& limits)
  {
    m_number_of_classified = collect_region(m_state, vertices, padding, m_inner);
    m_tried.clear(m_state.arrays().number_of_vertices());
    m_border.clear(m_state.arrays().number_of_vertices());
    m_boundary_edges.clear();
    if (m_cluster.is_too_large(m_inner.size()))
      return Splice_result_2::TOO_LARGE;
    for (std::size_t i = 0; i < m_inner.size(); ++i)
      if (m_tried.insert(m_inner[i])) {
        m_cluster.collect(m_inner[i], [this](Vertex_index w) {
          return m_inner.contains(w) && m_tried.insert(w);
        });
        const Splice_result_2 result = m_cluster.make(limits);
        if (result == Splice_result_2::DONE)
          put_cluster_in();
        else if (result != Splice_result_2::KEPT)
          return result;
      }
    return Splice_result_2::DONE;
  }

  void put_cluster_in()
  {
    for (const Vertex_index v : m_cluster.cluster()) {
      m_tried.insert(v);
      m_inner.insert(v);
    }
    for (const Vertex_index v : m_cluster.border())
      m_border.insert(v);
    m_cluster.put_in(m_context.editor, m_boundary_edges);
  }

  std::size_t number_of_padded() const { return m_inner.size() - m_number_of_classified; }

  // Merges vertices that have come to coincide. Other clusters may have been spliced before the
  // coincidence was found.
  void merge()
  {
    Update_proof_2& proof = m_context.proof;
    if (!proof.is_required())
      return m_context.rebuild(Rebuild_reason_2::COINCIDENCE);
    proof.reopen(m_state, m_boundary_edges);
    std::vector<Vertex_index> candidates = proof.uncertain_vertices(m_state);
    candidates.insert(candidates.end(), m_cluster.region().begin(), m_cluster.region().end());
    make_distinct(candidates);
    const std::size_t first_new = m_state.changes().new_edges.size();
    const std::size_t merged =
        m_context.relocation.merge(candidates, m_context.budget.left() / Cost_model_2::relocation);
    m_context.report().merged += merged;
    m_context.budget.spend(merged * Cost_model_2::relocation);
    proof.open_new_edges(m_state, first_new);
    proof.reopen(m_state, {});
    if (merged == 0 || m_context.budget.is_spent())
      m_context.rebuild(Rebuild_reason_2::COINCIDENCE);
  }

  Context& m_context;
  const State& m_state;
  Cluster_splice_2<State> m_cluster; // the cluster that is being spliced
  Index_set<Vertex_index> m_inner;   // Classified, then Padded, with all that joined a cluster
  Index_set<Vertex_index> m_tried;   // a subset of m_inner
  Index_set<Vertex_index> m_border;
  std::vector<Edge_index> m_boundary_edges; // of the new faces
  std::size_t m_number_of_classified = 0;
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_UPDATE_SPLICE_TOOL_2_H

// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_UPDATE_SPLICE_TOOL_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_UPDATE_SPLICE_TOOL_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Flat_arrays.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/mending/Border_splice_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/proof/Certificate_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/update/Cost_model_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/update/Flip_tool_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/update/Update_context_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/policies/Static_engine_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/policies/Update_report_2.h>

#include <cstddef>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

// The repairs of the thesis in the plane: triangulates regions apart and splices them in, or lets
// CGAL move one vertex after the other.
template <class State>
class Splice_tool_2
{
  using Context = Update_context_2<State>;
  using Proof = Update_proof_2;

public:
  Splice_tool_2(Context& context, Flip_tool_2<State>&)
    : m_context(context)
    , m_state(context.state)
    , m_splice(context.state)
  {
  }

  void set_engine(Static_engine_2 engine) { m_splice.set_engine(engine); }

  void splice_classified(unsigned padding)
  {
    constexpr std::size_t any = std::size_t(-2);
    m_context.proof.open_illegal();
    if (!splice(m_context.classification.vertices(), padding, any, m_context.proof.is_required()))
      return;
    for (std::size_t i = 0; i < m_splice.number_of_padded(); ++i)
      m_context.padded.push_back(m_splice.padded(i));
    m_context.border.assign(m_splice.border().begin(), m_splice.border().end());
  }

  void splice_open(unsigned padding)
  {
    constexpr std::size_t max_enlargements = 3; // then more padding does better
    m_context.proof.open_illegal();
    std::vector<Vertex_index> vertices;
    m_context.proof.for_each_uncertain_vertex(m_state,
                                              [&](Vertex_index v) { vertices.push_back(v); });
    splice(vertices, padding, max_enlargements, true);
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
  bool splice(const std::vector<Vertex_index>& vertices, unsigned padding, std::size_t max_enlargements,
              bool has_to_look)
  {
    if (m_context.has_rebuilt())
      return false;
    m_context.proof.set_faces(Proof::Faces::UNKNOWN);
    m_context.proof.forget_hull();
    const std::size_t most = m_context.budget.left() / Cost_model_2::spliced_vertex;
    Splice_limits_2 limits{max_enlargements, most};
    const Splice_result_2 result = m_splice.run(m_context.editor, vertices, padding, limits);
    m_context.budget.spend((most - limits.max_vertices) * Cost_model_2::spliced_vertex);
    m_context.report().enlargements += limits.enlargements;
    switch (result) {
    case Splice_result_2::TOO_LARGE:
      m_context.rebuild(limits.enlargements == 0 ? Rebuild_reason_2::TOO_MUCH_BROKEN
                                                 : Rebuild_reason_2::STUCK);
      return false;
    case Splice_result_2::TOO_DEAR:
      m_context.rebuild(Rebuild_reason_2::BUDGET_SPENT);
      return false;
    case Splice_result_2::COINCIDENCE:
      merge();
      return false;
    default:
      break;
    }
    report_splice();
    // the spliced faces are Delaunay among themselves, but their boundary edges may not be
    if (has_to_look)
      m_context.proof.reopen(m_state, m_splice.boundary_edges());
    else
      m_context.proof.clear();
    return true;
  }

  void report_splice()
  {
    Update_report_2& report = m_context.report();
    ++report.splices;
    report.padded += m_splice.number_of_padded();
    report.border += m_splice.number_of_border();
    report.spliced += m_splice.number_of_vertices();
  }

  // Merges vertices that have come to coincide. Other clusters may have been spliced before the
  // coincidence was found.
  void merge()
  {
    Proof& proof = m_context.proof;
    if (!proof.is_required())
      return m_context.rebuild(Rebuild_reason_2::COINCIDENCE);
    proof.reopen(m_state, m_splice.boundary_edges());
    std::vector<Vertex_index> candidates = m_splice.region();
    proof.for_each_uncertain_vertex(m_state, [&](Vertex_index v) { candidates.push_back(v); });
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
  Border_splice_2<State> m_splice;
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_UPDATE_SPLICE_TOOL_2_H

// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_UPDATE_REINSERTION_TOOL_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_UPDATE_REINSERTION_TOOL_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Flat_arrays.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/mending/Cluster_splice_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/topology/Star_polygon_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/update/Cost_model_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/update/Flip_tool_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/update/Update_context_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/policies/Static_engine_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/policies/Update_report_2.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

// The repairs of the thesis where no region can be triangulated apart: on a torus. Flips around the
// vertices of a region, or takes them out of their faces, to be put in again after the repair. A
// vertex can be located only where all is Delaunay, so a proof is required then.
template <class State>
class Reinsertion_tool_2
{
  using Context = Update_context_2<State>;

public:
  Reinsertion_tool_2(Context& context, Flip_tool_2<State>& flips)
    : m_context(context)
    , m_state(context.state)
    , m_flips(flips)
  {
  }

  static void set_engine(Static_engine_2) {}

  // Flips edges around the classified vertices and their padding, and puts in anew the vertices of
  // edges that cannot be flipped.
  void splice_classified(unsigned padding)
  {
    if (m_context.has_rebuilt())
      return;
    m_context.proof.open_illegal();
    const auto classified = std::ptrdiff_t(
        collect_region(m_state, m_context.classification.vertices(), padding, m_region));
    const auto inner = std::ptrdiff_t(m_region.size());
    for (const Vertex_index v : m_region)
      m_context.proof.open_around(m_state, v);
    add_layer(m_state, m_region);
    m_context.padded.assign(m_region.begin() + classified, m_region.begin() + inner);
    m_context.border.assign(m_region.begin() + inner, m_region.end());
    m_context.report().padded += m_context.padded.size();
    m_context.report().border += m_context.border.size();
    make_distinct(m_context.proof.uncertain());
    m_flips.flip();
    if (!m_context.is_done())
      splice_open(0);
    if (!m_context.proof.is_required())
      m_context.proof.clear();
  }

  void splice_open(unsigned padding)
  {
    m_context.proof.open_illegal();
    put_in_anew(m_context.proof.uncertain_vertices(m_state), padding);
  }

  void relocate() { put_in_anew(m_context.classification.vertices(), 0); }

private:
  void put_in_anew(const std::vector<Vertex_index>& vertices, unsigned padding)
  {
    if (m_context.has_rebuilt())
      return;
    collect_region(m_state, vertices, padding, m_region);
    if (!m_context.proof.is_required()) {
      m_context.proof.require_of_all(m_state);
      m_flips.flip();
    }
    if (m_context.has_rebuilt() || m_region.empty())
      return;
    // a sixth of a small torus: more are as much work as triangulating anew
    const std::size_t most = 10 + m_state.number_of_vertices() / 6;
    if (!m_context.can_spare(m_region.size()) ||
        m_context.relocation.number_waiting() + m_region.size() > most)
      return m_context.rebuild(Rebuild_reason_2::TOO_MUCH_BROKEN);
    m_context.budget.allow(m_region.size() * Cost_model_2::relocation);
    if (take_out(m_region.members()))
      m_flips.flip();
  }

  // Takes these vertices out if the budget allows it. Skips those whose faces meet images of
  // themselves, like the lowest point of a slab. Returns whether any is out.
  bool take_out(const std::vector<Vertex_index>& vertices)
  {
    const std::size_t price = price_of_taking_out(vertices);
    if (price > m_context.budget.left()) { // nothing else could mend so many edges either
      m_context.rebuild(Rebuild_reason_2::BUDGET_SPENT);
      return false;
    }
    const std::size_t first_new = m_state.changes().new_edges.size();
    bool is_any_out = false;
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      prefetch_stars<true>(m_state, i, vertices.size(), [&](std::size_t k) { return vertices[k]; });
      is_any_out |=
          m_context.relocation.take_out(vertices[i], m_state.previous_position(vertices[i]));
    }
    m_context.budget.spend(price);
    m_context.proof.open_new_edges(m_state, first_new);
    return is_any_out;
  }

  // The price of a vertex includes a few flips. A vertex of high degree takes more flips.
  std::size_t price_of_taking_out(const std::vector<Vertex_index>& vertices) const
  {
    constexpr std::size_t usual_degree = 8;
    std::size_t price = 0;
    for (const Vertex_index v : vertices) {
      const std::size_t degree = m_state.arrays().degree(v);
      price +=
          Cost_model_2::removal + Cost_model_2::flip * (degree - (std::min)(degree, usual_degree));
    }
    return price;
  }

  Context& m_context;
  const State& m_state;
  Flip_tool_2<State>& m_flips;
  Index_set<Vertex_index> m_region; // classified vertices, then their padding, then the border
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_UPDATE_REINSERTION_TOOL_2_H

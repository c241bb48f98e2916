// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_UPDATE_FLIP_TOOL_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_UPDATE_FLIP_TOOL_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Flat_arrays.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/mending/Lawson_flips_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/proof/Edge_test_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/topology/Topology_parts_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/update/Cost_model_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/update/Update_context_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/policies/Update_report_2.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

// Flips edges until none that is open can be flipped.
template <class State>
class Flip_tool_2
{
  using Context = Update_context_2<State>;

public:
  explicit Flip_tool_2(Context& context)
    : m_context(context)
    , m_state(context.state)
  {
  }

  // Flips from all open edges.
  void flip()
  {
    m_context.proof.open_illegal();
    if (m_context.is_done())
      return;
    std::vector<Edge_index>& edges = m_context.proof.uncertain();
    // a heuristic classifier treats examined edges as triangulated anew
    if (!m_context.is_exact)
      m_context.editor.note_examined(edges);
    run(edges, m_context.proof.do_faces_tile_hull());
    if (m_context.budget.is_spent())
      m_context.rebuild(Rebuild_reason_2::BUDGET_SPENT);
  }

  // Flips from a list of edges, and leaves in it those that were not proved.
  void run(std::vector<Edge_index>& edges, bool do_faces_tile_hull)
  {
    note(m_lawson.run(m_state, m_context.editor, edges, do_faces_tile_hull, most_flips()));
  }

  // Flips at most so often, from these edges, though faces may be inverted. Returns whether that
  // has proved them all.
  bool try_to_prove(std::vector<Edge_index>& edges, std::size_t most)
  {
    note(m_lawson.run(m_state, m_context.editor, edges, false, most));
    return edges.empty();
  }

  // Flips edges at infinity until the hull is convex. No face is inverted. `changed` are edges
  // whose test has changed since the classification. Returns whether the faces tile the hull.
  bool mend_hull(const std::vector<Edge_index>& changed)
  {
    if constexpr (!State::has_hull)
      return true;
    m_edges.clear();
    for (const std::vector<Edge_index>* edges :
         {&std::as_const(m_context.proof).uncertain(), &changed})
      append_at_infinity(*edges, m_edges);
    if (!m_edges.empty())
      run(m_edges, false);
    return m_edges.empty() && m_context.proof.hull_turns_once(m_state);
  }

  // Flips from edges around a vertex that was moved, where the faces tile the hull, and opens those
  // that it cannot prove.
  void flip_nearby(const std::vector<Edge_index>& edges)
  {
    m_edges.clear();
    note(m_lawson.run_nearby(m_state, m_context.editor, edges, m_edges, most_flips()));
    m_context.proof.open(m_edges);
  }

  // Calls work(part, flip) for all parts, as Lawson_flips_2::run_beside() says; some `moves`
  // vertices move there. Then flips the edges between parts, and opens those that it cannot prove.
  template <class Work>
  void flip_beside(const Topology_parts_2& topology, std::size_t moves, const Work& work)
  {
    constexpr std::size_t of_a_move = 100;
    m_edges.clear();
    note(m_lawson.run_beside(m_state, m_context.editor, topology,
                             (std::min)(most_flips(), of_a_move * moves), work, m_edges));
    run(m_edges, true);
    m_context.proof.open(m_edges);
  }

  // Flips around a vertex that was put into a face, and opens the edges that it cannot prove.
  void legalize_around(Vertex_index v)
  {
    const std::size_t flips =
        m_lawson.run_around(m_state, m_context.editor, v, m_edges, most_flips());
    m_context.report().flips += flips;
    spend_on_legalizing(flips);
    m_context.proof.open(m_edges);
  }

  // The price of putting a vertex in includes the first flips.
  void spend_on_legalizing(std::size_t flips)
  {
    constexpr std::size_t few = 8;
    m_context.budget.spend(flips > few ? (flips - few) * Cost_model_2::flip : 0);
  }

  // Threads share the edges: reading them from here and there takes a few nanoseconds each.
  void append_at_infinity(const std::vector<Edge_index>& edges,
                          std::vector<Edge_index>& at_infinity) const
  {
    using Parts = typename State::Parts;
    constexpr std::size_t least = Parts::size_for(8), ahead = 16;
    append_by_parts<Parts>(edges.size(), least, at_infinity,
                           [&](std::size_t i, std::size_t beyond, std::vector<Edge_index>& some) {
                             for (; i < beyond; ++i) {
                               if (i + ahead < edges.size())
                                 m_state.arrays().prefetch_edge(edges[i + ahead]);
                               if (m_state.is_at_infinity(edges[i]))
                                 some.push_back(edges[i]);
                             }
                           });
  }

  std::size_t most_flips() const { return m_context.budget.left() / Cost_model_2::flip + 1; }

  // THE GAP BESIDE A SLAB -----------------------------------------------------------------------

  // The edges which a flip would exchange across the gap for another one there, and make Delaunay.
  std::vector<Edge_index> illegal_edges_across_gap() const
  {
    std::vector<Edge_index> edges;
    for (Edge_index e(0); e < m_state.arrays().number_of_edges(); ++e)
      if (is_illegal_across_gap(e))
        edges.push_back(e);
    return edges;
  }

  // Lawson's flips, from these edges on, of edges across the gap alone. If all faces in the gap are
  // counterclockwise, as they are where all other edges are right, the gap then is Delaunay.
  void flip_across_gap(std::vector<Edge_index>& edges)
  {
    while (!edges.empty()) {
      const Edge_index e = edges.back();
      edges.pop_back();
      const Halfedge_index h = m_state.arrays().halfedge(e);
      if (!is_illegal_across_gap(e) || !m_context.editor.can_flip(h))
        continue;
      m_context.editor.flip(h);
      m_state.arrays().for_each_side(e, [&](Edge_index side) { edges.push_back(side); });
    }
  }

private:
  bool is_illegal_across_gap(Edge_index e) const
  {
    return m_state.flips_across_gap(e) &&
           typename State::Edge_test(m_state).state(e) == Edge_state_2::ILLEGAL;
  }

  void note(std::size_t flips)
  {
    m_context.report().flips += flips;
    m_context.budget.spend(flips * Cost_model_2::flip);
  }

  Context& m_context;
  const State& m_state;
  Lawson_flips_2 m_lawson;
  std::vector<Edge_index> m_edges;
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_UPDATE_FLIP_TOOL_2_H

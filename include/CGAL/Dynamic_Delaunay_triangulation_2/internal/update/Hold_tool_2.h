// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_UPDATE_HOLD_TOOL_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_UPDATE_HOLD_TOOL_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Flat_arrays.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/update/Cost_model_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/update/Flip_tool_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/update/Update_context_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/policies/Update_report_2.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

// Holds vertices so that no face is inverted, and releases them when all is Delaunay again.
template <class State>
class Hold_tool_2
{
  using Context = Update_context_2<State>;
  using At_hull = typename Held_vertices_2<State>::At_hull;

public:
  Hold_tool_2(Context& context, Flip_tool_2<State>& flips)
    : m_context(context)
    , m_flips(flips)
  {
  }

  // Whether the only vertex that has moved has to be taken out.
  bool has_jumped_alone(Vertex_index v) const { return m_context.held.goes_far(v); }

  void hold()
  {
    Update_proof_2& proof = m_context.proof;
    if (!m_context.can_hold() || proof.empty())
      return;
    if (proof.task().jumper != null_index)
      return take_out_jumper();
    const std::size_t first_flip = m_context.state.changes().new_edges.size();
    if (flips_suffice())
      return;
    m_context.editor.undo_flips(first_flip);
    if (try_to_hold(At_hull::PEEL) || m_context.has_rebuilt())
      return;
    m_context.held.let_go();
    m_context.editor.undo_flips(first_flip);
    if (!try_to_hold(At_hull::HOLD) && !m_context.has_rebuilt())
      m_context.rebuild(Rebuild_reason_2::STUCK);
  }

  void release()
  {
    if (m_context.held.empty())
      return;
    if (!m_context.proof.empty())
      return m_context.rebuild(Rebuild_reason_2::STUCK);
    constexpr unsigned max_rounds = 12;
    for (unsigned round = 0; round < max_rounds && release_once(); ++round)
      if (!m_context.proof.empty())
        break;
    const bool are_faces_right = m_context.proof.empty();
    if (are_faces_right && take_out_held())
      return;
    if (m_context.budget.is_spent())
      m_context.rebuild(Rebuild_reason_2::BUDGET_SPENT);
    else if (!are_faces_right || !m_context.can_spare(1))
      m_context.rebuild(Rebuild_reason_2::STUCK);
  }

private:
  // Moves each held vertex on, if it can: by parts, if they are many, then the others. Returns
  // whether enough have moved to go on.
  bool release_once()
  {
    auto& held = m_context.held;
    const auto in_parts = [&](const Topology_parts_2& topology) {
      m_flips.flip_beside(topology, held.size(), [&](std::size_t part, const auto& flip) {
        held.release_in_part(topology, part, flip);
      });
    };
    return held.release(
        in_parts, [this](const std::vector<Edge_index>& edges) { m_flips.flip_nearby(edges); });
  }

  // Where few faces are inverted, flips nearly always right them all, and nothing need be held: at
  // steps of 0.01 spacings, and where the border of a crystal bends. Returns whether they have.
  // Otherwise the uncertain edges are as before, but what was flipped has to be undone. Tries some
  // edges first, then twice as many: at random points, flips fail at one of 20 edges, and always
  // before 100, but a border may bend at thousands.
  bool flips_suffice()
  {
    Update_proof_2& proof = m_context.proof;
    const std::vector<Edge_index>& edges = proof.uncertain();
    if (edges.size() > 8 + m_context.state.arrays().number_of_edges() / 256)
      return false;
    for (std::size_t tried = 0; tried < edges.size();) {
      tried = (std::min)((std::max)(2 * tried, std::size_t(32)), edges.size());
      m_uncertain = edges;
      m_uncertain.resize(tried);
      if (!m_flips.try_to_prove(m_uncertain, 20 + 4 * tried))
        return false;
    }
    if (!proof.hull_turns_once(m_context.state))
      return false;
    proof.uncertain().clear();
    proof.set_faces_tile_hull(true);
    return true;
  }

  // Holds vertices, and makes the hull convex. False if the hull turns more than once even so: if
  // vertices of the hull have gone far into it, it may fold though all faces are counterclockwise.
  bool try_to_hold(At_hull at_hull)
  {
    Update_proof_2& proof = m_context.proof;
    auto& held = m_context.held;
    const std::size_t most = m_context.most_to_hold();
    const bool are_faces_right = held.hold(proof.uncertain(), most, at_hull);
    m_context.budget.spend(held.size() * Cost_model_2::held_vertex);
    if (!are_faces_right) {
      if (held.size() > most)
        m_context.rebuild(Rebuild_reason_2::TOO_MUCH_BROKEN);
      return false;
    }
    m_changed.clear();
    held.append_unproved(m_changed);
    if (!m_flips.mend_hull(m_changed))
      return false;
    proof.set_faces_tile_hull(true);
    proof.open(m_changed);
    return true;
  }

  // Takes out the only vertex that has moved. Where it rests everything is Delaunay.
  void take_out_jumper()
  {
    m_context.proof.clear();
    m_context.held.hold_at_rest(m_context.proof.task().jumper);
    if (!take_out_held())
      m_context.rebuild(Rebuild_reason_2::STUCK);
  }

  // Takes out the vertices that are still held, from a Delaunay triangulation. They are put in at
  // their targets later. Where one cannot be taken out, because too few others would stay, or at a
  // side of a slab if its faces meet images of themselves, it goes to its target, and what that
  // breaks is opened. Returns whether nothing is open.
  bool take_out_held()
  {
    Update_proof_2& proof = m_context.proof;
    m_context.held.list(m_left);
    m_context.budget.spend(m_left.size() * Cost_model_2::removal);
    if (m_context.can_spare(m_left.size()))
      m_context.relocation.take_out_of_delaunay(m_left);
    std::size_t left = 0;
    for (const Vertex_index v : m_left)
      if (!proof.empty() || !m_context.can_spare(1) || !take_out_of_hull(v))
        m_left[left++] = v;
    m_left.resize(left);
    m_context.held.let_go();
    for (const Vertex_index v : m_left)
      proof.open_around(m_context.state, v);
    if (!proof.empty())
      proof.set_faces_tile_hull(false);
    return proof.empty();
  }

  // Takes out a vertex on the hull, or of high degree, and flips around. Whether the hull turns
  // around once then is left to the end of the update: walking around a long hull costs more.
  bool take_out_of_hull(Vertex_index v)
  {
    const State& state = m_context.state;
    const std::size_t first_new = state.changes().new_edges.size();
    if (!m_context.relocation.take_out(v, state.positions()[v]))
      return false;
    m_context.proof.open_new_edges(state, first_new);
    m_flips.run(m_context.proof.uncertain(), false);
    return true;
  }

  Context& m_context;
  Flip_tool_2<State>& m_flips;
  std::vector<Edge_index> m_uncertain; // edges from which flips were tried
  std::vector<Edge_index> m_changed;   // edges whose test was changed
  std::vector<Vertex_index> m_left;    // vertices that could not be taken out
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_UPDATE_HOLD_TOOL_2_H

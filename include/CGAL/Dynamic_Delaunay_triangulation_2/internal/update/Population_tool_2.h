// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_UPDATE_POPULATION_TOOL_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_UPDATE_POPULATION_TOOL_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/assertions.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Flat_arrays.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/update/Cost_model_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/update/Flip_tool_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/update/Update_context_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/policies/Update_report_2.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

// Removes points, and puts in new points and whatever else is outside of faces.
template <class State>
class Population_tool_2
{
  using Context = Update_context_2<State>;

public:
  Population_tool_2(Context& context, Flip_tool_2<State>& flips)
    : m_context(context)
    , m_state(context.state)
    , m_flips(flips)
  {
  }

  // Removes the points with these ids. False if some of them are left, which is so only on a torus:
  // see Vertex_relocation_2::take_out(). Then a rebuild has to leave them out.
  bool remove(const std::vector<Point_id>& ids)
  {
    if (ids.empty())
      return true;
    auto& relocation = m_context.relocation;
    Update_proof_2& proof = m_context.proof;
    const bool are_delaunay = proof.is_rest_known() && !m_state.have_points_moved();
    const std::vector<Vertex_index> moved = relocation.remove(ids, are_delaunay);
    if (!moved.empty())
      proof.forget_hull();
    const std::size_t first_new = m_state.changes().new_edges.size();
    const bool are_gone = relocation.remove_rest();
    if (relocation.has_rest())
      proof.open_new_edges(m_state, first_new);
    for (const Vertex_index v : moved)
      proof.open_around(m_state, v);
    proof.close_proved(m_state);
    return are_gone;
  }

  // Removes points with these ids before a frame moves the others, so that it stays known where
  // these rest. Everything has to be Delaunay. Leaves the points that share a vertex to remove().
  // False if some of the others are left, as in remove().
  bool remove_before_motion(const std::vector<Point_id>& ids)
  {
    auto& relocation = m_context.relocation;
    Update_proof_2& proof = m_context.proof;
    const std::size_t first_new = m_state.changes().new_edges.size();
    std::vector<Point_id> alone;
    std::copy_if(ids.begin(), ids.end(), std::back_inserter(alone),
                 [this](Point_id id) { return m_state.ids().is_alone(id); });
    relocation.remove(alone, true);
    if (relocation.has_rest()) {
      const std::size_t first_unproved = m_state.changes().new_edges.size();
      if (!relocation.remove_rest())
        return false;
      Update_proof_2 around;
      around.open_new_edges(m_state, first_unproved);
      m_flips.run(around.uncertain(), false);
      if (!around.empty() || !proof.hull_turns_once(m_state))
        proof.forget_rest();
    }
    proof.open_new_edges(m_state, first_new);
    return true;
  }

  // Puts in vertices outside of faces, new points and those that have parted, with flips around
  // each.
  void put_in(const std::vector<Point_id>& parted)
  {
    Update_proof_2& proof = m_context.proof;
    Repair_budget_2& budget = m_context.budget;
    CGAL_precondition(!proof.is_required() || proof.empty());
    bool is_delaunay = proof.is_required(); // the end of the update tests that the hull turns once
    proof.set_faces_tile_hull(false);
    budget.allow((parted.size() + m_context.relocation.number_to_put_in()) *
                 Cost_model_2::relocation);
    const auto most_faces = [&] { return is_delaunay ? m_flips.most_flips() + 1 : 0; };
    const auto end = [&](Vertex_index v, std::size_t steps, std::size_t faces) {
      budget.spend(Cost_model_2::insertion + Cost_model_2::step_of_a_walk * steps);
      if (faces > 0)
        m_flips.spend_on_legalizing(faces - 1); // so many flips would do the same
      else {
        m_flips.legalize_around(v);
        is_delaunay = is_delaunay && proof.empty();
      }
      return !budget.is_spent() && (proof.empty() || State::can_locate_anywhere);
    };
    const auto counts = m_context.relocation.put_in(parted, most_faces, end);
    budget.spend(counts.in_parts * Cost_model_2::insertion);
    m_context.report().relocated += counts.relocated;
    m_context.report().merged += counts.merged;
    m_context.report().parted += counts.parted;
    if (budget.is_spent())
      m_context.rebuild(Rebuild_reason_2::BUDGET_SPENT);
    else if (!State::can_locate_anywhere && !proof.empty())
      m_context.rebuild(Rebuild_reason_2::STUCK);
  }

private:
  Context& m_context;
  const State& m_state;
  Flip_tool_2<State>& m_flips;
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_UPDATE_POPULATION_TOOL_2_H

// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_UPDATE_UPDATE_CONTEXT_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_UPDATE_UPDATE_CONTEXT_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Flat_arrays.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/mending/Held_vertices_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/mending/Vertex_relocation_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/topology/Topology_editor_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/update/Cost_model_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/update/Update_proof_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/policies/Update_report_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/views/Dynamic_classification_2.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

// What one update knows, and what its tools share: the triangulation, vertices that are not where
// they belong, the proof, the budget and the report. A rebuild ends the work of all tools.
template <class State>
class Update_context_2
{
  using Point = typename State::Point;

public:
  using Editor = Topology_editor_2<State>;
  using Classification = Dynamic_classification_2<State>;

  explicit Update_context_2(State& s)
    : state(s)
    , editor(s)
    , builder(s)
    , held(s, editor)
    , relocation(s, editor)
  {
  }

  Update_context_2(const Update_context_2&) = delete;
  Update_context_2& operator=(const Update_context_2&) = delete;

  const State& state;
  Editor editor;
  typename State::Builder builder;
  Held_vertices_2<State> held;
  Vertex_relocation_2<State> relocation; // vertices outside of all faces, and points to insert
  Update_proof_2 proof;
  Repair_budget_2 budget;
  Classification classification;
  std::vector<Vertex_index> padded, border; // vertices
  bool is_exact = true;                     // whether the classifier is exact

  Update_report_2& report() { return *m_report; }
  bool has_rebuilt() const { return m_report->rebuilt(); }
  // Whether no work is left for the tools.
  bool is_done() const { return proof.empty() || has_rebuilt(); }
  // The number of edges that were open after the classification. Counts all steps; if a rebuild
  // has ended the update before the last one, those that were left like the others.
  std::size_t number_of_classified_edges() const
  {
    return m_classified_edges * m_steps / (m_steps - m_steps_left + 1);
  }

  // AN UPDATE, IN STEPS -------------------------------------------------------------------------

  void start(Update_report_2& report, bool is_classifier_exact)
  {
    m_report = &report;
    is_exact = is_classifier_exact;
    m_classified_edges = 0;
    m_steps = m_steps_left = 1;
    proof.start({});
    forget_sets();
    budget.start_generously(price_of_rebuild());
  }

  // Takes the frame in so many steps: goes to the end of the first one, from where vertices rest.
  void begin_steps(unsigned steps)
  {
    m_steps = m_steps_left = steps;
    stop();
  }
  unsigned steps_left() const { return m_steps_left; }

  // Goes on to the end of the next step. Everything must be Delaunay where the vertices stand.
  void begin_next_step()
  {
    editor.go_on();
    --m_steps_left;
    stop();
  }

  // Opens what was classified, and all edges that see the jumper, if there is one.
  void open(const Update_task_2& task)
  {
    m_report->classified = classification.size();
    proof.start(task);
    proof.take(classification, state);
    m_classified_edges += proof.size();
    m_price_of_mending = price(Cost_model_2::mending);
    if (task.jumper != null_index)
      proof.open_around(state, task.jumper);
  }

  // Before a rebuild or after an exception: puts all vertices at their positions and into faces,
  // and cancels the insertions that are left. Throws nothing.
  void give_up()
  {
    held.let_go();
    editor.arrive();
    relocation.give_up();
  }

  // Gives the numbers of removed vertices to other vertices.
  void finish()
  {
    if (relocation.finish())
      forget_sets();
  }

  // Exchanges the whole triangulation with `other`. Throws nothing after the builder's
  // reserve_for_exchange().
  void exchange(State& other)
  {
    builder.exchange(other);
    classification = Classification();
    padded.clear();
    border.clear();
  }

  // Triangulates anew without the points `gone`, and with these and all other points that come.
  void rebuild(Rebuild_reason_2 reason, const std::vector<Point_id>& gone = {},
               std::vector<Point_id> coming = {}, std::vector<Point> points = {})
  {
    relocation.for_each_coming([&](Point_id id, const Point& p) {
      coming.push_back(id);
      points.push_back(p);
    });
    give_up();
    proof.clear();
    forget_sets();
    if (gone.empty() && coming.empty()) // nothing throws after these
      builder.rebuild();
    else
      builder.build_with(gone, std::move(coming), std::move(points));
    m_report->rebuild_reason = state.spans_plane() ? reason : Rebuild_reason_2::DIMENSION;
  }

  // PRICES --------------------------------------------------------------------------------------

  std::size_t price_of_rebuild() const { return Cost_model_2::rebuild(state.rebuilt_vertices()); }

  // Whether a rebuild is cheaper than mending what was classified, in this step and those that
  // follow, plus all insertions and removals. Where vertices can be held, their number will tell:
  // then only if it surely is.
  bool is_rebuild_cheaper() const
  {
    // where points did not move, only the faces around those that came or went are new
    const bool are_few_inverted = can_hold() || !state.have_points_moved();
    const std::size_t mending =
        are_few_inverted ? price(Cost_model_2::least_of_mending) : price(Cost_model_2::mending);
    return m_steps_left * mending + price_of_changes() > price_of_rebuild();
  }

  void limit_cost() { budget.start(price_of_rebuild(), m_price_of_mending, m_steps); }

  // Whether mending alone has cost as much as a rebuild.
  bool has_cost_a_rebuild() const { return budget.has_spent(price_of_rebuild()); }

  // If more vertices have to be held, a rebuild costs less. A few may always be.
  std::size_t most_to_hold() const
  {
    constexpr std::size_t few = 30;
    const std::size_t others =
        m_steps_left * Cost_model_2::illegal_edge * proof.illegal().size() + price_of_changes();
    const std::size_t rebuild = price_of_rebuild();
    return few +
           (rebuild - (std::min)(others, rebuild)) / (m_steps_left * Cost_model_2::mended_vertex);
  }

  // VERTICES ------------------------------------------------------------------------------------

  // Whether vertices can be held: it is known where they rest, with all faces counterclockwise.
  bool can_hold() const
  {
    return proof.is_required() && proof.is_rest_known() && state.have_points_moved() &&
           !has_rebuilt();
  }

  // Whether enough vertices remain in faces if so many more are taken out.
  bool can_spare(std::size_t vertices) const
  {
    return relocation.number_outside() + vertices + State::min_vertices <=
           state.number_of_vertices();
  }

private:
  // At the end of the last step the vertices stand at their targets. There is only one step where
  // points cannot be made from their coordinates.
  void stop()
  {
    if constexpr (State::Positions::can_place)
      if (m_steps_left > 1)
        editor.stop_at(1. / m_steps_left);
  }

  // The price of mending what is open.
  template <class Price>
  std::size_t price(const Price& price_of) const
  {
    return price_of(proof.illegal().size(), proof.uncertain().size());
  }
  std::size_t price_of_changes() const
  {
    return Cost_model_2::changes(proof.task().changes, state.number_of_vertices());
  }

  // Clears sets of vertices, whose numbers may have changed.
  void forget_sets()
  {
    padded.clear();
    border.clear();
    classification.clear(state);
  }

  Update_report_2* m_report = nullptr;
  unsigned m_steps = 1, m_steps_left = 1; // the present one included
  std::size_t m_classified_edges = 0, m_price_of_mending = 0;
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_UPDATE_UPDATE_CONTEXT_2_H

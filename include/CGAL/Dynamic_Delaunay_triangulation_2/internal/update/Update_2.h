// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_UPDATE_UPDATE_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_UPDATE_UPDATE_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/classifiers/Circumcircle_classifier_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Flat_arrays.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Points_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/proof/Certificate_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/proof/Edge_test_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/space/Input_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/update/Cost_model_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/update/Repair_tools_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/update/Update_choices_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/update/Update_context_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/update/Update_outlook_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/update/Update_proof_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/policies/Update_report_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/repairs/Hold_and_flip_repair_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/views/Dynamic_classification_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/views/Dynamic_frame_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/views/Dynamic_mender_2.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

// An update: everything that one call does to the triangulation of any space, whether all points
// move or a few, and whether points are inserted or removed. run_phases() shows its phases in their
// order. Only this class knows whether the triangulation is certified.
template <class State>
class Update_2
{
  using Point = typename State::Point;
  using Tools = Repair_tools_2<State>;
  using Mender = Dynamic_mender_2<Tools>;
  using Frame = Dynamic_frame_2<State>;
  using Change = Change_2<Point>;

public:
  using Choices = Update_choices_2<State>;

  explicit Update_2(State& state)
    : m_state(state)
    , m_tools(state)
    , m_context(m_tools.context)
  {
  }

  bool is_certified() const { return m_is_certified; }

  // Makes the empty triangulation a copy of `other`, and takes over what `update` knows.
  void copy(const State& other, const Update_2& update)
  {
    m_context.builder.copy(other);
    m_is_certified = update.m_is_certified;
    m_experience = update.m_experience;
    m_is_classifier_informed = update.m_is_classifier_informed;
  }

  // What a checkpoint keeps besides the state.
  const Repair_experience_2& memory() const { return m_experience; }

  // Exchanges everything for what was read from a checkpoint. The classifier was told of that
  // already. Throws nothing after the builder's reserve_for_exchange().
  void exchange(State& other, bool is_certified, const Repair_experience_2& memory)
  {
    m_context.exchange(other);
    m_is_certified = is_certified;
    m_experience = memory;
    m_is_classifier_informed = true;
  }

  Tools& tools() { return m_tools; }
  const Tools& tools() const { return m_tools; }

  // Runs an update. Moves the points to insert out of `change`, as there might be no memory for
  // copies. Takes a frame back if the policy or the classifier throws. At the end, tells the
  // classifier of what is new.
  template <class Input>
  Update_report_2 run(Change& change, Input& input, const Choices& choices);

  // To be called at the beginning of a call, before anything changes.
  void enter()
  {
    m_has_removed = false;
    m_context.editor.begin_changes(std::exchange(m_is_classifier_informed, false));
  }
  // Whether all points to remove in this call, or in the last one, were removed.
  bool has_removed() const { return m_has_removed; }

  // Whether the triangulation is Delaunay; changes only the certified flag, and edges across the
  // gap beside a slab, which are not listed.
  bool certify(const Choices& choices)
  {
    if (m_is_certified || !m_state.spans_plane() || is_any_parted())
      return m_is_certified;
    const Certificate_2<State> certificate(m_state);
    m_is_certified = certificate.holds() || (mend_gap(choices) && certificate.holds());
    return m_is_certified;
  }

private:
  // PHASES --------------------------------------------------------------------------------------

  template <class Input>
  Update_report_2 run_phases(Change& change, Input& input, const Choices& choices)
  {
    Update_report_2 report;
    const bool was_certified = std::exchange(m_is_certified, false);
    if (change.is_empty() && !(choices.is_exact() && m_state.spans_plane())) {
      m_is_certified = was_certified;
      return report;
    }
    Plan plan;
    bool is_accepted = false;
    try {
      report.inserted = change.coming.size();
      report.removed = change.gone.size();
      m_context.start(report, choices.is_exact());
      if (change.is_frame) {
        input.accept(); // throws nothing
        is_accepted = true;
      }
      m_context.editor.move(change.moved, change.moved_points, change.are_exact);
      plan = make_plan(change, choices, was_certified);
      if (plan.reason == Rebuild_reason_2::NONE)
        classify(change, choices, was_certified, plan);
    } catch (...) {
      if (is_accepted)
        input.take_back();
      m_is_certified = was_certified && change.moved.empty();
      throw;
    }
    if (plan.is_at_rest)
      m_context.editor.forget_previous();
    // before points are removed, because a rebuild just leaves them out (if a proof is required)
    if (plan.reason == Rebuild_reason_2::NONE && plan.steps == 1 && change.has_population() &&
        m_context.proof.is_required() && m_context.is_rebuild_cheaper()) {
      plan.reason = Rebuild_reason_2::TOO_MUCH_BROKEN;
      if (change.is_frame)
        learn(plan.reason);
    }
    if (plan.reason != Rebuild_reason_2::NONE) {
      rebuild(change, plan.reason);
      return report;
    }
    if (change.has_population()) {
      if (!remove(change.gone, change.is_frame, input)) {
        rebuild(change, Rebuild_reason_2::STUCK);
        return report;
      }
      m_context.relocation.announce(change.coming, change.coming_points);
    }
    m_has_removed = true;
    if (plan.steps > 1)
      mend_in_steps(plan.steps, change, choices);
    else
      mend(change, choices);
    if (report.removed > 0 || report.merged > 0) // vertices may have taken other points
      find_parted(change, was_certified);
    put_in(report);
    prove(change, report);
    return report;
  }

  // Removes points from a frame: where the others rest, if that is known, because there everything
  // is Delaunay. False if some of them are left.
  template <class Input>
  bool remove(const std::vector<Point_id>& ids, bool is_frame, Input& input)
  {
    if (!is_frame || !m_context.can_hold())
      return m_tools.population.remove(ids);
    input.take_back();
    bool are_gone = false;
    try {
      are_gone = m_tools.population.remove_before_motion(ids);
    } catch (...) {
      input.accept();
      throw;
    }
    input.accept();
    return are_gone && m_tools.population.remove(ids);
  }

  // POINTS THAT PART ----------------------------------------------------------------------------

  // Lists the covered points that have left their vertices. Where all was certified, and no frame
  // has come, these are among the points that moved alone.
  void find_parted(const Change& change, bool was_certified)
  {
    m_parted.clear();
    const auto& ids = m_state.ids();
    const auto add_if_parted = [&](Point_id id, Vertex_index v, const Point& p) {
      if (!m_state.is_at(p, v))
        m_parted.push_back(id);
    };
    if (change.is_frame || !was_certified)
      ids.for_each_covered(add_if_parted);
    else
      for (const Point_id id : change.moved)
        if (!ids.is_representative(id))
          add_if_parted(id, ids.vertex(id), ids.covered_point(id));
    make_distinct(m_parted);
  }

  bool is_any_parted() const
  {
    bool is_any = false;
    m_state.ids().for_each_covered(
        [&](Point_id, Vertex_index v, const Point& p) { is_any = is_any || !m_state.is_at(p, v); });
    return is_any;
  }

  // TO REBUILD OR NOT ---------------------------------------------------------------------------

  // Why to rebuild, or else in how many steps to take a frame.
  struct Plan
  {
    Rebuild_reason_2 reason = Rebuild_reason_2::NONE;
    unsigned steps = 1;
    bool is_at_rest = false; // only points come and go, so no edge is broken
  };

  // Decides before any work that a rebuild would discard.
  Plan make_plan(const Change& change, const Choices& choices, bool was_certified)
  {
    if (!m_state.spans_plane() || leaves_too_few(change))
      return {Rebuild_reason_2::DIMENSION};
    find_parted(change, was_certified);
    const std::size_t parted = m_parted.size();
    if (are_too_many(change.gone.size() + change.coming.size() + parted))
      return {parted > change.gone.size() + change.coming.size() ? Rebuild_reason_2::COINCIDENCE
                                                                 : Rebuild_reason_2::POPULATION};
    if (change.is_frame && choices.wants_rebuild(Frame(m_state)))
      return {Rebuild_reason_2::POLICY};
    if (change.is_frame && change.has_population() && choices.is_exact() && was_certified &&
        parted == 0 && m_state.is_frame_at_rest())
      return {Rebuild_reason_2::NONE, 1, true};
    return change.is_frame && choices.may_sample() ? plan_by_sample(change, was_certified) : Plan();
  }

  Plan plan_by_sample(const Change& change, bool was_certified)
  {
    const std::size_t rebuild = m_context.price_of_rebuild();
    const std::size_t changes = Cost_model_2::changes(change.gone.size() + change.coming.size(),
                                                      m_state.number_of_vertices());
    const Update_outlook_2<State> outlook(m_state, m_experience,
                                          rebuild - (std::min)(changes, rebuild));
    if (outlook.is_hopeless()) {
      m_experience.record_not_tried();
      return {Rebuild_reason_2::TOO_MUCH_BROKEN};
    }
    const bool can_stop = State::Positions::can_place && was_certified;
    return {Rebuild_reason_2::NONE, can_stop ? outlook.steps() : 1, false};
  }

  bool leaves_too_few(const Change& change) const
  {
    const auto& ids = m_state.ids();
    const auto representatives =
        std::size_t(std::count_if(change.gone.begin(), change.gone.end(),
                                  [&](Point_id id) { return ids.is_representative(id); }));
    return m_state.number_of_vertices() < State::min_vertices + representatives;
  }

  bool are_too_many(std::size_t changes) const
  {
    return changes > 0 && Cost_model_2::changes(changes, m_state.number_of_vertices()) >
                              m_context.price_of_rebuild() +
                                  Cost_model_2::rebuild(m_state.ids().number_of_covered());
  }

  void rebuild(Change& change, Rebuild_reason_2 reason)
  {
    const auto is_gone = [this](Point_id id) { return !m_state.ids().is_taken(id); };
    change.gone.erase(std::remove_if(change.gone.begin(), change.gone.end(), is_gone),
                      change.gone.end());
    m_context.rebuild(reason, change.gone, std::move(change.coming),
                      std::move(change.coming_points));
    m_has_removed = true;
    m_is_certified = true;
  }

  // CLASSIFICATION ------------------------------------------------------------------------------

  // The user's classifier is called for whole frames that are taken in one step. If it is exact, it
  // has nothing to name where points come and go and all others rest. Otherwise exact
  // predicates decide: at all edges if these are uncertified and a proof is required, else around
  // the moved points. Where points can be located only if all is Delaunay, a proof is always
  // required.
  void classify(const Change& change, const Choices& choices, bool was_certified, const Plan& plan)
  {
    Update_task_2 task;
    task.is_rest_known = was_certified;
    task.changes = change.gone.size() + change.coming.size();
    if (change.is_frame) {
      task.needs_proof = choices.is_exact();
      task.is_hull_as_before = plan.is_at_rest;
      if (!plan.is_at_rest && plan.steps == 1) // each step is classified on its own
        choices.classify(Frame(m_state), m_context.classification);
    } else if (change.is_mending ||
               ((choices.is_exact() || !State::can_locate_anywhere) && !was_certified)) {
      task.needs_proof = true;
      Circumcircle_classifier_2()(Frame(m_state), m_context.classification);
    } else {
      task.needs_proof = was_certified;
      task.is_hull_as_before = was_certified && !is_any_on_hull(change.moved);
      task.jumper = was_certified ? find_jumper(change.moved) : null_index;
      if (task.jumper == null_index)
        classify_around(change.moved);
      else
        m_context.classification.add_vertex(task.jumper);
    }
    m_context.open(task);
  }

  // Classifies the edges that see one of these points and are not Delaunay.
  void classify_around(const std::vector<Point_id>& ids)
  {
    const Frame frame(m_state);
    m_edges_around.clear();
    for (const Point_id id : ids)
      frame.for_each_edge_that_sees(frame.vertex(id),
                                    [&](Edge_index e) { m_edges_around.push_back(e); });
    if (ids.size() > 1)
      make_distinct(m_edges_around);
    m_context.classification.add_unless_delaunay(frame, m_edges_around);
  }

  // The vertex of the only point that has moved, if it has jumped: no edge need be examined then.
  Vertex_index find_jumper(const std::vector<Point_id>& ids) const
  {
    if (ids.size() != 1)
      return null_index;
    const Vertex_index v = m_state.ids().vertex(ids.front());
    return m_tools.holds.has_jumped_alone(v) ? v : null_index;
  }

  bool is_any_on_hull(const std::vector<Point_id>& ids) const
  {
    const auto is_on_hull = [&](Point_id id) {
      return State::has_hull &&
             m_state.arrays().are_neighbors(m_state.ids().vertex(id), infinite_index);
    };
    return std::any_of(ids.begin(), ids.end(), is_on_hull);
  }

  // MENDING -------------------------------------------------------------------------------------

  void mend(const Change& change, const Choices& choices)
  {
    Mender mender(m_tools);
    const bool is_nothing_open = m_context.proof.empty();
    if (!change.is_frame && is_nothing_open)
      m_context.limit_cost(); // the cost of putting vertices in
    else if (!change.is_frame)
      Hold_and_flip_repair_2()(mender);
    else if (!is_nothing_open || !m_context.classification.empty())
      choices.mend(mender);
    m_tools.holds.release(); // what a repair of the user's may have left held
  }

  // Takes a rough frame in equal steps. Each is mended like a frame of its own.
  void mend_in_steps(unsigned steps, const Change& change, const Choices& choices)
  {
    Update_task_2 task = m_context.proof.task();
    if (!m_context.can_hold()) { // a removal has left open where the others rest
      task.is_rest_known = false;
      steps = 1;
    }
    Circumcircle_classifier_2 classifier;
    for (m_context.begin_steps(steps);; m_context.begin_next_step()) {
      m_context.classification.clear(m_state);
      classifier(Frame(m_state), m_context.classification);
      m_context.open(task);
      mend(change, choices);
      if (m_context.has_rebuilt() || m_context.steps_left() == 1)
        return;
      if (!m_context.proof.is_complete(m_state))
        return m_context.rebuild(Rebuild_reason_2::STUCK);
    }
  }

  // Puts in vertices outside of faces, new points and those that have parted, and mends around
  // them. Before that mends everything, where points can be located only if all is Delaunay.
  void put_in(Update_report_2& report)
  {
    const auto& relocation = m_context.relocation;
    auto& proof = m_context.proof;
    const Hold_and_flip_repair_2 repair;
    Mender mender(m_tools);
    const bool are_any = relocation.number_to_put_in() > 0 || !m_parted.empty();
    if (!State::can_locate_anywhere && are_any && !report.rebuilt() && !proof.is_required()) {
      proof.require_of_all(m_state);
      repair.mend(mender);
    }
    const bool has_left_open = relocation.is_under_way() && !proof.empty();
    if (report.rebuilt() || (proof.is_required() && !proof.empty()) || !(are_any || has_left_open))
      return;
    m_tools.population.put_in(m_parted);
    if (!mender.is_done())
      repair.mend(mender);
  }

  // Rebuilds if a proof is required and was not completed.
  void prove(const Change& change, Update_report_2& report)
  {
    const bool has_to = m_context.proof.is_required();
    if (has_to && !report.rebuilt() && !m_context.proof.is_complete(m_state))
      m_context.rebuild(Rebuild_reason_2::STUCK);
    if (!report.rebuilt())
      m_context.finish();
    m_context.editor.end_changes();
    m_is_certified = has_to || report.rebuilt();
    if (change.is_frame)
      learn(report.rebuild_reason);
  }

  // Flips what can be flipped across the gap beside a slab. False if there is nothing to flip.
  bool mend_gap(const Choices& choices)
  {
    std::vector<Edge_index> edges;
    if (m_state.has_gap())
      edges = m_tools.flips.illegal_edges_across_gap();
    if (edges.empty())
      return false;
    m_context.editor.begin_changes(std::exchange(m_is_classifier_informed, false));
    m_tools.flips.flip_across_gap(edges);
    m_context.editor.end_changes();
    choices.inform(Frame(m_state));
    m_is_classifier_informed = true;
    return true;
  }

  void learn(Rebuild_reason_2 reason)
  {
    const std::size_t open = m_context.number_of_classified_edges(),
                      edges = m_state.arrays().number_of_edges();
    if (reason == Rebuild_reason_2::TOO_MUCH_BROKEN || reason == Rebuild_reason_2::BUDGET_SPENT ||
        m_context.has_cost_a_rebuild())
      m_experience.record_failure(open, edges);
    else if (reason == Rebuild_reason_2::NONE)
      m_experience.record_success(open, edges);
  }

  const State& m_state;
  Tools m_tools;
  Update_context_2<State>& m_context;     // that of the tools
  std::vector<Edge_index> m_edges_around; // points that moved alone
  std::vector<Point_id> m_parted;         // covered points that have left their vertices, ascending
  bool m_is_certified = true;
  bool m_has_removed = true;
  bool m_is_classifier_informed = false; // of what is new since an update began
  Repair_experience_2 m_experience;      // learned from whole frames
};

// Defined outside of the class, so that it is not inline: where it is declared extern, compilers
// leave out all that it calls, which is most of the package (`compiled_updates.h`).
template <class State>
template <class Input>
Update_report_2 Update_2<State>::run(Change& change, Input& input, const Choices& choices)
{
  Update_report_2 report;
  try {
    report = run_phases(change, input, choices);
  } catch (...) {
    m_context.give_up();
    throw;
  }
  m_context.relocation.give_up();
  choices.inform(Frame(m_state));
  m_is_classifier_informed = true;
  return report;
}

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_UPDATE_UPDATE_2_H

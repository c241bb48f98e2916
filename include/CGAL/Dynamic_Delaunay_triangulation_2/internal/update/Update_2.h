// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_UPDATE_UPDATE_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_UPDATE_UPDATE_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/classifiers/Circumcircle_classifier_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/classifiers/Dynamic_classification_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/core/Flat_arrays_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/core/Input_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/core/Points_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/proof/Certificate_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/proof/Edge_test_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/update/Cost_model_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/update/Repair_tools_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/update/Update_choices_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/policies/Update_report_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/queries/Dynamic_frame_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/repairs/Dynamic_mender_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/repairs/Hold_and_flip_repair_2.h>

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
  {
  }

  bool is_certified() const { return m_is_certified; }

  // Makes the empty triangulation a copy of `other`, and takes over what `update` knows.
  void copy(const State& other, const Update_2& update)
  {
    m_tools.builder().copy(other);
    m_is_certified = update.m_is_certified;
    m_experience = update.m_experience;
    m_is_classifier_informed = update.m_is_classifier_informed;
  }

  // What a checkpoint keeps besides the state.
  const Repair_experience_2& memory() const { return m_experience; }

  // Exchanges everything for what was read from a checkpoint. The classifier was told of that
  // already. Throws nothing after reserve_for_exchange() of the tools.
  void exchange(State& other, bool is_certified, const Repair_experience_2& memory)
  {
    m_tools.exchange(other);
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
    m_tools.editor().begin_changes(std::exchange(m_is_classifier_informed, false));
  }
  // Whether all points to remove in this call, or in the last one, were removed.
  bool has_removed() const { return m_has_removed; }

  // Whether the triangulation is Delaunay; changes only the certified flag, and edges across the
  // gap beside a slab, which are not listed.
  bool certify(const Choices& choices)
  {
    if (m_is_certified || !m_state.spans_plane() || !parted_duplicates().empty())
      return m_is_certified;
    const Certificate_2<State> certificate(m_state);
    m_is_certified = certificate.holds();
    if constexpr (State::is_periodic)
      m_is_certified = m_is_certified || (mend_gap(choices) && certificate.holds());
    return m_is_certified;
  }

  // The duplicates that have left their vertices.
  std::vector<Index> parted_duplicates() const
  {
    std::vector<Index> parted;
    const auto& ids = m_state.ids();
    for (const auto& duplicate : ids.duplicates())
      if (!m_state.is_at(duplicate.point, ids.vertex(duplicate.id)))
        parted.push_back(duplicate.id);
    return parted;
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
    Rebuild_reason_2 reason;
    bool is_accepted = false;
    try {
      report.inserted = change.coming.size();
      report.removed = change.gone.size();
      m_tools.start(report, choices.is_exact());
      if (change.is_frame) {
        input.accept(); // throws nothing
        is_accepted = true;
      }
      m_tools.editor().move(change.moved, change.moved_points, change.are_exact);
      reason = reason_to_rebuild(change, choices);
      if (reason == Rebuild_reason_2::NONE)
        classify(change, choices, was_certified);
    } catch (...) {
      if (is_accepted)
        input.take_back();
      m_is_certified = was_certified && change.moved.empty();
      throw;
    }
    // before points are removed, because a rebuild just leaves them out (if a proof is required)
    if (reason == Rebuild_reason_2::NONE && change.has_population() && m_tools.has_to_prove() &&
        m_tools.is_rebuild_cheaper()) {
      reason = Rebuild_reason_2::TOO_MUCH_BROKEN;
      if (change.is_frame)
        learn(reason);
    }
    if (reason != Rebuild_reason_2::NONE) {
      rebuild(change, reason, report);
      return report;
    }
    if (change.has_population()) {
      if (!remove(change.gone, change.is_frame, input)) {
        rebuild(change, Rebuild_reason_2::STUCK, report);
        return report;
      }
      m_tools.relocation().announce(change.coming, change.coming_points);
    }
    m_has_removed = true;
    mend(change, choices);
    prove_before_points_come(report);
    put_in(report);
    prove(change, report);
    return report;
  }

  // Removes points from a frame: where the others rest, if that is known, because there everything
  // is Delaunay. False if some of them are left.
  template <class Input>
  bool remove(const std::vector<Index>& ids, bool is_frame, Input& input)
  {
    if (!is_frame || !m_tools.can_hold())
      return m_tools.remove(ids);
    input.take_back();
    bool are_gone = false;
    try {
      are_gone = m_tools.remove_before_motion(ids);
    } catch (...) {
      input.accept();
      throw;
    }
    input.accept();
    return are_gone && m_tools.remove(ids);
  }

  // TO REBUILD OR NOT ---------------------------------------------------------------------------

  // Returns why to rebuild, or `NONE`. Decides before any work that a rebuild would discard.
  Rebuild_reason_2 reason_to_rebuild(const Change& change, const Choices& choices)
  {
    if (!m_state.spans_plane() || leaves_too_few(change))
      return Rebuild_reason_2::DIMENSION;
    const std::size_t parted = parted_duplicates().size();
    if (are_too_many(change.gone.size() + change.coming.size() + parted))
      return parted > change.gone.size() + change.coming.size() ? Rebuild_reason_2::COINCIDENCE
                                                                : Rebuild_reason_2::POPULATION;
    if (change.is_frame && choices.wants_rebuild(Frame(m_state)))
      return Rebuild_reason_2::POLICY;
    if (change.is_frame && choices.may_sample() && is_sample_hopeless()) {
      m_experience.record_not_tried();
      return Rebuild_reason_2::TOO_MUCH_BROKEN;
    }
    return Rebuild_reason_2::NONE;
  }

  bool leaves_too_few(const Change& change) const
  {
    const auto& ids = m_state.ids();
    const auto representatives =
        std::size_t(std::count_if(change.gone.begin(), change.gone.end(),
                                  [&](Point_id id) { return ids.is_representative(id); }));
    return m_state.number_of_vertices() < State::min_vertices + representatives;
  }

  // Each change takes, besides, a search through all duplicates.
  bool are_too_many(std::size_t changes) const
  {
    constexpr std::size_t compared_at_the_price_of_a_change = 512;
    const std::size_t duplicates = m_state.ids().duplicates().size();
    const std::size_t searches = changes * duplicates / compared_at_the_price_of_a_change;
    return changes > 0 && (changes + searches) * Cost_model_2::insertion >
                              m_tools.price_of_rebuild() + Cost_model_2::rebuild(duplicates);
  }

  // Samples edges, to avoid a useless classification: many edges if mending was in vain lately, or
  // if half of the very few edges that are sampled in every frame are broken.
  bool is_sample_hopeless() const
  {
    constexpr std::size_t very_few = 8, least = 128, most = 1024;
    const Frame frame(m_state);
    const std::size_t edges = frame.number_of_edges();
    const auto is_half_broken = [](const Sample& few) { return 2 * few.broken >= few.size; };
    const auto is_not_delaunay = [&](Edge_index e) { return !frame.is_delaunay(e); };
    const auto is_unproved = [&](Edge_index e) {
      return !frame.is_at_infinity(e) && !frame.proves_delaunay(e);
    };
    // the filter alone first, because every frame pays for it
    if (!m_experience.has_failed_recently() &&
        !(is_half_broken(sample(frame, very_few, is_unproved)) &&
          is_half_broken(sample(frame, very_few, is_not_delaunay))))
      return false;
    const std::size_t size = (std::min)((std::max)(edges / 16, least), most);
    const Sample many = sample(frame, size, is_not_delaunay);
    // Two of five broken edges are uncertain where mending costs as much as a rebuild. A quarter
    // more than necessary, because a sample may be wrong.
    const std::size_t broken = edges * many.broken / many.size * 4 / 5;
    return m_experience.is_hopeless(many.size, many.broken) ||
           Cost_model_2::mending(broken * 3 / 5, broken * 2 / 5) > m_tools.price_of_rebuild();
  }

  struct Sample
  {
    std::size_t size, broken;
  };

  // Samples about `size` edges, or all.
  template <class Is_broken>
  static Sample sample(const Frame& frame, std::size_t size, const Is_broken& is_broken)
  {
    const std::size_t edges = frame.number_of_edges();
    const std::size_t stride = 1 + edges / size;
    Sample taken{0, 0};
    for (std::size_t e = 0; e < edges; e += stride, ++taken.size)
      taken.broken += is_broken(Index(e));
    return taken;
  }

  void rebuild(Change& change, Rebuild_reason_2 reason, Update_report_2& report)
  {
    const bool spanned_plane = m_state.spans_plane();
    if (change.gone.empty() && change.coming.empty()) {
      m_tools.rebuild(reason);
    } else {
      m_tools.relocation().give_up(); // drops the slots of points that were removed already
      const auto is_gone = [this](Point_id id) { return !m_state.ids().is_taken(id); };
      change.gone.erase(std::remove_if(change.gone.begin(), change.gone.end(), is_gone),
                        change.gone.end());
      m_tools.builder().build_with(change.gone, std::move(change.coming),
                                   std::move(change.coming_points));
      report.rebuild_reason =
          spanned_plane && m_state.spans_plane() ? reason : Rebuild_reason_2::DIMENSION;
    }
    m_has_removed = true;
    m_is_certified = true;
  }

  // CLASSIFICATION ------------------------------------------------------------------------------

  // The user's classifier is called for whole frames only. Otherwise exact predicates decide: at
  // all edges if these are uncertified and a proof is required, otherwise around the moved points.
  // Where points can be located only if all is Delaunay, a proof is always required.
  void classify(const Change& change, const Choices& choices, bool was_certified)
  {
    typename Tools::Task task;
    task.was_certified = was_certified;
    task.changes = change.gone.size() + change.coming.size();
    task.movers = m_state.number_of_vertices();
    if (change.is_frame) {
      task.has_to_prove = choices.is_exact();
      choices.classify(Frame(m_state), m_tools.classification());
    } else if (change.is_mending ||
               ((choices.is_exact() || !State::can_locate_anywhere) && !was_certified)) {
      task.has_to_prove = true;
      Circumcircle_classifier_2()(Frame(m_state), m_tools.classification());
    } else {
      task.has_to_prove = was_certified;
      task.movers = change.moved.size();
      task.hull_stays = was_certified && !is_any_on_hull(change.moved);
      task.jumper = was_certified ? find_jumper(change.moved) : Vertex_index(null_index);
      if (task.jumper == null_index)
        classify_around(change.moved);
      else
        m_tools.classification().add_vertex(task.jumper);
    }
    m_tools.open(task);
  }

  // Classifies the edges that see one of these points and are not Delaunay.
  void classify_around(const std::vector<Index>& ids)
  {
    const Frame frame(m_state);
    m_edges_around.clear();
    for (const Point_id id : ids)
      frame.for_each_edge_that_sees(frame.vertex(id),
                                    [&](Edge_index e) { m_edges_around.push_back(e); });
    if (ids.size() > 1)
      make_distinct(m_edges_around);
    m_tools.classification().add_unless_delaunay(frame, m_edges_around);
  }

  // The vertex of the only point that has moved, if it has jumped: no edge need be examined then.
  Vertex_index find_jumper(const std::vector<Index>& ids) const
  {
    if (ids.size() != 1)
      return null_index;
    const Vertex_index v = m_state.ids().vertex(ids.front());
    return m_tools.has_jumped_alone(v) ? v : Vertex_index(null_index);
  }

  bool is_any_on_hull(const std::vector<Index>& ids) const
  {
    const auto is_on_hull = [&](Point_id id) {
      bool sees_infinity = false;
      m_state.arrays().for_each_neighbor(
          m_state.ids().vertex(id), [&](Vertex_index w) { sees_infinity |= w == infinite_index; });
      return sees_infinity;
    };
    return std::any_of(ids.begin(), ids.end(), is_on_hull);
  }

  // MENDING -------------------------------------------------------------------------------------

  void mend(const Change& change, const Choices& choices)
  {
    Mender mender(m_tools);
    const bool is_nothing_open = m_tools.open_edges().empty();
    if (!change.is_frame && is_nothing_open)
      m_tools.limit_cost(); // the cost of putting vertices in
    else if (!change.is_frame)
      Hold_and_flip_repair_2()(mender);
    else if (!is_nothing_open || !m_tools.classification().empty())
      choices.mend(mender);
    m_tools.release(); // what a repair of the user's may have left held
  }

  // Mends everything before points are put in, where they can be located only if all is Delaunay.
  void prove_before_points_come(const Update_report_2& report)
  {
    if (State::can_locate_anywhere || report.rebuilt() || m_tools.has_to_prove() ||
        (m_tools.relocation().number_to_put_in() == 0 && parted_duplicates().empty()))
      return;
    m_tools.examine_everything();
    Mender mender(m_tools);
    Hold_and_flip_repair_2().mend(mender);
  }

  // Puts in vertices outside of faces, new points and parted duplicates, and mends around them.
  void put_in(Update_report_2& report)
  {
    if (report.rebuilt() || (m_tools.has_to_prove() && !m_tools.open_edges().empty()))
      return;
    const std::vector<Index> parted = parted_duplicates();
    const bool has_left_open = m_tools.relocation().is_under_way() && !m_tools.open_edges().empty();
    if (!parted.empty() || m_tools.relocation().number_to_put_in() > 0 || has_left_open) {
      m_tools.put_in(parted);
      Mender mender(m_tools);
      if (!mender.is_done())
        Hold_and_flip_repair_2().mend(mender);
    }
  }

  // Rebuilds if a proof is required and was not completed.
  void prove(const Change& change, Update_report_2& report)
  {
    const bool has_to = m_tools.has_to_prove();
    if (has_to && !report.rebuilt() && !m_tools.is_proved())
      m_tools.rebuild(Rebuild_reason_2::STUCK);
    if (!report.rebuilt())
      m_tools.finish();
    m_tools.editor().end_changes();
    m_is_certified = has_to || report.rebuilt();
    if (change.is_frame)
      learn(report.rebuild_reason);
  }

  // Flips what can be flipped across the gap beside a slab. False if there is nothing to flip.
  bool mend_gap(const Choices& choices)
  {
    std::vector<Index> edges;
    if (m_state.torus().cell().is_slab())
      edges = m_tools.illegal_edges_across_gap();
    if (edges.empty())
      return false;
    m_tools.editor().begin_changes(std::exchange(m_is_classifier_informed, false));
    m_tools.flip_across_gap(edges);
    m_tools.editor().end_changes();
    choices.inform(Frame(m_state));
    m_is_classifier_informed = true;
    return true;
  }

  void learn(Rebuild_reason_2 reason)
  {
    const std::size_t open = m_tools.number_of_classified_edges(),
                      edges = m_tools.number_of_edges();
    if (reason == Rebuild_reason_2::TOO_MUCH_BROKEN || reason == Rebuild_reason_2::BUDGET_SPENT ||
        m_tools.has_cost_a_rebuild())
      m_experience.record_failure(open, edges);
    else if (reason == Rebuild_reason_2::NONE)
      m_experience.record_success(open, edges);
  }

  const State& m_state;
  Tools m_tools;
  std::vector<Index> m_edges_around; // points that moved alone
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
    m_tools.give_up();
    throw;
  }
  m_tools.relocation().give_up();
  choices.inform(Frame(m_state));
  m_is_classifier_informed = true;
  return report;
}

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_UPDATE_UPDATE_2_H

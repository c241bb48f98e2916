// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_PERIODIC_PERIODIC_UPDATE_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_PERIODIC_PERIODIC_UPDATE_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/classifiers/inform_classifier.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/core/Flat_arrays_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/core/Input_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/periodic/Periodic_editor_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/periodic/Periodic_input_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/periodic/Periodic_memory_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/periodic/Periodic_motion_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/periodic/Periodic_repair_tools_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/periodic/Periodic_triangulation_state_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/periodic/Torus_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/proof/Certificate_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/proof/Periodic_slacks_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/proof/Validity_check_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/topology/Halfedge_arrays_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/policies/Update_report_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/queries/Dynamic_frame_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/repairs/Dynamic_mender_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/repairs/Flip_and_splice_repair_2.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Dynamic_Delaunay_triangulations_2 {
namespace internal {

// Keeps a periodic triangulation Delaunay: builds it, and repairs it after points have moved, come
// or gone. update() shows the phases of a frame in their order. Only this class knows whether the
// triangulation is certified.
template <class State, class Editor>
class Periodic_update_2
{
  using Tools = Periodic_repair_tools_2<State, Editor>;
  using Mender = Dynamic_mender_2<Tools>;
  using Change = Change_2<typename State::Point>;
  using Input = Periodic_input_2<State>;

public:
  using Frame = Dynamic_frame_2<State>;

  explicit Periodic_update_2(State& state)
    : m_state(state)
    , m_editor(state)
    , m_motion(state, m_editor)
    , m_tools(state, m_editor)
  {
  }

  // Makes the triangulation a copy of `other`, and takes over what `update` knows.
  void copy(const State& other, const Periodic_update_2& update)
  {
    m_editor.copy(other);
    set_memory(update.memory());
    m_is_certified = update.m_is_certified;
    m_is_whole = update.m_is_whole;
  }

  const Tools& tools() const { return m_tools; }
  const Static_engines_2& engines() const { return m_tools.engines(); }
  void set_engines(const Static_engines_2& engines) { m_tools.set_engines(engines); }

  bool is_certified() const { return m_is_certified && m_is_whole; }
  // False after an exception has ended a call in the middle.
  bool is_whole() const { return m_is_whole; }

  // What has changed since this was last called, if a log is kept. Valid until the next call.
  const std::vector<Periodic_change_2>& take_log()
  {
    m_taken_log.clear();
    m_taken_log.swap(m_editor.log());
    return m_taken_log;
  }

  // CALLS ---------------------------------------------------------------------------------------

  // To be called at the beginning of a call, before anything changes. Throws if a position of a
  // frame cannot be used. Stages the frame, unless points are removed first: those that stay have
  // been checked then, by `Dynamic_population_2`.
  void enter(const Change& change, const Input& input)
  {
    m_has_removed = m_is_staged = false;
    if (!change.is_frame)
      return;
    input.with_frame([&](const auto& next) {
      m_is_staged = change.gone.empty() && m_motion.stage(next, input.cell());
      if (!m_is_staged && change.gone.empty())
        input.check_frame(next);
    });
  }

  // Whether all points to remove in this call, or in the last one, were removed.
  bool has_removed() const { return m_has_removed; }

  // At the end the classifier is told of what is new.
  template <class Classifier, class Repair, class Policy>
  Update_report_2 run(const Change& change, const Input& input, Classifier& classifier,
                      Repair& repair, Policy& policy)
  {
    const std::vector<Position_2> coming = input.positions(change.coming_points);
    const std::vector<Position_2> moved = input.positions(change.moved_points);
    Update_report_2 report;
    m_tools.start(report, true);
    if (!std::exchange(m_is_whole, false)) {
      m_tools.rebuild(Rebuild_reason_2::STUCK);
      m_is_certified = true;
    }
    if (change.is_mending)
      certify_all(report);
    for (std::size_t i = 0; i < moved.size(); ++i)
      move(change.moved[i], moved[i], report);
    for (const Index id : change.gone)
      remove(id, report);
    m_has_removed = change.is_frame; // not if this call mends before a frame
    if (change.is_frame)
      input.with_frame([&](const auto& next) {
        if (!m_is_staged)
          m_motion.stage(next, input.cell());
        update(next, input.cell(), classifier, repair, policy, report);
      });
    if (!coming.empty())
      insert(change.coming, coming, report);
    m_is_whole = true;
    m_editor.end_changes();
    inform_classifier(classifier, Frame(m_state));
    m_editor.begin_changes();
    return report;
  }

  // Whether the triangulation is Delaunay; changes only the certified flag.
  bool certify()
  {
    if (m_is_whole && !m_is_certified)
      m_is_certified = Certificate_2<State>(m_state).holds();
    return is_certified();
  }

  // CHECKPOINTS ---------------------------------------------------------------------------------

  Periodic_memory_2 memory() const { return {m_tools.hint(), m_motion.mean_way()}; }

  void reserve_for_exchange(const State& other)
  {
    m_editor.reserve_for_log(std::size_t(m_state.arrays().number_of_edges()) +
                             other.arrays().number_of_edges());
  }

  // Exchanges everything for what was read, of which the classifier was told. Throws nothing after
  // reserve_for_exchange().
  void exchange(State& state, bool is_certified, const Periodic_memory_2& memory)
  {
    m_editor.note_all_edges(Periodic_change_2::Kind::EDGE_REMOVED);
    m_editor.swap(state);
    m_editor.note_all_edges(Periodic_change_2::Kind::EDGE_CREATED);
    Update_report_2 report;
    m_tools.start(report, true);
    set_memory(memory);
    m_is_certified = is_certified;
    m_is_whole = true;
    m_editor.begin_changes();
  }

  // CERTIFICATE ---------------------------------------------------------------------------------

  // Tests everything again, exactly.
  bool is_valid(bool verbose) const
  {
    return Validity_check_2<State>(m_state, verbose).passes(0, m_is_certified);
  }

private:
  // POPULATION ----------------------------------------------------------------------------------

  // Inserts points with the next ids.
  void insert(const std::vector<Index>& next_ids, const std::vector<Position_2>& points,
              Update_report_2& report)
  {
    certify_all(report);
    m_editor.ids().reserve(next_ids);
    m_tools.place_all(next_ids, points);
    report.inserted += points.size();
  }

  void remove(Index id, Update_report_2& report)
  {
    certify_all(report);
    ++report.removed;
    m_tools.make_duplicate_if_shared(id);
    if (!ids().is_representative(id))
      return m_editor.ids().remove_duplicate(id);
    const Index v = ids().vertex(id);
    const bool is_out = m_state.number_of_vertices() > 1 && m_tools.take_out_of_delaunay(v);
    if (!is_out)
      return m_tools.rebuild(Rebuild_reason_2::STUCK, id);
    m_editor.ids().reserve_for_removals(1);
    m_editor.ids().remove_representative(id);
    m_tools.drop_taken_out();
  }

  // Moves one point.
  void move(Index id, const Position_2& p, Update_report_2& report)
  {
    certify_all(report);
    m_tools.make_duplicate_if_shared(id);
    const Index v = ids().vertex(id);
    if (!ids().is_representative(id)) {
      if (m_tools.coincide(p, m_state.positions()[v]))
        m_editor.ids().duplicate(id).point = p;
      else
        m_tools.place(id, p);
      return;
    }
    const Position_2 before = m_state.positions()[v];
    const Periodic_shift_2 shift = m_tools.shift_of_step(before, p);
    m_editor.set_position(v, p);
    m_editor.shift_images(v, shift);
    if (m_tools.are_faces_counterclockwise(v)) {
      m_tools.open_surroundings(v);
      return m_tools.legalize();
    }
    m_editor.set_position(v, before);
    m_editor.shift_images(v, no_shift - shift);
    const bool is_out = m_tools.take_out_of_delaunay(v);
    m_editor.set_position(v, p);
    if (!is_out)
      return m_tools.rebuild(Rebuild_reason_2::STUCK);
    m_tools.put_back_all();
  }

  // MOTION --------------------------------------------------------------------------------------

  // Moves all points to the positions that were staged, and are given again, in the same cell.
  template <class Next, class Classifier, class Repair, class Policy>
  void update(const Next& next, const Periodic_cell_2& cell, Classifier& classifier, Repair& repair,
              Policy& policy, Update_report_2& report)
  {
    m_tools.start(report, Classifier::is_exact);
    // a rebuild before the frame, as where a point was removed, leaves the frame still to be mended
    const Rebuild_reason_2 reason_before =
        std::exchange(report.rebuild_reason, Rebuild_reason_2::NONE);
    const bool was_certified = m_is_certified;
    const Periodic_cell_2 cell_before = m_state.torus().cell();
    m_is_certified = m_is_certified && Classifier::is_exact;
    // at their old places, because the faces there are proved
    const std::vector<Index> jumpers =
        m_is_certified ? m_motion.find_jumpers() : std::vector<Index>();
    const bool are_many = jumpers.size() > m_tools.max_taken_out();
    if (!are_many)
      for (const Index v : jumpers)
        m_tools.take_out_of_delaunay(v); // if not, the repair sees to its faces
    m_motion.move_vertices(cell);
    Rebuild_reason_2 reason;
    try {
      reason = reason_to_rebuild(policy, are_many);
      if (reason == Rebuild_reason_2::NONE)
        classify(classifier);
    } catch (...) {
      m_motion.move_vertices_back(cell_before);
      m_tools.put_back_all();
      m_is_certified = was_certified;
      m_is_whole = true;
      throw;
    }
    const std::vector<Index> parted = move_duplicates(next);
    if (reason != Rebuild_reason_2::NONE)
      m_tools.rebuild(reason);
    else
      mend(repair);
    prove(report);
    if (!report.rebuilt())
      report.rebuild_reason = reason_before;
    for (const Index id : parted)
      if (!ids().is_representative(id))
        move(id, next(id), report);
    report.parted += parted.size();
  }

  // Makes it Delaunay if it is not.
  void certify_all(Update_report_2& report)
  {
    if (m_is_certified)
      return;
    m_tools.start(report, true);
    mend_everything();
    prove(report);
  }

  const typename State::Ids& ids() const { return m_state.ids(); }

  void set_memory(const Periodic_memory_2& memory)
  {
    m_tools.set_hint(memory.hint);
    m_motion.set_mean_way(memory.mean_way);
  }

  // Returns the duplicates that are no longer where their vertices are.
  template <class Next>
  std::vector<Index> move_duplicates(const Next& next)
  {
    std::vector<Index> parted;
    for (auto& duplicate : m_editor.ids().duplicates()) {
      duplicate.point = next(duplicate.id);
      if (!m_tools.coincide(duplicate.point, m_state.positions()[ids().vertex(duplicate.id)]))
        parted.push_back(duplicate.id);
    }
    return parted;
  }

  template <class Policy>
  Rebuild_reason_2 reason_to_rebuild(Policy& policy, bool are_many) const
  {
    if (m_state.number_of_vertices() > 0 && policy.wants_rebuild(Frame(m_state)))
      return Rebuild_reason_2::POLICY;
    return are_many && m_tools.is_much_broken() ? Rebuild_reason_2::TOO_MUCH_BROKEN
                                                : Rebuild_reason_2::NONE;
  }

  // No classifier is asked where there are no edges.
  template <class Classifier>
  void classify(Classifier& classifier)
  {
    if (m_state.number_of_vertices() == 0)
      return;
    classifier(Frame(m_state), m_tools.classification());
    m_tools.take_classification();
  }

  template <class Repair>
  void mend(Repair& repair)
  {
    Mender mender(m_tools);
    if (!m_tools.classification().empty() || m_tools.number_of_open_edges() > 0)
      repair(mender);
  }

  void mend_everything()
  {
    m_tools.examine_everything();
    Mender mender(m_tools);
    Flip_and_splice_repair_2()(mender);
  }

  // Completes the proof if there has to be one.
  void prove(const Update_report_2& report)
  {
    m_is_certified = m_tools.has_to_prove() || report.rebuilt();
    if (!m_is_certified || report.rebuilt())
      return;
    if (m_tools.number_of_open_edges() > 0)
      return m_tools.rebuild(Rebuild_reason_2::STUCK);
    m_tools.put_back_all();
  }

  State& m_state;
  Editor m_editor;
  Periodic_motion_2<State, Editor> m_motion;
  Tools m_tools;
  std::vector<Periodic_change_2> m_taken_log;
  bool m_is_certified = true;
  bool m_is_whole = true;
  bool m_is_staged = false;
  bool m_has_removed = true;
};

} // namespace internal
} // namespace Dynamic_Delaunay_triangulations_2
} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_PERIODIC_PERIODIC_UPDATE_2_H

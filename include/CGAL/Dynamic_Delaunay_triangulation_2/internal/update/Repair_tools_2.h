// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_UPDATE_REPAIR_TOOLS_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_UPDATE_REPAIR_TOOLS_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/assertions.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/classifiers/Dynamic_classification_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/core/Flat_arrays_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/core/Points_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/proof/Certificate_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/topology/Topology_editor_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/update/Border_splice_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/update/Jumper_search_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/update/Lawson_flips_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/update/Open_edges_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/update/Repair_costs_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/update/Vertex_relocation_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/policies/Static_engine_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/policies/Update_report_2.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

// The tools that mend an update, in every space, and the state of the update: the open edges,
// the vertices outside of all faces, the remaining budget and the report. `Dynamic_mender_2` offers
// the tools to a repair; `Update_2` uses the rest itself. If mending costs more than it is worth, a
// rebuild ends it.
template <class State>
class Repair_tools_2
{
  using Editor = Topology_editor_2<State>;
  using Certificate = Certificate_2<State>;
  using Point = typename State::Point;
  using Relocation = Vertex_relocation_2<State>;
  using Builder = typename State::Builder;

public:
  using Classification = Dynamic_classification_2<State>;

  explicit Repair_tools_2(State& state)
    : m_state(state)
    , m_editor(state)
    , m_builder(state)
    , m_relocation(state, m_editor)
    , m_jumpers(state)
    , m_splice(state)
  {
  }

  const Static_engines_2& engines() const { return m_engines; }
  void set_engines(const Static_engines_2& engines)
  {
    m_engines = engines;
    m_builder.set_engine(engines.whole);
    if constexpr (State::can_splice)
      m_splice.set_engine(engines.region);
  }

  // AN UPDATE -----------------------------------------------------------------------------------

  // `is_exact`: whether the classifier is exact. An exact one need not be told of edges that were
  // examined and not changed.
  void start(Update_report_2& report, bool is_exact)
  {
    m_report = &report;
    m_is_exact = is_exact;
    forget();
    m_budget.start_generously(rebuilt_vertices());
    m_may_take_out = true;
  }

  Editor& editor() { return m_editor; }
  Classification& classification() { return m_classification; }
  Relocation& relocation() { return m_relocation; }
  Builder& builder() { return m_builder; }

  // What is known when the repair begins, besides the classification.
  struct Task
  {
    bool has_to_prove = false;
    bool was_certified = false;
    std::size_t changes = 0; // the number of points inserted and removed
    std::size_t movers = 0;  // at most so many points have moved
    bool hull_stays = false; // the hull turned around once, and none of its vertices has moved
    // The only vertex that has moved, if it is to be taken out, if everything was certified before
    // it moved, and if no edge was examined.
    Vertex_index jumper = null_index;
  };

  // Opens what was classified, and all edges that see the jumper, if there is one.
  void open(const Task& task)
  {
    CGAL_precondition(task.jumper == null_index || task.movers == 1);
    m_task = task;
    m_report->classified = m_classification.size();
    m_open.take(m_classification, m_state);
    if (State::jumpers_leave_before_motion)
      m_open.drop_empty(m_state);
    // without splices each edge whose flip gets stuck costs putting a vertex in anew
    if (!State::can_splice && m_open.are_many_uncertain())
      m_open.open_all_in_order();
    m_classified_edges = m_open.size();
    if (task.jumper != null_index)
      open_edges_that_see(task.jumper);
  }

  // Whether this vertex has to be taken out, if it is the only one that has moved.
  bool has_jumped_alone(Vertex_index v) const { return m_jumpers.has_jumped_alone(v); }

  // Removes the points with these ids. False if some of them are left, which is so only on a torus:
  // see Vertex_relocation_2::take_out(). Then a rebuild has to leave them out.
  bool remove(const std::vector<Index>& ids)
  {
    if (ids.empty())
      return true;
    const bool are_delaunay = m_task.was_certified && m_task.movers == 0;
    const std::vector<Index> moved = m_relocation.remove(ids, are_delaunay);
    m_task.hull_stays = m_task.hull_stays && moved.empty();
    const std::size_t first_new = m_state.changes().new_edges.size();
    const bool are_gone = m_relocation.remove_rest();
    if (m_relocation.has_rest())
      m_open.open_new_edges(m_state, first_new);
    for (const Vertex_index v : moved)
      open_edges_that_see(v);
    return are_gone;
  }

  // The largest number of vertices to take out and put in again where no region can be spliced, a
  // sixth of a small torus: more are as much work as triangulating anew.
  std::size_t max_taken_out() const { return 10 + rebuilt_vertices() / 18; }

  // Takes out vertices that are about to jump, while everything is Delaunay, so that their motion
  // breaks nothing. Leaves them to the repair if they are many, or if their faces meet images of
  // themselves.
  void take_out_before_motion(const std::vector<Index>& jumpers)
  {
    if (jumpers.size() > max_taken_out())
      return;
    for (const Vertex_index v : jumpers)
      if (can_spare(1))
        m_relocation.take_out_of_delaunay(v);
  }
  // Puts the vertices that take_out_before_motion() took out into faces, after a frame was refused.
  void put_back()
  {
    if (m_relocation.number_waiting() == 0)
      return;
    m_open.clear();
    m_task.has_to_prove = true;
    put_in({});
  }

  // Opens all edges that may not be Delaunay. After that the update can end with a proof, whatever
  // the classifier has picked.
  void examine_everything()
  {
    m_task.has_to_prove = true;
    m_open.take_unproved(m_state);
  }

  // Puts in vertices outside of faces, new points and parted duplicates, with flips around each.
  void put_in(const std::vector<Index>& parted_duplicates)
  {
    CGAL_precondition(!m_task.has_to_prove || m_open.empty());
    bool is_delaunay = m_task.has_to_prove; // is_proved() tests that the hull turns around once
    m_open.set_planar(false);
    m_may_take_out = false;
    m_budget.allow((parted_duplicates.size() + m_relocation.number_to_put_in()) *
                   Repair_budget_2::relocation);
    std::size_t steps_before = 0;
    const auto most_faces = [&] { return is_delaunay ? most_flips() + 1 : 0; };
    const auto end = [&](Vertex_index v, std::size_t steps, std::size_t faces) {
      m_budget.spend(Repair_budget_2::relocation / 2 +
                     Repair_budget_2::step_of_a_walk * (steps - steps_before));
      steps_before = steps;
      if (faces > 0)
        spend_on_flips(faces - 1); // so many flips would do the same
      else {
        settle(v);
        // in the plane false from here on: the hull may turn around twice
        is_delaunay = is_delaunay && !State::has_hull && m_open.empty();
      }
      return !m_budget.is_spent() && (m_open.empty() || State::can_locate_anywhere);
    };
    const auto counts = m_relocation.put_in(parted_duplicates, most_faces, end);
    m_report->relocated += counts.relocated;
    m_report->merged += counts.merged;
    m_report->parted += counts.parted;
    if (m_budget.is_spent())
      rebuild(Rebuild_reason_2::BUDGET_SPENT);
    else if (!State::can_locate_anywhere && !m_open.empty())
      rebuild(Rebuild_reason_2::STUCK);
  }

  // Whether nothing is left to prove. No vertex waits outside of all faces then: Update_2 puts all
  // waiting vertices in unless edges are open, and rebuilds if the budget does not last.
  bool is_proved() const
  {
    CGAL_precondition(!m_open.empty() || m_relocation.number_waiting() == 0);
    return m_open.empty() && (m_open.faces_tile_hull() || hull_turns_once());
  }

  // Gives the numbers of removed vertices to other vertices.
  void finish()
  {
    if (m_relocation.finish())
      forget_sets();
  }

  void reserve_for_exchange(const State& other) { m_builder.reserve_for_exchange(other); }

  // Exchanges the whole triangulation with `other`. Throws nothing after reserve_for_exchange().
  void exchange(State& other)
  {
    m_builder.exchange(other);
    m_classification = Classification();
    m_padded.clear();
    m_border.clear();
  }

  // STATE -----------------------------------------------------------------------------------------

  const Classification& classification() const { return m_classification; }
  const Open_edges_2& open_edges() const { return m_open; }
  std::size_t number_of_open_edges() const { return m_open.size(); }
  bool has_inverted_edges() const { return !m_open.uncertain().empty(); }
  bool has_to_prove() const { return m_task.has_to_prove; }
  bool has_rebuilt() const { return m_report->rebuilt(); }
  std::size_t number_of_edges() const { return m_state.arrays().number_of_edges(); }
  std::size_t number_of_classified_edges() const { return m_classified_edges; }
  const std::vector<Index>& padded() const { return m_padded; }
  const std::vector<Index>& border() const { return m_border; }

  // Whether a rebuild is cheaper than mending what was classified plus all insertions and removals.
  bool is_rebuild_cheaper() const
  {
    return Repair_budget_2::is_rebuild_cheaper(rebuilt_vertices(), m_classified_edges,
                                               m_task.changes);
  }

  // Whether mending alone has cost as much as a rebuild.
  bool has_cost_a_rebuild() const { return m_budget.has_spent_a_rebuild(rebuilt_vertices()); }

  // TOOLS, as Dynamic_mender_2 documents them ----------------------------------------------------

  void limit_cost() { m_budget.start(rebuilt_vertices(), m_open.size()); }

  void take_out_jumpers()
  {
    if (m_task.jumper != null_index)
      return take_out_jumper();
    if (State::jumpers_leave_before_motion)
      return;
    // where several neighbors jumped, some are not found until the others are out
    constexpr unsigned max_rounds = 4;
    const auto may_others_jump = [this] { return m_relocation.number_waiting() < m_task.movers; };
    for (unsigned round = 0; round < max_rounds && can_take_out() && may_others_jump(); ++round) {
      const std::vector<Index>& edges = round == 0 ? m_open.uncertain() : m_open.opened_last();
      if (edges.empty())
        return;
      m_budget.spend(edges.size() * Repair_budget_2::look_for_jumpers);
      const std::vector<Index>& jumpers = m_jumpers.find_jumpers(edges);
      // a jumper counts as a point removed and a point inserted, plus half of that for the search
      if (Repair_budget_2::is_rebuild_cheaper(rebuilt_vertices(), 0,
                                              m_task.changes + 3 * jumpers.size()))
        return rebuild(Rebuild_reason_2::TOO_MUCH_BROKEN);
      if (!take_out(jumpers))
        return;
    }
  }

  // Returns whether any vertex is out.
  bool take_out_farthest()
  {
    return can_take_out() && take_out(m_jumpers.find_farthest(m_open.uncertain()));
  }

  void flip()
  {
    if (!m_open.faces_tile_hull())
      flip_inverted();
    m_open.open_illegal();
    flip_uncertain();
  }

  void flip_inverted()
  {
    if (has_rebuilt() || m_open.empty())
      return;
    flip_uncertain();
    // where no splice follows, it costs less to take one vertex out for each edge that is left
    if (State::can_splice && !m_open.uncertain().empty() && !has_rebuilt()) {
      m_open.open_surroundings(m_state);
      flip_uncertain();
    }
    m_open.set_planar(!has_rebuilt() && m_task.has_to_prove && m_open.uncertain().empty() &&
                      hull_turns_once());
  }

  void splice_classified(unsigned padding)
  {
    m_open.open_illegal();
    constexpr std::size_t any = std::size_t(-2);
    if constexpr (!State::can_splice)
      flip_around_classified(padding);
    else if (splice(m_classification.vertices(), padding, any, m_task.has_to_prove)) {
      for (std::size_t i = 0; i < m_splice.number_of_padded(); ++i)
        m_padded.push_back(m_splice.padded(i));
      m_border.assign(m_splice.border().begin(), m_splice.border().end());
    }
  }

  void splice_open(unsigned padding)
  {
    m_open.open_illegal();
    splice_inverted(padding);
  }

  void splice_inverted(unsigned padding)
  {
    std::vector<Index> vertices;
    m_open.for_each_uncertain_vertex(m_state, [&](Vertex_index v) { vertices.push_back(v); });
    constexpr std::size_t max_enlargements = 3; // then padding or taking a vertex out does better
    if constexpr (!State::can_splice) {
      if (padding > 0 || !put_in_farthest_anew())
        put_in_anew(vertices, padding);
    } else
      splice(vertices, padding, max_enlargements, true);
  }

  void relocate()
  {
    if constexpr (!State::can_splice)
      put_in_anew(m_classification.vertices(), 0);
    else
      relocate_one_by_one();
  }

  void rebuild(Rebuild_reason_2 reason)
  {
    if (m_relocation.is_under_way())
      rebuild_with_relocation();
    else
      m_builder.rebuild();
    m_report->rebuild_reason = m_state.spans_plane() ? reason : Rebuild_reason_2::DIMENSION;
    forget();
  }

  // Whether a flip would exchange this edge across the gap beside a slab for another one there, and
  // make it Delaunay.
  bool is_illegal_across_gap(Edge_index e) const
  {
    return m_state.flips_across_gap(e) &&
           typename State::Edge_test(m_state).state(e) == Edge_state_2::ILLEGAL;
  }
  std::vector<Index> illegal_edges_across_gap() const
  {
    std::vector<Index> edges;
    for (Edge_index e = 0; e < number_of_edges(); ++e)
      if (is_illegal_across_gap(e))
        edges.push_back(e);
    return edges;
  }
  // Lawson's flips, from these edges on, of edges across the gap alone. If all faces in the gap are
  // counterclockwise, as they are where all other edges are right, the gap then is Delaunay.
  void flip_across_gap(std::vector<Index>& edges)
  {
    while (!edges.empty()) {
      const Edge_index e = edges.back();
      edges.pop_back();
      const Halfedge_index h = m_state.arrays().halfedge(e);
      if (!is_illegal_across_gap(e) || !m_editor.can_flip(h))
        continue;
      m_editor.flip(h);
      m_state.arrays().for_each_side(e, [&](Edge_index side) { edges.push_back(side); });
    }
  }

private:
  void relocate_one_by_one()
  {
    if (m_relocation.is_under_way())
      return rebuild(Rebuild_reason_2::POPULATION);
    if (!m_task.was_certified || !m_state.have_points_moved())
      return rebuild(Rebuild_reason_2::STUCK);
    const bool all_arrived = m_builder.relocate_all(m_report->relocated);
    m_open.clear();
    if (!all_arrived)
      rebuild(Rebuild_reason_2::COINCIDENCE);
    else if (!m_state.spans_plane()) // without edges, nothing but a rebuild can help
      rebuild(Rebuild_reason_2::DIMENSION);
    else if (!Certificate(m_state).holds())
      rebuild(Rebuild_reason_2::STUCK);
  }

  // Condition 4 of the certificate. A hull that has turned around once still does so if its
  // vertices are the same and have not moved. They are the same if no face at infinity is new. Each
  // new face has an edge in the log: a flip logs the diagonal, which is in both faces; putting in a
  // vertex logs all edges of its faces; taking one out logs the edges between the faces that are
  // left, and all edges of the last one. So no face at infinity is new if no edge in the log is at
  // one. Splices clear `hull_stays`. Walking around a long hull costs more than all the rest.
  bool hull_turns_once() const
  {
    const Change_log_2& changes = m_state.changes();
    const auto is_at_hull = [this](Edge_index e) { return m_state.is_at_infinity(e); };
    return (m_task.hull_stays && !changes.everything_is_new &&
            std::none_of(changes.new_edges.begin(), changes.new_edges.end(), is_at_hull)) ||
           Dynamic_frame_2<State>(m_state).hull_turns_once();
  }

  void open_edges_that_see(Vertex_index v)
  {
    Dynamic_frame_2<State>(m_state).for_each_edge_that_sees(
        v, [this](Edge_index e) { m_open.uncertain().push_back(e); });
  }

  void forget()
  {
    m_open.clear();
    forget_sets();
  }

  // Clears sets of vertices, whose numbers may have changed.
  void forget_sets()
  {
    m_padded.clear();
    m_border.clear();
    m_classification.clear(m_state);
  }

  std::size_t rebuilt_vertices() const
  {
    return State::rebuilt_vertices(m_state.number_of_vertices());
  }

  // VERTICES THAT WENT FAR ----------------------------------------------------------------------

  // Takes out the only vertex that has moved, if possible so that all other edges stay Delaunay.
  void take_out_jumper()
  {
    if (can_spare(1) && m_relocation.take_out_of_delaunay(m_task.jumper)) {
      m_open.clear();
      m_budget.spend(Repair_budget_2::relocation / 2);
    } else if (can_take_out())
      take_out({m_task.jumper});
  }

  // Whether enough vertices remain in faces if so many more are taken out.
  bool can_spare(std::size_t vertices) const
  {
    return m_relocation.number_outside() + vertices + State::min_vertices <=
           m_state.number_of_vertices();
  }

  bool can_take_out() const
  {
    return m_may_take_out && m_task.has_to_prove && m_state.have_points_moved() && !has_rebuilt();
  }

  // Takes these vertices out if the budget allows it and enough remain. Skips those whose faces
  // meet images of themselves, like the lowest point of a slab. Returns whether any is out.
  bool take_out(const std::vector<Index>& vertices)
  {
    if (vertices.empty() || vertices.size() * Repair_budget_2::relocation > m_budget.left() ||
        !can_spare(vertices.size()))
      return false;
    const std::size_t price = price_of_taking_out(vertices);
    if (price > m_budget.left()) { // nothing else could mend so many edges either
      rebuild(Rebuild_reason_2::BUDGET_SPENT);
      return false;
    }
    const std::size_t first_new = m_state.changes().new_edges.size();
    constexpr std::size_t ahead = 4; // to prefetch; none of the vertices is outside of all faces
    bool is_any_out = false;
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      if (i + ahead < vertices.size())
        m_editor.prefetch_around(vertices[i + ahead]);
      is_any_out |= m_relocation.take_out(vertices[i]);
    }
    m_budget.spend(price);
    m_open.open_new_edges(m_state, first_new);
    return is_any_out;
  }

  // The price of a vertex includes a few flips. A vertex of high degree takes more flips.
  std::size_t price_of_taking_out(const std::vector<Index>& vertices) const
  {
    using Parts = typename State::Parts;
    constexpr std::size_t least = (std::max)(Parts::usual_size / 64, std::size_t(1));
    constexpr std::size_t usual_degree = 8;
    return Parts::sum(vertices.size(), least, [&](std::size_t first, std::size_t beyond) {
      std::size_t price = 0;
      for (std::size_t i = first; i < beyond; ++i) {
        const std::size_t degree = m_state.arrays().degree(vertices[i]);
        price += Repair_budget_2::relocation / 2 +
                 Repair_budget_2::flip * (degree - (std::min)(degree, usual_degree));
      }
      return price;
    });
  }

  // FLIPS ---------------------------------------------------------------------------------------

  void flip_uncertain()
  {
    if (has_rebuilt() || m_open.uncertain().empty())
      return;
    std::vector<Index>& edges = m_open.uncertain();
    // a heuristic classifier treats examined edges as triangulated anew
    if (!m_is_exact)
      m_editor.note_examined(edges);
    const std::size_t flips =
        m_lawson.run(m_state, m_editor, edges, m_open.faces_tile_hull(), most_flips());
    m_report->flips += flips;
    m_budget.spend(flips * Repair_budget_2::flip);
    if (m_budget.is_spent())
      rebuild(Rebuild_reason_2::BUDGET_SPENT);
  }

  // Flips around a vertex that was put in.
  void settle(Vertex_index v)
  {
    std::size_t flips = m_lawson.run_around(m_state, m_editor, v, m_around, most_flips());
    for (std::size_t more = flips; !State::can_locate_anywhere && more > 0 && !m_around.empty();) {
      more = m_lawson.run(m_state, m_editor, m_around, false, most_flips());
      flips += more;
    }
    m_report->flips += flips;
    spend_on_flips(flips);
    m_open.uncertain().insert(m_open.uncertain().end(), m_around.begin(), m_around.end());
  }

  std::size_t most_flips() const { return m_budget.left() / Repair_budget_2::flip + 1; }

  // The price of putting a vertex in includes the first flips.
  void spend_on_flips(std::size_t flips)
  {
    constexpr std::size_t few = 8;
    m_budget.spend(flips > few ? (flips - few) * Repair_budget_2::flip : 0);
  }

  // SPLICES -------------------------------------------------------------------------------------

  // Splices around these vertices. Tests the uncertain and the boundary edges if `has_to_look`,
  // otherwise closes all. False if everything is rebuilt, or if this has merged vertices instead.
  bool splice(const std::vector<Index>& vertices, unsigned padding, std::size_t max_enlargements,
              bool has_to_look)
  {
    if (has_rebuilt())
      return false;
    m_open.set_planar(false);
    m_task.hull_stays = false;
    const std::size_t most = m_budget.left() / Repair_budget_2::spliced_vertex;
    Splice_limits_2 limits{max_enlargements, most};
    const Splice_result_2 result = m_splice.run(m_editor, vertices, padding, limits);
    m_budget.spend((most - limits.max_vertices) * Repair_budget_2::spliced_vertex);
    m_report->enlargements += limits.enlargements;
    switch (result) {
    case Splice_result_2::TOO_LARGE:
      rebuild(limits.enlargements == 0 ? Rebuild_reason_2::TOO_MUCH_BROKEN
                                       : Rebuild_reason_2::STUCK);
      return false;
    case Splice_result_2::TOO_DEAR:
      rebuild(Rebuild_reason_2::BUDGET_SPENT);
      return false;
    case Splice_result_2::COINCIDENCE:
      merge();
      return false;
    default:
      break;
    }
    ++m_report->splices;
    m_report->padded += m_splice.number_of_padded();
    m_report->border += m_splice.number_of_border();
    m_report->spliced += m_splice.number_of_vertices();
    // the spliced faces are Delaunay among themselves, but their boundary edges may not be
    if (has_to_look)
      m_open.reopen(m_state, m_splice.boundary_edges());
    else
      m_open.uncertain().clear();
    return true;
  }

  // Merges vertices that have come to coincide. Other clusters may have been spliced before the
  // coincidence was found.
  void merge()
  {
    if (!m_task.has_to_prove)
      return rebuild(Rebuild_reason_2::COINCIDENCE);
    m_open.reopen(m_state, m_splice.boundary_edges());
    std::vector<Index> candidates = m_splice.region();
    m_open.for_each_uncertain_vertex(m_state, [&](Vertex_index v) { candidates.push_back(v); });
    make_distinct(candidates);
    const std::size_t first_new = m_state.changes().new_edges.size();
    const std::size_t merged =
        m_relocation.merge(candidates, m_budget.left() / Repair_budget_2::relocation);
    m_report->merged += merged;
    m_budget.spend(merged * Repair_budget_2::relocation);
    m_open.open_new_edges(m_state, first_new);
    m_open.reopen(m_state, {});
    if (merged == 0 || m_budget.is_spent())
      rebuild(Rebuild_reason_2::COINCIDENCE);
  }

  // WHERE NO REGION CAN BE TRIANGULATED APART ---------------------------------------------------

  // Flips edges around the classified vertices and their padding, and puts vertices in anew where
  // that leaves edges that may have inverted faces.
  void flip_around_classified(unsigned padding)
  {
    if (has_rebuilt())
      return;
    m_splice.run(m_classification.vertices(), padding);
    m_padded = m_splice.padded();
    m_border = m_splice.border();
    m_report->padded += m_padded.size();
    m_report->border += m_border.size();
    for (const Vertex_index v : m_splice.inner())
      open_edges_that_see(v);
    make_distinct(m_open.uncertain());
    flip();
    if (has_inverted_edges())
      splice_inverted(0);
    if (!m_task.has_to_prove)
      m_open.clear();
  }

  // Takes out each uncertain edge's vertex that moved farthest, then flips. True if any is out.
  bool put_in_farthest_anew()
  {
    const bool are_out = take_out_farthest();
    if (are_out)
      flip_inverted();
    return are_out;
  }

  // Takes the vertices of a region out, to be put in again after the repair, and flips around. Then
  // a proof is always required, because vertices can be located only where all is proved.
  void put_in_anew(const std::vector<Index>& vertices, unsigned padding)
  {
    if (has_rebuilt())
      return;
    m_splice.run(vertices, padding);
    const std::vector<Index> region = m_splice.inner();
    if (!m_task.has_to_prove) {
      examine_everything();
      flip();
    }
    if (has_rebuilt() || region.empty())
      return;
    if (!can_spare(region.size()) ||
        m_relocation.number_waiting() + region.size() > max_taken_out())
      return rebuild(Rebuild_reason_2::TOO_MUCH_BROKEN);
    m_budget.allow(region.size() * Repair_budget_2::relocation); // limited by max_taken_out()
    if (take_out(region))
      flip();
  }

  // REBUILDING ----------------------------------------------------------------------------------

  void rebuild_with_relocation()
  {
    std::vector<Index> ids;
    std::vector<Point> points;
    m_relocation.for_each_coming([&](Point_id id, const Point& p) {
      ids.push_back(id);
      points.push_back(p);
    });
    m_relocation.give_up();
    if (ids.empty())
      m_builder.rebuild();
    else
      m_builder.build_with({}, std::move(ids), std::move(points));
  }

  const State& m_state;
  Static_engines_2 m_engines;
  Editor m_editor;
  Builder m_builder;
  Relocation m_relocation;
  Jumper_search_2<State> m_jumpers;
  Lawson_flips_2 m_lawson;
  typename State::Splice m_splice;
  Classification m_classification;
  Open_edges_2 m_open;
  Repair_budget_2 m_budget;
  std::vector<Index> m_around; // edges around a vertex that was put in
  std::vector<Index> m_padded, m_border;
  Update_report_2* m_report = nullptr;
  Task m_task{};              // a splice clears hull_stays
  bool m_is_exact = true;     // whether the classifier is exact
  bool m_may_take_out = true; // until vertices are put in
  std::size_t m_classified_edges = 0;
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_UPDATE_REPAIR_TOOLS_2_H

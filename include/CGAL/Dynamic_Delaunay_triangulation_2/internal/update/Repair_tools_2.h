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
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/update/Cost_model_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/update/Held_vertices_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/update/Lawson_flips_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/update/Open_edges_2.h>
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
    , m_held(state, m_editor)
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
    m_budget.start_generously(price_of_rebuild());
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
    m_classified_edges = m_open.size();
    m_price_of_mending = price(Cost_model_2::mending);
    if (task.jumper != null_index)
      open_edges_that_see(task.jumper);
  }

  // Whether the only vertex that has moved has to be taken out.
  bool has_jumped_alone(Vertex_index v) const { return m_held.goes_far(v); }

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
    m_open.close_proved(m_state);
    return are_gone;
  }

  // Removes points with these ids before a frame moves the others, so that it stays known where
  // these rest. Everything has to be Delaunay. Leaves the points that share a vertex to remove().
  // False if some of the others are left, as in remove().
  bool remove_before_motion(const std::vector<Index>& ids)
  {
    const std::size_t first_new = m_state.changes().new_edges.size();
    m_relocation.remove_of_delaunay(ids);
    if (m_relocation.has_rest()) {
      const std::size_t first_unproved = m_state.changes().new_edges.size();
      if (!m_relocation.remove_rest())
        return false;
      Open_edges_2 around;
      around.open_new_edges(m_state, first_unproved);
      note_flips(m_lawson.run(m_state, m_editor, around.uncertain(), false, most_flips()));
      m_task.was_certified = around.empty() && hull_turns_once();
    }
    m_open.open_new_edges(m_state, first_new);
    return true;
  }

  // The largest number of vertices to take out and put in again where no region can be spliced, a
  // sixth of a small torus: more are as much work as triangulating anew.
  std::size_t max_taken_out() const { return 10 + m_state.number_of_vertices() / 6; }

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
    m_budget.allow((parted_duplicates.size() + m_relocation.number_to_put_in()) *
                   Cost_model_2::relocation);
    std::size_t steps_before = 0;
    const auto most_faces = [&] { return is_delaunay ? most_flips() + 1 : 0; };
    const auto end = [&](Vertex_index v, std::size_t steps, std::size_t faces) {
      m_budget.spend(Cost_model_2::insertion +
                     Cost_model_2::step_of_a_walk * (steps - steps_before));
      steps_before = steps;
      if (faces > 0)
        spend_on_flips(faces - 1); // so many flips would do the same
      else {
        settle(v);
        is_delaunay = is_delaunay && m_open.empty();
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

  // After an exception: puts held vertices at their positions and all vertices into faces, and
  // cancels the insertions that are left. Throws nothing.
  void give_up()
  {
    m_held.let_go();
    m_relocation.give_up();
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

  // The price of mending what is open.
  template <class Price>
  std::size_t price(const Price& price_of) const
  {
    return price_of(m_open.illegal().size(), m_open.uncertain().size());
  }

  std::size_t price_of_rebuild() const { return Cost_model_2::rebuild(m_state.rebuilt_vertices()); }

  // Whether a rebuild is cheaper than mending what was classified plus all insertions and removals.
  // Where vertices can be held, their number will tell: then only if it surely is.
  bool is_rebuild_cheaper() const
  {
    // where points did not move, only the faces around those that came or went are new
    const bool are_few_inverted = can_hold() || !m_state.have_points_moved();
    const std::size_t mending =
        are_few_inverted ? price(Cost_model_2::least_of_mending) : price(Cost_model_2::mending);
    return mending + m_task.changes * Cost_model_2::insertion > price_of_rebuild();
  }

  // Whether mending alone has cost as much as a rebuild.
  bool has_cost_a_rebuild() const { return m_budget.has_spent(price_of_rebuild()); }

  // TOOLS, as Dynamic_mender_2 documents them ----------------------------------------------------

  void limit_cost() { m_budget.start(price_of_rebuild(), m_price_of_mending); }

  // Whether vertices can be held: it is known where they rest, with all faces counterclockwise.
  bool can_hold() const
  {
    return m_task.has_to_prove && m_task.was_certified && m_state.have_points_moved() &&
           !has_rebuilt();
  }

  void hold()
  {
    if (!can_hold() || m_open.empty())
      return;
    if (m_task.jumper != null_index)
      return take_out_jumper();
    const std::size_t most = most_to_hold();
    if (!m_held.hold(m_open.uncertain(), most))
      return rebuild(m_held.size() > most ? Rebuild_reason_2::TOO_MUCH_BROKEN
                                          : Rebuild_reason_2::STUCK);
    m_budget.spend(m_held.size() * Cost_model_2::held_vertex);
    std::vector<Index>& changed = m_around;
    changed.clear();
    m_held.append_changed_edges(changed);
    if (!mend_hull(changed))
      return rebuild(Rebuild_reason_2::STUCK);
    m_open.set_planar(true);
    typename State::Edge_test(m_state).append_unproved(changed, m_open.uncertain());
  }

  void release()
  {
    if (m_held.empty())
      return;
    if (!m_open.empty())
      return rebuild(Rebuild_reason_2::STUCK);
    constexpr unsigned max_rounds = 12;
    const auto flip = [this](const std::vector<Index>& edges) { flip_nearby(edges); };
    for (unsigned round = 0; round < max_rounds && m_held.release(flip); ++round)
      if (has_rebuilt() || !m_open.empty())
        break;
    if (!has_rebuilt() && !(m_open.empty() && take_out_held()))
      rebuild(m_budget.is_spent() ? Rebuild_reason_2::BUDGET_SPENT : Rebuild_reason_2::STUCK);
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
    // where no splice follows, the vertices of the edges that are left are put in anew
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
    m_held.let_go();
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

  // VERTICES THAT WENT FAR ----------------------------------------------------------------------

  // Whether enough vertices remain in faces if so many more are taken out.
  bool can_spare(std::size_t vertices) const
  {
    return m_relocation.number_outside() + vertices + State::min_vertices <=
           m_state.number_of_vertices();
  }

  // Takes these vertices out if the budget allows it and enough remain. Skips those whose faces
  // meet images of themselves, like the lowest point of a slab. Returns whether any is out.
  bool take_out(const std::vector<Index>& vertices)
  {
    if (vertices.empty() || vertices.size() * Cost_model_2::relocation > m_budget.left() ||
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
      is_any_out |= m_relocation.take_out(vertices[i], m_state.previous_position(vertices[i]));
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
        price += Cost_model_2::removal +
                 Cost_model_2::flip * (degree - (std::min)(degree, usual_degree));
      }
      return price;
    });
  }

  // HELD VERTICES -------------------------------------------------------------------------------

  // If more vertices have to be held, a rebuild costs less. A few may always be.
  std::size_t most_to_hold() const
  {
    constexpr std::size_t few = 30;
    const std::size_t others = Cost_model_2::illegal_edge * m_open.illegal().size() +
                               m_task.changes * Cost_model_2::insertion;
    const std::size_t rebuild = price_of_rebuild();
    return few + (rebuild - (std::min)(others, rebuild)) / Cost_model_2::mended_vertex;
  }

  // Takes out the only vertex that has moved. Where it rests everything is Delaunay.
  void take_out_jumper()
  {
    m_open.clear();
    m_held.hold_at_rest(m_task.jumper);
    if (!take_out_held())
      rebuild(Rebuild_reason_2::STUCK);
  }

  // Flips edges at infinity until the hull is convex. No face is inverted. `changed` are edges
  // whose test has changed since the classification. Returns whether the faces tile the hull.
  bool mend_hull(const std::vector<Index>& changed)
  {
    if constexpr (!State::has_hull)
      return true;
    m_at_hull.clear();
    for (const std::vector<Index>* edges : {&std::as_const(m_open).uncertain(), &changed})
      for (const Edge_index e : *edges)
        if (m_state.is_at_infinity(e))
          m_at_hull.push_back(e);
    if (!m_at_hull.empty())
      note_flips(m_lawson.run(m_state, m_editor, m_at_hull, false, most_flips()));
    return m_at_hull.empty() && hull_turns_once();
  }

  // Flips from edges around a held vertex, and opens those that it cannot prove.
  void flip_nearby(const std::vector<Index>& edges)
  {
    m_unproved.clear();
    typename State::Edge_test(m_state).append_unproved(edges, m_unproved);
    if (m_unproved.empty())
      return;
    note_flips(m_lawson.run_nearby(m_state, m_editor, m_unproved, most_flips()));
    m_open.uncertain().insert(m_open.uncertain().end(), m_unproved.begin(), m_unproved.end());
  }

  // Takes out the vertices that are still held, from a Delaunay triangulation. They are put in at
  // their targets later.
  bool take_out_held()
  {
    return m_held.take_out_rest([this](Vertex_index v) {
      m_budget.spend(Cost_model_2::removal);
      return can_spare(1) && (m_relocation.take_out_of_delaunay(v) || take_out_of_hull(v));
    });
  }

  // Takes out a vertex on the hull, or of high degree, and flips around.
  bool take_out_of_hull(Vertex_index v)
  {
    const std::size_t first_new = m_state.changes().new_edges.size();
    if (!m_relocation.take_out(v, m_state.positions()[v]))
      return false;
    m_open.open_new_edges(m_state, first_new);
    note_flips(m_lawson.run(m_state, m_editor, m_open.uncertain(), false, most_flips()));
    m_open.set_planar(m_open.empty() && hull_turns_once());
    return m_open.faces_tile_hull();
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
    note_flips(flips);
    if (m_budget.is_spent())
      rebuild(Rebuild_reason_2::BUDGET_SPENT);
  }

  void note_flips(std::size_t flips)
  {
    m_report->flips += flips;
    m_budget.spend(flips * Cost_model_2::flip);
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

  std::size_t most_flips() const { return m_budget.left() / Cost_model_2::flip + 1; }

  // The price of putting a vertex in includes the first flips.
  void spend_on_flips(std::size_t flips)
  {
    constexpr std::size_t few = 8;
    m_budget.spend(flips > few ? (flips - few) * Cost_model_2::flip : 0);
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
    const std::size_t most = m_budget.left() / Cost_model_2::spliced_vertex;
    Splice_limits_2 limits{max_enlargements, most};
    const Splice_result_2 result = m_splice.run(m_editor, vertices, padding, limits);
    m_budget.spend((most - limits.max_vertices) * Cost_model_2::spliced_vertex);
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
        m_relocation.merge(candidates, m_budget.left() / Cost_model_2::relocation);
    m_report->merged += merged;
    m_budget.spend(merged * Cost_model_2::relocation);
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
    m_budget.allow(region.size() * Cost_model_2::relocation); // limited by max_taken_out()
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
  Held_vertices_2<State> m_held;
  Lawson_flips_2 m_lawson;
  typename State::Splice m_splice;
  Classification m_classification;
  Open_edges_2 m_open;
  Repair_budget_2 m_budget;
  std::vector<Index> m_around;   // edges around a vertex that was put in, or around held ones
  std::vector<Index> m_at_hull;  // edges at infinity
  std::vector<Index> m_unproved; // around the vertex that has moved last
  std::vector<Index> m_padded, m_border;
  Update_report_2* m_report = nullptr;
  Task m_task{};          // a splice clears hull_stays
  bool m_is_exact = true; // whether the classifier is exact
  std::size_t m_classified_edges = 0, m_price_of_mending = 0;
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_UPDATE_REPAIR_TOOLS_2_H

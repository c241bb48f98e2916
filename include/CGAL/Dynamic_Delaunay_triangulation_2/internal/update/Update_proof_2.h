// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_UPDATE_UPDATE_PROOF_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_UPDATE_UPDATE_PROOF_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Flat_arrays.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Flat_elements_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/proof/Edge_test_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/topology/Change_log_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/views/Dynamic_classification_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/views/Dynamic_frame_2.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

// What an update is about, besides what the classifier names.
struct Update_task_2
{
  bool needs_proof = false;       // of everything; otherwise what the tools leave is right
  bool is_rest_known = false;     // all is Delaunay where vertices were before they moved, and rest
  bool is_hull_as_before = false; // it turned around once; new faces alone may have changed it
  std::size_t changes = 0;        // the number of points inserted and removed
  Vertex_index jumper = null_index; // the only vertex that has moved, if it is to be taken out
};

// How far an update has come: which edges are *open*, that is, not proved Delaunay yet, and what is
// known of the faces. Edges known to be illegal between two counterclockwise faces are kept apart,
// because a flip repairs them.
class Update_proof_2
{
public:
  // Starts anew, with no open edge.
  void start(const Update_task_2& task)
  {
    m_task = task;
    clear();
  }

  const Update_task_2& task() const { return m_task; }
  bool is_required() const { return m_task.needs_proof; }
  bool is_rest_known() const { return m_task.is_rest_known; }
  void forget_rest() { m_task.is_rest_known = false; }
  void forget_hull() { m_task.is_hull_as_before = false; }

  // Whether the last tool has proved that the faces tile the convex hull, on a torus the torus, as
  // counterclockwise faces do. If no tool was used yet, whether the classifier has.
  bool do_faces_tile_hull() const { return m_do_faces_tile_hull; }
  void set_faces_tile_hull(bool do_tile) { m_do_faces_tile_hull = do_tile; }

  // Whether nothing is left to prove.
  template <class State>
  bool is_complete(const State& state) const
  {
    return empty() && (do_faces_tile_hull() || hull_turns_once(state));
  }

  // Condition 4 of the certificate. A hull that has turned around once still does so if its
  // vertices are the same and have not moved. They are the same if no face at infinity is new. Each
  // new face has an edge in the log: a flip logs the diagonal, which is in both faces; putting in a
  // vertex logs all edges of its faces; taking one out logs the edges between the faces that are
  // left, and all edges of the last one. So no face at infinity is new if no edge in the log is at
  // one. Walking around a long hull costs more than all the rest.
  template <class State>
  bool hull_turns_once(const State& state) const
  {
    const Change_log_2& changes = state.changes();
    const auto are_inside = [&](std::size_t i, std::size_t beyond) {
      while (i < beyond && !state.is_at_infinity(changes.new_edges[i]))
        ++i;
      return i == beyond;
    };
    return (m_task.is_hull_as_before && !changes.everything_is_new &&
            State::Parts::all_of(changes.new_edges.size(), are_inside)) ||
           Dynamic_frame_2<State>(state).hull_turns_once();
  }

  // OPEN EDGES ----------------------------------------------------------------------------------

  bool empty() const { return m_uncertain.empty() && m_illegal.empty(); }
  std::size_t size() const { return m_uncertain.size() + m_illegal.size(); }

  // Open edges that may have inverted faces.
  const std::vector<Edge_index>& uncertain() const { return m_uncertain; }
  // The other ones.
  const std::vector<Edge_index>& illegal() const { return m_illegal; }
  std::vector<Edge_index>& uncertain() { return m_uncertain; }

  void clear()
  {
    m_uncertain.clear();
    m_illegal.clear();
    m_do_faces_tile_hull = false;
  }

  // Opens these edges.
  void open(const std::vector<Edge_index>& edges)
  {
    m_uncertain.insert(m_uncertain.end(), edges.begin(), edges.end());
  }

  // Opens the edges that see a vertex.
  template <class State>
  void open_around(const State& state, Vertex_index v)
  {
    Dynamic_frame_2<State>(state).for_each_edge_that_sees(
        v, [this](Edge_index e) { m_uncertain.push_back(e); });
  }

  // Takes the classified edges, and the edges at the vertices that were classified as a whole.
  template <class State>
  void take(const Dynamic_classification_2<State>& classification, const State& state)
  {
    clear();
    if (classification.is_everything())
      return open_all(state);
    const Dynamic_frame_2<State> frame(state);
    for (const Vertex_index v : classification.whole_vertices())
      frame.for_each_incident_edge(v, [this](Edge_index e) { m_uncertain.push_back(e); });
    const auto& edges = classification.edges();
    const auto illegal = edges.end() - std::ptrdiff_t(classification.number_of_illegal_edges());
    m_uncertain.insert(m_uncertain.end(), edges.begin(), illegal);
    m_illegal.assign(illegal, edges.end());
    if (empty() && classification.hull_turns_once())
      m_do_faces_tile_hull = true;
  }

  // Opens the edges that the log of new edges lists from the i-th on, and the edges around these,
  // whose opposite vertices may have changed. Drops open edges that are empty by now.
  template <class State>
  void open_new_edges(const State& state, std::size_t i)
  {
    const auto& arrays = state.arrays();
    const auto& new_edges = state.changes().new_edges;
    m_opened.clear(arrays.number_of_edges()); // each occurs some five times
    for (; i < new_edges.size(); ++i)
      if (!arrays.is_empty_edge(new_edges[i])) {
        m_opened.insert(new_edges[i]);
        arrays.for_each_side(new_edges[i], [this](Edge_index e) { m_opened.insert(e); });
      }
    using Parts = typename State::Parts;
    constexpr std::size_t least = Parts::size_for(4);
    remove_by_parts<Parts>(m_illegal, least, [&](std::size_t k, std::size_t) {
      return arrays.is_empty_edge(m_illegal[k]);
    });
    remove_by_parts<Parts>(m_uncertain, least, [&](std::size_t k, std::size_t) {
      return arrays.is_empty_edge(m_uncertain[k]) || m_opened.contains(m_uncertain[k]);
    });
    m_uncertain.insert(m_uncertain.end(), m_opened.begin(), m_opened.end());
    m_do_faces_tile_hull = false;
  }

  // From now on everything has to be proved. Opens all edges that may not be Delaunay.
  template <class State>
  void require_of_all(const State& state)
  {
    m_task.needs_proof = true;
    clear();
    append_unproved(state, m_uncertain);
  }

  // Closes the uncertain edges that the filter proves.
  template <class State>
  void close_proved(const State& state)
  {
    m_unproved.clear();
    typename State::Edge_test(state).append_unproved(m_uncertain, m_unproved);
    m_uncertain.swap(m_unproved);
  }

  // From now on, treats the illegal edges like the others.
  void open_illegal()
  {
    m_uncertain.insert(m_uncertain.end(), m_illegal.begin(), m_illegal.end());
    m_illegal.clear();
  }

  // Opens these edges, too, then closes all uncertain edges that are Delaunay.
  template <class State>
  void reopen(const State& state, const std::vector<Edge_index>& edges)
  {
    open(edges);
    keep_unproved(state, m_uncertain);
  }

  // The finite vertices of uncertain edges, some more than once.
  template <class State>
  std::vector<Vertex_index> uncertain_vertices(const State& state) const
  {
    std::vector<Vertex_index> vertices;
    for (const Edge_index e : m_uncertain) {
      const Edge_2 edge = state.edge(e);
      for (const Vertex_index v : {edge.source, edge.target, edge.left, edge.right})
        if (v != infinite_index)
          vertices.push_back(v);
    }
    return vertices;
  }

private:
  // Opens all edges, without the empty ones of vertices outside of all faces: an earlier step may
  // have taken them out.
  template <class State>
  void open_all(const State& state)
  {
    const auto& arrays = state.arrays();
    for (Edge_index e(0); e < arrays.number_of_edges(); ++e)
      if (!arrays.is_empty_edge(e))
        m_uncertain.push_back(e);
  }

  std::vector<Edge_index> m_uncertain, m_illegal, m_unproved;
  Index_set<Edge_index> m_opened;
  Update_task_2 m_task;
  bool m_do_faces_tile_hull = false;
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_UPDATE_UPDATE_PROOF_2_H

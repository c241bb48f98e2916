// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_UPDATE_OPEN_EDGES_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_UPDATE_OPEN_EDGES_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/classifiers/Dynamic_classification_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/core/Flat_arrays_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/proof/Edge_test_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/queries/Dynamic_frame_2.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

// How far the proof of an update has come: which edges are *open*, that is, not proved Delaunay
// yet, and whether the faces are known to tile the hull. The proof is complete when no edge is open
// and the faces tile the hull. Edges known to be illegal between two counterclockwise faces are
// kept apart, because a flip repairs them.
class Open_edges_2
{
public:
  bool empty() const { return m_uncertain.empty() && m_illegal.empty(); }
  std::size_t size() const { return m_uncertain.size() + m_illegal.size(); }

  // Open edges that may have inverted faces.
  const std::vector<Index>& uncertain() const { return m_uncertain; }
  // The other ones.
  const std::vector<Index>& illegal() const { return m_illegal; }
  std::vector<Index>& uncertain() { return m_uncertain; }

  // Whether the last tool has proved that the faces tile the convex hull. If no tool was used yet,
  // whether the classifier has. On a torus the faces tile the torus as soon as none is inverted.
  bool faces_tile_hull() const { return m_faces_tile_hull; }
  void set_planar(bool faces_tile_hull) { m_faces_tile_hull = faces_tile_hull; }

  void clear()
  {
    m_uncertain.clear();
    m_illegal.clear();
    m_faces_tile_hull = false;
  }

  // Takes the classified edges, and the edges at the vertices that were classified as a whole.
  template <class State>
  void take(const Dynamic_classification_2<State>& classification, const State& state)
  {
    clear();
    if (classification.is_everything()) {
      m_uncertain.resize(state.arrays().number_of_edges());
      std::iota(m_uncertain.begin(), m_uncertain.end(), Index(0));
      return;
    }
    const Dynamic_frame_2<State> frame(state);
    for (const Vertex_index v : classification.whole_vertices())
      frame.for_each_incident_edge(v, [this](Edge_index e) { m_uncertain.push_back(e); });
    const auto& edges = classification.edges();
    const auto illegal = edges.end() - std::ptrdiff_t(classification.number_of_illegal_edges());
    m_uncertain.insert(m_uncertain.end(), edges.begin(), illegal);
    m_illegal.assign(illegal, edges.end());
    m_faces_tile_hull = empty() && classification.hull_turns_once();
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
    constexpr std::size_t least = (std::max)(Parts::usual_size / 4, std::size_t(1));
    remove_by_parts<Parts>(m_illegal, least, [&](std::size_t k, std::size_t) {
      return arrays.is_empty_edge(m_illegal[k]);
    });
    remove_by_parts<Parts>(m_uncertain, least, [&](std::size_t k, std::size_t) {
      return arrays.is_empty_edge(m_uncertain[k]) || m_opened.contains(m_uncertain[k]);
    });
    m_uncertain.insert(m_uncertain.end(), m_opened.begin(), m_opened.end());
    m_faces_tile_hull = false;
  }

  // Opens all edges that may not be Delaunay.
  template <class State>
  void take_unproved(const State& state)
  {
    using Parts = typename State::Parts;
    const std::size_t edges = state.arrays().number_of_edges();
    std::vector<std::vector<Index>> open(Parts::number(edges));
    Parts::for_each(edges, [&](std::size_t part, std::size_t first, std::size_t beyond) {
      typename State::Edge_test(state).append_unproved(Index(first), Index(beyond), open[part]);
    });
    clear();
    for (const std::vector<Index>& of_part : open)
      m_uncertain.insert(m_uncertain.end(), of_part.begin(), of_part.end());
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

  // Opens the edges around open ones, because an illegal edge nearby may prevent their flips.
  template <class State>
  void open_surroundings(const State& state)
  {
    using Parts = typename State::Parts;
    constexpr std::size_t least = (std::max)(Parts::usual_size / 64, std::size_t(1));
    const Dynamic_frame_2<State> frame(state);
    std::vector<Index> vertices;
    for_each_uncertain_vertex(state, [&](Vertex_index v) { vertices.push_back(v); });
    make_distinct(vertices); // a vertex may be at many open edges, and see many other edges
    std::vector<std::vector<Index>> edges(Parts::number(vertices.size(), least));
    Parts::for_each(vertices.size(), least,
                    [&](std::size_t part, std::size_t i, std::size_t beyond) {
                      for (; i < beyond; ++i)
                        frame.for_each_edge_that_sees(
                            vertices[i], [&](Edge_index e) { edges[part].push_back(e); });
                    });
    for (const std::vector<Index>& list : edges)
      m_uncertain.insert(m_uncertain.end(), list.begin(), list.end());
    make_distinct(m_uncertain);
  }

  // Opens these edges, too, then closes all uncertain edges that are Delaunay.
  template <class State>
  void reopen(const State& state, const std::vector<Index>& edges)
  {
    m_uncertain.insert(m_uncertain.end(), edges.begin(), edges.end());
    keep_unproved(state, m_uncertain);
  }

  // Calls f(v) for the finite vertices of uncertain edges, for some more than once.
  template <class State, class Function>
  void for_each_uncertain_vertex(const State& state, const Function& f) const
  {
    for (const Edge_index e : m_uncertain) {
      const Edge_2 edge = state.edge(e);
      for (const Vertex_index v : {edge.source, edge.target, edge.left, edge.right})
        if (v != infinite_index)
          f(v);
    }
  }

private:
  std::vector<Index> m_uncertain, m_illegal, m_unproved;
  Index_set_2 m_opened;
  bool m_faces_tile_hull = false;
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_UPDATE_OPEN_EDGES_2_H

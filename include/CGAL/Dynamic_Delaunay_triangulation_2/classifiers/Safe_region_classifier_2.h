// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_CLASSIFIERS_SAFE_REGION_CLASSIFIER_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_CLASSIFIERS_SAFE_REGION_CLASSIFIER_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Flat_arrays.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Flat_elements_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/proof/Edge_slack_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/proof/Edge_test_2.h>

#include <algorithm>
#include <limits>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgDynamicDelaunayTriangulation2Classifiers

Gives every vertex a *safe region*, a disk around an earlier position: as long as all vertices stay
in their disks, the triangulation stays Delaunay (thesis 4.2.2, Proposition 1 of its [CD08]: de
Castro and Devillers, *Delaunay triangulations for moving points*, INRIA RR-6750, 2008). For an edge
`bc` with the opposite vertices `a` and `d`, let `o` be where the bisectors of `bc` and `ad` meet,
`r` the larger one of `|ob|` and `|oc|`, and `R` the smaller one of `|oa|` and `|od|`. The radius of
a vertex's disk is the minimum of `(R - r) / 2` over all edges that it is an end of or opposite to;
at the hull, about half of a distance is taken instead. If vertices have left their disks, exact
predicates test all edges that these vertices are ends of or opposite to, and the vertices of the
edges that are not Delaunay are classified.

It is *exact*: it misses no edge (\ref SafeEdgesVertices). So it classifies the same as
`Circumcircle_classifier_2`. `Circumcircle_classifier_2` keeps slack for edges instead of vertices,
with one tolerance for all, and is faster: here one edge near a tie shrinks the disks of four
vertices.

Cost: one pass over all vertices if at most one in 64 has left its disk, plus computing the disks of
these anew. Otherwise one pass over all edges, and now and then another one to compute all disks
anew. Memory for three doubles a vertex and one an edge.

\cgalModels{DelaunayClassifier_2}
*/
class Safe_region_classifier_2
{
public:
  /// it misses no edge.
  static constexpr bool is_exact = true;

  /// classifies.
  template <class Frame, class Classification>
  void operator()(const Frame& frame, Classification& classified)
  {
    // an exception may have ended the last update before this classifier was told
    m_holds = m_holds && !frame.has_changes() && frame.positions_are_exact() &&
              m_cell_changes == frame.number_of_cell_changes() && find_moved(frame);
    if (m_holds)
      find_edges_of_moved(frame);
    else
      find_unproved(frame);
    classified.add_unless_delaunay(frame, m_unproved);
  }

  /// computes new disks for the vertices that have left theirs, and for those around what was
  /// triangulated anew.
  template <class Frame>
  void after_update(const Frame& frame)
  {
    // vertex numbers in m_moved are of no use after vertices were renumbered
    if (m_holds && !frame.everything_is_new() && frame.positions_are_exact() &&
        !(frame.has_other_numbers() && !m_moved.empty())) {
      ++m_held;
      renew(frame);
      return;
    }
    m_holds = false;
    adapt_rest();
    if (m_rest > 0)
      --m_rest;
    else if (frame.positions_are_exact() && frame.number_of_edges() > 0)
      start(frame); // without edges the points do not span the plane
  }

private:
  using Vertex_index = Dynamic_Delaunay_triangulations_2::Vertex_index;
  using Edge_index = Dynamic_Delaunay_triangulations_2::Edge_index;
  using Positions = Dynamic_Delaunay_triangulations_2::Position_vector;

  static constexpr unsigned frames_worth_it = 16, max_rest = 64;

  // Lists vertices outside of their disks. False if too many: testing all edges then costs less.
  template <class Frame>
  bool find_moved(const Frame& frame)
  {
    using namespace Dynamic_Delaunay_triangulations_2::internal;
    m_moved.clear();
    for (Vertex_index v(1); v <= frame.number_of_vertices(); ++v)
      if (!(squared_distance(frame.position(v), m_references[v]) <= m_squared_bounds[v]))
        m_moved.push_back(v);
    add_relocated(frame);
    return 64 * m_moved.size() <= frame.number_of_vertices();
  }

  // Adds vertices that jumped or are given by another image: their references prove nothing.
  template <class Frame>
  void add_relocated(const Frame& frame)
  {
    m_moved.insert(m_moved.end(), frame.relocated_vertices().begin(),
                   frame.relocated_vertices().end());
  }

  template <class Frame>
  void find_edges_of_moved(const Frame& frame)
  {
    m_edges.clear(frame.number_of_edges());
    for (const Vertex_index v : m_moved)
      frame.for_each_edge_that_sees(v, [&](Edge_index e) { m_edges.insert(e); });
    m_unproved.assign(m_edges.begin(), m_edges.end());
    std::sort(m_unproved.begin(), m_unproved.end());
  }

  template <class Frame>
  void find_unproved(const Frame& frame)
  {
    m_unproved.clear();
    frame.append_unproved(0, frame.number_of_edges(), m_unproved);
  }

  // If the disks did not last long, they are not computed again for a while.
  void adapt_rest()
  {
    if (!m_was_started)
      return;
    m_was_started = false;
    m_next_rest = m_held >= frames_worth_it ? 1 : (std::min)(2 * m_next_rest, max_rest);
    m_rest = m_held >= frames_worth_it ? 0 : m_next_rest;
  }

  template <class Frame>
  void start(const Frame& frame)
  {
    m_was_started = true;
    m_held = 0;
    m_moved.clear();
    m_references = frame.positions();
    m_cell_changes = frame.number_of_cell_changes();
    m_tolerances.resize(frame.number_of_edges());
    m_squared_bounds.resize(m_references.size());
    for (Edge_index e(0); e < frame.number_of_edges(); ++e)
      measure(frame, e);
    for (Vertex_index v(1); v <= frame.number_of_vertices(); ++v)
      take_smallest(frame, v);
    m_holds = true;
  }

  template <class Frame>
  void renew(const Frame& frame)
  {
    m_holds = false; // until it is done: memory may run out
    frame.follow_vertices(m_references, [&](Vertex_index v) { return frame.position(v); });
    frame.follow_vertices(m_squared_bounds, [](Vertex_index) { return -1.; });
    frame.follow_edges(m_tolerances);
    if (!frame.has_other_numbers())
      add_relocated(frame);
    m_edges.clear(frame.number_of_edges());
    for (const Vertex_index v : m_moved) {
      m_references[v] = frame.position(v);
      frame.for_each_edge_that_sees(v, [&](Edge_index e) { m_edges.insert(e); });
    }
    frame.for_each_changed_edge([&](Edge_index e) { m_edges.insert(e); });
    m_vertices.clear(m_references.size());
    for (const Edge_index e : m_edges) {
      measure(frame, e);
      const auto& edge = frame.edge(e);
      for (const Vertex_index v : {edge.source, edge.target, edge.left, edge.right})
        m_vertices.insert(v);
    }
    for (const Vertex_index v : m_vertices)
      if (!frame.is_infinite(v))
        take_smallest(frame, v);
    m_moved.clear();
    m_holds = true;
  }

  template <class Frame>
  void measure(const Frame& frame, Edge_index e)
  {
    m_tolerances[e] = Frame::Slacks::tolerance(frame, e, m_references);
  }

  template <class Frame>
  void take_smallest(const Frame& frame, Vertex_index v)
  {
    double smallest = (std::numeric_limits<double>::max)();
    frame.for_each_edge_that_sees(
        v, [&](Edge_index e) { smallest = (std::min)(smallest, m_tolerances[e]); });
    m_squared_bounds[v] =
        smallest > 0 ? Dynamic_Delaunay_triangulations_2::internal::squared_bound(smallest) : -1;
  }

  bool m_holds = false;
  Positions m_references;               // the centers of the disks
  std::size_t m_cell_changes = 0;       // when these were taken
  std::vector<double> m_squared_bounds; // of the disks' radii; negative where there is no disk
  std::vector<double> m_tolerances;     // of each edge
  std::vector<Vertex_index> m_moved;    // vertices that left their disks
  std::vector<Edge_index> m_unproved;
  Dynamic_Delaunay_triangulations_2::internal::Index_set<Edge_index> m_edges;
  Dynamic_Delaunay_triangulations_2::internal::Index_set<Vertex_index> m_vertices;
  unsigned m_held = 0;      // the number of frames for which the disks have held
  unsigned m_next_rest = 1; // frames
  unsigned m_rest = 0;      // frames
  bool m_was_started = false;
};

} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_CLASSIFIERS_SAFE_REGION_CLASSIFIER_2_H

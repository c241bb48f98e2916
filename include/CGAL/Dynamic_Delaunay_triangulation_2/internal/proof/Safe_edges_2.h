// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_PROOF_SAFE_EDGES_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_PROOF_SAFE_EDGES_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Flat_arrays.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Edge_kinds_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Flat_elements_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Points_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/proof/Edge_slack_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/proof/Edge_test_2.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

// The edges that can be skipped. All vertices have a reference position, and there is one
// tolerance. An edge is *safe* if it is proved Delaunay for all positions of its four vertices
// within the tolerance of their references (Edge_slack_2), and *tight* otherwise. While all
// vertices are within the tolerance, only the tight edges are examined. If a few vertices are not,
// the edges that see them are examined, too.
//
// Skipping is exact. It remains to show that both faces at a skipped edge are counterclockwise,
// which the proof for the edge assumes. Let the vertices of such a face move straight from their
// references to their positions. If an edge of the face is examined, the face is found
// counterclockwise, or the edge is classified. Otherwise all its edges are safe. The face was
// counterclockwise at the references, and could change that only by passing through a state with
// its three vertices on a line (or two in one place), one of them between the other two. But these
// two are the ends of a safe edge: a circle has them inside and the third vertex outside.
//
// The hull turns around as often as at the references if it has the same vertices, and each of its
// corners is proved to remain a left turn or a turn by less than a right angle (Edge_slack_2): the
// sum of its turning angles is a multiple of 360 degrees, and changes continuously.
//
// `Frame::Slacks` has these proofs for the space of the frame.
class Safe_edges_2
{
public:
  // Whether there are references.
  bool holds() const { return m_holds; }
  // Whether the hull, as of the last append_unproved(), is known to turn around once.
  bool hull_turns_once() const { return m_hull_stays; }

  // Samples how far vertices move per frame. Needs the previous positions.
  template <class Frame>
  void measure_step(const Frame& frame)
  {
    m_sample.clear();
    const std::size_t vertices = frame.number_of_vertices();
    for (std::size_t i = 0; i < sample_size; ++i) {
      const Vertex_index v(1 + i * vertices / sample_size);
      m_sample.push_back(distance(frame.position(v), frame.previous_position(v)));
    }
    m_typical_step = quantile(m_sample, 2);
  }

  // Takes the positions of the frame as references, with the tolerance that makes one edge in
  // `share` tight. Takes none if a typical vertex, at its measured speed, would exceed the
  // tolerance within a few frames.
  template <class Frame>
  void start(const Frame& frame, std::size_t share)
  {
    m_holds = false;
    choose_tolerance(frame, share);
    if (!(m_tolerance > Edge_slack_2::smallest_tolerance) ||
        m_typical_step * min_frames > m_tolerance)
      return;
    m_references = frame.positions();
    m_cell_changes = frame.number_of_cell_changes();
    find_tight(frame);
    if constexpr (Frame::Slacks::has_hull)
      check_hull(frame);
    m_holds = m_tight.size() <= max_tight(frame);
  }

  // Takes note of what an update has triangulated anew. Call at the end of the update.
  template <class Frame>
  void learn(const Frame& frame)
  {
    take_changes(frame);
    if constexpr (Frame::Slacks::has_hull)
      if (m_holds && !m_hull_is_checked)
        check_hull(frame);
  }

  // Does the work of learn() except the check of the hull, for an update that was not completed.
  template <class Frame>
  void take_changes(const Frame& frame)
  {
    if (!m_holds)
      return;
    m_holds = frame.positions_are_exact() && !frame.everything_is_new() &&
              !frame.has_other_numbers() && m_cell_changes == frame.number_of_cell_changes() &&
              64 * frame.new_edges().size() < frame.number_of_edges() &&
              16 * frame.relocated_vertices().size() <= frame.number_of_vertices();
    if (!m_holds)
      return;
    m_changed.clear();
    for (const Vertex_index v : frame.relocated_vertices()) {
      m_references[v] = frame.position(v);
      // if just another image gives the point, these edges are not new
      frame.for_each_edge_that_sees(v, [this](Edge_index e) { m_changed.push_back(e); });
    }
    for (const Edge_index e : frame.new_edges()) {
      if constexpr (Frame::Slacks::has_hull)
        if (is_at_infinity(frame.edge(e))) {
          consider_around(frame, e);
          continue;
        }
      m_changed.push_back(e);
      frame.for_each_side(e, [this](Edge_index side) { m_changed.push_back(side); });
    }
    make_distinct(m_changed);
    for (const Edge_index e : m_changed)
      consider(frame, e);
    m_holds = m_tight.size() <= max_tight(frame);
  }

  // Appends, in ascending order, the examined edges that are not Delaunay, and the unproved ones
  // among the sides of their faces: an inverted face breaks its skipped edges, too. Returns false,
  // with no result, if too many vertices have moved too far.
  template <class Frame>
  bool append_unproved(const Frame& frame, std::vector<Edge_index>& unproved)
  {
    m_moved.clear();
    m_holds = append_moved(frame.positions(), m_references, m_tolerance, max_moved(frame), m_moved);
    if (!m_holds)
      return false;
    m_hull_stays = m_hull_is_safe;
    frame.append_unproved(m_tight.members(), unproved);
    for (const Vertex_index v : m_moved)
      frame.for_each_edge_that_sees(v, [&](Edge_index e) {
        if constexpr (Frame::Slacks::has_hull)
          m_hull_stays = m_hull_stays && !is_at_infinity(frame.edge(e));
        if (!frame.proves_delaunay(e))
          unproved.push_back(e);
      });
    unproved.erase(std::remove_if(unproved.begin(), unproved.end(),
                                  [&](Edge_index e) { return frame.is_delaunay(e); }),
                   unproved.end());
    for (std::size_t i = 0, broken = unproved.size(); i < broken; ++i)
      frame.for_each_side(unproved[i], [&](Edge_index e) {
        if (!frame.proves_delaunay(e))
          unproved.push_back(e);
      });
    make_distinct(unproved);
    return true;
  }

private:
  static constexpr double min_frames = 8;
  static constexpr std::size_t sample_size = 256;

  template <class Frame>
  static std::size_t max_tight(const Frame& frame)
  {
    return frame.number_of_edges() / 8;
  }

  template <class Frame>
  static std::size_t max_moved(const Frame& frame)
  {
    return frame.number_of_vertices() / 64;
  }

  template <class Frame>
  void choose_tolerance(const Frame& frame, std::size_t share)
  {
    m_sample.clear();
    const std::size_t edges = frame.number_of_edges();
    for (std::size_t i = 0; i < sample_size; ++i) {
      const double slack = Frame::Slacks::value(frame, Edge_index(i * edges / sample_size));
      if (!std::isnan(slack)) // NaN at infinity, and where squares overflow
        m_sample.push_back(slack);
    }
    m_tolerance = m_sample.empty() ? 0 : quantile(m_sample, share);
  }

  // Each part of the edges has a list of its own.
  template <class Frame>
  void find_tight(const Frame& frame)
  {
    const std::size_t edges = frame.number_of_edges();
    std::vector<std::vector<Edge_index>> tight(Frame::Parts::number(edges));
    Frame::Parts::for_each(edges, [&](std::size_t part, std::size_t first, std::size_t beyond) {
      for (Edge_index e(first); e < beyond; ++e)
        if (!Frame::Slacks::is_safe(frame, e, m_references, m_tolerance))
          tight[part].push_back(e);
    });
    m_tight.clear(edges);
    for (const std::vector<Edge_index>& list : tight)
      for (const Edge_index e : list)
        m_tight.insert(e);
  }

  template <class Frame>
  void consider(const Frame& frame, Edge_index e)
  {
    if (!Frame::Slacks::is_safe(frame, e, m_references, m_tolerance))
      m_tight.insert(e);
  }

  // Checks whether the hull of a certified triangulation is proved to go on turning around once.
  // The hull may look different at the references, but turns around as often there if all its
  // vertices are within the tolerance.
  template <class Frame>
  void check_hull(const Frame& frame)
  {
    m_hull_is_checked = true;
    frame.for_each_neighbor(infinite_index, [&](Vertex_index v) {
      m_hull_is_checked =
          m_hull_is_checked && is_within(m_tolerance, frame.position(v), m_references[v]);
    });
    m_hull_is_safe = m_hull_is_checked && frame.hull_turns_once();
    if (m_hull_is_safe)
      frame.for_each_incident_edge(infinite_index, [&](Edge_index e) {
        m_hull_is_safe =
            m_hull_is_safe &&
            Frame::Slacks::slack(frame, e, m_references).keeps_turning_angle(m_tolerance);
      });
  }

  // Considers the edges around a new edge at the hull.
  template <class Frame>
  void consider_around(const Frame& frame, Edge_index e)
  {
    const Edge_2& edge = frame.edge(e);
    m_hull_is_safe = false;
    m_hull_is_checked = false;
    for (const Vertex_index v : {edge.source, edge.target, edge.left, edge.right})
      if (v != infinite_index)
        frame.for_each_incident_edge(v, [&](Edge_index f) { consider(frame, f); });
  }

  bool m_holds = false;
  double m_tolerance = 0;
  double m_typical_step = 0;
  Position_vector m_references;   // of each vertex
  std::size_t m_cell_changes = 0; // before the references were taken
  Index_set<Edge_index> m_tight;
  bool m_hull_is_checked = false;
  bool m_hull_is_safe = false; // it turns around once while no vertex leaves the tolerance
  bool m_hull_stays = false;   // and no vertex at the hull has left it
  std::vector<Vertex_index> m_moved;
  std::vector<Edge_index> m_changed; // edges whose opposite vertices have changed
  std::vector<double> m_sample;
};

// When to take references for Safe_edges_2, and how many edges may then be tight. Taking references
// costs as much as some ten frames. The first attempts allow few tight edges. If references fail
// too soon, the next ones allow twice as many. If even many do not help, a rest follows, which is
// longer each time. References that hold for long are taken anew with half as many.
class Safe_edges_schedule_2
{
public:
  // One edge in share() may be tight.
  unsigned share() const { return m_share; }

  // Whether the next update may end with new references.
  bool is_near() const { return m_rest == 0; }

  // Returns whether to take references. Call after each update, with whether the present ones hold.
  bool is_due(bool they_hold)
  {
    if (they_hold)
      return ++m_held >= m_long && refine();
    adapt_rest();
    if (m_rest > 0) {
      --m_rest;
      return false;
    }
    m_was_due = true;
    return true;
  }

private:
  static constexpr unsigned smallest_share = 16, largest_share = 64;
  static constexpr unsigned min_rest = 8, max_rest = 256;
  static constexpr unsigned frames_worth_it = 64;

  bool refine()
  {
    if (m_share == largest_share)
      return false;
    m_share *= 2;
    m_held = 0;
    m_is_refined = true;
    return true;
  }

  // Adapts share and rest to how long the last references held, if they ever did.
  void adapt_rest()
  {
    if (!m_was_due)
      return;
    m_was_due = false;
    if (m_held >= frames_worth_it) {
      m_rest = m_next_rest = min_rest;
    } else if (m_is_refined) {
      m_share /= 2;
      m_long *= 2;
      m_rest = 0;
    } else if (m_share > smallest_share) {
      m_share /= 2;
      m_rest = min_rest;
    } else {
      m_share = largest_share;
      m_next_rest = (std::min)(2 * m_next_rest, max_rest);
      m_rest = m_next_rest;
    }
    m_is_refined = false;
    m_held = 0;
  }

  unsigned m_share = largest_share;
  unsigned m_rest = 4; // frames
  unsigned m_next_rest = min_rest;
  unsigned m_held = 0; // frames
  unsigned m_long = 512;
  bool m_was_due = false;
  bool m_is_refined = false;
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_PROOF_SAFE_EDGES_2_H

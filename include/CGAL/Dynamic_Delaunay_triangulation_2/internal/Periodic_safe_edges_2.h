// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_PERIODIC_SAFE_EDGES_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_PERIODIC_SAFE_EDGES_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Edge_slack_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Flat_arrays_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Neighborhood_mirror_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Safe_edges_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Torus_2.h>

#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Dynamic_Delaunay_triangulations_2 {
namespace internal {

// A frame of a periodic triangulation, as Safe_edges_2 asks for it.
template <class Maintained, class Editor>
class Periodic_frame_2
{
  using Mirror = Neighborhood_mirror_2;

public:
  using Edge_test = typename Maintained::Edge_test;

  // `previous` are the positions of the frame before.
  Periodic_frame_2(const Maintained& maintained, const typename Editor::News& news,
                   const std::vector<Position_2>& previous)
    : m_maintained(maintained)
    , m_news(news)
    , m_previous(previous)
  {
  }

  const Maintained& maintained() const { return m_maintained; }

  Index number_of_vertices() const { return m_maintained.number_of_vertices(); }
  Index number_of_edges() const { return m_maintained.mirror().number_of_edges(); }
  const std::vector<Position_2>& positions() const { return m_maintained.positions(); }
  const Position_2& position(Index v) const { return positions()[v]; }
  const Position_2& previous_position(Index v) const { return m_previous[v]; }
  static constexpr bool positions_are_exact() { return true; }

  bool everything_is_new() const { return m_news.is_all_new; }
  static constexpr bool has_other_numbers() { return false; } // then everything is new
  const std::vector<Index>& new_edges() const { return m_news.edges; }
  const std::vector<Index>& relocated_vertices() const { return m_news.vertices; }

  void append_unproved(const std::vector<Index>& list, std::vector<Index>& unproved) const
  {
    Edge_test(m_maintained).append_unproved(list, unproved);
  }
  bool proves_delaunay(Index e) const
  {
    return m_maintained.mirror().is_empty_edge(e) ||
           Edge_test(m_maintained).filter_proves_delaunay(e);
  }
  bool is_delaunay(Index e) const
  {
    return m_maintained.mirror().is_empty_edge(e) ||
           Edge_test(m_maintained).state(e) == Edge_state_2::DELAUNAY;
  }

  // Edges of vertices that are outside of all faces were looked at when these were taken out.
  template <class Function>
  void for_each_edge_that_sees(Index v, const Function& f) const
  {
    const Mirror& mirror = m_maintained.mirror();
    if (!mirror.is_outside(v))
      mirror.for_each_corner(v, [&](Index h) {
        f(mirror.edge_of(h));
        f(mirror.edge_of(Mirror::previous(h)));
      });
  }
  template <class Function>
  void for_each_side(Index e, const Function& f) const
  {
    if (!m_maintained.mirror().is_empty_edge(e))
      m_maintained.mirror().for_each_side(e, f);
  }

private:
  const Maintained& m_maintained;
  const typename Editor::News& m_news;
  const std::vector<Position_2>& m_previous;
};

// The proofs of Edge_slack_2 for edges between images, while the cell stays the same. The corners
// are taken relative to one of them, which rounds them: each is off by at most some `error`. An
// image goes as far as its point. So within a tolerance t of their references, the corners are
// within t + error of the rounded ones, where the circle separates them. That the faces are
// counterclockwise is proved at the references themselves.
struct Periodic_slacks_2
{
  static constexpr bool has_hull = false;
  static constexpr std::size_t new_edges_per_flip = 6; // those of both faces

  template <class Frame>
  static double value(const Frame& frame, Index e)
  {
    const Edge_images_2 corners = corners_of(frame, e, frame.positions());
    return is_across(torus(frame), corners)
               ? std::numeric_limits<double>::quiet_NaN()
               : Edge_slack_2(torus(frame).rounded_corners(corners).first).value();
  }

  template <class Frame>
  static bool is_safe(const Frame& frame, Index e, const std::vector<Position_2>& references,
                      double tolerance)
  {
    return !frame.maintained().mirror().is_empty_edge(e) &&
           is_safe(torus(frame), corners_of(frame, e, references), tolerance);
  }

  static bool is_safe(const Torus_2& torus, const Edge_images_2& references, double tolerance)
  {
    if (is_across(torus, references) || !torus.filter_proves_counterclockwise(references))
      return false;
    const auto [rounded, error] = torus.rounded_corners(references);
    return Edge_slack_2(rounded).is_safe(tolerance + error);
  }

private:
  template <class Frame>
  static const Torus_2& torus(const Frame& frame)
  {
    return frame.maintained().torus();
  }

  template <class Frame>
  static Edge_images_2 corners_of(const Frame& frame, Index e,
                                  const std::vector<Position_2>& positions)
  {
    return frame.maintained().corners_at(frame.maintained().mirror().halfedge(e), positions);
  }

  static bool is_across(const Torus_2& torus, const Edge_images_2& corners)
  {
    const auto is_from_right = [&](const Image_2& image) {
      return torus.are_across(image.shift, corners.right.shift);
    };
    return is_from_right(corners.left) || is_from_right(corners.source) ||
           is_from_right(corners.target);
  }
};

// Finds the edges of a periodic triangulation that may have stopped being Delaunay in a frame, and
// skips edges that are safe, as Circumcircle_classifier_2 does in the plane.
class Periodic_safe_edges_2
{
public:
  // Whether the editor has to keep news.
  bool holds() const { return m_safe_edges.holds(); }

  // Appends edges that are not proved Delaunay, and all that are not Delaunay, after vertices have
  // moved and before anything is repaired.
  template <class Frame>
  void append_unproved(const Frame& frame, std::vector<Index>& unproved)
  {
    if (frame.number_of_vertices() == 0)
      return;
    if (m_schedule.is_near() && !m_safe_edges.holds())
      m_safe_edges.measure_step(frame);
    m_safe_edges.take_changes(frame);
    m_unproved.clear();
    if (m_safe_edges.holds() && m_safe_edges.append_unproved(frame, m_unproved))
      unproved.insert(unproved.end(), m_unproved.begin(), m_unproved.end());
    else
      typename Frame::Edge_test(frame.maintained()).append_unproved(unproved);
  }

  // To be called at the end of the frame.
  template <class Frame>
  void learn(const Frame& frame)
  {
    m_safe_edges.learn(frame);
    if (frame.number_of_vertices() > 0 && m_schedule.is_due(m_safe_edges.holds()) &&
        !frame.everything_is_new())
      m_safe_edges.start(frame, m_schedule.share());
  }

private:
  Safe_edges_2<Periodic_slacks_2> m_safe_edges;
  Safe_edges_schedule_2 m_schedule;
  std::vector<Index> m_unproved;
};

} // namespace internal
} // namespace Dynamic_Delaunay_triangulations_2
} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_PERIODIC_SAFE_EDGES_2_H

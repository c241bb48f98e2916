// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CLASSIFIERS_CLASSIFICATION_TRUTH_H
#define CLASSIFIERS_CLASSIFICATION_TRUTH_H

#include "scenario_runner/Motion.h"
#include "scenario_runner/Static_triangulation.h"

#include <CGAL/enum.h>

#include <cstddef>
#include <vector>

namespace classifiers {

// What motion has broken before anybody mends it, by the kernel's exact predicates: the edges of
// the last topology that are not Delaunay at the new positions, and the vertices that have one in
// their star, which is made of the edges at a vertex and of those opposite to it. These are the
// vertices whose neighbors change when the edge is flipped.
class Classification_truth
{
public:
  // Between two updates. The vertices and edges have the numbers that the next update's classifier
  // knows them by.
  template <class Frame>
  void find(const Frame& frame, const std::vector<scenario::Point>& points)
  {
    m_places.assign(frame.number_of_vertices() + 1, Place(0, 0));
    for (typename Frame::Index v = 1; v <= frame.number_of_vertices(); ++v) {
      const scenario::Point& point = points[frame.id(v)];
      m_places[v] = {point.x, point.y};
    }
    m_is_vertex_broken.assign(m_places.size(), false);
    m_broken_edges.clear();
    for (typename Frame::Index e = 0; e < frame.number_of_edges(); ++e) {
      const auto& edge = frame.edge(e);
      if (is_broken<Frame>(edge)) {
        m_broken_edges.push_back(e);
        for (const auto v : {edge.source, edge.target, edge.left, edge.right}) {
          m_is_vertex_broken[v] = true;
        }
      }
    }
    m_is_vertex_broken[0] = false; // the one at infinity
  }

  const std::vector<std::size_t>& broken_edges() const { return m_broken_edges; }
  bool is_vertex_broken(std::size_t v) const { return m_is_vertex_broken[v]; }
  std::size_t number_of_vertices() const { return m_places.size() - 1; }

private:
  using Place = run::Kernel::Point_2;

  template <class Frame>
  bool is_broken(const typename Frame::Edge& edge) const
  {
    if (Frame::is_infinite(edge.source)) {
      return breaks_hull(edge.left, edge.target, edge.right);
    }
    if (Frame::is_infinite(edge.target)) {
      return breaks_hull(edge.right, edge.source, edge.left);
    }
    const bool has_left = !Frame::is_infinite(edge.left);
    const bool has_right = !Frame::is_infinite(edge.right);
    if (has_left && turn(edge.left, edge.source, edge.target) != CGAL::LEFT_TURN) {
      return true;
    }
    if (has_right && turn(edge.right, edge.target, edge.source) != CGAL::LEFT_TURN) {
      return true;
    }
    return has_left && has_right &&
           run::Kernel().side_of_oriented_circle_2_object()(
               m_places[edge.left], m_places[edge.source], m_places[edge.target],
               m_places[edge.right]) == CGAL::ON_POSITIVE_SIDE;
  }

  // The hull's way through v.
  bool breaks_hull(std::size_t before, std::size_t v, std::size_t after) const
  {
    const CGAL::Orientation orientation = turn(before, v, after);
    return orientation == CGAL::RIGHT_TURN ||
           (orientation == CGAL::COLLINEAR &&
            !run::Kernel().collinear_are_strictly_ordered_along_line_2_object()(
                m_places[before], m_places[v], m_places[after]));
  }

  CGAL::Orientation turn(std::size_t a, std::size_t b, std::size_t c) const
  {
    return run::Kernel().orientation_2_object()(m_places[a], m_places[b], m_places[c]);
  }

  std::vector<Place> m_places; // of each vertex
  std::vector<bool> m_is_vertex_broken;
  std::vector<std::size_t> m_broken_edges;
};

} // namespace classifiers

#endif // CLASSIFIERS_CLASSIFICATION_TRUTH_H

// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SPACE_CLASSIFIERS_POINT_DISTANCE_H
#define SPACE_CLASSIFIERS_POINT_DISTANCE_H

#include <CGAL/squared_distance_2.h>
#include <CGAL/squared_distance_3.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace space_classifiers {

// The edges of a triangulation, by ids: sorted, so that those that stay are found again.
class Edge_list
{
public:
  struct Edge
  {
    std::uint32_t source, target;

    friend bool operator<(const Edge& e, const Edge& f)
    {
      return e.source != f.source ? e.source < f.source : e.target < f.target;
    }
  };
  static constexpr std::size_t is_new = std::size_t(-1);

  template <class Dynamic>
  void read(const Dynamic& dt)
  {
    m_edges.swap(m_last_edges);
    m_edges.clear();
    dt.for_each_edge([this](std::size_t i, std::size_t j) {
      m_edges.push_back({std::uint32_t((std::min)(i, j)), std::uint32_t((std::max)(i, j))});
    });
    std::sort(m_edges.begin(), m_edges.end());
    m_origins.clear();
    std::size_t last = 0;
    for (const Edge& edge : m_edges) {
      while (last != m_last_edges.size() && m_last_edges[last] < edge) {
        ++last;
      }
      const bool stays = last != m_last_edges.size() && !(edge < m_last_edges[last]);
      m_origins.push_back(stays ? last : is_new);
    }
  }

  const std::vector<Edge>& edges() const { return m_edges; }
  // Which edge it was before it was read last, or `is_new`.
  std::size_t origin(std::size_t e) const { return m_origins[e]; }

private:
  std::vector<Edge> m_edges, m_last_edges;
  std::vector<std::size_t> m_origins;
};

// What `Point_distance_classifier_2` does, in the plane and in space.
template <class Point>
class Point_distance
{
  using Points = std::vector<Point>;

public:
  explicit Point_distance(double x)
    : m_x(x)
  {
  }

  void start(const Edge_list& edges, const Points& points)
  {
    m_squared_references.clear();
    for (const Edge_list::Edge& edge : edges.edges()) {
      m_squared_references.push_back(squared_length(edge, points));
    }
  }

  // Picks both ends of edges whose lengths have left their ranges.
  void classify(const Edge_list& edges, const Points& points)
  {
    m_picks.assign(points.size(), none);
    const double lowest = m_x * m_x, highest = (2 - m_x) * (2 - m_x);
    for (std::size_t e = 0; e != edges.edges().size(); ++e) {
      const Edge_list::Edge edge = edges.edges()[e];
      const double length = squared_length(edge, points), reference = m_squared_references[e];
      if (length < lowest * reference || length > highest * reference) {
        m_picks[edge.source] = m_picks[edge.target] = picked;
      }
    }
  }

  // Drops the picks for which a function of their ids does not hold.
  template <class Predicate>
  void keep(const Predicate& is_right)
  {
    for (std::size_t id = 0; id != m_picks.size(); ++id) {
      if (m_picks[id] == picked && !is_right(id)) {
        m_picks[id] = none;
      }
    }
  }

  // One layer of neighbors around the picks.
  void pad(const Edge_list& edges)
  {
    for (const Edge_list::Edge& edge : edges.edges()) {
      unsigned char &source = m_picks[edge.source], &target = m_picks[edge.target];
      if (source == picked && target == none) {
        target = padding;
      }
      if (target == picked && source == none) {
        source = padding;
      }
    }
  }

  bool is_picked(std::size_t id) const { return m_picks[id] == picked; }
  bool is_covered(std::size_t id) const { return m_picks[id] != none; }
  std::size_t number_picked() const
  {
    return std::size_t(std::count(m_picks.begin(), m_picks.end(), picked));
  }

  // Takes new lengths where edges are new, or at picks and padding.
  void after_update(const Edge_list& edges, const Points& points)
  {
    m_last_references.swap(m_squared_references);
    m_squared_references.clear();
    for (std::size_t e = 0; e != edges.edges().size(); ++e) {
      const Edge_list::Edge edge = edges.edges()[e];
      const bool stays = edges.origin(e) != Edge_list::is_new && !is_covered(edge.source) &&
                         !is_covered(edge.target);
      m_squared_references.push_back(stays ? m_last_references[edges.origin(e)]
                                           : squared_length(edge, points));
    }
  }

private:
  static constexpr unsigned char none = 0, padding = 1, picked = 2;

  static double squared_length(const Edge_list::Edge& edge, const Points& points)
  {
    return CGAL::squared_distance(points[edge.source], points[edge.target]);
  }

  double m_x;
  std::vector<double> m_squared_references, m_last_references; // of each edge
  std::vector<unsigned char> m_picks;                          // of each vertex
};

} // namespace space_classifiers

#endif // SPACE_CLASSIFIERS_POINT_DISTANCE_H

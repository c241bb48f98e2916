// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_JUMPER_SEARCH_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_JUMPER_SEARCH_2_H

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Computed_geometry_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Index_set_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Neighborhood_mirror_2.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Dynamic_Delaunay_triangulations_2 {
namespace internal {

// Finds the vertices that jumped: each went farther, as seen from its neighbors, than its
// neighborhood reaches. A vertex that leaves its neighborhood turns a face around, so only vertices
// at edges with inverted faces are looked at. What is a jump is a matter of cost alone, so plain
// floating point decides.
template <class Maintained>
class Jumper_search_2
{
public:
  explicit Jumper_search_2(const Maintained& maintained)
    : m_maintained(maintained)
  {
  }

  // Among the vertices of these edges, in the order in which they are met. Only while CGAL's
  // vertices have the points of the last frame.
  const std::vector<Index>& run(const std::vector<Index>& edges)
  {
    m_jumpers.clear();
    m_seen.clear(m_maintained.vertices.size());
    for (const Index e : edges) {
      const Edge_2& edge = m_maintained.mirror.edge(e);
      for (const Index v : {edge.source, edge.target, edge.left, edge.right})
        if (v != infinite_index && m_seen.insert(v) && has_jumped(v))
          m_jumpers.push_back(v);
    }
    return m_jumpers;
  }

private:
  // Flips take one or two for every spacing that a vertex travels, and cost a tenth of what taking
  // it out and putting it in again does; but from about this many spacings on they get stuck.
  static constexpr double longest_way = 0.75;

  bool has_jumped(Index v)
  {
    const Position_2 step = displacement(v);
    const double square = dot(step, step);
    if (!may_have_jumped(v, square))
      return false;
    collect_neighbors(v);
    if (m_squared_lengths.empty())
      return false;
    const Position_2 relative = step - Position_2{median(m_x), median(m_y)};
    return dot(relative, relative) > longest_way * longest_way * median(m_squared_lengths);
  }

  // Looks at the flat arrays alone: a vertex that jumped is far from its neighbors, or they have
  // gone with it.
  bool may_have_jumped(Index v, double squared_step) const
  {
    const auto& positions = m_maintained.positions;
    double nearest = (std::numeric_limits<double>::infinity)();
    m_maintained.mirror.for_each_neighbor(v, [&](Index w) {
      if (w != infinite_index)
        nearest = (std::min)(nearest, squared_distance(positions[v], positions[w]));
    });
    return 16 * squared_step > nearest;
  }

  // How far each went, and how far it was away a frame ago.
  void collect_neighbors(Index v)
  {
    m_x.clear();
    m_y.clear();
    m_squared_lengths.clear();
    const Position_2 place = previous_position(v);
    m_maintained.mirror.for_each_neighbor(v, [&](Index w) {
      if (w == infinite_index)
        return;
      const Position_2 step = displacement(w);
      m_x.push_back(step.x);
      m_y.push_back(step.y);
      m_squared_lengths.push_back(squared_distance(place, previous_position(w)));
    });
  }

  Position_2 previous_position(Index v) const
  {
    return Maintained::approximation(m_maintained.previous_point(v));
  }

  Position_2 displacement(Index v) const
  {
    return m_maintained.positions[v] - previous_position(v);
  }

  static double median(std::vector<double>& values)
  {
    const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
  }

  const Maintained& m_maintained;
  Index_set_2 m_seen;
  std::vector<Index> m_jumpers;
  std::vector<double> m_x, m_y, m_squared_lengths; // of the neighbors of a vertex
};

} // namespace internal
} // namespace Dynamic_Delaunay_triangulations_2
} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_JUMPER_SEARCH_2_H

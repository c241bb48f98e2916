// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_JUMPER_SEARCH_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_JUMPER_SEARCH_2_H

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Computed_geometry_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Index_set_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Neighborhood_mirror_2.h>

#include <algorithm>
#include <array>
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

  // Among the vertices of these edges, in the order in which they are met. Here and below only while
  // CGAL's vertices have the points of the last frame.
  const std::vector<Index>& find_jumpers(const std::vector<Index>& edges)
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

  // Of the vertices of each of these edges the one that went farthest, as seen from the others, but
  // only one at each edge.
  const std::vector<Index>& find_farthest(const std::vector<Index>& edges)
  {
    m_jumpers.clear();
    m_seen.clear(m_maintained.vertices.size());
    for (const Index e : edges) {
      const Edge_2& edge = m_maintained.mirror.edge(e);
      const std::array<Index, 4> vertices{edge.source, edge.target, edge.left, edge.right};
      const auto is_taken = [this](Index v) { return m_seen.contains(v); };
      if (std::any_of(vertices.begin(), vertices.end(), is_taken))
        continue;
      const Index v = farthest_of(vertices);
      if (v != no_index && m_seen.insert(v))
        m_jumpers.push_back(v);
    }
    return m_jumpers;
  }

private:
  // `no_index` if all have gone the same way.
  Index farthest_of(const std::array<Index, 4>& vertices)
  {
    m_x.clear();
    m_y.clear();
    for (const Index v : vertices)
      if (v != infinite_index) {
        const Position_2 step = displacement(v);
        m_x.push_back(step.x);
        m_y.push_back(step.y);
      }
    const Position_2 usual{median(m_x), median(m_y)};
    Index farthest = no_index;
    double longest = 0;
    for (const Index v : vertices)
      if (v != infinite_index) {
        const Position_2 relative = displacement(v) - usual;
        const double length = dot(relative, relative);
        if (length > longest) {
          longest = length;
          farthest = v;
        }
      }
    return farthest;
  }

  // Flips take one or two for every spacing that a vertex travels, and cost a tenth of what taking
  // it out and putting it in again does; but from about this many spacings on they get stuck.
  static constexpr double longest_way = 0.75;

  bool has_jumped(Index v)
  {
    const Position_2 step = displacement(v);
    if (!may_have_jumped(v, step))
      return false;
    collect_neighbors(v);
    const Position_2 relative = step - Position_2{median(m_x), median(m_y)};
    return dot(relative, relative) > longest_way * longest_way * median(m_squared_lengths);
  }

  // Reads no more than one neighbor's last position: a vertex that jumped is far from the nearest of
  // its neighbors, measured by how differently the two went; if that one jumped along with it, by
  // how far it went.
  bool may_have_jumped(Index v, const Position_2& step) const
  {
    const auto& positions = m_maintained.positions;
    double smallest = (std::numeric_limits<double>::infinity)();
    Index nearest = no_index;
    m_maintained.mirror.for_each_neighbor(v, [&](Index w) {
      const double square = squared_distance(positions[v], positions[w]); // NaN at infinity
      if (square < smallest) {
        smallest = square;
        nearest = w;
      }
    });
    if (nearest == no_index)
      return false;
    const Position_2 relative = step - displacement(nearest);
    return 16 * (std::max)(dot(step, step), dot(relative, relative)) > smallest;
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

// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_JUMPER_SEARCH_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_JUMPER_SEARCH_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Computed_geometry_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Index_set_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Neighborhood_mirror_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Prefetch_2.h>

#include <algorithm>
#include <array>
#include <cmath>
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

  // Among the vertices of these edges, in the order in which they are met. Here and below only
  // while CGAL's vertices have the points of the last frame.
  const std::vector<Index>& find_jumpers(const std::vector<Index>& edges)
  {
    m_jumpers.clear();
    m_seen.clear(m_maintained.vertices().size());
    for (std::size_t i = 0; i < edges.size(); ++i) {
      prefetch_edges(edges, i);
      look_at(m_maintained.mirror().edge(edges[i]));
    }
    return m_jumpers;
  }

  // Of the vertices of each of these edges the one that went farthest, as seen from the others, but
  // only one at each edge.
  const std::vector<Index>& find_farthest(const std::vector<Index>& edges)
  {
    m_jumpers.clear();
    m_seen.clear(m_maintained.vertices().size());
    for (const Index e : edges) {
      const Edge_2& edge = m_maintained.mirror().edge(e);
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
    const Position_2 usual{quantile(m_x, 2), quantile(m_y, 2)};
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

  // In lengths of a short edge. Flips take one or two for every spacing that a vertex travels, and
  // cost a tenth of what taking it out and putting it in again does; but from about this length on
  // they get stuck. Below 1, as a vertex that comes back from far away has gone as far as it was
  // from all its neighbors.
  static constexpr double max_way = 0.9;

  // One that went another way than each of the others, and not just a little, is looked at closely.
  // At 100,000 points what is read here is anywhere in memory, and the most of the search.
  void look_at(const Edge_2& edge)
  {
    std::array<Index, 4> vertices;
    std::array<Position_2, 4> places, steps;
    std::size_t size = 0;
    for (const Index v : {edge.source, edge.target, edge.left, edge.right})
      if (v != infinite_index) {
        vertices[size] = v;
        places[size] = previous_position(v);
        steps[size] = m_maintained.positions()[v] - places[size];
        ++size;
      }
    for (std::size_t i = 0; i < size; ++i) {
      constexpr double infinity = std::numeric_limits<double>::infinity();
      double difference = infinity, distance = infinity;
      for (std::size_t k = 0; k < size; ++k)
        if (k != i) {
          difference = (std::min)(difference, squared_distance(steps[i], steps[k]));
          distance = (std::min)(distance, squared_distance(places[i], places[k]));
        }
      if (16 * difference > distance && m_seen.insert(vertices[i]) && has_jumped(vertices[i]))
        m_jumpers.push_back(vertices[i]);
    }
  }

  bool has_jumped(Index v)
  {
    collect_neighbors(v);
    if (m_squared_lengths.empty())
      return false;
    const Position_2 step = displacement(v);
    const Position_2 relative{farthest_from_median(step.x, m_x), farthest_from_median(step.y, m_y)};
    return dot(relative, relative) > max_way * max_way * quantile(m_squared_lengths, 4);
  }

  // In steps, each of which reads what the one before has fetched.
  void prefetch_edges(const std::vector<Index>& edges, std::size_t i) const
  {
    constexpr std::size_t ahead = 4;
    if (i + 3 * ahead < edges.size())
      prefetch(&m_maintained.mirror().edge(edges[i + 3 * ahead]));
    if (i + 2 * ahead < edges.size())
      for_each_vertex(edges[i + 2 * ahead], [this](Index v) {
        prefetch(&m_maintained.vertices()[v]);
        prefetch(&m_maintained.positions()[v]);
      });
    if (i + ahead < edges.size())
      for_each_vertex(edges[i + ahead],
                      [this](Index v) { prefetch(&*m_maintained.vertices()[v]); });
  }

  template <class Function>
  void for_each_vertex(Index e, const Function& f) const
  {
    const Edge_2& edge = m_maintained.mirror().edge(e);
    for (const Index v : {edge.source, edge.target, edge.left, edge.right})
      f(v);
  }

  // How far each went, and how far it was away a frame ago.
  void collect_neighbors(Index v)
  {
    m_x.clear();
    m_y.clear();
    m_squared_lengths.clear();
    const Position_2 place = previous_position(v);
    m_maintained.mirror().for_each_neighbor(v, [&](Index w) {
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
    return approximation(m_maintained.previous_point(v));
  }

  Position_2 displacement(Index v) const
  {
    return m_maintained.positions()[v] - previous_position(v);
  }

  // How far x is from the median; from the farther one of two. Half of a vertex's neighbors may
  // have jumped along with it.
  static double farthest_from_median(double x, std::vector<double>& values)
  {
    const double upper = quantile(values, 2);
    double difference = std::abs(x - upper);
    if (values.size() % 2 == 0) {
      const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
      difference = (std::max)(difference, std::abs(x - *std::max_element(values.begin(), middle)));
    }
    return difference;
  }

  // What one in `part` of the values is smaller than.
  static double quantile(std::vector<double>& values, std::size_t part)
  {
    const auto place = values.begin() + std::ptrdiff_t(values.size() / part);
    std::nth_element(values.begin(), place, values.end());
    return *place;
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

// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_UPDATE_JUMPER_SEARCH_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_UPDATE_JUMPER_SEARCH_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/core/Flat_arrays_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/core/Points_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/core/Processor_2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

// Finds the vertices that jumped: relative to their neighbors, they moved farther than the extent
// of their neighborhood. A vertex that leaves its neighborhood inverts a face, so only vertices at
// edges with inverted faces are examined. Plain floating point decides, because a wrong decision
// affects only the cost.
template <class State>
class Jumper_search_2
{
public:
  explicit Jumper_search_2(const State& state)
    : m_state(state)
  {
  }

  // Finds jumpers among the vertices of these edges, in the order in which they are met. This and
  // all functions below need the previous positions.
  const std::vector<Index>& find_jumpers(const std::vector<Index>& edges)
  {
    collect_from_parts(edges.size(), m_suspects, [&](std::size_t i, Work& work) {
      prefetch_edges(edges, i);
      look_at(edges[i], work.found);
    });
    m_seen.clear(m_state.arrays().number_of_vertices());
    m_suspects.erase(std::remove_if(m_suspects.begin(), m_suspects.end(),
                                    [this](Vertex_index v) { return !m_seen.insert(v); }),
                     m_suspects.end());
    collect_from_parts(m_suspects.size(), m_jumpers, [&](std::size_t i, Work& work) {
      if (has_jumped(m_suspects[i], work))
        work.found.push_back(m_suspects[i]);
    });
    return m_jumpers;
  }

  // For each of these edges, finds the one of its vertices that moved farthest relative to the
  // others. Skips edges with a vertex found before, so that each edge has only one.
  const std::vector<Index>& find_farthest(const std::vector<Index>& edges)
  {
    m_jumpers.clear();
    m_seen.clear(m_state.arrays().number_of_vertices());
    for (const Edge_index e : edges) {
      const Edge_2 edge = m_state.edge(e);
      const std::array<Index, 4> vertices{edge.source, edge.target, edge.left, edge.right};
      const auto is_taken = [this](Vertex_index v) { return m_seen.contains(v); };
      if (std::any_of(vertices.begin(), vertices.end(), is_taken))
        continue;
      const Vertex_index v = farthest_of(vertices);
      if (v != null_index && m_seen.insert(v))
        m_jumpers.push_back(v);
    }
    return m_jumpers;
  }

  // Whether v has jumped, given that no other vertex has moved. False without finite neighbors.
  bool has_jumped_alone(Vertex_index v) const
  {
    const Position_2 place = m_state.previous_position(v);
    const double square = squared_distance(m_state.positions()[v], place);
    std::size_t neighbors = 0, passed = 0;
    for_each_neighbor(v, [&](Vertex_index w, const Position_2& position) {
      const double squared_length = squared_distance(place, position);
      neighbors += w != infinite_index;
      passed += square > max_way * max_way * squared_length; // false if w is infinite: NaN
    });
    return passed > neighbors / 4; // the same quartile as in has_jumped()
  }

private:
  using Parts = typename State::Parts;

  // The working memory of a part: what was found, and how the neighbors of a vertex moved.
  struct Work
  {
    std::vector<Index> found;
    std::vector<double> x, y, squared_lengths;
  };

  // Calls f(i, work) for each i below `size`, and lists what is found, in the order of i.
  template <class Function>
  void collect_from_parts(std::size_t size, std::vector<Index>& found, const Function& f)
  {
    // a call of f() takes up to a microsecond
    constexpr std::size_t least = (std::max)(Parts::usual_size / 256, std::size_t(1));
    m_works.resize((std::max)(Parts::number(size, least), m_works.size()));
    Parts::for_each(size, least, [&](std::size_t part, std::size_t first, std::size_t beyond) {
      m_works[part].found.clear();
      for (std::size_t i = first; i < beyond; ++i)
        f(i, m_works[part]);
    });
    found.clear();
    for (std::size_t part = 0; part < Parts::number(size, least); ++part)
      found.insert(found.end(), m_works[part].found.begin(), m_works[part].found.end());
  }

  // Returns the vertex that moved farthest from the median step; `null_index` if all moved alike.
  Index farthest_of(const std::array<Index, 4>& vertices)
  {
    Work& work = m_works.front();
    work.x.clear();
    work.y.clear();
    for (const Vertex_index v : vertices)
      if (v != infinite_index) {
        const Position_2 step = displacement(v);
        work.x.push_back(step.x);
        work.y.push_back(step.y);
      }
    const Position_2 usual{quantile(work.x, 2), quantile(work.y, 2)};
    Index farthest = null_index;
    double longest = 0;
    for (const Vertex_index v : vertices)
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

  // The longest way that is no jump, in units of a short edge. Shorter ways take one or two flips
  // per spacing, each at a tenth of the cost of taking the vertex out and putting it in again, but
  // from about this length on flips get stuck. The limit is below 1, because a vertex that returns
  // from far away goes about as far as its distance from each of its neighbors.
  static constexpr double max_way = 0.9;

  // Appends each vertex of e whose step differs from all other steps by more than a quarter of its
  // least distance. At 100,000 points, reading these scattered data takes most of the search.
  void look_at(Edge_index e, std::vector<Index>& suspects) const
  {
    std::array<Index, 4> vertices;
    std::array<Position_2, 4> places, steps;
    std::size_t size = 0;
    const auto add = [&](Vertex_index v, const Position_2& position) {
      if (v == infinite_index)
        return;
      vertices[size] = v;
      places[size] = m_state.previous_position_at(v, position);
      steps[size] = position - places[size];
      ++size;
    };
    const Edge_2 edge = m_state.edge(e);
    const Edge_corners_2 corners = m_state.corners(e);
    add(edge.source, corners.source);
    add(edge.target, corners.target);
    add(edge.left, corners.left);
    add(edge.right, corners.right);
    for (std::size_t i = 0; i < size; ++i) {
      constexpr double infinity = std::numeric_limits<double>::infinity();
      double difference = infinity, distance = infinity;
      for (std::size_t k = 0; k < size; ++k)
        if (k != i)
          difference = (std::min)(difference, squared_distance(steps[i], steps[k]));
      if (difference == 0)
        continue;
      for (std::size_t k = 0; k < size; ++k)
        if (k != i)
          distance = (std::min)(distance, squared_distance(places[i], places[k]));
      if (16 * difference > distance)
        suspects.push_back(vertices[i]);
    }
  }

  bool has_jumped(Vertex_index v, Work& work) const
  {
    collect_neighbors(v, work);
    if (work.squared_lengths.empty())
      return false;
    const Position_2 step = displacement(v);
    const Position_2 relative{farthest_from_median(step.x, work.x),
                              farthest_from_median(step.y, work.y)};
    return dot(relative, relative) > max_way * max_way * quantile(work.squared_lengths, 4);
  }

  // Prefetches in steps, each of which reads what the one before has fetched.
  void prefetch_edges(const std::vector<Index>& edges, std::size_t i) const
  {
    constexpr std::size_t ahead = 4;
    if (i + 2 * ahead < edges.size())
      prefetch(&m_state.arrays().edge(edges[i + 2 * ahead]));
    if (i + ahead < edges.size())
      for_each_vertex(edges[i + ahead], [this](Vertex_index v) { m_state.prefetch_positions(v); });
  }

  template <class Function>
  void for_each_vertex(Edge_index e, const Function& f) const
  {
    const Edge_2& edge = m_state.arrays().edge(e);
    for (const Vertex_index v : {edge.source, edge.target, edge.left, edge.right})
      f(v);
  }

  // Calls f(w, position) for every neighbor w of v, with its position as seen from v.
  template <class Function>
  void for_each_neighbor(Vertex_index v, const Function& f) const
  {
    using Arrays = Halfedge_arrays_2;
    m_state.arrays().for_each_corner(v, [&](Halfedge_index h) {
      const auto corner = m_state.corner_in(Arrays::next(h), m_state.frame_at(h));
      f(State::vertex_of(corner), m_state.rounded_position(corner));
    });
  }

  // Collects how far each neighbor moved, and its distance from v in the last frame.
  void collect_neighbors(Vertex_index v, Work& work) const
  {
    work.x.clear();
    work.y.clear();
    work.squared_lengths.clear();
    const Position_2 place = m_state.previous_position(v);
    for_each_neighbor(v, [&](Vertex_index w, const Position_2& position) {
      if (w == infinite_index)
        return;
      const Position_2 step = displacement(w);
      work.x.push_back(step.x);
      work.y.push_back(step.y);
      work.squared_lengths.push_back(
          squared_distance(place, m_state.previous_position_at(w, position)));
    });
  }

  Position_2 displacement(Vertex_index v) const
  {
    return m_state.positions()[v] - m_state.previous_position(v);
  }

  // The distance of x from the median; if there are two medians, from the farther one, because half
  // of a vertex's neighbors may have jumped along with it.
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

  const State& m_state;
  Index_set_2 m_seen;
  std::vector<Index> m_suspects, m_jumpers;
  std::vector<Work> m_works = std::vector<Work>(1);
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_UPDATE_JUMPER_SEARCH_2_H

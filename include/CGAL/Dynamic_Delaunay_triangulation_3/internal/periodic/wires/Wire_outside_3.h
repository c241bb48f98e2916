// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_PERIODIC_WIRES_WIRE_OUTSIDE_3_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_PERIODIC_WIRES_WIRE_OUTSIDE_3_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/passes/Elements_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/passes/Points_3.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_3::internal {

// Finds the outermost vertices of a wire, as rounded positions tell: where that is wrong, a rebuild
// takes longer.
template <class State>
class Wire_outside_3
{
public:
  explicit Wire_outside_3(const State& state)
    : m_state(state)
  {
  }

  // Brings the vertices of the hull to the front of a list, and about half of a number of others:
  // those that are farthest out in some directions. Returns how many.
  std::size_t bring_to_front(std::vector<Vertex_index>& order, std::size_t number) const
  {
    if (number >= order.size())
      return order.size();
    std::vector<Seen> seen;
    for (const Vertex_index v : order)
      seen.push_back(seen_along_wire(v));
    Column<Vertex_index, char> is_outside(m_state.positions.number(), 0);
    mark_hull(seen, is_outside);
    for (int i = 0; i < directions; ++i) {
      const double angle = (i + 0.5) * 6.283185307179586 / directions;
      mark_farthest(seen, std::cos(angle), std::sin(angle), number / (2 * directions), is_outside);
    }
    const auto inside = std::stable_partition(order.begin(), order.end(),
                                              [&](Vertex_index v) { return is_outside[v] != 0; });
    return std::size_t(inside - order.begin());
  }

private:
  static constexpr int directions = 16;

  // A vertex as it is seen along the wire.
  struct Seen
  {
    double x, y;
    Vertex_index vertex;
  };

  Seen seen_along_wire(Vertex_index v) const
  {
    const Position_3& p = m_state.positions.position(v);
    const auto along = [&p](const Position_3& w) { return w.x * p.x + w.y * p.y + w.z * p.z; };
    return {along(m_state.torus.vector(1)), along(m_state.torus.vector(2)), v};
  }

  // By Andrew's monotone chain.
  static void mark_hull(std::vector<Seen>& seen, Column<Vertex_index, char>& is_outside)
  {
    std::sort(seen.begin(), seen.end(),
              [](const Seen& p, const Seen& q) { return p.x != q.x ? p.x < q.x : p.y < q.y; });
    mark_chain(seen.begin(), seen.end(), is_outside);
    mark_chain(seen.rbegin(), seen.rend(), is_outside);
  }
  template <class Iterator>
  static void mark_chain(Iterator first, Iterator beyond, Column<Vertex_index, char>& is_outside)
  {
    const auto turns_left = [](const Seen& p, const Seen& q, const Seen& r) {
      return (q.x - p.x) * (r.y - p.y) > (q.y - p.y) * (r.x - p.x);
    };
    std::vector<Seen> chain;
    for (auto i = first; i != beyond; ++i) {
      while (chain.size() >= 2 && !turns_left(chain[chain.size() - 2], chain.back(), *i))
        chain.pop_back();
      chain.push_back(*i);
    }
    for (const Seen& s : chain)
      is_outside[s.vertex] = 1;
  }

  static void mark_farthest(std::vector<Seen>& seen, double x, double y, std::size_t number,
                            Column<Vertex_index, char>& is_outside)
  {
    const auto middle = seen.begin() + std::ptrdiff_t(number);
    std::nth_element(seen.begin(), middle, seen.end(), [=](const Seen& p, const Seen& q) {
      return x * p.x + y * p.y > x * q.x + y * q.y;
    });
    for (auto i = seen.begin(); i != middle; ++i)
      is_outside[i->vertex] = 1;
  }

  const State& m_state;
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_3::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_PERIODIC_WIRES_WIRE_OUTSIDE_3_H

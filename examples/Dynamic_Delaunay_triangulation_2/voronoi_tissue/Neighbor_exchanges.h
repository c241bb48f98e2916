// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef VORONOI_TISSUE_NEIGHBOR_EXCHANGES_H
#define VORONOI_TISSUE_NEIGHBOR_EXCHANGES_H

#include <CGAL/Periodic_cell_2.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <tuple>
#include <vector>

namespace tissue {

// Counts T1 events: two cells part, and two others become neighbors between them. An edge of the
// triangulation is known by two ids and a shift. That name lasts as long as the edge only if points
// stay unwrapped: wrapping one renames the shifts of all its edges.
class Neighbor_exchanges
{
  using Shift = CGAL::Periodic_shift_2;
  using Edge = std::tuple<std::size_t, std::size_t, Shift>;

public:
  template <class Dynamic>
  explicit Neighbor_exchanges(const Dynamic& dt)
  {
    read(dt);
  }

  // The number of edges that were not there when this was called last.
  template <class Dynamic>
  std::size_t count(const Dynamic& dt)
  {
    m_before.swap(m_edges);
    read(dt);
    m_new.clear();
    std::set_difference(m_edges.begin(), m_edges.end(), m_before.begin(), m_before.end(),
                        std::back_inserter(m_new));
    return m_new.size();
  }

private:
  template <class Dynamic>
  void read(const Dynamic& dt)
  {
    m_edges.clear();
    dt.for_each_edge([&](std::size_t i, std::size_t j, const Shift& shift) {
      m_edges.push_back((std::min)(Edge(i, j, shift), Edge(j, i, Shift{-shift[0], -shift[1]})));
    });
    std::sort(m_edges.begin(), m_edges.end());
  }

  std::vector<Edge> m_edges, m_before, m_new;
};

} // namespace tissue

#endif // VORONOI_TISSUE_NEIGHBOR_EXCHANGES_H

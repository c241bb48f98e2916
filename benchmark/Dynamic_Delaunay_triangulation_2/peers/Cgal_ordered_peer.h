// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PEERS_CGAL_ORDERED_PEER_H
#define PEERS_CGAL_ORDERED_PEER_H

#include "../speed/Insertion_in_rounds.h"
#include "Grid_points.h"
#include "Peer.h"
#include "Peer_output.h"
#include "scenario_runner/Measurement.h"
#include "scenario_runner/Static_triangulation.h"

#include <CGAL/hilbert_sort.h>

#include <cstddef>
#include <optional>
#include <vector>

namespace peers {

// CGAL's insertion one by one, each point located from the last one: in rounds along a Hilbert
// curve (every 8^k-th point first), the fastest that we know with CGAL's own means. The order is
// the last frame's, so sorting is outside of the clock. Of fresh clouds the last order is worth
// nothing: `sorts` has it sort, by halving boxes, while the clock runs.
class Cgal_ordered_peer : public Peer
{
public:
  explicit Cgal_ordered_peer(bool sorts)
    : Peer("CGAL insert in order", Promise::EXACT)
    , m_sorts(sorts)
  {
  }

  void start(const Grid_points& frame) override
  {
    scenario::find_spatial_order(frame.points, m_order);
  }

  void prepare(const Grid_points& frame) override
  {
    m_triangulation.reset();
    m_points.clear();
    for (const std::size_t id : m_order) {
      m_points.push_back(frame.points[id]);
    }
    if (!m_sorts) {
      scenario::find_spatial_order(frame.points, m_order); // for the next frame
    }
  }

  double triangulate() override
  {
    return run::nanoseconds_of([this] {
      if (m_sorts) {
        CGAL::hilbert_sort(m_points.begin(), m_points.end(), CGAL::Hilbert_sort_middle_policy());
      }
      speed::insert_in_rounds(m_points, m_triangulation.emplace());
    });
  }

  void write(Peer_output& output) const override { output.add(*m_triangulation); }

private:
  bool m_sorts;
  std::vector<std::size_t> m_order;
  Points m_points;
  std::optional<run::Static_triangulation> m_triangulation;
};

} // namespace peers

#endif // PEERS_CGAL_ORDERED_PEER_H

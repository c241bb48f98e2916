// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PEERS_CGAL_INSERTION_PEER_H
#define PEERS_CGAL_INSERTION_PEER_H

#include "Peer.h"
#include "scenario_runner/Measurement.h"

#include <optional>

namespace peers {

// CGAL's insertion of a range of points, what a user writes. It sorts them in space first, and that
// is timed, as it is its work.
class Cgal_insertion_peer : public Peer
{
public:
  Cgal_insertion_peer()
    : Peer("CGAL insert(range)", Promise::EXACT)
  {
  }

  void prepare(const Grid_points& frame) override
  {
    m_triangulation.reset();
    m_points = frame.points;
  }

  double triangulate() override
  {
    return run::nanoseconds_of(
        [this] { m_triangulation.emplace().insert(m_points.begin(), m_points.end()); });
  }

  void write(Peer_output& output) const override { output.add(*m_triangulation); }

private:
  Points m_points;
  std::optional<run::Static_triangulation> m_triangulation;
};

} // namespace peers

#endif // PEERS_CGAL_INSERTION_PEER_H

// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PEERS_DYNAMIC_PEER_H
#define PEERS_DYNAMIC_PEER_H

#include "Peer.h"
#include "scenario_runner/Measurement.h"

#include <CGAL/Dynamic_Delaunay_triangulation_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/classifiers/Point_distance_classifier_2.h>

#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

namespace peers {

// This package: update() from the last frame's triangulation to the next one. All that it does is
// timed: reading and checking the points, and with an exact classifier the proof, too.
template <class Dynamic>
class Dynamic_peer : public Peer
{
  static constexpr bool is_exact = Dynamic::Delaunay_classifier::is_exact;

public:
  explicit Dynamic_peer(std::string name)
    : Peer(std::move(name), is_exact ? Promise::EXACT : Promise::HEURISTIC)
  {
  }

  void start(const Grid_points& frame) override
  {
    m_triangulation.emplace(frame.points.begin(), frame.points.end());
  }

  void prepare(const Grid_points& frame) override { m_points = frame.points; }

  double triangulate() override
  {
    return run::nanoseconds_of(
        [this] { m_triangulation->update(m_points.begin(), m_points.end()); });
  }

  void write(Peer_output& output) const override
  {
    m_triangulation->for_each_edge([&](std::size_t i, std::size_t j) { output.add_edge(i, j); });
    if (m_triangulation->is_certified()) {
      output.add_faces(m_triangulation->triangulation().number_of_faces());
    } else if (is_exact) {
      throw std::runtime_error(name() + ": not certified");
    }
  }

private:
  Points m_points;
  std::optional<Dynamic> m_triangulation;
};

// The default: the circumcircle classifier with flips and splices.
using Exact_peer = Dynamic_peer<CGAL::Dynamic_Delaunay_triangulation_2<run::Kernel>>;

// The heuristic of the thesis: point distance, 0.7, with the border splice.
using Heuristic_peer = Dynamic_peer<
    CGAL::Dynamic_Delaunay_triangulation_2<run::Kernel, CGAL::Point_distance_classifier_2>>;

} // namespace peers

#endif // PEERS_DYNAMIC_PEER_H

// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PEERS_QHULL_PEER_H
#define PEERS_QHULL_PEER_H

#include "Peer.h"
#include "scenario_runner/Measurement.h"

extern "C" {
#include <libqhull_r/libqhull_r.h>
}

#include <cstddef>
#include <cstdio>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace peers {

// Qhull, through its reentrant library, as the system has compiled it. It lifts the points onto a
// paraboloid and makes its convex hull, whose facets have their neighbors; all of that is timed.
//   d        Delaunay triangulation
//   Qbb      scales the lifted coordinate: without, it is wrong, and slower too
//   Qt       triangulates facets that it has merged for want of precision
//   Q5 Q12   leaves out outer planes, which are not read, and lets wide facets pass
//   Pp       no warnings
// Without merging (Q0) it is an eighth faster, and promises nothing.
class Qhull_peer : public Peer
{
public:
  Qhull_peer()
    : Peer("Qhull", Promise::ROUNDED)
    , m_messages(std::tmpfile(), &std::fclose)
  {
    if (!m_messages) {
      throw std::runtime_error("Qhull has nowhere to write its messages to");
    }
  }
  ~Qhull_peer() override { clear(); }

  void prepare(const Grid_points& frame) override
  {
    clear();
    m_coordinates.clear();
    for (const Point& point : frame.points) {
      m_coordinates.push_back(point.x());
      m_coordinates.push_back(point.y());
    }
    qh_zero(&m_qhull, m_messages.get());
    m_is_there = true;
  }

  double triangulate() override
  {
    std::string options = "qhull d Qbb Qt Q5 Q12 Pp";
    return run::nanoseconds_of([&] {
      const auto points = static_cast<int>(m_coordinates.size() / dimension);
      const int error = qh_new_qhull(&m_qhull, dimension, points, m_coordinates.data(), False,
                                     options.data(), nullptr, m_messages.get());
      m_has_failed = error != 0;
    });
  }

  // Nothing, if it has failed.
  void write(Peer_output& output) const override
  {
    if (m_has_failed) {
      return;
    }
    for (const facetT* facet = m_qhull.facet_list; facet && facet->next; facet = facet->next) {
      if (!facet->upperdelaunay) {
        output.add_face(id(*facet, 0), id(*facet, 1), id(*facet, 2));
      }
    }
  }

private:
  static constexpr int dimension = 2;

  std::size_t id(const facetT& facet, int corner) const
  {
    const auto* const vertex = static_cast<const vertexT*>(facet.vertices->e[corner].p);
    return static_cast<std::size_t>(qh_pointid(&m_qhull, vertex->point));
  }

  void clear()
  {
    if (m_is_there) {
      int ignored_number = 0, ignored_size = 0;
      qh_freeqhull(&m_qhull, !qh_ALL);
      qh_memfreeshort(&m_qhull, &ignored_number, &ignored_size);
    }
    m_is_there = false;
  }

  std::unique_ptr<std::FILE, int (*)(std::FILE*)> m_messages;
  std::vector<coordT> m_coordinates;
  mutable qhT m_qhull; // its functions know no const
  bool m_is_there = false;
  bool m_has_failed = false;
};

} // namespace peers

#endif // PEERS_QHULL_PEER_H

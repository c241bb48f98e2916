// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PEERS_DELAUNATOR_PEER_H
#define PEERS_DELAUNATOR_PEER_H

#include "Child_process.h"
#include "Peer.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace peers {

// Delaunator, in one process of Node.js for the whole run, so that it is compiled and warm. That
// process writes the points into the array that the Delaunator object has had all the time, and
// times update() alone; pipes and conversions are outside of the clock.
class Delaunator_peer : public Peer
{
public:
  // \throws std::runtime_error if node or the package is not there.
  Delaunator_peer()
    : Peer("delaunator update()", Promise::ROUNDED)
    , m_process({"node", DELAUNATOR_WORKER})
    , m_versions(m_process.read_line())
  {
  }

  const std::string& versions() const { return m_versions; }

  void prepare(const Grid_points& frame) override
  {
    m_coordinates.clear();
    for (const Point& point : frame.points) {
      m_coordinates.push_back(point.x());
      m_coordinates.push_back(point.y());
    }
  }

  double triangulate() override
  {
    const auto size = static_cast<double>(m_coordinates.size());
    m_process.write(&size, sizeof(size));
    m_process.write(m_coordinates.data(), m_coordinates.size() * sizeof(double));
    std::array<double, 2> answer; // nanoseconds, and the number of corners
    m_process.read(answer.data(), sizeof(answer));
    m_corners.resize(static_cast<std::size_t>(answer[1]));
    m_process.read(m_corners.data(), m_corners.size() * sizeof(std::uint32_t));
    return answer[0];
  }

  void write(Peer_output& output) const override
  {
    for (std::size_t i = 0; i + 2 < m_corners.size(); i += 3) {
      output.add_face(m_corners[i], m_corners[i + 1], m_corners[i + 2]);
    }
  }

private:
  Child_process m_process;
  std::string m_versions;
  std::vector<double> m_coordinates;
  std::vector<std::uint32_t> m_corners; // three of each triangle
};

} // namespace peers

#endif // PEERS_DELAUNATOR_PEER_H

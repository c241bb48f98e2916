// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PEERS_PEER_H
#define PEERS_PEER_H

#include "Peer_output.h"

#include <string>
#include <utility>

namespace peers {

// What a peer says of its result. A difference is an error if it is EXACT; it is counted if it
// rounds; it is expected if it is HEURISTIC.
enum class Promise { EXACT, ROUNDED, HEURISTIC };

// What makes a Delaunay triangulation of every frame: from points in the form in which it
// takes them, to all edges or faces with their adjacency. Only that is timed, by triangulate().
//
// Outside of the clock are: writing the points into arrays of the peer's own, just before, so that
// all find them equally warm; destroying what the frame before has left; whatever a peer
// may know of the last frame; and reading the result.
class Peer
{
public:
  Peer(std::string name, Promise promise)
    : m_name(std::move(name))
    , m_promise(promise)
  {
  }
  Peer(const Peer&) = delete;
  Peer& operator=(const Peer&) = delete;
  virtual ~Peer() = default;

  const std::string& name() const { return m_name; }
  Promise promise() const { return m_promise; }

  // A new motion, at its first frame, which is not timed.
  virtual void start(const Grid_points&) {}

  virtual void prepare(const Grid_points& frame) = 0;

  // Returns nanoseconds.
  virtual double triangulate() = 0;

  virtual void write(Peer_output& output) const = 0;

private:
  std::string m_name;
  Promise m_promise;
};

} // namespace peers

#endif // PEERS_PEER_H

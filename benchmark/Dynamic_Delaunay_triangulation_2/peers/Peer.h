// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PEERS_PEER_H
#define PEERS_PEER_H

#include "Peer_output.h"

#include <string>
#include <utility>

namespace peers {

// What a peer promises of its result. A difference is an error if the peer is EXACT, counted if it
// rounds, and expected if it is HEURISTIC.
enum class Promise { EXACT, ROUNDED, HEURISTIC };

// Makes a Delaunay triangulation of every frame. triangulate() times the way from points, in the
// form in which the peer takes them, to all edges or faces with their adjacency.
//
// Not timed are: writing the points into arrays of the peer, which happens just before, so that
// all peers find them equally warm in caches; destroying what the frame before has left;
// preparations from the last frame; and reading the result.
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

  // Begins a new motion at its first frame, which is not timed.
  virtual void start(const Grid_points&) {}

  virtual void prepare(const Grid_points& frame) = 0;

  // Triangulates the prepared points, and returns the nanoseconds that it took.
  virtual double triangulate() = 0;

  virtual void write(Peer_output& output) const = 0;

private:
  std::string m_name;
  Promise m_promise;
};

} // namespace peers

#endif // PEERS_PEER_H

// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PEERS_CGAL_PEER_H
#define PEERS_CGAL_PEER_H

#include "../common/Fastest_static.h"
#include "Peer.h"
#include "scenario_runner/Measurement.h"
#include "scenario_runner/Static_triangulation.h"

#include <cstddef>
#include <map>
#include <optional>
#include <stdexcept>
#include <vector>

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

// CGAL's insertion one by one, each point located from the last one: in rounds along a Hilbert
// curve (every 8^k-th point first), the fastest that we know with CGAL's own means. The order is
// that of the last frame, so sorting is outside of the clock. For fresh clouds the last order is
// useless: with `sorts` points are sorted, by halving boxes, while the clock runs.
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
        common::sort_along_curve(m_points);
      }
      common::insert_in_rounds(m_points, m_triangulation.emplace());
    });
  }

  void write(Peer_output& output) const override { output.add(*m_triangulation); }

private:
  bool m_sorts;
  std::vector<std::size_t> m_order;
  Points m_points;
  std::optional<run::Static_triangulation> m_triangulation;
};

// CGAL's own way to move points: move_if_no_collision() of every vertex, beginning with the last
// frame's triangulation. It goes through the vertices along the last frame's Hilbert curve, which
// is kinder to its caches than the order of the ids; the sorting is outside of the clock.
class Cgal_move_peer : public Peer
{
public:
  Cgal_move_peer()
    : Peer("CGAL move", Promise::EXACT)
  {
  }

  void start(const Grid_points& frame) override
  {
    m_triangulation.emplace(frame.points.begin(), frame.points.end());
    std::map<Point, Vertex_handle> vertex_at;
    for (const auto v : m_triangulation->finite_vertex_handles()) {
      vertex_at[v->point()] = v;
    }
    m_vertices.clear();
    for (const Point& point : frame.points) {
      m_vertices.push_back(vertex_at.at(point));
    }
    scenario::find_spatial_order(frame.points, m_order);
  }

  void prepare(const Grid_points& frame) override
  {
    m_moves.clear();
    for (const std::size_t id : m_order) {
      m_moves.push_back({m_vertices[id], frame.points[id]});
    }
    scenario::find_spatial_order(frame.points, m_order); // for the next frame
  }

  double triangulate() override
  {
    bool collides = false;
    const double time = run::nanoseconds_of([&] {
      for (const Move& move : m_moves) {
        collides |= m_triangulation->move_if_no_collision(move.vertex, move.target) != move.vertex;
      }
    });
    if (collides) {
      throw std::runtime_error("CGAL move: a point moves to where another one still is");
    }
    return time;
  }

  void write(Peer_output& output) const override { output.add(*m_triangulation); }

private:
  using Vertex_handle = run::Static_triangulation::Vertex_handle;

  struct Move
  {
    Vertex_handle vertex;
    Point target;
  };

  std::optional<run::Static_triangulation> m_triangulation;
  std::vector<Vertex_handle> m_vertices; // of each id
  std::vector<std::size_t> m_order;
  std::vector<Move> m_moves;
};

} // namespace peers

#endif // PEERS_CGAL_PEER_H

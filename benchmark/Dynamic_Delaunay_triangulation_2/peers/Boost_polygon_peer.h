// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PEERS_BOOST_POLYGON_PEER_H
#define PEERS_BOOST_POLYGON_PEER_H

#include "Peer.h"
#include "scenario_runner/Measurement.h"

#include <boost/polygon/voronoi_builder.hpp>
#include <boost/polygon/voronoi_diagram.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace peers {

// Boost.Polygon's Voronoi diagram: its edges, walked around cells and vertices, are the Delaunay
// triangulation's adjacency, so nothing more is timed. Builder and diagram keep their memory from
// frame to frame, and are emptied outside of the clock.
class Boost_polygon_peer : public Peer
{
public:
  Boost_polygon_peer()
    : Peer("Boost.Polygon Voronoi", Promise::ROUNDED)
  {
  }

  void prepare(const Grid_points& frame) override
  {
    m_builder.clear();
    m_diagram.clear();
    m_points = frame.integers;
  }

  double triangulate() override
  {
    return run::nanoseconds_of([this] {
      for (const Grid_point& point : m_points) {
        m_builder.insert_point(point.x, point.y);
      }
      m_builder.construct(&m_diagram);
    });
  }

  // Where more than three cells meet in a vertex there is a polygon of Delaunay edges. If its
  // corners are cocircular, any triangulation will do: here all diagonals from one corner. They
  // need not be, as Boost.Polygon merges vertices that are nearer to each other than rounding.
  void write(Peer_output& output) const override
  {
    for (const auto& edge : m_diagram.edges()) {
      if (id(edge) < id(*edge.twin())) {
        output.add_edge(id(edge), id(*edge.twin()));
      }
    }
    for (const auto& vertex : m_diagram.vertices()) {
      add_diagonals(vertex, output);
    }
  }

private:
  using Diagram = boost::polygon::voronoi_diagram<double>;

  static std::size_t id(const Diagram::edge_type& edge) { return edge.cell()->source_index(); }

  static void add_diagonals(const Diagram::vertex_type& vertex, Peer_output& output)
  {
    const auto* const first = vertex.incident_edge();
    std::size_t corners = 0;
    const auto* edge = first;
    do {
      if (++corners > 3) {
        output.add_edge(id(*first), id(*edge->rot_prev()));
      }
      edge = edge->rot_next();
    } while (edge != first);
    output.add_faces(corners - 2);
  }

  std::vector<Grid_point> m_points;
  boost::polygon::voronoi_builder<std::int32_t> m_builder;
  Diagram m_diagram;
};

} // namespace peers

#endif // PEERS_BOOST_POLYGON_PEER_H

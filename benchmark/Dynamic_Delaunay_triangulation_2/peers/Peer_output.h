// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PEERS_PEER_OUTPUT_H
#define PEERS_PEER_OUTPUT_H

#include "scenario_runner/Static_triangulation.h"

#include <CGAL/Dynamic_Delaunay_triangulation_2/queries/delaunay_agreement.h>
#include <CGAL/Unique_hash_map.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

namespace peers {

using Point = run::Kernel::Point_2;
using Points = std::vector<Point>;

struct Grid_point
{
  std::int32_t x;
  std::int32_t y;
};

// The points of a frame, as integers and as doubles.
struct Grid_points
{
  std::vector<Grid_point> integers;
  Points points;
};

// The Delaunay triangulation of a frame, proved by exact predicates, and how far others agree with
// it. Ties are no errors: any chord of a cluster of cocircular points is a Delaunay edge.
class Frame_truth
{
  using Reference = CGAL::Dynamic_Delaunay_triangulations_2::internal::Delaunay_reference_2<
      run::Static_triangulation>;

public:
  using Place = Reference::Site;
  using Edge = Reference::Edge; // two places

  explicit Frame_truth(const Points& points)
    : m_triangulation(proved(points))
    , m_reference(m_triangulation)
  {
    for (const Point& point : points) {
      m_place_of_id.push_back(m_reference.site(point));
    }
  }
  Frame_truth(const Frame_truth&) = delete;
  Frame_truth& operator=(const Frame_truth&) = delete;

  Place place(std::size_t id) const { return m_place_of_id.at(id); }
  Place place(const Point& point) const { return m_reference.site(point); }
  static Edge edge(const Place& p, const Place& q) { return Reference::edge(p, q); }
  std::size_t number_of_faces() const { return m_triangulation.number_of_faces(); }

  CGAL::Delaunay_agreement compare(std::vector<Edge> edges) const
  {
    const auto [right, wrong, missing, places] = m_reference.compare(std::move(edges));
    return {right, wrong, missing, places};
  }

private:
  static run::Static_triangulation proved(const Points& points)
  {
    run::Static_triangulation triangulation(points.begin(), points.end());
    if (triangulation.number_of_vertices() != points.size()) {
      throw std::runtime_error("points coincide on the grid");
    }
    if (!triangulation.is_valid()) {
      throw std::runtime_error("the reference is not Delaunay");
    }
    return triangulation;
  }

  run::Static_triangulation m_triangulation;
  Reference m_reference;
  std::vector<Place> m_place_of_id;
};

// Takes the result of a peer for a frame, in any form, and compares it with the truth.
class Peer_output
{
public:
  struct Verdict
  {
    CGAL::Delaunay_agreement agreement;
    bool is_equal;
  };

  explicit Peer_output(const Frame_truth& truth)
    : m_truth(truth)
  {
  }

  void add_edge(std::size_t id, std::size_t other_id)
  {
    add_places(m_truth.place(id), m_truth.place(other_id));
  }

  void add_face(std::size_t a, std::size_t b, std::size_t c)
  {
    add_edge(a, b);
    add_edge(b, c);
    add_edge(c, a);
    add_faces(1);
  }

  // Peers that have faces must have the right number of them.
  void add_faces(std::size_t number) { m_faces = m_faces.value_or(0) + number; }

  template <class Triangulation>
  void add(const Triangulation& triangulation)
  {
    CGAL::Unique_hash_map<typename Triangulation::Vertex_handle, Frame_truth::Place> place_of;
    for (const auto v : triangulation.finite_vertex_handles()) {
      place_of[v] = m_truth.place(v->point());
    }
    for (const auto& edge : triangulation.finite_edges()) {
      add_places(place_of[edge.first->vertex(triangulation.cw(edge.second))],
                 place_of[edge.first->vertex(triangulation.ccw(edge.second))]);
    }
    add_faces(triangulation.number_of_faces());
  }

  Verdict verdict()
  {
    const CGAL::Delaunay_agreement agreement = m_truth.compare(std::move(m_edges));
    const bool has_right_faces =
        m_faces.value_or(m_truth.number_of_faces()) == m_truth.number_of_faces();
    return {agreement, agreement.is_perfect() && has_right_faces};
  }

private:
  void add_places(const Frame_truth::Place& p, const Frame_truth::Place& q)
  {
    m_edges.push_back(Frame_truth::edge(p, q));
  }

  const Frame_truth& m_truth;
  std::vector<Frame_truth::Edge> m_edges;
  std::optional<std::size_t> m_faces;
};

} // namespace peers

#endif // PEERS_PEER_OUTPUT_H

// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PEERS_FRAME_TRUTH_H
#define PEERS_FRAME_TRUTH_H

#include "Grid_points.h"

#include <CGAL/delaunay_agreement.h>

#include <cstddef>
#include <stdexcept>
#include <utility>
#include <vector>

namespace peers {

// The Delaunay triangulation of a frame, proved by exact predicates, and how far others agree with
// it. Ties are no errors: any chord of a cluster of cocircular points is a Delaunay edge.
class Frame_truth
{
  using Reference = CGAL::Dynamic_Delaunay_triangulations_2::internal::Delaunay_reference_2<
      run::Static_triangulation>;

public:
  using Edge = Reference::Edge; // two places

  explicit Frame_truth(const Points& points)
    : m_triangulation(proved(points))
    , m_reference(m_triangulation)
  {
    for (const Point& point : points) {
      m_place_of_id.push_back(m_reference.place(point));
    }
  }
  Frame_truth(const Frame_truth&) = delete;
  Frame_truth& operator=(const Frame_truth&) = delete;

  std::size_t place(std::size_t id) const { return m_place_of_id.at(id); }
  std::size_t place(const Point& point) const { return m_reference.place(point); }
  std::size_t number_of_faces() const { return m_triangulation.number_of_faces(); }

  CGAL::Delaunay_agreement compare(std::vector<Edge> edges) const
  {
    return m_reference.compare(std::move(edges));
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
  std::vector<std::size_t> m_place_of_id;
};

} // namespace peers

#endif // PEERS_FRAME_TRUTH_H

// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SPACE_CLASSIFIERS_BROKEN_VERTICES_2_H
#define SPACE_CLASSIFIERS_BROKEN_VERTICES_2_H

#include "../classifiers/Confusion.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace space_classifiers {

// The same in the plane: the vertices of both faces at edges that are not Delaunay.
class Broken_vertices_2
{
public:
  template <class Dynamic, class Point>
  void find(const Dynamic& dt, const std::vector<Point>& points)
  {
    std::vector<scenario::Point> places;
    for (const Point& p : points) {
      places.push_back({p.x(), p.y()});
    }
    const auto& frame = dt.frame();
    m_truth.find(frame, places);
    m_is_broken.assign(points.size(), false);
    for (typename Dynamic::Frame::Vertex_index v(1); v <= frame.number_of_vertices(); ++v) {
      m_is_broken[frame.id(v)] = m_truth.is_vertex_broken(v);
    }
  }

  bool is_broken(std::size_t id) const { return m_is_broken[id]; }
  std::size_t number() const
  {
    return std::size_t(std::count(m_is_broken.begin(), m_is_broken.end(), true));
  }

private:
  classifiers::Classification_truth m_truth;
  std::vector<bool> m_is_broken;
};

} // namespace space_classifiers

#endif // SPACE_CLASSIFIERS_BROKEN_VERTICES_2_H

// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_FINITE_NEIGHBORS_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_FINITE_NEIGHBORS_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Neighborhood_mirror_2.h>

namespace CGAL {
namespace Dynamic_Delaunay_triangulations_2 {
namespace internal {

// Who is around a vertex, counterclockwise, also where the points do not span the plane: there are
// no flat arrays then, and CGAL's structure knows.
template <class Dynamic>
class Finite_neighbors_2
{
public:
  explicit Finite_neighbors_2(const Dynamic& dt)
    : m_dt(dt)
    , m_frame(dt.frame())
    , m_dimension(dt.tds().dimension())
  {
  }

  // Calls f(w) for every finite neighbor w of the finite vertex v.
  template <class Function>
  void for_each(Index v, Function&& f) const
  {
    const auto call_if_finite = [&](Index w) {
      if (!m_frame.is_infinite(w))
        f(w);
    };
    if (m_dimension == 2)
      m_frame.for_each_neighbor(v, call_if_finite);
    else if (m_dimension == 1)
      for_each_on_line(v, call_if_finite);
  }

private:
  template <class Function>
  void for_each_on_line(Index v, const Function& f) const
  {
    auto neighbor = m_dt.tds().incident_vertices(m_dt.vertex(m_frame.id(v)));
    const auto first = neighbor;
    do
      f(neighbor->mirror_index());
    while (++neighbor != first);
  }

  const Dynamic& m_dt;
  const typename Dynamic::Frame m_frame;
  const int m_dimension;
};

} // namespace internal
} // namespace Dynamic_Delaunay_triangulations_2
} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_FINITE_NEIGHBORS_2_H

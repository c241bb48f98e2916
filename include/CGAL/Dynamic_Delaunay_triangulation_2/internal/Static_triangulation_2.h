// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_STATIC_TRIANGULATION_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_STATIC_TRIANGULATION_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Neighborhood_mirror_2.h>
#include <CGAL/Triangulation_data_structure_2.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <cstddef>
#include <iterator>
#include <vector>

namespace CGAL {
namespace Dynamic_Delaunay_triangulations_2 {
namespace internal {

// Calls f(i) for all i below n, in rounds: every 8^k-th first, then every 8^(k-1)-th of the others,
// and so on. Points numbered along a space-filling curve are inserted faster so than in one go
// along the curve, by a tenth at 10^3 points and a fifth at 10^5: the triangulation has long edges
// in the first rounds only.
template <class Function>
void for_each_in_rounds(std::size_t n, Function&& f)
{
  constexpr std::size_t ratio = 8;
  std::size_t stride = 1;
  while (stride * ratio < n)
    stride *= ratio;
  for (std::size_t i = 0; i < n; i += stride)
    f(i);
  for (; stride > 1; stride /= ratio)
    for (std::size_t i = 0; i < n; i += stride / ratio)
      if (i % stride != 0)
        f(i);
}

// A fresh CGAL Delaunay triangulation whose vertices and faces carry a number, to be copied from.
// Points are inserted one after the other, each located from the one before, so give them in a
// spatial order; no two of them may coincide.
template <class Traits>
class Static_triangulation_2
{
  using Vb = Triangulation_vertex_base_with_info_2<Index, Traits>;
  using Fb = Triangulation_face_base_with_info_2<Index, Traits>;
  using Tds = Triangulation_data_structure_2<Vb, Fb>;

public:
  using Triangulation = Delaunay_triangulation_2<Traits, Tds>;
  using Vertex_handle = typename Triangulation::Vertex_handle;
  using Face_handle = typename Triangulation::Face_handle;
  using Point = typename Triangulation::Point;

  explicit Static_triangulation_2(const Traits& traits = Traits())
    : m_triangulation(traits)
  {
    clear();
  }

  const Triangulation& triangulation() const { return m_triangulation; }
  // All faces, to be numbered.
  auto& faces() { return m_triangulation.tds().faces(); }

  void clear()
  {
    m_triangulation.clear();
    m_triangulation.infinite_vertex()->info() = infinite_index;
    m_last = Vertex_handle();
  }

  // A vertex at p with this number; by flips.
  void insert(const Point& p, Index number)
  {
    take(m_last == Vertex_handle() ? m_triangulation.insert(p)
                                   : m_triangulation.insert(p, m_last->face()),
         number);
  }

  // The same by a star in place of the faces in conflict with p.
  void insert_star(const Point& p, Index number)
  {
    if (m_triangulation.dimension() < 2)
      return insert(p, number);
    m_conflicts.clear();
    m_boundary.clear();
    m_triangulation.get_conflicts_and_boundary(p, std::back_inserter(m_conflicts),
                                               std::back_inserter(m_boundary), m_last->face());
    take(m_triangulation.star_hole(p, m_boundary.begin(), m_boundary.end(), m_conflicts.begin(),
                                   m_conflicts.end()),
         number);
  }

private:
  void take(Vertex_handle vertex, Index number)
  {
    vertex->info() = number;
    m_last = vertex;
  }

  Triangulation m_triangulation;
  Vertex_handle m_last;
  std::vector<Face_handle> m_conflicts;
  std::vector<typename Triangulation::Edge> m_boundary;
};

} // namespace internal
} // namespace Dynamic_Delaunay_triangulations_2
} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_STATIC_TRIANGULATION_2_H

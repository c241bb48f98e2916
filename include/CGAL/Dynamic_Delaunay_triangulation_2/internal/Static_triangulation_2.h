// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_STATIC_TRIANGULATION_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_STATIC_TRIANGULATION_2_H

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Neighborhood_mirror_2.h>
#include <CGAL/Triangulation_data_structure_2.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <cstddef>
#include <utility>

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

// A fresh CGAL Delaunay triangulation whose vertices and faces carry a number: what rebuilds and
// splices copy from. Points are inserted one after the other, each located from the one before, so
// give them in a spatial order.
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

  // The vertex at p, with `number` if it is new; and whether it is.
  std::pair<Vertex_handle, bool> insert(const Point& p, Index number)
  {
    const auto before = m_triangulation.number_of_vertices();
    m_last = m_last == Vertex_handle() ? m_triangulation.insert(p)
                                       : m_triangulation.insert(p, m_last->face());
    const bool is_new = m_triangulation.number_of_vertices() != before;
    if (is_new)
      m_last->info() = number;
    return {m_last, is_new};
  }

private:
  Triangulation m_triangulation;
  Vertex_handle m_last;
};

} // namespace internal
} // namespace Dynamic_Delaunay_triangulations_2
} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_STATIC_TRIANGULATION_2_H

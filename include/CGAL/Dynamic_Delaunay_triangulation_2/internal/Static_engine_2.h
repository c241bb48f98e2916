// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_STATIC_ENGINE_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_STATIC_ENGINE_2_H

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Flat_faces_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Guibas_stolfi_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Spatial_order_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Vertex_predicates_2.h>

namespace CGAL {
namespace Dynamic_Delaunay_triangulations_2 {
namespace internal {

// Triangulates vertices of the maintained triangulation anew: all of them for a rebuild, those of a
// region for a splice.
template <class Maintained>
class Static_engine_2
{
  using Predicates = Vertex_predicates_2<Maintained>;

public:
  explicit Static_engine_2(const Maintained& maintained)
    : m_guibas_stolfi(Predicates(maintained), m_faces)
  {
  }
  Static_engine_2(const Static_engine_2&) = delete;
  Static_engine_2& operator=(const Static_engine_2&) = delete;

  // No two of the vertices may coincide.
  void run(const Spatial_order_2& order) { m_guibas_stolfi.run(order); }

  // None, if the vertices do not span the plane.
  const Flat_faces_2& faces() const { return m_faces; }

  // Gives the memory back.
  void release() { m_faces.release(); }

private:
  Flat_faces_2 m_faces;
  Guibas_stolfi_2<Predicates> m_guibas_stolfi;
};

} // namespace internal
} // namespace Dynamic_Delaunay_triangulations_2
} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_STATIC_ENGINE_2_H

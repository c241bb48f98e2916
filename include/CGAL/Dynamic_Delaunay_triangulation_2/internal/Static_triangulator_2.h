// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_STATIC_TRIANGULATOR_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_STATIC_TRIANGULATOR_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Flat_faces_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Guibas_stolfi_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Spatial_order_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Static_triangulation_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Vertex_predicates_2.h>
#include <CGAL/Static_engine_2.h>

namespace CGAL {
namespace Dynamic_Delaunay_triangulations_2 {
namespace internal {

// Triangulates vertices of the maintained triangulation anew: all of them for a rebuild, those of a
// region for a splice.
template <class Maintained>
class Static_triangulator_2
{
  using Predicates = Vertex_predicates_2<Maintained>;
  using Static_triangulation = Static_triangulation_2<typename Maintained::Traits>;

public:
  explicit Static_triangulator_2(const Maintained& maintained)
    : m_maintained(maintained)
    , m_guibas_stolfi(Predicates(maintained), m_faces)
    , m_triangulation(maintained.traits())
  {
  }
  Static_triangulator_2(const Static_triangulator_2&) = delete;
  Static_triangulator_2& operator=(const Static_triangulator_2&) = delete;

  void set_engine(Static_engine_2 engine) { m_engine = engine; }

  // No two of the vertices may coincide.
  void run(const Spatial_order_2& order)
  {
    switch (m_engine) {
    case Static_engine_2::GUIBAS_STOLFI:
      return m_guibas_stolfi.run(order);
    case Static_engine_2::INSERTION:
      return insert(order, [this](const auto& p, Index v) { m_triangulation.insert(p, v); });
    case Static_engine_2::BOWYER_WATSON:
      return insert(order, [this](const auto& p, Index v) { m_triangulation.insert_star(p, v); });
    }
  }

  // None, if the vertices do not span the plane.
  const Flat_faces_2& faces() const { return m_faces; }

  // Gives the memory back. Throws nothing.
  void release() { m_faces.release(); }

private:
  template <class Insert>
  void insert(const Spatial_order_2& order, const Insert& insert)
  {
    m_triangulation.clear();
    for_each_in_rounds(order.size(),
                       [&](std::size_t i) { insert(m_maintained.point(order[i]), order[i]); });
    copy_faces();
    m_triangulation.clear(); // which takes memory, and may throw
  }

  void copy_faces()
  {
    m_faces.resize(0);
    if (m_triangulation.triangulation().dimension() < 2)
      return;
    Index number = 0;
    for (auto f = m_triangulation.faces().begin(); f != m_triangulation.faces().end(); ++f)
      f->info() = number++;
    m_faces.resize(number);
    for (auto f = m_triangulation.faces().begin(); f != m_triangulation.faces().end(); ++f)
      for (int i = 0; i < 3; ++i) {
        const auto g = f->neighbor(i);
        // g->index(f), which branches
        const Index place = Index(g->neighbor(1) == f) + 2 * Index(g->neighbor(2) == f);
        const Index h = Flat_faces_2::first_halfedge(f->info()) + Index(i);
        m_faces.set_apex(h, f->vertex(i)->info());
        m_faces.set_twin(h, Flat_faces_2::first_halfedge(g->info()) + place);
      }
  }

  const Maintained& m_maintained;
  Static_engine_2 m_engine = Static_engine_2::GUIBAS_STOLFI;
  Flat_faces_2 m_faces;
  Guibas_stolfi_2<Predicates> m_guibas_stolfi;
  Static_triangulation m_triangulation;
};

} // namespace internal
} // namespace Dynamic_Delaunay_triangulations_2
} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_STATIC_TRIANGULATOR_2_H

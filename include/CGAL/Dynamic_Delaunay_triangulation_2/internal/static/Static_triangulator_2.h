// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_STATIC_STATIC_TRIANGULATOR_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_STATIC_STATIC_TRIANGULATOR_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/passes/Spatial_order_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/proof/Edge_test_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/static/Flat_faces_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/static/Guibas_stolfi_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/topology/Halfedge_arrays_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/policies/Static_engine_2.h>
#include <CGAL/Triangulation_data_structure_2.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <cstddef>
#include <iterator>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

// Calls f(i) for all i below n, in rounds: every 8^k-th first, then every 8^(k-1)-th of the others,
// and so on. If points are numbered along a space-filling curve, inserting them in rounds is faster
// than inserting them along the curve, by a tenth at 10^3 points and a fifth at 10^5, because only
// the first rounds have long edges.
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

// A fresh CGAL Delaunay triangulation whose vertices and faces carry numbers, to be copied from.
// Each point is located from the last one inserted, so give them in a spatial order. No two of them
// may coincide.
template <class Traits>
class Static_triangulation_2
{
  using Vb = Triangulation_vertex_base_with_info_2<Vertex_index, Traits>;
  using Fb = Triangulation_face_base_with_info_2<Face_index, Traits>;
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

  // Inserts a vertex at p with this number, by flips.
  void insert(const Point& p, Vertex_index number)
  {
    take(m_last == Vertex_handle() ? m_triangulation.insert(p)
                                   : m_triangulation.insert(p, m_last->face()),
         number);
  }

  // Inserts a vertex at p with this number, by a star that replaces the faces in conflict with p.
  void insert_star(const Point& p, Vertex_index number)
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
  void take(Vertex_handle vertex, Vertex_index number)
  {
    vertex->info() = number;
    m_last = vertex;
  }

  Triangulation m_triangulation;
  Vertex_handle m_last;
  std::vector<Face_handle> m_conflicts;
  std::vector<typename Triangulation::Edge> m_boundary;
};

// Triangulates vertices of the maintained triangulation from scratch: all of them for a rebuild,
// those of a region for a splice.
template <class State>
class Static_triangulator_2
{
  using Predicates = Vertex_predicates_2<State>;
  using Static_triangulation = Static_triangulation_2<typename State::Traits>;

public:
  explicit Static_triangulator_2(const State& state)
    : m_state(state)
    , m_guibas_stolfi(Predicates(state), m_faces)
    , m_triangulation(state.traits())
  {
  }
  Static_triangulator_2(const Static_triangulator_2&) = delete;
  Static_triangulator_2& operator=(const Static_triangulator_2&) = delete;

  void set_engine(Static_engine_2 engine) { m_engine = engine; }

  // Triangulates the vertices of `order`. No two of them may coincide. If threads share the work,
  // one of them calls `companion()`.
  template <class Companion>
  void run(const Spatial_order_2& order, const Companion& companion)
  {
    switch (m_engine) {
    case Static_engine_2::GUIBAS_STOLFI:
      return m_guibas_stolfi.run(order, companion);
    case Static_engine_2::INSERTION:
      return insert(order, [this](const auto& p, Vertex_index v) { m_triangulation.insert(p, v); });
    case Static_engine_2::BOWYER_WATSON:
      return insert(order, [this](const auto& p, Vertex_index v) { m_triangulation.insert_star(p, v); });
    }
  }

  void run(const Spatial_order_2& order)
  {
    run(order, [] {});
  }

  // Empty if the vertices do not span the plane.
  const Flat_faces_2& faces() const { return m_faces; }

  // Frees the memory. Throws nothing.
  void release() { m_faces.release(); }

private:
  template <class Insert>
  void insert(const Spatial_order_2& order, const Insert& insert)
  {
    m_triangulation.clear();
    for_each_in_rounds(order.size(), [&](std::size_t i) {
      const Vertex_index v(order[i]);
      insert(m_state.point(v), v);
    });
    copy_faces();
    m_triangulation.clear(); // allocates memory, and may throw
  }

  void copy_faces()
  {
    m_faces.resize(0);
    if (m_triangulation.triangulation().dimension() < 2)
      return;
    Face_index number(0);
    for (auto f = m_triangulation.faces().begin(); f != m_triangulation.faces().end(); ++f)
      f->info() = number++;
    m_faces.resize(number);
    for (auto f = m_triangulation.faces().begin(); f != m_triangulation.faces().end(); ++f)
      for (int i = 0; i < 3; ++i) {
        const auto g = f->neighbor(i);
        // like g->index(f), but without a branch
        const Index place = Index(g->neighbor(1) == f) + 2 * Index(g->neighbor(2) == f);
        const Flat_halfedge_index h = Flat_faces_2::first_halfedge(f->info()) + i;
        m_faces.set_apex(h, f->vertex(i)->info());
        m_faces.set_twin(h, Flat_faces_2::first_halfedge(g->info()) + place);
      }
  }

  const State& m_state;
  Static_engine_2 m_engine = Static_engine_2::GUIBAS_STOLFI;
  Flat_faces_2 m_faces;
  Guibas_stolfi_2<Predicates, typename State::Parts> m_guibas_stolfi;
  Static_triangulation m_triangulation;
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_STATIC_STATIC_TRIANGULATOR_2_H

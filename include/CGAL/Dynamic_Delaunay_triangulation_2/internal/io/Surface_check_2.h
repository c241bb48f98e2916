// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_IO_SURFACE_CHECK_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_IO_SURFACE_CHECK_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Flat_arrays.h>
#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/static/Flat_faces_2.h>

#include <cstddef>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

// Checks whether faces form a triangulated closed surface:
//   - each edge has two faces, which run along it in opposite directions,
//   - the faces at each vertex form one cycle, and
//   - all faces are connected.
// By Euler's formula it is a sphere if it has four faces fewer than twice as many as vertices, and
// a torus if it has twice as many.
class Surface_check_2
{
public:
  // What is wrong, and at which face. `what` is null if nothing is.
  struct Flaw
  {
    const char* what = nullptr;
    Face_index face{0};
  };

  // The vertices are those from `first` to before `beyond`.
  Surface_check_2(Flat_faces_2& faces, Index beyond, Vertex_index first = Vertex_index(0))
    : m_faces(faces)
    , m_first_vertex(first)
    , m_beyond(beyond)
  {
  }

  // Links and checks faces that are given by their vertices alone. Two edges between the same
  // vertices count as a flaw. Returns a flaw if there is any.
  Flaw link_and_run()
  {
    sort_halfedges();
    const Flaw flaw = link();
    return flaw.what ? flaw : check();
  }

  // Checks linked faces, whose twins must run along each other in opposite directions.
  Flaw run()
  {
    sort_halfedges();
    return check();
  }

private:
  static Flaw flaw_at(Flat_halfedge_index halfedge, const char* what)
  {
    return {what, Flat_faces_2::face_of(halfedge)};
  }

  template <class Function>
  void for_each_halfedge(const Function& f) const
  {
    for (Face_index face(0); face < m_faces.number_of_faces(); ++face)
      for (Index i = 0; i < 3; ++i)
        f(Flat_faces_2::first_halfedge(face) + i);
  }

  // Sorts the half-edges by their sources.
  void sort_halfedges()
  {
    m_first.assign(m_beyond + std::size_t(1), 0);
    for_each_halfedge([this](Flat_halfedge_index h) { ++m_first[m_faces.source(h)]; });
    for (Vertex_index v(0); v < m_beyond; ++v)
      m_first[v + 1] += m_first[v];
    m_sorted.resize(m_first.back());
    for_each_halfedge([this](Flat_halfedge_index h) { m_sorted[--m_first[m_faces.source(h)]] = h; });
  }

  template <class Function>
  void for_each_halfedge_from(Vertex_index v, const Function& f) const
  {
    for (Index i = m_first[v]; i < m_first[v + 1]; ++i)
      f(m_sorted[i]);
  }

  Flaw link()
  {
    Flaw flaw;
    Column<Vertex_index, Flat_halfedge_index> halfedge_to(m_beyond, null_index); // from v to each vertex
    for (Vertex_index v(0); v < m_beyond; ++v) {
      for_each_halfedge_from(v, [&](Flat_halfedge_index h) {
        Flat_halfedge_index& there = halfedge_to[m_faces.target(h)];
        if (m_faces.target(h) == v)
          flaw = flaw_at(h, "the face has a vertex twice");
        else if (there != null_index)
          flaw = flaw_at(h, "an edge of the face is there twice");
        there = h;
      });
      for_each_halfedge_from(v, [&](Flat_halfedge_index h) {
        const Flat_halfedge_index arriving = Flat_faces_2::previous(h);
        const Flat_halfedge_index back = halfedge_to[m_faces.source(arriving)];
        if (back == null_index)
          flaw = flaw_at(h, "an edge of the face has no other face");
        m_faces.set_twin(arriving, back);
      });
      for_each_halfedge_from(
          v, [&](Flat_halfedge_index h) { halfedge_to[m_faces.target(h)] = null_index; });
      if (flaw.what)
        return flaw;
    }
    return flaw;
  }

  Flaw check() const
  {
    const Flaw flaw = check_vertices();
    return flaw.what ? flaw : check_connection();
  }

  Flaw check_vertices() const
  {
    for (Vertex_index v = m_first_vertex; v < m_beyond; ++v) {
      const Index degree = m_first[v + 1] - m_first[v];
      if (degree == 0)
        return {"a vertex is in no face", Face_index(m_faces.number_of_faces() - 1)};
      const Flat_halfedge_index start = m_sorted[m_first[v]];
      Flat_halfedge_index h = start;
      Index around = 0;
      do {
        h = m_faces.twin(Flat_faces_2::previous(h));
        ++around;
      } while (h != start);
      if (around != degree)
        return flaw_at(start, "the faces at a vertex of the face are not one cycle");
    }
    return {};
  }

  Flaw check_connection() const
  {
    std::vector<bool> is_reached(m_faces.number_of_faces());
    std::vector<Face_index> waiting(1, Face_index(0));
    is_reached[0] = true;
    while (!waiting.empty()) {
      const Flat_halfedge_index h = Flat_faces_2::first_halfedge(waiting.back());
      waiting.pop_back();
      for (Index i = 0; i < 3; ++i) {
        const Face_index f = Flat_faces_2::face_of(m_faces.twin(h + i));
        if (!is_reached[f])
          waiting.push_back(f);
        is_reached[f] = true;
      }
    }
    for (Face_index f(0); f < m_faces.number_of_faces(); ++f)
      if (!is_reached[f])
        return {"the face hangs together with the first one by no edges", f};
    return {};
  }

  Flat_faces_2& m_faces;
  Vertex_index m_first_vertex;
  Index m_beyond;
  Column<Vertex_index, Index> m_first; // index in m_sorted of the first half-edge from each vertex
  std::vector<Flat_halfedge_index> m_sorted; // the half-edges by their sources
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_IO_SURFACE_CHECK_2_H

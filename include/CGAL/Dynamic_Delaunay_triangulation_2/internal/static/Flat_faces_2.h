// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_STATIC_FLAT_FACES_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_STATIC_FLAT_FACES_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Flat_arrays.h>

#include <cstddef>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

// The number of a half-edge among those of `Flat_faces_2`.
using Flat_halfedge_index = Index_of<struct Flat_halfedge_element>;

// The faces of a fresh triangulation under construction, infinite ones included. Each has three
// half-edges, opposite to its vertices. Empty if the points do not span the plane.
//
// The numbers of the first half-edges of faces are four apart, and every fourth half-edge is
// unused: the division by three in next() and previous(), which are called very often, would cost a
// seventh of the time of Guibas' and Stolfi's method.
class Flat_faces_2
{
public:
  static Flat_halfedge_index first_halfedge(Face_index face)
  {
    return Flat_halfedge_index(4 * face);
  }
  static Flat_halfedge_index next(Flat_halfedge_index h)
  {
    return Flat_halfedge_index((h & 3) == 2 ? h - 2 : Index(h) + 1);
  }
  static Flat_halfedge_index previous(Flat_halfedge_index h)
  {
    return Flat_halfedge_index((h & 3) == 0 ? Index(h) + 2 : h - 1);
  }
  static Face_index face_of(Flat_halfedge_index h) { return Face_index(h / 4); }
  static Index place_of(Flat_halfedge_index h) { return h & 3; }
  // The number of half-edge h in arrays with the same faces.
  static Halfedge_index number_in_arrays(Flat_halfedge_index h)
  {
    return Halfedge_index(h - h / 4);
  }
  // The half-edge with this number in arrays.
  static Flat_halfedge_index from_arrays(Halfedge_index number)
  {
    return Flat_halfedge_index(Index(number) + number / 3);
  }

  Index number_of_faces() const { return Index(m_halfedges.size() / 4); }
  Vertex_index apex(Flat_halfedge_index h) const { return m_halfedges[h].apex; }
  Flat_halfedge_index twin(Flat_halfedge_index h) const { return m_halfedges[h].twin; }
  Vertex_index source(Flat_halfedge_index h) const { return apex(next(h)); }
  Vertex_index target(Flat_halfedge_index h) const { return apex(previous(h)); }

  void reserve(std::size_t faces) { m_halfedges.reserve(4 * faces); }
  void resize(std::size_t faces) { m_halfedges.resize(4 * faces); }
  void set_apex(Flat_halfedge_index h, Vertex_index v) { m_halfedges[h].apex = v; }
  void set_vertices(Face_index face, Vertex_index a, Vertex_index b, Vertex_index c)
  {
    const Flat_halfedge_index h = first_halfedge(face);
    set_apex(h, a);
    set_apex(h + 1, b);
    set_apex(h + 2, c);
  }
  void set_twin(Flat_halfedge_index h, Flat_halfedge_index g) { m_halfedges[h].twin = g; }
  void link(Flat_halfedge_index h, Flat_halfedge_index g)
  {
    set_twin(h, g);
    set_twin(g, h);
  }

  void release() { Uninitialized_vector<Halfedge>().swap(m_halfedges); }

private:
  struct Halfedge
  {
    Vertex_index apex;
    Flat_halfedge_index twin;
  };

  Uninitialized_column<Flat_halfedge_index, Halfedge> m_halfedges;
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_STATIC_FLAT_FACES_2_H

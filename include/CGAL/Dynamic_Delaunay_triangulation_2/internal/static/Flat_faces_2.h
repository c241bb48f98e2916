// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_STATIC_FLAT_FACES_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_STATIC_FLAT_FACES_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Flat_arrays.h>

#include <cstddef>

namespace CGAL::Dynamic_Delaunay_triangulations_2::internal {

// The faces of a fresh triangulation under construction, infinite ones included. Each has three
// half-edges, opposite to its vertices. Empty if the points do not span the plane.
//
// The numbers of the first half-edges of faces are four apart, and every fourth half-edge is
// unused: the division by three in next() and previous(), which are called very often, would cost a
// seventh of the time of Guibas' and Stolfi's method.
class Flat_faces_2
{
public:
  static Index first_halfedge(Index face) { return 4 * face; }
  static Index next(Index h) { return (h & 3) == 2 ? h - 2 : h + 1; }
  static Index previous(Index h) { return (h & 3) == 0 ? h + 2 : h - 1; }
  // The number of half-edge h in arrays with the same faces.
  static Index number_in_arrays(Index h) { return h - h / 4; }
  // The half-edge with this number in arrays.
  static Index from_arrays(Index number) { return number + number / 3; }

  Index number_of_faces() const { return Index(m_halfedges.size() / 4); }
  Index apex(Index h) const { return m_halfedges[h].apex; }
  Index twin(Index h) const { return m_halfedges[h].twin; }
  Index source(Index h) const { return apex(next(h)); }
  Index target(Index h) const { return apex(previous(h)); }

  void reserve(std::size_t faces) { m_halfedges.reserve(4 * faces); }
  void resize(std::size_t faces) { m_halfedges.resize(4 * faces); }
  void set_apex(Index h, Index v) { m_halfedges[h].apex = v; }
  void set_vertices(Index face, Index a, Index b, Index c)
  {
    const Index h = first_halfedge(face);
    set_apex(h, a);
    set_apex(h + 1, b);
    set_apex(h + 2, c);
  }
  void set_twin(Index h, Index g) { m_halfedges[h].twin = g; }
  void link(Index h, Index g)
  {
    set_twin(h, g);
    set_twin(g, h);
  }

  void release() { Uninitialized_vector<Halfedge>().swap(m_halfedges); }

private:
  struct Halfedge
  {
    Index apex, twin;
  };

  Uninitialized_vector<Halfedge> m_halfedges;
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_2::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_STATIC_FLAT_FACES_2_H

// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_FLAT_FACES_2_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_FLAT_FACES_2_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/Neighborhood_mirror_2.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Dynamic_Delaunay_triangulations_2 {
namespace internal {

// So many have half-edges whose numbers fit, here and in a mirror.
constexpr Index max_vertices = no_index / 8;

// The faces of a fresh triangulation, infinite ones included, while it is made: three half-edges
// each, opposite to its vertices. None at all if the points do not span the plane.
//
// Faces stand four half-edges apart, the last of which is not used: next() and previous() are
// called so often that the division by three would cost a seventh of Guibas' and Stolfi's method.
class Flat_faces_2
{
public:
  static Index first_halfedge(Index face) { return 4 * face; }
  static Index next(Index h) { return (h & 3) == 2 ? h - 2 : h + 1; }
  static Index previous(Index h) { return (h & 3) == 0 ? h + 2 : h - 1; }
  // The number of half-edge h in a mirror with the same faces.
  static Index number_in_mirror(Index h) { return h - h / 4; }

  Index number_of_faces() const { return Index(m_halfedges.size() / 4); }
  Index apex(Index h) const { return m_halfedges[h].apex; }
  Index twin(Index h) const { return m_halfedges[h].twin; }
  Index source(Index h) const { return apex(next(h)); }
  Index target(Index h) const { return apex(previous(h)); }

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

  void release() { std::vector<Halfedge>().swap(m_halfedges); }

private:
  struct Halfedge
  {
    Index apex, twin;
  };

  std::vector<Halfedge> m_halfedges;
};

} // namespace internal
} // namespace Dynamic_Delaunay_triangulations_2
} // namespace CGAL

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_2_INTERNAL_FLAT_FACES_2_H

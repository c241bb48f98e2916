// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_QUERIES_CELLS_BOXED_CELL_3_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_QUERIES_CELLS_BOXED_CELL_3_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/passes/Elements_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/queries/cells/Cell_measures_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/queries/cells/Cut_polyhedron_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/queries/Scaled_sites_3.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_3::internal {

// A box in units of the sites.
struct Box_3
{
  Position_3 low, high;

  // Whether it has a range around a vertex.
  bool contains(const Position_3& v, const Position_3& least, const Position_3& most) const
  {
    const Position_3 down = low - v, up = high - v;
    return down.x <= least.x && down.y <= least.y && down.z <= least.z && most.x <= up.x &&
           most.y <= up.y && most.z <= up.z;
  }
  Position_3 center() const { return low + 0.5 * (high - low); }
  // An upper bound on |x| + |y| + |z| from the center.
  double reach() const
  {
    const Position_3 way = high - low;
    return 0.5000001 * (way.x + way.y + way.z);
  }
};

// Measures Voronoi cells clipped by a box: the box is cut by the bisectors with all neighbors.
//
// Let u = 2^-53. Cells are cut relative to their vertices. If the box goes up to the distance L
// from a vertex, corners are off by a few u L. So a cell whose vertex is farther than two extents
// of the box from its center is cut relative to that center, by planes that are computed exactly
// and rounded at the end; corners are off by a few u times the extent of the box, however far away
// vertices are.
template <class State>
class Boxed_cell_3
{
  using Sites = Scaled_sites_3<State>;
  using Neighbor = Cell_neighbor_3<Vertex_index>;

public:
  // Measures the cell with these neighbors, and its facets with them. The centroid is not relative
  // to the vertex.
  Cell_measures_3 measure(const Sites& sites, Vertex_index v, const Box_3& box,
                          std::vector<Neighbor>& neighbors)
  {
    const Position_3 p = sites.at(v), center = box.center();
    const bool is_afar = size_of(p - center) > 2 * box.reach();
    const Position_3 origin = is_afar ? center : p;
    m_polyhedron.start_box(box.low - origin, box.high - origin);
    std::size_t label = Cut_polyhedron_3::walls;
    for (const Neighbor& neighbor : neighbors) {
      if (is_afar)
        cut_from_afar(sites, v, neighbor.site, box, label++);
      else
        m_polyhedron.cut(sites.bisector(v, neighbor.site), label++);
    }
    m_facets.assign(label, {0, {0, 0, 0}});
    Cell_measures_3 measures;
    if (!m_polyhedron.is_empty())
      measures = m_polyhedron.measure(m_facets);
    label = Cut_polyhedron_3::walls;
    for (Neighbor& neighbor : neighbors) {
      const Measured_facet_3& facet = m_facets[label++];
      neighbor.area = facet.area;
      neighbor.moment = facet.moment + facet.area * (origin - p);
    }
    measures.centroid = origin + measures.centroid;
    return measures;
  }

private:
  static double size_of(const Position_3& p)
  {
    return std::abs(p.x) + std::abs(p.y) + std::abs(p.z);
  }

  void cut_from_afar(const Sites& sites, Vertex_index v, Vertex_index w, const Box_3& box,
                     std::size_t label)
  {
    if (m_polyhedron.is_empty())
      return;
    // where doubles suffice: each sum is off by less than 2^-48 of the sizes in it
    const Position_3 edge = sites.vector(v, w), center = box.center();
    const Position_3 p = sites.at(v) - center, q = sites.at(w) - center;
    const double size = size_of(edge);
    const double margin = size * (box.reach() + 0x1p-48 * (size_of(p) + size_of(q)));
    const double product = dot(edge, 0.5 * (p + q));
    if (product > margin)
      return;
    if (product < -margin)
      return m_polyhedron.clear();
    m_polyhedron.cut(sites.bisector(v, w, center), label);
  }

  Cut_polyhedron_3 m_polyhedron;
  std::vector<Measured_facet_3> m_facets; // by label
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_3::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_QUERIES_CELLS_BOXED_CELL_3_H

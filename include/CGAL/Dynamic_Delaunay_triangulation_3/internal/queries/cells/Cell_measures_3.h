// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_QUERIES_CELLS_CELL_MEASURES_3_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_QUERIES_CELLS_CELL_MEASURES_3_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/passes/Elements_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/queries/cells/Voronoi_vertices_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/queries/Scaled_sites_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/queries/Site_charts_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/queries/Vertex_star_3.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_3::internal {

// The measures of a cell, in units of the sites.
struct Cell_measures_3
{
  double volume = 0, surface = 0;
  Position_3 centroid{0, 0, 0}; // of a whole cell relative to its vertex
};

// One neighbor of a cell, the area of the facet between both, and that area times the vector from
// the vertex of the cell to the centroid of the facet.
template <class Site>
struct Cell_neighbor_3
{
  Site site;
  double area;
  Position_3 moment{0, 0, 0};
};

// Measures whole Voronoi cells, one after the other. A cell consists of pyramids: their apex is the
// vertex, their bases are the facets of the cell.
template <class State>
class Whole_cell_3
{
  using Charts = Site_charts_3<typename State::Arrays>;
  using Site = typename Charts::Site;

public:
  using Neighbor = Cell_neighbor_3<Site>;

  // Lists the neighbors with which the cell of v shares an area, and measures it.
  Cell_measures_3 measure(const Voronoi_vertices_3<State>& vertices, Vertex_index v)
  {
    m_volume = m_surface = 0;
    m_moment = {0, 0, 0};
    m_neighbors.clear();
    m_is_bounded = true;
    m_low = m_high = {0, 0, 0};
    m_star.for_each_neighbor(
        vertices.sites().state().arrays, v, [&](const Site& w, const Cell_ring_3<Charts>& ring) {
          vertices.see(v, ring, m_corners);
          const bool is_bounded = std::none_of(m_corners.begin(), m_corners.end(),
                                               Voronoi_vertices_3<State>::is_infinite);
          m_is_bounded = m_is_bounded && is_bounded;
          if (!vertices.span_area(v, w, ring, m_corners))
            return;
          m_neighbors.push_back({w, infinity});
          if (is_bounded)
            add_facet(vertices.sites().bisector(Charts::site(v), w), m_neighbors.back());
        });
    if (!m_is_bounded)
      return {infinity, infinity};
    return {m_volume, m_surface, (1 / m_volume) * m_moment};
  }

  const std::vector<Neighbor>& neighbors() const { return m_neighbors; }
  bool is_bounded() const { return m_is_bounded; }
  // Bounds on the coordinates of the corners of a bounded cell, relative to its vertex.
  const Position_3& low() const { return m_low; }
  const Position_3& high() const { return m_high; }

private:
  static constexpr double infinity = std::numeric_limits<double>::infinity();

  // Adds the pyramid over the facet with the corners in a plane, and measures the facet.
  void add_facet(const Plane_3& plane, Neighbor& facet)
  {
    const Position_3& first = m_corners[0];
    note_corner(first);
    double doubled_area = 0;
    Position_3 moment{0, 0, 0}; // six times the area times the vector from the first corner
    Position_3 last{0, 0, 0};
    for (std::size_t i = 1; i < m_corners.size(); ++i) {
      const Position_3& corner = m_corners[i];
      note_corner(corner);
      const Position_3 side = corner - first;
      const double doubled = dot(plane.normal, cross(last, side));
      doubled_area += doubled;
      moment = moment + doubled * (last + side);
      last = side;
    }
    if (!(doubled_area > 0)) { // by rounding, or NaN, where a corner is too distant for doubles
      facet.area = doubled_area <= 0 ? 0 : infinity;
      return;
    }
    const double area = doubled_area / 2, volume = area * plane.distance / 3;
    facet.area = area;
    facet.moment = area * first + (1.0 / 6) * moment;
    m_surface += area;
    m_volume += volume;
    // the centroid of a pyramid is at three quarters of the way to that of its base
    m_moment = m_moment + 0.75 * (volume * first + (plane.distance / 18) * moment);
  }

  void note_corner(const Position_3& p)
  {
    m_low = {(std::min)(m_low.x, p.x), (std::min)(m_low.y, p.y), (std::min)(m_low.z, p.z)};
    m_high = {(std::max)(m_high.x, p.x), (std::max)(m_high.y, p.y), (std::max)(m_high.z, p.z)};
  }

  Vertex_star_3<typename State::Arrays> m_star;
  std::vector<Position_3> m_corners; // of a facet
  double m_volume = 0, m_surface = 0;
  Position_3 m_moment{0, 0, 0}; // the volume times the vector from the vertex to the centroid
  std::vector<Neighbor> m_neighbors;
  bool m_is_bounded = true;
  Position_3 m_low{0, 0, 0}, m_high{0, 0, 0};
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_3::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_QUERIES_CELLS_CELL_MEASURES_3_H

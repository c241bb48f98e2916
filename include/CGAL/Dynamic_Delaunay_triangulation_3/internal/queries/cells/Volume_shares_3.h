// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_QUERIES_CELLS_VOLUME_SHARES_3_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_QUERIES_CELLS_VOLUME_SHARES_3_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Flat_arrays.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/passes/Elements_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/queries/cells/Voronoi_vertices_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/queries/Scaled_images_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/queries/Scaled_sites_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/queries/Site_charts_3.h>

#include <cstddef>

namespace CGAL::Dynamic_Delaunay_triangulations_3::internal {

// What Delaunay facets add to the volumes of Voronoi cells.
//
// The Voronoi cell of v consists of pyramids over its facets. Let e be an edge from v to another
// site, m its middle, and let the facet between both have the corners c_1, c_2, ... in a cycle. Its
// pyramid, whose height is |e|/2, has the volume
//   1/12 sum_i e * ((c_i - m) x (c_i+1 - m)).
// Each term belongs to the Delaunay facet between the cells with the centers c_i and c_i+1, so
// every Delaunay facet adds a number for each of its edges, to the cells of both ends.
//
// The side from c_i to c_i+1 is perpendicular to the Delaunay facet xyz. If the normal of that,
//   N = (y - x) x (z - x),
// points to c_i+1, the term of the edge from x to y is, with t = (c_i+1 - c_i) * N / (24 N*N),
//   t |y - x|^2 (x - z) * (y - z):
// the length of the side, times a twelfth of the edge, times the distance of the edge from the
// center of the circle of xyz. Terms are of either sign. They are off by some u times |e| and the
// squared distances of the centers, as long as the angle at x is not flat: its sine is 2^-10 at
// least, else the first formula is used.
template <class State>
class Volume_shares_3
{
  using Arrays = typename State::Arrays;
  using Charts = Site_charts_3<Arrays>;
  using Sites = Scaled_sites_3<State>;

public:
  // The cells must exist. A facet adds to the corners of the cell from which it has the smaller
  // number.
  explicit Volume_shares_3(const Sites& sites)
    : m_sites(sites)
    , m_centers(sites)
    , m_shares(sites.state().arrays.number_of_cells())
  {
    State::Parts::for_each_element(m_shares.size(), [this](std::size_t c) {
      m_shares[Cell_index(c)] = shares_of(Cell_index(c));
    });
  }

  // In cubed units of the sites, for the vertices of a cell. Those of an infinite cell have
  // unbounded Voronoi cells, so their shares mean nothing.
  const Few<double, 4>& of(Cell_index c) const { return m_shares[c]; }

private:
  // A facet xyz of a cell, as seen from outside, its edges from y to z, z to x and x to y, and the
  // centers of the cell and of the one beyond.
  struct Facet
  {
    Few<Position_3, 3> vertices, edges;
    Position_3 inner, outer;
  };

  const Arrays& arrays() const { return m_sites.state().arrays; }

  Few<double, 4> shares_of(Cell_index c) const
  {
    Few<double, 4> shares{0, 0, 0, 0};
    const Position_3& center = m_centers.center(c);
    if (Voronoi_vertices_3<State>::is_infinite(center))
      return shares;
    const auto& sites = Charts::sites(arrays(), c);
    const Few<Position_3, 4> vertices{Position_3{0, 0, 0}, m_sites.vector(sites[0], sites[1]),
                                      m_sites.vector(sites[0], sites[2]),
                                      m_sites.vector(sites[0], sites[3])};
    for (int i = 0; i < 4; ++i) {
      const Corner_index k = Arrays::corner(c, i), mirror = arrays().mirror(k);
      if (mirror < k)
        continue;
      const auto beyond = Charts::beyond(arrays(), Charts::in_own_chart(c), i, mirror);
      const Position_3& other = m_centers.center(Charts::cell_of(beyond));
      if (Voronoi_vertices_3<State>::is_infinite(other))
        continue;
      // in an order in which the normal points away from the vertex at place i
      const int x = (i + 1) % 4, y = i % 2 == 0 ? (i + 2) % 4 : (i + 3) % 4, z = 6 - i - x - y;
      const auto edge = [&](int from, int to) {
        const Position_3 way = vertices[to] - vertices[from];
        return squared_length(way) > 0x1p-12 * squared_length(vertices[from])
                   ? way // else digits are lost
                   : m_sites.vector(sites[from], sites[to]);
      };
      const Few<double, 3> added =
          shares_of_facet({{vertices[x], vertices[y], vertices[z]},
                           {edge(y, z), edge(z, x), edge(x, y)},
                           center,
                           m_sites.vector(sites[0], Charts::site(arrays(), beyond, 0)) + other});
      shares[x] += added[0];
      shares[y] += added[1];
      shares[z] += added[2];
    }
    return shares;
  }

  static Few<double, 3> shares_of_facet(const Facet& facet)
  {
    const Position_3 &a = facet.edges[0], &b = facet.edges[1], &c = facet.edges[2],
                     normal = cross(b, c);
    const double aa = squared_length(a), bb = squared_length(b), cc = squared_length(c),
                 nn = squared_length(normal);
    if (!(nn > 0x1p-20 * (bb * cc)))
      return shares_of_thin(facet);
    const double t = dot(facet.inner - facet.outer, normal) / (24 * nn);
    // not by squared lengths, whose differences are less accurate where an edge is short
    return sums(t * aa * dot(b, c), t * bb * dot(c, a), t * cc * dot(a, b));
  }

  // By the first formula.
  static Few<double, 3> shares_of_thin(const Facet& facet)
  {
    const auto term = [&](int i) {
      const Position_3 middle = 0.5 * (facet.vertices[(i + 1) % 3] + facet.vertices[(i + 2) % 3]);
      return dot(facet.edges[i], cross(facet.inner - middle, facet.outer - middle)) / 12;
    };
    return sums(term(0), term(1), term(2));
  }

  // What the vertices get of the terms of the edges opposite to them: each those of its own edges.
  static Few<double, 3> sums(double a, double b, double c) { return {b + c, c + a, a + b}; }

  const Sites& m_sites;
  const Voronoi_vertices_3<State> m_centers;
  Dynamic_Delaunay_triangulations_2::internal::Uninitialized_column<Cell_index, Few<double, 4>>
      m_shares;
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_3::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_QUERIES_CELLS_VOLUME_SHARES_3_H

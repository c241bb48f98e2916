// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_QUERIES_CELLS_VORONOI_VERTICES_3_H
#define CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_QUERIES_CELLS_VORONOI_VERTICES_3_H

#include <CGAL/license/Dynamic_Delaunay_triangulation_2.h>

#include <CGAL/Dynamic_Delaunay_triangulation_2/internal/base/Flat_arrays.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/passes/Elements_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/queries/Scaled_sites_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/queries/Site_charts_3.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/internal/queries/Vertex_star_3.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Dynamic_Delaunay_triangulations_3::internal {

// The circumcenters of all cells: the vertices of the Voronoi diagram, in units of the sites.
//
// With edges b, c and d from its first vertex, a cell has the center
//   ((b*b) c x d + (c*c) d x b + (d*d) b x c) / (2 b*(c x d)).
// Let u = 2^-53, R be the radius, and the flatness t be b*(c x d) / (|b| |c| |d|). Each of the
// three products of the numerator is off by at most 12 u of its bound, such as |b|^2 |c| |d|; these
// add up to at most 6 R |b| |c| |d|, as no edge is longer than 2 R. The denominator is off by at
// most 16 u |b| |c| |d|. So the center is off by less than 80 u R / t. Where t is less than 1/1024,
// rational numbers are rounded at the end instead. Hence all centers are off by less than 1e-11 R,
// and where two of them differ by more than 1e-9 R, so do the exact ones.
template <class State>
class Voronoi_vertices_3
{
  using Arrays = typename State::Arrays;
  using Charts = Site_charts_3<Arrays>;
  using Site = typename Charts::Site;
  using Cell_ring = Cell_ring_3<Charts>;
  using Sites = Scaled_sites_3<State>;
  using Number = typename Sites::Number;
  using Exact_vector = typename Sites::Exact_vector;
  enum class Tie : unsigned char { unknown, no, yes };

public:
  // The cells must exist, and the sites stay where they are, while this is used.
  explicit Voronoi_vertices_3(const Sites& sites)
    : m_sites(sites)
    , m_centers(sites.state().arrays.number_of_cells())
    , m_ties(4 * m_centers.size())
  {
    State::Parts::for_each_element(m_centers.size(), [&](std::size_t c) {
      const double nan = std::numeric_limits<double>::quiet_NaN();
      m_centers[Cell_index(c)] = Charts::is_infinite(arrays(), Cell_index(c))
                                     ? Position_3{nan, nan, nan}
                                     : center_of(Charts::sites(arrays(), Cell_index(c)));
    });
  }

  const Sites& sites() const { return m_sites; }

  // The center of a cell relative to its first site; NaN if it is infinite.
  const Position_3& center(Cell_index c) const { return m_centers[c]; }

  // The corners of a facet, which are the centers of the cells around an edge from v, relative to
  // v; infinite cells have NaN.
  void see(Vertex_index v, const Cell_ring& ring, std::vector<Position_3>& corners) const
  {
    const Site site = Charts::site(v);
    corners.clear();
    for (const auto& of_ring : ring) {
      const Site first = Charts::site(arrays(), of_ring.cell, 0);
      const Position_3& center = m_centers[Charts::cell_of(of_ring.cell)];
      corners.push_back(
          site == first || is_infinite(center) ? center : m_sites.vector(site, first) + center);
    }
  }
  static bool is_infinite(const Position_3& corner) { return std::isnan(corner.x); }

  // Whether the corners of the facet between v and w span an area, exactly. Consecutive ones may
  // coincide. The first and the last of those in between do not, since they are ends of one side;
  // so there is an area if corners change three times, and none if they never do, or change twice:
  // to and fro. The infinite cells of coplanar hull facets have one infinite corner, others have
  // different ones. In periodic space only those with a common circle have one: in a slab all hull
  // facets are coplanar, and may be without cells beneath.
  bool span_area(Vertex_index v, const Site& w, const Cell_ring& ring,
                 const std::vector<Position_3>& corners) const
  {
    int changes = 0;
    for (std::size_t i = 0; i < ring.size() && changes < 3; ++i)
      changes += differ_evidently(corners[i], corners[next(ring, i)]);
    if (changes == 3)
      return true;
    changes = 0;
    for (std::size_t i = 0; i < ring.size() && changes < 3; ++i)
      changes += differ_evidently(corners[i], corners[next(ring, i)]) || differ(v, w, ring, i);
    return changes == 3;
  }

private:
  const Arrays& arrays() const { return m_sites.state().arrays; }
  static std::size_t next(const Cell_ring& ring, std::size_t i)
  {
    return i + 1 < ring.size() ? i + 1 : 0;
  }

  Position_3 center_of(const Few<Site, 4>& v) const
  {
    const Position_3 b = m_sites.vector(v[0], v[1]), c = m_sites.vector(v[0], v[2]),
                     d = m_sites.vector(v[0], v[3]), cd = cross(c, d);
    const double volume = dot(b, cd), bb = squared_length(b), cc = squared_length(c),
                 dd = squared_length(d);
    if (!(volume > 0 && volume * volume > 0x1p-20 * (bb * cc * dd) &&
          bb * cc * dd > (std::numeric_limits<double>::min)() * 0x1p40))
      return exact_center(v);
    return (0.5 / volume) * (bb * cd + (cc * cross(d, b) + dd * cross(b, c)));
  }

  Position_3 exact_center(const Few<Site, 4>& v) const
  {
    const Exact_vector b = m_sites.exact_vector(v[0], v[1]), c = m_sites.exact_vector(v[0], v[2]),
                       d = m_sites.exact_vector(v[0], v[3]);
    const Exact_vector cd = cross(c, d), db = cross(d, b), bc = cross(b, c);
    const Number bb = dot(b, b), cc = dot(c, c), dd = dot(d, d), volume = 2 * dot(b, cd);
    return m_sites.rounded({Number((bb * cd.x + cc * db.x + dd * bc.x) / volume),
                            Number((bb * cd.y + cc * db.y + dd * bc.y) / volume),
                            Number((bb * cd.z + cc * db.z + dd * bc.z) / volume)});
  }
  static Number dot(const Exact_vector& p, const Exact_vector& q)
  {
    return p.x * q.x + p.y * q.y + p.z * q.z;
  }
  static Exact_vector cross(const Exact_vector& p, const Exact_vector& q)
  {
    return {Number(p.y * q.z - p.z * q.y), Number(p.z * q.x - p.x * q.z),
            Number(p.x * q.y - p.y * q.x)};
  }
  static double dot(const Position_3& p, const Position_3& q) { return internal::dot(p, q); }
  static Position_3 cross(const Position_3& p, const Position_3& q)
  {
    return internal::cross(p, q);
  }

  // Whether two corners differ, as far as rounded ones prove it.
  static bool differ_evidently(const Position_3& p, const Position_3& q)
  {
    if (is_infinite(p) || is_infinite(q))
      return is_infinite(p) != is_infinite(q);
    return squared_length(p - q) > 1e-18 * (squared_length(p) + squared_length(q)) + 1e-290;
  }

  // Whether the corners of the i-th cell and the next one, which are both finite or both infinite,
  // differ.
  bool differ(Vertex_index v, const Site& w, const Cell_ring& ring, std::size_t i) const
  {
    const Ring_cell_3<Charts>& here = ring[i];
    const Site& after = ring[next(ring, i)].next;
    if constexpr (!Charts::is_periodic)
      if (arrays().is_infinite(here.cell)) {
        // between two of them is the infinite vertex; each has one other vertex besides v and w
        const Vertex_index before = ring[(i > 0 ? i : ring.size()) - 1].next;
        return !m_sites.are_coplanar(v, w, before, after);
      }
    if constexpr (Charts::is_periodic) // one above a slab and one below
      if (Charts::is_infinite(arrays(), Charts::cell_of(here.cell)) &&
          !Charts::is_infinite(here.next))
        return true;
    const auto place_of = [&](const Site& s) { return Charts::place_of(arrays(), here.cell, s); };
    const int opposite = 6 - place_of(Charts::site(v)) - place_of(w) - place_of(here.next);
    const Cell_index cell = Charts::cell_of(here.cell);
    return !is_on_sphere(Arrays::corner(cell, opposite), Charts::in_own_chart(here.cell, after));
  }

  // Whether the site beyond the facet opposite to a corner, in the chart of its cell, is on the
  // sphere of the cell. This is asked from both ends of three edges, and found once; threads that
  // ask at the same time find the same.
  bool is_on_sphere(Corner_index k, const Site& beyond) const
  {
    std::atomic<Tie>& known = m_ties[(std::min)(Index(k), Index(arrays().mirror(k)))];
    Tie tie = known.load(std::memory_order_relaxed);
    if (tie == Tie::unknown) {
      const auto& sites = Charts::sites(arrays(), Arrays::cell_of(k));
      tie = m_sites.are_on_a_sphere(sites, beyond) ? Tie::yes : Tie::no;
      known.store(tie, std::memory_order_relaxed);
    }
    return tie == Tie::yes;
  }

  const Sites& m_sites;
  Dynamic_Delaunay_triangulations_2::internal::Uninitialized_column<Cell_index, Position_3>
      m_centers;
  mutable std::vector<std::atomic<Tie>> m_ties; // of facets, by the smaller of their corners
};

} // namespace CGAL::Dynamic_Delaunay_triangulations_3::internal

#endif // CGAL_DYNAMIC_DELAUNAY_TRIANGULATION_3_INTERNAL_QUERIES_CELLS_VORONOI_VERTICES_3_H

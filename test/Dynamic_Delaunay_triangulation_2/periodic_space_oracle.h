// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// What a triangulation of periodic space in three dimensions must be, by exact fractions.

#ifndef DYNAMIC_DELAUNAY_TRIANGULATION_2_TEST_PERIODIC_SPACE_ORACLE_H
#define DYNAMIC_DELAUNAY_TRIANGULATION_2_TEST_PERIODIC_SPACE_ORACLE_H

#include <CGAL/convex_hull_2.h>
#include <CGAL/Dynamic_Delaunay_triangulation_3/Periodic_cell_3.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Simple_cartesian.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <map>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

namespace periodic_space_oracle {

using Shift = CGAL::Periodic_shift_3;
using Site = std::pair<std::size_t, Shift>; // an image of a point
using Exact = CGAL::Simple_cartesian<CGAL::Exact_rational>;
using Exact_point = Exact::Point_3;

inline Shift operator+(const Shift& s, const Shift& t)
{
  return {s[0] + t[0], s[1] + t[1], s[2] + t[2]};
}
inline Shift operator-(const Shift& s, const Shift& t)
{
  return {s[0] - t[0], s[1] - t[1], s[2] - t[2]};
}

// Sorts sites, and moves them so that the first one has the shift 0. Returns by how much.
template <std::size_t n>
Shift normalize(std::array<Site, n>& sites)
{
  std::sort(sites.begin(), sites.end());
  const Shift first = sites[0].second;
  for (Site& site : sites)
    site.second = site.second - first;
  return first;
}

// All cells, each as the same list whatever image of it is reported.
template <class Dynamic>
std::set<std::array<Site, 4>> cells_of(const Dynamic& dt)
{
  std::set<std::array<Site, 4>> cells;
  dt.for_each_cell([&](const std::array<std::size_t, 4>& ids, const std::array<Shift, 4>& shifts) {
    std::array<Site, 4> sites;
    for (std::size_t i = 0; i < 4; ++i)
      sites[i] = {ids[i], shifts[i]};
    normalize(sites);
    EXPECT_TRUE(cells.insert(sites).second);
  });
  return cells;
}

template <class Point>
class Oracle
{
public:
  Oracle(const std::map<std::size_t, Point>& points, const CGAL::Periodic_cell_3& cell)
    : m_points(points)
    , m_cell(cell)
    , m_ends(ends())
  {
    if (cell.is_wire())
      find_hull_of_wire();
  }

  Exact_point position(const Site& site) const
  {
    const Point& p = m_points.at(site.first);
    std::array<CGAL::Exact_rational, 3> x{p.x(), p.y(), p.z()};
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t k = 0; k < 3; ++k)
        x[k] += CGAL::Exact_rational(site.second[i]) * CGAL::Exact_rational(m_cell.vector(i)[k]);
    return Exact_point(x[0], x[1], x[2]);
  }

  // Cells are positive, fit together, and cover the torus once; spheres of neighbors are empty of
  // each other's vertices. So they are Delaunay. In a slab they cover what is between two planes
  // through the outermost points, where their hull facets are; in a wire a prism without ends.
  template <class Dynamic>
  void expect_Delaunay(const Dynamic& dt) const
  {
    CGAL::Exact_rational volume = 0;
    std::set<std::size_t> with_cells;
    std::map<std::array<Site, 3>, std::vector<Side>> sides;
    dt.for_each_cell(
        [&](const std::array<std::size_t, 4>& ids, const std::array<Shift, 4>& shifts) {
          EXPECT_EQ(shifts[0], Shift());
          std::array<Site, 4> sites;
          std::array<Exact_point, 4> p;
          for (std::size_t i = 0; i < 4; ++i) {
            with_cells.insert(ids[i]);
            sites[i] = {ids[i], shifts[i]};
            p[i] = position(sites[i]);
          }
          const auto of_cell = CGAL::volume(p[0], p[1], p[2], p[3]);
          EXPECT_GT(of_cell, 0);
          volume += of_cell;
          for (std::size_t i = 0; i < 4; ++i)
            add_side(sites, i, sides);
        });
    std::set<std::size_t> representatives;
    for (const auto& [id, point] : m_points)
      representatives.insert(dt.representative(id));
    if (!is_flat()) {
      EXPECT_EQ(with_cells, representatives);
    }
    if (m_points.empty())
      return;
    if (m_cell.is_slab()) {
      EXPECT_EQ(volume, highest() - lowest());
    } else if (m_cell.is_wire()) {
      EXPECT_EQ(volume, volume_of_wire());
    } else {
      EXPECT_EQ(volume, 6 * CGAL::abs(CGAL::volume(origin(), end(0), end(1), end(2))));
    }
    EXPECT_EQ(sides.size(), is_flat() ? 0u : dt.number_of_facets());
    for (const auto& [facet, both] : sides) {
      if (both.size() == 1) {
        expect_outermost(facet);
        continue;
      }
      ASSERT_EQ(both.size(), 2u);
      expect_legal(both[0], both[1]);
      expect_legal(both[1], both[0]);
    }
  }

  // Edges, neighbors and counts are those of the cells.
  template <class Dynamic>
  void expect_right_edges(const Dynamic& dt) const
  {
    std::set<std::array<Site, 2>> expected, found;
    std::size_t cells = 0;
    for (const std::array<Site, 4>& sites : cells_of(dt)) {
      ++cells;
      for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = 0; j < i; ++j)
          expected.insert(edge(sites[i], sites[j]));
    }
    dt.for_each_edge([&](std::size_t i, std::size_t j, const Shift& shift) {
      EXPECT_TRUE(found.insert(edge({i, Shift()}, {j, shift})).second);
    });
    EXPECT_EQ(dt.number_of_edges(), found.size());
    EXPECT_EQ(dt.number_of_cells(), cells);
    if (is_flat() && m_cell.is_wire()) {
      EXPECT_EQ(dt.number_of_facets(), 0u);
    } else if (is_flat()) {
      EXPECT_EQ(found.size(), 3 * dt.number_of_vertices());
      EXPECT_EQ(dt.number_of_facets(), 2 * dt.number_of_vertices());
      expected = found;
    }
    EXPECT_EQ(found, expected);
    for (const auto& [id, point] : m_points) {
      const std::size_t i = dt.representative(id);
      std::size_t neighbors = 0, ends = 0;
      dt.for_each_neighbor(id, [&](std::size_t j, const Shift& shift) {
        ++neighbors;
        EXPECT_TRUE(expected.count(edge({i, Shift()}, {j, shift})) == 1);
      });
      for (const auto& sites : expected)
        ends += std::size_t(sites[0].first == i) + std::size_t(sites[1].first == i);
      EXPECT_EQ(neighbors, ends);
      if (neighbors > 0 && ++m_examined > 20)
        break;
    }
  }

  // Points share a vertex if and only if they coincide modulo the lattice.
  template <class Dynamic>
  void expect_right_points(const Dynamic& dt) const
  {
    EXPECT_EQ(dt.number_of_points(), m_points.size());
    std::map<Exact_point, std::size_t> wrapped;
    std::set<std::size_t> representatives;
    for (const auto& [id, point] : m_points) {
      EXPECT_EQ(dt.point(id), point);
      const std::size_t representative = dt.representative(id);
      EXPECT_EQ(dt.representative(representative), representative);
      representatives.insert(representative);
      const auto [at, is_new] = wrapped.emplace(wrapped_position(id), representative);
      EXPECT_EQ(at->second, representative);
    }
    EXPECT_EQ(wrapped.size(), representatives.size());
    EXPECT_EQ(dt.number_of_vertices(), representatives.size());
  }

  // Whether all points are in a plane along a slab or a wire, and there are no cells.
  bool is_flat() const
  {
    return m_cell.is_wire() ? m_hull.size() < 3 : m_cell.is_slab() && highest() == lowest();
  }

private:
  // Along the cross product of a slab's vectors, by the length of this. Of other cells, the highest
  // point is higher than the lowest one.
  CGAL::Exact_rational elevation(const Exact_point& p) const
  {
    return CGAL::determinant(end(0) - origin(), end(1) - origin(), p - origin());
  }
  const CGAL::Exact_rational& highest() const { return m_ends.second; }
  const CGAL::Exact_rational& lowest() const { return m_ends.first; }
  std::pair<CGAL::Exact_rational, CGAL::Exact_rational> ends() const
  {
    std::pair<CGAL::Exact_rational, CGAL::Exact_rational> ends(0, 1);
    bool is_first = m_cell.is_slab();
    for (const auto& [id, point] : m_points) {
      const CGAL::Exact_rational at = elevation(position({id, Shift()}));
      ends = {is_first ? at : (std::min)(ends.first, at),
              is_first ? at : (std::max)(ends.second, at)};
      is_first = false;
    }
    return ends;
  }
  void expect_outermost(const std::array<Site, 3>& facet) const
  {
    if (m_cell.is_wire())
      return expect_on_hull_of_wire(facet);
    ASSERT_TRUE(m_cell.is_slab());
    const CGAL::Exact_rational at = elevation(position(facet[0]));
    EXPECT_TRUE(at == highest() || at == lowest());
    for (const Site& site : facet)
      EXPECT_EQ(elevation(position(site)), at);
  }

  // A point as it is seen along a wire, in units of two vectors u and v across it, and across each
  // other: |v| = |a| |u|.
  using Seen = Exact::Point_2;
  Exact::Vector_3 first_across() const
  {
    return CGAL::cross_product(end(0) - origin(),
                               CGAL::cross_product(end(0) - origin(), end(1) - origin()));
  }
  Seen seen_along_wire(const Exact_point& p) const
  {
    const Exact::Vector_3 u = first_across(), v = CGAL::cross_product(end(0) - origin(), u);
    return Seen(u * (p - origin()), v * (p - origin()));
  }
  void find_hull_of_wire()
  {
    std::vector<Seen> seen;
    for (const auto& [id, point] : m_points)
      seen.push_back(seen_along_wire(position({id, Shift()})));
    CGAL::ch_graham_andrew(seen.begin(), seen.end(), std::back_inserter(m_hull));
  }
  // The area that is seen is |u| |v| times the real one.
  CGAL::Exact_rational volume_of_wire() const
  {
    CGAL::Exact_rational area = 0;
    for (std::size_t i = 2; i < m_hull.size(); ++i)
      area += CGAL::area(m_hull[0], m_hull[i - 1], m_hull[i]);
    return area / first_across().squared_length();
  }
  // Facets are seen as parts of sides of the hull.
  void expect_on_hull_of_wire(const std::array<Site, 3>& facet) const
  {
    std::size_t sides = 0;
    for (std::size_t i = 0; i < m_hull.size(); ++i)
      sides += std::all_of(facet.begin(), facet.end(), [&](const Site& site) {
        return CGAL::collinear(m_hull[i], m_hull[(i + 1) % m_hull.size()],
                               seen_along_wire(position(site)));
      });
    EXPECT_EQ(sides, 1u);
  }

  // A cell at a facet: its vertices, and the translation that takes it to the facet's image that
  // others know.
  struct Side
  {
    std::array<Site, 4> sites;
    std::size_t place;
  };

  static void add_side(const std::array<Site, 4>& sites, std::size_t place,
                       std::map<std::array<Site, 3>, std::vector<Side>>& sides)
  {
    std::array<Site, 3> facet;
    for (std::size_t i = 0, n = 0; i < 4; ++i)
      if (i != place)
        facet[n++] = sites[i];
    const Shift shift = normalize(facet);
    Side side{sites, place};
    for (Site& site : side.sites)
      site.second = site.second - shift;
    sides[facet].push_back(side);
  }

  void expect_legal(const Side& side, const Side& other) const
  {
    const auto p = [&](std::size_t i) { return position(side.sites[i]); };
    const Exact_point apex = position(other.sites[other.place]);
    EXPECT_NE(CGAL::side_of_oriented_sphere(p(0), p(1), p(2), p(3), apex), CGAL::ON_POSITIVE_SIDE);
    std::array<Exact_point, 4> q{p(0), p(1), p(2), p(3)};
    q[side.place] = apex;
    EXPECT_EQ(CGAL::orientation(q[0], q[1], q[2], q[3]), CGAL::NEGATIVE);
  }

  static std::array<Site, 2> edge(const Site& s, const Site& t)
  {
    std::array<Site, 2> sites{s, t};
    normalize(sites);
    if (sites[0].first == sites[1].first) // of an edge between images of one point either end
      sites[1].second = (std::max)(sites[1].second, Shift() - sites[1].second);
    return sites;
  }

  static Exact_point origin() { return Exact_point(0, 0, 0); }
  Exact_point end(std::size_t i) const
  {
    const auto& v = m_cell.vector(i);
    return Exact_point(v[0], v[1], v[2]);
  }

  Exact_point wrapped_position(std::size_t id) const
  {
    const Exact_point p = position({id, Shift()});
    const Exact::Vector_3 v[] = {end(0) - origin(), end(1) - origin(), end(2) - origin()};
    const CGAL::Exact_rational whole = CGAL::determinant(v[0], v[1], v[2]);
    Exact_point wrapped = p;
    for (std::size_t i = 0; i < std::size_t(m_cell.dimension()); ++i) {
      Exact::Vector_3 w[] = {v[0], v[1], v[2]};
      w[i] = p - origin();
      CGAL::Exact_rational multiple = CGAL::determinant(w[0], w[1], w[2]) / whole;
      CGAL::Exact_rational rounded(std::floor(CGAL::to_double(multiple)));
      while (rounded > multiple)
        rounded -= 1;
      while (rounded + 1 <= multiple)
        rounded += 1;
      wrapped = wrapped - rounded * v[i];
    }
    return wrapped;
  }

  const std::map<std::size_t, Point>& m_points;
  const CGAL::Periodic_cell_3& m_cell;
  const std::pair<CGAL::Exact_rational, CGAL::Exact_rational> m_ends; // lowest and highest
  std::vector<Exact::Point_2> m_hull; // of a wire, as it is seen along that
  mutable std::size_t m_examined = 0;
};

// Tests everything about a triangulation of these points, by their ids.
template <class Dynamic>
void expect_exact(const Dynamic& dt, const std::map<std::size_t, typename Dynamic::Point>& points,
                  const CGAL::Periodic_cell_3& cell)
{
  const Oracle<typename Dynamic::Point> oracle(points, cell);
  EXPECT_TRUE(dt.is_certified());
  EXPECT_TRUE(dt.is_valid(true));
  EXPECT_EQ(dt.cell(), cell);
  ASSERT_NO_FATAL_FAILURE(oracle.expect_right_points(dt));
  ASSERT_NO_FATAL_FAILURE(oracle.expect_Delaunay(dt));
  ASSERT_NO_FATAL_FAILURE(oracle.expect_right_edges(dt));
}

} // namespace periodic_space_oracle

#endif // DYNAMIC_DELAUNAY_TRIANGULATION_2_TEST_PERIODIC_SPACE_ORACLE_H

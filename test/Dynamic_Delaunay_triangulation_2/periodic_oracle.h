// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// What every test asks of a periodic triangulation. The oracle is a plane full of exact copies of
// the points, seen through CGAL's exact kernel: it shares nothing with what it tests.

#ifndef DYNAMIC_DELAUNAY_TRIANGULATION_2_TEST_PERIODIC_ORACLE_H
#define DYNAMIC_DELAUNAY_TRIANGULATION_2_TEST_PERIODIC_ORACLE_H

#include <CGAL/Dynamic_periodic_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

class Periodic_oracle
{
  using Exact = CGAL::Exact_predicates_exact_constructions_kernel;
  using Point = Exact::Point_2;
  using Vector = Exact::Vector_2;
  using Triangle = std::array<Point, 3>;
  using Shift = CGAL::Periodic_shift_2;

public:
  template <class Triangulation>
  explicit Periodic_oracle(const Triangulation& triangulation)
    : m_a(triangulation.cell().ax(), triangulation.cell().ay())
    , m_b(triangulation.cell().bx(), triangulation.cell().by())
    , m_r(m_a)
    , m_t(m_b)
    , m_is_slab(triangulation.cell().is_slab())
  {
    if (m_is_slab)
      m_t = m_a.perpendicular(CGAL::COUNTERCLOCKWISE);
    else
      reduce();
    for (std::size_t id = 0; id < triangulation.number_of_ids(); ++id)
      if (triangulation.has_id(id)) {
        const auto p = triangulation.point(id);
        m_points[id] = Point(p.x(), p.y());
        m_places.insert(wrapped(m_points[id]));
      }
  }

  // Points in different places, up to translations of the lattice.
  std::size_t number_of_places() const { return m_places.size(); }

  bool coincide(std::size_t i, std::size_t j) const
  {
    return wrapped(m_points.at(i)) == wrapped(m_points.at(j));
  }

  Point image(std::size_t id, const Shift& shift) const
  {
    return m_points.at(id) + Exact::FT(shift[0]) * m_a + Exact::FT(shift[1]) * m_b;
  }

  // Twice the area of the cell, or of the part of a slab between its outermost points.
  Exact::FT double_area() const
  {
    if (!m_is_slab)
      return 2 * CGAL::abs(CGAL::determinant(m_a, m_b));
    const auto [low, high] = outermost();
    return 2 * (high - low);
  }

  bool is_outermost(std::size_t id) const
  {
    const auto [low, high] = outermost();
    const Exact::FT height = height_of(m_points.at(id));
    return height == low || height == high;
  }

  // Whether no copy of any point is inside the triangle's circle.
  bool is_delaunay(const Triangle& t) const
  {
    if (m_is_slab)
      return is_delaunay_in_slab(t);
    const Point start = wrapped(t[0]);
    const Vector to_start = start - t[0];
    const Triangle moved{start, t[1] + to_start, t[2] + to_start};
    // copies that are far outside by doubles need no exact predicate
    const Point center = CGAL::circumcenter(moved[0], moved[1], moved[2]);
    const double x = CGAL::to_double(center.x()), y = CGAL::to_double(center.y());
    const double reach = 1.001 * std::sqrt(CGAL::to_double(CGAL::squared_distance(center, start)));
    if (!(reach < 2 * length(m_t))) // larger than any circle without a point of the lattice
      return false;
    const int copies_r = 2 + int(2 * reach * length(m_t) / area());
    const int copies_t = 2 + int(2 * reach * length(m_r) / area());
    for (int i = -copies_r; i <= copies_r; ++i)
      for (int j = -copies_t; j <= copies_t; ++j)
        for (const Point& p : m_places)
          if (std::hypot(CGAL::to_double(p.x()) + i * CGAL::to_double(m_r.x()) +
                             j * CGAL::to_double(m_t.x()) - x,
                         CGAL::to_double(p.y()) + i * CGAL::to_double(m_r.y()) +
                             j * CGAL::to_double(m_t.y()) - y) < reach &&
              CGAL::side_of_oriented_circle(moved[0], moved[1], moved[2],
                                            p + Exact::FT(i) * m_r + Exact::FT(j) * m_t) ==
                  CGAL::ON_POSITIVE_SIDE)
            return false;
    return true;
  }

private:
  // Of the images of a point those nearest to the center along the slab are deepest in the circle.
  bool is_delaunay_in_slab(const Triangle& t) const
  {
    const Point center = CGAL::circumcenter(t[0], t[1], t[2]);
    for (const Point& p : m_places) {
      const double along = std::floor(CGAL::to_double(((center - p) * m_a) / (m_a * m_a)));
      for (int i = -1; i <= 2; ++i)
        if (CGAL::side_of_oriented_circle(t[0], t[1], t[2], p + Exact::FT(along + i) * m_a) ==
            CGAL::ON_POSITIVE_SIDE)
          return false;
    }
    return true;
  }

  Exact::FT height_of(const Point& p) const { return CGAL::determinant(m_a, p - CGAL::ORIGIN); }

  std::pair<Exact::FT, Exact::FT> outermost() const
  {
    Exact::FT low = height_of(*m_places.begin()), high = low;
    for (const Point& p : m_places) {
      low = (std::min)(low, height_of(p));
      high = (std::max)(high, height_of(p));
    }
    return {low, high};
  }

  static double length(const Vector& v)
  {
    return std::hypot(CGAL::to_double(v.x()), CGAL::to_double(v.y()));
  }
  double area() const { return std::abs(CGAL::to_double(CGAL::determinant(m_a, m_b))); }

  // Lagrange's reduction: then m_t is not shorter than m_r, and nearly as short as can be.
  void reduce()
  {
    for (int steps = 0; steps < 64; ++steps) {
      if (m_r * m_r > m_t * m_t)
        std::swap(m_r, m_t);
      const double k = std::round(CGAL::to_double(m_r * m_t) / CGAL::to_double(m_r * m_r));
      if (k == 0)
        return;
      m_t = m_t - Exact::FT(k) * m_r;
    }
  }

  // The image in the parallelogram of the reduced vectors, exactly.
  Point wrapped(const Point& p) const
  {
    const Vector v = p - CGAL::ORIGIN;
    const Exact::FT determinant = CGAL::determinant(m_r, m_t);
    const Exact::FT s = fraction(CGAL::determinant(v, m_t) / determinant);
    const Exact::FT t = CGAL::determinant(m_r, v) / determinant;
    return CGAL::ORIGIN + s * m_r + (m_is_slab ? t : fraction(t)) * m_t;
  }

  static Exact::FT fraction(const Exact::FT& x)
  {
    Exact::FT f = x - std::floor(CGAL::to_double(x));
    if (f < 0)
      f += 1;
    if (f >= 1)
      f -= 1;
    return f;
  }

  Vector m_a, m_b, m_r, m_t;
  bool m_is_slab;
  std::map<std::size_t, Point> m_points;
  std::set<Point> m_places;
};

using Directed_edge = std::tuple<std::size_t, std::size_t, CGAL::Periodic_shift_2>;

inline Directed_edge reversed(const Directed_edge& edge)
{
  const auto& [i, j, shift] = edge;
  return {j, i, {-shift[0], -shift[1]}};
}

// All edges, in both directions.
template <class Triangulation>
std::set<Directed_edge> edges_both_ways(const Triangulation& pt)
{
  std::set<Directed_edge> edges;
  pt.for_each_edge([&](std::size_t i, std::size_t j, const CGAL::Periodic_shift_2& shift) {
    edges.insert({i, j, shift});
    edges.insert(reversed({i, j, shift}));
  });
  return edges;
}

// Everything: no point is lost; the faces are closed along their edges up to the boundary of a
// slab, counterclockwise, as large as the cell together, and Delaunay; and edges and neighbors say
// the same.
template <class Triangulation>
void expect_periodic_delaunay(const Triangulation& pt)
{
  using Shift = CGAL::Periodic_shift_2;
  ASSERT_TRUE(pt.is_certified());
  ASSERT_TRUE(pt.is_valid());
  const Periodic_oracle oracle(pt);
  ASSERT_EQ(pt.number_of_vertices(), oracle.number_of_places());
  for (std::size_t id = 0; id < pt.number_of_ids(); ++id)
    if (pt.has_id(id)) {
      ASSERT_TRUE(oracle.coincide(id, pt.representative(id))) << "id " << id;
    }

  std::set<Directed_edge> of_faces, of_boundary, of_neighbors;
  CGAL::Exact_predicates_exact_constructions_kernel::FT area = 0;
  std::size_t faces = 0;
  pt.for_each_face([&](const std::array<std::size_t, 3>& ids, const std::array<Shift, 3>& shifts) {
    std::array<CGAL::Exact_predicates_exact_constructions_kernel::Point_2, 3> corners;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t k = (i + 1) % 3;
      corners[i] = oracle.image(ids[i], shifts[i]);
      of_faces.insert({ids[i], ids[k], {shifts[k][0] - shifts[i][0], shifts[k][1] - shifts[i][1]}});
    }
    EXPECT_EQ(CGAL::orientation(corners[0], corners[1], corners[2]), CGAL::LEFT_TURN);
    EXPECT_TRUE(oracle.is_delaunay(corners));
    area += CGAL::determinant(corners[1] - corners[0], corners[2] - corners[0]);
    ++faces;
  });
  ASSERT_EQ(faces, pt.number_of_faces());
  ASSERT_EQ(of_faces.size(), 3 * faces);
  if (oracle.number_of_places() > 0) {
    ASSERT_EQ(area, oracle.double_area());
  }
  pt.for_each_boundary_edge([&](std::size_t i, std::size_t j, const Shift& shift) {
    EXPECT_TRUE(oracle.is_outermost(i) && oracle.is_outermost(j));
    EXPECT_TRUE(of_boundary.insert({i, j, shift}).second);
  });
  for (const Directed_edge& edge : of_faces)
    ASSERT_NE(of_faces.count(reversed(edge)), of_boundary.count(edge));
  for (const Directed_edge& edge : of_boundary)
    ASSERT_NE(of_faces.count(edge), of_boundary.count(reversed(edge)));
  if (!pt.cell().is_slab()) {
    ASSERT_EQ(faces, 2 * oracle.number_of_places());
    ASSERT_TRUE(of_boundary.empty());
  }

  std::size_t edges = 0;
  pt.for_each_edge([&](std::size_t, std::size_t, const Shift&) { ++edges; });
  ASSERT_EQ(edges, pt.number_of_edges());
  ASSERT_EQ(edges, oracle.number_of_places() + faces); // Euler, for a torus and for a strip
  std::set<Directed_edge> expected = of_faces;
  for (const auto& edges_there : {of_faces, of_boundary})
    for (const Directed_edge& edge : edges_there) {
      expected.insert(edge);
      expected.insert(reversed(edge));
    }
  const std::set<Directed_edge> of_edges = edges_both_ways(pt);
  ASSERT_EQ(of_edges, expected);
  for (std::size_t id = 0; id < pt.number_of_ids(); ++id)
    if (pt.has_id(id) && pt.representative(id) == id)
      pt.for_each_neighbor(id, [&](std::size_t j, const Shift& shift) {
        of_neighbors.insert({id, j, shift});
      });
  ASSERT_EQ(of_neighbors, of_edges);
}

#endif // DYNAMIC_DELAUNAY_TRIANGULATION_2_TEST_PERIODIC_ORACLE_H

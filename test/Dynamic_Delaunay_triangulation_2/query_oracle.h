// Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
// SPDX-License-Identifier: GPL-3.0-or-later

// What tests of queries have in common: clouds of all kinds, and points, their images and polygons
// in exact numbers.

#ifndef DYNAMIC_DELAUNAY_TRIANGULATION_2_TEST_QUERY_ORACLE_H
#define DYNAMIC_DELAUNAY_TRIANGULATION_2_TEST_QUERY_ORACLE_H

#include "oracle.h"

#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace query_oracle {

using Exact_point = Epeck::Point_2;
using Exact_points = std::vector<Exact_point>;

template <class Point>
Exact_point exact(const Point& p)
{
  return Exact_point(p.x(), p.y());
}

template <class Point>
Exact_points exact_points(const std::vector<Point>& points)
{
  Exact_points result;
  for (const Point& p : points)
    result.push_back(exact(p));
  return result;
}

// Rounded to the last digit: CGAL::to_double() is exact only for numbers that have been computed.
inline double rounded(const Epeck::FT& number)
{
  return CGAL::to_double(CGAL::exact(number));
}

// Clouds of all kinds, by their names.
template <class Kernel>
std::map<std::string, std::vector<typename Kernel::Point_2>> clouds_of_all_kinds()
{
  using Source = Cloud<Kernel>;
  using Place = typename Kernel::Point_2;
  std::map<std::string, std::vector<Place>> clouds;
  clouds["no point"] = {};
  clouds["one"] = {Place(3, 4)};
  clouds["two"] = {Place(3, 4), Place(5, 4)};
  clouds["two in one place"] = {Place(3, 4), Place(3, 4)};
  clouds["line"] = Source(1).on_line(20);
  clouds["circle"] = Source::on_circle(36);
  clouds["circle and center"] = Source::on_circle(36);
  clouds["circle and center"].push_back(Place(0, 0));
  clouds["lattice"] = Source::grid(7, 6);
  clouds["random"] = Source(2).uniform(80);
  clouds["coincident"] = Source(3).uniform(30);
  for (const std::size_t i : {4u, 9u, 4u, 2u})
    clouds["coincident"].push_back(clouds["coincident"][i]);
  return clouds;
}

// Random points over a hull of which one side is hardly bent.
template <class Kernel>
std::vector<typename Kernel::Point_2> cloud_with_nearly_straight_hull()
{
  auto points = Cloud<Kernel>(5).uniform(60);
  for (int i = 0; i <= 8; ++i)
    points.emplace_back(i, -1e-13 * i * (8 - i));
  return points;
}

// The images of all points up to `reach` cells around them, in a slab along it; where points are
// given `away` cells along the first vector, around where they would be without.
template <class Periodic>
Exact_points images_around(const Periodic& dt, int reach, int away = 0)
{
  const auto& cell = dt.cell();
  const int reach_across = cell.is_slab() ? 0 : reach;
  const Epeck::Vector_2 a(cell.ax(), cell.ay()), b(cell.bx(), cell.by());
  Exact_points images;
  for (std::size_t id = 0; id < dt.number_of_ids(); ++id)
    for (int i = -reach; i <= reach; ++i)
      for (int j = -reach_across; j <= reach_across; ++j)
        images.push_back(exact(dt.point(id)) + Epeck::FT(i - away) * a + Epeck::FT(j) * b);
  return images;
}

// The part of the polygon that is no nearer to w than to v.
inline Exact_points clipped(const Exact_points& polygon, const Exact_point& v, const Exact_point& w)
{
  const auto bisector = CGAL::bisector(v, w); // v is on its positive side
  Exact_points result;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Exact_point &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
    const Epeck::FT at_p = bisector.a() * p.x() + bisector.b() * p.y() + bisector.c();
    const Epeck::FT at_q = bisector.a() * q.x() + bisector.b() * q.y() + bisector.c();
    if (at_p >= 0)
      result.push_back(p);
    if (at_p * at_q < 0)
      result.push_back(p + (q - p) * (at_p / (at_p - at_q)));
  }
  return result;
}

// The Voronoi cell of a place in a box, cut by the bisectors with all other points.
template <class Point>
Exact_points clipped_cell(const std::vector<Point>& points, const Point& place,
                          const CGAL::Bbox_2& box)
{
  Exact_points polygon{Exact_point(box.xmin(), box.ymin()), Exact_point(box.xmax(), box.ymin()),
                       Exact_point(box.xmax(), box.ymax()), Exact_point(box.xmin(), box.ymax())};
  for (const Point& other : points)
    if (other != place)
      polygon = clipped(polygon, exact(place), exact(other));
  return polygon;
}

} // namespace query_oracle

#endif // DYNAMIC_DELAUNAY_TRIANGULATION_2_TEST_QUERY_ORACLE_H
